//! The running text of a page in HTML or XML or of a document in LaTeX: its lines as they are shown, and where each part of them is.

use super::markup::INLINE;
use super::tags::{Tag, decode_entities, end_of_element, next_tag};
use super::{FormulaSink, delimited, plain};
use crate::order::sort_by_place;
use crate::token::{SourceChar, Span};
use std::ops::Range;

/// Elements that are cut out of a line.
const CUT: [&str; 17] = [
    "code",
    "script",
    "style",
    "annotation",
    "math",
    "svg",
    "button",
    "kbd",
    "samp",
    "del",
    "s",
    "strike",
    "canvas",
    "object",
    "iframe",
    "video",
    "audio",
];
/// Elements of other documents in XML that are cut out of a line: formulas in TeX, code, and what is drawn.
const CUT_IN_XML: [&str; 17] = [
    "m",
    "c",
    "cd",
    "sage",
    "program",
    "input",
    "output",
    "console",
    "image",
    "latex-image",
    "asymptote",
    "pg-code",
    "programlisting",
    "screen",
    "literallayout",
    "xref",
    "idx",
];
/// Elements of other documents in XML that are cut out and end the line.
const CUT_BLOCKS_IN_XML: [&str; 10] =
    ["me", "men", "md", "mdn", "metadata", "docinfo", "macros", "featured-links", "webwork", "setup"];
/// Elements that are cut out and end the line.
const CUT_BLOCKS: [&str; 7] = ["title", "pre", "nav", "textarea", "select", "noscript", "template"];
/// Elements that do not end a line, beside those that are known to end no sentence.
const PHRASES: [&str; 14] =
    ["tt", "var", "abbr", "acronym", "big", "cite", "q", "ins", "label", "bdi", "bdo", "dfn", "wbr", "nobr"];
/// Elements without content.
const VOID: [&str; 11] = ["img", "br", "newline", "input", "hr", "meta", "link", "wbr", "col", "area", "source"];
/// Stands for what is cut out of a line.
const EDGE: char = '\u{fffc}';

/// An index or an exponent that is open.
struct Script {
    /// Where its mark is in the lines.
    start: usize,
    /// Whether it leads to a note.
    links: bool,
}

/// The lines of a page, with exponents behind `^`, indices behind `_`, and a sign for what is cut out.
#[derive(Default)]
pub(crate) struct RunningText {
    pub text: String,
    /// What is no running text, in bytes of the lines.
    cut: Vec<Range<usize>>,
    /// Stretches of the page, each with the byte of the lines at which it begins; one as long as in the page is there as it is here.
    places: Vec<(usize, Span)>,
    scripts: Vec<Script>,
    /// How long the lines were behind the last underlined words, which may stand above a stroke.
    underlined: usize,
    /// Whether the page is in another language of XML than HTML.
    is_xml: bool,
}

impl RunningText {
    /// The lines of a page in HTML.
    pub(super) fn from_page(page: &str) -> Self {
        Self::from_tags(page, Self::default())
    }

    /// The lines of a document in another language of XML, such as CNXML or PreTeXt.
    pub(super) fn from_xml(page: &str) -> Self {
        Self::from_tags(page, Self { is_xml: true, ..Self::default() })
    }

    fn from_tags(page: &str, mut out: Self) -> Self {
        let mut at = 0;
        while let Some(tag) = next_tag(page, at) {
            out.prose(page, at..tag.start);
            at = out.tag(page, &tag);
        }
        out.prose(page, at..page.len());
        out.block(Span::new(page.len(), page.len()));
        let marked = delimited::formulas(&out.text, &[], delimited::Dollars::Single);
        out.cut.extend(marked.into_iter().map(|of| of.whole));
        sort_by_place(&mut out.cut, |range| range.start);
        out
    }

    /// Finds the formulas in the lines; their places are in the lines, too.
    pub(crate) fn read(&self, each: &mut FormulaSink<'_>) {
        plain::read(&self.text, &self.cut, each);
    }

    /// Where a stretch of the lines is in the page.
    pub(crate) fn span_in_page(&self, span: Span) -> Span {
        let of = |byte: u32| {
            let at = self.places.partition_point(|(start, _)| *start <= byte as usize).max(1) - 1;
            let (start, page) = self.places.get(at).copied().unwrap_or_default();
            let end = self.places.get(at + 1).map_or(self.text.len(), |(next, _)| *next);
            let within = byte.saturating_sub(Span::new(start, start).start);
            let verbatim = page.range().len() == end - start;
            if verbatim { Span { start: page.start + within, end: page.start + within + 1 } } else { page }
        };
        let start = of(span.start).start;
        Span { start, end: span.end.checked_sub(1).map_or(start, |last| of(last).end.max(start)) }
    }

    pub(super) fn push(&mut self, c: char, page: Span) {
        let length = c.len_utf8();
        match self.places.last_mut() {
            Some((start, last))
                if page.range().len() == length
                    && last.end == page.start
                    && last.range().len() == self.text.len() - *start =>
            {
                last.end = page.end;
            }
            _ => self.places.push((self.text.len(), page)),
        }
        self.text.push(c);
    }

    pub(super) fn edge(&mut self, page: Span) {
        let start = self.text.len();
        self.push(EDGE, page);
        self.cut.push(start..self.text.len());
    }

