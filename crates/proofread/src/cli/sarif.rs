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

fn result(uri: &str, finding: &ChainFinding, lines: &LineIndex<'_>, document: &Document) -> Value {
    let [start, end] = lines.line_columns(finding.at);
    let mut message = format!("{}: {}.", finding.chain, finding.verdict.description());
    if let Some(recomputed) = &finding.recomputed {
        message += &format!(" Printed {}, recomputed {recomputed}.", finding.printed);
    }
    if let Some(hint) = &finding.hint {
        message += &format!(" {} would agree.", hint.words);
    }
    let mut place = location(uri, start, end);
    // A chapter of a book is no file of its own.
    let chapter = document.path.as_ref().and_then(|path| document.name.strip_prefix(&format!("{}/", path.display())));
    if let Some(label) = document.label(start.line).or(chapter) {
        place["logicalLocations"] = json!([{ "name": label }]);
        message = format!("In {label}: {message}");
    }
    json!({
        "ruleId": finding.verdict.name(),
        "level": match finding.section {
            ReportSection::Numbers | ReportSection::Statistics => "error",
            ReportSection::Doubts => "note",
            ReportSection::Units | ReportSection::Bindings | ReportSection::Agreeing => "warning",
        },
        "message": { "text": message },
        "locations": [place],
        "partialFingerprints": { "chain/v1": fingerprint(finding) },
    })
}

impl ReportWriter for SarifWriter {
    fn document(&mut self, checked: &CheckedDocument<'_>) -> String {
        let lines = LineIndex::new(&checked.document.text);
        let uri = if checked.findings.is_empty() { String::new() } else { uri(checked.document) };
        let results = checked.findings.iter().map(|finding| result(&uri, finding, &lines, checked.document));
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
