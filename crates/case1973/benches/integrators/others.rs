//! The solver over the angle, and the program of 1973 on its integrator.

use crate::race::{ReferenceRun, SolverAnswer, numbers};
use geneva_case1973::program::Program1973;
use geneva_dynamics::steady::Engagement;
use geneva_mimic::MinStepPolicy;

/// The steady state by integrals over the angle, from the escapement.
pub(crate) fn steady(row: &ReferenceRun, tolerance: f64) -> Option<SolverAnswer> {
    let steady = Engagement::with_tolerance(&row.escapement, tolerance).ok()?.steady_state().ok()?;
    Some(SolverAnswer { numbers: numbers(&steady), evaluations: None })
}

/// Its entry speed and period alone.
pub(crate) fn terminal(row: &ReferenceRun, tolerance: f64) -> Option<SolverAnswer> {
    let (entry_speed, period) =
        Engagement::with_tolerance(&row.escapement, tolerance).ok()?.entry_speed_and_period().ok()?;
    Some(SolverAnswer { numbers: vec![entry_speed, period], evaluations: None })
}

/// The run from rest by integrals over the angle.
pub(crate) fn run(row: &ReferenceRun, tolerance: f64) -> Option<SolverAnswer> {
    let lines = Engagement::with_tolerance(&row.escapement, tolerance).ok()?.run(row.interval, row.duration).ok()?;
    Some(SolverAnswer { numbers: lines.iter().skip(1).map(|line| line.speed).collect(), evaluations: None })
}

/// The run from rest as the program makes it, with the exact sign and the mechanism's own reset angle.
pub(crate) fn program(row: &ReferenceRun, tolerance: f64) -> Option<SolverAnswer> {
    let integrator = geneva_mimic::SolverParameters {
        relative_tolerance: tolerance,
        at_smallest_step: MinStepPolicy::Continue,
        ..geneva_mimic::SolverParameters::new(row.interval, row.duration)
    };
    let printout = Program1973::ideal(&row.escapement).run(&integrator).ok()?;
    let numbers = printout.lines.iter().skip(1).map(|line| line.speed).collect();
    Some(SolverAnswer { numbers, evaluations: Some(printout.work.evaluations) })
}
