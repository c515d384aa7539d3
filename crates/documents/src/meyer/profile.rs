//! Fig. 8 and what chapter II says of its curve: its shape, its scales, and when it is steady.

use super::by_steps::{Motion, groups};
use super::general_statements::{Responses, each_alone, responses};
use super::runs::table::rows;
use super::study::steady;
use super::terms::{Start, is_there};
use super::*;
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use geneva_case1973::{Column, Hypothesis, Row, rows_of, series};
use geneva_dynamics::steady::{Engagement, SteadyState};
use geneva_evidence::Stated;
use geneva_evidence::agreement::joined;
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

const BEFORE: Locator = at("Chapter II, sentence around Fig. 8");
const RISE: Locator = at("Chapter II, paragraph on the rise time in Fig. 8");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        at("Fig. 8").figure("meyer.fig-8", "FIGURE 8", "speeds of driver and follower over time, four pins").missing(
            "The copy we had does not contain the curves, and the thesis does not name the run that they show",
        ),
        shape(),
        scales(),
        RISE.value("meyer.fig-8.rise", "0.025", "seconds", "rise time of the run that is drawn").missing(
            "The text does not name the run, and it need not be one of the runs in the tables. In the four-pin runs of \
             the tables the velocity takes 29 ms or more to become steady, whether we go by the velocity at each angle \
             or by the average of peak and minimum. No row has the 25 ms that the text gives. In two of these runs the \
             time of the first minimum rounds to 25 ms, but their rise times are longer than that by half or more",
        ),
        first_minimum(),
    ]
}

fn shape() -> Claim {
    BEFORE
        .statement(
            "meyer.shape",
            "will not change the shape of the curve",
            "no parameter changes the shape of the speed curve",
        )
        .first_route(QUADRATURE, |stated| {
            shaped(stated, quantities(), |row| {
                let lines = Hypothesis::IDEAL.engagement(row)?.steady_cycle(INSTANTS).ok()?;
                Some(lines.iter().map(|line| line.speed).collect())
            })
        })
        .second_route(RUNGE_KUTTA, |stated| {
            shaped(stated, quantities_in_steps(), |row| {
                let group = groups().iter().find(|group| group.rows.contains(row))?;
                let scale = group.scale(row);
                Some(group.motion.values(group.motion.steady()?, |_, speed| speed * scale))
            })
        })
        .interpreted_as(
            "We ask of the printed sentence only the least that “shape” can mean: with each mechanism, the curve must \
             go up and down equally often in all runs. Changes of less than 1 rad/s, the unit of the tables, do not \
             count. In the correction, “shape” means how low the minimum is and how high the speed at entry is, both \
             relative to the peak.",
        )
        .corrected(
            "will, with the exception of the driving torque, change the shape of the curve",
            Slip {
                id: "",
                reason: "The torque changes the scales of the curve and nothing else. Friction and the ratio of the \
                         inertias, however, change the curve's shape: the minimum and the speed at entry, both \
                         relative to the peak. They even change how often the curve goes up and down in an engagement. With six pins the speed dips \
                         shortly before the hand-over and rises again until just after it. With little friction this \
                         second rise is too small to show in the whole numbers of the tables, but with more friction \
                         it shows. Even in the tables, the curves are not scaled copies of each other: with four pins, \
                         one run has a minimum of 25 and a peak of 206, and another has the same minimum but a peak of \
                         163.",
                witness: "We computed the motions in small steps of the driver's angle.",
                origin: Origin::Concept,
                consequence: Consequence::Remark,
                changes: "Two speed curves of a mechanism are scaled copies of each other only with the same friction and the \
                          same ratio of the inertias.",
            },
        )
}

fn scales() -> Claim {
    BEFORE
        .statement(
            "meyer.scales",
            "the magnitude of the velocity, the period of the oscillations, and the rise time",
            "parameters change the terminal velocity, the period and the rise time",
        )
        .first_route(QUADRATURE, |stated| changed(stated, quantities()))
        .second_route(RUNGE_KUTTA, |stated| changed(stated, quantities_in_steps()))
        .but_not("changing torque and both inertias in the same proportion will change them")
        .interpreted_as(
            "In all runs, each of the three changes by a thousandth or more if we change a suitable one of torque, \
             friction and the two inertias, and nothing else, by a tenth, whether up or down. Changes of this size \
             count for the shape too. The torque changes all three, and velocity and period change with each of the \
             four. The rise time does not always change: in some runs, a tenth more or a tenth less of the friction or \
             of the driver's inertia changes it by less than a thousandth.",
        )
}

