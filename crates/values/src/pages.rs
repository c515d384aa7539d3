//! What a check found, as pages of a book in Markdown: where each number comes from, and which are wrong or open.

use crate::check::{NumberFinding, NumbersReport, with_unit};
use crate::report::{count, summary};
use geneva_evidence::PlainVerdict;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// How a text is named in the pages, and its address in the book if it has one.
pub type TextLink<'l> = dyn Fn(&Path) -> (String, Option<String>) + 'l;

/// What a number is tied to, in the columns of the coverage, with the column's head.
const TIES: [(&str, &str); 5] =
    [("value", "computed"), ("given", "given"), ("date", "dates"), ("reference", "references"), ("quoted", "quoted")];

/// A page on where each number comes from. `link` names a text, and gives its address in the book.
///
/// ```
/// use geneva_values::{NumbersReport, coverage_page};
///
/// let page = coverage_page(&NumbersReport::default(), &|_| (String::new(), None));
/// assert!(page.starts_with("0 numbers in 0 texts."));
/// ```
pub fn coverage_page(report: &NumbersReport, link: &TextLink<'_>) -> String {
    let mut out = format!("{}\n\n", summary(report));
    let texts = by_text(report);
    let heads = TIES.map(|(_, head)| format!(" {head} |")).concat();
    let _ = writeln!(out, "| text | numbers |{heads} right | wrong | open |");
    let _ = writeln!(out, "|:--|--:|{}--:|--:|--:|", "--:|".repeat(TIES.len()));
    for (text, numbers) in &texts {
        let ties =
            TIES.map(|(tie, _)| format!(" {} |", numbers.iter().filter(|of| tie_of(of) == tie).count())).concat();
        let verdicts = [PlainVerdict::Right, PlainVerdict::Wrong, PlainVerdict::Open];
        let verdicts = verdicts.map(|of| format!(" {} |", numbers.iter().filter(|it| it.kind.verdict() == of).count()));
        let _ = writeln!(out, "| {} | {} |{ties}{}", place(text, link), numbers.len(), verdicts.concat());
    }
    if !report.unused.is_empty() {
        let keys: Vec<String> = report.unused.iter().map(|key| format!("`{}`", key.replace('`', "'"))).collect();
        let values = count(keys.len(), "value");
        let _ = writeln!(out, "\n{values} that no number prints: {}.", keys.join(", "));
    }
    for (text, numbers) in &texts {
        let shown = cell(link(text).0);
        let _ = writeln!(out, "\n<details>\n<summary>Each number of {shown}</summary>\n");
        let _ = writeln!(out, "| after the words | printed | from | computed | verdict |\n|:--|--:|:--|--:|:--|");
        for number in numbers {
            let from = match (&number.key, &number.none) {
                (Some(key), _) => format!("`{}`", key.replace(['`', '|'], "'")),
                (None, Some(none)) => cell(none),
                (None, None) => String::new(),
            };
            let computed = [number.value.as_deref(), number.second.as_deref()].into_iter().flatten();
            let computed = cell(computed.collect::<Vec<_>>().join(" and "));
            let row =
                [cell(&number.before), cell(printed(number)), from, computed, number.kind.verdict().words().to_owned()];
            let _ = writeln!(out, "| {} |", row.join(" | "));
        }
        out += "\n</details>\n";
    }
    out
}

