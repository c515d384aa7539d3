//! The velocity triangle: v_P = v_P′ + v_{P/S}.

use super::signs::{GREEK, dimension};
use super::*;
use geneva_kinematics::pin_proofs::{PinSpeed, SlidesAlongTheSlot, SlidingSpeed, SlotPointSpeed};
use geneva_kinematics::pin_vectors::quarter_turn;
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
                (Evidence::Dimension, || a_length_times_a_speed("pin.crank-radius")),
                || prove(&PinSpeed).into(),
                (AutomaticDerivative, || {
                    from_duals(|crank| {
                        let speed = printed("pin.crank-radius") * printed("pin.driver-speed");
                        meets(crank.pin_motion()[1].norm(), speed)
                    })
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: r"v_{P}=R \omega_{D}", slip: GREEK }),
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
        signs::mark_d(),
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
                (AutomaticDerivative, || {
                    from_duals(|crank| {
                        let [[distance, sliding, _], [slot, turning, _]] = crank.polar();
                        let along = Turn::from_radians(slot).direction();
                        let sum = quarter_turn(&along) * (distance * turning) + along * sliding;
                        let [_, pin, _] = crank.pin_motion();
                        Finding::new(coincide(&pin, &sum), parts(&pin, &sum))
                    })
                }),
            ),
        ),
        directions::across_the_slot(),
        directions::along_the_slot(),
        directions::velocity_figure(),
        signs::letter_g(),
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
                (AutomaticDerivative, || {
                    from_duals(|crank| {
                        let [[distance, sliding, _], [slot, turning, _]] = crank.polar();
                        let angle = libm::atan2((distance * turning).abs(), sliding.abs()).to_degrees();
                        let triangle = crank.angle.to_degrees() - 180.0 + 90.0 - slot.to_degrees();
                        meets(angle, triangle)
                    })
                }),
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
                (AutomaticDerivative, || {
                    from_duals(|crank| {
                        let [[distance, ..], [_, turning, _]] = crank.polar();
                        meets((distance * turning).abs(), triangle(|t| t.pin_speed * libm::sin(t.velocity_angle)))
                    })
                }),
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
        .affected_by(ROUNDED_ANGLE),
        signs::mark_f(),
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
        Claim::equation(
            WORK,
            "pin.sliding-equation",
            COMPONENTS,
            "component of the pin's velocity along the slot",
            r"v_{P/S}=v_{P} \cos g",
            Check::equation(
                (ExactIdentity, || prove(&SlidingSpeed).into()),
                (AutomaticDerivative, || {
                    from_duals(|crank| {
                        let [[_, sliding, _], _] = crank.polar();
                        meets(sliding.abs(), triangle(|t| t.pin_speed * libm::cos(t.velocity_angle)))
                    })
                }),
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
                (Evidence::Dimension, || a_length_times_a_speed("pin.radius")),
                || prove(&SlotPointSpeed).into(),
                (AutomaticDerivative, || {
                    // What the pin's velocity has across the slot, against the distance times the slot's rate.
                    from_duals(|crank| {
                        let ([place, velocity, _], [[distance, ..], [_, turning, _]]) =
                            (crank.pin_motion(), crank.polar());
                        meets(place.perp(&velocity) / place.norm(), distance * turning)
                    })
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: r"v_{P'}=r \omega_{S}", slip: GREEK }),
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
                reason: "the copy has the letter i for the arrow, which does not say which way it pointed; the \
                         computation says clockwise, against the driver",
            },
        )
        .expecting(Verdict::NotReproducible),
    ]
}

const ROUNDED_ANGLE: Slip = Slip {
    id: "pin.slot-point-speed",
    reason: "Four digits are printed, but they come from the sine of an angle rounded to three; the fourth is not \
             right.",
    witness: "The pin's place differentiated, which uses no angle, gives the corrected digits.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Result,
    changes: "The fourth digit of this speed; the wheel's angular velocity, computed from it, keeps its three digits.",
};

/// Whether the length printed in this claim, times what the letter v names with the pin's velocity, is a speed.
fn a_length_times_a_speed(length: &str) -> Finding {
    let product = dimension(length).zip(dimension("pin.pin-speed")).map(|(length, speed)| length * speed);
    let words = product.map_or("unknown".into(), |product| product.to_string());
    Finding::new(product == Some(Dimension::SPEED), format!("{words} stands for {}", Dimension::SPEED))
}

/// Two vectors by their components, in the printed unit.
fn parts(a: &Vector2<f64>, b: &Vector2<f64>) -> String {
    format!("({:.1}, {:.1}) against ({:.1}, {:.1})", a.x, a.y, b.x, b.y)
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
