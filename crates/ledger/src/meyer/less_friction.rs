//! The general statement on friction: what less of it does to the rise, and what none does.

use super::by_steps::{Motion, groups};
use super::general_statements::with;
use super::runs::{Hypothesis, rows, series, steps};
use super::*;
use crate::Evidence::{Quadrature, RungeKutta};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::{Engagement, Printed, Rise};
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
            let readings = stated.pick::<&[Reading]>(&[DECAY], &RISE_TIMES);
            let found: Vec<[bool; 3]> = readings
                .iter()
                .map(|(_, reading)| {
                    Mechanism::ALL.map(|mechanism| {
                        let own = starts().iter().filter(|start| start.mechanism == mechanism);
                        always_falls(&own.map(|start| reading(start).unwrap_or(f64::NAN)).collect::<Vec<_>>())
                    })
                })
                .collect();
            let counts: Vec<String> = readings
                .iter()
                .zip(&found)
                .map(|((name, _), of)| format!("{name} {}", of.iter().filter(|falls| **falls).count()))
                .collect();
            Finding::new(
                found.contains(&[true; 3]),
                format!(
                    "with how many of the three mechanisms it falls from each of {GRID} frictions of the runs' range \
                     to the next: {}",
                    counts.join(", ")
                ),
            )
        })
        .by(RungeKutta, |stated| {
            let readings = stated.pick::<&[SteppedReading]>(&[decay_by_steps], &RISE_TIMES_BY_STEPS);
            let found: Vec<[Vec<f64>; 3]> = readings.iter().map(|of| by_friction(*of)).collect();
            let some = found.iter().any(|reading| reading.iter().all(|times| always_falls(times)));
            let four: Vec<_> = found.iter().map(|of| format!("{:.4?}", of[Mechanism::FOUR_PIN.index()])).collect();
            Finding::new(some, format!("with four pins, by rising friction: {}", four.join(", ")))
        })
        .read_as(
            "With each of the three mechanisms the rise time, in some one sense that the source's two definitions \
             bear, grows from each friction to the next smaller one. The senses: until the first minimum, as in the \
             text; until entry speed, peak, minimum, mean of both or mean over an engagement are within one per cent \
             of the steady ones; until 99 per cent of one of these are first reached.",
        )
        .corrected(
            "The more frictionless the system, the greater is the time in which a small difference from the terminal \
             velocity dies away",
            Slip {
                id: "",
                reason: "With less friction an engagement leaves more of a difference from the steady motion. Each \
                         takes less time, but not so much less: the time constant grows, and in that sense the \
                         sentence is right. The source's rise times are others. The time of the first minimum shortens \
                         with less friction; a time until some per cent are left shortens too, and grows by a whole \
                         engagement now and then.",
                witness: "By steps, with the frictions of the runs.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "By the source's definitions more friction does not shorten every rise; the first minimum it \
                          delays.",
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

/// A start from rest, for a torque and a follower of one.
struct Start {
    mechanism: Mechanism,
    rise: Rise,
    first_minimum: f64,
    lines: Vec<Printed>,
}

impl Start {
    fn of(mechanism: Mechanism, parameters: &Parameters) -> Option<Self> {
        let of = Engagement::with_tolerance(parameters, 1e-11).ok()?;
        let rise = of.rise(1e-6).ok()?;
        let lines = of.run(rise.steady.period / 400.0, rise.cycles.last()?.end).ok()?;
        Some(Self { mechanism, first_minimum: of.first_minimum().ok()??.time, rise, lines })
    }

    /// When 99 per cent of a speed are first reached.
    fn reaches(&self, speed: f64) -> Option<f64> {
        let after = self.lines.iter().position(|line| line.speed >= 0.99 * speed)?;
        let [a, b] = [self.lines.get(after.checked_sub(1)?)?, self.lines.get(after)?];
        // Between two lines as if it were straight.
        Some(a.time + (0.99 * speed - a.speed) / (b.speed - a.speed) * (b.time - a.time))
    }
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

/// What a rise is measured by, and its name.
type Reading = (&'static str, fn(&Start) -> Option<f64>);

/// The time in which a small difference from the steady speed is down to a hundredth.
const DECAY: Reading = ("a small difference down to a hundredth", |start| {
    let steady = &start.rise.steady;
    Some(steady.period * libm::log(0.01) / libm::log(steady.multiplier))
});

/// The senses of the rise time that the source's two definitions have.
const RISE_TIMES: [Reading; 10] = [
    ("first minimum", |start| Some(start.first_minimum)),
    ("entry within 1%", |start| start.rise.until_entry_speed(0.01)),
    ("peak within 1%", |start| start.rise.until_peak(0.01)),
    ("minimum within 1%", |start| start.rise.until_minimum(0.01)),
    ("mean of both within 1%", |start| start.rise.until_mean_of_extremes(0.01)),
    ("mean of an engagement within 1%", |start| start.rise.until_mean_speed(0.01)),
    ("99% of the entry speed", |start| start.reaches(start.rise.steady.entry_speed)),
    ("99% of the peak", |start| start.reaches(start.rise.steady.peak.speed)),
    ("99% of the mean of both", |start| start.reaches(start.rise.steady.mean_of_extremes())),
    ("99% of the mean", |start| start.reaches(start.rise.steady.mean_speed)),
];

/// The same by steps; times in units of √(I_f/K), as groups of runs differ in their torques.
type SteppedReading = fn(&Motion) -> Option<f64>;

/// Those of the text, of the axis with the entry speed, and of the axis with the average terminal velocity as defined.
const RISE_TIMES_BY_STEPS: [SteppedReading; 3] = [
    |motion| Some(motion.least(motion.engagements.first()?)?.time * unit(motion)),
    |motion| {
        let steady = motion.steady()?.ends()[0];
        let near = |of: &&by_steps::Engagement| (of.ends()[1] / steady - 1.0).abs() <= 0.01;
        Some(motion.engagements.iter().find(near)?.finish() * unit(motion))
    },
    |motion| {
        let steady = motion.steady()?;
        let peak = motion.greatest(steady, |_, speed| speed).value;
        let enough = 0.99 * f64::midpoint(peak, motion.least(steady)?.value);
        let reached = |of: &by_steps::Engagement| {
            let at = of.squares.iter().position(|square| square.sqrt() >= enough)?;
            of.times.get(at).copied()
        };
        Some(motion.engagements.iter().find_map(reached)? * unit(motion))
    },
];

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

/// The time in which a small difference is down to a hundredth, from what the steady engagement leaves of one.
fn decay_by_steps(motion: &Motion) -> Option<f64> {
    Some(motion.steady()?.duration() * unit(motion) * libm::log(0.01) / libm::log(left_over(motion)?))
}

/// Whether numbers fall from each to the next.
fn always_falls(numbers: &[f64]) -> bool {
    numbers.len() > 1 && numbers.is_sorted_by(|a, b| a > b)
}

/// The part of a small difference of the squares of two speeds that an engagement of the steady motion leaves.
fn left_over(motion: &Motion) -> Option<f64> {
    let entry = *motion.steady()?.squares.first()?;
    let end = |first: f64| steps::squares(&motion.parameters, &motion.angles, first).last().copied();
    let change = 1e-3 * entry;
    Some((end(entry + change)? - end(entry - change)?) / (2.0 * change))
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
    fn every_rise_time_is_found() {
        for (name, reading) in RISE_TIMES {
            assert!(starts().iter().all(|start| reading(start).is_some_and(|time| time > 0.0)), "{name}");
        }
    }

    #[test]
    fn the_first_minimum_comes_later_with_more_friction_and_a_trend_is_downward() {
        for mechanism in Mechanism::ALL {
            let own = || starts().iter().filter(move |start| start.mechanism == mechanism);
            let first: Vec<f64> = own().map(|start| start.first_minimum).collect();
            assert!(first.is_sorted_by(|a, b| a < b), "{first:?}");
            let entry: Vec<f64> = own().filter_map(|start| start.rise.until_entry_speed(0.01)).collect();
            assert!(entry.first() > entry.last(), "{entry:?}");
        }
    }
}
