//! Terms whose size, sign or unit is written in a way that only some texts have.

use crate::evaluate::atom::large_number;
use crate::judge::substitution::without_space;
use crate::token::{Token, TokenKind};
use crate::unit::{currency, unit};

/// A side in which a negative number in braces is raised with its sign, `{-8}^2` as 64: whoever puts it in braces, often a program, puts it in
/// for a letter.
pub(super) fn with_braced_sign(text: &str, side: &[Token]) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = Vec::with_capacity(side.len() + 2);
    let mut found = false;
    for token in side {
        let mut copy = token.clone();
        for list in copy.kind.lists() {
            if let Some(changed) = with_braced_sign(text, list) {
                (*list, found) = (changed, true);
            }
        }
        let braced = matches!(token.kind, TokenKind::Power(_)) && {
            let [.., sign, number] = out.as_slice() else {
                out.push(copy);
                continue;
            };
            let before = text.get(..sign.span.start as usize).unwrap_or_default();
            let behind = text.get(number.span.end as usize..).unwrap_or_default();
            sign.is_sign('-') && number.number().is_some() && before.ends_with('{') && behind.starts_with('}')
        };
        if braced {
            let bracket = |c| Token::new(TokenKind::Operator(c), token.span);
            out.insert(out.len() - 2, bracket('('));
            out.push(bracket(')'));
            found = true;
        }
        out.push(copy);
    }
    found.then_some(out)
}

/// A sum of bare terms with the sign of degrees behind the last one, in degrees as a whole: `4 + 30/60 + 18/3600 degrees`.
pub(super) fn sum_in_degrees(side: &[Token]) -> Option<Vec<Token>> {
    let end = side.iter().rposition(|token| !token.is_space())?;
    let (unit, terms) = side[..=end].split_last()?;
    let is_degrees = unit.word().is_some_and(|word| ["°", "degree", "degrees"].contains(&word));
    let is_bare = |token: &Token| token.word().is_none() && !matches!(token.kind, TokenKind::Function(_));
    let bracket = |c| Token::new(TokenKind::Operator(c), unit.span);
    (is_degrees && terms.iter().skip(1).any(|token| token.is_one_of("+-")) && terms.iter().all(is_bare))
        .then(|| [&[bracket('(')], terms, &[bracket(')'), unit.clone()]].concat())
}

/// Whether a unit without a number is the first factor of a side, so that it names a quantity: mol × 22.4 L/mol.
pub(super) fn begins_with_unit(side: &[Token]) -> bool {
    matches!(without_space(side).as_slice(), [word, sign, number, ..]
        if word.word().is_some_and(|word| word.chars().all(char::is_alphabetic) && unit(word).is_some())
            && sign.is_one_of("×·")
            && number.number().is_some())
}

/// A side without the word for a large number behind its last number, in which the other side may count: `0.6 · 200 = 120 million`.
pub(super) fn without_large_number(side: &[Token]) -> Option<Vec<Token>> {
    let is_large = |word: &str| large_number(word).is_some();
    // The sign of a currency, or a word that is no unit.
    let is_other = |word: &str| currency(word).is_some() || (unit(word).is_none() && !is_large(word));
    let is_behind = |token: &Token| token.is_space() || token.word().is_some_and(is_other);
    let end = side.iter().rposition(|token| !is_behind(token))?;
    let (last, rest) = side[..=end].split_last()?;
    let counts = last.word().is_some_and(is_large);
    (counts && rest.iter().any(|token| token.number().is_some())).then(|| rest.to_vec())
}
