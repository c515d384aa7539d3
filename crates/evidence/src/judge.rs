//! The verdict on a claim, derived.

use crate::number_format::fixed;
use crate::tex::places_changed;
use crate::units::unit_fault;
use crate::{
    Agreement, Check, ChoiceFn, Claim, Consequence, Decimal, DecisionFn, Erratum, Evidence, Finding, NumberFn,
    PlainVerdict, Route, Stated, Truth, Verdict,
};
use std::any::Any;
use std::borrow::Cow;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// A claim with its derived verdict and what was found on the way.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The claim.
    pub claim: &'static Claim,
    /// The characters that were judged: the printed ones, or others in their place.
    pub printed: Cow<'static, str>,
    /// The derived verdict.
    pub verdict: Verdict,
    /// The computed number in the printed unit, if the claim is one.
    pub computed: Option<f64>,
    /// The witness's number.
    pub witnessed: Option<f64>,
    /// What the source's own rounded intermediate results give.
    pub from_rounded: Option<f64>,
    /// The right number, where the printed one is not right to all its digits.
    pub right_value: Option<f64>,
    /// How the printed form, its correction and its witness were found to hold or to fail.
    pub findings: Vec<(&'static str, Finding)>,
    /// What contradicts the record, beside a differing verdict. Empty if all is well.
    pub faults: Vec<String>,
}

impl Judged {
    /// Nothing found yet.
    fn undecided(claim: &'static Claim, printed: Cow<'static, str>) -> Self {
        Self {
            claim,
            printed,
            verdict: Verdict::NotReproducible,
            computed: None,
            witnessed: None,
            from_rounded: None,
            right_value: None,
            findings: Vec::new(),
            faults: Vec::new(),
        }
    }

    /// Whether the claim agrees with its record: the verdict is the expected one and nothing contradicts it.
    pub fn matches_record(&self) -> bool {
        self.verdict == self.claim.expected && self.faults.is_empty()
    }

    /// Whether what is printed is right.
    pub fn truth(&self) -> Truth {
        self.plain().truth()
    }

    /// Whether the source itself is right for all we know: what is wrong is only in the copy of it that was read.
    pub fn is_miscopied(&self) -> bool {
        self.plain() == PlainVerdict::WrongInCopy
    }

    /// Whether the characters that were judged are the printed ones.
    pub fn is_as_printed(&self) -> bool {
        self.printed == self.claim.printed
    }

    /// Whether the characters could be read where the check reads them; what cannot be read is neither right nor wrong.
    pub fn is_readable(&self) -> bool {
        let is_number = self.computed.is_some();
        self.findings.iter().all(|(_, finding)| finding.evaluated)
            && (!is_number || self.printed.parse::<Decimal>().is_ok())
    }

    /// A number beside the judged characters, with some places more.
    pub fn rounded(&self, number: f64) -> String {
        let places = match self.printed.parse::<Decimal>() {
            // A fraction has no last place to go by.
            Ok(_) if self.printed.contains('/') => 2 * Decimal::MORE_PLACES,
            Ok(decimal) => decimal.places() as usize + Decimal::MORE_PLACES,
            Err(_) => Decimal::MORE_PLACES,
        };
        fixed(number, places)
    }

    /// The printed number, if the claim is one.
    pub fn printed_number(&self) -> Option<f64> {
        Some(self.printed.parse::<Decimal>().ok()?.to_f64())
    }

    /// What should stand in the place of the printed characters, if something should: as the erratum has it, or the
    /// right number, written as the printed one is.
    pub fn corrected(&self) -> Option<String> {
        let erratum = self.claim.erratum.as_ref()?;
        if !erratum.corrected.is_empty() {
            return Some(erratum.corrected.to_owned());
        }
        Some(self.printed.parse::<Decimal>().ok()?.like(self.right_value?))
    }

