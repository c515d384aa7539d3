//! What macros stand for, put in their place.

use super::definitions::{Macro, defines, definition};
use super::tex::Tex;
use crate::effort;
use crate::token::{SourceChar, Span};

/// Longest definition in a formula, in characters.
const LONGEST_DEFINITION: usize = 500;

/// Most letters that are looked at for the name of a command before an argument.
const LONGEST_NAME: usize = 64;

impl Tex<'_> {
    /// Takes the definition whose command has just been read, since it shows nothing; whether there is one.
    pub(super) fn takes_definition(&mut self, command: &str) -> bool {
        if !defines(command) {
            return false;
        }
        let mut text = format!("\\{command}");
        text.extend(self.stack.iter().rev().take(LONGEST_DEFINITION).map(|sign| sign.c));
        effort::count_steps(text.len());
        let Some((_, _, end)) = definition(&text, 0) else { return false };
        let taken = text[1 + command.len()..end].chars().count();
        self.stack.truncate(self.stack.len().saturating_sub(taken));
        true
    }

    /// Puts what a macro stands for in its place.
    pub(super) fn expand(&mut self, name: &str, used: &Macro, span: Span) -> bool {
        let mut arguments: Vec<Vec<SourceChar>> = Vec::new();
        for at in 0..used.arguments {
            let given = match (&used.default, at) {
                (Some(default), 0) => self.optional().unwrap_or_else(|| chars_at(default, span)),
                _ => self.raw_group(),
            };
            arguments.push(given);
        }
        if self.outermost.as_ref().is_none_or(|(_, behind)| self.stack.len() <= *behind) {
            self.outermost = Some((name.to_owned(), self.stack.len()));
        }
        let mut body = Vec::new();
        let mut letters = used.body.chars();
        while let Some(c) = letters.next() {
            if c == '#'
                && let Some(which) = letters.clone().next().and_then(|c| c.to_digit(10))
            {
                letters.next();
                // An argument ends the name of a command before it.
                let last = body.iter().rev().take(LONGEST_NAME);
                let name = last.take_while(|sign: &&SourceChar| sign.c.is_ascii_alphabetic()).count();
                if name > 0 && body.len() > name && body[body.len() - name - 1].c == '\\' {
                    body.push(SourceChar { c: ' ', span });
                }
                body.extend(arguments.get((which as usize).wrapping_sub(1)).into_iter().flatten());
                continue;
            }
            body.push(SourceChar { c, span });
        }
        self.expanded += body.len() + 1;
        if !self.macros.may_add(body.len() + 1, self.expanded) {
            let name = self.outermost.take().map_or_else(|| name.to_owned(), |(name, _)| name);
            self.macros.give_up(&name);
            return false;
        }
        self.stack.extend(body.into_iter().rev());
        true
    }
}

fn chars_at(text: &str, span: Span) -> Vec<SourceChar> {
    text.chars().map(|c| SourceChar { c, span }).collect()
}
