//! Documents in LaTeX: their macros, and the formulas of their body.

use super::adjoining::Joiner;
use super::definitions::{Macros, NamedMacros, closing, defines, definition};
use super::delimited::{DISPLAYS, FARTHEST, MORE_DISPLAYS, length_of_columns};
use super::unread::{UnreadKind, UnreadParts, note};
use super::{Formula, FormulaSink, tex};
use crate::token::{Span, signs};
use std::ops::Range;

/// Longest formula that is read, in bytes.
const LONGEST: usize = 20_000;
/// Environments whose content is not read.
const VERBATIM: [&str; 6] = ["verbatim", "lstlisting", "comment", "minted", "tikzpicture", "Verbatim"];

/// Whether the content of an environment is not read: it is one of these, or one that a package or a document has made for code, such as
/// `pythoncode`.
pub(super) fn is_verbatim(name: &str) -> bool {
    VERBATIM.contains(&name) || name.to_ascii_lowercase().ends_with("code") || name.ends_with("listing")
}

/// Environments that are a problem by themselves.
const SCOPES: [&str; 8] = ["example", "exercise", "problem", "solution", "question", "eg", "exam", "homework"];

/// Tables whose arguments say how their columns are set, perhaps with dollar signs.
const TABLES: [&str; 9] =
    ["tabular", "tabular*", "tabularx", "tabulary", "longtable", "xltabular", "supertabular", "array", "tblr"];

/// Longest argument of a table, in bytes.
const LONGEST_COLUMNS: usize = 400;

/// The bytes of the arguments behind the start of a table: a width or a place, and the columns.
fn length_of_table_columns(behind: &str) -> usize {
    let mut at = 0;
    for _ in 0..3 {
        let rest = &behind[at..];
        let length = if rest.starts_with('[') {
            rest.find(']').map(|end| end + 1)
        } else if rest.starts_with('{') {
            closing_brace(rest.as_bytes())
        } else {
            break;
        };
        // What is in braces behind the columns may be a cell.
        match length.filter(|length| *length <= LONGEST_COLUMNS && !rest[..*length].contains('&')) {
            Some(length) => at += length,
            None => break,
        }
    }
    at
}

