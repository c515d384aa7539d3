//! Whether the tables depend on what is not known of the integrator of 1973.

use crate::hypothesis::{Hypothesis, Lag};
use crate::{EXPLAINED, Row, Run};
use geneva_mimic::{SolverParameters as Integrator, StepSolution};

/// One parameter of the integrator, set to something other than its default.
pub struct Variant {
    /// The variant in words.
    pub name: &'static str,
    change: fn(Integrator) -> Integrator,
}

/// The variants. The print interval, the length of the run and the relative error are the thesis's own.
pub const VARIANTS: [Variant; 9] = [
    Variant { name: "the full step is kept", change: |by| Integrator { kept: StepSolution::FullStep, ..by } },
    Variant {
        name: "the two half steps, extrapolated, are kept",
        change: |by| Integrator { kept: StepSolution::Extrapolated, ..by },
    },
    Variant {
        name: "no floor below which errors are absolute",
        change: |by| Integrator { absolute_floor: 1e-9, ..by },
    },
    Variant { name: "a floor of one", change: |by| Integrator { absolute_floor: 1.0, ..by } },
    Variant { name: "steps grow whenever they are accepted", change: |by| Integrator { growth_below: 1.0, ..by } },
    Variant { name: "steps grow by a half", change: |by| Integrator { growth_factor: 1.5, ..by } },
    Variant { name: "steps shrink to a tenth", change: |by| Integrator { shrink_factor: 0.1, ..by } },
    Variant {
        name: "no step below a thousandth of the print interval",
        change: |by| Integrator { smallest_step: by.print_interval / 1000.0, ..by },
    },
    Variant {
        name: "no step above a tenth of the print interval",
        change: |by| Integrator {
            largest_step: by.print_interval / 10.0,
            initial_step: by.print_interval / 10.0,
            ..by
        },
    },
];

/// What a variant changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// The greatest relative change of a peak, a minimum and a period of the runs; dimensionless.
    pub most: [f64; 3],
    /// How many of these numbers round to another printed number.
    pub printed_otherwise: usize,
}

/// Each variant compared with the defaults, with the exact sign and with the delayed sign. None if a run comes to no end.
pub fn changes(rows: &[Row]) -> Option<Vec<(&'static Variant, [Change; 2])>> {
    let hypotheses = [Lag::None, Lag::AsListed].map(|lag| Hypothesis { lag, ..Hypothesis::WITHOUT_LAG });
    let runs = |of: &Hypothesis, change: fn(Integrator) -> Integrator| -> Option<Vec<Run>> {
        rows.iter().map(|row| of.run_by_program(row, &change(row.given.listing.integrator()))).collect()
    };
    let [exact, late] = hypotheses.map(|of| runs(&of, |by| by));
    let before = [exact?, late?];
    let mut found = Vec::new();
    for variant in &VARIANTS {
        let [exact, late] = hypotheses.map(|of| runs(&of, variant.change));
        found.push((variant, [change(&before[0], &exact?), change(&before[1], &late?)]));
    }
    Some(found)
}

fn change(before: &[Run], after: &[Run]) -> Change {
    let mut found = Change { most: [0.0; 3], printed_otherwise: 0 };
    for (before, after) in before.iter().zip(after) {
        for (at, column) in EXPLAINED.into_iter().enumerate() {
            let (old, new, unit) = (before.number(column), after.number(column), column.unit());
            found.most[at] = found.most[at].max((new / old - 1.0).abs());
            found.printed_otherwise += usize::from((old / unit).round() != (new / unit).round());
        }
    }
    found
}
