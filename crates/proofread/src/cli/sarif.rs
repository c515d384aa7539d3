//! Findings for code review: the Static Analysis Results Interchange Format, version 2.1.0 (OASIS).

use super::baseline::fingerprint;
use super::documents::Document;
use super::output::capitalised;
use super::{CheckedDocument, ReportWriter, RunTotals};
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::section::ReportSection;
use crate::tell::finding::ChainFinding;
use crate::tell::finding_group::FindingGroup;
use crate::tell::hint::Hint;
use crate::tell::line_index::LineIndex;
use crate::tell::sarif::{encoded, file_uri, help_uri, location, log, region};
use crate::tell::summary::describe_count;
use serde_json::{Value, json};
use std::collections::HashMap;

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

/// How much a finding weighs in a review.
fn level(finding: &ChainFinding) -> &'static str {
    match (finding.section, finding.verdict) {
        // Nothing is wrong there.
        (ReportSection::Agreeing, _) => "none",
        (ReportSection::Doubts | ReportSection::Units | ReportSection::LessCertain, _) => "note",
        (ReportSection::Numbers, _) if finding.caveat.is_some() => "warning",
        (ReportSection::Bindings, _) | (ReportSection::Numbers, ChainVerdict::LastDigit | ChainVerdict::Truncated) => {
            "warning"
        }
        (ReportSection::Numbers | ReportSection::Statistics, _) => "error",
    }
}

/// Most further places of a result that are named.
const MOST_RELATED: usize = 100;

/// The edit that a hint offers, if it is known to the character.
fn fix(uri: &str, hint: &Hint, document: &Document, lines: &LineIndex<'_>) -> Option<Value> {
    let offered = hint.replacement(&document.text, document.format)?;
    let [start, end] = lines.line_columns(hint.at);
    Some(json!({
        "description": { "text": format!("Write {}.", hint.words) },
        "artifactChanges": [{
            "artifactLocation": { "uri": uri },
            "replacements": [{ "deletedRegion": region(start, end), "insertedContent": { "text": offered } }],
        }],
    }))
}

/// A finding; `occurrence` counts those of its document with this fingerprint, from 1.
fn result(uri: &str, group: &FindingGroup, occurrence: usize, document: &Document, lines: &LineIndex<'_>) -> Value {
    let finding = &group.finding;
    let [start, end] = lines.line_columns(finding.at);
    let mut message = format!("{}: {}.", finding.chain, finding.verdict.description());
    message += &format!(" {}.", capitalised(&finding.values_in_words()));
    if let Some(hint) = &finding.hint {
        message += &format!(" {} would agree.", hint.words);
    }
    if let Some(caveat) = finding.caveat {
        let what = if finding.section == ReportSection::LessCertain { "Less certain" } else { "Note" };
        message += &format!(" {what}: {}.", caveat.reason());
    }
    if let Some(doubt) = finding.doubt {
        message += &format!(" Set aside: {}.", doubt.reason());
    }
    let mut place = location(uri, start, end);
    // A chapter of a book is no file of its own.
    let chapter = document.path.as_ref().and_then(|path| document.name.strip_prefix(&format!("{}/", path.display())));
    if let Some(label) = document.label(start.line).or(chapter.map(str::to_owned)) {
        place["logicalLocations"] = json!([{ "name": label }]);
        message = if label.starts_with("under ") {
            format!("{}: {message}", capitalised(&label))
        } else {
            format!("In {label}: {message}")
        };
    }
    if !group.others.is_empty() {
        message += &format!(" At {} of the same shape, too.", describe_count(group.others.len(), "more place"));
    }
    let level = level(finding);
    let mut out = json!({
        "ruleId": finding.verdict.name(),
        "kind": if level == "none" { "pass" } else { "fail" },
        "level": level,
        "message": { "text": message },
        "locations": [place],
        "partialFingerprints": { "chain/v1": format!("{}: {occurrence}", fingerprint(finding)) },
        "properties": { "printed": finding.printed, "recomputed": finding.recomputed, "factor": finding.factor },
    });
    if let Some(fix) =
        finding.hint.as_ref().filter(|_| document.made.is_none()).and_then(|hint| fix(uri, hint, document, lines))
    {
        out["fixes"] = json!([fix]);
    }
    let related = group.others.iter().map(|of| {
        let [start, end] = lines.line_columns(of.at);
        let mut place = location(uri, start, end);
        if let Some(label) = document.label(start.line) {
            place["logicalLocations"] = json!([{ "name": label }]);
        }
        place["message"] = json!({ "text": format!("{}. {}.", of.chain, capitalised(&of.values_in_words())) });
        place
    });
    let related: Vec<Value> = related.take(MOST_RELATED).collect();
    if !related.is_empty() {
        out["relatedLocations"] = related.into();
    }
    out
}

