//! The wheel at crank angles: every degree of a turn of the driver, or the angles that were asked for.

use super::WheelQuestion;
use super::design::{WheelDesign, too_large};
use crate::number_format::{as_typed, rounded_down};
use crate::{DataRow, Error, Item, ReportField};
use geneva_dynamics::wheel_loads::Load;
use geneva_kinematics::indexing::{Phase, PinInSlot, WheelMotion};

/// Degrees of half a turn.
const HALF_TURN: i32 = 180;

/// Most angles at which the motion is reported at once.
const MOST_INSTANTS: usize = 10_000;

/// The wheel at one crank angle.
struct WheelState {
    /// Crank angle in degrees.
    degrees: f64,
    motion: WheelMotion,
    /// None in the dwell, as of the load.
    pin: Option<PinInSlot>,
    load: Option<Load>,
}

impl WheelState {
    /// The wheel at this crank angle in degrees, counted from the middle of the first index, in any turn.
    fn new(design: &WheelDesign, degrees: f64) -> Result<Self, Error> {
        let wheel = design.wheel.indexing();
        let turns = libm::round(degrees / 360.0);
        let crank = (degrees - 360.0 * turns).to_radians();
        let motion = wheel.motion(turns as i64, crank)?;
        let from_pin = wheel.nearest_pin(crank).1;
        let is_engaged = motion.phase == Phase::Advance;
        let loads = design.loads(wheel)?.filter(|_| is_engaged);
        Ok(Self {
            degrees,
            motion,
            pin: is_engaged.then(|| wheel.pin_in_slot(within(wheel.engagement_half_angle(), from_pin))).transpose()?,
            load: loads.map(|loads| loads.load(within(wheel.engagement_half_angle(), from_pin))).transpose()?,
        })
    }

    /// Wheel angle in degrees from the middle of the first index.
    fn wheel_angle(&self, design: &WheelDesign) -> f64 {
        let step = 360.0 / f64::from(design.wheel.indexing().stations());
        self.motion.stations as f64 * step + self.motion.angle.to_degrees()
    }

    /// Everything reported about it. What has no line is only in the data.
    fn fields(&self, design: &WheelDesign) -> Fields {
        let (motion, pin, load) = (&self.motion, self.pin, self.load);
        let speed = design.speed();
        let is_engaged = motion.phase == Phase::Advance;
        let (phase, meaning) =
            if is_engaged { ("index", "a pin is in a slot") } else { ("dwell", "dwell: the wheel is locked") };
        let rated = |ratio: f64, power: i32| speed.map(|speed| (0..power).fold(ratio, |rate, _| rate * speed));
        let time = speed.map(|speed| self.degrees.to_radians() / speed);
        Fields {
            place: vec![
                ReportField::in_unit("crank_angle_deg", self.degrees, "°").line("crank angle", meaning),
                ReportField::new("phase", phase),
                ReportField::in_unit("wheel_angle_deg", self.wheel_angle(design), "°")
                    .line("wheel angle", "from the middle of the index at crank angle zero"),
                ReportField::in_unit("pin_radius_ratio", pin.map(|pin| pin.radius), "× crank radius")
                    .line("pin", "from the wheel's axis"),
            ],
            ratios: vec![
                ReportField::in_unit("velocity_ratio", motion.velocity, "× driver speed").line("velocity", ""),
                ReportField::in_unit("acceleration_ratio", motion.acceleration, "× driver speed²")
                    .line("acceleration", ""),
                ReportField::in_unit("jerk_ratio", motion.jerk, "× driver speed³").line("jerk", ""),
            ],
            along_the_slot: vec![
                ReportField::in_unit("sliding_ratio", pin.map(|pin| pin.sliding), "× pin speed")
                    .line("sliding", "along the slot; negative while the pin goes in"),
                ReportField::in_unit("coriolis_ratio", pin.map(|pin| pin.coriolis), "× pin's own")
                    .line("Coriolis", "acceleration of the pin, over its acceleration on the crank circle"),
            ],
            time: ReportField::in_unit("time_s", time, "s"),
            rates: vec![
                ReportField::in_unit("wheel_speed_rad_s", rated(motion.velocity, 1), "rad/s").in_other_unit(),
                ReportField::in_unit("wheel_acceleration_rad_s2", rated(motion.acceleration, 2), "rad/s²")
                    .in_other_unit(),
                ReportField::in_unit("wheel_jerk_rad_s3", rated(motion.jerk, 3), "rad/s³").in_other_unit(),
            ],
            load: vec![
                ReportField::in_unit("wheel_torque_nm", load.map(|load| load.wheel_torque), "N m")
                    .line("wheel torque", "positive while the pin drives the wheel"),
                ReportField::in_unit("pin_force_n", load.and_then(|load| design.force(load.pin_moment)), "N")
                    .line("pin force", "at right angles to the slot"),
                ReportField::in_unit("crank_torque_nm", load.map(|load| load.crank_torque), "N m")
                    .line("crank torque", ""),
                ReportField::in_unit("power_w", load.map(|load| load.power), "W").line("power", ""),
            ],
        }
    }
}

