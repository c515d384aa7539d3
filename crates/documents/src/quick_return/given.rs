//! What the problem gives and asks.

use super::letters::{COMPONENTS, VECTORS, with_parts};
use super::*;
use geneva_evidence::tex::Moment;

const DATA: Locator = at("Problem, 1st paragraph");
const VELOCITY: Locator = at("Problem, part (a), equation");
const ACCELERATION: Locator = at("Problem, part (b), 1st equation");
const THREE: Locator = at("Problem, part (a), question");
const TERMS: Locator = at("Problem, part (b), 2nd equation");
const QUESTION: Locator = at("Problem, part (b), question");
const DRAWING: Locator = at("Figure 7");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        DATA.statement("quick-return.driver-sense", "counter-clockwise", "the crank turns counter-clockwise")
            .first_route(Evidence::VECTORS, |stated| {
                in_both_drawings(|instant| {
                    let motion = driven(instant, stated).by_diagrams()?;
                    Some(out_of_the_page(motion.velocities.follower_speed))
                })
            })
            .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
                in_both_drawings(|instant| Some(out_of_the_page(driven(instant, stated).by_duals().polar()[1][1])))
            })
            .but_not("the crank turns clockwise"),
        DATA.value(
            "quick-return.driver-speed",
            "50",
            "r.p.m.",
            "the given speed of the crank, confirmed by the solution's rate in rad/s",
        )
        .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
            QUICK_RETURN.printed_number("quick-return.driver-rate") * 30.0 / PI
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
            QUICK_RETURN.printed_number("quick-return.pin-speed") / QUICK_RETURN.printed_number("quick-return.crank")
                * 30.0
                / PI
        }),
        VELOCITY
            .equation(
                "quick-return.velocity-equation",
                r"v_{P_2} = v_{P_4} + v_{P_2P_4}",
                "velocity of the pin, as the velocity of the lever's point under the pin plus the pin's velocity \
                 relative to the lever",
            )
            .in_letters(VECTORS),
        THREE
            .statement("quick-return.three", "three", "the equation of the velocities has three terms")
            .first_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
                from_duals(|crank| {
                    let Parted { velocities, .. } = parted(crank);
                    needed(&velocities, stated.pick(stated.count(), 2))
                })
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                summands("quick-return.velocity-equation", stated.pick(stated.count(), 2))
            })
            .but_not("the equation has two terms")
            .interpreted_as(COUNTED),
        accelerations(ACCELERATION, "quick-return.acceleration-equation", r"a_{P_2} = a_{P_4} + a_{P_2P_4}"),
        components_of_all(
            TERMS,
            "quick-return.seven-terms",
            concat!(
                r"(a_{P_2}^n + a_{P_2}^t) = (a_{P_4}^n + a_{P_4}^t)",
                r" + (a_{P_2P_4}^n + a_{P_2P_4}^t + 2\omega_4 \times v_{P_2P_4})"
            ),
        ),
        QUESTION
            .statement("quick-return.seven", "seven", "the equation of the accelerations has seven terms")
            .first_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
                from_duals(|crank| {
                    let Parted { accelerations, .. } = parted(crank);
                    needed(&accelerations, stated.pick(stated.count(), 6))
                })
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                summands("quick-return.seven-terms", stated.pick(stated.count(), 6))
            })
            .but_not("the equation has six terms")
            .interpreted_as(COUNTED),
        DRAWING
            .figure("quick-return.figure", "Figure", "the drawing of the mechanism, with its lengths and its angle")
            .missing(
                "The copy we had does not include the drawing. The lengths and the angle follow from the solution. The \
                 place of the pin on the crank's circle follows, too: of the two possible points, it is the one \
                 farther from the lever's pivot. But \
                 the solution does not show on which side of the line of centres the lever is. Without knowing the \
                 side, we cannot tell the senses of the sliding, of the Coriolis acceleration and of the lever's \
                 angular acceleration",
            ),
    ]
}

/// The equation of the accelerations, which the solution prints again in letters of its own.
pub(super) fn accelerations(place: Locator, id: &'static str, printed: &'static str) -> Claim {
    place
        .equation(
            id,
            printed,
            "acceleration of the pin, as the acceleration of the lever's point plus the pin's acceleration relative to \
             it, in a frame that does not turn",
        )
        .in_letters(VECTORS)
}

/// The equation of the accelerations by its components.
pub(super) fn components_of_all(place: Locator, id: &'static str, printed: &'static str) -> Claim {
    place
        .equation(id, printed, "acceleration of the pin by its normal, tangential and Coriolis components")
        .in_letters(COMPONENTS)
}

