//! The sheet for reading: names, a few digits, units, and what is measured from where.

use super::record::WheelRecord;
use crate::output::{count, wrapped};
use crate::sheet::{self, Line, number};

const INTRODUCTION: &str = "\
Crank angles are measured at the driver's axis from the line of centres, which joins the two axes. The driver turns at \
constant speed. While a pin is in a slot the wheel turns against the driver; it slows down behind the line of centres as \
it sped up before it.";

/// The whole sheet.
pub fn page(record: &WheelRecord) -> String {
    let sections = [
        ("Geometry", geometry(record)),
        ("Cycle", cycle(record)),
        ("Speed and acceleration of the wheel", peaks(record)),
    ];
    let page = sheet::page(&title(record), INTRODUCTION, &sections);
    let missing = missing(record);
    if missing.is_empty() { page } else { page + "\n" + &wrapped("", &missing) }
}

fn title(record: &WheelRecord) -> String {
    let mut title = format!(
        "External Geneva wheel: {}, driver with {}",
        count(record.stations as usize, "station"),
        count(record.pins as usize, "pin")
    );
    if let Some(radius) = record.crank_radius_mm {
        title += &format!(", crank radius {radius} mm");
    }
    if let Some(rpm) = record.rpm {
        title += &format!(", {rpm} rpm");
    }
    title
}

fn geometry(record: &WheelRecord) -> Vec<Line> {
    let mut lines = vec![line(
        "engagement half-angle",
        record.engagement_half_angle_deg,
        "°",
        "crank angle where a pin enters and leaves",
    )];
    for (name, ratio, length, meaning) in [
        ("centre distance", record.centre_distance_ratio, record.centre_distance_mm, "wheel's axis to driver's axis"),
        (
            "wheel radius",
            record.wheel_radius_ratio,
            record.wheel_radius_mm,
            "wheel's axis to a pin's centre as it enters",
        ),
        (
            "least slot length",
            record.slot_length_ratio,
            record.slot_length_mm,
            "from there to the pin's centre at its deepest",
        ),
    ] {
        lines.push(line(name, ratio, "× crank radius", meaning));
        lines.extend(length.map(|length| line("", length, "mm", "")));
    }
    lines
}

fn cycle(record: &WheelRecord) -> Vec<Line> {
    let mut lines = vec![
        line("motion fraction", record.motion_fraction, "× driver turn", "while a pin is in a slot"),
        line("dwell fraction", record.dwell_fraction, "× driver turn", "while the wheel is locked"),
    ];
    for (name, time, meaning) in [
        ("advance time", record.advance_time_s, "from a pin's entering to its leaving"),
        ("dwell time", record.dwell_time_s, "from its leaving to the next pin's entering"),
    ] {
        lines.extend(time.map(|time| line(name, time, "s", meaning)));
    }
    lines
}

fn peaks(record: &WheelRecord) -> Vec<Line> {
    let angle = number(record.peak_acceleration_angle_deg);
    let at_the_peak = format!("with a pin {angle}° before the line of centres");
    // With as many pins as fit and no dwell, one pin enters as another leaves.
    let at_entry = if record.dwell_fraction > 0.0 {
        "as a pin enters: a jump from zero"
    } else {
        "as a pin enters: a jump from as much deceleration"
    };
    let mut lines = Vec::new();
    for (name, ratio, ratio_unit, rate, unit, meaning) in [
        (
            "peak velocity",
            record.peak_velocity_ratio,
            "× driver speed",
            record.peak_speed_rad_s,
            "rad/s",
            "with a pin on the line of centres",
        ),
        (
            "entry acceleration",
            record.entry_acceleration_ratio,
            "× driver speed²",
            record.entry_acceleration_rad_s2,
            "rad/s²",
            at_entry,
        ),
        (
            "peak acceleration",
            record.peak_acceleration_ratio,
            "× driver speed²",
            record.peak_acceleration_rad_s2,
            "rad/s²",
            &at_the_peak,
        ),
    ] {
        lines.push(line(name, ratio, ratio_unit, meaning));
        lines.extend(rate.map(|rate| line("", rate, unit, "")));
    }
    lines
}

/// Which options would say more.
fn missing(record: &WheelRecord) -> String {
    let lengths = record.crank_radius_mm.is_none().then_some("For lengths in mm add --crank-radius MM.");
    let rates = record.rpm.is_none().then_some("For s, rad/s and rad/s² add --rpm R.");
    lengths.into_iter().chain(rates).collect::<Vec<_>>().join(" ")
}

fn line(name: &'static str, value: f64, unit: &'static str, meaning: &str) -> Line {
    Line::new(name, number(value), unit, meaning)
}
