//! Findings for programs: JSON, and lines of JSON.

use super::documents::Document;
use super::{CheckedDocument, ReportWriter, RunTotals};
use crate::judge::caveat::Caveat;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::doubt::Doubt;
use crate::judge::unchecked::UncheckedKind;
use crate::named_counts::NamedCounts;
use crate::reader::UnreadKind;
use crate::tell::finding::ChainFinding;
use crate::tell::finding_group::FindingGroup;
use crate::tell::line_index::{LineColumn, LineIndex};
use crate::tell::tally::CheckTally;
use crate::tell::unchecked_chain::UncheckedChain;
use crate::token::Span;
use serde_json::{Map, Value, json};

/// The version of the form, raised when a field changes its meaning.
pub(crate) const VERSION: u32 = 2;

fn place(place: LineColumn) -> Value {
    json!({ "line": place.line, "column": place.column })
}

fn span(span: Span, lines: &LineIndex<'_>) -> Value {
    let [start, end] = lines.line_columns(span);
    json!({ "start": place(start), "end": place(end), "bytes": [span.start, span.end] })
}

fn finding(group: &FindingGroup, lines: &LineIndex<'_>, document: &Document) -> Value {
    let finding = &group.finding;
    let mut out = json!({
        "list": finding.section.name(),
        "verdict": finding.verdict.name(),
        "message": finding.verdict.description(),
        "chain": finding.chain,
        "left": finding.left,
        "right": finding.right,
        "printed": finding.printed,
        "recomputed": finding.recomputed,
        "factor": finding.factor,
        "difference": finding.difference,
        "explanation": finding.explanation,
        "why": finding.why,
        "doubt": finding.doubt.map(Doubt::reason),
        "caveat": finding.caveat.map(Caveat::reason),
        "places": group.places().map(|of| found_place(of, lines, document)).collect::<Vec<_>>(),
        "hint": finding.hint.as_ref().map(|hint| hint.words.as_str()),
        "reading": finding.reading,
        "names": finding.names,
        "at": span(finding.at, lines),
        "chain_at": span(finding.span, lines),
    });
    add_place(&mut out, finding.at, lines, document);
    out
}

/// A place of a finding, with what is printed there.
fn found_place(finding: &ChainFinding, lines: &LineIndex<'_>, document: &Document) -> Value {
    let mut out = json!({
        "chain": finding.chain,
        "left": finding.left,
        "right": finding.right,
        "printed": finding.printed,
        "recomputed": finding.recomputed,
        "hint": finding.hint.as_ref().map(|hint| hint.words.as_str()),
        "at": span(finding.at, lines),
        "chain_at": span(finding.span, lines),
    });
    add_place(&mut out, finding.at, lines, document);
    out
}

/// Adds what a place is called, where it isn't called by the number of its line.
fn add_place(out: &mut Value, span: Span, lines: &LineIndex<'_>, document: &Document) {
    if let Some(label) = document.label(lines.line_columns(span)[0].line) {
        out["place"] = label.into();
    }
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
        "partly": tally.partly,
        "pairs": tally.pairs,
        "doubts": tally.doubts,
        "less_certain": tally.less_certain,
        "statistics": {
            "tests": tally.statistics.tests,
            "intervals": tally.statistics.intervals,
            "shares": tally.statistics.shares,
            "totals": tally.statistics.totals,
        },
        "verdicts": verdicts,
    })
}

/// Counts with their kinds and names; `name_of` is the name of a kind.
fn counts<K: Copy + Ord>(of: &NamedCounts<K>, name_of: fn(K) -> &'static str) -> Value {
    of.iter().map(|(kind, name, count)| json!({ "kind": name_of(kind), "name": name, "count": count })).collect()
}

fn unchecked(chain: &UncheckedChain, lines: &LineIndex<'_>, document: &Document) -> Value {
    let mut out = json!({
        "kind": chain.kind.name(),
        "name": chain.name,
        "reason": chain.reason(),
        "chain": chain.chain,
        "partly": chain.partly,
        "chain_at": span(chain.span, lines),
    });
    add_place(&mut out, chain.span, lines, document);
    out
}

fn document(checked: &CheckedDocument<'_>) -> Value {
    let has_places = !checked.findings.is_empty() || checked.unchecked.as_ref().is_some_and(|of| !of.is_empty());
    let lines = LineIndex::new(if has_places { &checked.document.text } else { "" });
    let findings: Vec<Value> = checked.findings.iter().map(|of| finding(of, &lines, checked.document)).collect();
    let mut out = json!({
        "id": checked.document.name,
        "format": checked.document.written_in,
        "tally": tally(&checked.tally),
        "not_checked": counts(&checked.not_checked, UncheckedKind::name),
        "not_read": counts(&checked.not_read, UnreadKind::name),
        "findings": findings,
    });
    if let Some(chains) = &checked.unchecked {
        out["unchecked"] = chains.iter().map(|chain| unchecked(chain, &lines, checked.document)).collect();
    }
    out
}

fn sum(of: &RunTotals) -> Value {
    let parts = of.unchecked_parts.iter();
    let parts: Vec<Value> =
        parts.map(|of| json!({ "file": of.file.display().to_string(), "count": of.count })).collect();
    let found = |of: [usize; 7]| {
        let [numbers, units, bindings, _, doubts, statistics, less_certain] = of;
        json!({
            "numbers": numbers,
            "units": units,
            "bindings": bindings,
            "doubts": doubts,
            "statistics": statistics,
            "less_certain": less_certain,
        })
    };
    json!({
        "documents": of.documents,
        "found": found(of.found.findings),
        "places": found(of.found.places),
        "less_certain": of.less_certain,
        "accepted": of.accepted,
        "accepted_gone": of.idle_cases.gone,
        "accepted_unread": of.idle_cases.unread,
        "tally": tally(&of.tally),
        "not_checked": counts(&of.not_checked, UncheckedKind::name),
        "not_read": counts(&of.not_read, UnreadKind::name),
        "only_macros": parts,
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
