//! What may explain that two sides differ, although nothing is wrong: each explanation has a name, and they are tried in order.

use crate::evaluate::expression::NameValues;
use crate::evaluate::printed::power_of_ten;
use crate::evaluate::value::{DIVIDES_BY_ZERO, NEGATIVE_ROOT, Obstacle};
use crate::join::chain::{ChainSide, Relation};
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::equals_conventions;
use crate::judge::flattened;
use crate::judge::notation;
use crate::judge::pi_in_school::with_school_pi;
use crate::judge::section::ReportSection;
use crate::judge::surroundings;
use crate::judge::unrounded::EarlierResults;
use crate::judge::verdict::{PairJudgement, evaluate_freely, judge};
use crate::reader::{Formula, FormulaStyle};
use crate::token::{Span, Token, TokenKind, any, show, trim_space};
use crate::unit::has_prefix;

/// An explanation: its name for programs, and what it makes of two sides that differ.
struct Explanation {
    name: &'static str,
    /// Whether the search ends with it once the sides agree.
    is_last_word: bool,
    /// The judgement under this explanation; none if it has nothing to say.
    judge: fn(&DifferingPair<'_>) -> Option<PairJudgement>,
}

/// An explanation that is the last word once the sides agree.
const fn explanation(name: &'static str, judge: fn(&DifferingPair<'_>) -> Option<PairJudgement>) -> Explanation {
    Explanation { name, is_last_word: true, judge }
}

/// Every explanation. The first that makes the sides agree wins; one that only brings them nearer hands its judgement on to those
/// behind it.
const EXPLANATIONS: [Explanation; 11] = [
    explanation("other-digits", try_other_digits),
    explanation("rounded-step", try_rounded_step),
    explanation("direction", try_direction),
    explanation("other-base", try_other_base),
    // With its unit, a side may still belong to the words before it, or stand for something else.
    Explanation { name: "unit-behind", is_last_word: false, judge: try_unit_behind },
    explanation("words-before", try_words_before),
    explanation("other-notation", try_other_notation),
    explanation("whole-turns", try_whole_turns),
    explanation("whole-pieces", try_whole_pieces),
    explanation("scale", try_scale),
    explanation("undefined", try_undefined),
];

/// The names of all explanations, in the order in which they are tried.
///
/// ```
/// assert_eq!(proofread::explanation_names().next(), Some("other-digits"));
/// assert!(proofread::explanation_names().any(|name| name == "unit-behind"));
/// ```
pub fn explanation_names() -> impl Iterator<Item = &'static str> {
    EXPLANATIONS.iter().map(|explanation| explanation.name)
}

/// Two neighbouring sides of a chain that differ as they are printed, with all that may explain it.
pub(crate) struct DifferingPair<'t> {
    pub text: &'t str,
    pub formula: &'t Formula,
    /// The sides of the chain before these two.
    pub before: &'t [ChainSide],
    pub left: &'t ChainSide,
    pub right: &'t ChainSide,
    pub relation: Relation,
    pub bindings: Option<&'t NameValues>,
    /// The results of the example or section so far.
    pub results: &'t EarlierResults,
    /// Whether both sides have values without those that the text gives to names.
    pub is_free: bool,
    /// Whether the right side ends the formula.
    pub ends_formula: bool,
    /// Whether the text has nothing but plain lines, so that it may come out of a page.
    pub is_plain_text: bool,
    /// How the sides compare, as far as the explanations have been tried.
    pub judgement: PairJudgement,
}

/// Whether nothing is wrong between the sides.
pub(crate) fn agrees(judgement: &PairJudgement) -> bool {
    judgement.verdict != ChainVerdict::CannotEvaluate
        && ReportSection::for_verdict(judgement.verdict, false) == ReportSection::Agreeing
}

impl DifferingPair<'_> {
    /// How the sides compare once the explanations have been tried.
    pub(crate) fn explain(mut self) -> PairJudgement {
        for explanation in &EXPLANATIONS {
            let Some(judgement) = (explanation.judge)(&self) else { continue };
            self.judgement = PairJudgement { explanation: Some(explanation.name), ..judgement };
            if explanation.is_last_word && agrees(&self.judgement) {
                break;
            }
        }
        self.judgement
    }

    fn judge(&self, left: &[Token], right: &[Token]) -> PairJudgement {
        judge(left, right, self.relation, self.bindings)
    }

    /// Whether each side is a printed number or quantity, and nothing is computed.
    fn literal_sides(&self) -> Option<[bool; 2]> {
        self.judgement.values.as_ref().map(|(left, right)| [left.is_literal(), right.is_literal()])
    }

    /// Around what the text says something about the sides: the formula, or in a plain line the two sides.
    fn place(&self) -> Span {
        let sides = self.left.span.join(self.right.span);
        match self.formula.style {
            FormulaStyle::Plain => sides,
            FormulaStyle::Formula => surroundings::part_near(self.text, self.formula.span, sides),
        }
    }

    /// The judgement at hand with another verdict.
    fn with_verdict(&self, verdict: ChainVerdict) -> Option<PairJudgement> {
        Some(PairJudgement { verdict, ..self.judgement.clone() })
    }
}

