//! What is said at the end of a report, for every program that shows one.

use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::section::ReportSection;
use crate::judge::unchecked::UncheckedKind;
use crate::named_counts::NamedCounts;
use crate::reader::{UnreadKind, UnreadParts};
use crate::tell::number_form::part_thousands;
use crate::tell::tally::CheckTally;

/// "1 chain", "2 chains", "12,345 chains".
///
/// ```
/// use proofread::summary::describe_count;
///
/// assert_eq!([1, 2, 12_345].map(|number| describe_count(number, "chain")), ["1 chain", "2 chains", "12,345 chains"]);
/// ```
pub fn describe_count(number: usize, thing: &str) -> String {
    format!("{} {thing}{}", digits(number), if number == 1 { "" } else { "s" })
}

/// A number with its thousands parted.
pub(crate) fn digits(number: usize) -> String {
    part_thousands(&number.to_string())
}

/// How many findings there are and on which lists, such as `2 findings: 1 on a number, 1 on units alone`; `number_on` tells how
/// many a list has, and `places` at how many places of the texts all of them are. None if there are none.
///
/// ```
/// use proofread::{ReportSection, summary::describe_findings};
///
/// let found = |section| if section == ReportSection::Units { 2 } else { 0 };
/// assert_eq!(describe_findings(found, 2).as_deref(), Some("2 findings: 2 on units alone"));
/// assert_eq!(describe_findings(found, 7).as_deref(), Some("2 findings at 7 places: 2 on units alone"));
/// assert_eq!(describe_findings(|_| 0, 0), None);
/// ```
pub fn describe_findings(number_on: impl Fn(ReportSection) -> usize, places: usize) -> Option<String> {
    const LISTS: [(ReportSection, &str); 6] = [
        (ReportSection::Numbers, "on a number"),
        (ReportSection::Statistics, "on a statistic or a total"),
        (ReportSection::Bindings, "with values from elsewhere in the text"),
        (ReportSection::Units, "on units alone"),
        (ReportSection::Doubts, "in doubt"),
        (ReportSection::LessCertain, "less certain"),
    ];
    let numbers = LISTS.map(|(list, words)| (number_on(list), words));
    let parts: Vec<String> = numbers
        .iter()
        .filter(|(number, _)| *number > 0)
        .map(|(number, words)| format!("{} {words}", digits(*number)))
        .collect();
    let all = numbers.iter().map(|(number, _)| number).sum();
    let at = if places > all { format!(" at {}", describe_count(places, "place")) } else { String::new() };
    (!parts.is_empty()).then(|| format!("{}{at}: {}", describe_count(all, "finding"), parts.join(", ")))
}

/// The statistics and totals that were compared, in a sentence; none if there are none.
///
/// ```
/// use proofread::{CheckTally, StatisticsTally, summary::describe_statistics};
///
/// let statistics = StatisticsTally { tests: 2, totals: 1, ..StatisticsTally::default() };
/// let words = describe_statistics(&CheckTally { statistics, ..CheckTally::default() }).expect("three");
/// assert_eq!(words, "Compared 2 p-values with their tests and 1 total with its parts.");
/// ```
pub fn describe_statistics(tally: &CheckTally) -> Option<String> {
    let of = tally.statistics;
    let kinds = [
        (of.tests, "p-value", "its test", "their tests"),
        (of.intervals, "confidence interval", "its estimate", "their estimates"),
        (of.shares, "share", "its parts", "their parts"),
        (of.totals, "total", "its parts", "their parts"),
    ];
    let compared = kinds.into_iter().filter(|(count, ..)| *count > 0).map(|(count, thing, its, their)| {
        format!("{} with {}", describe_count(count, thing), if count == 1 { its } else { their })
    });
    let compared: Vec<String> = compared.collect();
    let (last, others) = compared.split_last()?;
    let others = others.join(", ");
    Some(if others.is_empty() { format!("Compared {last}.") } else { format!("Compared {others} and {last}.") })
}

