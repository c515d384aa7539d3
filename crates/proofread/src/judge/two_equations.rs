//! Two equations in one row that only a sign or a gap parts.

use crate::join::chain::Relation;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::verdict::judge;
use crate::token::{Token, TokenKind};
use crate::unit::unit;

/// The number with which a side begins, with its power of ten and unit, and what stands behind the sign that follows.
fn parts(side: &[Token]) -> Option<(&[Token], &[Token])> {
    let first = side.iter().position(|token| !token.is_space() && !token.is_sign('-'))?;
    side[first].number()?;
    let is_unit = |token: Option<&Token>| token.and_then(Token::word).is_some_and(|word| unit(word).is_some());
    for (at, token) in side.iter().enumerate().skip(first + 1) {
        let next = side[at + 1..].iter().find(|token| !token.is_space());
        let goes_on = match &token.kind {
            TokenKind::Operator('×' | '·') => next.and_then(Token::number) == Some("10") || is_unit(next),
            TokenKind::Operator('/') => is_unit(next),
            TokenKind::Number(digits) => digits == "10",
            TokenKind::Word(_) | TokenKind::Power(_) | TokenKind::Space(_) => true,
            _ => false,
        };
        if !goes_on {
            return token.is_one_of("-/·").then(|| (&side[..at], &side[at + 1..]));
        }
    }
    None
}

/// Whether a printed quantity is followed by the name of the next one, both in words that were taken for one unit: `r = 0.3 m F = 2500 N`.
pub(crate) fn ends_with_name(text: &str, side: &[Token]) -> bool {
    let [number, .., last] = side else { return false };
    let units = side.iter().filter(|token| token.word().is_some()).count();
    let is_letter = last.word().is_some_and(|word| word.chars().count() == 1 && word.chars().all(char::is_alphabetic));
    let apart = text.get(..last.span.start as usize).is_some_and(|before| before.ends_with([' ', '\t']));
    let is_quantity = side.iter().all(|token| token.is_space() || token.number().is_some() || token.word().is_some());
    number.number().is_some() && is_letter && apart && units > 1 && is_quantity
}

/// The least width of a space, in tenths of an em, that may part two equations.
const GAP: u8 = 4;

/// Whether a space of a formula follows another one, as in `\;\;`.
fn is_doubled(side: &[Token], at: usize) -> bool {
    at > 0 && side[at].is_space() && side[at - 1].is_space()
}

/// Whether a sign or a gap parts two equations of which each holds: `3 × 4 = 12 / 3 × 5 = 15`. The side with the sign is the second of three.
pub(crate) fn are_two_equations(sides: [&[Token]; 3]) -> bool {
    let is_gap = |token: &Token| matches!(token.kind, TokenKind::Space(GAP..=8));
    // Behind a blank, a function may begin the second one: cos 60° = 0.5  sin 60° = 0.866.
    let begins = |at: usize| {
        let next = sides[1][at..].iter().find(|token| !token.is_space());
        at > 0 && sides[1][at].is_space() && next.is_some_and(|next| matches!(next.kind, TokenKind::Function(_)))
    };
    let gaps =
        (0..sides[1].len()).filter(|at| is_gap(&sides[1][*at]) || begins(*at) || is_doubled(sides[1], *at)).take(4);
    // In a row of equations the outer sides have gaps of their own.
    let last_gap = (1..sides[0].len()).rev().find(|at| is_doubled(sides[0], *at)).map_or(0, |at| at + 1);
    let first_gap = (1..sides[2].len()).find(|at| is_doubled(sides[2], *at)).map_or(sides[2].len(), |at| at - 1);
    let (first, third) = (&sides[0][last_gap..], &sides[2][..first_gap]);
    let parted = |at: usize| {
        let holds = |left: &[Token], right: &[Token]| {
            judge(left, right, Relation::Equal, None).verdict < ChainVerdict::Truncated
        };
        holds(first, &sides[1][..at]) && holds(&sides[1][at + 1..], third)
    };
    if gaps.clone().any(parted) {
        return true;
    }
    let Some((result, rest)) = parts(sides[1]) else { return false };
    let computes = |token: &Token| {
        token.is_one_of("+-×·/(√")
            || matches!(token.kind, TokenKind::Fraction(..) | TokenKind::Root(..) | TokenKind::Power(_))
    };
    let holds =
        |left: &[Token], right: &[Token]| judge(left, right, Relation::Equal, None).verdict < ChainVerdict::Truncated;
    // Two numbers alone are no equation.
    if !rest.iter().chain(sides[2]).any(computes) {
        return false;
    }
    // The sign may be the first of the second equation: 5 · 3 = 15   −5 · 3 = −15.
    let signed = &sides[1][sides[1].len() - rest.len() - 1..];
    let signed = signed.first().is_some_and(|sign| sign.is_sign('-')) && holds(signed, sides[2]);
    holds(sides[0], result) && (signed || holds(rest, sides[2]))
}
