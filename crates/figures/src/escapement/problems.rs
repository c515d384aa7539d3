//! Two problems with closed forms, and the errors of the integrator on them with steps of one length.

use geneva_mimic::{Kept, Parameters, integrate};
use nalgebra::{SVector, Vector1, Vector2};

/// Step lengths are 1/2, 1/4 and so on, so many of them.
pub const HALVINGS: i32 = 9;
/// How far the smooth problem is followed, in whole units of time.
const SMOOTH_END: f64 = 4.0;
/// So many places of the switch are tried, between these.
const PLACES: u32 = 60;
const BETWEEN: [f64; 2] = [0.3, 0.7];

/// Error at the end with one length of step.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// The step.
    pub step: f64,
    /// x'' = −x from 1 at rest: the greater of both components' errors.
    pub smooth: f64,
    /// x' = 1 before x = s and 2 beyond, from 0 to time 1: the greatest error over places of s.
    pub switched: f64,
}

/// Errors for all lengths of step, the longest first.
pub fn errors() -> Vec<Errors> {
    let one = |halvings: i32| {
        let step = libm::ldexp(1.0, -halvings);
        Errors { step, smooth: spring(step), switched: worst_switch(step) }
    };
    (1..=HALVINGS).map(one).collect()
}

/// How many powers of the step the error falls by, from the longest step to the shortest.
pub fn observed_order(errors: &[Errors], error: fn(&Errors) -> f64) -> f64 {
    match errors {
        [first, .., last] => libm::log(error(first) / error(last)) / libm::log(first.step / last.step),
        _ => 0.0,
    }
}

fn spring(step: f64) -> f64 {
    let exact = Vector2::new(libm::cos(SMOOTH_END), -libm::sin(SMOOTH_END));
    let end = last(|_, at| Vector2::new(at[1], -at[0]), Vector2::new(1.0, 0.0), step, SMOOTH_END);
    (end - exact).amax()
}

fn worst_switch(step: f64) -> f64 {
    let error = |place: u32| {
        let switch = BETWEEN[0] + (BETWEEN[1] - BETWEEN[0]) * f64::from(place) / f64::from(PLACES);
        let end = last(|_, at| Vector1::new(if at[0] < switch { 1.0 } else { 2.0 }), Vector1::zeros(), step, 1.0);
        (end[0] - (2.0 - switch)).abs()
    };
    (0..=PLACES).map(error).fold(0.0, f64::max)
}

/// The state at the end; no number if there is none, which these problems do not come to.
fn last<const D: usize>(
    mut rate: impl FnMut(f64, &SVector<f64, D>) -> SVector<f64, D>,
    start: SVector<f64, D>,
    step: f64,
    end: f64,
) -> SVector<f64, D> {
    let run = Parameters { kept: Kept::FullStep, ..Parameters::with_fixed_step(step, end, end) };
    integrate(&mut rate, start, &run, |_| ()).map_or(SVector::repeat(f64::NAN), |outcome| outcome.last.state)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_orders_are_four_and_one() {
        let errors = errors();
        let [smooth, switched] = [|at: &Errors| at.smooth, |at: &Errors| at.switched];
        assert!((observed_order(&errors, smooth) - 4.0).abs() < 0.2, "{errors:?}");
        assert!((observed_order(&errors, switched) - 1.0).abs() < 0.1, "{errors:?}");
        // A switch in a step costs at most a third of it, times the jump.
        assert!(errors.iter().all(|at| at.switched < at.step / 2.9), "{errors:?}");
    }
}
