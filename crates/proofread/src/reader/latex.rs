//! Documents in LaTeX: their macros, and the formulas of their body.

use super::adjoining::Joiner;
use super::definitions::{Macros, NamedMacros, closing, defines, definition};
use super::delimited::{DISPLAYS, FARTHEST};
use super::{Formula, FormulaSink, tex};
use crate::token::{Span, signs};

/// Longest formula that is read, in bytes.
const LONGEST: usize = 20_000;
/// Environments whose content is not read.
pub(super) const VERBATIM: [&str; 6] = ["verbatim", "lstlisting", "comment", "minted", "tikzpicture", "Verbatim"];
const MORE: [&str; 6] = ["flalign*", "alignat", "alignat*", "math", "dmath", "IEEEeqnarray"];
/// Environments that are a problem by themselves.
const SCOPES: [&str; 8] = ["example", "exercise", "problem", "solution", "question", "eg", "exam", "homework"];

/// Finds the formulas of a document, with the macros that are defined elsewhere.
pub(crate) fn read(text: &str, elsewhere: Option<&NamedMacros>, each: &mut FormulaSink<'_>) {
    let mut joiner = Joiner::new(text);
    let macros = Macros::from_text(text, text.len(), elsewhere);
    body(text, &macros, &mut |formula| joiner.take(formula, each));
    joiner.finish(each);
}

fn body(text: &str, macros: &Macros<'_>, each: &mut FormulaSink<'_>) {
    let bytes = text.as_bytes();
    let mut ends = Ends::default();
    let (mut at, mut scope, mut inside) = (0, 0u32, Vec::new());
    // Whether groups and conditions have ended so far; one without an end is looked for once.
    let (mut closes, mut ends_conditions) = (true, true);
    while at < bytes.len() {
        match bytes[at] {
            b'%' => at += text[at..].find('\n').unwrap_or(bytes.len() - at),
            b'$' => {
                let end = if bytes[at..].starts_with(b"$$") { "$$" } else { "$" };
                at = read_until(text, at, end.len(), end, scope, macros, each);
            }
            b'\\' => {
                let rest = &text[at + 1..];
                let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
                let name = &rest[..length];
                match (name, rest.bytes().next()) {
                    ("", Some(b'[')) => at = read_until(text, at, 2, "\\]", scope, macros, each),
                    ("", Some(b'(')) => at = read_until(text, at, 2, "\\)", scope, macros, each),
                    ("", next) => at += 1 + usize::from(next.is_some_and(|c| c.is_ascii())),
                    ("begin", _) => at = begin(text, at, &mut scope, &mut inside, macros, each),
                    ("end", _) => {
                        let closing = group_text(text, at + 4).unwrap_or_default();
                        if closing == "document" {
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
                        at = definition(text, at).map_or(at + 1 + length, |(_, _, end)| end);
                    }
                    ("iffalse", _) if ends_conditions => {
                        let end = rest.find("\\fi");
                        ends_conditions = end.is_some();
                        at += end.map_or(length + 1, |end| end + 4);
                    }
                    ("verb" | "lstinline", Some(_)) => {
                        let behind = &text[at + 1 + length..];
                        let mark = behind.chars().next().unwrap_or('|');
                        // It ends in its line, and near.
                        let mut inside = behind.char_indices().skip(1).take(FARTHEST).take_while(|(_, c)| *c != '\n');
                        let end = inside.find(|(_, c)| *c == mark).map_or(0, |(end, _)| end);
                        at += 1 + length + end + mark.len_utf8();
                    }
                    // What the document sets to nothing isn't printed.
                    (name, _) if macros.get(name).is_some_and(|of| of.arguments > 0 && of.body.trim().is_empty()) => {
                        at += 1 + length;
                        let unprinted = if closes { closing_brace(&bytes[at..]) } else { None };
                        closes &= unprinted.is_some();
                        at += unprinted.unwrap_or(0);
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

fn begin(
    text: &str,
    at: usize,
    scope: &mut u32,
    inside: &mut Vec<u32>,
    macros: &Macros<'_>,
    each: &mut FormulaSink<'_>,
) -> usize {
    let Some(name) = group_text(text, at + 6) else { return at + 6 };
    let open = at + 6 + name.len() + 2;
    if DISPLAYS.contains(&name) || MORE.contains(&name) {
        let end = format!("\\end{{{name}}}");
        return read_until(text, at, open - at, &end, *scope, macros, each);
    }
    if VERBATIM.contains(&name) {
        let end = format!("\\end{{{name}}}");
        return text.get(open..).and_then(|rest| rest.find(&end)).map_or(text.len(), |found| open + found + end.len());
    }
    if SCOPES.contains(&name) && inside.len() < 1000 {
        inside.push(*scope);
        *scope = u32::try_from(at).unwrap_or(u32::MAX).saturating_add(1);
    }
    open
}

/// Reads the formula that begins at `at` with a mark of `open` bytes and ends with `end`; the byte behind it.
fn read_until(
    text: &str,
    at: usize,
    open: usize,
    end: &str,
    scope: u32,
    macros: &Macros<'_>,
    each: &mut FormulaSink<'_>,
) -> usize {
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
    let Some(source) = text.get(start..close) else { return close };
    let mut formula = Formula::new(tex::formula(&signs(source, start), macros), Span::new(at, close + end.len()));
    formula.scope = scope;
    each(formula);
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
            let mut ends: Vec<String> = ends.collect();
            ends.sort();
            ends.truncate(MOST_ENDS);
            self.0.push((end.to_owned(), ends, 0));
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
    each: &mut FormulaSink<'_>,
) -> usize {
    let behind = at + 1 + name.len();
    let opened = |body: &str| {
        let begins = body.trim().strip_prefix("\\begin{")?.split('}').next()?;
        (DISPLAYS.contains(&begins) || MORE.contains(&begins)).then(|| format!("\\end{{{begins}}}"))
    };
    let Some(end) = macros.get(name).and_then(|of| opened(&of.body)) else { return behind };
    let Some((found, close)) = ends.nearest(text, behind, &end, macros) else { return behind };
    let source = &text[behind..found];
    let mut formula = Formula::new(tex::formula(&signs(source, behind), macros), Span::new(at, close));
    formula.scope = scope;
    each(formula);
    close
}
