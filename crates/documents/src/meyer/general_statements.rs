//! The parametric graphs, Figs. 9 to 11, and what the general statements on them say of the torque.

use super::runs::table::rows;
use super::terms::{Start, starts};
use super::*;
use crate::evidence::QUADRATURE;
use geneva_case1973::{Column, Hypothesis, Row, series};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Coefficients, Inertias, Parameters, Sign};
use geneva_evidence::Stated;
use geneva_kinematics::Expression;

const FIRST: Locator = at("Chapter II, 1st general statement");
const THIRD: Locator = at("Chapter II, 3rd general statement");

pub(super) fn claims() -> Vec<Claim> {
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
            "more torque gives more speed and a shorter rise time",
        )
        .missing(
            "The statement is about the graphs, which the copy does not contain. For the mechanisms themselves, with all \
             else unchanged, it holds in all 37 pairs of neighbouring rows of Appendix E, which the graphs summarise, \
             however we measure the rise time. As computed, both rise times are in inverse proportion to the square \
             root of the torque. But of the rise times that Appendix E prints, 2 of 37 go up with the torque and 2 stay \
             the same, and a graph through these points would rise. The thesis does not say whether it describes its \
             points or the mechanisms. The greater terminal velocity agrees with both",
        )
}

fn least_rise_time() -> Claim {
    FIRST
        .statement(
            "meyer.least-rise-time",
            "reach a certain minimum",
            "the rise time does not fall below a minimum, however strong the spring",
        )
        .first_route(QUADRATURE, |stated| {
            // The power of the torque with which a rise time goes where the torque is great.
            let power = stated.pick(-0.5, 0.0);
            let found: Vec<f64> = series(rows())
                .filter_map(|own| {
                    let strongest = own.last()?;
                    let times = |factor| Some(Start::by_integrals(&with(strongest, factor, 1.0)?)?.rise_times);
                    let (strong, stronger) = (times(1e6)?, times(4e6)?);
                    Some(strong.into_iter().zip(stronger).map(|(a, b)| libm::log(b / a) / libm::log(4.0)))
                })
                .flatten()
                .collect();
            let holds = found.iter().all(|found| (found - power).abs() < 1e-6);
            Finding::new(
                holds && found.len() == 2 * series(rows()).count(),
                format!(
                    "with every mechanism at every friction value of the runs, if the torque grows from one million to \
                     four million times the torque in the tables, the rise time varies as the torque to the power \
                     {:.6}, so more torque still shortens the rise",
                    found.first().copied().unwrap_or(f64::NAN)
                ),
            )
        })
        .second_route(Evidence::EXACT_IDENTITY, |stated| scaling(stated.pick(1, 0)))
        .interpreted_as(
            "We read the sentence as saying that, from some torque on, more torque does not shorten the rise. Appendix E \
             cannot decide this, because its torques are limited, so we judge the mechanisms.",
        )
        .corrected(
            "fall without limit, in inverse proportion to the square root of the torque, so that every increase of the \
             torque reduces the rise time",
            Slip {
                id: "",
                reason: "If the torque grows and all times shrink in inverse proportion to the square root of the \
                         torque, Eq. (1-19) still holds. So all times are proportional to √(I_f/K), where I_f is \
                         the follower's inertia and K the torque. As K grows, this square root becomes as small as we \
                         like, so there is no minimum.",
                witness: "We proved that the equation obeys this law of similarity, and showed that the equation no \
                          longer holds if the torque grows while all times stay the same.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "A stronger spring always shortens the rise. With four times the torque, the rise is half as \
                          long.",
            },
        )
}

