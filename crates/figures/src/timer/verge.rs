//! A verge with its foliot, in motion: a crown wheel whose upper and lower teeth push two pallets by turns, to and fro.

use crate::moving::{self, turning_key, turning_rule};
use crate::number::format_trimmed;
use crate::parts::{WIDTH, arrow};
use crate::svg::{Canvas, DrawingKind, Label, Path, Pixels, Shape, View};
use crate::theme::{DRIVER, FILL, FOLLOWER, INK, PAPER};
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// The figure's name, and the class of what swings.
const NAME: &str = "timer-verge";
const VERGE: &str = "timer-verge-verge";

/// Teeth of the crown wheel: an odd number, so that the middle of a gap is opposite each tooth.
const TEETH: u32 = 13;
/// A tooth, in radii of the wheel: how high it is, and how far the roots of its leading and of its trailing flank are behind
/// its tip.
const HEIGHT: f64 = 0.24;
const LEADING: f64 = 0.03;
const TRAILING: f64 = 0.25;
/// How far the middle of a tooth is behind its tip, in radians: a tooth is flat, and there it touches the round rim.
const LEAN: f64 = 0.125;
/// From the tips to the axis of the verge, and how thick a pallet is, in radii of the wheel.
const DISTANCE: f64 = 0.165;
const THICK: f64 = 0.05;
/// The angle between the pallets; of the verge from the middle of its swing, where a tooth leaves a pallet, where the next one
/// meets the other pallet, and where the swing ends. All in degrees.
const BETWEEN: f64 = 95.0;
const LEAVES: f64 = 14.0;
const MEETS: f64 = 16.0;
const FARTHEST: f64 = 24.0;

/// Seconds of a cycle, in which the wheel turns by one pitch and the verge swings to and fro.
const CYCLE: f64 = 4.0;
/// Where the drawing stands if it does not move, as a part of the cycle: a tooth pushes the upper pallet.
const AT_REST: f64 = 0.36;
/// Instants of each of the six parts of a cycle at which the motion is computed.
const STEPS: u32 = 16;
/// How far straight lines between key frames may be from the motion of the verge and of teeth that touch a pallet, and from that of
/// other teeth, in pixels.
const NEAR_PALLET: f64 = 0.12;
const ELSEWHERE: f64 = 0.8;

/// Half the foliot and the radius of its weights, in radii of the wheel.
const FOLIOT: f64 = 1.27;
const WEIGHT: f64 = 0.085;
/// Where the tips are in the middle of the drawing, pixels of a radius, and the height of the rim and of the drawing in pixels.
const MIDDLE: [f64; 2] = [320.0, 186.0];
const SCALE: f64 = 210.0;
const RIM: f64 = 64.0;
const HIGH: f64 = 340.0;
/// Half the width of the wheel's axle in radii of the wheel, and how much of its length is drawn, in pixels.
const AXLE: f64 = 0.08;
const AXLE_LENGTH: f64 = 34.0;

/// A point of the plane of the drawing, in radii of the wheel: x to the right, y from the wheel to the verge, from the
/// middle of the tips.
type Point = Vector2<f64>;

/// One instant: the part of the cycle that is over, and the angles of the wheel (from when a tooth is at the front) and of the verge
/// (from the middle of its swing, counter-clockwise as seen), in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Instant {
    share: f64,
    wheel: f64,
    verge: f64,
}

/// The upper pallet, which the teeth at the front push to the right, and the lower one, which those behind push to the left.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Pallet {
    Upper,
    Lower,
}

impl Pallet {
    /// +1 for the upper pallet, −1 for the lower.
    fn side(self) -> f64 {
        match self {
            Self::Upper => 1.0,
            Self::Lower => -1.0,
        }
    }

    /// The corners of the pallet: the face from the axis of the verge to its end, then the back.
    fn corners(self, verge: f64) -> [Point; 4] {
        let turn = Turn::from_radians(verge + self.side() * BETWEEN.to_radians() / 2.0);
        let (along, aside) = (Point::new(turn.sin, -turn.cos), Point::new(turn.cos, turn.sin) * self.side());
        let axis = Point::new(0.0, DISTANCE);
        [axis, axis + along * pallet_length(), axis + along * pallet_length() + aside * THICK, axis + aside * THICK]
    }
}

