//! The worked example, part (e): where the acceleration is greatest, and how great.

use super::letters::{ANY, COEFFICIENT, PEAK, ROOTS, condition, quadratic};
use super::*;
use geneva_evidence::tex::{By, Letters, Moment, by_name, decide_multiple, holds, value};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::gamma;
use geneva_kinematics::{Expression, Field};

const E: Locator = at("Ex. (e)");

/// A ratio that Eq. (5.32) does not give.
const WRONG_RATIO: Slip = Slip {
    id: "jazar.ex-e.ratio",
    reason: "The printed ratio does not follow from Eq. (5.32) at the printed angle or at any other, because the \
             printed ratio is larger than the largest value that the equation takes for six stations. We can only \
             guess at its origin: the equation gives the printed digits if the angle in the numerator is the printed \
             one, 22.90°, but the angle in the denominator is 22.50°, with a 5 in place of the 9. The answer to (e) is \
             the printed ratio times the square of the driver's speed. The speed is right, so only the ratio makes the \
             answer wrong.",
    witness: "We wrote the pin's position as a power series, which gives the pin's direction as seen from the wheel's \
              axis. By bisection, we found where the third derivative of this direction's angle is zero, because the \
              acceleration peaks there.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Result,
    changes: "The printed peak of the wheel's angular acceleration, which is the answer to (e), is too large.",
};

pub(super) fn claims() -> Vec<Claim> {
    [steps(), extreme::claims(), numbers()].concat()
}

fn steps() -> Vec<Claim> {
    vec![
        plot(),
        at("Ex. (e), derivative of Eq. (5.32)")
            .equation(
                "jazar.ex-e.derivative",
                concat!(
                    r"\frac{d\ddot{\phi}}{dt} = ",
                    r"\frac{-\dot{\theta}^3 \sin \alpha \cos^2 \alpha}",
                    r"{(1 + \sin^2 \alpha - 2 \sin \alpha \cos \theta)^3} ",
                    r"\{ (1 + \sin^2 \alpha - 2 \sin \alpha \cos \theta) \cos \theta ",
                    r"- 4 \sin \alpha \sin^2 \theta \}",
                ),
                "rate of change of the wheel's acceleration",
            )
            .in_letters(ANY),
        at("Ex. (e), condition for an extreme")
            .equation("jazar.ex-e.zero", r"\frac{d\ddot{\phi}}{dt} = 0", "the derivative is zero at the extremes")
            .evaluated(Evidence::JET, |tex| {
                let angle = |wheel: &Wheel| libm::acos(both_roots(libm::sin(wheel.half_pitch_angle())).0);
                Finding::of_reading(zero_at(tex, by_series, angle))
            })
            .read(Evidence::AUTOMATIC_DERIVATIVE, |tex| {
                zero_at(tex, by_duals, |wheel| wheel.acceleration_peak().angle)
            }),
        at("Ex. (e), condition for an extreme")
            .equation(
                "jazar.ex-e.condition",
                concat!(
                    r"(1 + \sin^2 \alpha) \cos \theta - 2 \sin \alpha \cos^2 \theta - 4 \sin \alpha ",
                    r"\sin^2 \theta = 0"
                ),
                "where the derivative is zero",
            )
            .decided(|tex| decide_multiple(tex, condition))
            .read(PEAK.evidence, |tex| holds(tex, (PEAK.numbers)())),
        E.equation(
            "jazar.ex-e.pythagoras",
            r"\sin^2\theta \text{ by } 1 - \cos^2\theta",
            "the square of the sine, replaced by the cosine",
        )
        .rewritten_and_proven(ANY, |tex| tex.replace(r"\text{ by }", "=")),
        at("Ex. (e), quadratic")
            .equation(
                "jazar.ex-e.quadratic",
                r"\cos^2\theta + \gamma\cos\theta - 2 = 0",
                "the condition as a quadratic in cos θ",
            )
            .decided(|tex| decide_multiple(tex, quadratic))
            .read(PEAK.evidence, |tex| holds(tex, (PEAK.numbers)())),
        at("Eq. (5.33)")
            .equation(
                "jazar.eq-5.33",
                r"\gamma = \frac{1 + \sin^2 \alpha}{2 \sin \alpha}",
                "coefficient of the quadratic",
            )
            .in_letters(COEFFICIENT),
        preceding(),
        at("Ex. (e), roots")
            .equation(
                "jazar.ex-e.roots",
                r"\cos\theta = \frac{-\gamma \pm \sqrt{\gamma^2 + 8}}{2}",
                "roots of the quadratic",
            )
            .in_letters(ROOTS),
    ]
}

