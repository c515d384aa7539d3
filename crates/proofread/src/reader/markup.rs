//! Documents in XML or HTML: where their formulas are, and what stands before and behind each of them.

use super::definitions::{Macros, NamedMacros};
use super::mathml;
use super::pretext;
use super::tags::{DEEPEST, LONGEST, decode_entities, end_of_element, next_tag, parse_element};
use super::unread::{UnreadKind, UnreadParts, note};
use super::{Formula, FormulaSink, delimited, tex};
use crate::token::{Span, TOO_LONG, Token, TokenKind};
use std::cell::LazyCell;

/// Elements whose own content is a scope for the names of quantities.
const SCOPES: [&str; 10] =
    ["example", "exercise", "note", "section", "figure", "table", "problem", "solution", "article", "aside"];
/// Elements whose text is not prose.
const SILENT: [&str; 5] = ["script", "style", "code", "pre", "annotation"];
/// Elements with TeX in older dialects, in which it is not read; other dialects have elements of these names around MathML.
const OTHER_FORMULAS: [&str; 3] = ["equation", "alignmath", "alignedmath"];
/// Elements that do not end a sentence.
pub(crate) const INLINE: [&str; 17] = [
    "emphasis", "em", "i", "b", "strong", "span", "a", "link", "term", "sub", "sup", "u", "font", "mark", "small",
    "br", "newline",
];

/// Finds the formulas of a document in XML or HTML: MathML, and TeX between the marks that MathJax and KaTeX look for.
///
/// The commands of its formulas may be defined elsewhere. It returns what is not read.
pub(crate) fn read(text: &str, elsewhere: Option<&NamedMacros>, each: &mut FormulaSink<'_>) -> UnreadParts {
    let mut unread = UnreadParts::default();
    let (mut at, mut next_scope) = (0, 1u32);
    let mut scopes: Vec<(String, u32)> = Vec::new();
    // What has been said since the last formula of the paragraph, or nothing if there was none.
    let mut before = PrecedingText::default();
    let macros = LazyCell::new(|| pretext::macros(text, elsewhere));
    while let Some(tag) = next_tag(text, at) {
        if let Some(between) = text.get(at..tag.start) {
            before.prose(between);
            comments(between, &mut unread);
            tex_between(between, (at, scopes.last().map_or(0, |(_, id)| *id)), &macros, each);
        }
        at = tag.end;
        if tag.closes {
            if let Some(open) = scopes.iter().rposition(|(name, _)| *name == tag.name) {
                scopes.truncate(open);
            }
        } else if tag.name == "math" {
            let (whole, end) = parse_element(text, &tag);
            let mut tokens = mathml::tokens(&whole);
            if end >= tag.start + LONGEST {
                tokens.push(Token::new(TokenKind::Unknown(TOO_LONG.to_owned()), whole.span));
            }
            let mut formula = Formula::new(tokens, whole.span);
            formula.scope = scopes.last().map_or(0, |(_, id)| *id);
            formula.continues = before.is_open() || before.is_enumerated(&formula);
            formula.goes_on = goes_on(&text[end..]);
            each(formula);
            before = PrecedingText { formula: true, ..PrecedingText::default() };
            at = end;
            continue;
        } else if pretext::ELEMENTS.contains(&tag.name.as_str()) && !tag.empty {
            let (mut formula, end) = pretext::formula(text, &tag, &macros);
            formula.scope = scopes.last().map_or(0, |(_, id)| *id);
            each(formula);
            at = end;
            continue;
        } else if SILENT.contains(&tag.name.as_str()) && !tag.empty {
            let is_tex = tag.attribute("type").is_some_and(|kind| kind.starts_with("math/tex"));
            let end = end_of_element(text, at, &tag.name);
            if is_tex {
                let span = Span::new(at, end);
                each(Formula::new(tex::formula(&crate::token::signs(&text[at..end], at), &macros), span));
            } else if ["code", "pre"].contains(&tag.name.as_str()) {
                note(&mut unread, UnreadKind::Element, &tag.name, &text[at..end]);
            }
            at = end;
        } else if OTHER_FORMULAS.contains(&tag.name.as_str()) && !tag.empty {
            let end = next_tag(text, at).filter(|end| end.closes && end.name == tag.name);
            let inside = end.and_then(|end| text.get(at..end.start)).unwrap_or_default();
            if !["$$", "\\[", "\\("].iter().any(|mark| inside.contains(mark)) {
                note(&mut unread, UnreadKind::Element, &tag.name, inside);
            }
        } else if SCOPES.contains(&tag.name.as_str()) && !tag.empty && scopes.len() < DEEPEST {
            scopes.push((tag.name.clone(), next_scope));
            next_scope += 1;
        }
        if !INLINE.contains(&tag.name.as_str()) {
            before = PrecedingText::default();
        }
    }
    if let Some(between) = text.get(at..) {
        comments(between, &mut unread);
        tex_between(between, (at, 0), &macros, each);
    }
    unread
}

/// Counts the comments in what is between two tags.
fn comments(between: &str, unread: &mut UnreadParts) {
    let mut rest = between;
    while let Some((_, behind)) = rest.split_once("<!--") {
        let (comment, behind) = behind.split_once("-->").unwrap_or((behind, ""));
        note(unread, UnreadKind::Comment, "", comment);
        rest = behind;
    }
}

/// Finds the formulas in what is between two tags, from its place in the text and with the scope it is in.
fn tex_between<'d>(
    between: &str,
    (at, scope): (usize, u32),
    macros: &LazyCell<Macros<'d>, impl FnOnce() -> Macros<'d>>,
    each: &mut FormulaSink<'_>,
) {
    if !between.contains(['\\', '$']) {
        return;
    }
    for found in delimited::formulas(between, &[], delimited::Dollars::Double) {
        let source = &between[found.inside.clone()];
        let tokens = tex::formula(&decode_entities(source, at + found.inside.start), macros);
        let mut formula = Formula::new(tokens, Span::new(at + found.whole.start, at + found.whole.end));
        formula.scope = scope;
        each(formula);
    }
}

/// What stands before a formula in its paragraph.
#[derive(Default)]
struct PrecedingText {
    formula: bool,
    tail: String,
}

impl PrecedingText {
    fn prose(&mut self, text: &str) {
        let from = text.char_indices().rev().nth(60).map_or(0, |(at, _)| at);
        self.tail.push_str(&text[from..]);
    }

    /// Whether a formula behind a comma goes on with a sum that began in the formula before.
    fn is_enumerated(&self, formula: &Formula) -> bool {
        let first = formula.tokens.iter().find(|token| !token.is_space());
        self.formula && self.tail.trim() == "," && first.is_some_and(|first| first.is_one_of("+-"))
    }

    /// Whether the formula continues what stands before it.
    fn is_open(&self) -> bool {
        let tail = self.tail.trim_end();
        let last = tail.chars().next_back();
        match last {
            None => self.formula,
            Some(c) if "+-−–×·*/=(^".contains(c) => true,
            Some(_) => {
                ["times", "plus", "minus", "divided by", "multiplied by"].iter().any(|word| tail.ends_with(word))
            }
        }
    }
}

/// Whether text behind a formula continues it.
fn goes_on(text: &str) -> bool {
    let rest = text.trim_start();
    rest.starts_with(['×', '·', '*', '^', '+', '/']) || (rest.starts_with("<m:math") || rest.starts_with("<math"))
}
