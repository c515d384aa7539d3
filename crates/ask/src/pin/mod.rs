//! A pin in the slot of a Geneva wheel at an instant: how fast the wheel turns and the pin slides, with every step of the
//! solution.
//!
//! Notation: `R` crank radius, `l` centre distance, `k = l/R`; θ crank angle from the line of centres, counted in the driver's
//! sense; φ wheel angle, counted in the opposite sense; r distance of the pin from the wheel's axis; γ angle between the
//! pin's velocity and the slot.

mod steps;

use crate::number_format::{as_typed, rounded_down};
use crate::worked::{AngleOrigin, DriverSpeed, LengthUnit, without_rounding};
use crate::{Error, MechanismReport, ReportField, Rounding, number, pairs};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use geneva_kinematics::pin_triangle::{TriangleSolution, solve};
use geneva_kinematics::wheel::{STATIONS, acceleration_ratio};
use std::f64::consts::PI;

/// What is asked of a pin in a slot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinQuestion {
    /// Distance of the pin's centre from the driver's axis, above zero, in `unit`.
    pub crank_radius: f64,
    /// How far apart the axes are.
    pub axes: AxisDistance,
    /// The crank's angle in degrees, counted in the sense in which the driver turns.
    pub angle: f64,
    /// From which line the angle is counted.
    pub origin: AngleOrigin,
    /// The driver's constant speed, above zero.
    pub speed: DriverSpeed,
    /// The unit of all lengths.
    pub unit: LengthUnit,
}

/// How far apart the two axes are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AxisDistance {
    /// By this length, greater than the crank radius, in the unit of the crank radius.
    Length(f64),
    /// As a wheel with so many slots needs it that is at rest when the pin enters: R / sin(180°/N).
    Stations(u32),
}

impl PinQuestion {
    /// Reads arguments as they are typed: `--crank-radius 40 --stations 6 --angle -20 --rad-s 8`.
    ///
    /// # Errors
    ///
    /// An argument that there is not, one that is missing, and a value that it can't have.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let [mut crank_radius, mut axes, mut angle, mut speed, mut unit] = [const { None }; 5];
        for pair in pairs(text) {
            let (name, value) = pair?;
            let place = match name {
                "crank-radius" => &mut crank_radius,
                "centre-distance" | "stations" => &mut axes,
                "angle" | "angle-from-extension" => &mut angle,
                "rpm" | "rad-s" => &mut speed,
                "unit" => &mut unit,
                _ => {
                    return Err(refused!(
                        "--{name} {value}: give --crank-radius, --centre-distance or --stations, --angle or \
                         --angle-from-extension, --rpm or --rad-s, and --unit"
                    ));
                }
            };
            *place = Some((name, value));
        }
        let missing = |name: &str| refused!("--{name} is missing; give it");
        let (axes, axes_value) = axes.ok_or_else(|| missing("centre-distance"))?;
        let (origin, angle) = angle.ok_or_else(|| missing("angle"))?;
        let (per, speed) = speed.ok_or_else(|| missing("rpm"))?;
        Ok(Self {
            crank_radius: number("crank-radius", crank_radius.ok_or_else(|| missing("crank-radius"))?.1)?,
            axes: match axes {
                "stations" => AxisDistance::Stations(number(axes, axes_value)?),
                _ => AxisDistance::Length(number(axes, axes_value)?),
            },
            angle: number(origin, angle)?,
            origin: match origin {
                "angle" => AngleOrigin::LineOfCentres,
                _ => AngleOrigin::Extension,
            },
            speed: match per {
                "rpm" => DriverSpeed::Rpm(number(per, speed)?),
                _ => DriverSpeed::RadiansPerSecond(number(per, speed)?),
            },
            unit: unit.map_or(Ok(LengthUnit::Millimetre), |(_, unit)| LengthUnit::parse(unit))?,
        })
    }
}

/// A pin in a slot at an instant, as its question describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct PinDesign {
    question: PinQuestion,
    /// The lengths, in the question's unit.
    pub mechanism: PinSlot,
    /// θ in degrees, negative before the line of centres.
    pub theta: f64,
    /// The triangle of the two axes and the pin on the side where θ is positive, and its speeds.
    triangle: TriangleSolution,
    /// The wheel's angular acceleration in rad/s², positive in the sense in which the wheel turns.
    acceleration: f64,
}

