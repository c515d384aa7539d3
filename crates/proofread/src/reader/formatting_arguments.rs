//! What commands of TeX that change how something looks take behind them.

use super::formatting::FormattingCommand;
use super::tex::{Tex, token};
use crate::token::{Span, Token, TokenKind};

impl Tex<'_> {
    /// What a command dresses up.
    pub(super) fn format_argument(
        &mut self,
        name: &str,
        command: FormattingCommand,
        span: Span,
        depth: usize,
        out: &mut Vec<Token>,
    ) {
        let options = |reader: &mut Self| while command.optional && reader.optional().is_some() {};
        options(self);
        let mut said = String::new();
        for _ in 0..command.dropped {
            said.extend(self.raw_group().iter().map(|sign| sign.c));
            options(self);
        }
        if command.kept {
            let inner = self.argument(depth);
            // Whether both sides are equal is asked, demanded or denied.
            let asked = ASKING.contains(&without_dress(&said));
            match inner.as_slice() {
                [Token { kind: TokenKind::Operator(c), .. }] if name.ends_with("set") || name == "stackrel" => {
                    let sign = if asked && "=≡".contains(*c) { ASKED } else { *c };
                    out.push(token(TokenKind::Operator(sign), span));
                }
                [Token { kind: TokenKind::Operator(_), .. }] if name.starts_with("math") => out.extend(inner),
                _ => self.push_group(inner, span, out),
            }
        } else if name == "color" {
            self.join_digits_around(span, out);
        } else if name.ends_with("left") || name.ends_with("right") {
            self.skip_space();
            if self.ahead(0) == Some('.') {
                self.stack.pop();
            }
        }
    }

    /// Keeps a group. Digits of a number that are marked, as in `1\mathbf{4}5`, touch those before and behind them, so that they
    /// are joined later.
    pub(super) fn push_group(&mut self, inner: Vec<Token>, span: Span, out: &mut Vec<Token>) {
        let follows = out.last().is_some_and(|last| last.number().is_some() && last.span.end == span.start);
        let goes_on = self.ahead(0).is_some_and(|c| c.is_ascii_digit());
        match inner.as_slice() {
            [Token { kind: TokenKind::Number(digits), span: place, .. }] if follows || goes_on => {
                let end = self.peek().filter(|_| goes_on).map_or(place.end + 1, |next| next.span.start);
                out.push(token(TokenKind::Number(digits.clone()), Span { start: span.start, end }));
            }
            _ => out.push(token(TokenKind::Group(inner), span)),
        }
    }

    /// Lets the digits before a command for a colour touch those behind it, in braces or without: `1\color{red}{4}5`.
    fn join_digits_around(&mut self, span: Span, out: &mut [Token]) {
        let next = if self.ahead(0) == Some('{') { self.ahead(1) } else { self.ahead(0) };
        let Some(last) = out.last_mut().filter(|last| last.number().is_some() && last.span.end == span.start) else {
            return;
        };
        if next.is_some_and(|c| c.is_ascii_digit()) {
            last.span.end = self.peek().map_or(last.span.end, |next| next.span.start);
        }
    }

    /// The length behind a command for space, in braces or without.
    pub(super) fn length(&mut self) -> String {
        self.skip_space();
        if self.ahead(0) == Some('{') {
            return self.raw_group().iter().map(|sign| sign.c).collect();
        }
        let mut out = String::new();
        while let Some(sign) = self.peek().filter(|sign| sign.c.is_ascii_digit() || " .-".contains(sign.c)) {
            out.push(sign.c);
            self.stack.pop();
        }
        for _ in 0..2 {
            if let Some(sign) = self.peek().filter(|sign| sign.c.is_ascii_lowercase()) {
                out.push(sign.c);
                self.stack.pop();
            }
        }
        out
    }

    /// Skips the space between two rows, `[4pt]`, which is told from a row that begins with a bracket by being a length.
    pub(super) fn row_space(&mut self) {
        let mut ahead = self.stack.iter().rev().map(|sign| sign.c).skip_while(|c| c.is_whitespace());
        if ahead.next() != Some('[') {
            return;
        }
        let inside: String = ahead.take(20).take_while(|c| *c != ']').collect();
        let inside = inside.trim();
        let is_length = inside.contains(|c: char| c.is_ascii_digit() || c == '\\')
            && ["pt", "em", "ex", "cm", "mm", "in", "skip", "jot", "size", "height"]
                .iter()
                .any(|end| inside.ends_with(end));
        if is_length {
            self.optional();
        }
    }
}

/// The relation of two sides of which it is not said that they are equal.
pub(crate) const ASKED: char = '∼';

/// What stands above or below an equals sign where it is not said that both sides are equal.
const ASKING: [&str; 11] = ["?", "??", "!", "no", "false", "not", "X", "✗", "✘", "\\times", "\\xmark"];

/// What is left of an argument without the commands for its font and the braces around it: `?` of `\text{?}`.
fn without_dress(said: &str) -> &str {
    let mut rest = said.trim().trim_matches('$');
    while let Some(inner) = rest.strip_suffix('}') {
        let inner = inner.strip_prefix('{').or_else(|| {
            let (name, inner) = inner.strip_prefix('\\')?.split_once('{')?;
            (name.starts_with("text") || name.starts_with("math") || name == "mbox").then_some(inner)
        });
        let Some(inner) = inner else { break };
        rest = inner.trim().trim_matches('$');
    }
    rest
}
