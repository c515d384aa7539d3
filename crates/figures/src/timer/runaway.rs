//! A runaway escapement: a toothed wheel, a pallet with a weighted bar, no spring; and the speed that its blows leave.

use crate::chart::{Chart, ChartAxis, LineStyle, Panel};
use crate::number::significant;
use crate::parts::{arc_arrow, fixed_pivot};
use crate::svg::{Canvas, Label, Path, Pixels, Shape, View};
use crate::theme::{DRIVER, FILL, FOLLOWER, INK, PAPER, RELATIVE};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::timer::runaway::{Drag, Runaway};
use geneva_kinematics::Turn;
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// The drawn wheel, in radii of its tips: how many teeth, where they end, and how wide they are there in radians.
const TEETH: u32 = 12;
const ROOT: f64 = 0.74;
const TOOTH: f64 = 0.16;
/// From one pallet to the other, in pitches; a pallet lies half of it to either side of the line of centres.
const SPAN: f64 = 2.5;
/// A pallet's face: how far a tooth slides along it and how far it lifts it, and how thick the pallet is above, in radii of
/// the tips.
const ALONG: f64 = 0.2;
const LIFT: f64 = 0.11;
const THICK: f64 = 0.12;
/// Part of its way along the face that the driving tooth has gone.
const PHASE: f64 = 0.3;
/// Half the bar that carries the weights, and their radius.
const BAR: f64 = 1.0;
const WEIGHT: f64 = 0.13;
/// Pixels of a tip's radius, and the height of the drawing above the panel.
const SCALE: f64 = 150.0;
const ABOVE: f64 = 440.0;

/// The pallet's inertia over the wheel's, reduced to the wheel, of the panel; how many blows it shows.
const PALLET: f64 = 0.15;
const BLOWS: usize = 9;
/// Every so many of the computed points are drawn.
const EACH: usize = 20;

/// A point of the plane of the drawing, in radii of the tips.
type Point = Vector2<f64>;

fn polar(radius: f64, angle: f64) -> Point {
    let turn = Turn::from_radians(angle);
    Point::new(turn.cos, turn.sin) * radius
}

/// The tips and the roots of the teeth, when one tooth has gone so far along the left pallet's face.
fn wheel(phase: f64) -> Vec<[Point; 3]> {
    let pitch = 2.0 * PI / f64::from(TEETH);
    let first = entry() - phase * ALONG;
    (0..TEETH)
        .map(|k| {
            let tip = first - pitch * f64::from(k);
            // The flank that drives is steep, the back is sloping.
            [polar(ROOT, tip + TOOTH / 2.0 + 0.1), polar(1.0, tip), polar(ROOT, tip - TOOTH / 2.0 + 0.1)]
        })
        .collect()
}

/// Where a tooth meets the left pallet: its angle on the circle of the tips.
fn entry() -> f64 {
    FRAC_PI_2 + SPAN * PI / f64::from(TEETH)
}

/// The pallet's pivot, from which both lines to the pallets touch the circle of the tips.
fn pivot() -> Point {
    Point::new(0.0, 1.0 / Turn::from_radians(SPAN * PI / f64::from(TEETH)).cos)
}

/// The corners of the left and of the right pallet, face first, when the left one's tooth has gone so far along its face.
fn pallets(phase: f64) -> [[Point; 4]; 2] {
    let arm = (pivot().norm_squared() - 1.0).sqrt();
    // Positive: the left pallet is lifted and the right one dips.
    let turned = -(phase - 0.5) * LIFT / arm;
    [entry(), PI - entry()].map(|angle| {
        let (place, outward) = (polar(1.0, angle), polar(1.0, angle));
        let along = Point::new(outward.y, -outward.x);
        let corner = |s: f64, n: f64| {
            let from_pivot = place + along * s + outward * n - pivot();
            let turn = Turn::from_radians(turned);
            pivot()
                + Point::new(
                    turn.cos * from_pivot.x - turn.sin * from_pivot.y,
                    turn.sin * from_pivot.x + turn.cos * from_pivot.y,
                )
        };
        // The curvature of the circle: a tooth that has gone s lies s²/2 below its tangent.
        [
            corner(0.0, LIFT / 2.0),
            corner(ALONG, -LIFT / 2.0 - ALONG * ALONG / 2.0),
            corner(ALONG, LIFT / 2.0 + THICK),
            corner(0.0, LIFT / 2.0 + THICK),
        ]
    })
}

