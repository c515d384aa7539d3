//! The method of integration: Runge and Kutta's of order four, with the step chosen by taking it twice.

use super::*;
use crate::meyer::reading::{Letters, value};
use geneva_mimic::{Kept, Parameters, integrate, runge_kutta_step};
use nalgebra::Vector1;
use std::convert::Infallible;

const STEPS: &str = "Appendix B, paragraph on the steps";
const HEART: &str = "Appendix B, paragraph on the integration subroutine";
const DIVISION: &str = "Appendix B, paragraph on the subintervals";
const ADVANTAGES: &str = "Appendix B, paragraph on the two advantages";
/// Claims of the four slopes, in order.
const STAGES: [&str; 4] =
    ["meyer.app-b.method.f1", "meyer.app-b.method.f2", "meyer.app-b.method.f3", "meyer.app-b.method.f4"];
const STEP: f64 = 0.125;

pub fn claims() -> Vec<Claim> {
    [described(), formulas(), advantages()].concat()
}

fn described() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "meyer.app-b.method.one-value",
            STEPS,
            "each step goes on with the value of the derivative at its beginning",
            r"\text{2DX at } t_n",
            Check::corrected_equation(
                (ClosedForm, || {
                    let (start, growth) = (1.0, |_: f64, y: f64| y);
                    let beginning = start + STEP * growth(0.0, start);
                    let found = printed_step(growth, 0.0, start, STEP).unwrap_or(f64::NAN);
                    Finding::new(
                        agrees(beginning, found),
                        format!(
                            "{beginning:.5} with that value alone, {found:.5} with the formulas that \
                                follow"
                        ),
                    )
                }),
                || {
                    let places = printed_places(|_, y| y, 0.0, 1.0, STEP);
                    let apart = places.is_some_and(|[first, second, third, fourth]| {
                        first.1 < second.1 && second.1 < third.1 && third.1 < fourth.1
                    });
                    Finding::new(apart, "four values are used, at four places")
                },
                (LimitCase, || {
                    // One value makes an error of the order of h², four of h⁵.
                    let one = |h: f64| libm::exp(h) - (1.0 + h);
                    let (euler, printed) = (one(STEP) / one(STEP / 2.0), halved(|_, y| y, |_, y, h| y * libm::exp(h)));
                    Finding::new(
                        (3.8..4.4).contains(&euler) && (30.0..34.0).contains(&printed),
                        format!(
                            "for half the step the error is {euler:.1} times smaller with one value, \
                                    {printed:.0} times with four"
                        ),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"\text{2DX at four places between } t_n \text{ and } t_{n+1}",
            slip: Slip {
                id: "",
                reason: "With the value at the beginning alone this is Euler's method. The \
                    formulas that follow take four values in each step, which is why their \
                    error is so much smaller.",
                witness: "Half the step makes the error of one step of the formulas 32 times \
                    smaller, of Euler's method 4 times.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
        statement(
            "meyer.app-b.method.order",
            HEART,
            "the method is of order four",
            "fourth order, variable step, Runge-",
            (LimitCase, || {
                let ratio = [16.0, 32.0].map(|steps| {
                    let fixed =
                        Parameters { kept: Kept::FullStep, ..Parameters::with_fixed_step(1.0 / steps, 1.0, 1.0) };
                    let mut growth = |_: f64, y: &Vector1<f64>| *y;
                    let run = integrate(&mut growth, Vector1::new(1.0), &fixed, |_| ());
                    run.map_or(f64::NAN, |run| libm::exp(1.0) - run.last.state[0])
                });
                sixteenth(ratio[0] / ratio[1])
            }),
            (ClosedForm, || {
                let ratio = [16_u32, 32].map(|steps| {
                    let h = 1.0 / f64::from(steps);
                    let end = (0..steps)
                        .fold(1.0, |y, k| printed_step(|x, y| x * y, h * f64::from(k), y, h).unwrap_or(f64::NAN));
                    libm::exp(0.5) - end
                });
                sixteenth(ratio[0] / ratio[1])
            }),
        ),
        statement(
            "meyer.app-b.method.widths",
            DIVISION,
            "weights of the four slopes, as widths of parts of the interval",
            r"h/6, h/3, h/3, and h/6",
            (ClosedForm, || {
                let sum: f64 = numbers("meyer.app-b.method.widths").iter().map(|n| 1.0 / f64::from(*n)).sum();
                Finding::new(agrees(sum, 1.0), "together they are h")
            }),
            (OtherPlaceInSource, || {
                // The formula's weights: what one step makes of four given slopes.
                let printed = numbers("meyer.app-b.method.widths");
                let weight = |k: usize| {
                    let letters = (1..=4).map(|at| (format!("f_{at}"), f64::from(u8::from(at == k + 1))));
                    let letters = letters.chain([("h".to_owned(), 1.0), ("y_n".to_owned(), 0.0)]).collect();
                    value(right_side("meyer.app-b.method.step"), &letters)
                };
                let same = printed.iter().enumerate().all(|(k, n)| agrees(weight(k), 1.0 / f64::from(*n)));
                Finding::new(same && printed.len() == 4, "the formula has these weights")
            }),
        ),
        Claim::statement(
            WORK,
            "meyer.app-b.method.constant",
            DIVISION,
            "the function is taken as constant over each of the four parts of the interval",
            "constant over each of the subintervals",
            Check::corrected_equation(
                (ClosedForm, || {
                    let ends = [0.0, 1.0 / 6.0, 0.5, 5.0 / 6.0, 1.0];
                    let middles = ends.windows(2).map(|pair| {
                        let middle = (pair[0] + pair[1]) / 2.0;
                        (pair[1] - pair[0]) * middle * middle * middle
                    });
                    let (parts, formula) = (middles.sum::<f64>(), printed_step(|x, _| x * x * x, 0.0, 0.0, 1.0));
                    Finding::new(
                        formula.is_some_and(|formula| agrees(parts, formula)),
                        format!(
                            "the integral of x³ from 0 to 1 is 1/4 by the formula, {parts:.4} with \
                                constants"
                        ),
                    )
                }),
                || {
                    let places = printed_places(|_, _| 1.0, 0.0, 0.0, 1.0).map(|places| places.map(|place| place.0));
                    Finding::new(places == Some([0.0, 0.5, 0.5, 1.0]), "the function is asked for at 0, h/2, h/2 and h")
                },
                (LimitCase, || {
                    let asked = places_of_mimic(|_, _| 1.0, 0.0, 0.0, 1.0).map(|place| place.0);
                    Finding::new(
                        asked == [0.0, 0.5, 0.5, 1.0],
                        "the classical method asks there, for no part of its own",
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "taken at the beginning of the interval, twice in its middle and at its end",
            slip: Slip {
                id: "",
                reason: "The four widths are weights. No part of the interval is treated by \
                    itself, and steps of a staircase could not give an error as small as \
                    h⁵.",
                witness: "An implementation of the classical method asks for the function at these three places.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
    ]
}

fn formulas() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "meyer.app-b.method.step",
            "Appendix B, display of y_{n+1}",
            "the next value, from four slopes",
            r"y_{n+1} = y_n + \frac{h}{6} (f_1 + 2f_2 + 2f_3 + f_4)",
            Check::equation((ClosedForm, || same_as_mimic(3)), (LimitCase, thirty_second)),
        ),
        stage("meyer.app-b.method.f1", r"f_1 = f(x_n; y_n)", "first slope, at the beginning", || same_as_mimic(0)),
        stage(
            "meyer.app-b.method.f2",
            r"f_2 = f\left(x_n + \frac{h}{2}; y_n + \frac{f_1 h}{2}\right)",
            "second slope, in the middle with the first",
            || same_as_mimic(1),
        ),
        stage(
            "meyer.app-b.method.f3",
            r"f_3 = f\left(x_n + \frac{h}{2}; y_n + \frac{f_2 h}{2}\right)",
            "third slope, in the middle with the second",
            || same_as_mimic(2),
        ),
        stage(
            "meyer.app-b.method.f4",
            r"f_4 = f(x_n + h; y_n + f_3 h)",
            "fourth slope, at the end with the third",
            || same_as_mimic(3),
        ),
    ]
}

fn advantages() -> Vec<Claim> {
    vec![
        statement(
            "meyer.app-b.method.one-point",
            ADVANTAGES,
            "one point is enough to start",
            "only an initial point",
            (ClosedForm, || same_as_mimic(3)),
            (LimitCase, thirty_second),
        ),
        Claim::statement(
            WORK,
            "meyer.app-b.method.subinterval",
            ADVANTAGES,
            "what has been integrated over when the next value is known",
            "over the subinterval",
            Check::corrected_equation(
                (ClosedForm, || {
                    let advance = printed_step(|_, _| 1.0, 0.0, 0.0, 1.0).unwrap_or(f64::NAN);
                    let widths = numbers("meyer.app-b.method.widths");
                    let part = widths.iter().any(|n| agrees(advance, 1.0 / f64::from(*n)));
                    Finding::new(part, format!("the step goes on by {advance} of the interval"))
                }),
                || same(printed_step(|_, _| 1.0, 0.0, 0.0, 1.0).unwrap_or(f64::NAN), 1.0),
                (OtherPlaceInSource, || {
                    let end = claim(STAGES[3]).is_some_and(|claim| claim.printed.contains("x_n + h"));
                    Finding::new(end, "the last slope is at x_n + h, the end of the interval")
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "over the interval",
            slip: Slip {
                id: "",
                reason: "The paragraph before calls h the interval and its four parts \
                    subintervals; one value follows from the other over the whole interval.",
                witness: "The next point is a whole h further on.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        Claim::equation(
            WORK,
            "meyer.app-b.method.truncation",
            ADVANTAGES,
            "order of the error of one step; that of a run of many is h⁴",
            "h^5",
            Check::equation(
                (ClosedForm, thirty_second),
                (LimitCase, || {
                    // For growth the step is the exponential series up to h⁴; the next term is h⁵/120.
                    let h = STEP / 8.0;
                    let growth = |_: f64, y: &Vector1<f64>| Ok::<_, Infallible>(*y);
                    let one = Vector1::new(1.0);
                    let step = runge_kutta_step(growth, 0.0, h, &one, &one).map_or(f64::NAN, |end| end[0]);
                    let left = (libm::exp(h) - step) * 120.0 / (h * h * h * h * h);
                    Finding::new((left - 1.0).abs() < 0.01, "the error is the next term of the exponential series")
                }),
            ),
        ),
        statement(
            "meyer.app-b.method.doubling",
            ADVANTAGES,
            "the error is judged by two half steps and one full step",
            "first with two half steps and then with one full step",
            (ClosedForm, || {
                // Two half steps have 2/32 of the error, so the difference is 15/16 of it.
                let exact = libm::exp(STEP);
                let full = printed_step(|_, y| y, 0.0, 1.0, STEP).unwrap_or(f64::NAN);
                let half = |y: f64| printed_step(|_, y| y, 0.0, y, STEP / 2.0).unwrap_or(f64::NAN);
                let part = (half(half(1.0)) - full) / (exact - full);
                Finding::new(
                    (part - 15.0 / 16.0).abs() < 0.01,
                    format!("the difference is {part:.3} of the full step's error"),
                )
            }),
            (LimitCase, || {
                let mut growth = |_: f64, y: &Vector1<f64>| *y;
                let run = integrate(&mut growth, Vector1::new(1.0), &Parameters::new(1.0, 1.0), |_| ());
                let error = run.map_or(f64::NAN, |run| (run.last.state[0] / libm::exp(1.0) - 1.0).abs());
                Finding::new(error < 5e-6, "a run with steps so chosen keeps the relative error")
            }),
        ),
    ]
}

fn stage(id: &'static str, printed: &'static str, meaning: &'static str, first: fn() -> Finding) -> Claim {
    let locator = "Appendix B, displays of the four slopes";
    Claim::equation(
        WORK,
        id,
        locator,
        meaning,
        printed,
        Check::equation((ClosedForm, first), (LimitCase, thirty_second)),
    )
}

type Slope = fn(f64, f64) -> f64;

/// Where the printed formulas ask for the slope, one after the other.
fn printed_places(slope: Slope, x: f64, y: f64, h: f64) -> Option<[(f64, f64); 4]> {
    printed_stages(slope, x, y, h).map(|(places, _)| places)
}

/// The next value by the printed formulas.
fn printed_step(slope: Slope, x: f64, y: f64, h: f64) -> Option<f64> {
    let (_, letters) = printed_stages(slope, x, y, h)?;
    Some(value(right_side("meyer.app-b.method.step"), &letters))
}

fn printed_stages(slope: Slope, x: f64, y: f64, h: f64) -> Option<([(f64, f64); 4], Letters)> {
    let mut letters: Letters = [("x_n", x), ("y_n", y), ("h", h)].map(|(name, value)| (name.to_owned(), value)).into();
    let mut places = [(0.0, 0.0); 4];
    for (k, id) in STAGES.into_iter().enumerate() {
        let inside = right_side(id).trim().strip_prefix('f')?.trim_start_matches(r"\left").strip_prefix('(')?;
        let (first, second) = inside.split_once(';')?;
        places[k] = (value(first, &letters), value(second, &letters));
        letters.insert(format!("f_{}", k + 1), slope(places[k].0, places[k].1));
    }
    Some((places, letters))
}

fn right_side(id: &str) -> &'static str {
    claim(id).and_then(|claim| claim.printed.split_once('=')).map_or("", |(_, right)| right)
}

/// Where an implementation of the classical method asks for the slope.
fn places_of_mimic(slope: Slope, x: f64, y: f64, h: f64) -> [(f64, f64); 4] {
    let mut places = vec![(x, y)];
    let rate = |x: f64, y: &Vector1<f64>| {
        places.push((x, y[0]));
        Ok::<_, Infallible>(Vector1::new(slope(x, y[0])))
    };
    let first = Vector1::new(slope(x, y));
    let end = runge_kutta_step(rate, x, x + h, &Vector1::new(y), &first);
    debug_assert!(end.is_ok());
    places.try_into().unwrap_or([(f64::NAN, f64::NAN); 4])
}

/// Whether the printed formulas ask for the slope where an implementation does, up to the k-th, and end where it ends.
fn same_as_mimic(k: usize) -> Finding {
    let slopes: [Slope; 3] = [|x, y| x * y, |x, y| y * y - x, |x, y| x + 1.0 / y];
    let holds = slopes.iter().all(|slope| {
        let (x, y) = (0.5, 1.25);
        let ours = places_of_mimic(*slope, x, y, STEP);
        let first = Vector1::new(slope(x, y));
        let rate = |x: f64, y: &Vector1<f64>| Ok::<_, Infallible>(Vector1::new(slope(x, y[0])));
        let end = runge_kutta_step(rate, x, x + STEP, &Vector1::new(y), &first).map_or(f64::NAN, |end| end[0]);
        printed_places(*slope, x, y, STEP).is_some_and(|printed| {
            (0..=k).all(|at| agrees(printed[at].0, ours[at].0) && agrees(printed[at].1, ours[at].1))
        }) && printed_step(*slope, x, y, STEP).is_some_and(|found| agrees(found, end))
    });
    Finding::new(
        holds,
        "the printed characters, read and evaluated, against an implementation \
            of the classical method",
    )
}

/// How many times smaller the error of one printed step is for half its length.
fn halved(slope: Slope, exact: fn(f64, f64, f64) -> f64) -> f64 {
    let (x, y) = (0.5, 1.0);
    let error = |h: f64| printed_step(slope, x, y, h).unwrap_or(f64::NAN) - exact(x, y, h);
    // Shorter than elsewhere: the next power of h is then small.
    error(STEP / 4.0) / error(STEP / 8.0)
}

/// Whether the error of a step is some 32 times smaller for half its length, for two equations that are not linear in
/// both variables.
fn thirty_second() -> Finding {
    let found = [
        halved(|x, y| x * y, |x, y, h| y * libm::exp(h * (x + h / 2.0))),
        halved(|_, y| y * y, |_, y, h| 1.0 / (1.0 / y - h)),
    ];
    Finding::new(
        found.iter().all(|ratio| (27.0..40.0).contains(ratio)),
        format!("for half the step the error is {:.0} and {:.0} times smaller", found[0], found[1]),
    )
}

fn sixteenth(ratio: f64) -> Finding {
    Finding::new(
        (14.5..17.5).contains(&ratio),
        format!("with half the step the error of a run is {ratio:.1} times smaller"),
    )
}