fn graphs() -> Vec<Claim> {
    vec![
        lost_curves("meyer.fig-9", "Fig. 9", "rise time and terminal velocity over torque, three pins", "FIGURE 9"),
        at("Figs. 10 and 11, ordinates")
            .statement(
                "meyer.fig-10.rise-axis",
                "RISE TIME TO 99% OF TERMINAL VELOCITY",
                "in the curves, the rise ends at 99 per cent of the terminal velocity",
            )
            .missing(
                "The copy we had does not contain the curves, and the thesis does not say which velocity the 99 per \
                 cent refer to. If they refer to the velocity at each angle, you get one rise time, and if they refer \
                 to the average of peak and minimum, you get another. No definition that we tried reproduces even half \
                 of the rise times of Appendix E, which the figures summarise",
            ),
        lost_curves("meyer.fig-10", "Fig. 10", "rise time and terminal velocity over torque, four pins", "FIGURE 10"),
        study::of_axis(),
        lost_curves("meyer.fig-11", "Fig. 11", "rise time and terminal velocity over torque, six pins", "FIGURE 11"),
    ]
}

fn almost_linear() -> Claim {
    THIRD
        .statement(
            "meyer.almost-linear",
            "An almost linear relationship exists",
            "plotted over the torque, the terminal velocity is nearly a straight line",
        )
        .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            let found = series(rows()).map(|own| {
                let velocity = |row: &Row| f64::midpoint(row.number(Column::Peak), row.number(Column::Minimum));
                let points: Vec<_> = own.iter().map(|row| (row.torque(), velocity(row))).collect();
                misses_of_line(&points, stated)
            });
            straight(found.flatten().collect(), "printed")
        })
        .second_route(QUADRATURE, |stated| {
            let groups = starts().chunk_by(|(a, _), (b, _)| {
                a.mechanism == b.mechanism && a.printed(Column::Friction) == b.printed(Column::Friction)
            });
            let found = groups.map(|own| {
                let torques: Vec<f64> = own.iter().map(|(row, _)| row.torque()).collect();
                let velocities: Vec<f64> = own.iter().map(|(_, start)| start.velocity).collect();
                misses_by_projection(&torques, &velocities, stated)
            });
            straight(found.flatten().collect(), "computed")
        })
        .but_not("the terminal velocity is almost proportional to the driving torque")
        .interpreted_as(
            "“Almost” means that, over the torques of each graph, the best straight line misses each velocity by less \
             than a twentieth. The line need not start at zero. The source does not define the word, so this measure \
             is ours, and any measure from 3 to 16 per cent gives the same verdict.",
        )
}

/// A row's mechanism with as many times its torque and its friction.
pub(super) fn with(row: &Row, torque: f64, friction: f64) -> Option<Engagement> {
    let at = Hypothesis::IDEAL.parameters(row)?;
    let changed =
        Parameters::new(at.mechanism(), at.inertias(), at.torque() * torque, at.friction() * friction).ok()?;
    Engagement::with_tolerance(&changed, 1e-11).ok()
}

/// Relative changes of some quantities in each group of runs, for each set of factors of torque, friction and the two
/// inertias.
pub(super) type Responses<const N: usize> = Vec<Vec<[f64; N]>>;

/// Sets of factors that change torque, friction and the two inertias each alone.
pub(super) fn each_alone(factor: f64) -> [[f64; 4]; 4] {
    std::array::from_fn(|changed| std::array::from_fn(|at| if at == changed { factor } else { 1.0 }))
}

/// The responses to these sets of factors; not numbers where the quantities cannot be found.
pub(super) fn responses<const N: usize>(factors: &[[f64; 4]], of: fn(&Parameters) -> Option<[f64; N]>) -> Responses<N> {
    let before: Vec<_> = series(rows())
        .filter_map(|own| {
            let at = Hypothesis::IDEAL.parameters(own.first()?)?;
            Some((at, of(&at)?))
        })
        .collect();
    let response = |[torque, friction, driver, follower]: &[f64; 4], at: &Parameters, before: &[f64; N]| {
        let inertias = Inertias::new(at.inertias().driver() * driver, at.inertias().follower() * follower).ok()?;
        let changed = Parameters::new(at.mechanism(), inertias, at.torque() * torque, at.friction() * friction).ok()?;
        let after = of(&changed)?;
        Some(std::array::from_fn(|k| (after[k] / before[k] - 1.0).abs()))
    };
    let all = |set: &[f64; 4]| before.iter().map(|(at, old)| response(set, at, old).unwrap_or([f64::NAN; N])).collect();
    factors.iter().map(all).collect()
}

