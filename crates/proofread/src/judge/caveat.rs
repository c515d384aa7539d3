//! What makes it less certain that a difference is a fault of the text: few digits at its place, many others in its document, or that it is
//! slight, if no edit is much likelier than others to be the slip.
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

/// What makes it less certain that a difference is a fault of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Caveat {
    /// Few digits are printed on the two sides.
    Short,
    /// Many pairs of the document differ.
    Clustered,
    /// The sides differ by less than a thousandth.
    Slight,
}

impl Caveat {
    /// The reason, to follow "less certain, since".
    ///
    /// ```
    /// use proofread::{Caveat, CheckOptions, TextFormat, proofread};
    ///
    /// let report = proofread("$3 + 4 = 8$", TextFormat::Markdown, CheckOptions::default())?;
    /// assert_eq!(report.findings[0].caveat, Some(Caveat::Short));
    /// assert!(Caveat::Short.reason().starts_with("few digits are printed here"));
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn reason(self) -> &'static str {
        match self {
            Self::Short => "few digits are printed here, and no edit stands out as the slip",
            Self::Clustered => "many others of the document differ, and no edit stands out as the slip",
            Self::Slight => "the sides differ by less than a thousandth, and no edit stands out as the slip",
        }
    }
}

/// What speaks for and against it that two sides that differ were read right.
///
/// ```
/// use proofread::{Caveat, DifferenceEvidence};
///
/// let sum = DifferenceEvidence { digits: 5, has_hint: false, is_slight: false, differing: 1 };
/// assert_eq!(sum.caveat(), Some(Caveat::Short));
/// assert_eq!(DifferenceEvidence { has_hint: true, ..sum }.caveat(), None);
/// assert_eq!(DifferenceEvidence { digits: 8, ..sum }.caveat(), None);
/// assert_eq!(DifferenceEvidence { digits: 8, differing: 6, ..sum }.caveat(), Some(Caveat::Clustered));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DifferenceEvidence {
    /// Significant digits printed on the two sides, at least one for each number.
    pub digits: u32,
    /// Whether a hint tells the edit that is the likeliest slip; also if none was searched for.
    pub has_hint: bool,
    /// Whether the sides differ by less than a thousandth.
    pub is_slight: bool,
    /// Pairs of the document that differ in their numbers, this one with them.
    pub differing: usize,
}

impl DifferenceEvidence {
    /// What makes the difference less certain, if anything does.
    pub fn caveat(self) -> Option<Caveat> {
        let caveats = [
            (self.digits <= FEW_DIGITS, Caveat::Short),
            (self.differing >= MANY, Caveat::Clustered),
            (self.is_slight, Caveat::Slight),
        ];
        let first = caveats.into_iter().find_map(|(holds, caveat)| holds.then_some(caveat));
        first.filter(|_| !self.has_hint)
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
        has_hint: bool,
    ) {
        let digits = sides.into_iter().map(digits).fold(0, u32::saturating_add);
        let is_slight = values.is_some_and(|(left, right)| left.difference(right) < SLIGHT);
        self.0.push((finding, DifferenceEvidence { digits, has_hint, is_slight, differing: 0 }));
    }

    /// What makes each of them less certain, in a document with so many pairs that differ.
    pub(crate) fn caveats(self, differing: usize) -> impl Iterator<Item = (usize, Option<Caveat>)> {
        let whole = move |evidence| DifferenceEvidence { differing, ..evidence };
        self.0.into_iter().map(move |(finding, evidence)| (finding, whole(evidence).caveat()))
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
