//! A runaway escapement: a toothed wheel, a pallet with a weighted bar, no spring; and the speed that its blows leave.

use crate::chart::{Chart, ChartAxis, LineStyle, Panel};
use crate::moving::{self, turning_key, turning_rule};
use crate::number::{format_trimmed, significant};
use crate::parts::{WIDTH, arc_arrow, fixed_pivot};
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
/// From the middle of one pallet to that of the other, in pitches: two and a half, so that a tooth reaches either pallet as
/// another leaves the other one. A pallet lies half of it to either side of the line of centres.
const SPAN: f64 = 2.5;
/// How far a swing moves a pallet, and how thick a pallet is above its face, in radii of the tips.
const LIFT: f64 = 0.11;
const THICK: f64 = 0.12;
/// Part of a swing in which a tooth slides along a face. In the rest, the drop, no tooth touches a pallet, and both bodies go on.
const TOUCHING: f64 = 0.94;
/// Points of a face that are joined by straight lines.
const FACE_POINTS: u32 = 7;
/// Where the drawing stands if it does not move, as a part of the cycle.
const AT_REST: f64 = 0.15;
/// Seconds of a cycle, in which the wheel turns by one pitch.
const CYCLE: f64 = 3.0;
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

/// The figure's name, and its parts that move.
const NAME: &str = "timer-runaway";
const PARTS: [&str; 4] = ["wheel", "anchor", "entry", "exit"];

/// A point of the plane of the drawing, in radii of the tips.
type Point = Vector2<f64>;

fn polar(radius: f64, angle: f64) -> Point {
    let turn = Turn::from_radians(angle);
    Point::new(turn.cos, turn.sin) * radius
}

fn turned(point: &Point, angle: f64) -> Point {
    let turn = Turn::from_radians(angle);
    Point::new(turn.cos * point.x - turn.sin * point.y, turn.sin * point.x + turn.cos * point.y)
}

/// The angle from tooth to tooth, in radians.
fn pitch() -> f64 {
    2.0 * PI / f64::from(TEETH)
}

/// Leading root, tip and trailing root of each tooth, when the wheel has turned by so many pitches, clockwise. At zero, the first
/// tooth reaches the entry pallet; at one half, the third reaches the exit pallet.
fn wheel(cycle: f64) -> Vec<[Point; 3]> {
    let first = FRAC_PI_2 + (SPAN / 2.0 + 0.25 - cycle) * pitch();
    (0..TEETH)
        .map(|k| {
            let tip = first - pitch() * f64::from(k);
            // The flank that drives is steep, the back is sloping.
            [polar(ROOT, tip + TOOTH / 2.0 + 0.1), polar(1.0, tip), polar(ROOT, tip - TOOTH / 2.0 + 0.1)]
        })
        .collect()
}

/// The anchor's angle in radians, clockwise, after so many cycles from 0 to 1: the teeth throw it to and fro in proportion to
/// the wheel's angle.
fn swing(cycle: f64) -> f64 {
    let half = LIFT / arm_length() / 2.0;
    if cycle < 0.5 { (4.0 * cycle - 1.0) * half } else { (3.0 - 4.0 * cycle) * half }
}

/// The anchor's pivot, from which both lines to the pallets touch the circle of the tips.
fn pivot() -> Point {
    Point::new(0.0, 1.0 / Turn::from_radians(SPAN / 2.0 * pitch()).cos)
}

/// From the pivot to the middle of a pallet.
fn arm_length() -> f64 {
    (pivot().norm_squared() - 1.0).sqrt()
}

/// The entry and the exit pallet in the middle of a swing: face first, from where a tooth meets it to where the tooth leaves it.
///
/// Each face is the path of the tip that drives it, as seen from the anchor, so the two touch all the way.
fn pallets() -> [Vec<Point>; 2] {
    [(0.0, 0, 1.0), (0.5, 2, -1.0)].map(|(from, tooth, side)| {
        let seen = |k: u32| {
            let cycle = from + 0.5 * TOUCHING * f64::from(k) / f64::from(FACE_POINTS - 1);
            pivot() + turned(&(wheel(cycle)[tooth][1] - pivot()), swing(cycle))
        };
        let face: Vec<Point> = (0..FACE_POINTS).map(seen).collect();
        let outward = polar(1.0, FRAC_PI_2 + side * SPAN / 2.0 * pitch());
        let back = |point: &Point| point + outward * (1.0 + LIFT / 2.0 + THICK - point.dot(&outward));
        let backs = [back(&face[face.len() - 1]), back(&face[0])];
        face.into_iter().chain(backs).collect()
    })
}

