//! Calculations that run on behind each result: `95 − 64 = 31 − 16 = 15`, where each step adds to the number before it.

use crate::decimal::parse_decimal;
use crate::evaluate::value::SideValue;
use crate::join::chain::{Chain, ChainSide};
use crate::judge::verdict::PairJudgement;

/// Whether the right side of a pair begins with the result of the left one, goes on from it, and has a side behind it.
pub(crate) fn runs_on(chain: &Chain, right: &ChainSide, judgement: &PairJudgement) -> bool {
    let Some((left, value)) = &judgement.values else { return false };
    let is_last = chain.sides.last().is_some_and(|last| std::ptr::eq(last, right));
    let mut tokens = right.tokens.iter().filter(|token| !token.is_space());
    let first =
        tokens.next().and_then(|token| token.number()).and_then(|digits| parse_decimal(&digits.replace(',', "")));
    let goes_on = tokens.next().is_some_and(|sign| sign.is_one_of("+-"));
    let is_bare = |of: &SideValue| !of.has_unit && of.angle.is_none();
    let result = left.number().ok().map(|of| of.point);
    let is_result =
        first.zip(result).is_some_and(|(first, result)| (first - result).abs() < 1e-9 * first.abs().max(1.0));
    !is_last && goes_on && is_result && is_bare(left) && is_bare(value) && !left.is_literal()
}
