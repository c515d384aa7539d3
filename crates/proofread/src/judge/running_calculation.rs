//! Calculations that run on behind each result: `95 − 64 = 31 − 16 = 15`, where each step goes on from the number before it.

use crate::evaluate::value::SideValue;
use crate::join::chain::{Chain, ChainSide};
use crate::judge::verdict::{PairJudgement, evaluate_freely};
use crate::token::{Token, TokenKind, trim_space};

/// Whether the right side of a pair begins with the result of the sides before it, goes on from it, and has a side behind it.
pub(crate) fn runs_on(chain: &Chain, right: &ChainSide, judgement: &PairJudgement) -> bool {
    let Some((left, _)) = &judgement.values else { return false };
    let at = chain.sides.iter().position(|side| std::ptr::eq(side, right));
    // What stands alone at the start is no result of a calculation.
    let is_between = at.is_some_and(|at| at + 1 < chain.sides.len() && (at > 1 || !left.is_literal()));
    let begins = |value: SideValue| value.is_literal() && value.dimension == left.dimension && value.meets(left, 0.0);
    is_between && start(&right.tokens).and_then(|start| evaluate_freely(start, None).ok()).is_some_and(begins)
}

/// What stands before the first operation of a side, or above the stroke if the side is a fraction; none if nothing is computed.
fn start(side: &[Token]) -> Option<&[Token]> {
    match trim_space(side) {
        [Token { kind: TokenKind::Fraction(above, _), .. }] => Some(above),
        side => side.iter().position(|token| token.is_one_of("+-×·/")).filter(|at| *at > 0).map(|at| &side[..at]),
    }
}
