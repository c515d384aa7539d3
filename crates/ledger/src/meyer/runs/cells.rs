//! The claims of the tables: one for each printed result of a run.
//!
//! Two questions are asked of a cell. What the computer gave: the summary is one of runs, so the computed number is the
//! run's, under one hypothesis for all cells ([`Hypothesis::as_run`]), and the resolution is one unit of the last
//! place, for somebody read the number from a print-out. And what is right: the mechanism's own number stands beside it.

use super::*;
use crate::meyer::slips::{RESET_ANGLE, SAMPLED_PEAKS};
use crate::{Entry, Line, Route};
use std::sync::OnceLock;

/// The four results of a row.
const RESULTS: [(Column, &str, &str, &str); 4] = [
    (Column::Peak, "max", "greatest speed of the driver in the run, as printed", "rad/sec"),
    (Column::Minimum, "min", "least speed of the driver in the run's steady cycle", "rad/sec"),
    (Column::Rise, "rise", "rise time of the run, as the text has it: the time of the first minimum", "sec"),
    (Column::Period, "period", "time between two peaks of the run", "sec"),
];

/// What was run, by the program and in steps; the mechanism as it is, over the angle and in steps.
type Routes = [fn() -> f64; 4];

/// The routes of each row to each result: a claim's routes are plain functions, so each has its own.
macro_rules! routes {
    ($($at:literal)*) => {
        [$([of::<$at, 0>(), of::<$at, 1>(), of::<$at, 2>(), of::<$at, 3>()]),*]
    };
}

const ROUTES: [[Routes; 4]; 49] = routes! {
    0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40 41
    42 43 44 45 46 47 48
};

const fn of<const AT: usize, const RESULT: usize>() -> Routes {
    [as_run::<AT, RESULT>, as_run_by_steps::<AT, RESULT>, ideal::<AT, RESULT>, ideal_by_steps::<AT, RESULT>]
}

/// The claims of all rows of a mechanism, after those of its heading.
pub fn claims() -> Vec<Claim> {
    let rows = rows().iter().zip(ROUTES).collect::<Vec<_>>();
    Mechanism::ALL
        .into_iter()
        .flat_map(|mechanism| {
            let own = rows.iter().filter(move |(row, _)| row.mechanism == mechanism);
            headings::claims(mechanism).into_iter().chain(own.flat_map(|(row, routes)| of_row(row, *routes)))
        })
        .collect()
}

/// The row's lines of the inventory, with its parameters as data.
pub fn lines() -> Vec<Line> {
    let mut lines = headings::lines();
    lines.extend(rows().iter().map(|row| {
        let slug = row.slug();
        let data = Entry::Exception {
            id: leaked(format!("meyer.app-e.{slug}.parameters")),
            numbers: leaked(format!("{} {}", row.printed(Column::Friction), row.printed(Column::Torque))),
            reason: "friction and torque of the run: data, from which the results are computed",
        };
        let results =
            RESULTS.map(|(_, name, ..)| name).map(|name| Entry::Claim(leaked(format!("meyer.app-e.{slug}.{name}"))));
        let entries: Vec<_> = std::iter::once(data).chain(results).collect();
        let fingerprint = record::fingerprint(row.line);
        Line { number: row.line, fingerprint, entries: entries.leak() }
    }));
    lines.sort_by_key(|line| line.number);
    lines
}

