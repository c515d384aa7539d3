//! The three conclusions of the thesis.

use super::by_steps::{Motion, groups};
use super::general_statements::with;
use super::runs::{Hypothesis, rows, series};
use super::*;
use crate::Evidence::{Integration, Steps};
use crate::Stated;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};

/// One second in a day: the resolution that the source ascribes to a watch, over a day.
pub const SECOND_A_DAY: f64 = 1.0 / 86_400.0;

pub fn claims() -> Vec<Claim> {
    let mut claims = vec![timing(), small_variations()];
    claims.extend(hand_over::conclusion());
    claims
}

fn timing() -> Claim {
    Claim::statement(
        WORK,
        "meyer.conclusion.timing",
        "Conclusion 1",
        "the mechanism keeps a period",
        "can be used as a timing device",
        Check::statement(
            "its period is the same to a second a day if the friction grows by one per cent",
            (Integration, |stated| {
                let friction = stated.pick(1.0, 1.01);
                let off = rows().iter().filter_map(|row| {
                    let last = *with(row, 1.0, 1.0)?.rise(1e-9).ok()?.cycles.last()?;
                    let later = with(row, 1.0, friction)?.steady_state().ok()?;
                    Some((last.end - last.start) / later.period - 1.0)
                });
                keeps_time(&off.collect::<Vec<_>>(), rows().len())
            }),
            (Steps, |stated| {
                let friction = stated.pick(1.0, 1.01);
                let off = groups().iter().filter_map(|group| {
                    let at = &group.motion.parameters;
                    let later =
                        Parameters::new(at.slots(), at.inertias(), at.torque(), at.friction() * friction).ok()?;
                    let from = group.motion.steady()?;
                    Some(from.duration() / Motion::of(&later)?.steady()?.duration() - 1.0)
                });
                keeps_time(&off.collect::<Vec<_>>(), groups().len())
            }),
        ),
    )
    .read_as(
        "A timing device of no stated accuracy: started from rest, every run comes to a motion whose engagements last \
         equally long, to a second a day, as long as nothing changes.",
    )
}

/// Whether engagements last as long as others to a second a day, from the relative differences.
fn keeps_time(off: &[f64], count: usize) -> Finding {
    let seconds: Vec<f64> = off.iter().map(|off| off.abs() / SECOND_A_DAY).collect();
    let (least, most) = seconds.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), s| (a.min(*s), b.max(*s)));
    Finding::new(
        off.len() == count && most <= 1.0,
        format!(
            "of {count}, the last engagement from rest and a later one differ by {least:.1} to {most:.1} s in a day"
        ),
    )
}

fn small_variations() -> Claim {
    Claim::statement(
        WORK,
        "meyer.small-variations",
        "Conclusion 2",
        "small changes of the parameters change the motion little",
        "will not seriously affect the motion",
        Check::statement(
            "one per cent of a parameter changes what is tabulated by less than half a per cent",
            (Integration, |stated| {
                small(stated, |at| {
                    let state = Engagement::new(at).ok()?.steady_state().ok()?;
                    Some([state.peak.speed, state.minimum.speed, state.period])
                })
            }),
            (Steps, |stated| {
                small(stated, |at| {
                    let motion = Motion::of(at)?;
                    let steady = motion.steady()?;
                    let peak = motion.greatest(steady, |_, speed| speed).value;
                    Some([peak, motion.least(steady)?.value, steady.duration()])
                })
            }),
        ),
    )
    .read_as(
        "An effect is not serious if it is less than its cause: one per cent more of torque, friction or an inertia \
         changes peak, minimum and period of the steady motion by less than one per cent each, in every run. The \
         three are what Appendix E tabulates of it.",
    )
}

/// Whether one per cent more of each parameter changes all quantities by less than a bound, in all groups of runs.
fn small(stated: Stated, of: fn(&Parameters) -> Option<[f64; 3]>) -> Finding {
    let (bound, part) = (stated.pick(1.0, 0.5), 0.01);
    let changes = |factors: [f64; 4]| -> Vec<f64> {
        let [torque, friction, driver, follower] = factors.map(|share| 1.0 + part * share);
        let change = |own: &[runs::Row]| {
            let at = Hypothesis::TRUE.parameters(own.first()?)?;
            let inertias = Inertias::new(at.inertias().driver() * driver, at.inertias().follower() * follower).ok()?;
            let changed = Parameters::new(at.slots(), inertias, at.torque() * torque, at.friction() * friction).ok()?;
            let (before, after) = (of(&at)?, of(&changed)?);
            Some((0..3).map(|k| (after[k] / before[k] - 1.0).abs() / part).fold(0.0, f64::max))
        };
        series().filter_map(change).collect()
    };
    let found: [Vec<f64>; 4] = std::array::from_fn(|which| changes(std::array::from_fn(|k| f64::from(k == which))));
    let worst = found.each_ref().map(|changes| changes.iter().copied().fold(0.0, f64::max));
    let complete = found.iter().all(|changes| changes.len() == series().count());
    let [torque, friction, driver, follower] = worst;
    Finding::new(
        complete && worst.iter().all(|change| *change < bound),
        format!(
            "one per cent more torque, friction, driver's or follower's inertia changes one of the three by \
             {torque:.2}, {friction:.2}, {driver:.2} or {follower:.2} per cent, in the run where it is most"
        ),
    )
}
