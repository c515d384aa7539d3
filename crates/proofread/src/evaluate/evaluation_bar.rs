//! A bar behind an expression, with the limits between which it is taken.

use crate::evaluate::expression::Evaluator;
use crate::evaluate::value::{Evaluated, Obstacle, SideValue};
use crate::order::sort_few_without_repeats;
use crate::token::{Token, TokenKind, any, collect_names, trim_space};

/// Where the terms begin that a bar is about: behind the sign after terms without a variable, since a constant would vanish between the limits,
/// as in `1/3 + x²/2|₀¹`.
fn start_of_variable_terms(tokens: &[Token]) -> usize {
    let is_variable = |kind: &TokenKind| matches!(kind, TokenKind::Name(name) if !matches!(name.as_str(), "π" | "e"));
    let mut depth = 0_usize;
    let mut start = 0;
    let mut has_term = false;
    for (at, token) in tokens.iter().enumerate() {
        if any(std::slice::from_ref(token), &is_variable) {
            break;
        }
        depth += usize::from(token.is_one_of("([{"));
        depth = depth.saturating_sub(usize::from(token.is_one_of(")]}")));
        if depth == 0 && token.is_one_of("+-") && has_term {
            (start, has_term) = (at + 1, false);
        } else {
            has_term |= !token.is_space() && !token.is_one_of("+-·×*/(");
        }
    }
    start
}

impl Evaluator<'_> {
    /// The difference of an expression's values at the limits of the bar behind it, if there is a bar.
    pub(crate) fn evaluate_bar(&mut self, tokens: &[Token]) -> Option<Evaluated<SideValue>> {
        let at = tokens.iter().position(|token| matches!(token.kind, TokenKind::Limits(..)))?;
        if tokens[..at].last().is_some_and(|before| before.is_sign(']')) {
            return None;
        }
        let (before, of) = tokens[..at].split_at(start_of_variable_terms(&tokens[..at]));
        let value = self.evaluate_between(of, &tokens[at]);
        let value = if trim_space(before).is_empty() {
            value
        } else {
            let is_minus = before.last().is_some_and(|sign| sign.is_sign('-'));
            let before = self.evaluate_all(&before[..before.len() - 1]);
            value.and_then(|value| before?.sum(&if is_minus { value.negate() } else { value }, false))
        };
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
        if !self.local.is_empty() {
            return Err(Obstacle::Unclear("a bar inside a bar"));
        }
        let mut names = Vec::new();
        collect_names(of, &mut names);
        sort_few_without_repeats(&mut names);
        let [name] = names.as_slice() else {
            return Err(Obstacle::Unclear("a bar behind an expression in several variables"));
        };
        let is_pi = |kind: &TokenKind| *kind == TokenKind::Name("π".to_owned());
        let has_pi = any(from, &is_pi) || any(to, &is_pi);
        let (from, to) = (self.evaluate_all(from)?, self.evaluate_all(to)?);
        let mut at = |limit: SideValue| {
            (self.local, self.has_pi_as_limit) = (vec![(name.clone(), limit)], has_pi);
            let value = self.evaluate_all(of);
            (self.local, self.has_pi_as_limit) = (Vec::new(), false);
            value
        };
        let (upper, lower) = (at(to)?, at(from)?);
        let mut difference = upper.sum(&lower.negate(), false)?;
        difference.operations += 1;
        Ok(difference)
    }
}
