//! Why a denominator is never zero, and what that does not say: the text between Eqs. (1-18) and (1-19).
//!
//! A *singularity* has one meaning here, the meaning in the paragraph: a place where something that the equation, as it
//! is written, divides by is zero, so that the equation would not be valid. Solved for the acceleration, it divides by
//! more.

use super::instants::moments;
use super::reading::decide_multiple;
use super::singularity_letters::*;
use super::*;
use geneva_dynamics::existence::least_margin;
use geneva_dynamics::{Coefficients, Pose};
use geneva_evidence::agreement::{joined, joined_numbers};
use geneva_kinematics::Mechanism;
use geneva_kinematics::escapement::pins_needed;

const FLAW: Locator = at("Line after Eq. (1-18)");
const END: Locator = at("Paragraph before the substitutions of Eq. (1-19)");
/// What the word means in the paragraph.
const SINGULARITY: &str = "As the paragraph uses the word, a singularity is a place where Eq. (1-18), as it is \
                           written, divides by zero, so that the equation would not be valid there. The paragraph does \
                           not make the stronger claim that the equation has one solution for the acceleration.";

pub(super) fn claims() -> Vec<Claim> {
    [quantity(), bounds(), slots()].concat()
}

fn quantity() -> Vec<Claim> {
    vec![
        FLAW.statement(
            "meyer.possible-flaw",
            "one possible flaw",
            "the equation of motion, as it is written, divides by one quantity that could be zero",
        )
        .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            let solved = stated.pick(None, Some("meyer.app-b.solved"));
            let displays = ["meyer.eq-1-18.first-line", "meyer.eq-1-18.second-line"].into_iter().chain(solved);
            let found: Option<Vec<_>> = displays.map(|id| divisors(MEYER.lookup(id).right_characters())).collect();
            let Some(found) = found else { return Finding::new(false, "a denominator cannot be read") };
            // All powers of the pin's distance are one thing.
            let [powers, others] = [true, false].map(|of| found.iter().flatten().filter(|power| **power == of).count());
            Finding::new(
                (usize::from(powers > 0) + others) as u32 == stated.count(),
                format!(
                    "among the denominators that are not constant, {powers} are powers of the pin's distance and \
                     {others} are not"
                ),
            )
        })
        .second_route(Evidence::VECTORS, |stated| {
            let places = ratios().filter(|ratio| *ratio >= 1.0).flat_map(|ratio| {
                (-36..=36).map(move |k| PinKinematics::driven(ratio, f64::from(k) * PI / 36.0, (1.0, 0.0)))
            });
            let (mut at_the_axis, mut elsewhere) = (false, false);
            for seen in places {
                // By Newton's laws: what multiplies θ'' and θ'², and friction on either flank.
                let [times_acceleration, times_square] = [seen.angular_velocity(), seen.angular_acceleration()];
                let arm = seen.place.normalize().dot(&seen.velocity) / seen.radius();
                let factors = [
                    times_acceleration * times_acceleration,
                    times_acceleration * times_square,
                    times_acceleration * arm,
                    times_square * arm,
                ];
                if seen.radius() < 1e-6 {
                    at_the_axis = true;
                } else {
                    elsewhere |= factors.iter().any(|factor| !factor.is_finite());
                    // Solved, with the least inertia of the driver: a divisor that passes through zero.
                    let least = inertia_ratios().map(|(_, ratio)| ratio).fold(f64::INFINITY, f64::min);
                    let margin = least + factors[0] - factors[2].abs();
                    elsewhere |= stated.pick(false, margin <= 0.0);
                }
            }
            let found = u32::from(at_the_axis) + u32::from(elsewhere);
            Finding::new(
                found == stated.count(),
                format!(
                    "the terms grow without bound where the pin is on the follower's axis, {}",
                    if elsewhere { "and elsewhere too" } else { "and nowhere else" }
                ),
            )
        })
        .but_not("when it is solved for the acceleration, it divides by nothing else that could be zero either")
        .interpreted_as(SINGULARITY),
        at("Display after Eq. (1-18)")
            .statement(
                "meyer.singularity.quantity",
                r"(1 + a^2 - 2a \cos \theta)",
                "the quantity whose powers Eq. (1-18) divides by, which is the square of the pin's distance from the \
                 follower's axis over r²",
            )
            .first_route(Evidence::VECTORS, |stated| {
                let holds = moments().iter().all(|moment| {
                    agrees(
                        reading::value(quantity_with(stated), moment.letters()),
                        instants::letters_of(moment)("square"),
                    )
                });
                Finding::new(
                    holds,
                    "we read and evaluated the quantity and compared it with the pin's distance computed in \
                     coordinates",
                )
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                // A less the ratio of the inertias is the square of a cos θ − 1 over that of the quantity.
                let holds = Mechanism::ALL.iter().all(|mechanism| {
                    (-9..=9).all(|k| {
                        let angle = mechanism.engagement_half_angle() * f64::from(k) / 10.0;
                        let factors = factors(*mechanism, 1.0, angle, 0.0);
                        let letters = reading::by_name([("a", mechanism.centre_distance_ratio()), ("theta", angle)]);
                        let divisor = reading::value(quantity_with(stated), &letters);
                        let above = reading::value(r"a \cos \theta - 1", &letters);
                        vanishes((factors.a - 1.0) * divisor * divisor - above * above)
                    })
                });
                Finding::new(
                    holds,
                    "the factor A of the equation of motion has the square of this quantity as its denominator",
                )
            })
            .but_not("the same quantity with a plus before its last term"),
        at("1st display of θ_∞")
            .equation(
                "meyer.singularity.assumed",
                r"1 + a^2 - 2a \cos \theta_\infty = 0",
                "condition for an angle at which 1 + a² − 2a cos θ would be zero",
            )
            .decided(|tex| decide_multiple(tex, on_the_axis))
            .read(Evidence::CLOSED_FORM, with_imaginary_angles),
        at("2nd display of θ_∞")
            .equation(
                "meyer.singularity.angle",
                r"\theta_\infty = \cos^{-1} \left(\frac{1 + a^2}{2a} \right)",
                "the angle at which 1 + a² − 2a cos θ would be zero",
            )
            .decided(|tex| decide_multiple(tex, on_the_axis_by_cosine))
            .read(Evidence::CLOSED_FORM, with_imaginary_angles),
    ]
}