/// How we count terms.
const COUNTED: &str = "We count the terms in another motion, in which the crank speeds up and the slot is curved, so \
                       that none of them is zero.";

/// The instant with the crank turning counter-clockwise; or clockwise.
fn driven(instant: &LeverProblem, stated: Stated) -> LeverProblem {
    let mut instant = instant.clone();
    instant.drive.speed *= stated.pick(1.0, -1.0);
    instant
}

/// Whether the lever's angular velocity points out of the page, as the solution says.
fn out_of_the_page(speed: f64) -> Finding {
    Finding::new(speed > 0.0, format!("the lever turns at {speed:.3} rad/s, counted positive out of the page"))
}

/// Every term of the two equations, left sides positive and right sides negative, of a motion in which none is zero.
struct Parted {
    velocities: [Vector2<f64>; 3],
    accelerations: [Vector2<f64>; 7],
    relative: Vector2<f64>,
    turning: f64,
}

/// The crank of the problem, speeding up, and a lever that turns at will: the slot must then be curved.
fn parted(crank: &Crank) -> Parted {
    let crank = Crank { acceleration: 7.0, ..*crank };
    let (turning, growth) = (2.0, -3.0);
    let ([place, velocity, _], arm) = (crank.pin_motion(), Turn::from_radians(crank.angle).direction() * crank.radius);
    let [_, relative, seen] = path(|t| turned(crank.pin(t), -advance(turning, growth, t)));
    let along = relative.normalize();
    let tangential = along * along.dot(&seen);
    let [normal, coriolis] = [seen - tangential, quarter_turn(&relative) * (2.0 * turning)];
    let across = quarter_turn(&place);
    Parted {
        velocities: [velocity, -across * turning, -relative],
        accelerations: [
            -arm * (crank.speed * crank.speed),
            quarter_turn(&arm) * crank.acceleration,
            place * (turning * turning),
            -across * growth,
            -normal,
            -tangential,
            -coriolis,
        ],
        relative,
        turning,
    }
}

/// The letters of the components, with this crank and a lever that turns at will.
pub(super) fn components_at_will(crank: Crank) -> Moment {
    let Parted { accelerations: [pin_n, pin_t, lever_n, lever_t, normal, tangential, _], relative, turning, .. } =
        parted(&crank);
    with_parts([[pin_n, pin_t], [-lever_n, -lever_t], [-normal, -tangential]], relative, turning)
}

/// Whether some choice of so many of the terms adds up to nothing.
fn needed(terms: &[Vector2<f64>], count: u32) -> Finding {
    if count as usize > terms.len() {
        return Finding::new(false, format!("there are {} terms, not {count}", terms.len()));
    }
    let longest = terms.iter().map(|term| term.norm()).fold(0.0, f64::max);
    let sum = |choice: u32| -> Vector2<f64> {
        let chosen = terms.iter().enumerate().filter(|(at, _)| choice >> at & 1 == 1);
        chosen.map(|(_, term)| *term).sum()
    };
    let choices = (0..1 << terms.len()).filter(|choice: &u32| choice.count_ones() == count);
    let gap = choices.map(|choice| sum(choice).norm() / longest).fold(f64::INFINITY, f64::min);
    let closes = vanishes(gap);
    let gap = if closes { 0.0 } else { gap };
    Finding::new(
        closes,
        format!(
            "for all choices of {count} terms we added the vectors, and the shortest sum is {gap:.2} times as long as \
             the longest term"
        ),
    )
}

/// Whether so many terms stand in the printed equation.
fn summands(equation: &str, count: u32) -> Finding {
    let printed = QUICK_RETURN.printed_text(equation);
    let found = printed.split(['=', '+']).filter(|term| !term.trim().is_empty()).count();
    Finding::new(found == count as usize, format!("the printed equation has {found} terms"))
}

/// The pin's acceleration from its components along the lever and across it, in polar coordinates.
pub(super) fn components(rates: &PolarRates<f64>) -> Vector2<f64> {
    let along = rates.sliding_rate - rates.angular_velocity * rates.angular_velocity;
    let across = rates.angular_acceleration + 2.0 * rates.sliding * rates.angular_velocity;
    rates.position * along + quarter_turn(&rates.position) * across
}

/// The length of the pin's acceleration, by the differentiated loop closure.
pub(super) fn total(rates: &PolarRates<f64>) -> f64 {
    components(rates).norm()
}
