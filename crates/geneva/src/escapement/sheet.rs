//! The sheet for reading: names, a few digits, units, and what is measured from where.

use super::record::{EscapementRecord, RISE_TIME};
use super::typed::again;
use crate::output::count;
use crate::sheet::{self, Line};
use geneva_dynamics::steady::MOST_CYCLES;

const INTRODUCTION: &str = "\
Times are in the unit of time of the torque and the inertias, and speeds in radians per unit of time: s and rad/s for lb, \
in and s, or for N, m and kg. Crank angles are measured at the driver's axis from the line of centres, negative before it.";

/// How many degrees count as none.
const NO_ANGLE: f64 = 1e-9;

/// The whole sheet.
pub fn page(record: &EscapementRecord) -> String {
    let sections = [
        ("Mechanism", mechanism(record)),
        ("Existence", existence(record)),
        ("Steady state", steady(record)),
        ("Rise from rest", rise(record)),
    ];
    sheet::page(&title(record), INTRODUCTION, &sections)
}

fn title(record: &EscapementRecord) -> String {
    format!(
        "Geneva escapement: {}, {}, friction {}, torque {}, inertias: driver {}, follower {}",
        count(record.slots as usize, "slot"),
        count(record.pins as usize, "pin"),
        again(record.friction),
        again(record.torque),
        again(record.driver_inertia),
        again(record.follower_inertia)
    )
}

fn mechanism(record: &EscapementRecord) -> Vec<Line> {
    let half = record.engagement_half_angle_deg;
    let own = 360.0 / f64::from(record.pins);
    let modulus = if record.modulus_deg == own {
        "turn of the driver from one pin's entering to the next's".to_owned()
    } else {
        format!(
            "turn of the driver after which its angle is put back; what follows is a calculation's, for the next pin \
             enters after {own}°"
        )
    };
    let mut lines = vec![
        line("inertia ratio", record.inertia_ratio, "", "driver's over follower's"),
        line("half-angle", half, "°", "crank angle where a pin leaves its slot; it enters as far before the line"),
        line("modulus", record.modulus_deg, "°", &modulus),
    ];
    if let Some(si) = record.in_si {
        lines.push(line("torque", si.torque_n_m, "N m", "of the spring, in SI units"));
        lines.push(line("driver inertia", si.driver_inertia_kg_m2, "kg m²", ""));
        lines.push(line("follower inertia", si.follower_inertia_kg_m2, "kg m²", ""));
    }
    lines
}

fn existence(record: &EscapementRecord) -> Vec<Line> {
    let share = 100.0 * record.friction / record.critical_friction;
    let margin = format!(
        "least A − |D|, which is above zero where there is one motion; {}° to either side of the line of centres",
        number(record.least_margin_angle_deg)
    );
    let critical = format!(
        "from which on it may jam, {}° to either side of the line of centres; the friction is {} % of it",
        number(record.critical_angle_deg),
        number(share)
    );
    vec![
        line("critical friction", record.critical_friction, "", &critical),
        line("margin", record.least_margin, "", &margin),
    ]
}

fn steady(record: &EscapementRecord) -> Vec<Line> {
    let switches: Vec<_> = record.switch_angles_deg.iter().map(|angle| place(*angle)).collect();
    let switches = match switches.as_slice() {
        [] => "of the friction term: none within the modulus".to_owned(),
        some => format!("of the friction term: at {}", some.join(" and at ")),
    };
    vec![
        line("entry speed", record.entry_speed, "", "of the driver, as a pin enters"),
        line("peak speed", record.peak_speed, "", &format!("at {}", place(record.peak_angle_deg))),
        line("minimum speed", record.minimum_speed, "", &format!("at {}", place(record.minimum_angle_deg))),
        line("mean speed", record.mean_speed, "", "modulus over period"),
        line("mean of extremes", record.mean_of_extremes, "", "of peak and minimum speed"),
        line("period", record.period, "", "from one engagement to the next"),
        line("contraction", record.contraction, "", "what an engagement leaves of a small difference of speeds"),
        Line::said("sign changes", &switches),
    ]
}

fn rise(record: &EscapementRecord) -> Vec<Line> {
    match (record.rise_time, record.engagements_to_settle) {
        (Some(time), Some(engagements)) => vec![
            line("rise time", time, "", RISE_TIME),
            Line::new("engagements", engagements.to_string(), "", "until then"),
        ],
        _ => {
            vec![Line::said("rise time", &format!("more than {MOST_CYCLES} engagements; it would be the {RISE_TIME}"))]
        }
    }
}

/// A crank angle: zero is the line of centres.
fn place(degrees: f64) -> String {
    if degrees.abs() <= NO_ANGLE { "0°".to_owned() } else { format!("{}°", number(degrees)) }
}

fn number(value: f64) -> String {
    sheet::number(value).replace('-', "−")
}

fn line(name: &'static str, value: f64, unit: &'static str, meaning: &str) -> Line {
    Line::new(name, number(value), unit, meaning)
}
