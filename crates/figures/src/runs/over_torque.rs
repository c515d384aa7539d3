//! Rise time and terminal speed over the torque, for several frictions.

use super::{Group, Run};
use crate::escapement::axes::{spanning, upright};
use crate::figure::{Figure, Words};
use crate::markers::kind;
use crate::number::{degrees, fixed, significant};
use crate::panel::{Panel, Stroke};
use crate::series::Series;
use crate::steady::MotionError;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::shape::Shape;
use crate::theme::{INK, Shade};
use geneva_dynamics::steady::Engagement;
use nalgebra::Vector2;

/// Room above the first panel for the key, a line, and the heights of the panels, in pixels.
const LINE: f64 = 28.0;
const HEIGHTS: [u32; 2] = [334, 384];
/// Steps of a curve.
const STEPS: u32 = 24;
/// How near the first peak that counts as risen must be to the steady one.
const PART: f64 = 0.01;
/// A start is followed until an engagement ends so near the steady motion.
const SETTLED: f64 = 1e-6;
const DASHES: &str = "9 5";
const SIZE: f64 = 9.0;

/// Rise time and mean of the extremes at a torque of one and an inertia of the follower of one: all that a friction
/// makes of them.
#[derive(Clone, Copy, Debug)]
struct Scaled {
    rise: f64,
    mean: f64,
}

impl Scaled {
    fn of(engagement: &Engagement) -> Result<Self, MotionError> {
        let unit = engagement.parameters().drive().sqrt();
        let rise = engagement.rise(SETTLED)?;
        let settled = rise.cycles.last().map_or(0.0, |cycle| cycle.end);
        // Who brakes well is settled before the first steady peak: then it is that of the next engagement.
        let until = rise.until_peak(PART).unwrap_or(settled + rise.steady.peak.time);
        Ok(Self { rise: until * unit, mean: rise.steady.mean_of_extremes() / unit })
    }
}

/// One friction's curves.
struct Family {
    friction: f64,
    as_run: Scaled,
    as_is: Option<Scaled>,
}

/// Rise time (until a peak within one per cent of the steady one) and mean of peak and minimum over the torque.
///
/// For each friction an unbroken curve of what the runs' own fold gives, and a dashed one of the mechanism's fold if
/// that is another; the runs of the table are marks. Meyer 1973, Figs. 9 to 11, which are lost. Series, a row for each
/// run: friction, torque, then mean and rise time as given, with the runs' fold, and with the mechanism's.
///
/// # Errors
///
/// [`MotionError`] if a friction is too great for the mechanism, or zero, or if there is no run.
pub fn over_torque(group: &Group) -> Result<Figure, MotionError> {
    let scale = |torque: f64| (torque / group.inertias.follower()).sqrt();
    let [least, greatest] = group.range(|run| run.torque);
    let mut families = Vec::new();
    for friction in group.frictions() {
        let of = |fold: f64| Scaled::of(&group.engagement(friction, least, fold)?);
        families.push(Family { friction, as_run: of(group.fold)?, as_is: group.own_fold().map(of).transpose()? });
    }
    if families.is_empty() {
        return Err(MotionError::Nothing);
    }
    let lines = if group.own_fold().is_some() { 2.0 } else { 1.0 };
    let ([upper, lower], height) = Panel::stack(lines * LINE, HEIGHTS);
    let room = 0.04 * (greatest - least).max(1e-3 * greatest);
    let level = spanning(least - room, greatest + room, 5.0);
    let [from, to] = [level.range.start, level.range.end];
    let most = |run: fn(&Run) -> f64, of: fn(&Scaled) -> f64, at: &dyn Fn(f64) -> f64| {
        let given = group.runs.iter().map(run);
        let ends = families.iter().flat_map(|one| [Some(one.as_run), one.as_is]).flatten();
        given.chain(ends.map(|one| of(&one) * at(least).max(at(greatest)))).fold(0.0, f64::max)
    };
    let milliseconds = |time: f64| 1000.0 * time;
    let rise = upright(0.0, milliseconds(most(|run| run.rise, |one| one.rise, &|torque| scale(torque).recip())), 4.0);
    let speed = upright(0.0, most(mean, |one| one.mean, &|_| scale(to)), 4.0);
    let panels = [Panel::new(upper, HEIGHTS[0], level.clone(), rise), Panel::new(lower, HEIGHTS[1], level, speed)];
    let mut canvas = Canvas::new(f64::from(crate::panel::WIDTH), height);
    for (k, panel) in panels.iter().enumerate() {
        panel.draw(&mut canvas, true);
        let value = |one: &Scaled, torque: f64| {
            if k == 0 { milliseconds(one.rise / scale(torque)) } else { one.mean * scale(torque) }
        };
        let torques = (0..=STEPS).map(|step| from + (to - from) * f64::from(step) / f64::from(STEPS));
        let torques: Vec<f64> = torques.filter(|torque| *torque > 0.0).collect();
        let mut ends = Vec::new();
        for (number, family) in families.iter().enumerate() {
            let shade = kind(number).0;
            let curves = [(Some(family.as_run), None, 2.4), (family.as_is, Some(DASHES), 2.0)];
            for (scaled, dashes, width) in curves {
                let Some(scaled) = scaled else { continue };
                let points: Vec<_> = torques.iter().map(|torque| (*torque, value(&scaled, *torque))).collect();
                let class = if dashes.is_some() { "as-is" } else { "as-run" };
                panel.curve(&mut canvas, &points, Stroke { shade, width, dashes, class });
                ends.push((value(&scaled, to), Label::words(&fixed(family.friction, 2)), shade));
            }
        }
        for (number, family) in families.iter().enumerate() {
            let own = group.runs.iter().filter(|run| run.friction == family.friction);
            let given = |run: &Run| (run.torque, if k == 0 { milliseconds(run.rise) } else { mean(run) });
            panel.marks(&mut canvas, &own.map(given).collect::<Vec<_>>(), kind(number), SIZE);
        }
        let frame = panel.corners();
        panel.beside(&mut canvas, ends);
        let head = Vector2::new(frame[1].x + 16.0, frame[0].y - 25.0);
        canvas.label(&head, &Vector2::new(1.0, 0.0), 0.0, &Label::symbol("μ").bare());
    }
    panels[0].name(&mut canvas, &Label::words("rise time in ms"));
    panels[1].name(&mut canvas, &Label::words("average terminal speed in rad/s"));
    panels[1].foot(&mut canvas, &Label::words("torque ").and_symbol("K").and(" in in lb"));
    key(&mut canvas, group.own_fold().map(|_| degrees(group.fold)));
    Ok(words(group, &families).figure(canvas, Kind::Panels, series(group, &families)))
}

