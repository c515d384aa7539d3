//! Whether the text speaks of numbers that are not reckoned with as usual: remainders, other bases, truth values.

use crate::decimal::parse_decimal;
use crate::effort;
use crate::evaluate::value::SideValue;
use crate::judge::substitution::without_space;
use crate::judge::surroundings::{self, text_around};
use crate::judge::verdict::evaluate_freely;
use crate::token::{Span, Token, TokenKind, any, show};

const WORDS: [&str; 24] = [
    "with a borrow",
    "with borrow",
    "with a carry",
    "with carry",
    "significand",
    "guard bit",
    "overflow",
    "overflows",
    "saturation",
    "uint",
    "boolean",
    "boolesch",
    "boolesche",
    "boolescher",
    "booleana",
    "booleano",
    "xor",
    "binary",
    "octal",
    "hexadecimal",
    "two\u{2019}s complement",
    "two's complement",
    "twos complement",
    "gf(2",
];

/// Words before a base, which is another one unless it is ten.
const BEFORE_BASE: [&str; 2] = ["in base", "(base"];

/// Words before the number of a base.
const BEFORE_OTHER_BASE: [&str; 3] = ["basis ", "to base ", "to the base "];

/// Bases in which numbers are written.
const BASES: std::ops::RangeInclusive<f64> = 2.0..=36.0;

/// Words before a modulus.
const BEFORE_MODULUS: [&str; 4] = ["mod", "pmod", "bmod", "modulo"];

/// The least power of two by which a number of so few bits differs that it has overflowed.
const LEAST_OVERFLOW: f64 = 4.0;

/// Signs of the ring of remainders or a finite field, before its modulus.
const RINGS: [&str; 12] = [
    "mathbb{z}",
    "mathbb z",
    "mathbb{f}",
    "mathbb f",
    "mathbf{z}",
    "mathbf{f}",
    "mathbb{u}",
    "gf(",
    // Commands that a text may have for them.
    "\\z",
    "\\zz",
    "\\f",
    "\\ff",
];

/// Signs of the operations of such a ring and commands with the modulus as their argument, and what stands behind them.
const OPERATIONS: [&str; 8] = ["\\times_", "\\cdot_", "\\otimes_", "\\oplus_", "\\odot_", "+_", "\\zmod{", "\\zn{"];

/// Words before a modulus in words, and words for it.
const IN_WORDS: [(&str, f64); 10] = [
    ("körper mit zwei elementen", 2.0),
    ("corps à deux éléments", 2.0),
    ("field of two elements", 2.0),
    ("field with two elements", 2.0),
    ("field of 2 elements", 2.0),
    ("field with 2 elements", 2.0),
    ("field of three elements", 3.0),
    ("field with three elements", 3.0),
    ("modulo two", 2.0),
    ("modulo three", 3.0),
];

/// Signs that a text writes of the ring of two elements alone.
const OF_TWO: [&str; 2] = ["1+1=0", "1 + 1 = 0"];

/// What ends a paragraph or an item, behind which a modulus in words no longer holds.
const ENDS: [&str; 5] = ["\n\n", "\\item", "<li", "<p", "\\end{"];

/// How far behind two sides a modulus may be named, in bytes.
const NEAR_BEHIND: usize = 400;

/// Differences from here on are not whole in floating point, so that any modulus may explain them.
const INEXACT: f64 = 9.0e15;

/// Whether a sign is one of a field, which the number of its elements may follow without a mark.
fn is_field(sign: &str) -> bool {
    sign.contains('f') && !sign.starts_with('\\')
}

/// Whether differences are not zero, but all of them multiples of a modulus, as far as floating point can tell.
fn are_multiples(differences: &[f64], modulus: f64) -> bool {
    let fits = |of: &f64| of.abs() >= INEXACT || of % modulus == 0.0;
    modulus > 1.0 && differences.iter().any(|of| *of != 0.0) && differences.iter().all(fits)
}

