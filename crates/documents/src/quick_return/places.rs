//! Where the vectors of the solution lead: to the pin, to the frame's origin, and from one to the other.

use super::letters::FRAME;
use super::*;
use geneva_evidence::tex::{Moment, holds, value};

const PLACES: Locator = at("Solution, position, vectors");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        PLACES
            .statement(
                "quick-return.point-located",
                "locates P2",
                "the vector r leads to the pin, and its length, with the same letter, is the length of the lever",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // At other lever angles: the end of r keeps its distance from the crank's axis, that of a point of
                // the lever its distance from the lever's pivot.
                let (axis, pivot) =
                    (Vector2::new(QUICK_RETURN.printed_number("quick-return.ground"), 0.0), Vector2::zeros());
                let (now, crank) = (projected_length(lever_angle()), QUICK_RETURN.printed_number("quick-return.crank"));
                let (centre, distance) = stated.pick((axis, crank), (pivot, now));
                let distances = OTHER_ANGLES.map(|angle| (end_of(projected_length(angle), angle) - centre).norm());
                let [least, most] = [f64::min, f64::max].map(|pick| distances.into_iter().reduce(pick));
                Finding::new(
                    distances.iter().all(|found| agrees(*found, distance)),
                    format!(
                        "while the lever swings, the end of r is {:.3} to {:.3} m from the centre of the named point's \
                         circle",
                        least.unwrap_or(f64::NAN),
                        most.unwrap_or(f64::NAN)
                    ),
                )
            })
            .second_route(Evidence::JET, |stated| {
                at_the_instant(|instant| {
                    let rates = instant.by_series()?;
                    let across = quarter_turn(&rates.position) * rates.angular_velocity;
                    let rate = rates.position * rates.sliding + across;
                    Some(alike(&rate, &stated.pick(quarter_turn(&instant.arm()) * instant.drive.speed, across)))
                })
            })
            .but_not("it leads to P4, a point of the lever"),
        PLACES
            .statement(
                "quick-return.frame",
                "oxy (same as P4)",
                "the frame's origin, to which R leads, is the lever's point under the pin",
            )
            .first_route(Evidence::VECTORS, |stated| {
                at_the_instant(|instant| {
                    let velocities = instant.by_diagrams()?.velocities;
                    let origin = stated.pick(velocities.slot_point_velocity, velocities.pin_velocity).norm();
                    let holds = QUICK_RETURN.prints_rounding_of("quick-return.lever-point-speed", origin);
                    Some(Finding::new(holds, format!("the origin then moves at {origin:.3} m/s")))
                })
            })
            .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
                from_duals(|crank| {
                    let [_, rate, _] = path(|t| {
                        let [x, y] = crank.pin(t);
                        let [a, b] = stated.pick(crank.point_under_the_pin(t), crank.pin(t));
                        [x - a, y - b]
                    });
                    Finding::new(
                        QUICK_RETURN.prints_rounding_of("quick-return.sliding-speed", rate.norm()),
                        format!("the pin then leaves the origin at {:.3} m/s", rate.norm()),
                    )
                })
            })
            .but_not("it is the same as P2, and moves with the pin"),
        PLACES
            .equation(
                "quick-return.p-is-zero",
                "p = 0",
                "the pin is at the frame's origin at this instant, but it does not stay there",
            )
            .evaluated(Evidence::VECTORS, |tex| {
                at_the_instant(|instant| {
                    let length = projected_length(lever_angle());
                    let axis = Vector2::new(instant.linkage.ground(), 0.0);
                    let [now, later] = [0.0, 1.0].map(|degrees| {
                        let crank = instant.position.crank.plus(&Turn::from_degrees(degrees));
                        let position = instant.linkage.position_at_crank(&crank).ok()?;
                        Some((axis + crank.direction() * axis_to_pin() - position.lever.direction() * length).norm())
                    });
                    let (now, later) = (now? / axis_to_pin(), later? / axis_to_pin());
                    Some(match holds(tex, &[Moment::default().with([("p", now)])]) {
                        None => Finding::of_reading(None),
                        Some(holds) => Finding::new(
                            holds && !vanishes(later),
                            format!(
                                "p is {now:.3} of the crank's radius, and {later:.3} of it when the crank has turned \
                                 by another 1°"
                            ),
                        ),
                    })
                })
            })
            .read(Evidence::OTHER_PLACE_IN_SOURCE, |tex| {
                // By printed numbers alone: within what the digits of the lever's length leave open.
                let p = (printed_pin()
                    - end_of(QUICK_RETURN.printed_number("quick-return.lever-length"), lever_angle()))
                .norm();
                let [least, most] = QUICK_RETURN.printed_interval("quick-return.lever-length");
                let (left, right) = tex.split_once('=')?;
                let apart = value(&format!("{left} - ({right})"), Moment::default().with([("p", p)]).letters());
                (!apart.is_nan()).then_some(apart.abs() < (most - least) / 2.0)
            }),
        PLACES
            .equation(
                "quick-return.sum-of-places",
                "r = R + p",
                "place of the pin, as the place of the frame's origin plus the pin's place in the frame",
            )
            .in_letters(FRAME)
            .with_second_witness(Evidence::JET, sum_of_rates),
        PLACES
            .equation(
                "quick-return.sum-of-places-by-points",
                r"r_{P2} = r_{P4} + r_{P2/P4}",
                "place of the pin, in the names of the points",
            )
            .in_letters(FRAME)
            .with_second_witness(Evidence::CLOSED_FORM, sum_while_the_lever_swings),
    ]
}