    /// What is wrong, a line each; empty if the claim holds.
    pub fn complaints(&self) -> Vec<String> {
        let mut lines = Vec::new();
        if self.verdict != self.claim.expected {
            let remedy = match self.verdict {
                Verdict::Truncated => {
                    "; if its digits were cut off, write `.corrected(\"…\", slip)` and `.expecting(Verdict::Truncated)`"
                }
                Verdict::NotReproduced => {
                    "; read the document again, or write `.corrected(\"…\", slip)` with what is right"
                }
                _ => "",
            };
            lines.push(format!("recorded as {}, but found {}{remedy}", self.claim.expected, self.verdict));
        }
        lines.extend(self.faults.iter().cloned());
        lines
    }
}

/// Derives the verdict on a claim.
///
/// No claim takes the others down: a check that stops with a panic is a fault of its own claim, which says with what.
pub fn judge(claim: &'static Claim) -> Judged {
    judge_characters(claim, Cow::Borrowed(claim.printed))
}

/// Derives the verdict on a claim as if these characters were printed in it, as [`judge`] does. Nothing is recorded: what is
/// said of other characters than the printed ones is not about the document.
pub fn judge_characters(claim: &'static Claim, printed: Cow<'static, str>) -> Judged {
    // Nothing half-made is seen afterwards: what a check keeps for later is kept only when it is whole.
    catch_unwind(AssertUnwindSafe(|| derived(claim, printed.clone()))).unwrap_or_else(|panic| {
        let faults = vec![format!("the check stopped: {}", words(&*panic))];
        Judged { verdict: Verdict::NotReproduced, faults, ..Judged::undecided(claim, printed.clone()) }
    })
}

/// What a panic says.
fn words(panic: &(dyn Any + Send)) -> &str {
    let owned = panic.downcast_ref::<String>().map(String::as_str);
    owned.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("without a word")
}

fn derived(claim: &'static Claim, printed: Cow<'static, str>) -> Judged {
    let mut judged = Judged::undecided(claim, printed);
    match &claim.check {
        Check::Number { computed, witness, from_rounded, resolution, right } => {
            judged.from_rounded = from_rounded.as_ref().map(|run| run());
            let resolution = resolution.as_ref().map(|run| run());
            number(&mut judged, computed, witness, resolution);
            if let Some(routes) = right {
                put_right(&mut judged, routes, resolution);
            } else if judged.verdict.needs_erratum() {
                judged.right_value = judged.computed;
            }
        }
        Check::Equation { first, witness, also, .. } => {
            let kind = also.as_ref().map_or(witness.evidence, |also| also.evidence);
            equation(&mut judged, &*first.run, kind);
        }
        Check::Statement { first, witness, neighbour } => statement(&mut judged, first, witness, *neighbour),
        Check::Missing { .. } => {}
    }
    for (form, finding) in judged.findings.iter().filter(|(_, finding)| !finding.evaluated) {
        judged.verdict = Verdict::NotReproduced;
        judged.faults.push(format!("{form}, it cannot be evaluated: {}", finding.how));
    }
    judged.faults.extend(unit_fault(claim));
    match (&claim.erratum, judged.verdict.needs_erratum()) {
        (None, true) => judged.faults.push(format!("{} without an erratum", judged.plain().words())),
        (Some(_), false) => {
            judged.faults.push(format!("an erratum is on record, but the claim is {}", judged.plain().words()));
        }
        _ => {}
    }
    judged
}

