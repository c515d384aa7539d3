//! The general statement on friction: what less of it does to the rise, and what none does.

use super::by_steps::{Motion, groups};
use super::general_statements::with;
use super::runs::{Hypothesis, rise_times, rows, series};
use super::terms::Start;
use super::*;
use crate::Evidence::{Quadrature, RungeKutta};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

const SECOND: Place = at("Chapter II, 2nd general statement");

pub fn claims() -> Vec<Claim> {
    vec![less_friction(), no_friction()]
}

fn less_friction() -> Claim {
    SECOND
        .statement(
            "meyer.less-friction",
            "The more frictionless the system, the greater is the rise time",
            "less friction, longer rise",
        )
        .by(Quadrature, |stated| goes(stated, Mechanism::ALL.map(by_friction), GRID as usize))
        .by(RungeKutta, |stated| goes(stated, Mechanism::ALL.map(by_friction_in_steps), FRICTIONS))
        .corrected(
            "On the whole the rise time falls as the friction grows; but more friction can also lengthen it",
            Slip {
                id: "",
                reason: "With more friction an engagement leaves less of a difference from the steady motion, but it \
                         takes longer. So the rise needs fewer engagements, and as long as their number stays it takes \
                         more time. From the least to the greatest friction of the runs it falls all the same, and \
                         without friction it has no end. Only the time in which a difference dies away, taken as if it \
                         did so evenly, falls with each step. The thesis's own rise times do not fall with each step \
                         either.",
                witness: "Motions in steps of the angle, with the frictions of the runs.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "A little more friction may lengthen the rise.",
            },
        )
}

fn no_friction() -> Claim {
    SECOND
        .statement(
            "meyer.no-friction",
            "will never reach a terminal velocity",
            "without friction there is no terminal velocity",
        )
        .by(Quadrature, |stated| {
            // Speeds that go as the root of the number of engagements know no bound.
            let quotients: Vec<f64> = series()
                .filter_map(|own| {
                    let of = with(own.first()?, 1.0, stated.pick(0.0, 0.01))?;
                    let (mut speed, mut after) = (0.0, Vec::new());
                    for _ in 0..400 {
                        speed = of.return_map(speed).ok()?;
                        after.push(speed);
                    }
                    Some(after.get(399)? / after.get(99)?)
                })
                .collect();
            Finding::new(
                quotients.len() == series().count() && quotients.iter().all(|quotient| (quotient - 2.0).abs() < 1e-9),
                format!(
                    "after four hundred engagements the speed is {:.6} times that after one hundred with six pins",
                    quotients.first().copied().unwrap_or(f64::NAN)
                ),
            )
        })
        .by(RungeKutta, |stated| {
            // Each engagement adds the whole work of the spring to the driver's energy.
            let parts: Vec<f64> = series()
                .filter_map(|own| {
                    let of = with(own.first()?, 1.0, stated.pick(0.0, 0.01))?;
                    let (at, motion) = (of.parameters(), Motion::from_rest(of.parameters(), 12));
                    let energy = at.inertias().driver() * motion.engagements.last()?.end() / 2.0;
                    let work = at.torque() * 2.0 * at.mechanism().engagement_half_angle();
                    Some(energy / (12.0 * work))
                })
                .collect();
            Finding::new(
                parts.len() == series().count() && parts.iter().all(|part| (part - 1.0).abs() < 1e-6),
                format!(
                    "after twelve engagements the driver has {:.6} of the work of the spring with six pins",
                    parts.first().copied().unwrap_or(f64::NAN)
                ),
            )
        })
        .but_not("nor does it with a hundredth of the friction of the runs")
}

/// Frictions between the least and the greatest of the runs, both included.
const GRID: u32 = 16;

/// Frictions of the runs.
const FRICTIONS: usize = 4;

