//! Position, velocity and acceleration of the wheel over one advance.

use super::pose::id;
use crate::figure::{Figure, Words};
use crate::number::{degrees, round_step, significant, trimmed, without_noise};
use crate::plot::{Axis, Curve, Plot, Scale, Side};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::shape::Shape;
use crate::theme::{DRIVER, FOLLOWER, INK, PAPER, RELATIVE, Shade};
use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration, peak_velocity};
use nalgebra::Vector2;
use std::f64::consts::PI;

const SIZE: (u32, u32) = (640, 480);
/// Rows of the series: at least so many steps, and none longer than a degree.
const LEAST_STEPS: u32 = 90;
/// Steps from zero to either end of an upright axis.
const STEPS: i32 = 3;
/// How far beyond the greatest value an upright axis goes at least.
const HEADROOM: f64 = 1.05;
/// Degrees between marks of the crank angle.
const MARKS: f64 = 15.0;
/// The rise to the peak of acceleration is steep if it begins below this part of the peak.
const STEEP: f64 = 0.35;
/// Degrees of dwell shown before and after the advance, if there are so many.
const DWELL: f64 = 8.0;

/// φ in radians, φ'/θ' and φ''/θ'² against θ in degrees, from entry to exit, for a driver of constant speed.
///
/// φ and φ'/θ' are read at the left, φ''/θ'² at the right; zero is at one height. A little of the dwell is shown on
/// both sides, so that the jumps of the acceleration at entry and exit can be seen: a filled dot on the advance, an
/// open one on the dwell. Series, in equal steps of at most a degree, both ends included: θ, φ, φ'/θ', φ''/θ'².
pub fn advance(wheel: &Wheel) -> Figure {
    let rows = rows(wheel);
    let most = wheel.engagement_half_angle().to_degrees();
    let rest = DWELL.min((PI / f64::from(wheel.pins())).to_degrees() - most).max(0.0);
    let plot = plot(wheel, &rows, most, rest);
    let mut canvas = plot.canvas();
    ends(&mut canvas, &plot, wheel, most, rest > 0.0);
    name_axes(&mut canvas, &plot);
    name_curves(&mut canvas, &plot, wheel, most);

    let columns = [("theta", "deg"), ("phi", "rad"), ("phi'/theta'", "1"), ("phi''/theta'^2", "1")];
    let (alpha, peak) = (wheel.half_station(), acceleration_peak(wheel));
    let words = Words {
        id: id("advance", wheel),
        title: format!("Position, velocity and acceleration of a wheel with {} stations", wheel.stations()),
        description: format!(
            "Three curves over the crank angle from {} to {}. The wheel's angle rises from {} rad to {} rad. Its \
             velocity ratio rises from zero to {} on the line of centres and falls back to zero. Its acceleration ratio \
             jumps from zero to {} at entry, rises to {} at {}, falls through zero on the line of centres to the \
             opposite values, and jumps back to zero at exit.",
            degrees(-most.to_radians()),
            degrees(most.to_radians()),
            significant(-alpha, 4).replace('-', "−"),
            significant(alpha, 4),
            significant(peak_velocity(wheel), 4),
            significant(entry_acceleration(wheel), 4),
            significant(peak.ratio, 4),
            degrees(-peak.angle)
        ),
        caption: "One advance at constant driver speed: the wheel's angle, and its velocity and acceleration over the \
                  driver's speed and its square. The acceleration jumps at both ends; there the jerk is infinite."
            .to_owned(),
    };
    words.figure(canvas, Kind::Plot, Series::new(columns, rows))
}

/// θ in degrees, φ in radians, φ'/θ', φ''/θ'²; from entry to exit, both included, symmetric to the last bit.
fn rows(wheel: &Wheel) -> Vec<[f64; 4]> {
    let half = wheel.engagement_half_angle();
    let steps = LEAST_STEPS.max(libm::ceil(2.0 * half.to_degrees() - 1e-9) as u32);
    let row = |k: u32| {
        // The share is exactly one at both ends.
        let theta = half * ((2.0 * f64::from(k) - f64::from(steps)) / f64::from(steps));
        let motion = wheel.engaged(theta).ok()?;
        let velocity = without_noise(motion.velocity, 1.0);
        Some([theta.to_degrees(), motion.angle, velocity, motion.acceleration])
    };
    (0..=steps).filter_map(row).collect()
}

fn plot(wheel: &Wheel, rows: &[[f64; 4]], most: f64, rest: f64) -> Plot {
    let end = most + rest;
    let count = ((end + 1e-9) / MARKS) as i32;
    let level = Axis {
        range: -end..end,
        marks: (-count..=count).map(|k| MARKS * f64::from(k)).collect(),
        decimals: 0,
        scale: Scale::Even,
    };
    let alpha = wheel.half_station();
    let curve = |column: usize, dwell: Option<f64>, side, shade, dashes| {
        let inside = rows.iter().map(|row| (row[0], row[column]));
        let points = match dwell {
            Some(value) => [(-end, -value)].into_iter().chain(inside).chain([(end, value)]).collect(),
            None => inside.collect(),
        };
        Curve { points, side, shade, dashes }
    };
    let curves = vec![
        curve(1, Some(alpha), Side::Left, RELATIVE, Some([3, 5])),
        curve(2, Some(0.0), Side::Left, FOLLOWER, None),
        curve(3, None, Side::Right, DRIVER, Some([12, 6])),
    ];
    let left = alpha.max(peak_velocity(wheel));
    Plot { size: SIZE, level, left: symmetric(left), right: symmetric(acceleration_peak(wheel).ratio), curves }
}