fn number(judged: &mut Judged, computed: &Route<NumberFn>, witness: &Route<NumberFn>, resolution: Option<f64>) {
    let claim = judged.claim;
    let (value, witnessed) = ((computed.run)(), (witness.run)());
    (judged.computed, judged.witnessed) = (Some(value), Some(witnessed));
    let printed: Decimal = match judged.printed.parse() {
        Ok(printed) => printed,
        Err(unreadable) => {
            judged.verdict = Verdict::NotReproduced;
            judged.faults.push(unreadable.to_string());
            return;
        }
    };
    // Where a slip gives the printed number, a correction is of the right one, and is looked at beside that.
    let of_another = matches!(&claim.check, Check::Number { right: Some(_), .. });
    let stated = claim.erratum.as_ref().filter(|erratum| !erratum.corrected.is_empty() && !of_another);
    let correction = stated.map(|erratum| correction_passes(erratum, value));
    judged.verdict = if printed.is_rounding_of(value) {
        Verdict::Reproduced
    } else if resolution.is_none() && printed.is_truncation_of(value) {
        Verdict::Truncated
    } else if judged.from_rounded.is_some_and(|rounded| printed.is_rounding_of(rounded)) {
        Verdict::FromRounded
    } else if resolution.is_some_and(|resolution| (value - printed.to_f64()).abs() <= resolution) {
        Verdict::ReadOff
    } else if correction == Some(true) {
        Verdict::Corrected
    } else {
        Verdict::NotReproduced
    };
    if let Some(rounded) = judged.from_rounded.filter(|rounded| !printed.is_rounding_of(*rounded)) {
        judged.faults.push(format!("the source's own rounded results give {rounded}, not the printed digits"));
    }
    if correction == Some(false) {
        judged.faults.push(format!("the correction is not what is computed, {value}"));
    }
    let right = stated.and_then(|erratum| erratum.corrected.parse().ok()).unwrap_or(printed);
    record_disagreement(judged, [computed.evidence, witness.evidence], [value, witnessed], &right);
}

/// Records a fault if two routes to one number disagree. A witness that is another printed number is known only to its digits;
/// any other must agree within the coarser tolerance of the two kinds of evidence.
fn record_disagreement(
    judged: &mut Judged,
    [first, witness]: [&Evidence; 2],
    [value, witnessed]: [f64; 2],
    digits: &Decimal,
) {
    let tolerance = match (first.agreement, witness.agreement) {
        (_, Agreement::ToPrintedDigits) => {
            if !digits.is_rounding_of(witnessed) {
                let fault =
                    format!("the witness ({witness}) gives {witnessed}, of which the digits are not a rounding");
                judged.faults.push(fault);
            }
            return;
        }
        (Agreement::Within(one), Agreement::Within(other)) if one.relative > other.relative => one,
        (_, Agreement::Within(tolerance)) => tolerance,
    };
    if !tolerance.agrees(value, witnessed) {
        let (relative, name) = (tolerance.relative, tolerance.name);
        judged.faults.push(format!(
            "the witness ({witness}) gives {witnessed}, not {value}; by the tolerance \"{name}\" of these kinds of evidence they may \
             differ by {relative:e} of their size"
        ));
    }
}

/// The right number beside what the source did. If the printed digits bear it too, a slip changes nothing here, and the
/// verdict stays. Where nothing that the source did gives them, the right number still tells that they are wrong.
fn put_right(judged: &mut Judged, routes: &[Route<NumberFn>; 2], resolution: Option<f64>) {
    let [right, witnessed] = routes.each_ref().map(|route| (route.run)());
    judged.right_value = Some(right);
    let stated = judged.claim.erratum.as_ref().filter(|erratum| !erratum.corrected.is_empty());
    if stated.is_some_and(|erratum| !correction_passes(erratum, right)) {
        judged.faults.push(format!("the correction is not the right number, {right}"));
    }
    let Ok(printed) = judged.printed.parse::<Decimal>() else { return };
    record_disagreement(judged, routes.each_ref().map(|route| route.evidence), [right, witnessed], &printed);
    if printed.is_rounding_of(right) {
        return;
    }
    let within = resolution.is_some_and(|unit| (right - printed.to_f64()).abs() <= unit);
    judged.verdict = match (judged.verdict, within) {
        (Verdict::NotReproduced, true) => Verdict::NotReproduced,
        (Verdict::NotReproduced, false) => Verdict::Corrected,
        (_, true) => Verdict::ReadOff,
        (_, false) => Verdict::ReproducedInError,
    };
}

fn correction_passes(erratum: &Erratum, value: f64) -> bool {
    erratum.corrected.parse::<Decimal>().is_ok_and(|corrected| corrected.is_rounding_of(value))
}

