//! Findings for people.

use super::baseline::IdleCases;
use super::output::{TextLayout, bold_style, printable};
use super::project::UncheckedParts;
use super::{CheckedDocument, ReportWriter, RunTotals};
use crate::judge::section::ReportSection;
use crate::tell::finding::ChainFinding;
use crate::tell::finding_group::FindingGroup;
use crate::tell::line_index::{LineColumn, LineIndex};
use crate::tell::summary::{self, describe_count};
use crate::tell::unchecked_chain::UncheckedChain;
use clap::builder::styling::AnsiColor;
use geneva_host::layout::{columns, first_columns};
use geneva_host::printable::{escape_and_shorten, escaped, shown_path};
use std::ops::Range;

/// Least of a text's line that is shown around a place, in characters.
const LEAST_SHOWN: usize = 20;

/// Findings laid out for a terminal, or for a pipe.
pub(crate) struct TextWriter(pub TextLayout);

impl ReportWriter for TextWriter {
    fn document(&mut self, checked: &CheckedDocument<'_>) -> String {
        let unchecked = checked.unchecked.as_deref().unwrap_or_default();
        if checked.findings.is_empty() && unchecked.is_empty() {
            return String::new();
        }
        let lines = LineIndex::new(&checked.document.text);
        let findings = checked.findings.iter().map(|group| finding_text(group, &lines, checked, self.0));
        findings.chain(unchecked.iter().map(|chain| unchecked_text(chain, &lines, checked, self.0))).collect()
    }

    fn end(&mut self, sum: &RunTotals) -> String {
        let [checked, left] = [checked_sentences(sum, true), left_out_sentences(sum, true)];
        let mut text = checked.into_iter().map(|said| said + "\n").collect::<String>();
        let green = AnsiColor::Green.on_default().bold();
        let red = AnsiColor::Red.on_default().bold();
        match findings_sentence(sum).as_deref().map(|said| said.split_once(':')) {
            Some(Some((number, lists))) => text += &format!("{red}{number}{red:#}:{lists}\n"),
            _ => text += &format!("{green}Nothing found.{green:#}\n"),
        }
        text.extend(left.into_iter().chain(sum.ways_out.clone()).map(|said| said + "\n"));
        self.0.folded(&text)
    }
}

/// How many findings there are and on which lists; none if there are none.
pub(super) fn findings_sentence(sum: &RunTotals) -> Option<String> {
    Some(summary::describe_findings(|list| sum.found.on(list), sum.found.differing_places())? + ".")
}

/// All that is said of a run beside [`findings_sentence`], to somebody who did not start it and has no options to set.
pub(super) fn summary_sentences(sum: &RunTotals) -> Vec<String> {
    [checked_sentences(sum, false), left_out_sentences(sum, false)].concat()
}

/// What was checked, and what was not and why; `with_options` names the options that tell more.
fn checked_sentences(sum: &RunTotals, with_options: bool) -> Vec<String> {
    let tally = &sum.tally;
    let mut said = vec![format!(
        "Checked {} of {} that arithmetic can check, in {} and {}.",
        describe_count(tally.checked, "chain"),
        describe_count(tally.checkable, "chain"),
        describe_count(tally.formulas, "formula or line").replace("formula or lines", "formulas or lines"),
        describe_count(sum.documents, "document"),
    )];
    said.extend(summary::describe_statistics(tally));
    let hint = if sum.unchecked_listed || !with_options { "" } else { " --unchecked lists them." };
    said.extend(summary::describe_unchecked_chains(&sum.not_checked).map(|said| said + hint));
    said.extend(summary::describe_partly_checked_chains(tally));
    said.extend(summary::describe_unread_formulas(tally));
    said.extend(summary::describe_unread_parts(&sum.not_read));
    said.extend(unchecked_parts_sentence(&sum.unchecked_parts));
    said
}

/// The files that were read for their macros alone, and how to have them checked.
fn unchecked_parts_sentence(of: &[UncheckedParts]) -> Option<String> {
    let count = of.iter().map(|of| of.count).sum();
    let who = match of {
        [] => return None,
        [one] => format!("{} includes", shown_path(&one.file)),
        some => format!("{} include", describe_count(some.len(), "document")),
    };
    let (were, them) = if count == 1 { ("was only read for its", "it") } else { ("were only read for their", "them") };
    let files = describe_count(count, "file");
    Some(format!("{who} {files} that {were} macros; give {them}, or the folder, to check {them} too."))
}

/// What was found and is not listed.
fn left_out_sentences(sum: &RunTotals, with_options: bool) -> Vec<String> {
    let units = summary::describe_unit_differences(&sum.tally).filter(|_| !sum.units_listed);
    let doubts = summary::describe_doubts(&sum.tally).filter(|_| !sum.doubts_listed);
    let less_certain = summary::describe_less_certain(sum.less_certain).filter(|_| !sum.less_certain_listed);
    let accepted =
        (sum.accepted > 0).then(|| format!("{} left out as accepted.", describe_count(sum.accepted, "case")));
    let end = |option: &str| if with_options { format!("; {option} lists them.") } else { ".".to_owned() };
    let units = units.map(|said| said + &end("--units"));
    let doubts = doubts.map(|said| said + &end("--doubts"));
    let less_certain = less_certain.map(|said| said + &end("--less-certain"));
    let idle = idle_case_sentences(&sum.idle_cases);
    [less_certain, units, doubts, accepted].into_iter().flatten().chain(idle).collect()
}

