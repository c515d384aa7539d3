//! What was found of an equation, a figure or a statement.

use crate::html::escape;
use geneva_ledger::{Check, Judged};

/// How a form was found to hold or to fail, with the reading; for a missing datum, what is missing.
pub fn how(judged: &Judged) -> String {
    if let Check::Missing { reason } = &judged.claim.check {
        return escape(reason);
    }
    let evidence = judged.claim.check.evidence();
    let kind = |role: &str| match role {
        "as printed" | "corrected" | "neighbour" => evidence.first(),
        "witness" | "neighbour by the witness" | "as printed by the witness" => evidence.last(),
        _ => None,
    };
    let mut parts: Vec<_> = judged
        .findings
        .iter()
        .map(|(role, finding)| {
            let kind = kind(role).map_or_else(String::new, |kind| format!(" ({kind})"));
            let says = if finding.holds { "holds" } else { "fails" };
            format!("{role}{kind} {says}: {}", escape(&finding.how))
        })
        .collect();
    if let Some(reading) = judged.claim.reading {
        parts.insert(0, format!("read as: {}", escape(reading.trim_end_matches('.'))));
    }
    if let Check::Statement { neighbour: Some(words), .. } = &judged.claim.check {
        parts.push(format!("the neighbour: {}", escape(words)));
    }
    parts.join(";<br>")
}