/// Whether the rise times, by rising friction, fall from each to the next with every mechanism, or on the whole only: by
/// both readings of them.
fn goes(stated: Stated, mechanisms: [Vec<[f64; 2]>; 3], count: usize) -> Finding {
    let readings = [0, 1]
        .map(|reading| mechanisms.each_ref().map(|own| own.iter().map(|both| both[reading]).collect::<Vec<f64>>()));
    let complete = mechanisms.iter().all(|own| own.len() == count);
    let falls = readings.iter().flatten().all(|times| always_falls(times));
    let on_the_whole = readings.iter().flatten().all(|times| times.first() > times.last());
    let rises = readings.iter().all(|own| own.iter().any(|times| times.windows(2).any(|pair| pair[1] > pair[0])));
    let printed = rise_times::with_more_friction();
    let steps =
        |of: &[Vec<f64>; 3]| of.iter().flat_map(|times| times.windows(2)).filter(|pair| pair[1] > pair[0]).count();
    Finding::new(
        complete && stated.pick(on_the_whole && rises, falls),
        format!(
            "of {} steps to more friction {} make the rise longer by the velocity at each angle and {} by the average of \
             peak and minimum; in Appendix E {} of {}, and in {} the time stays",
            3 * (count - 1),
            steps(&readings[0]),
            steps(&readings[1]),
            printed.up,
            printed.pairs,
            printed.equal
        ),
    )
}

/// The rise times of a mechanism with each friction of the grid, for a torque that is the same.
fn by_friction(mechanism: Mechanism) -> Vec<[f64; 2]> {
    static STARTS: OnceLock<[Vec<[f64; 2]>; 3]> = OnceLock::new();
    let all = STARTS.get_or_init(|| {
        let (low, high) = rows()
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |(low, high), row| (low.min(row.friction()), high.max(row.friction())));
        let friction = |k: u32| low + (high - low) * f64::from(k) / f64::from(GRID - 1);
        let start = |at: &Parameters, k: u32| {
            let with = Parameters::new(at.mechanism(), at.inertias(), at.torque(), friction(k)).ok()?;
            Some(Start::by_integrals(&Engagement::with_tolerance(&with, 1e-11).ok()?)?.rise_times)
        };
        Mechanism::ALL.map(|mechanism| {
            let own = rows().iter().find(|row| row.mechanism == mechanism);
            let at = own.and_then(|row| Hypothesis::IDEAL.parameters(row));
            at.map_or_else(Vec::new, |at| (0..GRID).filter_map(|k| start(&at, k)).collect())
        })
    });
    all[mechanism.index()].clone()
}

/// The same by steps of the angle, with the frictions of the runs and times in units of √(I_f/K), as groups of runs differ
/// in their torques.
fn by_friction_in_steps(mechanism: Mechanism) -> Vec<[f64; 2]> {
    let own = groups().iter().filter(|group| group.rows.first().is_some_and(|row| row.mechanism == mechanism));
    let times = |motion: &Motion| {
        let unit = motion.parameters.drive().sqrt();
        Some(Start::by_steps(motion)?.rise_times.map(|time| time * unit))
    };
    own.filter_map(|group| times(&group.motion)).collect()
}

/// Whether numbers fall from each to the next.
fn always_falls(numbers: &[f64]) -> bool {
    numbers.len() > 1 && numbers.is_sorted_by(|a, b| a > b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_in_which_a_difference_dies_away_evenly_falls_with_each_step() {
        for mechanism in Mechanism::ALL {
            let own = groups().iter().filter(|group| group.rows[0].mechanism == mechanism);
            let times: Vec<f64> = own
                .map(|group| {
                    let at = Hypothesis::IDEAL.parameters(&group.rows[0]).expect("an escapement");
                    let settling = geneva_dynamics::timer::Settling::new(&at).expect("a steady state");
                    settling.time(0.01) * at.drive().sqrt()
                })
                .collect();
            assert!(times.len() == FRICTIONS && always_falls(&times), "{times:?}");
        }
    }

    #[test]
    fn with_three_pins_the_velocity_profile_is_reached_sooner_with_each_step_and_with_the_others_not() {
        let falls = Mechanism::ALL.map(|mechanism| {
            let times: Vec<f64> = by_friction(mechanism).iter().map(|both| both[0]).collect();
            always_falls(&times)
        });
        assert_eq!(falls.iter().filter(|falls| **falls).count(), 1);
        assert!(falls[Mechanism::THREE_PIN.index()]);
    }
}
