//! The motion over the whole engagement: the follower's speed and the pin's speed along the slot.

use super::instant::Instant;
use crate::figure::{Figure, Words};
use crate::number::{degrees, round_step, significant, trimmed, with_minus_sign, without_noise};
use crate::plot::{Axis, Curve, Plot, Scale, Side};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::shape::Shape;
use crate::theme::{FOLLOWER, INK, PAPER, RELATIVE};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use nalgebra::Vector2;
use std::f64::consts::PI;

const SIZE: (u32, u32) = (640, 450);
/// Steps from zero to either end of an upright axis.
const STEPS: i32 = 3;
/// How far beyond the greatest value an upright axis goes at least.
const HEADROOM: f64 = 1.05;
/// Degrees between marks of the crank angle.
const MARKS: f64 = 15.0;

/// The follower's angular velocity over the driver's, and the pin's speed along the slot, from entry to exit.
///
/// The given instant (`crank` is φ, counter-clockwise from the direction O → B) is marked if it is within the
/// engagement. `driver_speed` is the driver's angular velocity in radians per second, counter-clockwise positive;
/// `length_unit` the unit of the mechanism's lengths. Series, in steps of about a degree from entry to exit:
/// φ; ω_S/ω_D, positive where the two turn the same way; speed along the slot, positive towards the follower's
/// pivot; r/R.
pub fn over_the_engagement(mechanism: &PinSlot, crank: &Turn<f64>, driver_speed: f64, length_unit: &str) -> Figure {
    let speed_unit = format!("{length_unit}/s");
    let rows = rows(mechanism, driver_speed);
    let instant = Instant::new(mechanism, crank, driver_speed);
    let half = mechanism.engagement_half_angle();
    let plot = plot(&rows, half.to_degrees());
    let mut canvas = plot.canvas();
    name_axes(&mut canvas, &plot, &speed_unit);
    name_curves(&mut canvas, &plot, &rows, &instant);
    if (instant.crank_angle - PI).abs() <= half + 1e-9 {
        mark(&mut canvas, &plot, &instant, &speed_unit);
    }

    let columns = [("phi", "deg"), ("omega_S/omega_D", "1"), ("v_P/S", speed_unit.as_str()), ("r/R", "1")];
    let [entry, exit] = [PI - half, PI + half].map(degrees);
    let lowest = Instant::new(mechanism, &Turn::from_radians(PI), 1.0).speed_ratio;
    let lowest = with_minus_sign(&significant(lowest, 4));
    let words = Words {
        id: "pin-engagement".to_owned(),
        title: "Speeds of the follower and along the slot over the engagement".to_owned(),
        description: format!(
            "Two curves over the crank angle from {entry} to {exit}. The follower's angular velocity over the driver's \
             is zero at both ends and falls to {lowest} on the line of centres; the pin's speed along the slot goes \
             from the pin's full speed inwards, through zero on the line of centres, to its full speed outwards."
        ),
        caption:
            "Over the engagement. The follower starts and stops at rest; the pin turns round in the slot where the \
                  follower is fastest. Negative ratio: the two turn in opposite senses. Sliding towards O is positive."
                .to_owned(),
    };
    words.figure(canvas, Kind::Plot, Series::new(columns, rows))
}

/// φ in degrees, ω_S/ω_D, speed along the slot, r/R; from entry to exit, both included.
fn rows(mechanism: &PinSlot, driver_speed: f64) -> Vec<[f64; 4]> {
    let half = mechanism.engagement_half_angle();
    let steps = libm::ceil(2.0 * half.to_degrees() - 1e-9).max(2.0) as u32;
    let row = |k: u32| {
        // Symmetric about the line of centres to the last bit.
        let before = half * (f64::from(steps) - 2.0 * f64::from(k)) / f64::from(steps);
        let instant = Instant::new(mechanism, &Turn::from_radians(before).supplement(), driver_speed);
        [180.0 - before.to_degrees(), instant.speed_ratio, instant.inward_speed, instant.radius_ratio]
    };
    (0..=steps).map(row).collect()
}

fn plot(rows: &[[f64; 4]], half_degrees: f64) -> Plot {
    let each = f64::from(((half_degrees / MARKS / 4.0).ceil() as u32).max(1)) * MARKS;
    let count = ((half_degrees + 1e-9) / each) as i32;
    let level = Axis {
        range: 180.0 - half_degrees..180.0 + half_degrees,
        marks: (-count..=count).map(|k| 180.0 + each * f64::from(k)).collect(),
        decimals: 0,
        scale: Scale::Even,
    };
    let curve = |column: usize, side, shade, dashes| Curve {
        points: rows.iter().map(|row| (row[0], row[column])).collect(),
        side,
        shade,
        dashes,
    };
    let curves = vec![curve(1, Side::Left, FOLLOWER, None), curve(2, Side::Right, RELATIVE, Some([10, 6]))];
    Plot { size: SIZE, level, left: symmetric_axis(rows, 1), right: symmetric_axis(rows, 2), curves }
}

