//! What the letters of the problem stand for: exactly, from the lines of crank and slot and the pin's place as a power
//! series; and by numbers, from the pin's place by dual numbers.

use super::*;
use crate::duals::ratio_with_standstill_at;
use crate::triangle::{Triangle, angle};
use geneva_evidence::Vocabulary;
use geneva_evidence::tex::Moment;
use geneva_kinematics::pin_vectors::quarter_turn;
use geneva_kinematics::{Expression, Jet, angular_velocity};
use std::array::from_fn;
use std::f64::consts::PI;
use std::sync::OnceLock;

/// The pin before the line of centres, the driver turning counter-clockwise: lengths, speeds and angles.
pub(super) const SPEEDS: Vocabulary = Vocabulary::new(speeds, Evidence::AUTOMATIC_DERIVATIVE, speeds_in_numbers);
/// Letters of the velocities, which are printed upright, from the positions of pin and slot.
pub(super) const VELOCITIES: Vocabulary =
    Vocabulary::new(velocities, Evidence::AUTOMATIC_DERIVATIVE, velocities_in_numbers);
/// The instant of the problem, at which the angle at the driver's axis is 30°.
pub(super) const AT_THIRTY: Vocabulary = Vocabulary::new(at_thirty, Evidence::AUTOMATIC_DERIVATIVE, thirty_in_numbers);
/// The four-slot wheel, whose slots are at 45° as the pin enters, and which is at rest then.
pub(super) const FOUR_SLOTS: Vocabulary =
    Vocabulary::new(four_slots, Evidence::AUTOMATIC_DERIVATIVE, four_slots_in_numbers);

/// The triangle of the axes and the pin, and its motion.
struct Moving {
    triangle: Triangle,
    /// The driver's angular velocity, and the wheel's, counter-clockwise positive.
    speeds: [Expression; 2],
    /// Velocities of the pin, of the wheel's point under it, and of the pin along the slot.
    velocities: [Vector2<Expression>; 3],
}

impl Moving {
    /// Variables: tangents of θ/2 and b/2, l, the driver's angular velocity.
    fn new() -> Self {
        let [half_theta, half_phi, distance, driver] = from_fn(Expression::variable);
        Self::of(Triangle::by_halves(distance, [half_theta, half_phi]), driver)
    }

    /// The pin goes round with the crank, and the wheel's point with the pin's direction. Along the slot, the square of the
    /// pin's distance changes.
    fn of(triangle: Triangle, driver: Expression) -> Self {
        let crank = triangle.theta.supplement().moving::<2>(driver);
        let pin = pin_vectors::path(&triangle.crank_radius, &triangle.distance, &crank);
        let wheel = angular_velocity(&pin).expect("the pin is off the pivot").value();
        let point = triangle.phi.moving::<2>(wheel).direction() * Jet::constant(triangle.slot_radius);
        let (place, square) = (pin.map(|series| series.value()), pin.x * pin.x + pin.y * pin.y);
        let [pin, point] = [pin, point].map(|path| path.map(|series| series.rate()));
        let sliding = place * (square.rate() / (2 * square.value()));
        Self { triangle, speeds: [driver, wheel], velocities: [pin, point, sliding] }
    }
}

/// Speeds are the parts of the velocities in their directions, and nothing is left across these.
fn speeds(_: i64) -> Moment<Expression> {
    let Moving { triangle, speeds: [driver, wheel], velocities } = Moving::new();
    let pin = quarter_turn(&triangle.theta.supplement().direction());
    let (inwards, across) = (-triangle.phi.direction(), -quarter_turn(&triangle.phi.direction()));
    let along = [pin, across, inwards];
    let part = |at: usize| velocities[at].dot(&along[at]);
    Moment::default()
        .with([("R", triangle.crank_radius), ("r", triangle.slot_radius), ("l", triangle.distance)])
        .with([("v_P", part(0)), ("v_{P'}", part(1)), ("v_{P/S}", part(2))])
        .with([(r"\mathrm{v}_D", driver), (r"\mathrm{v}_S", -wheel)])
        .with_angles([(r"\theta", angle(&triangle.theta)), ("b", angle(&triangle.phi))])
        .with_angles([("g", [pin.dot(&inwards), pin.dot(&across)])])
        .requiring([0, 1, 2].map(|at| velocities[at].perp(&along[at])))
}

fn velocities(_: i64) -> Moment<Expression> {
    let Moving { velocities: [pin, point, sliding], .. } = Moving::new();
    Moment::default().with([(r"\text{v}_P", pin), (r"\text{v}_{P'}", point), (r"\text{v}_{P/S}", sliding)])
}

