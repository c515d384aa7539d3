//! The general statement on friction: what less friction does to the rise, and what none does.

use super::by_steps::Motion;
use super::general_statements::with;
use super::runs::table::rows;
use super::*;
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use geneva_case1973::series;

const SECOND: Locator = at("Chapter II, 2nd general statement");

pub(super) fn claims() -> Vec<Claim> {
    vec![less_friction(), no_friction()]
}

fn less_friction() -> Claim {
    SECOND
        .statement(
            "meyer.less-friction",
            "The more frictionless the system, the greater is the rise time",
            "less friction makes the rise longer",
        )
        .missing(
            "The thesis leaves open what counts as steady, and different readings give different answers. To compare \
             them, we raised the friction in small steps, from the lowest value in the runs to the highest. That makes \
             45 steps for the three mechanisms together. First, suppose that the rise ends when the velocity at each \
             angle is steady to one per cent. Then the rise becomes longer in 7 of the steps. Six of these follow each \
             other, with four pins from .25 to .31, and together they make the rise longer by 0.26 ms at a torque of .08. \
             From the row with .25 to the row with .30 it is 0.24 ms, while the tables give only whole milliseconds. \
             With two per cent instead of one, it becomes longer in none of the steps. If we assume that each engagement reduces the difference from the \
             steady speed by the same factor, each of the friction values in the runs gives a shorter rise than the \
             next lower value. Now suppose that the rise ends with the first engagement in which the average of peak \
             and minimum is within one per cent of the steady average. Then the rise becomes longer in nearly every \
             step, because each engagement takes longer. But where the rise needs one engagement fewer than before the \
             step, it becomes shorter. In Appendix E, the row with more friction has the longer rise time in 8 of 34 \
             pairs of neighbouring rows. But from the least friction to the greatest, at the same torque, the printed \
             rise time falls in all 10 cases",
        )
}

fn no_friction() -> Claim {
    SECOND
        .statement(
            "meyer.no-friction",
            "will never reach a terminal velocity",
            "without friction there is no terminal velocity",
        )
        .first_route(QUADRATURE, |stated| {
            // Speeds that go as the root of the number of engagements know no bound.
            let quotients: Vec<f64> = series(rows())
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
                quotients.len() == series(rows()).count()
                    && quotients.iter().all(|quotient| (quotient - 2.0).abs() < 1e-9),
                format!(
                    "with six pins, after four hundred engagements, the speed is {:.6} times the speed after one \
                     hundred",
                    quotients.first().copied().unwrap_or(f64::NAN)
                ),
            )
        })
        .second_route(RUNGE_KUTTA, |stated| {
            // Each engagement adds the whole work of the spring to the driver's energy.
            let parts: Vec<f64> = series(rows())
                .filter_map(|own| {
                    let of = with(own.first()?, 1.0, stated.pick(0.0, 0.01))?;
                    let (at, motion) = (of.parameters(), Motion::from_rest(of.parameters(), 12));
                    let energy = at.inertias().driver() * motion.engagements.last()?.end() / 2.0;
                    let work = at.torque() * 2.0 * at.mechanism().engagement_half_angle();
                    Some(energy / (12.0 * work))
                })
                .collect();
            Finding::new(
                parts.len() == series(rows()).count() && parts.iter().all(|part| (part - 1.0).abs() < 1e-6),
                format!(
                    "with six pins, after twelve engagements, the driver's energy is {:.6} of the spring's work",
                    parts.first().copied().unwrap_or(f64::NAN)
                ),
            )
        })
        .but_not("there is none with a hundredth of the friction of the runs either")
}

#[cfg(test)]
mod tests {
    use super::super::by_steps::{Group, groups};
    use super::super::terms::{MISSING, Start};
    use super::*;
    use geneva_case1973::{Column, Hypothesis, Row, Trend, pairs_by_friction};
    use geneva_dynamics::Parameters;
    use geneva_dynamics::steady::Engagement;

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

    /// Frictions between the least and the greatest of the runs, both included.
    const GRID: u32 = 16;

    /// Frictions of the runs.
    const FRICTIONS: usize = 4;

    /// The rise times of each mechanism, by rising friction, by one of the two readings.
    type Times = [Vec<f64>; 3];

    /// The rise times by both readings with each friction of the grid, for one torque, to some part of the terminal
    /// velocity.
    fn by_friction(missing: f64) -> [Times; 2] {
        let [low, high] = [f64::min, f64::max].map(|of| rows().iter().map(Row::friction).reduce(of).expect("a row"));
        let friction = |k: u32| low + (high - low) * f64::from(k) / f64::from(GRID - 1);
        let both = Mechanism::ALL.map(|mechanism| {
            let own = rows().iter().find(|row| row.mechanism == mechanism).expect("a row");
            let at = Hypothesis::IDEAL.parameters(own).expect("an escapement");
            let start = |k: u32| {
                let with =
                    Parameters::new(at.mechanism(), at.inertias(), at.torque(), friction(k)).expect("a friction");
                let of = Engagement::with_tolerance(&with, 1e-11).expect("an escapement");
                Start::by_integrals_to(&of, missing).expect("a start").rise_times
            };
            (0..GRID).map(start).collect::<Vec<_>>()
        });
        [0, 1].map(|reading| both.each_ref().map(|own| own.iter().map(|times| times[reading]).collect()))
    }

