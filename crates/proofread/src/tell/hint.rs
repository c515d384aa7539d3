//! The single edit that makes two sides agree, if there is exactly one near.

use crate::evaluate::exponent::plain_exponent;
use crate::join::chain::{ChainSide, Relation};
use crate::judge::verdict::{ChainVerdict, PairJudgement, judge};
use crate::token::{Span, Token, TokenKind, show};
use crate::unit::unit;
use std::ops::ControlFlow;

/// An edit of one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Hint {
    /// What to change, in words.
    pub words: String,
    /// Where.
    pub at: Span,
}

impl Hint {
    /// What to write at the place instead, if the edit is of a number that stands there as the hint names it.
    ///
    /// ```
    /// use proofread::{CheckOptions, TextFormat, proofread};
    ///
    /// let text = r"It is $\tan 31.0^\circ = 0.609$.";
    /// let report = proofread(text, TextFormat::Markdown, CheckOptions::default())?;
    /// let hint = report.findings[0].hint.as_ref().expect("a hint");
    /// assert_eq!((&text[hint.at.range()], hint.replacement(text)), ("0.609", Some("0.601")));
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn replacement(&self, text: &str) -> Option<&str> {
        let (offered, printed) = self.words.strip_prefix('`')?.strip_suffix('`')?.split_once("` for `")?;
        // These signs mean the same in every format.
        let is_number = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b','));
        let stands_there = text.get(self.at.range()) == Some(printed);
        (stands_there && is_number(offered) && is_number(printed)).then_some(offered)
    }

    /// Whether the text has at the place already what the hint offers, so that the text was misread.
    pub(crate) fn stands_in(&self, text: &str) -> bool {
        let offered = self.words.strip_prefix('`').and_then(|words| words.split_once('`'));
        let plain = |text: &str| text.chars().filter(|c| !c.is_whitespace() && !"{}".contains(*c)).collect::<String>();
        let printed = text.get(self.at.range()).map(plain);
        offered.is_some_and(|(offered, _)| printed.is_some_and(|printed| printed == plain(offered)))
    }
}

/// How near an edit is: a slip of one sign or step is nearer than another digit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum EditNearness {
    /// A comma for a point: no digit differs.
    Comma,
    /// An exponent or its sign, a factor 2, a sign, a power of a unit, a square.
    Step,
    /// One digit, two neighbouring digits swapped, or plus for minus.
    Digit,
}

struct Edit {
    tokens: Vec<Token>,
    words: String,
    at: Span,
}

/// Takes edits one at a time, and says when it has enough of them. Each has a copy of its side.
type Tries<'t> = dyn FnMut(Edit) -> ControlFlow<()> + 't;

/// Most edits of a side that are tried.
const MOST: usize = 2500;

/// Longest sides for which an edit is searched, in tokens: of more than these, one is hardly ever the only one.
const LONGEST: usize = 200;

/// How much a search may cost, in tokens that are evaluated: a few tenths of a second for one finding, and a few seconds for a
/// document.
const MOST_FOR_ONE: usize = 200_000;
/// The budget of a document.
pub(crate) const MOST_FOR_ALL: usize = 600_000;

/// How many tokens there are, with those inside others.
fn size(tokens: &[Token]) -> usize {
    tokens.iter().map(|token| 1 + token.inner().into_iter().map(size).sum::<usize>()).sum()
}

