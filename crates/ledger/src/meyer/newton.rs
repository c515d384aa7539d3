//! Driver and follower by Newton's laws, for any numbers of pins and slots and in any unit of length.
//!
//! Places and velocities are vectors, the forces in the slot follow from what the follower's acceleration asks for.
//! Nothing here is a display of the source or a formula of the other crates: it is a second route to the motion.

use super::*;
use geneva_mimic::runge_kutta_step;
use nalgebra::Vector1;
use std::convert::Infallible;

/// A driver and a follower with a thin pin in a slot between them.
#[derive(Clone, Copy)]
pub struct Newton {
    /// Radius of the circle of the pins.
    pub radius: f64,
    /// Distance of the two axes, greater than the radius.
    pub distance: f64,
    pub friction: f64,
    /// Moments of inertia.
    pub driver: f64,
    pub follower: f64,
}

/// The pin in its slot at one angle, for a driver of angular velocity one.
struct InSlot {
    /// From the driver's axis.
    pin: Vector2<f64>,
    /// Unit vectors outwards along the slot and across it.
    along: Vector2<f64>,
    across: Vector2<f64>,
    /// Distance of the pin from the follower's axis.
    out: f64,
    velocity: Vector2<f64>,
}

impl InSlot {
    /// The follower's angular velocity, in the driver's sense.
    fn turning(&self) -> f64 {
        self.across.dot(&self.velocity) / self.out
    }

    fn sliding(&self) -> f64 {
        self.along.dot(&self.velocity)
    }
}

/// The result of an engagement.
#[derive(Clone, Copy)]
pub struct Passage {
    /// Square of the driver's speed at the end.
    pub end: f64,
    /// Duration of the engagement.
    pub duration: f64,
}

impl Newton {
    fn in_slot(&self, angle: f64) -> InSlot {
        let direction = Turn::from_radians(angle).direction();
        let pin = direction * self.radius;
        let place = pin - Vector2::new(self.distance, 0.0);
        let along = place.normalize();
        let velocity = quarter_turn(&pin);
        InSlot { pin, along, across: quarter_turn(&along), out: place.norm(), velocity }
    }

    /// The driver's angular acceleration under a torque; none if no force in the slot, or more than one, agrees with
    /// it.
    pub fn acceleration(&self, angle: f64, speed: f64, torque: f64) -> Option<f64> {
        let at = self.in_slot(angle);
        let (turning, sliding, square) = (at.turning(), at.sliding(), speed * speed);
        // The follower's acceleration is a part of the driver's and what the motion asks for: centripetal and Coriolis.
        let carried = (at.across.dot(&-at.pin) - 2.0 * sliding * turning) * square / at.out;
        let [per_gain, at_rest] = [turning, carried].map(|part| self.follower * part / at.out);
        let fits = |side: f64| {
            // Force across the slot with this sign, and friction along it against the sliding.
            let force = at.across + at.along * (self.friction * side * sliding.signum());
            let arm = at.pin.perp(&force);
            let inertia = self.driver + per_gain * arm;
            let angular_acceleration = (torque - at_rest * arm) / inertia;
            (inertia > 0.0 && side * (at_rest + per_gain * angular_acceleration) >= 0.0).then_some(angular_acceleration)
        };
        match (fits(1.0), fits(-1.0)) {
            (Some(angular_acceleration), None) | (None, Some(angular_acceleration)) => Some(angular_acceleration),
            (Some(one), Some(other)) => (one == other).then_some(one),
            (None, None) => None,
        }
    }

    /// An engagement from minus this angle to plus it, from a square of the speed at entry, in equal steps; none if the
    /// driver does not come through. The torque may depend on the angle turned in the engagement.
    pub fn engagement(&self, half: f64, entry: f64, torque: &dyn Fn(f64) -> f64, steps: u32) -> Option<Passage> {
        let step = 2.0 * half / f64::from(steps);
        let slope = |angle: f64, square: f64| {
            let angular_acceleration = self.acceleration(angle, square.max(0.0).sqrt(), torque(angle + half));
            Vector1::new(2.0 * angular_acceleration.unwrap_or(f64::NAN))
        };
        let (mut square, mut duration) = (entry, 0.0);
        for k in 0..steps {
            let [from, to] = [k, k + 1].map(|k| step * f64::from(k) - half);
            let rate = |angle: f64, state: &Vector1<f64>| Ok::<_, Infallible>(slope(angle, state[0]));
            let Ok(next) = runge_kutta_step(rate, from, to, &Vector1::new(square), &slope(from, square));
            // Exact where the square of the speed is linear in the angle.
            duration += 2.0 * step / (square.sqrt() + next[0].sqrt());
            square = next[0];
        }
        duration.is_finite().then_some(Passage { end: square, duration })
    }
}
