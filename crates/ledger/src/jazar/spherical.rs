//! What is said of spherical Geneva mechanisms.

use super::*;
use geneva_kinematics::{Expression, Identity, angular_velocity, prove};
use nalgebra::{Vector2, Vector3};

/// The claim on the shafts of spherical wheels.
pub fn angulated() -> Claim {
    at("Sentences on spherical mechanisms")
        .statement(
            "jazar.spherical-shafts",
            "between angulated shafts",
            "with its axis at an angle to the driver's, a wheel is moved on by a station, and is at rest at both ends",
        )
        .by(Vectors, |stated| {
            let angles = stated.pick(vec![60.0, 90.0, 120.0], vec![0.0]);
            let indexed = |stations: u32| angles.iter().all(|angle: &f64| indexes(stations, angle.to_radians()));
            let failing = STATIONS.clone().find(|stations| !indexed(*stations));
            let but = failing.map_or(String::new(), |stations| format!("; not with {stations}"));
            Finding::new(
                failing.is_none(),
                format!("shafts at {angles:?}°: the pin enters and leaves along meridians a station apart{but}"),
            )
        })
        .by(ExactIdentity, |stated| prove(&RestAtTheEnds { parallel: stated.pick(false, true) }).into())
        .but_not("between parallel shafts, by pins on the same sphere")
        .read_as("For these angles of the shafts and all numbers of stations that are tried elsewhere.")
}

/// Whether a pin on a sphere about the point where the axes meet, on a circle about the driver's, moves a wheel on by one
/// of so many stations: at two places it moves along a meridian of the wheel, and these are a station apart.
fn indexes(stations: u32, between_the_axes: f64) -> bool {
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
    sine > 0.0 && ends.iter().all(|(_, across)| vanishes(*across)) && agrees((ends[1].0 - ends[0].0).abs(), 2.0 * half)
}

/// A quarter of a turn from the middle, the wheel of shafts at right angles is at rest: the rate of the direction in which
/// the pin is seen along the wheel's axis. For parallel shafts that direction is the driver's own.
///
/// Variable: the tangent of a quarter of the angle between two slots.
struct RestAtTheEnds {
    parallel: bool,
}

impl Identity<1> for RestAtTheEnds {
    fn difference(&self, [half]: [Expression; 1]) -> Expression {
        let alpha = Turn::from_half_tangent(&half);
        let crank = Turn { cos: Expression::ZERO, sin: Expression::ONE }.moving::<2>(Expression::ONE);
        let along = if self.parallel { Jet::constant(alpha.sin) * crank.cos } else { Jet::constant(alpha.cos) };
        let seen = Vector2::new(along, Jet::constant(alpha.sin) * crank.sin);
        angular_velocity(&seen).map_or(Expression::ONE, |rate| rate.value())
    }
}
