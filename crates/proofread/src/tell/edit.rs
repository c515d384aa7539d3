//! Edits of one place: what a side may have been before a slip.

use crate::decimal::parse_decimal;
use crate::evaluate::exponent::plain_exponent;
use crate::join::chain::ChainSide;
use crate::token::{Span, Token, TokenKind, show};
use crate::unit::unit;
use std::ops::ControlFlow;

/// What kind of slip an edit takes back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EditKind {
    /// A comma for a point, or a point for a comma: no digit differs. `true` if the digits end with a zero, as thousands do.
    Comma(bool),
    /// The caret of a power of ten is lacking.
    Caret,
    /// The sign of a whole side.
    Sign,
    /// A factor 2 of a whole side.
    Factor,
    /// The sign of a power of ten.
    ExponentSign,
    /// So many steps of a power of ten.
    Exponent(u32),
    /// A step of another exponent.
    OtherExponent,
    /// A square or a cube of a unit.
    UnitPower,
    /// The square of a bracket.
    Square,
    /// A square that belongs to the whole bracket.
    OutsideBracket,
    /// The point is so many places off.
    Shift(u32),
    /// The prefix of a unit.
    Prefix,
    /// One digit is another one.
    Digit,
    /// Two neighbouring digits are swapped.
    Swap,
    /// A zero, or one of two like digits, is lacking.
    Lost,
    /// Another digit is lacking.
    LostAny,
    /// A zero too many, or a digit twice.
    Extra,
    /// Another digit too many.
    ExtraAny,
    /// Plus for minus, or minus for plus.
    PlusMinus,
}

impl EditKind {
    /// Whether it changes a number by a power of ten.
    pub(crate) fn is_of_size(self) -> bool {
        matches!(self, Self::Caret | Self::ExponentSign | Self::Exponent(_) | Self::Shift(_) | Self::Comma(_))
    }
}

/// A side with a slip taken back.
pub(crate) struct Edit {
    pub tokens: Vec<Token>,
    pub kind: EditKind,
    /// What to change, in words.
    pub words: String,
    pub at: Span,
}

/// Takes edits one at a time, and says when it has enough of them. Each has a copy of its side.
pub(crate) type Tries<'t> = dyn FnMut(Edit) -> ControlFlow<()> + 't;

fn number(text: String, span: Span) -> Token {
    Token::new(TokenKind::Number(text), span)
}

/// Edits of a side as a whole: its sign and a factor 2. Which of the two sides is wrong, they leave open.
pub(crate) fn whole_side(side: &ChainSide, tries: &mut Tries<'_>) -> ControlFlow<()> {
    let group = |before: &[TokenKind], after: &[TokenKind]| {
        let token = |kind: &TokenKind| Token::new(kind.clone(), side.span);
        let mut tokens: Vec<Token> = before.iter().map(token).collect();
        tokens.push(Token::new(TokenKind::Operator('('), side.span));
        tokens.extend(side.tokens.iter().cloned());
        tokens.push(Token::new(TokenKind::Operator(')'), side.span));
        tokens.extend(after.iter().map(token));
        tokens
    };
    let two = TokenKind::Number("2".to_owned());
    let mut push = |tokens: Vec<Token>, kind: EditKind, words: &str| {
        tries(Edit { tokens, kind, words: format!("{words} on one of the two sides"), at: side.span })
    };
    push(group(&[two.clone(), TokenKind::Operator('·')], &[]), EditKind::Factor, "a factor 2")?;
    push(group(&[], &[TokenKind::Operator('/'), two]), EditKind::Factor, "a factor 2")?;
    push(group(&[TokenKind::Operator('-')], &[]), EditKind::Sign, "the opposite sign")
}

fn truncate(text: &str) -> String {
    if text.chars().count() <= 40 {
        return text.to_owned();
    }
    text.chars().take(39).chain(['…']).collect()
}

