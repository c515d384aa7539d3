//! What a text shows to its readers, with the place of each character in the file: running text and formulas.
//!
//! Programs that look for something else than chains share the reading of the formats with the proofreader. A formula stays as it
//! is written, in TeX. What no reader sees is left out and counted.

use super::definitions::{defines, definition};
use super::latex::{group_text, is_verbatim};
use super::markup::INLINE;
use super::notebook;
use super::running::RunningText;
use super::tags::{Tag, decode_entities, end_of_element, next_tag};
use super::{LONGEST, TextFormat, UnreadableText, withdrawn_ranges};
use crate::order::sort_by_place;
use crate::token::Span;
use pulldown_cmark::{Event, Options, Parser, Tag as MarkdownTag, TagEnd};
use std::ops::Range;

/// Why a stretch of a text is not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LeftOut {
    /// Code, or what a program prints.
    Code,
    /// A comment, or what is struck out.
    Comment,
    /// The arguments of a command or a tag: sizes, labels, addresses.
    Argument,
    /// What comes before the text or defines macros.
    Preamble,
}

impl LeftOut {
    /// All kinds with their names, in the plural.
    pub const ALL: [(&'static str, Self); 4] = [
        ("pieces of code", Self::Code),
        ("comments", Self::Comment),
        ("arguments", Self::Argument),
        ("preambles and definitions", Self::Preamble),
    ];

    /// The name of a kind for one stretch, from its name in the plural.
    pub fn singular(name: &str) -> &str {
        match name {
            "pieces of code" => "piece of code",
            "comments" => "comment",
            "arguments" => "argument",
            _ => "preamble or definition",
        }
    }
}

/// What ends a row of a table in HTML and XML, where cells are paragraphs: a white space that no text has.
pub const ROW_END: char = '\u{b}';

/// The characters that readers see, and where each of them is in the file.
///
/// A blank line ends a paragraph, a heading, an item or a cell, whatever the format; [`ROW_END`] ends a row in HTML and XML.
#[derive(Default)]
pub struct ShownText {
    lines: RunningText,
    left_out: [usize; LeftOut::ALL.len()],
}

impl ShownText {
    /// The characters.
    pub fn text(&self) -> &str {
        &self.lines.text
    }

    /// Where a stretch of the characters is in the file.
    pub fn span_in_file(&self, shown: Span) -> Span {
        self.lines.span_in_page(shown)
    }

    /// How many stretches of a kind were left out that contain a digit.
    pub fn left_out(&self, kind: LeftOut) -> usize {
        self.left_out[kind as usize]
    }

    fn leave_out(&mut self, kind: LeftOut, what: &str) {
        self.left_out[kind as usize] += usize::from(what.bytes().any(|byte| byte.is_ascii_digit()));
    }

    /// Adds part of the text but for what is to be left out, whose ranges are in the part and may overlap.
    fn add_without(&mut self, part: &str, base: usize, mut without: Vec<(Range<usize>, LeftOut)>) {
        sort_by_place(&mut without, |(range, _)| (range.start, usize::MAX - range.end));
        let mut at = 0;
        for (range, kind) in without {
            if range.start < at {
                // What is in something that is left out is counted with it.
                self.add(part, base, at..at.max(range.start));
                at = at.max(range.end);
                continue;
            }
            self.add(part, base, at..range.start);
            self.leave_out(kind, &part[range.clone()]);
            // What is left and right of it must not become one word.
            let ends_lines = part[range.clone()].contains("\n\n");
            let place = Span::new(base + range.start, base + range.end);
            self.lines.push(if ends_lines { '\n' } else { ' ' }, place);
            at = range.end;
        }
        self.add(part, base, at..part.len());
    }

