//! A mechanism at an instant as data: what the library says of it, in the units of the command line.

use super::assembly::Assembly;
use super::instant::{Instant, Stroke};
use super::vector::Vector;
use anyhow::{Context, ensure};
use geneva_kinematics::quick_return::{Branch, Motion};
use serde::Serialize;

/// What no length, angle or speed that was let through should lead to.
const BEYOND: &str =
    "the motion there is beyond what can be computed; give other lengths, another angle or another speed";

/// All that is known of a mechanism at an instant: the keys of the JSON object.
///
/// Angles and directions are counter-clockwise from the direction lever's pivot → crank's axis, which is that of x;
/// angular velocities and accelerations are counter-clockwise positive. A vector that is zero has no direction.
#[derive(Debug, Serialize)]
pub struct QuickReturnRecord {
    pub ground_m: f64,
    pub crank_m: f64,
    pub rpm: f64,
    pub crank_speed_rad_s: f64,
    pub crank_angle_deg: f64,
    pub lever_angle_deg: f64,
    pub angle_at_pin_deg: f64,
    pub pin_distance_m: f64,
    pub branch: &'static str,
    pub stroke: &'static str,
    pub pin_velocity_m_s: Vector,
    pub lever_point_velocity_m_s: Vector,
    pub sliding_velocity_m_s: Vector,
    pub lever_speed_rad_s: f64,
    pub pin_normal_acceleration_m_s2: Vector,
    pub pin_tangential_acceleration_m_s2: Vector,
    pub lever_point_normal_acceleration_m_s2: Vector,
    pub lever_point_tangential_acceleration_m_s2: Vector,
    pub sliding_normal_acceleration_m_s2: Vector,
    pub sliding_tangential_acceleration_m_s2: Vector,
    pub coriolis_acceleration_m_s2: Vector,
    pub lever_acceleration_rad_s2: f64,
    /// `None` if the lever turns round and round.
    pub swing_limit_deg: Option<f64>,
    pub slow_stroke_deg: f64,
    pub fast_stroke_deg: f64,
    /// `None` if there is no fast stroke.
    pub time_ratio: Option<f64>,
    /// What is exactly so at the instant; the words of the sheet, and why a vector is zero.
    #[serde(skip)]
    pub instant: Instant,
}

impl QuickReturnRecord {
    /// What there is to say of a mechanism.
    pub fn new(assembly: &Assembly) -> anyhow::Result<Self> {
        let Assembly { linkage, position, rpm, drive } = assembly;
        let motion = Motion::at(&linkage.ground(), &linkage.crank(), &position.crank, drive).context(BEYOND)?;
        let instant = Instant::of(linkage, position);
        let (velocities, terms) = (&motion.velocities, &motion.accelerations);
        let [pin, lever_point, sliding] =
            [&velocities.pin_velocity, &velocities.slot_point_velocity, &velocities.sliding_velocity]
                .map(|velocity| Vector::new(velocity.x, velocity.y));
        let [pin_normal, pin_tangential] =
            [&motion.pin_normal, &motion.pin_tangential].map(|term| Vector::new(term.x, term.y));
        let [lever_normal, lever_tangential, sliding_normal, sliding_tangential, coriolis] = [
            &terms.follower_normal,
            &terms.follower_tangential,
            &terms.sliding_normal,
            &terms.sliding_tangential,
            &terms.coriolis,
        ]
        .map(|term| Vector::new(term.x, term.y));
        let greatest =
            [&pin_normal, &lever_normal, &coriolis].into_iter().map(|term| term.magnitude).fold(0.0, f64::max);

        // Three vectors are found as differences, and may be less than the rounding of what they are differences of.
        let sliding = sliding.zero_if(instant.on_centre_line).zero_below(pin.magnitude);
        let coriolis = coriolis.zero_if(instant.lever_at_rest || sliding.direction_deg.is_none());
        let lever_tangential = lever_tangential.zero_if(instant.steady_lever()).zero_below(greatest);
        let strokes = linkage.strokes();
        let record = Self {
            ground_m: linkage.ground(),
            crank_m: linkage.crank(),
            rpm: *rpm,
            crank_speed_rad_s: drive.speed,
            crank_angle_deg: unsigned_zero(position.crank.degrees()),
            lever_angle_deg: unsigned_zero(position.lever.degrees()),
            angle_at_pin_deg: position.angle_at_pin().to_degrees(),
            pin_distance_m: position.pin_distance,
            branch: match instant.branch {
                Branch::Near => "near",
                Branch::Far => "far",
            },
            stroke: instant.stroke.name(),
            pin_velocity_m_s: pin,
            lever_point_velocity_m_s: lever_point.zero_if(instant.lever_at_rest),
            sliding_velocity_m_s: sliding,
            lever_speed_rad_s: unsigned_zero(velocities.follower_speed),
            pin_normal_acceleration_m_s2: pin_normal,
            pin_tangential_acceleration_m_s2: pin_tangential,
            lever_point_normal_acceleration_m_s2: lever_normal.zero_if(instant.lever_at_rest),
            lever_point_tangential_acceleration_m_s2: lever_tangential,
            sliding_normal_acceleration_m_s2: sliding_normal,
            sliding_tangential_acceleration_m_s2: sliding_tangential
                .zero_if(instant.stroke == Stroke::End)
                .zero_below(greatest),
            coriolis_acceleration_m_s2: coriolis,
            lever_acceleration_rad_s2: unsigned_zero(terms.follower_acceleration),
            swing_limit_deg: strokes.swing_limit.map(f64::to_degrees),
            slow_stroke_deg: strokes.slow.to_degrees(),
            fast_stroke_deg: strokes.fast.to_degrees(),
            time_ratio: (strokes.fast > 0.0).then(|| strokes.time_ratio()),
            instant,
        };
        ensure!(record.is_finite(), BEYOND);
        Ok(record)
    }

    /// Whether every number is one.
    fn is_finite(&self) -> bool {
        let numbers = [
            self.crank_angle_deg,
            self.lever_angle_deg,
            self.pin_distance_m,
            self.lever_speed_rad_s,
            self.lever_acceleration_rad_s2,
        ];
        self.velocities().into_iter().chain(self.accelerations()).all(|vector| vector.magnitude.is_finite())
            && numbers.into_iter().all(f64::is_finite)
    }

    /// The pin's velocity, and the two that it is the sum of.
    pub fn velocities(&self) -> [&Vector; 3] {
        [&self.pin_velocity_m_s, &self.lever_point_velocity_m_s, &self.sliding_velocity_m_s]
    }

    /// The two terms of the pin's acceleration, and the five of the other side.
    pub fn accelerations(&self) -> [&Vector; 7] {
        [
            &self.pin_normal_acceleration_m_s2,
            &self.pin_tangential_acceleration_m_s2,
            &self.lever_point_normal_acceleration_m_s2,
            &self.lever_point_tangential_acceleration_m_s2,
            &self.sliding_normal_acceleration_m_s2,
            &self.sliding_tangential_acceleration_m_s2,
            &self.coriolis_acceleration_m_s2,
        ]
    }
}

/// Zero without the sign that a computer keeps with it.
fn unsigned_zero(value: f64) -> f64 {
    value + 0.0
}
