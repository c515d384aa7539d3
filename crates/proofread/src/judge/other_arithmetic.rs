//! Whether the text speaks of numbers that are not reckoned with as usual: remainders, other bases, truth values.

use crate::decimal::parse_decimal;
use crate::judge::surroundings::{self, text_around};
use crate::token::Span;

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
    // A ring may be named some sentences before, with its modulus or as its group of units.
    let far = surroundings::text_before(text, span);
    let far = if ["mathbb", "GF(", "U("].iter().any(|sign| far.contains(sign)) {
        far.to_ascii_lowercase()
    } else {
        String::new()
    };
    let named = |difference: f64| {
        let signs = { RINGS }.into_iter().chain(["u("]).flat_map(|sign| far.match_indices(sign));
        let moduli = signs.filter_map(|(at, sign)| {
            let behind = far[at + sign.len()..].trim_start_matches('}');
            number_at(behind.strip_prefix(['_', '/']).unwrap_or(behind).trim_start_matches(r"n\mathbb z"))
        });
        { moduli }.any(|modulus| modulus > 1.0 && difference != 0.0 && difference % modulus == 0.0)
    };
    if difference.is_some_and(named) {
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