/// Text that lives as long as the ledger, which is built once.
pub fn leaked(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

fn of_row(row: &'static Row, routes: [Routes; 4]) -> Vec<Claim> {
    let slug = row.slug();
    let place = leaked(format!(
        "Appendix E, {}-pin mechanism, μ = {}, K = {}",
        row.mechanism.pins(),
        row.printed(Column::Friction),
        row.printed(Column::Torque)
    ));
    let of = |((column, name, meaning, unit), [run, run_again, ideal, ideal_again]): (_, Routes)| {
        let id = leaked(format!("meyer.app-e.{slug}.{name}"));
        // How finely a result could be read from a print-out: one unit of its last place, and for a time at which
        // something happens a print interval besides.
        let check = Check::Number {
            computed: Route { evidence: Evidence::Program, run },
            witness: Route { evidence: Evidence::Steps, run: run_again },
            from_rounded: None,
            resolution: Some(match column {
                Column::Rise => || scores::unit(Column::Rise) + interval(),
                Column::Period => || scores::unit(Column::Period),
                _ => || scores::unit(Column::Peak),
            }),
            right: (column != Column::Rise).then_some([
                Route { evidence: Evidence::Integration, run: ideal },
                Route { evidence: Evidence::Steps, run: ideal_again },
            ]),
        };
        let claim = Claim::value(WORK, id, place, meaning, (row.printed(column), unit), check);
        let claim = claim.read_as(reading(column)).expecting(record::verdict(row, column));
        match (row.mechanism, column) {
            (_, Column::Rise) if claim.expected == Verdict::Corrected => claim.with_erratum(MISREAD_RISE),
            (_, Column::Rise) => claim,
            _ if claim.expected != Verdict::ReproducedInError => claim,
            // With four pins the reset is right; what is not is a peak between two lines of the print-out.
            (Mechanism::FourPin, _) => claim.affected_by(SAMPLED_PEAKS),
            _ => claim.affected_by(RESET_ANGLE),
        }
    };
    RESULTS.into_iter().zip(routes).map(of).collect()
}

/// How finely a cell was read.
fn reading(column: Column) -> &'static str {
    match column {
        Column::Rise => {
            "The first minimum of the speed, as the text has it; read from a print-out to a unit of the last place and a \
             print interval."
        }
        _ => "Read from a print-out to a unit of the last place.",
    }
}

/// A digit of the last rise time of four pins.
const MISREAD_RISE: Erratum = Erratum {
    corrected: ".018",
    slip: Slip {
        id: "",
        reason: "With this friction the other four rise times are those of the first minimum, to the resolution of their \
                 reading. A time of the motion goes as the inverse root of K, and so would this row have to be faster \
                 than the others, not as slow as the slowest. Whether the copy or the source has the other digit cannot \
                 be told.",
        witness: "The first minimum of the run, from Newton's laws in steps of time.",
        origin: Origin::Misprint,
        consequence: Consequence::Result,
        changes: "The strongest spring has the shortest rise, as it must.",
    },
};

/// The runs of all rows, each made once.
type Runs = OnceLock<Vec<Option<[f64; 4]>>>;

/// The result of a row among those of all.
fn result(at: usize, result: usize, all: &'static Runs, of: fn(&Row) -> Option<[f64; 4]>) -> f64 {
    let found = all.get_or_init(|| rows().iter().map(of).collect()).get(at).copied().flatten();
    found.map_or(f64::NAN, |found| found[result])
}

fn as_run<const AT: usize, const RESULT: usize>() -> f64 {
    static RUNS: Runs = OnceLock::new();
    result(AT, RESULT, &RUNS, |row| {
        let run = Hypothesis::as_run().run(row)?;
        Some(RESULTS.map(|(column, ..)| run.number(column)))
    })
}

fn as_run_by_steps<const AT: usize, const RESULT: usize>() -> f64 {
    static RUNS: Runs = OnceLock::new();
    result(AT, RESULT, &RUNS, |row| {
        let run = Lagged::of(row)?;
        Some([run.peak, run.minimum, run.first_minimum, run.period])
    })
}

fn ideal<const AT: usize, const RESULT: usize>() -> f64 {
    static RUNS: Runs = OnceLock::new();
    result(AT, RESULT, &RUNS, |row| {
        let run = Hypothesis::TRUE.run(row)?;
        Some(RESULTS.map(|(column, ..)| run.number(column)))
    })
}

fn ideal_by_steps<const AT: usize, const RESULT: usize>() -> f64 {
    static RUNS: Runs = OnceLock::new();
    result(AT, RESULT, &RUNS, |row| {
        let [least, time, greatest] = Hypothesis::TRUE.cycle_by_steps(row)?;
        let unit = motion::unit_of_speed(&Hypothesis::TRUE, row);
        Some([greatest * unit, least * unit, f64::NAN, time / unit])
    })
}