    /// Ends a line, and what adjoins in it.
    fn block(&mut self, page: Span) {
        while !self.scripts.is_empty() {
            self.close_script(page);
        }
        while !self.text.ends_with("\n\n\n") {
            self.push('\n', page);
        }
    }

    fn prose(&mut self, page: &str, range: Range<usize>) {
        let mut at = range.start;
        while let Some(rest) = page.get(at..range.end).filter(|rest| !rest.is_empty()) {
            // Comments, declarations and instructions.
            let mut marks = rest.match_indices('<').map(|(at, _)| at);
            let hidden = marks.find(|at| rest[at + 1..].starts_with(['!', '?']));
            let shown = &rest[..hidden.unwrap_or(rest.len())];
            decode_entities(shown, at).into_iter().for_each(|sign| self.sign(sign));
            let Some(hidden) = hidden else { break };
            let close = if rest[hidden..].starts_with("<!--") { "-->" } else { ">" };
            at += rest[hidden..].find(close).map_or(rest.len(), |end| hidden + end + close.len());
        }
    }

    fn sign(&mut self, SourceChar { c, span }: SourceChar) {
        if c.is_ascii_whitespace() && span.range().len() == 1 {
            if !self.text.is_empty() && !self.text.ends_with([' ', '\n']) {
                self.push(' ', span);
            }
            return;
        }
        // A block that begins with such a sign may go on with the one above it.
        if "=/×·÷".contains(c) && self.text.ends_with("\n\n\n") {
            self.truncate(self.text.len() - 2);
        }
        self.push(c, span);
    }

    fn truncate(&mut self, length: usize) {
        self.text.truncate(length);
        while self.places.pop_if(|(start, _)| *start >= length).is_some() {}
        while self.cut.pop_if(|range| range.end > length).is_some() {}
    }

    /// Takes a tag, with what is in its element if that is to be cut out; the byte of the page behind it.
    fn tag(&mut self, page: &str, tag: &Tag<'_>) -> usize {
        let name = tag.name.as_str();
        let span = Span::new(tag.start, tag.end);
        if !tag.closes && !tag.empty && !VOID.contains(&name) {
            let ends_line = CUT_BLOCKS.contains(&name) || (self.is_xml && CUT_BLOCKS_IN_XML.contains(&name));
            let raw = ends_line || CUT.contains(&name) || (self.is_xml && CUT_IN_XML.contains(&name));
            if raw || is_hidden(tag) {
                let close = |at| next_tag(page, at).map_or(page.len(), |close| close.end);
                let end = if raw { close(end_of_element(page, tag.end, name)) } else { end_of_nested(page, tag) };
                let whole = Span::new(tag.start, end);
                if ends_line {
                    self.block(whole)
                } else {
                    self.edge(whole)
                }
                return end;
            }
        }
        match name {
            "img" | "input" => self.edge(span),
            "sup" | "sub" if tag.closes => self.close_script(span),
            "sup" | "sub" => {
                self.scripts.push(Script { start: self.text.len(), links: false });
                self.push(if name == "sup" { '^' } else { '_' }, span);
                self.push('(', span);
            }
            "br" | "newline" => {
                let stroke = self.underlined > 0 && self.text.len() <= self.underlined + 1;
                self.block(span);
                self.truncate(self.text.len() - 2);
                if stroke {
                    self.edge(span);
                }
            }
            "u" if tag.closes => self.underlined = self.text.len(),
            "a" => self.scripts.last_mut().into_iter().for_each(|script| script.links = true),
            _ if INLINE.contains(&name) || PHRASES.contains(&name) => {}
            _ => self.block(span),
        }
        tag.end
    }

    /// Ends an index or an exponent.
    fn close_script(&mut self, page: Span) {
        let Some(Script { start, links }) = self.scripts.pop() else { return };
        let inner = self.text.get(start + 2..).unwrap_or_default().trim();
        let left_out = inner.is_empty() || inner.starts_with('[');
        if !left_out && !links && !matches!(inner, "th" | "st" | "nd" | "rd") {
            return self.push(')', page);
        }
        let from = self.span_in_page(Span::new(start, start + 1));
        self.truncate(start);
        if !left_out {
            self.edge(from.join(page));
        }
    }
}

/// Whether an element is not shown, or is drawn piece by piece as a formula or a fraction, or in letters of another alphabet.
fn is_hidden(tag: &Tag<'_>) -> bool {
    let drawn = |class: &str| ["katex", "MathJax", "frac"].iter().any(|name| class.contains(name));
    tag.attribute("aria-hidden") == Some("true")
        || tag.name.starts_with("mjx-")
        || (tag.name == "span" && tag.attribute("class").is_some_and(drawn))
        || tag.attribute("style").is_some_and(|style| style.contains("overline"))
        || (tag.name == "font" && tag.attribute("face").is_some_and(|face| face.eq_ignore_ascii_case("symbol")))
}

/// The byte behind an element in which others of its name may be.
fn end_of_nested(page: &str, open: &Tag<'_>) -> usize {
    let (mut at, mut depth) = (open.end, 1usize);
    while let Some(tag) = next_tag(page, at) {
        at = tag.end;
        if tag.name == open.name && !tag.empty {
            depth = if tag.closes { depth - 1 } else { depth + 1 };
        }
        if depth == 0 {
            return at;
        }
    }
    page.len()
}
