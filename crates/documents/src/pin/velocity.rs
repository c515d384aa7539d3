//! The velocity triangle: v_P = v_P′ + v_{P/S}.

use super::letters::{SPEEDS, VELOCITIES};
use super::placement::{AS_ON_THE_PAGE, drawn};
use super::*;
use geneva_evidence::filled;
use nalgebra::Vector2;

const PIN_VELOCITY: Locator = at("Solution, velocity of the pin");
const TRIANGLE: Locator = at("Solution, velocity triangle");
const ANGLE: Locator = at("Solution, angle in the velocity triangle");
const COMPONENTS: Locator = at("Solution, components of the velocity");
const WHEEL: Locator = at("Solution, angular velocity of the wheel");

pub(super) fn claims() -> Vec<Claim> {
    [pin_speed(), triangle_of_velocities(), components(), wheel()].concat()
}

fn pin_speed() -> Vec<Claim> {
    vec![
        PIN_VELOCITY
            .equation("pin.pin-speed-equation", r"v_{P}=R \mathrm{v}_{D}", "speed of the pin on its circle")
            .in_letters(SPEEDS)
            .interpreted_as(OF_A_DISK),
        PIN_VELOCITY
            .value(
                "pin.crank-radius",
                "50",
                "mm",
                "crank radius R from the lost figure, confirmed by the printed speeds and lengths",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                PIN.printed_number("pin.pin-speed") / PIN.printed_number("pin.driver-speed")
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                PIN.printed_number("pin.radius") / PIN.printed_number("pin.radius-ratio")
            }),
        PIN_VELOCITY
            .value("pin.pin-speed", "500", "mm/s", "speed of the pin")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.pin_speed))
            .second_route(Evidence::JET, || vectors(|motion| motion.pin_velocity.norm())),
        PIN_VELOCITY
            .value("pin.pin-velocity-direction", "60", "°", "angle of the pin's velocity from the horizontal")
            .first_route(Evidence::CLOSED_FORM, || 90.0 - PIN.printed_number("pin.angle-at-driver"))
            .second_route(Evidence::JET, || vectors(|motion| from_horizontal(&motion.pin_velocity)))
            .interpreted_as(AS_ON_THE_PAGE),
        signs::mark_d(),
    ]
}

fn triangle_of_velocities() -> Vec<Claim> {
    vec![
        TRIANGLE
            .equation(
                "pin.velocity-equation",
                r"\text{v}_{P}=\text{v}_{P'}+\text{v}_{P/S}",
                "velocity of the pin, as the velocity of the slot's point plus the velocity along the slot",
            )
            .in_letters(VELOCITIES),
        directions::across_the_slot(),
        directions::along_the_slot(),
        directions::velocity_figure(),
        TRIANGLE.lost_drawing("pin.triangle-drawings", "we draw", "the drawings of the two triangles"),
        signs::letter_g(),
        ANGLE
            .equation(
                "pin.velocity-angle-equation",
                r"g=90^{\circ}-\ldots^{\circ}-\ldots^{\circ}",
                "γ is a right angle less the angles at O and B",
            )
            .rewritten_and_proven(SPEEDS, filled(&[r"\theta^\circ", r"b^\circ"])),
        ANGLE
            .value("pin.velocity-angle", "17.6", "°", "γ, angle between the pin's velocity and the slot")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.velocity_angle).to_degrees())
            .second_route(Evidence::VECTORS, || vectors(angle_to_slot))
            .rounded(|| 90.0 - PIN.printed_number("pin.angle-at-pivot") - PIN.printed_number("pin.angle-at-driver")),
    ]
}