/// Whether a paragraph names the base in which its numbers are written, by words that it does not have for those of a vector space or of a
/// logarithm.
fn names_base(paragraph: &str) -> bool {
    let paragraph = paragraph.to_lowercase();
    let is_base = |behind: &str| number_at(behind).is_some_and(|base| BASES.contains(&base) && base != 10.0);
    let named = |words: &str| paragraph.match_indices(words).any(|(at, _)| is_base(&paragraph[at + words.len()..]));
    !paragraph.contains("log") && BEFORE_OTHER_BASE.iter().any(|words| named(words))
}

/// Whether the text around two sides, or the formula itself, speaks of arithmetic in which they may be equal. If it names a modulus, the
/// differences of their components must be multiples of it.
pub(crate) fn may_explain(text: &str, span: Span, differences: &[f64]) -> bool {
    let (before, after) = text_around(text, span);
    let sentence = before.rsplit(['.', '?', '!']).next().unwrap_or_default();
    let rest = after.split(['.', '?', '!']).next().unwrap_or_default();
    let source = text.get(span.range()).unwrap_or_default();
    let near = format!("{sentence} {source} {rest}").to_ascii_lowercase();
    // Some forty words are looked for.
    effort::count_steps(near.len());
    let places = |word: &'static str| {
        let letter = |c: char| c.is_ascii_alphabetic();
        let near = &near;
        near.match_indices(word).map(move |(at, _)| (at, at + word.len())).filter(move |(at, end)| {
            let open = !word.ends_with(letter) || !near[*end..].starts_with(letter);
            open && !(word.starts_with(letter) && near[..*at].ends_with(letter))
        })
    };
    // What overflows differs by a power of two, unless the digits themselves are bits.
    let may_overflow = || {
        let mut numbers = source.split(|c: char| !c.is_ascii_digit());
        let is_of_bits = |of: &str| of.len() > 2 && of.bytes().all(|c| matches!(c, b'0' | b'1'));
        let no_others = !source.contains(|c: char| ('2'..='9').contains(&c));
        no_others || numbers.any(is_of_bits) || differences.is_empty() || are_multiples(differences, LEAST_OVERFLOW)
    };
    let fits = |word: &str| !(word.contains("complement") || word.starts_with("overflow")) || may_overflow();
    if WORDS.iter().any(|word| fits(word) && places(word).next().is_some()) {
        return true;
    }
    let is_ten = |behind: &str| number_at(behind) == Some(10.0) || behind.starts_with(" ten");
    if { BEFORE_BASE }.iter().flat_map(|words| places(words)).any(|(_, end)| !is_ten(&near[end..])) {
        return true;
    }
    let fits = |modulus: Option<f64>| match modulus {
        // An inverse is an integer there, too.
        Some(modulus) if modulus > 0.0 && !differences.is_empty() && differences.iter().all(|by| by.fract() == 0.0) => {
            are_multiples(differences, modulus)
        }
        _ => true,
    };
    // A ring may be named some sentences before, or behind a display.
    let behind = text.get(span.end as usize..).unwrap_or_default();
    let behind = &behind[..behind.floor_char_boundary(NEAR_BEHIND)];
    let behind = { ENDS }.iter().take(4).filter_map(|end| behind.find(end)).min().map_or(behind, |at| &behind[..at]);
    let before = surroundings::text_before(text, span);
    let paragraph = { ENDS }.iter().filter_map(|end| before.rfind(end)).max().map_or(before, |at| &before[at..]);
    if names_base(paragraph) {
        return true;
    }
    let mut named = named_moduli(before);
    named.extend([paragraph, behind].into_iter().flat_map(moduli_in_words));
    named.extend(named_moduli(behind));
    if named.into_iter().any(|modulus| are_multiples(differences, modulus)) {
        return true;
    }
    // The hours of a clock, the letters of a cipher.
    (places("clock").next().is_some() && are_multiples(differences, 12.0))
        || (places("alphabet").next().is_some() && are_multiples(differences, 26.0))
        || { BEFORE_MODULUS }.iter().flat_map(|word| places(word)).any(|(_, end)| fits(number_at(&near[end..])))
        || { RINGS }.iter().flat_map(|sign| near.match_indices(sign)).any(|(at, sign)| {
            let behind = &near[at + sign.len()..];
            let modulus = behind.strip_prefix('_').or_else(|| behind.strip_prefix('/')).unwrap_or(behind);
            let is_ring = modulus.len() < behind.len() || is_field(sign);
            is_ring && fits(number_at(modulus))
        })
}

