//! Which way in words: senses of rotation, directions along and across, what the lever does.

use super::instant::{Instant, Stroke};
use super::record::QuickReturnRecord;
use super::vector::Vector;
use geneva_kinematics::quick_return::Branch;

/// Why a vector is zero that need not be.
const NOT_TOLD: &str = "too small to tell from zero";

/// Which way an angular velocity or acceleration turns.
pub fn sense(turning: f64) -> &'static str {
    if turning > 0.0 { "counter-clockwise" } else { "clockwise" }
}

/// Which way a vector along the lever points, seen from the lever's pivot.
pub fn along(vector: &Vector, record: &QuickReturnRecord) -> String {
    match vector.direction_deg {
        None => NOT_TOLD.to_owned(),
        Some(direction) if apart(direction, record).abs() < 90.0 => {
            "along the lever, outwards from its pivot".to_owned()
        }
        Some(_) => "along the lever, inwards to its pivot".to_owned(),
    }
}

/// Which way a vector across the lever turns the point at which it is about the lever's pivot.
pub fn across(vector: &Vector, record: &QuickReturnRecord) -> String {
    match vector.direction_deg {
        None => NOT_TOLD.to_owned(),
        Some(direction) => format!("across the lever, {}", sense(apart(direction, record))),
    }
}

/// A direction seen from the lever's, between −180° and 180°.
fn apart(direction: f64, record: &QuickReturnRecord) -> f64 {
    let turned = direction - record.lever_angle_deg;
    turned - 360.0 * (turned / 360.0).round()
}

/// Which of the points on its ray the pin is at.
pub fn branch(instant: &Instant) -> &'static str {
    match instant.branch {
        _ if instant.lever_at_rest => "near and far in one: the lever is tangent to the crank's circle",
        _ if !instant.swings => "far: the lever's ray meets the crank's circle in one point only",
        Branch::Near => "near: of the two places on the lever's ray, the one nearer to its pivot",
        Branch::Far => "far: of the two places on the lever's ray, the one farther from its pivot",
    }
}

/// Which stroke the lever is on, and what that means.
pub fn stroke(instant: &Instant) -> &'static str {
    match (instant.stroke, instant.swings) {
        (Stroke::End, true) => "between the two: the lever reverses at the end of its swing",
        (Stroke::Slow, true) => "slow: the lever turns with the crank",
        (Stroke::Fast, true) => "fast: the lever turns against the crank",
        _ if instant.half_speed => "the only one: the lever turns with the crank, at half its speed",
        (Stroke::End, false) => "between the two: the lever is at right angles to the line of centres",
        (Stroke::Slow, false) => "slow: the lever is on the side of the crank's axis",
        (Stroke::Fast, false) => "fast: the lever is on the side away from the crank's axis",
    }
}

/// What the lever's angular velocity is like.
pub fn lever_speed(record: &QuickReturnRecord) -> String {
    if record.instant.lever_at_rest {
        return "zero: the lever is at the end of its swing".to_owned();
    }
    let with = if record.lever_speed_rad_s * record.rpm.signum() > 0.0 { "with" } else { "against" };
    format!("{}, {with} the crank", sense(record.lever_speed_rad_s))
}

/// What the lever's angular acceleration does.
pub fn lever_acceleration(record: &QuickReturnRecord) -> String {
    let turning = sense(record.lever_acceleration_rad_s2);
    if record.lever_point_tangential_acceleration_m_s2.direction_deg.is_none() {
        return format!("zero: {}", steady(&record.instant));
    }
    if record.instant.lever_at_rest {
        return format!("{turning}: it starts on its way back");
    }
    let slows = (record.lever_speed_rad_s > 0.0) != (record.lever_acceleration_rad_s2 > 0.0);
    format!("{turning}: the lever {}", if slows { "slows down" } else { "speeds up" })
}

/// Why the lever neither speeds up nor slows down.
pub fn steady(instant: &Instant) -> &'static str {
    match instant {
        Instant { half_speed: true, .. } => "the lever turns at half the crank's speed",
        Instant { on_centre_line: true, .. } => "the pin is on the line of centres",
        _ => NOT_TOLD,
    }
}

/// Why the pin does not slide.
pub fn no_sliding(instant: &Instant) -> &'static str {
    if instant.on_centre_line { "the pin is on the line of centres" } else { NOT_TOLD }
}

/// Why the sliding neither speeds up nor slows down.
pub fn steady_sliding(instant: &Instant) -> &'static str {
    match (instant.stroke, instant.swings) {
        (Stroke::End, true) => "the lever is at rest, the crank across it",
        (Stroke::End, false) => "the lever turns as fast as the crank",
        _ => NOT_TOLD,
    }
}
