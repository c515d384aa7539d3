//! Texts in which a comma parts the decimals: whether a text is one, and its numbers.
//!
//! In one that is, `3,5` is three and a half and `1.000` a thousand, unless it has decimal points, too; in any other, `3,5`
//! are two numbers and `1,000` is a thousand.
//!
//! In MathML the parts of a number are often elements of their own, and programs that make it out of TeX leave out the space of a list:
//! `3,5` and `3, 5` are both `<mn>3</mn><mo>,</mo><mn>5</mn>`. Such commas part decimals only if something else says so: one
//! without tags around it, or one that no list of integers has, as in `3,06`.

use super::{Definitions, RunningText, TextFormat, formulas};
use crate::token::{Token, TokenKind, UNDECIDED_COMMA};

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
    /// With a comma among tags.
    loose: usize,
    /// With a comma that says by itself that it parts decimals: among tags, one of which no list has the like.
    sure: usize,
}

/// What a point is in a text in which commas part the decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DecimalPoints {
    /// It parts thousands: `1.000` is a thousand.
    Thousands,
    /// It parts decimals, too: the text has both.
    Decimals,
}

/// What a comma between digits is in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CommaMeaning {
    /// It parts decimals, and points mean this.
    Decimal(DecimalPoints),
    /// It parts numbers.
    Separator,
    /// Among tags it may be either, and elsewhere it parts numbers.
    Undecided,
}

/// Whether commas part the decimals in a text, and what its points do then.
pub(crate) fn comma_meaning(
    text: &str,
    format: TextFormat,
    elsewhere: Option<&Definitions>,
    lines: &RunningText,
) -> CommaMeaning {
    if !may_be(text) {
        return CommaMeaning::Separator;
    }
    let mut seen = SeparatorCounts::default();
    // A text that cannot be read says so when it is read.
    let _ = formulas(text, format, elsewhere, &mut |formula| {
        count_separators(&formula.tokens, text, false, &mut seen);
    });
    lines.read(&mut |formula| count_separators(&formula.tokens, &lines.text, false, &mut seen));
    let both = seen.decimal_points > 0 && seen.thousands == 0;
    let points = if both { DecimalPoints::Decimals } else { DecimalPoints::Thousands };
    match seen.commas > 3 * seen.points && 2 * seen.commas >= seen.either {
        true if seen.sure > 0 => CommaMeaning::Decimal(points),
        _ if seen.loose > 0 && seen.points == 0 => CommaMeaning::Undecided,
        _ => CommaMeaning::Separator,
    }
}

/// Longest stretch of tags between the parts of a number, in bytes.
const LONGEST_TAGS: usize = 400;

/// What is between two numbers of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CommaGap {
    /// A comma, or one in braces, or one that is said to be no separator.
    Tight,
    /// A comma among tags.
    Loose,
}

/// What is between these bytes of a text, if it is a comma and nothing else that is printed.
fn gap(text: &str, start: u32, end: u32) -> Option<CommaGap> {
    let length = end.saturating_sub(start) as usize;
    if length <= 3 {
        return Some(CommaGap::Tight);
    }
    let mut rest = text.get(start as usize..end as usize).filter(|gap| gap.len() <= LONGEST_TAGS)?;
    let mut printed = String::new();
    // MathML has a name for it.
    let is_no_separator = rest.contains("separator=\"false\"");
    while let Some((before, tag)) = rest.split_once('<') {
        printed += before.trim();
        rest = tag.split_once('>')?.1;
    }
    printed += rest.trim();
    matches!(printed.as_str(), "," | "&#44;" | "&#x2c;" | "&#x2C;" | "&comma;").then_some(if is_no_separator {
        CommaGap::Tight
    } else {
        CommaGap::Loose
    })
}

/// Whether a digit, a comma and a digit that are no thousands follow each other anywhere.
fn may_be(text: &str) -> bool {
    let bytes = text.as_bytes();
    let entities = ["&#44;", "&#x2c;", "&#x2C;", "&comma;"];
    entities.iter().any(|entity| text.contains(entity))
        || text.match_indices(',').any(|(at, _)| {
            let is_edge =
                |at: usize, sign: u8| bytes.get(at).is_some_and(|byte| *byte == sign || byte.is_ascii_whitespace());
            if is_edge(at.wrapping_sub(1), b'>') && is_edge(at + 1, b'<') {
                return is_between_leaves(bytes, at);
            }
            let braced = at > 1 && bytes[at - 1] == b'{' && bytes.get(at + 1) == Some(&b'}');
            let (before, behind) = if braced { (at - 2, at + 2) } else { (at.wrapping_sub(1), at + 1) };
            bytes.get(before).is_some_and(u8::is_ascii_digit) && {
                let zero = bytes[before] == b'0' && !bytes.get(before.wrapping_sub(1)).is_some_and(u8::is_ascii_digit);
                let digits = bytes[behind.min(bytes.len())..].iter().take_while(|c| c.is_ascii_digit()).count();
                digits > 0 && (digits != 3 || zero)
            }
        })
}

