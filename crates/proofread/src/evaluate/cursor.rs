//! A place in the tokens of a side, from which the evaluation goes on.

use crate::effort;
use crate::evaluate::value::{Evaluated, Obstacle};
use crate::token::{Token, TokenKind};

/// A place in a list of tokens.
#[derive(Clone, Copy)]
pub(crate) struct Cursor<'t> {
    pub tokens: &'t [Token],
    pub at: usize,
}

impl<'t> Cursor<'t> {
    pub(crate) fn new(tokens: &'t [Token]) -> Self {
        Self { tokens, at: 0 }
    }

    /// The next token that is no space, which is skipped.
    pub(crate) fn peek(&mut self) -> Option<&'t Token> {
        self.at = self.behind_space(self.at);
        self.tokens.get(self.at)
    }

    pub(crate) fn behind_space(&self, mut at: usize) -> usize {
        while self.tokens.get(at).is_some_and(Token::is_space) {
            at += 1;
        }
        at
    }

    /// The next token that is no space from a place on, and its own place.
    pub(crate) fn token_from(&self, at: usize) -> (Option<&'t Token>, usize) {
        let at = self.behind_space(at);
        (self.tokens.get(at), at)
    }

    /// The next token, space or not.
    pub(crate) fn current(&self) -> Option<&'t Token> {
        self.tokens.get(self.at)
    }

    /// The token before this one that is no space.
    pub(crate) fn previous(&self) -> Option<&'t Token> {
        self.tokens[..self.at.min(self.tokens.len())].iter().rev().find(|token| !token.is_space())
    }

    pub(crate) fn take(&mut self, sign: char) -> bool {
        let found = self.peek().is_some_and(|token| token.is_sign(sign));
        self.at += usize::from(found);
        found
    }

    /// Takes a minus sign before a number that is not raised: in 3² + −2² the brackets may be missing.
    pub(crate) fn take_minus(&mut self) -> bool {
        let (sign, at) = self.token_from(self.at);
        let (number, behind) = self.token_from(at + 1);
        let is_raised = matches!(self.tokens.get(behind + 1), Some(Token { kind: TokenKind::Power(_), .. }));
        let is_number = number.is_some_and(|number| number.number().is_some());
        let found = sign.is_some_and(|sign| sign.is_sign('-')) && is_number && !is_raised;
        self.at = if found { at + 1 } else { self.at };
        found
    }

    /// The tokens inside the brackets that open here.
    pub(crate) fn take_group(&mut self) -> Evaluated<&'t [Token]> {
        let mut depth = 0usize;
        for (at, token) in self.tokens.iter().enumerate().skip(self.at) {
            effort::count_steps(1);
            if token.is_one_of("([{⌊⌈") {
                depth += 1;
            } else if token.is_one_of(")]}⌋⌉") {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    let inner = &self.tokens[self.at + 1..at];
                    self.at = at + 1;
                    return Ok(inner);
                }
            }
        }
        Err(Obstacle::Unclear("a bracket that is not closed"))
    }
}
