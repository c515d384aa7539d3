//! The list of parts that every file has: outlines with all their holes, marks, thickness and place.

mod base;
mod holes;
mod list;
mod mounting;
mod standards;
mod walls;

pub use holes::{Hole, HolePurpose, Widening};
pub(crate) use list::axial_play;
pub use list::{Layer, Part, PartList, Place, parts};
pub use mounting::{BasePlate, Fastener, Mounting, Pattern, PinMount, ScrewHole, ShaftFit};
pub use standards::{KEYED_SHAFTS, Keyway, Thread};
pub(crate) use walls::remedy;
pub use walls::{MountingError, ThinWall};
