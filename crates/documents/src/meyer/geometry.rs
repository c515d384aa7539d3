//! The condition on an escapement and the instant of hand-over: figures 3 and 4, Eqs. (1-1) and (1-2).

use super::hand_over::Drawn;
use super::hand_over_letters::{HALVES, RATIO, RIGHT_TRIANGLE};
use super::*;
use geneva_evidence::agreement::joined_numbers;
use geneva_kinematics::escapement::{ContinuousEscapement, HandOverMotion};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_slot::{PinSlot, pin_from_pivot};

const USUAL: Locator = at("Chapter I, 1st paragraph");
const CONDITION: Locator = at("Chapter I, 2nd paragraph");
pub(super) const INSTANT: Locator = at("Chapter I, paragraph between Figs. 3 and 4");

pub(super) fn claims() -> Vec<Claim> {
    [conditions(), triangle()].concat()
}

fn conditions() -> Vec<Claim> {
    vec![
        USUAL
            .statement(
                "meyer.indexing",
                "1/n",
                "one turn of a driver with one pin moves the follower on by one slot of n",
            )
            .first_route(Evidence::LIMIT_CASE, |stated| {
                moved_on(stated, moved_by_a_turn, "a turn of the driver moves the follower on by that many slots")
            })
            .second_route(Evidence::VECTORS, |stated| {
                moved_on(
                    stated,
                    |wheel| 2.0 * angle_at_exit(wheel),
                    "from entry to exit the pin's direction turns by this angle",
                )
            })
            .but_not("two slots of n"),
        CONDITION
            .statement("meyer.intermittent", "intermittent", "with one pin, the follower moves intermittently")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let dwells = stated.pick(single(), complete()).into_iter().map(|(pins, slots)| dwell(pins, slots));
                every(dwells, |dwell| dwell > 0.0, "the parts of the driver's turn in which the follower dwells are")
            })
            .second_route(Evidence::VECTORS, |stated| {
                let fewest = stated.pick(single(), complete()).into_iter().map(|pair| fewest_engaged(pair) as f64);
                every(
                    fewest,
                    |pins| pins == 0.0,
                    "over a turn of the driver, the minimum numbers of pins within the rim are",
                )
            })
            .but_not("it does so with the pins of the escapement too"),
        CONDITION
            .statement(
                "meyer.always-engaged",
                "at least one pin",
                "as an escapement, the mechanism needs a pin engaged at every instant",
            )
            .missing(
                "The sentence can be read as a requirement for every such escapement, or as a choice made for this \
                 design, and the thesis does not say which. When no pin is engaged, the follower rests, and the text \
                 calls such intermittent motion undesirable, not impossible. If the sentence states a choice, there is \
                 nothing to test. If it states a requirement, it is false. Even with some pins taken away, and with \
                 the follower held between engagements, each of the three mechanisms comes to a steady speed at each \
                 friction value of the runs",
            ),
        at("Fig. 3, caption")
            .figure("meyer.fig-3", "four pin, four slot", "the mechanism that is drawn has four pins and four slots")
            .missing(
                "The copy we had does not contain the drawing. Four pins do fit four slots, but other pairs of numbers \
                 fit, too, and we cannot tell which pair is drawn",
            ),
        INSTANT
            .statement("meyer.hand-over", "must be entering", "as one pin leaves its slot, the next pin enters a slot")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let angles = neighbours(stated).into_iter().map(|(pins, slots)| {
                    let ratio = 1.0 / libm::sin(PI / f64::from(slots));
                    let engaged = PinSlot::new(1.0, ratio).map_or(f64::NAN, |at| 2.0 * at.engagement_half_angle());
                    engaged * f64::from(pins) / (2.0 * PI)
                });
                every(
                    angles,
                    |pitches| agrees(pitches, 1.0),
                    "the ratios of the driver's turn in an engagement to its turn from pin to pin are",
                )
            })
            .second_route(Evidence::VECTORS, |stated| {
                let ahead = neighbours(stated).into_iter().map(|(pins, slots)| {
                    // The leaving pin is where its circle touches the slot's centre line.
                    let drawn = Drawn { pins, slots, axis: 1.0 / libm::sin(PI / f64::from(slots)) };
                    let leaving = libm::atan2(drawn.tangent(), 1.0);
                    let next = drawn.place(leaving - 2.0 * drawn.half());
                    next.norm() - drawn.tangent()
                });
                every(
                    ahead,
                    vanishes,
                    "as one pin leaves, the distances of the next pin from the rim, positive outside, are",
                )
            })
            .but_not("with one pin more or fewer, the next pin enters at that instant too"),
        hand_over::along_the_slot(),
        at("Fig. 4").lost_drawing("meyer.fig-4", "Figure 4", "the mechanism as one pin leaves and the next enters"),
    ]
}

