//! What the letters stand for at the hand-over, figure 4 and appendix A: exactly, from the foot of the perpendicular from the
//! driver's axis on the slot; and by numbers, from the pin of the three escapements by coordinates.

use super::*;
use crate::duals::{halved, ratio_with_standstill_at};
use crate::triangle::angle;
use geneva_evidence::Vocabulary;
use geneva_evidence::tex::Moment;
use geneva_kinematics::Expression;
use std::array::from_fn;
use std::sync::OnceLock;

/// Half the angles between two slots and two pins.
pub(super) const HALVES: Vocabulary = Vocabulary::new(halves, Evidence::VECTORS, in_numbers);
/// The large right triangle.
pub(super) const RIGHT_TRIANGLE: Vocabulary = Vocabulary::new(right_triangle, Evidence::VECTORS, in_numbers);
/// The right triangle with a for its ratio of lengths.
pub(super) const RATIO: Vocabulary = Vocabulary::new(ratio, Evidence::VECTORS, in_numbers);
/// Numbers of pins and slots, of which the angles of the triangle are parts of half a turn.
pub(super) const COUNTS: Vocabulary = Vocabulary::new(counts, Evidence::VECTORS, in_numbers);
/// The lengths for which the appendix computes 1/sin φ₀ as the centre distance.
pub(super) const UNIT: Vocabulary = Vocabulary::new(unit, Evidence::VECTORS, unit_in_numbers);

/// The sizes in the drawing of one mechanism, in the unit of appendix A.
pub(super) const fn drawn<const SLOTS: u32>() -> Vocabulary {
    Vocabulary::new(drawing::<SLOTS>, Evidence::VECTORS, drawing_in_numbers::<SLOTS>)
}

/// The slots divide a turn, and so do the pins. Variables: π, n, m.
fn halves(_: i64) -> Moment<Expression> {
    let [pi, slots, pins] = from_fn(Expression::variable);
    let [follower, driver] = [slots, pins].map(|count| (pi + pi) / count / 2);
    Moment::default().with([(r"\pi", pi), ("n", slots), ("m", pins)]).with([
        (r"\phi", follower),
        (r"\phi_0", follower),
        (r"\theta", driver),
        (r"\theta_0", driver),
    ])
}

/// Lengths for a centre distance and the angle of the slot, which is half the angle between two of them.
struct Foot {
    /// From the driver's axis to the pin, and from the pin to the follower's axis.
    crank_radius: Expression,
    slot_radius: Expression,
    /// Angle of the crank from the line of centres.
    crank: Turn<Expression>,
}

impl Foot {
    /// The pin is where the perpendicular from the driver's axis meets the slot.
    fn new(distance: Expression, slot: &Turn<Expression>) -> Self {
        let (along, axis) = (slot.direction(), Vector2::new(distance, Expression::ZERO));
        // From the driver's axis to the slot.
        let across = quarter_turn(&along);
        let crank_radius = -axis.dot(&across);
        let crank = Turn { cos: -across.x, sin: across.y };
        Self { crank_radius, slot_radius: axis.dot(&along), crank }
    }
}

/// Variables: c, tangent of φ₀/2.
fn right_triangle(_: i64) -> Moment<Expression> {
    let [distance, half] = from_fn(Expression::variable);
    let slot = Turn::from_half_tangent(&half);
    at_the_foot(distance, &slot).with([("a", 1 / slot.sin)])
}

/// Variables as in [`right_triangle`].
fn ratio(_: i64) -> Moment<Expression> {
    let [distance, half] = from_fn(Expression::variable);
    let slot = Turn::from_half_tangent(&half);
    let ratio = distance / Foot::new(distance, &slot).crank_radius;
    at_the_foot(distance, &slot).with([("a", ratio)])
}

