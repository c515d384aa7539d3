//! The sources, as values that every claim must carry.

use crate::{Claim, Line, Malformed, Symbol, inventory_file, jazar, meyer, pin, quick_return, wild};
use std::fmt;
use std::sync::OnceLock;

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
    /// Statements on public pages and in public programs, each with its address.
    Wild,
}

impl Work {
    /// All sources, in the order of the book.
    pub const ALL: &[Self] = &[Self::Pin, Self::QuickReturn, Self::Jazar2003, Self::Meyer1973, Self::Wild];

    /// The documents that the book mirrors line by line. Their totals are counted without the statements elsewhere.
    pub const DOCUMENTS: &[Self] = &[Self::Pin, Self::QuickReturn, Self::Jazar2003, Self::Meyer1973];

    /// Whether it is one of the documents.
    pub fn is_document(self) -> bool {
        Self::DOCUMENTS.contains(&self)
    }

    /// Short name, as it starts the ids of its claims.
    pub fn slug(self) -> &'static str {
        match self {
            Self::Pin => "pin",
            Self::QuickReturn => "quick-return",
            Self::Jazar2003 => "jazar",
            Self::Meyer1973 => "meyer",
            Self::Wild => "wild",
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
            Self::Wild => {
                "Statements on public pages and in public programs, each with the address of its source and the day on \
                 which a stored copy was read."
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
            Self::Wild => wild::claims(),
        }
    }

    /// The source line by line: which claim or exception each printed number belongs to; empty for statements that are
    /// in no document. An error if its inventory file cannot be read, which a test excludes.
    pub fn inventory(self) -> Result<&'static [Line], &'static Malformed> {
        static READ: [OnceLock<Result<Vec<Line>, Malformed>>; Work::ALL.len()] =
            [const { OnceLock::new() }; Work::ALL.len()];
        let read = READ[self as usize].get_or_init(|| inventory_file::read(self.slug(), self.inventory_file()));
        read.as_ref().map(Vec::as_slice)
    }

    /// The inventory file that a copy of the source asks for: a line for each line with numbers; what the file says of
    /// a line is kept if its numbers have not changed.
    pub fn inventory_for(self, copy: &str) -> String {
        inventory_file::recorded(self.inventory_file(), copy)
    }

    /// The text of the inventory file.
    pub(crate) fn inventory_file(self) -> &'static str {
        match self {
            Self::Pin => include_str!("../sources/pin.inventory"),
            Self::QuickReturn => include_str!("../sources/quick-return.inventory"),
            Self::Jazar2003 => include_str!("../sources/jazar.inventory"),
            Self::Meyer1973 => include_str!("../sources/meyer.inventory"),
            Self::Wild => "",
        }
    }

    /// The claims that print the answers to what a problem asks for; none for a source that asks for no numbers.
    pub fn answers(self) -> &'static [&'static str] {
        match self {
            Self::Pin => pin::ANSWERS,
            Self::QuickReturn => quick_return::ANSWERS,
            Self::Jazar2003 => jazar::ANSWERS,
            Self::Meyer1973 | Self::Wild => &[],
        }
    }

    /// What the source concludes and a slip may make false: the claim, and what shows that it is a conclusion and no
    /// remark, its place or the words before it.
    pub fn conclusions(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::Meyer1973 => meyer::CONCLUSIONS,
            Self::Pin | Self::QuickReturn | Self::Jazar2003 | Self::Wild => &[],
        }
    }

    /// The source's letters and ours.
    pub fn symbols(self) -> &'static [Symbol] {
        match self {
            Self::Pin => pin::SYMBOLS,
            Self::QuickReturn => quick_return::SYMBOLS,
            Self::Jazar2003 => jazar::SYMBOLS,
            Self::Meyer1973 => meyer::SYMBOLS,
            // Each page has letters of its own; what they stand for is told with each statement.
            Self::Wild => &[],
        }
    }
}

impl fmt::Display for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.slug())
    }
}