/// Tries all lists of tokens that differ in one place; of a `result`, any digit may be lost.
pub(crate) fn variants(tokens: &[Token], result: bool, tries: &mut Tries<'_>) -> ControlFlow<()> {
    for (at, token) in tokens.iter().enumerate() {
        let with = |new: Vec<Token>, taken: usize| {
            let mut all = tokens[..at].to_vec();
            all.extend(new);
            all.extend_from_slice(&tokens[at + taken..]);
            all
        };
        let span = token.span;
        let mut push =
            |kind: EditKind, tokens: Vec<Token>, words: String| tries(Edit { tokens, kind, words, at: span });
        let is_raised = tokens.get(at + 1).is_some_and(|next| matches!(next.kind, TokenKind::Power(_)));
        match &token.kind {
            // Decimals that go on are not printed digit by digit.
            TokenKind::Number(text) if text.ends_with('…') || text.len() > LONGEST_NUMBER => {}
            TokenKind::Number(text) => {
                if let Some(exponent) = without_caret(tokens, at) {
                    let words = format!("`10^{0}` for `10{0}`", show(exponent));
                    let power =
                        Token::new(TokenKind::Power(exponent.to_vec()), exponent[0].span.join(exponent[1].span));
                    push(EditKind::Caret, with(vec![token.clone(), power], 3), words)?;
                }
                let is_ten = text == "10" && tokens.get(at + 1).and_then(exponent_of).is_some();
                let mut offered: Vec<String> = Vec::new();
                for (kind, other) in misprints(text, result).into_iter().filter(|_| !is_ten) {
                    if other != *text && !offered.contains(&other) {
                        // Zeros at the end of a result are open, and would let another integer pass.
                        let open = result && other.ends_with('0') && !other.contains('.');
                        let exact = if open { format!("{other}.") } else { other.clone() };
                        push(kind, with(vec![number(exact, span)], 1), format!("`{other}` for `{text}`"))?;
                        offered.push(other);
                    }
                }
            }
            // The sign before a printed result is the sign of the whole side.
            TokenKind::Operator(sign @ ('+' | '-')) if at > 0 || !result => {
                let other = if *sign == '+' { '-' } else { '+' };
                let name = |sign: char| if sign == '-' { '−' } else { sign };
                let place = tokens_around(tokens, at);
                let words = format!("`{}` for `{}` in `{place}`", name(other), name(*sign));
                push(EditKind::PlusMinus, with(vec![Token::new(TokenKind::Operator(other), span)], 1), words)?;
            }
            TokenKind::Power(_) => powers(tokens, at, tries)?,
            TokenKind::Word(word) if unit(word).is_some() && !matches!(word.as_str(), "°" | "%" | "rad") => {
                for power in ["2", "3"].into_iter().filter(|_| !is_raised) {
                    let exponent = Token::new(TokenKind::Power(vec![number(power.to_owned(), span)]), span);
                    push(
                        EditKind::UnitPower,
                        with(vec![token.clone(), exponent], 1),
                        format!("`{word}^{power}` for `{word}`"),
                    )?;
                }
                for other in other_prefixes(word) {
                    let words = format!("`{other}` for `{word}`");
                    push(EditKind::Prefix, with(vec![Token::new(TokenKind::Word(other), span)], 1), words)?;
                }
            }
            TokenKind::Operator(')') if !is_raised => {
                let squared =
                    vec![token.clone(), Token::new(TokenKind::Power(vec![number("2".to_owned(), span)]), span)];
                let words = format!("the square of `{}`", truncate(&show(&bracketed_tokens(tokens, at))));
                push(EditKind::Square, with(squared, 1), words)?;
            }
            _ => {}
        }
        nested_variants(tokens, at, tries)?;
    }
    ControlFlow::Continue(())
}

/// A unit with each of the other common prefixes.
fn other_prefixes(word: &str) -> Vec<String> {
    const PREFIXES: [&str; 8] = ["", "k", "m", "c", "μ", "n", "M", "G"];
    let bare = |prefix: &&str| {
        let base = word.strip_prefix(*prefix)?;
        let (of_base, own) = (unit(base)?, unit(word)?);
        let is_prefixed = prefix.is_empty() || of_base.dimension == own.dimension && base != word;
        (is_prefixed && base.chars().count() <= 3).then_some(base)
    };
    // A base without a prefix is the shortest one.
    let base = PREFIXES.iter().filter_map(bare).min_by_key(|base| base.len());
    let own = unit(word);
    let others = base.into_iter().flat_map(|base| PREFIXES.iter().map(move |prefix| [prefix, base].concat()));
    let fits = |other: &String| {
        other != word && unit(other).zip(own).is_some_and(|(other, own)| other.dimension == own.dimension)
    };
    others.filter(fits).collect()
}

/// What a number may have been before it was misprinted.
fn misprints(text: &str, result: bool) -> Vec<(EditKind, String)> {
    let all = |kind: EditKind, of: Vec<String>| of.into_iter().map(move |other| (kind, other));
    let mut out: Vec<(EditKind, String)> = all(EditKind::Comma(text.ends_with('0')), commas(text)).collect();
    out.extend(shifted(text).into_iter().map(|(places, other)| (EditKind::Shift(places), other)));
    // A one is hardly ever misprinted, but often there for show.
    if text != "1" {
        out.extend(all(EditKind::Swap, swapped(text)));
        out.extend(all(EditKind::Digit, digits(text)));
        out.extend(without_digit(text));
        out.extend(lost_digit(text, result));
    }
    out
}

