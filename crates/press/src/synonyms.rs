//! Words that a reader may search for and the book does not use.

/// What a reader may type that the book calls otherwise.
#[derive(Clone, Copy, Debug)]
pub struct Synonym {
    /// Words that may be typed.
    pub typed: &'static str,
    /// What they are called in the book. Each has words of its pages.
    pub meant: &'static [&'static str],
}
