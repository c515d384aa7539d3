//! A key above the panels: a piece of each curve with its mark and its name, in as many columns as there is room for.

use crate::markers::{kind, marks};
use crate::panel::WIDTH;
use crate::svg::canvas::Canvas;
use crate::svg::label::Label;
use crate::svg::shape::Shape;
use nalgebra::Vector2;

/// From line to line, from the left side to the first column, and the length of a piece of curve, in pixels.
const LINE: f64 = 28.0;
const LEFT: f64 = 16.0;
const PIECE: f64 = 44.0;
/// Between a piece and its name, and after the name.
const GAP: f64 = 8.0;
const SIZE: f64 = 9.0;
/// Dashes and gaps, one after another; from the fourth name on the shades begin again with other dashes.
const DASHES: [Option<&str>; 3] = [None, Some("9 4"), Some("3 4")];

/// The dashes of the curve with this number.
pub fn dashes(number: usize) -> Option<&'static str> {
    DASHES.get((number + number / 4) % DASHES.len()).copied().flatten()
}

/// The names of curves, in their order.
pub struct Samples<'a> {
    names: &'a [&'a str],
    columns: usize,
}

impl<'a> Samples<'a> {
    /// A key of these names.
    pub fn new(names: &'a [&'a str]) -> Self {
        let widest = names.iter().map(|name| label(name).width()).fold(0.0, f64::max) + PIECE + 3.0 * GAP;
        let columns = ((f64::from(WIDTH) - LEFT) / widest.max(1.0)) as usize;
        Self { names, columns: columns.clamp(1, 3).min(names.len().max(1)) }
    }

    /// How high it is, in pixels.
    pub fn height(&self) -> f64 {
        6.0 + LINE * self.names.len().div_ceil(self.columns).max(1) as f64
    }

    /// Draws it at the top of a canvas, with strokes so wide.
    pub fn draw(&self, canvas: &mut Canvas, width: f64) {
        let pitch = (f64::from(WIDTH) - LEFT) / self.columns as f64;
        for (number, name) in self.names.iter().enumerate() {
            let (column, row) = (number % self.columns, number / self.columns);
            let at = Vector2::new(LEFT + pitch * column as f64, 18.0 + LINE * row as f64);
            let end = at + Vector2::new(PIECE, 0.0);
            let line = Shape::line(&at, &end).stroke(kind(number).0, width);
            canvas.draw(match dashes(number) {
                Some(dashes) => line.dashed(dashes),
                None => line,
            });
            marks(canvas, &[at.lerp(&end, 0.5)], kind(number), SIZE);
            canvas.label(&end, &Vector2::new(1.0, 0.0), GAP, &label(name).shade(kind(number).0).bare());
        }
    }
}

/// A name, with hyphens that stay hyphens.
fn label(name: &str) -> Label {
    Label::words(&name.replace('-', "\u{2010}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_names_stand_one_under_another() {
        let long = "a name that takes more than half of the width of a figure";
        assert_eq!(Samples::new(&["one", "two", "three", "four"]).columns, 3);
        assert_eq!(Samples::new(&["one", long]).columns, 1);
        assert!(Samples::new(&["one", long]).height() > Samples::new(&["one", "two"]).height());
        assert_eq!(Samples::new(&[]).columns, 1);
    }

    #[test]
    fn no_two_of_eight_look_the_same() {
        let looks: Vec<_> = (0..8).map(|k| (kind(k).0.css, kind(k).1, dashes(k))).collect();
        assert!(looks.iter().enumerate().all(|(k, look)| !looks[..k].contains(look)), "{looks:?}");
    }
}
