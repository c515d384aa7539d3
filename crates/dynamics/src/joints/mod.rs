//! The escapement with joints that are not ideal: a pin with a radius, journals with friction.
//!
//! Meyer 1973 takes the pin for a point and the bearings for frictionless, and recommends (Recommendation 3) that the
//! dimensions of pin and slot and the friction in the bearings, "not necessarily constant", be looked into. This is the
//! model for it. With every size zero it is Eq. (1-19) again.
//!
//! # What is assumed
//!
//! - The pin is a cylinder of radius ρ, made fast to the driver. The slot has straight parallel sides, 2 ρ apart: no
//!   clearance. A pin that carries a roller is another mechanism and is not treated.
//! - The pin bears on one side at a time: with N > 0 on the leading flank, with N < 0 on the trailing one. The normal
//!   goes through the pin's centre, so its moments do not depend on ρ.
//! - Friction μ |N| acts where they touch, ρ beside the slot's centre line, along the slot, against the sliding of the
//!   pin's surface on the slot's side. The pin turns in the slot by θ' + φ', and its surface slides by ρ times that in
//!   addition to the sliding of its centre.
//! - The plane is level and both members are balanced, and the torque K is a pure couple. So the bearing of either
//!   member has to carry the force of the contact and nothing else: |N| √(1 + μ²).
//! - A journal of radius r_b with friction μ_b resists with μ_b r_b times that load, against the rotation. Besides,
//!   either bearing may resist with a constant torque, a drag torque.
//! - The follower stands still at the two ends of an engagement. There the bearing's torque is taken as an instant
//!   after entry and an instant before exit, against forward rotation; the two instants count for nothing in the
//!   motion. At rest in the entry N is the limit from within too, and counts as pressing on the leading flank.
//! - At the hand-over one pin carries: the one that enters. The speed is handed on unchanged.
//!
//! # What comes of it
//!
//! The pin bears on the same flank as it would without any friction (`equation`). At entry and at exit the centre of
//! the pin slides with the crank's speed r θ', but the surface of a thick one with (r − ρ) θ' only: it partly rolls. On
//! the line of centres it slides faster than a thin one. Over whole engagements a thicker pin costs less and speeds the
//! timer up; journals and drag torques slow it down: so it came out for inertias like those of the thesis, and the
//! tests hold it. Journals brake even without friction in the slot; constant torques alone do not.
//!
//! ```
//! use geneva_dynamics::joints::{Joints, Varied, series};
//! use geneva_dynamics::{Inertias, Parameters};
//! use geneva_kinematics::Mechanism;
//!
//! let inertias = Inertias::new(0.1, 1.0).expect("two inertias");
//! let parameters = Parameters::new(Mechanism::FOUR_PIN, inertias, 1.0, 0.2).expect("an escapement");
//! let thicker = series(&parameters, &Joints::IDEAL, Varied::PinRadius, [0.0, 0.1]).expect("it runs");
//! assert!(thicker[1].mean_speed > 1.0);
//! let journals = Joints::journals(0.1, 0.0);
//! let rougher = series(&parameters, &journals, Varied::BearingFriction, [0.0, 0.1]).expect("it runs");
//! assert!(rougher[1].mean_speed < 1.0);
//! ```
//!
//! # In order
//!
//! Lengths are in crank radii, so that a normal force becomes a moment N r. The contact and its moments (`contact`)
//! with those of the journals, the equation of motion with the flank decided beforehand and where the power goes
//! (`equation`, proven in [`equation_proofs`]; [`contact_proofs`] has the moments and the sliding from vectors), where
//! it has one solution (`existence`), the motion over one engagement by Runge-Kutta steps of the angle ([`JointPassage`]),
//! the one that repeats itself ([`SettledPassage`]), and what each size does to it ([`series`]).

mod contact;
pub mod contact_proofs;
mod effects;
mod equation;
pub mod equation_proofs;
mod existence;
mod passage;
mod steady;

pub use contact::{Arms, Reach};
pub use effects::{Effect, Varied, effects, series};
pub use equation::{Escapement, JointMotion, Power, Terms};
pub use existence::{LeastJointMargin, largest_pin_radius};
pub use passage::{JointPassage, STEPS};
pub use steady::SettledPassage;

/// Sizes and frictions of the joints.
///
/// ```
/// use geneva_dynamics::joints::{Escapement, Joints};
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(0.1, 1.0)?, 1.0, 0.2)?;
/// // A pin of a tenth of the crank radius, in bearings without friction.
/// let thick = Escapement::new(&timer, Joints { pin_radius: 0.1, ..Joints::IDEAL })?;
/// assert!(thick.reversal_angle() > 0.0); // rad: the surface of a thick pin slides outward before the line of centres
/// assert_eq!(Escapement::new(&timer, Joints::IDEAL)?.reversal_angle(), 0.0);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joints {
    /// ρ, radius of the pin and half the width of the slot, in crank radii; from 0 to below 1.
    pub pin_radius: f64,
    /// Radius of the driver's journal, in crank radii, not negative.
    pub driver_journal: f64,
    /// Radius of the follower's journal, in crank radii, not negative.
    pub follower_journal: f64,
    /// μ_b, friction of both journals, dimensionless, not negative.
    pub bearing_friction: f64,
    /// Constant torque against the driver's rotation, in the unit of K, not negative and below K.
    pub driver_drag_torque: f64,
    /// Constant torque against the follower's rotation, in the unit of K, not negative.
    pub follower_drag_torque: f64,
}

impl Joints {
    /// A pin that is a point, and bearings without friction: the model of Meyer 1973.
    pub const IDEAL: Self = Self {
        pin_radius: 0.0,
        driver_journal: 0.0,
        follower_journal: 0.0,
        bearing_friction: 0.0,
        driver_drag_torque: 0.0,
        follower_drag_torque: 0.0,
    };

    /// Both journals of this radius (crank radii) and this friction, and nothing else.
    pub const fn journals(radius: f64, friction: f64) -> Self {
        Self { driver_journal: radius, follower_journal: radius, bearing_friction: friction, ..Self::IDEAL }
    }

    /// The sizes by name, in the order of the fields.
    fn named(&self) -> [(&'static str, f64); 6] {
        [
            ("pin radius", self.pin_radius),
            ("driver's journal radius", self.driver_journal),
            ("follower's journal radius", self.follower_journal),
            ("bearing friction", self.bearing_friction),
            ("driver's drag torque", self.driver_drag_torque),
            ("follower's drag torque", self.follower_drag_torque),
        ]
    }
}

impl Default for Joints {
    fn default() -> Self {
        Self::IDEAL
    }
}
