//! The steady motion of the escapement: how engagements draw all motions together, and what the motion depends on.

mod collapse;
mod error;
mod hand_over;
mod phase;
#[cfg(test)]
mod tests;

pub use collapse::collapse;
pub use error::MotionError;
pub use hand_over::hand_over;
pub use phase::phase;
