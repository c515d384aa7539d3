//! Findings for code review: the Static Analysis Results Interchange Format, version 2.1.0 (OASIS).

use super::baseline::fingerprint;
use super::{Checked, Sum, Writer};
use crate::finding::{Finding, List};
use crate::place::Lines;
use crate::verdict::Verdict;
use serde_json::{Value, json};

#[derive(Default)]
pub(crate) struct Sarif {
    results: Vec<Value>,
}

/// A path as part of a URI.
fn uri(name: &str) -> String {
    let mut out = String::new();
    for byte in name.trim_start_matches("./").bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'/' | b'.' | b'-' | b'_' | b'~' => out.push(char::from(byte)),
            b'\\' => out.push('/'),
            _ => out += &format!("%{byte:02X}"),
        }
    }
    out
}

fn result(name: &str, finding: &Finding, lines: &Lines<'_>) -> Value {
    let [start, end] = lines.places(finding.at);
    let mut message = format!("{}: {}.", finding.chain, finding.verdict.words());
    if let Some(recomputed) = &finding.recomputed {
        message += &format!(" Printed {}, recomputed {recomputed}.", finding.printed);
    }
    if let Some(hint) = &finding.hint {
        message += &format!(" {} would agree.", hint.words);
    }
    json!({
        "ruleId": finding.verdict.name(),
        "level": match finding.list {
            List::Numbers => "error",
            List::Doubts => "note",
            List::Units | List::Bindings | List::Agreeing => "warning",
        },
        "message": { "text": message },
        "locations": [{
            "physicalLocation": {
                "artifactLocation": { "uri": uri(name) },
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

impl Writer for Sarif {
    fn document(&mut self, checked: &Checked<'_>) -> String {
        let lines = Lines::new(&checked.document.text);
        let results = checked.findings.iter().map(|finding| result(&checked.document.name, finding, &lines));
        self.results.extend(results);
        String::new()
    }

    fn end(&mut self, _sum: &Sum) -> String {
        let found =
            [Verdict::Truncated, Verdict::Units, Verdict::LastDigit, Verdict::Inconsistent, Verdict::Dimensions];
        let rules: Vec<Value> = found
            .iter()
            .map(|verdict| json!({ "id": verdict.name(), "shortDescription": { "text": verdict.words() } }))
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
