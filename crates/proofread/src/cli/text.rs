//! Findings for people.

use super::output::{bold, printable};
use super::{Checked, Sum, Writer};
use crate::finding::{Finding, List};
use crate::place::Lines;
use crate::reader::Format;
use crate::summary::{self, count};
use clap::builder::styling::AnsiColor;
use geneva_host::printable::escaped;
use std::ops::Range;

/// Longest line of the text that is shown around a place, in characters.
const WIDTH: usize = 100;

pub(crate) struct Text;

impl Writer for Text {
    fn document(&mut self, checked: &Checked<'_>) -> String {
        if checked.findings.is_empty() {
            return String::new();
        }
        let lines = Lines::new(&checked.document.text);
        checked.findings.iter().map(|finding| one(finding, &lines, checked)).collect()
    }

    fn end(&mut self, sum: &Sum) -> String {
        let tally = &sum.tally;
        let mut text = format!(
            "Checked {} of {} that arithmetic can check, in {} and {}.\n",
            count(tally.checked, "chain"),
            count(tally.checkable.max(tally.checked), "chain"),
            count(tally.formulas, "formula or line").replace("formula or lines", "formulas or lines"),
            count(sum.documents, "document"),
        );
        text.extend(summary::others(tally).map(|said| said + "\n"));
        text.extend(summary::unread(tally).map(|said| said + "\n"));
        let green = AnsiColor::Green.on_default().bold();
        let red = AnsiColor::Red.on_default().bold();
        match summary::findings(|list| sum.found[list as usize]).as_deref().map(|said| said.split_once(':')) {
            Some(Some((number, lists))) => text += &format!("{red}{number}{red:#}:{lists}.\n"),
            _ => text += &format!("{green}Nothing found.{green:#}\n"),
        }
        let hidden = summary::units_alone(tally).filter(|_| !sum.units_listed);
        text.extend(hidden.map(|said| format!("{said}; --units lists them.\n")));
        let hidden = summary::doubts(tally).filter(|_| !sum.doubts_listed);
        text.extend(hidden.map(|said| format!("{said}; --doubts lists them.\n")));
        if sum.accepted > 0 {
            text += &format!("{} left out as accepted.\n", count(sum.accepted, "case"));
        }
        text
    }
}

fn one(finding: &Finding, lines: &Lines<'_>, checked: &Checked<'_>) -> String {
    let (bold, blue) = (bold(), AnsiColor::Blue.on_default().bold());
    let colour = if finding.list == List::Numbers { AnsiColor::Red } else { AnsiColor::Yellow }.on_default().bold();
    let [from, _] = lines.places(finding.at);
    let name = escaped(&checked.document.name);
    let gutter = " ".repeat(from.line.to_string().len());
    let mut text = format!("{colour}{}{colour:#}{bold}: {}{bold:#}\n", finding.verdict.name(), finding.verdict.words());
    text += &format!("{gutter}{blue}-->{blue:#} {name}:{}:{}\n", from.line, from.column);
    let said = printed_and_recomputed(finding);
    let is_markup = matches!(checked.document.format, Format::Xml | Format::Html | Format::Notebook);
    let start = lines.start(from.line);
    let in_line = finding.at.start as usize - start..finding.at.end as usize - start;
    let shown =
        if is_markup { window(&finding.chain, finding.marked.clone()) } else { window(lines.line(from.line), in_line) };
    let (line, before, marked) = shown;
    let number = if is_markup { gutter.clone() } else { from.line.to_string() };
    text += &format!("{blue}{gutter} |{blue:#}\n{blue}{number} |{blue:#} {}\n", printable(&line));
    text += &format!(
        "{blue}{gutter} |{blue:#} {}{colour}{} {said}{colour:#}\n",
        " ".repeat(before),
        "^".repeat(marked.max(1))
    );
    let mut note = |what: &str, words: &str| {
        text += &format!("{gutter} {blue}={blue:#} {bold}{what}{bold:#}: {}\n", printable(words))
    };
    if !is_markup {
        note("read as", &finding.chain);
    }
    if let Some(doubt) = finding.doubt {
        note("set aside", doubt.words());
    }
    if let Some(why) = &finding.why {
        note("why", why);
    }
    if let Some(hint) = &finding.hint {
        note("hint", &format!("{} would agree", hint.words));
    }
    if !finding.reading.is_empty() {
        note("nearest reading", &finding.reading.join(", "));
    }
    if !finding.names.is_empty() {
        note("with values from elsewhere", &finding.names.join(", "));
    }
    text.push('\n');
    text
}

/// What was printed and what is computed.
fn printed_and_recomputed(finding: &Finding) -> String {
    let printed = printable(&finding.printed);
    match &finding.recomputed {
        Some(recomputed) if recomputed.contains(" against ") => format!("recomputed {recomputed}"),
        Some(recomputed) => format!("printed {printed}, recomputed {recomputed}"),
        None => format!("printed {printed}"),
    }
}

/// A part of a line around a place in it, how many columns are before the place, and how many it takes. A line may be as long as the
/// text, so only what is near is looked at.
fn window(line: &str, place: Range<usize>) -> (String, usize, usize) {
    let boundary = |at: usize| (0..=at.min(line.len())).rfind(|at| line.is_char_boundary(*at)).unwrap_or(0);
    let start = boundary(place.start);
    let end = boundary(place.end).max(start);
    let is_short = line.chars().nth(WIDTH).is_none();
    let indent = || line.len() - line.trim_start().len();
    let from = match line[..start].char_indices().rev().nth(WIDTH * 2 / 3 - 1) {
        _ if is_short => indent().min(start),
        Some((from, _)) => from,
        None => 0,
    };
    let to = if is_short { None } else { line[from..].char_indices().nth(WIDTH) };
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
