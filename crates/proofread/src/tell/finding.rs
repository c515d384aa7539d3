//! What was found at one place.

use crate::join::chain::{Chain, ChainSide, Relation};
use crate::judge::caveat::Caveat;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::doubt::Doubt;
use crate::judge::section::ReportSection;
use crate::judge::verdict::PairJudgement;
use crate::tell::hint::Hint;
use crate::tell::recomputed::PrintedPair;
use crate::token::{Span, show};
use std::ops::Range;

/// Two neighbouring sides that do not agree.
///
/// ```
/// use proofread::{CheckOptions, TextFormat, proofread};
///
/// let text = r"It is $\tan 31.0^\circ = 0.609$. And it is $3 + 4 = 111$ in binary.";
/// let options = CheckOptions { agreeing: true, ..CheckOptions::default() };
/// let [tangent, sum] = proofread(text, TextFormat::Markdown, options)?.findings.try_into().expect("two findings");
/// assert_eq!((tangent.printed.as_str(), tangent.recomputed.as_deref()), ("0.609", Some("0.601")));
/// assert_eq!(tangent.hint.map(|hint| hint.words).as_deref(), Some("`0.601` for `0.609`"));
/// assert_eq!((tangent.explanation, sum.explanation), (None, Some("other-base")));
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ChainFinding {
    /// How they compare.
    pub verdict: ChainVerdict,
    /// In which section of the report it stands.
    pub section: ReportSection,
    /// Why it is set aside, if it is.
    pub doubt: Option<Doubt>,
    /// What makes it less certain that the text is wrong there. If it is in the section of numbers all the same, it is the first
    /// of a document in which a third of the pairs differ, or has the shape of that one.
    pub caveat: Option<Caveat>,
    /// The chain, as one line; of a long one, the part around the two sides.
    pub chain: String,
    /// The bytes of `chain` that are the place to look at.
    pub marked: Range<usize>,
    /// The chain's place in the text.
    pub span: Span,
    /// The left side, as one line.
    pub left: String,
    /// The left side's place.
    pub left_span: Span,
    /// The right side, as one line.
    pub right: String,
    /// The right side's place.
    pub right_span: Span,
    /// The place to look at: the printed result, or the right side.
    pub at: Span,
    /// The printed result, with its unit.
    pub printed: String,
    /// What is computed, to as many digits and in the same unit, so that it may stand in the place of the printed result; if no side
    /// is a printed result, what both sides give, as *7 against 8*; if the units differ, in units of its own. None if a side
    /// has no value.
    pub recomputed: Option<String>,
    /// The printed value over the computed one, dimensionless, to six digits; none if they have no common unit, or one of them is zero.
    pub factor: Option<f64>,
    /// In which way the values differ, in words, where that says more than their digits: *a factor of 1,000*.
    pub difference: Option<String>,
    /// The name of the explanation that decided the verdict, one of [`explanation_names`](crate::explanation_names); none if the
    /// sides compare so as they are printed.
    pub explanation: Option<&'static str>,
    /// What keeps the sides from being compared, if that is what was found.
    pub why: Option<String>,
    /// The single edit that makes the sides agree, if there is exactly one near.
    pub hint: Option<Hint>,
    /// How the characters were read, where there was a choice.
    pub reading: Vec<&'static str>,
    /// The names whose values were taken from elsewhere in the text.
    pub names: Vec<String>,
}

/// Sides of a chain that are shown before and behind the two sides that do not agree.
const SHOWN_AROUND: usize = 12;

impl ChainFinding {
    pub(crate) fn new(
        chain: &Chain,
        left: &ChainSide,
        right: &ChainSide,
        judgement: &PairJudgement,
        section: ReportSection,
        hint: Option<Hint>,
    ) -> Self {
        let values = judgement.values.as_ref();
        let right_is_printed = values.is_none_or(|(left, right)| right.is_literal() || !left.is_literal());
        let printed = if right_is_printed { right } else { left };
        let ends = chain.sides.first().into_iter().chain(chain.sides.last());
        let span = ends.fold(left.span.join(right.span), |span, side| span.join(side.span));
        let (line, marked) = line(chain, right, printed);
        let computed = if right_is_printed { left } else { right };
        let recomputed = PrintedPair { computed, printed, right_is_printed, judgement }.recomputed(section);
        Self {
            verdict: judgement.verdict,
            section,
            doubt: None,
            caveat: None,
            chain: line,
            marked,
            span,
            left: show(&left.tokens),
            left_span: left.span,
            right: show(&right.tokens),
            right_span: right.span,
            at: printed.span,
            printed: show(&printed.tokens),
            recomputed: recomputed.shown,
            factor: recomputed.factor,
            difference: recomputed.difference,
            explanation: judgement.explanation,
            why: judgement.obstacle.as_ref().map(ToString::to_string),
            hint,
            reading: judgement.reading.descriptions(),
            names: judgement.used.clone(),
        }
    }

