//! Texts in which a comma parts the decimals: whether a text is one, and its numbers.
//!
//! In one that is, `3,5` is three and a half and `1.000` a thousand, unless it has decimal points, too; in any other, `3,5`
//! are two numbers and `1,000` is a thousand.

use super::{Definitions, RunningText, TextFormat, formulas};
use crate::token::{Token, TokenKind};

/// How the numbers of a text are written.
#[derive(Debug, Default)]
struct SeparatorCounts {
    /// With a comma that cannot part thousands.
    commas: usize,
    /// With one comma before three digits.
    either: usize,
    /// With a point.
    points: usize,
    /// With a point that cannot part thousands.
    decimal_points: usize,
    /// With points before groups of three and a comma behind them.
    thousands: usize,
}

/// What a point is in a text in which commas part the decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DecimalPoints {
    /// It parts thousands: `1.000` is a thousand.
    Thousands,
    /// It parts decimals, too: the text has both.
    Decimals,
}

/// Whether commas part the decimals in a text, and what its points do then.
pub(crate) fn decimal_points(
    text: &str,
    format: TextFormat,
    elsewhere: Option<&Definitions>,
    lines: &RunningText,
) -> Option<DecimalPoints> {
    if !may_be(text) {
        return None;
    }
    let mut seen = SeparatorCounts::default();
    // A text that cannot be read says so when it is read.
    let _ = formulas(text, format, elsewhere, &mut |formula| count_separators(&formula.tokens, text, &mut seen));
    lines.read(&mut |formula| count_separators(&formula.tokens, &lines.text, &mut seen));
    let both = seen.decimal_points > 0 && seen.thousands == 0;
    let points = if both { DecimalPoints::Decimals } else { DecimalPoints::Thousands };
    (seen.commas > 3 * seen.points && 2 * seen.commas >= seen.either).then_some(points)
}

/// Whether a digit, a comma and a digit that are no thousands follow each other anywhere.
fn may_be(text: &str) -> bool {
    let bytes = text.as_bytes();
    text.match_indices(',').any(|(at, _)| {
        let braced = at > 1 && bytes[at - 1] == b'{' && bytes.get(at + 1) == Some(&b'}');
        let (before, behind) = if braced { (at - 2, at + 2) } else { (at.wrapping_sub(1), at + 1) };
        bytes.get(before).is_some_and(u8::is_ascii_digit) && {
            let zero = bytes[before] == b'0' && !bytes.get(before.wrapping_sub(1)).is_some_and(u8::is_ascii_digit);
            let digits = bytes[behind.min(bytes.len())..].iter().take_while(|c| c.is_ascii_digit()).count();
            digits > 0 && (digits != 3 || zero)
        }
    })
}

/// The digits of a number, which may have an exponent or a degree sign behind it.
fn digits(token: &Token) -> Option<&str> {
    match &token.kind {
        TokenKind::Scripts(base, sub, _) if sub.is_empty() => match base.as_slice() {
            [number] => number.number(),
            _ => None,
        },
        _ => token.number(),
    }
}

/// The two numbers around the comma at `at`, if they touch it.
fn parted(tokens: &[Token], at: usize) -> Option<(&str, &str)> {
    let (before, behind) = (tokens.get(at.checked_sub(1)?)?, tokens.get(at + 1)?);
    let (whole, decimals) = (before.number()?, digits(behind)?);
    // Between them is no more than a comma, or one in braces.
    let near = behind.span.start.saturating_sub(before.span.end) <= 3;
    let follows = |at: Option<usize>| at.and_then(|at| tokens.get(at)).is_some_and(|token| token.is_sign(','));
    let number = |at: usize| {
        let signed = tokens.get(at).is_some_and(|token| token.is_sign('-'));
        let dots = |token: &Token| matches!(&token.kind, TokenKind::Unknown(name) if name == "…");
        tokens.get(at + usize::from(signed)).is_some_and(|token| digits(token).is_some() || dots(token))
    };
    // A list, unless the next comma is followed by space. The number before this one may have a sign of its own.
    let signed = at > 1 && tokens[at - 2].is_sign('-');
    let comma = at.checked_sub(2 + usize::from(signed));
    let listed = follows(comma) && comma.and_then(|comma| comma.checked_sub(1)).is_some_and(number)
        || follows(Some(at + 2)) && number(at + 3);
    let plain = |text: &str| text.chars().all(|c| c.is_ascii_digit());
    (tokens[at].is_sign(',') && near && !listed && plain(decimals) && thousands(whole).is_some())
        .then_some((whole, decimals))
}

/// The digits of a whole number with or without points between its thousands.
fn thousands(text: &str) -> Option<String> {
    let mut groups = text.split('.');
    let first = groups.next()?;
    let all = groups.clone().count();
    let fits = all == 0 || ((1..=3).contains(&first.len()) && first != "0" && groups.all(|group| group.len() == 3));
    let digits: String = text.chars().filter(|c| *c != '.').collect();
    (fits && digits.chars().all(|c| c.is_ascii_digit())).then_some(digits)
}

