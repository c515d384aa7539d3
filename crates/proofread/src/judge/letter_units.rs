//! Units whose letters are set as quantities: `12.40mm`, `2.31m^3`, `309.1\ J`.
//!
//! A letter behind a number is a factor in algebra, so the letters become units only if the whole chain makes sense with them: each side
//! with numbers has a value, all units are of one dimension, and the last side is a printed quantity.

use crate::evaluate::value::{Literal, SideValue};
use crate::join::chain::{Chain, ChainSide};
use crate::judge::letters_alone::{ALONE, has_mixed_terms, stands_alone};
use crate::judge::unit_products::units_in_products;
use crate::judge::verdict::evaluate_freely;
use crate::token::{Token, TokenKind, any, has_number};
use crate::unit::unit;

/// Digits of a result by which a single letter behind it is hardly a factor.
const TELLING_DIGITS: usize = 3;

/// The letters of a run at a place, and how many tokens they are: letters that touch each other and make a unit.
fn run(tokens: &[Token], at: usize) -> Option<(String, usize)> {
    let mut text = String::new();
    let mut length = 0;
    for (which, token) in tokens[at..].iter().enumerate() {
        let TokenKind::Name(name) = &token.kind else { break };
        let touches = which == 0 || tokens[at + which - 1].span.end == token.span.start;
        if !touches || name.chars().count() != 1 || length == 4 {
            break;
        }
        text.push_str(name);
        length += 1;
    }
    let known = if length == 1 { ALONE.contains(&text) } else { length > 1 && unit(&text).is_some() };
    let next = tokens[at + length..].iter().find(|token| !token.is_space());
    let ends = next.is_none_or(|next| match &next.kind {
        TokenKind::Operator(c) => "+-·×/),".contains(*c),
        TokenKind::Power(_) => true,
        _ => false,
    });
    (known && ends).then_some((text, length))
}

/// Tokens with such letters as units, and the letters.
fn with_units(tokens: &[Token], found: &mut Vec<String>) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let follows_number = out.iter().rev().find(|token| !token.is_space()).is_some_and(|of| of.number().is_some());
        if follows_number && let Some((text, length)) = run(tokens, at) {
            let span = token.span.join(tokens[at + length - 1].span);
            out.push(Token::new(TokenKind::Word(text.clone()), span));
            found.push(text);
            at += length;
            continue;
        }
        out.push(match &token.kind {
            TokenKind::Fraction(above, below) => {
                let parts = [above, below].map(|part| with_units(part, found));
                let [above, below] = parts;
                Token::new(TokenKind::Fraction(above, below), token.span)
            }
            TokenKind::Root(of, index) => Token::new(TokenKind::Root(with_units(of, found), index.clone()), token.span),
            _ => token.clone(),
        });
        at += 1;
    }
    out
}

/// A chain with the letters behind its numbers as units, if it makes sense with them and has letters there. A letter that stands for a
/// quantity elsewhere in the formula is none.
pub(crate) fn units_in_letters(chain: &Chain, formula: &[Token]) -> Option<Chain> {
    with_single_units(chain, formula).or_else(|| units_in_products(chain, formula))
}

/// The chain with single letters and groups of them as units.
fn with_single_units(chain: &Chain, formula: &[Token]) -> Option<Chain> {
    let is_letter = |kind: &TokenKind| matches!(kind, TokenKind::Name(name) if name.len() == 1 && name != "e");
    let last = chain.sides.last()?;
    if !has_number(&last.tokens) || !any(&last.tokens, &is_letter) {
        return None;
    }
    let mut found = Vec::new();
    let mut counted = Vec::new();
    let sides: Vec<ChainSide> = { chain.sides.iter() }
        .map(|side| {
            let before = found.len();
            let tokens = with_units(&side.tokens, &mut found);
            counted.push(found.len() > before);
            ChainSide { tokens, ..side.clone() }
        })
        .collect();
    if !counted.last().copied()? {
        return None;
    }
    let values: Vec<(usize, SideValue)> = { sides.iter().enumerate() }
        .filter(|(_, side)| has_number(&side.tokens))
        .filter_map(|(at, side)| evaluate_freely(&side.tokens, None).ok().map(|value| (at, value)))
        .collect();
    let (_, result) = values.last().filter(|(at, _)| at + 1 == sides.len())?;
    let computed: Vec<&SideValue> =
        { values.iter() }.filter(|(at, _)| at + 1 < sides.len()).map(|(_, of)| of).collect();
    let fits = |value: &&SideValue| !value.has_unit || value.dimension == result.dimension;
    if result.literal != Literal::Number || !result.has_unit || computed.is_empty() || !computed.iter().all(fits) {
        return None;
    }
    if sides.iter().any(has_mixed_terms) {
        return None;
    }
    // Sides that are neither numbers nor names are not understood.
    let numeric = sides.iter().filter(|side| has_number(&side.tokens)).count();
    let names: Vec<&str> = { sides.iter().flat_map(|side| &side.tokens) }
        .filter_map(|token| if let TokenKind::Name(name) = &token.kind { Some(name.as_str()) } else { None })
        .collect();
    let is_quantity = found.iter().any(|unit| names.contains(&&**unit) || stands_alone(formula, unit));
    if is_quantity || numeric != values.len() {
        return None;
    }
    let is_shared = counted.iter().filter(|has| **has).count() > 1 || found.iter().any(|unit| unit.len() > 1);
    let digits = { sides.last()?.tokens.iter() }.find_map(Token::number)?.chars().filter(char::is_ascii_digit).count();
    let computes = computed.iter().all(|value| value.literal == Literal::No);
    (is_shared || (digits >= TELLING_DIGITS && computes)).then(|| Chain { sides, ..chain.clone() })
}
