//! Where the power goes.

use super::equation::{Escapement, Motion};
use super::error::JointError;

/// Power at one instant, torque times radians per unit of time. Work done, when the rates are summed over a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power {
    /// K θ', from the spring.
    pub input: f64,
    /// μ |N| times the sliding speed of the pin's surface; not negative.
    pub sliding: f64,
    /// Into the driver's bearing; not negative.
    pub driver_bearing: f64,
    /// Into the follower's bearing; not negative.
    pub follower_bearing: f64,
}

impl Power {
    /// What friction takes in all three places.
    pub fn losses(&self) -> f64 {
        self.sliding + self.driver_bearing + self.follower_bearing
    }

    /// Growth of the kinetic energy of both members.
    pub fn growth(&self) -> f64 {
        self.input - self.losses()
    }

    /// All four times a factor.
    pub(super) fn times(&self, factor: f64) -> Self {
        Self {
            input: self.input * factor,
            sliding: self.sliding * factor,
            driver_bearing: self.driver_bearing * factor,
            follower_bearing: self.follower_bearing * factor,
        }
    }
}

impl Escapement {
    /// Where the power goes at a crank angle (radians, within the engagement) and a speed of the driver (≥ 0).
    ///
    /// # Errors
    ///
    /// As for [`Escapement::motion`].
    pub fn power(&self, angle: f64, speed: f64) -> Result<Power, JointError> {
        let motion = self.motion(angle, speed)?;
        Ok(self.work_rate(self.place(angle).reach.ratio, &motion).times(speed))
    }

    /// The power over θ', that is the work per radian of the driver.
    pub(super) fn work_rate(&self, ratio: f64, motion: &Motion) -> Power {
        let load = motion.normal_moment.abs();
        let joints = self.joints();
        Power {
            input: self.parameters().torque(),
            sliding: self.parameters().friction() * load * motion.sliding.abs(),
            driver_bearing: self.journals.driver * load + joints.driver_preload,
            follower_bearing: (self.journals.follower * load + joints.follower_preload) * ratio,
        }
    }
}
