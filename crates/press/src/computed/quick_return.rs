//! Of the quick-return mechanism: its strokes, and the answers to the exercises.

use super::{Number, degrees, with_unit};
use anyhow::Context;
use geneva_kinematics::quick_return::{Branch, Motion, Position};
use geneva_ledger::quick_return::Instant;

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("quick-return.swing-limit", || {
        let limit = Instant::printed()?.linkage.strokes().swing_limit.context("the lever does not swing")?;
        Ok(degrees(limit))
    }),
    ("quick-return.slow-stroke", || Ok(degrees(Instant::printed()?.linkage.strokes().slow))),
    ("quick-return.fast-stroke", || Ok(degrees(Instant::printed()?.linkage.strokes().fast))),
    ("quick-return.time-ratio", || Ok(format!("{:.2}", Instant::printed()?.linkage.strokes().time_ratio()))),
    ("quick-return.ten.angle-at-pin", || lower(|of| degrees(of.position.angle_at_pin()))),
    ("quick-return.ten.crank-angle", || lower(|of| degrees(of.position.crank.radians()))),
    ("quick-return.ten.lever-length", || lower(|of| with_unit(of.position.pin_distance, 3, "m"))),
    ("quick-return.ten.lever-point-speed", || lower(|of| of.speed(Seen::lever_point))),
    ("quick-return.ten.sliding-speed", || lower(|of| of.speed(Seen::sliding))),
    ("quick-return.ten.lever-speed", || lower(|of| of.lever_speed())),
    ("quick-return.ten.lever-normal", || lower(|of| of.acceleration(Seen::lever_normal))),
    ("quick-return.ten.coriolis", || lower(|of| of.acceleration(Seen::coriolis))),
    ("quick-return.ten.sliding-acceleration", || lower(|of| of.acceleration(Seen::sliding_tangential))),
    ("quick-return.ten.lever-tangential", || lower(|of| of.acceleration(Seen::lever_tangential))),
    ("quick-return.ten.lever-acceleration", || lower(|of| of.lever_acceleration())),
    ("quick-return.near.angle-at-pin", || near(|of| degrees(of.position.angle_at_pin()))),
    ("quick-return.near.lever-length", || near(|of| with_unit(of.position.pin_distance, 3, "m"))),
    ("quick-return.near.lever-speed", || near(|of| of.lever_speed())),
    ("quick-return.near.lever-normal", || near(|of| of.acceleration(Seen::lever_normal))),
    ("quick-return.near.coriolis", || near(|of| of.acceleration(Seen::coriolis))),
    ("quick-return.near.sliding-acceleration", || near(|of| of.acceleration(Seen::sliding_tangential))),
    ("quick-return.near.lever-tangential", || near(|of| of.acceleration(Seen::lever_tangential))),
    ("quick-return.near.lever-acceleration", || near(|of| of.lever_acceleration())),
];

/// The lever angle of the first exercise, in degrees.
const LOWER: f64 = 10.0;

/// The mechanism of the problem at an instant.
struct Seen {
    position: Position,
    motion: Motion<f64>,
}

fn lower(write: fn(&Seen) -> String) -> anyhow::Result<String> {
    let mut instant = Instant::printed()?;
    instant.position = instant.linkage.at_lever_degrees(LOWER, Branch::Far)?;
    seen(&instant, write)
}

fn near(write: fn(&Seen) -> String) -> anyhow::Result<String> {
    seen(&Instant::on(Branch::Near)?, write)
}

fn seen(instant: &Instant, write: fn(&Seen) -> String) -> anyhow::Result<String> {
    let motion = instant.by_diagrams().context("the pin is on the pivot")?;
    Ok(write(&Seen { position: instant.position.clone(), motion }))
}

impl Seen {
    fn lever_point(&self) -> f64 {
        self.motion.velocities.slot_point_velocity.norm()
    }

    fn sliding(&self) -> f64 {
        self.motion.velocities.sliding_velocity.norm()
    }

    fn lever_normal(&self) -> f64 {
        self.motion.accelerations.follower_normal.norm()
    }

    fn lever_tangential(&self) -> f64 {
        self.motion.accelerations.follower_tangential.norm()
    }

    fn sliding_tangential(&self) -> f64 {
        self.motion.accelerations.sliding_tangential.norm()
    }

    fn coriolis(&self) -> f64 {
        self.motion.accelerations.coriolis.norm()
    }

    fn speed(&self, of: fn(&Self) -> f64) -> String {
        with_unit(of(self), 3, "m/s")
    }

    fn acceleration(&self, of: fn(&Self) -> f64) -> String {
        with_unit(of(self), 3, "m/s²")
    }

    fn lever_speed(&self) -> String {
        with_unit(self.motion.velocities.follower_speed.abs(), 3, "rad/s")
    }

    fn lever_acceleration(&self) -> String {
        with_unit(self.motion.accelerations.follower_acceleration.abs(), 3, "rad/s²")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_senses_that_the_solutions_tell_are_those_of_the_motion() {
        let motion = |instant: Instant| instant.by_diagrams().expect("off the pivot");
        let mut ten = Instant::printed().expect("a mechanism");
        ten.position = ten.linkage.at_lever_degrees(LOWER, Branch::Far).expect("reached");
        let (ten, near) = (motion(ten), motion(Instant::on(Branch::Near).expect("a mechanism")));
        // Of the lever's angular velocity and acceleration, of the sliding velocity: counter-clockwise, outwards.
        let senses = |of: &Motion<f64>| {
            let outwards = of.velocities.sliding_velocity.dot(&of.velocities.position);
            [of.velocities.follower_speed, of.accelerations.follower_acceleration, outwards].map(f64::signum)
        };
        assert_eq!(senses(&ten), [1.0, -1.0, -1.0]);
        assert_eq!(senses(&near), [-1.0, -1.0, -1.0]);
        let along = |of: &Motion<f64>| of.accelerations.sliding_tangential.dot(&of.velocities.position).signum();
        let across = |of: &Motion<f64>| of.velocities.position.perp(&of.accelerations.coriolis).signum();
        assert_eq!([along(&ten), across(&ten)], [-1.0, -1.0]);
        assert_eq!([along(&near), across(&near)], [1.0, 1.0]);
    }
}