/// The one near edit that makes the sides agree; what the search costs is taken from `budget`.
///
/// If only the last digit differs, it must be one of the printed result: of a digit as far behind in an operand, this is no
/// evidence.
pub(crate) fn hint(
    left: &ChainSide,
    right: &ChainSide,
    relation: Relation,
    judgement: &PairJudgement,
    budget: &mut usize,
) -> Option<Hint> {
    let printed =
        judgement.values.as_ref().map_or(1, |(left, right)| usize::from(right.is_literal() || !left.is_literal()));
    let only = matches!(judgement.verdict, ChainVerdict::LastDigit | ChainVerdict::Truncated).then_some(printed);
    let sizes = [left, right].map(|side| size(&side.tokens));
    if sizes.into_iter().any(|size| size > LONGEST) {
        return None;
    }
    let each = sizes[0] + sizes[1];
    let mut spent = 0;
    for near in [EditNearness::Comma, EditNearness::Step, EditNearness::Digit] {
        let mut found: Vec<(usize, Hint)> = Vec::new();
        for (which, side) in [left, right].into_iter().enumerate() {
            let mut tried = 0;
            let mut is_spent = false;
            let mut tries = |edit: Edit| {
                tried += 1;
                spent += each;
                *budget = budget.saturating_sub(each);
                // Without having tried all edits, none is known to be the only one.
                is_spent = spent > MOST_FOR_ONE || *budget == 0;
                if is_spent {
                    return ControlFlow::Break(());
                }
                let sides = if which == 0 { [&edit.tokens, &right.tokens] } else { [&left.tokens, &edit.tokens] };
                let fits = judge(sides[0], sides[1], relation, None).verdict == ChainVerdict::Consistent;
                if fits && !found.iter().any(|(_, other)| other.words == edit.words) {
                    found.push((which, Hint { words: edit.words, at: edit.at }));
                }
                if tried < MOST { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            };
            let all = variants(&side.tokens, near, &mut tries);
            // On one side is as good as on the other.
            if all.is_continue() && near == EditNearness::Step && which == 0 && only.is_none() {
                let _ = whole_side(side, &mut tries);
            }
            // Of two, neither is the one.
            if is_spent || found.len() > 3 {
                return None;
            }
        }
        match found.as_slice() {
            [] => {}
            [(which, _)] if only.is_some_and(|only| only != *which) => return None,
            [(_, hint)] => return Some(hint.clone()),
            _ => return None,
        }
    }
    None
}

fn number(text: String, span: Span) -> Token {
    Token::new(TokenKind::Number(text), span)
}

/// Edits of a side as a whole: its sign and a factor 2. Which of the two sides is wrong, they leave open.
fn whole_side(side: &ChainSide, tries: &mut Tries<'_>) -> ControlFlow<()> {
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
    let mut push = |tokens: Vec<Token>, words: &str| {
        tries(Edit { tokens, words: format!("{words} on one of the two sides"), at: side.span })
    };
    push(group(&[two.clone(), TokenKind::Operator('·')], &[]), "a factor 2")?;
    push(group(&[], &[TokenKind::Operator('/'), two]), "a factor 2")?;
    push(group(&[TokenKind::Operator('-')], &[]), "the opposite sign")
}

fn truncate(text: &str) -> String {
    if text.chars().count() <= 40 {
        return text.to_owned();
    }
    text.chars().take(39).chain(['…']).collect()
}

/// Tries all lists of tokens that differ in one place.
fn variants(tokens: &[Token], near: EditNearness, tries: &mut Tries<'_>) -> ControlFlow<()> {
    for (at, token) in tokens.iter().enumerate() {
        let with = |new: Vec<Token>, taken: usize| {
            let mut all = tokens[..at].to_vec();
            all.extend(new);
            all.extend_from_slice(&tokens[at + taken..]);
            all
        };
        let span = token.span;
        let mut push = |tokens: Vec<Token>, words: String| tries(Edit { tokens, words, at: span });
        match &token.kind {
            // Decimals that go on are not printed digit by digit.
            TokenKind::Number(text) if text.ends_with('…') || text.len() > LONGEST_NUMBER => {}
            TokenKind::Number(text) if near == EditNearness::Digit => {
                for other in digits(text) {
                    push(with(vec![number(other.clone(), span)], 1), format!("`{other}` for `{text}`"))?;
                }
            }
            TokenKind::Number(text) if near == EditNearness::Comma => {
                for other in commas(text) {
                    push(with(vec![number(other.clone(), span)], 1), format!("`{other}` for `{text}`"))?;
                }
            }
            TokenKind::Number(text) => {
                if let Some(exponent) = without_caret(tokens, at) {
                    let words = format!("`10^{0}` for `10{0}`", show(exponent));
                    let power =
                        Token::new(TokenKind::Power(exponent.to_vec()), exponent[0].span.join(exponent[1].span));
                    push(with(vec![token.clone(), power], 3), words)?;
                }
                let power = tokens.get(at + 1).filter(|_| text == "10").and_then(exponent_of);
                for other in shifted(text).into_iter().filter(|_| power.is_none()) {
                    push(with(vec![number(other.clone(), span)], 1), format!("`{other}` for `{text}`"))?;
                }
            }
            TokenKind::Operator(sign @ ('+' | '-')) if near == EditNearness::Digit => {
                let other = if *sign == '+' { '-' } else { '+' };
                let name = |sign: char| if sign == '-' { '−' } else { sign };
                let place = tokens_around(tokens, at);
                push(
                    with(vec![Token::new(TokenKind::Operator(other), span)], 1),
                    format!("`{}` for `{}` in `{place}`", name(other), name(*sign)),
                )?;
            }
            TokenKind::Power(_) if near == EditNearness::Step => powers(tokens, at, tries)?,
            TokenKind::Word(word) if near == EditNearness::Step && unit(word).is_some() => {
                let raised = tokens.get(at + 1).is_some_and(|next| matches!(next.kind, TokenKind::Power(_)));
                if !raised && !matches!(word.as_str(), "°" | "%" | "rad") {
                    for power in ["2", "3"] {
                        let exponent = Token::new(TokenKind::Power(vec![number(power.to_owned(), span)]), span);
                        push(with(vec![token.clone(), exponent], 1), format!("`{word}^{power}` for `{word}`"))?;
                    }
                }
            }
            TokenKind::Operator(')')
                if near == EditNearness::Step
                    && !tokens.get(at + 1).is_some_and(|next| matches!(next.kind, TokenKind::Power(_))) =>
            {
                let squared =
                    vec![token.clone(), Token::new(TokenKind::Power(vec![number("2".to_owned(), span)]), span)];
                push(with(squared, 1), format!("the square of `{}`", truncate(&show(&bracketed_tokens(tokens, at)))))?;
            }
            _ => {}
        }
        nested_variants(tokens, at, near, tries)?;
    }
    ControlFlow::Continue(())
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
fn nested_variants(tokens: &[Token], at: usize, near: EditNearness, tries: &mut Tries<'_>) -> ControlFlow<()> {
    let token = &tokens[at];
    let lists = match token.kind {
        TokenKind::Fraction(..) => 2,
        // The index of a root is no place for a slip.
        TokenKind::Root(..) | TokenKind::Group(_) => 1,
        _ => 0,
    };
    for (which, list) in token.inner().into_iter().take(lists).enumerate() {
        variants(list, near, &mut |edit| {
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
        tries(Edit { tokens: all, words: format!("`{words}"), at: token.span })?;
    }
    // The square of a unit that belongs to the whole bracket.
    if tokens.get(at + 1).is_some_and(|next| next.is_sign(')')) && at > 0 && tokens[at - 1].word().is_some() {
        let mut all = tokens[..at].to_vec();
        all.push(tokens[at + 1].clone());
        all.push(token.clone());
        all.extend_from_slice(&tokens[at + 2..]);
        tries(Edit { tokens: all, words: format!("the exponent {power} outside the bracket"), at: token.span })?;
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

/// The number with its point elsewhere.
fn shifted(text: &str) -> Vec<String> {
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
        out.push(new);
    }
    out
}

/// The number with another digit in one place, and with two neighbouring digits swapped.
fn digits(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    // A one is hardly ever misprinted, but often there for show.
    if text == "1" {
        return out;
    }
    let letters: Vec<char> = text.chars().collect();
    for (at, letter) in letters.iter().enumerate().filter(|(_, letter)| letter.is_ascii_digit()).take(12) {
        for other in ('0'..='9').filter(|other| other != letter) {
            let leading_zero = at == 0 && other == '0' && letters.get(1).is_none_or(char::is_ascii_digit);
            if !leading_zero {
                let mut new = letters.clone();
                new[at] = other;
                if new.iter().any(|c| ('1'..='9').contains(c)) {
                    out.push(new.into_iter().collect());
                }
            }
        }
        if let Some(next) = letters.get(at + 1).filter(|next| next.is_ascii_digit() && *next != letter) {
            let mut new = letters.clone();
            (new[at], new[at + 1]) = (*next, *letter);
            out.push(new.into_iter().collect());
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::join::chain::split_chains;
    use crate::reader::{self, TextFormat};

    fn hinted(tex: &str) -> Option<String> {
        let mut found = None;
        reader::read(&format!("${tex}$"), TextFormat::Markdown, &mut |formula| {
            let chain = &split_chains(&formula.tokens)[0];
            let [left, right] = [&chain.sides[0], &chain.sides[1]];
            let judgement = judge(&left.tokens, &right.tokens, Relation::Equal, None);
            found = hint(left, right, Relation::Equal, &judgement, &mut MOST_FOR_ALL.clone());
        })
        .expect("it is read");
        found.map(|hint| hint.words)
    }

    #[test]
    fn the_one_edit_that_fits_is_named() {
        for (tex, words) in [
            (r"(46.6\ \mathrm{W})(86.400\ \mathrm{s}) = 4.03\times10^6\ \mathrm{J}", "`86,400` for `86.400`"),
            (r"2.40\ \mathrm{m/s^2}\,(12.0\ \mathrm{s})^2 = 172.80\ \mathrm{m}", "a factor 2 on one of the two sides"),
            (
                r"\frac{1000\ \mathrm{MeV}}{8.62\times10^{11}\ \mathrm{MeV/K}} = 1.16\times10^{13}\ \mathrm{K}",
                "`10^−11` for `10^11`",
            ),
            (r"\tan 31.0^\circ = 0.609", "`0.601` for `0.609`"),
            (r"239.052157 - 239.046526 = 0.0005631", "`0.005631` for `0.0005631`"),
            (r"3.0\cdot 20 = -60.0", "the opposite sign on one of the two sides"),
        ] {
            assert_eq!(hinted(tex).as_deref(), Some(words), "{tex}");
        }
    }

    #[test]
    fn a_lacking_caret_is_named() {
        assert_eq!(hinted(r"2 \times 3.1 \times 10^{-5} = 6.2 \times 10{-5}").as_deref(), Some("`10^−5` for `10−5`"));
        assert_eq!(hinted(r"2 \times 3.1 = 6.3 \times 10 - 5"), None);
    }

    #[test]
    fn what_the_text_has_already_is_not_offered() {
        let hint = Hint { words: "`6.928` for `6928`".to_owned(), at: Span::new(2, 7) };
        assert!(hint.stands_in("= 6.928") && !hint.stands_in("= 6928.") && !hint.stands_in("="));
    }

    #[test]
    fn of_several_edits_none_is_named() {
        assert_eq!(hinted("43.4 - 29.8 = 13.8"), None);
        // Another digit of an operand, or of a one, would do, but is not likely.
        assert_eq!(hinted("9.00 - (1.188)(0.100) = 8.90"), None);
        assert_eq!(hinted("1/4.000 = 0.750").as_deref(), Some("`0.250` for `0.750`"));
    }
}
