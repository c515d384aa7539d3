//! Lines of text for a terminal or a pipe.
//!
//! A width is a number of columns of a terminal, in which a letter with its accents takes one, a Chinese sign takes two, and
//! a colour takes none.

use crate::terminal::{self, WIDTHS};
use unicode_width::UnicodeWidthChar;

/// Columns that a text needs to the right of its lead. With less, it begins under it.
const LEAST_ROOM: usize = 30;
/// Columns at the end of a line that a part of a broken word may take.
const LEAST_PART: usize = 20;
/// How far such a text is set in.
const SET_IN: usize = 6;

/// How wide lines may be, and whether a word that is longer than a line is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextLayout {
    width: usize,
    breaks_words: bool,
}

impl Default for TextLayout {
    /// For a pipe or a file: the greatest width, and words stay whole.
    fn default() -> Self {
        Self { width: *WIDTHS.end(), breaks_words: false }
    }
}

impl TextLayout {
    /// For a terminal with so many columns, within [`WIDTHS`].
    pub fn for_columns(columns: usize) -> Self {
        Self { width: columns.clamp(*WIDTHS.start(), *WIDTHS.end()), breaks_words: true }
    }

    /// For standard output, whatever it is.
    pub fn of_output() -> Self {
        terminal::columns(std::io::stdout()).map_or_else(Self::default, Self::for_columns)
    }

    /// For standard error; none if that is no terminal, where a message stays on its line.
    pub fn of_errors() -> Option<Self> {
        terminal::columns(std::io::stderr()).map(Self::for_columns)
    }

    /// Columns of a line.
    pub fn width(self) -> usize {
        self.width
    }

    /// `text` in lines behind `lead`, then under it. Where little room is left beside a long lead, the text begins under it.
    pub fn wrapped(self, lead: &str, text: &str) -> String {
        let lead_columns = columns(lead);
        let is_beside = lead_columns == 0 || self.width >= lead_columns + LEAST_ROOM;
        let (first, indent) = if is_beside { (lead, lead_columns) } else { ("", SET_IN) };
        let mut lines = Vec::new();
        if !is_beside {
            lines = self.lines(lead, leading(lead) + SET_IN, false);
        }
        let words = text.split_whitespace().map(|word| (" ", word));
        let own = if is_beside { first.to_owned() } else { " ".repeat(indent) };
        if is_beside || !text.trim().is_empty() {
            lines.extend(self.broken(own, indent, words));
        }
        lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
    }

    /// `text` with each line that is too long broken between words, and set in as that line is. Lines that are short enough stay.
    /// Of a line with marks (`^`) under it, the part at the marks is shown. In a pipe or a file every line stays as it is.
    pub fn folded(self, text: &str) -> String {
        if !self.breaks_words {
            return text.to_owned();
        }
        let mut folded = String::with_capacity(text.len());
        let mut lines = text.split_inclusive('\n').peekable();
        while let Some(line) = lines.next() {
            let (line, end) = line.strip_suffix('\n').map_or((line, ""), |line| (line, "\n"));
            if columns(line) > self.width
                && let Some(marks) = lines.next_if(|next| is_of_marks(next))
            {
                folded += &self.part_at(line, marks.trim_end());
                continue;
            }
            folded += &self.lines(line, leading(line), true).join("\n");
            folded += end;
        }
        folded
    }

    /// The part of a line at the marks under it, and the marks.
    fn part_at(self, line: &str, marks: &str) -> String {
        // With a sign at either end that says that the line goes on.
        let room = self.width.saturating_sub(2).max(1);
        let (start, end) = (leading(marks), columns(marks).min(leading(marks) + room));
        let left_out = end.saturating_sub(room * 2 / 3).min(start);
        let rest = &line[first_columns(line, left_out).len()..];
        let (rest, sign) = if left_out > 0 { (rest, "…") } else { (line, "") };
        let shown = first_columns(rest, room);
        let more = if shown.len() < rest.len() { "…" } else { "" };
        let blanks = " ".repeat(start - left_out + sign.chars().count());
        format!("{sign}{shown}{more}\n{blanks}{}\n", "^".repeat(end - start))
    }

