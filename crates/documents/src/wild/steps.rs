//! How many steps a turn has.

use super::fit::ANY;
use super::*;
use geneva_kinematics::wheel::Wheel;
use std::ops::RangeInclusive;

pub(super) fn claims() -> Vec<Claim> {
    vec![
        PROBSEE
            .statement(
                "wild.probsee.steps",
                "3 to 18 indexing steps per input revolution",
                "number of steps in a turn of the driver",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // One pin makes a step; the formula crate refuses more pins than there is room for.
                let most = |slots| PINS.rev().find(|pins| Wheel::with_pins(slots, *pins).is_ok());
                steps(stated, Fit::by_wheel, most)
            })
            .second_route(Evidence::VECTORS, |stated| {
                // So many moves after one another as fit into a turn.
                let room = |slots| 2.0 * PI * (1.0 + 1e-12) / Fit::by_vectors(slots).moving;
                steps(stated, Fit::by_vectors, |slots| PINS.rev().find(|pins| f64::from(*pins) <= room(slots)))
            })
            .interpreted_as(
                "We take wheels with 3 to 18 slots, and drivers with one pin or with as many pins as there is room \
                 for.",
            )
            .corrected(
                "3 to 18 steps per turn of the wheel",
                Slip {
                    consequence: Consequence::Remark,
                    origin: Origin::Concept,
                    ..slip(
                        "In each turn of the driver, one pin moves the wheel once, by one slot. So the 3 to 18 steps \
                         are per turn of the wheel. A turn of the driver makes one step for each pin. At most six pins \
                         fit, and six fit only with three slots. So there are 1 to 6 steps in a turn of the driver.",
                        "Each move takes a certain part of a turn of the driver, so one turn cannot hold as many moves \
                         as the page says.",
                        "A reader of the page expects up to eighteen steps for each turn of the input shaft, but there \
                         are six at most.",
                    )
                },
            ),
        formula(
            STATEMASTER,
            "wild.statemaster.step",
            r"\phi = 360^{\circ}/n",
            "how far the wheel turns for each full turn of the driver",
            ANY,
            |fit| vec![(r"\phi", fit.step), ("n", fit.slots)],
        ),
        formula(ANVILATE, "wild.anvilate.index", r"\phi = 360^{\circ}/n", STEP, ANY, |fit| {
            vec![(r"\phi", fit.step), ("n", fit.slots)]
        }),
        formula(CALCULATOR, "wild.firgelli-time.step", r"\theta_{index} = 360^{\circ}/n", STEP, ANY, |fit| {
            vec![(r"\theta_{index}", fit.step), ("n", fit.slots)]
        }),
        formula(
            CALCULATOR,
            "wild.firgelli-time.speed",
            r"\omega_{geneva} = \omega_{driver}/n",
            "mean speed of the wheel, from the speed of the driver (RPM on the page)",
            ANY,
            |fit| {
                // Turns of the wheel in a time, over the turns of the driver: a step in the time of a move and a rest.
                let driver = 50.0 + fit.slots;
                let speed = driver * fit.step / (fit.moving + fit.resting);
                vec![(r"\omega_{geneva}", speed), (r"\omega_{driver}", driver), ("n", fit.slots)]
            },
        )
        .interpreted_as("We read it as the mean speed over many steps."),
        formula(INDEXING, "wild.firgelli-indexing.step", r"\theta = 360^{\circ}/n", STEP, ANY, |fit| {
            vec![(r"\theta", fit.step), ("n", fit.slots)]
        }),
        formula(
            INDEXING,
            "wild.firgelli-indexing.cycle",
            r"T_{cycle} = 60/\mathrm{RPM}",
            "time of a move and a rest in seconds",
            ANY,
            |fit| {
                let rpm = 7.0 + fit.slots;
                let cycle = (fit.moving + fit.resting) / (2.0 * PI * rpm / 60.0);
                vec![(r"T_{cycle}", cycle), (r"\mathrm{RPM}", rpm)]
            },
        ),
        fewest(ANVILATE, "wild.anvilate.least", "n ≥ 3", 1).but_not("two slots will do"),
        fewest(WORKBENCH, "wild.gear-workbench.least", "n >= 3", 1).but_not("two slots will do"),
        fewest(GENERATOR, "wild.generator.least", "n at least 3", 1).but_not("two slots will do"),
        fewest(SDFX, "wild.sdfx.least", "> 2", 1).but_not("two slots will do").interpreted_as(
            "We read it as the program's message says it of the sectors, although the program itself accepts two.",
        ),
        fewest(MECHANICS, "wild.mechanics.least", "N > 4", 0)
            .interpreted_as("The page speaks of “separators”, which we read as the slots.")
            .corrected(
                "N > 2",
                Slip {
                    consequence: Consequence::Remark,
                    ..slip(
                        "Wheels with three or four slots work, and all the formulas on the page hold for them.",
                        "Coordinates show that the pin enters a slot and leaves it again in a wheel with three slots, \
                         but never in a wheel with two.",
                        "The page excludes the commonest wheel, which has four slots.",
                    )
                },
            ),
        ANVILATE
            .statement(
                "wild.anvilate.more",
                "more slots",
                "more slots let the wheel move for a larger part of the cycle",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| more(Fit::by_wheel, stated))
            .second_route(Evidence::VECTORS, |stated| more(Fit::by_vectors, stated))
            .but_not("more slots let the wheel move for a smaller part of the cycle"),
        ANVILATE
            .statement("wild.anvilate.fewer", "fewer slots", "fewer slots give a longer rest")
            .first_route(Evidence::CLOSED_FORM, |stated| fewer(Fit::by_wheel, stated))
            .second_route(Evidence::VECTORS, |stated| fewer(Fit::by_vectors, stated))
            .but_not("fewer slots give a shorter rest"),
    ]
}

