//! Of the chapter on the wheel of N stations: its example, with a size and a load, and its exercise.

use super::Number;
use crate::numbers::fixed;
use anyhow::Context;
use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration, peak_velocity};
use geneva_ledger::jazar;
use std::f64::consts::PI;

/// The example's centre distance in millimetres and its moment of inertia in kg m².
const CENTRE_DISTANCE: f64 = 100.0;
const INERTIA: f64 = 0.002;
/// The exercise's stations and its dwell in seconds.
const STATIONS: u32 = 8;
const DWELL: f64 = 1.5;

/// The numbers of this chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("jazar.example.centre-distance", || Ok(with(CENTRE_DISTANCE, 0, "mm"))),
    ("jazar.example.indexing", || Ok(with(example()?.indexing_time(jazar::example_speed())?, 4, "s"))),
    ("jazar.example.crank-radius", || Ok(with(crank_radius()?, 1, "mm"))),
    ("jazar.example.wheel-radius", || Ok(with(crank_radius()? * example()?.wheel_radius_ratio(), 1, "mm"))),
    ("jazar.example.slot-depth", || Ok(with(crank_radius()? * example()?.slot_length_ratio(), 1, "mm"))),
    ("jazar.example.entry-acceleration", || Ok(with(entry_acceleration(&example()?) * square(), 0, "rad/s²"))),
    ("jazar.example.peak-angle", || Ok(fixed(acceleration_peak(&example()?).angle.to_degrees(), 1) + "°")),
    ("jazar.example.inertia", || Ok(with(INERTIA, 3, "kg&nbsp;m²"))),
    ("jazar.example.torque", || Ok(with(acceleration_peak(&example()?).ratio * square() * INERTIA, 1, "N&nbsp;m"))),
    ("jazar.exercise.turn", || Ok(with(turn()?, 1, "s"))),
    ("jazar.exercise.rpm", || Ok(with(60.0 / turn()?, 0, "turns a minute"))),
    ("jazar.exercise.moving", || Ok(with(turn()? - DWELL, 1, "s"))),
    ("jazar.exercise.peak-ratio", || Ok(fixed(peak_velocity(&exercise()?), 3))),
    ("jazar.exercise.peak-speed", || Ok(with(peak_velocity(&exercise()?) * 2.0 * PI / turn()?, 2, "rad/s"))),
];

fn with(number: f64, decimals: usize, unit: &str) -> String {
    format!("{}&nbsp;{unit}", fixed(number, decimals))
}

fn example() -> anyhow::Result<Wheel> {
    jazar::example().context("the source's wheel cannot be built")
}

fn crank_radius() -> anyhow::Result<f64> {
    Ok(CENTRE_DISTANCE / example()?.centre_distance_ratio())
}

/// The square of the example's driver speed.
fn square() -> f64 {
    jazar::example_speed() * jazar::example_speed()
}

fn exercise() -> anyhow::Result<Wheel> {
    Ok(Wheel::new(STATIONS)?)
}

/// The seconds that a turn of the exercise's driver takes.
fn turn() -> anyhow::Result<f64> {
    Ok(DWELL / exercise()?.dwell_fraction())
}
