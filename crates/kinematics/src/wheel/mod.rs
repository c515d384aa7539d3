//! The external Geneva wheel: any number of stations, any number of evenly spaced pins that fit.
//!
//! Notation: `N` stations, α = π/N half the angle between slots, θ crank angle from the line of centres, φ wheel angle
//! from the middle of the advance, k = 1 / sin α the centre distance in crank radii. θ and φ grow in opposite senses.
//! A wheel is a pin in a slot ([`pin_slot`](crate::pin_slot)) whose ratio k is chosen so that it starts and stops at
//! rest.
//!
//! [`Wheel`] has the ratios. [`Sizes`] makes millimetres of them, with pins, slots, locking disc and play, and from them
//! the [`Outline`] of both parts and their [`Clearance`] over a whole turn.

mod accurate;
pub mod as_built;
mod centres;
mod clearance;
mod crescent;
mod dwell_play;
mod fit;
mod flatted_shaft;
mod geometry;
mod indexing;
mod misplaced;
mod motion;
mod mouth;
mod mouth_fit;
mod outline;
mod play;
mod regions;
mod search;
mod shared_tolerance;
mod sizes;
mod sizing;
mod standard_fit;
mod tolerance_class;
mod walls;
mod warnings;

pub use centres::CentreTolerance;
pub use clearance::{Clearance, ClosestApproach, ContactPair, TOLERANCE};
pub use dwell_play::DwellPlay;
pub use fit::{MouthSize, Remedy, ShaftOf, SizesError};
pub use flatted_shaft::FlattedShaft;
pub use geometry::{STATIONS, Wheel, gamma};
pub use misplaced::MisplacedWheel;
pub use motion::{acceleration_ratio, jerk_ratio, unsteady_acceleration};
pub use mouth::Mouth;
pub use outline::{Edge, Face, Loop, Outline};
pub use play::{EntryContact, Knock, PinEntry};
pub(crate) use search::{Minimum, Search};
pub use shared_tolerance::SharedTolerance;
pub(crate) use shared_tolerance::{SharedGaps, make_wrong, shared_gaps};
pub use sizes::{Choices, Crescent, LockingDisc, Play, Scale, Sizes};
pub use standard_fit::{play_of_h8_e8, play_of_h8_e8_at};
pub use tolerance_class::{ToleranceClass, ToleranceLetter};
pub(crate) use warnings::THIN;
pub use warnings::Warning;
