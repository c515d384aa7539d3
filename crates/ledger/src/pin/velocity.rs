//! The velocity triangle: v_P = v_P′ + v_{P/S}.

use super::*;
use crate::{Check, Consequence, Dimension, Erratum, Origin, Slip, Verdict};
use geneva_kinematics::pin_proofs::{PinSpeed, SlidesAlongTheSlot, SlidingSpeed, SlotPointMovesAcross, SlotPointSpeed};
use geneva_kinematics::prove;
use nalgebra::Vector2;

const PIN: &str = "Solution, velocity of the pin";
const TRIANGLE: &str = "Solution, velocity triangle";
const ANGLE: &str = "Solution, angle in the velocity triangle";
const COMPONENTS: &str = "Solution, components of the velocity";
const WHEEL: &str = "Solution, angular velocity of the wheel";

pub fn claims() -> Vec<Claim> {
    [pin_speed(), triangle_of_velocities(), components(), wheel()].concat()
}

fn pin_speed() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "pin.pin-speed-equation",
            PIN,
            "speed of the pin on its circle",
            r"v_{P}=R \mathrm{v}_{D}",
            Check::corrected_equation(
                (Evidence::Dimension, || dimensions(Dimension::SPEED)),
                || prove(&PinSpeed).into(),
                (Jet, || {
                    same(vectors(|m| m.pin_velocity.norm()), printed("pin.crank-radius") * printed("pin.driver-speed"))
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(LETTER_V),
        Claim::value(
            WORK,
            "pin.crank-radius",
            PIN,
            "crank radius R, a datum of the lost figure; the printed speeds and lengths give it back",
            ("50", "mm"),
            Check::number(
                (OtherPlaceInSource, || printed("pin.pin-speed") / printed("pin.driver-speed")),
                (OtherPlaceInSource, || printed("pin.radius") / printed("pin.radius-ratio")),
            ),
        ),
        Claim::value(
            WORK,
            "pin.pin-speed",
            PIN,
            "speed of the pin",
            ("500", "mm/s"),
            Check::number(
                (ClosedForm, || triangle(|t| t.pin_speed)),
                (Jet, || vectors(|motion| motion.pin_velocity.norm())),
            ),
        ),
        Claim::value(
            WORK,
            "pin.pin-velocity-direction",
            PIN,
            "angle of the pin's velocity from the horizontal",
            ("60", "°"),
            Check::number(
                (ClosedForm, || 90.0 - printed("pin.angle-at-driver")),
                (Jet, || vectors(|motion| from_horizontal(&motion.pin_velocity))),
            ),
        ),
        Claim::statement(
            WORK,
            "pin.mark-d",
            PIN,
            "the velocity of the pin and its sliding velocity bear the same arrow",
            "d",
            Check::equation(
                (Jet, same_quadrant),
                (ClosedForm, || {
                    let angle = triangle(|t| t.velocity_angle).to_degrees();
                    Finding::new((0.0..90.0).contains(&angle), format!("the two are {angle:.1}° apart"))
                }),
            ),
        ),
    ]
}

fn triangle_of_velocities() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "pin.velocity-equation",
            TRIANGLE,
            "velocity of the pin: that of the slot's point and that along the slot",
            r"\text{v}_{P}=\text{v}_{P'}+\text{v}_{P/S}",
            Check::equation(
                (ExactIdentity, || prove(&SlidesAlongTheSlot).into()),
                (ClosedForm, || {
                    let by_sides = triangle(|t| libm::hypot(t.slot_point_speed, t.sliding_speed));
                    same(by_sides, vectors(|motion| motion.pin_velocity.norm()))
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "pin.across-the-slot",
            TRIANGLE,
            "the slot's point under the pin moves across OP",
            "perpendicular",
            Check::equation(
                (ExactIdentity, || prove(&SlotPointMovesAcross).into()),
                (Jet, || {
                    let along = vectors(|motion| (motion.pin_velocity - motion.sliding_velocity).dot(&motion.position));
                    let scale = vectors(|motion| motion.pin_velocity.norm() * motion.position.norm());
                    same(scale + along, scale)
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "pin.along-the-slot",
            TRIANGLE,
            "the pin moves along the slot as seen from the wheel",
            "along the slot",
            Check::equation(
                (ExactIdentity, || prove(&SlidesAlongTheSlot).into()),
                (ClosedForm, || {
                    same(
                        triangle(|t| t.sliding_speed),
                        vectors(|motion| -motion.pin_velocity.dot(&motion.position.normalize())),
                    )
                }),
            ),
        ),
        Claim::figure(
            WORK,
            "pin.velocity-figure",
            TRIANGLE,
            "the velocity triangle has its right angle between the velocity of the slot's point and the sliding velocity",
            "triangle",
            Check::equation(
                (Jet, || {
                    let squares = vectors(|m| m.slot_point_velocity.norm_squared() + m.sliding_velocity.norm_squared());
                    same(squares, vectors(|m| m.pin_velocity.norm_squared()))
                }),
                (ClosedForm, || {
                    let squares = triangle(|t| libm::hypot(t.slot_point_speed, t.sliding_speed));
                    same(squares, triangle(|t| t.pin_speed))
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "pin.velocity-angle-equation",
            ANGLE,
            "γ is what β and the angle at B leave of a right angle",
            r"g=90^{\circ}-\ldots-\ldots",
            Check::equation(
                (Vectors, || {
                    same(
                        vectors(angle_to_slot),
                        90.0 - triangle(|t| t.angle_at_pivot).to_degrees() - printed("pin.angle-at-driver"),
                    )
                }),
                (ExactIdentity, || prove(&SlotPointSpeed).into()),
            ),
        ),
        Claim::value(
            WORK,
            "pin.velocity-angle",
            ANGLE,
            "γ, angle between the pin's velocity and the slot",
            ("17.6", "°"),
            Check::number_from_rounded(
                (ClosedForm, || triangle(|t| t.velocity_angle).to_degrees()),
                (Vectors, || vectors(angle_to_slot)),
                || 90.0 - printed("pin.angle-at-pivot") - printed("pin.angle-at-driver"),
            ),
        ),
    ]
}

fn components() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "pin.slot-point-equation",
            COMPONENTS,
            "component of the pin's velocity across the slot",
            r"v_{P'}=v_{P} \sin g",
            Check::equation(
                (ExactIdentity, || prove(&SlotPointSpeed).into()),
                (Jet, || same(triangle(|t| t.slot_point_speed), vectors(|motion| motion.slot_point_velocity.norm()))),
            ),
        ),
        Claim::value(
            WORK,
            "pin.slot-point-speed",
            COMPONENTS,
            "speed of the slot's point under the pin",
            ("151.2", "mm/s"),
            Check::number_from_rounded(
                (ClosedForm, || triangle(|t| t.slot_point_speed)),
                (Jet, || vectors(|motion| motion.slot_point_velocity.norm())),
                || printed("pin.pin-speed") * sine(printed("pin.velocity-angle")),
            ),
        )
        .expecting(Verdict::FromRounded)
        .with_erratum(Erratum {
            corrected: "151.5",
            slip: Slip {
                id: "",
                reason: "Four digits are printed, but they come from an angle rounded to three; the fourth is not \
                    right.",
                witness: "The pin's place differentiated, which uses no angle, gives the corrected digits.",
                origin: Origin::Arithmetic,
                consequence: Consequence::Result,
                changes: "",
            },
        }),
        Claim::value(
            WORK,
            "pin.slot-point-velocity-direction",
            COMPONENTS,
            "angle of the slot point's velocity, from the vertical",
            ("42.4", "°"),
            Check::number(
                (ClosedForm, || triangle(|t| t.angle_at_pivot).to_degrees()),
                (Jet, || vectors(|motion| 90.0 - from_horizontal(&motion.slot_point_velocity))),
            ),
        ),
        Claim::statement(
            WORK,
            "pin.mark-f",
            COMPONENTS,
            "the arrow before the angle of the slot point's velocity says what the angle is measured from",
            "f",
            Check::corrected_equation(
                (Jet, || reads_as(from_horizontal, "horizontal")),
                || reads_as(|velocity| 90.0 - from_horizontal(velocity), "vertical"),
                (ExactIdentity, || prove(&SlotPointMovesAcross).into()),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "↘, angle from the vertical",
            slip: Slip {
                id: "",
                reason: "The arrow came out of the copy as the letter f. Read from the horizontal, as with the other \
                    two velocities, the printed angle is wrong; it is the angle from the vertical.",
                witness: "The velocity is across the slot, which makes the same angle with the horizontal.",
                origin: Origin::Copy,
                consequence: Consequence::Copy,
                changes: "",
            },
        }),
        Claim::equation(
            WORK,
            "pin.sliding-equation",
            COMPONENTS,
            "component of the pin's velocity along the slot",
            r"v_{P/S}=v_{P} \cos g",
            Check::equation(
                (ExactIdentity, || prove(&SlidingSpeed).into()),
                (Jet, || same(triangle(|t| t.sliding_speed), vectors(|motion| motion.sliding_velocity.norm()))),
            ),
        ),
        Claim::value(
            WORK,
            "pin.sliding-speed",
            COMPONENTS,
            "speed of the pin along the slot",
            ("477", "mm/s"),
            Check::number_from_rounded(
                (ClosedForm, || triangle(|t| t.sliding_speed)),
                (Jet, || vectors(|motion| motion.sliding_velocity.norm())),
                || printed("pin.pin-speed") * Turn::from_degrees(printed("pin.velocity-angle")).cos,
            ),
        ),
        Claim::value(
            WORK,
            "pin.sliding-velocity-direction",
            COMPONENTS,
            "angle of the sliding velocity from the horizontal",
            ("42.4", "°"),
            Check::number(
                (ClosedForm, || triangle(|t| t.angle_at_pivot).to_degrees()),
                (Jet, || vectors(|motion| from_horizontal(&motion.sliding_velocity))),
            ),
        ),
    ]
}

fn wheel() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "pin.follower-speed-equation",
            WHEEL,
            "speed of the slot's point from the wheel's angular velocity",
            r"v_{P'}=r \mathrm{v}_{S}",
            Check::corrected_equation(
                (Evidence::Dimension, || dimensions(Dimension::SPEED)),
                || prove(&SlotPointSpeed).into(),
                (ClosedForm, || same(triangle(|t| t.slot_point_speed), triangle(|t| t.slot_radius * t.follower_speed))),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: r"v_{P'}=r \omega_{S}", ..LETTER_V }),
        Claim::value(
            WORK,
            "pin.follower-speed",
            WHEEL,
            "angular speed of the wheel",
            ("4.08", "rad/s"),
            Check::number_from_rounded(
                (ClosedForm, || triangle(|t| t.follower_speed)),
                (Jet, || vectors(|motion| motion.follower_speed.abs())),
                || printed("pin.slot-point-speed") / printed("pin.radius"),
            ),
        ),
        Claim::statement(
            WORK,
            "pin.follower-sense",
            WHEEL,
            "sense in which the wheel turns, by an arrow",
            "i",
            Check::Missing {
                reason: "the arrow came out of the copy as the letter i, which does not say which way it pointed; the \
                         computation says clockwise, against the driver",
            },
        )
        .expecting(Verdict::NotReproducible),
    ]
}

const LETTER_V: Erratum = Erratum {
    corrected: r"v_{P}=R \omega_{D}",
    slip: Slip {
        id: "pin.pin-speed-equation",
        reason: "The Greek letter of the angular velocity came out of the copy as v, which makes the sides of the equation \
             differ in dimension.",
        witness: "With an angular velocity the equation gives the computed speed.",
        origin: Origin::Copy,
        consequence: Consequence::Copy,
        changes: "",
    },
};

/// Whether a length times this has the dimension of a speed.
fn dimensions(second: Dimension) -> Finding {
    let product = Dimension::LENGTH * second;
    Finding::new(product == Dimension::SPEED, format!("{product} stands for {}", Dimension::SPEED))
}

/// The acute angle between a direction and the horizontal, in degrees.
fn from_horizontal(direction: &Vector2<f64>) -> f64 {
    Turn { cos: direction.x.abs(), sin: direction.y.abs() }.degrees()
}

/// The angle between the pin's velocity and the direction to the follower's pivot, in degrees.
fn angle_to_slot(motion: &PinMotion<f64>) -> f64 {
    let inward = -motion.position;
    Turn { cos: motion.pin_velocity.dot(&inward), sin: motion.pin_velocity.perp(&inward).abs() }.degrees()
}

/// Whether the pin's velocity and its sliding velocity point into the same quadrant.
fn same_quadrant() -> Finding {
    let Some(motion) = Instant::printed().ok().and_then(|instant| instant.by_vectors()) else {
        return Finding::new(false, "no such position");
    };
    let (a, b) = (motion.pin_velocity, motion.sliding_velocity);
    let signs = |v: Vector2<f64>| (v.x > 0.0, v.y > 0.0);
    Finding::new(signs(a) == signs(b), format!("({:.0}, {:.0}) and ({:.0}, {:.0})", a.x, a.y, b.x, b.y))
}

/// Whether the printed angle of the slot point's velocity is right if measured as `angle` does.
fn reads_as(angle: fn(&Vector2<f64>) -> f64, from: &str) -> Finding {
    let Some(motion) = Instant::printed().ok().and_then(|instant| instant.by_vectors()) else {
        return Finding::new(false, "no such position");
    };
    let measured = angle(&motion.slot_point_velocity);
    let holds = rounds("pin.slot-point-velocity-direction", measured);
    Finding::new(holds, format!("{measured:.2}° from the {from}"))
}
