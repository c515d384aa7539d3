//! TeX in the elements of PreTeXt: `m`, `me`, `men`, and `md` with its rows.

use super::definitions::{Macros, NamedMacros, may_define};
use super::tags::{Tag, decode_entities, next_tag};
use super::{Formula, tex};
use crate::token::{SourceChar, Span};

/// Elements with TeX in them.
pub(crate) const ELEMENTS: [&str; 5] = ["m", "me", "men", "md", "mdn"];

/// Longest formula that is read, in bytes.
const LONGEST: usize = 20_000;

/// The macros that the document defines for its formulas, in elements for them or as a page for MathJax does, and those that are defined
/// for it elsewhere.
pub(crate) fn macros<'d>(text: &str, elsewhere: Option<&'d NamedMacros>) -> Macros<'d> {
    let mut defined = macros_text(text);
    if defined.is_empty() && may_define(text) {
        // In a page, this sign begins no comment.
        defined = text.replace('%', " ");
    }
    Macros::from_text(&defined, text.len(), elsewhere)
}

/// The definitions in the elements `macros`, as TeX.
pub(crate) fn macros_text(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some((_, behind)) = rest.split_once("<macros>") {
        let Some((inside, behind)) = behind.split_once("</macros>") else { break };
        let inside = inside.trim().strip_prefix("<![CDATA[").map_or(inside, |inside| inside.trim_end_matches("]]>"));
        out.extend(decode_entities(inside, 0).into_iter().map(|sign| sign.c));
        out.push('\n');
        rest = behind;
    }
    out
}

/// The formula in an element, and the byte behind its end tag.
pub(crate) fn formula(text: &str, open: &Tag<'_>, macros: &Macros<'_>) -> (Formula, usize) {
    let mut signs: Vec<SourceChar> = Vec::new();
    let mut at = open.end;
    // Words between the rows are none of the formula.
    let mut silent = false;
    let end = loop {
        let tag = next_tag(text, at).filter(|tag| tag.start < open.start + LONGEST);
        let Some(tag) = tag else { break open.end };
        if !silent {
            signs.extend(text.get(at..tag.start).map(|between| shown(between, at)).unwrap_or_default());
        }
        at = tag.end;
        match (tag.name.as_str(), tag.closes) {
            (name, true) if name == open.name => break tag.end,
            ("mrow", _) => {
                signs.extend("\\\\ ".chars().map(|c| SourceChar { c, span: Span::new(tag.start, tag.start) }))
            }
            ("intertext", closes) => silent = !closes,
            // What stands for something else, a blank to fill in or a number that is drawn.
            (_, false) => {
                signs.extend("\\fillin ".chars().map(|c| SourceChar { c, span: Span::new(tag.start, tag.end) }))
            }
            _ => {}
        }
    };
    // An element without an end has no formula.
    let signs = if end == open.end { Vec::new() } else { signs };
    (Formula::new(tex::formula(&signs, macros), Span::new(open.start, end)), end)
}

/// The characters of a stretch without the comments in it, which begins at a byte of the document.
fn shown(text: &str, base: usize) -> Vec<SourceChar> {
    let (mut out, mut at) = (Vec::new(), 0);
    while let Some(open) = text[at..].find("<!--").map(|open| at + open) {
        out.extend(decode_entities(&text[at..open], base + at));
        at = text[open..].find("-->").map_or(text.len(), |close| open + close + "-->".len());
    }
    out.extend(decode_entities(&text[at..], base + at));
    out
}
