//! A pin on a pinion that rolls on a fixed gear, in the place of the crank.
//!
//! As it enters and as it leaves, the pin must be at its farthest from the driver's axis: only there it moves at right
//! angles to the crank, along the slot. So the pinion makes a whole number of turns against the crank while the wheel
//! moves. It must also make a whole number in a turn of the crank, or the pin is elsewhere when the next slot comes: the
//! fixed gear has a whole number of times the teeth of the pinion.

use super::fit::{ANY, counted};
use super::*;
use geneva_evidence::agreement::vanishes;
use geneva_evidence::tex::{Moment, holds};
use nalgebra::Vector2;

/// Radii of the crank and of the pin's arm on the pinion, in the greatest distance of the pin.
const ARMS: [f64; 2] = [0.71, 0.29];

/// What the driver turns while the wheel turns.
type Moving = fn(&Fit) -> f64;

pub(super) fn claims() -> Vec<Claim> {
    vec![
        gears(MECHA_EXTERNAL, "wild.mecha-external.gears", GEARS[0], LEAST[0], |fit| fit.moving),
        reach(MECHA_EXTERNAL, "wild.mecha-external.reach"),
        // An internal wheel is driven on the rest of the turn.
        gears(MECHA_INTERNAL, "wild.mecha-internal.gears", GEARS[1], LEAST[1], |fit| fit.resting).in_places(2),
        MECHA_INTERNAL
            .value("wild.mecha-internal.teeth", "80", "", "teeth of the fixed gear for four slots, with a pinion of 20")
            .first_route(Evidence::CLOSED_FORM, || 20.0 * least(&by_turns(&Fit::by_wheel(4), |fit| fit.resting)))
            .second_route(Evidence::VECTORS, || 20.0 * least(&by_places(&Fit::by_vectors(4), |fit| fit.resting)))
            .interpreted_as("We take the least ratio with which the mechanism works."),
        reach(MECHA_INTERNAL, "wild.mecha-internal.reach"),
    ]
}

/// The corrected forms for an external and for an internal wheel: k is the least number that makes the ratio whole.
const LEAST: [&str; 2] = [r"\frac{Z_g}{Z_p} = k \frac{2 n}{n - 2}", r"\frac{Z_g}{Z_p} = k \frac{2 n}{n + 2}"];

/// The slip of a ratio that need not be an integer. For an internal wheel, the page gives the ratio of an external one.
const FRACTION: Slip = slip(
    WHOLE_TURNS,
    "We computed the pin's motion in coordinates for all ratios up to twice the number of slots, in steps of one \
     twelfth. The pin must move along the slot as it leaves one slot and as it comes to the next one.",
    "The formula is right for three, four and six slots. For five it gives 10/3, so the pin comes back to its place \
     only in every third turn of the crank. For the pin to come back in every turn, the ratio must be 10.",
);

const WHOLE_TURNS: &str = "The pinion must make a whole number of turns relative to the crank while the wheel moves, \
                           and also in a full turn of the crank. By the first condition, the ratio must be a multiple \
                           of the printed expression: 2n/(n − 2) for an external wheel and 2n/(n + 2) for an internal \
                           one. By the second condition, the ratio must be an integer. So we multiply the expression \
                           by k, the least integer that makes the ratio an integer.";

/// What the ratio of teeth is for, with an external and with an internal wheel.
const GEARS: [&str; 2] = [
    "number of teeth of the fixed gear over the number of teeth of the pinion, for an external wheel with n slots",
    "number of teeth of the fixed gear over the number of teeth of the pinion, for an internal wheel with n slots",
];

fn gears(place: Locator, id: &'static str, meaning: &'static str, corrected: &'static str, moving: Moving) -> Claim {
    place
        .equation(id, r"\frac{Z_g}{Z_p} = \frac{2 n}{n - 2}", meaning)
        .evaluated(Evidence::CLOSED_FORM, move |tex| {
            works(tex, |slots| by_turns(&Fit::by_wheel(slots), moving), moving)
        })
        .read(Evidence::VECTORS, move |tex| {
            Some(works(tex, |slots| by_places(&Fit::by_vectors(slots), moving), moving).holds)
        })
        .interpreted_as(
            "The formula is given for n slots, so we tried it for 3 to 60. The page shows four slots, for which the \
             formula is right. We count the formula as right if it gives the least ratio with which the mechanism \
             works.",
        )
        .corrected(corrected, FRACTION)
}

fn reach(place: Locator, id: &'static str) -> Claim {
    formula(place, id, r"R + r = B \sin(\pi/n)", "farthest distance of the pin from the driver's axis", ANY, |fit| {
        vec![("R", 0.75 * fit.crank), ("r", 0.25 * fit.crank), ("B", fit.centres), ("n", fit.slots)]
    })
}

/// For which wheels an equation gives the least ratio with which the mechanism works.
fn works(tex: &str, working: impl Fn(u32) -> Vec<f64>, moving: Moving) -> Finding {
    let gives = |slots: u32| {
        // Turns of the pinion against the crank in a move, which the least ratio makes whole; k times as many as the least
        // fraction has.
        let (fit, ratio) = (Fit::by_wheel(slots), least(&working(slots)));
        let turns = libm::round(ratio * moving(&fit) / (2.0 * PI));
        let letters = [("Z_g", 20.0 * ratio), ("Z_p", 20.0), ("n", f64::from(slots)), ("k", turns)];
        holds(tex, &[Moment::default().with(letters)])
    };
    counted(ANY, gives)
}

/// The least of some ratios, in ascending order; not a number if there is none.
fn least(ratios: &[f64]) -> f64 {
    ratios.first().copied().unwrap_or(f64::NAN)
}

/// The least ratio with which an external wheel of so many slots works.
#[cfg(test)]
pub(super) fn least_ratio(slots: u32) -> f64 {
    least(&by_turns(&Fit::by_wheel(slots), |fit| fit.moving))
}

/// Ratios of teeth that let the pin leave as it came, and come back: whole numbers that give whole turns in a move, for up
/// to two turns for each slot.
fn by_turns(fit: &Fit, moving: Moving) -> Vec<f64> {
    let whole = |number: &f64| vanishes(number - libm::round(*number));
    let ratios = (1..=2 * fit.slots as u32).map(|turns| f64::from(turns) * 2.0 * PI / moving(fit));
    ratios.filter(whole).collect()
}

/// Ratios of teeth, among all in twelfths, that let the pin leave as it came, and come back, by coordinates: the pin at its
/// farthest, on its way along the slot, as it leaves and as it comes to the next slot. The gear may have its teeth outside or inside.
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
            // As the reasons say.
            assert_eq!([3, 4, 6].contains(&slots), (2 * slots).is_multiple_of(slots - 2), "{slots} slots");
        }
    }
}
