//! The table of wheels: what each number of stations gives.

use anyhow::{Context, anyhow};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use geneva_press::html::{Cells, Table, table};
use geneva_press::numbers::fixed;
use std::ops::RangeInclusive;

/// The table for the numbers of stations from the first to the second, written with a space between.
pub fn wheels(range: &str) -> anyhow::Result<Table> {
    let stations = parsed(range).ok_or_else(|| anyhow!("`{range}`: two integers are expected, as in `3 18`"))?;
    let (first, last) = (*stations.start(), *stations.end());
    let head = [
        "stations",
        "moves, <small>of a turn</small>",
        "dwells, <small>of a turn</small>",
        "centre <br>distance, <small>× crank</small>",
        "wheel <br>radius, <small>× crank</small>",
        "peak <br>speed, <small>× driver’s</small>",
        "jump <br>at entry, <small>× driver’s speed²</small>",
        "peak <br>acceleration, <small>× driver’s speed²</small>",
        "at <small>crank angle</small>",
    ];
    let caption = format!(
        "Wheels with {first} to {last} stations, one pin, and a driver at constant speed. The parts of a turn for \
         which the wheel moves and dwells tell you how many stations to choose. Centre distance and wheel radius tell \
         you how large the wheel is. Speed and accelerations tell you how hard it is driven. The last column gives the \
         crank angles at which the wheel speeds up most, before the line of centres, and slows down most, past it"
    );
    table(&caption, Cells::Numbers, &head, stations.map(row))
}

fn parsed(range: &str) -> Option<RangeInclusive<u32>> {
    let (first, last) = range.split_once(' ')?;
    Some(first.parse().ok()?..=last.parse().ok()?)
}

fn row(stations: u32) -> anyhow::Result<Vec<String>> {
    let wheel = Wheel::new(stations).context("the table of wheels")?;
    let peak = wheel.acceleration_peak();
    let ratio = |number| fixed(number, 4);
    Ok(vec![
        format!("<i>N</i>&nbsp;=&nbsp;{stations}"),
        ratio(wheel.motion_fraction()),
        ratio(wheel.dwell_fraction()),
        ratio(wheel.centre_distance_ratio()),
        ratio(wheel.wheel_radius_ratio()),
        ratio(wheel.peak_velocity()),
        ratio(wheel.entry_acceleration()),
        ratio(peak.ratio),
        format!("∓{:.2}°", peak.angle.to_degrees()),
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
