//! One element: a line, a circle or a path, and how it looks.

use super::path::Path;
use super::view::Pixels;
use crate::number::trimmed;
use crate::theme::Colour;

/// Dash pattern of construction lines.
pub const DASHED: &str = "7 5";

/// An element without content. Unless told otherwise it is neither filled nor stroked.
#[derive(Clone, Debug)]
pub struct Shape {
    tag: &'static str,
    attributes: Vec<(&'static str, String)>,
}

impl Shape {
    /// A straight line.
    pub fn line(from: &Pixels, to: &Pixels) -> Self {
        let ends = [("x1", from.x), ("y1", from.y), ("x2", to.x), ("y2", to.y)];
        Self { tag: "line", attributes: ends.map(|(name, value)| (name, trimmed(value, 2))).to_vec() }
    }

    /// A circle.
    pub fn circle(centre: &Pixels, radius: f64) -> Self {
        let values = [("cx", centre.x), ("cy", centre.y), ("r", radius)];
        let circle = Self { tag: "circle", attributes: values.map(|(name, value)| (name, trimmed(value, 2))).to_vec() };
        circle.with("fill", "none")
    }

    /// A path.
    pub fn path(path: Path) -> Self {
        Self { tag: "path", attributes: vec![("d", path.data())] }.with("fill", "none")
    }

    /// Draws the outline in a colour, so many pixels wide.
    pub fn stroke(self, colour: Colour, width: f64) -> Self {
        self.with("stroke", colour.0).with("stroke-width", &trimmed(width, 2))
    }

    /// Breaks the outline: lengths of dashes and gaps in pixels.
    pub fn dashed(self, pattern: &str) -> Self {
        self.with("stroke-dasharray", pattern)
    }

    /// Fills the inside with a colour.
    pub fn fill(self, colour: Colour) -> Self {
        self.with("fill", colour.0)
    }

    /// Names what is drawn: a class by which pages and tests find it.
    pub fn class(self, name: &str) -> Self {
        self.with("class", name)
    }

    /// Sets an attribute, in place of an earlier value.
    pub fn with(mut self, name: &'static str, value: &str) -> Self {
        match self.attributes.iter_mut().find(|(known, _)| *known == name) {
            Some((_, earlier)) => *earlier = value.to_owned(),
            None => self.attributes.push((name, value.to_owned())),
        }
        self
    }

    /// The element as text.
    pub fn markup(&self) -> String {
        let attributes = self.attributes.iter().map(|(name, value)| format!(" {name}=\"{value}\""));
        format!("<{}{}/>", self.tag, attributes.collect::<String>())
    }
}