/// The number without one of its digits.
fn without_digit(text: &str) -> Vec<(EditKind, String)> {
    let bytes = text.as_bytes();
    let places = text.char_indices().filter(|(_, c)| c.is_ascii_digit()).take(12);
    let without = places.map(|(at, digit)| {
        let is_double = [at.wrapping_sub(1), at + 1].iter().any(|near| bytes.get(*near) == Some(&bytes[at]));
        let kind = if digit == '0' || is_double { EditKind::Extra } else { EditKind::ExtraAny };
        (kind, [&text[..at], &text[at + 1..]].concat())
    });
    // 1.6 for 1.60 is the same number.
    let value = |text: &str| parse_decimal(&text.replace(',', ""));
    without.filter(|(_, other)| is_number(other) && value(other) != value(text)).collect()
}

/// The number with one digit more: a zero or a neighbour's double, and in a result any digit.
fn lost_digit(text: &str, result: bool) -> Vec<(EditKind, String)> {
    let mut out = Vec::new();
    let bytes = text.as_bytes();
    for at in 0..=text.len().min(12) {
        let near = [at.checked_sub(1), Some(at)].into_iter().flatten().filter_map(|at| bytes.get(at));
        let near: Vec<char> = near.map(|byte| char::from(*byte)).filter(char::is_ascii_digit).collect();
        if near.is_empty() {
            continue;
        }
        for digit in ('0'..='9').filter(|digit| result || *digit == '0' || near.contains(digit)) {
            let other = format!("{}{digit}{}", &text[..at], &text[at..]);
            let kind = if digit == '0' || near.contains(&digit) { EditKind::Lost } else { EditKind::LostAny };
            if is_number(&other) {
                out.push((kind, other));
            }
        }
    }
    out
}

/// Whether digits are a number as it would be printed: with no zero in front, and with one digit that is none.
fn is_number(text: &str) -> bool {
    let leads = text.starts_with('0') && text.as_bytes().get(1).is_some_and(u8::is_ascii_digit);
    !leads
        && !text.starts_with(['.', ','])
        && !text.ends_with(['.', ','])
        && text.contains(|c| ('1'..='9').contains(&c))
}

/// The brackets that end at `at`, with what is in them.
fn bracketed_tokens(tokens: &[Token], at: usize) -> Vec<Token> {
    let mut depth = 0i32;
    for start in (0..=at).rev() {
        depth += i32::from(tokens[start].is_one_of(")]")) - i32::from(tokens[start].is_one_of("(["));
        if depth == 0 {
            return tokens[start..=at].to_vec();
        }
    }
    tokens[..=at].to_vec()
}

fn tokens_around(tokens: &[Token], at: usize) -> String {
    truncate(&show(&tokens[at.saturating_sub(2)..tokens.len().min(at + 3)]))
}

/// Edits inside a fraction, a root or a group.
fn nested_variants(tokens: &[Token], at: usize, tries: &mut Tries<'_>) -> ControlFlow<()> {
    let token = &tokens[at];
    let lists = match token.kind {
        TokenKind::Fraction(..) => 2,
        // The index of a root is no place for a slip.
        TokenKind::Root(..) | TokenKind::Group(_) => 1,
        _ => 0,
    };
    for (which, list) in token.inner().take(lists).enumerate() {
        variants(list, false, &mut |edit| {
            let mut kind = token.kind.clone();
            kind.lists().into_iter().skip(which).take(1).for_each(|list| list.clone_from(&edit.tokens));
            let mut all = tokens[..at].to_vec();
            all.push(Token::new(kind, token.span));
            all.extend_from_slice(&tokens[at + 1..]);
            tries(Edit { tokens: all, ..edit })
        })?;
    }
    ControlFlow::Continue(())
}

/// The exponent whose caret is lacking behind the ten of a power of ten: a minus sign and one or two digits.
fn without_caret(tokens: &[Token], at: usize) -> Option<&[Token]> {
    let before = tokens[..at].iter().rev().find(|token| !token.is_space())?;
    let exponent = tokens.get(at + 1..at + 3)?;
    let digits = exponent[1].number().is_some_and(|digits| digits.len() <= 2 && !digits.contains('.'));
    let fits = tokens[at].number() == Some("10") && before.is_one_of("×·") && exponent[0].is_sign('-') && digits;
    fits.then_some(exponent)
}

fn exponent_of(token: &Token) -> Option<i32> {
    let TokenKind::Power(exponent) = &token.kind else { return None };
    let value = plain_exponent(exponent).ok()?;
    (value.fract() == 0.0 && value.abs() < 1000.0).then_some(value as i32)
}