/// Whether the comma at this byte is all of an element, and digits end and begin those around it.
fn is_between_leaves(bytes: &[u8], at: usize) -> bool {
    let printed = |mut bytes: &mut dyn Iterator<Item = &u8>, [opens, closes]: [u8; 2]| {
        let mut in_tag = false;
        (&mut bytes)
            .take(LONGEST_TAGS)
            .find(|byte| {
                let is_printed = !in_tag && **byte != opens && !byte.is_ascii_whitespace();
                in_tag = (in_tag || **byte == opens) && **byte != closes;
                is_printed
            })
            .is_some_and(u8::is_ascii_digit)
    };
    printed(&mut bytes[..at].iter().rev(), [b'>', b'<']) && printed(&mut bytes[at + 1..].iter(), [b'<', b'>'])
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

/// The two numbers around the comma at `at`, if nothing else is between them, and how it stands there.
fn parted<'t>(tokens: &'t [Token], at: usize, text: &str) -> Option<(&'t str, &'t str, CommaGap)> {
    let (before, behind) = (tokens.get(at.checked_sub(1)?)?, tokens.get(at + 1)?);
    let (whole, decimals) = (before.number()?, digits(behind)?);
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
    let fits = tokens[at].is_sign(',') && !listed && plain(decimals) && thousands(whole).is_some();
    let gap = fits.then(|| gap(text, before.span.end, behind.span.start)).flatten()?;
    Some((whole, decimals, gap))
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

/// Whether the comma at `at` parts two sums in brackets that are all of a side, as in `(2+2,1+1)`.
fn is_computed_pair(tokens: &[Token], at: usize) -> bool {
    let signed = |at: Option<usize>| at.and_then(|at| tokens.get(at)).is_some_and(|token| token.is_one_of("+-"));
    signed(at.checked_sub(2)) && signed(Some(at + 2)) && is_pair(tokens, at)
}

/// Whether a comma among tags parts decimals for sure: what is between the bars of a fraction or under a root is no list, no
/// integer begins with a nought, and one is seldom added or multiplied.
fn is_decimal_for_sure(tokens: &[Token], at: usize, [whole, decimals]: [&str; 2], is_argument: bool) -> bool {
    let operates = at > 1 && tokens[at - 2].is_one_of("+-·×/");
    is_argument
        || (decimals.len() > 1 && decimals.starts_with('0'))
        || (whole == "0" && (operates || decimals.len() > 2))
}

/// Whether the digits around a comma may be a number with thousands.
fn may_be_thousands(whole: &str, decimals: &str) -> bool {
    decimals.len() == 3 && whole != "0"
}

/// Counts the comma at `at`, if it may part decimals.
fn count_comma(tokens: &[Token], at: usize, text: &str, is_argument: bool, seen: &mut SeparatorCounts) {
    let Some((whole, decimals, gap)) = parted(tokens, at, text) else { return };
    let is_loose = gap == CommaGap::Loose;
    // Among tags three digits may be thousands, too.
    if is_loose && may_be_thousands(whole, decimals) {
        (seen.either, seen.loose) = (seen.either + 1, seen.loose + 1);
        return;
    }
    let of_macro = |token: &Token| matches!(&token.kind, TokenKind::Unknown(name) if name.starts_with('\\'));
    let signed = usize::from(at > 2 && tokens[at - 2].is_one_of("-+"));
    // Space ends the name of a macro for a bracket.
    let solid = |token: &&Token| !token.is_space();
    let before = tokens.get(..(at - 1).saturating_sub(signed)).unwrap_or_default();
    let opens = before.iter().rev().find(solid).is_some_and(|open| open.is_one_of("([{⟨") || of_macro(open));
    let closes = tokens[at + 2..].iter().find(solid).is_some_and(|close| close.is_one_of(")]}⟩") || of_macro(close));
    // A pair in brackets may be a point of the plane.
    if !(opens && closes || is_pair(tokens, at)) {
        let is_sure = !is_loose || is_decimal_for_sure(tokens, at, [whole, decimals], is_argument);
        seen.commas += 1;
        seen.loose += usize::from(is_loose);
        seen.sure += usize::from(is_sure);
    }
    seen.thousands += usize::from(whole.contains('.'));
}

/// Counts how the numbers are written; `is_argument` says that the tokens are all of what is in a fraction or under a root.
fn count_separators(tokens: &[Token], text: &str, is_argument: bool, seen: &mut SeparatorCounts) {
    let is_argument =
        is_argument && !tokens.iter().any(|token| token.is_one_of("([{;=") || token.kind == TokenKind::Line);
    // A set is a list, also where it has an exponent: {0,1}^n.
    let mut in_sets = 0usize;
    for (at, token) in tokens.iter().enumerate() {
        let closes = |token: &Token| token.is_sign('}');
        let is_end = closes(token) || matches!(&token.kind, TokenKind::Scripts(base, ..) if base.iter().any(closes));
        in_sets = if is_end { in_sets.saturating_sub(1) } else { in_sets + usize::from(token.is_sign('{')) };
        match &token.kind {
            TokenKind::Operator(',') if in_sets > 0 => {}
            TokenKind::Operator(',') => count_comma(tokens, at, text, is_argument, seen),
            // The number of an equation.
            TokenKind::Number(_) if is_last_in_brackets(tokens, at) => {}
            TokenKind::Number(number) if number.contains('.') => {
                let source = text.get(token.span.range()).unwrap_or_default();
                let braced = source.contains(',') && !number.contains(',');
                let next_is_comma = tokens.get(at + 1).is_some_and(|token| token.is_sign(','));
                let mut behind = tokens[at + 1..].iter().filter(|token| !token.is_space());
                let is_mantissa = behind.next().is_some_and(|token| token.is_one_of("×·"))
                    && behind.next().is_some_and(|token| digits(token) == Some("10"));
                let is_decimal = thousands(number).is_none() || is_mantissa;
                if braced {
                    (seen.commas, seen.sure) = (seen.commas + 1, seen.sure + 1);
                } else {
                    // What may be a thousand in a text with decimal commas says less.
                    seen.points += usize::from(is_decimal);
                }
                seen.decimal_points += usize::from(!braced && !next_is_comma && is_decimal);
            }
            TokenKind::Number(number) if number.matches(',').count() == 1 => seen.either += 1,
            TokenKind::Scripts(base, _, power) => {
                [base, power].into_iter().for_each(|part| count_separators(part, text, false, seen))
            }
            TokenKind::Fraction(..) | TokenKind::Root(..) => {
                token.inner().for_each(|inner| count_separators(inner, text, true, seen))
            }
            _ => token.inner().for_each(|inner| count_separators(inner, text, false, seen)),
        }
    }
}

/// Puts what says so in the place of commas among tags that may part decimals or numbers.
pub(crate) fn mark_undecided(tokens: &mut [Token], text: &str) {
    for at in 0..tokens.len() {
        // Three digits are taken for thousands, as everywhere in a text without decimal commas.
        let is_open = matches!(parted(tokens, at, text), Some((whole, decimals, CommaGap::Loose)) if !may_be_thousands(whole, decimals));
        if is_open && !is_pair(tokens, at) {
            tokens[at] = Token::new(TokenKind::Unknown(UNDECIDED_COMMA.to_owned()), tokens[at].span);
        }
        tokens[at].kind.lists().into_iter().for_each(|inner| mark_undecided(inner, text));
    }
}

/// Makes decimals of what is behind commas.
pub(crate) fn apply_decimal_sign(tokens: &mut Vec<Token>, text: &str, points: DecimalPoints) {
    let mut at = 0;
    while at < tokens.len() {
        if let Some((whole, decimals, _)) = parted(tokens, at, text)
            && let Some(whole) = thousands(whole)
            && !(is_computed_pair(tokens, at))
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
        let span = tokens[at].span;
        match &mut tokens[at].kind {
            TokenKind::Number(number) if number.matches(',').count() == 1 && !number.contains('.') => {
                *number = number.replace(',', ".");
            }
            TokenKind::Number(number)
                if points == DecimalPoints::Thousands && number.contains('.') && !next_is_comma =>
            {
                // Where a comma is in the source, it has been taken for the sign of decimals.
                let is_comma = text.get(span.range()).is_some_and(|source| source.contains(','));
                if let Some(whole) = thousands(number).filter(|_| !is_comma) {
                    *number = whole;
                }
            }
            kind => kind.lists().into_iter().for_each(|inner| apply_decimal_sign(inner, text, points)),
        }
        at += 1;
    }
}