const STEP: &str = "how far the wheel turns in each step";

/// How few slots a wheel can have, by a number and a sign of inequality. A neighbour says so many less.
fn fewest(place: Locator, id: &'static str, printed: &'static str, less: u32) -> Claim {
    place
        .statement(id, printed, "least number of slots that a wheel can have")
        .first_route(Evidence::CLOSED_FORM, move |stated| least(stated, less, |slots| Wheel::new(slots).is_ok()))
        .second_route(Evidence::VECTORS, move |stated| {
            // The pin comes into the slot: the driver turns by some angle while it is there.
            least(stated, less, |slots| Fit::by_vectors(slots).moving > 1e-6)
        })
}

/// Whether the least number of slots is what is said; or what a neighbour says, so many less.
fn least(stated: Stated, less: u32, works: impl Fn(u32) -> bool) -> Finding {
    let above = stated.characters().contains('>') && !stated.characters().contains(">=");
    let said = stated.count() + u32::from(above);
    let said = stated.pick(said, said.saturating_sub(less));
    let found = (1..=60).find(|slots| works(*slots) && (*slots..=60).all(&works));
    let first = found.unwrap_or(0);
    let below = first.saturating_sub(1);
    Finding::new(found == Some(said), format!("wheels of {first} to 60 slots work, but a wheel of {below} does not"))
}

/// Whether each slot more makes the move longer; or shorter.
fn more(by: fn(u32) -> Fit, stated: Stated) -> Finding {
    let longer = |slots: u32| by(slots).moving - by(slots - 1).moving;
    let holds = (4..=60).all(|slots| longer(slots) * stated.pick(1.0, -1.0) > 0.0);
    Finding::new(
        holds,
        format!(
            "the move takes {:.1} more degrees of the driver's turn with four slots than with three",
            longer(4).to_degrees()
        ),
    )
}

/// How many pins are tried; there is never room for so many.
const PINS: RangeInclusive<u32> = 1..=18;

/// Whether a turn of the wheel has as many steps as are said, for the numbers of slots that are printed; or a turn of the
/// driver.
fn steps(stated: Stated, by: fn(u32) -> Fit, most: impl Fn(u32) -> Option<u32>) -> Finding {
    let [first, last] = WILD.printed_integers("wild.probsee.steps")[..] else {
        return Finding::new(false, "not a range of slots");
    };
    // In a turn of the wheel as many as it has slots; in a turn of the driver from one, with one pin, to as many as fit.
    let of = |slots: u32| {
        let whole = libm::round(2.0 * PI / by(slots).step) as u32;
        stated.pick(Some([whole; 2]), most(slots).map(|most| [1, most]))
    };
    let found: Vec<[u32; 2]> = (first..=last).filter_map(of).collect();
    let least = found.iter().map(|[least, _]| *least).min().unwrap_or(0);
    let most = found.iter().map(|[_, most]| *most).max().unwrap_or(0);
    let turn = stated.pick("wheel", "driver");
    Finding::new(
        stated.numbers() == [least, most].map(f64::from),
        format!("there are {least} to {most} steps in a turn of the {turn}, and this form says {first} to {last}"),
    )
}

/// Whether each slot less makes the rest longer; or shorter.
fn fewer(by: fn(u32) -> Fit, stated: Stated) -> Finding {
    let longer = |slots: u32| by(slots - 1).resting - by(slots).resting;
    let holds = (4..=60).all(|slots| longer(slots) * stated.pick(1.0, -1.0) > 0.0);
    Finding::new(
        holds,
        format!(
            "the rest takes {:.1} more degrees of the driver's turn with three slots than with four",
            longer(4).to_degrees()
        ),
    )
}
