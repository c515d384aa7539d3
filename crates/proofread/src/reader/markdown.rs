//! Markdown with TeX, the sources of an mdBook among it.

use super::adjoining::Joiner;
use super::delimited::{self, Dollars};
use super::{Formula, FormulaSink, markup, plain, tex};
use crate::token::{Span, signs};
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use std::ops::Range;

/// Markdown is parsed in pieces of about this many bytes, so that a long text takes little memory.
const PIECE: usize = 1 << 18;

/// Finds the formulas between marks, in fences of maths, in MathML, and in the lines between.
pub(crate) fn read(text: &str, dollars: Dollars, each: &mut FormulaSink<'_>) {
    let mut joiner = Joiner::new(text);
    for piece in pieces(text) {
        let mut found: Vec<Formula> = Vec::new();
        piece_of(&text[piece.clone()], dollars, &mut |formula| found.push(formula));
        found.sort_by_key(|formula| formula.span);
        for mut formula in found {
            let by = piece.start as u32;
            if by > 0 {
                formula.map_spans(&|span| Span { start: span.start + by, end: span.end + by });
            }
            joiner.take(formula, each);
        }
    }
    joiner.finish(each);
}

/// Cuts before a line behind a blank one, outside fences.
pub(super) fn pieces(text: &str) -> Vec<Range<usize>> {
    let (mut out, mut start, mut at) = (Vec::new(), 0, 0);
    let (mut fence, mut blank) = (None, false);
    for line in text.split_inclusive('\n') {
        let trimmed = line.trim_start();
        let mark = trimmed.chars().next().filter(|c| "`~".contains(*c));
        let opens = mark.filter(|c| trimmed.chars().take_while(|of| of == c).count() >= 3);
        if blank && fence.is_none() && at - start >= PIECE && !line.starts_with([' ', '\t']) {
            out.push(start..at);
            start = at;
        }
        match (fence, opens) {
            (None, Some(c)) => fence = Some(c),
            (Some(open), Some(c)) if open == c => fence = None,
            _ => {}
        }
        blank = trimmed.is_empty();
        at += line.len();
        // A fence that is never closed, or a line without end, must not make a piece of everything.
        if at - start >= 4 * PIECE {
            out.push(start..at);
            (start, fence) = (at, None);
        }
    }
    out.push(start..text.len());
    out
}

fn piece_of(text: &str, dollars: Dollars, each: &mut FormulaSink<'_>) {
    let (skip, fences) = code(text);
    for fence in fences {
        let source = &text[fence.clone()];
        let tokens = tex::formula(&signs(source, fence.start), &super::definitions::Macros::default());
        each(Formula::new(tokens, Span::new(fence.start, fence.end)));
    }
    let marked = delimited::formulas(text, &skip, dollars);
    let mut taken = skip;
    for of in marked {
        let tokens =
            tex::formula(&signs(&text[of.inside.clone()], of.inside.start), &super::definitions::Macros::default());
        each(Formula::new(tokens, Span::new(of.whole.start, of.whole.end)));
        taken.push(of.whole);
    }
    taken.sort_by_key(|range| range.start);
    for range in mathml(text, &taken) {
        markup::read(&text[range.clone()], &mut |mut formula| {
            let by = range.start as u32;
            formula.map_spans(&|span| Span { start: span.start + by, end: span.end + by });
            each(formula);
        });
        taken.push(range);
    }
    taken.sort_by_key(|range| range.start);
    plain::read(text, &taken, each);
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

/// The stretches that are code, and the content of fences that say they are maths.
fn code(text: &str) -> (Vec<Range<usize>>, Vec<Range<usize>>) {
    let (mut skip, mut fences) = (Vec::new(), Vec::new());
    let mut maths = false;
    skip.extend(super::withdrawn_ranges(text));
    for (event, range) in Parser::new_ext(text, Options::empty()).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                maths = matches!(&kind, CodeBlockKind::Fenced(info) if matches!(&**info, "math" | "{math}" | "latex" | "tex" | "katex"));
                skip.push(range);
            }
            Event::End(TagEnd::CodeBlock) => maths = false,
            Event::Text(_) if maths => match fences.last_mut() {
                Some(Range { end, .. }) if *end == range.start => *end = range.end,
                _ => fences.push(range),
            },
            Event::Code(_) => skip.push(range),
            _ => {}
        }
    }
    skip.sort_by_key(|range| range.start);
    (skip, fences)
}
