//! A pin on a pinion that rolls on a fixed gear, in the place of the crank.
//!
//! As it enters and as it leaves, the pin must be at its farthest from the driver's axis: only there it moves at right
//! angles to the crank, along the slot. The ratio of the teeth that the pages print is not among the claims: a pin comes
//! back to the same place in the next turn only where that ratio is a whole number, and the pages do not say for which
//! wheels it is meant.

use super::fit::ANY;
use super::*;

const EXTERNAL: Place = at(page!("https://mechamechanisms.com/external-geneva-and-epicyclic-gear-mechanism-1"));
const INTERNAL: Place = at(page!("https://mechamechanisms.com/internal-geneva-and-epicyclic-gear-mechanism-1"));

pub fn claims() -> Vec<Claim> {
    vec![reach(EXTERNAL, "wild.mecha-external.reach"), reach(INTERNAL, "wild.mecha-internal.reach")]
}

fn reach(place: Place, id: &'static str) -> Claim {
    formula(place, id, r"R + r = B \sin(\pi/n)", "farthest place of the pin from the driver's axis", ANY, |fit| {
        vec![("R", 0.75 * fit.crank), ("r", 0.25 * fit.crank), ("B", fit.centres), ("n", fit.slots)]
    })
}
