//! Lines and columns of places in a text.

use crate::effort;
use crate::token::Span;

/// A line and a column, both from 1; columns count characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineColumn {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
}

/// Bytes of a text between two places at which its characters are counted.
const STEP: usize = 256;

/// The lines of a text.
///
/// ```
/// use proofread::{LineColumn, LineIndex, Span};
///
/// let text = "Δt is\n1/3 = 0.34";
/// let lines = LineIndex::new(text);
/// let at = text.find("0.34").expect("a result");
/// assert_eq!(lines.line_column(at), LineColumn { line: 2, column: 7 });
/// assert_eq!(lines.line_columns(Span::new(at, text.len()))[1], LineColumn { line: 2, column: 11 });
/// assert_eq!(lines.line(1), "Δt is");
/// ```
#[derive(Clone, Debug)]
pub struct LineIndex<'t> {
    text: &'t str,
    starts: Vec<usize>,
    /// How many characters begin before each [`STEP`]th byte: a line may be as long as the text.
    counts: Vec<usize>,
}

/// How many characters begin in these bytes.
fn characters(bytes: &[u8]) -> usize {
    effort::count_steps(bytes.len());
    bytes.iter().filter(|byte| (**byte as i8) >= -0x40).count()
}

impl<'t> LineIndex<'t> {
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
    fn characters_before(&self, at: usize) -> usize {
        let at = at.min(self.text.len());
        let step = at / STEP;
        let rest = self.text.as_bytes().get(step * STEP..at).unwrap_or_default();
        self.counts.get(step).copied().unwrap_or_default() + characters(rest)
    }

    /// The place of a byte.
    pub fn line_column(&self, at: usize) -> LineColumn {
        let line = self.starts.partition_point(|start| *start <= at).max(1);
        LineColumn { line, column: self.characters_before(at) - self.characters_before(self.line_start(line)) + 1 }
    }

    /// The byte at which a line begins.
    pub(crate) fn line_start(&self, line: usize) -> usize {
        self.starts.get(line - 1).copied().unwrap_or(0)
    }

    /// Where a stretch begins and where it ends.
    pub fn line_columns(&self, span: Span) -> [LineColumn; 2] {
        [self.line_column(span.start as usize), self.line_column(span.end as usize)]
    }

    /// A line without its end.
    pub fn line(&self, line: usize) -> &'t str {
        let start = self.line_start(line);
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
        let lines = LineIndex::new(&text);
        let before = effort::steps();
        assert_eq!(lines.line_column(99_999), LineColumn { line: 1, column: 100_000 });
        assert!(effort::steps() - before <= 2 * STEP as u64);
    }

    #[test]
    fn columns_count_characters() {
        let lines = LineIndex::new("a\nβγ = 1\n");
        assert_eq!(lines.line_column("a\nβγ".len()), LineColumn { line: 2, column: 3 });
        assert_eq!(lines.line(2), "βγ = 1");
        assert_eq!(lines.line_column(1000).line, 3);
        let text = format!("{}\n{}", "aβ=\u{1d7d9}".repeat(300), "γ".repeat(1000));
        let lines = LineIndex::new(&text);
        for (at, _) in text.char_indices() {
            let (line, column) = match text[..at].rsplit_once('\n') {
                Some((_, before)) => (2, before.chars().count() + 1),
                None => (1, text[..at].chars().count() + 1),
            };
            assert_eq!(lines.line_column(at), LineColumn { line, column });
        }
    }
}
