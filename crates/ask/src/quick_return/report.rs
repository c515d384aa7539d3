//! The report on a mechanism at an instant, and which way everything points and turns.

use super::QuickReturnDesign;
use super::instant::{LeverInstant, NOT_TOLD, Stroke};
use super::vector::Vector;
use crate::number_format::as_typed;
use crate::{Error, MechanismReport, ReportField};
use geneva_kinematics::quick_return::{Branch, LeverMotion, Position, Strokes};

/// What the numbers are measured from, and what adds up.
const INTRODUCTION: &str = "\
Angles and directions are counter-clockwise from the direction that points from the lever's pivot to the crank's axis. \
The crank turns at constant speed. The pin's velocity is the velocity of the lever's point under it plus its sliding \
velocity in the slot. The two terms of its acceleration add up to the terms of the lever's point, of the sliding and of \
Coriolis.";

/// The error that no accepted length, angle or speed should lead to.
pub(super) const BEYOND: &str =
    "the motion there is too large or too small to compute; give other lengths, another angle or another speed";

/// Which way a vector points.
enum Way<'a> {
    /// Outwards or inwards, seen from the lever's pivot.
    Along,
    /// The way in which it turns its point about the lever's pivot.
    Across,
    /// The way that this text says.
    Is(&'a str),
}
use Way::{Across, Along, Is};

/// The instant, with the motion of the lever.
struct Seen {
    instant: LeverInstant,
    /// Speed of the crank in rad/s, counter-clockwise positive.
    crank_speed: f64,
    /// Direction of the lever, in degrees.
    lever_deg: f64,
    /// Angular velocity of the lever in rad/s, counter-clockwise positive.
    lever_speed: f64,
    /// Angular acceleration of the lever in rad/s², counter-clockwise positive.
    lever_acceleration: f64,
}

impl QuickReturnDesign {
    /// The answer.
    ///
    /// Angles and directions are counter-clockwise from the direction lever's pivot → crank's axis, which is that of x;
    /// angular velocities and accelerations are counter-clockwise positive. A vector that is zero has no direction.
    ///
    /// # Errors
    ///
    /// Lengths, angles or speeds that are too large or too small to compute with.
    pub fn answer(&self) -> Result<MechanismReport, Error> {
        let Self { linkage, position, drive, speed, .. } = self;
        let beyond = || refused!("{BEYOND}");
        let motion =
            LeverMotion::new(&linkage.ground(), &linkage.crank(), &position.crank, drive).ok_or_else(beyond)?;
        let seen = Seen {
            instant: LeverInstant::new(linkage, position),
            crank_speed: drive.speed,
            lever_deg: unsigned_zero(position.lever.degrees()),
            lever_speed: unsigned_zero(motion.velocities.follower_speed),
            lever_acceleration: unsigned_zero(motion.accelerations.follower_acceleration),
        };
        let mut given = vec![
            ReportField::in_unit("ground_m", linkage.ground(), "m"),
            ReportField::in_unit("crank_m", linkage.crank(), "m"),
        ];
        given.extend(speed.fields("crank_speed_rad_s"));
        let (velocities, accelerations) = seen.motion(&motion);
        let answer = MechanismReport {
            title: format!(
                "Slotted-lever quick-return mechanism: ground {} m, crank {} m, {} {} {}",
                as_typed(linkage.ground()),
                as_typed(linkage.crank()),
                as_typed(speed.value().abs()),
                speed.unit(),
                sense(speed.value())
            ),
            introduction: INTRODUCTION,
            sections: vec![
                ("Given", given),
                ("Position", seen.position(position)),
                ("Velocities", velocities),
                ("Accelerations", accelerations),
                ("Strokes", strokes(&linkage.strokes(), &seen.instant)),
            ],
            list: None,
            note: String::new(),
        };
        if answer.is_finite() { Ok(answer) } else { Err(beyond()) }
    }
}

/// Angular velocity and angular acceleration of the lever, counter-clockwise positive.
pub fn lever_motion(motion: &LeverMotion<f64>) -> [ReportField; 2] {
    let (speed, acceleration) = (motion.velocities.follower_speed, motion.accelerations.follower_acceleration);
    [
        ReportField::in_unit("lever_speed_rad_s", unsigned_zero(speed), "rad/s"),
        ReportField::in_unit("lever_acceleration_rad_s2", unsigned_zero(acceleration), "rad/s²"),
    ]
}

