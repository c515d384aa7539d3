//! The wheel at crank angles: every degree of a turn of the driver, or the angles that were asked for.

use super::design::Design;
use super::report::too_large;
use crate::{Error, Field, Item, Row, Value};
use geneva_dynamics::wheel_loads::Load;
use geneva_kinematics::indexing::PinInSlot;
use geneva_kinematics::wheel::{Motion, Phase};

/// Degrees of half a turn.
const HALF_TURN: i32 = 180;

/// The wheel at one crank angle.
struct Instant {
    /// Crank angle in degrees.
    degrees: f64,
    motion: Motion,
    /// None in the dwell, as of the load.
    pin: Option<PinInSlot>,
    load: Option<Load>,
}

impl Instant {
    /// The wheel at this crank angle in degrees, counted from the middle of the first index, in any turn.
    fn new(design: &Design, degrees: f64) -> Result<Self, Error> {
        let wheel = design.wheel.indexing();
        let turns = libm::round(degrees / 360.0);
        let crank = (degrees - 360.0 * turns).to_radians();
        let motion = wheel.at(turns as i64, crank)?;
        let from_pin = wheel.nearest_pin(crank).1;
        let is_engaged = motion.phase == Phase::Advance;
        let loads = design.loads(wheel)?.filter(|_| is_engaged);
        Ok(Self {
            degrees,
            motion,
            pin: is_engaged.then(|| wheel.pin_in_slot(within(wheel.engagement_half_angle(), from_pin))).transpose()?,
            load: loads.map(|loads| loads.at(within(wheel.engagement_half_angle(), from_pin))).transpose()?,
        })
    }

    /// Wheel angle in degrees from the middle of the first index.
    fn wheel_angle(&self, design: &Design) -> f64 {
        let step = 360.0 / f64::from(design.wheel.indexing().stations());
        self.motion.stations as f64 * step + self.motion.angle.to_degrees()
    }

    /// Everything reported about it.
    fn row(&self, design: &Design) -> Row {
        let (motion, pin, load) = (&self.motion, self.pin, self.load);
        let speed = design.speed();
        let phase = if motion.phase == Phase::Advance { "index" } else { "dwell" };
        let rated = |ratio: f64, power: i32| speed.map(|speed| (0..power).fold(ratio, |rate, _| rate * speed));
        Row(vec![
            ("crank_angle_deg", self.degrees.into()),
            ("phase", phase.into()),
            ("wheel_angle_deg", self.wheel_angle(design).into()),
            ("pin_radius_ratio", pin.map(|pin| pin.radius).into()),
            ("velocity_ratio", motion.velocity.into()),
            ("acceleration_ratio", motion.acceleration.into()),
            ("jerk_ratio", motion.jerk.into()),
            ("sliding_ratio", pin.map(|pin| pin.sliding).into()),
            ("coriolis_ratio", pin.map(|pin| pin.coriolis).into()),
            ("time_s", speed.map(|speed| self.degrees.to_radians() / speed).into()),
            ("wheel_speed_rad_s", rated(motion.velocity, 1).into()),
            ("wheel_acceleration_rad_s2", rated(motion.acceleration, 2).into()),
            ("wheel_jerk_rad_s3", rated(motion.jerk, 3).into()),
            ("wheel_torque_nm", load.map(|load| load.wheel_torque).into()),
            ("pin_force_n", load.and_then(|load| design.force(load.pin_moment)).into()),
            ("crank_torque_nm", load.map(|load| load.crank_torque).into()),
            ("power_w", load.map(|load| load.power).into()),
        ])
    }

    /// Its lines on a sheet.
    fn lines(&self, design: &Design) -> Vec<Field> {
        let phase = if self.pin.is_some() { "a pin is in a slot" } else { "dwell: the wheel is locked" };
        let told = [
            ("crank_angle_deg", "crank angle", "°", phase),
            ("wheel_angle_deg", "wheel angle", "°", "from the middle of the index at crank angle zero"),
            ("pin_radius_ratio", "pin", "× crank radius", "from the wheel's axis"),
            ("velocity_ratio", "velocity", "× driver speed", ""),
            ("wheel_speed_rad_s", "", "rad/s", ""),
            ("acceleration_ratio", "acceleration", "× driver speed²", ""),
            ("wheel_acceleration_rad_s2", "", "rad/s²", ""),
            ("jerk_ratio", "jerk", "× driver speed³", ""),
            ("wheel_jerk_rad_s3", "", "rad/s³", ""),
            ("sliding_ratio", "sliding", "× pin speed", "along the slot; negative while the pin goes in"),
            (
                "coriolis_ratio",
                "Coriolis",
                "× pin's own",
                "acceleration of the pin, over its acceleration on the crank circle",
            ),
            ("wheel_torque_nm", "wheel torque", "N m", "positive while the pin drives the wheel"),
            ("pin_force_n", "pin force", "N", "at right angles to the slot"),
            ("crank_torque_nm", "crank torque", "N m", ""),
            ("power_w", "power", "W", ""),
        ];
        let Row(row) = self.row(design);
        let value =
            |key: &str| row.iter().find(|(known, _)| *known == key).map_or(Value::Missing, |(_, value)| value.clone());
        // Of a wheel at rest there is only its angle to tell.
        let told = told.into_iter().take(if self.pin.is_some() { usize::MAX } else { 2 });
        told.map(|(key, name, unit, of)| Field::in_unit(key, value(key), unit).line(name, of)).collect()
    }
}

/// An angle that rounding may have taken a little beyond the ends, within them.
fn within(most: f64, angle: f64) -> f64 {
    angle.clamp(-most, most)
}

/// The wheel at one crank angle, as one of a list.
pub(super) fn item(design: &Design, degrees: f64) -> Result<Item, Error> {
    let instant = Instant::new(design, degrees)?;
    Ok(Item { heading: "At a crank angle", fields: instant.lines(design), row: instant.row(design) })
}

impl Design {
    /// The cycle: a row for each degree of a turn of the driver, both ends included, or for each angle of the question.
    ///
    /// # Errors
    ///
    /// Angles that the wheel doesn't have, and numbers that are too large or too small to compute with.
    pub fn cycle(&self) -> Result<Vec<Row>, Error> {
        let angles = self.angles()?;
        let angles = if angles.is_empty() { (-HALF_TURN..=HALF_TURN).map(f64::from).collect() } else { angles };
        let rows = angles.into_iter().map(|degrees| Ok(Instant::new(self, degrees)?.row(self)));
        let rows = rows.collect::<Result<Vec<_>, Error>>()?;
        let is_finite = rows.iter().flat_map(|row| &row.0).all(|(_, value)| value.is_finite());
        if is_finite { Ok(rows) } else { Err(too_large()) }
    }
}
