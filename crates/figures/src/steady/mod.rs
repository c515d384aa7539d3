//! The steady motion of the escapement: how engagements draw all motions together, and what the motion depends on.

mod collapse;
mod contours;
mod hand_over;
mod losses;
mod map;
mod phase;
#[cfg(test)]
mod tests;
mod work_precision;

pub use collapse::collapse;
pub use hand_over::hand_over;
pub use losses::{Line, losses};
pub use map::map;
pub use phase::phase;
pub use work_precision::{Measurement, work_precision};
