//! What a check or a record says: for people, and as JSON.

use crate::check::{FindingKind, NumberFinding, NumbersReport};
use crate::recording::RecordReport;
use geneva_fields::joined_with_and;
use geneva_host::layout::TextLayout;
use geneva_host::printable::{escaped, shown_path};
use proofread::reader::LeftOut;
use serde_json::{Value, json};

/// Most names of values that are listed for people.
const MOST_LISTED: usize = 12;

/// A count with its noun.
pub(crate) fn count(number: usize, noun: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {noun}{plural}")
}

/// A line with nothing in it that a terminal obeys.
fn line(text: &str) -> String {
    format!("{}\n", escaped(text))
}

/// A path with the line and the column, which editors open.
fn locator(finding: &NumberFinding) -> String {
    let path = shown_path(&finding.text);
    finding.at.map_or_else(|| path.clone(), |[start, _]| format!("{path}:{}:{}", start.line, start.column))
}

/// What a check found, for people: what differs, and a summary.
pub fn check_text(report: &NumbersReport, layout: TextLayout) -> String {
    let mut out = String::new();
    for finding in report.findings.iter().filter(|finding| !finding.kind.is_right()) {
        out += &line(&format!("{}: {}: {}", locator(finding), finding.kind.name(), finding.message));
    }
    for finding in report.findings.iter().filter(|finding| finding.neighbours_passed > 0) {
        let message = format!(
            "{} is right, but so would be its neighbour: the value is half way between; print one more digit",
            finding.printed
        );
        out += &line(&format!("{}: note: {message}", locator(finding)));
    }
    if !report.unused.is_empty() {
        let (shown, more) = report.unused.split_at(report.unused.len().min(MOST_LISTED));
        let more = if more.is_empty() { String::new() } else { format!(" and {} more", more.len()) };
        out += &line(&format!("note: no number is tied to the values {}{more}", shown.join(", ")));
    }
    layout.folded(&(out + &line(&summary(report))))
}

/// The summary in one sentence or two.
pub(crate) fn summary(report: &NumbersReport) -> String {
    let counts = FindingKind::ALL.into_iter().map(|(kind, name, _)| (report.count(kind), name));
    let counts: Vec<String> = counts
        .filter(|(count, _)| *count > 0)
        .map(|(count, name)| format!("{count} {}", name.replace('-', " ")))
        .collect();
    let counts = if counts.is_empty() { String::new() } else { format!(": {}", counts.join(", ")) };
    let numbers = report.findings.iter().filter(|finding| finding.at.is_some()).count();
    let mut out = format!("{} in {}{counts}.", count(numbers, "number"), count(report.texts, "text"));
    let (tried, refused) = neighbours(report);
    if tried > 0 {
        out += &format!(" Each check refused its neighbours: {refused} of {tried}.");
    }
    let left_out: Vec<String> = LeftOut::ALL
        .iter()
        .filter_map(|(name, kind)| report.left_out.get(kind).map(|count| (name, *count)))
        .map(|(name, count)| format!("{count} {}", if count == 1 { LeftOut::singular(name) } else { name }))
        .collect();
    if !left_out.is_empty() {
        out += &format!(" Not read: {} with digits.", joined_with_and(&left_out));
    }
    out
}

/// How many right numbers had their neighbours tried, and for how many both were refused.
fn neighbours(report: &NumbersReport) -> (usize, usize) {
    let tried = report.findings.iter().filter(|finding| finding.kind == FindingKind::Right);
    let refused = tried.clone().filter(|finding| finding.neighbours_passed == 0).count();
    (tried.count(), refused)
}

/// What a check found, as JSON: all numbers, and the counts.
pub fn check_json(report: &NumbersReport) -> String {
    let finding = |finding: &NumberFinding| {
        let place = |which: usize| finding.at.map(|at| at[which]);
        json!({
            "text": finding.text.to_string_lossy(),
            "line": place(0).map(|at| at.line),
            "column": place(0).map(|at| at.column),
            "end_line": place(1).map(|at| at.line),
            "end_column": place(1).map(|at| at.column),
            "kind": finding.kind.name(),
            "verdict": finding.kind.verdict().words(),
            "before": finding.before,
            "printed": finding.printed,
            "unit": finding.unit,
            "key": finding.key,
            "no_value": finding.none,
            "value": finding.value,
            "second_value": finding.second,
            "write": finding.write,
            "message": finding.message,
            "neighbours_refused": (finding.kind == FindingKind::Right).then_some(finding.neighbours_passed == 0),
        })
    };
    let counts: serde_json::Map<String, Value> =
        FindingKind::ALL.into_iter().map(|(kind, name, _)| (name.to_owned(), json!(report.count(kind)))).collect();
    let left_out: serde_json::Map<String, Value> = LeftOut::ALL
        .iter()
        .map(|(name, kind)| (name.replace(' ', "_"), json!(report.left_out.get(kind).copied().unwrap_or(0))))
        .collect();
    let (tried, refused) = neighbours(report);
    let page = json!({
        "numbers": report.findings.iter().map(finding).collect::<Vec<_>>(),
        "summary": {
            "right": report.is_right(),
            "texts": report.texts,
            "counts": counts,
            "second_values": report.has_second,
            "neighbours_tried": tried,
            "neighbours_refused": refused,
            "not_read": left_out,
            "unused_values": report.unused,
        },
    });
    format!("{page:#}\n")
}

/// What was recorded, for people.
pub fn record_text(report: &RecordReport, layout: TextLayout) -> String {
    let path = shown_path(&report.path);
    let mut out = String::new();
    for missing in &report.missing {
        let what = if report.is_pruned { "taken out" } else { "kept, though its number is no longer in the text" };
        out += &line(&format!("note: {what}: {missing}"));
    }
    if !report.missing.is_empty() && !report.is_pruned {
        out += &line("note: `geneva record --prune` takes out entries whose numbers are gone");
    }
    let ties: Vec<String> = report.ties.iter().map(|(name, count)| format!("{count} {name}")).collect();
    let ties = if ties.is_empty() { String::new() } else { format!(" Tied to: {}.", ties.join(", ")) };
    let undecided = ["open", "candidates"].iter().filter_map(|name| report.ties.get(*name)).sum::<usize>();
    let next = match undecided {
        0 => String::new(),
        1 => " One entry is for you to decide.".to_owned(),
        many => format!(" {many} entries are for you to decide."),
    };
    let by_chance = match (report.by_chance + 0.5) as usize {
        0 => String::new(),
        some => format!(
            " Of numbers like these, about {some} would have a value by chance: look at the ties that are marked."
        ),
    };
    let done = match (report.is_changed, report.added, report.moved) {
        (false, ..) => format!("{path} is up to date: {}.", count(report.numbers, "number")),
        (true, added, moved) => {
            let new = if added == 1 { "1 new entry".to_owned() } else { format!("{added} new entries") };
            format!("{path}: {}, {new}, {moved} described anew.", count(report.numbers, "number"))
        }
    };
    layout.folded(&(out + &line(&format!("{done}{ties}{by_chance}{next}"))))
}