/// The printed quantity, or its neighbour.
fn quantity_with(stated: Stated<'_>) -> &str {
    stated.pick(stated.characters(), r"(1 + a^2 + 2a \cos \theta)")
}

fn bounds() -> Vec<Claim> {
    vec![
        bound(
            "meyer.singularity.bound",
            "1st inequality",
            "a cosine is at most one",
            r"\left(\frac{1 + a^2}{2a} \right) \leq 1",
            nearest_on_the_axis_by_cosine,
        ),
        bound(
            "meyer.singularity.cleared",
            "2nd inequality",
            "the first inequality multiplied by 2a",
            r"1 + a^2 \leq 2a",
            nearest_on_the_axis,
        ),
        bound(
            "meyer.singularity.collected",
            "3rd inequality",
            "the second inequality with all its terms on one side",
            r"a^2 - 2a + 1 \leq 0",
            nearest_on_the_axis,
        ),
        bound(
            "meyer.singularity.square",
            "4th inequality",
            "the third inequality written as a square",
            r"(a - 1)^2 \leq 0",
            nearest_on_the_axis,
        ),
        at("Line after the inequalities")
            .statement("meyer.singularity.only-one", "a = 1", "1 + a² − 2a cos θ can be zero only for a ratio of one")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let square = MEYER.printed_text("meyer.singularity.square");
                let found: Vec<f64> = ratios().filter(|ratio| allows(square, *ratio) == Some(true)).collect();
                Finding::new(
                    found == [stated.pick(stated.number(), NEXT_RATIO)],
                    format!(
                        "among the ratios that we tried, the last inequality holds only for the ratio {}",
                        joined(&found)
                    ),
                )
            })
            .second_route(Evidence::VECTORS, |stated| {
                // How near the follower's axis a pin comes.
                let nearest = |ratio: &f64| {
                    let place = |k: u32| Turn::from_radians(2.0 * PI * f64::from(k) / 720.0).direction();
                    (0..720).map(|k| (place(k) - Vector2::new(*ratio, 0.0)).norm()).fold(f64::INFINITY, f64::min)
                };
                let found: Vec<f64> = ratios().filter(|ratio| vanishes(nearest(ratio))).collect();
                Finding::new(
                    found == [stated.pick(stated.number(), NEXT_RATIO)],
                    format!("among 80 centre distances, the pin reaches the follower's axis at {}", joined(&found)),
                )
            })
            .but_not("only the next greater ratio that we tried, seventeen sixteenths, allows it"),
    ]
}

