//! What makes it less certain that a difference is a fault of the text, if no edit is much likelier than others to be the slip.
//!
//! What misreads a text is not known beforehand, since each new text has notations of its own. But a notation that is not known is met
//! again and again in its document, and what is misread is often no calculation at all, or short. The rates are in `judged/README.md`.

use crate::judge::chain_shape::{chain_computes, has_other_signs, is_name, is_single_name};

/// Digits of a chain that are few.
const FEW_DIGITS: usize = 4;

/// Two sides that differ by less, relative to the larger one, may differ by digits that are not printed.
pub(crate) const SLIGHT: f64 = 1e-3;

/// Of so many pairs of a document, one that differs is a large share.
const ONE_OF: usize = 3;

/// Least pairs that differ in a document before their share says anything: a document may have one pair, and that one wrong.
const SEVERAL: usize = 2;

/// What makes it less certain that a difference is a fault of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Caveat {
    /// No side of the chain computes anything.
    Uncomputed,
    /// The chain has few digits, and beside them something other than operations, known functions and units.
    Short,
    /// The sides differ by less than a thousandth.
    Slight,
    /// A third of the pairs of the document differ, or more.
    Share {
        /// Pairs that differ.
        differing: usize,
        /// Pairs that were compared.
        pairs: usize,
    },
}

impl Caveat {
    /// The reason, to follow "less certain:".
    ///
    /// ```
    /// use proofread::{Caveat, CheckOptions, ReportSection, TextFormat, proofread};
    ///
    /// let report = proofread(r"$|3| = 4$", TextFormat::Markdown, CheckOptions::default())?;
    /// assert_eq!(report.findings[0].section, ReportSection::LessCertain);
    /// assert_eq!(report.findings[0].caveat, Some(Caveat::Uncomputed));
    /// assert!(Caveat::Uncomputed.reason().starts_with("neither side computes anything"));
    /// assert!(Caveat::Share { differing: 2, pairs: 5 }.reason().starts_with("2 of 5 pairs of this document differ"));
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn reason(self) -> String {
        let reason = match self {
            Self::Uncomputed => {
                "neither side computes anything, so that the equals sign may mean something else, and no edit stands out as the slip"
            }
            Self::Short => {
                "few digits are printed here, beside letters or signs that may mean something else, and no edit stands out as the slip"
            }
            Self::Slight => "the sides differ by less than a thousandth, and no edit stands out as the slip",
            Self::Share { differing, pairs } => {
                let verb = if differing == 1 { "differs" } else { "differ" };
                return [
                    &differing.to_string(),
                    " of ",
                    &pairs.to_string(),
                    " pairs of this document ",
                    verb,
                    ", which is mostly a notation that is not known here",
                ]
                .concat();
            }
        };
        reason.to_owned()
    }
}

/// What speaks for and against it that two sides that differ were read right.
///
/// ```
/// use proofread::{Caveat, DifferenceEvidence};
///
/// let sum = DifferenceEvidence { chain: "2 + 2 = 5", has_hint: false, is_slight: false, pairs: 9, differing: 1 };
/// assert_eq!(sum.caveat(), None);
/// assert_eq!(DifferenceEvidence { chain: "π(2) = 5", ..sum }.caveat(), Some(Caveat::Short));
/// assert_eq!(DifferenceEvidence { chain: "2 h = 5 km", ..sum }.caveat(), Some(Caveat::Uncomputed));
/// assert_eq!(DifferenceEvidence { differing: 3, ..sum }.caveat(), Some(Caveat::Share { differing: 3, pairs: 9 }));
/// assert_eq!(DifferenceEvidence { differing: 3, has_hint: true, ..sum }.caveat(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DifferenceEvidence<'c> {
    /// The chain, as a finding shows it.
    pub chain: &'c str,
    /// Whether a hint tells the edit that is the likeliest slip; also if no hints were wanted.
    pub has_hint: bool,
    /// Whether the sides differ by less than a thousandth.
    pub is_slight: bool,
    /// Pairs of the document that were compared.
    pub pairs: usize,
    /// Pairs of the document that differ in their numbers, this one with them.
    pub differing: usize,
}

impl DifferenceEvidence<'_> {
    /// What makes the difference less certain, if anything does.
    pub fn caveat(self) -> Option<Caveat> {
        self.own_caveat().or_else(|| self.share_caveat()).filter(|_| !self.has_hint)
    }

    /// What does so at its own place.
    fn own_caveat(self) -> Option<Caveat> {
        if !chain_computes(self.chain) && numeric_sides(self.chain).len() > 1 {
            Some(Caveat::Uncomputed)
        } else if has_few_digits_beside_others(self.chain) {
            Some(Caveat::Short)
        } else {
            self.is_slight.then_some(Caveat::Slight)
        }
    }

    /// What does so in its document, if a third of the pairs differ.
    pub(crate) fn share_caveat(self) -> Option<Caveat> {
        let Self { differing, pairs, .. } = self;
        (differing >= SEVERAL && differing.saturating_mul(ONE_OF) >= pairs)
            .then_some(Caveat::Share { differing, pairs: pairs.max(differing) })
    }
}

/// The sides of a chain with digits in them, without names, which are not compared with a number. If there is one side alone, it is
/// compared with the row before.
fn numeric_sides(chain: &str) -> Vec<&str> {
    let mut sides: Vec<&str> = chain.split(['=', '≈']).collect();
    if sides.len() > 2 && is_name(sides[0]) {
        sides.remove(0);
    }
    sides.retain(|side| side.bytes().any(|byte| byte.is_ascii_digit()) && !is_single_name(side));
    sides
}

/// Whether the sides have few digits, and beside them something other than operations, known functions and units.
fn has_few_digits_beside_others(chain: &str) -> bool {
    let sides = numeric_sides(chain);
    let digits: usize = sides.iter().map(|side| side.bytes().filter(u8::is_ascii_digit).count()).sum();
    sides.len() > 1 && digits <= FEW_DIGITS && sides.into_iter().any(has_other_signs)
}
