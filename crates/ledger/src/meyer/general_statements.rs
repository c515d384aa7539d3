//! The parametric graphs, Figs. 9 to 11, and what the general statements on them say of the torque.

use super::profile::lost;
use super::runs::{Column, Hypothesis, Row, series};
use super::study::steady;
use super::*;
use crate::Evidence::Quadrature;
use crate::Stated;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Coefficients, Inertias, Parameters, Sign};
use geneva_kinematics::Expression;

const FIRST: Place = at("Chapter II, 1st general statement");
const THIRD: Place = at("Chapter II, 3rd general statement");

pub fn claims() -> Vec<Claim> {
    let mut claims = vec![more_torque(), least_rise_time()];
    claims.extend(graphs());
    claims.extend(less_friction::claims());
    claims.push(almost_linear());
    claims
}

fn more_torque() -> Claim {
    FIRST
        .statement(
            "meyer.more-torque",
            "the lower the rise time, and the greater the terminal velocity",
            "more torque, more speed and less rise time",
        )
        .by(Quadrature, |stated| {
            let sign = stated.pick(1.0, -1.0);
            let found: Vec<bool> = series()
                .flat_map(|own| own.windows(2))
                .map(|pair| {
                    let Some([weak, strong]) = starts(&pair[0]).zip(starts(&pair[1])).map(<[Start; 2]>::from) else {
                        return false;
                    };
                    let faster = sign * (strong.speed - weak.speed) > 0.0;
                    let shorter = |k: usize| sign * (weak.times[k] - strong.times[k]) > 0.0;
                    faster && (0..weak.times.len()).all(shorter)
                })
                .collect();
            let right = found.iter().filter(|right| **right).count();
            Finding::new(
                !found.is_empty() && right == found.len(),
                format!(
                    "so it is for {right} of {} pairs of neighbouring rows, whether the rise ends with the first \
                     minimum, with an entry or with a peak within one per cent",
                    found.len()
                ),
            )
        })
        .by(ExactIdentity, |stated| scaling(stated.pick(1, -1)))
        .but_not("the greater the torque, the greater the rise time, and the lower the terminal velocity")
        .read_as("With all else kept.")
}

fn least_rise_time() -> Claim {
    FIRST
        .statement(
            "meyer.least-rise-time",
            "reach a certain minimum",
            "the rise time does not fall below a least one, however strong the spring",
        )
        .by(Quadrature, |stated| {
            // The power of the torque with which a rise time goes where the torque is great.
            let power = stated.pick(-0.5, 0.0);
            let found: Vec<f64> = series()
                .filter_map(|own| {
                    let strongest = own.last()?;
                    let times = |factor| Some(Start::of(&with(strongest, factor, 1.0)?)?.times);
                    let (strong, stronger) = (times(1e6)?, times(4e6)?);
                    Some(strong.into_iter().zip(stronger).map(|(a, b)| libm::log(b / a) / libm::log(4.0)))
                })
                .flatten()
                .collect();
            let holds = found.iter().all(|found| (found - power).abs() < 1e-6);
            Finding::new(
                holds && found.len() == 3 * series().count(),
                format!(
                    "a million times the torque of the tables and four times as much: the rise time goes as the power \
                     {:.6} of it, with every mechanism and friction",
                    found.first().copied().unwrap_or(f64::NAN)
                ),
            )
        })
        .by(ExactIdentity, |stated| scaling(stated.pick(1, 0)))
        .read_as(
            "From some torque on more torque does not shorten the rise, whether it ends with the first minimum, or \
             with an entry or a peak within one per cent of the steady one.",
        )
        .corrected(
            "fall without end, as the inverse of the root of the torque, so that every increase reduces it",
            Slip {
                id: "",
                reason: "Eq. (1-19) stays the same for a larger torque if all times are shortened by its root. The \
                         inertias set the scale of the times, √(I_f/K), which falls with K as far as one likes: there \
                         is no least time.",
                witness: "The law of similarity is proven for the equation; without a change of the times it is \
                          refuted.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "A stronger spring always shortens the rise: four times the torque halves it.",
            },
        )
}

fn graphs() -> Vec<Claim> {
    vec![
        lost("meyer.fig-9", "Fig. 9", "rise time and terminal velocity over torque, three pins", "FIGURE 9"),
        at("Figs. 10 and 11, ordinates")
            .statement(
                "meyer.fig-10.rise-axis",
                "RISE TIME TO 99% OF TERMINAL VELOCITY",
                "the rise time that is drawn ends at 99 per cent of the terminal velocity",
            )
            .missing(
                "The curves are not in the copy, and of which velocity it is 99 per cent is not said. The text has \
                 another definition, the first minimum. Neither that nor any of the readings of the axis that were \
                 tried gives more than a minority of the rise times of Appendix E, of which the figures are the \
                 summary",
            ),
        lost("meyer.fig-10", "Fig. 10", "rise time and terminal velocity over torque, four pins", "FIGURE 10"),
        study::of_axis(),
        lost("meyer.fig-11", "Fig. 11", "rise time and terminal velocity over torque, six pins", "FIGURE 11"),
    ]
}

