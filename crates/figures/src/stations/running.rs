//! The wheel at a crank angle above the curves of its motion, at the right distance of the axes or another.

use super::pose::{WheelMargins, WheelPose, count_noun};
use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::number::{degrees, extent, significant, with_minus_sign, without_noise};
use crate::parts::{WIDTH, pin_circle};
use crate::svg::{Canvas, Label, Pixels};
use crate::theme::{Colour, DRIVER, FOLLOWER, INK, RELATIVE};
use crate::{Figure, FigureError, Series, Words};
use geneva_kinematics::indexing::{Indexing, WheelMotion};
use geneva_kinematics::wheel::MisplacedWheel;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Room of the mechanism, and the space about it, in pixels.
const ROOM: Pixels = Vector2::new(WIDTH, 300.0);
const MARGINS: WheelMargins = WheelMargins { left: 8.0, right: 8.0, above: 8.0, below: 8.0 };
/// Height of a frame, in pixels, and the least height of all three with their titles.
const FRAME: f64 = 96.0;
/// Steps of the curves, and the degrees of dwell shown to either side, if there are so many.
const STEPS: u32 = 120;
const DWELL: f64 = 14.0;
/// Degrees between marks of the crank angle.
const MARKS: f64 = 30.0;
/// Where a curve stands at the crank angle.
const HERE: Marker = Marker::new(INK, MarkShape::Disc).sized(11.0).class("here");

/// The marks at the ends of a jump, in pixels.
const JUMP: f64 = 9.0;

/// What the arrows are.
const IMPULSES: &str = "Where a curve jumps, its rate of change, the curve below it, is infinite for an instant. Such \
     an impulse is drawn as an arrow.";

