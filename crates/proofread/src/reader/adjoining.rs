//! Formulas with nothing between them are often one, which an author cut to fit the page.

use super::{Formula, FormulaSink};
use crate::token::{Span, Token, TokenKind};

/// Commands between two formulas that only move the second one.
const MOVES: [&str; 8] = ["vspace", "hspace", "smallskip", "medskip", "bigskip", "noindent", "quad", "qquad"];

/// Puts formulas together as they come, and hands them on.
pub(crate) struct Joiner<'t> {
    text: &'t str,
    last: Option<Formula>,
}

impl<'t> Joiner<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Self { text, last: None }
    }

    /// Takes the next formula; the one before it is handed on unless both are one.
    pub(super) fn take(&mut self, mut next: Formula, each: &mut FormulaSink<'_>) {
        match self.last.take() {
            None => {}
            Some(last) if !self.adjoin(last.span, next.span) => each(last),
            Some(last)
                if is_cut(&last, &next, self.starts_line(last.span, next.span))
                    && self.displayed(last.span) == self.displayed(next.span) =>
            {
                let mut tokens = last.tokens;
                tokens.push(Token::new(TokenKind::Line, next.span));
                tokens.append(&mut next.tokens);
                next = Formula { tokens, span: last.span.join(next.span), ..next };
            }
            Some(last) => {
                // A sign before the first term may belong to it or to what stands before.
                let sign = last.tokens.iter().all(|token| token.is_space() || token.is_one_of("+-×·"));
                next.continues = sign || first(&next.tokens).is_some_and(|first| first.is_one_of("+-×·"));
                each(last);
            }
        }
        self.last = Some(next);
    }

    /// Hands on the last formula.
    pub(super) fn finish(&mut self, each: &mut FormulaSink<'_>) {
        self.last.take().into_iter().for_each(each);
    }

    /// Whether a formula stands apart from the sentence around it.
    fn displayed(&self, of: Span) -> bool {
        let text = self.text.get(of.range()).unwrap_or_default();
        ["$$", "\\[", "\\\\[", "\\begin"].iter().any(|mark| text.starts_with(mark))
    }

    /// Whether the second one is in the sentence, and on a line of its own.
    fn starts_line(&self, first: Span, second: Span) -> bool {
        let between = self.text.get(first.end as usize..second.start as usize).unwrap_or_default();
        !self.displayed(second) && between.contains('\n')
    }

    /// Whether both are TeX between marks, and nothing that is printed is between them.
    fn adjoin(&self, first: Span, second: Span) -> bool {
        let marked = |of: Span| self.text.get(of.range()).is_some_and(|text| text.starts_with(['$', '\\']));
        let mut between = self.text.get(first.end as usize..second.start as usize).unwrap_or("…").trim();
        while let Some(command) = between.strip_prefix('\\') {
            let Some(name) = MOVES.iter().find(|name| command.starts_with(**name)) else { return false };
            let rest = command[name.len()..].trim_start_matches('*');
            let argument = rest.strip_prefix('{').and_then(|inner| inner.find('}')).map_or(0, |end| end + 2);
            between = rest[argument..].trim_start();
        }
        between.is_empty() && marked(first) && marked(second)
    }
}

fn first(tokens: &[Token]) -> Option<&Token> {
    tokens.iter().find(|token| !token.is_space())
}

/// Whether the second of two formulas goes on where the first one stops: it begins with an equals sign or the sign of a
/// product or a sum, or the first one ends with one.
fn is_cut(one: &Formula, other: &Formula, starts_line: bool) -> bool {
    let has_cells = |of: &Formula| of.tokens.iter().any(|token| token.kind == TokenKind::Cell);
    let last = one.tokens.iter().rev().find(|token| !token.is_space());
    let relates = |of: &Formula| of.tokens.iter().any(|token| token.is_one_of("=≈"));
    // A sign before an equation behind another one may be the mark of an item.
    let item = starts_line && relates(one) && relates(other);
    let goes_on = first(&other.tokens).is_some_and(|first| first.is_one_of("=≈") || (first.is_one_of("+×·") && !item));
    // A sign alone parts two formulas as often as it joins them.
    let alone = one.tokens.iter().all(|token| token.is_space() || token.is_one_of("+-×·"));
    !has_cells(one) && !has_cells(other) && !alone && (goes_on || last.is_some_and(|last| last.is_one_of("+-×·")))
}
