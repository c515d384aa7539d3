//! The driver's speed over its angle, engagement by engagement, from rest and from above.

use super::error::MotionError;
use crate::escapement::axes::upright;
use crate::escapement::engagement::{Engagement as Followed, Instant};
use crate::figure::{Figure, Words};
use crate::markers::Mark;
use crate::number::{degrees, shown, significant, trimmed};
use crate::panel::{Panel, Stroke, WIDTH};
use crate::plot::{Axis, Scale};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::placing::around;
use crate::svg::shape::Shape;
use crate::theme::{CORIOLIS, DRIVER, FOLLOWER, INK};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use nalgebra::Vector2;
use std::f64::consts::FRAC_PI_4;

const HEIGHT: u32 = 520;
/// Engagements from rest, and from above.
const SHOWN: usize = 3;
/// The start from above, in steady entry speeds.
const ABOVE: f64 = 2.0;
/// Marks of the angle to either side of the line of centres.
const MARKS: i32 = 3;
/// Every how many instants of the drawing are a row of the series.
const KEPT: usize = 6;
const NEAR: [f64; 6] = [10.0, 16.0, 24.0, 34.0, 46.0, 60.0];

/// One engagement: angle in degrees and speed, and the switch.
struct Round {
    points: Vec<(f64, f64)>,
    switch: Option<(f64, f64)>,
    end: f64,
}

/// θ' over θ in successive engagements, from rest and from twice the steady speed at entry, with the steady cycle.
///
/// Speeds are over √(K / I_f). Marks show where the friction changes its sign past the line of centres; it also does on
/// the line of centres. Series: θ, then θ' of the engagements from rest, of those from above, and in the steady cycle.
///
/// # Errors
///
/// [`MotionError`] if there is no steady motion or it cannot be followed.
pub fn phase(parameters: &Parameters) -> Result<Figure, MotionError> {
    let engagement = Engagement::new(parameters)?;
    let (steady, unit) = (engagement.steady_state()?, parameters.drive().sqrt());
    let half = parameters.mechanism().engagement_half_angle().to_degrees();
    let round = |entry: f64| -> Result<Round, MotionError> {
        let passage = engagement.passage(entry)?;
        let instants = Followed::new(parameters, entry).and_then(|followed| Ok(followed.instants()?))?;
        let points: Vec<_> = instants.iter().map(|at: &Instant| (at.theta.to_degrees(), at.speed / unit)).collect();
        let switch = passage.switch_angle().map(|angle| {
            let angle = angle.to_degrees();
            let pair = points.windows(2).find(|pair| pair[0].0 <= angle && angle <= pair[1].0);
            let speed = pair.map_or(f64::NAN, |pair| {
                let share = (angle - pair[0].0) / (pair[1].0 - pair[0].0);
                pair[0].1 + share * (pair[1].1 - pair[0].1)
            });
            (angle, speed)
        });
        Ok(Round { points, switch: switch.filter(|(_, speed)| speed.is_finite()), end: passage.end_speed() })
    };
    let rounds = |mut entry: f64| -> Result<Vec<Round>, MotionError> {
        let mut rounds = Vec::new();
        for _ in 0..SHOWN {
            rounds.push(round(entry)?);
            entry = rounds.last().map_or(entry, |round| round.end);
        }
        Ok(rounds)
    };
    let (from_rest, from_above) = (rounds(0.0)?, rounds(ABOVE * steady.entry_speed)?);
    let cycle = round(steady.entry_speed)?;

    let marks = (-MARKS..=MARKS).map(|k| half * f64::from(k) / f64::from(MARKS)).collect();
    let level = Axis { range: -half..half, marks, decimals: 0, scale: Scale::Even };
    let all = || from_rest.iter().chain(&from_above).flat_map(|round| &round.points);
    let left = upright(0.0, all().map(|point| point.1).fold(0.0, f64::max), 5.0);
    let key = 56.0;
    let panel = Panel::new(Vector2::new(0.0, key), HEIGHT, level, left.clone());
    let mut canvas = Canvas::new(f64::from(WIDTH), f64::from(HEIGHT) + key);
    panel.draw(&mut canvas, true);
    let centres = [0.0, left.range.end].map(|y| panel.at((0.0, y)));
    canvas.draw(Shape::line(&centres[0], &centres[1]).stroke(INK, 1.3).dashed("5 4").class("centres"));
    let mut placing = panel.placing();
    placing.avoid(&centres[0], &centres[1], 1.5);
    let strokes = [
        Stroke { shade: DRIVER, width: 2.0, dashes: None, class: "from-rest" },
        Stroke { shade: FOLLOWER, width: 2.0, dashes: Some("8 4"), class: "from-above" },
        Stroke { shade: CORIOLIS, width: 3.4, dashes: Some("2 4"), class: "cycle" },
    ];
    let groups = [from_rest.as_slice(), from_above.as_slice(), std::slice::from_ref(&cycle)];
    for (rounds, stroke) in groups.into_iter().zip(strokes) {
        for round in rounds {
            placing.avoid_all(&panel.curve(&mut canvas, &round.points, stroke), 1.5);
        }
    }
    for (rounds, stroke) in groups.into_iter().zip(strokes) {
        let switches: Vec<_> = rounds.iter().filter_map(|round| round.switch).collect();
        panel.marks(&mut canvas, &switches, (stroke.shade, Mark::Diamond), 10.0);
        for (number, round) in rounds.iter().enumerate().filter(|_| rounds.len() > 1) {
            if let (Some(first), true) = (round.points.get(round.points.len() / 10), number < 2) {
                let label = Label::words(&(number + 1).to_string()).shade(stroke.shade);
                placing.put(&mut canvas, &label, around(&panel.at(*first), FRAC_PI_4, &NEAR[..3]));
            }
        }
    }
    let label = Label::words("line of centres");
    placing.put(&mut canvas, &label, around(&(centres[1] + Vector2::new(0.0, 26.0)), 0.0, &NEAR));
    let symbol = Label::symbol("θ").and("\u{200a}′ over √(").and_symbol("K").and("/").and_symbol("I").sub("f").and(")");
    panel.name(&mut canvas, &symbol);
    panel.foot(&mut canvas, &Label::words("driver angle ").and_symbol("θ").and(" in degrees"));
    samples(&mut canvas, strokes);
    Ok(words(parameters, &steady, unit, &cycle).figure(canvas, Kind::Plot, series(&from_rest, &from_above, &cycle)))
}

