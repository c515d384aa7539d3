//! The table of wheels: what each number of stations gives.

use anyhow::{Context, anyhow};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use geneva_press::numbers::fixed;
use geneva_press::table::{Cells, Table};
use std::ops::RangeInclusive;

/// The table for the numbers of stations from the first to the second, written with a space between.
pub fn wheels(range: &str) -> anyhow::Result<Table> {
    let stations = parsed(range).ok_or_else(|| anyhow!("`{range}`: two integers are expected, as in `3 18`"))?;
    let ratio = |number| fixed(number, 4);
    let wheels = stations.map(Wheel::new).collect::<Result<Vec<_>, _>>().context("the table of wheels")?;
    Table::with_rows(Cells::Numbers, wheels)
        .column("stations", |wheel| format!("<i>N</i>&nbsp;=&nbsp;{}", wheel.stations()))
        .column("moves, <small>of a turn</small>", |wheel| ratio(wheel.motion_fraction()))
        .column("dwells, <small>of a turn</small>", |wheel| ratio(wheel.dwell_fraction()))
        .column("centre <br>distance, <small>× crank</small>", |wheel| ratio(wheel.centre_distance_ratio()))
        .column("wheel <br>radius, <small>× crank</small>", |wheel| ratio(wheel.wheel_radius_ratio()))
        .column("peak <br>speed, <small>× driver’s</small>", |wheel| ratio(wheel.peak_velocity()))
        .column("jump <br>at entry, <small>× driver’s speed²</small>", |wheel| ratio(wheel.entry_acceleration()))
        .column("peak <br>acceleration, <small>× driver’s speed²</small>", |wheel| {
            ratio(wheel.acceleration_peak().ratio)
        })
        .column("at <small>crank angle</small>", |wheel| {
            format!("∓{:.2}°", wheel.acceleration_peak().angle.to_degrees())
        })
        .finish()
}

fn parsed(range: &str) -> Option<RangeInclusive<u32>> {
    let (first, last) = range.split_once(' ')?;
    Some(first.parse().ok()?..=last.parse().ok()?)
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
