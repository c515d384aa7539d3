//! The external wheel as it was really made: every slot, locking arc and pin with sizes of its own.
//!
//! [`AsBuiltWheel`] has the sizes. [`FreeAngles`] says at a crank angle between which wheel angles the wheel is free, and what
//! stops it on either side. [`BuiltTurn`] follows that through every station: whether the wheel turns or jams, how loose it is,
//! and with what blow the pins come in. [`Assemblies`] does so for many wheels whose sizes are drawn at random.

mod assemblies;
mod blow;
mod claw;
mod contact;
mod designed_wheel;
mod errors;
mod filled_in;
mod free_angles;
mod measured;
mod mistakes;
mod mouth;
mod mouth_limits;
mod nearest;
mod outline;
mod parts;
mod process;
mod random;
mod remedies;
mod right_wheel;
mod test_piece;
mod turn;
mod uncertain_wear;
mod undecided;

pub use assemblies::{Assemblies, Yield};
pub use blow::BuiltBlow;
pub use contact::BuiltContact;
pub use errors::{BuiltError, ErrorShape, MeasuredError, SizeErrors};
pub use free_angles::{AngleLimit, FreeAngles};
pub use measured::{MeasuredSize, MeasuredWheel, SizeMeasurement};
pub use mistakes::KnownMistake;
pub use nearest::{Culprit, NearestWheel, Residual};
pub use parts::{AsBuiltWheel, BuiltArc, BuiltCrescent, BuiltPin, BuiltSlot};
pub use process::{Process, ProcessNumbers, SourcedNumber};
pub use random::SplitMix64;
pub use remedies::SizeChange;
pub use test_piece::{RUNG, TestPiece};
pub use turn::{BuiltTurn, Jam, StationTurn, WIDTH_TOLERANCE};
pub use uncertain_wear::UncertainWear;
pub use undecided::{DoubtReason, UndecidedCulprit, UntoldWear};
