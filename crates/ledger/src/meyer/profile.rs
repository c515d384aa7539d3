//! Fig. 8 and what chapter II says of its curve: its shape, its scales, and when it is steady.

use super::by_steps::{Motion, groups};
use super::general_statements::{Responses, responses};
use super::runs::choice::{of_fig_8, rows_of};
use super::runs::{Column, Hypothesis, Row, series};
use super::*;
use crate::Evidence::{Quadrature, RungeKutta};
use crate::Stated;
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

const BEFORE: Place = at("Chapter II, sentence around Fig. 8");
const RISE: Place = at("Chapter II, paragraph on the rise time in Fig. 8");

/// A figure of which the copy has the number only.
pub fn lost(id: &'static str, locator: &'static str, meaning: &'static str, printed: &'static str) -> Claim {
    at(locator).figure(id, printed, meaning).missing("The curves are not in the copy")
}

pub fn claims() -> Vec<Claim> {
    vec![
        at("Fig. 8")
            .figure("meyer.fig-8", "FIGURE 8", "speeds of driver and follower over time, four pins")
            .missing("The curves are not in the copy, and the run that they show is not named"),
        shape(),
        scales(),
        RISE.value("meyer.fig-8.rise", "0.025", "seconds", "rise time of the run that is drawn").missing(
            "The text does not name the run. The first minima of two of the four-pin runs round to the printed time, \
             and the table gives other rise times for both",
        ),
        first_minimum(),
    ]
}

fn shape() -> Claim {
    BEFORE
        .statement(
            "meyer.shape",
            "will not change the shape of the curve",
            "no parameter changes the shape of the curve of speeds",
        )
        .by(Quadrature, |stated| {
            alike(stated, |row| {
                let lines = Hypothesis::IDEAL.engagement(row)?.steady_cycle(INSTANTS).ok()?;
                Some(lines.iter().map(|line| line.speed).collect())
            })
        })
        .by(RungeKutta, |stated| {
            alike(stated, |row| {
                let group = groups().iter().find(|group| group.rows.contains(row))?;
                let scale = group.scale(row);
                Some(group.motion.values(group.motion.steady()?, |_, speed| speed * scale))
            })
        })
        .but_not("nor the shape of the curve for six pins")
        .read_as(
            "Asked of the mechanism of Fig. 8 and the parameters of its table: the curve goes up and down equally often in \
             each engagement, as far as one unit of the tables lets one see. How deep its minimum is beside its peak does \
             change with the friction; with the torque nothing but the scales changes.",
        )
}

fn scales() -> Claim {
    BEFORE
        .statement(
            "meyer.scales",
            "the magnitude of the velocity, the period of the oscillations, and the rise time",
            "parameters change the speed, the period and the rise time",
        )
        .by(Quadrature, |stated| {
            static FOUND: OnceLock<Responses> = OnceLock::new();
            changed(stated, FOUND.get_or_init(|| responses(&TENTHS, scales_by_integrals)))
        })
        .by(RungeKutta, |stated| {
            static FOUND: OnceLock<Responses> = OnceLock::new();
            changed(stated, FOUND.get_or_init(|| responses(&TENTHS, scales_by_steps)))
        })
        .but_not("torque and both inertias, changed in one proportion, will change them")
        .read_as(
            "Each of torque, friction and the two inertias, changed alone, changes all three; the rise time is that of \
             the first minimum.",
        )
}

fn first_minimum() -> Claim {
    RISE.statement(
        "meyer.first-minimum",
        "by the first minimum in velocity, the driver has achieved its steady state",
        "by the first minimum of its speed the driver of Fig. 8 moves as it will for ever",
    )
    .by(Quadrature, |stated| settled(stated, departure))
    .by(RungeKutta, |stated| settled(stated, departure_by_steps))
    .but_not("so it has in every run of the four-pin mechanism")
    .read_as(
        "Asked of the run that Fig. 8 shows, which is not named: of the two whose first minimum is at the time that the \
         text gives, one is within a unit of the tables of its steady minimum, speed at entry and peak from its first \
         minimum on.",
    )
}

/// Instants of a cycle among which its turning points are looked for.
const INSTANTS: usize = 2000;

/// Whether the curves of all runs of the mechanism of Fig. 8 turn round equally often in a steady engagement, or those
/// of another.
fn alike(stated: Stated, speeds: impl Fn(&Row) -> Option<Vec<f64>>) -> Finding {
    let mechanism = stated.pick(Mechanism::FOUR_PIN, Mechanism::SIX_PIN);
    let counts: Vec<Option<usize>> = rows_of(mechanism).map(|row| swings(&speeds(row)?)).collect();
    let same = counts.first().is_some_and(|first| first.is_some() && counts.iter().all(|count| count == first));
    let all = || counts.iter().flatten();
    Finding::new(
        same,
        format!(
            "with {} pins the driver's speed turns round {} to {} times in a steady engagement of {} runs",
            mechanism.pins(),
            all().min().unwrap_or(&0),
            all().max().unwrap_or(&0),
            counts.len()
        ),
    )
}