/// A part of a document that is no running text.
pub(super) enum LatexPart<'t> {
    /// A formula, from what is inside its marks, and the problem that it belongs to.
    Formula { whole: Range<usize>, inside: Range<usize>, scope: u32 },
    /// What is not printed, or is no text; of which kind it is and its name, if it may be missed.
    Hidden(Range<usize>, Option<(UnreadKind, &'t str)>),
}

/// Takes the parts as they are found.
type PartSink<'s, 't> = dyn FnMut(LatexPart<'t>) + 's;

/// Finds the formulas of a document, with the macros that are defined elsewhere; what is not read.
pub(crate) fn read(text: &str, elsewhere: Option<&NamedMacros>, each: &mut FormulaSink<'_>) -> UnreadParts {
    let mut unread = UnreadParts::default();
    let mut joiner = Joiner::new(text);
    let macros = Macros::from_text(text, text.len(), elsewhere);
    parts(text, &macros, &mut |part| match part {
        LatexPart::Formula { whole, inside, scope } => {
            let tokens = tex::formula(&signs(&text[inside.clone()], inside.start), &macros);
            joiner.take(Formula { scope, ..Formula::new(tokens, Span::new(whole.start, whole.end)) }, each);
        }
        LatexPart::Hidden(range, Some((kind, name))) => note(&mut unread, kind, name, &text[range]),
        LatexPart::Hidden(..) => {}
    });
    joiner.finish(each);
    unread
}

/// Hands over the parts of a document that are no running text, in their order.
pub(super) fn parts<'t>(text: &'t str, macros: &Macros<'_>, each: &mut PartSink<'_, 't>) {
    const COMMENT: Option<(UnreadKind, &str)> = Some((UnreadKind::Comment, ""));
    let bytes = text.as_bytes();
    let mut ends = Ends::default();
    let (mut at, mut scope, mut inside) = (0, 0u32, Vec::new());
    // Whether groups and conditions have ended so far; one without an end is looked for once.
    let (mut closes, mut ends_conditions) = (true, true);
    while at < bytes.len() {
        match bytes[at] {
            b'%' => {
                let end = at + text[at..].find('\n').unwrap_or(bytes.len() - at);
                each(LatexPart::Hidden(at..end, COMMENT));
                at = end;
            }
            b'$' => {
                let end = if bytes[at..].starts_with(b"$$") { "$$" } else { "$" };
                at = read_until(text, at, end.len(), end, scope, each);
            }
            b'\\' => {
                let rest = &text[at + 1..];
                let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
                let name = &rest[..length];
                match (name, rest.bytes().next()) {
                    ("", Some(b'[')) => at = read_until(text, at, 2, "\\]", scope, each),
                    ("", Some(b'(')) => at = read_until(text, at, 2, "\\)", scope, each),
                    ("", next) => at += 1 + usize::from(next.is_some_and(|c| c.is_ascii())),
                    ("begin", _) => at = begin(text, at, &mut scope, &mut inside, each),
                    ("end", _) => {
                        let closing = group_text(text, at + 4).unwrap_or_default();
                        if closing == "document" {
                            each(LatexPart::Hidden(at..text.len(), COMMENT));
                            return;
                        }
                        if SCOPES.contains(&closing)
                            && let Some(outer) = inside.pop()
                        {
                            scope = outer;
                        }
                        at += 4;
                    }
                    (name, _) if defines(name) => {
                        let end = definition(text, at).map_or(at + 1 + length, |(_, _, end)| end);
                        each(LatexPart::Hidden(at..end, None));
                        at = end;
                    }
                    ("iffalse", _) if ends_conditions => {
                        let end = rest.find("\\fi");
                        ends_conditions = end.is_some();
                        let end = at + end.map_or(length + 1, |end| end + 4);
                        each(LatexPart::Hidden(at..end, COMMENT));
                        at = end;
                    }
                    ("verb" | "lstinline", Some(_)) => {
                        let behind = &text[at + 1 + length..];
                        let mark = behind.chars().next().unwrap_or('|');
                        // It ends in its line, and near.
                        let mut inside = behind.char_indices().skip(1).take(FARTHEST).take_while(|(_, c)| *c != '\n');
                        let end = inside.find(|(_, c)| *c == mark).map_or(0, |(end, _)| end);
                        let end = at + 1 + length + end + mark.len_utf8();
                        let end = end.min(text.len());
                        each(LatexPart::Hidden(at..end, Some((UnreadKind::Code, ""))));
                        at = end;
                    }
                    // What the document sets to nothing isn't printed.
                    (name, _) if macros.get(name).is_some_and(|of| of.arguments > 0 && of.body.trim().is_empty()) => {
                        let behind = at + 1 + length;
                        let unprinted = if closes { closing_brace(&bytes[behind..]) } else { None };
                        closes &= unprinted.is_some();
                        let end = behind + unprinted.unwrap_or(0);
                        each(LatexPart::Hidden(at..end, COMMENT));
                        at = end;
                    }
                    (name, _) => at = abbreviation(text, at, name, scope, macros, &mut ends, each),
                }
            }
            _ => at += 1,
        }
        while at < text.len() && !text.is_char_boundary(at) {
            at += 1;
        }
    }
}

/// The bytes up to the end of the group at the start of a text, zero if there is no group, and none if it has no end.
fn closing_brace(text: &[u8]) -> Option<usize> {
    let open = text.iter().take(100).position(|c| !c.is_ascii_whitespace()).filter(|at| text[*at] == b'{');
    let Some(open) = open else { return Some(0) };
    let inner = text[open + 1..].iter().map(|byte| char::from(*byte)).enumerate();
    closing(inner, '{', '}').map(|at| open + 1 + at + 1)
}

/// The text of the group that begins at `at`.
pub(super) fn group_text(text: &str, at: usize) -> Option<&str> {
    let rest = text.get(at..)?.trim_start_matches(' ').strip_prefix('{')?;
    let end = rest.bytes().take(60).position(|c| c == b'}')?;
    rest.get(..end)
}

fn begin<'t>(text: &'t str, at: usize, scope: &mut u32, inside: &mut Vec<u32>, each: &mut PartSink<'_, 't>) -> usize {
    let Some(name) = group_text(text, at + 6) else { return at + 6 };
    let open = at + 6 + name.len() + 2;
    if DISPLAYS.contains(&name) || MORE_DISPLAYS.contains(&name) {
        let end = format!("\\end{{{name}}}");
        let open = open + length_of_columns(name, text.get(open..).unwrap_or_default());
        return read_until(text, at, open - at, &end, *scope, each);
    }
    if is_verbatim(name) {
        let end = format!("\\end{{{name}}}");
        let behind = text.get(open..).and_then(|rest| rest.find(&end));
        let behind = behind.map_or(text.len(), |found| open + found + end.len());
        each(LatexPart::Hidden(at..behind, Some((UnreadKind::Environment, name))));
        return behind;
    }
    if TABLES.contains(&name) {
        return open + length_of_table_columns(text.get(open..).unwrap_or_default());
    }
    if SCOPES.contains(&name) && inside.len() < 1000 {
        inside.push(*scope);
        *scope = u32::try_from(at).unwrap_or(u32::MAX).saturating_add(1);
    }
    open
}