    /// A line that may be too long, as several.
    fn lines(self, line: &str, indent: usize, keeps_blanks: bool) -> Vec<String> {
        if columns(line) <= self.width {
            return vec![line.to_owned()];
        }
        let start = leading(line);
        let words = Words(&line[start..]).map(|(gap, word)| if keeps_blanks { (gap, word) } else { (" ", word) });
        self.broken(" ".repeat(start), indent.min(self.width / 2), words)
    }

    /// Words in lines: the first line begins with `first`, the others are set in.
    fn broken<'a>(self, first: String, indent: usize, words: impl Iterator<Item = (&'a str, &'a str)>) -> Vec<String> {
        let mut line = first;
        let (mut lines, mut length, mut is_empty) = (Vec::new(), columns(&line), true);
        let room = self.width.saturating_sub(indent).max(1);
        for (gap, word) in words {
            let mut word = word;
            let gap = if is_empty { "" } else { gap };
            let is_too_long = length + columns(gap) + columns(word) > self.width;
            // A word that has to be broken begins where there is room.
            let is_broken = self.breaks_words && columns(word) > room && length + LEAST_PART <= self.width;
            if !is_empty && is_too_long && !is_broken {
                lines.push(std::mem::replace(&mut line, " ".repeat(indent)));
                length = indent;
            } else {
                line += gap;
                length += columns(gap);
            }
            while self.breaks_words && length + columns(word) > self.width {
                let (part, rest) = split_at(word, self.width.saturating_sub(length).clamp(1, room));
                line += part;
                lines.push(std::mem::replace(&mut line, " ".repeat(indent)));
                (word, length) = (rest, indent);
            }
            line += word;
            length += columns(word);
            is_empty = false;
        }
        lines.push(line);
        lines
    }
}

/// Columns that a line takes on a terminal, without its colours.
pub fn columns(text: &str) -> usize {
    let mut rest = text;
    let mut sum = 0;
    while let Some(sign) = rest.chars().next() {
        let taken = escape(rest);
        if taken == 0 {
            sum += sign.width().unwrap_or(0);
        }
        rest = &rest[taken.max(sign.len_utf8())..];
    }
    sum
}

/// The first characters of `text` that take no more columns than these, and at least one character.
pub fn first_columns(text: &str, most: usize) -> &str {
    let (mut sum, mut end) = (0, 0);
    while let Some(sign) = text[end..].chars().next() {
        let taken = escape(&text[end..]);
        let width = if taken == 0 { sign.width().unwrap_or(0) } else { 0 };
        if sum + width > most && end > 0 {
            break;
        }
        sum += width;
        end += taken.max(sign.len_utf8());
    }
    &text[..end]
}

/// Bytes of a colour (`ESC [ … m`) with which `text` begins; 0 if there is none.
fn escape(text: &str) -> usize {
    let Some(rest) = text.strip_prefix("\u{1b}[") else { return 0 };
    rest.find(|sign: char| sign.is_ascii_alphabetic()).map_or(0, |end| end + 3)
}

/// Whether a line only marks places of the line above it.
fn is_of_marks(line: &str) -> bool {
    line.contains('^') && line.trim_end().chars().all(|sign| matches!(sign, ' ' | '^'))
}

/// Blanks at the beginning.
fn leading(line: &str) -> usize {
    line.len() - line.trim_start_matches(' ').len()
}

/// A word in two, the first of at most so many columns: behind a sign at which an address or a path is often divided, if
/// there is one in its second half.
fn split_at(word: &str, most: usize) -> (&str, &str) {
    let first = first_columns(word, most);
    let divided = first.rfind(['/', ',', ';', '&', '=', '_', '-', '.']).map(|at| at + 1);
    let at = divided.filter(|at| 2 * at > first.len()).unwrap_or(first.len());
    word.split_at(at)
}

/// Words with the blanks before them.
struct Words<'a>(&'a str);

impl<'a> Iterator for Words<'a> {
    type Item = (&'a str, &'a str);

