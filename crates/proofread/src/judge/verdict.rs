//! Two neighbouring sides compared under every reading that makes a difference.

use crate::evaluate::expression::{Evaluator, NameValues};
use crate::evaluate::interval::{Interval, SLACK};
use crate::evaluate::numeral::with_shared_exact;
use crate::evaluate::printed::Mode;
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::step_rounding::{StepRounding, significant_digits};
use crate::evaluate::value::{Evaluated, Obstacle, SideValue};
use crate::join::chain::Relation;
use crate::join::token_joining::has_letters;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::equals_conventions;
use crate::judge::lost_digits::{
    FEWER_DIGITS, FROM_TENS, LIKELY, LIKELY_OF_BARE, StepLikelihood, are_near, has_three_digits, has_words_of,
    is_as_coarse, is_cut, is_exact, is_near, is_plain_sum, is_round, is_within, may_have_rounded_terms, most_digits,
    most_digits_of_any, relative_width,
};
use crate::judge::money::has_money;
use crate::order::sort_few_without_repeats;
use crate::token::{Token, TokenKind, any};
use crate::unit::{currency, is_percent};
use std::f64::consts::PI;

/// A verdict, and the values behind it.
#[derive(Clone, Debug)]
pub(crate) struct PairJudgement {
    pub verdict: ChainVerdict,
    /// The reading under which it is so.
    pub reading: ReadingChoices,
    /// Both sides as their digits are printed.
    pub values: Option<(SideValue, SideValue)>,
    pub obstacle: Option<Obstacle>,
    pub used: Vec<String>,
    /// The name of the explanation under which it is so, if one was needed.
    pub explanation: Option<&'static str>,
    /// Whether other digits of the terms of a small difference would make the sides agree.
    pub is_ill_conditioned: bool,
}

impl PairJudgement {
    /// Whether its sides are nearer to each other than those of another reading.
    pub(crate) fn is_nearer(&self, other: &Self) -> bool {
        // A sign is lost more easily than digits.
        let apart = |of: &Self| {
            of.values.as_ref().map_or(f64::INFINITY, |(left, right)| {
                left.difference(right).min(LOST_SIGN + left.clone().negate().difference(right))
            })
        };
        apart(self) < 0.999 * apart(other)
    }
}

/// How far two sides are apart that differ in their sign alone.
const LOST_SIGN: f64 = 0.5;

/// Most choices that are made at once.
const MOST_CHOICES: u32 = 4;

/// Compares two sides.
pub(crate) fn judge(
    left: &[Token],
    right: &[Token],
    relation: Relation,
    bindings: Option<&NameValues>,
) -> PairJudgement {
    ComparedSides::new([left, right], relation, bindings).judge()
}

/// Whether two sides without names agree to the printed digits, as [`judge`] would find. It is quicker: of sides that don't, it does
/// not find out how they differ.
pub(crate) fn is_agreed(left: &[Token], right: &[Token], relation: Relation) -> bool {
    let pair = ComparedSides { only_agreement: true, ..ComparedSides::new([left, right], relation, None) };
    pair.judge().verdict == ChainVerdict::Consistent
}
/// Whether a side can be evaluated under some reading, and whether it is a printed number.
pub(crate) fn evaluate_freely(side: &[Token], bindings: Option<&NameValues>) -> Evaluated<SideValue> {
    let mut first = None;
    for reading in [
        ReadingChoices::USUAL,
        ReadingChoices::DEGREES,
        ReadingChoices::ONE_BELOW,
        ReadingChoices::POUNDS,
        ReadingChoices::NUMBERS,
    ] {
        match Evaluator::new(Mode::Point, reading, bindings).evaluate_side(side) {
            Ok(value) => return Ok(value),
            // Other readings change neither letters nor words.
            Err(why @ (Obstacle::Letter(_) | Obstacle::Word(_) | Obstacle::NoNumber | Obstacle::TooLarge)) => {
                return Err(first.unwrap_or(why));
            }
            Err(why) => first = first.or(Some(why)),
        }
    }
    Err(first.unwrap_or(Obstacle::NoNumber))
}

