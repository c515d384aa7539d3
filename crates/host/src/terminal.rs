//! The terminal's width.

use std::ops::RangeInclusive;

/// Widths, in characters, to which answers are laid out. A wider terminal gets lines that can still be read with ease,
/// and a narrower one breaks them itself.
pub const WIDTHS: RangeInclusive<usize> = 60..=100;

/// The width, in characters, to which a program lays out what it prints on its standard output: the terminal's, within
/// [`WIDTHS`]. It is the greatest of them where standard output is no terminal, so that a pipe or a file gets the same
/// bytes on any machine.
pub fn width() -> usize {
    let (least, most) = WIDTHS.into_inner();
    let columns = terminal_size::terminal_size_of(std::io::stdout()).map(|(width, _)| usize::from(width.0));
    // A terminal that does not know its width says 0.
    columns.filter(|columns| *columns > 0).map_or(most, |columns| columns.clamp(least, most))
}