/// Most files that a sentence names.
const MOST_NAMED: usize = 3;

/// Files by their names, and how many others there are.
fn in_short(files: &[String]) -> String {
    let (named, others) = files.split_at(files.len().min(MOST_NAMED));
    let mut words: Vec<String> = named.iter().map(|file| escape_and_shorten(file)).collect();
    words.extend((!others.is_empty()).then(|| format!("{} more", others.len())));
    words.join(", ")
}

/// The accepted cases that left nothing out, and why.
fn idle_case_sentences(of: &IdleCases) -> impl Iterator<Item = String> {
    let is = if of.gone == 1 { "is" } else { "are" };
    let gone = (of.gone > 0).then(|| format!("{} {is} not found any more.", describe_count(of.gone, "accepted case")));
    let unread = (of.unread > 0).then(|| {
        let belongs = if of.unread == 1 { "belongs" } else { "belong" };
        let files = if of.unread_files.len() == 1 { "a file" } else { "files" };
        let was = if of.unread_files.len() == 1 { "was" } else { "were" };
        format!(
            "{} {belongs} to {files} that {was} not read: {}.",
            describe_count(of.unread, "accepted case"),
            in_short(&of.unread_files)
        )
    });
    [gone, unread].into_iter().flatten()
}

/// A chain that was not checked, with its place and the reason.
fn unchecked_text(
    chain: &UncheckedChain,
    lines: &LineIndex<'_>,
    checked: &CheckedDocument<'_>,
    layout: TextLayout,
) -> String {
    let (bold, blue) = (bold_style(), AnsiColor::Blue.on_default().bold());
    let [from, _] = lines.line_columns(chain.span);
    let what = if chain.partly { "checked in part" } else { "not checked" };
    let name = escaped(&checked.document.name);
    let head = format!("{what}: {bold}{}{bold:#}\n", printable(&chain.reason()));
    let place = place(checked, from);
    let place = format!(" {blue}-->{blue:#} {name}{place}\n");
    let lead = format!("  {blue}={blue:#} ");
    layout.folded(&head) + &layout.folded(&place) + &layout.wrapped(&lead, &printable(&chain.chain)) + "\n"
}

/// A place behind the name of its document: its line and column, or what the line is called.
fn place(checked: &CheckedDocument<'_>, from: LineColumn) -> String {
    match checked.document.label(from.line) {
        Some(label) => format!(", {}", escaped(&label)),
        None => format!(":{}:{}", from.line, from.column),
    }
}

fn finding_text(
    group: &FindingGroup,
    lines: &LineIndex<'_>,
    checked: &CheckedDocument<'_>,
    layout: TextLayout,
) -> String {
    let finding = &group.finding;
    let (bold, blue) = (bold_style(), AnsiColor::Blue.on_default().bold());
    let colour = if matches!(finding.section, ReportSection::Numbers | ReportSection::Statistics) {
        AnsiColor::Red
    } else {
        AnsiColor::Yellow
    }
    .on_default()
    .bold();
    let [from, _] = lines.line_columns(finding.at);
    let name = escaped(&checked.document.name);
    // The lines of a text that was made out of another format have no numbers that a person could look up.
    let number = match checked.document.label(from.line) {
        Some(_) => String::new(),
        None => from.line.to_string(),
    };
    let gutter = " ".repeat(number.len().max(1));
    let mut text =
        format!("{colour}{}{colour:#}{bold}: {}{bold:#}\n", finding.verdict.name(), finding.verdict.description());
    let place = place(checked, from);
    text += &layout.folded(&format!("{gutter}{blue}-->{blue:#} {name}{place}\n"));
    // Beside the number of the line, and with a sign at either end that says that the line goes on.
    let width = layout.width().saturating_sub(gutter.len() + 5).max(LEAST_SHOWN);
    let said = printable(&finding.values_in_words());
    let is_markup = checked.document.is_markup();
    let start = lines.line_start(from.line);
    let in_line = finding.at.start as usize - start..finding.at.end as usize - start;
    let shown = if is_markup {
        window(&finding.chain, finding.marked.clone(), width)
    } else {
        window(lines.line(from.line), in_line, width)
    };
    let (line, before, marked) = shown;
    // From characters to columns.
    let up_to = |characters: usize| columns(&printable(&line.chars().take(characters).collect::<String>()));
    let (before, marked) = (up_to(before), up_to(before + marked) - up_to(before));
    let line = first_columns(&line, width + 2);
    let (before, marked) = (before.min(width), marked.min((width + 2).saturating_sub(before)));
    let number = if is_markup || number.is_empty() { gutter.clone() } else { number };
    text += &format!("{blue}{gutter} |{blue:#}\n{blue}{number} |{blue:#} {}\n", printable(line));
    let marks = "^".repeat(marked.max(1));
    let under = |indent: usize| format!("{blue}{gutter} |{blue:#} {}", " ".repeat(indent));
    let beside = format!("{}{colour}{marks} {said}{colour:#}", under(before));
    if columns(&beside) <= layout.width() {
        text += &format!("{beside}\n");
    } else {
        // Words that don't fit beside the marks stand under them, as far to the left as they need.
        let room = layout.width().saturating_sub(columns(&under(0)));
        text += &format!("{}{colour}{marks}{colour:#}\n", under(before));
        text += &match room.checked_sub(columns(&said)) {
            Some(free) => format!("{}{colour}{said}{colour:#}\n", under(before.min(free))),
            None => layout.wrapped(&under(0), &format!("{colour}{said}{colour:#}")),
        };
    }
    let mut note = |what: &str, words: &str| {
        let lead = format!("{gutter} {blue}={blue:#} ");
        text += &layout.wrapped(&lead, &format!("{bold}{what}{bold:#}: {}", printable(words)));
    };
    if !is_markup {
        note("read as", &finding.chain);
    }
    for (what, mut words) in notes(finding) {
        if what == NOTE && checked.apart > 0 {
            words += "; --less-certain lists the others";
        }
        note(what, &words);
    }
    if let Some(places) = other_places(group, lines, checked) {
        note("also", &places);
    }
    text.push('\n');
    text
}

