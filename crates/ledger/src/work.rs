//! The sources, as values that every claim must carry.

use crate::{Claim, Line, Symbol, jazar, meyer, pin, quick_return};
use std::fmt;

/// A source document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Work {
    /// A textbook problem: the velocity of a pin in a four-slot Geneva wheel.
    Pin,
    /// An examination problem: velocity and acceleration diagram of a quick-return mechanism.
    QuickReturn,
    /// A lecture handout of 2003: the N-station Geneva wheel.
    Jazar2003,
    /// A master's project of 1973: the Geneva mechanism as a timing device.
    Meyer1973,
}

impl Work {
    /// All sources, in the order of the book.
    pub const ALL: &[Self] = &[Self::Pin, Self::QuickReturn, Self::Jazar2003, Self::Meyer1973];

    /// Short name, as it starts the ids of its claims.
    pub fn slug(self) -> &'static str {
        match self {
            Self::Pin => "pin",
            Self::QuickReturn => "quick-return",
            Self::Jazar2003 => "jazar",
            Self::Meyer1973 => "meyer",
        }
    }

    /// What the document is, in a line.
    pub fn citation(self) -> &'static str {
        match self {
            Self::Pin => {
                "Sample problem of an engineering-dynamics textbook with its worked solution: angular velocity of a \
                 four-slot Geneva wheel and velocity of the pin in its slot. Copy without title, author or year."
            }
            Self::QuickReturn => {
                "Examination problem on the dynamics of machinery with its worked solution: velocity and acceleration \
                 diagram of a slotted-lever quick-return mechanism. Copy without drawings, title, author or year."
            }
            Self::Jazar2003 => {
                "G. Nakhaie Jazar, lecture handout on the Geneva mechanism, ME341 Mechanics of Machinery, North Dakota \
                 State University, Fargo, fall 2003. Equations (5.25) to (5.34), figures 5.28 to 5.31 (captions only)."
            }
            Self::Meyer1973 => {
                "H. W. Meyer Jr., An Analysis of the Geneva Mechanism as a Timing Device, master's project, Newark College \
                 of Engineering, May 1973. Equations (1-1) to (1-19), program and tables; figures 1 to 15 as captions only."
            }
        }
    }

    /// The claims that this source makes.
    pub fn claims(self) -> Vec<Claim> {
        match self {
            Self::Pin => pin::claims(),
            Self::QuickReturn => quick_return::claims(),
            Self::Jazar2003 => jazar::claims(),
            Self::Meyer1973 => meyer::claims(),
        }
    }

    /// The source line by line: which claim or exception each printed number belongs to.
    pub fn inventory(self) -> &'static [Line] {
        match self {
            Self::Pin => pin::INVENTORY,
            Self::QuickReturn => quick_return::INVENTORY,
            Self::Jazar2003 => jazar::INVENTORY,
            Self::Meyer1973 => meyer::inventory(),
        }
    }

    /// The source's letters and ours.
    pub fn symbols(self) -> &'static [Symbol] {
        match self {
            Self::Pin => pin::SYMBOLS,
            Self::QuickReturn => quick_return::SYMBOLS,
            Self::Jazar2003 => jazar::SYMBOLS,
            Self::Meyer1973 => meyer::SYMBOLS,
        }
    }
}

impl fmt::Display for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.slug())
    }
}
