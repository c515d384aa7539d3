//! The sheet for reading: names, a few digits, units, directions, and what is measured from where.

use super::digits::{angle, direction, number, typed};
use super::record::QuickReturnRecord;
use super::vector::Vector;
use super::words;
use crate::sheet::{self, Line};

/// What the numbers are measured from, and what adds up.
const INTRODUCTION: &str = "\
Angles and directions are counter-clockwise from the direction that points from the lever's pivot to the crank's axis. \
The crank turns at constant speed. The pin's velocity is the sum of that of the lever's point under it and of its \
sliding in the slot. The two terms of its acceleration are together the sum of those of the lever's point, of the \
sliding and of Coriolis.";

/// The whole sheet.
pub fn page(record: &QuickReturnRecord) -> String {
    let sections = [
        ("Position", position(record)),
        ("Velocities", velocities(record)),
        ("Accelerations", accelerations(record)),
        ("Strokes", strokes(record)),
    ];
    sheet::page(&title(record), INTRODUCTION, &sections)
}

fn title(record: &QuickReturnRecord) -> String {
    format!(
        "Slotted-lever quick-return mechanism: ground {} m, crank {} m, {} rpm {}",
        typed(record.ground_m),
        typed(record.crank_m),
        typed(record.rpm.abs()),
        words::sense(record.rpm)
    )
}

fn position(record: &QuickReturnRecord) -> Vec<Line> {
    vec![
        degrees("crank angle", record.crank_angle_deg, "direction from the crank's axis to the pin"),
        degrees("lever angle", record.lever_angle_deg, "direction from the lever's pivot to the pin"),
        degrees("angle at the pin", record.angle_at_pin_deg, "between lever and crank"),
        scalar("pin distance", record.pin_distance_m, "m", "from the lever's pivot to the pin"),
        Line::said("branch", words::branch(&record.instant)),
        Line::said("stroke", words::stroke(&record.instant)),
    ]
}

fn velocities(record: &QuickReturnRecord) -> Vec<Line> {
    let [pin, lever, sliding] = record.velocities();
    let on_circle = format!("along the crank's circle, {}", words::sense(record.rpm));
    let carried = zero_or(lever, "the lever is at rest", words::across(lever, record));
    let slides = zero_or(sliding, words::no_sliding(&record.instant), words::along(sliding, record));
    let speed = if record.instant.lever_at_rest { 0.0 } else { record.lever_speed_rad_s.abs() };
    vec![
        vector("pin", pin, "m/s", on_circle),
        vector("lever's point", lever, "m/s", carried),
        vector("sliding", sliding, "m/s", slides),
        scalar("lever, angular", speed, "rad/s", &words::lever_speed(record)),
    ]
}

fn accelerations(record: &QuickReturnRecord) -> Vec<Line> {
    let [pin_normal, pin_tangential, lever_normal, lever_tangential, sliding_normal, sliding_tangential, coriolis] =
        record.accelerations();
    let (instant, unit) = (&record.instant, "m/s²");
    let still = if instant.lever_at_rest { "the lever is at rest" } else { "the pin does not slide" };
    let inwards = zero_or(lever_normal, still, words::along(lever_normal, record));
    let carried = zero_or(lever_tangential, words::steady(instant), words::across(lever_tangential, record));
    let slides = zero_or(sliding_tangential, words::steady_sliding(instant), words::along(sliding_tangential, record));
    let turned = zero_or(coriolis, still, words::across(coriolis, record));
    let angular = lever_tangential.direction_deg.map_or(0.0, |_| record.lever_acceleration_rad_s2.abs());
    vec![
        vector("pin, normal", pin_normal, unit, "to the crank's axis".to_owned()),
        vector("pin, tangential", pin_tangential, unit, "the crank turns at constant speed".to_owned()),
        vector("lever, normal", lever_normal, unit, inwards),
        vector("lever, tangential", lever_tangential, unit, carried),
        vector("sliding, normal", sliding_normal, unit, "the slot is straight".to_owned()),
        vector("sliding, tangential", sliding_tangential, unit, slides),
        vector("Coriolis", coriolis, unit, turned),
        scalar("lever, angular", angular, "rad/s²", &words::lever_acceleration(record)),
    ]
}

fn strokes(record: &QuickReturnRecord) -> Vec<Line> {
    let swing = match record.swing_limit_deg {
        None => Line::said(
            "swing",
            "none: the crank is longer than the ground distance, and the lever turns round and round",
        ),
        Some(_) if record.instant.half_speed => Line::said(
            "swing",
            "none: with a crank as long as the ground distance the pin passes through the lever's pivot at 180°, where \
             the lever has no direction",
        ),
        Some(limit) => degrees("swing limit", limit, "greatest lever angle, to either side"),
    };
    let mut lines = vec![swing];
    match record.time_ratio {
        None => lines.push(Line::said("time ratio", "none: there is no fast stroke")),
        Some(ratio) => lines.extend([
            degrees("slow stroke", record.slow_stroke_deg, "of a turn of the crank"),
            degrees("fast stroke", record.fast_stroke_deg, "of a turn of the crank"),
            scalar("time ratio", ratio, "", "time of the slow stroke over that of the fast one"),
        ]),
    }
    lines
}

/// Why a vector is zero, if it is.
fn zero_or(vector: &Vector, why: &str, otherwise: String) -> String {
    if vector.direction_deg.is_none() { why.to_owned() } else { otherwise }
}

fn vector(name: &'static str, vector: &Vector, unit: &'static str, meaning: String) -> Line {
    match vector.direction_deg {
        None => Line::new(name, number(0.0), unit, &format!("zero: {meaning}")),
        Some(degrees) => {
            let direction = format!("at {:>7}°", direction(degrees));
            Line { direction, ..Line::new(name, number(vector.magnitude), unit, &meaning) }
        }
    }
}

fn scalar(name: &'static str, value: f64, unit: &'static str, meaning: &str) -> Line {
    Line::new(name, number(value), unit, meaning)
}

fn degrees(name: &'static str, value: f64, meaning: &str) -> Line {
    Line::new(name, angle(value), "°", meaning)
}
