//! The claims of the tables: one for each printed number of a run. Its data are claims of `data`, its results these.
//!
//! Two questions are asked of a cell. What the computer gave: the summary is one of runs, so the computed number is the
//! run's, under one hypothesis for all cells ([`Hypothesis::AS_RUN`]), and the resolution is one unit of the last
//! place, for somebody read the number from a print-out. And what is right: the mechanism's own number stands beside it.

use super::cache::{CachedResults, cached_result};
use super::table::{expected, rows};
use super::{data, headings};
use crate::meyer::at;
use crate::meyer::slips::{RESET_ANGLE, SAMPLED_PEAKS, UNEXPLAINED};
use geneva_case1973::witness::{self, steps::cycle_of_row};
use geneva_case1973::{Column, Hypothesis, Row, Run};
use geneva_evidence::{Claim, Verdict, intern};
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

/// The four results of a row: column, the end of the claim's id (`meyer.app-e.6-pin.mu-0.20.k-0.03.max`), meaning and unit.
const RESULTS: [(Column, &str, &str, &str); 4] = [
    (Column::Peak, "max", "greatest speed of the driver in the run", "rad/sec"),
    (Column::Minimum, "min", "least speed of the driver in the run's steady cycle", "rad/sec"),
    (Column::Rise, "rise", "rise time of the run, from rest to its terminal velocity", "sec"),
    (Column::Period, "period", "time between two peaks of the run", "sec"),
];

/// The claims of all rows of a mechanism, after the claims of its heading.
pub(crate) fn claims() -> Vec<Claim> {
    let of_table = |mechanism| {
        let own = rows().iter().filter(move |row| row.mechanism == mechanism);
        headings::claims(mechanism).into_iter().chain(own.flat_map(of_row))
    };
    Mechanism::ALL.into_iter().flat_map(of_table).collect()
}

fn of_row(row: &'static Row) -> Vec<Claim> {
    let slug = row.slug();
    let place = at(intern(format!(
        "Appendix E, {}-pin mechanism, μ = {}, K = {}",
        row.mechanism.pins(),
        row.printed(Column::Friction),
        row.printed(Column::Torque)
    )));
    let of = |(result, (column, name, meaning, unit)): (usize, (Column, &str, _, _))| {
        let id = intern(format!("meyer.app-e.{slug}.{name}"));
        let printed_there = place.value(id, row.printed(column), unit, meaning);
        if column == Column::Rise {
            return printed_there.missing(NO_DEFINITION);
        }
        let claim = printed_there
            .first_route(crate::evidence::PROGRAM, move || as_run(row)[result])
            .second_route(crate::evidence::RUNGE_KUTTA, move || as_run_by_steps(row)[result])
            // How finely a result could be read from a print-out: one unit of its last place.
            .with_resolution(move || column.unit())
            .interpreted_as(
                "We assume that the author read the value from a print-out to within one unit of its last place.",
            )
            .expecting(expected(row, column).unwrap_or(Verdict::Reproduced));
        let claim = claim.right(
            crate::evidence::QUADRATURE,
            move || ideal(row)[result],
            crate::evidence::RUNGE_KUTTA,
            move || ideal_by_steps(row)[result],
        );
        match row.mechanism {
            _ if claim.expected == Verdict::Corrected => claim.affected_by(UNEXPLAINED),
            _ if claim.expected != Verdict::ReproducedInError => claim,
            // With four pins the reset is right; what is not is a peak between two lines of the print-out.
            Mechanism::FOUR_PIN => claim.in_error(SAMPLED_PEAKS),
            _ => claim.in_error(RESET_ANGLE),
        }
    };
    data::claims(row, place).into_iter().chain(RESULTS.into_iter().enumerate().map(of)).collect()
}

/// Why a rise time cannot be checked.
const NO_DEFINITION: &str = "The rise lasts until the terminal velocity is reached to within one per cent. But the \
                             thesis does not say which velocity is meant, or at which instant of an engagement the \
                             rise ends. (For one run, it says that the rise ends by the first minimum.) For example, you get one rise time if the velocity at each angle is meant, and \
                             another if the average of peak and minimum is meant. No definition that we tried \
                             reproduces even half of the 49 rise times";

fn results(run: Run) -> [f64; 4] {
    RESULTS.map(|(column, ..)| run.number(column))
}

fn as_run(row: &Row) -> [f64; 4] {
    static RUNS: CachedResults<4> = OnceLock::new();
    cached_result(&RUNS, row, |row| Hypothesis::AS_RUN.run(row).map(results))
}

fn as_run_by_steps(row: &Row) -> [f64; 4] {
    static RUNS: CachedResults<4> = OnceLock::new();
    cached_result(&RUNS, row, |row| witness::lagged_run(row).map(results))
}

fn ideal(row: &Row) -> [f64; 4] {
    static RUNS: CachedResults<4> = OnceLock::new();
    cached_result(&RUNS, row, |row| Hypothesis::IDEAL.run(row).map(results))
}

fn ideal_by_steps(row: &Row) -> [f64; 4] {
    static RUNS: CachedResults<4> = OnceLock::new();
    cached_result(&RUNS, row, |row| {
        let [least, time, greatest] = cycle_of_row(&Hypothesis::IDEAL, row)?;
        Some([greatest, least, f64::NAN, time])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn program_and_mechanism_are_as_far_above_the_unexplained_peaks_as_their_slip_says() {
        let unexplained = rows().iter().filter(|row| expected(row, Column::Peak) == Some(Verdict::Corrected));
        let above = unexplained.map(|row| [as_run(row)[0], ideal(row)[0]].map(|peak| peak - row.number(Column::Peak)));
        let above: Vec<[f64; 2]> = above.collect();
        assert_eq!(above.len(), 2);
        let units = above.iter().map(|peaks| peaks.map(|above| above / Column::Peak.unit()));
        assert!(units.clone().all(|[program, mechanism]| program > 1.5 && mechanism > 2.5), "{above:?}");
        // They do not agree with each other either, and not all of them differ by more than two units.
        assert!(units.clone().all(|[program, mechanism]| (program - mechanism).abs() > 0.5), "{above:?}");
        assert!(units.clone().any(|[program, _]| program < 2.0), "{above:?}");
    }
}
