//! Findings for programs: JSON, and lines of JSON.

use super::{CheckedDocument, ReportWriter, RunTotals};
use crate::check::CheckTally;
use crate::doubt::Doubt;
use crate::finding::ChainFinding;
use crate::line_index::{LineColumn, LineIndex};
use crate::token::Span;
use crate::verdict::ChainVerdict;
use serde_json::{Map, Value, json};

/// The version of the form, raised when a field changes its meaning.
pub(crate) const VERSION: u32 = 1;

fn place(place: LineColumn) -> Value {
    json!({ "line": place.line, "column": place.column })
}

fn span(span: Span, lines: &LineIndex<'_>) -> Value {
    let [start, end] = lines.line_columns(span);
    json!({ "start": place(start), "end": place(end), "bytes": [span.start, span.end] })
}

fn finding(finding: &ChainFinding, lines: &LineIndex<'_>) -> Value {
    json!({
        "list": finding.section.name(),
        "verdict": finding.verdict.name(),
        "message": finding.verdict.description(),
        "chain": finding.chain,
        "left": finding.left,
        "right": finding.right,
        "printed": finding.printed,
        "recomputed": finding.recomputed,
        "explanation": finding.explanation,
        "why": finding.why,
        "doubt": finding.doubt.map(Doubt::reason),
        "hint": finding.hint.as_ref().map(|hint| hint.words.as_str()),
        "reading": finding.reading,
        "names": finding.names,
        "at": span(finding.at, lines),
        "chain_at": span(finding.span, lines),
    })
}

fn tally(tally: &CheckTally) -> Value {
    let verdicts: Map<String, Value> = ChainVerdict::ALL
        .iter()
        .map(|verdict| (verdict.name().to_owned(), tally.pairs_with(*verdict).into()))
        .collect();
    json!({
        "bytes": tally.bytes,
        "formulas": tally.formulas,
        "unread": tally.unread,
        "chains": tally.chains,
        "checkable": tally.checkable,
        "checked": tally.checked,
        "pairs": tally.pairs,
        "doubts": tally.doubts,
        "statistics": {
            "tests": tally.statistics.tests,
            "intervals": tally.statistics.intervals,
            "shares": tally.statistics.shares,
            "totals": tally.statistics.totals,
        },
        "verdicts": verdicts,
    })
}

fn document(checked: &CheckedDocument<'_>) -> Value {
    let lines = if checked.findings.is_empty() { LineIndex::new("") } else { LineIndex::new(&checked.document.text) };
    let findings: Vec<Value> = checked.findings.iter().map(|of| finding(of, &lines)).collect();
    json!({
        "id": checked.document.name,
        "format": checked.document.format.name(),
        "tally": tally(&checked.tally),
        "findings": findings,
    })
}

fn sum(of: &RunTotals) -> Value {
    let [numbers, units, bindings, _, doubts, statistics] = of.found;
    json!({
        "documents": of.documents,
        "found": { "numbers": numbers, "units": units, "bindings": bindings, "doubts": doubts, "statistics": statistics },
        "accepted": of.accepted,
        "tally": tally(&of.tally),
    })
}

/// One object.
#[derive(Default)]
pub(crate) struct JsonWriter {
    documents: Vec<Value>,
}

impl ReportWriter for JsonWriter {
    fn document(&mut self, checked: &CheckedDocument<'_>) -> String {
        self.documents.push(document(checked));
        String::new()
    }

    fn end(&mut self, of: &RunTotals) -> String {
        let documents = std::mem::take(&mut self.documents);
        format!("{:#}\n", json!({ "version": VERSION, "documents": documents, "sum": sum(of) }))
    }
}

/// An object per document, and one with the sums.
pub(crate) struct JsonLinesWriter;

impl ReportWriter for JsonLinesWriter {
    fn document(&mut self, checked: &CheckedDocument<'_>) -> String {
        format!("{}\n", json!({ "version": VERSION, "document": document(checked) }))
    }

    fn end(&mut self, of: &RunTotals) -> String {
        format!("{}\n", json!({ "version": VERSION, "sum": sum(of) }))
    }
}
