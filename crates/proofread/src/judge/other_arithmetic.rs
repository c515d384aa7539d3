//! Whether the text speaks of numbers that are not reckoned with as usual: remainders, other bases, truth values.

use crate::decimal::parse_decimal;
use crate::judge::surroundings::{self, text_around};
use crate::token::{Span, Token, show};

const WORDS: [&str; 15] = [
    "significand",
    "guard bit",
    "overflow",
    "overflows",
    "saturation",
    "uint",
    "boolean",
    "xor",
    "binary",
    "octal",
    "hexadecimal",
    "two\u{2019}s complement",
    "two's complement",
    "in base",
    "gf(2",
];

/// Words before a modulus.
const BEFORE_MODULUS: [&str; 4] = ["mod", "pmod", "bmod", "modulo"];

/// Signs of the ring of remainders or a finite field, before its modulus.
const RINGS: [&str; 5] = ["mathbb{z}", "mathbb z", "mathbb{f}", "mathbb f", "gf("];

/// Whether the text around two sides, or the formula itself, speaks of arithmetic in which they may be equal. If it names a modulus, their
/// difference must be a multiple of it.
pub(crate) fn may_explain(text: &str, span: Span, difference: Option<f64>) -> bool {
    let (before, after) = text_around(text, span);
    let sentence = before.rsplit(['.', '?', '!']).next().unwrap_or_default();
    let rest = after.split(['.', '?', '!']).next().unwrap_or_default();
    let source = text.get(span.range()).unwrap_or_default();
    let near = format!("{sentence} {source} {rest}").to_ascii_lowercase();
    let places = |word: &'static str| {
        let letter = |c: char| c.is_ascii_alphabetic();
        let near = &near;
        near.match_indices(word).map(move |(at, _)| (at, at + word.len())).filter(move |(at, end)| {
            let open = !word.ends_with(letter) || !near[*end..].starts_with(letter);
            open && !(word.starts_with(letter) && near[..*at].ends_with(letter))
        })
    };
    if WORDS.iter().any(|word| places(word).next().is_some()) {
        return true;
    }
    let fits = |modulus: Option<f64>| match (modulus, difference) {
        // An inverse is an integer there, too.
        (Some(modulus), Some(difference)) if modulus > 0.0 && difference.fract() == 0.0 => difference % modulus == 0.0,
        _ => true,
    };
    // A ring may be named some sentences before.
    let is_multiple = |difference: f64| {
        let fits = |modulus: f64| modulus > 1.0 && difference != 0.0 && difference % modulus == 0.0;
        named_moduli(surroundings::text_before(text, span)).into_iter().any(fits)
    };
    if difference.is_some_and(is_multiple) {
        return true;
    }
    // The hours of a clock.
    (places("clock").next().is_some() && difference.is_some_and(|by| by % 12.0 == 0.0))
        || { BEFORE_MODULUS }.iter().flat_map(|word| places(word)).any(|(_, end)| fits(number_at(&near[end..])))
        || { RINGS }.iter().flat_map(|sign| near.match_indices(sign)).any(|(at, sign)| {
            let behind = &near[at + sign.len()..];
            let modulus = behind.strip_prefix('_').or_else(|| behind.strip_prefix('/')).unwrap_or(behind);
            let is_ring = modulus.len() < behind.len() || sign == "gf(" || sign.contains('f');
            is_ring && fits(number_at(modulus))
        })
}

/// Whether two sides are what holds among truth values and remainders, or is often printed because it is false, if the text speaks of
/// what is true: 1 + 1 = 0, 1 + 1 = 1, 2 + 2 = 5.
pub(crate) fn is_proverbial(left: &[Token], right: &[Token], speaks_of_truth: impl FnOnce() -> bool) -> bool {
    let digits = |side: &[Token]| show(side).replace(' ', "");
    match (&*digits(left), &*digits(right)) {
        ("1+1", "0") => true,
        ("1+1", "1" | "3") | ("2+2", "5") | ("5", "2+2") => speaks_of_truth(),
        _ => false,
    }
}

/// The moduli of the rings, fields and groups of units that a text names: 6 of `\mathbb{Z}_6`, 9 of `U(9)`.
fn named_moduli(text: &str) -> Vec<f64> {
    if !["mathbb", "GF(", "U("].iter().any(|sign| text.contains(sign)) {
        return Vec::new();
    }
    let lower = text.to_ascii_lowercase();
    let of_rings = { RINGS }.into_iter().flat_map(|sign| lower.match_indices(sign)).filter_map(|(at, sign)| {
        let behind = lower[at + sign.len()..].trim_start_matches('}');
        // Behind a comma, ℤ has no modulus.
        let modulus = behind.strip_prefix(['_', '/']);
        number_at(modulus.or_else(|| sign.contains('f').then_some(behind))?)
    });
    // Neither SU(2) nor the value U(2) = 5 of a function.
    let of_groups = text.match_indices("U(").take(surroundings::MOST_CALLS).filter_map(|(at, sign)| {
        let (inside, behind) = text[at + sign.len()..].split_once(')')?;
        let equal = behind.trim_start().strip_prefix('=');
        let is_value = equal.is_some_and(|equal| !equal.trim_start_matches([' ', '\\']).starts_with('{'));
        let is_name = text[..at].ends_with(|c: char| c.is_alphanumeric());
        parse_decimal(inside).filter(|_| !is_name && !is_value)
    });
    of_rings.chain(of_groups).collect()
}

/// The number that follows, in braces, brackets or marks of a formula; none if something else does, or a power.
fn number_at(text: &str) -> Option<f64> {
    let text = text.trim_start_matches(|c: char| c.is_whitespace() || "{}()$\\~,:;".contains(c));
    let length = text.chars().take_while(char::is_ascii_digit).count();
    let digits = text.get(..length).filter(|_| !text[length..].starts_with('^'))?;
    parse_decimal(digits)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn explains(text: &str, difference: f64) -> bool {
        let at = text.find('=').expect("a formula");
        may_explain(text, Span::new(at, at + 1), Some(difference))
    }

    #[test]
    fn a_modulus_explains_its_multiples_alone() {
        for (text, modulus) in [
            ("modulo $7$ it is =", 7.0),
            ("= \\pmod{10}", 10.0),
            ("In $\\mathbb{Z}_{12}$, =", 12.0),
            ("over $\\mathbb F_{23}$: =", 23.0),
            ("On the clock, =", 12.0),
        ] {
            assert!(explains(text, 3.0 * modulus) && !explains(text, 3.0 * modulus + 1.0), "{text}");
        }
        assert!(explains("modulo $n$ it is =", 5.0) && explains("in binary, =", 5.0));
        assert!(!explains("the model =", 5.0) && !explains("$x \\in \\mathbb{Z}$ and =", 5.0));
    }
}