    /// The rise times by steps of the angle, with the frictions of the runs.
    ///
    /// Times are in units of √(I_f/K), because groups of runs differ in their torques.
    fn by_friction_in_steps() -> [Times; 2] {
        let own = |mechanism: Mechanism| groups().iter().filter(move |group| group.rows[0].mechanism == mechanism);
        let times = |group: &Group| {
            let unit = group.motion.parameters.drive().sqrt();
            Start::by_steps(&group.motion).expect("a start").rise_times.map(|time| time * unit)
        };
        [0, 1].map(|reading| Mechanism::ALL.map(|of| own(of).map(|group| times(group)[reading]).collect()))
    }

    /// By how much the time is longer in each step that makes it so, by mechanism.
    fn lengthened(times: &Times) -> [Vec<f64>; 3] {
        times.each_ref().map(|own| {
            let longer = own.windows(2).filter(|pair| pair[1] > pair[0]);
            longer.map(|pair| pair[1] - pair[0]).collect()
        })
    }

    fn counts(of: &[Vec<f64>; 3]) -> [usize; 3] {
        of.each_ref().map(Vec::len)
    }

    #[test]
    fn the_velocity_at_each_angle_is_reached_later_with_more_friction_by_less_than_the_tables_can_tell_or_never() {
        for (missing, expected) in [(0.005, [2, 8, 0]), (MISSING, [1, 6, 0]), (0.02, [0; 3]), (0.05, [0; 3])] {
            let longer = lengthened(&by_friction(missing)[0]);
            assert_eq!(counts(&longer), expected, "{missing}");
            // In all steps of a mechanism together by less than a unit of the tables.
            assert!(longer.iter().all(|own| own.iter().sum::<f64>() < Column::Rise.unit()), "{missing}: {longer:?}");
            assert!(missing < MISSING || longer.iter().flatten().all(|more| *more < 1e-4), "{longer:?}");
        }
        // What reading and chapter say of the steps that follow each other.
        let four = &by_friction(MISSING)[0][1];
        let longest = four.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<_>>();
        assert!(longest.iter().map(|more| *more > 0.0).eq((0..15).map(|step| (5..11).contains(&step))), "{longest:?}");
        let (total, rows) = (1e3 * (four[11] - four[5]), 1e3 * (four[10] - four[5]));
        assert_eq!([total, rows].map(|more| format!("{more:.2}")), ["0.26", "0.24"]);
        let steps = by_friction_in_steps();
        assert_eq!(counts(&lengthened(&steps[0])), [0, 1, 0]);
        assert!(steps.iter().flatten().all(|own| own.len() == FRICTIONS));
    }

    #[test]
    fn counted_in_whole_engagements_the_rise_is_longer_with_nearly_every_step_and_drops_by_an_engagement() {
        for (missing, expected) in
            [(0.005, [14, 15, 13]), (MISSING, [14; 3]), (0.02, [15, 14, 14]), (0.05, [14, 15, 15])]
        {
            assert_eq!(counts(&lengthened(&by_friction(missing)[1])), expected, "{missing}");
        }
        // Between the frictions of the runs it goes either way.
        let in_steps: usize = counts(&lengthened(&by_friction_in_steps()[1])).iter().sum();
        assert!((1..3 * (FRICTIONS - 1)).contains(&in_steps), "{in_steps}");
        // Even from the least friction to the greatest it depends on the part of the velocity.
        let falls =
            [0.005, MISSING, 0.02].map(|missing| by_friction(missing)[1].iter().all(|own| own[0] > own[own.len() - 1]));
        assert_eq!(falls, [false, true, false]);
    }

    #[test]
    fn the_printed_rise_times_go_up_in_eight_pairs_and_fall_from_the_least_friction_to_the_greatest() {
        let printed = Trend::count(Column::Rise, pairs_by_friction(rows()));
        assert_eq!((printed.up, printed.pairs), (8, 34));
        let [least, greatest] =
            [f64::min, f64::max].map(|of| rows().iter().map(Row::friction).reduce(of).expect("a row"));
        let mut falls = Vec::new();
        for low in rows().iter().filter(|row| row.friction() == least) {
            let same = |row: &&Row| row.mechanism == low.mechanism && row.torque() == low.torque();
            let high = rows().iter().filter(same).find(|row| row.friction() == greatest);
            falls.extend(high.map(|high| high.number(Column::Rise) < low.number(Column::Rise)));
        }
        assert_eq!(falls, [true; 10]);
    }

    /// Whether numbers fall from each to the next.
    fn always_falls(numbers: &[f64]) -> bool {
        numbers.len() > 1 && numbers.is_sorted_by(|a, b| a > b)
    }
}
