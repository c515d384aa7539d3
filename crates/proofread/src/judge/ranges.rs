//! What is written like a difference or a quotient and names something: ranges of years and codes, addresses of networks.

use crate::evaluate::value::SideValue;
use crate::judge::number_marks::{integer, touch};
use crate::judge::surroundings::{speaks_around, text_before};
use crate::token::{Span, Token};

/// Years of which a range is taken for one whatever its dash is.
const YEARS: std::ops::Range<f64> = 1700.0..2200.0;

/// Whether a side is two years or other numbers with a dash between them: `1914–1918`, `1982-1984`.
pub(crate) fn is_range(text: &str, side: &[Token]) -> bool {
    // In brackets, years belong to the words before them.
    let side = match side {
        [open, years @ .., close] if open.is_sign('(') && close.is_sign(')') => years,
        _ => side,
    };
    let [one, dash, other] = side else { return false };
    let ends = integer(one).zip(integer(other)).map(|(one, other)| [f64::from(one), f64::from(other)]);
    let from_to = ends.is_some_and(|[one, other]| one < other);
    // Of the second year, the first two digits may be left out: 1990-92.
    let digits = [one, other].map(|of| of.number().unwrap_or_default());
    let are_years = digits[0].len() == 4
        && digits[1].len() == 2
        && ["1", "20"].iter().any(|century| digits[0].starts_with(century))
        && digits[0].get(2..).is_some_and(|last| last < digits[1]);
    let are_full_years = from_to && ends.is_some_and(|ends| ends.iter().all(|year| YEARS.contains(year)));
    let source = text.get(dash.span.range());
    dash.is_sign('-') && touch(side) && ((from_to && source == Some("–")) || are_years || are_full_years)
}

/// Whether both sides are ranges that stand for each other: `0-255 = 0-100%`.
pub(crate) fn are_ranges(left: &[Token], right: &[Token]) -> bool {
    let is_range = |side: &[Token]| match side {
        [one, dash, other, unit @ ..] if unit.len() < 2 && unit.iter().all(|of| of.word().is_some()) => {
            let rises = integer(one).zip(integer(other)).is_some_and(|(one, other)| one < other);
            dash.is_sign('-') && touch(&side[..3]) && rises
        }
        _ => false,
    };
    is_range(left) && is_range(right)
}

/// Most bits of a prefix of an address.
const MOST_BITS: u32 = 32;

/// Whether a side is the address of a network with the length of its prefix, `10/8`, in a text that speaks of such addresses.
pub(crate) fn is_network(text: &str, side: &[Token], place: Span) -> bool {
    const WORDS: [&str; 6] = ["subnet", "rfc 1918", "cidr", "ip plan", "ip address", "prefix length"];
    let [address, stroke, bits] = side else { return false };
    let is_prefix = stroke.is_sign('/')
        && touch(side)
        && address.number().is_some()
        && integer(bits).is_some_and(|bits| bits <= MOST_BITS);
    is_prefix
        && (speaks_around(text, place, &WORDS) || {
            let before = text_before(text, place).to_ascii_lowercase();
            WORDS.iter().any(|word| before.contains(word))
        })
}

/// Whether a result is a quotient without its remainder, which the words behind it name: `3 ÷ 2 = 1` remainder 1.
pub(crate) fn has_remainder_behind(text: &str, end: u32, values: Option<&(SideValue, SideValue)>) -> bool {
    const WORDS: [&str; 5] = ["remainder", "with remainder", "rest", "r ", "r."];
    let behind = text.get(end as usize..).unwrap_or_default();
    let behind = behind.trim_start_matches(|c: char| c.is_whitespace() || "$,;`~\\)".contains(c));
    let behind: String = behind.chars().take(20).collect::<String>().to_ascii_lowercase();
    let rest = WORDS.iter().find_map(|word| behind.strip_prefix(word)).unwrap_or_default();
    let rest = rest.trim_start_matches(|c: char| c.is_whitespace() || "$:=of".contains(c));
    let numbers = values.and_then(|(left, right)| left.number().ok().zip(right.number().ok()));
    rest.starts_with(|c: char| c.is_ascii_digit())
        && numbers.is_some_and(|(left, right)| left.point > 0.0 && libm::floor(left.point) == right.point)
}
