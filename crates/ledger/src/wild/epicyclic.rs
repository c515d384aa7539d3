//! A pin on a pinion that rolls on a fixed gear, in the place of the crank.
//!
//! As it enters and as it leaves, the pin must be at its farthest from the driver's axis: only there it moves at right
//! angles to the crank, along the slot. So the pinion makes a whole number of turns against the crank while the wheel
//! moves. It must also make a whole number in a turn of the crank, or the pin is elsewhere when the next slot comes: the
//! fixed gear has a whole number of times the teeth of the pinion.

use super::fit::{ANY, counted};
use super::*;
use crate::agreement::vanishes;
use crate::tex::{Moment, holds};
use nalgebra::Vector2;

const EXTERNAL: Place = at(page!("https://mechamechanisms.com/external-geneva-and-epicyclic-gear-mechanism-1"));
const INTERNAL: Place = at(page!("https://mechamechanisms.com/internal-geneva-and-epicyclic-gear-mechanism-1"));

/// The numbers of slots for which the printed ratio is a whole number.
const WHOLE: [u32; 3] = [3, 4, 6];

/// Radii of the crank and of the pin's arm on the pinion, in the greatest distance of the pin.
const ARMS: [f64; 2] = [0.71, 0.29];

/// What the driver turns while the wheel turns.
type Moving = fn(&Fit) -> f64;

pub fn claims() -> Vec<Claim> {
    vec![
        gears(EXTERNAL, "wild.mecha-external.gears", |fit| fit.moving),
        reach(EXTERNAL, "wild.mecha-external.reach"),
        // An internal wheel is driven on the rest of the turn.
        gears(INTERNAL, "wild.mecha-internal.gears", |fit| fit.resting),
        reach(INTERNAL, "wild.mecha-internal.reach"),
    ]
}

fn gears(place: Place, id: &'static str, moving: Moving) -> Claim {
    place
        .equation(id, r"\frac{Z_g}{Z_p} = \frac{2 n}{n - 2}", "teeth of the fixed gear over those of the pinion")
        .evaluated(ClosedForm, move |tex| of_the_whole(tex, |slots| by_turns(&Fit::by_wheel(slots), moving)))
        .read(Vectors, move |tex| {
            Some(of_the_whole(tex, |slots| by_places(&Fit::by_vectors(slots), moving)).holds)
        })
        .read_as(
            "For the wheels for which the ratio is a whole number. The page shows one of four slots. With any other ratio the \
             pin does not come back to its place in the next turn: five slots want the ratio 10.",
        )
}

fn reach(place: Place, id: &'static str) -> Claim {
    formula(place, id, r"R + r = B \sin(\pi/n)", "farthest place of the pin from the driver's axis", ANY, |fit| {
        vec![("R", 0.75 * fit.crank), ("r", 0.25 * fit.crank), ("B", fit.centres), ("n", fit.slots)]
    })
}

/// Whether an equation gives a ratio with which the mechanism works, for the wheels for which the printed one is whole and
/// for no other.
fn of_the_whole(tex: &str, working: impl Fn(u32) -> Vec<f64>) -> Finding {
    let gives = |slots: u32, ratio: f64| {
        holds(tex, &[Moment::default().with([("Z_g", 20.0 * ratio), ("Z_p", 20.0), ("n", f64::from(slots))])])
    };
    let works = |slots: &u32| working(*slots).into_iter().any(|ratio| gives(*slots, ratio) == Some(true));
    let found: Vec<u32> = ANY.filter(works).collect();
    let how = counted(ANY, |slots| Some(found.contains(&slots))).how;
    Finding::new(found == WHOLE, how)
}

/// Ratios of teeth that let the pin leave as it came, and come back: whole numbers that give whole turns in a move, for up
/// to two turns for each slot.
fn by_turns(fit: &Fit, moving: Moving) -> Vec<f64> {
    let whole = |number: &f64| vanishes(number - libm::round(*number));
    let ratios = (1..=2 * fit.slots as u32).map(|turns| f64::from(turns) * 2.0 * PI / moving(fit));
    ratios.filter(whole).collect()
}

/// The same by coordinates, of all ratios in twelfths: the pin at its farthest, on its way along the slot, as it leaves and
/// as it comes to the next slot. The gear may have its teeth outside or inside.
fn by_places(fit: &Fit, moving: Moving) -> Vec<f64> {
    let half = moving(fit) / 2.0;
    let direction = |angle: f64| Vector2::new(libm::cos(angle), libm::sin(angle));
    let enters_or_leaves = |ratio: f64, crank: f64| {
        let arm = crank + ratio * (crank + half);
        let place = direction(crank) * ARMS[0] + direction(arm) * ARMS[1];
        let velocity = direction(crank + PI / 2.0) * ARMS[0] + direction(arm + PI / 2.0) * (ARMS[1] * (1.0 + ratio));
        // The slot is at right angles to the crank there.
        vanishes((place - direction(crank)).norm()) && vanishes(velocity.dot(&direction(crank)) / velocity.norm())
    };
    let works = |ratio: &f64| {
        [*ratio, -ratio].iter().all(|ratio| [half, 2.0 * PI - half].iter().all(|at| enters_or_leaves(*ratio, *at)))
    };
    (1..=24 * fit.slots as u32).map(|twelfths| f64::from(twelfths) / 12.0).filter(works).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_routes_give_the_least_ratio_of_every_wheel() {
        let divisor =
            |slots: u32| (1..=4).rev().find(|by| (2 * slots).is_multiple_of(*by) && (slots - 2).is_multiple_of(*by));
        let moves: [Moving; 2] = [|fit| fit.moving, |fit| fit.resting];
        for (slots, moving) in ANY.flat_map(|slots| moves.map(|moving| (slots, moving))) {
            let least = divisor(slots).map(|divisor| f64::from(2 * slots / divisor));
            let found = [by_turns(&Fit::by_wheel(slots), moving), by_places(&Fit::by_vectors(slots), moving)];
            for ratios in found {
                assert_eq!(ratios.first().map(|ratio| libm::round(*ratio)), least, "{slots} slots");
            }
            assert_eq!(WHOLE.contains(&slots), (2 * slots).is_multiple_of(slots - 2), "{slots} slots");
        }
        // As the reading says.
        assert_eq!(libm::round(by_turns(&Fit::by_wheel(5), moves[0])[0]), 10.0);
    }
}
