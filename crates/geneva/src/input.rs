//! What a user's text files are: a deck, its data, the copy of a source.

/// The name that stands for standard input.
pub(crate) const STANDARD_INPUT: &str = "-";

/// Most bytes of a file or of standard input.
pub(crate) const MOST_BYTES: u64 = 16_000_000;
