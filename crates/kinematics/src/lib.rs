//! Exact motion of pin-in-slot mechanisms.
//!
//! With the cosine and the sine of an angle held as a pair ([`Turn`]), every rate in this crate is a rational
//! function of what it is given. The formulas are therefore generic over a [`Field`] and run unchanged on `f64`, on
//! truncated power series ([`Jet`], the derivatives), on exact rationals, on rationals with square roots adjoined
//! ([`Surd`]) and on expressions ([`Expression`], whose degrees tell how many points prove an identity).
//!
//! This crate holds no number that a source prints, does no input or output, and knows nothing of claims or books.

#![warn(clippy::missing_errors_doc)]

mod error;
mod proofs;
mod scalars;

pub mod escapement;
pub mod indexing;
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

pub use dashu_ratio::RBig as Rational;
pub use error::KinematicsError;
pub use escapement::{EscapementError, Mechanism};
pub use proofs::expression::Expression;
pub use proofs::identity::{Identity, IdentityWithRoot, Proof, Refutation, prove, prove_with_root};
pub use scalars::field::{Field, rational};
pub use scalars::jet::Jet;
pub use scalars::surd::Surd;
pub use scalars::turn::{Turn, angular_velocity};