/// How often a cycle of speeds turns round by a unit of the tables or more.
fn swings(speeds: &[f64]) -> Option<usize> {
    let unit = Column::Peak.unit();
    let highest = speeds.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?.0;
    // From the highest down: it turns where it has come back by a unit.
    let (mut turns, mut falling, mut last) = (1, true, speeds[highest]);
    for speed in speeds.iter().cycle().skip(highest).take(speeds.len() + 1) {
        if (*speed < last) == falling {
            last = *speed;
        } else if (speed - last).abs() >= unit {
            (turns, falling, last) = (turns + 1, !falling, *speed);
        }
    }
    Some(turns)
}

/// Factors of torque, friction and the two inertias: each alone a tenth greater, and all but the friction together.
const TENTHS: [[f64; 4]; 5] =
    [[1.1, 1.0, 1.0, 1.0], [1.0, 1.1, 1.0, 1.0], [1.0, 1.0, 1.1, 1.0], [1.0, 1.0, 1.0, 1.1], [1.1, 1.0, 1.1, 1.1]];

/// Mean of peak and minimum, period, and the time of the first minimum.
fn scales_by_integrals(parameters: &Parameters) -> Option<[f64; 3]> {
    let of = Engagement::with_tolerance(parameters, 1e-11).ok()?;
    let steady = of.steady_state().ok()?;
    Some([steady.mean_of_extremes(), steady.period, of.first_minimum().ok()??.time])
}

/// The same.
fn scales_by_steps(parameters: &Parameters) -> Option<[f64; 3]> {
    let motion = Motion::repeating(parameters)?;
    let (first, steady) = (motion.engagements.first()?, motion.steady()?);
    let peak = motion.greatest(steady, |_, speed| speed).value;
    let middle = f64::midpoint(peak, motion.least(steady)?.value);
    Some([middle, steady.duration(), motion.least(first)?.time])
}

/// Whether all three quantities change in every group of runs: with each parameter alone, or with torque and inertias
/// together.
fn changed(stated: Stated, found: &Responses) -> Finding {
    let (alone, together) = found.split_at(found.len() - 1);
    let changes = stated.pick(alone, together).concat().concat();
    let least = changes.iter().copied().fold(f64::INFINITY, f64::min);
    let complete = found.iter().all(|groups| groups.len() == series().count());
    Finding::new(
        complete && changes.iter().all(|change| *change > crate::tolerance::STEPS.relative),
        format!("a tenth more changes each by {:.2} per cent or more in all groups", 100.0 * least),
    )
}

/// By how much a run from rest departs from its steady minimum, speed at entry and peak, from its first minimum on, in
/// rad/s.
fn departure(row: &Row) -> Option<f64> {
    let of = Hypothesis::IDEAL.engagement(row)?;
    let (first, rise) = (of.first_minimum().ok()??, of.rise(1e-6).ok()?);
    let steady = &rise.steady;
    let peak = rise.cycles.first().map(|cycle| cycle.peak).filter(|peak| peak.angle > first.angle)?;
    let later = rise.cycles.iter().skip(1).flat_map(|cycle| {
        [
            cycle.minimum.speed - steady.minimum.speed,
            cycle.entry_speed - steady.entry_speed,
            cycle.peak.speed - steady.peak.speed,
        ]
    });
    let own = [first.speed - steady.minimum.speed, peak.speed - steady.peak.speed];
    Some(later.chain(own).map(f64::abs).fold(0.0, f64::max))
}

/// The same.
fn departure_by_steps(row: &Row) -> Option<f64> {
    let group = groups().iter().find(|group| group.rows.contains(row))?;
    let motion = &group.motion;
    let of = |engagement: &by_steps::Engagement| {
        let peak = motion.greatest(engagement, |_, speed| speed).value;
        Some([motion.least(engagement)?.value, engagement.ends()[0], peak])
    };
    let steady = of(motion.steady()?)?;
    // The first engagement begins at rest.
    let [minimum, _, peak] = of(motion.engagements.first()?)?;
    let own = [minimum - steady[0], peak - steady[2]];
    let later = motion.engagements.iter().skip(1).filter_map(of);
    let later = later.flat_map(|found| [0, 1, 2].map(|k| found[k] - steady[k]));
    Some(later.chain(own).map(f64::abs).fold(0.0, f64::max) * group.scale(row))
}

/// Whether a run that may be that of Fig. 8 is steady from its first minimum on, to a unit of the tables; or all runs of
/// its mechanism.
fn settled(stated: Stated, departure: fn(&Row) -> Option<f64>) -> Finding {
    let fig_8 = of_fig_8().unwrap_or_default();
    let asked: Vec<&Row> = stated.pick(fig_8, rows_of(Mechanism::FOUR_PIN).collect());
    let found: Vec<f64> = asked.iter().map(|row| departure(row).unwrap_or(f64::NAN)).collect();
    let steady = found.iter().filter(|off| **off < Column::Peak.unit()).count();
    let holds = stated.pick(steady > 0, steady == found.len());
    Finding::new(
        holds,
        format!(
            "of {} runs {steady} are within a unit of the steady motion from the first minimum on; they depart by {found:.2?} \
             rad/s",
            found.len()
        ),
    )
}
