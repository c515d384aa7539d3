//! Markdown with TeX, the sources of an mdBook among it.

use super::adjoining::Joiner;
use super::comments::note_comments;
use super::definitions::{Macros, NamedMacros};
use super::delimited::{self, Dollars};
use super::fences::{Fences, name_of_fence, with_plain_fences};
use super::unread::{UnreadKind, UnreadParts, note};
use super::{Formula, FormulaSink, markup, plain, tex};
use crate::order::sort_by_place;
use crate::token::{Span, signs};
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use std::ops::Range;

/// Markdown is parsed in pieces of about this many bytes, so that a long text takes little memory.
const PIECE: usize = 1 << 18;

/// Finds the formulas between marks, in fences of maths, in MathML, and in the lines between; what is not read. The text may have
/// macros of its own, anywhere in it, and `elsewhere` has those of other texts.
pub(crate) fn read(
    text: &str,
    dollars: Dollars,
    elsewhere: Option<&NamedMacros>,
    each: &mut FormulaSink<'_>,
) -> UnreadParts {
    let macros = Macros::from_text(text, text.len(), elsewhere).in_markdown();
    let mut unread = UnreadParts::default();
    let mut joiner = Joiner::new(text);
    for piece in pieces(text) {
        let mut found: Vec<Formula> = Vec::new();
        piece_of(&text[piece.clone()], (dollars, &macros), &mut unread, &mut |formula| found.push(formula));
        sort_by_place(&mut found, |formula| formula.span);
        for mut formula in found {
            let by = piece.start as u32;
            if by > 0 {
                formula.map_spans(&|span| Span { start: span.start + by, end: span.end + by });
            }
            joiner.take(formula, each);
        }
    }
    joiner.finish(each);
    unread
}

/// The fences of code in which a chain may be, with their languages.
#[cfg(feature = "cli")]
pub(crate) fn unread_fences(text: &str) -> Vec<(Span, String)> {
    let mut out = Vec::new();
    for piece in pieces(text) {
        code(&text[piece.clone()], &mut |kind, name, range| {
            let mut alone = UnreadParts::default();
            note(&mut alone, kind, name, &text[piece.start + range.start..piece.start + range.end]);
            if kind == UnreadKind::Fence && alone.total() > 0 {
                out.push((Span::new(piece.start + range.start, piece.start + range.end), name.to_owned()));
            }
        });
    }
    out
}

/// Cuts before a line behind a blank one, outside fences; a line that is longer than several pieces is cut between words, outside
/// formulas and code.
pub(super) fn pieces(text: &str) -> Vec<Range<usize>> {
    let (mut out, mut start, mut at) = (Vec::new(), 0, 0);
    let (mut fences, mut blank) = (Fences::default(), false);
    for line in text.split_inclusive('\n') {
        if blank && fences.are_closed() && at - start >= PIECE && !line.starts_with([' ', '\t']) {
            out.push(start..at);
            start = at;
        }
        if line.len() > 4 * PIECE && fences.are_closed() {
            if at > start {
                out.push(start..at);
            }
            start = at;
            while let Some(length) = cut_of_line(&text[start..at + line.len()]) {
                out.push(start..start + length);
                start += length;
            }
        }
        fences.take(line);
        blank = line.trim_start().is_empty();
        at += line.len();
        // A fence that is never closed, or a line without end, must not make a piece of everything.
        if at - start >= 4 * PIECE {
            out.push(start..at);
            (start, fences) = (at, Fences::default());
        }
    }
    out.push(start..text.len());
    out
}

/// Longest formula or stretch of code that a cut inside a line spares, in bytes: a mark whose partner is farther away is a plain sign.
const LONGEST_MARKED: usize = 20_000;

