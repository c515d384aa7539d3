//! A pin on a pinion that rolls on a fixed gear, in the place of the crank.
//!
//! As it enters and as it leaves, the pin must be at its farthest from the driver's axis: only there it moves at right
//! angles to the crank, along the slot. So the pinion makes a whole number of turns against the crank in between.

use super::fit::{ANY, counted};
use super::*;
use crate::agreement::vanishes;
use crate::tex::{Moment, holds};
use nalgebra::Vector2;

const EXTERNAL: Place = at(page!("https://mechamechanisms.com/external-geneva-and-epicyclic-gear-mechanism-1"));
const INTERNAL: Place = at(page!("https://mechamechanisms.com/internal-geneva-and-epicyclic-gear-mechanism-1"));

pub fn claims() -> Vec<Claim> {
    vec![
        gears(EXTERNAL, "wild.mecha-external.gears", |fit| fit.moving),
        reach(EXTERNAL, "wild.mecha-external.reach"),
        // An internal wheel is driven on the rest of the turn.
        gears(INTERNAL, "wild.mecha-internal.gears", |fit| fit.resting).corrected(
            r"\frac{Z_g}{Z_p} = \frac{2 n}{n + 2}",
            slip(
                "An internal wheel is driven while the driver turns by 180° + 360°/n. The printed ratio is that of the \
                 external mechanism, where it is 180° − 360°/n.",
                "The pin's velocity at both ends, by coordinates: along the slot for the corrected ratio.",
                "The shown mechanism, with four slots, works: its pinion makes three turns in a move. So do wheels of three \
                 and of six slots. With any other number the pin leaves across the slot.",
            ),
        ),
        reach(INTERNAL, "wild.mecha-internal.reach"),
    ]
}

fn gears(place: Place, id: &'static str, moving: fn(&Fit) -> f64) -> Claim {
    place
        .equation(id, r"\frac{Z_g}{Z_p} = \frac{2 n}{n - 2}", "teeth of the fixed gear over those of the pinion")
        .evaluated(ClosedForm, move |tex| counted(ANY, |slots| whole_turns(tex, &Fit::by_wheel(slots), moving)))
        .read(Vectors, move |tex| {
            let found: Option<Vec<bool>> =
                ANY.map(|slots| along_the_slot(tex, &Fit::by_vectors(slots), moving)).collect();
            Some(found?.into_iter().all(|holds| holds))
        })
        .read_as("Any whole number of turns of the pinion in a move will do.")
}

fn reach(place: Place, id: &'static str) -> Claim {
    formula(place, id, r"R + r = B \sin(\pi/n)", "farthest place of the pin from the driver's axis", ANY, |fit| {
        vec![("R", 0.75 * fit.crank), ("r", 0.25 * fit.crank), ("B", fit.centres), ("n", fit.slots)]
    })
}

/// The most turns of the pinion in a move that are tried.
const MOST: i32 = 9;

/// The letters of the page for a ratio of the teeth.
fn letters(ratio: f64, slots: f64) -> [Moment; 1] {
    [Moment::default().with([("Z_g", 20.0 * ratio), ("Z_p", 20.0), ("n", slots)])]
}

/// Whether the equation holds for a ratio with which the pinion makes some whole number of turns in a move.
fn whole_turns(tex: &str, fit: &Fit, moving: fn(&Fit) -> f64) -> Option<bool> {
    let found: Option<Vec<bool>> =
        (1..=MOST).map(|turns| holds(tex, &letters(f64::from(turns) * 2.0 * PI / moving(fit), fit.slots))).collect();
    Some(found?.contains(&true))
}

/// Whether the equation holds for a ratio with which the pin leaves as it came: at the slot's end, along the slot.
fn along_the_slot(tex: &str, fit: &Fit, moving: fn(&Fit) -> f64) -> Option<bool> {
    let leaves = |ratio: f64| {
        // Crank and pinion arm as they are when the pin leaves; at entry both point the same way.
        let direction = |angle: f64| Vector2::new(libm::cos(angle), libm::sin(angle));
        let (crank, arm) = (moving(fit) / 2.0, moving(fit) / 2.0 + ratio * moving(fit));
        let place = direction(crank) * 0.75 + direction(arm) * 0.25;
        let velocity = direction(crank + PI / 2.0) * 0.75 + direction(arm + PI / 2.0) * (0.25 * (1.0 + ratio));
        // The slot is at right angles to the crank there.
        vanishes((place - direction(crank)).norm()) && vanishes(velocity.dot(&direction(crank)) / velocity.norm())
    };
    let ratios = (1..=8 * MOST).map(|eighths| f64::from(eighths) / 8.0 * 2.0 * PI / moving(fit));
    let found: Option<Vec<bool>> =
        ratios.filter(|ratio| leaves(*ratio)).map(|ratio| holds(tex, &letters(ratio, fit.slots))).collect();
    Some(found?.contains(&true))
}
