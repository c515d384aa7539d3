//! The position triangle OPB: law of cosines, law of sines.

use super::*;
use crate::Check;
use geneva_kinematics::pin_proofs::{LawOfCosines, LawOfSines};
use geneva_kinematics::prove;
use nalgebra::Vector2;

const COSINES: &str = "Solution, law of cosines";
const SINES: &str = "Solution, law of sines";

pub fn claims() -> Vec<Claim> {
    vec![
        Claim::figure(
            WORK,
            "pin.position-figure",
            "Solution, 1st sentence",
            "triangle OPB is the position at the given crank angle",
            "OPB",
            Check::equation(
                (Vectors, || {
                    // The corner P from the triangle's own side and angle at O, against the crank's end.
                    let radius = triangle(|t| t.slot_radius);
                    let corner = Turn::from_radians(triangle(|t| t.angle_at_pivot)).direction() * radius;
                    let gap = (corner - Vector2::new(vectors(|m| m.position.x), vectors(|m| m.position.y))).norm();
                    Finding::new(gap <= 1e-12 * radius, format!("the triangle closes to {gap:.0e} mm"))
                }),
                (ClosedForm, || same(vectors(|motion| motion.position.norm()), triangle(|t| t.slot_radius))),
            ),
        ),
        Claim::equation(
            WORK,
            "pin.law-of-cosines",
            COSINES,
            "law of cosines for the side OP",
            r"r^{2}=R^{2}+l^{2}-2 R l \cos \ldots",
            Check::equation(
                (ExactIdentity, || prove(&LawOfCosines).into()),
                (Vectors, || same(triangle(|t| t.slot_radius), vectors(|motion| motion.position.norm()))),
            ),
        ),
        Claim::value(
            WORK,
            "pin.angle-at-driver",
            COSINES,
            "angle of the triangle at B, 180° − φ",
            ("30", "°"),
            Check::number(
                (ClosedForm, || 180.0 - printed("pin.crank-angle")),
                (Vectors, || {
                    Instant::printed().map_or(f64::NAN, |instant| {
                        let (to_pin, to_pivot) = (instant.crank.direction(), Vector2::new(-1.0, 0.0));
                        Turn { cos: to_pin.dot(&to_pivot), sin: to_pin.perp(&to_pivot) }.degrees()
                    })
                }),
            ),
        ),
        Claim::value(
            WORK,
            "pin.radius-squared",
            COSINES,
            "square of OP, in squared crank radii",
            ("0.551", "R^{2}"),
            Check::number(
                (ClosedForm, || triangle(|t| t.radius_squared_ratio)),
                (Vectors, || {
                    let radius = printed("pin.crank-radius");
                    vectors(|motion| motion.position.norm_squared()) / (radius * radius)
                }),
            ),
        ),
        Claim::value(
            WORK,
            "pin.radius-ratio",
            COSINES,
            "OP in crank radii",
            ("0.742", "R"),
            Check::number_from_rounded(
                (ClosedForm, || triangle(|t| t.radius_ratio)),
                (Vectors, || vectors(|motion| motion.position.norm()) / printed("pin.crank-radius")),
                || printed("pin.radius-squared").sqrt(),
            ),
        ),
        Claim::value(
            WORK,
            "pin.radius",
            COSINES,
            "OP, distance of the pin from the follower's pivot",
            ("37.1", "mm"),
            Check::number_from_rounded(
                (ClosedForm, || triangle(|t| t.slot_radius)),
                (Vectors, || vectors(|motion| motion.position.norm())),
                || printed("pin.radius-ratio") * printed("pin.crank-radius"),
            ),
        ),
        Claim::equation(
            WORK,
            "pin.law-of-sines",
            SINES,
            "law of sines for the angle at O",
            r"\frac{\sin b}{R}=\frac{\sin 30^{\circ}}{r}",
            Check::equation(
                (ExactIdentity, || prove(&LawOfSines).into()),
                (Vectors, || same(triangle(|t| t.sine_at_pivot), vectors(|motion| motion.position.normalize().y))),
            ),
        ),
        Claim::equation(
            WORK,
            "pin.sine-at-pivot",
            SINES,
            "sine of the angle at O, from the rounded r/R",
            r"\sin b=\frac{\sin 30^{\circ}}{0.742}",
            // An equation with a rounded number in it holds if the number is a rounding of what would make it exact.
            Check::equation(
                (ClosedForm, || makes_exact(triangle(|t| t.sine_at_pivot))),
                (Vectors, || makes_exact(vectors(|motion| motion.position.normalize().y))),
            ),
        ),
        Claim::value(
            WORK,
            "pin.angle-at-pivot",
            SINES,
            "β, angle of the slot at O from the line of centres",
            ("42.4", "°"),
            Check::number_from_rounded(
                (ClosedForm, || triangle(|t| t.angle_at_pivot).to_degrees()),
                (Vectors, || vectors(|motion| Turn { cos: motion.position.x, sin: motion.position.y }.degrees())),
                || {
                    let sine = sine(printed("pin.angle-at-driver")) / printed("pin.radius-ratio");
                    Turn { cos: (1.0 - sine * sine).sqrt(), sin: sine }.degrees()
                },
            ),
        ),
    ]
}

/// Whether the printed r/R is a rounding of the denominator that makes sin β exact.
fn makes_exact(sine_at_pivot: f64) -> Finding {
    let exact = sine(printed("pin.angle-at-driver")) / sine_at_pivot;
    Finding::new(rounds("pin.radius-ratio", exact), format!("exact with {exact} in the denominator"))
}