/// Whether a number stands alone in brackets at the end of a row, behind space.
fn is_last_in_brackets(tokens: &[Token], at: usize) -> bool {
    let opens = at > 1 && tokens[at - 1].is_sign('(') && tokens[at - 2].is_space();
    let closes = tokens.get(at + 1).is_some_and(|token| token.is_sign(')'));
    opens && closes && tokens[at + 2..].iter().all(|token| token.is_space() || token.kind == TokenKind::Line)
}

/// Most tokens of a component of a pair.
const LONGEST_COMPONENT: usize = 40;

/// Whether the comma at `at` parts two expressions in brackets that are all of a side, as in `(1-2,1+2) = (-1,3)`.
fn is_pair(tokens: &[Token], at: usize) -> bool {
    let relation =
        |token: Option<&Token>| token.is_none_or(|token| token.is_one_of("=≈∈") || token.kind == TokenKind::Line);
    let solid = |token: &&Token| !token.is_space();
    let (before, behind) = (&tokens[..at], &tokens[at + 1..]);
    let bracket = |token: &Token| token.is_one_of("()[],;");
    let opens = before.iter().rposition(bracket).filter(|open| at - open <= LONGEST_COMPONENT);
    let closes = behind.iter().position(bracket).filter(|close| *close <= LONGEST_COMPONENT);
    let (Some(open), Some(close)) = (opens, closes) else { return false };
    tokens[open].is_one_of("([")
        && behind[close].is_one_of(")]")
        && relation(before[..open].iter().rev().find(solid))
        && relation(behind[close + 1..].iter().find(solid))
}

fn count_separators(tokens: &[Token], text: &str, seen: &mut SeparatorCounts) {
    for (at, token) in tokens.iter().enumerate() {
        match &token.kind {
            TokenKind::Operator(',') if parted(tokens, at).is_some() => {
                let of_macro =
                    |token: &Token| matches!(&token.kind, TokenKind::Unknown(name) if name.starts_with('\\'));
                let signed = usize::from(at > 2 && tokens[at - 2].is_one_of("-+"));
                let opens = at > 1 + signed && {
                    let open = &tokens[at - 2 - signed];
                    open.is_one_of("([{⟨") || of_macro(open)
                };
                let closes = tokens.get(at + 2).is_some_and(|token| token.is_one_of(")]}⟩") || of_macro(token));
                // A pair in brackets may be a point of the plane.
                seen.commas += usize::from(!(opens && closes || is_pair(tokens, at)));
                seen.thousands += usize::from(tokens[at - 1].number().is_some_and(|whole| whole.contains('.')));
            }
            // The number of an equation.
            TokenKind::Number(_) if is_last_in_brackets(tokens, at) => {}
            TokenKind::Number(number) if number.contains('.') => {
                let braced = text.get(token.span.range()).is_some_and(|source| source.contains(','));
                let next_is_comma = tokens.get(at + 1).is_some_and(|token| token.is_sign(','));
                let mut behind = tokens[at + 1..].iter().filter(|token| !token.is_space());
                let is_mantissa = behind.next().is_some_and(|token| token.is_one_of("×·"))
                    && behind.next().is_some_and(|token| digits(token) == Some("10"));
                let is_decimal = thousands(number).is_none() || is_mantissa;
                if braced {
                    seen.commas += 1;
                } else {
                    // What may be a thousand in a text with decimal commas says less.
                    seen.points += usize::from(is_decimal);
                }
                seen.decimal_points += usize::from(!braced && !next_is_comma && is_decimal);
            }
            TokenKind::Number(number) if number.matches(',').count() == 1 => seen.either += 1,
            TokenKind::Scripts(base, _, power) => {
                [base, power].into_iter().for_each(|part| count_separators(part, text, seen))
            }
            _ => token.inner().for_each(|inner| count_separators(inner, text, seen)),
        }
    }
}

/// Makes decimals of what is behind commas.
pub(crate) fn apply_decimal_sign(tokens: &mut Vec<Token>, points: DecimalPoints) {
    let mut at = 0;
    while at < tokens.len() {
        if let Some((whole, decimals)) = parted(tokens, at)
            && let Some(whole) = thousands(whole)
        {
            let number = TokenKind::Number(format!("{whole}.{decimals}"));
            let span = tokens[at - 1].span.join(tokens[at + 1].span);
            let joint = match tokens[at + 1].kind.clone() {
                TokenKind::Scripts(base, sub, sup) => {
                    let inner = base.first().map_or(span, |digits| tokens[at - 1].span.join(digits.span));
                    TokenKind::Scripts(vec![Token::new(number, inner)], sub, sup)
                }
                _ => number,
            };
            tokens.splice(at - 1..at + 2, [Token::new(joint, span)]);
            continue;
        }
        let next_is_comma = tokens.get(at + 1).is_some_and(|token| token.is_sign(','));
        match &mut tokens[at].kind {
            TokenKind::Number(number) if number.matches(',').count() == 1 && !number.contains('.') => {
                *number = number.replace(',', ".");
            }
            TokenKind::Number(number)
                if points == DecimalPoints::Thousands && number.contains('.') && !next_is_comma =>
            {
                if let Some(whole) = thousands(number) {
                    *number = whole;
                }
            }
            kind => kind.lists().into_iter().for_each(|inner| apply_decimal_sign(inner, points)),
        }
        at += 1;
    }
}
