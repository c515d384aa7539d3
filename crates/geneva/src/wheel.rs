//! One wheel: its sizes, its times, its greatest speed and acceleration, or its drawing.

use crate::arguments::{Format, Output, formats};
use crate::fields::{self, Field, Report, number};
use crate::output::{count, standalone};
use crate::typed::{self, as_typed, rounded};
use anyhow::ensure;
use clap::Args;
use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration, peak_velocity};
use std::f64::consts::PI;

/// Which wheel, and how.
#[derive(Args, Debug)]
pub struct WheelArguments {
    /// Number of slots, 3 to 1000: stops in one turn of the wheel
    #[arg(long, value_name = "N", value_parser = typed::stations, allow_negative_numbers = true)]
    pub stations: u32,
    /// Number of evenly spaced pins on the driver; at most 2N/(N − 2), or two would be in slots at once
    #[arg(long, value_name = "P", default_value_t = 1, value_parser = typed::pins, allow_negative_numbers = true)]
    pub pins: u32,
    /// Speed of the driver in turns a minute, above zero; gives times, rad/s and rad/s²
    #[arg(long, value_name = "R", value_parser = typed::positive, allow_hyphen_values = true)]
    pub rpm: Option<f64>,
    /// Distance of a pin's centre from the driver's axis in metres, above zero; gives lengths in mm
    #[arg(long, value_name = "M", value_parser = typed::metres, allow_hyphen_values = true)]
    pub crank_radius: Option<f64>,
    /// How to write it
    #[arg(long, default_value = "text", value_parser = formats(&[
        (Format::Text, "A sheet for reading, which says what is measured from where"),
        (Format::Json, "An object with all digits; null where --rpm or --crank-radius is missing"),
        (Format::Svg, "A drawing to scale, a file of its own"),
    ]))]
    pub format: Format,
    /// Where to write it.
    #[command(flatten)]
    pub to: Output,
}

const INTRODUCTION: &str = "\
Crank angles are measured at the driver's axis from the line of centres, which joins the two axes. The driver turns at \
constant speed. While a pin is in a slot the wheel turns against the driver; it slows down past the line of centres as \
it sped up before it.";

/// The wheel that is wanted, as it is wanted.
pub fn page(wanted: &WheelArguments) -> anyhow::Result<String> {
    let wheel = Wheel::with_pins(wanted.stations, wanted.pins)?;
    let report = report(&wheel, wanted.rpm, wanted.crank_radius)?;
    ensure!(report.is_finite(), "the wheel is beyond what can be computed; give another --rpm or --crank-radius");
    match wanted.format {
        Format::Json => fields::json(&report),
        Format::Svg => Ok(standalone(&geneva_figures::stations::mechanism(&wheel).svg)),
        _ => Ok(report.sheet()),
    }
}