fn slots() -> Vec<Claim> {
    vec![
        at("1st display before the substitutions of Eq. (1-19)")
            .equation(
                "meyer.singularity.ratio",
                r"a = \frac{1}{\sin(\pi/n)} = 1",
                "the condition that the ratio is one, by Eq. (1-2)",
            )
            .decided(|tex| decide_multiple(tex, ratio_of_one))
            .read(Evidence::CLOSED_FORM, only_for_two),
        at("2nd display before the substitutions of Eq. (1-19)")
            .equation(
                "meyer.singularity.sine",
                r"\sin\left(\frac{\pi}{n}\right) = 1",
                "the same condition for the sine",
            )
            .decided(|tex| decide_multiple(tex, ratio_of_one_by_sine))
            .read(Evidence::CLOSED_FORM, only_for_two),
        END.statement("meyer.singularity.two-slots", "n=2", "only two slots would give a ratio of one")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let found = slots_that_satisfy(MEYER.printed_text("meyer.singularity.sine"));
                Finding::new(
                    found.as_deref() == Some(&[stated.pick(stated.count(), 3)]),
                    format!(
                        "we read and evaluated the sine for 1 to 100 slots, and it is one only for {}",
                        joined(found.iter().flatten())
                    ),
                )
            })
            .second_route(Evidence::VECTORS, |stated| {
                // A pin that enters along its slot, half the angle between two slots from the line of centres: how far
                // the follower's axis then is from the driver's.
                let distance = |slots: u32| {
                    let (sin, cos) = libm::sincos(PI / f64::from(slots));
                    // The right angle at the pin: R = r cot φ.
                    let pin = Vector2::new(cos, sin) * (cos / sin);
                    let to_driver = quarter_turn(&pin.normalize()) * -cos.signum();
                    (pin + to_driver).norm()
                };
                let found: Vec<u32> = (2..=100).filter(|slots| agrees(distance(*slots), 1.0)).collect();
                Finding::new(
                    found == [stated.pick(stated.count(), 3)],
                    format!("the axes are r apart for {} slots", joined(&found)),
                )
            })
            .but_not("only three slots"),
        END.statement("meyer.singularity.ruled-out", "previously ruled out", "two slots are ruled out by Eq. (1-3)")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let right = MEYER.right_side("meyer.eq-1-3");
                let letters = reading::by_name([("n", stated.pick(2.0, 3.0))]);
                let pins = reading::value(right, &letters);
                let ruled_out = !(pins.is_finite() && pins >= 1.0 && agrees(pins, pins.round()));
                Finding::new(
                    ruled_out,
                    format!(
                        "Eq. (1-3), read and evaluated, gives {} pins",
                        if pins.is_finite() { pins.to_string() } else { "infinitely many".into() }
                    ),
                )
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                let slots = stated.pick(2, 3);
                let fits = |pins: &u32| vanishes(PI / f64::from(*pins) + PI / f64::from(slots) - PI / 2.0);
                let found = (1..=1000).find(fits);
                Finding::new(
                    found.is_none() && pins_needed(slots).is_none(),
                    format!(
                        "we tried 1 to 1000 pins, and the angles at the hand-over make a right angle for {}",
                        found.map_or("none of these numbers".into(), |pins: u32| format!("{pins} pins"))
                    ),
                )
            })
            .but_not("three slots are ruled out by Eq. (1-3)"),
        END.statement(
            "meyer.singularity.conclusion",
            "contains no singularities",
            "Eq. (1-18), as it is written, divides by zero nowhere in the three mechanisms",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            let of = |ratio: f64, angle: f64| 1.0 + ratio * ratio - 2.0 * ratio * libm::cos(angle);
            let least = inertia_ratios().map(|(mechanism, inertia)| {
                let ratio = mechanism.centre_distance_ratio();
                let as_written =
                    (-180..=180).map(|k| of(ratio, f64::from(k) * PI / 180.0)).fold(f64::INFINITY, f64::min);
                let solved = least_margin(mechanism, inertia, MUCH_FRICTION).map_or(f64::NAN, |least| least.margin);
                stated.pick(as_written, solved)
            });
            let least: Vec<f64> = least.collect();
            Finding::new(
                least.iter().all(|least| *least > 0.0),
                format!("the least values of the divisor are {}", joined_numbers(&least)),
            )
        })
        .second_route(Evidence::VECTORS, |stated| {
            let nearest = Mechanism::ALL.map(|mechanism| {
                let axis = Vector2::new(mechanism.centre_distance_ratio(), 0.0);
                let place = |k: u32| Turn::from_radians(2.0 * PI * f64::from(k) / 720.0).direction();
                (0..720).map(|k| (place(k) - axis).norm()).fold(f64::INFINITY, f64::min)
            });
            // Whether the driver feels an inertia above zero on either flank of the slot, all over the engagements.
            let positive = inertia_ratios().all(|(mechanism, inertia)| {
                (-99..=99).all(|k| {
                    let angle = mechanism.engagement_half_angle() * f64::from(k) / 100.0;
                    let seen = PinKinematics::driven(mechanism.centre_distance_ratio(), angle, (1.0, 0.0));
                    let (turning, sliding) = (seen.angular_velocity(), seen.place.normalize().dot(&seen.velocity));
                    let friction = MUCH_FRICTION * turning * sliding / seen.radius();
                    inertia + turning * turning > friction.abs()
                })
            });
            Finding::new(
                nearest.iter().all(|distance| !vanishes(*distance)) && stated.pick(true, positive),
                format!("a pin comes as near to the follower's axis as {} radii", joined_numbers(&nearest)),
            )
        })
        .but_not("when it is solved for the acceleration, it divides by zero nowhere, whatever the friction")
        .interpreted_as(SINGULARITY),
    ]
}