/// One of the curves: its name, its colour and its value.
type Curve = (&'static str, Colour, fn(&WheelMotion) -> f64);

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
pub fn running(misplaced: &MisplacedWheel, crank: f64) -> Result<Figure, FigureError> {
    let wheel = misplaced.wheel();
    let motion = misplaced.motion(crank)?;
    let pitch = 2.0 * PI / f64::from(wheel.pins());
    let near = crank - libm::round(crank / pitch) * pitch;
    let half = misplaced.engagement_half_angle();
    let end = (half + DWELL.to_radians()).min(pitch / 2.0).max(half.min(pitch / 2.0));
    let rows = rows(misplaced, half.min(end), end)?;

    let bodies = WheelPose::fitting(wheel, ROOM, MARGINS);
    let axis = bodies.view.place(&Vector2::new(misplaced.centre_distance_ratio(), 0.0));
    let placed = WheelPose { axis, ..bodies };
    let panels = panels(&rows, near.to_degrees(), &motion, end.to_degrees());
    let blow = misplaced.entry_velocity_ratio();
    let words = words(misplaced, crank, &motion, blow);
    let series = Series::of_items(
        &rows,
        [
            ("theta", "deg", |(theta, _)| *theta),
            ("phi", "rad", |(_, motion)| motion.angle),
            ("phi'/theta'", "1", |(_, motion)| motion.velocity),
            ("phi''/theta'^2", "1", |(_, motion)| motion.acceleration),
            ("phi'''/theta'^3", "1", |(_, motion)| motion.jerk),
        ],
    );
    Ok(Chart::new(panels).figure_below(words, series, ROOM.y, |canvas: &mut Canvas| {
        pin_circle(canvas, &placed.axis, placed.view.scale);
        placed.draw(canvas, crank, motion.angle, 2.0);
    }))
}

/// θ in degrees, and the wheel there.
type Row = (f64, WheelMotion);

/// The wheel over one passage and a part of the dwell to either side; two rows at each jump.
fn rows(of: &MisplacedWheel, half: f64, end: f64) -> Result<Vec<Row>, FigureError> {
    let still = |crank: f64| -> Result<Row, FigureError> {
        Ok((crank.to_degrees(), WheelMotion { velocity: 0.0, acceleration: 0.0, jerk: 0.0, ..of.motion(crank)? }))
    };
    let mut rows = Vec::new();
    if end > half {
        rows.extend([still(-end)?, still(-half)?]);
    }
    for k in 0..=STEPS {
        let crank = half * ((2.0 * f64::from(k) - f64::from(STEPS)) / f64::from(STEPS));
        let motion = of.motion(crank)?;
        rows.push((crank.to_degrees(), WheelMotion { velocity: without_noise(motion.velocity, 1.0), ..motion }));
    }
    if end > half {
        rows.extend([still(half)?, still(end)?]);
    }
    Ok(rows)
}

/// The three curves, one under another.
fn panels(rows: &[Row], near: f64, motion: &WheelMotion, end: f64) -> Vec<Panel> {
    let marks = || {
        let count = ((end + 1e-9) / MARKS) as i32;
        (-count..=count).map(|k| MARKS * f64::from(k))
    };
    // Rest, advance and rest: two rows at one angle are a jump.
    let parts: Vec<&[Row]> = rows.chunk_by(|(a, _), (b, _)| a < b).collect();
    let panel = |(k, (name, colour, value)): (usize, &Curve)| {
        let values = || rows.iter().map(|(_, motion)| value(motion));
        let [least, most] = extent(values().chain([0.0]));
        let title = Label::words(name).in_colour(*colour);
        let y = ChartAxis::spanning(least, most, 3.0).titled(title);
        let x = ChartAxis::whole(-end..end, marks());
        let last = k + 1 == CURVES.len();
        let x = if last {
            x.titled(Label::words("crank angle ").and_symbol("θ").and(" in degrees"))
        } else {
            x.unnumbered()
        };
        let mut panel = Panel::new(FRAME, &x, &y).horizontal(0.0, LineStyle::thin("zero"));
        for part in &parts {
            panel = panel.curve(part.iter().map(|(theta, motion)| (*theta, value(motion))), LineStyle::new(*colour));
        }
        let jump = |pair: &[&[Row]], value: fn(&WheelMotion) -> f64| match pair {
            [[.., (theta, before)], [(_, after), ..]] => (*theta, [value(before), value(after)]),
            _ => (0.0, [0.0, 0.0]),
        };
        for (pair, sense) in parts.windows(2).zip([1.0, -1.0]) {
            let (theta, [before, after]) = jump(pair, *value);
            // A jump is a ring at rest and a disc on the advance; the rate of what jumps is an impulse.
            if before != after {
                let (still, moving) = if sense > 0.0 { (before, after) } else { (after, before) };
                let ends = [(MarkShape::Ring, still, "still"), (MarkShape::Disc, moving, "moving")];
                panel = ends.into_iter().fold(panel, |panel, (mark, value, class)| {
                    panel.marks([(theta, value)], Marker::new(*colour, mark).sized(JUMP).class(class))
                });
            }
            let Some((.., integral)) = k.checked_sub(1).map(|k| &CURVES[k]) else { continue };
            let (_, [before, after]) = jump(pair, *integral);
            if before != after {
                panel = panel.impulse(theta, after > before, LineStyle::new(*colour).class("impulse"));
                if sense > 0.0 {
                    let edge = panel.ends()[usize::from(after > before)];
                    panel = panel.name_near([(theta, 0.7 * edge)], PI, Label::words("impulse").in_colour(*colour));
                }
            }
        }
        panel.vertical(near, LineStyle::thin("now").wide(1.0).dashed("2 4")).marks([(near, value(motion))], HERE)
    };
    CURVES.iter().enumerate().map(panel).collect()
}

fn words(of: &MisplacedWheel, crank: f64, motion: &WheelMotion, blow: f64) -> Words {
    let wheel = of.wheel();
    let (stations, pins) = (count_noun(wheel.stations(), "station"), count_noun(wheel.pins(), "pin"));
    let distance = match of.error() {
        0.0 => "with the axes at the right distance".to_owned(),
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
            "Above, the mechanism to scale. Below it, over the crank angle of the nearest pin, the wheel's velocity, \
             acceleration and jerk over the driver's speed, its square and its cube; a dot on each at the crank angle: {}, \
             {} and {}. As the pin enters the velocity jumps by {}.",
            number(motion.velocity),
            number(motion.acceleration),
            number(motion.jerk),
            number(blow)
        ),
        format!(
            "A wheel with {stations} and {pins}, {distance}. The curves are the wheel's velocity, acceleration and jerk, \
             divided by the driver's speed, its square and its cube. The dots are at the crank angle of the drawing. \
             {IMPULSES}"
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_drawn};
    use crate::svg::TEXT_SIZE;
    use geneva_kinematics::wheel::Wheel;

    fn figure(error: f64) -> Figure {
        let wheel = Wheel::new(4).expect("possible");
        running(&MisplacedWheel::new(&wheel, error).expect("possible"), 0.3).expect("drawn")
    }

    #[test]
    fn what_jumps_is_not_joined_and_its_rate_is_an_impulse() {
        let figure = figure(0.0);
        assert_drawn(&figure);
        let drawing = ParsedDrawing::parse(&figure);
        // Rest, advance and rest again for each of three; the velocity is continuous, acceleration and jerk jump.
        assert_eq!((drawing.count("curve"), drawing.count("still"), drawing.count("moving")), (9, 4, 4));
        assert_eq!(drawing.count("impulse"), 4, "shaft and head, at entry and at exit");
        assert!(drawing.texts().contains(&"impulse".to_owned()) && figure.caption.contains("impulse"));
        // Both accelerations jump up, from rest and to rest.
        for arrow in [0, 2] {
            assert!(drawing.path("impulse", arrow + 1)[0].y < drawing.path("impulse", arrow)[0].y - 10.0);
        }
    }

    #[test]
    fn a_blow_is_an_impulse_of_the_acceleration() {
        assert_eq!(ParsedDrawing::parse(&figure(0.01)).count("impulse"), 8);
    }

    #[test]
    fn no_title_touches_the_numbers_of_the_panel_above() {
        let figure = figure(0.0);
        let drawing = ParsedDrawing::parse(&figure);
        let frames: Vec<f64> =
            [0, 1, 2].map(|panel| drawing.path("now", panel).iter().map(|end| end.y).fold(0.0, f64::max)).to_vec();
        for (title, foot) in [("acceleration", frames[0]), ("jerk", frames[1])] {
            let base = drawing.base_line(title);
            // A digit is less than three quarters of its size high, and half of it is below the foot of the frame.
            assert!(base - 0.75 * TEXT_SIZE > foot + 0.375 * TEXT_SIZE + 4.0, "{title}: {base} below {foot}");
        }
    }
}
