//! The journals: torque in proportion to the load that the contact puts on them.
//!
//! Each member is balanced and lies in a level plane, and K is a couple. So what its bearing carries is the force of
//! the contact, N across the slot and μ |N| along it: |N| √(1 + μ²) on either.

use super::Joints;
use super::contact::Arms;
use crate::Sign;
use geneva_kinematics::Field;

/// Arms of the journals' friction over |N|, in crank radii: torque against the rotation over normal force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Journals {
    pub driver: f64,
    pub follower: f64,
}

impl Journals {
    /// μ_b r_b √(1 + μ²) of either journal, for the friction μ between pin and slot.
    pub fn new(joints: &Joints, friction: f64) -> Self {
        let load = (1.0 + friction * friction).sqrt();
        let arm = |radius: f64| joints.bearing_friction * radius * load;
        Self { driver: arm(joints.driver_journal), follower: arm(joints.follower_journal) }
    }
}

impl<S: Field> Arms<S> {
    /// With journals whose torques have these arms over |N| = s N: both take from what the force gives.
    pub fn with_journals(&self, driver: &S, follower: &S, flank: Sign) -> Self {
        Self {
            follower: self.follower.clone() - flank.of(follower.clone()),
            driver: self.driver.clone() + flank.of(driver.clone()),
        }
    }
}