fn first_minimum() -> Claim {
    RISE.statement(
        "meyer.first-minimum",
        "by the first minimum in velocity, the driver has achieved its steady state",
        "by the first minimum of its speed, the driver has reached its steady motion",
    )
    .first_route(QUADRATURE, |stated| {
        let first = |(row, state): &(&Row, SteadyState)| {
            let first = Hypothesis::IDEAL.engagement(row)?.first_minimum().ok()??;
            Some([first.speed, state.minimum.speed])
        };
        achieved(stated, &steady().iter().filter_map(first).collect::<Vec<_>>())
    })
    .second_route(RUNGE_KUTTA, |stated| {
        let first = |row: &Row| {
            let group = groups().iter().find(|group| group.rows.contains(row))?;
            let least = |of| Some(group.motion.least(of)?.value * group.scale(row));
            Some([least(group.motion.engagements.first()?)?, least(group.motion.steady()?)?])
        };
        achieved(stated, &rows().iter().filter_map(first).collect::<Vec<_>>())
    })
    .interpreted_as(
        "We test the sentence against all runs, because the sentence before it in the thesis speaks of all runs. We ask \
         for no more than that the first minimum is within 1 rad/s (the unit of the tables) of the minimum of the steady \
         motion. If we asked for one per cent, as for the rise time, no run would pass. If the sentence were meant only \
         for the run of Fig. 8, it would be open, because the thesis does not name this run. Of the 17 four-pin runs, 12 \
         have a first minimum within 1 rad/s of the steady one, and in 4 of these the velocity at each angle stays \
         within 1 rad/s of the steady velocity from then on.",
    )
    .corrected(
        "at the first minimum in velocity, the driver is still 1.8 to 28 per cent slower than at the minimum of its \
         steady state",
        Slip {
            id: "",
            reason: "The first minimum belongs to an engagement that begins at rest. In every run this minimum is \
                     lower than the minimum of the steady state, and the less friction there is, the lower it is. In \
                     15 of the 49 runs, 12 of them with four pins, the difference is 1 rad/s or less, so the tables, \
                     whose speeds have no decimals, hardly show it there.",
            witness: "We computed the motions in small steps of the driver's angle.",
            origin: Origin::Concept,
            consequence: Consequence::Remark,
            changes: "The time of the first minimum is no measure of the rise time, although the text takes a rise \
                      time from it. We leave the claim about that rise time open, because the text does not name the \
                      run.",
        },
    )
}

/// Whether the first minima of all runs are the steady ones, to within a unit of the tables, or lack as much of them as is
/// stated; from the first and the steady minimum of each, in rad/s.
fn achieved(stated: Stated, minima: &[[f64; 2]]) -> Finding {
    let count = rows().len();
    let [least, most] = range(minima.iter().map(|[first, steady]| 100.0 * (1.0 - first / steady)));
    let near = minima.iter().filter(|[first, steady]| is_there(steady - first)).count();
    Finding::new(
        minima.len() == count && stated.pick(stated.is_rounding_of(&[least, most]), near == count),
        format!(
            "in {near} of {count} runs the first minimum is within 1 rad/s of the steady minimum; the first minimum is \
             {least:.1} to {most:.1} per cent lower than the steady one"
        ),
    )
}

/// Instants of a cycle among which its turning points are looked for.
const INSTANTS: usize = 2000;

/// Least part by which a change of a tenth must change a number for the shape to change, or a scale.
const VISIBLE: f64 = 1e-3;

/// Whether the curves of all runs of each mechanism turn round equally often in a steady engagement; or whether the torque
/// alone leaves the shape as it is.
fn shaped(stated: Stated, found: &Responses<QUANTITIES>, speeds: impl Fn(&Row) -> Option<Vec<f64>>) -> Finding {
    if stated.pick(true, false) {
        // The shape's numbers come last; of these the one that changes more.
        let shape = |own: &[f64; QUANTITIES]| own[SCALES..].iter().copied().fold(0.0, f64::max);
        let changes = |which: usize| {
            let both = [&found[which], &found[which + PARAMETERS]];
            both.into_iter().flatten().map(shape).collect::<Vec<f64>>()
        };
        let (torque, others) = (changes(0), (1..PARAMETERS).flat_map(changes).collect::<Vec<f64>>());
        let [most, least] = [range(torque.iter().copied())[1], range(others.iter().copied())[0]];
        let groups = series(rows()).count();
        let complete = torque.len() == 2 * groups && others.len() == 2 * groups * (PARAMETERS - 1);
        return Finding::new(
            complete && most <= crate::evidence::STEPS_TOLERANCE.relative && least >= VISIBLE,
            format!(
                "relative to the peak, neither the minimum nor the speed at entry changes if the torque changes by a \
                 tenth, up or down. But if any other parameter changes by a tenth, up or down, one of the two changes \
                 by {:.2} per cent or more, with every mechanism at every friction value",
                100.0 * least
            ),
        );
    }
    let counts = Mechanism::ALL
        .map(|mechanism| rows_of(rows(), mechanism).iter().filter_map(|row| swings(&speeds(row)?)).collect::<Vec<_>>());
    let same = |own: &Vec<usize>| own.first().is_some_and(|first| own.iter().all(|count| count == first));
    let times = |own: &Vec<usize>| match [own.iter().min(), own.iter().max()].map(|end| end.copied().unwrap_or(0)) {
        [least, most] if least == most => least.to_string(),
        [least, most] => format!("{least} to {most}"),
    };
    let each: Vec<String> = Mechanism::ALL
        .iter()
        .zip(&counts)
        .map(|(at, own)| format!("{} times in the runs with {} pins", times(own), at.pins()))
        .collect();
    Finding::new(
        counts.iter().all(same),
        format!("in a cycle, the driver's speed turns from rising to falling or back {}", joined(&each)),
    )
}

