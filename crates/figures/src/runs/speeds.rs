//! Speeds of driver and follower over time, from rest.

use crate::escapement::axes::upright;
use crate::figure::{Figure, Words};
use crate::number::{fixed, significant};
use crate::panel::{Panel, Stroke, WIDTH};
use crate::plot::{Axis, Scale};
use crate::series::Series;
use crate::steady::MotionError;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{DRIVER, FOLLOWER, INK, PAPER};
use geneva_dynamics::Pose;
use geneva_dynamics::steady::{Engagement, Extreme};
use geneva_kinematics::Turn;
use nalgebra::Vector2;

/// Engagements that are shown, lines of the run in each, and every how many of them is a row of the series.
const ENGAGEMENTS: usize = 5;
const LINES: f64 = 200.0;
const KEPT: usize = 5;
const HEIGHT: u32 = 480;
/// The driver has reached its steady motion where an engagement ends so near it.
const SETTLED: f64 = 1e-9;

/// The driver's first minimum from rest: in the first engagement, once the follower has its speed.
///
/// # Errors
///
/// [`MotionError`] if there is no such place.
pub fn first_minimum(engagement: &Engagement) -> Result<Extreme, MotionError> {
    engagement.first_minimum()?.ok_or(MotionError::Nothing)
}

/// θ' and φ' over time from rest, with the first minimum of the driver's speed marked.
///
/// φ' is counted in the follower's own sense, against the driver's: it is not negative while a pin is in its slot.
/// `others` is what else is to be said of the run in the caption. Meyer 1973, Fig. 8, which is lost. Series, at
/// every fifth instant: time, θ', φ'.
///
/// # Errors
///
/// [`MotionError`] if there is no steady motion.
pub fn speeds(engagement: &Engagement, others: &str) -> Result<Figure, MotionError> {
    let rise = engagement.rise(SETTLED)?;
    let steady = rise.steady;
    let Extreme { time: first, speed: first_speed, .. } = first_minimum(engagement)?;
    let begin = rise.cycles.first().map_or(0.0, |cycle| cycle.end);
    let duration = begin + (ENGAGEMENTS - 1) as f64 * steady.period;
    let lines = engagement.run(steady.period / LINES, duration)?;
    let ratio = engagement.parameters().mechanism().centre_distance_ratio();
    // From the geometry of the pose, which holds beyond the exit too.
    let rows: Vec<[f64; 3]> = lines
        .iter()
        .map(|line| {
            let pose = Pose::new(&ratio, &Turn::from_radians(line.angle));
            [line.time, line.speed, pose.velocity_ratio() * line.speed]
        })
        .collect();
    let ms = |time: f64| 1000.0 * time;
    let least = rows.iter().map(|row| row[2]).fold(0.0, f64::min);
    let most = rows.iter().flat_map(|row| [row[1], row[2]]).fold(steady.peak.speed, f64::max);
    let left = upright(if least < -1e-3 * most { least } else { 0.0 }, most, 5.0);
    let level = upright(0.0, ms(duration) / 1.04, 5.0);
    let level = Axis { range: 0.0..ms(duration), scale: Scale::Even, ..level };
    let level = Axis { marks: level.marks.iter().copied().filter(|mark| *mark <= ms(duration)).collect(), ..level };
    let key = 56.0;
    let panel = Panel::new(Vector2::new(0.0, key), HEIGHT, level, left);
    let mut canvas = Canvas::new(f64::from(WIDTH), f64::from(HEIGHT) + key);
    panel.draw(&mut canvas, true);
    let zero = [0.0, ms(duration)].map(|x| panel.at((x, 0.0)));
    canvas.draw(Shape::line(&zero[0], &zero[1]).stroke(INK, 1.2).class("zero"));
    let column = |k: usize| rows.iter().map(|row| (ms(row[0]), row[k])).collect::<Vec<_>>();
    let follower = Stroke { shade: FOLLOWER, width: 2.2, dashes: Some("7 4"), class: "follower" };
    let driver = Stroke { shade: DRIVER, width: 2.6, dashes: None, class: "driver" };
    for (k, stroke) in [(2, follower), (1, driver)] {
        panel.curve(&mut canvas, &column(k), stroke);
    }
    let at = panel.at((ms(first), first_speed));
    let ring = |at: &Pixels| Shape::circle(at, 6.0).fill(PAPER).stroke(INK, 2.0);
    canvas.draw(ring(&at).class("first-minimum"));
    let beside = Vector2::new(36.0, 48.0);
    canvas.draw(ring(&beside));
    let label = Label::words(&format!("first minimum, after {} ms", fixed(ms(first), 1))).bare();
    canvas.label(&beside, &Vector2::new(1.0, 0.0), 30.0, &label);
    panel.name(&mut canvas, &Label::words("speeds in rad/s"));
    panel.foot(&mut canvas, &Label::words("time from rest in ms"));
    samples(&mut canvas, [driver, follower]);
    let greatest = rows.iter().map(|row| row[2]).fold(0.0, f64::max);
    let words = Words {
        id: "runs-speeds".to_owned(),
        title: "Speeds of driver and follower over time, from rest".to_owned(),
        description: format!(
            "Two curves over time, from rest through {ENGAGEMENTS} engagements. The driver's speed rises, and then \
             swings between {} and {} rad/s in every engagement. The follower starts and stops in each, turning the \
             other way, at up to {} rad/s. A ring marks the driver's first minimum, in the first engagement, after {} \
             ms.",
            significant(steady.minimum.speed, 3),
            significant(steady.peak.speed, 3),
            significant(greatest, 3),
            fixed(ms(first), 1)
        ),
        caption: format!(
            "From rest. The driver slows down while it speeds the follower up, and gets the motion back as the \
             follower stops. The follower's speed is counted in its own sense, against the driver's. {others}"
        )
        .trim_end()
        .to_owned(),
    };
    let columns = [("t", "s"), ("theta'", "rad/s"), ("phi'", "rad/s")];
    Ok(words.figure(canvas, Kind::Plot, Series::new(columns, rows.into_iter().step_by(KEPT))))
}

/// What the curves are, above the frame.
fn samples(canvas: &mut Canvas, strokes: [Stroke; 2]) {
    let names = ["driver ", "follower "].into_iter().zip(["θ", "φ"]);
    let places = [(16.0, ""), (190.0, ", the other way round")];
    for ((stroke, (name, symbol)), (x, more)) in strokes.into_iter().zip(names).zip(places) {
        let at = |x: f64| Vector2::new(x, 20.0);
        let line = Shape::line(&at(x), &at(x + 40.0)).stroke(stroke.shade, stroke.width);
        canvas.draw(match stroke.dashes {
            Some(dashes) => line.dashed(dashes),
            None => line,
        });
        let label = Label::words(name).and_symbol(symbol).and("\u{200a}′").and(more).shade(stroke.shade).bare();
        canvas.label(&at(x + 40.0), &Vector2::new(1.0, 0.0), 10.0, &label);
    }
}
