//! The general statement on friction: what less of it does to the rise, and what none does.

use super::by_steps::{Motion, groups};
use super::general_statements::with;
use super::runs::{Hypothesis, rows, series};
use super::*;
use crate::Evidence::{Quadrature, RungeKutta};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::{Engagement, Rise};
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
        .by(Quadrature, |stated| {
            let times = Mechanism::ALL.map(|mechanism| {
                let own = starts().iter().filter(|start| start.mechanism == mechanism);
                own.map(|start| stated.pick(start.to_terminal_speed(), Some(start.first_minimum)).unwrap_or(f64::NAN))
                    .collect::<Vec<_>>()
            });
            let falling = times.iter().filter(|times| always_falls(times)).count();
            Finding::new(
                falling == times.len(),
                format!(
                    "with {falling} of the three mechanisms it falls from each of {GRID} frictions of the runs' range \
                     to the next"
                ),
            )
        })
        .by(RungeKutta, |stated| {
            let found = by_friction(stated.pick(to_terminal_speed_by_steps, first_minimum_by_steps));
            let falls = found.iter().all(|times| always_falls(times));
            let four = &found[Mechanism::FOUR_PIN.index()];
            Finding::new(falls, format!("with four pins, by rising friction, in units of √(I_f/K): {four:.4?}"))
        })
        .but_not("the greater is the time of the first minimum")
        .read_as(
            "Rise time as on the axes of Figs. 10 and 11, to 99 per cent of the terminal velocity: of the speed at entry, \
             of which what is missing dies away evenly from one entry to the next. The text's other measure, the first \
             minimum, goes the other way; and a time that counts whole engagements jumps.",
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

/// A start from rest, for a torque and a follower of one.
struct Start {
    mechanism: Mechanism,
    rise: Rise,
    first_minimum: f64,
}

impl Start {
    fn of(mechanism: Mechanism, parameters: &Parameters) -> Option<Self> {
        let of = Engagement::with_tolerance(parameters, 1e-11).ok()?;
        Some(Self { mechanism, first_minimum: of.first_minimum().ok()??.time, rise: of.rise(1e-6).ok()? })
    }

    /// When the speed at entry comes to 99 per cent of the steady one.
    fn to_terminal_speed(&self) -> Option<f64> {
        let entries = self.rise.cycles.iter().map(|cycle| (cycle.start, cycle.entry_speed));
        until_a_hundredth(entries, self.rise.steady.entry_speed)
    }
}

/// The time at which a hundredth of the steady speed is missing, from the times of entries and the speeds there; what is
/// missing falls between two entries by one factor in equal times.
fn until_a_hundredth(entries: impl Iterator<Item = (f64, f64)>, steady: f64) -> Option<f64> {
    let missing: Vec<(f64, f64)> = entries.map(|(time, speed)| (time, (1.0 - speed / steady).abs())).collect();
    let pair = missing.windows(2).find(|pair| pair[1].1 <= 0.01)?;
    let [(before, more), (after, less)] = [pair[0], pair[1]];
    Some(before + (after - before) * libm::log(more / 0.01) / libm::log(more / less))
}

/// The starts of the three mechanisms with each friction of the grid.
fn starts() -> &'static [Start] {
    static STARTS: OnceLock<Vec<Start>> = OnceLock::new();
    STARTS.get_or_init(|| {
        let (low, high) = rows()
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |(low, high), row| (low.min(row.friction()), high.max(row.friction())));
        let friction = |k: u32| low + (high - low) * f64::from(k) / f64::from(GRID - 1);
        let of = |mechanism: Mechanism| {
            let own = rows().iter().find(|row| row.mechanism == mechanism);
            let at = own.and_then(|row| Hypothesis::IDEAL.parameters(row));
            let with = move |k| Parameters::new(at?.mechanism(), at?.inertias(), at?.torque(), friction(k)).ok();
            (0..GRID).filter_map(move |k| Start::of(mechanism, &with(k)?))
        };
        Mechanism::ALL.into_iter().flat_map(of).collect()
    })
}

/// A measure of the rise by steps; times in units of √(I_f/K), as groups of runs differ in their torques.
type SteppedReading = fn(&Motion) -> Option<f64>;

fn to_terminal_speed_by_steps(motion: &Motion) -> Option<f64> {
    let entry = |of: &by_steps::Engagement| Some((*of.times.first()?, of.ends()[0]));
    Some(until_a_hundredth(motion.engagements.iter().filter_map(entry), motion.steady()?.ends()[0])? * unit(motion))
}

fn first_minimum_by_steps(motion: &Motion) -> Option<f64> {
    Some(motion.least(motion.engagements.first()?)?.time * unit(motion))
}

/// √(K/I_f), by which times become numbers.
fn unit(motion: &Motion) -> f64 {
    motion.parameters.drive().sqrt()
}

/// A reading of the groups of each mechanism, by rising friction.
fn by_friction(reading: SteppedReading) -> [Vec<f64>; 3] {
    Mechanism::ALL.map(|mechanism| {
        let own = groups().iter().filter(|group| group.rows.first().is_some_and(|row| row.mechanism == mechanism));
        own.map(|group| reading(&group.motion).unwrap_or(f64::NAN)).collect()
    })
}

/// Whether numbers fall from each to the next.
fn always_falls(numbers: &[f64]) -> bool {
    numbers.len() > 1 && numbers.is_sorted_by(|a, b| a > b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_starts_are_there_and_each_engagement_takes_longer_with_more_friction() {
        for mechanism in Mechanism::ALL {
            let own = starts().iter().filter(|start| start.mechanism == mechanism);
            let periods: Vec<f64> = own.map(|start| start.rise.steady.period).collect();
            assert_eq!(periods.len(), GRID as usize);
            assert!(periods.is_sorted_by(|a, b| a < b), "{periods:?}");
        }
    }

    #[test]
    fn the_rise_is_longer_with_less_friction_by_its_first_measure_and_shorter_by_its_second() {
        for mechanism in Mechanism::ALL {
            let own = || starts().iter().filter(move |start| start.mechanism == mechanism);
            let first: Vec<f64> = own().map(|start| start.first_minimum).collect();
            assert!(first.is_sorted_by(|a, b| a < b), "{first:?}");
            // What counts whole engagements comes no earlier, and less than one of them later.
            for start in own() {
                let [smooth, whole] = [start.to_terminal_speed(), start.rise.until_entry_speed(0.01)];
                let late = whole.expect("settled") - smooth.expect("settled");
                assert!((0.0..=1.5 * start.rise.steady.period).contains(&late), "{late}");
            }
        }
    }
}
