//! What is wrong in a source: one slip, in one place or in many.

use crate::slugs::slugs;
use crate::{Decimal, Judged, Kind, Verdict, Work, claims, verdicts_where};
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// What is wrong in one place, and the slip that it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Erratum {
    /// What should be printed there. Empty for a number whose check computes the right one.
    pub corrected: &'static str,
    /// In how many places of an equation the printed characters are others than the corrected ones.
    pub places: usize,
    /// The slip.
    pub slip: Slip,
}

/// One thing that is wrong. Every claim that it reaches refers to it; it is counted once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slip {
    /// The id of the claim in which the slip is made. Empty if it is the claim at hand.
    pub id: &'static str,
    /// Why it is wrong.
    pub reason: &'static str,
    /// Which second witness says so, in words.
    pub witness: &'static str,
    /// Where it comes from.
    pub origin: Origin,
    /// What it does to the reader of the source.
    pub consequence: Consequence,
    /// What changes when it is put right, in a sentence. May be empty if nothing but the place itself does.
    pub changes: &'static str,
}

/// Where a slip comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Origin {
    /// A character that is lost or changed in the copy at hand.
    Copy,
    /// A wrong or missing word, sign or symbol.
    Misprint,
    /// A wrong or carelessly rounded computation.
    Arithmetic,
    /// A wrong idea.
    Concept,
    /// Nothing that is printed shows where it comes from.
    Unknown,
}

/// The least relative deviation of an answer that counts as a wrong result: half a per cent.
///
/// Rounding to two digits can change any number by that much or more: half a unit of the second digit is at least 0.5 in 99.
/// What is wrong by less is wrong in its last digits, and no data of two digits would show it.
pub const FELT: f64 = 0.005;

/// What a slip does, the most serious consequence first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Consequence {
    /// An answer, a number in a table or a curve is wrong, by [`FELT`] or more.
    Result,
    /// Something that the source concludes is false: the claim is among [`Work::conclusions`].
    Conclusion,
    /// A sentence that describes something is false; the source concludes nothing false from it.
    Remark,
    /// A printed number is wrong, and no answer is wrong by [`FELT`] or more.
    Number,
    /// A displayed equation is false; nothing after it uses it so.
    Derivation,
    /// A label, a reference, a unit or a name is wrong.
    Wording,
    /// A character of the copy is wrong; nothing is said of the original.
    Copy,
}

slugs!(Origin {
    Copy = "copy",
    Misprint = "misprint",
    Arithmetic = "arithmetic",
    Concept = "concept",
    Unknown = "unknown",
});

slugs!(Consequence {
    Result = "result",
    Conclusion = "conclusion",
    Remark = "remark",
    Number = "number",
    Derivation = "derivation",
    Wording = "wording",
    Copy = "copy",
});

impl Origin {
    /// What it means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Copy => {
                "a character that is lost or changed in the copy we had, which says nothing about the original"
            }
            Self::Misprint => "a slip of the pen or a misprint: a wrong or missing word, sign or symbol",
            Self::Arithmetic => "a wrong or carelessly rounded computation",
            Self::Concept => "a wrong idea",
            Self::Unknown => "we cannot tell",
        }
    }
}

impl Consequence {
    /// What it means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Result => "an answer, a tabulated number or a curve is wrong, by half a per cent or more",
            Self::Conclusion => "something that the source concludes is false",
            Self::Remark => {
                "a sentence that describes something is false, but the source concludes nothing false from it"
            }
            Self::Number => "a printed number is wrong, but no answer is wrong by half a per cent or more",
            Self::Derivation => "a displayed equation is false, but nothing after it uses it in that form",
            Self::Wording => "a label, a reference, a unit or a name is wrong",
            Self::Copy => "a character of the copy we had is wrong, which says nothing about the original",
        }
    }

    /// The meaning written as a heading.
    pub fn heading(self) -> String {
        let mut characters = self.meaning().chars();
        characters.next().map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
    }
}

/// A slip with all its places.
#[derive(Clone, Debug)]
pub struct Places {
    /// The slip.
    pub slip: Slip,
    /// The claims that it reaches, in the order of the source, the one in which it is made first.
    pub claims: Vec<&'static Judged>,
}

/// All slips, the most serious consequence first, then by how much they change printed numbers (the sum of their
/// relative changes), then in the order of the sources.
pub fn slips() -> &'static [Places] {
    static SLIPS: OnceLock<Vec<Places>> = OnceLock::new();
    SLIPS.get_or_init(|| collected(|_| true))
}

/// The slips that are made in this source, in the order of [`slips`]: the verdicts of the others are not derived for it.
pub fn slips_in(work: Work) -> Vec<Places> {
    let main = |slip: &Slip| claims().iter().find(|claim| claim.id == slip.id).map(|claim| claim.work);
    collected(|slip| main(slip) == Some(work))
}

