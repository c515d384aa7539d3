//! The velocities: a triangle with its right angle between lever and slot.

use super::letters::SIZES;
use super::*;
use geneva_evidence::filled;

const PIN: Locator = at("Solution, velocity, part (a)");
const ACROSS: Locator = at("Solution, velocity, 4th line");
const LEVER: Locator = at("Solution, velocity, 5th line");
const ALONG: Locator = at("Solution, velocity, 6th line");

pub(super) fn claims() -> Vec<Claim> {
    [pin(), across(), along()].concat()
}

fn pin() -> Vec<Claim> {
    vec![
        PIN.equation("quick-return.pin-speed-equation", r"v_{P2} = \omega_2 l_2", "speed of the pin on its circle")
            .in_letters(SIZES),
        PIN.value("quick-return.pin-speed", "1.048", "m/s", "speed of the pin")
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.velocities.pin_velocity.norm()))
            .second_route(Evidence::JET, || {
                series(|rates| libm::hypot(rates.sliding, rates.angular_velocity) * radius(rates))
            })
            .rounded(|| {
                QUICK_RETURN.printed_number("quick-return.driver-rate")
                    * QUICK_RETURN.printed_number("quick-return.crank")
            })
            .expecting(Verdict::FromRounded)
            .affected_by(rounding::STEPS),
    ]
}

fn across() -> Vec<Claim> {
    vec![
        ACROSS
            .equation(
                "quick-return.lever-point-speed-equation",
                r"v_{P4} = v_{P2} \cos(\ldots^\circ)",
                "the pin's velocity across the lever, from an angle between crank and lever",
            )
            .rewritten_and_proven(SIZES, filled(&[r"\psi^\circ"]))
            .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || {
                printed_speeds_point_to("quick-return.lever-point-speed", arccosine)
            })
            .corrected(r"v_{P4} = v_{P2} \cos\beta", OTHER_ANGLE),
        ACROSS
            .value("quick-return.lever-point-speed", "0.669", "m/s", "speed of the lever's point under the pin")
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.velocities.slot_point_velocity.norm()))
            .second_route(Evidence::JET, || series(|rates| rates.angular_velocity * radius(rates)))
            .rounded(|| {
                QUICK_RETURN.printed_number("quick-return.pin-speed")
                    * cosine(QUICK_RETURN.printed_number("quick-return.angle-at-pin"))
            }),
        LEVER
            .equation("quick-return.lever-speed-equation", r"\omega_4 = v_{P4} / l_4", "angular velocity of the lever")
            .in_letters(SIZES),
        LEVER
            .value("quick-return.lever-speed", "1.216", "rad/s", "angular velocity of the lever")
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.velocities.follower_speed))
            .second_route(Evidence::JET, || series(|rates| rates.angular_velocity))
            .rounded(|| {
                QUICK_RETURN.printed_number("quick-return.lever-point-speed")
                    / QUICK_RETURN.printed_number("quick-return.lever-length")
            })
            .expecting(Verdict::FromRounded)
            .affected_by(rounding::STEPS),
    ]
}

fn along() -> Vec<Claim> {
    vec![
        ALONG
            .equation(
                "quick-return.sliding-speed-equation",
                r"v_{P2/P4} = v_{P2} \sin(\ldots^\circ)",
                "the pin's velocity along the lever, from an angle between crank and lever",
            )
            .rewritten_and_proven(SIZES, filled(&[r"\psi^\circ"]))
            .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || {
                printed_speeds_point_to("quick-return.sliding-speed", arcsine)
            })
            .corrected(r"v_{P2/P4} = v_{P2} \sin\beta", OTHER_ANGLE),
        ALONG
            .value("quick-return.sliding-speed", "0.806", "m/s", "speed of the pin along the slot")
            .first_route(Evidence::VECTORS, || diagram(|motion| motion.velocities.sliding_velocity.norm()))
            .second_route(Evidence::JET, || series(|rates| rates.sliding.abs() * radius(rates)))
            .rounded(|| {
                QUICK_RETURN.printed_number("quick-return.pin-speed")
                    * sine(QUICK_RETURN.printed_number("quick-return.angle-at-pin"))
            }),
    ]
}

const OTHER_ANGLE: Slip = Slip {
    id: "quick-return.lever-point-speed-equation",
    reason: "The pin's velocity v(P2) is at right angles to the crank, and its part v(P4) across the lever is at right \
             angles to the lever. So the angle between these two velocities is the angle between crank and lever. That \
             angle is β, at the pin. The printed angle is the angle between the crank and the line of centres. \
             Because the solution itself computes the printed angle and uses it in two equations, we do not think that \
             this mistake comes from our copy.",
    witness: "The printed speeds alone show the mistake. Divided by the speed of the pin, they are the cosine and the \
              sine of an angle, and to the printed digits this angle is β.",
    origin: Origin::Misprint,
    consequence: Consequence::Derivation,
    changes: "The correction changes no number, because the solution computed both speeds with β.",
};

/// Whether the ratio of a printed speed to the printed speed of the pin belongs to β and not to the printed angle.
fn printed_speeds_point_to(part: &str, angle_of: fn(f64) -> f64) -> Finding {
    let [part, whole] = [part, "quick-return.pin-speed"].map(|id| QUICK_RETURN.printed_interval(id));
    let [lowest, highest] = [part[0] / whole[1], part[1] / whole[0]];
    let [a, b] = [angle_of(lowest), angle_of(highest)];
    let allowed = a.min(b)..a.max(b);
    let (beta, other) = (
        QUICK_RETURN.printed_number("quick-return.angle-at-pin"),
        QUICK_RETURN.printed_number("quick-return.crank-angle"),
    );
    let holds = allowed.contains(&beta) && !allowed.contains(&other);
    Finding::new(
        holds,
        format!(
            "the printed speeds fit only an angle between {:.2}° and {:.2}° (β is {beta}°, and the printed angle is \
             {other}°)",
            allowed.start, allowed.end
        ),
    )
}