fn plot() -> Claim {
    at("Ex. (e), reference to Fig. 5.30")
        .statement(
            "jazar.ex-e.plot",
            "read directly",
            "the extreme and its angle can be read from a plot of Eq. (5.32)",
        )
        .first_route(Evidence::JET, |stated| {
            let curve = stated.pick("jazar.eq-5.32", "jazar.eq-5.31");
            reads(|wheel, t| steady_display(curve, wheel, t).abs(), peak_by_series)
        })
        .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
            let order = stated.pick(2, 1);
            reads(
                |wheel, t| by_duals(wheel, t)[order].abs(),
                |wheel| (wheel.acceleration_peak().angle, wheel.acceleration_peak().ratio),
            )
        })
        .but_not("the extreme and its angle can be read from a plot of Eq. (5.31)")
        .interpreted_as(
            "We take a plot with a point at each degree, over the second half of the advance. From it we read the \
             angle to half a degree, and the greatest value to as many places as the source prints.",
        )
}

fn preceding() -> Claim {
    at("Ex. (e), after Eq. (5.33)")
        .statement(
            "jazar.ex-e.preceding",
            "quadratic equation",
            "the preceding equation is a quadratic equation in cos θ",
        )
        .first_route(Evidence::EXACT_IDENTITY, |stated| {
            let printed = decide_multiple(JAZAR.printed_text("jazar.ex-e.quadratic"), quadratic);
            let degree = left_side(Expression::variable(0), Expression::integer(7)).degrees(1)[0];
            let how = format!("{}; the equation is of degree {degree} in cos θ", printed.how);
            Finding::new(printed.holds && degree == stated.pick(2, 3), how)
        })
        .second_route(Evidence::CLOSED_FORM, |stated| {
            // Differences of the sides for cosines at equal steps: of a polynomial, those of its degree are the last
            // that are not zero.
            let degree: usize = stated.pick(2, 3);
            let sides = |cosine: f64| {
                let (left, right) = JAZAR.printed_text("jazar.ex-e.quadratic").split_once('=').unwrap_or_default();
                let letters = by_name([("theta", libm::acos(cosine)), ("gamma", 7.0)]);
                value(left, &letters) - value(right, &letters)
            };
            let difference = |order: usize| {
                let mut values: Vec<f64> = (0..=order).map(|step| sides(step as f64 / 4.0)).collect();
                while values.len() > 1 {
                    values = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
                }
                values[0]
            };
            let (own, next) = (difference(degree), difference(degree + 1));
            Finding::new(
                !vanishes(own) && vanishes(next),
                format!(
                    "the differences of order {degree} are {own:.3}, and the differences of the next order are {:.3}",
                    next + 0.0
                ),
            )
        })
        .but_not("it is a cubic equation")
        .interpreted_as(
            "We take the preceding equation to be the display before the word “where”, which has no number. The equation \
             after that word only says what γ is.",
        )
}

