//! One step by the printed formulas of the method, and one by an implementation of it.

use super::*;
use crate::meyer::reading::{self, Letters, Moment, value, value_at};
use geneva_mimic::runge_kutta_step;
use nalgebra::Vector1;
use std::convert::Infallible;

/// Claims of the four slopes, in order.
const STAGES: [&str; 4] =
    ["meyer.app-b.method.f1", "meyer.app-b.method.f2", "meyer.app-b.method.f3", "meyer.app-b.method.f4"];
/// The length of a step.
pub(super) const STEP: f64 = 0.125;

/// Whether a formula of the method holds for the steps of an implementation of the classical method.
pub(super) fn holds_in_a_step(tex: &str) -> Option<bool> {
    let slopes: [Slope; 3] = [|x, y| x * y, |x, y| y * y - x, |x, y| x + 1.0 / y];
    let moments = slopes.iter().flat_map(|slope| {
        [(0.5, 1.25, STEP), (0.75, 0.5, 2.0 * STEP)].map(|(x, y, h)| {
            let places = places_of_mimic(*slope, x, y, h);
            let next = step_of_mimic(*slope, x, y, h);
            let slopes = places.map(|(x, y)| slope(x, y));
            let slopes = ["f_1", "f_2", "f_3", "f_4"].into_iter().zip(slopes);
            let letters = [("x_n", x), ("y_n", y), ("h", h), ("y_n+1", next)].into_iter().chain(slopes);
            Moment::of(reading::by_name(letters)).sloping(*slope)
        })
    });
    reading::holds(tex, &moments.collect::<Vec<_>>())
}

/// The slope y' as a function of x and y.
pub(super) type Slope = fn(f64, f64) -> f64;

/// Where the printed formulas ask for the slope, one after the other.
pub(super) fn printed_places(slope: Slope, x: f64, y: f64, h: f64) -> Option<[(f64, f64); 4]> {
    printed_stages(slope, x, y, h).map(|(places, _)| places)
}

/// The next value by the printed formulas.
pub(super) fn printed_step(slope: Slope, x: f64, y: f64, h: f64) -> Option<f64> {
    let (_, letters) = printed_stages(slope, x, y, h)?;
    Some(value(MEYER.right_side("meyer.app-b.method.step"), &letters))
}

fn printed_stages(slope: Slope, x: f64, y: f64, h: f64) -> Option<([(f64, f64); 4], Letters)> {
    let mut letters = reading::by_name([("x_n", x), ("y_n", y), ("h", h)]);
    let mut places = [(0.0, 0.0); 4];
    for (k, id) in STAGES.into_iter().enumerate() {
        let inside = MEYER.right_side(id).trim().strip_prefix('f')?.trim_start_matches(r"\left").strip_prefix('(')?;
        let inside = inside.strip_suffix(')')?.trim_end_matches(r"\right");
        let (first, second) = inside.split_once(';')?;
        places[k] = (value(first, &letters), value(second, &letters));
        letters.insert(format!("f_{}", k + 1), slope(places[k].0, places[k].1));
    }
    Some((places, letters))
}
/// Where an implementation of the classical method asks for the slope.
pub(super) fn places_of_mimic(slope: Slope, x: f64, y: f64, h: f64) -> [(f64, f64); 4] {
    let mut places = vec![(x, y)];
    let rate = |x: f64, y: &Vector1<f64>| {
        places.push((x, y[0]));
        Ok::<_, Infallible>(Vector1::new(slope(x, y[0])))
    };
    let first = Vector1::new(slope(x, y));
    let Ok(_) = runge_kutta_step(rate, x, x + h, &Vector1::new(y), &first);
    places.try_into().unwrap_or([(f64::NAN, f64::NAN); 4])
}

/// One step of an implementation of the classical method.
pub(super) fn step_of_mimic(slope: Slope, x: f64, y: f64, h: f64) -> f64 {
    let rate = |x: f64, y: &Vector1<f64>| Ok::<_, Infallible>(Vector1::new(slope(x, y[0])));
    runge_kutta_step(rate, x, x + h, &Vector1::new(y), &Vector1::new(slope(x, y))).map_or(f64::NAN, |end| end[0])
}

/// How many times smaller the error of a step is for half its length, for two equations that are not linear in both variables.
fn halved(step: impl Fn(Slope, f64, f64, f64) -> Option<f64>) -> Option<[f64; 2]> {
    let (x, y) = (0.5, 1.0);
    let of = |slope: Slope, exact: fn(f64, f64, f64) -> f64| {
        let error = |h: f64| Some(step(slope, x, y, h)? - exact(x, y, h));
        // Shorter than elsewhere: the next power of h is then small.
        Some(error(STEP / 8.0)? / error(STEP / 16.0)?)
    };
    Some([
        of(|x, y| x * y, |x, y, h| y * libm::exp(h * (x + h / 2.0)))?,
        of(|_, y| y * y, |_, y, h| 1.0 / (1.0 / y - h))?,
    ])
}

/// How many times smaller the error of a printed step is for half its length, for two equations.
pub(super) fn halvings() -> [f64; 2] {
    halved(printed_step).unwrap_or([f64::NAN; 2])
}

/// Whether the error of a step is of the fifth order, with these characters in the place of those of a claim; none if they cannot
/// be read.
pub(super) fn is_of_fifth_order(own: &str, tex: &str) -> Option<bool> {
    let step = |slope: Slope, x: f64, y: f64, h: f64| {
        let mut moment = Moment::default().with([("x_n", x), ("y_n", y), ("h", h)]).sloping(slope);
        for id in STAGES.into_iter().chain(["meyer.app-b.method.step"]) {
            let line = if id == own { tex } else { MEYER.lookup(id).right_characters() };
            let (name, formula) = line.split_once('=')?;
            let value = Some(value_at(formula, &moment)).filter(|value| value.is_finite())?;
            moment = moment.with([(name, value)]);
        }
        moment.letters().get("y_n+1").copied()
    };
    Some(halved(step)?.iter().all(|ratio| power_of_two(*ratio) == Some(5)))
}

/// Which power of two a number is nearest to, if it is near to one.
pub(super) fn power_of_two(ratio: f64) -> Option<i32> {
    let power = libm::log2(ratio);
    ((power - power.round()).abs() < 0.25).then_some(power.round() as i32)
}

/// Whether the error of a run falls with half the step as this order has it.
pub(super) fn of_order(order: i32, ratio: f64) -> Finding {
    Finding::new(
        power_of_two(ratio) == Some(order),
        format!("with half the step, the error of a run is {ratio:.1} times smaller"),
    )
}