/// Edits of an exponent: its sign, one to three steps, and none at all.
fn powers(tokens: &[Token], at: usize, tries: &mut Tries<'_>) -> ControlFlow<()> {
    let token = &tokens[at];
    let Some(power) = exponent_of(token) else { return ControlFlow::Continue(()) };
    let base = tokens[..at].last();
    // An exponent of minus one behind a function's name is a name, too.
    if base.is_some_and(|base| matches!(base.kind, TokenKind::Function(_))) {
        return ControlFlow::Continue(());
    }
    let of_ten = base.and_then(Token::number) == Some("10");
    let steps: &[i32] = if of_ten { &[-3, -2, -1, 1, 2, 3] } else { &[-1, 1] };
    let mut others: Vec<i32> = steps.iter().map(|step| power + step).collect();
    if power != 0 {
        others.push(-power);
    }
    others.sort_unstable();
    others.dedup();
    let base = truncate(&base.map(|base| show(std::slice::from_ref(base))).unwrap_or_default());
    for other in others.into_iter().filter(|other| *other != power && *other != 0) {
        let mut exponent = Vec::new();
        if other < 0 {
            exponent.push(Token::new(TokenKind::Operator('-'), token.span));
        }
        exponent.push(number(other.unsigned_abs().to_string(), token.span));
        let mut all = tokens[..at].to_vec();
        if other != 1 || of_ten {
            all.push(Token::new(TokenKind::Power(exponent), token.span));
        }
        all.extend_from_slice(&tokens[at + 1..]);
        let words = format!("{base}^{other}` for `{base}^{power}`").replace('-', "−");
        let kind = match (other == -power, of_ten) {
            (true, true) => EditKind::ExponentSign,
            (false, true) => EditKind::Exponent((other - power).unsigned_abs()),
            (_, false) => EditKind::OtherExponent,
        };
        tries(Edit { tokens: all, kind, words: format!("`{words}"), at: token.span })?;
    }
    // The square of a unit that belongs to the whole bracket.
    if tokens.get(at + 1).is_some_and(|next| next.is_sign(')')) && at > 0 && tokens[at - 1].word().is_some() {
        let mut all = tokens[..at].to_vec();
        all.push(tokens[at + 1].clone());
        all.push(token.clone());
        all.extend_from_slice(&tokens[at + 2..]);
        let words = format!("the exponent {power} outside the bracket");
        tries(Edit { tokens: all, kind: EditKind::OutsideBracket, words, at: token.span })?;
    }
    ControlFlow::Continue(())
}

/// The number with a comma for its point, or a point for its comma.
fn commas(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    if let Some((whole, behind)) = text.split_once('.')
        && behind.len() == 3
        && (1..=3).contains(&whole.len())
        && whole != "0"
    {
        out.push(format!("{whole},{behind}"));
    }
    if let Some((whole, groups)) = text.split_once(',')
        && groups.len() == 3
    {
        out.push(format!("{whole}.{groups}"));
    }
    out
}

/// Most characters of a number that may be misprinted.
const LONGEST_NUMBER: usize = 16;

/// The number with its point elsewhere, and by how many places.
fn shifted(text: &str) -> Vec<(u32, String)> {
    let plain: String = text.chars().filter(|c| *c != ',').collect();
    let (whole, behind) = plain.split_once('.').unwrap_or((&plain, ""));
    let digits = format!("{whole}{behind}");
    let mut out = Vec::new();
    for places in [-3i32, -2, -1, 1, 2, 3] {
        if plain.len() < 2 {
            break;
        }
        let point = whole.len() as i32 + places;
        let new = if point <= 0 {
            format!("0.{}{digits}", "0".repeat(point.unsigned_abs() as usize))
        } else if point as usize >= digits.len() {
            format!("{digits}{}", "0".repeat(point as usize - digits.len()))
        } else {
            format!("{}.{}", &digits[..point as usize], &digits[point as usize..])
        };
        let trimmed = new.trim_start_matches('0');
        let new =
            if trimmed.is_empty() || trimmed.starts_with('.') { format!("0{trimmed}") } else { trimmed.to_owned() };
        out.push((places.unsigned_abs(), new));
    }
    out
}

/// The number with another digit in one place.
fn digits(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    for (at, digit) in text.char_indices().filter(|(_, c)| c.is_ascii_digit()).take(12) {
        let others = ('0'..='9').filter(|other| *other != digit);
        out.extend(others.map(|other| format!("{}{other}{}", &text[..at], &text[at + 1..])));
    }
    out.retain(|other| is_number(other));
    out
}

/// The number with two neighbouring digits swapped.
fn swapped(text: &str) -> Vec<String> {
    let letters: Vec<char> = text.chars().collect();
    let is_pair =
        |at: &usize| letters[*at..*at + 2].iter().all(char::is_ascii_digit) && letters[*at] != letters[*at + 1];
    let places = (0..letters.len().saturating_sub(1)).filter(is_pair).take(12);
    let swap = places.map(|at| {
        let mut new = letters.clone();
        new.swap(at, at + 1);
        new.into_iter().collect::<String>()
    });
    swap.filter(|other| is_number(other)).collect()
}
