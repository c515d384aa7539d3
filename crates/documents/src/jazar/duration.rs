//! The angle α of Fig. 5.31, and how long an advance takes.

use super::letters::{ENTRY_AND_EXIT, PARTS};
use super::*;
use geneva_evidence::equal_to;
use geneva_kinematics::indexing::Indexing;
use std::cmp::Ordering;

const GEOMETRY: Locator = at("Paragraph on Fig. 5.31");
const DURATION: Locator = at("2nd paragraph on Fig. 5.31");

pub(super) fn claims() -> Vec<Claim> {
    [angle(), vec![duration()], comparisons()].concat()
}

fn angle() -> Vec<Claim> {
    vec![
        GEOMETRY
            .statement(
                "jazar.alpha",
                "moment of engagement",
                "α is the angle between slot and line of centres as the pin enters or leaves",
            )
            .first_route(Evidence::VECTORS, |stated| {
                for_all_stations(
                    |wheel| {
                        let end = wheel.engagement_half_angle() * stated.pick(1.0, 0.5);
                        [-end, end].iter().all(|t| agrees(by_series(wheel, *t)[0].abs(), wheel.half_pitch_angle()))
                    },
                    "the slot is then half a pitch from the line of centres",
                )
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                for_all_stations(
                    |wheel| {
                        // Half a pitch is what the wheel has to turn until the slot is on the line of centres.
                        let (ratio, pitch) = (wheel.centre_distance_ratio(), 2.0 * PI / f64::from(wheel.stations()));
                        let end = libm::acos(1.0 / ratio) * stated.pick(1.0, 0.5);
                        [-end, end].iter().all(|t| agrees(by_cosines(ratio, *t).1.abs(), pitch / 2.0))
                    },
                    "the law of cosines gives this angle where the crank is tangent to the slot",
                )
            })
            .but_not("it is that angle when the pin has gone half of the way from there to the line of centres"),
        curves::caption(),
        at("Fig. 5.31, caption").lost_drawing(
            "jazar.fig-5.31-drawing",
            "Figure 5.31",
            "the drawing of the geometry of N stations",
        ),
        at("Fig. 5.31, caption")
            .figure("jazar.fig-5.31", "half the angle", "neighbouring slots are 2α apart")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                for_all_stations(
                    |wheel| {
                        let alpha = libm::asin(1.0 / wheel.centre_distance_ratio());
                        agrees(stated.pick(1.0 / stated.number(), 1.0) * alpha * f64::from(wheel.stations()), 2.0 * PI)
                    },
                    "all slots together make one turn if the sine of α is the crank over the centre distance",
                )
            })
            .second_route(Evidence::VECTORS, |stated| {
                for_all_stations(
                    |wheel| {
                        // From slot to slot, as often as there are slots: the first one again.
                        let step =
                            Turn::from_radians(stated.pick(1.0 / stated.number(), 1.0) * entry_angle(wheel).abs());
                        let first = Turn::from_radians(0.0);
                        let last = (0..wheel.stations()).fold(first, |slot, _| slot.plus(&step));
                        vanishes((last.direction() - first.direction()).norm())
                    },
                    "this number of steps from slot to slot leads back to the first slot",
                )
            })
            .but_not("α is the whole angle between neighbouring slots"),
        DURATION
            .equation("jazar.alpha-degrees", r"360^{\circ}/(2N)", "α in degrees")
            .rewritten_and_proven(PARTS, equal_to(r"\alpha")),
    ]
}

fn duration() -> Claim {
    DURATION
        .equation("jazar.duration", r"\pi - 2\alpha", "crank angle of an advance")
        .rewritten_and_proven(ENTRY_AND_EXIT, equal_to(r"\theta_{\text{exit}} - \theta_{\text{entry}}"))
}

fn comparisons() -> Vec<Claim> {
    vec![
        DURATION
            .statement(
                "jazar.duration-grows",
                "increases",
                "with more stations the advance takes more of the driver's turn",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                compare_neighbours(&[Wheel::motion_fraction], stated.pick(Ordering::Less, Ordering::Greater))
            })
            .second_route(Evidence::JET, |stated| {
                compare_neighbours(&[entry_crank], stated.pick(Ordering::Less, Ordering::Greater))
            })
            .but_not("the advance takes less of the driver's turn"),
        DURATION
            .value(
                "jazar.duration-limit",
                "180",
                "°",
                "crank angle that an advance takes, in the limit of very many stations",
            )
            .first_route(Evidence::LIMIT_CASE, || {
                limit(|n| of(n, |wheel| 2.0 * wheel.engagement_half_angle()).to_degrees())
            })
            .second_route(
                Evidence::JET, // From where the wheel of the power series is at rest.
                || limit(|n| of(n, entry_crank)).to_degrees(),
            ),
        DURATION
            .statement("jazar.gentler", "more gentle", "with more stations the peaks of velocity and acceleration fall")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                compare_neighbours(
                    &[Wheel::peak_velocity, Wheel::entry_acceleration, |wheel| wheel.acceleration_peak().ratio],
                    stated.pick(Ordering::Greater, Ordering::Less),
                )
            })
            .second_route(Evidence::JET, |stated| {
                compare_neighbours(
                    &[
                        |wheel| by_series(wheel, 0.0)[1],
                        |wheel| by_series(wheel, -wheel.engagement_half_angle())[2],
                        |wheel| peak_by_series(wheel).1,
                    ],
                    stated.pick(Ordering::Greater, Ordering::Less),
                )
            })
            .but_not("they rise")
            .interpreted_as(
                "“More gentle” means here that, at the same speed of the driver, the wheel's peak velocity, its peak \
                 acceleration and the jump of its acceleration at entry all fall. The handout normalises its own \
                 curves by this speed. If the move took the same time instead, the jump at entry would rise from three \
                 to five stations and then fall.",
            ),
        DURATION
            .statement(
                "jazar.dwell-shrinks",
                "decreasing",
                "with more stations the wheel stands still for less of the turn",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                compare_neighbours(&[Wheel::dwell_fraction], stated.pick(Ordering::Greater, Ordering::Less))
            })
            .second_route(Evidence::JET, |stated| {
                compare_neighbours(
                    &[|wheel| 2.0 * PI - entry_crank(wheel)],
                    stated.pick(Ordering::Greater, Ordering::Less),
                )
            })
            .but_not("the wheel stands still for more of the turn"),
    ]
}

/// Wheel angle as the pin enters.
pub(super) fn entry_angle(wheel: &Wheel) -> f64 {
    by_series(wheel, -wheel.engagement_half_angle())[0]
}

/// Whether quantities of each wheel compare so with those of the wheel with a station more.
fn compare_neighbours(quantities: &[fn(&Wheel) -> f64], ordering: Ordering) -> Finding {
    let compares = |pair: &&[Wheel]| {
        quantities.iter().all(|quantity| quantity(&pair[0]).partial_cmp(&quantity(&pair[1])) == Some(ordering))
    };
    let failing = wheels().windows(2).find(|pair| !compares(pair));
    let how = match (failing, ordering) {
        (Some(pair), _) => format!("this fails from {} stations to the next number", pair[0].stations()),
        (None, Ordering::Less) => format!("it rises with each additional station, for {}", numbers_of_stations()),
        (None, _) => format!("it falls with each additional station, for {}", numbers_of_stations()),
    };
    Finding::new(failing.is_none(), how)
}

/// Limit for N to infinity of a quantity that goes with 1/N: twice the value at 2 N less that at N.
fn limit(quantity: fn(u32) -> f64) -> f64 {
    2.0 * quantity(1000) - quantity(500)
}
