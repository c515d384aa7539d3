//! What is written like numbers and is none, or belongs to one: marks of stations, bits, uncertainties.

use crate::decimal::parse_decimal;
use crate::join::chain::ChainSide;
use crate::judge::substitution::without_space;
use crate::token::{Token, TokenKind, any};
use crate::unit::is_percent;

/// Whether a side is written like a mark rather than like a sum: `28+92.45` for a place on a line, `181-57-45` for an angle.
pub(crate) fn is_mark(side: &[Token]) -> bool {
    let two = |token: &Token| {
        token.number().is_some_and(|digits| digits.split('.').next().is_some_and(|whole| whole.len() == 2))
    };
    match side {
        [place, plus, feet] => plus.is_sign('+') && integer(place).is_some() && two(feet) && touch(side),
        [degrees, one, minutes, other, seconds] => {
            let numbers = integer(degrees).is_some() && two(minutes) && two(seconds);
            one.is_sign('-') && other.is_sign('-') && numbers && touch(side)
        }
        _ => false,
    }
}

/// Whether a side has an integer with the digits 0 and 1 that is as long as those of other bases, or a byte.
pub(crate) fn has_bits(side: &[Token]) -> bool {
    let bits = |digits: &str| {
        let long = digits.len() > 4 && (digits.contains('0') || digits.len() == 8);
        long && digits.chars().all(|c| c == '0' || c == '1')
    };
    let round = |digits: &str| digits.trim_end_matches('0').len() < 2;
    side.iter().filter_map(Token::number).any(|digits| bits(digits) && !round(digits))
}

/// How far a number may be from the share that per cent are, relative to the larger one, to be meant as this share.
const NEAR: f64 = 0.3;

/// Whether a side is a number in per cent, and another number is near the share that it is: `97%` beside 0.96.
pub(crate) fn is_near_percent(side: &[Token], other: f64) -> bool {
    let solid = without_space(side);
    let [number, sign] = solid.as_slice() else { return false };
    let number = number.number().and_then(parse_decimal).filter(|_| sign.word().is_some_and(is_percent));
    number.map(|number| number / 100.0).is_some_and(|share| (share - other).abs() <= NEAR * share.max(other))
}

/// The whole number that a token prints, if it prints one.
pub(super) fn integer(token: &Token) -> Option<u32> {
    token.number().and_then(|digits| digits.parse().ok())
}

/// Whether tokens stand one behind the other without anything between them in the text.
pub(super) fn touch(tokens: &[Token]) -> bool {
    tokens.windows(2).all(|pair| pair[0].span.end == pair[1].span.start)
}

/// Whether one or two digits in brackets stand close behind decimals, whose uncertainty they are, as in 9.81(2), or an uncertainty with its
/// sign.
pub(crate) fn has_uncertainty(side: &ChainSide) -> bool {
    let percent = any(&side.tokens, &|kind| matches!(kind, TokenKind::Word(word) if word == "%"));
    (percent && has_signed_bracket(&side.tokens))
        || side.tokens.windows(4).any(|of| {
            let [decimals, open, digits, close] = of else { return false };
            let (Some(decimals), Some(digits)) = (decimals.number(), digits.number()) else { return false };
            let fine = decimals.split_once('.').is_some_and(|(_, behind)| behind.len() > 1);
            open.is_sign('(') && close.is_sign(')') && fine && digits.len() <= 2 && !digits.contains('.')
        })
}

/// Whether a bracket begins with the sign of an uncertainty anywhere in these tokens.
fn has_signed_bracket(tokens: &[Token]) -> bool {
    without_space(tokens).windows(2).any(|of| of[0].is_sign('(') && of[1].is_sign('±'))
        || tokens.iter().any(|token| token.inner().any(has_signed_bracket))
}
