//! The terminal's width.

use std::ops::RangeInclusive;

/// Widths, in columns, to which answers are laid out. A wider terminal gets lines that can still be read with ease,
/// and a narrower one breaks them itself.
pub const WIDTHS: RangeInclusive<usize> = 60..=100;

/// Columns of the terminal that a stream of this process is; none if it is no terminal, or one that doesn't know its width.
#[cfg(any(unix, windows))]
pub(crate) fn columns(stream: impl Stream) -> Option<usize> {
    let columns = terminal_size::terminal_size_of(stream).map(|(width, _)| usize::from(width.0));
    // A terminal that does not know its width says 0.
    columns.filter(|columns| *columns > 0)
}

#[cfg(unix)]
pub(crate) use std::os::fd::AsFd as Stream;
#[cfg(windows)]
pub(crate) use std::os::windows::io::AsHandle as Stream;

/// Without terminals there is none to ask.
#[cfg(not(any(unix, windows)))]
pub(crate) fn columns<S>(_: S) -> Option<usize> {
    None
}