/// So long that the tooth leaves the pallet where it should.
fn pallet_length() -> f64 {
    DISTANCE / Turn::from_radians((BETWEEN / 2.0 + LEAVES).to_radians()).cos
}

fn pitch() -> f64 {
    2.0 * PI / f64::from(TEETH)
}

/// The angle of the tooth whose tip touches the upper pallet's face, from the front.
fn touching(verge: f64) -> f64 {
    let turn = Turn::from_radians(verge + BETWEEN.to_radians() / 2.0);
    libm::asin(DISTANCE * turn.sin / turn.cos)
}

/// The cycle, from where a tooth meets the upper pallet to where the next one does.
///
/// A tooth meets the pallet while the foliot swings towards it, and is pushed back until the foliot has come to rest. Then it
/// pushes the pallet until it leaves it. The torque on the verge is taken as constant, so the speed of the verge changes
/// evenly, but for the blow with which a tooth and a pallet meet. In the drop between them it is constant.
fn cycle() -> Vec<Instant> {
    let [leaves, meets, farthest] = [LEAVES, MEETS, FARTHEST].map(f64::to_radians);
    // With a unit of torque over inertia: the speeds before and after the blow, and the times from them.
    let (before, after) = ((2.0 * (leaves + farthest)).sqrt(), (2.0 * (farthest - meets)).sqrt());
    let (back, push, drop) = (after, before, (meets - leaves) / before);
    let half = back + push + drop;
    let mut instants = Vec::new();
    let mut add = |from: f64, time: f64, wheel: f64, verge: f64| {
        instants.push(Instant { share: (from + time) / half / 2.0, wheel, verge });
    };
    let share = |k: u32| f64::from(k) / f64::from(STEPS);
    let turned = [touching(leaves), pitch() / 2.0 + touching(-meets)];
    for (side, start) in [(1.0, 0.0), (-1.0, half)] {
        let before = if side > 0.0 { 0.0 } else { pitch() / 2.0 };
        let mut touched = |from: f64, time: f64, verge: f64| add(from, time, before + touching(verge), side * verge);
        for k in 0..STEPS {
            let left = back * (1.0 - share(k));
            touched(start, back * share(k), left * left / 2.0 - farthest);
        }
        for k in 0..=STEPS {
            let time = push * share(k);
            touched(start + back, time, time * time / 2.0 - farthest);
        }
        for k in 1..STEPS {
            let wheel = before + turned[0] + (turned[1] - turned[0]) * share(k);
            add(start + back + push, drop * share(k), wheel, side * (leaves + (meets - leaves) * share(k)));
        }
    }
    add(2.0 * half, 0.0, pitch() + touching(-meets), -meets);
    instants
}

/// Where a tooth's tip is seen, and how wide the tooth looks, compared with one at the front: the sine of the tip's angle from
/// the front and the cosine of that of the tooth's middle. The width of a tooth behind is negative.
fn seen(tooth: i32, wheel: f64) -> [f64; 2] {
    let angle = wheel + f64::from(tooth) * pitch();
    [Turn::from_radians(angle).sin, Turn::from_radians(angle - LEAN).cos]
}

/// The numbers of the teeth that are seen on one side at some time of a cycle.
fn teeth(pallet: Pallet, instants: &[Instant]) -> Vec<i32> {
    let count = i32::try_from(TEETH).unwrap_or_default();
    let first = if pallet == Pallet::Upper { -count / 2 } else { 0 };
    let is_seen = |tooth: &i32| instants.iter().any(|at| seen(*tooth, at.wheel)[1] * pallet.side() > 0.0);
    (first..first + count).filter(is_seen).collect()
}

/// The corners of a tooth whose tip is seen there and which looks so wide: leading root, tip, trailing root.
fn tooth([tip, width]: [f64; 2]) -> [Point; 3] {
    [Point::new(tip - LEADING * width, -HEIGHT), Point::new(tip, 0.0), Point::new(tip - TRAILING * width, -HEIGHT)]
}

/// The instants of a motion between which straight lines are near enough to it: numbers of a list in which `off` says how far
/// one is from the line between two others, in tolerances.
fn key_frames(count: usize, off: &impl Fn([usize; 3]) -> f64) -> Vec<usize> {
    fn part(from: usize, to: usize, off: &impl Fn([usize; 3]) -> f64, keys: &mut Vec<usize>) {
        let off_here = |k: usize| off([from, k, to]);
        if let Some(worst) = (from + 1..to).max_by(|a, b| off_here(*a).total_cmp(&off_here(*b)))
            && off_here(worst) > 1.0
        {
            part(from, worst, off, keys);
            keys.push(worst);
            part(worst, to, off, keys);
        }
    }
    let last = count.saturating_sub(1);
    let mut keys = vec![0];
    part(0, last, off, &mut keys);
    keys.push(last);
    keys
}

