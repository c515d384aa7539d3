//! The classes of verdict, for data.

use crate::slugs::slugs;

/// What became of a printed claim. Derived by [`judge`](crate::judge), never asserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// The exact value rounds to the printed digits, or the printed form holds.
    Reproduced,
    /// The exact value gives the printed digits only by cutting off.
    Truncated,
    /// Only the source's own rounded intermediates give the printed digits.
    FromRounded,
    /// Read from a curve or a print-out, or announced as approximate, and right within a resolution that is stated.
    ReadOff,
    /// A slip of the source leads to the printed digits, so they are not right.
    ReproducedInError,
    /// The printed form fails and the corrected form passes.
    Corrected,
    /// The printed form fails, and no corrected form is known.
    NotReproduced,
    /// A value that the claim needs is missing.
    NotReproducible,
}

slugs!(Verdict {
    Reproduced = "reproduced",
    Truncated = "truncated",
    FromRounded = "from-rounded",
    ReadOff = "read-off",
    ReproducedInError = "reproduced-in-error",
    Corrected = "corrected",
    NotReproduced = "not-reproduced",
    NotReproducible = "not-reproducible",
});

slugs!(Truth { Right = "right", Wrong = "wrong", Open = "open" });

/// Whether what is printed is right about the thing it describes, which is another question than whether it is
/// reproduced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Truth {
    /// It is right, to the printed digits, or as finely as it could be read off.
    Right,
    /// It is wrong, if only in a last digit.
    Wrong,
    /// We cannot tell.
    Open,
}

impl Truth {
    /// What it means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Right => {
                "what is printed is right, to the printed digits or, if it was read off, as finely as it could be read"
            }
            Self::Wrong => "what is printed is wrong, and we give the right form or number",
            Self::Open => "we cannot tell",
        }
    }
}

impl Verdict {
    /// What the class means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Reproduced => {
                "the exact value rounds to the printed digits, or an equation or statement holds as printed"
            }
            Self::Truncated => {
                "the printed digits are the first digits of the exact value, but rounding would change the last of them"
            }
            Self::FromRounded => {
                "the source's own rounded intermediate results give the printed digits, but the exact value has other \
                 digits"
            }
            Self::ReadOff => {
                "read from a curve or a print-out, or announced as approximate by the source, and right within the \
                 stated resolution"
            }
            Self::ReproducedInError => {
                "the source's own method gives the printed digits, but the method contains a mistake, so the right \
                 number is a different one"
            }
            Self::Corrected => "the printed form fails, but a corrected form passes, and a second witness agrees",
            Self::NotReproduced => "the printed form fails, and no corrected form is known",
            Self::NotReproducible => "a value that the claim needs is missing from the source",
        }
    }

    /// Whether a claim with this verdict must carry an erratum.
    pub fn needs_erratum(self) -> bool {
        self.truth() == Truth::Wrong
    }
}
