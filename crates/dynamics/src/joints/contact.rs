//! The contact of a pin of finite radius with a side of its slot: what slides, and which moments one normal force has.
//!
//! Let e point along the slot from the follower's axis to the pin's centre, at the distance R, and n across it, in the
//! sense in which the pin drives the follower on. On the follower acts N n + μ |N| σ e at R e + s ρ n, where s is the
//! sign of N and σ that of the sliding; on the driver the opposite force at the same point. The follower turns from e
//! towards n by φ', the driver in the opposite sense by θ'.
//!
//! *Sliding.* The pin's centre goes along the slot by R'. Its surface point s ρ n is taken along e by θ' s ρ, and the
//! slot's side there by −φ' s ρ. So the surface slides by R' + s ρ (θ' + φ').
//!
//! *Moment on the follower.* N has the arm R. The friction has the arm s ρ and turns it back: N R − σ μ |N| s ρ, and
//! s |N| = N, so N (R − σ μ ρ).
//!
//! *Moment on the driver.* The point of contact, moving with the driver, has the velocity φ' R across the slot and
//! R' + s ρ θ' along it. Over θ' these are the arms: N (q R + σ μ (s dR/dθ + ρ)) with q = φ'/θ', against the driver.
//!
//! *Journals.* Each member is balanced and lies in a level plane, and K is a couple. So what its bearing carries is the
//! force of the contact, N across the slot and μ |N| along it: |N| √(1 + μ²) on either. Its torque is in proportion to
//! that.

use super::Joints;
use crate::{Pose, Sign};
use geneva_kinematics::Field;

/// Place of the pin's centre in the slot, and its rates with the driver's angle. Lengths in crank radii.
///
/// ```
/// use geneva_dynamics::joints::Reach;
/// use geneva_dynamics::{Pose, Sign};
/// use geneva_kinematics::Turn;
///
/// // On the line of centres with a = 2: R = 1, both members at one speed, and the pin's centre does not slide.
/// let reach = Reach::from_pose(&Pose::new(&2.0, &Turn::from_radians(0.0)));
/// assert_eq!((reach.radius, reach.ratio, reach.slide), (1.0, 1.0, 0.0));
/// // The surface of a pin of a tenth of the crank radius slides, as it turns in the slot at twice the speed.
/// assert_eq!(reach.sliding(&0.1, Sign::Plus), 0.2);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Reach<S> {
    /// R, from the follower's axis, in crank radii.
    pub radius: S,
    /// q = φ'/θ', dimensionless; not negative in an engagement.
    pub ratio: S,
    /// dR/dθ, outward, in crank radii per radian.
    pub slide: S,
}

/// Moments of the contact about the two axes over its normal force N, in crank radii.
///
/// ```
/// use geneva_dynamics::joints::Reach;
/// use geneva_dynamics::{Pose, Sign};
/// use geneva_kinematics::Turn;
///
/// // Without friction the normal force alone acts: R on the follower, R φ'/θ' on the driver.
/// let reach = Reach::from_pose(&Pose::new(&2.0, &Turn::from_radians(0.0)));
/// let arms = reach.arms(&0.1, &0.0, Sign::Plus, Sign::Plus);
/// assert_eq!((arms.follower, arms.driver), (1.0, 1.0)); // crank radii
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Arms<S> {
    /// λ, what turns the follower on, in crank radii.
    pub follower: S,
    /// κ, what holds the driver back, in crank radii.
    pub driver: S,
}

impl Reach<f64> {
    /// The place for a pose: R² is its square, dR/dθ = a sin θ / R.
    pub fn from_pose(pose: &Pose<f64>) -> Self {
        let radius = pose.radius_squared.sqrt();
        // At the ends a cos θ − 1 is zero but for rounding.
        Self { radius, ratio: pose.numerator.max(0.0) / pose.radius_squared, slide: pose.k_sin_theta / radius }
    }
}

impl<S: Field> Reach<S> {
    /// Sliding of the pin's surface on the slot's side over θ', outward, in crank radii, for a pin of this radius on
    /// this flank (plus: leading): dR/dθ + s ρ (1 + q).
    pub fn sliding(&self, pin: &S, flank: Sign) -> S {
        self.slide.clone() + flank.apply(pin.clone() * (S::one() + self.ratio.clone()))
    }

    /// The arms for a pin of this radius with friction μ, on this flank, sliding outward (plus) or inward.
    pub fn arms(&self, pin: &S, friction: &S, flank: Sign, sliding: Sign) -> Arms<S> {
        let side = flank.apply(self.slide.clone()) + pin.clone();
        Arms {
            follower: self.radius.clone() - sliding.apply(friction.clone() * pin.clone()),
            driver: self.ratio.clone() * self.radius.clone() + sliding.apply(friction.clone() * side),
        }
    }
}

/// Arms of the journals' friction over |N|: torque against the rotation over normal force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Journals {
    /// Of the driver's journal, in crank radii.
    pub driver: f64,
    /// Of the follower's journal, in crank radii.
    pub follower: f64,
}

impl Journals {
    /// μ_b r_b √(1 + μ²) of either journal, for the friction μ between pin and slot.
    pub(super) fn new(joints: &Joints, friction: f64) -> Self {
        let load = (1.0 + friction * friction).sqrt();
        let arm = |radius: f64| joints.bearing_friction * radius * load;
        Self { driver: arm(joints.driver_journal), follower: arm(joints.follower_journal) }
    }
}

impl<S: Field> Arms<S> {
    /// This contact with journals whose torques have these arms over |N| = s N: both take from what the force gives.
    pub fn with_journals(&self, driver: &S, follower: &S, flank: Sign) -> Self {
        Self {
            follower: self.follower.clone() - flank.apply(follower.clone()),
            driver: self.driver.clone() + flank.apply(driver.clone()),
        }
    }
}