/// Reads the formula that begins at `at` with a mark of `open` bytes and ends with `end`; the byte behind it.
fn read_until(text: &str, at: usize, open: usize, end: &str, scope: u32, each: &mut PartSink<'_, '_>) -> usize {
    let start = at + open;
    let bytes = text.as_bytes();
    let (mut stop, mut depth, mut inside) = (start, 0usize, None);
    let close = loop {
        let Some(rest) = bytes.get(stop..).filter(|rest| !rest.is_empty() && stop - start < LONGEST) else {
            break inside;
        };
        if inside.is_some_and(|inside| stop > inside + FARTHEST) {
            break inside;
        }
        // A dollar sign inside braces belongs to text in the formula, unless no other one follows.
        if rest.starts_with(end.as_bytes()) {
            if depth == 0 || end != "$" {
                break Some(stop);
            }
            inside = inside.or(Some(stop));
        }
        match rest[0] {
            b'\\' => stop += 2,
            // A blank line ends a formula that an author forgot to end.
            b'\n' if rest.get(1) == Some(&b'\n') && end.starts_with('$') => break inside,
            b'{' => (stop, depth) = (stop + 1, depth + 1),
            b'}' => (stop, depth) = (stop + 1, depth.saturating_sub(1)),
            b'%' => stop += rest.iter().position(|c| *c == b'\n').unwrap_or(rest.len()).max(1),
            _ => stop += 1,
        }
    };
    let Some(close) = close else { return stop.max(start).min(text.len()) };
    if text.get(start..close).is_none() {
        return close;
    }
    each(LatexPart::Formula { whole: at..close + end.len(), inside: start..close, scope });
    close + end.len()
}

/// Most macros that are looked for as the end of a display.
const MOST_ENDS: usize = 8;

/// The ends of displays, each with the macros that stand for it and how far a document has none of them.
#[derive(Default)]
struct Ends(Vec<(String, Vec<String>, usize)>);

impl Ends {
    /// Where the first macro begins that stands for this end, within the longest formula behind a place, and where it ends.
    fn nearest(&mut self, text: &str, from: usize, end: &str, macros: &Macros<'_>) -> Option<(usize, usize)> {
        let known = self.0.iter().position(|(of, ..)| of == end).unwrap_or_else(|| {
            let ends = macros.iter().filter(|(_, of)| of.body.trim() == end).map(|(name, _)| format!("\\{name}"));
            let mut first: Vec<String> = Vec::new();
            for end in ends {
                let at = first.partition_point(|before| *before < end);
                first.insert(at, end);
                first.truncate(MOST_ENDS);
            }
            self.0.push((end.to_owned(), first, 0));
            self.0.len() - 1
        });
        let (_, names, none_until) = &mut self.0[known];
        let boundary = |at: usize| (from..=at.min(text.len())).rfind(|at| text.is_char_boundary(*at)).unwrap_or(from);
        let limit = boundary(from + LONGEST);
        // One that begins in what was looked through may reach beyond it.
        let longest = names.iter().map(String::len).max().unwrap_or(0);
        let start = boundary((*none_until).saturating_sub(longest + 1).clamp(from, limit));
        let window = &text[start..limit];
        let is_end = |at: usize, mark: &str| !window[at + mark.len()..].starts_with(|c: char| c.is_ascii_alphabetic());
        let first = |mark: &String| {
            let at = window.match_indices(mark.as_str()).map(|(at, _)| at).find(|at| is_end(*at, mark))?;
            Some((start + at, start + at + mark.len()))
        };
        let nearest = names.iter().filter_map(first).min();
        if nearest.is_none() {
            *none_until = limit;
        }
        nearest
    }
}

/// A macro in running text that stands for the beginning of a display, with another one for its end.
fn abbreviation(
    text: &str,
    at: usize,
    name: &str,
    scope: u32,
    macros: &Macros<'_>,
    ends: &mut Ends,
    each: &mut PartSink<'_, '_>,
) -> usize {
    let behind = at + 1 + name.len();
    let opened = |body: &str| {
        let begins = body.trim().strip_prefix("\\begin{")?.split('}').next()?;
        (DISPLAYS.contains(&begins) || MORE_DISPLAYS.contains(&begins)).then(|| format!("\\end{{{begins}}}"))
    };
    let Some(end) = macros.get(name).and_then(|of| opened(&of.body)) else { return behind };
    let Some((found, close)) = ends.nearest(text, behind, &end, macros) else { return behind };
    each(LatexPart::Formula { whole: at..close, inside: behind..found, scope });
    close
}