fn numbers() -> Vec<Claim> {
    vec![
        at("Ex. (e), from Eq. (5.33)")
            .value("jazar.ex-e.gamma", "1.25", "", "γ of the six-station wheel")
            .first_route(Evidence::CLOSED_FORM, || six(gamma))
            .second_route(Evidence::JET, || {
                let c = libm::cos(six_pair(peak_by_series).0);
                (2.0 - c * c) / c
            }),
        at("Ex. (e), from Eq. (5.34)")
            .value("jazar.ex-e.angle", "±22.90", "°", "crank angles at which the acceleration is greatest in magnitude")
            .first_route(Evidence::CLOSED_FORM, || six(|w| w.acceleration_peak().angle).to_degrees())
            .second_route(Evidence::JET, || six_pair(peak_by_series).0.to_degrees()),
        at("Ex. (e), from Eq. (5.32)")
            .equation(
                "jazar.ex-e.ratio-form",
                r"\frac{\ddot{\phi}}{\dot{\theta}^2}",
                "the acceleration over the square of the driver's speed is a pure number, the same for each speed",
            )
            .evaluated(Evidence::DIMENSION, |tex| Finding::of_reading(pure_number(tex)))
            .read(Evidence::JET, same_at_each_speed),
        extreme::signs(),
        at("Ex. (e), from Eq. (5.32)")
            .value(
                "jazar.ex-e.ratio",
                "±1.372",
                "",
                "greatest magnitude of the acceleration of the six-station wheel, divided by the square of the \
                 driver's speed",
            )
            .first_route(Evidence::CLOSED_FORM, || six(|w| w.acceleration_peak().ratio))
            .second_route(Evidence::JET, || six_pair(peak_by_series).1)
            .corrected("±1.350", WRONG_RATIO),
        E.equation("jazar.ex-e.driver-formula", r"6 \times 2\pi", "angular velocity of the driver, computed once more")
            .evaluated(Evidence::CLOSED_FORM, rounds_to_the_speed)
            // How many radians the driver turns in the time of a cycle.
            .read(Evidence::LIMIT_CASE, |tex| {
                Some(agrees(number(tex)? * JAZAR.printed_number("jazar.ex-c.cycle"), 2.0 * PI))
            }),
        E.value("jazar.ex-e.peak", "1,950", "rad/s²", "peak angular acceleration of the wheel")
            .first_route(Evidence::CLOSED_FORM, || {
                JAZAR.printed_number("jazar.ex-e.ratio") * example_speed() * example_speed()
            })
            .second_route(Evidence::JET, || {
                JAZAR.printed_number("jazar.ex-e.ratio") * acceleration_by_time() / six_pair(peak_by_series).1
            })
            .right(
                Evidence::CLOSED_FORM,
                || example().and_then(|w| w.peaks(example_speed())).map_or(f64::NAN, |peaks| peaks.1),
                Evidence::JET,
                acceleration_by_time,
            )
            .in_error(WRONG_RATIO),
    ]
}

/// Whether a product of numbers rounds to the printed speed of the driver.
pub(super) fn rounds_to_the_speed(tex: &str) -> Finding {
    match number(tex) {
        Some(product) => Finding::new(
            JAZAR.prints_rounding_of("jazar.ex-d.driver-speed", product),
            format!("the formula gives {}", geneva_evidence::agreement::short(product)),
        ),
        None => Finding::of_reading(None),
    }
}

/// The value of a formula without letters; none if it cannot be read.
pub(super) fn number(tex: &str) -> Option<f64> {
    Some(value(tex, &Letters::new())).filter(|number| !number.is_nan())
}

pub(super) fn six_pair(pair: fn(&Wheel) -> (f64, f64)) -> (f64, f64) {
    example().map_or((f64::NAN, f64::NAN), |wheel| pair(&wheel))
}

/// The size of the greatest acceleration of the wheel of six by time, for a driver with as many turns in a second as the
/// source counts advances: the square of its speed comes from the power series.
fn acceleration_by_time() -> f64 {
    let (angle, _) = six_pair(peak_by_series);
    six(|wheel| at_speed(wheel, angle, 2.0 * PI * JAZAR.printed_number("jazar.ex-a.advances"))[2].abs())
}

/// Whether the tallest of points at whole degrees tells an extreme: its angle to half a degree, its size as rounded to
/// the places of the printed ratio.
fn reads(curve: impl Fn(&Wheel, f64) -> f64, extreme: impl Fn(&Wheel) -> (f64, f64)) -> Finding {
    let Ok(wheel) = example() else { return Finding::new(false, "there is no wheel of six stations") };
    let last = wheel.engagement_half_angle().to_degrees() as i32;
    let points = (0..=last).map(|degrees| (degrees, curve(&wheel, f64::from(degrees).to_radians())));
    let (degrees, read) = points.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, f64::NAN));
    let (angle, size) = extreme(&wheel);
    let places = JAZAR.printed_decimal("jazar.ex-e.ratio").places() as usize;
    let as_printed = |number: f64| format!("{number:.places$}");
    Finding::new(
        (angle.to_degrees() - f64::from(degrees)).abs() <= 0.5 && as_printed(read) == as_printed(size),
        format!("the reading is {} at {degrees}°", as_printed(read)),
    )
}

