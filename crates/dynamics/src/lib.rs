//! Equation of motion of the Geneva escapement: a driver with pins all round, a slotted follower, a constant torque.
//!
//! The formulas are generic over a [`Field`](geneva_kinematics::Field), so that they run on `f64`, on power series
//! and on exact rationals. The equation is derived from the balance of energy in [`energy`].
//!
//! Notation: `r` crank radius, `c = a r` centre distance, θ crank angle from the line of centres, φ follower angle,
//! `R` distance of the pin from the follower's pivot, μ friction between pin and slot, `K` torque on the driver, `I_D`
//! and `I_f` moments of inertia of driver and follower. θ and φ grow in opposite senses of rotation.
//!
//! [`joints`] is the same escapement with a pin of finite radius and friction in the bearings. [`wheel_loads`] and
//! [`line_contact`] are of wheels whose driver has a constant speed: torques and forces, and the pressure on the pin.
//!
//! This crate holds no number that a source prints, does no input or output, and knows nothing of claims or books.

#![warn(clippy::missing_errors_doc)]

pub mod energy;
pub mod equation;
pub mod equation_proofs;
mod error;
pub mod existence;
pub mod existence_proofs;
pub mod forces;
pub mod joints;
pub mod line_contact;
mod parameters;
pub mod pose;
mod sign;
pub mod similarity;
pub mod singularity;
pub mod steady;
pub mod timer;
pub mod wheel_loads;

pub use equation::{Acceleration, Coefficients};
pub use error::Error;
pub use parameters::{Inertias, Parameters};
pub use pose::Pose;
pub use sign::Sign;