/// What there is to say of a wheel at this speed of the driver and with this crank radius in metres, where they are given.
///
/// Ratios of length are to the crank radius; those of velocity and acceleration to the driver's angular speed and its
/// square; fractions are of the driver's turn. What needs a speed or a length that was not given is missing.
fn report(wheel: &Wheel, rpm: Option<f64>, crank_radius: Option<f64>) -> anyhow::Result<Report> {
    let speed = rpm.map(|rpm| rpm * PI / 30.0);
    // A radius of 0.07 m is one of 70 mm, not of 70.00000000000001 mm.
    let radius_mm = crank_radius.map(|metres| rounded(1000.0 * metres));
    let lengths = |ratio: f64| radius_mm.map(|radius| radius * ratio);
    let peaks = speed.map(|speed| wheel.peaks(speed)).transpose()?;
    let peak = acceleration_peak(wheel);
    let at_the_peak = format!("with a pin {}° before the line of centres", number(peak.angle.to_degrees()));
    // With as many pins as fit and no dwell, one pin enters as another leaves.
    let at_entry = if wheel.dwell_fraction() > 0.0 {
        "as a pin enters: a jump from zero"
    } else {
        "as a pin enters: a jump from as much deceleration"
    };
    let entry = entry_acceleration(wheel);
    let given = vec![
        Field::new("stations", wheel.stations()),
        Field::new("pins", wheel.pins()),
        Field::new("rpm", rpm),
        Field::new("crank_radius_mm", radius_mm),
    ];
    let geometry = vec![
        Field::in_unit("engagement_half_angle_deg", wheel.engagement_half_angle().to_degrees(), "°")
            .line("engagement half-angle", "crank angle where a pin enters and leaves"),
        Field::in_unit("centre_distance_ratio", wheel.centre_distance_ratio(), "× crank radius")
            .line("centre distance", "wheel's axis to driver's axis"),
        Field::in_unit("centre_distance_mm", lengths(wheel.centre_distance_ratio()), "mm").also(),
        Field::in_unit("wheel_radius_ratio", wheel.wheel_radius_ratio(), "× crank radius")
            .line("wheel radius", "wheel's axis to a pin's centre as it enters"),
        Field::in_unit("wheel_radius_mm", lengths(wheel.wheel_radius_ratio()), "mm").also(),
        Field::in_unit("slot_length_ratio", wheel.slot_length_ratio(), "× crank radius")
            .line("least slot length", "from there to the pin's centre at its deepest"),
        Field::in_unit("slot_length_mm", lengths(wheel.slot_length_ratio()), "mm").also(),
    ];
    let cycle = vec![
        Field::in_unit("motion_fraction", wheel.motion_fraction(), "× driver turn")
            .line("motion fraction", "while a pin is in a slot"),
        Field::in_unit("dwell_fraction", wheel.dwell_fraction(), "× driver turn")
            .line("dwell fraction", "while the wheel is locked"),
        Field::in_unit("indexing_time_s", speed.map(|speed| wheel.indexing_time(speed)).transpose()?, "s")
            .line("indexing time", "from a pin's entering to its leaving"),
        Field::in_unit("dwell_time_s", speed.map(|speed| wheel.dwell_time(speed)).transpose()?, "s")
            .line("dwell time", "from its leaving to the next pin's entering"),
    ];
    let motion = vec![
        Field::in_unit("peak_velocity_ratio", peak_velocity(wheel), "× driver speed")
            .line("peak velocity", "with a pin on the line of centres"),
        Field::in_unit("peak_speed_rad_s", peaks.map(|(speed, _)| speed), "rad/s").also(),
        Field::in_unit("entry_acceleration_ratio", entry, "× driver speed²").line("entry acceleration", at_entry),
        Field::in_unit("entry_acceleration_rad_s2", speed.map(|speed| speed * speed * entry), "rad/s²").also(),
        Field::in_unit("peak_acceleration_ratio", peak.ratio, "× driver speed²").line("peak acceleration", at_the_peak),
        Field::in_unit("peak_acceleration_rad_s2", peaks.map(|(_, acceleration)| acceleration), "rad/s²").also(),
        // Of the peak of deceleration; that of acceleration is as far before the line of centres.
        Field::new("peak_acceleration_angle_deg", peak.angle.to_degrees()),
    ];
    Ok(Report {
        title: title(wheel, rpm, radius_mm),
        introduction: INTRODUCTION,
        sections: vec![
            ("Given", given),
            ("Geometry", geometry),
            ("Cycle", cycle),
            ("Speed and acceleration of the wheel", motion),
        ],
        note: missing(rpm, crank_radius),
    })
}

fn title(wheel: &Wheel, rpm: Option<f64>, radius_mm: Option<f64>) -> String {
    let (stations, pins) = (count(wheel.stations() as usize, "station"), count(wheel.pins() as usize, "pin"));
    let radius = radius_mm.map_or_else(String::new, |radius| format!(", crank radius {} mm", as_typed(radius)));
    let rpm = rpm.map_or_else(String::new, |rpm| format!(", {} rpm", as_typed(rpm)));
    format!("External Geneva wheel: {stations}, driver with {pins}{radius}{rpm}")
}

/// Which options would say more.
fn missing(rpm: Option<f64>, crank_radius: Option<f64>) -> String {
    let lengths = crank_radius.is_none().then_some("For lengths in mm add --crank-radius M, in metres.");
    let rates = rpm.is_none().then_some("For s, rad/s and rad/s² add --rpm R.");
    lengths.into_iter().chain(rates).collect::<Vec<_>>().join(" ")
}
