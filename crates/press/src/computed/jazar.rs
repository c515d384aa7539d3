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
    ("jazar.example.pin-force", || Ok(with(greatest(force)?.1, 0, "N"))),
    ("jazar.example.pin-force.angle", || Ok(fixed(greatest(force)?.0.to_degrees(), 0) + "°")),
    ("jazar.example.driver-torque", || Ok(with(greatest(driver_torque)?.1, 1, "N&nbsp;m"))),
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

/// The force on the pin in N, at a crank angle: the wheel's torque over the pin's distance from its axis.
fn force(wheel: &Wheel, theta: f64) -> anyhow::Result<f64> {
    let ratio = wheel.centre_distance_ratio();
    let distance = (1.0 + ratio * ratio - 2.0 * ratio * libm::cos(theta)).sqrt() * crank_radius()? / 1000.0;
    Ok((wheel.engaged(theta)?.acceleration * square() * INERTIA / distance).abs())
}

/// The torque in N m that the driver needs for it.
fn driver_torque(wheel: &Wheel, theta: f64) -> anyhow::Result<f64> {
    let motion = wheel.engaged(theta)?;
    Ok((motion.acceleration * square() * INERTIA * motion.velocity).abs())
}

/// Where a load of the example is greatest between the line of centres and the exit, in rad, and how great it is there.
fn greatest(load: fn(&Wheel, f64) -> anyhow::Result<f64>) -> anyhow::Result<(f64, f64)> {
    /// Places at which it is compared: the two digits that are shown change with none of them.
    const PLACES: u32 = 2000;
    let wheel = example()?;
    let end = wheel.engagement_half_angle();
    let at = |place: u32| end * f64::from(place) / f64::from(PLACES);
    let mut most = (0.0, 0.0);
    for angle in (0..=PLACES).map(at) {
        let load = load(&wheel, angle)?;
        if load > most.1 {
            most = (angle, load);
        }
    }
    Ok(most)
}

fn exercise() -> anyhow::Result<Wheel> {
    Ok(Wheel::new(STATIONS)?)
}

/// The seconds that a turn of the exercise's driver takes.
fn turn() -> anyhow::Result<f64> {
    Ok(DWELL / exercise()?.dwell_fraction())
}
