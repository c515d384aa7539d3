//! One instant: the kinematics of the linkage, and how its values are written.

use crate::number::{significant, with_minus_sign};
use geneva_kinematics::pin_vectors::PinMotion;
use geneva_kinematics::quick_return::{Drive, Motion, Position, QuickReturn};
use geneva_kinematics::relative_motion::SlotAccelerations;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// What is so small beside the greatest of its kind is written as zero.
const NOTHING: f64 = 1e-7;
/// Outside these sizes values are written with a power of ten.
const SMALL: f64 = 1e-3;
const LARGE: f64 = 1e6;

/// Position and motion at one instant. Angles in radians, the rest in the units of the arguments.
#[derive(Clone, Debug)]
pub struct Instant {
    /// φ, in [0, 2π).
    pub crank_angle: f64,
    /// ψ, in (−π, π].
    pub lever_angle: f64,
    /// β, in [0, π].
    pub angle_at_pin: f64,
    /// r.
    pub pin_distance: f64,
    /// Unit vector from the lever's pivot to the pin.
    pub along: Vector2<f64>,
    /// All vectors.
    pub motion: Motion<f64>,
}

impl Instant {
    /// The motion of a linkage at a position. With the pin on the lever's pivot nothing moves.
    pub fn new(linkage: &QuickReturn, position: &Position, drive: &Drive<f64>) -> Self {
        let motion = Motion::at(&linkage.ground(), &linkage.crank(), &position.crank, drive).unwrap_or_else(still);
        let crank_angle = position.crank.radians();
        Self {
            crank_angle: if crank_angle < 0.0 { crank_angle + 2.0 * PI } else { crank_angle },
            lever_angle: position.lever.radians(),
            angle_at_pin: position.angle_at_pin(),
            pin_distance: position.pin_distance,
            along: position.lever.direction(),
            motion,
        }
    }

    /// ω₄, counter-clockwise positive; zero where it is nothing but rounding error beside ω₂.
    pub fn lever_speed(&self, drive: &Drive<f64>) -> f64 {
        cleared(self.motion.velocities.follower_speed, drive.speed)
    }

    /// α₄, counter-clockwise positive; zero where it is nothing but rounding error.
    pub fn lever_acceleration(&self, drive: &Drive<f64>) -> f64 {
        let scale = drive.speed * drive.speed + drive.acceleration.abs();
        cleared(self.motion.accelerations.follower_acceleration, scale)
    }
}

fn still() -> Motion<f64> {
    let zero = Vector2::zeros;
    Motion {
        crank: zero(),
        velocities: PinMotion::carried(zero(), zero(), 0.0),
        pin_normal: zero(),
        pin_tangential: zero(),
        accelerations: SlotAccelerations {
            follower_normal: zero(),
            follower_tangential: zero(),
            sliding_normal: zero(),
            sliding_tangential: zero(),
            coriolis: zero(),
            follower_acceleration: 0.0,
        },
    }
}

/// `value`, or zero where it is nothing beside a value of the size of `scale`.
pub fn cleared(value: f64, scale: f64) -> f64 {
    if value.abs() <= NOTHING * scale.abs() { 0.0 } else { value }
}

/// A value with its unit, to four significant digits; zero without any.
pub fn written(value: f64, unit: &str) -> String {
    let digits = match value.abs() {
        0.0 => "0".to_owned(),
        size if (SMALL..LARGE).contains(&size) => significant(value, 4),
        _ => {
            let scientific = format!("{value:.3e}");
            let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
            format!("{mantissa}·10{}", raised(exponent))
        }
    };
    with_minus_sign(&format!("{digits} {unit}"))
}

/// A whole number in superscript digits.
fn raised(number: &str) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raise = |c: char| c.to_digit(10).and_then(|digit| digits.get(digit as usize)).copied().unwrap_or('⁻');
    number.chars().map(raise).collect()
}

/// The sense of a rate, after its value: nothing for a rate of zero.
pub fn turning(rate: f64) -> &'static str {
    match rate {
        rate if rate > 0.0 => ", counter-clockwise",
        rate if rate < 0.0 => ", clockwise",
        _ => "",
    }
}

/// The same for a label, with a hyphen that it does not take for a minus sign.
pub fn turning_label(rate: f64) -> String {
    turning(rate).replace('-', "\u{2010}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_four_digits_and_very_small_and_large_ones_a_power_of_ten() {
        let texts = [0.0, -2.5, 0.012_345, 123_456.0, -1.5e-6, 9.999_99e11].map(|value| written(value, "m"));
        assert_eq!(texts, ["0 m", "−2.500 m", "0.01235 m", "123500 m", "−1.500·10⁻⁶ m", "1.000·10¹² m"]);
    }
}
