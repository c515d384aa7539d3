//! The table of wheels: what each number of stations gives.

use crate::html::{Cells, Table, table};
use crate::numbers::fixed;
use anyhow::{Context, anyhow};
use geneva_dynamics::wheel_loads::WheelLoads;
use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration, peak_velocity};
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
        "RMS crank <br>torque, <small>× its peak</small>",
    ];
    let caption = format!(
        "Wheels with {first} to {last} stations, one pin, and a driver at constant speed. The times of moving and dwelling \
         tell you how many stations to choose, centre distance and wheel radius how large the wheel is, and speed and \
         accelerations how hard it is driven. The crank angle is that, before and past the line of centres, where the \
         acceleration is greatest. The last column is the root mean square of the crank’s torque over a turn, without friction"
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
        format!("<i>N</i>&nbsp;=&nbsp;{stations}"),
        ratio(wheel.motion_fraction()),
        ratio(wheel.dwell_fraction()),
        ratio(wheel.centre_distance_ratio()),
        ratio(wheel.wheel_radius_ratio()),
        ratio(peak_velocity(&wheel)),
        ratio(entry_acceleration(&wheel)),
        ratio(peak.ratio),
        format!("∓{:.2}°", peak.angle.to_degrees()),
        fixed(rms_share(&wheel)?, 3),
    ])
}

/// Root mean square of the crank's torque over a turn, over its peak, dimensionless: without friction it depends on the numbers
/// of stations and pins alone.
fn rms_share(wheel: &Wheel) -> anyhow::Result<f64> {
    let loads = WheelLoads::new(wheel, 1.0, 0.0, 1.0)?;
    Ok(loads.rms_crank_torque() / loads.crank_torque().driving.value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_friction_the_rms_torque_is_the_same_part_of_the_peak_at_any_inertia_and_speed() {
        for stations in [3, 6, 8, 18] {
            let wheel = Wheel::new(stations).expect("possible");
            let loads = WheelLoads::new(&wheel, 0.37, 0.0, 21.0).expect("possible");
            let share = loads.rms_crank_torque() / loads.crank_torque().driving.value;
            assert!((share / rms_share(&wheel).expect("one") - 1.0).abs() < 1e-9, "{stations}");
        }
        // By many equal steps for eight stations.
        let wheel = Wheel::new(8).expect("possible");
        let end = wheel.engagement_half_angle();
        let torque = |step: u32| {
            let motion = wheel.engaged(end * (f64::from(step) / 5e3 - 1.0)).expect("in the slot");
            motion.acceleration * motion.velocity
        };
        let all: Vec<f64> = (0..=10_000).map(torque).collect();
        let square = all.iter().map(|torque| torque * torque).sum::<f64>() * end / 5e3 / std::f64::consts::TAU;
        let peak = all.iter().copied().fold(0.0, f64::max);
        assert!((square.sqrt() / peak / rms_share(&wheel).expect("one") - 1.0).abs() < 1e-4);
    }

    #[test]
    fn what_is_no_range_of_wheels_is_refused() {
        for wrong in ["3", "3-5", "x 5", "2 4"] {
            assert!(wheels(wrong).is_err(), "{wrong}");
        }
    }
}
