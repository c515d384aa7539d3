//! The digits 0 and 1 in a text that speaks of them: numbers in base two, in as many bits as are printed, and truth values.

use crate::judge::binary_numbers::{converted, is_of_bits};
use crate::judge::other_arithmetic::section_before;
use crate::judge::surroundings::text_around;
use crate::judge::verdict::evaluate_freely;
use crate::token::{Span, Token, TokenKind};

/// Words of numbers in base two.
const OF_BINARY: [&str; 17] = [
    "binary",
    "base 2",
    "base two",
    "base-2",
    "base $2$",
    "complement",
    "binari",
    "binär",
    "mantissa",
    "significand",
    "floating point",
    "floating-point",
    "mod 2",
    "modulo 2",
    "sign bit",
    "overflow",
    "-bit",
];

/// Words of truth values, among which any number of ones adds to one.
const OF_TRUTH: [&str; 2] = ["boole", "logic gate"];

/// How much of the start of a document is taken for its title, in bytes.
const TITLE: usize = 200;

/// Whether one of these words stands in the title of a text, in the section before a place or just behind it.
fn speaks_of(text: &str, place: Span, words: &[&str]) -> bool {
    let title = &text[..text.floor_char_boundary(TITLE)];
    let (_, after) = text_around(text, place);
    let near = format!("{title} {} {after}", section_before(text, place)).to_lowercase();
    words.iter().any(|word| near.contains(word))
}

/// The value of a side as a plain number.
fn number(side: &[Token]) -> Option<f64> {
    let value = evaluate_freely(side, None).ok()?;
    (!value.has_unit).then(|| value.number().ok()).flatten().map(|of| of.point)
}

/// Whether a side has no other signs than those of sums and products.
fn adds_and_multiplies(side: &[Token]) -> bool {
    side.iter().all(|token| match token.kind {
        TokenKind::Operator(c) => "+\u{b7}\u{d7}*()".contains(c),
        _ => matches!(token.kind, TokenKind::Number(_) | TokenKind::Space(_)),
    })
}

/// Whether the sides agree as numbers of bits, or as truth values, and the text speaks of these: `1 + 1 = 10`, `0101 - 1001 = 0101 + 0111`,
/// `0.5 = 0.1`.
pub(crate) fn agree(text: &str, left: &[Token], right: &[Token], place: Span) -> bool {
    if !is_of_bits(right) {
        return false;
    }
    let in_two = |side: &[Token]| number(&converted(side));
    let Some(result) = in_two(right) else { return false };
    if !is_of_bits(left) {
        // A decimal fraction and its binary digits.
        let is_alone = matches!(right, [digits] if digits.number().is_some_and(|digits| digits.contains('.')));
        return is_alone && number(left) == Some(result) && speaks_of(text, place, &OF_BINARY);
    }
    let (Some(value), Some(decimal)) = (in_two(left), number(left)) else { return false };
    let digits = || left.iter().chain(right).filter_map(Token::number);
    // More bits than are printed are lost.
    let width = digits().map(str::len).max().unwrap_or(1);
    let is_whole = digits().all(|digits| !digits.contains('.'));
    let wraps = is_whole && (value - result) % libm::exp2(width as f64) == 0.0;
    if (value == result || wraps) && speaks_of(text, place, &OF_BINARY) {
        return true;
    }
    let is_truth = matches!(right, [bit] if matches!(bit.number(), Some("0" | "1")));
    let is_or = is_truth && adds_and_multiplies(left) && digits().all(|digits| digits.len() == 1);
    is_or && decimal.min(1.0) == result && speaks_of(text, place, &OF_TRUTH)
}
