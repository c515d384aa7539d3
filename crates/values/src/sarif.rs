//! What a check found, for code review.

use crate::check::{FindingKind, NumberFinding, NumbersReport};
use geneva_evidence::PlainVerdict;
use proofread::LineColumn;
use proofread::sarif::{file_uri, location, log};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::path::Path;

/// What a check found and is not right, in the Static Analysis Results Interchange Format. An entry whose number is gone is
/// reported at the beginning of its text.
pub fn check_sarif(report: &NumbersReport) -> String {
    let mut uris: HashMap<&Path, String> = HashMap::new();
    let mut results = Vec::new();
    for finding in report.findings.iter().filter(|finding| !finding.kind.is_right()) {
        let NumberFinding { text, at, kind, message, printed, unit, key, .. } = finding;
        let uri = uris.entry(text).or_insert_with(|| file_uri(text));
        let [start, end] = at.unwrap_or([LineColumn { line: 1, column: 1 }; 2]);
        results.push(json!({
            "ruleId": kind.name(),
            "level": if kind.verdict() == PlainVerdict::Wrong { "error" } else { "warning" },
            "message": { "text": format!("{message}.") },
            "locations": [location(uri, start, end)],
            "partialFingerprints": {
                "number/v1": format!("{}: {printed} {unit} {}", kind.name(), key.as_deref().unwrap_or_default()),
            },
        }));
    }
    let rules: Vec<Value> = FindingKind::ALL
        .iter()
        .filter(|(kind, ..)| !kind.is_right())
        .map(|(_, name, meaning)| json!({ "id": name, "shortDescription": { "text": meaning } }))
        .collect();
    log("geneva check", &rules, results)
}
