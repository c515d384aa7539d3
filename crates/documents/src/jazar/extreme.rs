//! The worked example, part (e): which root is the angle of the greatest acceleration, and what the source says of it.

use super::letters::PEAK_ANGLE;
use super::peak::{both_roots, left_side, six_pair};
use super::*;
use crate::duals::halved;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::acceleration_ratio;
use geneva_kinematics::{Expression, Field, Identity, Rational, prove, rational};

pub(super) fn claims() -> Vec<Claim> {
    vec![root_choice(), alpha_range(), maximum(), angle(), sign_of_the_angle(), general_validity()]
}

fn root_choice() -> Claim {
    at("Ex. (e), choice of the root")
        .statement(
            "jazar.ex-e.root-choice",
            "0 and 1",
            "only the positive root gives a cosine whose size is between zero and one",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            let [least, most] = stated.numbers()[..] else { return Finding::new(false, "not two numbers") };
            // From the least size of a cosine to the greatest.
            let sizes = vanishes(libm::cos(PI / 2.0) - least) && agrees(libm::cos(0.0), most);
            for_all_stations(
                |wheel| {
                    let (plus, minus) = both_roots(libm::sin(wheel.half_pitch_angle()));
                    let (this, other) = stated.pick((plus, minus), (minus, plus));
                    sizes && (least..=most).contains(&this.abs()) && other.abs() > most
                },
                &format!(
                    "the size of one root is between {least} and {most}, as a cosine's must be, but the other's is not"
                ),
            )
        })
        .second_route(Evidence::EXACT_IDENTITY, |stated| {
            // The left side q of the quadratic is below zero at cos θ = 0. If it is a square over 2 sin α at 1, or at
            // −1, it is not below zero there for any sine between zero and one, and a root is between. The product
            // of the roots is q(0) = −2, so the other is at least as great as two in size.
            let product: Finding = prove(&ProductOfTheRoots).into();
            let [_, end] = stated.numbers()[..] else { return Finding::new(false, "not two numbers") };
            let square: Finding = prove(&SquareAt { end: stated.pick(1, -1) * end as i64 }).into();
            Finding::of_cases(product.holds && square.holds, &[product, square])
        })
        .but_not("only the negative root does")
}

fn alpha_range() -> Claim {
    at("Ex. (e), choice of the root")
        .statement(
            "jazar.ex-e.alpha-range",
            r"0 < \alpha < 60^{\circ}",
            "the allowable range of α, which is half the angle between two slots",
        )
        .first_route(Evidence::EXACT_IDENTITY, |stated| {
            let Some((range, closed)) = range(stated) else { return Finding::new(false, "not a range") };
            let [Ok(start), Ok(end)] = range.map(Rational::try_from) else { return Finding::new(false, "not a range") };
            let alpha = |stations| rational(180, stations);
            let outside = (3..=1000).find(|stations| {
                let alpha = alpha(*stations);
                alpha <= start || if closed { alpha > end } else { alpha >= end }
            });
            let but = outside.map_or_else(
                || "every number of stations from 3 to 1000 is in the range".to_owned(),
                |stations| format!("with {stations} stations, α is outside the range"),
            );
            // An end that belongs to the range is reached.
            let missed = closed && !(3..=1000).any(|stations| alpha(stations) == end);
            let at_the_end = if missed { ", but none is at its end" } else { "" };
            Finding::new(outside.is_none() && !missed, format!("{but}{at_the_end}"))
        })
        .second_route(Evidence::VECTORS, |stated| {
            let slot = |wheel: &Wheel| by_series(wheel, wheel.engagement_half_angle())[0].to_degrees();
            let Some(([start, end], closed)) = range(stated) else { return Finding::new(false, "not a range") };
            let (least, greatest) =
                (wheels().iter().map(slot).fold(f64::INFINITY, f64::min), greatest(wheels().iter().map(slot)));
            let at_the_end = agrees(greatest, end);
            let holds = least > start && if closed { at_the_end } else { !at_the_end && greatest < end };
            Finding::new(
                holds,
                format!(
                    "the largest α, with three stations, is {greatest:.4}°, and the range {} this angle",
                    if holds { "includes" } else { "does not include" }
                ),
            )
        })
        .corrected(
            r"0 < \alpha \le 60^{\circ}",
            Slip {
                id: "",
                reason: "The smallest number of stations that the handout allows is three. With three stations α is \
                         exactly 60°, but the printed range leaves 60° out. It should include 60°, because what the \
                         handout says about the choice of the root holds there too. The copy may have lost a stroke \
                         of the inequality sign. But the right sign appears nowhere else in the handout, so we count \
                         this mistake as the handout's.",
                witness: "For a three-station wheel, the coordinates of the pin at entry give a slot angle of 60°, \
                          which is α.",
                origin: Origin::Misprint,
                consequence: Consequence::Remark,
                changes: "",
            },
        )
}

