//! Which numbers of pins and slots an escapement can have: Eq. (1-3), its table and the remarks on it.

use super::*;
use geneva_kinematics::escapement::entry_proofs::{EntryTriangle, PinsAndSlots};
use geneva_kinematics::escapement::{ApproachCoefficient, pins_needed, possible};
use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::{Rational, rational};

const TABLE_AT: &str = "Table after Eq. (1-3)";
const REMARK: &str = "Paragraph after the table of Eq. (1-3)";

/// The columns of the table of possible combinations: ids of the numbers of slots and of pins.
pub const TABLE: [(&str, &str); 3] = [
    ("meyer.table.three-slots", "meyer.table.six-pins"),
    ("meyer.table.four-slots", "meyer.table.four-pins"),
    ("meyer.table.six-slots", "meyer.table.three-pins"),
];

pub fn claims() -> Vec<Claim> {
    [angle_sum(), combinations(), remarks()].concat()
}

fn angle_sum() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "meyer.half-turn",
            "Eq. (1-3), 1st line",
            "sum of the angles in the large triangle",
            r"\theta_o + \phi_o + \frac{\pi}{2} = \pi",
            Check::equation(
                (ExactIdentity, || prove(&EntryTriangle::HalfTurn).into()),
                (Vectors, || {
                    for_each(|at| agrees(angles_of_the_triangle(at).iter().sum(), PI), "the three angles measured")
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.quarter-turn",
            "Eq. (1-3), 2nd line",
            "the two acute angles",
            r"\theta_o + \phi_o = \frac{\pi}{2}",
            Check::equation(
                (ExactIdentity, || prove(&EntryTriangle::QuarterTurn).into()),
                (Vectors, || {
                    for_each(
                        |at| {
                            let [driver, follower, _] = angles_of_the_triangle(at);
                            agrees(driver + follower, PI / 2.0)
                        },
                        "the two angles measured",
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.angle-sum",
            "Eq. (1-3), 3rd line",
            "the same by the numbers of pins and slots",
            r"\frac{\pi}{m} + \frac{\pi}{n} = \frac{\pi}{2}",
            Check::equation(
                (ExactIdentity, || prove(&PinsAndSlots::AngleSum).into()),
                (Vectors, || {
                    for_each(
                        |at| {
                            let [driver, follower, right] = angles_of_the_triangle(at);
                            agrees(driver, PI / f64::from(at.pins()))
                                && agrees(follower, PI / f64::from(at.slots()))
                                && agrees(right, PI / 2.0)
                        },
                        "the angles measured are π/m, π/n and π/2",
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.eq-1-3",
            "Eq. (1-3), 4th line",
            "number of pins",
            r"m = \frac{2n}{n-2}",
            Check::equation(
                (ExactIdentity, || prove(&PinsAndSlots::Pins).into()),
                (LimitCase, || {
                    let holds = (3..=100).all(|n| {
                        (1..=100).all(|m| makes_a_quarter(m, n) == pins_needed(n).is_some_and(|pins| pins == whole(m)))
                    });
                    Finding::new(holds, "of all numbers to 100 the same satisfy both lines")
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.continuous",
            "Paragraph after Eq. (1-3)",
            "the two conditions make the motion continuous",
            "continuous motion",
            Check::equation(
                (ExactIdentity, || {
                    exactly(
                        |at| at.gap.iter().chain(&at.follower_speeds).all(is_zero),
                        "angle and velocity of the follower are the same by either pin",
                    )
                }),
                (LimitCase, || {
                    let holds = (3..=18).all(|n| (2..=18).all(|m| comes_to_rest(m, n) == makes_a_quarter(m, n)));
                    Finding::new(holds, "of all numbers to 18 no others bring the follower to rest at π/m")
                }),
            ),
        ),
    ]
}

fn combinations() -> Vec<Claim> {
    let value = |id, meaning, printed, computed: fn() -> f64, witness: fn() -> f64| {
        Claim::value(
            WORK,
            id,
            TABLE_AT,
            meaning,
            (printed, ""),
            Check::number((ClosedForm, computed), (LimitCase, witness)),
        )
    };
    let [first, second, third] = TABLE;
    vec![
        Claim::statement(
            WORK,
            "meyer.only-three",
            "Sentence before the table of Eq. (1-3)",
            "three combinations of whole numbers, and no more",
            "only three",
            Check::equation(
                (ExactIdentity, || {
                    let Finding { holds, how } = prove(&PinsAndSlots::Factors).into();
                    Finding::new(
                        holds && possible().len() == 3,
                        format!("(m − 2)(n − 2) = 4, which has three pairs of divisors; {how}"),
                    )
                }),
                (LimitCase, || Finding::new(found_by_trying().len() == 3, "all numbers to 100 tried")),
            ),
        ),
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
        Claim::statement(
            WORK,
            "meyer.fewer-pins",
            REMARK,
            "the more slots, the fewer pins",
            "m decreases",
            Check::equation(
                (ExactIdentity, || prove(&PinsAndSlots::NeverTwo).into()),
                (LimitCase, || {
                    Finding::new((3..1000).all(|n| pins_needed(n) > pins_needed(n + 1)), "from 3 to 1000 slots")
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.two-pins",
            REMARK,
            "after three pins come two, for slots without end",
            "2",
            Check::equation(
                (ExactIdentity, || {
                    let Finding { holds, how } = prove(&PinsAndSlots::NeverTwo).into();
                    Finding::new(holds, format!("m − 2 = 4/(n − 2): above zero, and below any bound in the end; {how}"))
                }),
                (LimitCase, || {
                    let between = |n| pins_needed(n).is_some_and(|pins| pins > whole(2) && pins < whole(3));
                    Finding::new((7..=10_000).all(between), "between 2 and 3 from 7 to 10 000 slots")
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.tangent",
            REMARK,
            "as it enters and leaves, the pin's path runs along the slot's centre line",
            "coincident with the centerline",
            Check::equation(
                (ExactIdentity, || {
                    exactly(
                        |at| [&at.leaving, &at.entering].iter().all(|pin| is_zero(&pin.beside) && is_zero(&pin.across)),
                        "place and velocity of both pins are on the centre line",
                    )
                }),
                (Series, || all_proven(&[ApproachCoefficient::BesideConstant, ApproachCoefficient::BesideLinear])),
            ),
        ),
    ]
}

/// The angles at the driver's axis, the follower's axis and the pin that leaves, between the sides.
fn angles_of_the_triangle(escapement: &Escapement) -> [f64; 3] {
    let (follower, driver) = (Vector2::zeros(), Vector2::new(escapement.centre_distance_ratio(), 0.0));
    let pin = geometry::leaving(escapement).place;
    let between = |a: Vector2<f64>, b: Vector2<f64>| libm::atan2(a.perp(&b).abs(), a.dot(&b));
    [
        between(follower - driver, pin - driver),
        between(driver - follower, pin - follower),
        between(driver - pin, follower - pin),
    ]
}

/// Whether π/m and π/n make a quarter turn.
fn makes_a_quarter(pins: u32, slots: u32) -> bool {
    2 * (pins + slots) == pins * slots
}

/// Whether the follower is at rest at π/m, with the centres at the distance of Eqs. (1-1) and (1-2).
fn comes_to_rest(pins: u32, slots: u32) -> bool {
    let ratio = 1.0 / libm::sin(PI / f64::from(slots));
    vanishes(velocity_ratio(&ratio, &Turn::from_radians(PI / f64::from(pins))))
}

fn whole(number: u32) -> Rational {
    rational(number.into(), 1)
}

/// The combination in this row of the list that the divisors give, as slots and pins.
fn listed(row: usize) -> (f64, f64) {
    possible().get(row).map_or((f64::NAN, f64::NAN), |pair| (pair.0.into(), pair.1.into()))
}

/// All combinations of numbers to 100, by rising number of slots.
fn found_by_trying() -> Vec<(u32, u32)> {
    let pairs = (1..=100).flat_map(|slots| (1..=100).map(move |pins| (slots, pins)));
    pairs.filter(|(slots, pins)| makes_a_quarter(*pins, *slots)).collect()
}

fn tried(row: usize) -> (f64, f64) {
    found_by_trying().get(row).map_or((f64::NAN, f64::NAN), |pair| (pair.0.into(), pair.1.into()))
}
