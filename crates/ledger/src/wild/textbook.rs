//! A public page that continues the textbook problem of this book's first chapter and asks for the wheel's
//! acceleration.
//!
//! It repeats what it needs of the first problem, whose copy has lost its arrows. Its stored text ends before the
//! result.

use super::*;
use crate::Evidence::OtherPlaceInSource;
use crate::by_id::printed;
use crate::pin::{Instant, only_arrow, turns};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_triangle::TriangleSolution;
use geneva_kinematics::pin_vectors::PinMotion;
use nalgebra::Vector2;

pub fn claims() -> Vec<Claim> {
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
            .statement("wild.holooly.sense", "an arrow that turns clockwise", "sense in which the wheel turns")
            .by(ClosedForm, |stated| {
                // Positive against the driver, which turns counterclockwise.
                turns(-by_triangle(|t| t.follower_speed) * stated.pick(1.0, -1.0), stated)
            })
            .by(Vectors, |stated| turns(by_vectors(|motion| motion.follower_speed) * stated.pick(1.0, -1.0), stated))
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
                "an arrow down and to the left, with the angle from the horizontal",
                "direction of the pin's velocity along the slot",
            )
            .by(ClosedForm, |stated| {
                // Along the slot, towards the wheel's axis, which is down to the left of the pin.
                slides_at(180.0 + by_triangle(|t| t.angle_at_pivot).to_degrees(), stated)
            })
            .by(Vectors, |stated| {
                let x = by_vectors(|motion| motion.sliding_velocity.x);
                let y = by_vectors(|motion| motion.sliding_velocity.y);
                slides_at(libm::atan2(y, x).to_degrees(), stated)
            })
            .but_not("the pin slides up and to the right"),
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
            .by(OtherPlaceInSource, || {
                printed("wild.holooly.pin-acceleration") / (printed("pin.driver-speed") * printed("pin.driver-speed"))
            })
            .by(OtherPlaceInSource, || printed("pin.crank-radius"))
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
            .by(ClosedForm, || {
                Instant::printed().map_or(f64::NAN, |instant| {
                    instant.mechanism.crank_radius() * instant.driver_speed * instant.driver_speed
                })
            })
            .by(Vectors, || {
                // The pin's velocity turns with the driver.
                printed("pin.driver-speed") * by_vectors(|motion| motion.pin_velocity.norm())
            }),
        HOLOOLY
            .value(
                "wild.holooly.direction",
                "0",
                "°",
                "angle of the pin's acceleration below the horizontal, with a mark to show that the acceleration \
                 points to the right",
            )
            .by(ClosedForm, || 180.0 - printed("pin.crank-angle"))
            .by(Vectors, || {
                // Towards the driver's axis.
                let axis = Instant::printed().map_or(f64::NAN, |instant| instant.mechanism.centre_distance());
                let x = by_vectors(|motion| motion.position.x);
                let y = by_vectors(|motion| motion.position.y);
                let towards = Vector2::new(axis - x, -y);
                -Turn { cos: towards.x / towards.norm(), sin: towards.y / towards.norm() }.degrees()
            })
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
        .by(ClosedForm, move || by_triangle(triangle))
        .by(Vectors, move || by_vectors(vectors))
}

/// A quantity of the first problem's instant by its triangle; not a number if there is no such position.
fn by_triangle(quantity: fn(&TriangleSolution) -> f64) -> f64 {
    Instant::printed().map_or(f64::NAN, |instant| quantity(&instant.by_triangle()))
}

/// A quantity of the first problem's instant by vectors; not a number if there is no such position.
fn by_vectors(quantity: fn(&PinMotion<f64>) -> f64) -> f64 {
    Instant::printed().ok().and_then(|instant| instant.by_vectors()).map_or(f64::NAN, |motion| quantity(&motion))
}

/// Whether the arrow that is told of, and no other, has the printed angle for this direction in degrees; or for the opposite
/// one.
fn slides_at(heading: f64, stated: Stated) -> Finding {
    only_arrow(&["wild.holooly.angle"], [(heading + stated.pick(0.0, 180.0)).rem_euclid(360.0)], stated)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::by_id::characters;

    #[test]
    fn another_arrow_is_refused() {
        let sliding =
            |words| slides_at(180.0 + by_triangle(|t| t.angle_at_pivot).to_degrees(), Stated::right(words)).holds;
        assert!(sliding(characters("wild.holooly.sliding-direction")));
        assert!(!sliding("an arrow down and to the left, with the angle from the vertical"));
        assert!(!sliding("an arrow up and to the right, with the angle from the horizontal"));
        let turning = |words| turns(by_vectors(|motion| motion.follower_speed), Stated::right(words)).holds;
        assert!(turning(characters("wild.holooly.sense")));
        assert!(!turning("an arrow that turns counterclockwise"));
    }

    #[test]
    fn the_page_prints_the_same_numbers() {
        // The driver's speed and the crank's angle are given there too, and no claims: they are the problem's data.
        for (id, there) in [("pin.driver-speed", "10"), ("pin.crank-angle", "150")] {
            assert_eq!(characters(id), there, "{id}");
        }
        for (id, there) in [
            ("pin.radius", "wild.holooly.radius"),
            ("pin.angle-at-pivot", "wild.holooly.angle"),
            ("pin.sliding-speed", "wild.holooly.sliding"),
            ("pin.sliding-velocity-direction", "wild.holooly.angle"),
            ("pin.follower-speed", "wild.holooly.speed"),
        ] {
            assert_eq!(characters(id), characters(there), "{id}");
        }
    }
}