    /// What is printed and what is computed, in words.
    ///
    /// ```
    /// use proofread::{CheckOptions, TextFormat, proofread};
    ///
    /// let report = proofread(r"$0.6 \cdot 200 = 12000$", TextFormat::Markdown, CheckOptions::default())?;
    /// let finding = &report.findings[0];
    /// assert_eq!(finding.values_in_words(), "printed 12000, recomputed 120 (a factor of 100)");
    /// assert_eq!(finding.factor, Some(100.0));
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn values_in_words(&self) -> String {
        match (self.recomputed_in_words(), &self.difference) {
            (Some(recomputed), _) if self.gives_both() => format!("recomputed {recomputed}"),
            (Some(_), _) if self.recomputed.as_ref() == Some(&self.printed) => {
                format!("printed and recomputed {}", self.printed)
            }
            (Some(recomputed), _) => format!("printed {}, recomputed {recomputed}", self.printed),
            (None, Some(difference)) => format!("printed {}, but {difference}", self.printed),
            (None, None) => format!("printed {}", self.printed),
        }
    }

    /// What is computed and in which way it differs from what is printed, in words; none if a side has no value.
    ///
    /// ```
    /// use proofread::{CheckOptions, TextFormat, proofread};
    ///
    /// let report = proofread(r"$3.0 \cdot 20 = -60$", TextFormat::Markdown, CheckOptions::default())?;
    /// assert_eq!(report.findings[0].recomputed_in_words().as_deref(), Some("60 (the sign differs)"));
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn recomputed_in_words(&self) -> Option<String> {
        let recomputed = self.recomputed.as_ref()?;
        Some(match &self.difference {
            Some(difference) => format!("{recomputed} ({difference})"),
            None => recomputed.clone(),
        })
    }

    /// Whether neither side is a printed result.
    fn gives_both(&self) -> bool {
        self.recomputed.as_ref().is_some_and(|recomputed| recomputed.contains(" against "))
    }

    /// Changes where everything in it was written.
    pub(crate) fn map_spans(&mut self, to: &dyn Fn(Span) -> Span) {
        let own = [&mut self.span, &mut self.left_span, &mut self.right_span, &mut self.at];
        own.into_iter().chain(self.hint.as_mut().map(|hint| &mut hint.at)).for_each(|span| *span = to(*span));
    }
}

/// The chain around the side `right` as one line, and where the side `printed` is in it.
fn line(chain: &Chain, right: &ChainSide, printed: &ChainSide) -> (String, Range<usize>) {
    let at = chain.sides.iter().position(|side| std::ptr::eq(side, right)).unwrap_or(0);
    line_around(chain, at, Some(printed))
}

/// The start of a chain as one line.
#[cfg(feature = "cli")]
pub(crate) fn chain_line(chain: &Chain) -> String {
    line_around(chain, 0, None).0
}

fn line_around(chain: &Chain, at: usize, printed: Option<&ChainSide>) -> (String, Range<usize>) {
    let shown = at.saturating_sub(SHOWN_AROUND)..chain.sides.len().min(at + SHOWN_AROUND);
    let mut line = if shown.start > 0 { "…".to_owned() } else { String::new() };
    let mut marked = 0..0;
    for side in &chain.sides[shown.clone()] {
        line += match side.relation {
            None => "",
            Some(Relation::Equal) => " = ",
            Some(Relation::Approximate) => " ≈ ",
            Some(Relation::Other) => " … ",
        };
        let start = line.len();
        line += &show(&side.tokens);
        if printed.is_some_and(|printed| std::ptr::eq(side, printed)) {
            marked = start..line.len();
        }
    }
    if shown.end < chain.sides.len() {
        line += " …";
    }
    (line, marked)
}
