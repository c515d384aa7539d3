//! Driver and follower by Newton's laws, for any number of pins and any number of slots and in any unit of length.
//!
//! Places and velocities are vectors, the forces in the slot follow from what the follower's acceleration asks for.
//! Nothing here is a display of the source or a formula of the other crates: it is a second route to the motion.

use super::*;
use geneva_case1973::witness::steps::step;

/// A driver and a follower with a thin pin in a slot between them.
#[derive(Clone, Copy)]
pub(super) struct Newton {
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
    fn angular_velocity(&self) -> f64 {
        self.across.dot(&self.velocity) / self.out
    }

    fn sliding(&self) -> f64 {
        self.along.dot(&self.velocity)
    }
}

/// Everything at one angle that speed and torque do not change.
struct Instant {
    /// Angle turned in the engagement.
    turned: f64,
    /// Distance of the pin from the follower's axis.
    out: f64,
    /// What the motion asks of the follower across the slot, centripetal and Coriolis, for a driver of angular velocity
    /// one.
    asked: f64,
    /// Moment of inertia of the follower.
    follower: f64,
    /// Force across the slot that the follower asks for per acceleration of the driver.
    force_per_acceleration: f64,
    /// For the two flanks of the slot, as the force across it is positive or negative.
    flanks: [Flank; 2],
}

/// A flank of the slot at one angle.
struct Flank {
    /// 1 or −1.
    side: f64,
    /// Moment about the driver's axis of a unit force across the slot, with its friction along it.
    arm: f64,
    /// Moment of inertia that the driver feels.
    inertia: f64,
}

impl Instant {
    /// The driver's angular acceleration under a torque; none if no force in the slot, or more than one, agrees with
    /// it.
    fn acceleration(&self, speed: f64, torque: f64) -> Option<f64> {
        // The follower's acceleration is a part of the driver's and what the motion asks for.
        let at_rest = self.follower * (self.asked * (speed * speed) / self.out) / self.out;
        let fits = |Flank { side, arm, inertia }: &Flank| {
            let angular_acceleration = (torque - at_rest * arm) / inertia;
            let presses = side * (at_rest + self.force_per_acceleration * angular_acceleration) >= 0.0;
            (*inertia > 0.0 && presses).then_some(angular_acceleration)
        };
        match (fits(&self.flanks[0]), fits(&self.flanks[1])) {
            (Some(angular_acceleration), None) | (None, Some(angular_acceleration)) => Some(angular_acceleration),
            (Some(one), Some(other)) => (one == other).then_some(one),
            (None, None) => None,
        }
    }
}

/// The result of an engagement.
#[derive(Clone, Copy)]
pub(super) struct Passage {
    /// Square of the driver's speed at the end.
    pub end: f64,
    /// Duration of the engagement.
    pub duration: f64,
}

/// The engagements of a driver and a follower from minus an angle to plus it, in equal steps.
pub(super) struct Engagements {
    step: f64,
    /// The angles at the ends of the steps, and the mechanism there and in the middle of each step.
    angles: Vec<f64>,
    ends: Vec<Instant>,
    middles: Vec<Instant>,
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

    fn instant(&self, angle: f64, turned: f64) -> Instant {
        let at = self.in_slot(angle);
        let (turning, sliding) = (at.angular_velocity(), at.sliding());
        let force_per_acceleration = self.follower * turning / at.out;
        let flank = |side: f64| {
            // Force across the slot with this sign, and friction along it against the sliding.
            let force = at.across + at.along * (self.friction * side * sliding.signum());
            let arm = at.pin.perp(&force);
            Flank { side, arm, inertia: self.driver + force_per_acceleration * arm }
        };
        Instant {
            turned,
            out: at.out,
            asked: at.across.dot(&-at.pin) - 2.0 * sliding * turning,
            follower: self.follower,
            force_per_acceleration,
            flanks: [1.0, -1.0].map(flank),
        }
    }

    /// The engagements from minus this angle to plus it, in so many steps.
    pub(super) fn engagements(&self, half: f64, steps: u32) -> Engagements {
        let step = 2.0 * half / f64::from(steps);
        let angles: Vec<f64> = (0..=steps).map(|k| step * f64::from(k) - half).collect();
        let instant = |angle: f64| self.instant(angle, angle + half);
        let ends = angles.iter().map(|angle| instant(*angle)).collect();
        let middles = angles.windows(2).map(|pair| instant(pair[0] + (pair[1] - pair[0]) / 2.0)).collect();
        Engagements { step, angles, ends, middles }
    }
}

impl Engagements {
    /// The engagement with this square of the speed at entry; none if the driver does not come through. The torque may
    /// depend on the angle turned in the engagement.
    pub(super) fn passage(&self, entry: f64, torque: &dyn Fn(f64) -> f64) -> Option<Passage> {
        let slope = |at: &Instant, square: f64| {
            let angular_acceleration = at.acceleration(square.max(0.0).sqrt(), torque(at.turned));
            2.0 * angular_acceleration.unwrap_or(f64::NAN)
        };
        let (mut square, mut duration) = (entry, 0.0);
        for ((angles, ends), middle) in self.angles.windows(2).zip(self.ends.windows(2)).zip(&self.middles) {
            let next = step(angles[1] - angles[0], square, [&ends[0], middle, &ends[1]], slope);
            // Exact where the square of the speed is linear in the angle.
            duration += 2.0 * self.step / (square.sqrt() + next.sqrt());
            square = next;
        }
        duration.is_finite().then_some(Passage { end: square, duration })
    }
}
