//! Verdicts in five plain words, as readers see them on pages.
//!
//! The eight classes of [`Verdict`] say what became of a claim, in data. A reader wants to know whether what is printed is right,
//! so pages say it in these five words and in no others. Which class becomes which word is decided here only.

use crate::slugs::slugs;
use crate::{Truth, Verdict};

/// Whether what is printed is right, as a page says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PlainVerdict {
    /// It is right as printed.
    Right,
    /// It was read from a curve or a print-out, and is right within the reading error.
    RightAsRead,
    /// It is wrong, if only in a last digit.
    Wrong,
    /// Only the copy at hand is wrong; nothing is said of the original.
    WrongInCopy,
    /// We cannot tell.
    Open,
}

slugs!(PlainVerdict {
    Right = "right",
    RightAsRead = "right-as-read",
    Wrong = "wrong",
    WrongInCopy = "wrong-in-copy",
    Open = "open",
});

impl PlainVerdict {
    /// The words on a page.
    pub fn words(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::RightAsRead => "right as read",
            Self::Wrong => "wrong",
            Self::WrongInCopy => "wrong in our copy",
            Self::Open => "open",
        }
    }

    /// The sign for it behind a word or in a table.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Right => "✓",
            Self::RightAsRead => "≈",
            Self::Wrong | Self::WrongInCopy => "✗",
            Self::Open => "?",
        }
    }

    /// What it means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Right => "what is printed is right, a number to its last digit",
            Self::RightAsRead => {
                "a number that was read from a curve or a print-out, or that the source calls approximate, is right within \
                 the reading error"
            }
            Self::Wrong => "what is printed is wrong, a number perhaps only in its last digit",
            Self::WrongInCopy => "only the copy we had is wrong, which has lost or changed a character",
            Self::Open => "we cannot tell",
        }
    }

    /// Right, wrong or open: a reading counts as right, and a mistake of the copy as one of what is printed.
    pub fn truth(self) -> Truth {
        match self {
            Self::Right | Self::RightAsRead => Truth::Right,
            Self::Wrong | Self::WrongInCopy => Truth::Wrong,
            Self::Open => Truth::Open,
        }
    }
}

impl Verdict {
    /// The plain verdict on a claim of this class. `in_copy` says that only a copy is wrong, where something is.
    pub fn plain(self, in_copy: bool) -> PlainVerdict {
        match self {
            Self::Reproduced => PlainVerdict::Right,
            Self::ReadOff => PlainVerdict::RightAsRead,
            Self::Truncated | Self::FromRounded | Self::ReproducedInError | Self::Corrected if in_copy => {
                PlainVerdict::WrongInCopy
            }
            // Rounded steps explain a last digit, but do not make it right.
            Self::Truncated | Self::FromRounded | Self::ReproducedInError | Self::Corrected => PlainVerdict::Wrong,
            Self::NotReproduced | Self::NotReproducible => PlainVerdict::Open,
        }
    }

    /// The answer to the question whether what is printed is right.
    pub fn truth(self) -> Truth {
        self.plain(false).truth()
    }
}