/// How often a cycle of speeds turns round by a unit of the tables or more.
fn swings(speeds: &[f64]) -> Option<usize> {
    let unit = Column::Peak.unit();
    let highest = speeds.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?.0;
    // From the highest down: it turns where it has come back by a unit.
    let (mut turns, mut falling, mut last) = (1, true, speeds[highest]);
    for speed in speeds.iter().cycle().skip(highest).take(speeds.len() + 1) {
        if (*speed < last) == falling {
            last = *speed;
        } else if (speed - last).abs() >= unit {
            (turns, falling, last) = (turns + 1, !falling, *speed);
        }
    }
    Some(turns)
}

/// Factors of torque, friction and the two inertias: each alone a tenth greater, each alone a tenth less, and all but the
/// friction together.
fn tenths() -> Vec<[f64; 4]> {
    [&each_alone(1.1)[..], &each_alone(0.9), &[[1.1, 1.0, 1.1, 1.1]]].concat()
}

/// Parameters that are changed alone.
const PARAMETERS: usize = 4;

/// The average terminal velocity, the period and the rise time by both readings, which are scales; minimum and speed at
/// entry over the peak, which are the shape.
const QUANTITIES: usize = 6;

/// How many of them are scales.
const SCALES: usize = 4;

fn quantities() -> &'static Responses<QUANTITIES> {
    static FOUND: OnceLock<Responses<QUANTITIES>> = OnceLock::new();
    FOUND.get_or_init(|| {
        responses(&tenths(), |parameters| {
            let of = Engagement::with_tolerance(parameters, 1e-11).ok()?;
            let (start, steady) = (Start::by_integrals(&of)?, of.steady_state().ok()?);
            let shape = [steady.minimum.speed, steady.entry_speed].map(|speed| speed / steady.peak.speed);
            let [profile, average] = start.rise_times;
            Some([start.velocity, steady.period, profile, average, shape[0], shape[1]])
        })
    })
}

fn quantities_in_steps() -> &'static Responses<QUANTITIES> {
    static FOUND: OnceLock<Responses<QUANTITIES>> = OnceLock::new();
    FOUND.get_or_init(|| {
        responses(&tenths(), |parameters| {
            let motion = Motion::repeating(parameters)?;
            let (start, steady) = (Start::by_steps(&motion)?, motion.steady()?);
            let peak = motion.greatest(steady, |_, speed| speed).value;
            let shape = [motion.least(steady)?.value, steady.ends()[0]].map(|speed| speed / peak);
            let [profile, average] = start.rise_times;
            Some([start.velocity, steady.duration(), profile, average, shape[0], shape[1]])
        })
    })
}

/// By parameter and group the lesser of the two changes, up and down, of each quantity.
fn alone(found: &Responses<QUANTITIES>) -> [Vec<[f64; QUANTITIES]>; PARAMETERS] {
    let either = |which: usize| {
        let (more, less) = (&found[which], &found[which + PARAMETERS]);
        more.iter().zip(less).map(|(a, b)| std::array::from_fn(|k| if a[k] < b[k] { a[k] } else { b[k] })).collect()
    };
    std::array::from_fn(either)
}