/// What a reader of a review is told about a verdict.
fn help(verdict: ChainVerdict) -> &'static str {
    match verdict {
        ChainVerdict::Consistent => "The printed digits of one side give the other one to its printed digits.",
        ChainVerdict::Rounded => {
            "The sides agree if the steps between them were rounded, so there is nothing to correct."
        }
        ChainVerdict::Truncated => {
            "The result has the right digits, but was cut off where it should have been rounded. Most authors do so on purpose."
        }
        ChainVerdict::Approximate => "The sides are near each other, and the text says no more than that.",
        ChainVerdict::Doubtful => "The sides agree only if integers were rounded to tens.",
        ChainVerdict::Units => {
            "The numbers agree, but the units do not have the same dimension, or differ by a factor. Check which unit is missing or \
             is one too many."
        }
        ChainVerdict::LastDigit => {
            "The last printed digit differs by one from what the printed digits give. Check the rounding, or whether more digits went \
             in than are printed."
        }
        ChainVerdict::Inconsistent => {
            "The two sides differ under every plausible reading. One of the printed numbers is a misprint, or a step was computed \
             wrongly."
        }
        ChainVerdict::Dimensions => {
            "Neither the numbers nor the dimensions of the two sides agree. A factor with a unit is probably missing."
        }
        ChainVerdict::CannotEvaluate => {
            "A side has a letter without a value, or something that the program does not know."
        }
    }
}

/// What every rule adds to its help.
const ACCEPTING: &str = "A finding that is right as it is can be accepted: `proofread --accept FILE` writes it down, and \
    `--baseline FILE` leaves it out.";

fn rule(verdict: ChainVerdict) -> Value {
    let (name, meaning) = (verdict.name(), verdict.description());
    let mut out = json!({
        "id": name,
        "shortDescription": { "text": meaning },
        "fullDescription": { "text": help(verdict) },
        "help": {
            "text": format!("{} {}", help(verdict), ACCEPTING.replace('`', "")),
            "markdown": format!("**{name}**: {meaning}.\n\n{}\n\n{ACCEPTING}", help(verdict)),
        },
    });
    if let Some(address) = help_uri() {
        out["helpUri"] = address.into();
    }
    out
}

impl ReportWriter for SarifWriter {
    fn document(&mut self, checked: &CheckedDocument<'_>) -> String {
        let text = &checked.document.text;
        let lines = LineIndex::new(text);
        let uri = if checked.findings.is_empty() { String::new() } else { uri(checked.document) };
        let mut occurrences: HashMap<String, usize> = HashMap::new();
        let results = checked.findings.iter().map(|group| {
            let occurrence = occurrences.entry(fingerprint(&group.finding)).or_default();
            *occurrence += 1;
            result(&uri, group, *occurrence, checked.document, &lines)
        });
        self.results.extend(results);
        String::new()
    }

    fn end(&mut self, _sum: &RunTotals) -> String {
        let rules = ChainVerdict::ALL.map(rule);
        log("proofread", &rules, std::mem::take(&mut self.results))
    }
}
