//! What a clockmaker asks of an escapement.
//!
//! How exact the timer is, in [`Sensitivities`]; how hard its members are accelerated, in [`Accelerations`]; and how
//! fast it settles, in [`Settling`]. All of it is drawn from the steady motion, [`steady`](crate::steady).

mod accelerations;
mod error;
mod sensitivity;
mod settling;

pub use accelerations::{Accelerations, INSTANTS, Strongest};
pub use error::TimerError;
pub use sensitivity::Sensitivities;
pub use settling::Settling;

#[cfg(test)]
mod tests;