/// Most reasons of a kind that a sentence names.
const MOST_NAMED: usize = 8;

/// The chains that were not checked, in a sentence with the reasons; none if there are none.
///
/// ```
/// use proofread::{CheckOptions, TextFormat, proofread, summary::describe_unchecked_chains};
///
/// let text = r"$\foo{7} = 36$, $\foo{3} = 1$, $x + 1 = 2$";
/// let report = proofread(text, TextFormat::Markdown, CheckOptions::default())?;
/// let words = describe_unchecked_chains(&report.not_checked).expect("three chains");
/// assert_eq!(words, "Not checked: 2 chains with `\\foo`, 1 with letters.");
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
pub fn describe_unchecked_chains(counts: &NamedCounts<UncheckedKind>) -> Option<String> {
    let (mut named, mut others) = (Vec::new(), Vec::new());
    for (kind, name, times) in counts.iter() {
        let is_phrase = ["a ", "an ", "two ", "the ", "numbers ", "dots"].iter().any(|start| name.starts_with(start));
        let words = match kind {
            UncheckedKind::Letter => "with letters",
            UncheckedKind::Definition if times == 1 => "that only gives a letter a value",
            UncheckedKind::Definition => "that only give a letter a value",
            UncheckedKind::Word => "with words that are no units",
            UncheckedKind::Denied => "that the text asks about or denies",
            UncheckedKind::Notation if is_phrase => "with ",
            UncheckedKind::Notation => "with this: ",
            UncheckedKind::Command | UncheckedKind::Environment | UncheckedKind::Function => "with `",
            _ => "with a side that is missing or goes on elsewhere",
        };
        match kind {
            UncheckedKind::Notation => named.push((times, [words, name].concat())),
            _ if kind.has_names() => named.push((times, [words, name, "`"].concat())),
            _ => others.push((times, words.to_owned())),
        }
    }
    let mut listed = most_frequent(named, MOST_NAMED, "with other things that are not known");
    listed.append(&mut others);
    let first = listed.first()?.0;
    let chains = if first == 1 { " chain " } else { " chains " };
    Some(["Not checked: ", &in_list(&listed).replacen(' ', chains, 1), "."].concat())
}

/// The most frequent of some things, with one more for all others.
fn most_frequent(mut things: Vec<(usize, String)>, most: usize, others: &str) -> Vec<(usize, String)> {
    for end in 1..things.len() {
        let mut at = end;
        while at > 0 && things[at - 1].0 < things[at].0 {
            things.swap(at - 1, at);
            at -= 1;
        }
    }
    if things.len() > most {
        let rest = things.drain(most..).map(|(times, _)| times).sum();
        things.push((rest, others.to_owned()));
    }
    things
}

/// Things with how many there are of each.
fn in_list(things: &[(usize, String)]) -> String {
    let mut text = String::new();
    for (times, words) in things {
        text += if text.is_empty() { "" } else { ", " };
        text += &digits(*times);
        text += " ";
        text += words;
    }
    text
}

/// The chains that were checked in part, in a sentence; none if there are none.
///
/// ```
/// use proofread::{CheckTally, summary::describe_partly_checked_chains};
///
/// let words = describe_partly_checked_chains(&CheckTally { partly: 2, ..CheckTally::default() });
/// assert_eq!(words.as_deref(), Some("2 chains were checked in part."));
/// ```
pub fn describe_partly_checked_chains(tally: &CheckTally) -> Option<String> {
    let verb = if tally.partly == 1 { "was" } else { "were" };
    (tally.partly > 0).then(|| format!("{} {verb} checked in part.", describe_count(tally.partly, "chain")))
}

