//! Tags of XML and HTML, read as they come: an end without a start, a bare `&` or an attribute without quotes stops nothing.

use super::symbols;
use crate::token::{SourceChar, Span, TokenKind};

/// Deepest nesting of elements that is kept; what is nested deeper becomes part of the deepest.
pub(crate) const DEEPEST: usize = 40;
/// Longest formula that is read, in bytes.
pub(crate) const LONGEST: usize = 200_000;

/// A tag.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tag<'t> {
    /// The name in small letters, without a prefix.
    pub name: String,
    pub closes: bool,
    /// Whether it is its own end.
    pub empty: bool,
    attributes: &'t str,
    pub start: usize,
    pub end: usize,
}

impl<'t> Tag<'t> {
    /// The value of an attribute.
    pub(crate) fn attribute(&self, name: &str) -> Option<&'t str> {
        let mut rest = self.attributes;
        while let Some(at) = rest.find(name) {
            let starts = rest[..at].chars().next_back().is_none_or(|c| c.is_whitespace() || c == ':');
            rest = &rest[at + name.len()..];
            let value = rest.trim_start().strip_prefix('=').map(str::trim_start);
            if let (true, Some(value)) = (starts, value) {
                let quote = value.chars().next().filter(|c| matches!(c, '"' | '\''));
                return match quote {
                    Some(quote) => value[1..].split(quote).next(),
                    None => value.split_whitespace().next(),
                };
            }
        }
        None
    }
}

/// An element inside a formula.
#[derive(Debug)]
pub(crate) struct Element {
    pub name: String,
    /// `mathvariant`, `open`, `close`, `width`, `linebreak`, `notation` and `linethickness`, where given.
    pub attributes: Vec<(&'static str, String)>,
    pub children: Vec<Self>,
    pub text: Vec<SourceChar>,
    pub span: Span,
}

impl Element {
    pub(super) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(known, _)| *known == name).map(|(_, value)| value.as_str())
    }
}

/// The next tag at or behind `from`; comments, declarations and instructions are no tags.
pub(crate) fn next_tag(text: &str, from: usize) -> Option<Tag<'_>> {
    let mut at = from;
    loop {
        let start = at + text.get(at..)?.find('<')?;
        let rest = &text[start + 1..];
        let past = |end: Option<usize>, length: usize| end.map_or(text.len(), |end| start + 1 + end + length);
        if rest.starts_with("!--") {
            at = past(rest.find("-->"), 3);
            continue;
        }
        if rest.starts_with("![CDATA[") {
            at = past(rest.find("]]>"), 3);
            continue;
        }
        if rest.starts_with(['!', '?']) {
            at = past(rest.find('>'), 1);
            continue;
        }
        let closes = rest.starts_with('/');
        let rest = &rest[usize::from(closes)..];
        if !rest.starts_with(|c: char| c.is_ascii_alphabetic()) {
            at = start + 1;
            continue;
        }
        let body_start = start + 1 + usize::from(closes);
        let mut quote = None;
        let end = rest.bytes().position(|c| match (quote, c) {
            (None, b'>' | b'<') => true,
            (None, b'"' | b'\'') => {
                quote = Some(c);
                false
            }
            (Some(open), c) if open == c => {
                quote = None;
                false
            }
            _ => false,
        });
        // A quote that is never closed must not swallow the text.
        let end = end.or_else(|| rest.find('>')).unwrap_or(rest.len());
        let body = &rest[..end];
        let name_end = body.find(|c: char| c.is_whitespace() || c == '/').unwrap_or(body.len());
        let name = body[..name_end].rsplit(':').next().unwrap_or_default().to_ascii_lowercase();
        let closed = rest[end..].starts_with('>');
        return Some(Tag {
            name,
            closes,
            empty: body.ends_with('/'),
            attributes: &body[name_end..],
            start,
            end: body_start + end + usize::from(closed),
        });
    }
}

/// Entities that have other names than commands of TeX.
const ENTITIES: &[(&str, char)] = &[
    ("lt", '<'),
    ("gt", '>'),
    ("amp", '&'),
    ("quot", '"'),
    ("apos", '\''),
    ("nbsp", ' '),
    ("thinsp", ' '),
    ("ensp", ' '),
    ("emsp", ' '),
    ("minus", '−'),
    ("ndash", '–'),
    ("mdash", '—'),
    ("middot", '·'),
    ("sdot", '·'),
    ("divide", '÷'),
    ("frasl", '/'),
    ("plusmn", '±'),
    ("deg", '°'),
    ("radic", '√'),
    ("asymp", '≈'),
    ("ne", '≠'),
    ("le", '≤'),
    ("ge", '≥'),
    ("sup1", '¹'),
    ("sup2", '²'),
    ("sup3", '³'),
    ("frac12", '½'),
    ("frac14", '¼'),
    ("frac34", '¾'),
    ("micro", 'μ'),
    ("infin", '∞'),
    ("there4", '∴'),
    ("rarr", '→'),
    ("rArr", '⇒'),
    ("rsquo", '’'),
    ("hellip", '…'),
    ("InvisibleTimes", '\u{2062}'),
    ("ApplyFunction", '\u{2061}'),
];