/// An axis from −3 to 3 round steps, so that zero is at one height on both sides.
fn symmetric_axis(rows: &[[f64; 4]], column: usize) -> Axis {
    let greatest = rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
    let step = round_step(HEADROOM * greatest / f64::from(STEPS));
    let end = step * f64::from(STEPS);
    let digits = trimmed(step, 6);
    let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
    Axis {
        range: -end..end,
        marks: (-STEPS..=STEPS).map(|k| step * f64::from(k)).collect(),
        decimals,
        scale: Scale::Even,
    }
}

/// The symbols of the two curves.
fn symbols() -> [Label; 2] {
    let ratio = Label::symbol("ω").sub("S").and(" / ").and_symbol("ω").sub("D").shade(FOLLOWER);
    [ratio, Label::symbol("v").sub("P/S").shade(RELATIVE)]
}

fn name_axes(canvas: &mut Canvas, plot: &Plot, speed_unit: &str) {
    let ends = &plot.level.range;
    let (right, down) = (Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0));
    let [ratio, sliding] = symbols();
    canvas.label(&(plot.place(Side::Left, ends.start, plot.left.range.end) - down * 26.0), &right, -48.0, &ratio);
    let corner = plot.place(Side::Right, ends.end, plot.right.range.end) - down * 26.0;
    canvas.label(&corner, &-right, -56.0, &sliding.and(&format!(" in {speed_unit}")));
    let middle = plot.place(Side::Left, (ends.start + ends.end) / 2.0, plot.left.range.start);
    canvas.label(&middle, &down, 50.0, &Label::words("crank angle ").and_symbol("φ").and(" in degrees"));
}

/// Names each curve beside it, in the half that the instant is not in.
fn name_curves(canvas: &mut Canvas, plot: &Plot, rows: &[[f64; 4]], instant: &Instant) {
    let at = |share: f64| {
        let share = if instant.crank_angle <= PI { share } else { 1.0 - share };
        rows.get((share * (rows.len() - 1) as f64) as usize).copied().unwrap_or_default()
    };
    let [ratio, sliding] = symbols();
    let (rising, flat) = (at(0.8), at(0.9));
    canvas.label(&plot.place(Side::Left, rising[0], rising[1]), &Vector2::new(0.0, -1.0), 29.0, &ratio);
    let inwards = Vector2::new(0.0, flat[2].signum());
    canvas.label(&plot.place(Side::Right, flat[0], flat[2]), &inwards, 22.0, &sliding);
}

/// Marks the instant on both curves.
fn mark(canvas: &mut Canvas, plot: &Plot, instant: &Instant, speed_unit: &str) {
    let x = instant.crank_angle.to_degrees();
    let [foot, head] = [plot.left.range.start, plot.left.range.end].map(|y| plot.place(Side::Left, x, y));
    canvas.draw(Shape::line(&foot, &head).stroke(INK, 1.2).dashed("3 4").class("instant"));
    let ratio = without_noise(instant.speed_ratio, 1.0);
    let speed = without_noise(instant.inward_speed, instant.pin_velocity.norm());
    let name = Label::symbol("φ").and(&format!(" = {}", degrees(instant.crank_angle)));
    // At the end of the line that the sliding speed leaves free, inside the frame.
    let (end, away) = if speed >= 0.0 { (foot, -1.4) } else { (head, 1.4) };
    canvas.label(&end, &Vector2::new(instant.side(), away), 22.0, &name);
    let ratio_falls = instant.side() > 0.0;
    let speed_falls = speed * instant.side() >= 0.0;
    for (side, y, falls, shade, text) in [
        (Side::Left, ratio, ratio_falls, FOLLOWER, significant(ratio, 4)),
        (Side::Right, speed, speed_falls, RELATIVE, format!("{} {speed_unit}", significant(speed, 4))),
    ] {
        let at = plot.place(side, x, y);
        canvas.draw(Shape::circle(&at, 6.0).fill(shade).stroke(PAPER, 1.5));
        let towards = beside_slope(falls, plot.level.share(x));
        canvas.label(&at, &towards, 14.0, &Label::words(&text).shade(shade));
    }
}

/// Where a label finds room beside a point of a falling or rising curve, at this share of the way across the plot.
fn beside_slope(falls: bool, share: f64) -> Vector2<f64> {
    let (forward, upward) = match (falls, share) {
        (true, share) if share <= 0.72 => (1.0, -0.8),
        (true, _) => (-1.0, 0.8),
        (false, share) if share >= 0.28 => (-1.0, -0.8),
        (false, _) => (1.0, 0.8),
    };
    Vector2::new(forward, upward)
}