/// How long the first piece of a long line is; none if the line is short enough.
///
/// The next piece begins with a letter behind a space, which starts no list, heading or block of code.
fn cut_of_line(line: &str) -> Option<usize> {
    // So that the rest is no scrap.
    if line.len() <= 2 * PIECE {
        return None;
    }
    let bytes = line.as_bytes();
    // Where formulas or code begin that were not closed yet, and what closes them.
    let mut open: Option<(usize, &[u8])> = None;
    let mut at = 0;
    while at < 2 * PIECE {
        let rest = &bytes[at..];
        open = open.filter(|(from, _)| at - from < LONGEST_MARKED);
        let mark = [
            (&b"$$"[..], &b"$$"[..]),
            (b"$", b"$"),
            (br"\(", br"\)"),
            (br"\[", br"\]"),
            (b"`", b"`"),
            (b"<math", b"</math>"),
        ]
        .into_iter()
        .find(|(begins, _)| rest.starts_with(begins));
        at += match (open, mark) {
            (Some((_, ends)), _) if rest.starts_with(ends) => {
                open = None;
                ends.len()
            }
            (None, Some((begins, ends))) => {
                open = Some((at, ends));
                begins.len()
            }
            (None, None) if at >= PIECE && rest[0].is_ascii_alphabetic() && bytes[at - 1] == b' ' => return Some(at),
            // The sign behind a backslash is no mark.
            _ if rest[0] == b'\\' => 2,
            _ => 1,
        };
    }
    // There is no such place: behind any space, or anywhere.
    let latest = (PIECE..=2 * PIECE).rev().filter(|at| line.is_char_boundary(*at));
    latest.clone().find(|at| bytes[at - 1] == b' ').or_else(|| latest.clone().next())
}

fn piece_of(
    text: &str,
    (dollars, macros): (Dollars, &Macros<'_>),
    unread: &mut UnreadParts,
    each: &mut FormulaSink<'_>,
) {
    let (skip, fences) = code(text, &mut |kind, name, range| note(unread, kind, name, &text[range]));
    for mut fence in fences {
        // The options of a directive.
        while text[fence.clone()].starts_with(':')
            && let Some(end) = text[fence.clone()].find('\n')
        {
            fence.start += end + 1;
        }
        let source = &text[fence.clone()];
        note_comments(source, unread);
        let tokens = tex::formula(&signs(source, fence.start), macros);
        each(Formula::new(tokens, Span::new(fence.start, fence.end)));
    }
    let spans: Vec<Range<usize>> =
        skip.iter().filter(|range| text[(*range).clone()].starts_with('`')).cloned().collect();
    let marked = delimited::formulas(text, &skip, dollars);
    let mut taken = skip;
    for of in marked {
        let source = &text[of.inside.clone()];
        note_comments(source, unread);
        let tokens = tex::formula(&signs(source, of.inside.start), macros);
        each(Formula::new(tokens, Span::new(of.whole.start, of.whole.end)));
        taken.push(of.whole);
    }
    sort_by_place(&mut taken, |range| range.start);
    for range in mathml(text, &taken) {
        markup::read(&text[range.clone()], None, &mut |mut formula| {
            let by = range.start as u32;
            formula.map_spans(&|span| Span { start: span.start + by, end: span.end + by });
            each(formula);
        });
        taken.push(range);
    }
    sort_by_place(&mut taken, |range| range.start);
    plain::read(text, &taken, each);
    for span in spans {
        let marks = text[span.clone()].bytes().take_while(|byte| *byte == b'`').count();
        if let Some(code) = text.get(span.start + marks..span.end.saturating_sub(marks))
            && plain::is_arithmetic(code)
        {
            plain::read_code(code, span.start + marks, each);
        }
    }
}

/// Elements of MathML outside the stretches to skip.
fn mathml(text: &str, skip: &[Range<usize>]) -> Vec<Range<usize>> {
    let mut out = Vec::new();
    let mut from = 0;
    // Where the stretches end that begin before the element.
    let (mut skipped, mut until) = (skip.iter().peekable(), 0);
    while let Some(at) = text[from..].find("<math").map(|at| from + at) {
        let end = text[at..].find("</math>").map_or(text.len(), |end| at + end + "</math>".len());
        while let Some(range) = skipped.next_if(|range| range.start <= at) {
            until = until.max(range.end);
        }
        if at >= until {
            out.push(at..end);
        }
        from = end;
    }
    out
}

/// The stretches that are no text, and the content of fences that say they are maths. What is not read is handed over with its name.
fn code(text: &str, unread: &mut dyn FnMut(UnreadKind, &str, Range<usize>)) -> (Vec<Range<usize>>, Vec<Range<usize>>) {
    let (mut skip, mut fences) = (Vec::new(), Vec::new());
    let plain = with_plain_fences(text);
    for chunk in plain.iter().flat_map(|plain| &plain.chunks) {
        let info =
            text[chunk.clone()].lines().next().unwrap_or_default().trim_start_matches([' ', '\t', '>', '`', '~']);
        unread(UnreadKind::Fence, name_of_fence(info), chunk.clone());
        skip.push(chunk.clone());
    }
    let (mut maths, mut withdrawn) = (false, Vec::new());
    let read = plain.as_ref().map_or(text, |plain| &plain.text);
    for (event, range) in Parser::new_ext(read, Options::empty()).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                maths = matches!(&kind, CodeBlockKind::Fenced(info) if is_maths(info));
                if !maths {
                    let block = &text[range.clone()];
                    let first = block.lines().next().unwrap_or_default();
                    let info = first.trim_start_matches([' ', '`', '~']).trim();
                    if kind == CodeBlockKind::Indented {
                        unread(UnreadKind::Indented, "", range.clone());
                    } else {
                        unread(UnreadKind::Fence, name_of_fence(info), range.clone());
                    }
                }
                skip.push(range);
            }
            Event::End(TagEnd::CodeBlock) => maths = false,
            Event::Text(_) if maths => match fences.last_mut() {
                Some(Range { end, .. }) if *end == range.start => *end = range.end,
                _ => fences.push(range),
            },
            Event::Code(code) => {
                if !plain::is_arithmetic(&code) {
                    unread(UnreadKind::Code, "", range.clone());
                }
                skip.push(range);
            }
            _ => {}
        }
    }
    sort_by_place(&mut skip, |range| range.start);
    // What is withdrawn in code is counted with the code; neither is in something else of its kind.
    for range in super::withdrawn_ranges(text) {
        let before = skip.partition_point(|code: &Range<usize>| code.start <= range.start);
        let in_code = before.checked_sub(1).and_then(|at| skip.get(at)).is_some_and(|code| range.start < code.end);
        if !in_code && !text[range.clone()].starts_with("://") {
            unread(UnreadKind::Comment, "", range.clone());
        }
        withdrawn.push(range);
    }
    skip.append(&mut withdrawn);
    skip.extend(plain.into_iter().flat_map(|plain| plain.marks));
    sort_by_place(&mut skip, |range| range.start);
    (skip, fences)
}