/// What is reported of an instant.
struct Fields {
    place: Vec<ReportField>,
    ratios: Vec<ReportField>,
    along_the_slot: Vec<ReportField>,
    time: ReportField,
    /// The ratios at the driver's speed, in their order.
    rates: Vec<ReportField>,
    load: Vec<ReportField>,
}

impl Fields {
    /// As data: what is known without a speed comes first.
    fn into_row(self) -> DataRow {
        let Self { place, ratios, along_the_slot, time, rates, load } = self;
        let all = place.into_iter().chain(ratios).chain(along_the_slot).chain([time]).chain(rates).chain(load);
        DataRow(all.map(|field| (field.key, field.value)).collect())
    }

    /// On a sheet: each rate under its ratio. Of a wheel at rest there is only its place to tell.
    fn into_lines(self, is_at_rest: bool) -> Vec<ReportField> {
        let Self { place, ratios, along_the_slot, rates, load, .. } = self;
        let moving = ratios.into_iter().zip(rates).flat_map(<[ReportField; 2]>::from).chain(along_the_slot).chain(load);
        place.into_iter().chain(moving.filter(|_| !is_at_rest)).collect()
    }
}

/// An angle that rounding may have taken a little beyond the ends, within them.
fn within(most: f64, angle: f64) -> f64 {
    angle.clamp(-most, most)
}

/// The wheel at one crank angle, as one of a list.
pub(super) fn item(design: &WheelDesign, degrees: f64) -> Result<Item, Error> {
    let instant = WheelState::new(design, degrees)?;
    let fields = instant.fields(design).into_lines(instant.pin.is_none());
    Ok(Item { heading: "At a crank angle", fields, row: instant.fields(design).into_row() })
}

impl WheelDesign {
    /// The crank angles in degrees at which to report the motion.
    pub(super) fn angles(&self) -> Result<Vec<f64>, Error> {
        let WheelQuestion { at, at_wheel, .. } = &self.question;
        let asked = at.len() + at_wheel.len();
        if asked > MOST_INSTANTS {
            return Err(refused!(
                "--at and --at-wheel give {asked} angles, but at most {MOST_INSTANTS} can be reported at once; give fewer, or \
                 none with --format csv, which has a row for each degree"
            ));
        }
        let wheel = self.wheel.indexing();
        let most = 180.0 / f64::from(wheel.stations());
        let of_the_wheel = at_wheel.iter().map(|degrees| {
            if degrees.abs() > most {
                return Err(refused!(
                    "--at-wheel {}: during an index the wheel turns from −{most}° to {most}°; give an angle in this range",
                    as_typed(*degrees),
                    most = rounded_down(most)
                ));
            }
            Ok(wheel.crank_at(degrees.to_radians())?.to_degrees())
        });
        at.iter().map(|degrees| Ok(*degrees)).chain(of_the_wheel).collect()
    }

    /// The cycle: a row for each degree of a turn of the driver, both ends included, or for each angle of the question.
    ///
    /// # Errors
    ///
    /// Angles that the wheel doesn't have, and numbers that are too large or too small to compute with.
    pub fn cycle(&self) -> Result<Vec<DataRow>, Error> {
        let angles = self.angles()?;
        let angles = if angles.is_empty() { (-HALF_TURN..=HALF_TURN).map(f64::from).collect() } else { angles };
        let rows = angles.into_iter().map(|degrees| Ok(WheelState::new(self, degrees)?.fields(self).into_row()));
        let rows = rows.collect::<Result<Vec<_>, Error>>()?;
        match rows.iter().flat_map(|row| &row.0).find(|(_, value)| !value.is_finite()) {
            None => Ok(rows),
            Some((key, _)) => Err(too_large(key)),
        }
    }
}