/// A runaway escapement in motion, to a scale of our own, and under it the wheel's speed from rest, with a torque and with twice that.
///
/// It moves as the model of the panel does in the steady motion: from blow to blow its speed grows evenly with time. Series, a row for each drawn point: blows since the start, and the speed with both torques, over the root of torque times
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
        NAME,
        "A runaway escapement, and the speed of its wheel",
        format!(
            "Above, a wheel with {TEETH} teeth that turns clockwise. Over it an anchor swings about its own pivot, with a \
             weight at either end of a bar and no spring. A tooth pushes the anchor's left pallet away from the wheel, while \
             the right pallet moves in between two teeth. Then another tooth pushes the right pallet away, and the anchor \
             swings back. Below, two saw-toothed curves of the wheel's speed: it rises from rest, drops \
             at each blow, and repeats itself after a few blows, about a mean of {} with the torque K and {} with twice the \
             torque.",
            significant(slow, 3),
            significant(fast, 3)
        ),
        format!(
            "A runaway escapement, slowed down, with dimensions of our own choice. The teeth throw the pallets to and fro, \
             and nothing but the inertia of the weighted bar resists them, because there is no balance spring. A pallet is \
             filled while a tooth pushes it. Below is our model of it, in which each blow takes a fixed part of the energy (the pallet's inertia, reduced to \
             the wheel, is {PALLET} of the wheel's). In the steady motion each blow takes the energy that the torque \
             has supplied since the last blow, so twice the torque makes the mean speed (dotted) √2 times as great."
        ),
    );
    let columns = [("blows", "1"), ("speed K", "1"), ("speed 2K", "1")];
    let rows = once.iter().zip(&twice).map(|(one, two)| [one.0, one.1, two.1]);
    let series = Series::new(columns, rows);
    let ease = Ease::new(model.speed_retention());
    Ok(Chart::new([panel]).figure_below(words, series, ABOVE, |canvas| draw(canvas, ease)))
}

/// How a wheel goes from blow to blow under a constant torque: its angle `linear` t + `square` t², both from 0 to 1.
#[derive(Clone, Copy)]
struct Ease {
    linear: f64,
    square: f64,
}

impl Ease {
    /// From this part of its final speed on.
    fn new(first: f64) -> Self {
        Self { linear: 2.0 * first / (1.0 + first), square: (1.0 - first) / (1.0 + first) }
    }

    /// When the wheel has gone this part of its way.
    fn time(self, way: f64) -> f64 {
        ((self.linear * self.linear + 4.0 * self.square * way).sqrt() - self.linear) / (2.0 * self.square)
    }

    /// As CSS writes it: the cubic curve whose control points lie at a third and two thirds of the time is this one exactly.
    fn timing(self) -> String {
        let (first, second) = (self.linear / 3.0, (2.0 * self.linear + self.square) / 3.0);
        format!("cubic-bezier(.33333,{},.66667,{})", format_trimmed(first, 4), format_trimmed(second, 4))
    }
}

/// The rules that move wheel and anchor, and fill the pallet that is pushed.
fn style(ease: Ease, centre: &Pixels, hub: &Pixels) -> String {
    let [wheel, anchor, entry, exit] = PARTS.map(|part| format!("{NAME}-{part}"));
    let wheel_keys: String = [0.0, 0.5, 1.0].map(|cycle| turning_key(cycle, cycle * pitch())).concat();
    let anchor_keys: String = [0.0, 0.5, 1.0].map(|cycle| turning_key(cycle, swing(cycle))).concat();
    let touched = 0.5 * ease.time(TOUCHING);
    let key_frames = format!(
        "@keyframes {wheel}{{{wheel_keys}}}@keyframes {anchor}{{{anchor_keys}}}{}{}",
        moving::shown_while(&entry, [0.0, touched]),
        moving::shown_while(&exit, [0.5, 0.5 + touched])
    );
    let timing = format!("{}s {}", format_trimmed(CYCLE, 2), ease.timing());
    let rules = [
        turning_rule(&wheel, centre, &timing),
        turning_rule(&anchor, hub, &timing),
        moving::step_rule(&entry, CYCLE),
        moving::step_rule(&exit, CYCLE),
    ];
    moving::style(NAME, &key_frames, &rules.concat())
}

