//! Congruences with a printed modulus: `7 + 9 ≡ 3 (mod 12)` says that both sides leave the same remainder.

use crate::token::{Span, Token, TokenKind, trim_space};

/// Most tokens of a side.
const LONGEST_SIDE: usize = 60;

/// The tokens with `A ≡ B (mod m)` as `(A) mod m = (B) mod m`, where all three are numbers or are computed from numbers, and no other
/// relation stands in the same row. None if there is no such congruence.
pub(crate) fn as_remainders(tokens: &[Token]) -> Option<Vec<Token>> {
    if !tokens.iter().any(|token| token.is_sign('≡') || is_pmod(token)) {
        return None;
    }
    let mut out = Vec::with_capacity(tokens.len());
    let mut found = false;
    for piece in tokens.split_inclusive(parts) {
        let (end, row) =
            piece.split_last().filter(|(last, _)| parts(last)).map_or((None, piece), |(end, row)| (Some(end), row));
        match rewritten(row) {
            Some(mut row) => {
                found = true;
                out.append(&mut row);
            }
            None => out.extend_from_slice(row),
        }
        out.extend(end.cloned());
    }
    found.then_some(out)
}

/// Whether a token stands between two formulas.
fn parts(token: &Token) -> bool {
    let word = |word: &str| word.chars().count() > 1 && word != "mod";
    match &token.kind {
        TokenKind::Line | TokenKind::Space(9..) | TokenKind::Operator(',' | ';' | '.' | '⇒') => true,
        TokenKind::Word(of) => word(of),
        _ => false,
    }
}

/// A row that is a congruence, as an equation of remainders.
fn rewritten(row: &[Token]) -> Option<Vec<Token>> {
    let row = trim_space(row);
    let Some(at) = row.iter().position(|token| token.is_sign('≡')) else { return with_modulus(row) };
    let (left, rest) = (trim_space(&row[..at]), &row[at + 1..]);
    let (right, modulus) = parted_modulus(rest)?;
    let right = trim_space(right);
    if ![left, right].into_iter().all(is_arithmetic) {
        return None;
    }
    let end = |side: &[Token]| side.last().map_or(0, |last| last.span.end as usize);
    let start = |side: &[Token]| side.first().map_or(0, |first| first.span.start as usize);
    let sign = |c, at: usize| Token::new(TokenKind::Operator(c), Span::new(at, at));
    let mut out = Vec::with_capacity(2 * row.len());
    for side in [left, right] {
        let place = end(side);
        if !out.is_empty() {
            out.push(Token::new(TokenKind::Operator('='), row[at].span));
        }
        out.push(sign('(', start(side)));
        out.extend_from_slice(side);
        out.push(sign(')', place));
        out.push(Token::new(TokenKind::Word("mod".to_owned()), Span::new(place, place)));
        out.push(Token::new(modulus.clone(), Span::new(place, place)));
    }
    Some(out)
}

fn is_pmod(token: &Token) -> bool {
    matches!(&token.kind, TokenKind::Unknown(name) if name == "pmod")
}

/// A row of equations of numbers with `\\pmod` behind the last, with the modulus as one behind `mod`: it may hold for the rows before, too.
fn with_modulus(row: &[Token]) -> Option<Vec<Token>> {
    let at = row.iter().position(is_pmod)?;
    let (before, modulus) = parted_modulus(row)?;
    let mut sides = before.split(|token| token.is_sign('='));
    let first = sides.next().map(trim_space)?;
    let mut others = sides.peekable();
    if !(first.is_empty() || is_arithmetic(first)) || others.peek().is_none() || !others.all(is_arithmetic) {
        return None;
    }
    let word = Token::new(TokenKind::Word("mod".to_owned()), row[at].span);
    let place = row.last().map_or(row[at].span, |last| last.span);
    Some([before, &[word, Token::new(modulus, place)]].concat())
}

/// What stands before the modulus, and the modulus: an integer behind `\\pmod`, or with `mod` in brackets.
fn parted_modulus(tokens: &[Token]) -> Option<(&[Token], TokenKind)> {
    let solid: Vec<usize> = (0..tokens.len()).filter(|at| !tokens[*at].is_space()).collect();
    let mut last = solid.iter().rev().map(|at| (*at, &tokens[*at]));
    let closes = |token: &Token| token.is_sign(')');
    let is_mod = |token: &Token| match &token.kind {
        TokenKind::Word(word) | TokenKind::Unknown(word) => matches!(word.as_str(), "mod" | "pmod"),
        _ => false,
    };
    let (mut at, mut token) = last.next()?;
    let bracketed = closes(token);
    if bracketed {
        (at, token) = last.next()?;
    }
    let digits = token.number().filter(|digits| digits.chars().all(|c| c.is_ascii_digit()) && *digits != "0")?;
    let modulus = TokenKind::Number(digits.to_owned());
    (at, token) = (last.next().filter(|(before, _)| *before < at))?;
    if !is_mod(token) {
        return None;
    }
    if bracketed {
        (at, token) = last.next()?;
        if !token.is_sign('(') {
            return None;
        }
    }
    Some((&tokens[..at], modulus))
}

/// Whether tokens are numbers and signs between them, with no letter, unit or relation.
fn is_arithmetic(side: &[Token]) -> bool {
    let fits = |token: &Token| match &token.kind {
        TokenKind::Number(digits) => digits.chars().all(|c| c.is_ascii_digit()),
        TokenKind::Operator(c) => "+-·×*/()!".contains(*c),
        TokenKind::Space(width) => *width < 9,
        TokenKind::Power(power) => is_arithmetic(power),
        _ => false,
    };
    !trim_space(side).is_empty() && side.len() <= LONGEST_SIDE && side.iter().all(fits)
}