impl Seen {
    fn position(&self, position: &Position) -> Vec<ReportField> {
        let branch = match self.instant.branch {
            Branch::Near => "near",
            Branch::Far => "far",
        };
        vec![
            ReportField::in_unit("crank_angle_deg", unsigned_zero(position.crank.degrees()), "°")
                .line("crank angle", "direction from the crank's axis to the pin"),
            ReportField::in_unit("lever_angle_deg", self.lever_deg, "°")
                .line("lever angle", "direction from the lever's pivot to the pin"),
            ReportField::in_unit("angle_at_pin_deg", position.angle_at_pin().to_degrees(), "°")
                .line("angle at the pin", "between lever and crank"),
            ReportField::in_unit("pin_distance_m", position.pin_distance, "m")
                .line("pin distance", "from the lever's pivot to the pin"),
            ReportField::new("branch", branch).words("branch", self.instant.branch_in_words()),
            ReportField::new("stroke", self.instant.stroke.name()).words("stroke", self.instant.stroke_in_words()),
        ]
    }

    /// Velocities and accelerations.
    fn motion(&self, motion: &LeverMotion<f64>) -> (Vec<ReportField>, Vec<ReportField>) {
        let (instant, [lever_speed, lever_acceleration]) = (&self.instant, lever_motion(motion));
        let (velocities, terms) = (&motion.velocities, &motion.accelerations);
        let [pin, lever, sliding] =
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
        let lever = lever.zero_if(instant.lever_at_rest);
        let sliding = sliding.zero_if(instant.on_centre_line).zero_below(pin.magnitude);
        let pin_tangential = pin_tangential.zero_if(true);
        let lever_normal = lever_normal.zero_if(instant.lever_at_rest);
        let lever_tangential = lever_tangential.zero_if(instant.steady_lever()).zero_below(greatest);
        let sliding_normal = sliding_normal.zero_if(true);
        let sliding_tangential = sliding_tangential.zero_if(instant.stroke == Stroke::End).zero_below(greatest);
        let coriolis = coriolis.zero_if(instant.lever_at_rest || sliding.direction_deg.is_none());

        let field = |key, name, vector: &Vector, way, why_zero| self.vector(key, name, vector, way, why_zero);
        let on_circle = format!("along the crank's circle, {}", sense(self.crank_speed));
        let speed = if instant.lever_at_rest { 0.0 } else { self.lever_speed.abs() };
        let speeds = vec![
            field("pin_velocity_m_s", "pin", &pin, Is(&on_circle), NOT_TOLD),
            field("lever_point_velocity_m_s", "lever's point", &lever, Across, "the lever is at rest"),
            field("sliding_velocity_m_s", "sliding", &sliding, Along, instant.no_sliding()),
            lever_speed.line("lever, angular", self.lever_speed_in_words()).with_size(speed, String::new()),
        ];
        let still = if instant.lever_at_rest { "the lever is at rest" } else { "the pin does not slide" };
        let (constant, straight) = ("the crank turns at constant speed", "the slot is straight");
        let (steady, steady_sliding) = (instant.no_angular_acceleration(), instant.steady_sliding());
        let angular = lever_tangential.direction_deg.map_or(0.0, |_| self.lever_acceleration.abs());
        let accelerations = vec![
            field("pin_normal_acceleration_m_s2", "pin, normal", &pin_normal, Is("to the crank's axis"), NOT_TOLD),
            field("pin_tangential_acceleration_m_s2", "pin, tangential", &pin_tangential, Along, constant),
            field("lever_point_normal_acceleration_m_s2", "lever, normal", &lever_normal, Along, still),
            field("lever_point_tangential_acceleration_m_s2", "lever, tangential", &lever_tangential, Across, steady),
            field("sliding_normal_acceleration_m_s2", "sliding, normal", &sliding_normal, Across, straight),
            field(
                "sliding_tangential_acceleration_m_s2",
                "sliding, tangential",
                &sliding_tangential,
                Along,
                steady_sliding,
            ),
            field("coriolis_acceleration_m_s2", "Coriolis", &coriolis, Across, still),
            lever_acceleration
                .line("lever, angular", self.lever_acceleration_in_words(&lever_tangential))
                .with_size(angular, String::new()),
        ];
        (speeds, accelerations)
    }

