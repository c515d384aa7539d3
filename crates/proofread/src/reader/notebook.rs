//! Jupyter notebooks: the Markdown of their cells.

use super::definitions::{NamedMacros, may_define, named_macros};
use super::delimited::Dollars;
use super::json::{self, NoJson};
use super::{FormulaSink, UnreadKind, UnreadParts, UnreadableText, markdown};
use crate::token::Span;

/// Finds the formulas in the Markdown cells; what is not read. A macro of one cell holds in all, as it does where the notebook is shown.
///
/// # Errors
///
/// If the text is no notebook.
pub(crate) fn read(
    text: &str,
    elsewhere: Option<&NamedMacros>,
    each: &mut FormulaSink<'_>,
) -> Result<UnreadParts, UnreadableText> {
    let mut unread = UnreadParts::default();
    let mut macros = elsewhere.cloned().unwrap_or_default();
    if may_define(text) {
        markdown_cells(text, &mut |decoded, _| macros.extend(named_macros(decoded)))?;
    }
    let others = markdown_cells(text, &mut |decoded, places| {
        unread.add(&markdown::read(decoded, Dollars::Spaced, Some(&macros), &mut |mut formula| {
            formula.map_spans(&|span| in_notebook(places, span));
            each(formula);
        }));
    })?;
    if others > 0 {
        unread.count(UnreadKind::Cell, "", others);
    }
    Ok(unread)
}

/// Where a stretch of a cell is in the notebook, with the place of each byte of the cell.
pub(super) fn in_notebook(places: &[u32], span: Span) -> Span {
    let end = places.last().map_or(0, |last| last + 1);
    let place = |at: u32| places.get(at as usize).copied().unwrap_or(end);
    let last = span.end.checked_sub(1).map_or(0, place);
    Span { start: place(span.start), end: (last + 1).max(place(span.start)) }
}

/// Hands over the Markdown cells, each with the place in the notebook of each of its bytes; how many cells are something else.
///
/// # Errors
///
/// If the text is no notebook.
pub(super) fn markdown_cells(text: &str, each: &mut dyn FnMut(&str, &[u32])) -> Result<usize, UnreadableText> {
    let mut others = 0;
    let notebook = NotebookText(text);
    for cell in notebook.cells()? {
        let cell = notebook.members(cell)?;
        let is_markdown = member(&cell, "cell_type") == Some("\"markdown\"");
        let Some(source) = member(&cell, "source").filter(|_| is_markdown) else {
            others += 1;
            continue;
        };
        let lines = json::items(source).unwrap_or_else(|_| vec![source]);
        let (mut decoded, mut places) = (String::new(), Vec::new());
        for line in lines {
            decode(line, notebook.place(line), &mut decoded, &mut places);
        }
        each(&decoded, &places);
    }
    Ok(others)
}

/// The value of a name; of several, the last one counts.
fn member<'t>(object: &[(&str, &'t str)], name: &str) -> Option<&'t str> {
    object.iter().rev().find(|(of, _)| *of == name).map(|(_, value)| *value)
}

/// The text of a notebook, of which all else is a part.
struct NotebookText<'t>(&'t str);

impl<'t> NotebookText<'t> {
    /// Where a part of the text begins.
    fn place(&self, part: &str) -> usize {
        part.as_ptr().addr().wrapping_sub(self.0.as_ptr().addr())
    }

    /// What a part was read as, or where it could not be read.
    fn read<T>(&self, part: &str, found: Result<T, NoJson>) -> Result<T, UnreadableText> {
        found.map_err(|NoJson { expected, at }| {
            let before = self.0.get(..self.place(part) + at).unwrap_or(self.0);
            let (line, column) =
                (before.matches('\n').count() + 1, before.rsplit('\n').next().map_or(0, |of| of.chars().count()) + 1);
            UnreadableText::Notebook(format!("{expected} is expected at line {line}, column {column}"))
        })
    }

    fn members(&self, object: &'t str) -> Result<Vec<(&'t str, &'t str)>, UnreadableText> {
        self.read(object, json::members(object))
    }

    fn items(&self, list: &'t str) -> Result<Vec<&'t str>, UnreadableText> {
        self.read(list, json::items(list))
    }

    /// The cells; those of format 3 lie in worksheets.
    fn cells(&self) -> Result<Vec<&'t str>, UnreadableText> {
        let whole = self.members(self.0)?;
        if let Some(cells) = member(&whole, "cells") {
            return self.items(cells);
        }
        let missing = UnreadableText::Notebook("it has neither `cells` nor `worksheets`".to_owned());
        let mut out = Vec::new();
        for worksheet in self.items(member(&whole, "worksheets").ok_or(missing)?)? {
            if let Some(cells) = member(&self.members(worksheet)?, "cells") {
                out.extend(self.items(cells)?);
            }
        }
        Ok(out)
    }
}

/// The text of a JSON string that starts `base` bytes into the document, and the place of each of its bytes there.
fn decode(json: &str, base: usize, out: &mut String, places: &mut Vec<u32>) {
    let inner = json.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')).unwrap_or_default();
    let mut rest = inner.char_indices();
    let mut half = None;
    while let Some((at, c)) = rest.next() {
        let mut decoded = c;
        if c == '\\' {
            decoded = match rest.next().map(|(_, c)| c) {
                Some('n') => '\n',
                Some('t') => '\t',
                Some('r') => '\r',
                Some('b' | 'f') => ' ',
                Some('u') => {
                    let digits: String = rest.by_ref().take(4).map(|(_, c)| c).collect();
                    let code = u32::from_str_radix(&digits, 16).unwrap_or(0xfffd);
                    match (half.take(), code) {
                        (None, 0xd800..=0xdbff) => {
                            half = Some(code);
                            continue;
                        }
                        (Some(high), 0xdc00..=0xdfff) => {
                            char::from_u32(0x10000 + ((high - 0xd800) << 10) + (code - 0xdc00)).unwrap_or('\u{fffd}')
                        }
                        (_, code) => char::from_u32(code).unwrap_or('\u{fffd}'),
                    }
                }
                Some(c) => c,
                None => break,
            };
        }
        out.push(decoded);
        let place = Span::new(base + 1 + at, 0).start;
        places.extend(std::iter::repeat_n(place, decoded.len_utf8()));
    }
}
