//! Where the pin is and how fast, by the closed forms.
//!
//! Notation: `R` crank radius, `l` centre distance, `k` = l/R; φ crank angle, θ = 180° − φ; r distance of the pin
//! from the follower's pivot; β angle of the slot; γ acute angle between the pin's velocity and the slot.

use crate::number::without_noise;
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::{self, PinSlot};
use geneva_kinematics::pin_vectors::quarter_turn;
use nalgebra::Vector2;

/// Position and motion of a pin in its slot at one instant. Lengths are in the mechanism's unit, speeds in that unit times the driver's.
#[derive(Clone, Debug)]
pub(super) struct PinState {
    /// φ in radians, in [0, 2π).
    pub crank_angle: f64,
    /// r / R.
    pub radius_ratio: f64,
    /// Position of the pin from the follower's pivot.
    pub position: Vector2<f64>,
    /// Angle of the slot, in radians; negative below the line of centres.
    pub slot_angle: f64,
    /// Angular velocity of the follower over the driver's: counter-clockwise positive when the driver's is.
    pub speed_ratio: f64,
    /// Velocity of the pin.
    pub pin_velocity: Vector2<f64>,
    /// Velocity of the follower's point under the pin.
    pub slot_point_velocity: Vector2<f64>,
    /// Velocity of the pin relative to the follower, along the slot.
    pub sliding_velocity: Vector2<f64>,
    /// Speed of the pin along the slot, positive towards the follower's pivot.
    pub inward_speed: f64,
}

impl PinState {
    /// The instant at crank angle φ, for a driver of this angular velocity (radians per time, counter-clockwise).
    pub(super) fn new(mechanism: &PinSlot, crank: &Turn<f64>, driver_speed: f64) -> Self {
        let (ratio, unit) = (mechanism.ratio(), mechanism.crank_radius());
        let from_line_of_centres = crank.supplement();
        let in_radii = pin_slot::pin_from_pivot(&ratio, &from_line_of_centres);
        let radius_ratio = pin_slot::slot_radius_squared(&ratio, &from_line_of_centres).sqrt();
        let position = in_radii * unit;
        let speed_ratio = -pin_slot::velocity_ratio(&ratio, &from_line_of_centres);
        // θ decreases as φ grows, so dr/dφ is minus dr/dθ, and the speed inwards is plus.
        let rate = pin_slot::sliding_product(&ratio, &from_line_of_centres) / radius_ratio;
        let inward_speed = rate * unit * driver_speed;
        let turned = crank.radians();
        Self {
            crank_angle: if turned < 0.0 { turned + 2.0 * std::f64::consts::PI } else { turned },
            radius_ratio,
            position,
            slot_angle: libm::atan2(position.y, position.x),
            speed_ratio,
            pin_velocity: quarter_turn(&crank.direction()) * (unit * driver_speed),
            slot_point_velocity: quarter_turn(&position) * (speed_ratio * driver_speed),
            sliding_velocity: in_radii * (-inward_speed / radius_ratio),
            inward_speed,
        }
    }

    /// γ in radians: from 0 (the pin moves along the slot) to π/2 (across it).
    pub(super) fn velocity_angle(&self) -> f64 {
        libm::atan2(self.slot_point_velocity.norm(), self.sliding_velocity.norm())
    }

    /// The three speeds for display, rounding error taken for zero: of the pin, of the slot's point, along the slot.
    pub(super) fn speeds(&self) -> [f64; 3] {
        let pin = self.pin_velocity.norm();
        [pin, self.slot_point_velocity.norm(), self.sliding_velocity.norm()].map(|speed| without_noise(speed, pin))
    }

    /// +1 if the pin is on or above the line of centres, −1 below it.
    pub(super) fn side(&self) -> f64 {
        if self.position.y < 0.0 { -1.0 } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_kinematics::pin_vectors;

    #[test]
    fn the_velocity_triangle_closes_and_agrees_with_the_differentiated_path() {
        let mechanism = PinSlot::new(3.0, 4.4).expect("possible");
        for degrees in [128, 141, 163, 180, 199, 217, 232].map(f64::from) {
            let crank = Turn::from_degrees(degrees);
            let instant = PinState::new(&mechanism, &crank, 7.0);
            let gap = instant.slot_point_velocity + instant.sliding_velocity - instant.pin_velocity;
            assert!(gap.norm() <= 1e-12 * instant.pin_velocity.norm(), "{degrees}: {gap}");
            let motion = pin_vectors::solve(&3.0, &4.4, &crank, &7.0).expect("off the pivot");
            approx::assert_relative_eq!(motion.position, instant.position, max_relative = 1e-12);
            let sliding = motion.sliding_velocity - instant.sliding_velocity;
            assert!(sliding.norm() <= 1e-12 * instant.pin_velocity.norm(), "{degrees}: {sliding}");
            approx::assert_relative_eq!(motion.follower_speed, instant.speed_ratio * 7.0, max_relative = 1e-12);
        }
    }

    #[test]
    fn the_pin_slides_inwards_before_the_line_of_centres_and_outwards_after() {
        let mechanism = PinSlot::new(3.0, 4.4).expect("possible");
        let at = |degrees| PinState::new(&mechanism, &Turn::from_degrees(degrees), 1.0);
        assert!(at(160.0).inward_speed > 0.0 && at(200.0).inward_speed < 0.0);
        assert!(at(160.0).side() > 0.0 && at(200.0).side() < 0.0);
    }
}
