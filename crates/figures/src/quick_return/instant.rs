//! One instant: the kinematics of the linkage, and how its terms are called and written.

use crate::number::short;
use crate::svg::Label;
use geneva_kinematics::pin_vectors::PinMotion;
use geneva_kinematics::quick_return::{Drive, LeverMotion, Position, QuickReturn};
use geneva_kinematics::relative_motion::SlotAccelerations;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// What is so small beside the greatest of its kind is written as zero.
const NOTHING: f64 = 1e-7;

/// Position and motion of a linkage at one instant. Angles in radians, the rest in the units of the arguments.
#[derive(Clone, Debug)]
pub(super) struct LeverState {
    /// From the direction O4 → O2, in [0, 2π).
    pub crank_angle: f64,
    /// φ, in (−π, π].
    pub lever_angle: f64,
    /// β, in [0, π].
    pub angle_at_pin: f64,
    /// r.
    pub pin_distance: f64,
    /// Unit vector from the lever's pivot to the pin.
    pub along: Vector2<f64>,
    /// All vectors.
    pub motion: LeverMotion<f64>,
}

impl LeverState {
    /// The motion of a linkage at a position. With the pin on the lever's pivot nothing moves.
    pub(super) fn new(linkage: &QuickReturn, position: &Position, drive: &Drive<f64>) -> Self {
        let motion =
            LeverMotion::new(&linkage.ground(), &linkage.crank(), &position.crank, drive).unwrap_or_else(still);
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

    /// θ, from the line of centres O2 → O4, counter-clockwise positive, in [−π, π).
    pub(super) fn theta(&self) -> f64 {
        self.crank_angle - PI
    }

    /// φ′, counter-clockwise positive; zero where it is nothing but rounding error beside θ′.
    pub(super) fn lever_speed(&self, drive: &Drive<f64>) -> f64 {
        cleared(self.motion.velocities.follower_speed, drive.speed)
    }

    /// φ″, counter-clockwise positive; zero where it is nothing but rounding error.
    pub(super) fn lever_acceleration(&self, drive: &Drive<f64>) -> f64 {
        let scale = drive.speed * drive.speed + drive.acceleration.abs();
        cleared(self.motion.accelerations.follower_acceleration, scale)
    }
}

fn still() -> LeverMotion<f64> {
    let zero = Vector2::zeros;
    LeverMotion {
        crank: zero(),
        velocities: PinMotion::new(zero(), zero(), 0.0),
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
pub(super) fn cleared(value: f64, scale: f64) -> f64 {
    if value.abs() <= NOTHING * scale.abs() { 0.0 } else { value }
}

/// A value with its unit, to four significant digits; zero without any.
pub(super) fn format_with_unit(value: f64, unit: &str) -> String {
    format!("{} {unit}", short(value, 4))
}

/// The sense of a rate, after its value: nothing for a rate of zero.
pub(super) fn turning(rate: f64) -> &'static str {
    match rate {
        rate if rate > 0.0 => ", counter-clockwise",
        rate if rate < 0.0 => ", clockwise",
        _ => "",
    }
}

/// The sense of a rate as a label writes it: with a hyphen that the label does not take for a minus sign.
pub(super) fn turning_label(rate: f64) -> String {
    turning(rate).replace('-', "\u{2010}")
}

/// Velocity of the pin, "2", of the lever's point under it, "4", or of the one relative to the other, "rel".
pub(super) fn v(of: &str) -> Label {
    Label::symbol("v").sub(of)
}

/// A part of the acceleration of the same: normal, n, or tangential, t.
pub(super) fn a(part: &str, of: &str) -> Label {
    Label::symbol("a").sup(part).sub(of)
}

/// The Coriolis acceleration.
pub(super) fn coriolis() -> Label {
    Label::symbol("a").sub("Cor")
}

/// Rate of the angle of the crank, θ, or of the lever, φ.
pub(super) fn rate_of(angle: &str) -> Label {
    Label::rate(angle, 1).of_part(&format!("{angle}'"))
}

/// Angular acceleration of the lever.
pub(super) fn lever_acceleration() -> Label {
    Label::rate("φ", 2)
}

/// The number of a vector in its series, its components, its magnitude and its direction in degrees.
///
/// The direction is counted counter-clockwise from O4 → O2; that of a vector that is nothing beside `scale` is zero.
pub(super) fn row(number: usize, vector: &Vector2<f64>, scale: f64) -> [f64; 5] {
    let magnitude = libm::hypot(vector.x, vector.y);
    let direction = if cleared(magnitude, scale) == 0.0 { 0.0 } else { libm::atan2(vector.y, vector.x).to_degrees() };
    [number as f64, vector.x, vector.y, magnitude, direction]
}
