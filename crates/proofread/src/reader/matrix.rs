//! Matrices and factorial powers in TeX.

use super::tex::{Tex, token};
use crate::effort;
use crate::token::{NamedOperation, SourceChar, Span, Token, TokenKind, trim_space};

/// Most characters of a matrix.
const LONGEST: usize = 4000;

impl Tex<'_> {
    /// Whether the exponent ahead has a line below or above it, as a falling or rising factorial has; the line's command is taken.
    pub(super) fn factorial_power(&mut self) -> Option<NamedOperation> {
        self.skip_space();
        let open = usize::from(self.ahead(0) == Some('{'));
        let is_ahead = |name: &str| {
            let letters = name.chars().enumerate().all(|(at, c)| self.ahead(open + at) == Some(c));
            letters && !self.ahead(open + name.len()).is_some_and(|c| c.is_ascii_alphabetic())
        };
        if is_ahead("\\underline") {
            Some(NamedOperation::Falling)
        } else if is_ahead("\\overline") {
            Some(NamedOperation::Rising)
        } else {
            None
        }
    }

    /// Reads a matrix up to its end, which is taken; whether there is one.
    pub(super) fn matrix(&mut self, name: &str, span: Span, depth: usize, out: &mut Vec<Token>) -> bool {
        let Some(inside) = self.take_environment(name) else {
            self.has_open_matrix = true;
            return false;
        };
        let whole = inside.iter().fold(span, |span, sign| span.join(sign.span));
        let tokens = self.read_inside(inside.into_iter().rev().collect(), depth);
        // Equations in brackets are rows of their own.
        if tokens.iter().any(|token| token.is_one_of("=≈")) {
            out.push(token(TokenKind::Line, span));
            out.extend(tokens);
            out.push(token(TokenKind::Line, whole));
            return true;
        }
        let rows: Vec<Vec<Token>> = tokens
            .split(|token| token.kind == TokenKind::Line)
            .map(|row| trim_space(row).to_vec())
            .filter(|row| !row.is_empty())
            .collect();
        let has_det = |token: &Token| matches!(&token.kind, TokenKind::Unknown(name) if name == "\\det");
        let last = out.iter().rposition(|token| !token.is_space());
        let det = last.filter(|at| has_det(&out[*at]));
        if name.starts_with('v') || det.is_some() {
            out.truncate(det.unwrap_or(out.len()));
            out.push(token(TokenKind::Call(NamedOperation::Determinant, rows), whole));
        } else {
            out.push(token(TokenKind::Call(NamedOperation::Matrix, rows), whole));
        }
        true
    }

    /// The characters up to the end of an environment, which is taken; none if it has no end.
    fn take_environment(&mut self, name: &str) -> Option<Vec<SourceChar>> {
        if self.has_open_matrix {
            return None;
        }
        let is_at = |stack: &[SourceChar], end: usize, text: &str| {
            text.chars()
                .enumerate()
                .all(|(at, c)| end.checked_sub(at + 1).and_then(|at| stack.get(at)).is_some_and(|sign| sign.c == c))
        };
        let (opening, closing) = (format!("\\begin{{{name}}}"), format!("\\end{{{name}}}"));
        let mut nested = 0usize;
        for end in (1..=self.stack.len()).rev().take(LONGEST) {
            effort::count_steps(1);
            if self.stack[end - 1].c != '\\' {
                continue;
            }
            if is_at(&self.stack, end, &opening) {
                nested += 1;
            } else if is_at(&self.stack, end, &closing) {
                if nested == 0 {
                    let inside = self.stack.split_off(end).into_iter().rev().collect();
                    self.stack.truncate(end - closing.chars().count());
                    return Some(inside);
                }
                nested -= 1;
            }
        }
        None
    }
}
