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
/// Where a quantity is smooth at its strongest, the parabola through three instants leaves an error of some millionths.
pub const INSTANTS: usize = 4000;

impl Accelerations {
    /// Of the steady motion of an escapement; to about four digits where a quantity has a kink at its strongest, and to
    /// more elsewhere.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]: without friction there is no steady state.
    pub fn new(parameters: &Parameters) -> Result<Self, TimerError> {
        let lines = Engagement::new(parameters)?.steady_cycle(INSTANTS)?;
        let all = lines.iter().map(|line| Ok((line.angle, at(parameters, line.angle, line.speed)?)));
        let all = all.collect::<Result<Vec<_>, TimerError>>()?;
        let jump = match all.as_slice() {
            [(_, first), .., (_, last)] => first[1] - last[1],
            _ => 0.0,
        };
        Ok(Self {
            driver: Strongest::of(&all, 0),
            follower: Strongest::of(&all, 1),
            normal_moment: Strongest::of(&all, 2),
            jump,
        })
    }
}

/// Accelerations of driver and follower and normal force times crank radius.
fn at(parameters: &Parameters, angle: f64, speed: f64) -> Result<[f64; 3], TimerError> {
    let driver = parameters.acceleration(angle, speed)?.value;
    let forces = parameters.contact_forces(angle, speed)?;
    Ok([driver, forces.follower_acceleration, forces.normal_moment])
}

impl Strongest {
    /// Of one of three quantities at instants that are equally far apart: by the parabola through the strongest and its
    /// neighbours.
    fn of(instants: &[(f64, [f64; 3])], quantity: usize) -> Self {
        let value = |(_, values): &(f64, [f64; 3])| values[quantity];
        let strength = |at: &usize| libm::fabs(value(&instants[*at]));
        let Some(at) = (0..instants.len()).max_by(|a, b| strength(a).total_cmp(&strength(b))) else {
            return Self { value: 0.0, angle: f64::NAN };
        };
        let here = &instants[at];
        let beside = at.checked_sub(1).and_then(|before| Some((instants.get(before)?, instants.get(at + 1)?)));
        let Some((before, after)) = beside else { return Self { value: value(here), angle: here.0 } };
        let along = |a: f64, b: f64, c: f64, shift: f64| b + shift * ((c - a) / 2.0 + shift * (a - 2.0 * b + c) / 2.0);
        let (a, b, c) = (value(before), value(here), value(after));
        let bend = a - 2.0 * b + c;
        let shift = if bend == 0.0 { 0.0 } else { (a - c) / (2.0 * bend) };
        Self { value: along(a, b, c, shift), angle: along(before.0, here.0, after.0, shift) }
    }
}
