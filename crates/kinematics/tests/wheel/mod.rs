//! The external wheel: motion, sizes, outlines and clearances.

mod accurate;
mod as_built;
mod assembly;
mod centres;
mod clearance;
mod cycle;
mod dwell;
mod extremes;
mod flatted_shaft;
mod geometry;
mod indexing;
mod misplaced;
mod motion;
mod mouth;
mod shared_tolerance;
mod sizes;
mod standard_fit;
mod tolerance_class;
mod tolerances;
mod walls;
mod warnings;
