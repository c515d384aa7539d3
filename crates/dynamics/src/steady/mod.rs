//! The steady motion of an escapement, and how it is reached from rest.
//!
//! With u = θ'² and the angle instead of the time, Eq. (1-19) of Meyer 1973 is linear between the changes of the
//! friction's sign: θ'' = u'/2, so (A + S D) u'/2 + (B + S C) u = E. The return map of one engagement takes u at entry to
//! a u at the end that grows with it; its slope, the multiplier by which two motions approach one another, is known
//! ([`Passage::multiplier`]). Its fixed point is the steady state ([`SteadyState`]), and the speed at entry there the
//! terminal speed.
//! No step of time is made: the solution is two integrals for each sign, by a rule of sixteen nodes on as many
//! subintervals as the nearest poles of the equation ask for.
//!
//! In order: the variable (`circle`), the Gauss-Legendre rule (`quadrature`), the integrals over a `subinterval`,
//! [`Engagement`], the `contact_reversal`, [`Passage`] with its [`Extreme`]s, the [`SteadyState`], [`Rise`], and runs on a
//! print grid ([`PrintedLine`]). The identities behind them are proven in [`proofs`].

mod circle;
mod contact_reversal;
mod engagement;
mod exponential;
mod extremes;
mod largest_printed;
mod passage;
pub mod proofs;
pub(crate) mod quadrature;
mod rise;
mod run;
mod steady_state;
mod subinterval;

pub use engagement::{Engagement, MOST_SUBINTERVALS, TOLERANCE, TOLERANCES};
pub use extremes::Extreme;
pub use passage::Passage;
pub use rise::{MOST_CYCLES, Rise, RiseCycle, RiseMeasure};
pub use run::{MOST_PRINTED, PrintedLine};
pub use steady_state::SteadyState;