struct ComparedSides<'t> {
    sides: [&'t [Token]; 2],
    relation: Relation,
    bindings: Option<&'t NameValues>,
    noticed: ReadingChoices,
    inverse: bool,
    /// Whether a difference of open numbers lost most of their digits.
    cancels: bool,
    /// Whether their terms are more than printed integers.
    cancels_decimals: bool,
    /// Both sides with the numbers exact that both of them print.
    alike: Option<[Vec<Token>; 2]>,
    /// Whether nothing but their agreement is asked for.
    only_agreement: bool,
}

impl<'t> ComparedSides<'t> {
    fn new(sides: [&'t [Token]; 2], relation: Relation, bindings: Option<&'t NameValues>) -> Self {
        Self {
            sides,
            relation,
            bindings,
            noticed: ReadingChoices::USUAL,
            inverse: false,
            cancels: false,
            cancels_decimals: false,
            alike: None,
            only_agreement: false,
        }
    }

    /// The best judgement over all readings.
    fn judge(mut self) -> PairJudgement {
        let mut best: Option<PairJudgement> = None;
        let mut obstacle = None;
        let mut without_value = true;
        let mut tried: Vec<ReadingChoices> = Vec::new();
        loop {
            let mut open = self.noticed;
            // Revolutions beside radians are angles.
            if open.contains(ReadingChoices::TURNS) && open.contains(ReadingChoices::DOSE) {
                open = ReadingChoices::USUAL.union(self.without_choice(open, ReadingChoices::TURNS));
            }
            let next = open.subsets(MOST_CHOICES).into_iter().find(|reading| !tried.contains(reading));
            let Some(reading) = next else { break };
            tried.push(reading);
            for numbers in [ReadingChoices::USUAL, ReadingChoices::NUMBERS] {
                match self.compare(reading.union(numbers)) {
                    Ok(Some(found)) => {
                        let better = |best: &PairJudgement| {
                            found.verdict < best.verdict || (found.verdict == best.verdict && found.is_nearer(best))
                        };
                        if best.as_ref().is_none_or(better) {
                            best = Some(found);
                        }
                    }
                    Ok(None) => {}
                    Err(why) => {
                        without_value &= matches!(why, Obstacle::NoValue(_));
                        obstacle = obstacle.or(Some(why));
                    }
                }
                if best.as_ref().is_some_and(|best| best.verdict == ChainVerdict::Consistent) {
                    break;
                }
            }
            if best.as_ref().is_some_and(|best| best.verdict == ChainVerdict::Consistent) || tried.len() > 64 {
                break;
            }
        }
        // Without any unit, there is none that could differ.
        if let Some(best) = &mut best
            && let Some((left, right)) = &best.values
            && best.verdict == ChainVerdict::Units
            && [left, right].into_iter().all(|side| !side.has_unit && side.angle.is_none() && !side.parts.is_vector())
            && are_near(left, right)
            && !self.inverse
        {
            best.verdict = ChainVerdict::Inconsistent;
        }
        if let Some(best) = &mut best
            && let Some(values) = &best.values
            && best.verdict > ChainVerdict::Units
            && equals_conventions::may_stand_for_each_other(self.sides[0], self.sides[1], values)
        {
            best.verdict = ChainVerdict::Doubtful;
        }
        best.unwrap_or_else(|| {
            let verdict = match obstacle {
                // A name whose value is zero, or has lost its unit, says nothing of the dimensions.
                Some(Obstacle::MixedSum) if self.bindings.is_none() || !self.sides.into_iter().any(has_letters) => {
                    ChainVerdict::Dimensions
                }
                Some(Obstacle::NoValue(_)) if without_value => ChainVerdict::Inconsistent,
                _ => ChainVerdict::CannotEvaluate,
            };
            PairJudgement {
                verdict,
                reading: ReadingChoices::USUAL,
                values: None,
                obstacle,
                used: Vec::new(),
                explanation: None,
                is_ill_conditioned: false,
            }
        })
    }

    fn without_choice(&self, set: ReadingChoices, choice: ReadingChoices) -> ReadingChoices {
        set.subsets(16).into_iter().rev().find(|of| !of.contains(choice)).unwrap_or_default()
    }

    fn value(
        &mut self,
        which: usize,
        mode: Mode,
        reading: ReadingChoices,
        used: &mut Vec<String>,
    ) -> Evaluated<SideValue> {
        let mut evaluator = Evaluator::new(mode, reading, self.bindings);
        let side = self.alike.as_ref().filter(|_| mode != Mode::Point).map_or(self.sides[which], |sides| &sides[which]);
        let value = evaluator.evaluate_side(side);
        self.noticed.insert(evaluator.noticed);
        self.inverse |= evaluator.inverse;
        self.cancels |= mode == Mode::Strict && evaluator.steps.cancels;
        self.cancels_decimals |= mode == Mode::Strict && evaluator.steps.cancels_decimals;
        used.append(&mut evaluator.used);
        value
    }

    fn evaluate_both(
        &mut self,
        inside: Mode,
        literal: [bool; 2],
        reading: ReadingChoices,
    ) -> Evaluated<[SideValue; 2]> {
        let mode = |literal: bool| if literal { Mode::Result } else { inside };
        let unused = &mut Vec::new();
        let left = self.value(0, mode(literal[0]), reading, unused)?;
        let right = self.value(1, mode(literal[1]), reading, unused)?;
        Ok([left, right])
    }

    /// The verdict under one reading, or none if the sides cannot be compared under it.
    fn compare(&mut self, reading: ReadingChoices) -> Evaluated<Option<PairJudgement>> {
        let mut used = Vec::new();
        let left = self.value(0, Mode::Point, reading, &mut used);
        let right = self.value(1, Mode::Point, reading, &mut used);
        let mut points = [left?, right?];
        if points[0].is_tuple != points[1].is_tuple {
            return Err(Obstacle::Unclear("a list beside a number"));
        }
        sort_few_without_repeats(&mut used);
        let literal = [points[0].is_literal(), points[1].is_literal()];
        let numbers = reading.contains(ReadingChoices::NUMBERS);
        let printed = points.clone();
        let judgement = |verdict: ChainVerdict| {
            let [left, right] = printed.clone();
            Some(PairJudgement {
                verdict,
                reading,
                values: Some((left, right)),
                obstacle: None,
                used: used.clone(),
                explanation: None,
                is_ill_conditioned: false,
            })
        };
        let same = points[0].dimension == points[1].dimension;
        let zero = points.iter().any(SideValue::is_zero_at_point);
        let lacks_unit = SideValue::is_one_a_quantity(&points);
        let both_units = points.iter().all(|point| point.has_unit);
        // Neither would be more than numbers that agree without their units.
        if self.only_agreement && if numbers { both_units } else { !same && !zero } {
            return Ok(None);
        }
        if !same && !numbers && !zero {
            // A factor without its unit leaves the number in base units of the SI.
            let [left, right] = self.evaluate_both(Mode::Strict, literal, reading)?;
            let computed = self.sides[usize::from(literal[0])];
            let agree = match literal {
                [false, true] if is_plain_sum(computed) || lacks_unit => points[0].meets(&right, 0.0),
                [true, false] if is_plain_sum(computed) || lacks_unit => left.meets(&points[1], 0.0),
                _ => left.meets(&right, 0.0),
            };
            let agree = agree
                || equals_conventions::agree_with_omitted_unit(self.sides, &left, &right)
                || equals_conventions::agree_as_weight(&left, &right);
            return Ok(agree.then(|| judgement(ChainVerdict::Units)).flatten());
        }
        if numbers && !points.iter().any(|point| point.has_unit) {
            return Ok(None);
        }
        if literal == [false, false] {
            self.alike = with_shared_exact(self.sides);
        }
        let fewer = |one: &SideValue, other: &SideValue| {
            one.parts.pairs(&other.parts).all(|(a, b)| a.half_width() < b.half_width())
        };
        // Whether the sides agree, a computed one decides by its point.
        let unused = &mut Vec::new();
        let mut strict = match literal {
            [false, true] => [points[0].clone(), self.value(1, Mode::Result, reading, unused)?],
            [true, false] => [self.value(0, Mode::Result, reading, unused)?, points[1].clone()],
            [false, false] => points.clone(),
            [true, true] => self.evaluate_both(Mode::Strict, literal, reading)?,
        };
        // A quantity that is converted isn't rounded to tens before.
        let mut converted = None;
        if literal == [true, true] && both_units {
            let exact = self.value(0, Mode::Strict, reading, unused)?;
            if fewer(&exact, &strict[0]) {
                strict[0] = exact.clone();
                converted = Some(exact);
            }
        }
        // Without a unit on one side, the numbers are compared as if neither had one.
        let drops_unit = numbers && lacks_unit;
        let is_minus = self.noticed.contains(ReadingChoices::MINUS);
        let without_sign = |value: &mut SideValue| {
            if drops_unit {
                value.drop_unit();
            }
            if is_minus {
                value.parts = value.parts.map(|part| Interval::with_half_width(part.point.abs(), part.half_width()));
            }
        };
        points.iter_mut().chain(&mut strict).for_each(without_sign);
        let by_numbers = numbers && both_units;
        let fine = |verdict: ChainVerdict| judgement(if by_numbers { ChainVerdict::Units } else { verdict });
        // A function of an angle or a ratio is mostly of something measured.
        let is_function = |kind: &TokenKind| matches!(kind, TokenKind::Function(_));
        let is_of_functions = self.sides.iter().any(|side| any(side, &is_function));
        let bare = (points.iter().all(|point| !point.has_unit && point.angle.is_none()) || self.is_all_money())
            && !is_of_functions;
        if bare && self.relation == Relation::Equal && self.is_of_whole_numbers(&points, literal) {
            let printed = usize::from(literal[1]);
            let near = is_near(&points[1 - printed], &strict[printed]) && has_three_digits(&strict[printed]);
            let same = points[0].number()?.point - points[1].number()?.point;
            let verdict = match same.abs() < 0.5 {
                true => ChainVerdict::Consistent,
                false if near => ChainVerdict::LastDigit,
                false => ChainVerdict::Inconsistent,
            };
            return Ok(judgement(verdict));
        }
        if bare
            && self.relation == Relation::Equal
            && let Some(computed) = self.fraction_beside_zero(&points, literal)
        {
            let is_sum = any(self.sides[computed], &|kind| matches!(kind, TokenKind::Operator('+' | '-')));
            return Ok(judgement(if is_sum { ChainVerdict::Inconsistent } else { ChainVerdict::Truncated }));
        }
        let [left, right] = &strict;
        // What is converted has no more digits than it had before.
        let are_quantities = points.iter().all(|point| point.has_unit || point.angle.is_some());
        let is_finer =
            literal == [true, true] && are_quantities && relative_width(right) < FEWER_DIGITS * relative_width(left);
        // In the same unit, it may be said more exactly.
        let gains_digits = is_finer && points[0].factor != points[1].factor;
        let agrees = match literal {
            [true, true] => points[0].meets(right, 0.0) || (!is_finer && left.meets(&points[1], 0.0)),
            [false, true] => points[0].meets(right, 0.0),
            [true, false] => left.meets(&points[1], 0.0),
            [false, false] => points[0].difference(&points[1]) < SLACK,
        };
        if agrees {
            return Ok(fine(ChainVerdict::Consistent));
        }
        if self.only_agreement {
            return Ok(None);
        }
        let mut lenient = self.evaluate_both(Mode::Lenient, literal, reading);
        if literal != [true, true] {
            strict = self.evaluate_both(Mode::Strict, literal, reading)?;
            strict.iter_mut().for_each(without_sign);
        }
        if let (Some(exact), Ok(lenient)) = (converted, &mut lenient) {
            lenient[0] = exact;
        }
        let mut lenient = lenient.unwrap_or_else(|_| strict.clone());
        lenient.iter_mut().for_each(without_sign);
        let [left, right] = &strict;
        if equals_conventions::lacks_degrees(left, right)
            || equals_conventions::counts_electrons(self.sides, left, right)
        {
            return Ok(judgement(ChainVerdict::Doubtful));
        }
        if (!numbers && equals_conventions::agree_with_omitted_unit(self.sides, left, right))
            || equals_conventions::lacks_direction(left, right)
        {
            return Ok(judgement(ChainVerdict::Units));
        }
        for (which, turned) in
            [(0, [left.scaled(PI / 180.0), right.clone()]), (1, [left.clone(), right.scaled(PI / 180.0)])]
        {
            let turns = self.inverse && equals_conventions::turns_into_degrees(self.sides[which]);
            if turns
                && (turned[0].meets(&turned[1], 0.0)
                    || equals_conventions::angles(&turned, &points, ReadingChoices::USUAL).is_some())
            {
                return Ok(judgement(ChainVerdict::Doubtful));
            }
        }
        let loose = equals_conventions::unit_looseness(self.sides[0], self.sides[1]);
        let loosely = loose > 0.0 && (points[0].meets(right, loose) || left.meets(&points[1], loose));
        if loosely || equals_conventions::agree_with_rounded_charge(self.sides, left, right) {
            return Ok(fine(ChainVerdict::Rounded));
        }
        if equals_conventions::is_continued(left, right) {
            return Ok(judgement(ChainVerdict::Doubtful));
        }
        if self.inverse
            && let Some(verdict) = equals_conventions::angles(&strict, &points, reading)
        {
            return Ok(if verdict == ChainVerdict::Units { judgement(verdict) } else { fine(verdict) });
        }
        let computed = self.sides[usize::from(literal[0])];
        let of_one_unit = !numbers || has_words_of(self.sides[0], self.sides[1]);
        let exact_steps = of_one_unit && literal[0] != literal[1] && is_plain_sum(computed);
        // A side that shows the next step has the digits that the one before it gives.
        let steps = literal[0] != literal[1] || (literal == [false, false] && points[0].meets(right, 0.0));
        // A small difference of open numbers explains anything: the source's own digits decide.
        let meets = left.meets(right, 0.0) && !exact_steps && steps;
        let [operands, result] = self.digits_of_operands_and_result(literal);
        // They are whole, or have so few digits beside the result that they must be meant as they are.
        let has_exact_operands =
            (result > 0 && (operands == 0 || result >= operands + 2)) || self.has_long_result(literal);
        // A share in per cent is a bare number, too, though its zero is a rounded one.
        let bare = bare || (!is_of_functions && self.is_all_share());
        // A bare number is given as it is, or it has the digits of the others and one more was dropped.
        let likelihood = match literal[0] == literal[1] || !bare {
            true => StepLikelihood { share: LIKELY, of_one_digit: Some(f64::INFINITY) },
            false if operands < result => FROM_TENS,
            false => StepLikelihood { share: LIKELY, of_one_digit: Some(LIKELY_OF_BARE) },
        };
        let is_bare_result = bare && literal[0] != literal[1];
        let explained =
            meets && !(is_bare_result && has_exact_operands) && likelihood.explains(&strict, &points, literal);
        let close = literal[0] != literal[1] && is_within(&points, &strict[usize::from(literal[1])], 3.0001);
        let ill = explained && self.cancels && literal[0] != literal[1] && !close;
        if explained && !ill {
            return Ok(fine(ChainVerdict::Rounded));
        }
        let near = (literal[1] && is_near(&lenient[0], right)) || (literal[0] && is_near(&lenient[1], left));
        // Three digits behind ≈ are meant to be right.
        let exact = if literal[1] { is_exact(right) } else { literal[0] && is_exact(left) && !is_round(self.sides[1]) };
        let strictly = (literal[1] && is_near(left, right)) || (literal[0] && is_near(right, left));
        // A printed number before them that has no fewer digits is no estimate.
        let is_estimate = literal[0] && relative_width(left) > 1.0001 * relative_width(right);
        let by_digits = literal[1] && has_three_digits(right) && !is_estimate;
        let rough = if by_digits {
            let lost = close && left.meets(right, 0.0) && !(is_bare_result && has_exact_operands);
            lost || (self.relation == Relation::Approximate && self.agrees_with_rounded_steps(reading, right))
        } else {
            !exact || strictly
        };
        // A one with decimals is no rough one.
        let has_point = any(self.sides[1], &|kind| matches!(kind, TokenKind::Number(digits) if digits.contains('.')));
        let one = literal[1] && !has_point && points[1].number().is_ok_and(|of| of.point == 1.0);
        let rounds_to_one = one && points[0].number().is_ok_and(|of| (0.5..1.5).contains(&of.point));
        if self.relation == Relation::Approximate && rounds_to_one {
            return Ok(fine(ChainVerdict::Approximate));
        }
        if self.relation == Relation::Approximate && equals_conventions::is_order_of_magnitude(self.sides, &points) {
            return Ok(fine(ChainVerdict::Approximate));
        }
        if self.relation == Relation::Approximate && rough && lenient[0].meets(&lenient[1], 0.05) {
            return Ok(fine(ChainVerdict::Approximate));
        }
        let cut = match literal {
            [false, true] => is_cut(&points[0], right),
            [true, false] => is_cut(&points[1], left),
            [true, true] => {
                (fewer(left, right) && is_cut(&points[0], right))
                    || (!gains_digits && fewer(right, left) && is_cut(&points[1], left))
            }
            [false, false] => false,
        };
        if cut {
            return Ok(fine(ChainVerdict::Truncated));
        }
        if lenient[0].meets(&lenient[1], 0.0)
            && !ill
            && !gains_digits
            && FROM_TENS.explains(&lenient, &points, literal)
            && is_as_coarse(&lenient, literal)
        {
            return Ok(judgement(if by_numbers { ChainVerdict::Units } else { ChainVerdict::Doubtful }));
        }
        if by_numbers {
            return Ok(judgement(ChainVerdict::Dimensions));
        }
        // What the steps would allow, but not likely, is more than a digit; and of one or two digits, the last one is a large part.
        let near = near && (exact_steps || !left.meets(right, 0.0)) && (strictly || is_as_coarse(&lenient, literal));
        let near = near && !gains_digits && has_three_digits(&strict[usize::from(literal[1])]);
        if near && literal == [false, true] && may_have_rounded_terms(self.sides[0], &points[0], right) {
            return Ok(fine(ChainVerdict::Rounded));
        }
        let found = judgement(if near { ChainVerdict::LastDigit } else { ChainVerdict::Inconsistent });
        let is_ill_conditioned = ill && self.cancels_decimals;
        Ok(found.map(|found| PairJudgement { is_ill_conditioned, ..found }))
    }

    /// Whether both sides have a currency and no other unit.
    fn is_all_money(&self) -> bool {
        let is_other = |kind: &TokenKind| matches!(kind, TokenKind::Word(word) if currency(word).is_none());
        self.sides.iter().all(|side| has_money(side) && !any(side, &is_other))
    }

    /// Whether a side is in per cent and neither has any unit.
    fn is_all_share(&self) -> bool {
        let is_share = |kind: &TokenKind| matches!(kind, TokenKind::Word(word) if is_percent(word));
        let is_other = |kind: &TokenKind| matches!(kind, TokenKind::Word(word) if !is_percent(word));
        self.sides.iter().any(|side| any(side, &is_share)) && !self.sides.iter().any(|side| any(side, &is_other))
    }

    /// The most digits of a decimal number that goes into a result, and of the printed one.
    fn digits_of_operands_and_result(&self, literal: [bool; 2]) -> [usize; 2] {
        literal.map(|of| most_digits(self.sides[usize::from(of)]))
    }

    /// Whether a whole result shows so many digits more than any number that goes into it that these must be meant as they are:
    /// `294/0.0001 = 2940000`.
    fn has_long_result(&self, literal: [bool; 2]) -> bool {
        let [operands, result] = literal.map(|of| most_digits_of_any(self.sides[usize::from(of)]));
        literal[0] != literal[1] && most_digits(self.sides[usize::from(literal[1])]) == 0 && result >= operands + LONGER
    }

    /// Whether bare numbers give a whole one that is small enough to be printed in full, or is printed to its last digit: then the printed
    /// one must be it, with all its zeros.
    fn is_of_whole_numbers(&self, points: &[SideValue; 2], literal: [bool; 2]) -> bool {
        let [Ok(left), Ok(right)] = [&points[0], &points[1]].map(SideValue::number) else { return false };
        let is_whole = |of: f64| (of - libm::round(of)).abs() < 1e-9 && (of == 0.0 || (0.5..EXACT).contains(&of.abs()));
        let decimal = |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if digits.contains('.'));
        let has_decimals = self.sides.iter().any(|side| any(side, &decimal));
        // Decimals times a power of ten are rounded, whole as they may be.
        let printed_side = self.sides[usize::from(literal[1])];
        if any(printed_side, &decimal) && any(printed_side, &|kind| matches!(kind, TokenKind::Power(_))) {
            return false;
        }
        let [computed, printed] = if literal[1] { [left.point, right.point] } else { [right.point, left.point] };
        let in_full = computed.abs() < FULL && (printed != 0.0 || !has_decimals);
        let to_its_end = !has_decimals && printed % 10.0 != 0.0;
        (literal[0] || literal[1]) && is_whole(left.point) && is_whole(right.point) && (in_full || to_its_end)
    }

