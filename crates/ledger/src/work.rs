//! The sources, as values that every claim must carry.

use crate::{Claim, Line, Symbol, pin};
use std::fmt;

/// A source document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Work {
    /// A textbook problem: the velocity of a pin in a four-slot Geneva wheel.
    Pin,
}

impl Work {
    /// All sources, in the order of the book.
    pub const ALL: &[Self] = &[Self::Pin];

    /// Short name, as it starts the ids of its claims.
    pub fn slug(self) -> &'static str {
        match self {
            Self::Pin => "pin",
        }
    }

    /// What the document is, in a line.
    pub fn citation(self) -> &'static str {
        match self {
            Self::Pin => {
                "Sample problem of an engineering-dynamics textbook with its worked solution: angular velocity of a \
                 four-slot Geneva wheel and velocity of the pin in its slot. Copy without title, author or year."
            }
        }
    }

    /// The claims that this source makes.
    pub fn claims(self) -> Vec<Claim> {
        match self {
            Self::Pin => pin::claims(),
        }
    }

    /// The source line by line: which claim or exception each printed number belongs to.
    pub fn inventory(self) -> &'static [Line] {
        match self {
            Self::Pin => pin::INVENTORY,
        }
    }

    /// The source's letters and ours.
    pub fn symbols(self) -> &'static [Symbol] {
        match self {
            Self::Pin => pin::SYMBOLS,
        }
    }
}

impl fmt::Display for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.slug())
    }
}
