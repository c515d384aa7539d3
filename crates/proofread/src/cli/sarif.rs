//! Findings for code review: the Static Analysis Results Interchange Format, version 2.1.0 (OASIS).

use super::baseline::fingerprint;
use super::documents::Document;
use super::{CheckedDocument, ReportWriter, RunTotals};
use crate::finding::{ChainFinding, ReportSection};
use crate::line_index::LineIndex;
use crate::verdict::ChainVerdict;
use geneva_host::git::Repository;
use serde_json::{Value, json};
use std::path::{Component, Path};

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
    let whole = path.canonicalize().unwrap_or_else(|_| path.clone());
    let top = Repository::containing(&whole).map(|repository| repository.top().to_owned());
    let top = top.or_else(|| std::env::current_dir().and_then(|folder| folder.canonicalize()).ok());
    match top.and_then(|top| whole.strip_prefix(top).ok()) {
        Some(inside) => encoded(path_names(inside)),
        None => format!("file:///{}", encoded(path_names(&whole))),
    }
}

/// The names of which a path is made.
fn path_names(path: &Path) -> impl Iterator<Item = &[u8]> {
    path.components().filter_map(|part| match part {
        Component::Normal(name) => Some(name.as_encoded_bytes()),
        _ => None,
    })
}

/// Names with strokes between them, and a code for each byte that may mean something else.
fn encoded<'n>(names: impl Iterator<Item = &'n [u8]>) -> String {
    let mut out = String::new();
    for name in names {
        out += if out.is_empty() { "" } else { "/" };
        for byte in name {
            match byte {
                b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'.' | b'-' | b'_' | b'~' => out.push(char::from(*byte)),
                _ => out += &format!("%{byte:02X}"),
            }
        }
    }
    out
}

fn result(uri: &str, finding: &ChainFinding, lines: &LineIndex<'_>) -> Value {
    let [start, end] = lines.line_columns(finding.at);
    let mut message = format!("{}: {}.", finding.chain, finding.verdict.description());
    if let Some(recomputed) = &finding.recomputed {
        message += &format!(" Printed {}, recomputed {recomputed}.", finding.printed);
    }
    if let Some(hint) = &finding.hint {
        message += &format!(" {} would agree.", hint.words);
    }
    json!({
        "ruleId": finding.verdict.name(),
        "level": match finding.section {
            ReportSection::Numbers => "error",
            ReportSection::Doubts => "note",
            ReportSection::Units | ReportSection::Bindings | ReportSection::Agreeing => "warning",
        },
        "message": { "text": message },
        "locations": [{
            "physicalLocation": {
                "artifactLocation": { "uri": uri },
                "region": {
                    "startLine": start.line,
                    "startColumn": start.column,
                    "endLine": end.line,
                    "endColumn": end.column,
                },
            },
        }],
        "partialFingerprints": { "chain/v1": fingerprint(finding) },
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
        let run = json!({
            "tool": { "driver": { "name": "proofread", "version": env!("CARGO_PKG_VERSION"), "rules": rules } },
            "columnKind": "unicodeCodePoints",
            "results": std::mem::take(&mut self.results),
        });
        let schema = "https://json.schemastore.org/sarif-2.1.0.json";
        format!("{:#}\n", json!({ "$schema": schema, "version": "2.1.0", "runs": [run] }))
    }
}
