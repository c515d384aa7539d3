//! Numbers that formulas run on, and exact proofs of identities between them.
//!
//! A formula that is generic over a [`Field`] runs unchanged on `f64`, on truncated power series ([`Jet`], the derivatives), on
//! exact rationals ([`rational`]), on rationals with square roots adjoined ([`Surd`]) and on expressions ([`Expression`], whose
//! degrees tell how many points prove an identity). An angle is held as the pair of its cosine and its sine ([`Turn`]), so
//! what a formula makes of it is rational.
//!
//! ```
//! use geneva_exact::{Expression, Identity, prove};
//!
//! /// (x + 1)² = x² + 2x + 1, for every x.
//! struct Square;
//!
//! impl Identity<1> for Square {
//!     fn difference(&self, [x]: [Expression; 1]) -> Expression {
//!         (x + 1) * (x + 1) - (x * x + 2 * x + 1)
//!     }
//! }
//! assert!(prove(&Square).is_ok());
//! ```
//!
//! This crate knows no subject, no claim and no book. Only exact numbers panic, when they are divided by zero.

#![warn(clippy::missing_errors_doc)]

mod proofs;
mod scalars;

pub use dashu_ratio::RBig as Rational;
pub use proofs::expression::Expression;
pub use proofs::identity::{Identity, IdentityWithRoot, Proof, Refutation, prove, prove_with_root};
pub use scalars::field::{Field, rational};
pub use scalars::jet::Jet;
pub use scalars::surd::Surd;
pub use scalars::turn::{Turn, angular_velocity};
