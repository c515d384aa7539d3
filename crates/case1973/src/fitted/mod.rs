//! The data of the runs, found from what is printed of their results.
//!
//! Friction, torque and inertias are data: no run gives them. But the results depend on them, and so they can be found
//! from the results without being known:
//!
//! - a row's torque, from its minimum and its period, with its friction and the inertias as printed;
//! - a row's friction, from its minimum and its period, with its torque and the inertias as printed;
//! - the two inertias of a mechanism, from all peaks, minima and periods of its table, with its frictions and torques.
//!
//! What is found is where the sum of the squares of the misfits, in units of the last printed place, is least. It is
//! looked for over all that can be, by golden section over the solution by integrals. The steady motion has the inertias
//! of Fig. 11 for six pins and is reset after 90°, as the program has it.
//!
//! [`InertiaFit`] asks the opposite: what the right reset angle could explain, whatever the inertias were.

mod golden_section;
mod inertia_fit;

pub use golden_section::{Motions, friction, inertias, ratios, torque};
pub use inertia_fit::{InertiaFit, RATIOS, most_within_one};

use crate::Column;

/// The results from which a row's torque and friction are found: no printed line need fall on a peak.
const BUT_FOR_THE_PEAK: &[Column] = &[Column::Minimum, Column::Period];
