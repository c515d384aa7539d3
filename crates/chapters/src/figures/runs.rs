//! The figures of the runs of the thesis and of the steady motion.

use super::designs;
use crate::printed_cells::{self, PrintedCell};
use crate::rows::{self, NONE, number, weakest};
use anyhow::Context;
use geneva_case1973::{
    Column, EXPLAINED, Hypothesis, PeakReading, Reset, Row, Score, rows_of, rows_with_least_friction,
};
use geneva_documents::meyer::runs::choice::{comparable, of_fig_8 as rows_of_fig_8};
use geneva_documents::meyer::runs::study::{delays, scores};
use geneva_documents::meyer::runs::table::{listing, rows};
use geneva_figures::runs::{self, ComparedCells, Count, LagLikelihood, MechanismRuns, Scan};
use geneva_figures::steady;
use geneva_figures::{Figure, Series};
use geneva_kinematics::Mechanism;
use geneva_press::numbers::fixed;

/// Printed against computed numbers of all cells: of the mechanisms as they are, and of the program as listed.
pub(super) fn agreement() -> anyhow::Result<Figure> {
    let of = |hypothesis: &Hypothesis, name: &str| {
        Ok::<_, anyhow::Error>(ComparedCells::new(name.to_owned(), rows::score(hypothesis)?))
    };
    let compared =
        [of(&Hypothesis::IDEAL, "real mechanisms")?, of(&Hypothesis::AS_RUN, "the program with its mistake")?];
    let inertias = Mechanism::ALL.into_iter().filter_map(|mechanism| rows_of(rows(), mechanism).first()).map(|row| {
        let [driver, follower] = Hypothesis::WITHOUT_LAG.inertias(row).map(|inertia| fixed(1e6 * inertia, 0));
        format!("{driver} and {follower} with {} pins", row.mechanism.pins())
    });
    let says = format!(
        "Inertias of driver and follower: {} (10⁻⁶ in lb s²); frictions and torques as in the tables.",
        inertias.collect::<Vec<_>>().join(", ")
    );
    let cells = printed_cells::of_rows(rows())?;
    let series = Series::new([("as_run", ""), ("right", "")], cells.iter().map(|cell| [cell.as_run, cell.right]));
    let [words @ .., _, _] = printed_cells::HEADS;
    let series = series.to_decimals(6).with_words(words, cells.iter().map(PrintedCell::words));
    Ok(runs::agreement(&compared, series, "1 rad/s or 1 ms", &says))
}

/// Printed against computed numbers of the mechanisms as they are.
pub(super) fn own_angles() -> anyhow::Result<Figure> {
    one_agreement("agreement-own-angles", "own reset angles", &Hypothesis::IDEAL)
}

/// Printed against computed numbers of the program as listed.
pub(super) fn quarter_turn() -> anyhow::Result<Figure> {
    one_agreement("agreement-quarter-turn", "reset after 90° for all", &Hypothesis::AS_RUN)
}

fn one_agreement(figure: &str, name: &str, hypothesis: &Hypothesis) -> anyhow::Result<Figure> {
    let compared = ComparedCells::new(name.to_owned(), rows::score(hypothesis)?);
    Ok(runs::one_agreement(figure, &compared, "1 rad/s or 1 ms"))
}

/// How many of a mechanism's numbers come out, over the reset angle: where the pins of neither fit the program.
pub(super) fn reset_angle() -> anyhow::Result<Figure> {
    /// From half the angle between the pins of three, in half degrees.
    const HALF_DEGREES: std::ops::RangeInclusive<u32> = 120..=240;
    let scan = |mechanism| {
        let rows = rows_of(rows(), mechanism);
        let count = |half_degrees: u32| {
            let angle = f64::from(half_degrees) / 2.0;
            let reset = Reset::After(angle.to_radians());
            let of = Hypothesis { reset, reading: PeakReading::True, ..Hypothesis::WITHOUT_LAG };
            (angle, rows.iter().map(|row| of.results(row).map_or(0, |results| row.explained_by(&results))).sum())
        };
        Scan { mechanism, cells: EXPLAINED.len() * rows.len(), counts: HALF_DEGREES.map(count).collect() }
    };
    Ok(runs::reset_angle(&[scan(Mechanism::SIX_PIN), scan(Mechanism::THREE_PIN)]))
}

/// What each of the compared hypotheses makes of the rows.
pub(super) fn hypotheses() -> anyhow::Result<Figure> {
    let named = |score: &Score| ComparedCells::new(score.hypothesis.brief_words(), score);
    Ok(runs::deviations(&scores().iter().map(named).collect::<Vec<_>>()))
}

/// How many cells of each column each of the compared hypotheses gives.
pub(super) fn columns() -> anyhow::Result<Figure> {
    let count = |score: &Score| score.fits.each_ref().map(|fit| Count { exact: fit.exact, within_one: fit.within_one });
    Ok(runs::columns(&scores().iter().map(count).collect::<Vec<_>>(), rows().len()))
}

/// How likely the tables are, over the lag of the friction's sign.
pub(super) fn lags() -> anyhow::Result<Figure> {
    const MILLISECONDS: f64 = 1e3;
    let lag = |(lag, score): &(f64, Score)| LagLikelihood {
        lag: MILLISECONDS * lag,
        likelihoods: score.likelihoods(),
        peaks: score.fits[0].within_one,
    };
    let all: Vec<LagLikelihood> = delays().iter().map(lag).collect();
    Ok(runs::lags(&all, MILLISECONDS * listing().delay, rows().len()))
}