/// Whether the words behind the mark of a fence say that a formula is in it.
fn is_maths(info: &str) -> bool {
    matches!(info, "math" | "latex" | "tex" | "katex") || info.starts_with("{math}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_line_is_cut_outside_formulas_and_code() {
        let words = |unit: &str| unit.repeat(6 * PIECE / unit.len());
        for unit in [
            "is $a = b + c$ or ",
            "is $$a = b + c$$ or ",
            r"is \(a = b\) or \[b = c\] or ",
            "is `a = b or c` or ",
            "is <math> <mi>a</mi> <mo>=</mo> </math> or ",
            r"is \$ or $a = b or \$ c$ or ",
        ] {
            let text = words(unit);
            let pieces = pieces(&text);
            assert!(pieces.len() >= 3 && pieces.iter().all(|piece| piece.len() <= 2 * PIECE), "{unit}");
            let ends = pieces.iter().map(|piece| piece.end).collect::<Vec<_>>();
            assert!(pieces.iter().skip(1).map(|piece| piece.start).eq(ends.iter().take(ends.len() - 1).copied()));
            let at_edges = |at: usize| {
                text[at..].starts_with("or is ") || text[at..].starts_with("is ") || text[at..].starts_with("or ")
            };
            assert!(pieces.iter().all(|piece| at_edges(piece.start)), "{unit}");
            // Whole units only, or the first word of one.
            for piece in &pieces {
                let offset = piece.start % unit.len();
                let is_outside = unit.starts_with("is") && (offset == 0 || unit[offset..] == *"or ")
                    || unit[offset..].starts_with("or ");
                assert!(is_outside, "{unit} {offset}");
            }
        }
    }

    #[test]
    fn a_long_line_without_a_place_for_a_cut_is_cut_anyway() {
        for unit in ["é", "a", "$", "`", r"\", r"\(", "$ 1", "  ", "<math ", "\u{1f600}"] {
            let text = unit.repeat(9 * PIECE / unit.len());
            let pieces = pieces(&text);
            assert!(pieces.iter().all(|piece| piece.len() <= 2 * PIECE), "{unit}");
            assert_eq!(pieces.iter().map(|piece| &text[piece.clone()]).collect::<String>(), text, "{unit}");
        }
    }
}