/// Whether an equation holds at both angles of the greatest acceleration, for many numbers of stations, with the wheel's
/// angle and its derivatives by this route. The derivative of the acceleration is over its value on the line of centres.
fn zero_at(tex: &str, rates: fn(&Wheel, f64) -> [f64; 4], angle: fn(&Wheel) -> f64) -> Option<bool> {
    let moments = wheels().iter().step_by(5).flat_map(|wheel| {
        let (angle, scale) = (angle(wheel), rates(wheel, 0.0)[3]);
        [-angle, angle].map(|crank| {
            let [wheel_angle, velocity, acceleration, jerk] = rates(wheel, crank);
            Moment::default()
                .with([(r"\phi", wheel_angle), (r"\dot\phi", velocity), (r"\ddot\phi", acceleration)])
                .changing(By::Time, [("phi''", jerk / scale)])
        })
    });
    holds(tex, &moments.collect::<Vec<_>>())
}

/// Whether a formula in rates of the two angles has the same value in each unit of time.
fn pure_number(tex: &str) -> Option<bool> {
    // So many units are as long as one was.
    let rates = |units: f64| {
        let [once, twice] = [units.recip(), (units * units).recip()];
        [("phi'", 1.75 * once), ("phi''", -0.75 * twice), ("theta'", 2.25 * once), ("theta''", 1.25 * twice)]
    };
    let one = of_rates(tex, rates(1.0))?;
    Some(agrees(of_rates(tex, rates(2.0))?, one) && agrees(of_rates(tex, rates(0.2))?, one))
}

/// The value of a formula in rates of the two angles; none if it cannot be read.
fn of_rates(tex: &str, rates: [(&str, f64); 4]) -> Option<f64> {
    let letters = by_name(rates);
    Some(value(tex, &letters)).filter(|value| !value.is_nan())
}

/// Whether a formula in rates of the two angles is the wheel's acceleration at the driver's speed one, for each speed.
fn same_at_each_speed(tex: &str) -> Option<bool> {
    let states = wheels().iter().step_by(5).flat_map(|wheel| {
        [-0.9, -0.4, 0.7].into_iter().flat_map(move |part| {
            let crank = part * wheel.engagement_half_angle();
            let once = by_series(wheel, crank)[2];
            [0.5, 3.0, 40.0].map(|speed| {
                let [_, velocity, acceleration, _] = at_speed(wheel, crank, speed);
                Moment::default().with([(r"\dot\phi", velocity), (r"\ddot\phi", acceleration)]).with([
                    (r"\dot\theta", speed),
                    (r"\ddot\theta", 0.0),
                    ("y", once),
                ])
            })
        })
    });
    holds(&format!("{tex} = y"), &states.collect::<Vec<_>>())
}

/// The roots of the quadratic as they are printed, from the sine of α by Eq. (5.33).
pub(super) fn both_roots(sine: f64) -> (f64, f64) {
    let gamma = (1.0 + sine * sine) / (2.0 * sine);
    let root = (gamma * gamma + 8.0).sqrt();
    ((-gamma + root) / 2.0, (-gamma - root) / 2.0)
}

/// The left side of the quadratic in cos θ.
pub(super) fn left_side<S: Field>(cosine: S, gamma: S) -> S {
    cosine.clone() * cosine.clone() + gamma * cosine - S::integer(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_possible_origin_of_the_ratio_gives_its_digits() {
        // The reason of the erratum: a 5 for the 9 of the angle, in the denominator alone.
        let ratio = |numerator: f64, denominator: f64| {
            let [sine, square] = [six(|w| libm::sin(w.half_pitch_angle())), six(|w| libm::cos(w.half_pitch_angle()))];
            let below = 1.0 + sine * sine - 2.0 * sine * libm::cos(denominator.to_radians());
            sine * square * square * libm::sin(numerator.to_radians()) / (below * below)
        };
        let angle = JAZAR.printed_number("jazar.ex-e.angle");
        assert!(JAZAR.prints_rounding_of("jazar.ex-e.ratio", ratio(angle, angle - 0.4)));
        assert!(!JAZAR.prints_rounding_of("jazar.ex-e.ratio", ratio(angle, angle)));
        assert!(!JAZAR.prints_rounding_of("jazar.ex-e.ratio", ratio(angle - 0.4, angle - 0.4)));
    }
}
