//! The table of wheels: what each number of stations gives.

use crate::html::{Cells, Table, table};
use crate::maths::formula;
use crate::numbers::fixed;
use anyhow::{Context, anyhow};
use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration, peak_velocity};
use std::ops::RangeInclusive;

/// The table for the numbers of stations from the first to the second, written with a space between.
pub fn wheels(range: &str) -> anyhow::Result<Table> {
    let stations = parsed(range).ok_or_else(|| anyhow!("`{range}`: two whole numbers are expected, as in `3 18`"))?;
    let symbol = |tex: &str| formula(tex, false);
    let head = [
        symbol("N")?,
        "moves".to_owned(),
        "dwells".to_owned(),
        symbol("l/R")?,
        "wheel radius".to_owned(),
        format!("peak {}", symbol(r"\dot\varphi/\dot\theta")?),
        format!("entry {}", symbol(r"\ddot\varphi/\dot\theta^2")?),
        format!("peak {}", symbol(r"\lvert\ddot\varphi\rvert/\dot\theta^2")?),
        format!("at {}", symbol(r"\theta = \mp")?),
    ];
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    table("Wheels by number of stations", Cells::Numbers, &head, stations.map(row))
}

fn parsed(range: &str) -> Option<RangeInclusive<u32>> {
    let (first, last) = range.split_once(' ')?;
    Some(first.parse().ok()?..=last.parse().ok()?)
}

fn row(stations: u32) -> anyhow::Result<Vec<String>> {
    let wheel = Wheel::new(stations).context("the table of wheels")?;
    let peak = acceleration_peak(&wheel);
    let ratio = |number| fixed(number, 4);
    Ok(vec![
        stations.to_string(),
        ratio(wheel.motion_fraction()),
        ratio(wheel.dwell_fraction()),
        ratio(wheel.centre_distance_ratio()),
        ratio(wheel.wheel_radius_ratio()),
        ratio(peak_velocity(&wheel)),
        ratio(entry_acceleration(&wheel)),
        ratio(peak.ratio),
        format!("{:.3}°", peak.angle.to_degrees()),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_range_of_wheels_is_refused() {
        for wrong in ["3", "3-5", "x 5", "2 4"] {
            assert!(wheels(wrong).is_err(), "{wrong}");
        }
    }
}
