//! How a Geneva escapement runs under a constant torque, and what a Geneva wheel asks of a driver of constant speed.
//!
//! An escapement is a driver with pins all round and a slotted follower. Friction in the slots takes more energy the faster
//! it runs, so it settles to a steady speed. You give the mechanism, two moments of inertia, a torque and a coefficient of
//! friction.
//!
//! ```
//! use geneva_kinematics::indexing::Indexing;
//! use geneva_dynamics::steady::Engagement;
//! use geneva_dynamics::wheel_loads::WheelLoads;
//! use geneva_dynamics::{Inertias, Parameters};
//! use geneva_kinematics::{Mechanism, wheel::Wheel};
//! use std::f64::consts::FRAC_PI_2;
//!
//! // An escapement with four pins turns by a quarter of a turn per pin.
//! let inertias = Inertias::new(2e-6, 1e-6)?; // driver and follower, kg m²
//! let (torque, friction) = (1e-3, 0.2); // N m, coefficient
//! let timer = Parameters::new(Mechanism::FOUR_PIN, inertias, torque, friction)?;
//! let steady = Engagement::new(&timer)?.steady_state()?; // rad/s and s
//! assert!((steady.mean_speed * steady.period - FRAC_PI_2).abs() < 1e-12);
//! assert!(steady.multiplier < 1.0); // a disturbance shrinks
//!
//! // A wheel of four stations with 1e-3 kg m² and no friction, at 10 rad/s.
//! let wheel = Wheel::new(4)?;
//! let loads = WheelLoads::new(&wheel, 1e-3, 0.0, 10.0)?;
//! let entry = loads.load(-wheel.engagement_half_angle())?;
//! assert!((entry.wheel_torque - 0.1).abs() < 1e-12); // N m: J ω² tan 45°
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conventions
//!
//! - **Units** of an escapement may be any that fit together. With inertias in kg m² and torques in N m, times are in seconds
//!   and speeds in rad/s; where the unit of time is yours, the comments say "unit of time". [`wheel_loads`],
//!   [`line_contact`] and [`pin_strength`] are in SI units.
//! - **Angles** are in radians. The crank angle θ is zero on the line of centres, negative before it and positive past it.
//!   The follower's angle φ is zero there too. Driver and follower turn in opposite senses, and both angles grow.
//! - **Lengths** are in crank radii. So a force becomes a moment, force times crank radius, until you give the radius.
//! - **Errors** name the value, the allowed range and what to change: [`DynamicsError`].
//!
//! Notation: `r` crank radius, `c = a r` centre distance, `R` distance of the pin from the follower's pivot, μ friction
//! between pin and slot, `K` torque on the driver, `I_D` and `I_f` moments of inertia of driver and follower. A prime is a
//! derivative by time, except in algebra that says otherwise.
//!
//! # Where to look
//!
//! | question | module or type |
//! |---|---|
//! | what may be chosen, and the acceleration at one instant | [`Parameters`], [`equation`] |
//! | can it jam? | [`existence`] |
//! | force and friction at one instant | [`forces`] |
//! | steady speed, start from rest, motion over time | [`steady`] |
//! | exactness, settling, blows by play, other escapements | [`timer`] |
//! | what changes with the torque | [`similarity`] |
//! | a pin of finite radius, friction in the bearings | [`joints`] |
//! | torque, force and power of a wheel at constant speed | [`wheel_loads`] |
//! | friction of pin, disc and bearings, start, flywheel | [`wheel_loads`] |
//! | pressure between pin and slot | [`line_contact`] |
//! | bending and shear of a pin, the least pin for a load | [`pin_strength`] |
//! | why the equation is right | [`energy`], [`singularity`], the modules whose names end in `proofs` |
//!
//! The formulas are generic over a [`Field`](geneva_kinematics::Field), so that they run on `f64`, on power series and on
//! exact rationals. The equation of motion is derived from the balance of energy in [`energy`].
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
pub mod pin_strength;
pub mod pose;
mod sign;
pub mod similarity;
pub mod singularity;
pub mod steady;
pub mod timer;
pub mod wheel_loads;

pub use equation::{Acceleration, Coefficients};
pub use error::DynamicsError;
pub use parameters::{Inertias, Parameters};
pub use pose::Pose;
pub use sign::Sign;
