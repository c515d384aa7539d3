//! The method of integration: Runge and Kutta's of order four, with the step chosen by taking it twice.

use super::stages::{
    STEP, Slope, halvings, holds_in_a_step, is_of_fifth_order, of_order, power_of_two, printed_places, printed_step,
    step_of_mimic,
};
use super::*;
use crate::meyer::reading::value;
use geneva_evidence::agreement::joined_numbers;
use geneva_mimic::{SolverParameters, StepSolution, integrate, runge_kutta_step};
use nalgebra::Vector1;
use std::convert::Infallible;

const STEPS: Locator = at("Appendix B, paragraph on the steps");
const HEART: Locator = at("Appendix B, paragraph on the integration subroutine");
const DIVISION: Locator = at("Appendix B, paragraph on the subintervals");
const ADVANTAGES: Locator = at("Appendix B, paragraph on the two advantages");

pub(super) fn claims() -> Vec<Claim> {
    [described(), formulas(), advantages()].concat()
}

fn described() -> Vec<Claim> {
    vec![
        STEPS
            .statement(
                "meyer.app-b.method.one-value",
                "made negligible by proper choice of the increment",
                "if the second derivative, taken as constant over a step, gives the new first derivative, and the new \
                 first derivative gives the new value, the error tends to zero as the step gets shorter",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let errors: Vec<f64> = INCREMENTS.map(error_of_growth).to_vec();
                goes_away(&errors, stated)
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                let errors: Vec<f64> = INCREMENTS.map(error_of_a_swing).to_vec();
                goes_away(&errors, stated)
            })
            .but_not("the error goes to zero as the square of the step")
            .interpreted_as(
                "We take the sentence as a picture of the method with one value for each step, although the formulas \
                 that follow take four.",
            ),
        HEART
            .statement("meyer.app-b.method.order", "fourth order", "the method is of order four")
            .first_route(Evidence::LIMIT_CASE, |stated| {
                let ratio = [16.0, 32.0].map(|steps| {
                    let fixed = SolverParameters {
                        kept: StepSolution::FullStep,
                        ..SolverParameters::with_fixed_step(1.0 / steps, 1.0, 1.0)
                    };
                    let mut growth = |_: f64, y: &Vector1<f64>| *y;
                    let run = integrate(&mut growth, Vector1::new(1.0), &fixed, |_| ());
                    run.map_or(f64::NAN, |run| libm::exp(1.0) - run.last.state[0])
                });
                of_order(stated.pick(stated.count() as i32, 5), ratio[0] / ratio[1])
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                let ratio = [16_u32, 32].map(|steps| {
                    let h = 1.0 / f64::from(steps);
                    let end = (0..steps)
                        .fold(1.0, |y, k| printed_step(|x, y| x * y, h * f64::from(k), y, h).unwrap_or(f64::NAN));
                    libm::exp(0.5) - end
                });
                of_order(stated.pick(stated.count() as i32, 5), ratio[0] / ratio[1])
            })
            .but_not("it is of order five"),
        DIVISION
            .statement(
                "meyer.app-b.method.widths",
                r"h/6, h/3, h/3, and h/6",
                "weights of the four slopes, given as widths of parts of the interval",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // With the slopes of powers of x at the four places: their integrals from 0 to 1.
                let places = [0.0, 0.5, 0.5, 1.0];
                let holds = (0..=3).all(|power| {
                    let sum: f64 = said_widths(stated)
                        .iter()
                        .zip(places)
                        .map(|(width, x)| width * libm::pow(x, f64::from(power)))
                        .sum();
                    agrees(sum, 1.0 / f64::from(power + 1))
                });
                Finding::new(holds, "we computed the integrals of 1, x, x² and x³ with these weights")
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                // The formula's weights: what one step makes of four given slopes.
                let weight = |k: usize| {
                    let letters = (1..=4).map(|at| (format!("f_{at}"), f64::from(u8::from(at == k + 1))));
                    let letters = letters.chain([("h".to_owned(), 1.0), ("y_n".to_owned(), 0.0)]).collect();
                    value(MEYER.right_side("meyer.app-b.method.step"), &letters)
                };
                let weights = [0, 1, 2, 3].map(weight);
                let said = said_widths(stated);
                let same = said.iter().zip(weights).all(|(said, weight)| agrees(*said, weight));
                Finding::new(
                    same && said.len() == 4,
                    format!("the formula has the weights {}", joined_numbers(&weights)),
                )
            })
            .but_not("h/3, h/6, h/6 and h/3"),
        DIVISION
            .statement(
                "meyer.app-b.method.constant",
                "constant over each of the subintervals",
                "the function is taken as constant over each of the four parts of the interval",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let slopes: [Slope; 3] = [|x, _| x * x * x, |x, _| 1.0 / (1.0 + x), |x, _| libm::sin(x)];
                let holds = slopes.iter().all(|slope| {
                    let sum: f64 = constants(*slope, |_| 0.0, stated)
                        .iter()
                        .zip(widths())
                        .map(|(height, width)| height * width)
                        .sum();
                    printed_step(*slope, 0.0, 0.0, 1.0).is_some_and(|step| agrees(sum, step))
                });
                Finding::new(
                    holds,
                    "we compared the area under four constants with one step by the formula, for three functions of x",
                )
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                // Growth, y' = y from 1: the classical method's step, and the staircase of the same four widths.
                let growth: Slope = |_, y| y;
                let heights = constants(growth, libm::exp, stated);
                let area: f64 = heights.iter().zip(widths()).map(|(height, width)| height * width).sum();
                let rate = |_: f64, y: &Vector1<f64>| Ok::<_, Infallible>(*y);
                let step = runge_kutta_step(rate, 0.0, 1.0, &Vector1::new(1.0), &Vector1::new(1.0));
                let step = step.map_or(f64::NAN, |end| end[0] - 1.0);
                Finding::new(
                    agrees(area, step),
                    format!("the area is {area:.6} under the constants and {step:.6} by the classical method"),
                )
            })
            .but_not("the constants are the function's values in the middle of the parts")
            .interpreted_as("The constants are the four slopes of the formula that follows, in their order."),
    ]
}

