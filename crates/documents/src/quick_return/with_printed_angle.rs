//! What would follow if the angle that is printed with the velocities were right.

use super::*;

/// What the source would have found if the angle printed with the velocities were the one between crank and lever.
///
/// The speed of the pin and the length of the lever stay as they are. No such motion exists, because the triangle of
/// ground, crank and lever does not close with this angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithPrintedAngle {
    /// Speed of the lever's point, in m/s.
    pub lever_point_speed: f64,
    /// Sliding speed, in m/s.
    pub sliding_speed: f64,
    /// Angular velocity of the lever, in rad/s.
    pub lever_speed: f64,
    /// Centripetal acceleration of the lever's point, in m/s².
    pub lever_normal: f64,
    /// Coriolis acceleration, in m/s².
    pub coriolis: f64,
    /// Sliding acceleration towards the pivot, in m/s².
    pub sliding_acceleration: f64,
    /// Tangential acceleration of the lever's point, clockwise, in m/s².
    pub lever_tangential: f64,
    /// Angular acceleration of the lever, clockwise, in rad/s².
    pub lever_acceleration: f64,
}

/// Evaluates the equations as they are printed, unrounded: the two for the velocities with the angle that is printed
/// there, and the two for the accelerations with β.
pub fn with_printed_angle() -> WithPrintedAngle {
    let angle = Turn::from_degrees(QUICK_RETURN.printed_number("quick-return.crank-angle"));
    let beta = Turn::from_radians(position_of(Position::angle_at_pin));
    let length = position_of(|position| position.pin_distance);
    let (speed, normal) =
        (diagram(|motion| motion.velocities.pin_velocity.norm()), diagram(|motion| motion.pin_normal.norm()));
    let [lever_point_speed, sliding_speed] = [speed * angle.cos, speed * angle.sin];
    let lever_speed = lever_point_speed / length;
    let lever_normal = lever_speed * lever_point_speed;
    let coriolis = 2.0 * lever_speed * sliding_speed;
    let lever_tangential = normal * beta.sin - coriolis;
    WithPrintedAngle {
        lever_point_speed,
        sliding_speed,
        lever_speed,
        lever_normal,
        coriolis,
        sliding_acceleration: normal * beta.cos - lever_normal,
        lever_tangential,
        lever_acceleration: lever_tangential / length,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_evidence::tex::{Letters, name, value};

    #[test]
    fn the_accelerations_are_those_of_the_printed_equations() {
        let (with, beta) = (with_printed_angle(), position_of(Position::angle_at_pin));
        let letters = [
            ("A_{P2}^n", diagram(|motion| motion.pin_normal.norm())),
            ("A_{P4}^n", with.lever_normal),
            (r"\omega_4", with.lever_speed),
            ("v_{P2/P4}", with.sliding_speed),
            (r"\beta", beta),
        ];
        let letters = letters.map(|(tex, value)| (name(tex).expect("a name"), value));
        for (id, found) in [
            ("quick-return.sliding-acceleration-equation", with.sliding_acceleration),
            ("quick-return.lever-tangential-equation", with.lever_tangential),
        ] {
            let printed =
                value(&QUICK_RETURN.right_side(id).replace(r"\ldots", r"\beta"), &Letters::from(letters.clone()));
            assert!(agrees(printed, found), "{id}: {printed} against {found}");
        }
    }
}
