//! One element: a line, a circle or a path, and how it looks.

use super::ground::{Area, FilledShape};
use super::path::Path;
use super::view::Pixels;
use crate::number::format_trimmed;
use crate::theme::Colour;

/// Dash pattern of construction lines.
pub(crate) const DASHED: &str = "7 5";

/// An element without content. Unless told otherwise it is neither filled nor stroked.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    tag: &'static str,
    attributes: Vec<(&'static str, String)>,
    area: Option<Area>,
    filled: Option<Colour>,
}

impl Shape {
    /// A straight line.
    pub(crate) fn line(from: &Pixels, to: &Pixels) -> Self {
        let ends = [("x1", from.x), ("y1", from.y), ("x2", to.x), ("y2", to.y)];
        Self::new("line", ends.map(|(name, value)| (name, format_trimmed(value, 2))).to_vec(), None)
    }

    /// A circle.
    pub(crate) fn circle(centre: &Pixels, radius: f64) -> Self {
        let values = [("cx", centre.x), ("cy", centre.y), ("r", radius)];
        let attributes = values.map(|(name, value)| (name, format_trimmed(value, 2))).to_vec();
        Self::new("circle", attributes, Some(Area::Disc(*centre, radius))).attribute("fill", "none")
    }

    /// A path.
    pub(crate) fn path(path: Path) -> Self {
        let attributes = vec![("d", path.data().to_owned())];
        Self::new("path", attributes, Some(Area::Loops(path.loops()))).attribute("fill", "none")
    }

    fn new(tag: &'static str, attributes: Vec<(&'static str, String)>, area: Option<Area>) -> Self {
        Self { tag, attributes, area, filled: None }
    }

    /// Draws the outline in a colour, so many pixels wide.
    pub(crate) fn stroke(self, colour: Colour, width: f64) -> Self {
        self.attribute("stroke", colour.0).attribute("stroke-width", &format_trimmed(width, 2))
    }

    /// Breaks the outline: lengths of dashes and gaps in pixels.
    pub(crate) fn dashed(self, pattern: &str) -> Self {
        self.attribute("stroke-dasharray", pattern)
    }

    /// Fills the inside with a colour.
    pub(crate) fn fill(self, colour: Colour) -> Self {
        Self { filled: Some(colour), ..self.attribute("fill", colour.0) }
    }

    /// Fills the inside with a colour of which so little covers what is below: a share between 0 and 1.
    pub(crate) fn tint(self, colour: Colour, share: f64) -> Self {
        self.fill(colour).attribute("fill-opacity", &format_trimmed(share, 2))
    }

    /// Names what is drawn: a class by which pages and tests find it.
    pub(crate) fn class(self, name: &str) -> Self {
        self.attribute("class", name)
    }

    /// Sets an attribute, in place of an earlier value.
    pub(crate) fn attribute(mut self, name: &'static str, value: &str) -> Self {
        match self.attributes.iter_mut().find(|(known, _)| *known == name) {
            Some((_, earlier)) => *earlier = value.to_owned(),
            None => self.attributes.push((name, value.to_owned())),
        }
        self
    }

    /// What a label stands on that is written over it; nothing for what is not filled.
    pub(crate) fn face(&self) -> Option<FilledShape> {
        let share = self.attributes.iter().find(|(name, _)| *name == "fill-opacity");
        let share = share.and_then(|(_, share)| share.parse().ok()).unwrap_or(1.0);
        Some(FilledShape { area: self.area.clone()?, colour: self.filled?, share })
    }

    /// The element as text.
    pub(crate) fn markup(&self) -> String {
        let attributes = self.attributes.iter().map(|(name, value)| format!(" {name}=\"{value}\""));
        format!("<{}{}/>", self.tag, attributes.collect::<String>())
    }
}