/// The printed widths of the four parts, in units of the interval.
fn widths() -> Vec<f64> {
    MEYER.printed_integers("meyer.app-b.method.widths").iter().map(|n| 1.0 / f64::from(*n)).collect()
}

/// The widths that are said; for the neighbour, the outer and inner ones are exchanged.
fn said_widths(stated: Stated) -> Vec<f64> {
    let printed: Vec<f64> = stated.numbers().iter().map(|n| 1.0 / n).collect();
    let order = stated.pick([0, 1, 2, 3], [1, 0, 3, 2]);
    order.iter().filter_map(|at| printed.get(*at).copied()).collect()
}

/// The constants over the four parts of the interval from 0 to 1: the slopes where the printed formulas ask for them,
/// or those in the middle of each part on the exact curve.
fn constants(slope: Slope, exact: fn(f64) -> f64, stated: Stated) -> Vec<f64> {
    let asked = printed_places(slope, 0.0, exact(0.0), 1.0).unwrap_or([(f64::NAN, f64::NAN); 4]);
    let mut start = 0.0;
    let middles = widths().into_iter().map(|width| {
        let middle = start + width / 2.0;
        start += width;
        (middle, exact(middle))
    });
    stated.pick(asked.to_vec(), middles.collect()).into_iter().map(|(x, y)| slope(x, y)).collect()
}

/// How many steps a unit of time is cut into, more and more.
const INCREMENTS: [u32; 6] = [16, 32, 64, 128, 256, 512];

/// Whether errors fall by nearly half from each to the next, or by nearly three quarters.
fn goes_away(errors: &[f64], stated: Stated) -> Finding {
    let holds = errors.windows(2).all(|pair| pair[1] < stated.pick(0.55, 0.3) * pair[0]);
    let [first, last] = [errors.first(), errors.last()].map(|error| error.copied().unwrap_or(f64::NAN));
    Finding::new(holds, format!("the error falls from {first:.1e} to {last:.1e} with 32 times as many steps"))
}

