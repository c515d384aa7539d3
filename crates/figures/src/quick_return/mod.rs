//! The slotted-lever quick-return mechanism: where it stands, its vector diagrams, its motion over a turn.
//!
//! Link 2 is the crank about O2, link 4 the slotted lever about O4; the ground is link 1. P2 is the pin on the crank,
//! P4 the point of the lever under it. O4 lies at the left, O2 to its right: the crank angle φ and the lever angle ψ
//! are both counted counter-clockwise from that direction. β is the angle at the pin between lever and crank, r the
//! pin's distance from O4.

mod acceleration;
mod bead;
#[cfg(test)]
mod drawn;
mod instant;
mod linkage;
mod mechanism;
mod order;
mod polygons;
mod steps;
mod turn;
mod velocity;

pub use acceleration::acceleration_diagram;
pub use bead::bead_on_a_lever;
pub use mechanism::mechanism;
pub use polygons::polygons;
pub use turn::over_a_turn;
pub use velocity::velocity_diagram;