/// A judgement as doubtful, if the sides agree.
fn doubtful_if_agreeing(judgement: PairJudgement) -> Option<PairJudgement> {
    agrees(&judgement).then_some(PairJudgement { verdict: ChainVerdict::Doubtful, ..judgement })
}

/// That a side has no value is what the text shows: both sides divide by zero or take a root of a negative number, or it is called
/// undefined.
fn try_undefined(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    let Some(Obstacle::NoValue(why)) = &pair.judgement.obstacle else { return None };
    let of_right = evaluate_freely(&pair.right.tokens, pair.bindings).err();
    let alike = [DIVIDES_BY_ZERO, NEGATIVE_ROOT].contains(why);
    // Complex numbers may be meant: (1 + √−3)(1 − √−3) = 4.
    if *why == NEGATIVE_ROOT && has_root_twice(&pair.left.tokens) {
        return pair.with_verdict(ChainVerdict::Doubtful);
    }
    let shown = matches!(of_right, Some(Obstacle::NoValue(of_right)) if alike && of_right == *why);
    (shown || surroundings::calls_undefined(pair.text, pair.left.span.join(pair.right.span)))
        .then(|| pair.with_verdict(ChainVerdict::Doubtful))
        .flatten()
}

/// Whether two roots of a side are of the same negative number.
fn has_root_twice(side: &[Token]) -> bool {
    let of_negative = |token: &Token| match &token.kind {
        TokenKind::Root(of, _) => trim_space(of).first().is_some_and(|sign| sign.is_sign('-')).then(|| show(of)),
        _ => None,
    };
    let roots: Vec<String> = side.iter().filter_map(of_negative).take(MOST_ROOTS).collect();
    roots.iter().enumerate().any(|(at, one)| roots[at + 1..].contains(one))
}

/// Most roots of a side that are compared with each other.
const MOST_ROOTS: usize = 8;

/// Digits that are printed elsewhere, or that everybody knows, went into the computed side: a result before it was rounded, a
/// constant of nature, 3.14 for π.
fn try_other_digits(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    let computes =
        pair.is_free && pair.literal_sides() == Some([false, true]) && pair.judgement.verdict > ChainVerdict::Units;
    let explained = computes && pair.results.explains(pair.formula.scope, pair.left, pair.right);
    explained.then(|| pair.with_verdict(ChainVerdict::Rounded)).flatten()
}

/// A side before gives both, so that the step between was rounded: a printed one, or one that is as near to both as its last digit.
fn try_rounded_step(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    let sides = pair.literal_sides()?;
    let (left, right) = pair.judgement.values.as_ref()?;
    let is_near = left.dimension == right.dimension && left.difference(right) < NEAR_STEP;
    let is_step = sides == [true, true] || (sides == [false, true] && is_near);
    if !is_step || pair.judgement.verdict <= ChainVerdict::Units {
        return None;
    }
    // What is in base units of the SI may lack its unit.
    let agree = |one: &ChainSide, other: &ChainSide, least: ChainVerdict| {
        let verdict = pair.judge(&one.tokens, &other.tokens).verdict;
        verdict <= least || verdict == ChainVerdict::Units
    };
    let gives = |first: &ChainSide| {
        agree(first, pair.left, ChainVerdict::Rounded) && agree(first, pair.right, ChainVerdict::Consistent)
    };
    let given = pair.before.iter().rev().take(MOST_BEFORE).any(gives);
    given.then(|| pair.with_verdict(ChainVerdict::Rounded)).flatten()
}

/// How far a step with rounded numbers may be from the result of the steps before it, relative to it.
const NEAR_STEP: f64 = 0.01;

/// How many sides before two others are asked whether they give both.
const MOST_BEFORE: usize = 3;