/// The character of an entity.
fn entity_char(name: &str) -> Option<char> {
    let known = ENTITIES.iter().find(|(known, _)| *known == name).map(|(_, c)| *c);
    known.or_else(|| match symbols::symbol(name) {
        TokenKind::Operator(c) => Some(c),
        TokenKind::Name(letter) => letter.chars().next(),
        _ => None,
    })
}

/// The byte at which an element that has none of its name in it ends.
pub(crate) fn end_of_element(text: &str, from: usize, name: &str) -> usize {
    let mut ends = text[from..].match_indices("</").map(|(at, _)| from + at);
    let is_its = |at: &usize| {
        let (found, rest) = text[at + 2..].split_at_checked(name.len()).unwrap_or_default();
        found.eq_ignore_ascii_case(name) && !rest.starts_with(|c: char| c.is_ascii_alphanumeric())
    };
    ends.find(is_its).unwrap_or(text.len())
}

/// The characters of text between tags, with entities as the characters that they name.
pub(crate) fn decode_entities(text: &str, base: usize) -> Vec<SourceChar> {
    let mut out = Vec::with_capacity(text.len());
    let mut rest = text.char_indices();
    while let Some((at, c)) = rest.next() {
        let mut sign = SourceChar { c, span: Span::new(base + at, base + at + c.len_utf8()) };
        let end = (c == '&').then(|| text[at + 1..].bytes().take(15).position(|c| c == b';')).flatten();
        if let Some(name) = end.and_then(|end| text.get(at + 1..at + 1 + end)) {
            let number = name.strip_prefix('#').and_then(|digits| match digits.strip_prefix(['x', 'X']) {
                Some(hex) => u32::from_str_radix(hex, 16).ok(),
                None => digits.parse().ok(),
            });
            if let Some(c) = number.and_then(char::from_u32).or_else(|| entity_char(name)) {
                let length = name.len() + 1;
                sign = SourceChar { c, span: Span::new(base + at, base + at + 1 + length) };
                for _ in 0..name.chars().count() + 1 {
                    rest.next();
                }
            }
        }
        out.push(sign);
    }
    out
}

/// The element that a start tag opens, and the byte behind it.
pub(crate) fn parse_element(text: &str, open: &Tag<'_>) -> (Element, usize) {
    let limit = text.len().min(open.start + LONGEST);
    let mut stack = vec![new_element(open)];
    let mut at = open.end;
    if open.empty {
        return (new_element(open), open.end);
    }
    loop {
        let tag = next_tag(text, at).filter(|tag| tag.start < limit);
        let text_end = tag.as_ref().map_or(limit, |tag| tag.start).max(at);
        if let (Some(current), Some(between)) = (stack.last_mut(), text.get(at..text_end)) {
            current.text.extend(decode_entities(between, at));
        }
        let Some(tag) = tag else {
            at = limit;
            break;
        };
        at = tag.end;
        if tag.closes {
            let Some(matching) = stack.iter().rposition(|open| open.name == tag.name) else { continue };
            while stack.len() > matching.max(1) {
                close_element(&mut stack, tag.end);
            }
            if matching == 0 {
                break;
            }
        } else if tag.empty || stack.len() >= DEEPEST {
            if let Some(current) = stack.last_mut() {
                current.children.push(new_element(&tag));
            }
        } else {
            stack.push(new_element(&tag));
        }
    }
    while !text.is_char_boundary(at) {
        at += 1;
    }
    while stack.len() > 1 {
        close_element(&mut stack, at);
    }
    let mut whole = stack.pop().unwrap_or_else(|| new_element(open));
    whole.span = Span::new(open.start, at);
    (whole, at)
}

fn new_element(tag: &Tag<'_>) -> Element {
    let known = ["mathvariant", "open", "close", "width", "linebreak", "notation", "linethickness"];
    let attributes = known.into_iter().filter_map(|name| Some((name, tag.attribute(name)?.to_owned()))).collect();
    let span = Span::new(tag.start, tag.end);
    Element { name: tag.name.clone(), attributes, children: Vec::new(), text: Vec::new(), span }
}

fn close_element(stack: &mut Vec<Element>, end: usize) {
    if let Some(mut done) = stack.pop() {
        done.span = done.span.join(Span::new(end, end + 1));
        done.span.end = Span::new(end, end).end;
        match stack.last_mut() {
            Some(parent) => parent.children.push(done),
            None => stack.push(done),
        }
    }
}
