//! Of the chapter on the solver: what it takes, from the record.

use super::{least, most};
use crate::measurements::{Measurement, integrators};
use anyhow::Context;
use geneva_evidence::{Numbers, OwnNumber, RECORD};

/// The numbers of the chapter.
pub(super) fn numbers() -> Vec<OwnNumber> {
    let recorded = |id, form: &'static str, run: fn() -> Numbers<f64>| OwnNumber::new(id, form, RECORD, run);
    vec![
        OwnNumber::count("solver.escapements", || Ok(each()?.1)),
        recorded("solver.steady-state", "{.0} µs", || Ok(each()?.0)),
        recorded("solver.missed-by", "{2}", || Ok(least(&missed()?))),
        recorded("solver.located.error.least", "{2}", || Ok(least(&located(error)?))),
        recorded("solver.located.error.most", "{2}", || Ok(most(&located(error)?))),
        recorded("solver.located.work.least", "{.1}", || Ok(1.0 / most(&located(evaluations)?))),
        recorded("solver.located.work.most", "{.1}", || Ok(1.0 / least(&located(evaluations)?))),
    ]
}

/// The library's methods, as written down at first.
const METHODS: [&str; 2] = ["dopri5", "dop853"];

fn error(of: &Measurement) -> Option<f64> {
    of.true_error
}

fn evaluations(of: &Measurement) -> Option<f64> {
    of.evaluations.map(|count| count as f64)
}

/// How many times larger than the tolerance the errors of the library's methods are, written down as at first.
fn missed() -> anyhow::Result<Vec<f64>> {
    let all = integrators()?.into_iter().filter(|one| METHODS.contains(&one.contestant.as_str()));
    all.map(|one| Ok(one.true_error.context("no error")? / one.tolerance.parse::<f64>()?)).collect()
}

/// What the library's methods have without located switches over what they have with them, at the same tolerances.
fn located(quantity: fn(&Measurement) -> Option<f64>) -> anyhow::Result<Vec<f64>> {
    let all = integrators()?;
    let of = |contestant: &str, tolerance: &str| {
        let found = all.iter().find(|one| one.contestant == contestant && one.tolerance == tolerance);
        found.and_then(quantity).with_context(|| format!("no {contestant} at {tolerance}"))
    };
    let plain = all.iter().filter(|one| METHODS.contains(&one.contestant.as_str()));
    let ratio = |one: &Measurement| {
        let with = of(&format!("{}-located", one.contestant), &one.tolerance)?;
        Ok(of(&one.contestant, &one.tolerance)? / with)
    };
    plain.map(ratio).collect()
}

/// Microseconds for the steady state of one escapement, and how many were found.
fn each() -> anyhow::Result<(f64, u32)> {
    let is_asked = |one: &Measurement| one.contestant == "angle-steady" && one.tolerance == "1e-10";
    let found = integrators()?.into_iter().find(is_asked).context("no such measurement in the record")?;
    let runs = found.runs.context("a measurement without runs")?;
    Ok((1e3 * found.milliseconds / f64::from(runs), runs))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_chapter_says_of_the_record_is_so() {
        let all = integrators().expect("read");
        let times = |of: &dyn Fn(&Measurement) -> bool| -> Vec<f64> {
            all.iter().filter(|one| one.runs.is_some() && of(one)).map(|one| one.milliseconds).collect()
        };
        let own = times(&|one| one.contestant == "angle-run");
        let others = times(&|one| !one.contestant.starts_with("angle"));
        assert!(most(&own) < least(&others), "at its finest faster than the others at their coarsest");
        assert!(most(&own) < 1.5 * least(&own), "more precision costs it little");
        // The least time for an error that is small enough.
        let time = |contestant: &str| {
            let fine =
                |one: &Measurement| one.contestant == contestant && one.true_error.is_some_and(|error| error < 1e-7);
            least(&times(&fine))
        };
        let methods = ["dopri5", "dop853", "dopri5-located", "dop853-located"];
        assert!(
            methods.iter().all(|method| time(method) < time("mimic")),
            "the program is the slowest at a high precision"
        );
    }
}
