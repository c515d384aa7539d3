//! The blows of a pin with play, from their impulse: what momentum it hands over and what energy is then gone.
//!
//! Nothing holds the parts between the flanks: the driver has the torque alone and the follower keeps its speed. The pin is a
//! point, and the play is in crank radii.

use super::contact::{ContactModel, Stance, dot, moment};
use super::halve;

/// Speeds and energies of a blow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Impact {
    /// Speed with which pin and flank meet, across the slot, in crank radii per unit of time.
    pub closing_speed: f64,
    /// Kinetic energy that is gone, in the unit of the torque.
    pub energy: f64,
    /// That energy over the work of the torque from one pin to the next.
    pub share: f64,
}

/// Instants into which the way across the play is divided.
const INSTANTS: u32 = 4000;

impl ContactModel {
    /// The blow on the trailing flank, after the pin has left the leading one at this angle and speed of the driver. None if the
    /// pin leaves the slot before.
    pub(crate) fn crossing(&self, angle: f64, speed: f64, play: f64) -> Option<Impact> {
        let stance = self.stance(angle);
        self.flight([angle, speed], stance.along, stance.ratio * speed, play)
    }

    /// The blow on the leading flank as a pin enters at this speed of the driver into a slot at rest, in whose middle it is.
    pub(crate) fn entry(&self, speed: f64, play: f64) -> Option<Impact> {
        self.flight([-self.half, speed], self.stance(-self.half).along, 0.0, play / 2.0)
    }

    /// Follows pin and slot until the pin is so far from the slot's middle.
    fn flight(&self, [angle, speed]: [f64; 2], slot: [f64; 2], follower: f64, width: f64) -> Option<Impact> {
        let acceleration = self.torque / self.inertias[0];
        let driver = |time: f64| [angle + time * (speed + acceleration * time / 2.0), speed + acceleration * time];
        // The slot turns clockwise.
        let turned = |time: f64| {
            let (sine, cosine) = (-follower * time).sin_cos();
            [slot[0] * cosine - slot[1] * sine, slot[0] * sine + slot[1] * cosine]
        };
        let from_follower = |stance: &Stance| [stance.pin[0] - self.ratio, stance.pin[1]];
        let off = |time: f64| moment(turned(time), from_follower(&self.stance(driver(time)[0]))).abs() - width;
        // No pin is in its slot for longer than this.
        let step = 2.0 * self.half / speed / f64::from(INSTANTS);
        let before = (0..INSTANTS).map(|k| step * f64::from(k)).find(|time| off(time + step) > 0.0)?;
        let [high, _] = halve(60, [before + step, before], |time| off(time) > 0.0);
        let [angle, speed] = driver(high);
        (angle < self.half).then(|| self.impact(&self.stance(angle), turned(high), speed, follower))
    }

    /// What an impulse does that leaves pin and flank at one speed across the slot.
    fn impact(&self, stance: &Stance, slot: [f64; 2], driver: f64, follower: f64) -> Impact {
        let across = [slot[1], -slot[0]];
        // The flank's distance from the follower's axis, and the pin's way across the slot for each radian of the driver.
        let arms = [dot(stance.velocity, across), dot([stance.pin[0] - self.ratio, stance.pin[1]], slot)];
        let closing = |driver: f64, follower: f64| arms[0] * driver - arms[1] * follower;
        let after = |impulse: f64| {
            [driver - impulse * arms[0] / self.inertias[0], follower + impulse * arms[1] / self.inertias[1]]
        };
        // The closing speed falls evenly with the impulse: the impulse with which nothing is left.
        let [before, with_one] = [closing(driver, follower), closing(after(1.0)[0], after(1.0)[1])];
        let impulse = before / (before - with_one);
        let energy = |[driver, follower]: [f64; 2]| {
            (self.inertias[0] * driver * driver + self.inertias[1] * follower * follower) / 2.0
        };
        let energy = energy([driver, follower]) - energy(after(impulse));
        Impact { closing_speed: before.abs(), energy, share: energy / (self.torque * 2.0 * self.half) }
    }
}