/// Meyer 1973, chapter II: the average terminal velocity.
fn mean(run: &Run) -> f64 {
    f64::midpoint(run.peak, run.minimum)
}

/// What marks and curves are.
fn key(canvas: &mut Canvas, fold: Option<String>) {
    let right = Vector2::new(1.0, 0.0);
    let sample = |canvas: &mut Canvas, x: f64, y: f64, dashed: bool, shade: Shade| {
        let line = Shape::line(&Vector2::new(x, y), &Vector2::new(x + 44.0, y)).stroke(shade, 2.4).class("sample");
        canvas.draw(if dashed { line.dashed(DASHES) } else { line });
    };
    let top = 18.0;
    let places: Vec<_> = (0..4).map(|k| Vector2::new(16.0 + 15.0 * f64::from(k), top)).collect();
    for (k, place) in places.iter().enumerate() {
        crate::markers::marks(canvas, &[*place], kind(k), SIZE);
    }
    canvas.label(&Vector2::new(72.0, top), &right, 0.0, &Label::words("printed").bare());
    sample(canvas, 190.0, top, false, INK);
    let run = fold.as_ref().map_or("exact".to_owned(), |fold| format!("exact, driver put back after {fold}"));
    canvas.label(&Vector2::new(244.0, top), &right, 0.0, &Label::words(&run).bare());
    if fold.is_some() {
        sample(canvas, 190.0, top + LINE, true, INK);
        canvas.label(
            &Vector2::new(244.0, top + LINE),
            &right,
            0.0,
            &Label::words("exact, the mechanism as it is").bare(),
        );
    }
}

/// The family of a run.
fn family<'a>(families: &'a [Family], run: &Run) -> Option<&'a Family> {
    families.iter().find(|family| family.friction == run.friction)
}

fn series(group: &Group, families: &[Family]) -> Series {
    let columns = [
        ("mu", "1"),
        ("K", "in lb"),
        ("mean printed", "rad/s"),
        ("as run", "rad/s"),
        ("as is", "rad/s"),
        ("rise printed", "s"),
        ("as run", "s"),
        ("as is", "s"),
    ];
    let rows = group.runs.iter().filter_map(|run| {
        let family = family(families, run)?;
        let unit = (run.torque / group.inertias.follower()).sqrt();
        let (as_run, as_is) = (family.as_run, family.as_is.unwrap_or(family.as_run));
        let speeds = [mean(run), as_run.mean * unit, as_is.mean * unit];
        let [given, run_time, is_time] = [run.rise, as_run.rise / unit, as_is.rise / unit];
        Some([run.friction, run.torque, speeds[0], speeds[1], speeds[2], given, run_time, is_time])
    });
    Series::new(columns, rows)
}

