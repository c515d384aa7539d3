//! Products and quotients of units whose letters are set as quantities: `203.7m/s`, `5\,kg \cdot 3\,\frac{m}{s^2}`, `20A(5m\Omega)`.
//!
//! They become units only if the chain makes sense with them: all its sides with numbers and units are of one dimension, its last side is a
//! printed number, and more than one letter speaks for it. Where the dimensions differ, the letters stay quantities.

use crate::evaluate::value::{Literal, SideValue};
use crate::join::chain::{Chain, ChainSide};
use crate::judge::letters_alone::{ALONE, has_mixed_terms, stands_alone};
use crate::judge::verdict::evaluate_freely;
use crate::token::{Span, Token, TokenKind, any, has_number};
use crate::unit::unit;

/// Letters that are units behind a stroke, besides those that stand alone.
const BELOW: &str = "hd";
/// Most letters of the sign of a unit.
const LONGEST: usize = 4;

/// The units that were found in a side.
#[derive(Default)]
struct FoundUnits {
    /// Letters that are a unit by themselves.
    single: Vec<String>,
    /// Whether a sign of several letters is among them.
    long: bool,
    /// Whether a quotient of units is among them.
    quotient: bool,
}

impl FoundUnits {
    fn is_empty(&self) -> bool {
        self.single.is_empty() && !self.long && !self.quotient
    }
}

fn skip_space(tokens: &[Token], mut at: usize) -> usize {
    while tokens.get(at).is_some_and(Token::is_space) {
        at += 1;
    }
    at
}

/// The sign of a unit that begins at a place, and where it ends: letters that touch each other, or a word.
fn sign(tokens: &[Token], at: usize, is_below: bool) -> Option<(String, usize)> {
    if let Some(word) = tokens.get(at)?.word() {
        return unit(word).is_some().then(|| (word.to_owned(), at + 1));
    }
    let mut text = String::new();
    let mut end = at;
    while let Some(TokenKind::Name(name)) = tokens.get(end).map(|token| &token.kind) {
        let touches = end == at || tokens[end - 1].span.end == tokens[end].span.start;
        if !touches {
            break;
        }
        if name.chars().count() != 1 || end - at == LONGEST {
            return None;
        }
        text.push_str(name);
        end += 1;
    }
    let known = match end - at {
        0 => false,
        1 => ALONE.contains(&text) || text == "Ω" || (is_below && BELOW.contains(&text)),
        _ => unit(&text).is_some(),
    };
    known.then_some((text, end))
}

/// The units from a place on, with their exponents, as tokens, and where they end.
fn product(tokens: &[Token], start: usize, found: &mut FoundUnits) -> Option<(Vec<Token>, usize)> {
    let mut out = Vec::new();
    let mut at = start;
    let mut is_below = false;
    loop {
        let (text, end) = sign(tokens, at, is_below)?;
        let is_letters = tokens[at].word().is_none();
        let span = tokens[at].span.join(tokens[end - 1].span);
        if is_letters {
            if end - at > 1 {
                found.long = true;
            } else {
                found.single.push(text.clone());
            }
        }
        out.push(Token::new(TokenKind::Word(text), span));
        at = end;
        if let Some(power) = tokens.get(at).filter(|token| matches!(token.kind, TokenKind::Power(_))) {
            out.push(power.clone());
            at += 1;
        }
        let next = skip_space(tokens, at);
        let connects = tokens.get(next).is_some_and(|token| token.is_one_of("/·"));
        let behind = if connects { skip_space(tokens, next + 1) } else { next };
        let divides = connects && tokens[next].is_sign('/');
        if sign(tokens, behind, divides).is_none() {
            return Some((out, at));
        }
        found.quotient |= divides;
        is_below = divides;
        let between = Span { start: span.end, end: span.end };
        let joint = if connects { tokens[next].clone() } else { Token::new(TokenKind::Operator('·'), between) };
        out.push(joint);
        at = behind;
    }
}

/// Tokens that are units and nothing else, as units.
fn only_units(tokens: &[Token], found: &mut FoundUnits) -> Option<Vec<Token>> {
    let (out, end) = product(tokens, skip_space(tokens, 0), found)?;
    (skip_space(tokens, end) == tokens.len()).then_some(out)
}

