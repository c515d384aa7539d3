//! Equals signs that lead from a number to a function of it, as people write who press one key after the other: `tan α = 4/9 = 24.0°`,
//! `0.21 = ln(0.21) = −1.56`.

use crate::evaluate::value::AngleUnit;
use crate::join::chain::{Chain, ChainSide};
use crate::judge::substitution::without_space;
use crate::judge::verdict::PairJudgement;
use crate::token::{MathFunction, Token, TokenKind};

/// How near a printed angle is to the one that the ratio gives, in radians: half a degree in the tenth is rounded once more.
const NEAR: f64 = 0.002;

/// Whether the right side is the angle whose function, which the side before the left one names, has the value of the left one.
pub(super) fn leads_to_angle(chain: &Chain, left: &ChainSide, judgement: &PairJudgement) -> bool {
    let Some((ratio, angle)) = &judgement.values else { return false };
    if angle.angle != Some(AngleUnit::Degrees) || ratio.has_unit || ratio.angle.is_some() {
        return false;
    }
    let (Ok(ratio), Ok(printed)) = (ratio.number(), angle.number()) else { return false };
    let Some(at) = chain.sides.iter().position(|side| side.span == left.span) else { return false };
    let functions =
        chain.sides[..at].iter().filter_map(|side| match side.tokens.iter().find(|token| !token.is_space()) {
            Some(Token { kind: TokenKind::Function(function), .. }) => Some(*function),
            _ => None,
        });
    { functions }.any(|function| {
        let given = match function {
            MathFunction::Sin => libm::asin(ratio.point),
            MathFunction::Cos => libm::acos(ratio.point),
            MathFunction::Tan => libm::atan(ratio.point),
            _ => return false,
        };
        (given - printed.point).abs() < NEAR
    })
}

/// Whether the right side is the logarithm of the left one, as it is printed there.
pub(super) fn leads_to_logarithm(left: &[Token], right: &[Token]) -> bool {
    let (left, right) = (without_space(left), without_space(right));
    let [number] = left.as_slice() else { return false };
    let is_logarithm = |token: &Token| {
        matches!(token.kind, TokenKind::Function(MathFunction::Ln | MathFunction::Log | MathFunction::Lg))
    };
    let inside = match right.as_slice() {
        [function, open, inside, close] if is_logarithm(function) && open.is_sign('(') && close.is_sign(')') => inside,
        [function, inside] if is_logarithm(function) => inside,
        _ => return false,
    };
    number.number().is_some() && number.number() == inside.number()
}