/// The words behind a side say which way its quantity points, so that the sign may be left out.
fn try_direction(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    let named = [pair.left, pair.right].into_iter().any(|side| surroundings::names_direction(pair.text, side.span));
    named.then(|| doubtful_if_agreeing(pair.judge(&opposite_side(pair.left), &pair.right.tokens))).flatten()
}

/// A side with the opposite sign.
fn opposite_side(side: &ChainSide) -> Vec<Token> {
    let sign = |c| Token::new(TokenKind::Operator(c), side.span);
    [&[sign('-'), sign('(')], side.tokens.as_slice(), &[sign(')')]].concat()
}

/// The words behind the formula name the base in which its last number is written.
fn try_other_base(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    let base = pair.ends_formula.then(|| surroundings::named_base(pair.text, pair.formula.span)).flatten()?;
    doubtful_if_agreeing(pair.judge(&pair.left.tokens, &decimal_integer(pair.right, base)?))
}

/// The integer at a side, whose digits are in another base.
fn decimal_integer(side: &ChainSide, base: u32) -> Option<Vec<Token>> {
    let [Token { kind: TokenKind::Number(digits), span, .. }] = side.tokens.as_slice() else { return None };
    let value = u64::from_str_radix(digits, base).ok()?;
    Some(vec![Token::new(TokenKind::Number(value.to_string()), *span)])
}

/// The unit of the right side stands in the text behind the formula. Where that doesn't make the sides agree, it may bring them
/// nearer.
fn try_unit_behind(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    if !pair.ends_formula {
        return None;
    }
    let unit = surroundings::unit_behind(pair.text, pair.formula.span);
    if unit.is_empty() {
        return None;
    }
    let right = &pair.right.tokens;
    let mut with = [right.as_slice(), &unit].concat();
    // The scale of a temperature behind its degree sign.
    let scale = unit.last().and_then(Token::word).filter(|word| matches!(*word, "C" | "F"));
    if let (Some(scale), Some(last)) = (scale, right.last())
        && last.word() == Some("°")
    {
        with.truncate(right.len() - 1);
        with.push(Token::new(TokenKind::Word(format!("°{scale}")), last.span));
    }
    let other = pair.judge(&pair.left.tokens, &with);
    // The other numbers of the chain lack their unit, too.
    if agrees(&other) || other.verdict == ChainVerdict::Units {
        return Some(PairJudgement { verdict: other.verdict.min(ChainVerdict::Doubtful), ..other });
    }
    // What the formula leaves out may be in thousands of them: 2.5/100 = 25 μA, of milliamperes.
    if let Some((left, right)) = pair.judgement.values.as_ref()
        && !left.has_unit
        && unit.iter().filter_map(Token::word).any(has_prefix)
        && [-9.0, -6.0, -3.0, 3.0, 6.0, 9.0]
            .iter()
            .any(|by| left.scaled(power_of_ten(*by)).meets(right, NEAR_STEP / 2.0))
    {
        return pair.with_verdict(ChainVerdict::Units);
    }
    let nearer = other.verdict == pair.judgement.verdict && other.is_nearer(&pair.judgement);
    (nearer || other.verdict < pair.judgement.verdict).then_some(other)
}

/// The left side belongs to the words before it, as in the mass *after 90 years = …*: it is a printed count, or a printed quantity
/// of another kind than the computed right side.
fn try_words_before(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    let (left, right) = pair.judgement.values.as_ref()?;
    // 17 coins at $0.25 = $4.25
    let counts = || surroundings::counts_before(pair.text, pair.left.span);
    if pair.before.is_empty()
        && [pair.left, pair.right].into_iter().all(is_printed)
        && counts().into_iter().any(|count| left.scaled(count).meets(right, 0.0))
    {
        return pair.with_verdict(ChainVerdict::Doubtful);
    }
    let is_count = left.dimension.is_none() && left.factor == 1.0;
    let of_other_kinds = left.dimension != right.dimension || is_count;
    // A temperature or a time beside what depends on it.
    let depends = right.is_literal() && right.has_unit && left.dimension != right.dimension;
    let may_belong = left.is_literal() && left.has_unit && (!right.is_literal() || depends) && of_other_kinds;
    let belongs = pair.before.is_empty() && may_belong && surroundings::follows_preposition(pair.text, pair.left.span);
    belongs.then(|| pair.with_verdict(ChainVerdict::Doubtful)).flatten()
}

