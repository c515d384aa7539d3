//! Sums of integers with dots for the terms between: `1 + 2 + ⋯ + 10` is 55.

use crate::decimal::parse_decimal;
use crate::evaluate::interval::Interval;
use crate::evaluate::value::{Literal, SideValue};
use crate::token::{Token, TokenKind};

/// Most terms that are printed before the dots.
const MOST_PRINTED: usize = 6;
/// Largest sum that is reckoned with.
const LARGEST: f64 = 9.0e15;

/// The sum of an arithmetic progression that these tokens are: two terms or more, dots, and the last term. None if they are anything
/// else, or if the printed terms may be those of a geometric progression.
pub(crate) fn of_progression(tokens: &[Token]) -> Option<SideValue> {
    let mut solid = tokens.iter().filter(|token| !token.is_space());
    let integer = |token: Option<&Token>| {
        let digits = token?.number().filter(|digits| digits.chars().all(|c| c.is_ascii_digit()))?;
        parse_decimal(digits)
    };
    let mut printed = vec![integer(solid.next())?];
    loop {
        solid.next().filter(|sign| sign.is_sign('+'))?;
        let term = solid.next()?;
        if is_dots(term) {
            break;
        }
        printed.push(integer(Some(term)).filter(|_| printed.len() < MOST_PRINTED)?);
    }
    solid.next().filter(|sign| sign.is_sign('+'))?;
    let last = integer(solid.next())?;
    let [first, second, ..] = *printed.as_slice() else { return None };
    let step = second - first;
    let is_steady = printed.windows(2).all(|of| of[1] - of[0] == step);
    let count = (last - first) / step + 1.0;
    // Dots that stand for no term are those of other data: 8 + 5 + … + 2.
    let is_whole = count.fract() == 0.0 && count > printed.len() as f64 + 1.0;
    if solid.next().is_some() || step == 0.0 || !is_steady || !is_whole || may_be_geometric(&printed, last) {
        return None;
    }
    let sum = count * (first + last) / 2.0;
    let value = SideValue::from_interval(Interval::exact(sum));
    (sum.abs() < LARGEST).then_some(SideValue { operations: 1, literal: Literal::No, ..value })
}

fn is_dots(token: &Token) -> bool {
    match &token.kind {
        TokenKind::Unknown(name) => name == "…",
        TokenKind::Operator(c) => *c == '…',
        _ => false,
    }
}

/// Whether each printed term is the one before times the same factor, and the last one comes so, too: 2 + 4 + ⋯ + 64.
fn may_be_geometric(printed: &[f64], last: f64) -> bool {
    let ratio = printed[1] / printed[0];
    if !(ratio.is_finite() && ratio > 1.0) || printed.windows(2).any(|of| of[1] != of[0] * ratio) {
        return false;
    }
    let mut term = printed[1];
    while term < last {
        term *= ratio;
    }
    term == last
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::join::token_joining::join_tokens;
    use crate::reader::tokenise_text;

    fn sum(text: &str) -> Option<f64> {
        of_progression(&join_tokens(&tokenise_text(text, 0))).and_then(|value| value.number().ok()).map(|of| of.point)
    }

    #[test]
    fn terms_are_steady_and_reach_the_last_one() {
        assert_eq!(sum("1 + 2 + 3 + … + 10"), Some(55.0));
        assert_eq!(sum("1 + 3 + … + 99"), Some(2500.0));
        assert_eq!(sum("10 + 9 + … + 1"), Some(55.0));
        for other in [
            "1 + … + 10",
            "1 + 2 + 4 + … + 64",
            "2 + 4 + … + 64",
            "1 + 3 + … + 10",
            "1 + 2 + … + 2",
            "8 + 5 + … + 2",
            "1 + 1 + … + 1",
            "1 + 2 + … + 10 + 3",
        ] {
            assert_eq!(sum(other), None, "{other}");
        }
    }
}
