//! Numbers in TeX, whose digits may stand in groups.

use super::tex::Tex;
use super::words::{number, number_length};
use crate::token::{SourceChar, Span, Token};

/// What may part the thousands of a number.
const SEPARATORS: [&[char]; 9] = [
    &[','],
    &['{', ',', '}'],
    &['\\', ','],
    &['\\', ':'],
    &['\\', ';'],
    &['\\', ' '],
    &['~'],
    &['{', ' ', '}'],
    &['\''],
];

impl Tex<'_> {
    /// Takes a number with `,`, `{,}` or `\,` between its thousands.
    pub(super) fn number(&mut self, out: &mut Vec<Token>) -> bool {
        let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        let starts = digit(self.ahead(0)) || (self.ahead(0) == Some('.') && digit(self.ahead(1)));
        if !starts {
            return false;
        }
        let mut taken = Vec::new();
        let (mut groups, mut leading) = (true, None);
        let is_thin = |of: &Self, at: usize| of.ahead(at) == Some('\\') && of.ahead(at + 1) == Some(',');
        loop {
            while let Some(sign) = self.peek().filter(|sign| sign.c.is_ascii_digit()) {
                taken.push(sign);
                self.stack.pop();
            }
            let leading = *leading.get_or_insert(taken.len());
            let separator: &[char] = SEPARATORS
                .into_iter()
                .find(|of| of.iter().enumerate().all(|(at, c)| self.ahead(at) == Some(*c)))
                .unwrap_or(&[]);
            let n = separator.len();
            let three = (n..n + 3).all(|at| digit(self.ahead(at))) && !digit(self.ahead(n + 3));
            let zero = taken.first().is_some_and(|sign| sign.c == '0');
            groups &= n > 0 && three && (1..=3).contains(&leading) && !zero;
            if !groups {
                break;
            }
            let span = self.peek().map_or(Span::default(), |sign| sign.span);
            self.stack.truncate(self.stack.len() - n);
            // Space parts thousands in texts with decimal commas, too.
            if separator.contains(&',') && separator[0] != '\\' {
                taken.push(SourceChar { c: ',', span });
            }
        }
        // A comma in braces before other than three digits is a decimal comma.
        let comma = [Some('{'), Some(','), Some('}')] == [self.ahead(0), self.ahead(1), self.ahead(2)];
        let whole = taken.iter().all(|sign| sign.c.is_ascii_digit());
        if comma && whole && digit(self.ahead(3)) {
            let span = self.peek().map_or(Span::default(), |sign| sign.span);
            self.stack.truncate(self.stack.len() - 3);
            self.stack.push(SourceChar { c: '.', span });
        }
        // Some programs set a thin space before the point.
        if is_thin(self, 0) && self.ahead(2) == Some('.') && digit(self.ahead(3)) {
            self.stack.truncate(self.stack.len() - 2);
        }
        if self.ahead(0) == Some('.') && digit(self.ahead(1)) {
            taken.extend(self.stack.pop());
            loop {
                let from = taken.len();
                while let Some(sign) = self.peek().filter(|sign| sign.c.is_ascii_digit()) {
                    taken.push(sign);
                    self.stack.pop();
                }
                // A thin space parts groups of three decimals.
                if !(taken.len() == from + 3 && is_thin(self, 0) && digit(self.ahead(2))) {
                    break;
                }
                self.stack.truncate(self.stack.len() - 2);
            }
        }
        debug_assert!(number_length(&taken) > 0);
        out.push(number(&taken));
        true
    }
}
