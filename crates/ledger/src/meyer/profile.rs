//! Fig. 8 and what chapter II says of its curve: its shape, its scales, and when it is steady.

use super::by_steps::{Group, Motion, groups};
use super::general_statements::{Responses, responses};
use super::runs::{Column, Hypothesis, Row, rows, series};
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
            let sets = between_parameters(stated.pick(&["torque"], &["torque", "friction", "slots"]));
            let counts: Vec<Vec<usize>> =
                sets.iter().map(|set| set.iter().filter_map(|row| turning_points(row)).collect()).collect();
            let alike = |set: &&Vec<usize>| set.windows(2).all(|pair| pair[0] == pair[1]);
            let (same, all) = (counts.iter().filter(alike).count(), counts.concat());
            let (least, most) = all.iter().fold((usize::MAX, 0), |(a, b), count| (a.min(*count), b.max(*count)));
            Finding::new(
                same == counts.len() && all.len() == rows().len(),
                format!(
                    "in {same} of {} sets of runs the driver's speed has equally many turning points in each steady \
                     engagement, of {least} to {most} in all",
                    counts.len()
                ),
            )
        })
        .by(OtherPlaceInSource, |stated| {
            // Is some number within the rounding of all quotients of peak and minimum?
            let sets = between_parameters(stated.pick(&["torque"], &["torque", "friction"]));
            let ranges: Vec<[f64; 2]> = sets.iter().map(|set| quotient(set)).collect();
            let one = ranges.iter().filter(|[low, high]| low <= high).count();
            Finding::new(
                one == ranges.len(),
                format!("in {one} of {} sets of rows one quotient of peak and minimum fits all", ranges.len()),
            )
        })
        .read_as(
            "Two curves have one shape if one covers the other after a change of the scales of its axes. Asked is no \
             more than that they turn round equally often in an engagement, or have one quotient of peak and minimum \
             to the printed digits.",
        )
        .corrected(
            "Changing the torque will not change the shape of the curve",
            Slip {
                id: "",
                reason: "Eq. (1-19) is the same equation if all speeds grow as the root of K/I_f and all times shrink \
                         by it, so a change of K alone changes scales alone. The number of slots, the friction and the \
                         quotient of the inertias do change the shape: how deep the minimum is, where the peak stands, \
                         how many peaks there are.",
                witness: "Peak over minimum, as printed, is the same for all torques, but not for all frictions.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "A curve for one friction cannot be got from that for another by new scales.",
            },
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
        "by the first minimum of its speed the driver moves as it will for ever",
    )
    .by(Quadrature, |stated| {
        settled(stated, rows().iter().filter_map(|row| Some((row.mechanism, minima(row)?))).collect())
    })
    .by(RungeKutta, |stated| {
        let of = |group: &Group| {
            let motion = &group.motion;
            let least = |engagement| Some(motion.least(engagement)?.value);
            let minima: Vec<f64> = motion.engagements.iter().filter_map(least).collect();
            let steady = *minima.last()?;
            Some((group.rows.first()?.mechanism, minima.iter().map(|least| least / steady).collect()))
        };
        settled(stated, groups().iter().filter_map(of).collect())
    })
    .read_as(
        "A steady state is achieved with a minimum if that and all later ones are within one part in a hundred of the \
         last, the measure on the axes of Figs. 10 and 11.",
    )
    .corrected(
        "by the second minimum in velocity with four pins, by the third with six, by the fourth with three, the driver \
         has achieved its steady state",
        Slip {
            id: "",
            reason: "The first minimum is that of the first engagement, which starts from rest: no speed has been \
                     handed on yet. It is too low in every run, with six and three pins by more than with four. What \
                     an engagement leaves of the difference depends on the friction: with four pins the second pin \
                     enters at the steady speed within one per cent, except with the least friction of the runs.",
            witness: "The minima of all mechanisms and frictions, by steps.",
            origin: Origin::Concept,
            consequence: Consequence::Conclusion,
            changes: "A rise time that ends with the first minimum is too short.",
        },
    )
}

/// The rows in sets between which only these parameters change.
fn between_parameters(parameters: &[&str]) -> Vec<Vec<&'static Row>> {
    let may = |name: &str| parameters.contains(&name);
    let alike = |a: &&Row, b: &&Row| {
        (may("slots") || a.mechanism == b.mechanism)
            && (may("friction") || a.printed(Column::Friction) == b.printed(Column::Friction))
            && (may("torque") || a.printed(Column::Torque) == b.printed(Column::Torque))
    };
    let all: Vec<&Row> = rows().iter().collect();
    all.chunk_by(alike).map(<[&Row]>::to_vec).collect()
}

/// Instants of a cycle among which its turning points are looked for.
const INSTANTS: usize = 2000;

/// How often the driver's speed turns round in an engagement of the steady motion.
fn turning_points(row: &Row) -> Option<usize> {
    let lines = Hypothesis::IDEAL.engagement(row)?.steady_cycle(INSTANTS).ok()?;
    Some(lines.windows(2).filter(|pair| (pair[0].acceleration < 0.0) != (pair[1].acceleration < 0.0)).count())
}

/// The range of the quotients of peak and minimum that round to the printed ones of all rows; empty if the first is the
/// greater.
fn quotient(set: &[&Row]) -> [f64; 2] {
    set.iter().fold([0.0, f64::INFINITY], |[low, high]: [f64; 2], row| {
        let [peak, least] = [Column::Peak, Column::Minimum].map(|column| row.number(column));
        [low.max((peak - 0.5) / (least + 0.5)), high.min((peak + 0.5) / (least - 0.5))]
    })
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
    let motion = Motion::of(parameters)?;
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

/// The minima of a run from rest, over the steady one.
fn minima(row: &Row) -> Option<Vec<f64>> {
    let of = Hypothesis::IDEAL.engagement(row)?;
    let (first, rise) = (of.first_minimum().ok()??.speed, of.rise(1e-6).ok()?);
    let later = rise.cycles.iter().skip(1).map(|cycle| cycle.minimum.speed);
    Some(std::iter::once(first).chain(later).map(|least| least / rise.steady.minimum.speed).collect())
}

/// Whether the minimum with the number that is stated is, with six, four and three pins, the first from which on all
/// are the steady one within a part in a hundred.
fn settled(stated: Stated, runs: Vec<(Mechanism, Vec<f64>)>) -> Finding {
    let said = stated.pick([3, 2, 4], [1; 3]);
    let mut found = [0; 3];
    for (mechanism, minima) in &runs {
        let off = minima.iter().rposition(|part| (part - 1.0).abs() > 0.01);
        let number = &mut found[mechanism.index()];
        *number = (*number).max(off.map_or(1, |last| last + 2));
    }
    let range = |mechanism: Mechanism| {
        let own = runs.iter().filter(|(of, _)| *of == mechanism).filter_map(|(_, minima)| minima.first());
        let (low, high) = own.fold((f64::INFINITY, 0.0_f64), |(a, b), part| (a.min(*part), b.max(*part)));
        format!("{:.1} to {:.1}", 100.0 * low, 100.0 * high)
    };
    let [six, four, three] = Mechanism::ALL.map(range);
    Finding::new(
        !runs.is_empty() && found == said,
        format!(
            "the first minimum is {six} per cent of the steady one with six pins, {four} with four, {three} with \
             three; from the minimum with the number {}, {} and {} on all are within one per cent",
            found[0], found[1], found[2]
        ),
    )
}
