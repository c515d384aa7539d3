//! The wheel at a crank angle beside the curves of its motion, at the right distance of the axes or another.

use super::pose::{Bodies, Margins, counted};
use crate::chart::{Axis, Chart, Mark, Marker, Panel, Stroke};
use crate::number::{degrees, significant, with_minus_sign, without_noise};
use crate::parts::pin_circle;
use crate::svg::{Canvas, Label, Pixels};
use crate::theme::{DRIVER, FOLLOWER, INK, RELATIVE, Shade};
use crate::{Figure, FigureError, Series, Words};
use geneva_kinematics::wheel::{Misplaced, Motion};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// The mechanism's column, and the space about it, in pixels.
const COLUMN: f64 = 420.0;
const MARGINS: Margins = Margins { left: 8.0, right: 8.0, above: 8.0, below: 8.0 };
/// Height of a frame, in pixels, and the least height of all three with their titles.
const FRAME: f64 = 96.0;
/// Steps of the curves, and the degrees of dwell shown to either side, if there are so many.
const STEPS: u32 = 120;
const DWELL: f64 = 14.0;
/// Degrees between marks of the crank angle.
const MARKS: f64 = 30.0;
/// Where a curve stands at the crank angle.
const HERE: Marker = Marker::new(INK, Mark::Disc).sized(11.0).class("here");

/// One of the curves: its name, its colour and its value.
type Curve = (&'static str, Shade, fn(&Motion) -> f64);

const CURVES: [Curve; 3] = [
    ("velocity", FOLLOWER, |motion| motion.velocity),
    ("acceleration", DRIVER, |motion| motion.acceleration),
    ("jerk", RELATIVE, |motion| motion.jerk),
];

/// The wheel with a pin at a crank angle (radians from the line of centres, −π to π), and the wheel's velocity,
/// acceleration and jerk over the angle of the nearest pin: over the driver's speed, its square and its cube.
///
/// Series: crank angle, wheel angle, the three
/// ratios, in equal steps; a jump is where two rows have the same crank angle.
///
/// # Errors
///
/// [`FigureError`] for an angle beyond half a turn.
pub fn running(misplaced: &Misplaced, crank: f64) -> Result<Figure, FigureError> {
    let wheel = misplaced.wheel();
    let motion = misplaced.at(crank)?;
    let pitch = 2.0 * PI / f64::from(wheel.pins());
    let near = crank - libm::round(crank / pitch) * pitch;
    let half = misplaced.engagement_half_angle();
    let end = (half + DWELL.to_radians()).min(pitch / 2.0).max(half.min(pitch / 2.0));
    let rows = rows(misplaced, half.min(end), end)?;

    let bodies = Bodies::new(wheel, COLUMN, MARGINS);
    let axis = bodies.view.place(&Vector2::new(misplaced.centre_distance_ratio(), 0.0));
    let titles = panels(&rows, near.to_degrees(), &motion, end.to_degrees());
    let height: f64 = titles.iter().map(Panel::room).sum();
    let placed = Bodies { axis, ..bodies }.moved(&Pixels::new(0.0, (height - bodies.height) / 2.0));
    let blow = misplaced.entry_velocity_ratio();
    let words = words(misplaced, crank, &motion, blow);
    let columns =
        [("theta", "deg"), ("phi", "rad"), ("phi'/theta'", "1"), ("phi''/theta'^2", "1"), ("phi'''/theta'^3", "1")];
    let series = Series::new(columns, rows);
    Ok(Chart::new(titles).figure_beside(words, series, |canvas: &mut Canvas| {
        pin_circle(canvas, &placed.axis, placed.view.scale);
        placed.draw(canvas, crank, motion.angle, 2.0);
    }))
}

/// θ in degrees, φ and the three ratios over one passage and a part of the dwell to either side; two rows at each jump.
fn rows(of: &Misplaced, half: f64, end: f64) -> Result<Vec<[f64; 5]>, FigureError> {
    let row = |crank: f64, motion: Motion| {
        let Motion { angle, velocity, acceleration, jerk, .. } = motion;
        [crank.to_degrees(), angle, without_noise(velocity, 1.0), acceleration, jerk]
    };
    let still = |crank: f64| -> Result<[f64; 5], FigureError> {
        let angle = of.at(crank)?.angle;
        Ok([crank.to_degrees(), angle, 0.0, 0.0, 0.0])
    };
    let mut rows = Vec::new();
    if end > half {
        rows.extend([still(-end)?, still(-half)?]);
    }
    for k in 0..=STEPS {
        let crank = half * ((2.0 * f64::from(k) - f64::from(STEPS)) / f64::from(STEPS));
        rows.push(row(crank, of.at(crank)?));
    }
    if end > half {
        rows.extend([still(half)?, still(end)?]);
    }
    Ok(rows)
}

/// The three curves, one under another.
fn panels(rows: &[[f64; 5]], near: f64, motion: &Motion, end: f64) -> Vec<Panel> {
    let marks = || {
        let count = ((end + 1e-9) / MARKS) as i32;
        (-count..=count).map(|k| MARKS * f64::from(k))
    };
    let panel = |(k, (name, shade, value)): (usize, &Curve)| {
        let column = || rows.iter().map(move |row| row[k + 2]);
        let [least, most] = [column().fold(0.0, f64::min), column().fold(0.0, f64::max)];
        let title = Label::words(name).shade(*shade);
        let y = Axis::spanning(least, most, 3.0).titled(title);
        let x = Axis::whole(-end..end, marks());
        let last = k + 1 == CURVES.len();
        let x = if last {
            x.titled(Label::words("crank angle ").and_symbol("θ").and(" in degrees"))
        } else {
            x.unnumbered()
        };
        Panel::new(FRAME, &x, &y)
            .horizontal(0.0, Stroke::thin("zero"))
            .curve(rows.iter().map(|row| (row[0], row[k + 2])), Stroke::new(*shade))
            .vertical(near, Stroke::thin("now").wide(1.0).dashed("2 4"))
            .marks([(near, value(motion))], HERE)
    };
    CURVES.iter().enumerate().map(panel).collect()
}

fn words(of: &Misplaced, crank: f64, motion: &Motion, blow: f64) -> Words {
    let wheel = of.wheel();
    let (stations, pins) = (counted(wheel.stations(), "station"), counted(wheel.pins(), "pin"));
    let distance = match of.error() {
        0.0 => "at the right distance of the axes".to_owned(),
        error => format!(
            "with the axes {} % too {}",
            significant(100.0 * error.abs(), 3),
            if error > 0.0 { "far apart" } else { "near" }
        ),
    };
    let number = |value: f64| with_minus_sign(&significant(without_noise(value, 1.0), 4));
    Words::new(
        "live-wheel",
        format!("A wheel with {stations} and {pins}, {distance}, at a crank angle of {}", degrees(crank)),
        format!(
            "At the left the mechanism to scale. At the right, over the crank angle of the nearest pin, the wheel's velocity, \
             acceleration and jerk over the driver's speed, its square and its cube; a dot on each at the crank angle: {}, \
             {} and {}. As the pin enters the velocity jumps by {}.",
            number(motion.velocity),
            number(motion.acceleration),
            number(motion.jerk),
            number(blow)
        ),
        format!(
            "A wheel with {stations} and {pins}, {distance}: velocity, acceleration and jerk of the wheel over the driver's \
             speed, its square and its cube. The dots are at the crank angle of the drawing."
        ),
    )
}