fn almost_linear() -> Claim {
    THIRD
        .statement(
            "meyer.almost-linear",
            "An almost linear relationship exists",
            "over the torque the terminal velocity is nearly a straight line",
        )
        .by(OtherPlaceInSource, |stated| {
            let fits = series().map(|own| {
                let speed = |row: &Row| f64::midpoint(row.number(Column::Peak), row.number(Column::Minimum));
                let points: Vec<_> = own.iter().map(|row| (row.torque(), speed(row))).collect();
                explained_by_line(&points, stated)
            });
            straight(&fits.collect::<Vec<_>>(), "printed")
        })
        .by(Quadrature, |stated| {
            let fits = steady().chunk_by(|(a, _), (b, _)| {
                a.mechanism == b.mechanism && a.printed(Column::Friction) == b.printed(Column::Friction)
            });
            let fits = fits.map(|own| {
                let torques: Vec<f64> = own.iter().map(|(row, _)| row.torque()).collect();
                let speeds: Vec<f64> = own.iter().map(|(_, state)| state.mean_of_extremes()).collect();
                explained_by_projection(&torques, speeds, stated)
            });
            straight(&fits.collect::<Vec<_>>(), "computed")
        })
        .but_not("the terminal velocity is almost proportional to the driving torque")
        .read_as(
            "Over the torques of each graph a straight line, which need not start at zero, accounts for 99 per cent or \
             more of the variance of the velocities: the measure on the axes of Figs. 10 and 11.",
        )
}

/// A start from rest as far as rise times go.
struct Start {
    /// The average terminal velocity of the source: the mean of peak and minimum.
    speed: f64,
    /// Until the first minimum, an entry within one per cent of the steady one, a peak within one per cent.
    times: [f64; 3],
}

impl Start {
    fn of(engagement: &Engagement) -> Option<Self> {
        let rise = engagement.rise(1e-6).ok()?;
        let times = [engagement.first_minimum().ok()??.time, rise.until_entry_speed(0.01)?, rise.until_peak(0.01)?];
        Some(Self { speed: rise.steady.mean_of_extremes(), times })
    }
}

fn starts(row: &Row) -> Option<Start> {
    Start::of(&Hypothesis::IDEAL.engagement(row)?)
}

/// A row's mechanism with as many times its torque and its friction.
pub fn with(row: &Row, torque: f64, friction: f64) -> Option<Engagement> {
    let at = Hypothesis::IDEAL.parameters(row)?;
    let changed =
        Parameters::new(at.mechanism(), at.inertias(), at.torque() * torque, at.friction() * friction).ok()?;
    Engagement::with_tolerance(&changed, 1e-11).ok()
}

/// Relative changes of three quantities in each group of runs, for each set of factors of torque, friction and the two
/// inertias.
pub type Responses = Vec<Vec<[f64; 3]>>;

/// Those to these sets of factors; not numbers where the quantities cannot be found.
pub fn responses(factors: &[[f64; 4]], of: fn(&Parameters) -> Option<[f64; 3]>) -> Responses {
    let before: Vec<_> = series()
        .filter_map(|own| {
            let at = Hypothesis::IDEAL.parameters(own.first()?)?;
            Some((at, of(&at)?))
        })
        .collect();
    let response = |[torque, friction, driver, follower]: &[f64; 4], at: &Parameters, before: &[f64; 3]| {
        let inertias = Inertias::new(at.inertias().driver() * driver, at.inertias().follower() * follower).ok()?;
        let changed = Parameters::new(at.mechanism(), inertias, at.torque() * torque, at.friction() * friction).ok()?;
        let after = of(&changed)?;
        Some(std::array::from_fn(|k| (after[k] / before[k] - 1.0).abs()))
    };
    let all = |set: &[f64; 4]| before.iter().map(|(at, old)| response(set, at, old).unwrap_or([f64::NAN; 3])).collect();
    factors.iter().map(all).collect()
}

/// Whether κ² times the torque only makes all speeds κ^p times as large, and all times shorter by as much.
fn scaling(power: i32) -> Finding {
    all_proven(&Sign::BOTH.map(|sign| Scaled { power, sign }))
}

/// Eq. (1-19) with the torque κ² E, speeds κ^p θ' and accelerations κ^2p θ'', less κ² times Eq. (1-19).
///
/// Variables: A to E, θ', θ'', κ.
struct Scaled {
    power: i32,
    sign: Sign,
}