/// A runaway escapement, to a scale of our own, and under it the wheel's speed from rest, with a torque and with twice that.
///
/// Series, a row for each drawn point: blows since the start, and the speed with both torques, over the root of torque times
/// angle from blow to blow over the wheel's inertia.
///
/// # Errors
///
/// [`FigureError`] if the model of the panel has no steady motion.
pub fn runaway() -> Result<Figure, FigureError> {
    let model = Runaway::new(1.0, PALLET, 1.0, Drag::default())?;
    let run = |torque: f64| {
        let (mut speed, mut points) = (0.0, Vec::new());
        for blow in 0..BLOWS {
            let path = model.between_blows(torque, speed);
            points.extend(path.iter().step_by(EACH).map(|(angle, speed)| (blow as f64 + angle, *speed)));
            speed = path.last().map_or(0.0, |last| last.1) * model.speed_retention();
        }
        points
    };
    let [once, twice] = [1.0, 2.0].map(run);
    let steady = [1.0, 2.0].map(|torque| model.steady(torque).map(|steady| steady.mean_speed));
    let [slow, fast] = [steady[0].clone()?, steady[1].clone()?];
    let x = ChartAxis::whole(0.0..BLOWS as f64, (0..=BLOWS).map(|blow| blow as f64));
    let x = x.titled(Label::words("blows since the start from rest"));
    let most = twice.iter().map(|point| point.1).fold(0.0, f64::max);
    let y = ChartAxis::from_zero(0.0, 1.1 * most, 3.0).titled(Label::words("speed of the wheel, without scale"));
    let (one, two) = (LineStyle::new(DRIVER).class("speed"), LineStyle::new(RELATIVE).dashed("9 4").class("speed"));
    let tops = |points: &[(f64, f64)]| points.iter().copied().filter(|(blows, _)| *blows > 2.9).collect::<Vec<_>>();
    let panel = Panel::new(230.0, &x, &y)
        .horizontal(slow, LineStyle::thin("mean").dashed("3 4"))
        .horizontal(fast, LineStyle::thin("mean").dashed("3 4"))
        .curve(twice.iter().copied(), two)
        .curve(once.iter().copied(), one)
        .name_near(tops(&twice), FRAC_PI_2, Label::words("twice the torque").in_colour(RELATIVE))
        .name_near(tops(&once), -FRAC_PI_2, Label::words("torque ").and_symbol("K").in_colour(DRIVER));
    let words = Words::new(
        "timer-runaway",
        "A runaway escapement, and the speed of its wheel",
        format!(
            "Above, a wheel with {TEETH} teeth that turns clockwise. Over it an anchor swings about its own pivot, with a \
             weight at either end of a bar and no spring. A tooth pushes its left pallet away from the wheel, while the right \
             pallet moves in between two teeth. Below, two saw-toothed curves of the wheel's speed: it rises from rest, drops \
             at each blow, and repeats itself after a few blows, about a mean of {} with the torque K and {} with twice the \
             torque.",
            significant(slow, 3),
            significant(fast, 3)
        ),
        format!(
            "A runaway escapement, drawn with dimensions of our own choice. The teeth throw the pallets to and fro, \
             and nothing but the inertia of the weighted bar resists them, because there is no balance spring. Below \
             is our model of it, in which each blow takes a fixed part of the energy (the pallet's inertia, reduced to \
             the wheel, is {PALLET} of the wheel's). In the steady motion each blow takes the energy that the torque \
             has supplied since the last blow, so twice the torque makes the mean speed (dotted) √2 times as great."
        ),
    );
    let columns = [("blows", "1"), ("speed K", "1"), ("speed 2K", "1")];
    let rows = once.iter().zip(&twice).map(|(one, two)| [one.0, one.1, two.1]);
    let series = Series::new(columns, rows);
    Ok(Chart::new([panel]).figure_below(words, series, ABOVE, draw))
}