fn triangle() -> Vec<Claim> {
    vec![
        at("1st display before Eq. (1-1)")
            .equation(
                "meyer.phi-0",
                r"\phi = \phi_0 = \frac{1}{2} \left(\frac{2\pi}{n} \right) = \frac{\pi}{n}",
                "follower's angle at the hand-over, which is half the angle between two slots",
            )
            .in_letters(HALVES),
        at("2nd display before Eq. (1-1)")
            .equation(
                "meyer.theta-0",
                r"\theta = \theta_0 = \frac{1}{2} \left(\frac{2\pi}{m} \right) = \frac{\pi}{m}",
                "size of the driver's angle at the hand-over, which is half the angle between two pins",
            )
            .in_letters(HALVES),
        at("Fig. 4 and the text below it")
            .figure(
                "meyer.right-triangle",
                "large right triangle",
                "at the hand-over, crank and slot are at right angles",
            )
            .first_route(Evidence::EXACT_IDENTITY, |stated| {
                let found = exactly(
                    |at| is_zero(&sides(at)[0].dot(&sides(at)[1])),
                    "the scalar product of crank and slot is zero",
                );
                and_with_a_slot_more(found, stated)
            })
            .second_route(Evidence::VECTORS, |stated| {
                // The driver's axis, the pin and the follower's axis; which side is opposite the right angle.
                let misfits = Mechanism::ALL.into_iter().map(|at| {
                    let drawn = Drawn::new(at.pins(), at.slots() + stated.pick(0, 1));
                    1.0 + drawn.place(drawn.half()).norm_squared() - drawn.axis * drawn.axis
                });
                every(misfits, vanishes, "the squares of two sides minus the square of the third are")
            })
            .but_not("they are at right angles too if the follower has one more slot"),
        at("3rd display before Eq. (1-1)")
            .equation(
                "meyer.pin-circle",
                r"r = c \sin \phi_0 = c \sin \left(\frac{\pi}{n} \right)",
                "radius of the pins' circle",
            )
            .in_letters(RIGHT_TRIANGLE),
        at("Eq. (1-1)").equation("meyer.eq-1-1", r"c = a r", "centre distance").in_letters(RIGHT_TRIANGLE),
        at("Eq. (1-2)")
            .equation(
                "meyer.eq-1-2",
                r"a = \frac{1}{\sin(\pi/n)}",
                "centre distance over the radius of the pins' circle",
            )
            .in_letters(RATIO),
    ]
}

/// The sides of the triangle at the hand-over: from the driver's axis to the pin, from there to the follower's axis,
/// and back to the driver's.
fn sides(at: &HandOver) -> [Vector2<Roots>; 3] {
    let (pin, axis) = (&at.layout.pins[0], &at.layout.follower_axis);
    [pin.clone(), axis - pin, -axis.clone()]
}

