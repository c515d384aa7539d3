//! Rise time and terminal speed over the torque, for several frictions.

use super::{Group, Run};
use crate::chart::{Axis, Chart, Entry, Panel, Spot, Stroke, kind};
use crate::number::{count_word, degrees, fixed, significant};
use crate::svg::Label;
use crate::theme::INK;
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::steady::Engagement;

/// Steps of a curve.
const STEPS: u32 = 24;
/// How near the first peak that counts as risen must be to the steady one.
const PART: f64 = 0.01;
/// A start is followed until an engagement ends so near the steady motion.
const SETTLED: f64 = 1e-6;
const DASHES: &str = "9 5";

/// Rise time and mean of the extremes at a torque of one and an inertia of the follower of one: all that a friction
/// makes of them.
#[derive(Clone, Copy, Debug)]
struct Scaled {
    rise: f64,
    mean: f64,
}

impl Scaled {
    fn of(engagement: &Engagement) -> Result<Self, FigureError> {
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

/// What a panel shows of a run and of what is computed, at a torque over the inertia of the follower.
struct Quantity {
    given: fn(&Run) -> f64,
    computed: fn(&Scaled, f64) -> f64,
    name: &'static str,
}

/// Rise time in milliseconds, and mean of the extremes.
const QUANTITIES: [Quantity; 2] = [
    Quantity {
        given: |run| 1000.0 * run.rise,
        computed: |scaled, drive| 1000.0 * scaled.rise / drive.sqrt(),
        name: "rise time in ms",
    },
    Quantity {
        given: mean,
        computed: |scaled, drive| scaled.mean * drive.sqrt(),
        name: "average terminal speed in rad/s",
    },
];

/// Rise time (until a peak within one per cent of the steady one) and mean of peak and minimum over the torque.
///
/// For each friction an unbroken curve of what the runs' own reset angle gives, and a dashed one of the mechanism's
/// reset angle if that is another; the runs of the table are marks. Meyer 1973, Figs. 9 to 11, which are lost. Series, a row
/// for each run: friction, torque, then mean and rise time as given, with the runs' reset angle, and with the mechanism's.
///
/// # Errors
///
/// [`FigureError`] if a friction is too great for the mechanism, or zero, or if there is no run.
pub fn over_torque(group: &Group) -> Result<Figure, FigureError> {
    let [least, greatest] = group.range(|run| run.torque);
    let mut families = Vec::new();
    for friction in group.frictions() {
        let of = |reset: f64| Scaled::of(&group.engagement(friction, least, reset)?);
        families.push(Family { friction, as_run: of(group.reset)?, as_is: group.own_reset().map(of).transpose()? });
    }
    if families.is_empty() {
        return Err(FigureError::Nothing);
    }
    let room = 0.04 * (greatest - least).max(1e-3 * greatest);
    let x = Axis::spanning(least - room, greatest + room, 5.0);
    let [rise, speed] = QUANTITIES;
    let panels = [
        panel(group, &families, &x, &rise),
        panel(group, &families, &x.clone().titled(Label::words("torque ").and_symbol("K").and(" in in lb")), &speed),
    ];
    let exact = Stroke::new(INK).wide(2.4);
    let run = group.own_reset().map_or("exact".to_owned(), |_| format!("exact, back after {}", degrees(group.reset)));
    let mut key = vec![
        Entry::marks((0..4).map(|number| kind(number).1), Label::words("printed")),
        Entry::curve(exact, Label::words(&run)),
    ];
    if group.own_reset().is_some() {
        key.push(Entry::curve(exact.dashed(DASHES), Label::words("exact, the mechanism as it is")));
    }
    Ok(Chart::new(panels).key(key).figure(words(group, &families), series(group, &families)))
}

/// The curves of all frictions, and the runs.
fn panel(group: &Group, families: &[Family], x: &Axis, quantity: &Quantity) -> Panel {
    let Quantity { given, computed, name } = quantity;
    let value = |scaled: &Scaled, torque: f64| computed(scaled, torque / group.inertias.follower());
    let [least, greatest] = group.range(|run| run.torque);
    let (from, to) = (x.range.start, x.range.end);
    let ends = families.iter().flat_map(|one| [Some(one.as_run), one.as_is]).flatten();
    let ends = ends.flat_map(|one| [value(&one, least), value(&one, greatest)]);
    let most = group.runs.iter().map(given).chain(ends).fold(0.0, f64::max);
    let y = Axis::from_zero(0.0, most, 4.0);
    let mu = y.blank().titled(Label::symbol("μ"));
    let mut panel =
        Panel::new(if x.title.is_some() { 270.0 } else { 220.0 }, x, &y.titled(Label::words(name))).right(mu);
    let torques = (0..=STEPS).map(|step| from + (to - from) * f64::from(step) / f64::from(STEPS));
    let torques: Vec<f64> = torques.filter(|torque| *torque > 0.0).collect();
    for (number, family) in families.iter().enumerate() {
        let stroke = Stroke { dashes: None, ..kind(number).0 };
        let curves = [
            (Some(family.as_run), stroke.wide(2.4).class("as-run")),
            (family.as_is, stroke.wide(2.0).dashed(DASHES).class("as-is")),
        ];
        for (scaled, stroke) in curves {
            let Some(scaled) = scaled else { continue };
            panel = panel.curve(torques.iter().map(|torque| (*torque, value(&scaled, *torque))), stroke);
            let label = Label::words(&fixed(family.friction, 2)).shade(stroke.shade);
            panel = panel.name(label, Spot::Beside(value(&scaled, to)));
        }
    }
    for (number, family) in families.iter().enumerate() {
        let own = group.runs.iter().filter(|run| run.friction == family.friction);
        panel = panel.marks(own.map(|run| (run.torque, given(run))), kind(number).1);
    }
    panel
}

/// Meyer 1973, chapter II: the average terminal velocity.
fn mean(run: &Run) -> f64 {
    f64::midpoint(run.peak, run.minimum)
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
    let name = count_word(pins);
    let rows = series(group, families).rows;
    let quotients = |over: usize, under: usize| rows.iter().map(move |row| row[over] / row[under]);
    let spread = |over: usize, under: usize| {
        let least = quotients(over, under).fold(f64::INFINITY, f64::min);
        let most = quotients(over, under).fold(0.0, f64::max);
        [least, most].map(|quotient| significant(quotient, 3))
    };
    let ([low, high], [short, long]) = (spread(2, 3), spread(5, 6));
    let as_is = if group.own_reset().is_some() {
        let [low, high] = spread(2, 4);
        format!(" Of the mechanism as it is, dashed, the printed speeds are {low} to {high} times those of its curves.")
    } else {
        String::new()
    };
    Words::new(
        format!("runs-{name}-pin"),
        format!("Rise time and average terminal speed over the torque, {name} pins"),
        format!(
            "Two panels over the torque K, each with a curve and printed points for {} frictions. Above, the rise \
             time: all curves fall, the points scatter, from {short} to {long} times the value of their curve. Below, \
             the mean of peak and minimum: all curves rise, and the points lie on them, from {low} to {high} times \
             their value.{as_is}",
            families.len()
        ),
        if group.own_reset().is_some() {
            format!(
                "{pins} pins. The printed speeds are those of a driver whose angle is reset after {}, whatever the \
                 mechanism, and not those of the mechanism as it is. The printed rise times keep to no curve: here the \
                 time until a peak is within one per cent of the steady one, which leaps with the number of \
                 engagements.",
                degrees(group.reset)
            )
        } else {
            format!(
                "{pins} pins. The printed speeds are those of the equation of motion. The printed rise times keep to \
                 no curve: here the time until a peak is within one per cent of the steady one, which leaps with the \
                 number of engagements."
            )
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{Drawing, sound};
    use geneva_dynamics::Inertias;
    use geneva_kinematics::Mechanism;
    use std::f64::consts::FRAC_PI_2;

    fn group(mechanism: Mechanism, runs: Vec<Run>) -> Group {
        Group { mechanism, inertias: Inertias::new(1.0, 2.0).expect("sound"), reset: FRAC_PI_2, runs }
    }

    fn run(friction: f64, torque: f64) -> Run {
        Run { friction, torque, peak: 1.5, minimum: 0.5, rise: 5.0, period: 1.0 }
    }

    #[test]
    fn speeds_go_with_the_root_of_the_torque() {
        let runs: Vec<Run> = [0.25, 0.5].into_iter().flat_map(|mu| [1.0, 4.0].map(|torque| run(mu, torque))).collect();
        for mechanism in Mechanism::ALL {
            let figure = over_torque(&group(mechanism, runs.clone())).expect("drawn");
            sound(&figure);
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
            let drawing = Drawing::of(&figure);
            let curves = ["as-run", "as-is"].map(|class| drawing.count(class));
            assert_eq!(curves, if mechanism == Mechanism::FOUR_PIN { [4, 0] } else { [4, 4] });
        }
    }

    #[test]
    fn what_has_no_steady_motion_is_an_error() {
        assert_eq!(over_torque(&group(Mechanism::FOUR_PIN, vec![])), Err(FigureError::Nothing));
        for friction in [0.0, 90.0, f64::NAN] {
            assert!(over_torque(&group(Mechanism::FOUR_PIN, vec![run(friction, 1.0)])).is_err(), "{friction}");
        }
    }
}