/// How far a number is from the straight line over the cycle between two instants.
fn off_the_line(instants: &[Instant], [from, at, to]: [usize; 3], number: impl Fn(&Instant) -> f64) -> f64 {
    let [a, b, c] = [from, at, to].map(|k| &instants[k]);
    let share = if c.share > a.share { (b.share - a.share) / (c.share - a.share) } else { 0.0 };
    (number(b) - number(a) - share * (number(c) - number(a))).abs()
}

/// A tooth on one side at an instant: none of it is seen while it is on the other side.
fn on_side(pallet: Pallet, tooth: i32, at: &Instant) -> [f64; 2] {
    let [tip, width] = seen(tooth, at.wheel);
    [tip, pallet.side() * (pallet.side() * width).max(0.0)]
}

fn pushed_class(pallet: Pallet) -> String {
    format!("{NAME}-{}", if pallet == Pallet::Upper { "upper" } else { "lower" })
}

fn tooth_class(pallet: Pallet, place: usize) -> String {
    format!("{NAME}-{}{place}", if pallet == Pallet::Upper { "u" } else { "l" })
}

/// The key frames of one tooth on one side.
fn tooth_keys(pallet: Pallet, tooth: i32, instants: &[Instant]) -> String {
    let value = |k: usize| move |at: &Instant| on_side(pallet, tooth, at)[k];
    // The teeth that meet a pallet in this cycle or leave it: in the one before, each was a place farther back.
    let is_near =
        instants.iter().any(|at| (0.0..0.9 * pallet_length()).contains(&(pallet.side() * seen(tooth, at.wheel)[0])));
    let off = |at| {
        let [tip, width] = [0, 1].map(|k| off_the_line(instants, at, value(k)) * SCALE);
        // Half a tooth is its mean width.
        tip.max(width * TRAILING / 2.0) / if is_near { NEAR_PALLET } else { ELSEWHERE }
    };
    let key = |k: usize| {
        let at = &instants[k];
        let ([tip, width], share) = (on_side(pallet, tooth, at), format_trimmed(100.0 * at.share, 2));
        let [tip, width] = [format_trimmed(tip * SCALE, 1), format_trimmed(width, 2)];
        format!("{share}%{{transform:translate({tip}px)scaleX({width})}}")
    };
    key_frames(instants.len(), &off).into_iter().map(key).collect()
}

/// The part of the cycle, from its beginning, in which a tooth touches the upper pallet. Half a cycle later, one touches the
/// lower pallet as long.
fn touched(instants: &[Instant]) -> f64 {
    instants.get(2 * STEPS as usize).map_or(0.0, |at| at.share)
}

/// The rules that move the teeth and the verge, and fill the pallet that a tooth touches.
fn style(instants: &[Instant], axis: &Pixels) -> String {
    let timing = format!("{}s linear", format_trimmed(CYCLE, 2));
    let (mut frames, mut rules) = (String::new(), String::new());
    for (pallet, from) in [(Pallet::Lower, 0.5), (Pallet::Upper, 0.0)] {
        for (place, number) in teeth(pallet, instants).into_iter().enumerate() {
            let class = tooth_class(pallet, place);
            frames += &format!("@keyframes {class}{{{}}}", tooth_keys(pallet, number, instants));
            rules += &format!(".{class}{{animation:{class} {timing} infinite}}");
        }
        frames += &moving::shown_while(&pushed_class(pallet), [from, from + touched(instants)]);
        rules += &moving::step_rule(&pushed_class(pallet), CYCLE);
    }
    let off = |at| off_the_line(instants, at, |at| at.verge) * SCALE * pallet_length() / NEAR_PALLET;
    let keys = key_frames(instants.len(), &off);
    let verge: String = keys.into_iter().map(|k| turning_key(instants[k].share, -instants[k].verge)).collect();
    frames += &format!("@keyframes {VERGE}{{{verge}}}");
    rules += &turning_rule(VERGE, axis, &timing);
    moving::style(NAME, &frames, &rules)
}

