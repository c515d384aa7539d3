//! TeX in the elements of PreTeXt: `m`, `me`, `men`, and `md` with its rows.

use super::definitions::Macros;
use super::tags::{Tag, decode_entities, next_tag};
use super::{Formula, tex};
use crate::token::{SourceChar, Span};

/// Elements with TeX in them.
pub(crate) const ELEMENTS: [&str; 5] = ["m", "me", "men", "md", "mdn"];

/// Longest formula that is read, in bytes.
const LONGEST: usize = 20_000;

/// The macros that the document defines for its formulas.
pub(crate) fn macros(text: &str) -> Macros<'static> {
    let inside = text.split_once("<macros>").and_then(|(_, rest)| rest.split_once("</macros>"));
    Macros::from_text(inside.map_or("", |(inside, _)| inside), text.len(), None)
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
            signs.extend(text.get(at..tag.start).map(|between| decode_entities(between, at)).unwrap_or_default());
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
