//! Many marks that weigh little: all of a kind in one path.

use crate::svg::canvas::Canvas;
use crate::svg::path::Path;
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{CORIOLIS, DRIVER, FOLLOWER, INK, PAPER, RELATIVE, Shade};
use nalgebra::Vector2;

/// The shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A disc.
    Disc,
    /// A square.
    Square,
    /// A square on its corner.
    Diamond,
    /// A triangle.
    Triangle,
}

/// Colour and mark of the first to the eighth of several kinds; the last four have the colour of the text.
pub fn kind(number: usize) -> (Shade, Mark) {
    let (shade, mark) = match number % 4 {
        0 => (FOLLOWER, Mark::Disc),
        1 => (DRIVER, Mark::Square),
        2 => (RELATIVE, Mark::Diamond),
        _ => (CORIOLIS, Mark::Triangle),
    };
    (if number % 8 < 4 { shade } else { INK }, mark)
}

/// Colour and mark of a mechanism with so many slots, as in the other figures.
pub fn of_mechanism(slots: u32) -> (Shade, Mark) {
    match slots {
        3 => kind(0),
        4 => kind(1),
        _ => kind(2),
    }
}

/// Marks of fewer pixels have no rim.
const RIMMED: f64 = 7.0;

/// Draws equal marks at places of the page, as one path.
pub fn marks(canvas: &mut Canvas, places: &[Pixels], (shade, mark): (Shade, Mark), size: f64) {
    let Some(first) = places.first() else { return };
    let offsets: &[(f64, f64)] = match mark {
        Mark::Disc | Mark::Square | Mark::Diamond => &[],
        Mark::Triangle => &[(0.0, -0.64), (0.6, 1.04), (-1.2, 0.0)],
    };
    let begin = |at: &Pixels| offsets.first().map_or(*at, |(x, y)| at + Vector2::new(*x, *y) * size);
    let mut path = Path::start_rounded(&begin(first), 1);
    for (k, place) in places.iter().enumerate() {
        if k > 0 {
            path = path.again_at(&begin(place));
        }
        path = match mark {
            Mark::Disc | Mark::Square => path.dot(),
            // Square ends stand across the line, however short it is.
            Mark::Diamond => path.line_by(&Vector2::new(0.1, 0.1)),
            Mark::Triangle => {
                let steps = offsets.iter().skip(1).map(|(x, y)| Vector2::new(*x, *y) * size);
                steps.fold(path, |path, step| path.line_by(&step)).close()
            }
        };
    }
    let shape = Shape::path(path);
    match mark {
        Mark::Disc | Mark::Square | Mark::Diamond => {
            let (cap, size) = if mark == Mark::Disc { ("round", size) } else { ("square", 0.86 * size) };
            let shape = shape.with("stroke-linecap", cap);
            if size >= RIMMED {
                canvas.draw(shape.clone().stroke(PAPER, size + 2.4).class("rim"));
            }
            canvas.draw(shape.stroke(shade, size).class("marks"));
        }
        Mark::Triangle => {
            let shape = shape.fill(shade);
            canvas.draw(if size >= RIMMED { shape.stroke(PAPER, 1.2) } else { shape }.class("marks"));
        }
    }
}