/// Whether a side is a printed number with or without its unit or the sign of a currency.
fn is_printed(side: &ChainSide) -> bool {
    let mut numbers = side.tokens.iter().filter(|token| token.number().is_some());
    let all = |token: &Token| token.is_space() || token.number().is_some() || token.word().is_some();
    numbers.next().is_some() && numbers.next().is_none() && side.tokens.iter().all(all)
}

/// The sides are written in a way that only some texts have, and in which they agree; or in which only their units differ, which
/// says less.
fn try_other_notation(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    if pair.judgement.verdict <= ChainVerdict::Units {
        return None;
    }
    // A factorial whose sign stands behind the formula, or ends it as a sentence would.
    let ends_formula = || trim_space(&pair.formula.tokens).last().is_some_and(|last| last.is_sign('!'));
    let begins_text = || surroundings::begins_with_factorial(pair.text, pair.right.span, pair.formula.span);
    if pair.ends_formula && (ends_formula() || begins_text()) {
        let sign = Token::new(TokenKind::Operator('!'), pair.right.span);
        let other = pair.judge(&pair.left.tokens, &[pair.right.tokens.as_slice(), &[sign]].concat());
        if other.verdict < ChainVerdict::Doubtful {
            return Some(PairJudgement { verdict: ChainVerdict::Doubtful, ..other });
        }
    }
    let mut in_numbers = None;
    for [left, right] in notation::other_notations(pair.text, pair.formula, pair.left, pair.right) {
        let other = pair.judge(&left, &right);
        if other.verdict < ChainVerdict::Doubtful {
            return Some(PairJudgement { verdict: ChainVerdict::Doubtful, ..other });
        }
        if other.verdict == ChainVerdict::Units {
            in_numbers = Some(other);
        }
    }
    for [left, right] in with_school_pi(&pair.left.tokens, &pair.right.tokens) {
        let other = pair.judge(&left, &right);
        if other.verdict == ChainVerdict::Consistent {
            return Some(PairJudgement { verdict: ChainVerdict::Doubtful, ..other });
        }
    }
    if pair.is_plain_text {
        let before = pair.text.get(..pair.left.span.start as usize).unwrap_or_default();
        for [left, right] in flattened::with_lost_marks(before, &pair.left.tokens, &pair.right.tokens) {
            let other = pair.judge(&left, &right);
            if other.verdict == ChainVerdict::Consistent {
                return Some(PairJudgement { verdict: ChainVerdict::Doubtful, ..other });
            }
        }
    }
    in_numbers
}

/// Both sides are angles that differ by whole turns.
fn try_whole_turns(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    let (left, right) = pair.judgement.values.as_ref()?;
    let explained = pair.judgement.verdict > ChainVerdict::Doubtful && notation::differ_by_turns(left, right);
    explained.then(|| pair.with_verdict(ChainVerdict::Doubtful)).flatten()
}

/// Words near a number that is taken up to the next whole one.
const ROUNDS_UP: [&str; 12] = [
    " turns",
    "windings",
    "rounded up",
    "round up",
    "rounding up",
    "next whole",
    "next integer",
    "next higher",
    "required sample size",
    "minimum sample size",
    "minimum number of",
    "aufgerundet",
];

/// The right side counts whole pieces, of which there have to be at least as many as the left side says: behind ≈, or where the text rounds up
/// or speaks of turns.
fn try_whole_pieces(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    let (left, right) = pair.judgement.values.as_ref()?;
    // Decimals count no pieces.
    let is_decimal = |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if digits.contains('.'));
    let explained = pair.judgement.verdict > ChainVerdict::Doubtful
        && !any(&pair.right.tokens, &is_decimal)
        && notation::counts_up(left, right)
        && (pair.relation == Relation::Approximate || surroundings::speaks_around(pair.text, pair.place(), &ROUNDS_UP));
    explained.then(|| pair.with_verdict(ChainVerdict::Doubtful)).flatten()
}