/// The speed between the printed instants: of the four-pin runs that brake least the one with the strongest spring.
pub(super) fn printed_too_seldom() -> anyhow::Result<Figure> {
    let row = rows_with_least_friction(rows(), Mechanism::FOUR_PIN)
        .and_then(<[Row]>::last)
        .context("no run with four pins")?;
    let listing = listing();
    Ok(runs::aliasing(&Hypothesis::WITHOUT_LAG.engagement(row).context(NONE)?, listing.interval, listing.duration)?)
}

/// Fig. 8: the first of the rows that it may show.
pub(super) fn of_fig_8() -> anyhow::Result<Figure> {
    let named = |row: &Row| format!("μ = {}, K = {}", row.printed(Column::Friction), row.printed(Column::Torque));
    let fitting = rows_of_fig_8().context("no rise time of Fig. 8")?;
    let (row, others) = fitting.split_first().context("no run has the printed rise time")?;
    let others: Vec<String> = others.iter().map(|row| named(row)).collect();
    let fits = match others.join(" and with ") {
        with if with.is_empty() => String::new(),
        with => format!(" The time of the first minimum with {with} rounds to it, too."),
    };
    let [driver, follower] = Hypothesis::WITHOUT_LAG.inertias(row).map(|inertia| fixed(1e6 * inertia, 0));
    let inertias = format!("inertias of driver and follower {driver} and {follower} · 10⁻⁶ in lb s²");
    let words = format!(
        "Four pins, {}, {inertias}. The time of this run's first minimum rounds to the rise time printed for Fig. \
         8.{fits}",
        named(row)
    );
    Ok(runs::speeds(&Hypothesis::WITHOUT_LAG.engagement(row).context(NONE)?, &words)?)
}

/// The printed numbers of a mechanism over the torque.
pub(super) fn over_torque(mechanism: Mechanism) -> anyhow::Result<Figure> {
    Ok(runs::over_torque(&group(mechanism)?)?)
}

/// All runs on one curve.
pub(super) fn collapse() -> anyhow::Result<Figure> {
    let groups = Mechanism::ALL.into_iter().map(group).collect::<anyhow::Result<Vec<_>>>()?;
    Ok(steady::collapse(&groups)?)
}

/// A mechanism's rows, with the reset angle and the inertias that explain the tables.
fn group(mechanism: Mechanism) -> anyhow::Result<MechanismRuns> {
    MechanismRuns::from_rows(&Hypothesis::WITHOUT_LAG, rows_of(rows(), mechanism)).context(NONE)
}

/// The return map of the three-pin run that brakes least: an engagement leaves more of a difference than with four pins, so
/// that the steps to the steady state can be seen.
pub(super) fn return_map() -> anyhow::Result<Figure> {
    let row = weakest(rows_with_least_friction(rows(), Mechanism::THREE_PIN))?;
    Ok(steady::return_map(&Hypothesis::IDEAL.parameters(row).context(NONE)?)?)
}

/// The speed over the angle of that run, from rest.
pub(super) fn phase() -> anyhow::Result<Figure> {
    let row = weakest(rows_with_least_friction(rows(), Mechanism::THREE_PIN))?;
    Ok(steady::phase(&Hypothesis::IDEAL.parameters(row).context(NONE)?)?)
}

/// The map of a mechanism, with its runs.
pub(super) fn map(mechanism: Mechanism) -> anyhow::Result<Figure> {
    Ok(steady::map(mechanism, &designs()?)?)
}

/// Accelerations and pin force over an engagement: of the four-pin runs that brake least the one with the strongest spring.
pub(super) fn accelerations() -> anyhow::Result<Figure> {
    let row = rows_with_least_friction(rows(), Mechanism::FOUR_PIN)
        .and_then(<[Row]>::last)
        .context("no run with four pins")?;
    let run = format!(
        "four pins, μ = {}, K = {} in lb, inertias as in the runs of the thesis",
        row.printed(Column::Friction),
        row.printed(Column::Torque)
    );
    Ok(steady::accelerations(&Hypothesis::IDEAL.parameters(row).context(NONE)?, &run)?)
}

/// A pin of finite radius in its slot, four pins: while it drives the follower, and where the driver is fastest.
pub(super) fn contact() -> anyhow::Result<Figure> {
    /// Radius of the pin in crank radii.
    const PIN: f64 = 0.1;
    let row = weakest(comparable(Mechanism::FOUR_PIN))?;
    Ok(steady::contact(&Hypothesis::IDEAL.parameters(row).context(NONE)?, PIN)?)
}

/// Mean speed and multiplier over the radius of the pin, of the driver's journal, and of the follower's.
pub(super) fn losses() -> anyhow::Result<Figure> {
    /// Friction of the journals.
    const BEARINGS: f64 = 0.2;
    let row = weakest(comparable(Mechanism::FOUR_PIN))?;
    let shown = format!(
        "four pins, μ = {} in the slot, {BEARINGS} in the bearings, inertias as in the runs of the thesis",
        number(row, "friction")?
    );
    Ok(steady::losses(&Hypothesis::IDEAL.parameters(row).context(NONE)?, BEARINGS, &shown)?)
}
