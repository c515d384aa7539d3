//! Formulas with letters that were taken for units, and the sides that put numbers in their place.

use crate::token::{Token, TokenKind};
use crate::unit::unit;

/// Whether the right side is the left one with numbers for letters that were taken for units: `5/D = 5/4`, `2·g·h = 2·9.81·5`.
pub(crate) fn substitutes(left: &[Token], right: &[Token]) -> bool {
    let mut letters = 0;
    fits(&without_space(left), &without_space(right), &mut letters) && letters > 0
}

pub(crate) fn without_space(side: &[Token]) -> Vec<&Token> {
    side.iter().filter(|token| !token.is_space()).collect()
}

fn fits(mut left: &[&Token], mut right: &[&Token], letters: &mut usize) -> bool {
    let times = |token: &Token| token.is_one_of("×·");
    let mut behind_sign = true;
    while let [one, rest @ ..] = left {
        if let [other, behind @ ..] = right
            && (one.kind == other.kind || (times(one) && times(other)))
        {
            (left, right, behind_sign) = (rest, behind, matches!(one.kind, TokenKind::Operator(_)));
            continue;
        }
        match (&one.kind, right) {
            (TokenKind::Word(_) | TokenKind::Name(_), _) => {
                // Between a number and a letter there need be no sign.
                if let [sign, behind @ ..] = right
                    && !behind_sign
                    && times(sign)
                {
                    right = behind;
                }
                let Some(behind) = behind_value(right) else { return false };
                right = behind;
                // Two letters may be a product of two quantities.
                let two = matches!(&one.kind, TokenKind::Word(word) if word.chars().count() == 2);
                if let [sign, behind @ ..] = right
                    && two
                    && times(sign)
                    && let Some(behind) = behind_value(behind)
                {
                    right = behind;
                }
                *letters += 1;
            }
            (TokenKind::Fraction(a, b), [Token { kind: TokenKind::Fraction(c, d), .. }, behind @ ..])
            | (TokenKind::Root(a, b), [Token { kind: TokenKind::Root(c, d), .. }, behind @ ..]) => {
                if !fits(&without_space(a), &without_space(c), letters)
                    || !fits(&without_space(b), &without_space(d), letters)
                {
                    return false;
                }
                right = behind;
            }
            (TokenKind::Power(a), [Token { kind: TokenKind::Power(b), .. }, behind @ ..]) => {
                if !fits(&without_space(a), &without_space(b), letters) {
                    return false;
                }
                right = behind;
            }
            _ => return false,
        }
        (left, behind_sign) = (rest, false);
    }
    right.is_empty()
}

/// What is behind the value with which a side begins: a number with its power of ten and unit, or an expression in brackets.
fn behind_value<'t, 's>(side: &'s [&'t Token]) -> Option<&'s [&'t Token]> {
    let (first, mut rest) = side.split_first()?;
    if first.is_one_of("([") {
        let mut depth = 1usize;
        let end = rest.iter().position(|token| {
            depth += usize::from(token.is_one_of("(["));
            depth -= usize::from(token.is_one_of(")]"));
            depth == 0
        })?;
        return Some(&rest[end + 1..]);
    }
    first.number()?;
    if let [sign, ten, power, behind @ ..] = rest
        && sign.is_one_of("×·")
        && ten.number() == Some("10")
        && matches!(power.kind, TokenKind::Power(_))
    {
        rest = behind;
    }
    while let [word, behind @ ..] = rest
        && word.word().is_some_and(|word| unit(word).is_some())
    {
        rest = behind;
    }
    Some(rest)
}

/// Whether a side may be a formula whose letters were taken for units: no number in it has more than two digits, and a single letter stands
/// behind a sign, as in `1/T` and `1/2·C·V²`.
pub(crate) fn is_formula(side: &[Token]) -> bool {
    let side = without_space(side);
    let letter = |token: &Token| {
        token.word().is_some_and(|word| word.chars().count() == 1 && word.chars().all(char::is_alphabetic))
    };
    let small = |token: &&&Token| token.number().is_none_or(|digits| digits.len() < 3 && !digits.contains('.'));
    let words = side.iter().filter_map(|token| token.word()).all(|word| word.chars().count() == 1);
    // Units of a product stand behind one another: 60 N·m.
    let behind_sign = (1..side.len()).any(|at| {
        let of_unit = at > 1 && matches!(side[at - 2].kind, TokenKind::Word(_) | TokenKind::Power(_));
        side[at - 1].is_one_of("/·×+-") && letter(side[at]) && !of_unit
    });
    words && behind_sign && side.iter().all(|token| small(&token))
}
