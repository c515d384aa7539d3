//! The three conclusions of the thesis.

use super::by_steps::{Group, Motion, groups};
use super::general_statements::{Responses, responses, with};
use super::runs::{rows, series};
use super::*;
use crate::Evidence::{Integration, Steps};
use crate::Stated;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Coefficients, Parameters};
use geneva_mimic::runge_kutta_step;
use nalgebra::Vector1;
use std::sync::OnceLock;

/// One second in a day: the resolution that the source ascribes to a watch, over a day.
pub const SECOND_A_DAY: f64 = 1.0 / 86_400.0;

pub fn claims() -> Vec<Claim> {
    vec![timing(), small_variations(), three()]
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
                static LATER: OnceLock<[Vec<f64>; 2]> = OnceLock::new();
                let [same, more] = LATER.get_or_init(|| [1.0, 1.01].map(off_by_steps));
                keeps_time(stated.pick(same, more), groups().len())
            }),
        ),
    )
    .read_as(
        "A timing device of no stated accuracy: started from rest, every run comes to a motion whose engagements last \
         equally long, to a second a day, as long as nothing changes.",
    )
}

/// By how much the steady engagement from rest differs from that with as many times the friction.
fn off_by_steps(friction: f64) -> Vec<f64> {
    let of = |group: &Group| {
        let at = &group.motion.parameters;
        let later = Parameters::new(at.slots(), at.inertias(), at.torque(), at.friction() * friction).ok()?;
        Some(group.motion.steady()?.duration() / Motion::of(&later)?.steady()?.duration() - 1.0)
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
    Claim::statement(
        WORK,
        "meyer.small-variations",
        "Conclusion 2",
        "small changes of the parameters change the motion little",
        "will not seriously affect the motion",
        Check::statement(
            "one per cent of a parameter changes what is tabulated by less than half a per cent",
            (Integration, |stated| {
                static FOUND: OnceLock<Responses> = OnceLock::new();
                small(stated, FOUND.get_or_init(|| responses(&one_per_cent(), by_integrals)))
            }),
            (Steps, |stated| {
                static FOUND: OnceLock<Responses> = OnceLock::new();
                small(stated, FOUND.get_or_init(|| responses(&one_per_cent(), by_steps)))
            }),
        ),
    )
    .read_as(
        "An effect is not serious if it is less than its cause: one per cent more of torque, friction or an inertia \
         changes peak, minimum and period of the steady motion by less than one per cent each, in every run. The \
         three are what Appendix E tabulates of it.",
    )
}

/// Peak, minimum and period of the steady motion.
fn by_integrals(at: &Parameters) -> Option<[f64; 3]> {
    let state = Engagement::new(at).ok()?.steady_state().ok()?;
    Some([state.peak.speed, state.minimum.speed, state.period])
}

/// The same.
fn by_steps(at: &Parameters) -> Option<[f64; 3]> {
    let motion = Motion::of(at)?;
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

fn three() -> Claim {
    Claim::statement(
        WORK,
        "meyer.conclusion.three",
        "Conclusion 3",
        "three combinations of pins and slots, and no more",
        "Only three geometrical configurations",
        Check::corrected_statement(
            (Vectors, |stated| {
                let found: Vec<_> = pairs().filter(|pair| takes_over(*pair, stated)).collect();
                Finding::new(
                    found == THREE,
                    format!("of pins and slots up to {MOST}, {} pairs: {}", found.len(), listed(&found)),
                )
            }),
            (Steps, |stated| {
                let found: Vec<_> = pairs().filter(|pair| settles(*pair, stated)).collect();
                Finding::new(
                    found == THREE,
                    format!("by steps of the motion {} pairs: {}", found.len(), listed(&found)),
                )
            }),
        ),
    )
    .read_as(
        "A configuration works in a timing application if pins without width take over from one another without a \
         blow and the motion comes to a terminal velocity.",
    )
    .expecting(Verdict::Corrected)
    .with_erratum(Erratum {
        corrected: "Only three geometrical configurations that bring the follower to rest at each hand-over",
        slip: Slip {
            id: "",
            reason: "The follower need not stand still when one pin takes over from another. By Eq. (1-7) φ'/θ' is \
                     the same at θ and at -θ, so that the leaving pin and the entering one always ask for the same \
                     speed of it. All that is needed is that the follower turns by 2π/n while the driver turns by \
                     2π/m, and a = sin(π/m + π/n)/sin(π/n) does that for other numbers too. With five pins and five \
                     slots the follower never stops.",
            witness: "Others come to a terminal velocity as well, by steps of the equation of motion.",
            origin: Origin::Concept,
            consequence: Consequence::Conclusion,
            changes: "There are more configurations to choose from than the three that were studied.",
        },
    })
}

/// Pins and slots of the three configurations.
const THREE: [(u32, u32); 3] = [(3, 6), (4, 4), (6, 3)];

/// The greatest number of pins and of slots that is tried.
const MOST: u32 = 7;

/// Pins and slots, with which the follower does not turn back.
fn pairs() -> impl Iterator<Item = (u32, u32)> {
    let all = (3..=MOST).flat_map(|pins| (3..=MOST).map(move |slots| (pins, slots)));
    all.filter(|(pins, slots)| 2 * (pins + slots) <= pins * slots)
}

fn listed(pairs: &[(u32, u32)]) -> String {
    pairs.iter().map(|(pins, slots)| format!("{pins}/{slots}")).collect::<Vec<_>>().join(", ")
}

/// Centre distance over crank radius, and the angle from the line of centres at which a pin leaves.
fn sizes((pins, slots): (u32, u32)) -> (f64, f64) {
    let [pin, slot] = [pins, slots].map(|count| PI / f64::from(count));
    (libm::sin(pin + slot) / libm::sin(slot), pin)
}

/// Whether one pin takes over from another without a blow; and, if that is stated, with the follower at rest.
fn takes_over(pair: (u32, u32), stated: Stated) -> bool {
    let (ratio, half) = sizes(pair);
    // The pin from the follower's axis and its velocity: angle and speed of a slot that holds it.
    let slot = |angle: f64| {
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let (place, velocity) = (Vector2::new(ratio - cos, sin), Vector2::new(sin, cos));
        (libm::atan2(place.y, place.x), place.perp(&velocity) / place.norm_squared())
    };
    let ((leaving, speed), (entering, other)) = (slot(half), slot(-half));
    let pitch = 2.0 * PI / f64::from(pair.1);
    vanishes(leaving - entering - pitch) && vanishes(speed - other) && stated.pick(vanishes(speed), true)
}

/// Whether the motion of a mechanism with these pins and slots comes to repeat itself; and, if that is stated, with the
/// follower at rest at each hand-over.
///
/// With a torque and a follower of one, a driver of half the follower's inertia and a friction of a fifth: any will do.
fn settles(pair: (u32, u32), stated: Stated) -> bool {
    let (ratio, half) = sizes(pair);
    let at = |angle: f64| Coefficients::new(&ratio, &Turn::from_radians(angle), &0.5, &0.2, &1.0);
    let slope = |angle: f64, state: &Vector1<f64>| {
        at(angle).acceleration(state[0].max(0.0).sqrt()).map(|found| Vector1::new(2.0 * found.value))
    };
    let engagement = |entry: f64| {
        let place = |k: u32| half * (f64::from(k) / 100.0 - 1.0);
        (0..200).try_fold(Vector1::new(entry), |state, k| {
            let first = slope(place(k), &state)?;
            runge_kutta_step(slope, place(k), place(k + 1), &state, &first)
        })
    };
    let mut square = 0.0;
    for _ in 0..1000 {
        let Ok(next) = engagement(square) else { return false };
        let change = next[0] - square;
        square = next[0];
        if change.abs() <= 1e-9 * square {
            let lead = ratio * libm::cos(half) - 1.0;
            return square.is_finite() && stated.pick(vanishes(lead * square.sqrt()), true);
        }
    }
    false
}
