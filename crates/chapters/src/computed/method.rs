//! Of how it is checked: the equations that are read, the misprints that were made, and what readings overturned.

use crate::lookup::of_documents;
use crate::tables::readings::{READINGS, SENTENCES};
use anyhow::Context;
use geneva_documents::LEDGER;
use geneva_evidence::OwnNumber;
use geneva_evidence::{Check, Evidence, Judged};
use std::collections::BTreeMap;

/// Made by the test of the misprints, which fails if it is not as the ledger has it.
const MISPRINTS: &str = include_str!("../../../../book/records/misprints.csv");
/// Made by the test of further misprints in equations that are wrong as printed.
const MISPRINTS_OF_WRONG: &str = include_str!("../../../../book/records/misprints-of-wrong.csv");

/// The numbers of the page.
pub(super) fn numbers() -> Vec<OwnNumber> {
    vec![
        misprinted("method.misprints.refuted", "refuted"),
        misprinted("method.misprints.refuted-by-both", "refuted-by-both"),
        misprinted("method.misprints.unreadable", "unreadable"),
        misprinted("method.misprints.harmless", "harmless"),
        misprinted("method.misprints.of-wrong", "noticed"),
        misprinted("method.misprints.at-the-slip", "at-the-slip"),
        OwnNumber::count("method.equations", || Ok(equations())),
        OwnNumber::count("method.same-kind", || Ok(of_one_kind(|_| true))),
        OwnNumber::count("method.readings.last", || Ok(last()?.0)),
        OwnNumber::count("method.readings.last-of", || Ok(last()?.1)),
        OwnNumber::count("method.readings.last-part", || Ok(one_in(last()?))),
        OwnNumber::count("method.readings.last-sentences", || Ok(last()?.2)),
        OwnNumber::count("method.readings.eighth-sentences", || {
            let sentences = READINGS.get(7).and_then(|reading| reading.sentences);
            Ok(sentences.context("the eighth reading counted sentences")?)
        }),
        OwnNumber::count("method.readings.again", || Ok(again())),
    ]
}

/// A number of the records of misprints.
fn misprinted(id: &'static str, line: &'static str) -> OwnNumber {
    OwnNumber::count(id, move || Ok(misprints(line)?))
}

/// A number of the records of misprints.
fn misprints(name: &str) -> anyhow::Result<usize> {
    let lines =
        [MISPRINTS, MISPRINTS_OF_WRONG].into_iter().flat_map(str::lines).filter_map(|line| line.split_once(','));
    let found = lines.into_iter().find_map(|(known, number)| (known == name).then_some(number));
    Ok(found.with_context(|| format!("the record of misprints has no line `{name}`"))?.parse()?)
}

/// How many equations of all sources are checked: both routes of each read its characters.
fn equations() -> usize {
    LEDGER.verdicts().iter().filter(|judged| matches!(judged.claim.check, Check::Equation { .. })).count()
}

/// How many claims of the documents have two routes of one kind, of these kinds.
fn of_one_kind(wanted: fn(&Evidence) -> bool) -> usize {
    let alike = |judged: &&Judged| match judged.claim.check.evidence()[..] {
        [first, witness] => first == witness && wanted(first),
        _ => false,
    };
    of_documents().filter(alike).count()
}

/// Of the last reading that overturned something and counted what it went through: statements and figures overturned, those
/// gone through, and sentences of the book to change.
fn last() -> anyhow::Result<(usize, usize, usize)> {
    let mut overturning = READINGS.iter().rev().filter(|reading| !reading.overturned.is_empty());
    let counted = overturning.find_map(|reading| {
        // Those of the pages elsewhere were gone through, but not counted.
        let here = |id: &str| !id.starts_with("wild.");
        let of = reading.overturned.iter().filter(|(id, kind)| here(id) && SENTENCES.contains(kind)).count();
        Some((of, reading.gone_through?, reading.sentences?))
    });
    counted.context("no reading has counted what it went through")
}

/// A part as one in so many.
fn one_in((part, all, _): (usize, usize, usize)) -> f64 {
    (all as f64 / part.max(1) as f64).round()
}

/// How many claims more than one reading has overturned.
fn again() -> usize {
    let mut times: BTreeMap<&str, usize> = BTreeMap::new();
    for (id, _) in READINGS.iter().flat_map(|reading| reading.overturned) {
        *times.entry(id).or_default() += 1;
    }
    times.values().filter(|times| **times > 1).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_record_of_misprints_has_its_lines() {
        for name in ["refuted", "refuted-by-both", "unreadable", "harmless", "noticed", "at-the-slip"] {
            assert!(misprints(name).expect("a line") > 0, "{name}");
        }
        assert!(misprints("made up").is_err());
        // What else is of one kind would have to be said.
        assert_eq!(of_one_kind(|_| true), of_one_kind(|kind| kind == Evidence::OTHER_PLACE_IN_SOURCE));
        assert!(again() > 3 && equations() > 200);
    }
}
