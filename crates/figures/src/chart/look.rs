//! How curves and marks look, and how they are told apart.

use crate::svg::{Canvas, Path, Pixels, Shape};
use crate::theme::{CORIOLIS, Colour, DRIVER, FOLLOWER, GRID, INK, PAPER, RELATIVE};
use nalgebra::Vector2;

/// How a line looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LineStyle {
    /// Its colour.
    pub colour: Colour,
    /// Its width in pixels.
    pub width: f64,
    /// Its dashes and gaps; none for an unbroken line.
    pub dashes: Option<&'static str>,
    /// What it is, for pages and tests.
    pub class: &'static str,
}

impl LineStyle {
    /// An unbroken curve of this colour.
    pub(crate) const fn new(colour: Colour) -> Self {
        Self { colour, width: 2.8, dashes: None, class: "curve" }
    }

    /// A thin line of reference.
    pub(crate) const fn thin(class: &'static str) -> Self {
        Self { colour: INK, width: 1.3, dashes: None, class }
    }

    /// A line that parts a frame.
    pub(crate) const fn edge() -> Self {
        Self { colour: GRID, width: 1.2, dashes: None, class: "edge" }
    }

    /// Sets the line's width in pixels.
    pub(crate) const fn wide(self, width: f64) -> Self {
        Self { width, ..self }
    }

    /// Dashes the line: lengths of dashes and gaps in turn, in pixels.
    pub(crate) const fn dashed(self, dashes: &'static str) -> Self {
        Self { dashes: Some(dashes), ..self }
    }

    /// Draws the line in one piece, without dashes.
    pub(crate) const fn undashed(self) -> Self {
        Self { dashes: None, ..self }
    }

    /// Sets the class of the line's element, for a style sheet.
    pub(crate) const fn class(self, class: &'static str) -> Self {
        Self { class, ..self }
    }

    /// A shape drawn with it.
    pub(crate) fn apply_to(&self, shape: Shape) -> Shape {
        let shape = shape.stroke(self.colour, self.width).class(self.class);
        self.dashes.map_or(shape.clone(), |dashes| shape.dashed(dashes))
    }
}

/// The shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MarkShape {
    /// A disc.
    Disc,
    /// A square.
    Square,
    /// A square on its corner.
    Diamond,
    /// A triangle.
    Triangle,
    /// A triangle whose tip points to the left, or to the right: for what is beyond an edge, with its tip there.
    Left,
    Right,
    /// A circle filled with the paper's colour.
    Ring,
    /// A circle through which the curve can be seen.
    Circle,
}

/// How the marks of a kind look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Marker {
    /// Their colour.
    pub colour: Colour,
    /// Their shape.
    pub mark: MarkShape,
    /// Their size in pixels.
    pub size: f64,
    /// What they are, for pages and tests.
    pub class: &'static str,
}

impl Marker {
    /// A marker of the usual size.
    pub(crate) const fn new(colour: Colour, mark: MarkShape) -> Self {
        Self { colour, mark, size: 9.0, class: "marks" }
    }

    /// Sets the marker's size in pixels.
    pub(crate) const fn sized(self, size: f64) -> Self {
        Self { size, ..self }
    }

    /// Sets the class of the markers' elements, for a style sheet.
    pub(crate) const fn class(self, class: &'static str) -> Self {
        Self { class, ..self }
    }
}

/// Dashes and gaps, one after another.
const DASHES: [Option<&str>; 3] = [None, Some("9 4"), Some("3 4")];

/// The curve and the marks of the first to the eighth of several kinds: from the fifth on in the colour of the text,
/// and with other dashes.
pub(crate) fn kind(number: usize) -> (LineStyle, Marker) {
    let (colour, mark) = match number % 4 {
        0 => (FOLLOWER, MarkShape::Disc),
        1 => (DRIVER, MarkShape::Square),
        2 => (RELATIVE, MarkShape::Diamond),
        _ => (CORIOLIS, MarkShape::Triangle),
    };
    let colour = if number % 8 < 4 { colour } else { INK };
    let dashes = DASHES.get((number + number / 4) % DASHES.len()).copied().flatten();
    (LineStyle { dashes, ..LineStyle::new(colour) }, Marker::new(colour, mark))
}

/// The curve and the marks of a mechanism with so many slots: the same in all figures.
pub(crate) fn of_mechanism(slots: u32) -> (LineStyle, Marker) {
    kind(match slots {
        3 => 0,
        4 => 1,
        _ => 2,
    })
}

/// Marks of fewer pixels have no rim.
const RIMMED: f64 = 7.0;

/// Draws equal marks at places of the page: they weigh little, for all are one path.
pub(super) fn draw_marks(canvas: &mut Canvas, places: &[Pixels], marker: &Marker) {
    let Marker { colour, mark, size, class } = *marker;
    if matches!(mark, MarkShape::Ring | MarkShape::Circle) {
        for at in places {
            let circle = Shape::circle(at, size / 2.0).stroke(colour, 2.0).class(class);
            canvas.draw(if mark == MarkShape::Ring { circle.fill(PAPER) } else { circle });
        }
        return;
    }
    // The first corner, and the steps from there.
    let corners: &[(f64, f64)] = match mark {
        MarkShape::Triangle => &[(0.0, -0.64), (0.6, 1.04), (-1.2, 0.0)],
        MarkShape::Left => &[(0.0, 0.0), (1.1, -0.6), (0.0, 1.2)],
        MarkShape::Right => &[(0.0, 0.0), (-1.1, -0.6), (0.0, 1.2)],
        _ => &[],
    };
    let begin = |at: &Pixels| corners.first().map_or(*at, |(x, y)| at + Vector2::new(*x, *y) * size);
    let mut path = Path::empty(1);
    for place in places {
        path = path.again_at(&begin(place));
        path = match mark {
            // Square ends stand across the line, however short it is.
            MarkShape::Diamond => path.line_by(&Vector2::new(0.1, 0.1)),
            // A line of no length has no direction, so programs that show PDF leave its square ends out.
            MarkShape::Square => path.line_by(&Vector2::new(0.1, 0.0)),
            _ if !corners.is_empty() => {
                let steps = corners.iter().skip(1).map(|(x, y)| Vector2::new(*x, *y) * size);
                steps.fold(path, |path, step| path.line_by(&step)).close()
            }
            _ => path.dot(),
        };
    }
    if path.is_empty() {
        return;
    }
    let shape = Shape::path(path);
    if !corners.is_empty() {
        let shape = shape.fill(colour);
        canvas.draw(if size >= RIMMED { shape.stroke(PAPER, 1.2) } else { shape }.class(class));
        return;
    }
    let (cap, size) = if mark == MarkShape::Disc { ("round", size) } else { ("square", 0.86 * size) };
    let shape = shape.attribute("stroke-linecap", cap);
    if size >= RIMMED {
        canvas.draw(shape.clone().stroke(PAPER, size + 2.4).class("rim"));
    }
    canvas.draw(shape.stroke(colour, size).class(class));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_of_eight_look_the_same() {
        let looks: Vec<_> = (0..8).map(kind).collect();
        assert!(looks.iter().enumerate().all(|(k, look)| !looks[..k].contains(look)), "{looks:?}");
    }
}