/// An equation as printed and as corrected, of which the characters decide.
fn equation(judged: &mut Judged, decide: &DecisionFn, witness: &Evidence) {
    let claim = judged.claim;
    let as_printed = decide(&judged.printed);
    let correction = claim.erratum.as_ref().map(|erratum| decide(erratum.corrected));
    let witnessed = claim.witnessed_as(&judged.printed);
    judged.verdict = verdict(as_printed.holds, correction.as_ref().map(|finding| finding.holds));
    if as_printed.holds && correction.is_some() {
        judged.faults.push("a correction is on record, but the printed form holds".to_owned());
    }
    if let Some(erratum) = &claim.erratum {
        let places = places_changed(&judged.printed, erratum.corrected);
        if places != erratum.places && judged.is_as_printed() {
            judged.faults.push(format!(
                "the correction changes the printed characters in {places} places, and {} on record",
                match erratum.places {
                    1 => "one is".to_owned(),
                    recorded => format!("{recorded} are"),
                }
            ));
        }
    }
    if !witnessed.holds {
        judged.faults.push(format!("the witness ({witness}) disagrees: {}", witnessed.how));
    }
    judged.findings.push(("as printed", as_printed));
    judged.findings.extend(correction.map(|finding| ("corrected", finding)));
    judged.findings.push(("witness", witnessed));
}

fn statement(judged: &mut Judged, first: &Route<ChoiceFn>, witness: &Route<ChoiceFn>, neighbour: Option<&'static str>) {
    let printed = judged.printed.clone();
    // Who puts in the correction says what is right.
    let is_correction = judged.claim.erratum.as_ref().is_some_and(|erratum| erratum.corrected == printed);
    let said = if is_correction { Stated::right(&printed) } else { Stated::wrong(&printed) };
    let both = [Stated::right(judged.claim.right_for(&printed)), said];
    let [[right, wrong], [witnessed, refused]] = [both.map(&*first.run), both.map(&*witness.run)];
    judged.verdict = match neighbour {
        Some(_) => verdict(right.holds, None),
        None => verdict(wrong.holds, Some(right.holds)),
    };
    for (route, accepts) in [("first route", wrong.holds), ("witness", refused.holds)] {
        if accepts {
            let what = neighbour.unwrap_or("the printed form");
            judged.faults.push(format!("the {route} accepts the neighbour, {what}"));
        }
    }
    if !witnessed.holds {
        judged.faults.push(format!("the witness ({}) disagrees: {}", witness.evidence, witnessed.how));
    }
    let names = match neighbour {
        Some(_) => ["as printed", "neighbour", "witness", "neighbour by the witness"],
        None => ["corrected", "as printed", "witness", "as printed by the witness"],
    };
    judged.findings = names.into_iter().zip([right, wrong, witnessed, refused]).collect();
    if neighbour.is_none() {
        judged.findings.swap(0, 1);
    }
}

/// What follows from whether the printed form holds, and its correction, if there is one.
fn verdict(printed: bool, corrected: Option<bool>) -> Verdict {
    match (printed, corrected) {
        (true, _) => Verdict::Reproduced,
        (false, Some(true)) => Verdict::Corrected,
        (false, _) => Verdict::NotReproduced,
    }
}

impl Judged {
    /// The plain verdict on the characters that were judged.
    ///
    /// Other characters than the printed ones are in no source, so none of them is open for want of a correction, and none is
    /// miscopied: what the check refuses is wrong.
    pub fn plain(&self) -> PlainVerdict {
        if self.is_as_printed() {
            return self.verdict.plain(self.is_only_in_copy());
        }
        match self.verdict {
            Verdict::NotReproduced => PlainVerdict::Wrong,
            other => other.plain(false),
        }
    }

    /// The plain verdict on the printed characters, as it is on record.
    pub fn recorded_plain(&self) -> PlainVerdict {
        self.claim.expected.plain(self.is_only_in_copy())
    }

    /// Whether the mistake that reaches the claim, if one does, is only in the copy.
    fn is_only_in_copy(&self) -> bool {
        let of_copy = |erratum: &Erratum| erratum.slip.consequence == Consequence::Copy;
        self.claim.erratum.as_ref().is_some_and(of_copy)
    }
}

#[cfg(test)]
#[path = "judge_tests.rs"]
mod tests;
