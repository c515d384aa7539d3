//! What is counted behind a result: `12 × 3.5 = 42 lamps`, and `(16 + 8) bytes = 24 bytes`.
//!
//! Such a noun is no unit that is known, and what stands before it can be computed without it. It is left away if it is behind the last
//! side and is the only word of the chain. What it counts may be worth several of what the other sides count (*3 × 4 = 1 dozen*), or be
//! counted up to whole pieces (*50/12 = 5 boxes*), and then it stays.

use crate::evaluate::value::{Literal, SideValue};
use crate::join::chain::{Chain, ChainSide};
use crate::judge::verdict::evaluate_freely;
use crate::token::{Token, TokenKind, any, has_number, span_of, trim_space};
use crate::unit::{currency, unit};

/// Most words behind a number that are taken for what it counts.
const MOST_WORDS: usize = 4;
/// Letters from which on a word is hardly the sign of a unit.
const SHORTEST: usize = 3;

/// Words that are a number, a way to write one, or an operation.
const NUMBER_WORDS: &str = " dozen dozens hundred hundreds thousand thousands lakh lakhs crore crores million millions milliard billion \
    billions trillion pair pairs couple couples score gross half halves quarter quarters third thirds tenth tenths hundredth hundredths \
    thousandth thousandths fold modulo base binary decimal hexadecimal octal ternary rounded truncated remainder rest plus minus times \
    divided over and mod hex oct bin dec the squared cubed factorial choose less per percentage prozent dutzend mal hundert tausend millionen milliarden ";

/// Words that name a unit of which others are made, though the table of units does not have them.
const UNIT_WORDS: &str = " pound pounds ounce ounces yard yards pint pints quart quarts cups tablespoon tablespoons teaspoon teaspoons \
    fathom fathoms furlong furlongs hectare hectares hertz pascal pascals tesla gauss coulomb coulombs farad farads henry henries carat \
    carats stone barrel barrels bushel bushels octet octets nibble nibbles decade decades century centuries fortnight fortnights radian \
    radians steradian steradians ";

/// Beginnings of the names of multiples and parts of units.
const PREFIXES: [&str; 10] = ["kilo", "mega", "giga", "tera", "peta", "milli", "micro", "nano", "centi", "deci"];

/// How many of one thing another one is worth often enough: days in a week, bits in a byte, months in a year.
const WORTH: [f64; 16] =
    [7.0, 8.0, 10.0, 12.0, 16.0, 20.0, 24.0, 30.0, 52.0, 60.0, 100.0, 365.0, 1000.0, 1024.0, 3600.0, 1e6];

/// Whether a word may be a noun for things that are counted.
fn is_counted_noun(word: &str) -> bool {
    // The decibels of a quantity that the sign names: dBV.
    if word.starts_with("dB") && unit(word).is_none() {
        return true;
    }
    let mut letters = word.chars();
    letters.next();
    let lower = word.to_ascii_lowercase();
    let listed = |list: &str| list.split_ascii_whitespace().any(|known| known == lower);
    word.chars().count() >= SHORTEST
        && word.chars().all(char::is_alphabetic)
        && letters.all(|c| !c.is_ascii_uppercase())
        && unit(word).is_none()
        && !listed(NUMBER_WORDS)
        && !listed(UNIT_WORDS)
        && !PREFIXES.iter().any(|prefix| lower.starts_with(prefix))
}

/// Whether a word is an abbreviation in capital letters for what a number is of, and no size of memory: `3.6 LPA`.
fn is_abbreviation(word: &str) -> bool {
    /// Letters of the shortest one.
    const LEAST: usize = 3;
    word.len() >= LEAST && word.bytes().all(|c| c.is_ascii_uppercase()) && !word.ends_with('B') && unit(word).is_none()
}

/// Whether a word may be a label of a quantity or a thing that is counted: no number, no operation, and no name of a unit that is not known.
pub(super) fn may_be_counted(word: &str) -> bool {
    let lower = word.to_ascii_lowercase();
    let listed = |list: &str| list.split_ascii_whitespace().any(|known| known == lower);
    word.chars().all(char::is_alphanumeric)
        && word.starts_with(char::is_alphabetic)
        && word.chars().any(|c| c.is_ascii_lowercase() || c.is_ascii_digit())
        && !listed(NUMBER_WORDS)
        && !listed(UNIT_WORDS)
        && !PREFIXES.iter().any(|prefix| lower.starts_with(prefix))
}

/// The words at the end of tokens, and the tokens before them: what is counted, directly behind a number or a bracket.
fn words_at_end(tokens: &[Token]) -> Option<(&[Token], Vec<&str>)> {
    let (mut rest, is_remark) = match without_remark(trim_space(tokens)) {
        Some(rest) => (rest, true),
        None => (trim_space(tokens), false),
    };
    // For what the result is one: $50 per year, $50/member.
    if let Some((noun, before)) = rest.split_last()
        && noun.word().is_some_and(|noun| noun.chars().all(char::is_alphabetic))
        && let Some((sign, number)) = trim_space(before).split_last()
        && (sign.word() == Some("per") || sign.is_sign('/') && noun.word().is_some_and(is_counted_noun))
        && let number = trim_space(number)
        && number.last().is_some_and(|last| last.number().is_some())
    {
        return Some((number, Vec::new()));
    }
    let mut words = Vec::new();
    while let [before @ .., last] = rest
        && let Some(word) = last.word()
    {
        words.push(word);
        rest = trim_space(before);
    }
    words.reverse();
    let is_counted =
        (is_remark || !words.is_empty()) && words.len() <= MOST_WORDS && words.iter().all(|word| is_counted_noun(word));
    let is_counted = is_counted || matches!(words.as_slice(), [word] if is_abbreviation(word));
    let is_counter = |last: &Token| last.number().is_some() || matches!(last.kind, TokenKind::Power(_));
    (is_counted && rest.last().is_some_and(is_counter)).then_some((rest, words))
}

