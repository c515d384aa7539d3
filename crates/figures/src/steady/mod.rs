//! The steady motion of the escapement: how engagements draw all motions together, and what the motion depends on.

mod collapse;
mod contours;
mod losses;
mod map;
mod phase;
mod return_map;
#[cfg(test)]
mod tests;
mod work_precision;

pub use collapse::collapse;
pub use losses::{Line, losses};
pub use map::map;
pub use phase::phase;
pub use return_map::return_map;
pub use work_precision::{Measurement, work_precision};
