//! Arrows behind a result: they lead to the other end of a range, or to a rounder number, which takes nothing from the result.

use crate::decimal::parse_decimal;
use crate::evaluate::printed::power_of_ten;
use crate::judge::surroundings::text_behind;
use crate::token::Span;

/// Whether an arrow behind a place leads to another number, as in a range or a rounder one: `0.5 --> 1.49`.
pub(crate) fn goes_on_with_arrow(text: &str, span: Span) -> bool {
    let rest = text_behind(text, span).trim_start();
    let arrows = ["-->", "->", "→", "\\to ", "\\rightarrow "];
    let next = arrows.iter().find_map(|arrow| rest.strip_prefix(arrow));
    next.is_some_and(|next| {
        let next = next.trim_start();
        let next = next.strip_prefix("about ").unwrap_or(next);
        next.starts_with(|c: char| c.is_ascii_digit()) && !is_rounder(text.get(span.range()).unwrap_or_default(), next)
    })
}

/// Whether the number at the start of a text is another one rounded, cut off or in per cent.
fn is_rounder(number: &str, text: &str) -> bool {
    let end = text.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(text.len());
    let (digits, behind) = text.split_at(end);
    let digits = digits.trim_end_matches('.');
    let decimals = |of: &str| of.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let Some((number, next)) = parse_decimal(number).zip(parse_decimal(digits)) else { return false };
    let is_percent = behind.trim_start_matches([' ', '\\']).starts_with('%');
    let last_place = power_of_ten(-(decimals(digits) as f64));
    let number = if is_percent { 100.0 * number } else { number };
    (is_percent || decimals(digits) < MOST_ROUNDED) && (number - next).abs() < last_place
}

/// Decimals from which on a number behind an arrow is hardly a rounder one.
const MOST_ROUNDED: usize = 2;
