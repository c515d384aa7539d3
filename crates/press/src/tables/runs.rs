//! What explains the printed tables of the thesis's runs, and what does not matter to them.

use super::signed;
use crate::html::{Cells, table};
use anyhow::Context;
use geneva_ledger::meyer::runs::{
    Constants, Fit, Fold, Hypothesis, Reading, Score, SixPin, delays as all_delays, integrator as integrators, scores,
};

/// The hypotheses, how many cells each explains, and how likely it makes the tables.
pub fn hypotheses() -> anyhow::Result<String> {
    let rows: Vec<Vec<String>> = scores()
        .iter()
        .enumerate()
        .map(|(at, score)| {
            let mut row = vec![format!("{}: {}", at + 1, words(&score.hypothesis)), score.within_one().to_string()];
            row.extend(logs(score));
            for fit in &score.fits {
                row.extend([counts(fit), signed(100.0 * fit.mean, 1), signed(100.0 * fit.worst, 1)]);
            }
            row
        })
        .collect();
    let head = [
        "Hypothesis",
        "of 147",
        "ln L, normal",
        "exponential",
        "Peak",
        "mean %",
        "worst %",
        "Minimum",
        "mean %",
        "worst %",
        "Period",
        "mean %",
        "worst %",
    ];
    Ok(table("Hypotheses about the runs", Cells::NamedNumbers, &head, &rows))
}

/// Delays of the sign of the friction.
pub fn delays() -> anyhow::Result<String> {
    let rows: Vec<Vec<String>> = all_delays()
        .iter()
        .map(|(delay, score)| {
            let [peak, minimum, period] = &score.fits;
            let [normal, _] = peak.likelihoods;
            let name = if *delay > 0.0 { format!("{:.3} ms", 1e3 * delay) } else { "none".to_owned() };
            let mut row = vec![name];
            row.extend(logs(score));
            row.extend([counts(peak), signed(100.0 * peak.mean, 2), signed(100.0 * peak.worst, 1)]);
            row.extend([format!("{:.2}", normal.spread), counts(minimum), counts(period)]);
            row
        })
        .collect();
    let head =
        ["Delay", "ln L, normal", "exponential", "Peak", "mean %", "worst %", "spread, rad/s", "Minimum", "Period"];
    Ok(table("Delays of the sign of the friction", Cells::NamedNumbers, &head, &rows))
}

/// What changes when the integrator is told otherwise what the thesis does not tell.
pub fn integrator() -> anyhow::Result<String> {
    let changes = integrators::changes().context("a run of the program of 1973 comes to no end")?;
    let rows: Vec<Vec<String>> = changes
        .iter()
        .map(|(variant, changes)| {
            let mut row = vec![variant.name.to_owned()];
            for change in changes {
                row.extend(change.most.map(|most| format!("{:.1}", 1e6 * most)));
                row.push(change.printed_otherwise.to_string());
            }
            row
        })
        .collect();
    let head = [
        "Changed",
        "peak, ppm",
        "minimum, ppm",
        "period, ppm",
        "digits",
        "late sign: peak, ppm",
        "minimum, ppm",
        "period, ppm",
        "digits",
    ];
    Ok(table("Parameters of the integrator that are not recorded", Cells::NamedNumbers, &head, &rows))
}

/// Cells to the printed digit, and within one unit.
fn counts(fit: &Fit) -> String {
    format!("{} / {}", fit.exact, fit.within_one)
}

fn logs(score: &Score) -> [String; 2] {
    score.likelihoods().map(|log| signed(log, 1))
}

fn words(hypothesis: &Hypothesis) -> String {
    let fold = match hypothesis.fold {
        Fold::OfTheMechanism => "angle put back after 360°/m",
        Fold::OneForAll => "after 90° for all",
    };
    let inertias = match hypothesis.six_pin {
        SixPin::AsHeaded => "six-pin inertias as headed",
        SixPin::AsDrawn => "as in Fig. 11",
    };
    let reading = match hypothesis.reading {
        Reading::True => "true peaks",
        Reading::OnTheGrid => "largest printed speed",
    };
    let constants = if hypothesis.constants == Constants::AsListed { "; constants as listed" } else { "" };
    let sign = if hypothesis.delay.is_some() { "; sign by the old acceleration" } else { "" };
    format!("{fold}; {inertias}; {reading}{constants}{sign}")
}