/// How far before two sides a text may name the modulus of their remainders, in bytes.
const SECTION: usize = 6000;

/// The least modulus that is looked for so far away; of smaller ones, too many differences are multiples.
const LEAST_FAR: f64 = 5.0;

/// The least number that may be a modulus although the text doesn't call it so.
const LEAST_UNCALLED: f64 = 100.0;

/// Whether the right side may be the remainder of the left one for a modulus that the section names, or, of a power, for any larger number that
/// the example prints: with the key 221, `219^2 = 4`.
pub(crate) fn may_be_remainder(
    text: &str,
    left: &[Token],
    values: Option<&(SideValue, SideValue)>,
    place: Span,
) -> bool {
    let numbers = values.and_then(|(left, right)| left.number().ok().zip(right.number().ok()));
    let Some((value, remainder)) = numbers.map(|(left, right)| (left.point, right.point)) else { return false };
    let fits = |modulus: f64| {
        // Below the modulus, too, if it is the negative one: 162 = −59 for 221.
        let is_reduced = value.abs() >= modulus || remainder < 0.0;
        remainder.abs() < modulus && is_reduced && are_multiples(&[value - remainder], modulus)
    };
    if value.fract() != 0.0 || remainder.fract() != 0.0 || value.abs() < LEAST_FAR {
        return false;
    }
    if moduli_of(section_before(text, place)).into_iter().any(|modulus| modulus >= LEAST_FAR && fits(modulus)) {
        return true;
    }
    let is_power = matches!(without_space(left).as_slice(), [base, Token { kind: TokenKind::Power(_), .. }] if base.number().is_some());
    let example = surroundings::text_before(text, place);
    let numbers = example.split(|c: char| !c.is_ascii_digit() && c != '.').filter_map(parse_decimal);
    is_power && { numbers }.any(|number| number >= LEAST_UNCALLED && fits(number))
}

/// The text of the section before a place.
pub(super) fn section_before(text: &str, place: Span) -> &str {
    let end = (place.start as usize).min(text.len());
    let section = text.get(text.ceil_char_boundary(end.saturating_sub(SECTION))..end).unwrap_or_default();
    effort::count_steps(section.len() / 32);
    section
}

/// The moduli that a section names.
fn moduli_of(section: &str) -> Vec<f64> {
    let mut named = named_moduli(section);
    named.extend(moduli_in_words(section));
    named
}

/// A whole number and its exponent, if a side is nothing else.
fn whole_power(side: &[Token]) -> Option<[f64; 2]> {
    let solid = without_space(side);
    let [base, Token { kind: TokenKind::Power(power), .. }] = solid.as_slice() else { return None };
    let base = base.number().filter(|digits| digits.bytes().all(|c| c.is_ascii_digit())).and_then(parse_decimal)?;
    let power = evaluate_freely(power, None).ok()?.number().ok()?.point;
    (power.fract() == 0.0).then_some([base, power])
}

/// Whether the right side is the inverse of the number on the left for a modulus that the section names, or the power that is it for a prime
/// one: `2^{-1} = 5` modulo 9, `50^{-1} = 50^{59}` modulo 61.
pub(crate) fn is_inverse(text: &str, left: &[Token], right: &[Token], place: Span) -> bool {
    let Some([base, -1.0]) = whole_power(left) else { return false };
    let other = whole_power(right);
    let number = match without_space(right).as_slice() {
        [number] => number.number().and_then(parse_decimal),
        _ => None,
    };
    let fits = |modulus: f64| {
        let is_power = other.is_some_and(|[of, power]| of == base && (power + 1.0) % (modulus - 1.0) == 0.0);
        modulus > 2.0 && (is_power || number.is_some_and(|number| (base * number) % modulus == 1.0))
    };
    (number.is_some() || other.is_some()) && moduli_of(section_before(text, place)).into_iter().any(fits)
}

