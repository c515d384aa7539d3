//! The steady motion of an escapement, and how it is reached from rest.
//!
//! With u = θ'² and the angle instead of the time, Eq. (1-19) of Meyer 1973 is linear between the changes of the
//! friction's sign: θ'' = u'/2, so (A + S D) u'/2 + (B + S C) u = E. One engagement takes u at entry to a u at the end
//! that grows with it, and any two motions approach one another by a factor that is known
//! ([`Passage::contraction`]). The speed that is handed on unchanged is the terminal speed ([`SteadyState`]).
//! No step of time is made: the solution is two integrals for each sign, by a rule of sixteen points on as many
//! stretches as the nearest poles of the equation ask for.
//!
//! In order: the variable (`arc`), the rule (`rule`), the integrals (`stretch`), what of them all escapements of a mechanism
//! share (`halves`), [`Engagement`], the `switch`, the way through it (`walk`), [`Passage`] with its [`Extreme`]s and its
//! clock, [`SteadyState`] and what it is without extremes ([`Terminal`]), [`Rise`], and runs on a print grid ([`Printed`]).
//! The identities behind them are proven in [`proofs`].

mod arc;
mod clock;
mod cycle;
mod engagement;
mod error;
mod exponential;
mod extremes;
mod first_minimum;
mod halves;
mod passage;
pub mod proofs;
mod rise;
mod rule;
mod stretch;
mod switch;
mod terminal;
mod trajectory;
mod walk;

#[cfg(test)]
mod tests;

pub use engagement::{Engagement, MOST_STRETCHES, TOLERANCES};
pub use error::SteadyError;
pub use extremes::Extreme;
pub use passage::Passage;
pub use rise::{Cycle, MOST_CYCLES, Rise};
pub use terminal::{SteadyState, Terminal};
pub use trajectory::{MOST_PRINTED, Printed};
