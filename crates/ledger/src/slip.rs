//! What is wrong in a source: one slip, in one place or in many.

use crate::slugs::slugs;
use crate::{Judged, Kind, Verdict, Work, claims, verdicts_where};
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// What is wrong in one place, and the slip that it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Erratum {
    /// What should stand there. Empty for a number whose check computes the right one.
    pub corrected: &'static str,
    /// The slip.
    pub slip: Slip,
}

/// One thing that is wrong. Every claim that it reaches refers to it; it is counted once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slip {
    /// The id of the claim in which it is made. Empty for that of the claim at hand.
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
}

/// What a slip does, the gravest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Consequence {
    /// An answer, a table or a curve is wrong.
    Result,
    /// Something that the source concludes is false.
    Conclusion,
    /// A printed number that is no answer is wrong, and no answer with it.
    Number,
    /// A displayed equation is false; nothing after it uses it so.
    Derivation,
    /// A label, a reference, a unit or a name is wrong.
    Wording,
    /// A character of the copy is wrong; nothing is said of the original.
    Copy,
}

slugs!(Origin { Copy = "copy", Misprint = "misprint", Arithmetic = "arithmetic", Concept = "concept" });

slugs!(Consequence {
    Result = "result",
    Conclusion = "conclusion",
    Number = "number",
    Derivation = "derivation",
    Wording = "wording",
    Copy = "copy",
});

impl Origin {
    /// What it means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Copy => "a character that is lost or changed in the copy at hand; nothing is said of the original",
            Self::Misprint => "a slip of the pen or a misprint: a wrong or missing word, sign or symbol",
            Self::Arithmetic => "a wrong or carelessly rounded computation",
            Self::Concept => "a wrong idea",
        }
    }
}

impl Consequence {
    /// What it means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Result => "an answer, a table or a curve is wrong",
            Self::Conclusion => "something that the source concludes is false",
            Self::Number => "a printed number that is no answer is wrong, and no answer with it",
            Self::Derivation => "a displayed equation is false; nothing after it uses it so",
            Self::Wording => "a label, a reference, a unit or a name is wrong",
            Self::Copy => "a character of the copy is wrong; nothing is said of the original",
        }
    }

    /// The same as a heading.
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

/// All slips, the gravest consequence first, then what changes most in printed numbers
/// (the sum of their relative changes), then as the sources stand.
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
        self.wrong_numbers().filter_map(|judged| {
            let (printed, right) = (judged.printed_number()?, judged.right_value?);
            Some(((printed - right) / right).abs())
        })
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
        fault(copy != (slip.origin == Origin::Copy), "a slip of the copy is one by origin and by consequence");
        fault(!copy && !result && !number && self.wrong_numbers().next().is_some(), "a printed number changes");
        fault(number && self.wrong_numbers().next().is_none(), "no printed number changes");
        // A problem says which numbers are its answers; the tables and curves of a thesis are all of them its results.
        let asked = self.main().claim.work.answers();
        let changed = self.wrong_numbers().find(|judged| asked.contains(&judged.claim.id));
        fault(number && changed.is_some(), "an answer changes");
        fault(
            result && !asked.is_empty() && changed.is_none() && !kinds.contains(&Kind::Figure),
            "no answer and no figure changes",
        );
        // On a page that gives a formula to its readers, the formula is the answer.
        let answers = |kind: &Kind| match kind {
            Kind::Figure | Kind::Example => true,
            Kind::Equation => !self.is_of_a_document(),
            Kind::Value | Kind::Statement => false,
        };
        fault(
            result && self.wrong_numbers().next().is_none() && !kinds.iter().any(answers),
            "no printed number and no figure changes",
        );
        fault(
            is(Consequence::Conclusion)
                && !self
                    .claims
                    .iter()
                    .any(|judged| judged.claim.kind == Kind::Statement && judged.verdict == Verdict::Corrected),
            "no statement is corrected",
        );
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
    fn a_result_is_an_answer_and_another_number_is_none() {
        let found = faults_as("pin.slot-point-speed", Consequence::Result);
        assert!(found.contains("but no answer and no figure changes"), "{found}");
        let found = faults_as("quick-return.pin-speed", Consequence::Number);
        assert!(found.contains("but an answer changes"), "{found}");
        let found = faults_as("quick-return.lever-point-speed-equation", Consequence::Number);
        assert!(found.contains("but no printed number changes"), "{found}");
    }
}
