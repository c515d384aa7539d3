//! How hard the members are accelerated in the steady motion, and how suddenly.

use super::TimerError;
use crate::Parameters;
use crate::steady::Engagement;

/// The greatest value of a quantity, by its size, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strongest {
    /// The value, with its sign.
    pub value: f64,
    /// Crank angle in radians from the line of centres.
    pub angle: f64,
}

/// Accelerations and forces of a steady cycle. Angular accelerations in radians per square of the unit of time; moments
/// in the unit of the torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accelerations {
    /// Of the driver, θ''.
    pub driver: Strongest,
    /// Of the follower, φ''.
    pub follower: Strongest,
    /// Normal force between pin and slot times the crank radius.
    pub normal_moment: Strongest,
    /// By how much the follower's acceleration jumps as one pin hands over to the next: entry less exit.
    pub jump: f64,
}

/// Into how many equal parts of its period the cycle is divided to find what is strongest.
///
/// Between two instants a smooth quantity changes by a few millionths of its own size near its extreme.
pub const INSTANTS: usize = 4000;

impl Accelerations {
    /// Of the steady motion of an escapement; to about four digits, as the cycle is looked at in [`INSTANTS`] parts.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]: without friction there is no steady state.
    pub fn new(parameters: &Parameters) -> Result<Self, TimerError> {
        let lines = Engagement::new(parameters)?.steady_cycle(INSTANTS)?;
        let nowhere = Strongest { value: 0.0, angle: f64::NAN };
        let mut found = Self { driver: nowhere, follower: nowhere, normal_moment: nowhere, jump: 0.0 };
        for line in &lines {
            let [driver, follower, normal] = at(parameters, line.angle, line.speed)?;
            found.driver.keep(driver, line.angle);
            found.follower.keep(follower, line.angle);
            found.normal_moment.keep(normal, line.angle);
        }
        if let (Some(first), Some(last)) = (lines.first(), lines.last()) {
            let [_, entry, _] = at(parameters, first.angle, first.speed)?;
            let [_, exit, _] = at(parameters, last.angle, last.speed)?;
            found.jump = entry - exit;
        }
        Ok(found)
    }
}

/// Accelerations of driver and follower and normal force times crank radius.
fn at(parameters: &Parameters, angle: f64, speed: f64) -> Result<[f64; 3], TimerError> {
    let driver = parameters.acceleration(angle, speed)?.value;
    let forces = parameters.contact_forces(angle, speed)?;
    Ok([driver, forces.follower_acceleration, forces.normal_moment])
}

impl Strongest {
    fn keep(&mut self, value: f64, angle: f64) {
        if value.abs() > self.value.abs() {
            *self = Self { value, angle };
        }
    }
}