/// The ends of the range in degrees, and whether the second one belongs to it.
fn range(stated: Stated) -> Option<([f64; 2], bool)> {
    let ends = stated.numbers().try_into().ok()?;
    Some((ends, stated.characters().contains(r"\le")))
}

fn maximum() -> Claim {
    at("Ex. (e), before Eq. (5.34)")
        .statement(
            "jazar.ex-e.maximum",
            "at a maximum",
            "the size of the angular acceleration has a maximum at both angles ±θ of Eq. (5.34)",
        )
        .first_route(Evidence::JET, |stated| {
            let size = |acceleration: f64| stated.pick(acceleration.abs(), acceleration);
            for_all_stations(
                |wheel| {
                    let at = |t: f64| size(by_series(wheel, t)[2]);
                    let angle = libm::acos(both_roots(libm::sin(wheel.half_pitch_angle())).0);
                    let greatest = |peak: f64| {
                        let near = geneva_evidence::CLOSURE.relative * at(peak).abs();
                        within(wheel.engagement_half_angle()).all(|t| at(t) <= at(peak) + near)
                    };
                    greatest(angle) && greatest(-angle)
                },
                "it is nowhere in the advance greater than at ±θ",
            )
        })
        .second_route(Evidence::CLOSED_FORM, |stated| {
            for_all_stations(
                |wheel| {
                    let angle = wheel.acceleration_peak().angle;
                    // The slope of what is greatest: from plus to minus.
                    let slope = |t: f64| {
                        let motion = wheel.engaged(t);
                        motion.map_or(f64::NAN, |m| m.jerk * stated.pick(m.acceleration.signum(), 1.0))
                    };
                    [angle, -angle].iter().all(|peak| slope(peak - 1e-4) > 0.0 && slope(peak + 1e-4) < 0.0)
                },
                "it rises up to both angles and falls from there",
            )
        })
        .but_not("the acceleration with its sign is greatest at both angles, too")
        .interpreted_as(
            "We take this to be about the size of the acceleration, because the source gives two values of opposite \
             signs for the two angles.",
        )
}

fn angle() -> Claim {
    at("Eq. (5.34)")
        .equation(
            "jazar.eq-5.34",
            r"\theta = \pm \cos^{-1}\left(\frac{-\gamma + \sqrt{\gamma^2 + 8}}{2}\right)",
            "crank angles at which the acceleration is greatest in size",
        )
        .in_letters(PEAK_ANGLE)
}

fn sign_of_the_angle() -> Claim {
    at("Ex. (e), on Eq. (5.34)")
        .statement(
            "jazar.ex-e.sign-of-angle",
            "comes from inversion of the cosine",
            "the two signs of the angle belong to one root of the quadratic, not to two",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            for_all_stations(
                |wheel| {
                    let (plus, minus) = both_roots(libm::sin(wheel.half_pitch_angle()));
                    let angle = wheel.acceleration_peak().angle;
                    agrees(libm::cos(angle), plus) && agrees(libm::cos(-angle), stated.pick(plus, minus))
                },
                "the cosines of both angles are the positive root",
            )
        })
        .second_route(Evidence::JET, |stated| {
            for_all_stations(
                |wheel| {
                    // The extreme before the line of centres, looked for by itself. The roots' product is −2.
                    let before = halved([-wheel.engagement_half_angle(), 0.0], |t| by_series(wheel, t)[3] > 0.0)[0];
                    let after = libm::cos(peak_by_series(wheel).0);
                    vanishes(libm::cos(before) - stated.pick(after, -2.0 / after))
                },
                "the extreme before the line of centres has the same cosine as the one past it",
            )
        })
        .but_not("the two signs belong to the two roots")
}

