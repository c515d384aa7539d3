//! The printed rows beside runs by second routes, and what the printed numbers say among themselves.

use geneva_case1973::witness::{lagged_run, run_with_lag};
use geneva_case1973::{Column, EXPLAINED, Hypothesis, Row, Run};
use geneva_documents::meyer::runs::table::rows;
use std::sync::OnceLock;

/// Peak, minimum and period of a row; none if a run comes to no end.
type RowResults = Option<[f64; 3]>;

/// In how many cells of these rows a column comes within one unit of the last printed place. A run that comes to no end is
/// near nothing.
pub(crate) fn count_near<'a>(rows: impl Iterator<Item = (&'a Row, RowResults)>, columns: &[Column]) -> usize {
    let is_near = |row: &Row, results: RowResults, column: Column| {
        let place = EXPLAINED.iter().position(|known| *known == column);
        let found = place.zip(results).map(|(place, results)| results[place]);
        found.is_some_and(|found| row.misfit(column, found).abs() <= 1.0 + 1e-9)
    };
    rows.map(|(row, results)| columns.iter().filter(|column| is_near(row, results, **column)).count()).sum()
}

/// The results of a run.
fn results_of_run(run: Run) -> [f64; 3] {
    [run.peak, run.minimum, run.period]
}

/// The rows, each as the program ran it, by Newton's laws.
pub(crate) fn rows_as_run() -> impl Iterator<Item = (&'static Row, RowResults)> {
    static RUNS: OnceLock<Vec<RowResults>> = OnceLock::new();
    let runs = RUNS.get_or_init(|| rows().iter().map(|row| lagged_run(row).map(results_of_run)).collect());
    rows().iter().zip(runs.iter().copied())
}

/// The rows with the sign late as it is listed, by Newton's laws, whatever else the hypothesis is.
pub(crate) fn rows_with_listed_lag(hypothesis: Hypothesis) -> impl Iterator<Item = (&'static Row, RowResults)> {
    rows().iter().map(move |row| {
        let listing = &row.given.listing;
        let run = |program| run_with_lag(&program, listing.delay, listing.interval, listing.duration);
        (row, hypothesis.program(row).and_then(run).map(results_of_run))
    })
}

/// The rows with the exact sign, on an integrator as the program's.
pub(crate) fn rows_on_the_integrator(hypothesis: Hypothesis) -> impl Iterator<Item = (&'static Row, RowResults)> {
    rows()
        .iter()
        .map(move |row| (row, hypothesis.run_by_program(row, &row.given.listing.integrator()).map(results_of_run)))
}

/// The rows as the mechanisms are, in equal steps of the crank.
pub(crate) fn rows_as_mechanisms() -> impl Iterator<Item = (&'static Row, RowResults)> {
    static RUNS: OnceLock<Vec<RowResults>> = OnceLock::new();
    let cycle = |row| geneva_case1973::witness::steps::cycle_of_row(&Hypothesis::IDEAL, row);
    let runs = RUNS.get_or_init(|| {
        rows().iter().map(|row| cycle(row).map(|[least, period, greatest]| [greatest, least, period])).collect()
    });
    rows().iter().zip(runs.iter().copied())
}

/// The printed rows, those with one mechanism and one friction together.
fn groups() -> Vec<Vec<&'static Row>> {
    let mut groups: Vec<Vec<&Row>> = Vec::new();
    for row in rows() {
        let is_own =
            |group: &&mut Vec<&Row>| group[0].mechanism == row.mechanism && group[0].friction() == row.friction();
        match groups.iter_mut().find(is_own) {
            Some(group) => group.push(row),
            None => groups.push(vec![row]),
        }
    }
    groups
}

/// How many groups have some number that each row allows from one end to another. Straight pieces have a point in common if each two
/// of them have.
fn groups_in_common(allowed: impl Fn(&Row) -> [f64; 2], misread: usize) -> usize {
    let meet = |a: &Row, b: &Row| allowed(a)[0] <= allowed(b)[1] && allowed(b)[0] <= allowed(a)[1];
    let all_meet = |group: &[&Row]| group.iter().all(|a| group.iter().all(|b| meet(a, b)));
    let but_for_one = |group: &[&Row]| {
        (0..group.len()).any(|left_out| {
            let others: Vec<&Row> =
                group.iter().enumerate().filter(|(at, _)| *at != left_out).map(|(_, row)| *row).collect();
            all_meet(&others)
        })
    };
    groups().iter().filter(|group| all_meet(group) || (misread > 0 && but_for_one(group))).count()
}

/// In how many groups the printed numbers of a column go as a power of the torque, each to one unit.
pub(crate) fn groups_obeying(column: Column, power: f64) -> usize {
    let scaled = |row: &Row, units: f64| (row.number(column) + units * column.unit()) / row.torque().powf(power);
    groups_in_common(|row| [scaled(row, -1.0), scaled(row, 1.0)], 0)
}

/// In how many groups one number, over the root of the torque, fits all rise times to a unit and a print interval, but for so
/// many rows (none or one).
pub(crate) fn groups_with_one_rise(misread: usize) -> usize {
    let scaled = |row: &Row, sign: f64| {
        let slack = Column::Rise.unit() + row.given.listing.interval;
        (row.number(Column::Rise) + sign * slack) * row.torque().sqrt()
    };
    groups_in_common(|row| [scaled(row, -1.0).max(0.0), scaled(row, 1.0)], misread)
}

/// Pairs of rows that differ in one column and the mechanism and other columns have alike, with none between them: how many, and
/// in how many the rise time is greater and the same in the row with more of that column.
pub(crate) fn rises_with_more(of: Column, alike: Column) -> [usize; 3] {
    let more = |a: &Row, b: &Row| {
        a.mechanism == b.mechanism && a.number(alike) == b.number(alike) && b.number(of) > a.number(of)
    };
    let mut counts = [0; 3];
    for a in rows() {
        for b in rows().iter().filter(|b| more(a, b)) {
            if rows().iter().any(|between| more(a, between) && more(between, b)) {
                continue;
            }
            let [before, after] = [a, b].map(|row| row.number(Column::Rise));
            counts[0] += 1;
            counts[1] += usize::from(after > before);
            counts[2] += usize::from(after == before);
        }
    }
    counts
}