    /// The side that whole numbers give, if it is no whole number and the other one is a printed zero, which is not rounded to a unit.
    fn fraction_beside_zero(&self, points: &[SideValue; 2], literal: [bool; 2]) -> Option<usize> {
        let computed = match literal {
            [false, true] => 0,
            [true, false] => 1,
            _ => return None,
        };
        let decimal = |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if digits.contains('.'));
        let value = points[computed].number().ok()?.point;
        let is_zero = points[1 - computed].number().ok()?.point == 0.0;
        let has_decimals = self.sides.iter().any(|side| any(side, &decimal));
        (is_zero && !has_decimals && value.abs() > 1e-9).then_some(computed)
    }

    /// Whether the left side gives the printed right one if its quotients, roots, powers and functions were rounded to as many
    /// digits before they went on.
    fn agrees_with_rounded_steps(&mut self, reading: ReadingChoices, right: &SideValue) -> bool {
        let Some(digits) = right.number().ok().and_then(significant_digits) else { return false };
        let mut evaluator = Evaluator::new(Mode::Point, reading, self.bindings);
        evaluator.steps = StepRounding::to_digits(digits);
        let value = evaluator.evaluate_side(self.sides[0]);
        value.is_ok_and(|value| evaluator.steps.result(value).meets(right, 0.0))
    }
}

/// How many digits more than its operands a whole result shows if they are exact.
const LONGER: usize = 3;

/// Whole numbers below this are printed in full where they are reckoned with.
const FULL: f64 = 1e4;

/// Whole numbers below this are exact in floating point.
const EXACT: f64 = 9.0e15;
