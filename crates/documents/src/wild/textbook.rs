//! A public page that continues the textbook problem of this book's first chapter and asks for the wheel's
//! acceleration.
//!
//! It repeats what it needs of the first problem, whose copy has lost its arrows. Its stored text ends before the
//! result.

use super::*;
use crate::PIN;
use crate::pin::continuation::{SLIDING_ARROW, WHEEL_ARROW};
use crate::pin::{Arrow, PinProblem, Placement, heading, turns};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_triangle::TriangleSolution;
use geneva_kinematics::pin_vectors::PinMotion;
use nalgebra::Vector2;

pub(super) fn claims() -> Vec<Claim> {
    vec![
        value(
            "wild.holooly.speed",
            "4.08",
            "rad/s",
            "angular speed of the wheel",
            |t| t.follower_speed,
            |motion| motion.follower_speed.abs(),
        ),
        HOLOOLY
            .statement("wild.holooly.sense", WHEEL_ARROW, "sense in which the wheel turns")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // Positive against the driver, which turns counterclockwise.
                turns(-by_triangle(|t| t.follower_speed) * stated.pick(1.0, -1.0), stated)
            })
            .second_route(Evidence::VECTORS, |stated| turns(by_vectors(|motion| motion.follower_speed) * stated.pick(1.0, -1.0), stated))
            .but_not("the wheel turns counterclockwise"),
        value(
            "wild.holooly.angle",
            "42.4",
            "°",
            "angle of the slot from the line of centres",
            |t| t.angle_at_pivot.to_degrees(),
            |motion| libm::atan2(motion.position.y.abs(), motion.position.x.abs()).to_degrees(),
        ),
        value(
            "wild.holooly.sliding",
            "477",
            "mm/s",
            "speed of the pin along the slot",
            |t| t.sliding_speed,
            |motion| motion.sliding_velocity.norm(),
        ),
        HOLOOLY
            .statement(
                "wild.holooly.sliding-direction",
                SLIDING_ARROW,
                "direction of the pin's velocity along the slot",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // Along the slot, towards the wheel's axis, and from the pin towards the driver's axis.
                let (slot, crank) = (by_triangle(|t| t.angle_at_pivot).to_degrees(), PIN.printed_number("pin.crank-angle"));
                slides(
                    |at| at.heading(if at.mirrored { -crank } else { crank } + 180.0),
                    |at| at.heading_of_velocity(180.0 + slot),
                    stated,
                )
            })
            .second_route(Evidence::VECTORS, |stated| {
                slides(
                    |at| at.heading(at.by_vectors(|at, motion| heading(&to_the_axis(at, motion)))),
                    |at| at.heading(at.by_vectors(|_, motion| heading(&motion.sliding_velocity))),
                    stated,
                )
            })
            .but_not("the pin slides up and to the right")
            .interpreted_as(
                "The stored page has no drawing. We take the mechanism as the page's arrow before the pin's acceleration \
                 has it. This arrow points down and to the right, and two of eight ways of drawing the mechanism fit it. In \
                 both, the pin slides down and to the left, but only in one of them at the printed angle from the \
                 horizontal.",
            ),
        value(
            "wild.holooly.radius",
            "37.1",
            "mm",
            "distance of the pin from the wheel's axis",
            |t| t.slot_radius,
            |motion| motion.position.norm(),
        ),
        HOLOOLY
            .value("wild.holooly.crank", "500", "mm", "crank radius, in the product that gives the pin's acceleration")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                WILD.printed_number("wild.holooly.pin-acceleration") / (PIN.printed_number("pin.driver-speed") * PIN.printed_number("pin.driver-speed"))
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || PIN.printed_number("pin.crank-radius"))
            .corrected(
                "50",
                Slip {
                    origin: Origin::Misprint,
                    consequence: Consequence::Number,
                    ..slip(
                        "500 mm times the square of 10 rad/s is 50,000 mm/s², ten times the printed product. With the \
                         crank radius of the problem, 50 mm, the product is right.",
                        "We used the crank radius of the problem that the page continues.",
                        "Nothing that is printed after this number changes.",
                    )
                },
            ),
        HOLOOLY
            .value("wild.holooly.pin-acceleration", "5000", "mm/s²", "acceleration of the pin")
            .first_route(Evidence::CLOSED_FORM, || {
                PinProblem::printed().map_or(f64::NAN, |instant| {
                    instant.mechanism.crank_radius() * instant.driver_speed * instant.driver_speed
                })
            })
            .second_route(Evidence::VECTORS, || {
                // The pin's velocity turns with the driver.
                PIN.printed_number("pin.driver-speed") * by_vectors(|motion| motion.pin_velocity.norm())
            }),
        HOLOOLY
            .value(
                "wild.holooly.direction",
                "0",
                "°",
                "angle of the pin's acceleration below the horizontal, with a mark to show that the acceleration \
                 points to the right",
            )
            .first_route(Evidence::CLOSED_FORM, || 180.0 - PIN.printed_number("pin.crank-angle"))
            .second_route(Evidence::VECTORS, || {
                let found = PinProblem::printed().ok().and_then(|at| Some(to_the_axis(&at, &at.by_vectors()?).normalize()));
                found.map_or(f64::NAN, |towards| -Turn { cos: towards.x, sin: towards.y }.degrees())
            })
            .interpreted_as(
                "The stored page has no drawing. We take the mechanism as the page's arrow before the sliding velocity \
                 has it. This arrow points down and to the left, and only one of eight ways of drawing the mechanism has it \
                 with the printed angle from the horizontal.",
            )
            .corrected(
                "30",
                Slip {
                    origin: Origin::Copy,
                    consequence: Consequence::Copy,
                    ..slip(
                        "The acceleration points to the driver's axis, 30° below the horizontal. A digit is lost: the \
                         stored copy has a degree sign before the 0, where the digit should be.",
                        "We used the coordinates of the pin and of the driver's axis.",
                        "We don't know what this error affects, because our copy of the page ends before the direction is used.",
                    )
                },
            ),
    ]
}

