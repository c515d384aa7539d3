//! What the handout says of spherical Geneva mechanisms.

use super::*;
use geneva_evidence::agreement::joined;
use geneva_kinematics::{Expression, Identity, angular_velocity, prove};
use nalgebra::{Vector2, Vector3};

const SENTENCES: Locator = at("Sentences on spherical mechanisms");

/// The claims on spherical wheels.
pub(super) fn claims() -> Vec<Claim> {
    vec![angulated(), locking()]
}

fn angulated() -> Claim {
    SENTENCES
        .statement(
            "jazar.spherical-shafts",
            "between angulated shafts",
            "a wheel whose axis is at an angle to the driver's axis is moved on by one station, and it is at rest at \
             both ends of the move",
        )
        .first_route(Evidence::VECTORS, |stated| {
            let indexed = |stations: u32| {
                ANGLES.iter().all(|angle| indexes(stations, angle.to_radians(), stated.pick(false, true)))
            };
            let failing = STATIONS.clone().filter(|stations| !indexed(*stations)).count();
            let of = match failing {
                0 => "each number of stations".to_owned(),
                _ => format!(
                    "{} of {} numbers of stations",
                    STATIONS.clone().count() - failing,
                    STATIONS.clone().count()
                ),
            };
            Finding::new(
                failing == 0,
                format!(
                    "with shafts at {} degrees and {of}, the pin enters and leaves along meridians one station apart{}",
                    joined(ANGLES),
                    stated.pick("", ", half a turn of the driver after each other")
                ),
            )
        })
        .second_route(Evidence::EXACT_IDENTITY, |stated| {
            let quarter = stated.pick(false, true);
            let [rest, step]: [Finding; 2] =
                [prove(&RestAtTheEnds { quarter }).into(), prove(&StepOfAStation { quarter }).into()];
            Finding::of_cases(rest.holds && step.holds, &[rest, step])
        })
        .but_not("it also takes half of the driver's turn at every angle between the shafts")
        .interpreted_as(
            "We tried this with shafts at 60°, 90° and 120°, for all numbers of stations that we try elsewhere. A \
             proof covers any angle at which there is room for the pin.",
        )
}

fn locking() -> Claim {
    SENTENCES
        .statement(
            "jazar.spherical-locking",
            "without losing positive locking",
            "a spherical wheel can have many stations and still be locked between two advances",
        )
        .missing(
            "By the text, a spherical wheel keeps something that a planar wheel loses, but the text does not say what. If the length of the locking \
             arcs in wheel radii is meant, a spherical wheel with axes at right angles loses as much. If the mere \
             ability to lock is meant, a planar wheel keeps it, too",
        )
}

/// The angles between the shafts that are tried, in degrees.
const ANGLES: [f64; 3] = [60.0, 90.0, 120.0];

/// Whether a pin on a sphere about the point where the axes meet, on a circle about the driver's, moves a wheel on by one
/// of so many stations: at two places it moves along a meridian of the wheel, and these are a station apart. If `half`,
/// also whether these places are half a turn of the driver apart.
fn indexes(stations: u32, between_the_axes: f64, half_a_turn: bool) -> bool {
    let (tilt, upright) = libm::sincos(between_the_axes);
    let half = PI / f64::from(stations);
    // How far the pins are from the driver's axis, so that the two meridians touch their circle.
    let sine = libm::sin(half) * tilt;
    let cosine = (1.0 - sine * sine).sqrt();
    let axis = Vector3::new(tilt, 0.0, upright);
    let (to_the_wheel, aside) = (Vector3::new(-upright, 0.0, tilt), Vector3::y());
    // The crank angle from the place nearest to the wheel's axis: where the pin's velocity is towards that axis.
    let turn = sine * upright / (cosine * tilt);
    let out = (1.0 - turn * turn).sqrt();
    let ends = [-1.0, 1.0].map(|side| {
        let radial = to_the_wheel * turn + aside * (side * out);
        let pin = axis * cosine + radial * sine;
        let velocity = axis.cross(&pin);
        let across = pin.x * velocity.y - pin.y * velocity.x;
        (libm::atan2(pin.y, pin.x), across)
    });
    let rests = sine > 0.0 && ends.iter().all(|(_, across)| vanishes(*across));
    rests && agrees((ends[1].0 - ends[0].0).abs(), 2.0 * half) && (!half_a_turn || vanishes(turn))
}

/// A pin at the angle ρ from the driver's axis, and the crank angle θ from the place nearest to the wheel's axis.
struct Pin {
    /// The direction in which it is seen along the wheel's axis, but for the scale of the first coordinate.
    seen: Vector2<Jet<Expression, 2>>,
    /// sin ρ.
    sine: Expression,
    /// sin Σ and cos Σ of the angle between the shafts, over the scale.
    shafts: Turn<Expression>,
}

impl Pin {
    /// For the tangents of ρ/2 and θ/2: the wheel is at rest at ±θ between shafts at the angle Σ with
    /// tan Σ = tan ρ / cos θ. Where the crank is then, or a quarter of a turn from the middle.
    fn new([half_rho, half_theta]: [Expression; 2], quarter: bool) -> Self {
        let [rho, theta] = [half_rho, half_theta].map(|half| Turn::from_half_tangent(&half));
        let shafts = Turn { cos: rho.cos * theta.cos, sin: rho.sin };
        let at = if quarter { Turn { cos: Expression::ZERO, sin: Expression::ONE } } else { theta };
        let crank = at.moving::<2>(Expression::ONE);
        let along = Jet::constant(shafts.sin * rho.cos) - Jet::constant(shafts.cos * rho.sin) * crank.cos;
        Self { seen: Vector2::new(along, Jet::constant(rho.sin) * crank.sin), sine: rho.sin, shafts }
    }
}

/// The wheel is at rest at θ: the rate of the direction in which the pin is seen along the wheel's axis. Variables: the
/// tangents of ρ/2 and θ/2.
struct RestAtTheEnds {
    quarter: bool,
}

impl Identity<2> for RestAtTheEnds {
    fn difference(&self, variables: [Expression; 2]) -> Expression {
        let pin = Pin::new(variables, self.quarter);
        angular_velocity(&pin.seen).map_or(Expression::ONE, |rate| rate.value())
    }
}

/// The pin is then seen at the angle α from the middle with sin α sin Σ = sin ρ, squared: pins on a circle with
/// sin ρ = sin (π/N) sin Σ move the wheel by 2π/N. Variables: as above.
struct StepOfAStation {
    quarter: bool,
}

impl Identity<2> for StepOfAStation {
    fn difference(&self, variables: [Expression; 2]) -> Expression {
        let Pin { seen, sine, shafts } = Pin::new(variables, self.quarter);
        let [x, y] = [seen.x.value(), seen.y.value()].map(|coordinate| coordinate * coordinate);
        let [sine, tilt] = [sine * sine, shafts.sin * shafts.sin];
        // The square of the scale.
        let whole = tilt + shafts.cos * shafts.cos;
        y * tilt - sine * (x + y * whole)
    }
}
