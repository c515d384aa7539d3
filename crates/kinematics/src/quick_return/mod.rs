//! The slotted-lever quick-return mechanism: a crank's pin slides in a lever that turns about a fixed pivot.
//!
//! Notation and frame: the lever's pivot O is the origin, the crank's axis B lies at (l, 0). The crank angle φ and the
//! lever angle ψ are both measured counter-clockwise from the direction O → B; the crank's radius is R, the distance
//! of the pin from the lever's pivot r. A module for each question:
//!
//! - [`linkage`]: which lengths and angles are possible, and how far does the lever swing?
//! - [`motion`]: every velocity and acceleration, by closing vector diagrams.
//! - [`series`]: the lever's rates by differentiating the loop closure.
//! - [`proofs`]: why diagrams and series agree.

pub mod linkage;
pub mod motion;
pub mod proofs;
pub mod series;

pub use linkage::{Branch, Position, QuickReturn, Strokes};
pub use motion::{Drive, LeverMotion};
