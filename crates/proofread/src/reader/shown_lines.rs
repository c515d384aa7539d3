//! What each line of a file shows to readers, for whoever counts a text's numbers by its lines.

use super::{TextFormat, UnreadableText, markdown, shown_text};
use crate::token::Span;
use pulldown_cmark::{Event, Options, Parser, Tag};
use std::ops::Range;

/// Tags that part the digits on their sides: MathML's numbers, raised and lowered signs. A line break parts all characters.
const PARTING: [&str; 3] = ["mn", "sup", "sub"];

/// The shown characters of each line of a file, in the order of the lines: what is markup, code, comment or address is left out, and
/// the numbers of a list in Markdown are, too. A line that shows nothing is empty.
///
/// In a notebook these are the lines of its file, of which only those with Markdown show something.
///
/// # Errors
///
/// As [`shown_text`], and for a notebook whose file has several lines of its Markdown in one.
///
/// ```
/// use proofread::{TextFormat, reader};
///
/// let page = "# A fall\n\n<!-- 7 -->\n1. It falls for `2` 3.19 s.\n";
/// let lines = reader::shown_lines(page, TextFormat::Markdown)?;
/// assert_eq!(lines.len(), 4);
/// assert_eq!(lines[3].split_whitespace().collect::<Vec<_>>(), [".", "It", "falls", "for", "3.19", "s."]);
/// assert!(lines[2].trim().is_empty());
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
pub fn shown_lines(text: &str, format: TextFormat) -> Result<Vec<String>, UnreadableText> {
    let shown = shown_text(text, format)?;
    let starts: Vec<usize> = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
    let markers = if format == TextFormat::Markdown { list_numbers(text) } else { Vec::new() };
    let mut lines = vec![String::new(); text.lines().count()];
    let mut before = Span::new(0, 0);
    // The line that ended last in a notebook's Markdown.
    let mut ended = None;
    for (at, c) in shown.text().char_indices() {
        let place = shown.span_in_file(Span::new(at, at + c.len_utf8()));
        let start = place.range().start;
        let number = starts.partition_point(|line| *line <= start).saturating_sub(1);
        let Some(line) = lines.get_mut(number) else { break };
        if format == TextFormat::Notebook {
            if c == '\n' {
                ended = Some(number);
            } else if !c.is_whitespace() && ended == Some(number) {
                return Err(UnreadableText::LinesInOne);
            }
        }
        let marker = markers.get(markers.partition_point(|marker| marker.end <= start));
        let is_marker = marker.is_some_and(|marker| marker.contains(&start));
        if c.is_whitespace() || is_marker {
            line.push(' ');
        } else {
            let between = text.get(before.range().end..start).unwrap_or_default();
            let [is_digit, was_digit] = [c.is_ascii_digit(), line.ends_with(|c: char| c.is_ascii_digit())];
            if is_digit && was_digit && has_tag(between, &PARTING) || has_tag(between, &["br", "newline"]) {
                line.push(' ');
            }
            line.push(c);
        }
        before = place;
    }
    Ok(lines)
}

/// Whether a stretch of markup has a tag of one of these names.
fn has_tag(between: &str, names: &[&str]) -> bool {
    let tags = between.split('<').skip(1).map(|tag| tag.trim_start_matches('/').split([' ', '>', '/']).next());
    // A name may begin with that of its space: `m:mn`.
    tags.flatten().any(|tag| names.contains(&tag.rsplit(':').next().unwrap_or_default()))
}

/// Where the numbers are that a text in Markdown gives the items of its lists: a page counts them itself.
fn list_numbers(text: &str) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    for piece in markdown::pieces(text) {
        for (event, range) in Parser::new_ext(&text[piece.clone()], Options::empty()).into_offset_iter() {
            if let Event::Start(Tag::Item) = event {
                let start = piece.start + range.start;
                let digits = text[start..].bytes().take_while(u8::is_ascii_digit).count();
                found.push(start..start + digits);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str, format: TextFormat) -> Vec<String> {
        let lines = shown_lines(text, format).expect("a text");
        lines.iter().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
    }

    #[test]
    fn each_character_is_in_the_line_of_the_file_where_it_is() {
        let tex = "\\documentclass[12pt]{article}\n\\begin{document}\nA % 3\n\\label{eq:4} $v = 5$\n\\end{document}\n";
        assert_eq!(shown(tex, TextFormat::Latex), ["", "", "A", "$v = 5$", ""]);
        let page =
            "<p id=\"2\">\nIt is 10<sup>3</sup> m,<br>1<td>2</td>\n<style>\na { width: 7px }\n</style>\nor 8.</p>";
        assert_eq!(shown(page, TextFormat::Html), ["", "It is 10^(3) m, 1 2", "", "", "", "or 8."]);
        let xml = "<para id=\"p-9\">It is 10<sup>3</sup>,\n<m:math><m:mn>4</m:mn><m:mn>5</m:mn><m:mo>=</m:mo><m:mn>3</m:mn><m:mtext>.</m:mtext><m:mn>0</m:mn></m:math> <b>6</b>7</para>\n";
        assert_eq!(shown(xml, TextFormat::Xml), ["It is 10^(3),", "4 5=3.0 67"]);
        assert_eq!(shown("1 and\r\n\r\n2", TextFormat::Plain), ["1 and", "", "2"]);
        assert!(shown("", TextFormat::Plain).is_empty());
    }

    #[test]
    fn a_list_in_markdown_counts_its_items_itself() {
        let text =
            "---\ndate: 2020\n---\nFirst 5\n2. is text\n\n3) an item of 7\n   8. no item\n\n    9 code\n[a](b3)\n";
        let lines = shown(text, TextFormat::Markdown);
        assert_eq!(
            lines,
            ["", "", "", "First 5", "2. is text", "", ") an item of 7", "8. no item", "", "9 code", "[a"]
        );
    }

    #[test]
    fn a_notebook_is_read_by_the_lines_of_its_file_if_they_are_those_of_its_markdown() {
        let cell = "{\"cells\": [{\"cell_type\": \"markdown\",\n\"source\": [\n\"It is 2.5 m\\n\",\n\"and 3.\"]}]}";
        assert_eq!(shown(cell, TextFormat::Notebook), ["", "", "It is 2.5 m", "and 3."]);
        let one = cell.replace('\n', "");
        assert_eq!(shown_lines(&one, TextFormat::Notebook), Err(UnreadableText::LinesInOne));
    }
}
