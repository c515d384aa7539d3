//! Findings for programs: JSON, and lines of JSON.

use super::{Checked, Sum, Writer};
use crate::check::Tally;
use crate::doubt::Doubt;
use crate::finding::Finding;
use crate::place::{Lines as TextLines, Place};
use crate::token::Span;
use crate::verdict::Verdict;
use serde_json::{Map, Value, json};

/// The version of the form, raised when a field changes its meaning.
pub(crate) const VERSION: u32 = 1;

fn place(place: Place) -> Value {
    json!({ "line": place.line, "column": place.column })
}

fn span(span: Span, lines: &TextLines<'_>) -> Value {
    let [start, end] = lines.places(span);
    json!({ "start": place(start), "end": place(end), "bytes": [span.start, span.end] })
}

fn finding(finding: &Finding, lines: &TextLines<'_>) -> Value {
    json!({
        "list": finding.list.name(),
        "verdict": finding.verdict.name(),
        "message": finding.verdict.words(),
        "chain": finding.chain,
        "left": finding.left,
        "right": finding.right,
        "printed": finding.printed,
        "recomputed": finding.recomputed,
        "explanation": finding.explanation,
        "why": finding.why,
        "doubt": finding.doubt.map(Doubt::words),
        "hint": finding.hint.as_ref().map(|hint| hint.words.as_str()),
        "reading": finding.reading,
        "names": finding.names,
        "at": span(finding.at, lines),
        "chain_at": span(finding.span, lines),
    })
}

fn tally(tally: &Tally) -> Value {
    let verdicts: Map<String, Value> =
        Verdict::ALL.iter().map(|verdict| (verdict.name().to_owned(), tally.with(*verdict).into())).collect();
    json!({
        "bytes": tally.bytes,
        "formulas": tally.formulas,
        "unread": tally.unread,
        "chains": tally.chains,
        "checkable": tally.checkable,
        "checked": tally.checked,
        "pairs": tally.pairs,
        "doubts": tally.doubts,
        "verdicts": verdicts,
    })
}

fn document(checked: &Checked<'_>) -> Value {
    let lines = if checked.findings.is_empty() { TextLines::new("") } else { TextLines::new(&checked.document.text) };
    let findings: Vec<Value> = checked.findings.iter().map(|of| finding(of, &lines)).collect();
    json!({
        "id": checked.document.name,
        "format": checked.document.format.name(),
        "tally": tally(&checked.tally),
        "findings": findings,
    })
}

fn sum(of: &Sum) -> Value {
    let [numbers, units, bindings, _, doubts] = of.found;
    json!({
        "documents": of.documents,
        "found": { "numbers": numbers, "units": units, "bindings": bindings, "doubts": doubts },
        "accepted": of.accepted,
        "tally": tally(&of.tally),
    })
}

/// One object.
#[derive(Default)]
pub(crate) struct Json {
    documents: Vec<Value>,
}

impl Writer for Json {
    fn document(&mut self, checked: &Checked<'_>) -> String {
        self.documents.push(document(checked));
        String::new()
    }

    fn end(&mut self, of: &Sum) -> String {
        let documents = std::mem::take(&mut self.documents);
        format!("{:#}\n", json!({ "version": VERSION, "documents": documents, "sum": sum(of) }))
    }
}

/// An object per document, and one with the sums.
pub(crate) struct Lines;

impl Writer for Lines {
    fn document(&mut self, checked: &Checked<'_>) -> String {
        format!("{}\n", json!({ "version": VERSION, "document": document(checked) }))
    }

    fn end(&mut self, of: &Sum) -> String {
        format!("{}\n", json!({ "version": VERSION, "sum": sum(of) }))
    }
}
