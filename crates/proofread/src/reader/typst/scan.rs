//! Reading Typst's source sign by sign: what its strings, comments and pieces of code end with.

use std::ops::Range;

/// Whether a name may begin so.
pub(super) fn is_name_start(c: char) -> bool {
    c.is_alphabetic()
}

/// A place in a stretch of the source.
pub(super) struct Scan<'t> {
    source: &'t str,
    pub at: usize,
    pub end: usize,
}

impl<'t> Scan<'t> {
    pub(super) fn new(source: &'t str, range: Range<usize>) -> Self {
        Self { source, at: range.start, end: range.end }
    }

    /// The source up to the end.
    pub(super) fn text(&self) -> &'t str {
        &self.source[..self.end]
    }

    pub(super) fn rest(&self) -> &'t str {
        self.source.get(self.at..self.end).unwrap_or_default()
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.at >= self.end
    }

    pub(super) fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    pub(super) fn starts_with(&self, signs: &str) -> bool {
        self.rest().starts_with(signs)
    }

    /// The next character and its place.
    pub(super) fn next(&mut self) -> Option<(char, Range<usize>)> {
        let c = self.peek()?;
        let start = self.at;
        self.at += c.len_utf8();
        Some((c, start..self.at))
    }

    pub(super) fn skip_space(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }

    /// How many digits are at a place.
    pub(super) fn digits_at(&self, at: usize) -> usize {
        self.text().get(at..).unwrap_or_default().bytes().take_while(u8::is_ascii_digit).count()
    }

    /// Whether a letter is at a place.
    pub(super) fn letter_at(&self, at: usize) -> bool {
        self.text().get(at..).unwrap_or_default().starts_with(|c: char| c.is_ascii_alphabetic())
    }

    /// Skips a comment, if one begins here.
    pub(super) fn skip_comment(&mut self) -> bool {
        let rest = self.rest();
        if rest.starts_with("//") {
            self.at += rest.find('\n').unwrap_or(rest.len());
            return true;
        }
        if !rest.starts_with("/*") {
            return false;
        }
        let (mut depth, mut from) = (0usize, 0);
        while let Some(mark) = rest[from..].find("/*").into_iter().chain(rest[from..].find("*/")).min() {
            let opens = rest[from + mark..].starts_with("/*");
            from += mark + 2;
            depth = if opens { depth + 1 } else { depth - 1 };
            if depth == 0 {
                self.at += from;
                return true;
            }
        }
        self.at = self.end;
        true
    }

    /// The content of a string whose mark is right before this place, which moves behind it.
    pub(super) fn string_behind(&mut self, mark: usize) -> Range<usize> {
        while let Some((c, range)) = self.next() {
            match c {
                '\\' => drop(self.next()),
                '"' => return mark + 1..range.start,
                _ => {}
            }
        }
        mark + 1..self.end
    }

    /// Skips what code prints, behind its `#`: a name with its arguments, or something in brackets.
    pub(super) fn code_expression(&mut self) {
        match self.peek() {
            Some('(' | '{' | '[') => self.balanced(),
            Some('"') => {
                let mark = self.at;
                self.next();
                self.string_behind(mark);
            }
            Some(c) if c.is_alphanumeric() || c == '_' => loop {
                while self.peek().is_some_and(|c| c.is_alphanumeric() || "_-".contains(c)) {
                    self.next();
                }
                while matches!(self.peek(), Some('(' | '[')) {
                    self.balanced();
                }
                if !(self.starts_with(".") && self.letter_at(self.at + 1)) {
                    break;
                }
                self.next();
            },
            _ => {}
        }
    }

    /// Skips what is in brackets, which begin here, with all brackets and strings in them.
    pub(super) fn balanced(&mut self) {
        let mut depth = 0usize;
        while !self.is_at_end() {
            if self.skip_comment() {
                continue;
            }
            let Some((c, range)) = self.next() else { return };
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => {
                    depth = depth.saturating_sub(1);
                    if depth == 0 {
                        return;
                    }
                }
                '"' => drop(self.string_behind(range.start)),
                '\\' => drop(self.next()),
                _ => {}
            }
        }
    }
}
