//! One wheel: its sizes, its times, its motion and loads, its drawing and files; or which wheels have wanted times.

mod arguments;
mod check;
mod check_advice;
mod check_arguments;
mod check_certainty;
mod check_doubts;
mod check_made;
mod check_mouth;
mod check_needs;
mod check_remedies;
#[cfg(test)]
mod check_rule_tests;
mod check_words;
mod design;
mod drive;
mod files;
mod fitting;
mod friction;
mod hole_rows;
mod instant;
mod kind;
mod loads;
mod looseness;
mod making;
mod masses;
#[cfg(test)]
mod masses_tests;
mod materials;
mod mounted_parts;
mod mounting;
mod mounting_error;
mod mouth;
mod mouth_rows;
mod over_sizes;
mod parts;
mod pin_load;
mod process;
mod question;
mod ranges;
mod reasons;
mod recommended;
#[cfg(test)]
mod recomputed_tests;
mod report;
mod ring_rows;
mod sized;
mod speeds;
mod times;
mod typed_question;
mod warnings;
mod yield_cause;

pub use arguments::{ActsOn, Argument, ArgumentGroup, ArgumentSlot, GROUPS, Knob, NamedChoice, WRONG_SIZES, arguments};
pub use check::{CheckQuestion, UNCERTAINTY};
pub use check_arguments::{CHECK_ARGUMENTS, CheckArgument};
pub use design::WheelDesign;
pub use files::{MadeOf, SHAPE_FILES, ShapeFile};
pub use fitting::FittingValues;
pub(crate) use fitting::sizes_refusal;
pub use kind::{AnyWheel, WheelKind};
pub use materials::PartMaterials;
pub use mounting::{BoreShape, MountingQuestion, PinKind};
pub use mouth::mouth_arguments;
pub use process::{ASSEMBLIES, yield_fields};
pub use question::{SearchEffort, WheelQuestion};
pub use speeds::speeds;
pub use times::{Times, proposals, proposals_for_angle};
pub use yield_cause::CauseSearch;

pub use geneva_workshop::LayerNames;
