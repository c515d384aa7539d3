//! By which power of the step the error falls: on a smooth problem, and on one with a switch.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::number::format_fixed;
use crate::svg::{DASHED, Label};
use crate::theme::{DRIVER, FOLLOWER};
use crate::{Figure, Series, Words};
use geneva_mimic::{SolverParameters, StepSolution, integrate};
use nalgebra::{SVector, Vector1, Vector2};
use std::f64::consts::FRAC_PI_2;

/// The reference lines lie so many times above the errors.
const ABOVE: f64 = 8.0;
/// Digits after the point of an error in the series: the smallest are near the last place of a number of size one.
const DECIMALS: usize = 18;
/// Step lengths are 1/2, 1/4 and so on, so many of them.
const HALVINGS: i32 = 9;
/// How far the smooth problem is followed, in whole units of time.
const SMOOTH_END: f64 = 4.0;
/// So many places of the switch are tried, between these.
const PLACES: u32 = 60;
const BETWEEN: [f64; 2] = [0.3, 0.7];

/// The error of one of the problems.
type ErrorOf = fn(&Errors) -> f64;

/// Error over step length of the integrator with steps of one length, on logarithmic axes, with lines of slope 4 and 1.
///
/// The smooth problem is x'' = −x, from 1 at rest to time 4. The one with a switch is x' = 1 before x = s and 2 beyond,
/// from 0 to time 1, and its error the greatest over places of s. Series: the step, both errors.
pub fn order() -> Figure {
    let errors = errors();
    let steps = || errors.iter().map(|at| at.step);
    let values = || errors.iter().flat_map(|at| [at.smooth, at.switched]).filter(|error| *error > 0.0);
    let x = ChartAxis::decades(steps().fold(1.0, f64::min), steps().fold(0.0, f64::max), 1);
    let y = ChartAxis::decades(values().fold(1.0, f64::min), 1.0, 2).titled(Label::words("error at the end"));
    let mut panel = Panel::new(406.0, &x.titled(Label::words("step ").and_symbol("h")), &y);
    let problems: [(ErrorOf, f64, LineStyle, Marker, &str); 2] = [
        (
            |at| at.switched,
            1.0,
            LineStyle::new(DRIVER).dashed("10 6"),
            Marker::new(DRIVER, MarkShape::Square),
            "with a switch",
        ),
        (|at| at.smooth, 4.0, LineStyle::new(FOLLOWER), Marker::new(FOLLOWER, MarkShape::Disc), "smooth"),
    ];
    for (error, slope, stroke, marker, name) in problems {
        let points: Vec<_> = errors.iter().map(|at| (at.step, error(at))).filter(|(_, error)| *error > 0.0).collect();
        let reference = |at: &Errors| ABOVE * error(&errors[0]) * libm::pow(at.step / errors[0].step, slope);
        let reference: Vec<_> = errors.iter().map(|at| (at.step, reference(at))).collect();
        panel = panel.curve(reference.iter().copied(), LineStyle::thin("slope").dashed(DASHED));
        panel = panel.curve(points.iter().copied(), stroke).marks(points.iter().copied(), marker.class("point"));
        let middle = |points: &[(f64, f64)]| points.iter().copied().skip(3).take(4).collect::<Vec<_>>();
        panel = panel.name_near(middle(&reference), FRAC_PI_2, Label::words(&format!("slope {slope}")));
        panel = panel.name_near(middle(&points), -FRAC_PI_2, Label::words(name).in_colour(stroke.colour));
    }

    let [smooth, switched] = [observed_order(&errors, |at| at.smooth), observed_order(&errors, |at| at.switched)]
        .map(|order| format_fixed(order, 2));
    let rows = errors.iter().map(|at| [at.step, at.smooth, at.switched]);
    let series = Series::new([("h", "1"), ("smooth", "1"), ("switch", "1")], rows).to_decimals(DECIMALS);
    let words = Words::new(
        "integrator-order",
        "Error over step length, for a smooth problem and for one with a switch",
        format!(
            "Two rows of points on logarithmic axes, the step length to the right, the error upwards. The errors of \
             the smooth problem follow a line of slope 4 (observed: {smooth}). The errors of the problem with a switch \
             are far above and follow a line of slope 1 (observed: {switched})."
        ),
        "Where the right-hand side of the differential equation is \
         smooth (ẍ = −x), half the step gives a sixteenth of the error. Where the \
         right-hand side jumps within a step (ẋ = 1, then 2), the error is proportional to the step, whatever the \
             order of the method.",
    );
    Chart::new([panel]).figure(words, series)
}

/// Error at the end with one length of step.
#[derive(Clone, Copy, Debug)]
struct Errors {
    /// The step.
    step: f64,
    /// x'' = −x from 1 at rest: the greater of both components' errors.
    smooth: f64,
    /// x' = 1 before x = s and 2 beyond, from 0 to time 1: the greatest error over places of s.
    switched: f64,
}

/// Errors for all lengths of step, the longest first.
fn errors() -> Vec<Errors> {
    let one = |halvings: i32| {
        let step = libm::ldexp(1.0, -halvings);
        Errors { step, smooth: spring(step), switched: worst_reversal(step) }
    };
    (1..=HALVINGS).map(one).collect()
}

/// How many powers of the step the error falls by, from the longest step to the shortest.
fn observed_order(errors: &[Errors], error: ErrorOf) -> f64 {
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

fn worst_reversal(step: f64) -> f64 {
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
    let run = SolverParameters { kept: StepSolution::FullStep, ..SolverParameters::with_fixed_step(step, end, end) };
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