fn components() -> Vec<Claim> {
    vec![
        COMPONENTS
            .equation(
                "pin.slot-point-equation",
                r"v_{P'}=v_{P} \sin g",
                "component of the pin's velocity across the slot",
            )
            .in_letters(SPEEDS),
        COMPONENTS
            .value("pin.slot-point-speed", "151.2", "mm/s", "speed of the slot's point under the pin")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.slot_point_speed))
            .second_route(Evidence::JET, || vectors(|motion| motion.slot_point_velocity.norm()))
            .rounded(|| PIN.printed_number("pin.pin-speed") * sine(PIN.printed_number("pin.velocity-angle")))
            .expecting(Verdict::FromRounded)
            .affected_by(ROUNDED_ANGLE),
        signs::mark_f(),
        COMPONENTS
            .value(
                "pin.slot-point-velocity-direction",
                "42.4",
                "°",
                "angle of the slot point's velocity, from the vertical",
            )
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.angle_at_pivot).to_degrees())
            .second_route(Evidence::JET, || vectors(|motion| 90.0 - from_horizontal(&motion.slot_point_velocity)))
            .interpreted_as(AS_ON_THE_PAGE),
        COMPONENTS
            .equation("pin.sliding-equation", r"v_{P/S}=v_{P} \cos g", "component of the pin's velocity along the slot")
            .in_letters(SPEEDS),
        COMPONENTS
            .value("pin.sliding-speed", "477", "mm/s", "speed of the pin along the slot")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.sliding_speed))
            .second_route(Evidence::JET, || vectors(|motion| motion.sliding_velocity.norm()))
            .rounded(|| {
                PIN.printed_number("pin.pin-speed") * Turn::from_degrees(PIN.printed_number("pin.velocity-angle")).cos
            }),
        COMPONENTS
            .value("pin.sliding-velocity-direction", "42.4", "°", "angle of the sliding velocity from the horizontal")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.angle_at_pivot).to_degrees())
            .second_route(Evidence::JET, || vectors(|motion| from_horizontal(&motion.sliding_velocity)))
            .interpreted_as(AS_ON_THE_PAGE),
    ]
}

fn wheel() -> Vec<Claim> {
    vec![
        WHEEL
            .equation(
                "pin.follower-speed-equation",
                r"v_{P'}=r \mathrm{v}_{S}",
                "speed of the slot's point from the wheel's angular velocity",
            )
            .in_letters(SPEEDS)
            .interpreted_as(OF_A_DISK),
        WHEEL
            .value("pin.follower-speed", "4.08", "rad/s", "angular speed of the wheel")
            .first_route(Evidence::CLOSED_FORM, || triangle(|t| t.follower_speed))
            .second_route(Evidence::JET, || vectors(|motion| motion.follower_speed.abs()))
            .rounded(|| PIN.printed_number("pin.slot-point-speed") / PIN.printed_number("pin.radius")),
        signs::follower_sense(),
    ]
}

const ROUNDED_ANGLE: Slip = Slip {
    id: "pin.slot-point-speed",
    reason: "Four digits are printed, but they come from the sine of an angle that was rounded to three digits, so \
             the fourth digit is wrong.",
    witness: "Differentiating the pin's position needs no rounded angle and gives the corrected digits.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Number,
    changes: "Only the fourth digit of this speed is wrong. The wheel's angular velocity, which is computed from this \
              speed, is right to its three printed digits.",
};

/// How the letter v is read that has a disk's name for an index.
const OF_A_DISK: &str = "The letter v with the index D or S means the angular velocity of that disk, as it does where \
                         the problem gives it and where its unit is printed.";

/// The acute angle between a direction and the horizontal, in degrees.
fn from_horizontal(direction: &Vector2<f64>) -> f64 {
    let turn = Turn::from_degrees(drawn().heading(heading(direction)));
    Turn { cos: turn.cos.abs(), sin: turn.sin.abs() }.degrees()
}

/// The acute angle between the pin's velocity and the line of the slot, in degrees.
fn angle_to_slot(motion: &PinMotion<f64>) -> f64 {
    let (along, across) = (motion.pin_velocity.dot(&motion.position), motion.pin_velocity.perp(&motion.position));
    Turn { cos: along.abs(), sin: across.abs() }.degrees()
}