/// The error of y' = y after a unit of time, each step going on with the value of the derivative at its beginning.
fn error_of_growth(steps: u32) -> f64 {
    let h = 1.0 / f64::from(steps);
    let end = (0..steps).fold(1.0, |y, _| y + h * y);
    (libm::exp(1.0) - end).abs()
}

/// The error for x'' = −x from x = 1 at rest, where x'' gives the next x', and x' gives the next x.
fn error_of_a_swing(steps: u32) -> f64 {
    let h = 1.0 / f64::from(steps);
    let end = (0..steps).fold(Vector2::new(1.0, 0.0), |state, _| {
        let speed = state.y - state.x * h;
        Vector2::new(state.x + speed * h, speed)
    });
    (end - Vector2::new(libm::cos(1.0), -libm::sin(1.0))).norm()
}

fn formulas() -> Vec<Claim> {
    vec![
        at("Appendix B, display of y_{n+1}")
            .equation(
                "meyer.app-b.method.step",
                r"y_{n+1} = y_n + \frac{h}{6} (f_1 + 2f_2 + 2f_3 + f_4)",
                "the next value, from four slopes",
            )
            .evaluated(Evidence::CLOSED_FORM, |tex| Finding::of_reading(holds_in_a_step(tex)))
            .read(Evidence::LIMIT_CASE, |tex| is_of_fifth_order("meyer.app-b.method.step", tex)),
        stage("meyer.app-b.method.f1", r"f_1 = f(x_n; y_n)", "first slope, taken at the beginning"),
        stage(
            "meyer.app-b.method.f2",
            r"f_2 = f\left(x_n + \frac{h}{2}; y_n + \frac{f_1 h}{2}\right)",
            "second slope, taken in the middle, using the first",
        ),
        stage(
            "meyer.app-b.method.f3",
            r"f_3 = f\left(x_n + \frac{h}{2}; y_n + \frac{f_2 h}{2}\right)",
            "third slope, taken in the middle, using the second",
        ),
        stage(
            "meyer.app-b.method.f4",
            r"f_4 = f(x_n + h; y_n + f_3 h)",
            "fourth slope, taken at the end, using the third",
        ),
    ]
}