/// Degrees by which an angle may be beyond the engagement: the rounding of a typed end.
const AT_THE_END: f64 = 1e-9;

/// Speeds in rad/s that can be computed with.
const SPEEDS: std::ops::RangeInclusive<f64> = 1e-30..=1e30;

impl PinDesign {
    /// The pin that a question describes.
    ///
    /// # Errors
    ///
    /// What is impossible, with the arguments to change: lengths and speeds that are not above zero, axes that are too near, a
    /// number of slots out of range, and an angle at which the pin is not in the slot.
    pub fn new(question: &PinQuestion) -> Result<Self, Error> {
        let radius = question.crank_radius;
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(refused!("--crank-radius {}: not a length above zero; give one", as_typed(radius)));
        }
        let centres = match question.axes {
            AxisDistance::Length(length) if length > radius && length.is_finite() => length,
            AxisDistance::Length(length) => {
                return Err(refused!(
                    "--centre-distance {}: the wheel's axis must be outside the pin's circle; give more than --crank-radius {}",
                    as_typed(length),
                    as_typed(radius)
                ));
            }
            AxisDistance::Stations(slots) if STATIONS.contains(&slots) => radius / libm::sin(PI / f64::from(slots)),
            AxisDistance::Stations(slots) => {
                return Err(refused!("--stations {slots}: give {} to {}", STATIONS.start(), STATIONS.end()));
            }
        };
        let speed = question.speed.radians_per_second();
        if !SPEEDS.contains(&speed) {
            let option = if matches!(question.speed, DriverSpeed::Rpm(_)) { "--rpm" } else { "--rad-s" };
            let given = as_typed(question.speed.value());
            return Err(refused!("{option} {given}: the driver must turn; give a speed above zero"));
        }
        let mechanism = PinSlot::new(radius, centres)?;
        let theta = question.origin.from_line_of_centres(question.angle);
        let half = mechanism.engagement_half_angle().to_degrees();
        if theta.is_nan() || theta.abs() > half + AT_THE_END {
            return Err(outside(question, half));
        }
        let size = theta.abs().min(half);
        let triangle = solve(&mechanism, &Turn::from_degrees(size), speed);
        let ratio = mechanism.ratio();
        let acceleration = acceleration_ratio(&ratio, &Turn::from_degrees(theta)) * speed * speed;
        let numbers = [triangle.slot_radius, triangle.pin_speed, triangle.follower_speed, acceleration];
        if numbers.iter().any(|value| !value.is_finite()) {
            return Err(refused!("these numbers are too large or too small to compute with; give others"));
        }
        Ok(Self { question: *question, mechanism, theta, triangle, acceleration })
    }

    /// The wheel's angular velocity in rad/s, in the sense against the driver; zero as the pin enters and leaves.
    pub fn wheel_speed(&self) -> f64 {
        without_rounding(self.triangle.follower_speed, self.speed())
    }

    /// The pin's speed along the slot, towards the wheel's axis positive, in the question's unit a second.
    pub fn sliding_speed(&self) -> f64 {
        let size = without_rounding(self.triangle.sliding_speed, self.triangle.pin_speed);
        if self.theta > 0.0 { -size + 0.0 } else { size }
    }

    /// The wheel's angular acceleration in rad/s², positive while the wheel speeds up.
    pub fn wheel_acceleration(&self) -> f64 {
        without_rounding(self.acceleration, self.speed() * self.speed())
    }

    /// The driver's speed in rad/s.
    pub fn speed(&self) -> f64 {
        self.question.speed.radians_per_second()
    }

    /// The answer.
    pub fn answer(&self) -> MechanismReport {
        let PinQuestion { unit, speed, .. } = self.question;
        let radius = self.mechanism.crank_radius();
        let TriangleSolution { slot_radius, angle_at_pivot, velocity_angle, pin_speed, .. } = self.triangle;
        let length = |key, value: f64| ReportField::in_unit(key, value, unit.name()).rounded(Rounding::Significant(4));
        let rate = |key, value: f64| ReportField::in_unit(key, value, unit.speed());
        let degrees = |key, value: f64| ReportField::in_unit(key, value, "°");
        let sign = if self.theta < 0.0 { -1.0 } else { 1.0 };
        let gamma = without_rounding(velocity_angle, 1.0).to_degrees();
        let across = without_rounding(self.triangle.slot_point_speed, pin_speed);
        let (sliding, acceleration) = (self.sliding_speed(), self.wheel_acceleration());
        let mut given = vec![ReportField::new("length_unit", unit.name()), length("crank_radius", radius)];
        given.extend(speed.fields("driver_speed_rad_s"));
        let position = vec![
            length("centre_distance", self.mechanism.centre_distance())
                .line("centre distance l", "between the two axes"),
            degrees("crank_angle_deg", self.theta)
                .line("crank angle θ", "from the line of centres, negative before it"),
            length("pin_distance", slot_radius).line("pin distance r", "from the wheel's axis to the pin"),
            degrees("wheel_angle_deg", sign * angle_at_pivot.to_degrees())
                .line("wheel angle φ", "of the slot from the line of centres, counted against the driver's sense"),
            degrees("velocity_angle_deg", gamma).line("angle γ", "between the pin's velocity and the slot"),
        ];
        let velocities = vec![
            rate("pin_speed", pin_speed).line("pin", "along its circle"),
            rate("slot_point_speed", across).line("wheel's point", "under the pin, across the slot"),
            rate("sliding_speed", sliding)
                .line("sliding", self.sliding_in_words())
                .with_size(sliding.abs(), String::new()),
            ReportField::in_unit("wheel_speed_rad_s", self.wheel_speed(), "rad/s")
                .line("wheel", self.turning_in_words()),
            ReportField::in_unit("wheel_acceleration_rad_s2", acceleration, "rad/s²")
                .line("wheel, angular", self.acceleration_in_words())
                .with_size(acceleration.abs(), String::new()),
        ];
        let axes = match self.question.axes {
            AxisDistance::Length(length) => format!("axes {} {} apart", as_typed(length), unit.name()),
            AxisDistance::Stations(slots) => format!("{slots} slots"),
        };
        MechanismReport {
            title: format!(
                "Pin in a slot: crank radius {} {}, {axes}, driver at {} {}",
                as_typed(radius),
                unit.name(),
                as_typed(speed.value()),
                speed.unit()
            ),
            introduction: "Crank angles are counted from the line of centres in the sense in which the driver turns, so they \
                           are negative until the pin is nearest to the wheel's axis. The wheel turns against the driver.",
            sections: vec![("Given", given), ("Position", position), ("Motion", velocities)],
            list: None,
            note: String::new(),
        }
    }

    /// Which way the pin slides, in words.
    pub fn sliding_in_words(&self) -> &'static str {
        let sliding = self.sliding_speed();
        if sliding == 0.0 {
            "zero: on the line of centres the pin does not slide"
        } else if sliding > 0.0 {
            "along the slot, towards the wheel's axis"
        } else {
            "along the slot, away from the wheel's axis"
        }
    }

    /// Which way the wheel turns, in words.
    pub fn turning_in_words(&self) -> &'static str {
        match self.wheel_speed() {
            0.0 if self.theta < 0.0 => "zero: the pin is just entering its slot",
            0.0 => "zero: the pin is just leaving its slot",
            _ => "opposite to the driver",
        }
    }

    /// What the wheel's acceleration does, in words.
    pub fn acceleration_in_words(&self) -> &'static str {
        let acceleration = self.wheel_acceleration();
        if acceleration == 0.0 {
            "zero: on the line of centres the wheel is fastest"
        } else if acceleration > 0.0 {
            "the wheel is speeding up"
        } else {
            "the wheel is slowing down"
        }
    }
}

/// The pin is not in the slot; `half` of the engagement in degrees.
fn outside(question: &PinQuestion, half: f64) -> Error {
    let ends = rounded_down(half);
    let asked = as_typed(question.angle);
    match question.origin {
        AngleOrigin::LineOfCentres => refused!(
            "--angle {asked}: the pin drives the wheel from θ = −{ends}° to {ends}° only; outside of the slot the wheel stands \
             still. Give an angle in this range"
        ),
        AngleOrigin::Extension => refused!(
            "--angle-from-extension {asked}: the pin drives the wheel from {}° to {}° only; outside of the slot the wheel stands \
             still. Give an angle in this range",
            as_typed(180.0 - half),
            as_typed(180.0 + half)
        ),
    }
}

#[cfg(test)]
mod tests;
