//! The worked example, part (e): where the acceleration is greatest, and how great.

use super::four::printed_5_32;
use super::*;
use crate::{Consequence, Dimension as Exponents, Erratum, Origin, Slip, Verdict};
use geneva_kinematics::wheel::{acceleration_peak, gamma};
use geneva_kinematics::wheel_peak_proofs::{BelowOne, Condition, InsideTheEngagement, Pythagoras, Quadratic, Roots};
use geneva_kinematics::wheel_proofs::{OddAcceleration, Printed, Quantity};
use geneva_kinematics::{DegreeBound, Field, Rational, prove, rational};

const E: &str = "Ex. (e)";

pub fn claims() -> Vec<Claim> {
    [steps(), choice(), numbers()].concat()
}

fn steps() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "jazar.ex-e.plot",
            "Ex. (e), reference to Fig. 5.30",
            "the extreme and its angle can be read from a plot of Eq. (5.32)",
            "read directly",
            Check::equation(
                (Series, || {
                    let (angle, size) = six_pair(peak_by_series);
                    let (read, top) = six_pair(read_from_a_plot);
                    Finding::new(
                        (angle - read).abs() < 0.01 && (size - top).abs() < 1e-3,
                        format!("{read:.2} rad and {top:.3} from 201 points"),
                    )
                }),
                (ExactIdentity, || prove(&Printed(Quantity::Acceleration)).into()),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.ex-e.derivative",
            "Ex. (e), derivative of Eq. (5.32)",
            "rate of change of the wheel's acceleration",
            r"\frac{d\ddot{\phi}}{dt} = \frac{-\dot{\theta}^3 \sin \alpha \cos^2 \alpha}{(1 + \sin^2 \alpha - 2 \sin \alpha \cos \theta)^3} \{ (1 + \sin^2 \alpha - 2 \sin \alpha \cos \theta) \cos \theta - 4 \sin \alpha \sin^2 \theta \}",
            Check::equation(
                (ExactIdentity, || prove(&Printed(Quantity::Jerk)).into()),
                (AutomaticDerivative, || as_by_duals(3, printed_derivative)),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.ex-e.condition",
            "Ex. (e), condition for an extreme",
            "where the derivative is zero",
            r"(1 + \sin^2 \alpha) \cos \theta - 2 \sin \alpha \cos^2 \theta - 4 \sin \alpha \sin^2 \theta = 0",
            Check::equation(
                (ExactIdentity, || prove(&Condition).into()),
                (Series, || {
                    at_the_peak(|sine, c| (1.0 + sine * sine) * c - 2.0 * sine * c * c - 4.0 * sine * (1.0 - c * c))
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.ex-e.pythagoras",
            E,
            "replacement of the square of the sine",
            r"\sin^2\theta = 1 - \cos^2\theta",
            Check::equation(
                (ExactIdentity, || prove(&Pythagoras).into()),
                (ClosedForm, || same(libm::sin(0.4) * libm::sin(0.4), 1.0 - libm::cos(0.4) * libm::cos(0.4))),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.ex-e.quadratic",
            "Ex. (e), quadratic",
            "the condition as a quadratic in cos θ",
            r"\cos^2\theta + \gamma\cos\theta - 2 = 0",
            Check::equation(
                (ExactIdentity, || prove(&Quadratic).into()),
                (Series, || at_the_peak(|sine, c| c * c + (1.0 + sine * sine) / (2.0 * sine) * c - 2.0)),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.eq-5.33",
            "Eq. (5.33)",
            "coefficient of the quadratic",
            r"\gamma = \frac{1 + \sin^2 \alpha}{2 \sin \alpha}",
            Check::equation(
                (ExactIdentity, || prove(&Quadratic).into()),
                (Series, || {
                    // The γ that makes the peak of the power series a root.
                    let c = libm::cos(six_pair(peak_by_series).0);
                    same((2.0 - c * c) / c, six(gamma))
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.ex-e.preceding",
            "Ex. (e), after Eq. (5.33)",
            "the preceding equation is a quadratic equation in cos θ",
            "preceding equation",
            Check::corrected_equation(
                (ExactIdentity, || {
                    degree_in_cosine(|_, sine| (S1::integer(1) + sine.clone() * sine.clone()) / (S1::integer(2) * sine))
                }),
                || degree_in_cosine(|c, gamma| c.clone() * c.clone() + gamma * c - S1::integer(2)),
                (ExactIdentity, || prove(&Roots { plus: true }).into()),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "the equation before Eq. (5.33)",
            slip: Slip {
                id: "",
                reason: "The preceding equation is Eq. (5.33), which has no cos θ in it. Meant is the unnumbered one \
                    before it.",
                witness: "The roots that follow are proven to be those of the unnumbered equation.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        Claim::equation(
            WORK,
            "jazar.ex-e.roots",
            "Ex. (e), roots",
            "roots of the quadratic",
            r"\cos\theta = \frac{-\gamma \pm \sqrt{\gamma^2 + 8}}{2}",
            Check::equation(
                (ExactIdentity, || prove(&Roots { plus: true }).into()),
                (ExactIdentity, || prove(&Roots { plus: false }).into()),
            ),
        ),
    ]
}

fn choice() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "jazar.ex-e.root-choice",
            "Ex. (e), choice of the root",
            "only the positive root gives a cosine of a size between zero and one",
            "0 and 1",
            Check::equation(
                (ExactIdentity, || prove(&BelowOne).into()),
                (ClosedForm, || {
                    for_all_stations(
                        |wheel| {
                            let (plus, minus) = both_roots(wheel);
                            (0.0..1.0).contains(&plus) && minus < -1.0
                        },
                        "one root lies between 0 and 1, the other below −1",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.ex-e.alpha-range",
            "Ex. (e), choice of the root",
            "the allowable range of α",
            r"0 < \alpha < 60^{\circ}",
            Check::corrected_equation(
                (LimitCase, || for_all_stations(|wheel| exact_alpha(wheel) < rational(60, 1), "α is less than 60°")),
                || for_all_stations(|wheel| exact_alpha(wheel) <= rational(60, 1), "α is at most 60°"),
                (Vectors, || same(of(3, |w| by_series(w, w.engagement_half_angle())[0]).to_degrees(), 60.0)),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"0 < \alpha \le 60^{\circ}",
            slip: Slip {
                id: "",
                reason: "Three stations have α = 60° exactly, and the text names three as the least number. The \
                    statement about the root holds there too, and in fact for all α below 90°.",
                witness: "With three stations the slot is at 60° from the line of centres as the pin leaves.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        Claim::statement(
            WORK,
            "jazar.ex-e.maximum",
            "Ex. (e), before Eq. (5.34)",
            "the angular acceleration has a maximum at both angles ±θ of Eq. (5.34)",
            "at a maximum",
            Check::corrected_equation(
                (Series, || {
                    let (angle, size) = six_pair(peak_by_series);
                    let at_plus = six_at(angle)[2];
                    Finding::new(
                        at_plus > 0.0,
                        format!("φ̈ is {at_plus:.3} θ̇² at +θ, while its maximum is {size:.3} θ̇²"),
                    )
                }),
                || {
                    for_all_stations(
                        |w| {
                            let (angle, size) = peak_by_series(w);
                            let nearby = |t: f64| by_series(w, t - 1e-4)[2].abs().max(by_series(w, t + 1e-4)[2].abs());
                            agrees(by_series(w, -angle)[2], size)
                                && agrees(by_series(w, angle)[2], -size)
                                && nearby(angle) < size
                                && nearby(-angle) < size
                        },
                        "a maximum at −θ, a minimum of the same size at +θ",
                    )
                },
                (ExactIdentity, || prove(&OddAcceleration).into()),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "its size is at a maximum",
            slip: Slip {
                id: "",
                reason: "The acceleration is an odd function of θ: greatest at −θ, where the wheel speeds up, and \
                    least at +θ, where it slows down. Its size is greatest at both.",
                witness: "The acceleration is proven to be odd in θ for every wheel.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
        Claim::equation(
            WORK,
            "jazar.eq-5.34",
            "Eq. (5.34)",
            "crank angles at which the acceleration is greatest in size",
            r"\theta = \pm \cos^{-1}\left(\frac{-\gamma + \sqrt{\gamma^2 + 8}}{2}\right)",
            Check::equation(
                (ExactIdentity, || prove(&Roots { plus: true }).into()),
                (Series, || {
                    for_all_stations(
                        |w| vanishes(libm::cos(peak_by_series(w).0) - both_roots(w).0),
                        "the power series has its extreme there",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.ex-e.general-validity",
            "Ex. (e), on Eqs. (5.33) and (5.34)",
            "Eqs. (5.33) and (5.34) hold for every number of stations",
            "general validity",
            Check::equation(
                (ExactIdentity, || prove(&InsideTheEngagement).into()),
                (Series, || {
                    for_all_stations(
                        |w| {
                            let peak = acceleration_peak(w);
                            peak.angle < w.engagement_half_angle() && agrees(peak.ratio, peak_by_series(w).1)
                        },
                        "the extreme lies inside the engagement and is that of the power series",
                    )
                }),
            ),
        ),
    ]
}

fn numbers() -> Vec<Claim> {
    vec![
        Claim::value(
            WORK,
            "jazar.ex-e.gamma",
            "Ex. (e), from Eq. (5.33)",
            "γ of the wheel of six",
            ("1.25", ""),
            Check::number(
                (ClosedForm, || six(gamma)),
                (Series, || {
                    let c = libm::cos(six_pair(peak_by_series).0);
                    (2.0 - c * c) / c
                }),
            ),
        ),
        Claim::value(
            WORK,
            "jazar.ex-e.angle",
            "Ex. (e), from Eq. (5.34)",
            "crank angles at which the acceleration is greatest in size",
            ("±22.90", "°"),
            Check::number(
                (ClosedForm, || six(|w| acceleration_peak(w).angle).to_degrees()),
                (Series, || six_pair(peak_by_series).0.to_degrees()),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.ex-e.ratio-form",
            "Ex. (e), from Eq. (5.32)",
            "the acceleration over the square of the driver's speed is a pure number",
            r"\frac{\ddot{\phi}}{\dot{\theta}^2}",
            Check::equation(
                (Dimension, || {
                    let exponents =
                        Exponents::ANGULAR_ACCELERATION / (Exponents::ANGULAR_SPEED * Exponents::ANGULAR_SPEED);
                    Finding::new(exponents == Exponents::NONE, exponents.to_string())
                }),
                (ExactIdentity, || prove(&Printed(Quantity::Acceleration)).into()),
            ),
        ),
        Claim::value(
            WORK,
            "jazar.ex-e.ratio",
            "Ex. (e), from Eq. (5.32)",
            "greatest size of the acceleration of the wheel of six, over the square of the driver's speed",
            ("±1.372", ""),
            Check::number(
                (ClosedForm, || six(|w| acceleration_peak(w).ratio)),
                (Series, || six_pair(peak_by_series).1),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "±1.350", slip: Slip {
 id: "",
reason: "It does not follow from Eq. (5.32) at the printed angle, nor at any other: it is larger \
                    than the largest value that the equation takes for six stations. Where it comes from is not \
                    known.",
witness: "The pin's place as a power series, its third derivative brought to zero by halving intervals.",
origin: Origin::Arithmetic,
consequence: Consequence::Result,
changes: "",
} }),
        Claim::statement(
            WORK,
            "jazar.ex-e.signs",
            "Ex. (e), from Eq. (5.32)",
            "the upper sign of the acceleration belongs to the upper sign of the angle",
            r"\pm",
            Check::corrected_equation(
                (ClosedForm, || sign_at_the_upper_angle(1.0)),
                || sign_at_the_upper_angle(-1.0),
                (Series, || {
                    Finding::new(
                        six_at(six_pair(peak_by_series).0)[2] < 0.0,
                        "the wheel slows down behind the line of centres",
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: r"\mp", slip: Slip {
 id: "",
reason: "Eq. (5.32) has a minus sign: the acceleration is negative at the positive angle.",
witness: "The power series of the pin's place, which does not use Eq. (5.32).",
origin: Origin::Misprint,
consequence: Consequence::Wording,
changes: "",
} }),
        Claim::equation(
            WORK,
            "jazar.ex-e.driver-formula",
            E,
            "angular velocity of the driver once more",
            r"6 \times 2\pi",
            Check::equation(
                (ClosedForm, || same(example_speed(), printed("jazar.ex-a.advances") * 2.0 * PI)),
                (OtherPlaceInSource, || same(2.0 * PI / printed("jazar.ex-c.cycle"), example_speed())),
            ),
        ),
        Claim::value(
            WORK,
            "jazar.ex-e.peak",
            E,
            "peak angular acceleration of the wheel",
            ("1,950", "rad/s²"),
            Check::number(
                (ClosedForm, || example().and_then(|w| w.peaks(example_speed())).map_or(f64::NAN, |peaks| peaks.1)),
                (Series, || example_speed() * example_speed() * six_pair(peak_by_series).1),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "1,918", slip: Slip {
 id: "",
reason: "Inherited: it is the wrong ratio times the square of the right speed.",
witness: "The same power series, with the exact speed.",
origin: Origin::Arithmetic,
consequence: Consequence::Result,
changes: "",
} }),
    ]
}

type S1 = DegreeBound<1>;

fn six_pair(pair: fn(&Wheel) -> (f64, f64)) -> (f64, f64) {
    example().map_or((f64::NAN, f64::NAN), |wheel| pair(&wheel))
}

fn six_at(crank: f64) -> [f64; 4] {
    example().map_or([f64::NAN; 4], |wheel| by_series(&wheel, crank))
}

/// The tallest of 201 points of Eq. (5.32) over the second half of the advance.
fn read_from_a_plot(wheel: &Wheel) -> (f64, f64) {
    let points = (0..=200).map(|k| wheel.engagement_half_angle() * f64::from(k) / 200.0);
    let points = points.map(|t| (t, printed_5_32(wheel, t).abs()));
    points.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((f64::NAN, f64::NAN))
}

/// Whether an equation in sin α and cos θ is zero at the peak of the power series, for all numbers of stations.
fn at_the_peak(equation: fn(f64, f64) -> f64) -> Finding {
    let worst = (3..=60)
        .filter_map(|n| Wheel::new(n).ok())
        .map(|wheel| equation(libm::sin(wheel.half_station()), libm::cos(peak_by_series(&wheel).0)).abs())
        .fold(0.0, f64::max);
    Finding::new(vanishes(worst), format!("at most {worst:.0e} at the peaks for 3 to 60 stations"))
}

/// The derivative of Eq. (5.32) as it is printed, for a driver of speed one.
fn printed_derivative(wheel: &Wheel, theta: f64) -> f64 {
    let (sine, cosine) = (libm::sin(wheel.half_station()), libm::cos(wheel.half_station()));
    let (s, c) = (libm::sin(theta), libm::cos(theta));
    let square = 1.0 + sine * sine - 2.0 * sine * c;
    -(sine * cosine * cosine) / (square * square * square) * (square * c - 4.0 * sine * s * s)
}

/// α in degrees, as an exact fraction.
fn exact_alpha(wheel: &Wheel) -> Rational {
    rational(180, i64::from(wheel.stations()))
}

fn both_roots(wheel: &Wheel) -> (f64, f64) {
    let (gamma, root) = (gamma(wheel), (gamma(wheel) * gamma(wheel) + 8.0).sqrt());
    ((root - gamma) / 2.0, (-root - gamma) / 2.0)
}

/// Whether an expression in cos θ (and one other letter, taken as constant) is quadratic in cos θ.
fn degree_in_cosine(expression: fn(S1, S1) -> S1) -> Finding {
    let [degree] = expression(S1::variable(0), S1::integer(7)).numerator();
    Finding::new(degree == 2, format!("of degree {degree} in cos θ"))
}

fn sign_at_the_upper_angle(sign: f64) -> Finding {
    let acceleration = six(|w| w.engaged(acceleration_peak(w).angle).map_or(f64::NAN, |m| m.acceleration));
    Finding::new(acceleration * sign > 0.0, format!("{acceleration:.3} θ̇² at the positive angle"))
}
