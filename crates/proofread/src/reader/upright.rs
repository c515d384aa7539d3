//! Upright text in a formula, with the formulas in it.

use super::symbols::merge_letters;
use super::tex::{Tex, token};
use super::words::{span_of_chars, tokenise_words};
use crate::token::{MathFunction, SourceChar, Token, TokenKind};
use crate::unit::unit;

/// The formula of a substance as a word, which is no sign of a unit; what is no such formula isn't known.
fn substance(text: &str) -> TokenKind {
    let name: String = text.chars().filter(|c| !"{}_^$ ".contains(*c)).collect();
    if name.is_empty() || !name.chars().all(|c| c.is_ascii_alphanumeric() || "()+-".contains(c)) || name.contains("->")
    {
        return TokenKind::Unknown("\\ce".to_owned());
    }
    let letters: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
    TokenKind::Word(if unit(&letters).is_some() { format!("ce{letters}") } else { letters })
}

impl Tex<'_> {
    /// Upright text: a function, units, or words.
    pub(super) fn read_upright(&mut self, command: &str, depth: usize, out: &mut Vec<Token>) {
        self.skip_space();
        let raw = self.raw_group_or_digits();
        let text: String = raw.iter().map(|sign| sign.c).collect();
        if command == "ce" {
            out.push(token(substance(&text), span_of_chars(&raw)));
            return;
        }
        // A remark in brackets stands apart.
        if text.trim_start().starts_with(['(', '[']) && text.contains(|c: char| c.is_ascii_digit()) {
            out.push(token(TokenKind::Space(2), span_of_chars(&raw)));
        }
        let is_minute = text.trim() == "min" && command != "operatorname";
        let is_second = text.trim() == "sec" && command != "operatorname" && !self.has_argument_ahead();
        if let Some(function) = MathFunction::from_name(text.trim()).filter(|_| !is_minute && !is_second) {
            out.push(token(TokenKind::Function(function), span_of_chars(&raw)));
            return;
        }
        // Without a number before it, the name of a function and no second of arc.
        let follows_number =
            out.iter().rev().find(|token| !token.is_space()).is_some_and(|last| last.number().is_some());
        if matches!(text.trim(), "arcsec" | "arccsc" | "arccot") && !follows_number {
            out.push(token(TokenKind::Unknown(format!("\\{}", text.trim())), span_of_chars(&raw)));
            return;
        }
        let has_formulas = text.contains('$') && text.contains('=') && !text.contains("\\$");
        for (which, piece) in raw.split(|sign| has_formulas && sign.c == '$').enumerate() {
            // An equation in a text in a formula is one of its own.
            if which % 2 == 1 {
                let part = token(TokenKind::Operator(';'), span_of_chars(piece));
                out.push(part.clone());
                out.extend(self.read_inside(piece.iter().rev().copied().collect(), depth));
                out.push(part);
            } else {
                self.read_words(command, piece, depth, out);
            }
        }
    }

    /// The characters of a group, or all digits that follow: without braces the argument is the first one alone, and the others are printed
    /// close behind it.
    fn raw_group_or_digits(&mut self) -> Vec<SourceChar> {
        let mut digits = Vec::new();
        while let Some(digit) = self.peek().filter(|next| next.c.is_ascii_digit()) {
            digits.push(digit);
            self.stack.pop();
        }
        if digits.is_empty() { self.raw_group() } else { digits }
    }

    /// Whether what follows may be the argument of a function: a bracket, an exponent, a letter or a number, or a command for one of them.
    fn has_argument_ahead(&self) -> bool {
        const NO_ARGUMENT: [&str; 14] = [
            "times", "cdot", "quad", "qquad", "right", "approx", "to", "implies", "end", "text", "mathrm", "frac",
            "leq", "le",
        ];
        let rest: String = self.stack.iter().rev().take(12).map(|sign| sign.c).collect();
        let rest = rest.trim_start_matches([' ', '~', '\n', '}']);
        let Some(name) = rest.strip_prefix('\\') else {
            return rest.starts_with(|c: char| c.is_alphanumeric() || "([{^".contains(c));
        };
        let name: String = name.chars().take_while(char::is_ascii_alphabetic).collect();
        !name.is_empty() && !NO_ARGUMENT.contains(&name.as_str())
    }

    /// Upright text without formulas that stand apart from it.
    fn read_words(&mut self, command: &str, raw: &[SourceChar], depth: usize, out: &mut Vec<Token>) {
        let has = |signs: &[char]| raw.iter().any(|sign| signs.contains(&sign.c));
        if has(&['\\', '^', '_', '{', '$']) || (command == "mathrm" && has(&['~'])) {
            // Space for a dollar sign ends the name of a command before it.
            let spaced = |sign: &SourceChar| if sign.c == '$' { SourceChar { c: ' ', ..*sign } } else { *sign };
            let inner = self.read_inside(raw.iter().rev().map(spaced).collect(), depth);
            merge_letters(inner, out);
            return;
        }
        let plain = |sign: &SourceChar| if sign.c == '~' { SourceChar { c: ' ', ..*sign } } else { *sign };
        tokenise_words(&raw.iter().map(plain).collect::<Vec<_>>(), out);
    }
}
