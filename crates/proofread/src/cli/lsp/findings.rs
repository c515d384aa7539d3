//! Findings as an editor shows them: marks, what is said beside them, and edits.

use super::super::output::printable;
use super::super::text::notes;
use super::checking::CheckedText;
use super::positions::{PositionEncoding, PositionIndex};
use crate::judge::section::ReportSection;
use crate::reader::TextFormat;
use crate::tell::finding::ChainFinding;
use crate::token::Span;
use serde_json::{Value, json};
use std::ops::Range;

/// What an editor understands.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct EditorFeatures {
    pub encoding: PositionEncoding,
    /// Places that belong to a mark.
    pub related: bool,
    /// Edits that are no commands.
    pub literal_actions: bool,
    /// Edits that name the version of the document.
    pub document_changes: bool,
}

impl EditorFeatures {
    /// What an editor says of itself when it starts.
    pub(super) fn from_capabilities(of: &Value) -> Self {
        let text = &of["textDocument"];
        Self {
            encoding: PositionEncoding::first_of(&of["general"]["positionEncodings"]),
            related: text["publishDiagnostics"]["relatedInformation"] == true,
            literal_actions: text["codeAction"]["codeActionLiteralSupport"].is_object(),
            document_changes: of["workspace"]["workspaceEdit"]["documentChanges"] == true,
        }
    }
}

/// How grave the protocol calls a finding: 2 is a warning, 3 information and 4 a hint. Nothing is an error, which is a word
/// for what keeps a text from being read.
fn severity(finding: &ChainFinding) -> u8 {
    match finding.section {
        ReportSection::Numbers | ReportSection::Statistics => 2,
        ReportSection::Units | ReportSection::Bindings | ReportSection::LessCertain => 3,
        ReportSection::Doubts | ReportSection::Agreeing => 4,
    }
}

/// A finding in two lines: what it is with what was printed and recomputed, and both sides.
fn message(finding: &ChainFinding) -> String {
    let said = format!("{}: {}", finding.verdict.description(), printable(&finding.values_in_words()));
    printable(&said) + "\n" + &printable(&format!("{} against {}", finding.left, finding.right))
}

/// The marks of a text.
pub(super) fn diagnostics(checked: &CheckedText, address: &str, features: EditorFeatures) -> Vec<Value> {
    let index = PositionIndex::new(&checked.text, features.encoding);
    checked.findings.iter().map(|finding| diagnostic(finding, &index, address, features)).collect()
}

fn diagnostic(finding: &ChainFinding, index: &PositionIndex<'_>, address: &str, features: EditorFeatures) -> Value {
    let mut out = json!({
        "range": index.range(finding.at),
        "severity": severity(finding),
        "code": finding.verdict.name(),
        "source": "proofread",
        "message": message(finding),
    });
    if features.related {
        let is_right = finding.at == finding.right_span;
        let (other, words) = match is_right {
            true => (finding.left_span, &finding.left),
            false => (finding.right_span, &finding.right),
        };
        out["relatedInformation"] = json!([{
            "location": { "uri": address, "range": index.range(other) },
            "message": format!("the other side: {}", printable(words)),
        }]);
    }
    out
}

/// Whether a stretch and a range of bytes touch.
fn touches(span: Span, range: &Range<usize>) -> bool {
    span.start as usize <= range.end && range.start <= span.end as usize
}

/// What is said of the findings at a byte, with the stretch that it is about; none if there is none.
pub(super) fn hover(checked: &CheckedText, at: usize, features: EditorFeatures) -> Value {
    let here = |of: &&ChainFinding| touches(of.at, &(at..at));
    // On a side, too, but what is marked comes first.
    let beside = |of: &&ChainFinding| touches(of.span, &(at..at));
    let found = checked.findings.iter().find(here).or_else(|| checked.findings.iter().find(beside));
    let Some(finding) = found else { return Value::Null };
    let mut lines = vec![
        format!("{}: {}", finding.verdict.name(), finding.verdict.description()),
        printable(&finding.values_in_words()),
        format!("read as: {}", finding.chain),
    ];
    lines.extend(notes(finding).into_iter().map(|(what, words)| format!("{what}: {words}")));
    let lines: Vec<String> = lines.iter().map(|line| printable(line)).collect();
    let index = PositionIndex::new(&checked.text, features.encoding);
    // Plain, since nothing in it is to be read as mark-up.
    json!({ "contents": { "kind": "plaintext", "value": lines.join("\n") }, "range": index.range(finding.at) })
}

/// The document that an edit belongs to.
pub(super) struct EditedDocument<'d> {
    pub address: &'d str,
    /// Its version, as the editor counts; null if it has none.
    pub version: &'d Value,
    pub format: TextFormat,
}

/// The edits that hints offer for the findings in a range of bytes.
pub(super) fn fixes(
    checked: &CheckedText,
    range: &Range<usize>,
    document: &EditedDocument<'_>,
    features: EditorFeatures,
) -> Vec<Value> {
    if !features.literal_actions {
        return Vec::new();
    }
    let index = PositionIndex::new(&checked.text, features.encoding);
    let near = checked
        .findings
        .iter()
        .filter(|of| touches(of.at, range) || of.hint.as_ref().is_some_and(|hint| touches(hint.at, range)));
    let edits: Vec<_> = near
        .filter_map(|finding| {
            let hint = finding.hint.as_ref()?;
            Some((finding, hint, hint.replacement(&checked.text, document.format)?))
        })
        .collect();
    let is_single = edits.len() == 1;
    let action = |(finding, hint, new): (&ChainFinding, &crate::tell::hint::Hint, String)| {
        let edit = json!([{ "range": index.range(hint.at), "newText": new }]);
        let edit = if features.document_changes {
            let of = json!({ "uri": document.address, "version": document.version });
            json!({ "documentChanges": [{ "textDocument": of, "edits": edit }] })
        } else {
            json!({ "changes": { document.address: edit } })
        };
        json!({
            "title": format!("Write {}", printable(&hint.words)),
            "kind": "quickfix",
            "diagnostics": [diagnostic(finding, &index, document.address, features)],
            "isPreferred": is_single,
            "edit": edit,
        })
    };
    edits.into_iter().map(action).collect()
}