    fn add(&mut self, part: &str, base: usize, range: Range<usize>) {
        for (at, c) in part.get(range.clone()).unwrap_or_default().char_indices() {
            let start = base + range.start + at;
            self.lines.push(c, Span::new(start, start + c.len_utf8()));
        }
    }
}

/// Reads what a text shows.
///
/// # Errors
///
/// If the text is too long, or is no notebook where it should be one.
///
/// ```
/// use proofread::{Span, TextFormat, reader};
///
/// let page = "<p title=\"2\">It is 2&nbsp;<b>m</b>.</p>";
/// let shown = reader::shown_text(page, TextFormat::Html)?;
/// assert_eq!(shown.text().trim(), "It is 2 m.");
/// let at = shown.text().find('m').expect("a unit");
/// assert_eq!(&page[shown.span_in_file(Span::new(at, at + 1)).range()], "m");
/// assert_eq!(shown.left_out(reader::LeftOut::Argument), 1);
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
pub fn shown_text(text: &str, format: TextFormat) -> Result<ShownText, UnreadableText> {
    if text.len() > LONGEST {
        return Err(UnreadableText::TooLong);
    }
    let mut shown = ShownText::default();
    match format {
        TextFormat::Markdown => markdown(text, &mut shown),
        TextFormat::Latex => latex(text, &mut shown),
        TextFormat::Xml | TextFormat::Html => markup(text, format, &mut shown),
        TextFormat::Plain | TextFormat::Csv => shown.add(text, 0, 0..text.len()),
        TextFormat::Notebook => {
            let others = notebook::markdown_cells(text, &mut |decoded, places| {
                let mut cell = ShownText::default();
                markdown(decoded, &mut cell);
                for (at, c) in cell.text().char_indices() {
                    let place = cell.span_in_file(Span::new(at, at + c.len_utf8()));
                    shown.lines.push(c, notebook::in_notebook(places, place));
                }
                let end = notebook::in_notebook(places, Span::new(decoded.len(), decoded.len()));
                "\n\n".chars().for_each(|c| shown.lines.push(c, end));
                for (mine, its) in shown.left_out.iter_mut().zip(cell.left_out) {
                    *mine += its;
                }
            })?;
            shown.left_out[LeftOut::Code as usize] += others;
        }
    }
    Ok(shown)
}

fn markdown(text: &str, shown: &mut ShownText) {
    let front = text.strip_prefix("---\n").and_then(|rest| rest.find("\n---\n")).map_or(0, |end| end + 4 + 5);
    shown.leave_out(LeftOut::Preamble, &text[..front]);
    let text = &text[front..];
    for piece in super::markdown::pieces(text) {
        let part = &text[piece.clone()];
        let without = unseen_in_markdown(part);
        shown.add_without(part, front + piece.start, without);
    }
}

fn unseen_in_markdown(text: &str) -> Vec<(Range<usize>, LeftOut)> {
    let kind_of = |range: &Range<usize>| match text[range.clone()].starts_with("://") {
        true => LeftOut::Argument,
        false => LeftOut::Comment,
    };
    let mut out: Vec<_> = withdrawn_ranges(text).into_iter().map(|range| (range.clone(), kind_of(&range))).collect();
    // Where the text of the innermost link ends so far.
    let mut links: Vec<usize> = Vec::new();
    for (event, range) in Parser::new_ext(text, Options::empty()).into_offset_iter() {
        match event {
            Event::Start(MarkdownTag::CodeBlock(_)) | Event::Code(_) => out.push((range, LeftOut::Code)),
            Event::Start(MarkdownTag::Link { .. } | MarkdownTag::Image { .. }) => links.push(range.start),
            Event::End(TagEnd::Link | TagEnd::Image) => {
                let inside = links.pop().unwrap_or(range.start);
                if let Some(close) = text.get(inside..range.end).and_then(|rest| rest.find("](")) {
                    out.push((inside + close..range.end, LeftOut::Argument));
                }
                if let Some(outer) = links.last_mut() {
                    *outer = range.end;
                }
            }
            Event::Text(_) => links.iter_mut().for_each(|end| *end = (*end).max(range.end)),
            Event::InlineHtml(_) => out.push((range, LeftOut::Argument)),
            Event::Start(MarkdownTag::HtmlBlock) => {
                let block = &text[range.clone()];
                let mut at = 0;
                while let Some(tag) = next_tag(block, at) {
                    let is_code = !tag.closes && SILENT.contains(&tag.name.as_str());
                    at = if is_code { end_of_element(block, tag.end, &tag.name) } else { tag.end };
                    let kind = if is_code { LeftOut::Code } else { LeftOut::Argument };
                    out.push((range.start + tag.start..range.start + at, kind));
                }
            }
            _ => {}
        }
    }
    out.extend(filled_in(text).map(|range| (range, LeftOut::Argument)));
    out
}

/// What another program fills in or takes out before a text is shown: `{{ page.date }}`, `{{#include a.rs}}`, `{#id}`.
fn filled_in(text: &str) -> impl Iterator<Item = Range<usize>> {
    /// Longest expression, in bytes.
    const LONGEST: usize = 1000;
    let openings = text.match_indices('{').map(|(at, _)| at);
    openings.filter_map(move |at| {
        // In TeX, such braces hold an argument, an exponent or an index.
        let before = text[..at].trim_end_matches(|c: char| c.is_ascii_alphabetic());
        if before.ends_with('\\') || text[..at].ends_with(['{', '^', '_']) {
            return None;
        }
        let rest = &text[at + 1..];
        let (inside, close) = match rest.strip_prefix('{') {
            Some(inside) => (inside, "}}"),
            None if rest.starts_with('#') => (rest, "}"),
            None => return None,
        };
        let name = inside.trim_start_matches([' ', '#', '%', '<', '>', '~', '-']);
        let is_named = name.bytes().take(2).filter(u8::is_ascii_alphabetic).count() == 2;
        let end = inside.bytes().take(LONGEST).position(|byte| byte == b'}')?;
        let closes = inside[end..].starts_with(close) && !inside[..end].contains("\n\n");
        let behind = text.len() - inside.len() + end + close.len();
        (is_named && closes).then_some(at..behind)
    })
}

/// Commands of LaTeX whose arguments no reader sees as numbers, and how many arguments in braces they have.
const UNSEEN: [(&str, usize); 41] = [
    ("end", 1),
    ("label", 1),
    ("ref", 1),
    ("eqref", 1),
    ("pageref", 1),
    ("autoref", 1),
    ("cref", 1),
    ("Cref", 1),
    ("cite", 1),
    ("citep", 1),
    ("citet", 1),
    ("parencite", 1),
    ("textcite", 1),
    ("nocite", 1),
    ("includegraphics", 1),
    ("usepackage", 1),
    ("documentclass", 1),
    ("input", 1),
    ("include", 1),
    ("bibliography", 1),
    ("bibliographystyle", 1),
    ("bibitem", 1),
    ("hspace", 1),
    ("vspace", 1),
    ("url", 1),
    ("href", 1),
    ("color", 1),
    ("textcolor", 1),
    ("linespread", 1),
    ("pagestyle", 1),
    ("setlength", 2),
    ("addtolength", 2),
    ("setcounter", 2),
    ("addtocounter", 2),
    ("fontsize", 2),
    ("rule", 2),
    ("definecolor", 3),
    ("sisetup", 1),
    ("hypersetup", 1),
    ("cmidrule", 1),
    ("cline", 1),
];

fn latex(text: &str, shown: &mut ShownText) {
    const BEGIN: &str = "\\begin{document}";
    let begin = text.find(BEGIN).map_or(0, |at| at + BEGIN.len());
    shown.leave_out(LeftOut::Preamble, &text[..begin]);
    let body = &text[begin..];
    let end = body.find("\\end{document}").unwrap_or(body.len());
    shown.leave_out(LeftOut::Comment, &body[end..]);
    let body = &body[..end];
    let (mut out, mut at) = (Vec::new(), 0);
    let bytes = body.as_bytes();
    while at < bytes.len() {
        let (next, kind) = match bytes[at] {
            b'%' => (body[at..].find('\n').map_or(body.len(), |end| at + end), Some(LeftOut::Comment)),
            b'\\' => command(body, at),
            _ => (at + 1, None),
        };
        let next = (next.max(at + 1)..=body.len()).find(|at| body.is_char_boundary(*at)).unwrap_or(body.len());
        if let Some(kind) = kind {
            out.push((at..next, kind));
        }
        at = next;
    }
    shown.add_without(body, begin, out);
}

/// Where a command ends that begins at `at`, and why it isn't read; it is read if there is no reason.
pub(super) fn command(text: &str, at: usize) -> (usize, Option<LeftOut>) {
    let rest = &text[at + 1..];
    let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
    let (name, behind) = (&rest[..length], at + 1 + length);
    match name {
        "" if rest.starts_with('\\') => {
            let end = arguments(text, at + 2, 0);
            (end, (end > at + 2).then_some(LeftOut::Argument))
        }
        "" => (at + 2, None),
        "begin" => {
            let Some(name) = group_text(text, behind) else { return (behind, None) };
            let open = text[behind..].find('}').map_or(behind, |close| behind + close + 1);
            if !is_verbatim(name) {
                let braces =
                    usize::from(["tabular", "array", "tabularx", "minipage", "thebibliography"].contains(&name));
                return (arguments(text, open, braces), Some(LeftOut::Argument));
            }
            let end = format!("\\end{{{name}}}");
            let end = text[open..].find(&end).map_or(text.len(), |found| open + found + end.len());
            (end, Some(if name == "comment" { LeftOut::Comment } else { LeftOut::Code }))
        }
        "iffalse" => {
            let end = rest.find("\\fi").map_or(text.len(), |end| at + 1 + end + 3);
            (end, Some(LeftOut::Comment))
        }
        "verb" | "lstinline" => {
            let mark = text[behind..].chars().next().unwrap_or('|');
            // It ends in its line, and near.
            let line = text[behind..].char_indices().skip(1).take(1000).take_while(|(_, c)| *c != '\n');
            let end = { line }.find(|(_, c)| *c == mark).map_or(behind, |(end, _)| behind + end + mark.len_utf8());
            (end, Some(LeftOut::Code))
        }
        name if defines(name) => (definition(text, at).map_or(behind, |(_, _, end)| end), Some(LeftOut::Preamble)),
        name => match UNSEEN.iter().find(|(known, _)| *known == name) {
            Some((_, braces)) => (arguments(text, behind, *braces), Some(LeftOut::Argument)),
            None => (behind, None),
        },
    }
}

/// Where the arguments end that begin at `at`: any number in square brackets, and so many in braces.
fn arguments(text: &str, mut at: usize, mut braces: usize) -> usize {
    /// Longest argument, in bytes.
    const LONGEST: usize = 1000;
    at += usize::from(text[at..].starts_with('*'));
    loop {
        let rest = &text.as_bytes()[at..];
        let close = match rest.first() {
            Some(b'[') => b']',
            Some(b'{') if braces > 0 => b'}',
            // The range of a rule in a table.
            Some(b'(') if braces > 0 => b')',
            _ => return at,
        };
        let mut depth = 0usize;
        let end = rest.iter().take(LONGEST).position(|byte| {
            depth += usize::from(*byte == rest[0]);
            depth -= usize::from(*byte == close);
            depth == 0
        });
        let Some(end) = end else { return at };
        braces -= usize::from(close == b'}');
        at += end + 1;
    }
}

/// Elements whose text is no running text.
const SILENT: [&str; 10] =
    ["script", "style", "code", "pre", "annotation", "svg", "kbd", "samp", "textarea", "programlisting"];
/// Elements that do not end a paragraph, beside those that are known to end no sentence.
const PHRASES: [&str; 30] = [
    "tt",
    "var",
    "abbr",
    "acronym",
    "big",
    "cite",
    "q",
    "ins",
    "label",
    "bdi",
    "bdo",
    "dfn",
    "wbr",
    "math",
    "mi",
    "mn",
    "mo",
    "mrow",
    "mtext",
    "quantity",
    "time",
    "data",
    "italic",
    "bold",
    "underline",
    "sc",
    "roman",
    "xref",
    "styled-content",
    "named-content",
];

fn markup(text: &str, format: TextFormat, shown: &mut ShownText) {
    let mut at = 0;
    while let Some(tag) = next_tag(text, at) {
        prose(text, at..tag.start, shown);
        at = element(text, &tag, format, shown);
    }
    prose(text, at..text.len(), shown);
}

/// Takes a tag, with what is in its element if that is not shown; the byte behind it.
fn element(text: &str, tag: &Tag<'_>, format: TextFormat, shown: &mut ShownText) -> usize {
    let (name, place) = (tag.name.as_str(), Span::new(tag.start, tag.end));
    let mut push = |what: &str| what.chars().for_each(|c| shown.lines.push(c, place));
    match name {
        "sup" => push(if tag.closes { ")" } else { "^(" }),
        "sub" => push(if tag.closes { ")" } else { "_(" }),
        _ if INLINE.contains(&name) || PHRASES.contains(&name) => {}
        // Cut out of the line, which goes on.
        "code" | "kbd" | "samp" | "annotation" => push(" "),
        "tr" | "row" => push("\n\n\u{b}"),
        _ => push("\n\n"),
    }
    shown.leave_out(LeftOut::Argument, &text[place.range()]);
    let is_head = match format {
        TextFormat::Html => ["title", "template", "noscript"].contains(&name),
        _ => name == "metadata",
    };
    let is_struck = ["del", "s", "strike"].contains(&name);
    if tag.closes || tag.empty || !(SILENT.contains(&name) || is_head || is_struck) {
        return tag.end;
    }
    let end = end_of_element(text, tag.end, name);
    shown.leave_out(if is_struck { LeftOut::Comment } else { LeftOut::Code }, &text[tag.end..end]);
    end
}

/// Adds text between tags, in which there may be comments, declarations and instructions.
fn prose(text: &str, range: Range<usize>, shown: &mut ShownText) {
    let mut at = range.start;
    while let Some(rest) = text.get(at..range.end).filter(|rest| !rest.is_empty()) {
        let hidden = rest.match_indices('<').map(|(at, _)| at).find(|at| rest[at + 1..].starts_with(['!', '?']));
        let seen = &rest[..hidden.unwrap_or(rest.len())];
        decode_entities(seen, at).into_iter().for_each(|sign| shown.lines.push(sign.c, sign.span));
        let Some(hidden) = hidden else { break };
        let close = if rest[hidden..].starts_with("<!--") { "-->" } else { ">" };
        let end = rest[hidden..].find(close).map_or(rest.len(), |end| hidden + end + close.len());
        shown.leave_out(LeftOut::Comment, &rest[hidden..end]);
        at += end;
    }
}