/// Whether an asterisk in a side is an operation that the example defines: `a * b = 2^{ab}`, or that it names by itself, `$*$`.
pub(crate) fn has_own_operation(text: &str, side: Span) -> bool {
    let has_sign = |source: &str| source.contains('*') || source.contains("\\ast");
    if !text.get(side.range()).is_some_and(has_sign) {
        return false;
    }
    let before = surroundings::text_before(text, side).replace("\\ast", "*");
    let solid: String = before.chars().filter(|c| !c.is_whitespace()).collect();
    let named = ["$*$", "\\(*\\)", "<m>*</m>", "(*)"].iter().any(|sign| solid.contains(sign));
    // With its letters on the right side, too, unlike a product with numbers put in.
    let defined = solid.match_indices('=').take(surroundings::MOST_CALLS).any(|(at, _)| {
        let mut signs = solid[..at].chars().rev();
        let [other, sign, one, before] = [signs.next(), signs.next(), signs.next(), signs.next()];
        let letters = [one, other].map(|letter| letter.filter(char::is_ascii_alphabetic));
        let [Some(one), Some(other)] = letters else { return false };
        let behind = solid[at + 1..].split(['$', '=', '<']).next().unwrap_or_default();
        sign == Some('*')
            && !before.is_some_and(|before| before.is_ascii_alphabetic() || before == '*')
            && behind.contains(one)
            && behind.contains(other)
    });
    named || defined
}

/// Whether bits add to bits where the example speaks of codes of them: `1 + 1 = 0` in each place.
pub(crate) fn are_codewords(text: &str, sides: [&[Token]; 2], differences: &[f64], place: Span) -> bool {
    const WORDS: [&str; 5] = ["hamming", "linear code", "codeword", "code word", "parity"];
    let is_other = |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if !matches!(&**digits, "0" | "1"));
    are_multiples(differences, 2.0)
        && !sides.into_iter().any(|side| any(side, &is_other))
        && any(sides[0], &|kind| *kind == TokenKind::Operator('+'))
        && {
            let example = surroundings::text_before(text, place).to_ascii_lowercase();
            WORDS.iter().any(|word| example.contains(word))
        }
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

/// Whether a side is the exclusive or of two bits, `1^0`, in a section that names this operation, and the other one is a bit.
pub(crate) fn is_exclusive_or(text: &str, left: &[Token], right: &[Token], place: Span) -> bool {
    let bit = |token: &Token| matches!(token.number(), Some("0" | "1"));
    let is_of_bits = match without_space(left).as_slice() {
        [base, Token { kind: TokenKind::Power(power), .. }] => {
            bit(base) && matches!(power.as_slice(), [one] if bit(one))
        }
        _ => false,
    };
    if !is_of_bits || !matches!(without_space(right).as_slice(), [one] if bit(one)) {
        return false;
    }
    section_before(text, place).to_ascii_lowercase().contains("xor")
}