/// The slips of the documents with this consequence.
pub fn slips_of(consequence: Consequence) -> impl Iterator<Item = &'static Places> {
    slips().iter().filter(move |places| places.is_of_a_document() && places.slip.consequence == consequence)
}

/// The slip of this id with its places: the verdicts on no other claims are derived for it.
pub fn slip(id: &str) -> Option<&'static Places> {
    static FOUND: OnceLock<BTreeMap<&str, OnceLock<Option<Places>>>> = OnceLock::new();
    let all = || claims().iter().filter_map(|claim| Some((claim.erratum?.slip.id, OnceLock::new()))).collect();
    FOUND.get_or_init(all).get(id)?.get_or_init(|| collected(|slip| slip.id == id).pop()).as_ref()
}

/// The slips that are wanted, with their places.
fn collected(wanted: impl Fn(&Slip) -> bool) -> Vec<Places> {
    let mut found: Vec<Places> = Vec::new();
    for judged in verdicts_where(|claim| claim.erratum.as_ref().is_some_and(|erratum| wanted(&erratum.slip))) {
        let Some(erratum) = &judged.claim.erratum else { continue };
        match found.iter_mut().find(|places| places.slip.id == erratum.slip.id) {
            Some(places) => places.claims.push(judged),
            None => found.push(Places { slip: erratum.slip, claims: vec![judged] }),
        }
    }
    for places in &mut found {
        places.claims.sort_by_key(|judged| judged.claim.id != places.slip.id);
    }
    let parts_in_a_million = |of: &Places| (of.changes().sum::<f64>() * 1e6).round() as u64;
    found.sort_by_key(|of| (of.slip.consequence, Reverse(parts_in_a_million(of))));
    found
}

impl Places {
    /// The claim in which the slip is made.
    pub fn main(&self) -> &'static Judged {
        self.claims[0]
    }

    /// Whether it is made in one of the documents that the book mirrors.
    pub fn is_of_a_document(&self) -> bool {
        self.main().claim.work.is_document()
    }

    /// The printed numbers that are not right because of it.
    pub fn wrong_numbers(&self) -> impl Iterator<Item = &'static Judged> {
        let wrong = |judged: &&Judged| judged.claim.kind == Kind::Value && judged.verdict.needs_erratum();
        self.claims.iter().copied().filter(wrong)
    }

    /// Their deviations from what is right, relative to that.
    fn changes(&self) -> impl Iterator<Item = f64> {
        self.wrong_numbers().filter_map(change)
    }

    /// The largest of these deviations; none if no number is wrong.
    pub fn greatest_change(&self) -> Option<f64> {
        self.changes().max_by(f64::total_cmp)
    }

    /// What contradicts the consequence on record; empty if nothing does.
    pub fn faults(&self) -> Vec<String> {
        let (slip, mut faults) = (&self.slip, Vec::new());
        let mut fault = |wrong: bool, what: &str| {
            if wrong {
                faults.push(format!("{}: recorded as {}, but {what}", slip.id, slip.consequence));
            }
        };
        let kinds: Vec<_> = self.claims.iter().map(|judged| judged.claim.kind).collect();
        let is = |consequence| slip.consequence == consequence;
        let (copy, result, number) = (is(Consequence::Copy), is(Consequence::Result), is(Consequence::Number));
        let main = self.main().claim;
        let changed = self.greatest_change();
        fault(copy != (slip.origin == Origin::Copy), "a slip of the copy is one by origin and by consequence");
        fault(!copy && !result && !number && changed.is_some(), "a printed number changes");
        fault(number && changed.is_none(), "no printed number changes");
        // A problem says which numbers are its answers; the tables and curves of a thesis are all of them its results.
        let asked = main.work.answers();
        let answers = self.wrong_numbers().filter(|judged| asked.contains(&judged.claim.id));
        let felt = |change: f64| change >= FELT;
        let felt_in_an_answer = answers.filter_map(change).any(felt);
        fault(number && felt_in_an_answer, "an answer changes by half a per cent or more");
        fault(
            result && !asked.is_empty() && !felt_in_an_answer && !kinds.contains(&Kind::Figure),
            "no answer changes by half a per cent or more, and no figure",
        );
        // On a page that gives a formula to its readers, the formula is the answer.
        let shows = |kind: &Kind| match kind {
            Kind::Figure | Kind::Example => true,
            Kind::Equation => !self.is_of_a_document(),
            Kind::Value | Kind::Statement => false,
        };
        fault(
            result && !changed.is_some_and(felt) && !kinds.iter().any(shows),
            "no printed number changes by half a per cent or more, and no figure",
        );
        let sentence = |judged: &&Judged| {
            matches!(judged.claim.kind, Kind::Statement | Kind::Figure) && judged.verdict == Verdict::Corrected
        };
        let concluded = main.work.conclusions().iter().any(|(id, _)| *id == main.id);
        fault(
            (is(Consequence::Conclusion) || is(Consequence::Remark))
                && !self.claims.iter().copied().any(|judged| sentence(&judged)),
            "no statement is corrected",
        );
        fault(is(Consequence::Conclusion) && !concluded, "the source is not known to conclude it");
        fault(is(Consequence::Remark) && concluded, "the source concludes it");
        fault(is(Consequence::Derivation) && !kinds.contains(&Kind::Equation), "it is in no equation");
        let told = matches!(slip.consequence, Consequence::Result | Consequence::Conclusion);
        fault(told && slip.changes.is_empty(), "nothing is said of what it changes");
        fault(self.main().claim.id != slip.id, "no claim of that id refers to it");
        fault(
            self.claims.iter().any(|judged| judged.claim.erratum.is_some_and(|erratum| erratum.slip != *slip)),
            "two slips have this id",
        );
        faults
    }
}