/// More than the critical friction of each mechanism with the inertias of its runs.
const MUCH_FRICTION: f64 = 1.0;

/// The three mechanisms, each with the driver's inertia over the follower's in its runs.
pub(super) fn inertia_ratios() -> impl Iterator<Item = (Mechanism, f64)> {
    let ids = |pins: u32| match pins {
        3 => ["meyer.app-e.3-pin.driver", "meyer.app-e.3-pin.follower"],
        4 => ["meyer.app-e.4-pin.driver", "meyer.app-e.4-pin.follower"],
        _ => ["meyer.fig-11.driver", "meyer.fig-11.follower"],
    };
    Mechanism::ALL.into_iter().map(move |mechanism| {
        let [driver, follower] = ids(mechanism.pins()).map(|id| MEYER.printed_number(id));
        (mechanism, driver / follower)
    })
}

/// For each denominator of a display that is not constant, whether it is a power of the square of the pin's distance; none
/// if one cannot be read.
fn divisors(display: &str) -> Option<Vec<bool>> {
    let pieces = reading::pieces(display);
    // Where the group in braces ends that begins at a piece.
    let end = |start: usize| {
        let mut depth = 0;
        (start..pieces.len()).find(|at| {
            depth += i32::from(pieces[*at].text == "{") - i32::from(pieces[*at].text == "}");
            depth == 0
        })
    };
    let mut found = Vec::new();
    for at in (0..pieces.len()).filter(|at| pieces[*at].text == r"\frac") {
        let start = end(at + 1)? + 1;
        let below = display.get(pieces.get(start)?.start..pieces[end(start)?].end)?;
        let values: Vec<[f64; 2]> = moments()
            .iter()
            .map(|moment| [reading::value(below, moment.letters()), instants::letters_of(moment)("square")])
            .collect();
        if values.iter().flatten().any(|value| !value.is_finite()) {
            return None;
        }
        let is_power =
            |power: i32| values.iter().all(|[value, square]| agrees(*value, libm::pow(*square, power.into())));
        if values.iter().any(|[value, _]| !agrees(*value, values[0][0])) {
            found.push((1..=4).any(is_power));
        }
    }
    Some(found)
}

/// One of the four inequalities; all are one statement.
fn bound(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    letters: fn() -> Condition,
) -> Claim {
    let decide = move |tex: &str| match at_most(tex) {
        Some(apart) => decide_multiple(&apart, letters),
        None => Finding::of_reading(None),
    };
    at(locator).equation(id, printed, meaning).decided(decide).read(Evidence::CLOSED_FORM, only_for_one)
}

/// The least of the ratios that are tried that is greater than one.
const NEXT_RATIO: f64 = 1.0625;

/// The factors of the equation of motion for a torque of one.
fn factors(mechanism: Mechanism, inertia: f64, angle: f64, friction: f64) -> Coefficients<f64> {
    let pose = Pose::new(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle));
    Coefficients::from_pose(&pose, &inertia, &friction, &1.0)
}