/// Lever angles in degrees, all within the swing, at which a statement about the motion is tried.
const OTHER_ANGLES: [f64; 5] = [-20.0, -5.0, 5.0, 15.0, 25.0];

/// The printed lever angle, in degrees.
fn lever_angle() -> f64 {
    QUICK_RETURN.printed_number("quick-return.lever-angle")
}

/// The printed crank radius.
fn axis_to_pin() -> f64 {
    QUICK_RETURN.printed_number("quick-return.crank")
}

/// The end of a vector from the lever's pivot, by its length and its angle in degrees.
fn end_of(length: f64, degrees: f64) -> Vector2<f64> {
    Turn::from_degrees(degrees).direction() * length
}

/// Where the pin is by the printed ground distance, crank radius and crank angle.
fn printed_pin() -> Vector2<f64> {
    Vector2::new(QUICK_RETURN.printed_number("quick-return.ground"), 0.0)
        + end_of(axis_to_pin(), QUICK_RETURN.printed_number("quick-return.crank-angle"))
}

/// The sum at other lever angles, where p is not zero: r from the crank's angle, R fixed on the lever, p along it.
fn sum_while_the_lever_swings() -> Finding {
    let origin = projected_length(lever_angle());
    let sums = OTHER_ANGLES.map(|angle| {
        let crank = angle + angle_at_pin(angle);
        let r = Vector2::new(QUICK_RETURN.printed_number("quick-return.ground"), 0.0) + end_of(axis_to_pin(), crank);
        let p = projected_length(angle) - origin;
        (coincide(&r, &(end_of(origin, angle) + end_of(p, angle))), p)
    });
    let [least, most] = [f64::min, f64::max].map(|pick| sums.into_iter().map(|(_, p)| p).reduce(pick));
    Finding::new(
        sums.into_iter().all(|(holds, _)| holds),
        format!(
            "we computed both at five lever angles, with p from {:.3} to {:.3} m along the lever",
            least.unwrap_or(f64::NAN),
            most.unwrap_or(f64::NAN)
        ),
    )
}

/// The rates of the sum at the instant, to the second: those of R on the lever and of p along it against the pin's.
fn sum_of_rates() -> Finding {
    at_the_instant(|instant| {
        let (rates, arm, speed) = (instant.by_series()?, instant.arm(), instant.drive.speed);
        let (along, across, turning) = (rates.position, quarter_turn(&rates.position), rates.angular_velocity);
        let origin = [across * turning, across * rates.angular_acceleration - along * (turning * turning)];
        let inside = [along * rates.sliding, along * rates.sliding_rate + across * (2.0 * turning * rates.sliding)];
        let pin = [quarter_turn(&arm) * speed, -arm * (speed * speed)];
        let place = Vector2::new(instant.linkage.ground(), 0.0) + arm;
        let holds =
            coincide(&place, &along) && (0..2).all(|order| coincide(&pin[order], &(origin[order] + inside[order])));
        Some(Finding::new(holds, "the place, velocity and acceleration of the pin are the sums for R and p"))
    })
}
