//! The classes of verdict.

use std::fmt;

/// What became of a printed claim. Derived by [`judge`](crate::judge), never asserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// The exact value rounds to the printed digits, or the printed form holds.
    Reproduced,
    /// The exact value gives the printed digits only by cutting off.
    Truncated,
    /// Only the source's own rounded intermediates give the printed digits.
    FromRounded,
    /// Read from a curve or a print-out, and right within the reading's resolution.
    ReadOff,
    /// The printed form fails and the corrected form passes.
    Corrected,
    /// The printed form fails, and no corrected form is known.
    NotReproduced,
    /// A datum is missing.
    NotReproducible,
}

impl Verdict {
    /// All classes, best first.
    pub const ALL: &[Self] = &[
        Self::Reproduced,
        Self::Truncated,
        Self::FromRounded,
        Self::ReadOff,
        Self::Corrected,
        Self::NotReproduced,
        Self::NotReproducible,
    ];

    /// The name used in data and on the command line.
    pub fn slug(self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::Truncated => "truncated",
            Self::FromRounded => "from-rounded",
            Self::ReadOff => "read-off",
            Self::Corrected => "corrected",
            Self::NotReproduced => "not-reproduced",
            Self::NotReproducible => "not-reproducible",
        }
    }

    /// What the class means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Reproduced => {
                "the exact value rounds to the printed digits; an equation or statement holds as printed"
            }
            Self::Truncated => "the exact value gives the printed digits only by cutting off, not by rounding",
            Self::FromRounded => "only the source's own rounded intermediate results give the printed digits",
            Self::ReadOff => "read from a curve or a print-out, and right within the stated resolution of the reading",
            Self::Corrected => "the printed form fails; a corrected form passes, and a second witness agrees",
            Self::NotReproduced => "the printed form fails, and no corrected form is known",
            Self::NotReproducible => "a datum that the claim needs is missing from the source",
        }
    }

    /// Whether a claim with this verdict must carry an erratum.
    pub fn needs_erratum(self) -> bool {
        matches!(self, Self::Truncated | Self::FromRounded | Self::Corrected)
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.slug())
    }
}