/// The sine of 30° is one half. Variables: tangent of b/2, l.
fn at_thirty(_: i64) -> Moment<Expression> {
    let [half_phi, distance] = from_fn(Expression::variable);
    let theta = Turn { cos: Expression::root() / 2, sin: Expression::ONE / 2 };
    let triangle = Triangle::new(distance, theta, Turn::from_half_tangent(&half_phi));
    Moment::default()
        .with([("R", triangle.crank_radius), ("r", triangle.slot_radius)])
        .replacing(r"\sin 30^\circ", triangle.theta.sin)
        .with_angles([("b", angle(&triangle.phi))])
        .with_root_of(3)
}

/// At rest, the pin moves along the slot. Variables: l, the driver's angular velocity.
fn four_slots(_: i64) -> Moment<Expression> {
    let [distance, driver] = from_fn(Expression::variable);
    let half = Expression::root() / 2;
    let eighth = Turn { cos: half, sin: half };
    let Moving { triangle, speeds: [_, wheel], .. } = Moving::of(Triangle::new(distance, eighth, eighth), driver);
    Moment::default()
        .with([("R", triangle.crank_radius), ("l", distance)])
        .giving(r"\sqrt{2}", Expression::root())
        .requiring([wheel])
        .with_root_of(2)
}

/// Crank radius, centre distance over it, crank angle over the right angle, angular velocity.
const STATES: [[f64; 4]; 4] =
    [[1.3, 1.4, 1.75, 0.8], [0.7, 2.2, 1.62, 2.5], [2.1, 1.2, 1.8, 1.7], [1.6, 3.1, 1.7, 0.6]];

fn cranks() -> impl Iterator<Item = Crank> {
    STATES.into_iter().map(|[radius, ratio, quarters, speed]| Crank {
        ground: ratio * radius,
        radius,
        angle: quarters * PI / 2.0,
        speed,
        acceleration: 0.0,
    })
}

/// The letters of one state, from where the pin is and where the slot's point goes.
fn state(crank: &Crank) -> Moment {
    let [[distance, sliding, _], [slot, turning, _]] = crank.polar();
    let ([place, pin, _], [_, point, _]) = (crank.pin_motion(), crank.point_motion());
    let velocity_angle = libm::atan2(pin.perp(&place).abs(), -pin.dot(&place));
    Moment::default()
        .with([("R", crank.radius), ("l", crank.ground), ("r", distance), ("b", slot), (r"\theta", PI - crank.angle)])
        .with([("v_P", pin.norm()), ("v_{P'}", point.norm()), ("v_{P/S}", sliding.abs()), ("g", velocity_angle)])
        .with([(r"\mathrm{v}_D", crank.speed), (r"\mathrm{v}_S", turning.abs())])
}

fn speeds_in_numbers() -> &'static [Moment] {
    static STATES: OnceLock<Vec<Moment>> = OnceLock::new();
    STATES.get_or_init(|| cranks().map(|crank| state(&crank)).collect())
}

fn velocities_in_numbers() -> &'static [Moment] {
    static STATES: OnceLock<Vec<Moment>> = OnceLock::new();
    let velocities = |crank: Crank| {
        let [[_, sliding, _], [slot, ..]] = crank.polar();
        let relative = Turn::from_radians(slot).direction() * sliding;
        Moment::default().with([
            (r"\text{v}_P", crank.pin_motion()[1]),
            (r"\text{v}_{P'}", crank.point_motion()[1]),
            (r"\text{v}_{P/S}", relative),
        ])
    };
    STATES.get_or_init(|| cranks().map(velocities).collect())
}

fn thirty_in_numbers() -> &'static [Moment] {
    static STATES: OnceLock<Vec<Moment>> = OnceLock::new();
    STATES.get_or_init(|| cranks().map(|crank| state(&Crank { angle: 150f64.to_radians(), ..crank })).collect())
}

fn four_slots_in_numbers() -> &'static [Moment] {
    static STATES: OnceLock<Vec<Moment>> = OnceLock::new();
    let state =
        |radius: f64| Moment::default().with([("R", radius), ("l", radius * ratio_with_standstill_at(PI / 4.0))]);
    STATES.get_or_init(|| [0.75, 1.5].map(state).into())
}

/// Whether an equation in which a number is rounded is exact for a number that rounds to it, with this value of a letter: at
/// the two ends of what its digits leave open, the sides differ in opposite senses. None if it cannot be read.
pub(super) fn makes_exact(tex: &str, (letter, value): (&str, f64)) -> Option<bool> {
    let digits = geneva_evidence::numeric_tokens(tex).into_iter().find(|token| token.contains('.'))?;
    let ends = digits.parse::<Decimal>().ok()?.interval();
    let (left, right) = tex.split_once('=')?;
    let letters = Moment::default().with([(letter, value)]).letters().clone();
    let [low, high] = ends.map(|end| {
        let right = right.replacen(&digits, &format!("{end}"), 1);
        geneva_evidence::tex::value(&format!("{left} - ({right})"), &letters)
    });
    (low.is_finite() && high.is_finite()).then_some(low * high < 0.0)
}
