//! Shifts of bits, whose sign is also that of an order of magnitude: `14 << 3 + 3 = 115`.

use crate::join::chain::{Chain, ChainSide, Relation};
use crate::judge::substitution::without_space;
use crate::judge::verdict::is_agreed;
use crate::token::{Token, TokenKind};

/// Most bits by which a number is shifted.
const MOST: f64 = 63.0;

/// Whether the sign before the left side shifts the number before it, and the right side is the result: the sum behind the sign is added to the
/// shifted number, or is the number of bits.
pub(crate) fn is_shifted(text: &str, chain: &Chain, left: &ChainSide, right: &ChainSide) -> bool {
    if left.relation != Some(Relation::Other) {
        return false;
    }
    let Some(at) = chain.sides.iter().position(|side| side.span == left.span) else { return false };
    let Some(before) = chain.sides[..at].iter().rev().find(|side| !side.tokens.is_empty()) else { return false };
    let sign = text.get(before.span.end as usize..left.span.start as usize).unwrap_or_default();
    let factor = match sign.trim_matches([' ', '$', '~', '{', '}']) {
        "\\ll" | "<<" | "≪" | "&lt;&lt;" => 2.0,
        "\\gg" | ">>" | "≫" | "&gt;&gt;" => 0.5,
        _ => return false,
    };
    let whole = |token: &Token| token.number().and_then(|digits| digits.parse::<u32>().ok()).map(f64::from);
    let operand = match without_space(&before.tokens).as_slice() {
        [number] => whole(number),
        _ => None,
    };
    let Some(operand) = operand else { return false };
    let shifted = |bits: f64| libm::floor(operand * libm::pow(factor, bits));
    let as_number = |value: f64| Token::new(TokenKind::Number(format!("{value}")), left.span);
    let Some((first, rest)) = left.tokens.split_first() else { return false };
    let Some(bits) = whole(first).filter(|bits| *bits <= MOST) else { return false };
    let added = [&[as_number(shifted(bits))], rest].concat();
    is_agreed(&added, &right.tokens, Relation::Equal)
}