/// The text speaks of a drawing or a map, on which one quantity stands for another.
fn try_scale(pair: &DifferingPair<'_>) -> Option<PairJudgement> {
    let (left, right) = pair.judgement.values.as_ref()?;
    let is_literal = left.is_literal() && right.is_literal() && left.has_unit;
    let explained = is_literal
        && equals_conventions::may_be_to_scale(left, right)
        && surroundings::speaks_of_scale(pair.text, pair.place());
    explained.then(|| pair.with_verdict(ChainVerdict::Doubtful)).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::join::chain::split_chains;
    use crate::reader::{TextFormat, read};

    /// The explanations that have something to say of the last two sides in a text, each asked alone, and how the sides compare
    /// in the end.
    fn explained(text: &str) -> (Vec<&'static str>, PairJudgement) {
        let mut formulas = Vec::new();
        read(text, TextFormat::Markdown, &mut |formula| formulas.push(formula)).expect("a text");
        let mut results = EarlierResults::default();
        let mut last = None;
        for formula in &formulas {
            let chains = split_chains(&formula.tokens);
            for (which, chain) in chains.iter().enumerate() {
                for at in 1..chain.sides.len() {
                    let (left, right) = (&chain.sides[at - 1], &chain.sides[at]);
                    let relation = right.relation.expect("a relation");
                    let pair = |judgement| DifferingPair {
                        text,
                        formula,
                        before: &chain.sides[..at - 1],
                        left,
                        right,
                        relation,
                        bindings: None,
                        results: &results,
                        is_free: true,
                        ends_formula: which + 1 == chains.len() && at + 1 == chain.sides.len(),
                        is_plain_text: false,
                        judgement,
                    };
                    let judgement = judge(&left.tokens, &right.tokens, relation, None);
                    let asked = pair(judgement.clone());
                    let names = EXPLANATIONS.iter().filter(|of| (of.judge)(&asked).is_some()).map(|of| of.name);
                    last = Some((names.collect(), pair(judgement.clone()).explain()));
                    if let Some(values) = judgement.values.filter(|(_, right)| right.is_literal()) {
                        results.record(formula.scope, left, right, &values);
                    }
                }
            }
        }
        last.expect("two sides")
    }

    /// Of these two sides just one explanation speaks, and it decides.
    #[track_caller]
    fn alone(name: &str, text: &str, verdict: ChainVerdict) {
        let (names, judgement) = explained(text);
        assert_eq!((names.as_slice(), judgement.explanation), ([name].as_slice(), Some(name)), "{text}");
        assert_eq!(judgement.verdict, verdict, "{text}");
    }

    /// Of these two sides two explanations speak, and the earlier one decides.
    #[track_caller]
    fn earlier(name: &str, later: &str, text: &str) {
        let (names, judgement) = explained(text);
        assert_eq!((names.as_slice(), judgement.explanation), ([name, later].as_slice(), Some(name)), "{text}");
    }

    /// Nothing explains how these two sides differ.
    #[track_caller]
    fn none(text: &str, verdict: ChainVerdict) {
        let (names, judgement) = explained(text);
        assert_eq!((names.as_slice(), judgement.explanation), ([].as_slice(), None), "{text}");
        assert_eq!(judgement.verdict, verdict, "{text}");
    }

    #[test]
    fn a_text_may_show_that_there_is_no_value() {
        alone("undefined", r"$m = \frac{7-3}{5-5} = \frac{4}{0}$", ChainVerdict::Doubtful);
        alone("undefined", r"The slope $\frac{7-3}{5-5} = 4$ is undefined.", ChainVerdict::Doubtful);
        none(r"The slope $\frac{7-3}{5-5} = 4$ is steep.", ChainVerdict::Inconsistent);
    }

    #[test]
    fn digits_that_went_in_are_an_explanation() {
        let speed = r"$v = \frac{10.00\,\text{m}}{30.00\,\text{s}} = 0.33\,\text{m/s}$";
        let work = r"$(4900\,\text{N})0.33\,\text{m/s} = 1633.33\,\text{W}$";
        alone("other-digits", &format!("{speed}, and {work}"), ChainVerdict::Rounded);
        none(work, ChainVerdict::Inconsistent);
    }

    #[test]
    fn a_step_between_may_have_been_rounded() {
        // Other digits go into a computed side and a step is a printed one, so these two never meet.
        let chain = r"$1.00 \times 1454.95\,\text{Pa} = 1450\,\text{Pa} = 1.455\,\text{kPa}$";
        alone("rounded-step", chain, ChainVerdict::Rounded);
        none(&chain.replace("1.455", "1.435"), ChainVerdict::Inconsistent);
    }

    #[test]
    fn words_may_say_the_sign() {
        alone("direction", r"$2.0\,\text{N} - 5.0\,\text{N} = 3.0\,\text{N}$ downward", ChainVerdict::Doubtful);
        none(r"$2.0\,\text{N} - 5.0\,\text{N} = 3.0\,\text{N}$ in all", ChainVerdict::Inconsistent);
        earlier("rounded-step", "direction", r"$\pm\sqrt{4.0} = -2.0 = 2.0$ downward");
    }

    #[test]
    fn words_may_name_the_base() {
        // With its digits in another base the right side is another number, so none of the explanations before it fits, too.
        alone("other-base", "$3 + 4 = 111$ in binary", ChainVerdict::Doubtful);
        none("$3 + 4 = 111$ in all", ChainVerdict::Inconsistent);
    }

    #[test]
    fn a_unit_may_stand_behind_the_formula() {
        alone("unit-behind", r"$3.0\,\text{m}/4.0 = 75$ cm", ChainVerdict::Consistent);
        none(r"$3.0\,\text{m}/4.0 = 0.85$ in all", ChainVerdict::Inconsistent);
        earlier("other-base", "unit-behind", "$3\\cdot4 \\approx 1100$ % (binary)");
    }

    #[test]
    fn a_unit_behind_the_formula_is_not_the_last_word() {
        for (later, text) in [
            ("words-before", r"After $3\,\text{photons} = 150 \cdot 2$ %"),
            ("scale", r"On the map, $0.0\,\text{cm} = 0.01$ mm"),
        ] {
            let (names, judgement) = explained(text);
            assert_eq!((names, judgement.explanation), (vec!["unit-behind", later], Some(later)), "{text}");
            assert_eq!(judgement.verdict, ChainVerdict::Doubtful, "{text}");
        }
        // It may bring the sides nearer without making them agree.
        alone("unit-behind", r"$30.0\cdot4.00 = 12100$ %", ChainVerdict::LastDigit);
    }

    #[test]
    fn a_side_may_belong_to_the_words_before_it() {
        alone("words-before", r"The mass after $90\,\text{y} = 2.5\,\text{kg}$", ChainVerdict::Doubtful);
        none(r"The age of $90\,\text{y} = 2.5\,\text{kg}$", ChainVerdict::Dimensions);
        earlier("words-before", "other-notation", r"After $3\,\text{photons} = 1-1/2 + 1-1/2$");
    }

    #[test]
    fn a_text_may_write_in_its_own_way() {
        alone("other-notation", "$1-1/2 + 2-3/4 = 4.25$", ChainVerdict::Doubtful);
        // A result that is written with its period may be truncated.
        alone("other-notation", "$1/6 = 0.1(6)$", ChainVerdict::Doubtful);
        alone("other-notation", r"$12 \cdot 11! = 12!$", ChainVerdict::Doubtful);
        none(r"$12 \cdot 11! = 13!$", ChainVerdict::Inconsistent);
        alone("other-notation", r"$1-1/2 \cdot 2.0\,\text{m} = 3.0\,\text{m/s}$", ChainVerdict::Units);
        none("$1-1/2 + 2-3/4 = 5.25$", ChainVerdict::Inconsistent);
        earlier("other-notation", "whole-turns", r"$$360^\circ \\ + 5^\circ = 5^\circ$$");
    }

    #[test]
    fn angles_may_differ_by_whole_turns() {
        alone("whole-turns", r"$90^\circ + 280^\circ = 10^\circ$", ChainVerdict::Doubtful);
        none(r"$90^\circ + 280^\circ = 20^\circ$", ChainVerdict::Inconsistent);
        earlier("direction", "whole-turns", r"$180^\circ = -180^\circ$ clockwise");
    }

    #[test]
    fn whole_pieces_are_counted_up() {
        alone("whole-pieces", r"$6.20/2.00 \approx 4$", ChainVerdict::Doubtful);
        none("$6.20/2.00 = 4$", ChainVerdict::Inconsistent);
        earlier("other-notation", "whole-pieces", r"$$-0.9 \\ + 5.0 \approx 5$$");
    }

    #[test]
    fn a_drawing_has_a_scale() {
        alone("scale", r"On that map, $3.000\,\text{cm} = 50\,\text{N}$", ChainVerdict::Doubtful);
        none(r"On that day, $3.000\,\text{cm} = 50\,\text{N}$", ChainVerdict::Dimensions);
        earlier("words-before", "scale", r"On that map, after $3.0\,\text{min} = 50\,\text{m}$");
    }

    #[test]
    fn every_explanation_is_documented() {
        let names: Vec<&str> = explanation_names().collect();
        let quoted: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
        let schema = include_str!("../../schema/proofread.schema.json");
        assert!(
            schema.contains(&format!("\"enum\": [{}, null]", quoted.join(", "))),
            "{names:?} are not in the schema"
        );
        let readme = include_str!("../../README.md");
        let missing = names.iter().find(|name| !readme.contains(&format!("| `{name}` |")));
        assert_eq!(missing, None, "not in the README");
    }
}
