//! Exponents that can be read without evaluating anything.

use crate::evaluate::printed::PrintedNumber;
use crate::evaluate::value::{Evaluated, Obstacle};
use crate::token::{Token, TokenKind};

/// A small integer that stands alone.
pub(crate) fn small_integer(tokens: &[Token]) -> Option<f64> {
    integer_below(1000, tokens)
}

/// A whole number below a bound that stands alone.
pub(crate) fn integer_below(bound: u32, tokens: &[Token]) -> Option<f64> {
    let [Token { kind: TokenKind::Number(text), .. }] = tokens else { return None };
    text.parse::<u32>().ok().filter(|number| *number < bound).map(f64::from)
}

/// An exponent that is a number or a fraction of two, with a sign.
pub(crate) fn plain_exponent(tokens: &[Token]) -> Evaluated<f64> {
    let tokens: Vec<&Token> = tokens.iter().filter(|token| !token.is_space()).collect();
    let (sign, tokens) = match tokens.as_slice() {
        [first, rest @ ..] if first.is_sign('-') => (-1.0, rest),
        [first, rest @ ..] if first.is_sign('+') => (1.0, rest),
        all => (1.0, all),
    };
    let number = |text: &str| PrintedNumber::read(text).map(|of| of.value);
    let value = match tokens {
        [Token { kind: TokenKind::Number(text), .. }] => number(text),
        [Token { kind: TokenKind::Fraction(a, b), .. }] => small_integer(a).zip(small_integer(b)).map(|(a, b)| a / b),
        [Token { kind: TokenKind::Number(a), .. }, stroke, Token { kind: TokenKind::Number(b), .. }]
            if stroke.is_sign('/') =>
        {
            number(a).zip(number(b)).map(|(a, b)| a / b)
        }
        _ => None,
    };
    value
        .filter(|value| value.is_finite() && value.abs() < 1e4)
        .map(|value| sign * value)
        .ok_or(Obstacle::Unclear("an exponent that is no number"))
}

/// Whether an upright e to a power is the base of the logarithms: nobody raises a charge to such a power.
pub(crate) fn is_power_of_e(power: f64) -> bool {
    power <= 0.0 || power > 4.0 || power.fract() != 0.0
}