/// An axis from −3 to 3 round steps that holds a value of this size.
fn symmetric(greatest: f64) -> Axis {
    let step = round_step(HEADROOM * greatest / f64::from(STEPS));
    let end = step * f64::from(STEPS);
    let digits = trimmed(step, 6);
    let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
    let marks = (-STEPS..=STEPS).map(|k| step * f64::from(k)).collect();
    Axis { range: -end..end, marks, decimals, scale: Scale::Even }
}

/// Entry and exit: uprights through both, and the jumps of the acceleration.
fn ends(canvas: &mut Canvas, plot: &Plot, wheel: &Wheel, most: f64, dwells: bool) {
    let jump = entry_acceleration(wheel);
    for (theta, value) in [(-most, jump), (most, -jump)] {
        let [zero, top] = [0.0, value].map(|y| plot.place(Side::Right, theta, y));
        if dwells {
            let outer =
                plot.place(Side::Right, if theta < 0.0 { plot.level.range.start } else { plot.level.range.end }, 0.0);
            canvas.draw(Shape::line(&outer, &zero).stroke(DRIVER, 3.0).dashed("12 6").class("dwell"));
            canvas.draw(Shape::line(&zero, &top).stroke(DRIVER, 1.3).dashed("2 3").class("jump"));
            canvas.draw(Shape::circle(&zero, 5.0).stroke(DRIVER, 2.0).fill(PAPER).class("dwell-end"));
        }
        canvas.draw(Shape::circle(&top, 5.0).stroke(DRIVER, 2.0).fill(DRIVER).class("advance-end"));
    }
    if dwells {
        let foot = plot.left.range.start;
        for (theta, name, towards) in [(-most, "entry", 1.0), (most, "exit", -1.0)] {
            let [low, high] = [foot, -foot].map(|y| plot.place(Side::Left, theta, y));
            canvas.draw(Shape::line(&low, &high).stroke(INK, 1.0).dashed("1 4"));
            canvas.label(&(low - Vector2::new(0.0, 14.0)), &Vector2::new(towards, 0.0), 6.0, &Label::words(name));
        }
    }
}

/// The symbols of the three curves: φ, φ'/θ' and φ''/θ'².
fn symbols() -> [Label; 3] {
    let shaded = |shade: Shade| Label::symbol("φ").shade(shade);
    [
        shaded(RELATIVE).and(" in rad"),
        shaded(FOLLOWER).and("′ / ").and_symbol("θ").and("\u{200a}′"),
        shaded(DRIVER).and("″ / ").and_symbol("θ").and("\u{200a}′²"),
    ]
}

fn name_axes(canvas: &mut Canvas, plot: &Plot) {
    let ends = &plot.level.range;
    let (right, down) = (Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0));
    let [angle, velocity, acceleration] = symbols();
    let left = plot.place(Side::Left, ends.start, plot.left.range.end) - down * 26.0;
    canvas.label(&left, &right, -56.0, &angle.and(","));
    canvas.label(&left, &right, 30.0, &velocity);
    let corner = plot.place(Side::Right, ends.end, plot.right.range.end) - down * 26.0;
    canvas.label(&corner, &-right, -56.0, &acceleration);
    let middle = plot.place(Side::Left, 0.0, plot.left.range.start);
    canvas.label(&middle, &down, 50.0, &Label::words("crank angle ").and_symbol("θ").and(" in degrees"));
}

/// Names each curve beside it: the velocity on its falling side, the acceleration outside its peak.
fn name_curves(canvas: &mut Canvas, plot: &Plot, wheel: &Wheel, most: f64) {
    let [angle, velocity, acceleration] = symbols();
    let at = |share: f64| wheel.engaged(share * most.to_radians()).ok();
    if let (Some(fast), Some(late)) = (at(0.22), at(0.8)) {
        let place = plot.place(Side::Left, 0.22 * most, fast.velocity);
        canvas.label(&place, &Vector2::new(1.0, -0.5), 14.0, &velocity);
        let place = plot.place(Side::Left, 0.8 * most, late.angle.max(late.velocity));
        canvas.label(&place, &Vector2::new(0.0, -1.0), 20.0, &angle);
    }
    // Outside a steep rise to the peak; under a flat one, where the velocity is still small.
    let peak = acceleration_peak(wheel);
    if entry_acceleration(wheel) < STEEP * peak.ratio {
        let place = plot.place(Side::Right, -1.5 * peak.angle.to_degrees(), 0.9 * peak.ratio);
        canvas.label(&place, &Vector2::new(-1.0, -0.6), 14.0, &acceleration);
    } else if let Some(early) = at(-0.75) {
        let place = plot.place(Side::Right, -0.75 * most, early.acceleration);
        canvas.label(&place, &Vector2::new(0.3, 1.0), 24.0, &acceleration);
    }
}
