//! The condition on an escapement and the instant of hand-over: figures 3 and 4, Eqs. (1-1) and (1-2).

use super::*;
use geneva_kinematics::escapement::entry_proofs::{EntryTriangle, HalfAngle};
use geneva_kinematics::pin_slot::{pin_from_pivot, velocity_ratio};

const USUAL: &str = "Chapter I, 1st paragraph";
const CONDITION: &str = "Chapter I, 2nd paragraph";
const INSTANT: &str = "Chapter I, paragraph between Figs. 3 and 4";

pub fn claims() -> Vec<Claim> {
    [conditions(), triangle()].concat()
}

fn conditions() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "meyer.indexing",
            USUAL,
            "a turn of a driver with one pin moves the follower on by one slot of n",
            "1/n",
            Check::equation(
                (LimitCase, || {
                    for_usual(
                        |wheel| agrees(moved_by_a_turn(wheel), 2.0 * PI / f64::from(wheel.stations())),
                        "one slot a turn",
                    )
                }),
                (Vectors, || {
                    for_usual(
                        |wheel| agrees(2.0 * angle_at_exit(wheel), 2.0 * PI / f64::from(wheel.stations())),
                        "from entry to exit the pin's direction turns by one slot",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.intermittent",
            CONDITION,
            "with one pin the follower moves by fits and starts",
            "intermittent",
            Check::equation(
                (ClosedForm, || for_usual(|wheel| wheel.dwell_fraction() > 0.0, "part of the turn is dwell")),
                (Vectors, || {
                    for_usual(
                        |wheel| {
                            let away = Turn::from_radians(PI / 2.0).direction()
                                + Vector2::new(wheel.centre_distance_ratio(), 0.0);
                            away.norm() > exit(wheel).norm()
                        },
                        "a quarter turn from the line of centres the pin is out of reach of the slots",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.always-engaged",
            CONDITION,
            "as an escapement it needs a pin engaged at every instant",
            "at least one pin",
            Check::equation(
                (ClosedForm, || {
                    for_each(
                        |at| {
                            let fewer = Wheel::with_pins(at.slots(), at.pins() - 1);
                            at.wheel().dwell_fraction() == 0.0 && fewer.is_ok_and(|wheel| wheel.dwell_fraction() > 0.0)
                        },
                        "no dwell; with a pin fewer there is one",
                    )
                }),
                (Vectors, || {
                    for_each(
                        |at| (0..=200).all(|k| pins_at_the_rim(at, PI * f64::from(k) / 100.0) > 0),
                        "over a whole turn some pin is within the rim",
                    )
                }),
            ),
        ),
        Claim::figure(
            WORK,
            "meyer.fig-3",
            "Fig. 3, caption",
            "the mechanism drawn has four pins and four slots",
            "four pin, four slot",
            Check::equation(
                (OtherPlaceInSource, || {
                    let (slots, pins) = combinations::TABLE[1];
                    Finding::new((printed(slots), printed(pins)) == (4.0, 4.0), "the table has this combination")
                }),
                (LimitCase, || {
                    Finding::new(Escapement::new(4).is_ok_and(|at| at.pins() == 4), "four slots need four pins")
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.hand-over",
            INSTANT,
            "as one pin leaves its slot the next enters one",
            "must be entering",
            Check::equation(
                (ExactIdentity, || {
                    exactly(
                        |at| at.leaving.out == at.entering.out && at.gap.iter().all(is_zero),
                        "both pins are at the rim, one slot apart",
                    )
                }),
                (Vectors, || {
                    for_each(
                        |at| pins_at_the_rim(at, at.driver_half_angle()) == 2 && pins_at_the_rim(at, 0.0) == 1,
                        "two pins are within the rim then, one on the line of centres",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.along-the-slot",
            INSTANT,
            "for the follower not to be jerked the pin must come and go along the slot's centre line",
            "along the centerline",
            Check::equation(
                (ExactIdentity, || {
                    exactly(
                        |at| {
                            [&at.leaving.across, &at.entering.across]
                                .into_iter()
                                .chain(&at.follower_speeds)
                                .all(is_zero)
                        },
                        "nothing of the velocity is across the slot, and the follower is at rest",
                    )
                }),
                (LimitCase, || {
                    for_each(
                        |at| {
                            let further = 1.2 * at.centre_distance_ratio();
                            velocity_ratio(&further, &Turn::from_radians(at.driver_half_angle())) > 0.01
                        },
                        "with the centres a fifth further apart the follower starts with a jump of its speed",
                    )
                }),
            ),
        ),
    ]
}

fn triangle() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "meyer.phi-0",
            "1st display before Eq. (1-1)",
            "follower's angle at the hand-over: half of that between two slots",
            r"\phi = \phi_0 = \frac{1}{2} \left(\frac{2\pi}{n} \right) = \frac{\pi}{n}",
            Check::equation(
                (ExactIdentity, || all_proven(&[HalfAngle::Halved, HalfAngle::Simplified])),
                (Vectors, || {
                    for_each(
                        |at| agrees(leaving(at).angle(), PI / f64::from(at.slots())),
                        "direction of the leaving pin from the follower's axis",
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.theta-0",
            "2nd display before Eq. (1-1)",
            "driver's angle at the hand-over, its size: half of that between two pins",
            r"\theta = \theta_0 = \frac{1}{2} \left(\frac{2\pi}{m} \right) = \frac{\pi}{m}",
            Check::equation(
                (ExactIdentity, || all_proven(&[HalfAngle::Halved, HalfAngle::Simplified])),
                (Vectors, || {
                    for_each(
                        |at| vanishes(Seen::new(at, PI / f64::from(at.pins())).turning()),
                        "the pin carries the follower no further at π/m",
                    )
                }),
            ),
        ),
        Claim::figure(
            WORK,
            "meyer.right-triangle",
            "Fig. 4 and the text below it",
            "at the hand-over crank and slot are at right angles",
            "large right triangle",
            Check::equation(
                (ExactIdentity, || {
                    exactly(
                        |at| is_zero(&at.layout.pins[0].dot(&(&at.layout.follower_axis - &at.layout.pins[0]))),
                        "the two sides at the pin",
                    )
                }),
                (Vectors, || {
                    for_each(
                        |at| {
                            agrees(
                                leaving(at).place.norm_squared() + 1.0,
                                at.centre_distance_ratio() * at.centre_distance_ratio(),
                            )
                        },
                        "the squares of the two sides make that of the centre distance",
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.pin-circle",
            "3rd display before Eq. (1-1)",
            "radius of the pins' circle",
            r"r = c \sin \phi_0 = c \sin \left(\frac{\pi}{n} \right)",
            Check::equation(
                (ExactIdentity, || prove(&EntryTriangle::PinCircle).into()),
                (Vectors, || {
                    for_each(
                        |at| {
                            let layout = at.layout(at.driver_half_angle());
                            layout.is_ok_and(|layout| {
                                agrees(
                                    layout.slots[0].direction.perp(&layout.follower_axis).abs(),
                                    layout.pins[0].norm(),
                                )
                            })
                        },
                        "the slot's line passes the driver's axis at the radius of the pins",
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.eq-1-1",
            "Eq. (1-1)",
            "centre distance",
            r"c = a r",
            Check::equation(
                (ExactIdentity, || prove(&EntryTriangle::CentreDistance).into()),
                (Vectors, || {
                    for_each(
                        |at| agrees(projected_distance(at), 1.0 / libm::sin(PI / f64::from(at.slots()))),
                        "crank and slot projected on the line of centres",
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.eq-1-2",
            "Eq. (1-2)",
            "centre distance over the radius of the pins' circle",
            r"a = \frac{1}{\sin(\pi/n)}",
            Check::equation(
                (ExactIdentity, || prove(&EntryTriangle::Standstill).into()),
                (Vectors, || {
                    for_usual(
                        |wheel| {
                            vanishes(exit(wheel).dot(&Turn::from_radians(-wheel.engagement_half_angle()).direction()))
                        },
                        "with it slot and crank are at right angles as the pin leaves",
                    )
                }),
            ),
        ),
    ]
}

/// A Geneva wheel with one pin, for each usual number of slots.
fn for_usual(holds: fn(&Wheel) -> bool, how: &str) -> Finding {
    let failing = (3..=18).find(|slots| !Wheel::new(*slots).is_ok_and(|wheel| holds(&wheel)));
    match failing {
        None => Finding::new(true, format!("{how}, for three to eighteen slots")),
        Some(slots) => Finding::new(false, format!("{how}: not for {slots} slots")),
    }
}

/// How far the follower goes on during a turn of the driver, from an instant of an advance to that of the next.
fn moved_by_a_turn(wheel: &Wheel) -> f64 {
    let place =
        |turns| wheel.at(turns, 0.3).map_or(f64::NAN, |at| at.stations as f64 * 2.0 * wheel.half_station() + at.angle);
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

/// How many pins are no further from the follower's axis than a pin that leaves, with the first at this angle.
fn pins_at_the_rim(escapement: &Escapement, crank: f64) -> usize {
    let rim = leaving(escapement).radius() * (1.0 + crate::tolerance::CLOSURE.relative);
    let pitch = 2.0 * PI / f64::from(escapement.pins());
    (0..escapement.pins()).filter(|k| Seen::new(escapement, crank + pitch * f64::from(*k)).radius() <= rim).count()
}

/// The pin that leaves.
pub fn leaving(escapement: &Escapement) -> Seen {
    Seen::new(escapement, escapement.driver_half_angle())
}

/// Centre distance over the radius of the pins' circle, from the angles π/m of the crank and π/n of the slot alone.
fn projected_distance(escapement: &Escapement) -> f64 {
    let [crank, slot] = [escapement.pins(), escapement.slots()].map(|count| Turn::from_radians(PI / f64::from(count)));
    crank.cos + crank.sin * slot.cos / slot.sin
}