fn words(group: &Group, families: &[Family]) -> Words {
    let pins = group.mechanism.pins();
    let name = match pins {
        3 => "three",
        4 => "four",
        _ => "six",
    };
    let rows = series(group, families).rows;
    let quotients = |over: usize, under: usize| rows.iter().map(move |row| row[over] / row[under]);
    let spread = |over: usize, under: usize| {
        let least = quotients(over, under).fold(f64::INFINITY, f64::min);
        let most = quotients(over, under).fold(0.0, f64::max);
        [least, most].map(|quotient| significant(quotient, 3))
    };
    let ([low, high], [short, long]) = (spread(2, 3), spread(5, 6));
    let as_is = if group.own_fold().is_some() {
        let [low, high] = spread(2, 4);
        format!(" Of the mechanism as it is, dashed, the printed speeds are {low} to {high} times those of its curves.")
    } else {
        String::new()
    };
    Words {
        id: format!("runs-{name}-pin"),
        title: format!("Rise time and average terminal speed over the torque, {name} pins"),
        description: format!(
            "Two panels over the torque K, each with a curve and printed points for {} frictions. Above, the rise \
             time: all curves fall, the points scatter, from {short} to {long} times the value of their curve. Below, \
             the mean of peak and minimum: all curves rise, and the points lie on them, from {low} to {high} times \
             their value.{as_is}",
            families.len()
        ),
        caption: if group.own_fold().is_some() {
            format!(
                "{pins} pins. The printed speeds are those of a driver that is put back after {}, whatever the \
                 mechanism, and not those of the mechanism as it is. The printed rise times keep to no curve: here \
                 the time until a peak is within one per cent of the steady one, which leaps with the number of \
                 engagements.",
                degrees(group.fold)
            )
        } else {
            format!(
                "{pins} pins. The printed speeds are those of the equation of motion. The printed rise times keep to \
                 no curve: here the time until a peak is within one per cent of the steady one, which leaps with the \
                 number of engagements."
            )
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{labels_inside, named, only_numbers, overlapping_labels, well_formed};
    use geneva_dynamics::Inertias;
    use geneva_kinematics::Mechanism;
    use roxmltree::Document;
    use std::f64::consts::FRAC_PI_2;

    fn group(mechanism: Mechanism, runs: Vec<Run>) -> Group {
        Group { mechanism, inertias: Inertias::new(1.0, 2.0).expect("sound"), fold: FRAC_PI_2, runs }
    }

    fn run(friction: f64, torque: f64) -> Run {
        Run { friction, torque, peak: 1.5, minimum: 0.5, rise: 5.0, period: 1.0 }
    }

    #[test]
    fn speeds_go_with_the_root_of_the_torque() {
        let runs: Vec<Run> = [0.25, 0.5].into_iter().flat_map(|mu| [1.0, 4.0].map(|torque| run(mu, torque))).collect();
        for mechanism in Mechanism::ALL {
            let figure = over_torque(&group(mechanism, runs.clone())).expect("drawn");
            well_formed(&figure);
            only_numbers(&figure);
            labels_inside(&figure);
            assert_eq!(overlapping_labels(&figure), [], "{}", figure.id);
            for pair in figure.series.rows.chunks(2) {
                for column in [3, 4] {
                    approx::assert_relative_eq!(pair[1][column], 2.0 * pair[0][column], max_relative = 1e-12);
                    approx::assert_relative_eq!(pair[0][column + 3], 2.0 * pair[1][column + 3], max_relative = 1e-12);
                }
                // Each number by the engagement itself, at the run's own torque.
                let row = &pair[1];
                let own = group(mechanism, vec![]).engagement(row[0], row[1], FRAC_PI_2).expect("sound");
                let rise = own.rise(SETTLED).expect("steady");
                approx::assert_relative_eq!(row[3], rise.steady.mean_of_extremes(), max_relative = 1e-9);
                let until =
                    rise.cycles.iter().find(|cycle| (cycle.peak.speed / rise.steady.peak.speed - 1.0).abs() <= PART);
                let next = rise.cycles[rise.cycles.len() - 1].end + rise.steady.peak.time;
                approx::assert_relative_eq!(row[6], until.map_or(next, |at| at.peak.time), max_relative = 1e-9);
            }
            let document = Document::parse(&figure.svg).expect("well-formed");
            let curves = ["as-run", "as-is"].map(|class| named(&document, class).len());
            assert_eq!(curves, if mechanism == Mechanism::FOUR_PIN { [4, 0] } else { [4, 4] });
        }
    }

    #[test]
    fn what_has_no_steady_motion_is_an_error() {
        assert_eq!(over_torque(&group(Mechanism::FOUR_PIN, vec![])), Err(MotionError::Nothing));
        for friction in [0.0, 90.0, f64::NAN] {
            assert!(over_torque(&group(Mechanism::FOUR_PIN, vec![run(friction, 1.0)])).is_err(), "{friction}");
        }
    }
}
