//! Which numbers of pins and slots an escapement can have: Eq. (1-3), its table and the remarks on it.

use super::geometry::{and_with_a_slot_more, every};
use super::hand_over::Drawn;
use super::hand_over_letters::{COUNTS, RIGHT_TRIANGLE};
use super::*;
use geneva_evidence::agreement::joined;
use geneva_kinematics::escapement::entry_proofs::PinsAndSlots;
use geneva_kinematics::escapement::{pins_needed, possible_pairs};
use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::{Jet, Rational, rational};

const TABLE_AT: Locator = at("Table after Eq. (1-3)");
const REMARK: Locator = at("Paragraph after the table of Eq. (1-3)");

/// The columns of the table of possible combinations: ids of the numbers of slots and of pins.
pub(super) const TABLE: [(&str, &str); 3] = [
    ("meyer.table.three-slots", "meyer.table.six-pins"),
    ("meyer.table.four-slots", "meyer.table.four-pins"),
    ("meyer.table.six-slots", "meyer.table.three-pins"),
];

pub(super) fn claims() -> Vec<Claim> {
    [angle_sum(), combinations(), remarks()].concat()
}

fn angle_sum() -> Vec<Claim> {
    vec![
        at("Eq. (1-3), 1st line")
            .equation(
                "meyer.half-turn",
                r"\theta_o + \phi_o + \frac{\pi}{2} = \pi",
                "sum of the angles in the large triangle",
            )
            .in_letters(RIGHT_TRIANGLE),
        at("Eq. (1-3), 2nd line")
            .equation("meyer.quarter-turn", r"\theta_o + \phi_o = \frac{\pi}{2}", "the two acute angles")
            .in_letters(RIGHT_TRIANGLE),
        at("Eq. (1-3), 3rd line")
            .equation(
                "meyer.angle-sum",
                r"\frac{\pi}{m} + \frac{\pi}{n} = \frac{\pi}{2}",
                "sum of the two acute angles, by the numbers of pins and slots",
            )
            .in_letters(COUNTS),
        at("Eq. (1-3), 4th line")
            .equation("meyer.eq-1-3", r"m = \frac{2n}{n-2}", "number of pins")
            .in_letters(COUNTS)
            .with_second_witness(Evidence::LIMIT_CASE, || {
                let holds = (3..=100).all(|n| {
                    (1..=100).all(|m| makes_a_quarter(m, n) == pins_needed(n).is_some_and(|pins| pins == whole(m)))
                });
                Finding::new(holds, "of all numbers up to 100, the same ones satisfy both lines")
            }),
        at("Paragraph after Eq. (1-3)")
            .statement("meyer.continuous", "continuous motion", "the two conditions make the motion continuous")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let gaps = Mechanism::ALL.into_iter().flat_map(|at| {
                    let crank = Turn::from_radians(PI / f64::from(at.pins() + stated.pick(0, 1)));
                    let ratio = at.centre_distance_ratio();
                    // By Eqs. (1-6) and (1-7): what is missing to a slot, and the jump of the follower's speed.
                    let angle = 2.0 * libm::atan(crank.sin / (ratio - crank.cos)) - at.follower_pitch_angle();
                    [angle, velocity_ratio(&ratio, &crank) - velocity_ratio(&ratio, &crank.reversed())]
                });
                every(gaps, vanishes, "the jumps of the follower's angle and speed from pin to pin are")
            })
            .second_route(Evidence::VECTORS, |stated| {
                let missing = Mechanism::ALL.into_iter().map(|at| {
                    let (pins, slots) = (at.pins() + stated.pick(0, 1), at.slots());
                    let drawn = Drawn { pins, slots, axis: 1.0 / libm::sin(PI / f64::from(slots)) };
                    turned_by_a_pin(&drawn) * f64::from(slots) / (2.0 * PI)
                });
                every(
                    missing,
                    |slots| (slots - 1.0).abs() < 1e-9,
                    "the numbers of slots by which each pin carries the follower are",
                )
            })
            .but_not("with Eq. (1-1) and one more pin than Eq. (1-3) gives, the motion is continuous too"),
    ]
}

fn combinations() -> Vec<Claim> {
    let value = |id, meaning, printed, computed: fn() -> f64, witness: fn() -> f64| {
        TABLE_AT
            .value(id, printed, "", meaning)
            .first_route(Evidence::CLOSED_FORM, computed)
            .second_route(Evidence::LIMIT_CASE, witness)
    };
    let [first, second, third] = TABLE;
    vec![
        at("Sentence before the table of Eq. (1-3)")
            .statement("meyer.only-three", "only three", "there are three combinations of integers, and no more")
            .first_route(Evidence::EXACT_IDENTITY, |stated| {
                let Finding { holds, how, .. } = prove(&PinsAndSlots::Factors).into();
                let found = possible_pairs().len();
                Finding::new(
                    holds && found == stated.pick(stated.count() as usize, 4),
                    format!("(m − 2)(n − 2) = 4, and 4 has {found} pairs of divisors; {how}"),
                )
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                let found = found_by_trying().len();
                Finding::new(
                    found == stated.pick(stated.count() as usize, 4),
                    format!("we tried all numbers up to 100 and found {found}"),
                )
            })
            .but_not("four combinations"),
        value(first.0, "slots of the 1st combination", "3", || listed(0).0, || tried(0).0),
        value(second.0, "slots of the 2nd combination", "4", || listed(1).0, || tried(1).0),
        value(third.0, "slots of the 3rd combination", "6", || listed(2).0, || tried(2).0),
        value(first.1, "pins of the 1st combination", "6", || listed(0).1, || tried(0).1),
        value(second.1, "pins of the 2nd combination", "4", || listed(1).1, || tried(1).1),
        value(third.1, "pins of the 3rd combination", "3", || listed(2).1, || tried(2).1),
    ]
}

