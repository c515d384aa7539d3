//! The three conclusions of the thesis.

use super::by_steps::{Group, Motion, groups};
use super::general_statements::{Responses, responses, with};
use super::runs::{rows, series};
use super::*;
use crate::Evidence::{Quadrature, RungeKutta};
use crate::Stated;
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use std::sync::OnceLock;

/// One second in a day: this project's measure of keeping time. The source says of a watch that it resolves a second.
pub const SECOND_A_DAY: f64 = 1.0 / 86_400.0;

pub fn claims() -> Vec<Claim> {
    let mut claims = vec![timing(), small_variations()];
    claims.extend(hand_over::conclusion());
    claims
}

fn timing() -> Claim {
    at("Conclusion 1")
        .statement("meyer.conclusion.timing", "can be used as a timing device", "the mechanism keeps a period")
        .by(Quadrature, |stated| {
            let friction = stated.pick(1.0, 1.01);
            let off = rows().iter().filter_map(|row| {
                let last = *with(row, 1.0, 1.0)?.rise(1e-9).ok()?.cycles.last()?;
                let later = with(row, 1.0, friction)?.steady_state().ok()?;
                Some((last.end - last.start) / later.period - 1.0)
            });
            keeps_time(&off.collect::<Vec<_>>(), rows().len())
        })
        .by(RungeKutta, |stated| {
            static LATER: OnceLock<[Vec<f64>; 2]> = OnceLock::new();
            let [same, more] = LATER.get_or_init(|| [1.0, 1.01].map(off_by_steps));
            keeps_time(stated.pick(same, more), groups().len())
        })
        .but_not("its period is the same to a second a day if the friction grows by one per cent")
        .read_as(
            "A timing device of no stated accuracy: started from rest, every run comes to a motion whose engagements \
             last equally long, to a second a day, as long as nothing changes.",
        )
}

/// By how much the last engagement from rest, when it repeats itself, differs from one of twenty more, with as many times
/// the friction.
fn off_by_steps(friction: f64) -> Vec<f64> {
    let of = |group: &Group| {
        let at = &group.motion.parameters;
        let later = Parameters::new(at.mechanism(), at.inertias(), at.torque(), at.friction() * friction).ok()?;
        let later = group.motion.going_on(&later, 20);
        Some(group.motion.steady()?.duration() / later.engagements.last()?.duration() - 1.0)
    };
    groups().iter().filter_map(of).collect()
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
    at("Conclusion 2")
        .statement(
            "meyer.small-variations",
            "will not seriously affect the motion",
            "small changes of the parameters change the motion little",
        )
        .by(Quadrature, |stated| {
            static FOUND: OnceLock<Responses> = OnceLock::new();
            small(stated, FOUND.get_or_init(|| responses(&one_per_cent(), by_integrals)))
        })
        .by(RungeKutta, |stated| {
            static FOUND: OnceLock<Responses> = OnceLock::new();
            small(stated, FOUND.get_or_init(|| responses(&one_per_cent(), by_steps)))
        })
        .but_not("one per cent of a parameter changes what is tabulated by less than half a per cent")
        .read_as(
            "An effect is not serious if it is less than its cause: one per cent more of torque, friction or an \
             inertia changes peak, minimum and period of the steady motion by less than one per cent each, in every \
             run. The three are what Appendix E tabulates of it. The numbers of pins and slots, and the angles that go \
             with them, cannot vary by per cents.",
        )
}

/// Peak, minimum and period of the steady motion.
fn by_integrals(at: &Parameters) -> Option<[f64; 3]> {
    let state = Engagement::new(at).ok()?.steady_state().ok()?;
    Some([state.peak.speed, state.minimum.speed, state.period])
}

/// The same.
fn by_steps(at: &Parameters) -> Option<[f64; 3]> {
    let motion = Motion::repeating(at)?;
    let steady = motion.steady()?;
    let peak = motion.greatest(steady, |_, speed| speed).value;
    Some([peak, motion.least(steady)?.value, steady.duration()])
}

/// A small part.
const PART: f64 = 0.01;

/// Factors of torque, friction and the two inertias: one of them a small part greater.
fn one_per_cent() -> [[f64; 4]; 4] {
    std::array::from_fn(|which| std::array::from_fn(|k| if k == which { 1.0 + PART } else { 1.0 }))
}

/// Whether a small part more of each parameter changes all quantities by less than it, or by less than half of it, in
/// all groups of runs.
fn small(stated: Stated, found: &Responses) -> Finding {
    let bound = stated.pick(1.0, 0.5);
    let worst: Vec<f64> = found
        .iter()
        .map(|groups| groups.concat().iter().map(|change| change / PART).fold(0.0, |a, b| if b > a { b } else { a }))
        .collect();
    let complete =
        found.iter().all(|groups| groups.len() == series().count() && !groups.concat().iter().any(|x| x.is_nan()));
    let said: Vec<String> = worst.iter().map(|change| format!("{change:.2}")).collect();
    Finding::new(
        complete && worst.iter().all(|change| *change < bound),
        format!(
            "one per cent more torque, friction, driver's or follower's inertia changes one of the three by {} per \
             cent, in the run where it is most",
            said.join(", ")
        ),
    )
}
