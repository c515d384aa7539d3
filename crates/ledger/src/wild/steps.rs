//! How many steps a turn has.

use super::fit::ANY;
use super::*;
use crate::by_id::numbers;
use geneva_kinematics::wheel::Wheel;
use std::ops::RangeInclusive;

const PROBSEE: Place = at(page!("https://probsee.com/p/Geneva_drive"));
const STATEMASTER: Place = at(page!("http://www.statemaster.com/encyclopedia/Geneva-drive"));
const ANVILATE: Place = at(page!("https://github.com/clay-good/anvilate/blob/HEAD/src/anvilate/analysis/geneva.py"));

pub fn claims() -> Vec<Claim> {
    vec![
        PROBSEE
            .statement(
                "wild.probsee.steps",
                "3 to 18 indexing steps per input revolution",
                "how many steps there are in a turn of the driver",
            )
            .by(ClosedForm, |stated| {
                // One pin makes a step; the formula crate refuses more pins than there is room for.
                let most = |slots| PINS.rev().find(|pins| Wheel::with_pins(slots, *pins).is_ok());
                steps(stated, Fit::by_wheel, most)
            })
            .by(Vectors, |stated| {
                // So many moves after one another as fit into a turn.
                let room = |slots| 2.0 * PI * (1.0 + 1e-12) / Fit::by_vectors(slots).moving;
                steps(stated, Fit::by_vectors, |slots| PINS.rev().find(|pins| f64::from(*pins) <= room(slots)))
            })
            .read_as("The wheels have 3 to 18 slots, and one pin or as many as there is room for.")
            .corrected(
                "3 to 18 steps per turn of the wheel",
                Slip {
                    consequence: Consequence::Remark,
                    origin: Origin::Misprint,
                    ..slip(
                        "One pin moves the wheel once in a turn of the driver, by one slot. So 3 to 18 is the number of \
                         steps in a turn of the wheel. More pins make more steps in a turn of the driver, six at the \
                         most, with three slots.",
                        "So many moves as are said do not fit into a turn of the driver.",
                        "A reader expects up to eighteen steps for a turn of the shaft that he drives.",
                    )
                },
            ),
        formula(
            STATEMASTER,
            "wild.statemaster.step",
            r"\phi = 360^{\circ}/n",
            "what the wheel turns for each full turn of the driver",
            ANY,
            |fit| vec![(r"\phi", fit.step), ("n", fit.slots)],
        ),
        ANVILATE
            .statement("wild.anvilate.fewer", "fewer slots", "fewer slots give a longer rest")
            .by(ClosedForm, |stated| fewer(Fit::by_wheel, stated))
            .by(Vectors, |stated| fewer(Fit::by_vectors, stated))
            .but_not("fewer slots give a shorter rest"),
    ]
}

/// How many pins are tried; there is never room for so many.
const PINS: RangeInclusive<u32> = 1..=18;

/// Whether a turn of the wheel has as many steps as are said, for the numbers of slots that are printed; or a turn of the
/// driver.
fn steps(stated: Stated, by: fn(u32) -> Fit, most: impl Fn(u32) -> Option<u32>) -> Finding {
    let [first, last] = numbers("wild.probsee.steps")[..] else { return Finding::new(false, "not a range of slots") };
    let of = |slots: u32| stated.pick(Some(libm::round(2.0 * PI / by(slots).step) as u32), most(slots));
    let found: Vec<u32> = (first..=last).filter_map(of).collect();
    let [least, most] = [found.iter().min(), found.iter().max()].map(|steps| steps.copied().unwrap_or(0));
    Finding::new(stated.numbers() == [least, most].map(f64::from), format!("from {least} to {most} steps"))
}

/// Whether each slot less makes the rest longer; or shorter.
fn fewer(by: fn(u32) -> Fit, stated: Stated) -> Finding {
    let longer = |slots: u32| by(slots - 1).resting - by(slots).resting;
    let holds = (4..=60).all(|slots| longer(slots) * stated.pick(1.0, -1.0) > 0.0);
    Finding::new(
        holds,
        format!("{:.1} degrees of the driver more with three slots than with four", longer(4).to_degrees()),
    )
}