/// A verge with its foliot in motion, to a scale of our own, seen along the verge.
///
/// Series, a row for each computed instant: the part of the cycle, and the angles by which wheel and verge have turned since
/// its beginning, in degrees.
pub fn verge() -> Figure {
    let instants = cycle();
    let mut canvas = Canvas::new(WIDTH, HIGH);
    draw(&mut canvas, &instants);
    let words = Words::new(
        NAME,
        "A verge with its foliot",
        format!(
            "A crown wheel with {TEETH} teeth, seen from its rim. Its upper teeth, in front, go to the right, its lower teeth, \
             behind, to the left. Before the tips is the verge, seen from its end, with two pallets at about a right angle and \
             a long bar with a weight at either end, the foliot. An upper tooth pushes the upper pallet to the right and leaves \
             it. Then a lower tooth meets the lower pallet, is pushed back a little, stops the foliot and pushes it back."
        ),
        "A verge with its foliot, seen from above and slowed down, with dimensions of our own choice. The crown wheel's upper \
         teeth push the upper pallet to the right. Its lower teeth, drawn faint, push the lower pallet to the left. A pallet \
         is filled while a tooth touches it. When they meet, the foliot still swings on and pushes the wheel back a little.",
    );
    let start = instants[0];
    let row = |at: &Instant| [at.share, (at.wheel - start.wheel).to_degrees(), (at.verge - start.verge).to_degrees()];
    let series = Series::new([("cycle", "1"), ("wheel", "deg"), ("verge", "deg")], instants.iter().map(row));
    words.figure(canvas, DrawingKind::Mechanism, series)
}

/// The drawing, from what is lowest to what is uppermost.
fn draw(canvas: &mut Canvas, instants: &[Instant]) {
    let view = View { origin: Pixels::from(MIDDLE), scale: SCALE };
    let axis = view.place(&Point::new(0.0, DISTANCE));
    let rest = instants.iter().min_by(|a, b| (a.share - AT_REST).abs().total_cmp(&(b.share - AT_REST).abs()));
    let rest = *rest.unwrap_or(&Instant { share: 0.0, wheel: 0.0, verge: 0.0 });
    canvas.draw_markup(style(instants, &axis));
    let corner = |x: f64, y: f64| view.place(&Point::new(x, y));
    let bottom = -HEIGHT - RIM / SCALE;
    let outline = [corner(-1.0, -HEIGHT), corner(1.0, -HEIGHT), corner(1.0, bottom), corner(-1.0, bottom)];
    let end = bottom - AXLE_LENGTH / SCALE;
    let axle = [corner(-AXLE, end), corner(-AXLE, bottom), corner(AXLE, bottom), corner(AXLE, end)];
    moving::on_field(canvas, NAME, &Pixels::new(WIDTH, HIGH), |canvas| {
        canvas.draw(Shape::path(Path::along(&axle, 1)).fill(FILL).stroke(DRIVER, 2.5).class("axle"));
        canvas.faint(0.45, "", |canvas| {
            draw_teeth(canvas, Pallet::Lower, instants, &rest);
            canvas.group(&moving::turned(VERGE, &axis, -rest.verge), |canvas| {
                draw_pallet(canvas, Pallet::Lower, &view);
            });
        });
        draw_teeth(canvas, Pallet::Upper, instants, &rest);
        canvas.draw(Shape::path(Path::through(&outline, 1)).fill(FILL).stroke(DRIVER, 2.5).class("rim"));
        canvas.group(&moving::turned(VERGE, &axis, -rest.verge), |canvas| {
            draw_pallet(canvas, Pallet::Upper, &view);
            let ends = [-FOLIOT, FOLIOT].map(|end| corner(end, DISTANCE));
            canvas.draw(Shape::line(&ends[0], &ends[1]).stroke(FOLLOWER, 5.0).class("foliot"));
            for end in &ends {
                canvas.draw(Shape::circle(end, WEIGHT * SCALE).fill(FILL).stroke(FOLLOWER, 2.5).class("weight"));
            }
        });
    });
    canvas.draw(Shape::circle(&axis, 9.0).fill(PAPER).stroke(INK, 2.0).class("verge"));
    label(canvas, &view);
}

