//! What is said at the end of a report, for every program that shows one.

use crate::check::CheckTally;
use crate::finding::ReportSection;
use crate::verdict::ChainVerdict;

/// "1 chain", "2 chains", "12,345 chains".
///
/// ```
/// use proofread::summary::describe_count;
///
/// assert_eq!([1, 2, 12_345].map(|number| describe_count(number, "chain")), ["1 chain", "2 chains", "12,345 chains"]);
/// ```
pub fn describe_count(number: usize, thing: &str) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.char_indices() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    format!("{text} {thing}{}", if number == 1 { "" } else { "s" })
}

/// How many findings there are and on which lists, such as `2 findings: 1 on a number, 1 on units alone`; `number_on` tells how
/// many a list has. None if there are none.
///
/// ```
/// use proofread::{ReportSection, summary::describe_findings};
///
/// let found = |section| if section == ReportSection::Units { 2 } else { 0 };
/// assert_eq!(describe_findings(found).as_deref(), Some("2 findings: 2 on units alone"));
/// assert_eq!(describe_findings(|_| 0), None);
/// ```
pub fn describe_findings(number_on: impl Fn(ReportSection) -> usize) -> Option<String> {
    const LISTS: [(ReportSection, &str); 5] = [
        (ReportSection::Numbers, "on a number"),
        (ReportSection::Statistics, "on a statistic or a total"),
        (ReportSection::Bindings, "with values from elsewhere in the text"),
        (ReportSection::Units, "on units alone"),
        (ReportSection::Doubts, "in doubt"),
    ];
    let numbers = LISTS.map(|(list, words)| (number_on(list), words));
    let parts: Vec<String> = numbers
        .iter()
        .filter(|(number, _)| *number > 0)
        .map(|(number, words)| format!("{} {words}", describe_count(*number, "").trim_end_matches([' ', 's'])))
        .collect();
    let all = numbers.iter().map(|(number, _)| number).sum();
    (!parts.is_empty()).then(|| format!("{}: {}", describe_count(all, "finding"), parts.join(", ")))
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

/// The chains that arithmetic cannot check, in a sentence; none if there are none.
///
/// ```
/// use proofread::{CheckTally, summary::describe_unchecked_chains};
///
/// let tally = CheckTally { chains: 3, checkable: 1, checked: 1, ..CheckTally::default() };
/// let words = describe_unchecked_chains(&tally).expect("two chains");
/// assert_eq!(words, "2 other chains only define something or contain letters.");
/// ```
pub fn describe_unchecked_chains(tally: &CheckTally) -> Option<String> {
    match tally.chains.saturating_sub(tally.checkable.max(tally.checked)) {
        0 => None,
        1 => Some("1 other chain only defines something or contains letters.".to_owned()),
        others => Some(format!("{} only define something or contain letters.", describe_count(others, "other chain"))),
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_and_many_are_told_apart() {
        let one_each = |list| usize::from(matches!(list, ReportSection::Numbers | ReportSection::Units));
        assert_eq!(describe_findings(one_each).as_deref(), Some("2 findings: 1 on a number, 1 on units alone"));
        assert_eq!(
            describe_findings(|list| 1200 * usize::from(list == ReportSection::Numbers)).as_deref(),
            Some("1,200 findings: 1,200 on a number")
        );
        assert_eq!(describe_findings(|_| 0), None);
        let doubt = |list| usize::from(list == ReportSection::Doubts);
        assert_eq!(describe_findings(doubt).as_deref(), Some("1 finding: 1 in doubt"));
        let tally = CheckTally { doubts: 2, ..CheckTally::default() };
        assert!(describe_doubts(&tally).is_some_and(|said| said.starts_with("2 differences are set aside")));
        let tally = CheckTally { chains: 3, checkable: 1, checked: 2, ..CheckTally::default() };
        assert_eq!(
            describe_unchecked_chains(&tally).as_deref(),
            Some("1 other chain only defines something or contains letters.")
        );
        assert_eq!((describe_unit_differences(&tally), describe_unread_formulas(&tally)), (None, None));
        let tally = CheckTally { unread: 2, ..CheckTally::default() };
        assert!(
            describe_unread_formulas(&tally).is_some_and(|said| said.starts_with("2 formulas or lines were not read"))
        );
    }
}