fn remarks() -> Vec<Claim> {
    vec![
        REMARK
            .statement("meyer.fewer-pins", "m decreases", "with more slots there are fewer pins")
            .first_route(Evidence::LIMIT_CASE, |stated| {
                // More pins before than behind; and no more than in inverse proportion.
                let holds = (3..1000).all(|n| {
                    pins_needed(n).zip(pins_needed(n + 1)).is_some_and(|(more, fewer)| {
                        more > fewer && stated.pick(true, more * whole(n) == fewer * whole(n + 1))
                    })
                });
                Finding::new(holds, "we compared each number of slots with the next, from 3 to 1000")
            })
            .second_route(Evidence::JET, |stated| {
                // m = 2n/(n − 2) as a series in n.
                let pins = |slots: f64| {
                    let n = Jet::<f64, 2>::variable(slots);
                    Jet::constant(2.0) * n / (n - Jet::constant(2.0))
                };
                let holds = (1..=1000).all(|k| {
                    let slots = 2.0 + f64::from(k) / 10.0;
                    let of = pins(slots);
                    of.rate() < 0.0 && stated.pick(true, agrees(of.rate(), -of.value() / slots))
                });
                Finding::new(
                    holds,
                    format!(
                        "the derivative dm/dn is {:.2} for three slots and {:.4} for twenty",
                        pins(3.0).rate(),
                        pins(20.0).rate()
                    ),
                )
            })
            .but_not("m decreases in inverse proportion"),
        REMARK
            .statement("meyer.two-pins", "2", "after three pins come two, with infinitely many slots")
            .first_route(Evidence::EXACT_IDENTITY, |stated| {
                let Finding { holds, how, .. } = prove(&PinsAndSlots::NeverTwo).into();
                let above = [1_000, 1_000_000, 1_000_000_000].map(|n| {
                    pins_needed(n)
                        .map_or(f64::NAN, |pins| (pins - whole(stated.pick(stated.count(), 1))).to_f64().value())
                });
                let falls = above.windows(2).all(|pair| pair[1] > 0.0 && pair[1] < pair[0] / 100.0);
                Finding::new(
                    holds && falls,
                    format!(
                        "with a thousand, a million and 10⁹ slots, the number of pins exceeds this limit by {}; {how}",
                        joined(above)
                    ),
                )
            })
            .second_route(Evidence::VECTORS, |stated| {
                // The pin's path is along the slot, so the follower's axis is on the tangent of the pins' circle.
                let crank = PI / f64::from(stated.pick(stated.count(), 1));
                let tangent = Drawn::velocity(crank);
                Finding::new(
                    vanishes(tangent.y),
                    format!("at π/m the pin's path and the line of centres diverge by {:.3} per unit", tangent.y),
                )
            })
            .but_not("one pin, with infinitely many slots"),
        REMARK
            .statement(
                "meyer.tangent",
                "coincident with the centerline",
                "as the pin enters and leaves, its path runs along the slot's centre line",
            )
            .first_route(Evidence::EXACT_IDENTITY, |stated| {
                let along: fn(&HandOver) -> bool =
                    |at| [&at.leaving, &at.entering].iter().all(|pin| is_zero(&pin.beside) && is_zero(&pin.across));
                let found = exactly(along, "place and velocity of both pins are on that line");
                and_with_a_slot_more(found, stated)
            })
            .second_route(Evidence::VECTORS, |stated| {
                let parts = Mechanism::ALL.into_iter().flat_map(|at| {
                    let drawn = Drawn::new(at.pins(), at.slots() + stated.pick(0, 1));
                    [drawn.half(), -drawn.half()].map(|end| {
                        // A step of the pin along its path, by its places alone.
                        let step = 1e-6;
                        let (here, there) = (drawn.place(end), drawn.place(end + step));
                        here.normalize().perp(&(there - here)) / step
                    })
                });
                every(parts, |part| part.abs() < 1e-5, "the components of a small step of the pin across that line are")
            })
            .but_not("the path runs along it too if the follower has one more slot"),
    ]
}

/// How far a pin carries the follower over its engagement, from π/m before the line of centres to π/m behind it: its
/// rate summed by Simpson's rule.
fn turned_by_a_pin(drawn: &Drawn) -> f64 {
    const STEPS: u32 = 2000;
    let step = 2.0 * drawn.half() / f64::from(STEPS);
    let rate = |k: u32| drawn.turning(step * f64::from(k) - drawn.half());
    let inner: f64 = (1..STEPS).map(|k| f64::from(2 + 2 * (k % 2)) * rate(k)).sum();
    step / 3.0 * (rate(0) + inner + rate(STEPS))
}

/// Whether π/m and π/n make a quarter turn.
fn makes_a_quarter(pins: u32, slots: u32) -> bool {
    2 * (pins + slots) == pins * slots
}

fn whole(number: u32) -> Rational {
    rational(number.into(), 1)
}

/// The combination in this row of the list that the divisors give, as slots and pins.
fn listed(row: usize) -> (f64, f64) {
    possible_pairs().get(row).map_or((f64::NAN, f64::NAN), |pair| (pair.0.into(), pair.1.into()))
}

/// All combinations of numbers to 100, by rising number of slots.
fn found_by_trying() -> Vec<(u32, u32)> {
    let pairs = (1..=100).flat_map(|slots| (1..=100).map(move |pins| (slots, pins)));
    pairs.filter(|(slots, pins)| makes_a_quarter(*pins, *slots)).collect()
}

fn tried(row: usize) -> (f64, f64) {
    found_by_trying().get(row).map_or((f64::NAN, f64::NAN), |pair| (pair.0.into(), pair.1.into()))
}