/// Whether κ² times the torque only makes all speeds κ^p times as large, and all times shorter by as much.
fn scaling(power: i32) -> Finding {
    let found = all_proven(&Sign::BOTH.map(|sign| Scaled { power, sign }));
    let times = ["all times unchanged", "all times divided by κ", "all times divided by κ²"];
    let times = usize::try_from(power).ok().and_then(|power| times.get(power)).unwrap_or(&"other times");
    let how = format!(
        "with the torque multiplied by κ² and {times}, both sides of Eq. (1-19) should become κ² times as large. For \
         this condition, {}",
        found.how
    );
    Finding { how, ..found }
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

/// By how much a line may miss a velocity, relative to it.
const ALMOST: f64 = 0.05;

/// Whether the lines of all groups almost meet all velocities, from how far they miss each of them.
fn straight(misses: Vec<f64>, velocities: &str) -> Finding {
    let most = misses.iter().map(|miss| miss.abs()).fold(0.0, f64::max);
    let complete = misses.len() == starts().len() && misses.iter().all(|miss| miss.is_finite());
    Finding::new(
        complete && most < ALMOST,
        format!(
            "the line misses each of {} {velocities} velocities by at most {:.1} per cent",
            misses.len(),
            100.0 * most
        ),
    )
}

/// By how much the best line misses the ordinates, relative to them: any line, or one through the origin.
fn misses_of_line(points: &[(f64, f64)], stated: Stated) -> Vec<f64> {
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
    points.iter().map(|(at, value)| (start + slope * at) / value - 1.0).collect()
}

/// By how much a line misses, by projection.
///
/// It is what is left of the ordinates when their components along the abscissae, and along a constant if the line need
/// not start at zero, are taken off.
fn misses_by_projection(abscissae: &[f64], ordinates: &[f64], stated: Stated) -> Vec<f64> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let without = |of: &[f64], along: &[f64]| -> Vec<f64> {
        let part = dot(of, along) / dot(along, along);
        of.iter().zip(along).map(|(a, b)| a - part * b).collect()
    };
    let constant = vec![1.0; ordinates.len()];
    let [direction, rest] = stated
        .pick([without(abscissae, &constant), without(ordinates, &constant)], [abscissae.to_vec(), ordinates.to_vec()]);
    without(&rest, &direction).iter().zip(ordinates).map(|(left, value)| -left / value).collect()
}

#[cfg(test)]
mod tests {
    use super::runs::study::explained;
    use super::runs::table::listing;
    use super::*;
    use geneva_case1973::{Trend, pairs_by_torque};

    #[test]
    fn no_reading_of_the_axis_nor_of_the_text_gives_most_of_the_rise_times() {
        for tried in explained() {
            let counts = [&tried.as_run, &tried.ideal].map(|of| of.within_one.iter().sum::<usize>());
            assert!(counts.iter().all(|count| 2 * count < rows().len()), "{} {:?}: {counts:?}", tried.name, tried.near);
        }
        // Nor does the time at which 99 per cent of the average terminal velocity are first reached.
        for of in [Hypothesis::IDEAL, Hypothesis::WITHOUT_LAG] {
            let near = rows().iter().filter(|row| {
                let at = of.engagement(row).expect("an escapement");
                let average = at.steady_state().expect("a steady state").mean_of_extremes();
                let lines = at.run(listing().interval / 10.0, listing().duration).expect("a run");
                let reached = lines.iter().find(|line| line.speed >= 0.99 * average).expect("in the run");
                (reached.time - row.number(Column::Rise)).abs() <= 1e-3
            });
            let count = near.count();
            assert!(2 * count < rows().len(), "{count}");
        }
    }