impl Identity<8> for Scaled {
    fn difference(&self, [a, b, c, d, e, speed, angular_acceleration, kappa]: [Expression; 8]) -> Expression {
        let whole = (0..self.power.unsigned_abs()).fold(Expression::ONE, |product, _| product * kappa);
        let factor = if self.power < 0 { 1 / whole } else { whole };
        let square = kappa * kappa;
        let left = |e: Expression, speed: Expression, angular_acceleration: Expression| {
            Coefficients { a, b, c, d, e }.residual(&speed, &angular_acceleration, self.sign)
        };
        left(square * e, factor * speed, factor * factor * angular_acceleration)
            - square * left(e, speed, angular_acceleration)
    }
}

/// Whether a line accounts for 99 per cent of the variance in all twelve groups.
fn straight(parts: &[f64], speeds: &str) -> Finding {
    let [least, most] =
        parts.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], part| [low.min(*part), high.max(*part)]);
    Finding::new(
        parts.len() == series().count() && least >= 0.99,
        format!("of the variance of the {speeds} velocities in {} groups {least:.3} to {most:.3}", parts.len()),
    )
}

/// The part of the variance of the ordinates for which the best line accounts: any line, or one through the origin.
/// Less than zero if it is worse than their mean.
fn explained_by_line(points: &[(f64, f64)], stated: Stated) -> f64 {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y, xx, xy) = (mean(|p| p.0), mean(|p| p.1), mean(|p| p.0 * p.0), mean(|p| p.0 * p.1));
    let (slope, start) = stated.pick(
        {
            let slope = (xy - x * y) / (xx - x * x);
            (slope, y - slope * x)
        },
        (xy / xx, 0.0),
    );
    let left: f64 = points.iter().map(|(at, value)| value - start - slope * at).map(|off| off * off).sum();
    let all: f64 = points.iter().map(|(_, value)| (value - y) * (value - y)).sum();
    1.0 - left / all
}

/// The same: what is left of the ordinates when their components along the abscissae, and along a constant if the line
/// need not start at zero, are taken off.
fn explained_by_projection(abscissae: &[f64], ordinates: Vec<f64>, stated: Stated) -> f64 {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let without = |of: &[f64], along: &[f64]| -> Vec<f64> {
        let part = dot(of, along) / dot(along, along);
        of.iter().zip(along).map(|(a, b)| a - part * b).collect()
    };
    let constant = vec![1.0; ordinates.len()];
    let about_mean = without(&ordinates, &constant);
    let [direction, rest] =
        stated.pick([without(abscissae, &constant), about_mean.clone()], [abscissae.to_vec(), ordinates]);
    let left = without(&rest, &direction);
    1.0 - dot(&left, &left) / dot(&about_mean, &about_mean)
}

#[cfg(test)]
mod tests {
    use super::runs::rows;
    use super::*;

    #[test]
    fn no_reading_of_the_axis_nor_of_the_text_gives_most_of_the_rise_times() {
        for (definition, found) in runs::rise_times::explained() {
            let counts = found.map(|of| of.within_one.iter().sum::<usize>());
            assert!(counts.iter().all(|count| 2 * count < rows().len()), "{}: {counts:?}", definition.name);
        }
        // Nor does the time at which 99 per cent of the average terminal velocity are first reached.
        for of in [Hypothesis::IDEAL, Hypothesis::WITHOUT_LAG] {
            let near = rows().iter().filter(|row| {
                let at = of.engagement(row).expect("an escapement");
                let average = at.steady_state().expect("a steady state").mean_of_extremes();
                let lines = at.run(runs::interval() / 10.0, runs::duration()).expect("a run");
                let reached = lines.iter().find(|line| line.speed >= 0.99 * average).expect("in the run");
                (reached.time - row.number(Column::Rise)).abs() <= 1e-3
            });
            let count = near.count();
            assert!(2 * count < rows().len(), "{count}");
        }
    }

    #[test]
    fn a_line_accounts_for_all_of_a_line_and_little_of_a_parabola() {
        for (stated, start) in [(Stated::right(""), 3.0), (Stated::wrong(""), 0.0)] {
            let points: Vec<(f64, f64)> = (1..6).map(|k| (f64::from(k), start + 2.0 * f64::from(k))).collect();
            let (x, y): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
            assert!((explained_by_line(&points, stated) - 1.0).abs() < 1e-12);
            assert!((explained_by_projection(&x, y, stated) - 1.0).abs() < 1e-12);
        }
        let bent: Vec<(f64, f64)> = (-3..4).map(|k| (f64::from(k), f64::from(k * k))).collect();
        let (x, y): (Vec<f64>, Vec<f64>) = bent.iter().copied().unzip();
        assert!(explained_by_line(&bent, Stated::right("")).abs() < 1e-12);
        assert!(explained_by_projection(&x, y, Stated::right("")).abs() < 1e-12);
    }
}