/// The teeth of one side, each in its place: as wide as it is and moved sideways.
fn draw_teeth(canvas: &mut Canvas, pallet: Pallet, instants: &[Instant], rest: &Instant) {
    let [x, y] = MIDDLE.map(|value| format_trimmed(value, 2));
    let outline = tooth([0.0, 1.0]).map(|corner| Pixels::new(corner.x, -corner.y) * SCALE);
    canvas.group(&format!("transform=\"translate({x} {y})\""), |canvas| {
        for (place, number) in teeth(pallet, instants).into_iter().enumerate() {
            let [tip, width] = on_side(pallet, number, rest);
            let [tip, width] = [format_trimmed(tip * SCALE, 1), format_trimmed(width, 2)];
            let shape = Shape::path(Path::along(&outline, 1)).fill(FILL).stroke(DRIVER, 2.5);
            let shape = shape.class(&tooth_class(pallet, place)).attribute("vector-effect", "non-scaling-stroke");
            let shape = shape.attribute("stroke-linejoin", "round");
            canvas.draw_markup(shape.attribute("transform", &format!("translate({tip})scale({width} 1)")).markup());
        }
    });
}

/// A pallet in the middle of the swing.
fn draw_pallet(canvas: &mut Canvas, pallet: Pallet, view: &View) {
    let outline = pallet.corners(0.0).map(|corner| view.place(&corner));
    let is_pushed = pallet == Pallet::Upper;
    moving::draw_pushed(canvas, &Path::through(&outline, 1), "pallet", &pushed_class(pallet), is_pushed);
}