/// The parts and files that were not read, in a sentence; none if there are none.
///
/// ```
/// use proofread::{CheckOptions, TextFormat, proofread, summary::describe_unread_parts};
///
/// let text = "~~~python\nx = 2 + 3\n~~~\n\n<!-- 2 + 2 = 5 -->\n";
/// let report = proofread(text, TextFormat::Markdown, CheckOptions::default())?;
/// let words = describe_unread_parts(&report.not_read).expect("two parts");
/// assert_eq!(words, "Not read, with an equals sign and a digit: 1 fence of `python`, 1 comment.");
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
pub fn describe_unread_parts(parts: &UnreadParts) -> Option<String> {
    let (mut whole, mut some) = (Vec::new(), Vec::new());
    for (kind, name, times) in parts.iter() {
        let (one, many) = match kind {
            UnreadKind::Fence if name.is_empty() => ("fence without a language", "fences without a language"),
            UnreadKind::Fence => ("fence of", "fences of"),
            UnreadKind::Indented => ("block of indented code", "blocks of indented code"),
            UnreadKind::Code => ("piece of code in a line", "pieces of code in a line"),
            UnreadKind::Cell => ("cell that is no text", "cells that are no text"),
            UnreadKind::Environment => ("environment", "environments"),
            UnreadKind::Element => ("element", "elements"),
            UnreadKind::Comment => ("comment", "comments"),
            UnreadKind::File => ("file of", "files of"),
            UnreadKind::Binary => ("file with zero bytes", "files with zero bytes"),
            UnreadKind::Folder => ("folder of output", "folders of output"),
            UnreadKind::Link => ("symbolic link", "symbolic links"),
            UnreadKind::Object => ("object of", "objects of"),
        };
        let mut words = (if times == 1 { one } else { many }).to_owned();
        if !name.is_empty() {
            words += &[" `", name, "`"].concat();
        }
        (if kind.is_whole() { &mut whole } else { &mut some }).push((times, words));
    }
    let [whole, some] = [whole, some].map(|of| in_list(&most_frequent(of, 2 * MOST_NAMED, "others")));
    match (whole.is_empty(), some.is_empty()) {
        (true, true) => None,
        (false, true) => Some(["Not read: ", &whole, "."].concat()),
        (true, false) => Some(["Not read, ", WITH_SIGN, &some, "."].concat()),
        (false, false) => Some(["Not read: ", &whole, "; and, ", WITH_SIGN, &some, "."].concat()),
    }
}

/// What is said before the parts of a text that were not read.
const WITH_SIGN: &str = "with an equals sign and a digit: ";

/// The formulas that are not read to their end, in a sentence; none if there are none.
///
/// ```
/// use proofread::{CheckTally, summary::describe_unread_formulas};
///
/// let words = describe_unread_formulas(&CheckTally { unread: 1, ..CheckTally::default() }).expect("one formula");
/// assert!(words.starts_with("1 formula or line was not read to its end"));
/// assert_eq!(describe_unread_formulas(&CheckTally::default()), None);
/// ```
pub fn describe_unread_formulas(tally: &CheckTally) -> Option<String> {
    const WHY: &str = "too long, or nests too deeply, or has macros that never end";
    match tally.unread {
        0 => None,
        1 => Some(format!("1 formula or line was not read to its end: it is {WHY}.")),
        some => {
            let some = describe_count(some, "formula or line").replace("formula or lines", "formulas or lines");
            Some(format!("{some} were not read to their end: each is {WHY}."))
        }
    }
}

/// The places in which only units differ, in words without a full stop; none if there are none.
///
/// ```
/// use proofread::{CheckOptions, TextFormat, proofread, summary::describe_unit_differences};
///
/// let text = r"$4.9\,\mathrm{m/s} \cdot 2.0\,\mathrm{s} = 9.8\,\mathrm{m/s}$";
/// let report = proofread(text, TextFormat::Markdown, CheckOptions::default())?;
/// let words = describe_unit_differences(&report.tally).expect("one place");
/// assert_eq!(words, "1 place agrees in its numbers but not in its units");
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
pub fn describe_unit_differences(tally: &CheckTally) -> Option<String> {
    match tally.pairs_with(ChainVerdict::Units) {
        0 => None,
        1 => Some("1 place agrees in its numbers but not in its units".to_owned()),
        places => Some(format!("{} agree in their numbers but not in their units", describe_count(places, "place"))),
    }
}

