//! The three curves over a turn: their values, and the panels that they are drawn in.

use super::instant::Instant;
use crate::number::{round_step, trimmed};
use crate::plot::{Axis, Curve, Plot, Scale, Side};
use crate::svg::view::Pixels;
use crate::theme::FOLLOWER;
use geneva_kinematics::Turn;
use geneva_kinematics::quick_return::{Drive, QuickReturn};
use nalgebra::Vector2;

/// Width and height of a panel with its margins, in pixels.
const SIZE: (u32, u32) = (640, 264);
/// From the top of a panel to that of the next, in pixels: the margins overlap.
pub const PITCH: f64 = 196.0;
/// Degrees of crank angle between two marks.
const MARKS: u32 = 60;
/// How far beyond the greatest value an upright axis goes at least.
const HEADROOM: f64 = 1.04;
/// At least so many steps of an upright axis.
const STEPS: f64 = 4.0;

/// φ and ψ in degrees, ω₄, α₄, at each degree of a turn at constant crank speed.
///
/// ψ goes on without a jump: a lever that turns ends a turn farther on. Where the pin is on the lever's pivot there is
/// no row.
pub fn rows(linkage: &QuickReturn, drive: &Drive<f64>) -> Vec<[f64; 4]> {
    let turns = linkage.strokes().swing_limit.is_none();
    let row = |degrees: u32| {
        let phi = f64::from(degrees);
        let position = linkage.at_crank(&Turn::from_degrees(phi)).ok()?;
        let instant = Instant::new(linkage, &position, drive);
        let psi = match position.lever.degrees() {
            _ if degrees == 0 || (degrees == 360 && !turns) => 0.0,
            _ if degrees == 360 => 360.0,
            psi if turns && degrees > 180 && psi < 0.0 => psi + 360.0,
            psi => psi,
        };
        Some([phi, psi, instant.lever_speed(drive), instant.lever_acceleration(drive)])
    };
    (0..=360).filter_map(row).collect()
}

/// One panel of the three: the values of a column.
pub fn plot(rows: &[[f64; 4]], column: usize) -> Plot {
    let level = Axis {
        range: 0.0..360.0,
        marks: (0..=360).step_by(MARKS as usize).map(f64::from).collect(),
        decimals: 0,
        scale: Scale::Even,
    };
    let values = || rows.iter().filter_map(|row| row.get(column).copied());
    let left = upright(values().fold(0.0, f64::min), values().fold(0.0, f64::max), column == 1);
    let curve = Curve {
        points: rows.iter().map(|row| (row[0], row[column])).collect(),
        side: Side::Left,
        shade: FOLLOWER,
        dashes: None,
    };
    let right = Axis { marks: Vec::new(), ..left.clone() };
    Plot { size: SIZE, level, left, right, curves: vec![curve] }
}

/// An axis in round steps that holds zero and both values; angles have steps of degrees.
fn upright(least: f64, greatest: f64, angles: bool) -> Axis {
    // Angles end on the frame: their ends are known.
    let room = if angles { 1.0 } else { HEADROOM };
    let size = room * (greatest - least);
    let step = if angles { angle_step(size / STEPS) } else { round_step(size / STEPS) };
    let low = libm::floor(room * least / step + 1e-9).min(0.0) as i32;
    let high = (libm::ceil(room * greatest / step - 1e-9) as i32).max(low + 1);
    let digits = trimmed(step, 6);
    let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
    let marks = (low..=high).map(|k| step * f64::from(k)).collect();
    Axis { range: step * f64::from(low)..step * f64::from(high), marks, decimals, scale: Scale::Even }
}

/// The least round part of a turn that is not below `least` degrees.
fn angle_step(least: f64) -> f64 {
    [1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0].into_iter().find(|step| *step >= least).unwrap_or(120.0)
}

/// Where the panel of this number begins.
pub fn corner(top: f64, number: usize) -> Pixels {
    Vector2::new(0.0, top + PITCH * number as f64)
}
