//! How sure it is that a difference is a fault of the text: by how much is computed at its place, and how much of its document comes out as
//! printed.
//!
//! What misreads a text is not known beforehand, since each new text has notations of its own. But in a text that is misread much comes out
//! otherwise, and what is misread is mostly short, as a piece of something else is. The rates are in `judged/README.md`.

use crate::token::{Token, TokenKind};

/// Operations that count at most.
const MOST_OPERATIONS: u32 = 6;

/// Significant digits that count at most.
const MOST_DIGITS: u32 = 12;

/// What a digit weighs, if an operation weighs one.
const DIGIT: f64 = 0.3;

/// What it weighs that a document has e times fewer differences.
const PER_E_FOLD: f64 = 2.0;

/// Pairs that are added to those of each document, and how many of these differ: what is expected where nothing else is known.
const EXPECTED: (f64, f64) = (4.0, 0.2);

/// The least weight of a difference that is listed where many of its document differ. Of those below it, one of seven was real at first
/// contact.
const LISTED: f64 = 7.4;

/// The fewest pairs that differ in a document where differences of less weight are set aside. Fewer can all be looked at.
const MANY: usize = 6;

/// The least weight of a difference that is sure. Of these, three of four were real at first contact; of those between, one of three.
const SURE: f64 = 8.8;

/// How sure it is that a difference is a fault of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Confidence {
    /// Much is computed there, and hardly anything else of the document differs.
    High,
    /// Little is computed there, or much else of the document differs.
    Low,
}

impl Confidence {
    /// A name for programs: `high` or `low`.
    pub fn name(self) -> &'static str {
        match self {
            Self::High => "high",
            Self::Low => "low",
        }
    }

    /// Why the difference is less certain, to follow those words; none if it is not.
    ///
    /// ```
    /// use proofread::Confidence;
    ///
    /// assert_eq!(Confidence::High.caveat(), None);
    /// assert_eq!(Confidence::Low.caveat(), Some("little is computed here, or much else of the document differs"));
    /// ```
    pub fn caveat(self) -> Option<&'static str> {
        (self == Self::Low).then_some("little is computed here, or much else of the document differs")
    }
}

/// What speaks for it that two sides that differ were read right.
///
/// ```
/// use proofread::{Confidence, DifferenceEvidence};
///
/// // 12.5 · 3.2 = 41.0 as the only one of forty that differs, and as one of ten.
/// let alone = DifferenceEvidence { operations: 1, digits: 8, differing: 1, compared: 40 };
/// assert_eq!(alone.confidence(), Some(Confidence::High));
/// let of_many = DifferenceEvidence { differing: 10, ..alone };
/// assert_eq!(of_many.confidence(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DifferenceEvidence {
    /// Operations on the two sides, those in exponents and units with them.
    pub operations: u32,
    /// Significant digits printed on the two sides, at least one for each number.
    pub digits: u32,
    /// Pairs of the document that differ in their numbers, this one with them.
    pub differing: usize,
    /// Pairs of the document that were compared.
    pub compared: usize,
}

impl DifferenceEvidence {
    /// How sure the difference is; none if so little speaks for it that it is set aside.
    pub fn confidence(self) -> Option<Confidence> {
        let others = |count: usize, more: f64| count.saturating_sub(1) as f64 + more;
        let share = others(self.differing, EXPECTED.1) / others(self.compared, EXPECTED.0);
        let computed = self.operations.min(MOST_OPERATIONS);
        let printed = self.digits.min(MOST_DIGITS);
        let weight = f64::from(computed) + DIGIT * f64::from(printed) - PER_E_FOLD * libm::log(share);
        match weight {
            weight if weight >= SURE => Some(Confidence::High),
            weight if weight < LISTED && self.differing >= MANY => None,
            _ => Some(Confidence::Low),
        }
    }
}

/// Findings on numbers, each with how much is computed at its place.
#[derive(Default)]
pub(crate) struct WeighedFindings(Vec<(usize, [u32; 2])>);

impl WeighedFindings {
    pub(crate) fn record(&mut self, finding: usize, sides: [&[Token]; 2]) {
        let of = sides.map(|side| [operations(side), digits(side)]);
        self.0.push((finding, [of[0][0].saturating_add(of[1][0]), of[0][1].saturating_add(of[1][1])]));
    }

    /// How sure each of them is, in a document with so many pairs that differ of those that were compared.
    pub(crate) fn confidences(
        self,
        differing: usize,
        compared: usize,
    ) -> impl Iterator<Item = (usize, Option<Confidence>)> {
        self.0.into_iter().map(move |(finding, [operations, digits])| {
            (finding, DifferenceEvidence { operations, digits, differing, compared }.confidence())
        })
    }
}

/// The operations among tokens and inside them.
fn operations(tokens: &[Token]) -> u32 {
    let mut count = 0_u32;
    let mut behind_number = false;
    for token in tokens {
        let is_operation = match &token.kind {
            TokenKind::Operator('+' | '-') => behind_number,
            TokenKind::Operator(sign) => "×·*/:÷∘!".contains(*sign),
            TokenKind::Fraction(..) | TokenKind::Root(..) | TokenKind::Power(_) | TokenKind::Call(..) => true,
            TokenKind::Function(_) => true,
            _ => false,
        };
        count = count.saturating_add(u32::from(is_operation));
        count = token.inner().map(operations).fold(count, u32::saturating_add);
        if !token.is_space() {
            behind_number = match &token.kind {
                TokenKind::Operator(sign) => ")]}|!".contains(*sign),
                kind => !matches!(kind, TokenKind::Line | TokenKind::Cell | TokenKind::Function(_)),
            };
        }
    }
    count
}

/// The significant digits of the numbers among tokens and inside them.
fn digits(tokens: &[Token]) -> u32 {
    let of = |token: &Token| {
        let own = token.number().map_or(0, |number| {
            let printed = number.trim_start_matches(['0', '.', ',']);
            let printed = printed.trim_end_matches(['0', '.', ',']);
            printed.chars().filter(char::is_ascii_digit).count().max(1)
        });
        let own = u32::try_from(own).unwrap_or(u32::MAX);
        token.inner().map(digits).fold(own, u32::saturating_add)
    };
    tokens.iter().map(of).fold(0, u32::saturating_add)
}