/// What the curves are, above the frame.
fn samples(canvas: &mut Canvas, strokes: [Stroke; 3]) {
    let names = ["from rest", "from twice the steady speed", "steady cycle"];
    for ((stroke, name), (x, y)) in strokes.into_iter().zip(names).zip([(16.0, 18.0), (230.0, 18.0), (16.0, 46.0)]) {
        let at = |x: f64| Vector2::new(x, y);
        let line = Shape::line(&at(x), &at(x + 40.0)).stroke(stroke.shade, stroke.width);
        canvas.draw(match stroke.dashes {
            Some(dashes) => line.dashed(dashes),
            None => line,
        });
        canvas.label(&at(x + 40.0), &Vector2::new(1.0, 0.0), 10.0, &Label::words(name).shade(stroke.shade).bare());
    }
    let at = Vector2::new(268.0, 46.0);
    crate::markers::marks(canvas, &[at], (INK, Mark::Diamond), 10.0);
    canvas.label(&at, &Vector2::new(1.0, 0.0), 12.0, &Label::words("friction changes its sign").bare());
}

fn series(from_rest: &[Round], from_above: &[Round], cycle: &Round) -> Series {
    let columns = [
        ("theta", "deg"),
        ("rest 1", "1"),
        ("rest 2", "1"),
        ("rest 3", "1"),
        ("above 1", "1"),
        ("above 2", "1"),
        ("above 3", "1"),
        ("steady", "1"),
    ];
    let all: Vec<&Round> = from_rest.iter().chain(from_above).collect();
    let rows = cycle.points.iter().enumerate().step_by(KEPT).map(|(k, (theta, speed))| {
        let of = |number: usize| all.get(number).and_then(|round| round.points.get(k)).map_or(0.0, |point| point.1);
        [*theta, of(0), of(1), of(2), of(3), of(4), of(5), *speed]
    });
    Series::new(columns, rows)
}

fn words(parameters: &Parameters, steady: &geneva_dynamics::steady::SteadyState, unit: f64, cycle: &Round) -> Words {
    let switch = cycle.switch.map_or(String::new(), |(angle, _)| {
        format!(
            " Past the line of centres the friction changes its sign at {} in the steady cycle.",
            degrees(angle.to_radians())
        )
    });
    Words {
        id: "steady-phase".to_owned(),
        title: "The driver's speed over its angle, engagement by engagement".to_owned(),
        description: format!(
            "Speed over angle for {} pins and μ = {}, for three engagements from rest, three from twice the steady \
             speed, and the steady cycle, which enters at {}, falls to {} and rises to {}. The curves from rest come \
             from below and those from above from above; from the third engagement on they can hardly be told from \
             the steady cycle.{switch}",
            parameters.mechanism().pins(),
            trimmed(parameters.friction(), 4),
            significant(steady.entry_speed / unit, 3),
            significant(steady.minimum.speed / unit, 3),
            significant(steady.peak.speed / unit, 3)
        ),
        caption: format!(
            "Successive engagements, numbered, from rest and from above: the third can hardly be told from the steady \
             cycle. The friction changes its sign on the line of centres and at the diamonds, where the follower begins \
             to run ahead of the pin. {}",
            shown(parameters)
        ),
    }
}