/// The units behind a number, and where they end.
fn units_at(tokens: &[Token], start: usize, found: &mut FoundUnits) -> Option<(Vec<Token>, usize)> {
    let at = skip_space(tokens, start);
    let (out, end) = match tokens.get(at).map(|token| &token.kind)? {
        TokenKind::Fraction(above, below) => {
            let above = only_units(above, found)?;
            let below = only_units(below, found)?;
            found.quotient = true;
            (vec![Token::new(TokenKind::Fraction(above, below), tokens[at].span)], at + 1)
        }
        TokenKind::Operator('/') => {
            let behind = skip_space(tokens, at + 1);
            let is_long = sign(tokens, behind, true).is_some_and(|(_, end)| end - behind > 1);
            let (units, end) = if is_long { product(tokens, behind, found)? } else { return None };
            found.quotient = true;
            ([&tokens[at..=at], &units].concat(), end)
        }
        TokenKind::Name(_) => product(tokens, at, found)?,
        _ => return None,
    };
    let ends = tokens.get(skip_space(tokens, end)).is_none_or(|next| match next.kind {
        TokenKind::Operator(c) => "+-·×/)(],".contains(c),
        TokenKind::Fraction(..) | TokenKind::Number(_) | TokenKind::Unknown(_) => true,
        _ => false,
    });
    ends.then_some((out, end))
}

/// Whether units may stand behind these tokens: a number, or a power of one.
fn ends_with_number(tokens: &[Token]) -> bool {
    let mut solid = tokens.iter().rev().filter(|token| !token.is_space());
    match solid.next().map(|last| &last.kind) {
        Some(TokenKind::Number(_)) => true,
        Some(TokenKind::Power(_)) => solid.next().is_some_and(|base| base.number().is_some()),
        _ => false,
    }
}

/// Tokens with the units behind their numbers.
fn with_products(tokens: &[Token], found: &mut FoundUnits) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let mut more = FoundUnits::default();
        if !token.is_space()
            && ends_with_number(&out)
            && let Some((units, end)) = units_at(tokens, at, &mut more)
        {
            out.extend(units);
            at = end;
            found.single.append(&mut more.single);
            found.long |= more.long;
            found.quotient |= more.quotient;
            continue;
        }
        out.push(match &token.kind {
            TokenKind::Fraction(above, below) => {
                let [above, below] = [above, below].map(|part| with_products(part, found));
                Token::new(TokenKind::Fraction(above, below), token.span)
            }
            TokenKind::Root(of, index) => {
                Token::new(TokenKind::Root(with_products(of, found), index.clone()), token.span)
            }
            _ => token.clone(),
        });
        at += 1;
    }
    out
}

/// A chain with products and quotients of units in its letters, if it makes sense with them.
pub(super) fn units_in_products(chain: &Chain, formula: &[Token]) -> Option<Chain> {
    let is_letter = |kind: &TokenKind| matches!(kind, TokenKind::Name(name) if name != "π" && name != "e");
    if !chain.sides.iter().any(|side| has_number(&side.tokens) && any(&side.tokens, &is_letter)) {
        return None;
    }
    let mut found = FoundUnits::default();
    let (mut with_units, mut values) = (0, Vec::<SideValue>::new());
    let mut sides = Vec::with_capacity(chain.sides.len());
    for side in &chain.sides {
        let mut more = FoundUnits::default();
        let tokens = with_products(&side.tokens, &mut more);
        let value = has_number(&tokens).then(|| evaluate_freely(&tokens, None).ok()).flatten();
        let Some(value) = value else {
            // A side of quantities in letters stays as it is.
            if has_number(&side.tokens) && (!more.is_empty() || !any(&tokens, &is_letter)) {
                return None;
            }
            sides.push(side.clone());
            continue;
        };
        with_units += usize::from(value.has_unit);
        found.single.append(&mut more.single);
        found.long |= more.long;
        found.quotient |= more.quotient;
        values.push(value);
        sides.push(ChainSide { tokens, ..side.clone() });
    }
    let (result, computed) = values.split_last()?;
    let ends_with_result = sides.last().is_some_and(|side| evaluate_freely(&side.tokens, None).is_ok());
    let fits = |value: &SideValue| match value.has_unit {
        true => value.dimension == result.dimension,
        false => result.has_unit,
    };
    let computes = computed.iter().any(|value| value.literal == Literal::No);
    if found.is_empty() || !ends_with_result || result.literal != Literal::Number || !computes {
        return None;
    }
    if !computed.iter().all(fits) || sides.iter().any(has_mixed_terms) {
        return None;
    }
    // One letter on one side may be any quantity.
    let is_shared = found.long || found.quotient || with_units > 1;
    let is_first = |letter: &String| {
        let is_name = |token: &Token| matches!(&token.kind, TokenKind::Name(name) if name == letter);
        sides.iter().skip(1).any(|side| side.tokens.iter().any(is_name))
    };
    let clashes = |letter: &String| is_first(letter) || stands_alone(formula, letter);
    let is_quantity = !found.quotient && with_units < 2 && found.single.iter().any(clashes);
    (is_shared && !is_quantity).then(|| Chain { sides, ..chain.clone() })
}