/// The moduli of the rings, fields and groups of units that a text names: 6 of `\mathbb{Z}_6`, 9 of `U(9)`, 13 of `\times_{13}`.
fn named_moduli(text: &str) -> Vec<f64> {
    let lower = text.to_ascii_lowercase();
    let of_rings = { RINGS }.into_iter().flat_map(|sign| lower.match_indices(sign)).filter_map(|(at, sign)| {
        let behind = lower[at + sign.len()..].trim_start_matches('}');
        let behind = behind.strip_prefix("{}").unwrap_or(behind);
        // Behind a comma, ℤ has no modulus.
        let modulus = behind.strip_prefix(['_', '/']);
        // ℤ₂³ has three components, but in braces it would be a power.
        let one_digit = modulus.filter(|of| of.starts_with(|c: char| c.is_ascii_digit())).map(|of| &of[..1]);
        number_at(modulus.or_else(|| is_field(sign).then_some(behind))?).or_else(|| one_digit.and_then(parse_decimal))
    });
    let of_operations = { OPERATIONS }.into_iter().flat_map(|sign| lower.match_indices(sign));
    let of_operations = of_operations.filter_map(|(at, sign)| number_at(&lower[at + sign.len()..]));
    // As signs, with tags before the index.
    let of_signs = { ["𝔽", "ℤ"] }.into_iter().flat_map(|sign| text.match_indices(sign));
    let of_signs = of_signs.filter_map(|(at, sign)| number_at(index_behind(&text[at + sign.len()..])?));
    // Neither SU(2) nor the value U(2) = 5 of a function.
    let of_groups = text.match_indices("U(").take(surroundings::MOST_CALLS).filter_map(|(at, sign)| {
        let (inside, behind) = text[at + sign.len()..].split_once(')')?;
        let equal = behind.trim_start().strip_prefix('=');
        let is_value = equal.is_some_and(|equal| !equal.trim_start_matches([' ', '\\']).starts_with('{'));
        let is_name = text[..at].ends_with(|c: char| c.is_alphanumeric());
        parse_decimal(inside).filter(|_| !is_name && !is_value)
    });
    of_rings.chain(of_operations).chain(of_signs).chain(of_groups).collect()
}

/// The text from an index on that stands at its start, behind a mark or tags.
fn index_behind(text: &str) -> Option<&str> {
    if let Some(index) = text.strip_prefix('_') {
        return Some(index);
    }
    let mut rest = text;
    while let Some((_, behind)) = rest.strip_prefix('<').and_then(|tag| tag.split_once('>')) {
        rest = behind.trim_start();
    }
    (rest.len() < text.len() && rest.starts_with(|c: char| c.is_ascii_digit())).then_some(rest)
}

/// The moduli that a paragraph names in words, or by what holds for them alone.
fn moduli_in_words(text: &str) -> Vec<f64> {
    let lower = text.to_ascii_lowercase();
    let of_words =
        { BEFORE_MODULUS }.into_iter().flat_map(|word| lower.match_indices(word)).filter_map(|(at, word)| {
            let is_word = !lower[..at].ends_with(|c: char| c.is_ascii_alphabetic());
            let behind = &lower[at + word.len()..];
            number_at(behind).or_else(|| number_of_letter(behind, &lower)).filter(|_| is_word)
        });
    let in_words = IN_WORDS.iter().filter(|(words, _)| lower.contains(words)).map(|(_, modulus)| *modulus);
    let of_two = OF_TWO.iter().filter(|sign| lower.contains(**sign)).map(|_| 2.0);
    of_words.chain(in_words).chain(of_two).collect()
}

/// The value that a text in small letters gives to the one letter that follows: 13 for `p` where the text has `p = 13`.
fn number_of_letter(behind: &str, text: &str) -> Option<f64> {
    let behind = behind.trim_start_matches(|c: char| c.is_whitespace() || "{($~".contains(c));
    let letter = behind.get(..1).filter(|of| of.starts_with(|c: char| c.is_ascii_lowercase()))?;
    if behind[1..].starts_with(|c: char| c.is_alphanumeric()) {
        return None;
    }
    let assigned = text.match_indices(letter).filter_map(|(at, _)| {
        let is_part = text[..at].ends_with(|c: char| c.is_alphanumeric() || "\\_^".contains(c));
        let value = text[at + 1..].trim_start().strip_prefix('=')?;
        number_at(value.trim_start()).filter(|_| !is_part)
    });
    assigned.last()
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
        may_explain(text, Span::new(at, at + 1), &[difference])
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
