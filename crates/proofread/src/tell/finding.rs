//! What was found at one place.

use crate::evaluate::exponent::plain_exponent;
use crate::evaluate::printed::{format_significant, power_of_ten};
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::SideValue;
use crate::join::chain::{Chain, ChainSide, Relation};
use crate::judge::doubt::Doubt;
use crate::judge::section::ReportSection;
use crate::judge::verdict::{ChainVerdict, PairJudgement};
use crate::tell::hint::Hint;
use crate::token::{Span, Token, TokenKind, show};
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
    /// What is computed, to as many digits and in the same unit; none if the sides have no common unit.
    pub recomputed: Option<String>,
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
        let recomputed = values.and_then(|(left, right)| {
            let (computed, printed_value) = if right_is_printed { (left, right) } else { (right, left) };
            recomputed(computed, printed_value, &printed.tokens, judgement)
        });
        Self {
            verdict: judgement.verdict,
            section,
            doubt: None,
            chain: line,
            marked,
            span,
            left: show(&left.tokens),
            left_span: left.span,
            right: show(&right.tokens),
            right_span: right.span,
            at: printed.span,
            printed: show(&printed.tokens),
            recomputed,
            explanation: judgement.explanation,
            why: judgement.obstacle.as_ref().map(ToString::to_string),
            hint,
            reading: judgement.reading.descriptions(),
            names: judgement.used.clone(),
        }
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

/// The computed value in the unit and with the digits of the printed one.
fn recomputed(
    computed: &SideValue,
    printed: &SideValue,
    tokens: &[Token],
    judgement: &PairJudgement,
) -> Option<String> {
    if judgement.verdict == ChainVerdict::Units || judgement.verdict == ChainVerdict::Dimensions {
        return None;
    }
    if computed.parts.is_vector() || printed.parts.is_vector() || judgement.reading.contains(ReadingChoices::POINTS) {
        return None;
    }
    let computed = computed.number().ok()?.point;
    let printed_point = printed.number().ok()?.point;
    if !printed.is_literal() {
        return Some(format!("{} against {}", format_significant(computed, 4), format_significant(printed_point, 4)));
    }
    let factor = if printed.factor == 0.0 { 1.0 } else { printed.factor };
    let (value, digits) = (computed / factor, digits_of(tokens));
    let scaled = |power: i32| format_significant(value / power_of_ten(f64::from(power)), digits);
    let mut text = match power_of(tokens) {
        // The power of ten of the printed number, or the nearest one if that is far off.
        Some(power) => {
            let own = if value == 0.0 { power } else { libm::floor(libm::log10(value.abs())) as i32 };
            let power = if (-1..=2).contains(&(own - power)) { power } else { own };
            format!("{} × 10^{power}", scaled(power)).replace("^-", "^−")
        }
        None if is_whole(tokens) && libm::fabs(value - libm::round(value)) < 1e-9 && value.abs() < 1e9 => {
            (libm::round(value) as i64).to_string()
        }
        None => format_significant(value, digits),
    };
    if let Some(size) = text.strip_prefix('-') {
        text = format!("−{size}");
    }
    let unit = unit_text(tokens);
    Some(if unit.starts_with(['°', '%']) && !unit.starts_with("°C") {
        text + &unit
    } else {
        format!("{text} {unit}").trim().to_owned()
    })
}

/// Whether the number is printed without a point.
fn is_whole(tokens: &[Token]) -> bool {
    tokens.iter().find_map(Token::number).is_some_and(|number| !number.contains('.'))
}

fn digits_of(tokens: &[Token]) -> usize {
    let number = tokens.iter().find_map(Token::number).unwrap_or("0");
    let digits: String = number.chars().filter(char::is_ascii_digit).collect();
    let significant = digits.trim_start_matches('0').len();
    significant.max(2)
}

fn power_of(tokens: &[Token]) -> Option<i32> {
    let at = tokens.iter().position(|token| token.number() == Some("10"))?;
    let TokenKind::Power(exponent) = &tokens.get(at + 1)?.kind else { return None };
    plain_exponent(exponent).ok().map(|power| power as i32).filter(|_| at > 0)
}

/// What follows the number.
fn unit_text(tokens: &[Token]) -> String {
    let start = tokens.iter().position(|token| token.word().is_some() || matches!(token.kind, TokenKind::Fraction(..)));
    let unit = start.map_or(&[][..], |start| &tokens[start..]);
    show(unit)
}