/// The deviation of a printed number from the right one, relative to that.
///
/// What is right in the place of a misprint is the number that should have been printed, with no more digits than that.
fn change(judged: &Judged) -> Option<f64> {
    let misprint = judged.claim.erratum.as_ref().filter(|erratum| erratum.slip.origin == Origin::Misprint);
    let corrected = misprint.and_then(|erratum| erratum.corrected.parse::<Decimal>().ok());
    let (printed, right) = (judged.printed_number()?, judged.right_value?);
    let right = corrected.map_or(right, |corrected| corrected.to_f64());
    Some(((printed - right) / right).abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What contradicts the slip of this id with another consequence on record.
    fn faults_as(id: &str, consequence: Consequence) -> String {
        let mut places = slip(id).expect("a slip").clone();
        places.slip.consequence = consequence;
        places.faults().join("\n")
    }

    #[test]
    fn the_slips_of_a_source_are_those_among_all() {
        let ids = |slips: &mut dyn Iterator<Item = &Places>| -> Vec<(&str, usize)> {
            slips.map(|places| (places.slip.id, places.claims.len())).collect()
        };
        for work in Work::ALL {
            let expected = ids(&mut slips().iter().filter(|places| places.main().claim.work == *work));
            assert_eq!(ids(&mut slips_in(*work).iter()), expected, "{work}");
        }
        let one_by_one: Vec<&Places> = slips().iter().filter_map(|places| slip(places.slip.id)).collect();
        assert_eq!(ids(&mut one_by_one.into_iter()), ids(&mut slips().iter()));
        assert!(slip("no-slip").is_none());
    }

    #[test]
    fn a_result_is_an_answer_that_is_wrong_by_more_than_its_last_digits() {
        let found = faults_as("pin.slot-point-speed", Consequence::Result);
        assert!(found.contains("but no answer changes by half a per cent or more"), "{found}");
        // An answer, but wrong in its last digits alone.
        let found = faults_as("quick-return.pin-speed", Consequence::Result);
        assert!(found.contains("but no answer changes by half a per cent or more"), "{found}");
        let found = faults_as("meyer.app-a.three-slots.centre", Consequence::Result);
        assert!(found.contains("but no printed number changes by half a per cent or more"), "{found}");
        let found = faults_as("jazar.ex-c.formula", Consequence::Number);
        assert!(found.contains("but an answer changes"), "{found}");
        let found = faults_as("quick-return.lever-point-speed-equation", Consequence::Number);
        assert!(found.contains("but no printed number changes"), "{found}");
    }

    #[test]
    fn a_conclusion_is_drawn_by_the_source_and_a_remark_is_not() {
        let found = faults_as("meyer.conclusion.three", Consequence::Remark);
        assert!(found.contains("but the source concludes it"), "{found}");
        let found = faults_as("wild.probsee.steps", Consequence::Conclusion);
        assert!(found.contains("but the source is not known to conclude it"), "{found}");
        let found = faults_as("quick-return.lever-point-speed-equation", Consequence::Remark);
        assert!(found.contains("but no statement is corrected"), "{found}");
        assert!(faults_as("meyer.spring-rate", Consequence::Number).contains("but no printed number changes"));
    }

    #[test]
    fn rounding_to_two_digits_can_change_any_number_by_as_much() {
        // Half a unit of the second digit, over the greatest number of that size.
        let least = (10..=99).map(|digits| 0.5 / (f64::from(digits) + 0.5)).fold(f64::INFINITY, f64::min);
        assert!((FELT..1.01 * FELT).contains(&least), "{least}");
    }
}
