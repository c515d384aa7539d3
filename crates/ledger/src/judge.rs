//! The verdict on a claim, derived.

use crate::tolerance::{ROUTES, STEPS};
use crate::{Check, Claim, Decimal, Erratum, Evidence, Finding, Route, Verdict};

/// A claim with its derived verdict and what was found on the way.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The claim.
    pub claim: &'static Claim,
    /// The derived verdict.
    pub verdict: Verdict,
    /// The computed number in the printed unit, if the claim is one.
    pub computed: Option<f64>,
    /// The witness's number.
    pub witnessed: Option<f64>,
    /// What the source's own rounded intermediate results give.
    pub from_rounded: Option<f64>,
    /// How the printed form, its correction and its witness were found to hold or to fail.
    pub findings: Vec<(&'static str, Finding)>,
    /// What contradicts the record, beside a differing verdict. Empty if all is well.
    pub faults: Vec<String>,
}

impl Judged {
    /// Whether the claim stands as recorded: the verdict is the expected one and nothing contradicts it.
    pub fn holds(&self) -> bool {
        self.verdict == self.claim.expected && self.faults.is_empty()
    }

    /// What is wrong, a line each; empty if the claim holds.
    pub fn complaints(&self) -> Vec<String> {
        let mut lines = Vec::new();
        if self.verdict != self.claim.expected {
            lines.push(format!("recorded as {}, but found {}", self.claim.expected, self.verdict));
        }
        lines.extend(self.faults.iter().cloned());
        lines
    }
}

/// Derives the verdict on a claim.
pub fn judge(claim: &'static Claim) -> Judged {
    let mut judged = Judged {
        claim,
        verdict: Verdict::NotReproducible,
        computed: None,
        witnessed: None,
        from_rounded: None,
        findings: Vec::new(),
        faults: Vec::new(),
    };
    match &claim.check {
        Check::Number { computed, witness, from_rounded, resolution } => {
            judged.from_rounded = from_rounded.map(|run| run());
            number(&mut judged, computed, witness, *resolution);
        }
        Check::Form { printed, corrected, witness } => form(&mut judged, printed, *corrected, witness),
        Check::Missing { .. } => {}
    }
    match (&claim.erratum, judged.verdict.needs_erratum()) {
        (None, true) => judged.faults.push(format!("{} without an erratum", judged.verdict)),
        (Some(_), false) => judged.faults.push(format!("an erratum is on record, but the claim is {}", judged.verdict)),
        _ => {}
    }
    judged
}

fn number(judged: &mut Judged, computed: &Route<f64>, witness: &Route<f64>, resolution: Option<f64>) {
    let claim = judged.claim;
    let (value, witnessed) = ((computed.run)(), (witness.run)());
    (judged.computed, judged.witnessed) = (Some(value), Some(witnessed));
    let printed: Decimal = match claim.printed.parse() {
        Ok(printed) => printed,
        Err(unreadable) => {
            judged.verdict = Verdict::NotReproduced;
            judged.faults.push(unreadable.to_string());
            return;
        }
    };
    let correction = claim.erratum.as_ref().map(|erratum| correction_passes(erratum, value));
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
    if correction == Some(false) {
        judged.faults.push(format!("the correction is not what is computed, {value}"));
    }
    // Another printed number is known only to its digits; any other route must agree as far as arithmetic goes.
    let agrees = if witness.evidence == Evidence::OtherPlaceInSource {
        let right = claim.erratum.as_ref().and_then(|erratum| erratum.corrected.parse().ok()).unwrap_or(printed);
        right.is_rounding_of(witnessed)
    } else if witness.evidence == Evidence::Steps {
        STEPS.agrees(value, witnessed)
    } else {
        ROUTES.agrees(value, witnessed)
    };
    if !agrees {
        judged.faults.push(format!("the witness ({}) gives {witnessed}, not {value}", witness.evidence));
    }
}

fn correction_passes(erratum: &Erratum, value: f64) -> bool {
    erratum.corrected.parse::<Decimal>().is_ok_and(|corrected| corrected.is_rounding_of(value))
}

fn form(judged: &mut Judged, printed: &Route<Finding>, corrected: Option<fn() -> Finding>, witness: &Route<Finding>) {
    let (as_printed, correction, witnessed) = ((printed.run)(), corrected.map(|run| run()), (witness.run)());
    judged.verdict = match (as_printed.holds, correction.as_ref().map(|finding| finding.holds)) {
        (true, _) => Verdict::Reproduced,
        (false, Some(true)) => Verdict::Corrected,
        (false, _) => Verdict::NotReproduced,
    };
    if as_printed.holds && correction.is_some() {
        judged.faults.push("a correction is on record, but the printed form holds".to_owned());
    }
    if !witnessed.holds {
        judged.faults.push(format!("the witness ({}) disagrees: {}", witness.evidence, witnessed.how));
    }
    judged.findings.push(("as printed", as_printed));
    judged.findings.extend(correction.map(|finding| ("corrected", finding)));
    judged.findings.push(("witness", witnessed));
}

#[cfg(test)]
#[path = "judge_tests.rs"]
mod tests;
