//! What the routes of the statistics have to count, to take the least of, or to run in the second way.

use super::*;
use geneva_case1973::witness::{self, gauss_newton, steps};
use geneva_case1973::{Run, Score, rise_times};

/// The score of a hypothesis among those compared.
pub(super) fn score(hypothesis: Hypothesis) -> Option<&'static Score<'static>> {
    scores().iter().find(|score| score.hypothesis == hypothesis)
}

/// The score of the program as listed with its sign late by this part of a print interval.
pub fn lagged(part: f64) -> Option<&'static Score<'static>> {
    let found = delays().iter().find(|(delay, _)| (delay / listing().interval - part).abs() < 1e-9);
    found.map(|(_, score)| score)
}

/// How many results of these columns are no more than so many units off, by runs of these mechanisms of the second routes.
pub(super) fn count(
    mechanisms: &[Mechanism],
    columns: &[Column],
    units: f64,
    run: impl Fn(&Row) -> Option<Run>,
) -> Option<f64> {
    let mut count = 0;
    for row in rows().iter().filter(|row| mechanisms.contains(&row.mechanism)) {
        let run = run(row)?;
        let is_near = |column: &&Column| row.misfit(**column, run.number(**column)).abs() <= units + 1e-9;
        count += columns.iter().filter(is_near).count();
    }
    Some(count as f64)
}

/// A run with the exact sign on the integrator of the program, where the first route solves the motion over the angle.
pub(super) fn without_lag(row: &Row) -> Option<Run> {
    Hypothesis::WITHOUT_LAG.run_by_program(row, &row.given.listing.integrator())
}

pub(super) fn count_lagged(mechanisms: &[Mechanism], columns: &[Column], units: f64) -> Option<f64> {
    count(mechanisms, columns, units, witness::lagged_run)
}

/// How many results are near by the steady cycle in steps.
pub(super) fn count_cycles(
    hypothesis: Hypothesis,
    mechanisms: &[Mechanism],
    columns: &[Column],
    units: f64,
) -> Option<f64> {
    count(mechanisms, columns, units, |row| {
        let [minimum, period, peak] = steps::cycle_of_row(&hypothesis, row)?;
        Some(Run { peak, minimum, period, first_minimum: f64::NAN })
    })
}

pub(super) fn mean(counts: &[usize]) -> f64 {
    counts.iter().sum::<usize>() as f64 / counts.len() as f64
}

/// The count in the middle of all; none if there are none.
pub(super) fn middle(mut counts: Vec<usize>) -> Option<f64> {
    counts.sort_unstable();
    counts.get(counts.len() / 2).map(|count| *count as f64)
}

pub(super) fn least(all: impl IntoIterator<Item = f64>) -> Option<f64> {
    all.into_iter().min_by(f64::total_cmp)
}

pub(super) fn greatest(all: impl IntoIterator<Item = f64>) -> Option<f64> {
    all.into_iter().max_by(f64::total_cmp)
}

/// How many per cent of these counts are as great as the count of the mechanisms themselves.
pub(super) fn as_many(counts: Vec<usize>) -> Option<f64> {
    let found = score(Hypothesis::IDEAL)?.within_one_of(&OTHERS);
    Some(100.0 * counts.iter().filter(|count| **count >= found).count() as f64 / counts.len() as f64)
}

/// The least margin over all weighings of all rows, by densities.
pub(super) fn of_all_rows(others: Others) -> Option<f64> {
    let weighings = [Weighing::BY_COLUMN, Weighing::BY_TABLE, Weighing::COARSE];
    let margins = weighings.map(|weighing| densities::least_margin(&weighing, scores(), others));
    least(margins.into_iter().collect::<Option<Vec<_>>>()?)
}

/// The least margin if one row of each group counts, by densities.
pub(super) fn of_one_row_of_each(others: Others) -> Option<f64> {
    let margins =
        Weighing::one_row_of_each(rows()).map(|weighing| densities::least_margin(&weighing, scores(), others));
    least(margins.collect::<Option<Vec<_>>>()?)
}

/// The logarithms of the likelihood by each law, by densities.
pub(super) fn by_densities(score: &Score) -> Option<[f64; 2]> {
    let [normal, exponential] = Law::ALL.map(|law| densities::log_likelihood(&Weighing::BY_COLUMN, score, law));
    Some([normal?, exponential?])
}

/// The least margin, by either law, of the listed lag over a fifth of the print interval or more.
pub(super) fn over_a_fifth(logarithms: fn(&Score) -> Option<[f64; 2]>) -> Option<f64> {
    let listed = logarithms(lagged(0.1)?)?;
    let mut margins = Vec::new();
    for (_, later) in delays().iter().filter(|(delay, _)| *delay > 0.19 * listing().interval) {
        let later = logarithms(later)?;
        margins.extend([0, 1].map(|law| listed[law] - later[law]));
    }
    least(margins)
}

pub(super) fn freed(mechanism: Mechanism, reset: Reset) -> Option<f64> {
    Some(InertiaFit::new(rows_of(rows(), mechanism), reset)?.within_one() as f64)
}

pub(super) fn freed_in_steps(mechanism: Mechanism, reset: Reset) -> Option<f64> {
    within_one_in_steps(rows_of(rows(), mechanism), reset)
}

pub(super) fn within_one_in_steps(table: &[Row], reset: Reset) -> Option<f64> {
    let angle = Hypothesis { reset, ..Hypothesis::WITHOUT_LAG }.angle(table.first()?);
    let (_, misfits) = gauss_newton::inertias(table, angle)?;
    Some(misfits.iter().filter(|misfit| misfit.abs() <= 1.0 + 1e-9).count() as f64)
}

/// A friction that is as good as none: a hundredth of the printed one.
pub const LITTLE: f64 = 0.01;

pub(super) fn little_friction(mechanism: Mechanism) -> Option<f64> {
    let freed = InertiaFit::with_friction(rows_of(rows(), mechanism), Reset::OfTheMechanism, LITTLE)?;
    Some(freed.within_one() as f64)
}

/// The table with a hundredth of its frictions printed, by the second route.
pub(super) fn little_friction_in_steps(mechanism: Mechanism) -> Option<f64> {
    let changed = |row: &Row| {
        let friction = (LITTLE * row.friction()).to_string();
        let cell = |column| if column == Column::Friction { &friction } else { row.printed(column) };
        Row::read(mechanism, &Column::ALL.map(cell).join(" "), row.given).ok()
    };
    let table: Vec<Row> = rows_of(rows(), mechanism).iter().filter_map(changed).collect();
    within_one_in_steps(&table, Reset::OfTheMechanism)
}

/// How many rise times the best definition explains in each shuffle; dealt once.
pub fn shuffled(shuffled: ShuffleScope) -> &'static [usize] {
    static COUNTS: [OnceLock<Vec<usize>>; 2] = [const { OnceLock::new() }; 2];
    let own = usize::from(shuffled == ShuffleScope::AmongEqualTorques);
    let deal = || rise_times::shuffles_of_definitions(rows(), explained(), shuffled, SHUFFLES);
    COUNTS[own].get_or_init(deal)
}

/// The times of all definitions, of the runs and of the mechanisms.
pub(super) fn definitions() -> Vec<&'static [f64]> {
    explained().iter().flat_map(|tried| [&tried.as_run.times[..], &tried.ideal.times]).collect()
}
