//! How sure it is that a difference is a fault of the text: by how many digits are printed at its place, whether one edit mends it, and how many
//! others its document has.
//!
//! What misreads a text is not known beforehand, since each new text has notations of its own. But what is misread is mostly short, as a piece
//! of something else is; no slip of one digit explains it; and it comes in clusters. The rates are in `judged/README.md`.

use crate::evaluate::value::SideValue;
use crate::token::Token;

/// Significant digits on both sides that are few.
const FEW_DIGITS: u32 = 5;

/// Pairs that differ in a document that are many.
const MANY: usize = 6;

/// Two sides that differ by less, relative to the larger one, may differ by digits that are not printed.
const SLIGHT: f64 = 1e-3;

/// How sure it is that a difference is a fault of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Confidence {
    /// Nothing speaks against it.
    High,
    /// No single edit mends it, and few digits are printed there, or many other pairs of the document differ, or it is slight.
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
    /// assert!(Confidence::Low.caveat().is_some_and(|why| why.starts_with("no single edit mends it")));
    /// ```
    pub fn caveat(self) -> Option<&'static str> {
        const WHY: &str = "no single edit mends it, and it is short or slight, or much else of the document differs";
        (self == Self::Low).then_some(WHY)
    }
}

/// What speaks for and against it that two sides that differ were read right.
///
/// ```
/// use proofread::{Confidence, DifferenceEvidence};
///
/// let sum = DifferenceEvidence { digits: 5, is_mended: false, is_slight: false, differing: 1 };
/// assert_eq!(sum.confidence(), Some(Confidence::Low));
/// assert_eq!(DifferenceEvidence { is_mended: true, ..sum }.confidence(), Some(Confidence::High));
/// assert_eq!(DifferenceEvidence { digits: 8, ..sum }.confidence(), Some(Confidence::High));
/// assert_eq!(DifferenceEvidence { differing: 6, ..sum }.confidence(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DifferenceEvidence {
    /// Significant digits printed on the two sides, at least one for each number.
    pub digits: u32,
    /// Whether a hint tells the single edit that mends it; also if none was searched for.
    pub is_mended: bool,
    /// Whether the sides differ by less than a thousandth.
    pub is_slight: bool,
    /// Pairs of the document that differ in their numbers, this one with them.
    pub differing: usize,
}

impl DifferenceEvidence {
    /// How sure the difference is; none if so little speaks for it that it is set aside.
    pub fn confidence(self) -> Option<Confidence> {
        let is_short = self.digits <= FEW_DIGITS;
        let has_many = self.differing >= MANY;
        let is_low = !self.is_mended && (is_short || has_many || self.is_slight);
        let confidence = if is_low { Confidence::Low } else { Confidence::High };
        (!(is_short && has_many)).then_some(confidence)
    }
}

/// Findings on numbers, each with what speaks for and against it.
#[derive(Default)]
pub(crate) struct WeighedFindings(Vec<(usize, DifferenceEvidence)>);

impl WeighedFindings {
    pub(crate) fn record(
        &mut self,
        finding: usize,
        sides: [&[Token]; 2],
        values: Option<&(SideValue, SideValue)>,
        is_mended: bool,
    ) {
        let digits = sides.into_iter().map(digits).fold(0, u32::saturating_add);
        let is_slight = values.is_some_and(|(left, right)| left.difference(right) < SLIGHT);
        self.0.push((finding, DifferenceEvidence { digits, is_mended, is_slight, differing: 0 }));
    }

    /// How sure each of them is, in a document with so many pairs that differ.
    pub(crate) fn confidences(self, differing: usize) -> impl Iterator<Item = (usize, Option<Confidence>)> {
        let whole = move |evidence| DifferenceEvidence { differing, ..evidence };
        self.0.into_iter().map(move |(finding, evidence)| (finding, whole(evidence).confidence()))
    }
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
