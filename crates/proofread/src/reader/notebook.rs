//! Jupyter notebooks: the Markdown of their cells.

use super::delimited::Dollars;
use super::{FormulaSink, UnreadKind, UnreadParts, UnreadableText, markdown};
use crate::token::Span;
use serde_json::value::RawValue;
use std::collections::HashMap;

type Object<'t> = HashMap<String, &'t RawValue>;

/// Finds the formulas in the Markdown cells; what is not read.
///
/// # Errors
///
/// If the text is no notebook.
pub(crate) fn read(text: &str, each: &mut FormulaSink<'_>) -> Result<UnreadParts, UnreadableText> {
    let mut unread = UnreadParts::default();
    let others = markdown_cells(text, &mut |decoded, places| {
        unread.add(&markdown::read(decoded, Dollars::Spaced, &mut |mut formula| {
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
    let wrong = |error: serde_json::Error| UnreadableText::Notebook(error.to_string());
    let notebook: Object<'_> = serde_json::from_str(text).map_err(wrong)?;
    for cell in cells(&notebook)? {
        let cell: Object<'_> = serde_json::from_str(cell.get()).map_err(wrong)?;
        let is_markdown = cell.get("cell_type").is_some_and(|kind| kind.get() == "\"markdown\"");
        let Some(source) = cell.get("source").filter(|_| is_markdown) else {
            others += 1;
            continue;
        };
        let lines: Vec<&RawValue> = match serde_json::from_str(source.get()) {
            Ok(lines) => lines,
            Err(_) => vec![source],
        };
        let (mut decoded, mut places) = (String::new(), Vec::new());
        for line in lines {
            let start = line.get().as_ptr().addr().wrapping_sub(text.as_ptr().addr());
            decode(line.get(), start, &mut decoded, &mut places);
        }
        each(&decoded, &places);
    }
    Ok(others)
}

/// The cells; those of format 3 lie in worksheets.
fn cells<'t>(notebook: &Object<'t>) -> Result<Vec<&'t RawValue>, UnreadableText> {
    let wrong = |error: serde_json::Error| UnreadableText::Notebook(error.to_string());
    if let Some(cells) = notebook.get("cells") {
        return serde_json::from_str(cells.get()).map_err(wrong);
    }
    let missing = UnreadableText::Notebook("it has neither `cells` nor `worksheets`".to_owned());
    let worksheets = notebook.get("worksheets").ok_or(missing)?;
    let worksheets: Vec<Object<'t>> = serde_json::from_str(worksheets.get()).map_err(wrong)?;
    let mut out = Vec::new();
    for cells in worksheets.iter().filter_map(|worksheet| worksheet.get("cells")) {
        out.extend(serde_json::from_str::<Vec<&'t RawValue>>(cells.get()).map_err(wrong)?);
    }
    Ok(out)
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