fn advantages() -> Vec<Claim> {
    vec![
        ADVANTAGES
            .statement("meyer.app-b.method.one-point", "only an initial point", "one point is enough to start")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // The point that the formulas are given, against the step from the whole point.
                let (x, y): (f64, f64) = (0.5, 1.25);
                let given = printed_step(|x, y| x * y, x, stated.pick(y, 1.0), STEP);
                Finding::new(
                    given.is_some_and(|given| agrees(given, step_of_mimic(|x, y| x * y, x, y, STEP))),
                    "we compared one step from the given values with a step of the classical method",
                )
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                // A run that is stopped half-way and started again from its last point, or from its x alone.
                let run = |from: f64, to: f64, start: f64| {
                    let parts = 16_u32;
                    let h = (to - from) / f64::from(parts);
                    (0..parts).fold(start, |y, k| step_of_mimic(|x, y| x * y, from + h * f64::from(k), y, h))
                };
                let half = run(0.0, 1.0, 1.0);
                let (whole, again) = (run(1.0, 2.0, half), run(1.0, 2.0, stated.pick(half, 1.0)));
                Finding::new(
                    agrees(whole, again),
                    format!("the method gives {whole:.6} in one go and {again:.6} when restarted half-way"),
                )
            })
            .but_not("the method needs only the point's x"),
        ADVANTAGES
            .statement(
                "meyer.app-b.method.subinterval",
                "over the subinterval",
                "how far the integration has gone when the next value is known",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let advance = printed_step(|_, _| 1.0, 0.0, 0.0, 1.0).unwrap_or(f64::NAN);
                let said = stated.pick(1.0, widths()[0]);
                Finding::new(
                    agrees(advance, said),
                    format!("a step is {advance} interval wide, so it is wider than a subinterval"),
                )
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                let mut points = Vec::new();
                let fixed = SolverParameters {
                    kept: StepSolution::FullStep,
                    ..SolverParameters::with_fixed_step(STEP, STEP, 1.0)
                };
                let mut steady = |_: f64, _: &Vector1<f64>| Vector1::new(1.0);
                let run = integrate(&mut steady, Vector1::new(0.0), &fixed, |point| points.push(point.state[0]));
                let said = STEP * stated.pick(1.0, widths()[0]);
                let holds = run.is_ok() && points.windows(2).all(|pair| agrees(pair[1] - pair[0], said));
                Finding::new(holds && points.len() > 2, "each step of the classical method covers a whole interval")
            })
            .corrected(
                "over the interval",
                Slip {
                    id: "",
                    reason: "In the paragraphs before this one, the appendix divides the whole range into intervals of \
                             width h, and each interval into four subintervals. Once y_1 is known, the \
                             integration has covered the interval from x_0 to x_1.",
                    witness: "With each step, a run of the classical method advances by a whole interval.",
                    origin: Origin::Misprint,
                    consequence: Consequence::Wording,
                    changes: "",
                },
            ),
        ADVANTAGES
            .equation(
                "meyer.app-b.method.truncation",
                "h^5",
                "order of the error of one step; a run of many steps has an error of order h⁴",
            )
            .evaluated(Evidence::CLOSED_FORM, |tex| match [2.0, 1.0].map(|h| with_step(tex, h)) {
                [Some(whole), Some(half)] => {
                    let found = halvings();
                    Finding::new(
                        half > 0.0 && found.iter().all(|ratio| power_of_two(*ratio) == power_of_two(whole / half)),
                        format!(
                            "with half the step, the errors for two equations are {:.0} and {:.0} times smaller",
                            found[0], found[1]
                        ),
                    )
                }
                _ => Finding::of_reading(None),
            })
            .read(Evidence::LIMIT_CASE, |tex| {
                // For growth the step is the exponential series up to h⁴; what is left over a power of h.
                let left = |h: f64| {
                    let step = step_of_mimic(|_, y| y, 0.0, 1.0, h);
                    Some((libm::exp(h) - step) / with_step(tex, h)?)
                };
                Some((left(STEP / 16.0)? / left(STEP / 8.0)? - 1.0).abs() < 0.1)
            }),
        ADVANTAGES
            .statement(
                "meyer.app-b.method.doubling",
                "two half steps and then with one full step",
                "comparing two half steps with one full step gives the error",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let step = |y: f64, h: f64| printed_step(|_, y| y, 0.0, y, h).unwrap_or(f64::NAN);
                fifteen_sixteenths(step, libm::exp(STEP), stated)
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                let step = |y: f64, h: f64| step_of_mimic(|_, y| y * y, 0.0, y, h);
                fifteen_sixteenths(step, 1.0 / (1.0 - STEP), stated)
            })
            .but_not("comparing one half step with one full step gives it")
            .interpreted_as("The text does not show that the library chose its steps in this way."),
    ]
}

/// The value of a formula for a step of this length; none if it cannot be read.
fn with_step(tex: &str, length: f64) -> Option<f64> {
    let letters = reading::by_name([("h", length)]);
    Some(value(tex, &letters)).filter(|value| !value.is_nan())
}

/// Whether the difference of the two results is nearly all of the full step's error: two half steps have 2/32 of it, so
/// that 15/16 are left.
fn fifteen_sixteenths(step: impl Fn(f64, f64) -> f64, exact: f64, stated: Stated) -> Finding {
    let [halves, half, full] = stated.numbers()[..] else { return Finding::new(false, "steps of two lengths") };
    let taken = |steps: f64, length: f64| (0..steps as u32).fold(1.0, |y, _| step(y, length));
    let (halves, full) = (taken(halves - stated.pick(0.0, 1.0), STEP * half), taken(full, STEP));
    let part = (halves - full) / (exact - full);
    Finding::new(
        (part - 15.0 / 16.0).abs() < 1.0 / 16.0,
        format!("the difference is {part:.3} of the full step's error"),
    )
}

fn stage(id: &'static str, printed: &'static str, meaning: &'static str) -> Claim {
    at("Appendix B, displays of the four slopes")
        .equation(id, printed, meaning)
        .evaluated(Evidence::CLOSED_FORM, |tex| Finding::of_reading(holds_in_a_step(tex)))
        .read(Evidence::LIMIT_CASE, move |tex| is_of_fifth_order(id, tex))
}