/// The mechanism.
fn draw(canvas: &mut Canvas, ease: Ease) {
    let view = View { origin: Pixels::new(320.0, 268.0), scale: SCALE };
    let place = |point: &Point| view.place(point);
    let (centre, hub) = (place(&Point::zeros()), place(&pivot()));
    canvas.draw_markup(style(ease, &centre, &hub));
    let [wheel_class, anchor_class, entry_class, exit_class] = PARTS.map(|part| format!("{NAME}-{part}"));
    moving::on_field(canvas, NAME, &Pixels::new(WIDTH, ABOVE), |canvas| {
        canvas.group(&moving::turned(&wheel_class, &centre, AT_REST * pitch()), |canvas| {
            let teeth = wheel(0.0);
            let outline: Vec<Pixels> = teeth.iter().flatten().map(place).collect();
            canvas.draw(Shape::path(Path::through(&outline, 1)).fill(FILL).stroke(DRIVER, 2.5).class("toothed-wheel"));
        });
        canvas.group(&moving::turned(&anchor_class, &hub, swing(AT_REST)), |canvas| {
            // The bar with its weights, behind the pallets.
            let ends = [-BAR, BAR].map(|end| place(&(pivot() + Point::new(end, 0.0))));
            canvas.draw(Shape::line(&ends[0], &ends[1]).stroke(FOLLOWER, 5.0).class("bar"));
            for end in &ends {
                canvas.draw(Shape::circle(end, WEIGHT * SCALE).fill(FILL).stroke(FOLLOWER, 2.5).class("weight"));
            }
            for (corners, (class, is_pushed)) in pallets().iter().zip([(&entry_class, true), (&exit_class, false)]) {
                let back = (corners[corners.len() - 2] + corners[corners.len() - 1]) / 2.0;
                let arm = Shape::line(&hub, &place(&back)).stroke(FOLLOWER, 9.0);
                canvas.draw(arm.attribute("stroke-linecap", "round").class("arm"));
                let outline: Vec<Pixels> = corners.iter().map(place).collect();
                moving::draw_pushed(canvas, &Path::through(&outline, 1), "pallet", class, is_pushed);
            }
        });
    });
    fixed_pivot(canvas, &centre, 1.0);
    canvas.draw(Shape::circle(&hub, 9.0).fill(PAPER).stroke(INK, 2.0).class("pivot"));
    arc_arrow(canvas, &centre, 0.5 * SCALE, 2.5, 0.7, DRIVER, 2.5);
    for end in [0.9, -0.9] {
        arc_arrow(canvas, &hub, 0.24 * SCALE, FRAC_PI_2, FRAC_PI_2 + end, FOLLOWER, 2.5);
    }
    let right = Pixels::new(1.0, 0.0);
    let torque = Label::words("torque ").and_symbol("K").in_colour(DRIVER);
    canvas.label(&(centre + Pixels::new(0.0, -0.5 * SCALE + 16.0)), &Pixels::new(0.0, 1.0), 12.0, &torque);
    let named = |text: &str| Label::words(text).in_colour(FOLLOWER);
    canvas.label(&(hub + right * ((BAR + WEIGHT) * SCALE)), &right, 10.0, &named("weighted bar"));
    for (corners, (side, name)) in pallets().iter().zip([(-right, "entry pallet"), (right, "exit pallet")]) {
        let outer = if side.x < 0.0 { corners[corners.len() - 1] } else { corners[corners.len() - 2] };
        canvas.label(&place(&outer), &side, 16.0, &named(name));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound, depth, overlap};

    /// Instants of a cycle that are looked at.
    const INSTANTS: u32 = 240;
    /// How deep a tooth may reach into a pallet, and how far it may be from a face that it pushes, in radii of the tips: less
    /// than a sixth of a pixel.
    const WITHIN: f64 = 0.001;
    const APART: f64 = 0.0005;

    fn instants() -> impl Iterator<Item = f64> {
        (0..INSTANTS).map(|k| f64::from(k) / f64::from(INSTANTS))
    }

    /// Both pallets after a part of the cycle.
    fn pallets_at(cycle: f64) -> [Vec<Point>; 2] {
        pallets()
            .map(|corners| corners.iter().map(|corner| pivot() + turned(&(corner - pivot()), -swing(cycle))).collect())
    }

    #[test]
    fn no_tooth_cuts_into_a_pallet_at_any_time() {
        for cycle in instants() {
            let pallets = pallets_at(cycle);
            for (k, tooth) in wheel(cycle).iter().enumerate() {
                for (pallet, name) in pallets.iter().zip(["entry", "exit"]) {
                    let within = overlap(tooth, pallet);
                    assert!(within < WITHIN, "{cycle}: tooth {k} is {within} within the {name} pallet");
                }
            }
        }
    }

    #[test]
    fn one_tooth_after_another_slides_along_a_face_and_pushes_it() {
        for cycle in instants() {
            let (swing_part, side) = if cycle < 0.5 { (2.0 * cycle, 0) } else { (2.0 * cycle - 1.0, 1) };
            let tip = wheel(cycle)[2 * side][1];
            let pallets = pallets_at(cycle);
            let gap = depth(&tip, &pallets[side]).abs();
            if swing_part <= TOUCHING {
                assert!(gap < APART, "{cycle}: the tip is {gap} off the face");
            } else if swing_part > TOUCHING + 0.02 {
                assert!(gap > APART, "{cycle}: the tooth has not left the face");
            }
            // It pushes: had the anchor stood still a moment ago, the tip would now be within the pallet.
            if swing_part > 0.05 && swing_part < TOUCHING {
                let within = depth(&tip, &pallets_at(cycle - 0.01)[side]);
                assert!(within > APART, "{cycle}: the tip is {within} within the pallet of a moment ago");
            }
        }
    }

    #[test]
    fn the_drawing_turns_its_bodies_as_they_go() {
        let svg = runaway().expect("drawn").svg;
        let half = (LIFT / arm_length() / 2.0).to_degrees();
        // Clockwise, as the page counts: the wheel always, the anchor while the entry pallet is lifted.
        for (body, angles) in [("wheel", [0.0, 15.0, 30.0]), ("anchor", [-half, half, -half])] {
            let [first, middle, last] =
                angles.map(|angle| format!("transform:rotate({}deg)", format_trimmed(angle, 2)));
            let keys = format!("@keyframes {NAME}-{body}{{0%{{{first}}}50%{{{middle}}}100%{{{last}}}}}");
            assert!(svg.contains(&keys), "no {keys}");
            let rest = angles[0] + 2.0 * AT_REST * (angles[1] - angles[0]);
            let turned = format!("class=\"{NAME}-{body}\" transform=\"rotate({} ", format_trimmed(rest, 2));
            assert!(svg.contains(&turned), "no {turned}");
        }
    }

    #[test]
    fn after_a_cycle_everything_is_where_the_next_begins() {
        assert_eq!(swing(0.0), swing(1.0));
        for (tooth, next) in wheel(1.0).iter().zip(wheel(0.0).iter().skip(1)) {
            assert!(tooth.iter().zip(next).all(|(a, b)| (a - b).norm() < 1e-12));
        }
    }

    #[test]
    fn the_curve_of_the_style_is_the_motion_from_blow_to_blow() {
        let ease = Ease::new(0.7);
        // Even acceleration: the speed at the end over the speed at the beginning.
        assert!((ease.linear / (ease.linear + 2.0 * ease.square) - 0.7).abs() < 1e-12);
        let [first, second] = [ease.linear / 3.0, (2.0 * ease.linear + ease.square) / 3.0];
        for t in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let way = ease.linear * t + ease.square * t * t;
            // The parameter of the curve is the time, for its control points are evenly spaced.
            let curve = 3.0 * first * t * (1.0 - t).powi(2) + 3.0 * second * t * t * (1.0 - t) + t.powi(3);
            assert!((curve - way).abs() < 1e-12 && (ease.time(way) - t).abs() < 1e-12, "{t}");
        }
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
