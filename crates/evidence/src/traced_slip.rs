//! A slip with all the places that it reaches, and what contradicts its consequence on record.

use crate::{Consequence, Decimal, FELT, Judged, Kind, Origin, Slip, Verdict};
use std::cmp::Reverse;

/// A slip with all its places.
#[derive(Clone, Debug)]
pub struct TracedSlip {
    /// The slip.
    pub slip: Slip,
    /// The claims that it reaches, in the order of the source, the one in which it is made first.
    pub claims: Vec<&'static Judged>,
}

/// The slips of these claims, each with all of them that it reaches: the most serious consequence first, then by how much they
/// change printed numbers (the sum of their relative changes), then in the order of the claims.
pub(crate) fn trace(judged: impl IntoIterator<Item = &'static Judged>) -> Vec<TracedSlip> {
    let mut found: Vec<TracedSlip> = Vec::new();
    for judged in judged {
        let Some(erratum) = &judged.claim.erratum else { continue };
        match found.iter_mut().find(|places| places.slip.id == erratum.slip.id) {
            Some(places) => places.claims.push(judged),
            None => found.push(TracedSlip { slip: erratum.slip, claims: vec![judged] }),
        }
    }
    for places in &mut found {
        places.claims.sort_by_key(|judged| judged.claim.id != places.slip.id);
    }
    let parts_in_a_million = |of: &TracedSlip| (of.changes().sum::<f64>() * 1e6).round() as u64;
    found.sort_by_key(|of| (of.slip.consequence, Reverse(parts_in_a_million(of))));
    found
}

impl TracedSlip {
    /// The claim in which the slip is made.
    pub fn main(&self) -> &'static Judged {
        self.claims[0]
    }

    /// Whether it is made in one of the documents that the book mirrors.
    pub fn is_mirrored(&self) -> bool {
        self.main().claim.document.is_mirrored()
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
        // A problem says which numbers are its answers; the tables and curves of a longer work are all of them its results.
        let asked = main.document.answers;
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
            Kind::Equation => !self.is_mirrored(),
            Kind::Value | Kind::Statement => false,
        };
        fault(
            result && !changed.is_some_and(felt) && !kinds.iter().any(shows),
            "no printed number changes by half a per cent or more, and no figure",
        );
        let sentence = |judged: &&Judged| {
            matches!(judged.claim.kind, Kind::Statement | Kind::Figure) && judged.verdict == Verdict::Corrected
        };
        let concluded = main.document.conclusions.iter().any(|(id, _)| *id == main.id);
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
