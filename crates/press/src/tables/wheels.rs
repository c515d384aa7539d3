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
    let (first, last) = (*stations.start(), *stations.end());
    let speed = formula(r"\dot\varphi/\dot\theta", false)?;
    let acceleration = formula(r"\lvert\ddot\varphi\rvert/\dot\theta^2", false)?;
    let head = [
        format!("stations <small>{}</small>", formula("N", false)?),
        "moves <small>of a turn</small>".to_owned(),
        "dwells <small>of a turn</small>".to_owned(),
        format!("centre <br>distance <small>{}</small>", formula("l/R", false)?),
        format!("wheel <br>radius <small>over {}</small>", formula("R", false)?),
        format!("peak <br>speed <small>{speed}</small>"),
        format!("jump <br>at entry <small>{acceleration}</small>"),
        format!("peak <br>acceleration <small>{acceleration}</small>"),
        format!("peak <br>where <small>{}</small>", formula(r"\theta = \mp", false)?),
    ];
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let caption = format!(
        "Wheels of {first} to {last} stations, one pin, driver at constant speed. Moves and dwells say which number of \
         stations to take; centre distance and wheel radius how large it is; speed and accelerations how hard it is moved; \
         the last column at which crank angle before and behind the line of centres the acceleration is greatest"
    );
    table(&caption, Cells::Numbers, &head, stations.map(row))
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
        format!("{:.2}°", peak.angle.to_degrees()),
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
