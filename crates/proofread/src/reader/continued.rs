//! A formula that begins with a relation sign goes on with the one before it, if nothing but a unit, a sign of per cent or a bracket stands
//! between them: `$97$% $= 0.97$`.

use super::{Formula, FormulaStyle, tokenise_text};
use crate::token::{Span, Token, TokenKind};
use crate::unit::{is_percent, unit};

/// Longest text between two formulas that are one, in bytes.
const LONGEST: usize = 40;

/// Puts formulas together as they come, and hands them on.
pub(super) struct ContinuedFormulas<'t> {
    text: &'t str,
    last: Option<Formula>,
    /// A formula in the bracket behind the last one.
    bracketed: Option<Formula>,
}

impl<'t> ContinuedFormulas<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Self { text, last: None, bracketed: None }
    }

    /// Takes the next formula; those before it are handed on unless they go on in it.
    pub(super) fn take(&mut self, next: Formula, each: &mut dyn FnMut(Formula)) {
        let Some(last) = self.last.take() else {
            self.last = Some(next);
            return;
        };
        let inner = self.bracketed.take();
        let may_go_on = ends_with_value(&last) && next.style == FormulaStyle::Formula;
        if let Some(between) = self.between(&last, inner.as_ref(), &next).filter(|_| may_go_on && begins_side(&next)) {
            let span = last.span.join(next.span);
            let mut tokens = last.tokens;
            tokens.push(Token::new(TokenKind::Space(2), next.span));
            tokens.extend(between);
            tokens.extend(next.tokens);
            self.last = Some(Formula { tokens, span, goes_on: next.goes_on, ..last });
            return;
        }
        if inner.is_none() && may_go_on && self.opens_bracket(&last, &next) {
            (self.last, self.bracketed) = (Some(last), Some(next));
            return;
        }
        each(last);
        match inner {
            // It may itself have a bracket behind it.
            Some(inner) => {
                self.last = Some(inner);
                self.take(next, each);
            }
            None => self.last = Some(next),
        }
    }

    /// Hands on the last formulas.
    pub(super) fn finish(&mut self, each: &mut dyn FnMut(Formula)) {
        self.last.take().into_iter().chain(self.bracketed.take()).for_each(each);
    }

    fn text_between(&self, from: u32, to: u32) -> Option<&'t str> {
        let between = self.text.get(from as usize..to as usize)?;
        (between.len() <= LONGEST && !between.contains("\n\n")).then_some(between)
    }

    /// Whether a formula stands first in a bracket behind the last one, perhaps behind its unit.
    fn opens_bracket(&self, last: &Formula, next: &Formula) -> bool {
        let between = self.text_between(last.span.end, next.span.start).map(str::trim_end);
        between.and_then(|between| between.strip_suffix('(')).is_some_and(|unit| units(unit, 0).is_some())
    }

    /// What stands between a formula and the one in which it goes on; none if it is more than a unit and a bracket of a quantity.
    fn between(&self, last: &Formula, inner: Option<&Formula>, next: &Formula) -> Option<Vec<Token>> {
        let start = last.span.end as usize;
        let Some(inner) = inner else {
            let between = self.text_between(last.span.end, next.span.start)?;
            // Formulas with nothing between them are put together elsewhere, or are in different cells.
            if between.trim().is_empty() {
                return None;
            }
            let Some((before, bracket)) = between.trim_end().split_once('(') else { return units(between, start) };
            let inside = bracket.strip_suffix(')')?;
            let digits = inside.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(inside.len());
            let number = tokenise_text(&inside[..digits], start + before.len() + 1);
            let unit = units_or_noun(&inside[digits..], start + before.len() + 1 + digits)?;
            let is_number = matches!(number.as_slice(), [number] if number.number().is_some());
            return is_number.then(|| bracketed(units(before, start), number, unit, next.span)).flatten();
        };
        let before = self.text_between(last.span.end, inner.span.start)?.trim_end().strip_suffix('(')?;
        let behind = self.text_between(inner.span.end, next.span.start)?.trim_end().strip_suffix(')')?;
        let unit = units_or_noun(behind, inner.span.end as usize)?;
        let relates = inner.tokens.iter().any(is_relation);
        (!relates).then(|| bracketed(units(before, start), inner.tokens.clone(), unit, next.span)).flatten()
    }
}

/// A unit, and behind it a quantity in brackets.
fn bracketed(
    before: Option<Vec<Token>>,
    mut number: Vec<Token>,
    mut unit: Vec<Token>,
    place: Span,
) -> Option<Vec<Token>> {
    let sign = |c| Token::new(TokenKind::Operator(c), Span { end: place.start, ..place });
    let mut out = before?;
    out.push(sign('('));
    out.append(&mut number);
    out.append(&mut unit);
    out.push(sign(')'));
    Some(out)
}

/// The tokens of a text that has nothing but units; none if it has anything else.
fn units(text: &str, base: usize) -> Option<Vec<Token>> {
    /// Words of English that are signs of units, too.
    const WORDS: [&str; 5] = ["a", "as", "at", "in", "are"];
    let text = text.trim_matches([' ', '~', '\n', '\u{a0}']);
    let is_known = |word: &str| {
        let name = word.trim_end_matches(|c: char| c.is_ascii_digit() || "²³^".contains(c));
        !WORDS.contains(&name) && (is_percent(name) || unit(name).is_some() || is_plural_of_unit(name))
    };
    let mut words = text.split([' ', '~', '/', '·', '\u{a0}', '\n']).filter(|word| !word.is_empty() && *word != "\\");
    if !words.all(|word| is_known(word.trim_start_matches('\\'))) {
        return None;
    }
    Some(tokenise_text(&text.replace(['\\', '~'], " "), base))
}

/// The tokens of a text that has nothing but units, or none of a noun, which only says what is counted.
fn units_or_noun(text: &str, base: usize) -> Option<Vec<Token>> {
    let is_noun = |word: &str| word.len() > 2 && word.chars().all(|c| c.is_ascii_lowercase()) && unit(word).is_none();
    units(text, base).or_else(|| is_noun(text.trim()).then(Vec::new))
}

/// Whether a word is a unit behind a plural ending.
fn is_plural_of_unit(word: &str) -> bool {
    word.strip_suffix('s').is_some_and(|word| word.len() > 2 && unit(word).is_some())
}

fn is_relation(token: &Token) -> bool {
    token.is_one_of("=≈")
}

/// Whether the right side of an equation begins a formula.
fn begins_side(formula: &Formula) -> bool {
    formula.tokens.iter().find(|token| !token.is_space()).is_some_and(is_relation)
}

/// Whether a formula in the sentence ends with a number or a bracket, so that a unit may follow.
fn ends_with_value(formula: &Formula) -> bool {
    let last = formula.tokens.iter().rev().find(|token| !token.is_space());
    let is_value = |token: &Token| match &token.kind {
        TokenKind::Number(_) | TokenKind::Fraction(..) | TokenKind::Root(..) | TokenKind::Power(_) => true,
        TokenKind::Scripts(base, sub, _) => sub.is_empty() && base.last().is_some_and(|of| of.number().is_some()),
        TokenKind::Operator(c) => ")]".contains(*c),
        _ => false,
    };
    formula.style == FormulaStyle::Formula && last.is_some_and(is_value)
}