/// The mechanism.
fn draw(canvas: &mut Canvas) {
    let view = View { origin: Pixels::new(320.0, 268.0), scale: SCALE };
    let place = |point: &Point| view.place(point);
    let outline: Vec<Pixels> =
        wheel(PHASE).iter().flat_map(|tooth| tooth.iter().map(place).collect::<Vec<_>>()).collect();
    canvas.draw(Shape::path(Path::through(&outline, 1)).fill(FILL).stroke(DRIVER, 2.5).class("toothed-wheel"));
    let centre = place(&Point::zeros());
    let hub = place(&pivot());
    let arm = (pivot().norm_squared() - 1.0).sqrt();
    let lean = -(PHASE - 0.5) * LIFT / arm;
    // The bar with its weights, behind the pallets.
    let ends = [PI, 0.0].map(|side| place(&(pivot() + polar(BAR, side + lean))));
    canvas.draw(Shape::line(&ends[0], &ends[1]).stroke(FOLLOWER, 5.0).class("bar"));
    for end in &ends {
        canvas.draw(Shape::circle(end, WEIGHT * SCALE).fill(FILL).stroke(FOLLOWER, 2.5).class("weight"));
    }
    for corners in pallets(PHASE) {
        let back = (corners[2] + corners[3]) / 2.0;
        canvas.draw(
            Shape::line(&hub, &place(&back)).stroke(FOLLOWER, 9.0).attribute("stroke-linecap", "round").class("arm"),
        );
        let outline: Vec<Pixels> = corners.iter().map(place).collect();
        let shape = Shape::path(Path::through(&outline, 1)).fill(PAPER).stroke(FOLLOWER, 2.5);
        canvas.draw(shape.attribute("stroke-linejoin", "round").class("pallet"));
    }
    fixed_pivot(canvas, &centre, 1.0);
    canvas.draw(Shape::circle(&hub, 9.0).fill(PAPER).stroke(INK, 2.0).class("pivot"));
    arc_arrow(canvas, &centre, 0.5 * SCALE, 2.5, 0.7, DRIVER, 2.5);
    arc_arrow(canvas, &hub, 0.24 * SCALE, FRAC_PI_2 + 0.9, FRAC_PI_2 - 0.9, FOLLOWER, 2.5);
    let right = Pixels::new(1.0, 0.0);
    let beside = |point: Pixels, label: Label, canvas: &mut Canvas| canvas.label(&point, &right, 8.0, &label);
    let up = Pixels::new(0.0, -1.0);
    canvas.label(
        &(centre + Pixels::new(0.0, -0.5 * SCALE + 16.0)),
        &-up,
        12.0,
        &Label::words("torque ").and_symbol("K").in_colour(DRIVER),
    );
    let weight = ends[1] + right * (WEIGHT * SCALE);
    beside(weight, Label::words("weighted bar").in_colour(FOLLOWER), canvas);
    let [left, exit] = pallets(PHASE);
    canvas.label(&place(&left[3]), &-right, 12.0, &Label::words("driven pallet").in_colour(FOLLOWER));
    beside(place(&exit[2]), Label::words("next to be hit").in_colour(FOLLOWER), canvas);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound};

    /// Whether a point lies inside of a polygon whose corners go round one way.
    fn inside(point: &Point, corners: &[Point]) -> bool {
        let mut crossings = 0;
        for (k, from) in corners.iter().enumerate() {
            let to = corners[(k + 1) % corners.len()];
            if (from.y > point.y) != (to.y > point.y)
                && point.x < from.x + (point.y - from.y) / (to.y - from.y) * (to.x - from.x)
            {
                crossings += 1;
            }
        }
        crossings % 2 == 1
    }

    #[test]
    fn one_tooth_pushes_the_left_pallet_and_no_tooth_cuts_into_either() {
        for phase in [0.0, 0.3, 0.6, 1.0] {
            let (teeth, [left, right]) = (wheel(phase), pallets(phase));
            // The driving tip lies on the face: a little outward is inside of the pallet, a little inward is not.
            let tip = teeth[0][1];
            let face = left[1] - left[0];
            let off = face.perp(&(tip - left[0])) / face.norm();
            assert!(off.abs() < 0.015, "{phase}: the tip is {off} off the face");
            for tooth in &teeth {
                for pallet in [left, right] {
                    for share in [0.0, 0.25, 0.5, 0.75, 1.0] {
                        for side in [[0, 1], [1, 2]] {
                            let point = tooth[side[0]].lerp(&tooth[side[1]], share) * 0.985;
                            assert!(!inside(&point, &pallet), "{phase}: {point}");
                        }
                    }
                    assert!(pallet.iter().all(|corner| !inside(corner, tooth)), "{phase}");
                }
            }
        }
    }

    #[test]
    fn the_right_pallet_goes_in_while_the_left_one_is_lifted() {
        let depth = |phase: f64| pallets(phase).map(|corners| corners[1].norm());
        let ([left, right], [later_left, later_right]) = (depth(0.1), depth(0.9));
        assert!(later_left > left + 0.05 && later_right < right - 0.05);
    }

    #[test]
    fn the_drawn_speeds_are_in_the_ratio_of_the_roots_and_drop_by_the_same_part_at_each_blow() {
        let figure = runaway().expect("drawn");
        assert_sound(&figure);
        let drawing = ParsedDrawing::parse(&figure);
        let counts = ["toothed-wheel", "pallet", "weight", "bar", "speed", "mean"].map(|class| drawing.count(class));
        assert_eq!(counts, [1, 2, 2, 1, 2, 2]);
        for row in &figure.series.rows {
            assert!((row[2] - 2.0_f64.sqrt() * row[1]).abs() < 1e-12, "{row:?}");
        }
        let jumps = figure.series.rows.windows(2).filter(|pair| pair[0][0] == pair[1][0]);
        let kept: Vec<f64> = jumps.map(|pair| pair[1][1] / pair[0][1]).collect();
        assert_eq!(kept.len(), BLOWS - 1);
        assert!(kept.iter().all(|part| (part - (1.0 - PALLET) / (1.0 + PALLET)).abs() < 1e-12), "{kept:?}");
    }
}