    fn next(&mut self) -> Option<Self::Item> {
        let start = leading(self.0);
        let end = self.0[start..].find(' ').map_or(self.0.len(), |at| start + at);
        let (gap, word) = (&self.0[..start], &self.0[start..end]);
        self.0 = &self.0[end..];
        (!word.is_empty()).then_some((gap, word))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_text_is_broken_between_words_and_stays_under_its_beginning() {
        for width in [60, 80, 100] {
            let text = TextLayout::for_columns(width).wrapped("  - ", &"word ".repeat(40));
            assert!(text.lines().all(|line| columns(line) <= width), "{text}");
            assert!(text.lines().skip(1).all(|line| line.starts_with("    word")));
            assert_eq!(text.split_whitespace().count(), 41);
        }
    }

    #[test]
    fn beside_a_long_lead_the_text_begins_under_it() {
        let lead = "a name and its number ".repeat(3);
        let text = TextLayout::for_columns(80).wrapped(&lead, &"word ".repeat(20));
        assert!(text.lines().skip(1).all(|line| line.starts_with("      word")), "{text}");
        assert_eq!(TextLayout::default().wrapped(&lead, "").lines().count(), 1);
        let narrow = TextLayout::for_columns(60).wrapped(&lead, "word");
        assert!(narrow.lines().all(|line| columns(line) <= 60), "{narrow}");
    }

    #[test]
    fn a_word_longer_than_the_line_is_broken_in_a_terminal_and_stays_whole_in_a_pipe() {
        let word = format!("https://example.org/{}", "folder/".repeat(30));
        assert_eq!(TextLayout::default().wrapped("", &word), format!("{word}\n"));
        let broken = TextLayout::for_columns(80).wrapped("at ", &word);
        assert!(broken.lines().all(|line| columns(line) <= 80), "{broken}");
        assert!(broken.lines().next().is_some_and(|line| line.ends_with('/')), "{broken}");
        assert_eq!(broken.split_whitespace().skip(1).collect::<String>(), word);
        assert_eq!(TextLayout::default().wrapped("a ", ""), "a\n");
    }

    #[test]
    fn wide_signs_accents_and_colours_take_the_columns_that_a_terminal_gives_them() {
        assert_eq!(["φ̇", "１２", "表", "\u{1b}[1m\u{1b}[31ma\u{1b}[0m", "e\u{301}"].map(columns), [1, 4, 2, 1, 1]);
        assert_eq!(first_columns("表表表", 5), "表表");
        let text = TextLayout::for_columns(60).wrapped("", &"表".repeat(100));
        assert!(text.lines().all(|line| columns(line) <= 60), "{text}");
    }

    #[test]
    fn marks_stay_under_what_they_mark() {
        for at in [0, 3, 40, 90, 137] {
            let line = format!("{}{}{}", "a".repeat(at), "xx", "b".repeat(140 - at));
            let text = format!("    {line}\n    {}^^\nend\n", " ".repeat(at));
            let folded = TextLayout::for_columns(60).folded(&text);
            let lines: Vec<Vec<char>> = folded.lines().map(|line| line.chars().collect()).collect();
            assert!(lines.len() == 3 && lines.iter().all(|line| line.len() <= 60), "{folded}");
            let marked: String =
                lines[0].iter().zip(&lines[1]).filter(|(_, mark)| **mark == '^').map(|(sign, _)| sign).collect();
            assert_eq!(marked, "xx", "{folded}");
        }
        let wide = format!("{}\n{}\n", "a".repeat(200), "^".repeat(200));
        assert!(TextLayout::for_columns(60).folded(&wide).lines().all(|line| columns(line) <= 60));
    }

    #[test]
    fn a_folded_text_keeps_its_lines_and_its_blanks() {
        let long = format!("  a   table\n    {}\nend", "word ".repeat(30).trim_end());
        let folded = TextLayout::for_columns(60).folded(&long);
        assert!(folded.starts_with("  a   table\n    word") && folded.ends_with("word\nend"), "{folded}");
        assert!(folded.lines().all(|line| columns(line) <= 60), "{folded}");
        assert!(folded.lines().skip(1).filter(|line| *line != "end").all(|line| line.starts_with("    word")));
    }
}