/// A number by the triangle of the first problem and by its vectors.
fn value(
    id: &'static str,
    digits: &'static str,
    unit: &'static str,
    meaning: &'static str,
    triangle: fn(&TriangleSolution) -> f64,
    vectors: fn(&PinMotion<f64>) -> f64,
) -> Claim {
    HOLOOLY
        .value(id, digits, unit, meaning)
        .first_route(Evidence::CLOSED_FORM, move || by_triangle(triangle))
        .second_route(Evidence::VECTORS, move || by_vectors(vectors))
}

/// A quantity of the first problem's instant by its triangle; not a number if there is no such position.
fn by_triangle(quantity: fn(&TriangleSolution) -> f64) -> f64 {
    PinProblem::printed().map_or(f64::NAN, |instant| quantity(&instant.by_triangle()))
}

/// A quantity of the first problem's instant by vectors; not a number if there is no such position.
fn by_vectors(quantity: fn(&PinMotion<f64>) -> f64) -> f64 {
    PinProblem::printed().ok().and_then(|instant| instant.by_vectors()).map_or(f64::NAN, |motion| quantity(&motion))
}

/// The vector from the pin to the driver's axis, along which a steady driver accelerates the pin.
fn to_the_axis(at: &PinProblem, motion: &PinMotion<f64>) -> Vector2<f64> {
    Vector2::new(at.mechanism.centre_distance(), 0.0) - motion.position
}

/// Whether the arrow in the statement, or the opposite one, is the sliding velocity's in the only placement in which the
/// page's mark fits the pin's acceleration: this many degrees below the horizontal, to the right.
fn slides(acceleration: impl Fn(Placement) -> f64, sliding: impl Fn(Placement) -> f64, stated: Stated) -> Finding {
    let mark = Arrow { up: false, right: true, from_the_horizontal: true };
    let Ok(below) = WILD.lookup("wild.holooly.direction").right_characters().parse() else {
        return Finding::not_evaluated("an angle is no number");
    };
    let slot = WILD.printed_decimal("wild.holooly.angle");
    let left: Vec<_> =
        Placement::all().filter(|at| Arrow::fitting([&below], [acceleration(*at)]) == Some(mark)).collect();
    let said = Arrow::read(stated.characters());
    let opposite = stated.pick(0.0, 180.0);
    let fits = |at: &Placement| {
        let found = Arrow::fitting([&slot], [(sliding(*at) + opposite).rem_euclid(360.0)]);
        found.is_some() && found == said
    };
    let how = format!("the mark of the acceleration fits {} of eight placements of the drawing", left.len());
    Finding::new(left.len() == 1 && left.iter().all(fits), how)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_arrow_is_refused() {
        let judged = |words: &'static str| {
            let claim = WILD.lookup("wild.holooly.sliding-direction");
            geneva_evidence::judge(Box::leak(Box::new(Claim { printed: words, ..claim.clone() }))).matches_record()
        };
        assert!(judged(WILD.printed_text("wild.holooly.sliding-direction")));
        assert!(!judged("an arrow down and to the left, with the angle from the vertical"));
        assert!(!judged("an arrow up and to the right, with the angle from the horizontal"));
        assert!(!judged("an arrow down and to the right, with the angle from the vertical"));
        let turning = |words| turns(by_vectors(|motion| motion.follower_speed), Stated::right(words)).holds;
        assert!(turning(WILD.printed_text("wild.holooly.sense")));
        assert!(!turning("an arrow that turns counterclockwise"));
    }

    #[test]
    fn the_page_prints_the_same_numbers() {
        // The driver's speed and the crank's angle are given there too, and no claims: they are the problem's data.
        for (id, there) in [("pin.driver-speed", "10"), ("pin.crank-angle", "150")] {
            assert_eq!(PIN.printed_text(id), there, "{id}");
        }
        for (id, there) in [
            ("pin.radius", "wild.holooly.radius"),
            ("pin.angle-at-pivot", "wild.holooly.angle"),
            ("pin.sliding-speed", "wild.holooly.sliding"),
            ("pin.sliding-velocity-direction", "wild.holooly.angle"),
            ("pin.follower-speed", "wild.holooly.speed"),
        ] {
            assert_eq!(PIN.printed_text(id), WILD.printed_text(there), "{id}");
        }
        // The crank radius has a zero too many.
        assert_eq!(WILD.printed_text("wild.holooly.crank"), format!("{}0", PIN.printed_text("pin.crank-radius")));
    }
}
