//! The pin in the slot at one instant, and over the time it is engaged.
//!
//! Frame and angles: the follower's pivot O is the origin, the driver's axis B lies to its right; the crank angle φ
//! is measured counter-clockwise from the direction O → B, so it is a half turn when the pin is nearest to O.

#[cfg(test)]
mod drawn;
mod engagement;
mod instant;
mod position;
mod running;
mod velocity;

pub use engagement::over_the_engagement;
pub use position::position_triangle;
pub use running::velocities_at_the_pin;
pub use velocity::velocity_triangle;