/// The finding for the three escapements, and for a neighbour also for the escapements with a slot more.
///
/// With a slot more one pin still takes over from the next. By the sum of the two angles, exactly, we ask whether the
/// follower is at rest then, and therefore crank and slot are at right angles.
pub(super) fn and_with_a_slot_more(found: Finding, stated: Stated) -> Finding {
    let rests = |at: &Mechanism| {
        let more = ContinuousEscapement::new(at.pins(), at.slots() + 1);
        more.is_some_and(|pair| pair.hand_over_motion() == HandOverMotion::Rests)
    };
    let all = stated.pick(true, Mechanism::ALL.iter().all(rests));
    let but = if all { "" } else { "; with one more slot, the follower is not at rest then" };
    Finding::new(found.holds && all, format!("{}{but}", found.how))
}

/// A driver with one pin, for each usual number of slots: pins and slots.
fn single() -> Vec<(u32, u32)> {
    (3..=18).map(|slots| (1, slots)).collect()
}

/// The three escapements.
fn complete() -> Vec<(u32, u32)> {
    Mechanism::ALL.iter().map(|at| (at.pins(), at.slots())).collect()
}

/// The three escapements, or those with a pin more and with a pin fewer at the same distance of the axes.
fn neighbours(stated: Stated) -> Vec<(u32, u32)> {
    let with = |more: u32, fewer: u32| Mechanism::ALL.into_iter().map(move |at| (at.pins() + more - fewer, at.slots()));
    stated.pick(with(0, 0).collect(), with(1, 0).chain(with(0, 1)).collect())
}

/// The part of the driver's turn in which no pin is in a slot.
fn dwell(pins: u32, slots: u32) -> f64 {
    Wheel::with_pins(slots, pins).map_or(f64::NAN, |wheel| wheel.dwell_fraction())
}

/// The fewest pins inside the rim over a turn of the driver, at the centre distance of Eq. (1-2).
fn fewest_engaged((pins, slots): (u32, u32)) -> usize {
    let drawn = Drawn { pins, slots, axis: 1.0 / libm::sin(PI / f64::from(slots)) };
    drawn.fewest_within(drawn.tangent())
}

/// Whether a property holds for all of these numbers, of which there must be some; the finding lists them.
pub(super) fn every(numbers: impl Iterator<Item = f64>, holds: impl Fn(f64) -> bool, what: &str) -> Finding {
    let numbers: Vec<f64> = numbers.collect();
    let all = !numbers.is_empty() && numbers.iter().all(|number| holds(*number));
    Finding::new(
        all,
        match numbers[..] {
            [first, _, ..] if numbers.iter().all(|number| (number - first).abs() < 5e-4) => {
                format!("{what} all {}", joined_numbers(&[first]))
            }
            _ => format!("{what} {}", joined_numbers(&numbers)),
        },
    )
}

/// Whether the follower goes on by a slot or, wrongly stated, by two, for each usual number of slots.
fn moved_on(stated: Stated, turned: fn(&Wheel) -> f64, what: &str) -> Finding {
    let failing = (3..=18).find(|slots| {
        let wanted = stated.pick(stated.number(), 2.0) * 2.0 * PI / f64::from(*slots);
        !Wheel::new(*slots).is_ok_and(|wheel| agrees(turned(&wheel), wanted))
    });
    let but = failing.map_or(String::new(), |slots| format!(", but this fails with {slots} slots"));
    Finding::new(failing.is_none(), format!("{what}, for three to eighteen slots{but}"))
}

/// How far the follower goes on during a turn of the driver, from an instant of an advance to that of the next.
fn moved_by_a_turn(wheel: &Wheel) -> f64 {
    let place = |turns| {
        wheel.motion(turns, 0.3).map_or(f64::NAN, |at| at.stations as f64 * 2.0 * wheel.half_pitch_angle() + at.angle)
    };
    place(1) - place(0)
}

/// The pin as it leaves, from the follower's axis.
fn exit(wheel: &Wheel) -> Vector2<f64> {
    pin_from_pivot(&wheel.centre_distance_ratio(), &Turn::from_radians(wheel.engagement_half_angle()))
}

fn angle_at_exit(wheel: &Wheel) -> f64 {
    let place = exit(wheel);
    libm::atan2(place.y, place.x)
}