fn general_validity() -> Claim {
    at("Ex. (e), on Eqs. (5.33) and (5.34)")
        .statement(
            "jazar.ex-e.general-validity",
            "general validity",
            "Eqs. (5.33) and (5.34) hold for every number of stations",
        )
        .first_route(Evidence::JET, |stated| {
            valid_for(stated, |wheel, angle, gain| {
                let scale = rate_by_series(wheel, 0.0, gain);
                [-angle, angle].iter().all(|t| vanishes(rate_by_series(wheel, *t, gain) / scale))
            })
        })
        .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
            valid_for(stated, |wheel, angle, gain| {
                // The slope of the acceleration changes its sign there, and nowhere else past the line of centres.
                let slope = |crank: f64| unsteady_by_duals(wheel, crank, 1.0, gain)[1];
                let end = wheel.engagement_half_angle();
                let before = (1..=20).all(|k| slope(angle * f64::from(k) / 20.001) < 0.0);
                let past =
                    (1..=20).all(|k| slope(angle * 1.00005 + (end - angle * 1.00005) * f64::from(k) / 20.0) > 0.0);
                before && past
            })
        })
        .but_not("the equations hold while the driver speeds up, too")
        .interpreted_as(
            "We take this to be about every number of stations, with a driver of constant speed, as in the example.",
        )
}

/// Whether Eqs. (5.33) and (5.34) give the angle of the extreme for all numbers of stations; or with a driver that
/// gains five times its speed in the time of a radian. If it gained less, three stations would hardly show it.
fn valid_for(stated: Stated, is_extreme: impl Fn(&Wheel, f64, f64) -> bool) -> Finding {
    let gain = stated.pick(0.0, 5.0);
    for_all_stations(
        |wheel| {
            let angle = libm::acos(both_roots(libm::sin(wheel.half_pitch_angle())).0);
            angle < wheel.engagement_half_angle() && is_extreme(wheel, angle, gain)
        },
        "the angle is the angle of the extreme",
    )
}

/// The rate of change of the wheel's acceleration as a power series, for a driver of speed one and this acceleration.
fn rate_by_series(wheel: &Wheel, crank: f64, gain: f64) -> f64 {
    let advance = Jet::from_coefficients([0.0, 1.0, gain / 2.0, 0.0]);
    let turn = Turn::from_radians(crank).moving_by(&advance);
    let series = angular_velocity(&pin_from_pivot(&Jet::constant(wheel.centre_distance_ratio()), &turn));
    series.and_then(|series| series.derivative(2)).unwrap_or(f64::NAN)
}

/// The two roots of c² + γ c − 2 = 0 have the product −2: (c − a)(c + 2/a) has its middle coefficient for γ, and −2 at
/// c = 0. Variables: c and a root a.
struct ProductOfTheRoots;

impl Identity<2> for ProductOfTheRoots {
    fn difference(&self, [cosine, root]: [Expression; 2]) -> Expression {
        left_side(cosine, 2 / root - root) - (cosine - root) * (cosine + 2 / root)
    }
}

/// With γ by Eq. (5.33), c² + γ c − 2 is at c = ±1 the square of 1 − sin α over 2 sin α. Variable: sin α.
struct SquareAt {
    end: i64,
}

impl Identity<1> for SquareAt {
    fn difference(&self, [sine]: [Expression; 1]) -> Expression {
        let (gamma, rest) = ((1 + sine * sine) / (2 * sine), 1 - sine);
        left_side(Expression::integer(self.end), gamma) - rest * rest / (2 * sine)
    }
}

/// The upper sign of the acceleration belongs to one sign of the angle, the lower to the other.
pub(super) fn signs() -> Claim {
    at("Ex. (e), from Eq. (5.32)")
        .statement("jazar.ex-e.signs", r"\pm", "the accelerations at the two angles have opposite signs")
        .first_route(Evidence::JET, |stated| {
            let (angle, _) = six_pair(peak_by_series);
            let [before, past] = [-angle, angle].map(|t| six(|wheel| by_series(wheel, t)[2]));
            same(before, stated.pick(-1.0, 1.0) * past)
        })
        .second_route(Evidence::EXACT_IDENTITY, |stated| prove(&SameSize { sign: stated.pick(-1, 1) }).into())
        .but_not("the two accelerations have the same sign")
        .interpreted_as(
            "The two values differ in sign, but the source does not say which belongs to which angle. The wheel speeds \
             up at the negative angle and slows down at the positive one.",
        )
}

/// The acceleration at −θ is `sign` times that at θ. Variables: k and the tangent of θ/2.
struct SameSize {
    sign: i64,
}

impl Identity<2> for SameSize {
    fn difference(&self, [ratio, half]: [Expression; 2]) -> Expression {
        let crank = Turn::from_half_tangent(&half);
        acceleration_ratio(&ratio, &crank.reversed()) - self.sign * acceleration_ratio(&ratio, &crank)
    }
}