/// What the parts are, and which way the teeth go.
fn label(canvas: &mut Canvas, view: &View) {
    let at = |x: f64, y: f64| view.place(&Point::new(x, y));
    let none = Pixels::zeros();
    canvas.label(&at(0.0, DISTANCE + 0.17), &none, 0.0, &Label::words("verge"));
    canvas.label(&at(0.6, DISTANCE + 0.45), &none, 0.0, &Label::words("foliot").in_colour(FOLLOWER));
    for (line, ends, text) in [(0.0, [0.36, 0.66], "upper teeth"), (26.0, [-0.53, -0.83], "lower teeth, behind")] {
        let y = -HEIGHT - (19.0 + line) / SCALE;
        canvas.label(&at(0.0, y), &none, 0.0, &Label::words(text).in_colour(DRIVER));
        let [tail, tip] = ends.map(|x| at(x, y));
        arrow(canvas, &tail, &tip, DRIVER, 2.5, "way");
    }
    let beside = at(AXLE, -HEIGHT - (RIM + AXLE_LENGTH / 2.0) / SCALE);
    canvas.label(&beside, &Pixels::new(1.0, 0.0), 12.0, &Label::words("crown wheel").in_colour(DRIVER));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound, depth, overlap};

    /// Instants of a cycle at which the drawing is looked at, between its key frames, too.
    const INSTANTS: u32 = 500;
    /// How deep a tooth may reach into a pallet, and how far it may be from a face that it pushes, in radii of the wheel: less
    /// than half a pixel.
    const WITHIN: f64 = 0.002;

    /// The numbers in the key frames of this name: share of the cycle, then the numbers of the transform.
    fn keys(svg: &str, name: &str) -> Vec<Vec<f64>> {
        let (_, frames) = svg.split_once(&format!("@keyframes {name}{{")).expect("key frames");
        let frames = frames.split_once("}}").expect("an end").0;
        let numbers = |frame: &str| {
            let parts = frame.split(|c: char| !c.is_ascii_digit() && !"-.".contains(c));
            parts.filter_map(|part| part.parse().ok()).collect()
        };
        frames.split('}').map(numbers).collect()
    }

    /// What a browser shows between key frames.
    fn shown(keys: &[Vec<f64>], share: f64) -> Vec<f64> {
        let pair = keys.windows(2).find(|pair| pair[1][0] >= 100.0 * share).expect("within the cycle");
        let part = (100.0 * share - pair[0][0]) / (pair[1][0] - pair[0][0]);
        pair[0].iter().zip(&pair[1]).skip(1).map(|(a, b)| a + part * (b - a)).collect()
    }

    /// The teeth of one side and its pallet, as a browser shows them.
    fn shown_parts(svg: &str, pallet: Pallet) -> Vec<(f64, Vec<[Point; 3]>, [Point; 4])> {
        let verge = keys(svg, VERGE);
        let count = teeth(pallet, &cycle()).len();
        let teeth: Vec<_> = (0..count).map(|place| keys(svg, &tooth_class(pallet, place))).collect();
        let instants = (0..=INSTANTS).map(|k| f64::from(k) / f64::from(INSTANTS));
        let parts = instants.map(|share| {
            let look = |keys: &Vec<Vec<f64>>| {
                let [tip, width] = shown(keys, share)[..] else { panic!("two numbers") };
                tooth([tip / SCALE, width])
            };
            (share, teeth.iter().map(look).collect(), pallet.corners(-shown(&verge, share)[0].to_radians()))
        });
        parts.collect()
    }

    #[test]
    fn no_tooth_cuts_into_a_pallet_at_any_time() {
        let svg = verge().svg;
        for pallet in [Pallet::Upper, Pallet::Lower] {
            for (share, teeth, corners) in shown_parts(&svg, pallet) {
                for (place, tooth) in teeth.iter().enumerate() {
                    let within = overlap(tooth, &corners);
                    assert!(within < WITHIN, "{share}: tooth {place} is {within} within the {pallet:?} pallet");
                }
            }
        }
    }

    #[test]
    fn but_for_the_drop_one_tooth_touches_one_pallet() {
        let (svg, instants) = (verge().svg, cycle());
        let [upper, lower] = [Pallet::Upper, Pallet::Lower].map(|pallet| shown_parts(&svg, pallet));
        let drop = |share: f64| {
            let after = instants.iter().position(|at| at.share >= share).expect("within the cycle");
            let half = after % (instants.len() / 2);
            half > 2 * STEPS as usize || half == 0
        };
        for (upper, lower) in upper.iter().zip(&lower) {
            let share = upper.0;
            let touches = [upper, lower].map(|(_, teeth, corners)| {
                teeth.iter().filter(|tooth| depth(&tooth[1], corners).abs() < WITHIN).count()
            });
            match (drop(share), share < 0.5) {
                (true, _) => assert!(touches.iter().sum::<usize>() <= 1, "{share}: {touches:?}"),
                (false, true) => assert_eq!(touches, [1, 0], "{share}"),
                (false, false) => assert_eq!(touches, [0, 1], "{share}"),
            }
        }
    }

    #[test]
    fn after_a_cycle_every_tooth_is_where_the_next_was_and_the_verge_where_it_was() {
        let svg = verge().svg;
        for pallet in [Pallet::Upper, Pallet::Lower] {
            let all = shown_parts(&svg, pallet);
            let (first, last) = (&all[0], &all[all.len() - 1]);
            assert!(first.2.iter().zip(&last.2).all(|(a, b)| (a - b).norm() < 1e-3));
            // The upper teeth go to the next place; the last of them goes out of sight.
            for (tooth, next) in last.1.iter().zip(first.1.iter().skip(1)) {
                assert!(tooth.iter().zip(next).all(|(a, b)| (a - b).norm() < 4e-3), "{tooth:?} {next:?}");
            }
        }
    }

    #[test]
    fn half_a_cycle_later_the_lower_side_does_what_the_upper_did() {
        let instants = cycle();
        let half = instants.len() / 2;
        for (one, other) in instants.iter().zip(&instants[half..]) {
            assert!((other.share - one.share - 0.5).abs() < 1e-12);
            assert!((other.wheel - one.wheel - pitch() / 2.0).abs() < 1e-12);
            assert!((other.verge + one.verge).abs() < 1e-12);
        }
        // The wheel goes back while the foliot swings on, and jumps ahead in the drop.
        let steps: Vec<f64> = instants.windows(2).map(|pair| pair[1].wheel - pair[0].wheel).collect();
        let [back, push, drop] = [0, 1, 2].map(|part| {
            let steps = &steps[part * STEPS as usize..(part + 1) * STEPS as usize];
            (steps.iter().all(|step| *step < 0.0), steps.iter().all(|step| *step > 0.0))
        });
        assert_eq!([back, push, drop], [(true, false), (false, true), (false, true)]);
    }

    #[test]
    fn the_number_of_teeth_is_odd_and_all_parts_are_drawn() {
        assert_eq!(TEETH % 2, 1);
        let figure = verge();
        assert_sound(&figure);
        let drawing = ParsedDrawing::parse(&figure);
        let counts = ["rim", "pallet", "weight", "foliot", "verge", "way"].map(|class| drawing.count(class));
        assert_eq!(counts, [1, 2, 2, 1, 1, 4]);
    }
}