    #[test]
    fn more_torque_never_lengthens_the_rise_under_a_definition_by_the_motion_alone() {
        use geneva_case1973::rise_times::{Target, Whole};
        let by_the_motion = |near: &geneva_case1973::rise_times::RiseTolerance| {
            near.target == Target::Computed && near.whole != Whole::Units
        };
        let mut tried_pairs = 0;
        for tried in explained().iter().filter(|tried| tried.near.as_ref().is_some_and(by_the_motion)) {
            // The time at which a speed is first passed is read off printed lines, which come at times of their own.
            let slack = if tried.name.contains("first comes up") { listing().interval / 2.0 } else { 0.0 };
            let at = |row: &Row| rows().iter().position(|other| other == row).expect("a row");
            for times in [&tried.as_run.times, &tried.ideal.times] {
                for pair in pairs_by_torque(rows()) {
                    let [weak, strong] = pair.map(|row| times[at(row)]);
                    tried_pairs += 1;
                    assert!(strong <= weak + slack, "{} {:?}: {weak} {strong}", tried.name, tried.near);
                }
            }
        }
        assert!(tried_pairs > 1000, "{tried_pairs}");
    }

    #[test]
    fn more_torque_shortens_every_computed_rise_but_not_every_printed_one() {
        let start = |row: &Row| starts().iter().find(|(other, _)| *other == row).expect("a start").1;
        for pair in pairs_by_torque(rows()) {
            let [weak, strong] = pair.map(start);
            let power = libm::log(pair[1].torque() / pair[0].torque()) / 2.0;
            for k in [0, 1] {
                let fall = libm::log(weak.rise_times[k] / strong.rise_times[k]);
                assert!(strong.rise_times[k] < weak.rise_times[k] && (fall / power - 1.0).abs() < 1e-6);
            }
            assert!(strong.velocity > weak.velocity);
            let printed = pair.map(|row| f64::midpoint(row.number(Column::Peak), row.number(Column::Minimum)));
            assert!(printed[1] > printed[0]);
        }
        let printed = Trend::count(Column::Rise, pairs_by_torque(rows()));
        assert_eq!((printed.up, printed.equal, printed.pairs), (2, 2, 37));
    }

    #[test]
    fn a_line_meets_a_line_and_misses_a_parabola() {
        for (stated, start) in [(Stated::right(""), 3.0), (Stated::wrong(""), 0.0)] {
            let points: Vec<(f64, f64)> = (1..6).map(|k| (f64::from(k), start + 2.0 * f64::from(k))).collect();
            let (x, y): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
            for misses in [misses_of_line(&points, stated), misses_by_projection(&x, &y, stated)] {
                assert!(misses.len() == 5 && misses.iter().all(|miss| miss.abs() < 1e-12));
            }
        }
        let bent: Vec<(f64, f64)> = (1..8).map(|k| (f64::from(k), f64::from(k * k))).collect();
        let (x, y): (Vec<f64>, Vec<f64>) = bent.iter().copied().unzip();
        let right = Stated::right("");
        let misses = misses_of_line(&bent, right);
        assert!(misses.iter().zip(misses_by_projection(&x, &y, right)).all(|(a, b)| (a - b).abs() < 1e-12));
        assert!(misses.iter().any(|miss| miss.abs() > 0.1));
    }

    #[test]
    fn any_threshold_between_three_and_sixteen_per_cent_gives_the_same_verdict() {
        fn most(stated: Stated<'_>) -> impl Iterator<Item = f64> {
            series(rows()).map(move |own| {
                let velocity = |row: &Row| f64::midpoint(row.number(Column::Peak), row.number(Column::Minimum));
                let points: Vec<_> = own.iter().map(|row| (row.torque(), velocity(row))).collect();
                misses_of_line(&points, stated).iter().map(|miss| miss.abs()).fold(0.0, f64::max)
            })
        }
        assert!(most(Stated::right("")).all(|miss| miss < 0.03));
        assert!(most(Stated::wrong("")).all(|miss| miss > 0.16));
    }
}
