//! The list of parts that every file has: outlines with all their holes, marks, thickness and place.

mod base;
mod error;
mod holes;
mod internal;
mod list;
mod looseness;
mod mounting;
mod part;
mod standards;
mod test_piece;
mod walls;

pub use error::MountingError;
pub use holes::{Hole, HolePurpose, Widening};
pub use internal::internal_parts;
pub(crate) use list::axial_play;
pub use list::{PartList, parts};
pub use mounting::{BasePlate, Fastener, Mounting, Pattern, PinMount, ScrewHole, ShaftFit};
pub(crate) use part::allowance_words;
pub use part::{Layer, Part, Place};
pub use standards::{KEYED_SHAFTS, Keyway, Thread};
pub use test_piece::test_piece;
pub use walls::ThinWall;
pub(crate) use walls::remedy;
