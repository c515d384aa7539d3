//! Lines and columns of places in a text.

use crate::effort;
use crate::token::Span;

/// A line and a column, both from 1; columns count characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
}

/// Bytes of a text between two places at which its characters are counted.
const STEP: usize = 256;

/// The lines of a text.
#[derive(Clone, Debug)]
pub struct Lines<'t> {
    text: &'t str,
    starts: Vec<usize>,
    /// How many characters begin before each [`STEP`]th byte: a line may be as long as the text.
    counts: Vec<usize>,
}

/// How many characters begin in these bytes.
fn characters(bytes: &[u8]) -> usize {
    effort::count(bytes.len());
    bytes.iter().filter(|byte| (**byte as i8) >= -0x40).count()
}

impl<'t> Lines<'t> {
    /// The lines of this text.
    pub fn new(text: &'t str) -> Self {
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        let mut counted = 0;
        let count = |bytes: &[u8]| {
            counted += characters(bytes);
            counted
        };
        let counts = std::iter::once(0).chain(text.as_bytes().chunks(STEP).map(count)).collect();
        Self { text, starts, counts }
    }

    /// How many characters begin before a byte.
    fn count(&self, at: usize) -> usize {
        let at = at.min(self.text.len());
        let step = at / STEP;
        let rest = self.text.as_bytes().get(step * STEP..at).unwrap_or_default();
        self.counts.get(step).copied().unwrap_or_default() + characters(rest)
    }

    /// The place of a byte.
    pub fn place(&self, at: usize) -> Place {
        let line = self.starts.partition_point(|start| *start <= at).max(1);
        Place { line, column: self.count(at) - self.count(self.start(line)) + 1 }
    }

    /// The byte at which a line begins.
    pub(crate) fn start(&self, line: usize) -> usize {
        self.starts.get(line - 1).copied().unwrap_or(0)
    }

    /// Where a stretch begins and where it ends.
    pub fn places(&self, span: Span) -> [Place; 2] {
        [self.place(span.start as usize), self.place(span.end as usize)]
    }

    /// A line without its end.
    pub fn line(&self, line: usize) -> &'t str {
        let start = self.start(line);
        let end = self.starts.get(line).copied().unwrap_or(self.text.len());
        self.text.get(start..end).unwrap_or_default().trim_end_matches(['\n', '\r'])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_in_a_long_line_costs_as_much_as_in_a_short_one() {
        let text = "x".repeat(100_000);
        let lines = Lines::new(&text);
        let before = effort::steps();
        assert_eq!(lines.place(99_999), Place { line: 1, column: 100_000 });
        assert!(effort::steps() - before <= 2 * STEP as u64);
    }

    #[test]
    fn columns_count_characters() {
        let lines = Lines::new("a\nβγ = 1\n");
        assert_eq!(lines.place("a\nβγ".len()), Place { line: 2, column: 3 });
        assert_eq!(lines.line(2), "βγ = 1");
        assert_eq!(lines.place(1000).line, 3);
        let text = format!("{}\n{}", "aβ=\u{1d7d9}".repeat(300), "γ".repeat(1000));
        let lines = Lines::new(&text);
        for (at, _) in text.char_indices() {
            let (line, column) = match text[..at].rsplit_once('\n') {
                Some((_, before)) => (2, before.chars().count() + 1),
                None => (1, text[..at].chars().count() + 1),
            };
            assert_eq!(lines.place(at), Place { line, column });
        }
    }
}