/// Whether all scales change visibly in every group of runs: with some parameter alone, or with torque and inertias
/// together.
fn changed(stated: Stated, found: &Responses<QUANTITIES>) -> Finding {
    let alone = alone(found);
    let most = |group: usize| -> [f64; QUANTITIES] {
        std::array::from_fn(|k| alone.iter().filter_map(|own| Some(own.get(group)?[k])).fold(0.0, f64::max))
    };
    let together = found.last().cloned().unwrap_or_default();
    let groups = stated.pick((0..series(rows()).count()).map(most).collect(), together);
    let changes: Vec<f64> = groups.iter().flat_map(|own| own[..SCALES].to_vec()).collect();
    let [least, least_alone] = [changes, alone.concat().iter().flat_map(|own| own[..SCALES].to_vec()).collect()]
        .map(|changes| 100.0 * changes.into_iter().fold(f64::INFINITY, f64::min));
    Finding::new(
        groups.len() == series(rows()).count() && least >= 100.0 * VISIBLE,
        format!(
            "with every mechanism at every friction value, each of the three changes by {least:.1} per cent or more \
             if the parameter with the greatest effect on it changes by a tenth, up or down, and by {least_alone:.3} \
             per cent or more if any other parameter does"
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::super::terms::starts;
    use super::*;

    #[test]
    fn no_four_pin_run_of_the_tables_has_the_rise_time_of_fig_8_by_either_reading_nor_in_print() {
        let four = || rows_of(rows(), Mechanism::FOUR_PIN);
        let times = |row: &Row| starts().iter().find(|(other, _)| *other == row).expect("a start").1.rise_times;
        assert!(four().iter().flat_map(times).all(|time| time > 0.029));
        assert!(four().iter().all(|row| row.number(Column::Rise) != MEYER.printed_number("meyer.fig-8.rise")));
        let candidates = four().iter().filter(|row| {
            let engagement = Hypothesis::IDEAL.engagement(row).expect("an escapement");
            let first = engagement.first_minimum().expect("a start").expect("a minimum");
            (first.time - MEYER.printed_number("meyer.fig-8.rise")).abs() <= 0.0005
        });
        let longer: Vec<f64> =
            candidates.flat_map(times).map(|time| time / MEYER.printed_number("meyer.fig-8.rise")).collect();
        assert!(longer.len() == 4 && longer.iter().all(|part| *part > 1.5), "{longer:?}");
    }

    #[test]
    fn the_first_minimum_is_the_steady_one_in_as_many_runs_as_reading_and_reason_say() {
        // Whether the minimum alone is as near as this, and whether the velocity at each angle is so from then on.
        let near = |row: &Row, is_near: fn(f64, f64) -> bool| {
            let group = groups().iter().find(|group| group.rows.contains(row)).expect("a group");
            let (motion, scale) = (&group.motion, group.scale(row));
            let speeds = |of| motion.values(of, |_, speed| speed * scale);
            let (first, steady) = (&motion.engagements[0], motion.steady().expect("a steady motion"));
            let [minimum, other] = [first, steady].map(|of| motion.least(of).expect("a minimum").value * scale);
            let from = motion.angles.iter().position(|angle| *angle >= motion.least(first).expect("a minimum").angle);
            let skipped = from.expect("an angle");
            let agrees = |of, skipped| {
                speeds(of).into_iter().zip(speeds(steady)).skip(skipped).all(|(speed, steady)| is_near(speed, steady))
            };
            let later = motion.engagements.iter().skip(1).all(|of| agrees(of, 0));
            [is_near(minimum, other), agrees(first, skipped) && later]
        };
        let count = |rows: &[Row], is_near: fn(f64, f64) -> bool| {
            [0, 1].map(|which| rows.iter().filter(|row| near(row, is_near)[which]).count())
        };
        let (unit, per_cent) =
            (|a: f64, b: f64| is_there(a - b), |a: f64, b: f64| (a / b - 1.0).abs() <= terms::MISSING);
        assert_eq!(count(rows_of(rows(), Mechanism::FOUR_PIN), unit), [12, 4]);
        assert_eq!(count(rows(), unit)[0], 15);
        assert_eq!(count(rows(), per_cent), [0, 0]);
    }

    #[test]
    fn two_printed_curves_have_one_minimum_and_peaks_that_no_rounding_makes_alike() {
        let deep = |row: &&Row| row.number(Column::Minimum) == 25.0;
        let over = |row: &Row, off: f64| (25.0 + off) / (row.number(Column::Peak) - off);
        let found: Vec<&Row> = rows_of(rows(), Mechanism::FOUR_PIN).iter().filter(deep).collect();
        let [one, other] = found[..] else { panic!("two rows") };
        assert_eq!([one, other].map(|row| row.printed(Column::Peak)), ["206", "163"]);
        assert!(over(one, 0.5) < over(other, -0.5));
    }

    #[test]
    fn each_parameter_changes_velocity_and_period_visibly_but_not_each_the_rise_time() {
        for found in [quantities(), quantities_in_steps()] {
            let alone = alone(found);
            let [torque, ..] = &alone;
            assert!(torque.iter().all(|own| own[..SCALES].iter().all(|change| *change >= VISIBLE)));
            assert!(alone.iter().flatten().all(|own| own[..2].iter().all(|change| *change >= VISIBLE)));
            let unseen = |k: usize| alone.iter().flatten().filter(|own| own[k] < VISIBLE).count();
            assert_eq!([unseen(2), unseen(3)], [2, 5]);
            // These are changes of the friction and of the driver's inertia.
            for of in [&alone[0], &alone[3]] {
                assert!(of.iter().all(|own| own[2] >= VISIBLE && own[3] >= VISIBLE));
            }
        }
    }
}
