//! Numbers of computing: digits in base two that are not called so, logarithms to the base two, and prefixes that are powers of 1024.

use crate::decimal::fixed;
use crate::judge::sides::Sides;
use crate::token::{MathFunction, Token, TokenKind};

/// Most digits of a number in base two before and behind its point.
const MOST_DIGITS: usize = 40;

/// Both sides in base ten, if all of their numbers may be in base two; or the left one, where it is a significand of base two times a power of
/// two, or one number with the digits of base two: `1.0110 · 2^0 = 1.375`, `111 = 4 + 2 + 1`, `1001 = 9h`.
pub(super) fn in_decimal(left: &[Token], right: &[Token]) -> Option<Sides> {
    if is_binary(left, |_| true) && is_binary(right, |_| true) {
        return Some([converted(left), converted(right)]);
    }
    let is_power_of_two = |side: &[Token], at: usize| {
        side[at].number() == Some("2") && matches!(side.get(at + 1), Some(Token { kind: TokenKind::Power(_), .. }))
    };
    let is_significand = |side: &[Token]| {
        (0..side.len()).any(|at| is_power_of_two(side, at)) && is_binary(side, |at| !is_power_of_two(side, at))
    };
    if is_significand(left) {
        return Some([converted(left), right.to_vec()]);
    }
    let is_number = matches!(left, [number] if number.number().is_some_and(|digits| digits.len() > 2));
    if !is_number || !is_binary(left, |_| true) {
        return None;
    }
    // The letter of a hexadecimal digit is no unit.
    let right = match right {
        [digit, letter] if digit.number().is_some() && matches!(letter.word(), Some("h" | "H")) => vec![digit.clone()],
        right if is_significand(right) => converted(right),
        right => right.to_vec(),
    };
    Some([converted(left), right])
}

/// Whether the numbers of a side, but for those that don't count, have the digits 0 and 1 only, one of them several.
fn is_binary(side: &[Token], counts: impl Fn(usize) -> bool) -> bool {
    let digits: Vec<&str> = (0..side.len()).filter(|at| counts(*at)).filter_map(|at| side[at].number()).collect();
    let plain = side.iter().enumerate().all(|(at, token)| match token.kind {
        TokenKind::Power(_) => at > 0 && !counts(at - 1),
        _ => matches!(token.kind, TokenKind::Number(_) | TokenKind::Space(_) | TokenKind::Operator(_)),
    });
    let is_long = |of: &&str| of.len() > 1 && of.len() < MOST_DIGITS;
    plain && digits.iter().all(|of| of.chars().all(|c| "01.".contains(c))) && digits.iter().any(is_long)
}

/// Whether all numbers of a side, but for powers of two, have the digits 0 and 1 only, and it has no letters.
pub(super) fn is_of_bits(side: &[Token]) -> bool {
    let is_raised = |at: usize| matches!(side.get(at), Some(Token { kind: TokenKind::Power(_), .. }));
    let fits = |(at, token): (usize, &Token)| match &token.kind {
        TokenKind::Number(digits) => {
            is_raised(at + 1) && digits == "2"
                || digits.len() < MOST_DIGITS && digits.bytes().all(|c| matches!(c, b'0' | b'1' | b'.'))
        }
        TokenKind::Power(_) => at > 0 && side[at - 1].number() == Some("2"),
        _ => matches!(token.kind, TokenKind::Space(_) | TokenKind::Operator(_)),
    };
    side.iter().enumerate().all(fits) && side.iter().any(|token| token.number().is_some_and(|of| of != "2"))
}

/// The tokens with their numbers of the digits 0 and 1 in base ten.
pub(super) fn converted(side: &[Token]) -> Vec<Token> {
    let decimal = |token: &Token| {
        let digits =
            token.number().filter(|digits| digits.len() < MOST_DIGITS && digits.chars().all(|c| "01.".contains(c)))?;
        let (whole, behind) = digits.split_once('.').unwrap_or((digits, ""));
        let value = |digits: &str| digits.chars().fold(0.0, |sum, c| 2.0 * sum + if c == '1' { 1.0 } else { 0.0 });
        let number = value(whole) + value(behind) * libm::exp2(-(behind.len() as f64));
        let digits = if behind.is_empty() { format!("{number}") } else { fixed(number, 12) };
        Some(Token::new(TokenKind::Number(digits), token.span))
    };
    side.iter().map(|token| decimal(token).unwrap_or_else(|| token.clone())).collect()
}

