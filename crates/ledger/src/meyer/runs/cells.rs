//! The claims of the tables: one for each printed result of a run.
//!
//! What a cell claims is what the computer gave: the summary is one of runs. So the computed number is the run's, with
//! the fold of the program and the inertias that fit, and the resolution is one unit of the last place: somebody read
//! the number from a print-out with lines a print interval apart. What the mechanism does is another table.

use super::*;
use crate::{Entry, Line, Route};
use geneva_dynamics::steady::SteadyState;
use std::sync::OnceLock;

/// The four results of a row.
const RESULTS: [(Column, &str, &str, &str); 4] = [
    (Column::Peak, "max", "greatest speed of the driver in the run", "rad/sec"),
    (Column::Minimum, "min", "least speed of the driver in the run's steady cycle", "rad/sec"),
    (Column::Period, "period", "time between two peaks of the run", "sec"),
    (Column::Rise, "rise", "rise time of the run", "sec"),
];

/// Both routes to peak, minimum and period of a row.
type Routes = [(fn() -> f64, fn() -> f64); 3];

/// The routes of each row: a claim's routes are plain functions, so each row has its own.
macro_rules! routes {
    ($($at:literal)*) => {
        [$([
            (peak::<$at>, peak_by_steps::<$at>),
            (minimum::<$at>, minimum_by_steps::<$at>),
            (period::<$at>, period_by_steps::<$at>),
        ]),*]
    };
}

const ROUTES: [Routes; 49] = routes! {
    0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40 41
    42 43 44 45 46 47 48
};

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
            ["max", "min", "rise", "period"].map(|name| Entry::Claim(leaked(format!("meyer.app-e.{slug}.{name}"))));
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

fn of_row(row: &'static Row, routes: Routes) -> Vec<Claim> {
    let slug = row.slug();
    let place = leaked(format!(
        "Appendix E, {}-pin mechanism, μ = {}, K = {}",
        row.mechanism.pins(),
        row.printed(Column::Friction),
        row.printed(Column::Torque)
    ));
    let mut routes = routes.into_iter();
    RESULTS
        .into_iter()
        .map(|(column, name, meaning, unit)| {
            let id = leaked(format!("meyer.app-e.{slug}.{name}"));
            let check = match routes.next().filter(|_| column != Column::Rise) {
                Some((computed, witness)) => Check::Number {
                    computed: Route { evidence: Evidence::Integration, run: computed },
                    witness: Route { evidence: Evidence::Steps, run: witness },
                    from_rounded: None,
                    resolution: resolution(column),
                    right: None,
                },
                None => Check::Missing { reason: NO_DEFINITION },
            };
            let claim = Claim::value(WORK, id, place, meaning, (row.printed(column), unit), check);
            claim.expecting(record::verdict(row, column))
        })
        .collect()
}

/// Why no rise time can be computed.
const NO_DEFINITION: &str = "What the rise time is a time to is not said in a way that gives the column: the two places \
                             that define it disagree, and no definition by the motion itself gives it";

/// How finely a result could be read: one unit of its last place. A rise time has no definition to be read by.
fn resolution(column: Column) -> Option<f64> {
    match column {
        Column::Peak | Column::Minimum => Some(1.0),
        Column::Period => Some(1e-3),
        _ => None,
    }
}

fn steady(at: usize) -> Option<&'static SteadyState> {
    static STEADY: OnceLock<Vec<Option<SteadyState>>> = OnceLock::new();
    let of = |row: &Row| Hypothesis::BEST.engagement(row)?.steady_state().ok();
    STEADY.get_or_init(|| rows().iter().map(of).collect()).get(at)?.as_ref()
}

fn peak<const AT: usize>() -> f64 {
    Hypothesis::BEST.run(&rows()[AT]).map_or(f64::NAN, |run| run.peak)
}

fn peak_by_steps<const AT: usize>() -> f64 {
    Hypothesis::BEST.peak_by_steps(&rows()[AT]).unwrap_or(f64::NAN)
}

fn minimum<const AT: usize>() -> f64 {
    steady(AT).map_or(f64::NAN, |steady| steady.minimum.speed)
}

fn minimum_by_steps<const AT: usize>() -> f64 {
    let row = &rows()[AT];
    let least = Hypothesis::BEST.cycle_by_steps(row).map_or(f64::NAN, |[least, _]| least);
    least * motion::unit_of_speed(&Hypothesis::BEST, row)
}

fn period<const AT: usize>() -> f64 {
    steady(AT).map_or(f64::NAN, |steady| steady.period)
}

fn period_by_steps<const AT: usize>() -> f64 {
    let row = &rows()[AT];
    let time = Hypothesis::BEST.cycle_by_steps(row).map_or(f64::NAN, |[_, time]| time);
    time / motion::unit_of_speed(&Hypothesis::BEST, row)
}
