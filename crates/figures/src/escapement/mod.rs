//! The Geneva escapement: the mechanism, its angles, its forces, its motion, and how well the motion is computed.
//!
//! The driver's axis B lies at the left, the follower's axis O to its right. The driver turns counter-clockwise, the
//! follower clockwise; θ is counted from B → O and φ from O → B, each in its body's sense. r is the radius of the pins'
//! circle, c = a r the centre distance, R the distance of the engaged pin P from O. Lengths are in r, forces in K / r
//! with the driving torque K.

mod angles;
#[cfg(test)]
mod drawn;
mod engagement;
mod existence;
mod force_panels;
mod force_senses;
mod forces;
mod hand_over;
mod mechanism;
mod normal_force;
mod order;
mod pose;
mod ratios;
mod running;

pub use angles::angles;
pub(crate) use engagement::speeds;
pub use existence::{MarkedEscapement, existence};
pub use forces::steady_forces;
pub use hand_over::hand_over;
pub use mechanism::mechanism;
pub use normal_force::normal_force;
pub use order::order;
pub use ratios::ratios;
pub use running::running;
