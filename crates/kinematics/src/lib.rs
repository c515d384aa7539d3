//! Geneva wheels, Geneva escapements and quick-return levers: how they move, exactly, and how large their parts are.
//!
//! You choose a wheel by its number of stations. Its motion follows in ratios to the driver's motion. If you also choose
//! one length, you get all sizes in millimetres and can check that nothing collides over a whole turn.
//!
//! ```
//! use geneva_kinematics::Mechanism;
//! use geneva_kinematics::indexing::Indexing;
//! use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
//! use std::f64::consts::PI;
//!
//! // A wheel of four stations, driven at 10 rad/s, moves for a quarter of a turn.
//! let (wheel, driver_speed) = (Wheel::new(4)?, 10.0);
//! let move_time = wheel.indexing_time(driver_speed)?; // s
//! assert!((move_time - PI / 2.0 / 10.0).abs() < 1e-15);
//! let peak = driver_speed * wheel.peak_velocity(); // rad/s
//! assert!((peak - 10.0 * (1.0 + 2_f64.sqrt())).abs() < 1e-13);
//!
//! // Sizes in mm with the axes 100 mm apart. No part touches another.
//! let scale = Scale::CentreDistance(100.0);
//! let sizes = Sizes::new(wheel, scale, &Choices::default())?;
//! assert!((sizes.crank_radius - 100.0 / 2_f64.sqrt()).abs() < 1e-12);
//! assert!(sizes.clearance().closest_approach().distance > 0.0);
//!
//! // An escapement is a wheel without dwell. With four slots it needs four pins.
//! assert_eq!(Mechanism::new(4)?.pins(), 4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conventions
//!
//! - **Angles** are in radians, unless a name says degrees. The crank angle is zero in the middle of an engagement, where
//!   the pin is deepest in its slot; it is negative before and positive after. The wheel angle is zero at the same
//!   instant. Both grow as driver and wheel turn, although an external wheel turns against its driver.
//!   [`pin_vectors`] and [`quick_return`] measure angles counter-clockwise from the line of centres instead.
//! - **Rates** are ratios: the wheel's velocity over the driver's speed, its acceleration over the square of that speed,
//!   its jerk over the cube.
//! - **Lengths** of a wheel or an escapement are in crank radii. [`wheel::Sizes`] and everything made from it are in
//!   millimetres. Where you give several lengths, as to [`pin_slot::PinSlot`], any one unit will do.
//! - **Errors** name the value, the allowed range and what to change. No length, angle or count makes a
//!   function panic; only exact numbers do, when they are divided by zero.
//!
//! # Where to look
//!
//! | question | module |
//! |---|---|
//! | an external Geneva wheel: motion, sizes, play, clearance, outline | [`wheel`] |
//! | an internal or a spherical one | [`internal_wheel`], [`spherical_wheel`] |
//! | all three kinds by one name | [`indexing`] |
//! | an escapement: which numbers of pins and slots, and where everything is | [`escapement`] |
//! | a quick-return lever | [`quick_return`] |
//! | a cam to compare a wheel with | [`cam`] |
//! | a pin in a slot, for lengths of any ratio | [`pin_slot`], [`pin_triangle`], [`pin_vectors`], [`relative_motion`] |
//! | why the formulas are right | the modules whose names end in `proofs`, for [`prove`] |
//!
//! # Numbers
//!
//! With the cosine and the sine of an angle held as a pair ([`Turn`]), every rate in this crate is a rational function of
//! what it is given. The formulas are therefore generic over a [`Field`] and run unchanged on `f64`, on truncated power
//! series ([`Jet`], the derivatives), on exact rationals ([`rational`]), on rationals with square roots adjoined ([`Surd`]) and
//! on expressions ([`Expression`], whose degrees tell how many points prove an identity).
//!
//! This crate holds no number that a source prints, does no input or output, and knows nothing of claims or books.

#![warn(clippy::missing_errors_doc)]

mod error;

pub mod bisection;
pub mod cam;
pub mod escapement;
pub mod indexing;
pub mod internal_assemblies;
pub mod internal_clearance;
pub mod internal_sizes;
pub mod internal_wheel;
pub mod internal_wheel_proofs;
pub mod pin_proofs;
pub mod pin_slot;
pub mod pin_triangle;
pub mod pin_vectors;
pub mod quick_return;
pub mod relative_motion;
pub mod spherical_wheel;
pub mod spherical_wheel_proofs;
pub mod wheel;
pub mod wheel_jerk_proofs;
pub mod wheel_peak_proofs;
pub mod wheel_proofs;

pub use error::KinematicsError;
pub use escapement::{EscapementError, Mechanism};
pub use geneva_exact::{
    Expression, Field, Identity, IdentityWithRoot, Jet, Proof, Rational, Refutation, Surd, Turn, angular_velocity,
    prove, prove_with_root, rational,
};