/// The differences that are set aside, in words without a full stop; none if there are none.
///
/// ```
/// use proofread::{CheckTally, summary::describe_doubts};
///
/// let words = describe_doubts(&CheckTally { doubts: 2, ..CheckTally::default() }).expect("two doubts");
/// assert!(words.starts_with("2 differences are set aside"));
/// ```
pub fn describe_doubts(tally: &CheckTally) -> Option<String> {
    match tally.doubts {
        0 => None,
        1 => Some(
            "1 difference is set aside, since the text may have been misread or the result is truncated".to_owned(),
        ),
        some => Some(format!(
            "{} are set aside, since the text may have been misread or the results are truncated",
            describe_count(some, "difference")
        )),
    }
}

/// The differences that are less certain, in words without a full stop; none if there are none.
///
/// ```
/// use proofread::summary::describe_less_certain;
///
/// assert_eq!([0, 1, 3].map(describe_less_certain), [None, Some("1 less certain difference".to_owned()), Some("3 less certain differences".to_owned())]);
/// ```
pub fn describe_less_certain(differences: usize) -> Option<String> {
    (differences > 0).then(|| describe_count(differences, "less certain difference"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_and_many_are_told_apart() {
        let one_each = |list| usize::from(matches!(list, ReportSection::Numbers | ReportSection::Units));
        assert_eq!(describe_findings(one_each, 2).as_deref(), Some("2 findings: 1 on a number, 1 on units alone"));
        assert_eq!(
            describe_findings(|list| 1200 * usize::from(list == ReportSection::Numbers), 1200).as_deref(),
            Some("1,200 findings: 1,200 on a number")
        );
        assert_eq!(describe_findings(|_| 0, 0), None);
        let doubt = |list| usize::from(list == ReportSection::Doubts);
        assert_eq!(describe_findings(doubt, 1).as_deref(), Some("1 finding: 1 in doubt"));
        let tally = CheckTally { doubts: 2, ..CheckTally::default() };
        assert!(describe_doubts(&tally).is_some_and(|said| said.starts_with("2 differences are set aside")));
        let mut counts = NamedCounts::default();
        assert_eq!(describe_unchecked_chains(&counts), None);
        counts.count(UncheckedKind::Letter, "", 1539);
        assert_eq!(describe_unchecked_chains(&counts).as_deref(), Some("Not checked: 1,539 chains with letters."));
        counts.count(UncheckedKind::Notation, "an uncertainty", 1);
        assert_eq!(
            describe_unchecked_chains(&counts).as_deref(),
            Some("Not checked: 1 chain with an uncertainty, 1,539 with letters.")
        );
        let mut parts = UnreadParts::default();
        parts.count(UnreadKind::Comment, "", 2);
        parts.count(UnreadKind::File, ".rst", 3);
        assert_eq!(
            describe_unread_parts(&parts).as_deref(),
            Some("Not read: 3 files of `.rst`; and, with an equals sign and a digit: 2 comments.")
        );
        let tally = CheckTally { partly: 1, ..CheckTally::default() };
        assert_eq!(describe_partly_checked_chains(&tally).as_deref(), Some("1 chain was checked in part."));
        assert_eq!((describe_unit_differences(&tally), describe_unread_formulas(&tally)), (None, None));
        let tally = CheckTally { unread: 2, ..CheckTally::default() };
        assert!(
            describe_unread_formulas(&tally).is_some_and(|said| said.starts_with("2 formulas or lines were not read"))
        );
    }
}
