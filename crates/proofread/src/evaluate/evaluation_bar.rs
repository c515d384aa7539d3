//! A bar behind an expression, with the limits between which it is taken.

use crate::evaluate::expression::Evaluator;
use crate::evaluate::value::{Evaluated, Obstacle, SideValue};
use crate::order::sort_few_without_repeats;
use crate::token::{Token, TokenKind, collect_names, trim_space};

impl Evaluator<'_> {
    /// The difference of an expression's values at the limits of the bar behind it, if there is a bar.
    pub(crate) fn evaluate_bar(&mut self, tokens: &[Token]) -> Option<Evaluated<SideValue>> {
        let at = tokens.iter().position(|token| matches!(token.kind, TokenKind::Limits(..)))?;
        if tokens[..at].last().is_some_and(|before| before.is_sign(']')) {
            return None;
        }
        let value = self.evaluate_between(&tokens[..at], &tokens[at]);
        let rest = trim_space(&tokens[at + 1..]);
        Some(value.and_then(|value| {
            let Some(first) = rest.first() else { return Ok(value) };
            if first.is_one_of("+-") {
                // The terms behind the bar may have bars of their own.
                let others =
                    self.nest(|inside| inside.evaluate_bar(rest).unwrap_or_else(|| inside.evaluate_all(rest)))?;
                return value.sum(&others, false);
            }
            let other = self.evaluate_all(rest)?;
            value.product(&other, None, true)
        }))
    }

    /// The difference of an expression's values at the limits.
    pub(crate) fn evaluate_between(&mut self, of: &[Token], limits: &Token) -> Evaluated<SideValue> {
        let TokenKind::Limits(from, to) = &limits.kind else { return Err(Obstacle::Unclear("no limits")) };
        if self.local.is_some() {
            return Err(Obstacle::Unclear("a bar inside a bar"));
        }
        let mut names = Vec::new();
        collect_names(of, &mut names);
        sort_few_without_repeats(&mut names);
        let [name] = names.as_slice() else {
            return Err(Obstacle::Unclear("a bar behind an expression in several variables"));
        };
        let (from, to) = (self.evaluate_all(from)?, self.evaluate_all(to)?);
        let mut at = |limit: SideValue| {
            self.local = Some((name.clone(), limit));
            let value = self.evaluate_all(of);
            self.local = None;
            value
        };
        let (upper, lower) = (at(to)?, at(from)?);
        let mut difference = upper.sum(&lower.negate(), false)?;
        difference.operations += 1;
        Ok(difference)
    }
}
