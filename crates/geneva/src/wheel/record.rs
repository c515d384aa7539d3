//! A wheel as data: what the library says of it, in the units of the command line.

use anyhow::{anyhow, ensure};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration, peak_velocity};
use serde::Serialize;
use std::f64::consts::PI;

const RPM: &str = "--rpm";
const CRANK_RADIUS: &str = "--crank-radius";

/// All that is known of a wheel: the keys of the JSON object and the columns of the CSV row.
///
/// Ratios of length are to the crank radius; those of velocity and acceleration to the driver's angular speed and its
/// square; fractions are of the driver's turn. What needs a speed or a length that was not given is `None`.
#[derive(Debug, Serialize)]
pub struct WheelRecord {
    pub stations: u32,
    pub pins: u32,
    pub rpm: Option<f64>,
    pub crank_radius_mm: Option<f64>,
    pub engagement_half_angle_deg: f64,
    pub centre_distance_ratio: f64,
    pub centre_distance_mm: Option<f64>,
    pub wheel_radius_ratio: f64,
    pub wheel_radius_mm: Option<f64>,
    pub slot_length_ratio: f64,
    pub slot_length_mm: Option<f64>,
    pub motion_fraction: f64,
    pub dwell_fraction: f64,
    pub advance_time_s: Option<f64>,
    pub dwell_time_s: Option<f64>,
    pub peak_velocity_ratio: f64,
    pub peak_speed_rad_s: Option<f64>,
    pub entry_acceleration_ratio: f64,
    pub entry_acceleration_rad_s2: Option<f64>,
    pub peak_acceleration_ratio: f64,
    pub peak_acceleration_rad_s2: Option<f64>,
    /// Of the peak of deceleration; that of acceleration is as far before the line of centres.
    pub peak_acceleration_angle_deg: f64,
}

impl WheelRecord {
    /// The wheel at this speed of the driver and of this size, where they are given.
    pub fn new(wheel: &Wheel, rpm: Option<f64>, crank_radius_mm: Option<f64>) -> anyhow::Result<Self> {
        let rates = rpm.map(|rpm| Rates::new(wheel, rpm)).transpose()?;
        let lengths = crank_radius_mm.map(|radius| Lengths::new(wheel, radius)).transpose()?;
        let peak = acceleration_peak(wheel);
        Ok(Self {
            stations: wheel.stations(),
            pins: wheel.pins(),
            rpm,
            crank_radius_mm,
            engagement_half_angle_deg: wheel.engagement_half_angle().to_degrees(),
            centre_distance_ratio: wheel.centre_distance_ratio(),
            centre_distance_mm: lengths.as_ref().map(|lengths| lengths.centre_distance),
            wheel_radius_ratio: wheel.wheel_radius_ratio(),
            wheel_radius_mm: lengths.as_ref().map(|lengths| lengths.wheel_radius),
            slot_length_ratio: wheel.slot_length_ratio(),
            slot_length_mm: lengths.as_ref().map(|lengths| lengths.slot_length),
            motion_fraction: wheel.motion_fraction(),
            dwell_fraction: wheel.dwell_fraction(),
            advance_time_s: rates.as_ref().map(|rates| rates.advance_time),
            dwell_time_s: rates.as_ref().map(|rates| rates.dwell_time),
            peak_velocity_ratio: peak_velocity(wheel),
            peak_speed_rad_s: rates.as_ref().map(|rates| rates.peak_speed),
            entry_acceleration_ratio: entry_acceleration(wheel),
            entry_acceleration_rad_s2: rates.as_ref().map(|rates| rates.entry_acceleration),
            peak_acceleration_ratio: peak.ratio,
            peak_acceleration_rad_s2: rates.as_ref().map(|rates| rates.peak_acceleration),
            peak_acceleration_angle_deg: peak.angle.to_degrees(),
        })
    }
}

/// What a speed of the driver gives, in seconds and radians.
struct Rates {
    advance_time: f64,
    dwell_time: f64,
    peak_speed: f64,
    entry_acceleration: f64,
    peak_acceleration: f64,
}

impl Rates {
    fn new(wheel: &Wheel, rpm: f64) -> anyhow::Result<Self> {
        let speed = rpm * PI / 30.0;
        let (peak_speed, peak_acceleration) = wheel.peaks(speed).map_err(|error| refused(RPM, rpm, error))?;
        let rates = Self {
            advance_time: wheel.advance_time(speed)?,
            dwell_time: wheel.dwell_time(speed)?,
            peak_speed,
            entry_acceleration: speed * speed * entry_acceleration(wheel),
            peak_acceleration,
        };
        // A wheel with as many pins as fit may have no dwell at all, but no other of these is ever zero.
        let computed = [rates.advance_time, peak_speed, rates.entry_acceleration, peak_acceleration];
        ensure!(rates.dwell_time.is_finite() && computed.into_iter().all(f64::is_normal), beyond(RPM, rpm));
        Ok(rates)
    }
}

/// What a crank radius in mm gives, in mm.
struct Lengths {
    centre_distance: f64,
    wheel_radius: f64,
    slot_length: f64,
}

impl Lengths {
    fn new(wheel: &Wheel, radius: f64) -> anyhow::Result<Self> {
        let mechanism = wheel.pin_and_slot(radius).map_err(|error| refused(CRANK_RADIUS, radius, error))?;
        let lengths = Self {
            centre_distance: mechanism.centre_distance(),
            wheel_radius: radius * wheel.wheel_radius_ratio(),
            slot_length: radius * wheel.slot_length_ratio(),
        };
        let computed = [lengths.centre_distance, lengths.wheel_radius, lengths.slot_length];
        ensure!(computed.into_iter().all(f64::is_normal), beyond(CRANK_RADIUS, radius));
        Ok(lengths)
    }
}

/// The library's refusal, in terms of the option and the value that the reader typed.
fn refused(option: &'static str, typed: f64, error: KinematicsError) -> anyhow::Error {
    match error {
        KinematicsError::Size { .. } if typed > 0.0 && typed.is_finite() => beyond(option, typed),
        KinematicsError::Size { .. } => KinematicsError::Size { name: option, asked: typed }.into(),
        other => other.into(),
    }
}

/// A value is allowed, but what follows from it is no number that can be held.
fn beyond(option: &'static str, typed: f64) -> anyhow::Error {
    anyhow!("{option} {typed:?}: too large or too small to compute with; give one that a machine can have")
}