/// The tokens before a remark in brackets that says how the number before it is given: `2.51 (rounded)`.
fn without_remark(tokens: &[Token]) -> Option<&[Token]> {
    const REMARKS: [&str; 5] = ["rounded", "approximately", "approx", "nearest", "exactly"];
    let (_, rest) = tokens.split_last().filter(|(last, _)| last.is_sign(')'))?;
    let open = rest.iter().rposition(|token| token.is_sign('('))?;
    let says = |token: &Token| token.word().is_some_and(|word| REMARKS.contains(&word));
    let inside = &rest[open + 1..];
    let is_text = inside.iter().all(|token| token.is_space() || token.is_sign('.') || token.word().is_some());
    (is_text && inside.iter().any(says)).then(|| trim_space(&rest[..open]))
}

/// Whether two words are one noun, in the singular or the plural.
fn is_one_noun(one: &str, other: &str) -> bool {
    one == other || one.strip_suffix('s') == Some(other) || other.strip_suffix('s') == Some(one)
}

/// Tokens without the nouns behind their numbers and brackets.
fn without_nouns(tokens: &[Token], nouns: &[&str]) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut rest = tokens;
    while let [token, behind @ ..] = rest {
        let before = trim_space(&out).last();
        let is_counter = before.is_some_and(|last| last.number().is_some() || last.is_sign(')'));
        let mut ahead = rest.iter().filter(|token| !token.is_space());
        let is_noun = |noun: &&str| ahead.next().and_then(Token::word).is_some_and(|word| is_one_noun(word, noun));
        if is_counter && !nouns.is_empty() && !token.is_space() && nouns.iter().all(is_noun) {
            let mut words = 0;
            rest = &rest[rest
                .iter()
                .take_while(|token| {
                    token.is_space() || {
                        words += 1;
                        words <= nouns.len()
                    }
                })
                .count()..];
            continue;
        }
        out.push(match &token.kind {
            TokenKind::Fraction(above, below) => {
                let [above, below] = [above, below].map(|part| without_nouns(part, nouns));
                Token::new(TokenKind::Fraction(above, below), token.span)
            }
            _ => token.clone(),
        });
        rest = behind;
    }
    out
}

fn has_words(tokens: &[Token]) -> bool {
    any(tokens, &|kind| matches!(kind, TokenKind::Word(word) if currency(word).is_none()))
}

fn has_division(tokens: &[Token]) -> bool {
    any(tokens, &|kind| matches!(kind, TokenKind::Fraction(..) | TokenKind::Operator('/' | '⌊' | '⌈')))
}

/// Whether the noun may count something else than the computed side does, or count it up.
fn may_count_otherwise(side: &ChainSide, value: &SideValue, result: f64) -> bool {
    let Ok(computed) = value.number().map(|of| of.point) else { return true };
    let is_worth = |ratio: f64| WORTH.iter().any(|worth| (ratio - worth).abs() <= 1e-9 * worth);
    let divides = has_division(&side.tokens);
    // A part of a whole that another number counts: 1/4 = 13 cards.
    let is_part = divides && computed.abs() < 1.0;
    let is_whole = result.fract() == 0.0 && (computed - result).abs() < 1.0;
    // From one number to another one: pages 5–7 = 3 pages.
    let is_range = computed * result < 0.0 && !divides;
    is_range
        || is_worth(computed / result)
        || is_worth(result / computed)
        || is_part
        || (divides && is_whole && computed != result)
}

/// A chain without what its last side counts, if no other word and no unit is in it and the sides before compute it.
pub(crate) fn without_counted_nouns(chain: &Chain) -> Option<Chain> {
    let (result, nouns) = words_at_end(&chain.sides.last()?.tokens)?;
    let nouns: Vec<&str> = nouns;
    let result = trim_space(result).to_vec();
    let (_, before) = chain.sides.split_last()?;
    let mut sides: Vec<ChainSide> = before
        .iter()
        .map(|side| {
            let tokens = trim_space(&without_nouns(&side.tokens, &nouns)).to_vec();
            let span = if tokens.len() == side.tokens.len() { side.span } else { span_of(&tokens) };
            ChainSide { tokens, span, ..side.clone() }
        })
        .collect();
    let span = span_of(&result);
    sides.push(ChainSide { tokens: result, span, relation: chain.sides.last()?.relation });
    if sides.iter().any(|side| has_number(&side.tokens) && has_words(&side.tokens)) {
        return None;
    }
    // A side with letters says nothing of its own.
    let mut numeric: Vec<&ChainSide> = Vec::new();
    let mut values: Vec<SideValue> = Vec::new();
    for side in sides.iter().filter(|side| has_number(&side.tokens)) {
        if let Ok(value) = evaluate_freely(&side.tokens, None) {
            numeric.push(side);
            values.push(value);
        }
    }
    let (result, computed) = values.split_last()?;
    if numeric.last()?.span != sides.last()?.span {
        return None;
    }
    let number = result.number().ok()?.point;
    let is_result = result.literal == Literal::Number && !computed.is_empty();
    let computes =
        computed.iter().all(|value| value.literal == Literal::No || value.number().is_ok_and(|of| of.point == number));
    let computes = computes && computed.iter().any(|value| value.literal == Literal::No);
    let otherwise = || numeric.iter().zip(computed).any(|(side, value)| may_count_otherwise(side, value, number));
    (is_result && computes && !otherwise()).then(|| Chain { sides, ..chain.clone() })
}