    /// A vector: why it is zero, if it is, or else which way it points.
    fn vector(&self, key: &'static str, name: &'static str, vector: &Vector, way: Way, why_zero: &str) -> ReportField {
        let unit = if key.ends_with("_s2") { "m/s²" } else { "m/s" };
        let Some(degrees) = vector.direction_deg else {
            return ReportField::in_unit(key, vector, unit)
                .line(name, format!("zero: {why_zero}"))
                .with_size(0.0, String::new());
        };
        // Seen from the lever's direction, between −180° and 180°.
        let turned = degrees - self.lever_deg;
        let apart = turned - 360.0 * (turned / 360.0).round();
        let way = match way {
            Along if apart.abs() < 90.0 => "along the lever, outwards from its pivot".to_owned(),
            Along => "along the lever, inwards to its pivot".to_owned(),
            Across => format!("across the lever, {}", sense(apart)),
            Is(way) => way.to_owned(),
        };
        ReportField::in_unit(key, vector, unit)
            .line(name, way)
            .with_size(vector.magnitude, format!("at {:>7}°", direction(degrees)))
    }

    /// The sense of the lever's angular velocity, in words.
    fn lever_speed_in_words(&self) -> String {
        if self.instant.lever_at_rest {
            return "zero: the lever is at the end of its swing".to_owned();
        }
        let with = if self.lever_speed * self.crank_speed.signum() > 0.0 { "with" } else { "against" };
        format!("{}, {with} the crank", sense(self.lever_speed))
    }

    /// The sense and effect of the lever's angular acceleration, in words.
    fn lever_acceleration_in_words(&self, tangential: &Vector) -> String {
        let turning = sense(self.lever_acceleration);
        if tangential.direction_deg.is_none() {
            return format!("zero: {}", self.instant.no_angular_acceleration());
        }
        if self.instant.lever_at_rest {
            return format!("{turning}: the lever starts on its way back");
        }
        let slows = (self.lever_speed > 0.0) != (self.lever_acceleration > 0.0);
        format!("{turning}: the lever {}", if slows { "slows down" } else { "speeds up" })
    }
}

fn strokes(strokes: &Strokes, instant: &LeverInstant) -> Vec<ReportField> {
    let time_ratio = (strokes.fast > 0.0).then(|| strokes.time_ratio());
    let swing = ReportField::in_unit("swing_limit_deg", strokes.swing_limit.map(f64::to_degrees), "°");
    let swing = match strokes.swing_limit {
        None => swing
            .words("swing", "none: the crank is longer than the ground distance, so the lever turns round and round"),
        Some(_) if instant.half_speed => swing.words(
            "swing",
            "none: the crank is as long as the ground distance, so the pin passes through the lever's pivot at 180°, \
             where the lever has no direction",
        ),
        Some(_) => swing.line("swing limit", "greatest lever angle, to either side"),
    };
    let mut slow = ReportField::in_unit("slow_stroke_deg", strokes.slow.to_degrees(), "°");
    let mut fast = ReportField::in_unit("fast_stroke_deg", strokes.fast.to_degrees(), "°");
    let mut ratio = ReportField::new("time_ratio", time_ratio);
    if time_ratio.is_some() {
        slow = slow.line("slow stroke", "of a turn of the crank");
        fast = fast.line("fast stroke", "of a turn of the crank");
        ratio = ratio.line("time ratio", "time of the slow stroke over the time of the fast stroke");
    } else {
        ratio = ratio.words("time ratio", "none: there is no fast stroke");
    }
    vec![swing, slow, fast, ratio]
}

/// The direction of a vector in degrees, from above −180 to 180, with as many decimals as its neighbours in a column.
fn direction(degrees: f64) -> String {
    match format!("{degrees:.2}").as_str() {
        "-0.00" => "0.00".to_owned(),
        "-180.00" => "180.00".to_owned(),
        written => geneva_figures::with_minus_sign(written),
    }
}

/// Which way an angular velocity or acceleration turns.
fn sense(turning: f64) -> &'static str {
    if turning > 0.0 { "counter-clockwise" } else { "clockwise" }
}

/// Zero without the sign that a computer keeps with it.
fn unsigned_zero(value: f64) -> f64 {
    value + 0.0
}

#[cfg(test)]
mod tests {
    use super::direction;

    #[test]
    fn a_direction_that_is_rounded_to_nothing_or_to_a_half_turn_has_no_sign() {
        assert_eq!([-1e-3, -179.999, -7.5].map(direction), ["0.00", "180.00", "−7.50"]);
    }
}
