//! The steady motion of the escapement: how engagements draw all motions together, and what the motion depends on.

mod accelerations;
mod collapse;
mod contact;
mod contours;
mod losses;
mod map;
mod phase;
mod return_map;
#[cfg(test)]
mod tests;

pub use accelerations::accelerations;
pub use collapse::collapse;
pub use contact::contact;
pub use losses::losses;
pub use map::map;
pub use phase::phase;
pub use return_map::return_map;