/// What is said before a caveat about a finding that is listed all the same.
const NOTE: &str = "note";

/// What else is to be said of a finding, each with the words before it.
pub(super) fn notes(finding: &ChainFinding) -> Vec<(&'static str, String)> {
    let mut notes = Vec::new();
    if let Some(doubt) = finding.doubt {
        notes.push(("set aside", doubt.reason().to_owned()));
    }
    if let Some(caveat) = finding.caveat {
        let what = if finding.section == ReportSection::LessCertain { "less certain" } else { NOTE };
        notes.push((what, caveat.reason()));
    }
    if let Some(why) = &finding.why {
        notes.push(("why", why.clone()));
    }
    if let Some(hint) = &finding.hint {
        notes.push(("hint", format!("{} would agree", hint.words)));
    }
    if !finding.reading.is_empty() {
        notes.push(("nearest reading", finding.reading.join(", ")));
    }
    if !finding.names.is_empty() {
        notes.push(("with values from elsewhere", finding.names.join(", ")));
    }
    notes
}

/// Most places of one shape that are named.
const MOST_PLACES: usize = 8;

/// Where else a finding is, in words; none if it is at one place alone.
pub(super) fn other_places(
    group: &FindingGroup,
    lines: &LineIndex<'_>,
    checked: &CheckedDocument<'_>,
) -> Option<String> {
    let of = |finding: &ChainFinding| {
        let line = lines.line_columns(finding.at)[0].line;
        checked.document.label(line).map_or_else(|| line.to_string(), |label| escaped(&label).into_owned())
    };
    let (named, others) = group.others.split_at(group.others.len().min(MOST_PLACES));
    let count = describe_count(group.others.len(), "more place");
    let mut places: Vec<String> = named.iter().map(of).collect();
    places.dedup();
    // The lines of a document of an office program have names.
    let is_numbered = places.first()?.bytes().all(|byte| byte.is_ascii_digit());
    let line = match (is_numbered, places.len()) {
        (false, _) => "",
        (true, 1) if others.is_empty() => "line ",
        (true, _) => "lines ",
    };
    places.extend((!others.is_empty()).then(|| "…".to_owned()));
    let between = if is_numbered { ", " } else { "; " };
    Some(format!("at {count} of the same shape: {line}{}", places.join(between)))
}

/// A part of a line around a place in it, how many characters are before the place, and how many it takes. A line may be as long
/// as the text, so only what is near is looked at.
fn window(line: &str, place: Range<usize>, width: usize) -> (String, usize, usize) {
    let boundary = |at: usize| (0..=at.min(line.len())).rfind(|at| line.is_char_boundary(*at)).unwrap_or(0);
    let start = boundary(place.start);
    let end = boundary(place.end).max(start);
    let is_short = line.chars().nth(width).is_none();
    let indent = || line.len() - line.trim_start().len();
    let from = match line[..start].char_indices().rev().nth(width * 2 / 3 - 1) {
        _ if is_short => indent().min(start),
        Some((from, _)) => from,
        None => 0,
    };
    let to = if is_short { None } else { line[from..].char_indices().nth(width) };
    let to = to.map_or(line.len(), |(length, _)| from + length);
    let mut text = line[from..to].to_owned();
    let mut before = line[from..start.min(to)].chars().count();
    // What is left out at the start may be space alone.
    if !is_short && !line[..from].trim_end().is_empty() {
        text.insert(0, '…');
        before += 1;
    }
    if to < line.len() {
        text.push('…');
    }
    (text, before, line[start.min(to)..end.min(to)].chars().count())
}