/// A side with its logarithms without a base to the base 2; none if there are none.
pub(super) fn to_base_two(side: &[Token]) -> Option<Vec<Token>> {
    let is_log = |token: &Token| matches!(token.kind, TokenKind::Function(MathFunction::Log | MathFunction::Lg));
    let change = |token: &Token| {
        if is_log(token) { Token::new(TokenKind::Function(MathFunction::LogTo(2)), token.span) } else { token.clone() }
    };
    side.iter().any(is_log).then(|| side.iter().map(change).collect())
}

/// A side with each letter `e` behind a number as the base of the natural logarithms, also above and below strokes: `1/(2e)`; none if there
/// is no such letter.
pub(super) fn with_base_of_logarithms(side: &[Token]) -> Option<Vec<Token>> {
    let is_e = |token: &Token| matches!(&token.kind, TokenKind::Word(word) | TokenKind::Name(word) if word == "e");
    let mut out: Vec<Token> = Vec::with_capacity(side.len() + 1);
    let mut found = false;
    for (at, token) in side.iter().enumerate() {
        let mut copy = token.clone();
        for list in copy.kind.lists() {
            if let Some(inner) = with_base_of_logarithms(list) {
                (*list, found) = (inner, true);
            }
        }
        let is_raised = matches!(side.get(at + 1), Some(Token { kind: TokenKind::Power(_), .. }));
        let behind_number = out.iter().rev().find(|of| !of.is_space()).is_some_and(|of| of.number().is_some());
        if is_e(token) && behind_number && !is_raised {
            out.push(Token::new(TokenKind::Operator('\u{b7}'), token.span));
            copy.kind = TokenKind::Number(EULER.to_owned());
            found = true;
        }
        out.push(copy);
    }
    found.then_some(out)
}

/// The base of the natural logarithms, with more digits than any text prints.
const EULER: &str = "2.718281828459045";

/// Prefixes of sizes of memory without a unit, and their powers of two.
const PREFIXES: [(&str, &str); 5] = [("K", "10"), ("M", "20"), ("G", "30"), ("T", "40"), ("P", "50")];

/// Both sides with the prefixes behind numbers of one of them as powers of two, if the other one has a power of two: `2^16 = 64K`.
pub(super) fn with_binary_prefixes(left: &[Token], right: &[Token]) -> Option<Sides> {
    let has_power = |side: &[Token]| {
        let is_raised = |of: &[Token]| of[0].number() == Some("2") && matches!(of[1].kind, TokenKind::Power(_));
        side.windows(2).any(is_raised)
    };
    let prefix_of = |token: &Token| match &token.kind {
        TokenKind::Word(word) | TokenKind::Name(word) => PREFIXES.iter().find(|(prefix, _)| prefix == word),
        _ => None,
    };
    let written = |side: &[Token]| -> Option<Vec<Token>> {
        let mut out: Vec<Token> = Vec::with_capacity(side.len() + 3);
        let mut found = false;
        for token in side {
            let behind_number = out.iter().rev().find(|of| !of.is_space()).is_some_and(|of| of.number().is_some());
            match prefix_of(token).filter(|_| behind_number) {
                Some((_, power)) => {
                    let power = vec![Token::new(TokenKind::Number((*power).to_owned()), token.span)];
                    let kinds = [TokenKind::Operator('·'), TokenKind::Number("2".to_owned()), TokenKind::Power(power)];
                    out.extend(kinds.map(|kind| Token::new(kind, token.span)));
                    found = true;
                }
                None => out.push(token.clone()),
            }
        }
        found.then_some(out)
    };
    match (has_power(left), has_power(right)) {
        (true, _) => written(right).map(|right| [left.to_vec(), right]),
        (_, true) => written(left).map(|left| [left, right.to_vec()]),
        _ => None,
    }
}
