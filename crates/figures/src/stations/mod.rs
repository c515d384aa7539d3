//! The Geneva wheel of any number of stations and pins: the mechanism, its angles, its motion; the internal and the
//! spherical wheel.
//!
//! Frame and angles: the wheel's axis O lies at the left, the driver's axis B to its right. The crank angle θ is
//! measured clockwise from B → O, the wheel's angle φ counter-clockwise from O → B: both are zero where a pin is on
//! the line of centres, and both grow. Lengths are in crank radii.

mod choice;
#[cfg(test)]
mod clearance;
mod crescent;
mod critical;
mod cycle;
mod dimensions;
#[cfg(test)]
mod drawn;
mod driver;
mod dwell_play;
mod extremes;
mod indexing;
mod internal;
mod kinds;
mod locking_cuts;
mod mechanism;
mod model;
mod motion;
mod over_sizes;
mod pose;
mod running;
mod spherical;
mod wrong_formulas;

pub use choice::choice;
pub use crescent::crescent;
pub use critical::critical_geometry;
pub use dimensions::{dimensions, dimensions_of_a_wrong_wheel, dimensions_on_a_page};
pub use dwell_play::dwell_play;
pub use extremes::extremes;
pub use indexing::indexing;
pub use internal::internal_mechanism;
pub use kinds::kinds;
pub use locking_cuts::locking_cuts;
pub use mechanism::mechanism;
pub use model::model;
pub use motion::{motion, turning};
pub use over_sizes::{LoadsAtSize, over_sizes};
pub use running::running;
pub use spherical::spherical_mechanism;
pub use wrong_formulas::{WrongFormula, wrong_formulas};
