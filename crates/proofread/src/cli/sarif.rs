//! Findings for code review: the Static Analysis Results Interchange Format, version 2.1.0 (OASIS).

use super::baseline::fingerprint;
use super::documents::Document;
use super::{CheckedDocument, ReportWriter, RunTotals};
use crate::judge::section::ReportSection;
use crate::judge::verdict::ChainVerdict;
use crate::tell::finding::ChainFinding;
use crate::tell::line_index::LineIndex;
use crate::tell::sarif::{encoded, file_uri, location, log};
use serde_json::{Value, json};

#[derive(Default)]
pub(crate) struct SarifWriter {
    results: Vec<Value>,
}

/// Where a document is, as code review names it: a file by its path in its repository, or below the working directory where there
/// is none. A line of JSON counts as a file in the working directory, whatever its id says.
fn uri(document: &Document) -> String {
    let Some(path) = &document.path else {
        let parts = document.name.split('/').filter(|part| !matches!(*part, "" | "."));
        let parts = parts.map(|part| if part == ".." { "__" } else { part });
        return format!("./{}", encoded(parts.map(str::as_bytes)));
    };
    file_uri(path)
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default() + letters.as_str()
}

fn result(uri: &str, finding: &ChainFinding, lines: &LineIndex<'_>) -> Value {
    let [start, end] = lines.line_columns(finding.at);
    let mut message = format!("{}: {}.", finding.chain, finding.verdict.description());
    message += &format!(" {}.", capitalised(&finding.values_in_words()));
    if let Some(hint) = &finding.hint {
        message += &format!(" {} would agree.", hint.words);
    }
    json!({
        "ruleId": finding.verdict.name(),
        "level": match finding.section {
            ReportSection::Numbers | ReportSection::Statistics => "error",
            ReportSection::Doubts => "note",
            ReportSection::Units | ReportSection::Bindings | ReportSection::Agreeing => "warning",
        },
        "message": { "text": message },
        "locations": [location(uri, start, end)],
        "partialFingerprints": { "chain/v1": fingerprint(finding) },
        "properties": { "printed": finding.printed, "recomputed": finding.recomputed, "factor": finding.factor },
    })
}

impl ReportWriter for SarifWriter {
    fn document(&mut self, checked: &CheckedDocument<'_>) -> String {
        let lines = LineIndex::new(&checked.document.text);
        let uri = if checked.findings.is_empty() { String::new() } else { uri(checked.document) };
        let results = checked.findings.iter().map(|finding| result(&uri, finding, &lines));
        self.results.extend(results);
        String::new()
    }

    fn end(&mut self, _sum: &RunTotals) -> String {
        let found = [
            ChainVerdict::Truncated,
            ChainVerdict::Units,
            ChainVerdict::LastDigit,
            ChainVerdict::Inconsistent,
            ChainVerdict::Dimensions,
        ];
        let rules: Vec<Value> = found
            .iter()
            .map(|verdict| json!({ "id": verdict.name(), "shortDescription": { "text": verdict.description() } }))
            .collect();
        log("proofread", &rules, std::mem::take(&mut self.results))
    }
}