/// A page on the numbers that are wrong, with what to write in their place, and on those that are open.
///
/// ```
/// use geneva_values::{NumbersReport, errata_page};
///
/// assert_eq!(errata_page(&NumbersReport::default(), &|_| (String::new(), None)), "No number is wrong, and none is open.\n");
/// ```
pub fn errata_page(report: &NumbersReport, link: &TextLink<'_>) -> String {
    let of = |verdict| report.findings.iter().filter(move |finding| finding.kind.verdict() == verdict);
    let mut out = String::new();
    if of(PlainVerdict::Wrong).next().is_some() {
        let wrong = with_verb(of(PlainVerdict::Wrong).count());
        let _ = writeln!(out, "{wrong} wrong: what was computed or recorded is something else.\n");
        let _ =
            writeln!(out, "| where | after the words | printed | computed | to be written |\n|:--|:--|--:|--:|--:|");
        for number in of(PlainVerdict::Wrong) {
            let computed = number.value.as_deref().unwrap_or_default();
            let write = number.write.as_ref().map(|write| with_unit(write, &number.unit)).unwrap_or_default();
            let row = [&number.before, &printed(number), computed, &write].map(cell).join(" | ");
            let _ = writeln!(out, "| {} | {row} |", line_of(number, link));
        }
    }
    if of(PlainVerdict::Open).next().is_some() {
        let _ = writeln!(out, "\n{} open.\n", with_verb(of(PlainVerdict::Open).count()));
        let _ = writeln!(out, "| where | after the words | why |\n|:--|:--|:--|");
        for number in of(PlainVerdict::Open) {
            let row = [&*number.before, &number.message].map(cell).join(" | ");
            let _ = writeln!(out, "| {} | {row} |", line_of(number, link));
        }
    }
    if out.is_empty() { "No number is wrong, and none is open.\n".to_owned() } else { out.trim_start().to_owned() }
}

fn with_verb(number: usize) -> String {
    format!("{} {}", count(number, "number"), if number == 1 { "is" } else { "are" })
}

/// The findings of each text.
fn by_text(report: &NumbersReport) -> BTreeMap<&Path, Vec<&NumberFinding>> {
    let mut texts: BTreeMap<&Path, Vec<&NumberFinding>> = BTreeMap::new();
    for finding in &report.findings {
        texts.entry(&finding.text).or_default().push(finding);
    }
    texts
}

/// What a number is tied to, in one word; none if nobody has decided.
fn tie_of(number: &NumberFinding) -> &str {
    match (&number.key, &number.none) {
        (Some(_), _) => "value",
        (None, Some(none)) => none.split(' ').next().unwrap_or_default(),
        (None, None) => "",
    }
}

fn printed(number: &NumberFinding) -> String {
    with_unit(&number.printed, &number.unit)
}

fn place(text: &Path, link: &TextLink<'_>) -> String {
    let (name, address) = link(text);
    let shown = cell(name);
    address.map_or_else(|| shown.clone(), |address| format!("[{shown}](<{address}>)"))
}

fn line_of(number: &NumberFinding, link: &TextLink<'_>) -> String {
    let place = place(&number.text, link);
    number.at.map_or_else(|| place.clone(), |[start, _]| format!("{place}, line {}", start.line))
}

/// Characters in a cell of a table in Markdown, where none of them is mark-up.
fn cell(text: impl AsRef<str>) -> String {
    let mut out = String::new();
    for c in text.as_ref().chars() {
        match c {
            '\n' | '\r' | '\t' => out.push(' '),
            '{' | '}' => {
                let _ = write!(out, "&#{};", u32::from(c));
            }
            c if c.is_ascii_punctuation() && !matches!(c, '.' | ',' | '/' | '-' | ':' | '%' | '#' | '(' | ')') => {
                out.extend(['\\', c])
            }
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::FindingKind;

    fn number(kind: FindingKind) -> NumberFinding {
        NumberFinding {
            kind,
            text: "src/a|b.md".into(),
            at: None,
            before: "it *is* {{this}}".to_owned(),
            printed: "2.5".to_owned(),
            unit: "mm".to_owned(),
            key: Some("width".to_owned()),
            none: None,
            value: Some("2.61 mm".to_owned()),
            second: None,
            write: Some("2.6".to_owned()),
            message: "printed 2.5 mm".to_owned(),
            neighbours_passed: 0,
        }
    }

    #[test]
    fn nothing_in_a_text_is_mark_up_in_the_pages() {
        let findings = vec![number(FindingKind::Stale), number(FindingKind::Untied)];
        let report = NumbersReport { findings, texts: 1, ..NumbersReport::default() };
        let link = |_: &Path| ("a|b".to_owned(), Some("a.html".to_owned()));
        for page in [errata_page(&report, &link), coverage_page(&report, &link)] {
            assert!(!page.contains("{{") && !page.contains("*is*") && !page.contains("a|b"), "{page}");
        }
        let errata = errata_page(&report, &link);
        assert!(errata.contains("| 2.5 mm | 2.61 mm | 2.6 mm |"), "{errata}");
        assert!(errata.contains("1 number is open."), "{errata}");
    }
}