fn at_the_foot(distance: Expression, slot: &Turn<Expression>) -> Moment<Expression> {
    let Foot { crank_radius, slot_radius, crank } = Foot::new(distance, slot);
    Moment::default()
        .with([("c", distance), ("r", crank_radius), ("R", slot_radius)])
        .with_angles([(r"\phi_0", angle(slot)), (r"\phi_o", angle(slot)), (r"\theta_o", angle(&crank))])
        // The program has N for n.
        .replacing(r"\sin(\pi/n)", slot.sin)
        .replacing(r"\sin(\pi/N)", slot.sin)
        .replacing(r"\cos(\pi/n)", slot.cos)
        .replacing(r"\cos(\pi/N)", slot.cos)
}

/// The two angles make a quarter turn, by the line before. Variables: θ₀, φ₀.
fn counts(_: i64) -> Moment<Expression> {
    let [driver, follower] = from_fn(Expression::variable);
    let pi = 2 * (driver + follower);
    Moment::default().with([(r"\pi", pi), ("n", pi / follower), ("m", pi / driver)])
}

/// Variable: tangent of φ₀/2.
fn unit(_: i64) -> Moment<Expression> {
    let slot = Turn::from_half_tangent(&Expression::variable(0));
    at_the_foot(1 / slot.sin, &slot)
}

/// The angle of the slot has a root of two or three.
fn drawing<const SLOTS: u32>(_: i64) -> Moment<Expression> {
    let (half, root) = (Expression::ONE / 2, Expression::root() / 2);
    let (slot, under, degrees) = match SLOTS {
        3 => (Turn { cos: half, sin: root }, 3, [r"\sin 60^\circ", r"\sin 30^\circ"]),
        4 => (Turn { cos: root, sin: root }, 2, [r"\sin 45^\circ", r"\sin 45^\circ"]),
        _ => (Turn { cos: root, sin: half }, 3, [r"\sin 30^\circ", r"\sin 60^\circ"]),
    };
    // The distance at which the crank has the unit of length.
    let Foot { crank_radius, .. } = Foot::new(Expression::ONE, &slot);
    let moment = at_the_foot(1 / crank_radius, &slot);
    let crank = Foot::new(Expression::ONE, &slot).crank;
    let counted = format!(r"\sin(\pi/{SLOTS})");
    moment
        .replacing(&counted, slot.sin)
        .replacing(degrees[0], slot.sin)
        .replacing(degrees[1], crank.sin)
        .with_root_of(under)
}

/// Radius of the circle of the pins: any number will do.
const RADIUS: f64 = 1.5;

/// The letters at the angle of the driver at which the follower stands still, with this radius of the pins' circle.
fn letters(escapement: &Mechanism, radius: f64) -> Moment {
    let ratio = ratio_with_standstill_at(PI / f64::from(escapement.slots()));
    let turning = |angle: f64| PinKinematics::driven(ratio, angle, (1.0, 0.0)).angular_velocity();
    let driver = halved([0.0, PI / 2.0], |angle| turning(angle) > 0.0)[0];
    let pin = PinKinematics::driven(ratio, driver, (1.0, 0.0));
    let follower = pin.angle();
    Moment::default()
        .with([("n", f64::from(escapement.slots())), ("m", f64::from(escapement.pins()))])
        .with([(r"\phi", follower), (r"\phi_0", follower), (r"\phi_o", follower)])
        .with([(r"\theta", driver), (r"\theta_0", driver), (r"\theta_o", driver)])
        .with([("r", radius), ("c", ratio * radius), ("a", ratio), ("R", pin.radius() * radius)])
}

fn in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    FOUND.get_or_init(|| Mechanism::ALL.iter().map(|at| letters(at, RADIUS)).collect())
}

fn unit_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    FOUND.get_or_init(|| Mechanism::ALL.iter().map(|at| letters(at, 1.0)).collect())
}

fn drawing_in_numbers<const SLOTS: u32>() -> &'static [Moment] {
    let at = Mechanism::ALL.iter().position(|at| at.slots() == SLOTS);
    at.map_or(&[], |at| &unit_in_numbers()[at..=at])
}
