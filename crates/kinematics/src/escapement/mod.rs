//! The Geneva escapement: a Geneva wheel with so many pins that one is always in a slot, and whose follower is at rest
//! as one pin takes over from the next. [`ContinuousEscapement`] allows any number of pins and slots, without that rest.
//!
//! Notation: n slots on the follower, m pins on the driver, r radius of the pins' circle, c = a r centre distance, θ
//! driver angle from the line of centres, φ follower angle from there, R distance of the pin from the follower's axis.
//! θ and φ grow in opposite senses. At θ₀ = π/m and φ₀ = π/n one pin leaves its slot while the next enters one; both
//! then move along their slots and the follower stands still for that instant. Source: Meyer 1973, chapter I.
//!
//! The mechanism is a [`Wheel`](crate::wheel::Wheel) without dwell, so sizes and motion are the wheel's. Here is what
//! is the escapement's own: which numbers of slots and pins are possible ([`Mechanism`]), where everything
//! is ([`Configuration`], [`HandOver`]), what stays clear of what, and why no other numbers are possible
//! ([`entry_proofs`]).

mod clearance;
mod configuration;
mod continuous;
mod geometry;

pub mod entry_proofs;

pub use clearance::{ApproachCoefficient, RimExcess};
pub use configuration::{Configuration, HandOver, RelativePosition, Roots, Slot};
pub use continuous::{ContinuityStep, ContinuousEscapement, HandOverMotion};
pub use geometry::{EscapementError, Mechanism, pins_needed, possible_pairs};
