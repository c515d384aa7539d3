//! The steady motion of the escapement: how engagements draw all motions together, and what the motion depends on.

mod error;

pub use error::MotionError;
