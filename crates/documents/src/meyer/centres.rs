//! Chapter II's paragraph on the curves of Fig. 8, what it says of the line of centres: the driver slowest and the follower
//! fastest there.

use super::by_steps::{Group, groups};
use super::peaks::{Cycle, PEAKS, all_of, cycles, falls};
use super::runs::table::rows;
use super::terms::is_there;
use super::*;
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use geneva_case1973::Row;
use geneva_dynamics::steady::PrintedLine;

/// The extremes between two peaks are put on the line of centres.
const EXTREMES_ON_CENTRES: Slip = Slip {
    id: "meyer.extremes-on-centres",
    reason: "On the line of centres the pin does not slide, so no friction opposes the spring. By Eq. (1-19), A θ'' = \
             E there, with positive A and E, so the driver's acceleration θ'' is positive. The driver is therefore \
             slowest before this line. On the line the ratio of the follower's speed to the driver's has its maximum \
             and is not changing, so the follower's acceleration φ'' is this ratio times θ'', which is positive, too. \
             The follower is fastest past the line, where the pin goes over to the trailing flank of its slot. In the \
             runs with six and four pins the driver's minimum is so flat that the driver's speed on the line of \
             centres exceeds the minimum by less than 1 rad/s, the unit of the tables. In some runs with three pins, \
             the driver's speed on the line exceeds the minimum by more than this unit. In all runs, the follower's \
             speed on the line is below its maximum by more than this unit.",
    witness: "For every mechanism at every friction value, we computed the motion in small steps of the driver's \
              angle.",
    origin: Origin::Concept,
    consequence: Consequence::Remark,
    changes: "The driver begins to speed up before the line of centres, and past the line the follower is still \
              speeding up.",
};

pub(super) fn claims() -> Vec<Claim> {
    vec![
        PEAKS
            .statement(
                "meyer.extremes-on-centres",
                "the driver velocity is a minimum and the follower velocity is a maximum",
                "on the line of centres the driver is slowest and the follower fastest",
            )
            .first_route(QUADRATURE, |stated| {
                extremes(stated, cycles().iter().filter_map(Middle::of).collect(), rows().len())
            })
            .second_route(RUNGE_KUTTA, |stated| {
                let middle = |group: &Group, row: &Row| {
                    let (motion, steady) = (&group.motion, group.motion.steady()?);
                    let (least, most) = (motion.least(steady)?, motion.greatest(steady, motion.follower()));
                    let on_line = motion.angles.iter().position(|angle| vanishes(*angle))?;
                    let driver = motion.values(steady, |_, speed| speed)[on_line] - least.value;
                    let follower = most.value - motion.values(steady, motion.follower())[on_line];
                    let missed = [driver, follower].map(|missed| missed * group.scale(row));
                    Some(Middle { before: -least.angle, after: most.angle, missed })
                };
                let all = groups().iter().flat_map(|group| group.rows.iter().filter_map(move |row| middle(group, row)));
                extremes(stated, all.collect(), rows().len())
            })
            .interpreted_as(
                "We test the sentence against the steady motion of every run. An extreme counts as being on the line \
                 of centres if the speed on the line is within 1 rad/s (the unit of the tables) of the extreme speed.",
            )
            .corrected(
                "the driver velocity is a minimum 0.48 to 5.8° before the line, and on the line it is up to 2.1 rad/s \
                 greater; the follower velocity is a maximum 9.3 to 25° past the line, and on the line it is 4.9 to 15 \
                 rad/s less",
                EXTREMES_ON_CENTRES,
            ),
        PEAKS
            .statement(
                "meyer.follower-decreases",
                "(and the follower velocity decreases)",
                "the follower's speed falls from the line of centres onwards",
            )
            .first_route(QUADRATURE, |stated| {
                let found = cycles().iter().filter_map(|Cycle { state, lines }| {
                    let change = state.reversal_angle?;
                    let own = lines.iter().filter(|line| line.angle >= stated.pick(change, 0.0));
                    Some(falls(&own.map(|line| line.follower_speed).collect::<Vec<_>>()))
                });
                all_of(found.collect(), rows().len(), "runs, to within one unit of the tables")
            })
            .second_route(RUNGE_KUTTA, |stated| {
                let found = groups().iter().filter_map(|group| {
                    let (motion, steady) = (&group.motion, group.motion.steady()?);
                    let speeds = motion.values(steady, motion.follower());
                    let fastest = motion.greatest(steady, motion.follower()).angle;
                    let from = stated.pick(fastest, 0.0);
                    let at = motion.angles.iter().position(|angle| *angle >= from)?;
                    Some(speeds[at..].windows(2).all(|pair| pair[1] < pair[0]))
                });
                all_of(found.collect(), groups().len(), "groups of runs, from step to step")
            })
            .interpreted_as(
                "We ask whether the follower's speed falls from the line of centres to the exit, to within 1 rad/s, \
                 the unit of the tables.",
            )
            .corrected(
                "(and the follower velocity increases until the pin goes over to the trailing flank of the slot, and \
                 then decreases)",
                EXTREMES_ON_CENTRES,
            ),
    ]
}

/// The extremes about the line of centres: how far before and past it in radians, and by how much the driver's and the
/// follower's speed differ from them on it, in rad/s.
struct Middle {
    before: f64,
    after: f64,
    missed: [f64; 2],
}

impl Middle {
    /// The extremes of a row's steady motion, by the solution over the angle.
    fn of(cycle: &Cycle) -> Option<Self> {
        let pair = cycle.lines.windows(2).find(|pair| pair[0].angle <= 0.0 && pair[1].angle > 0.0)?;
        let share = pair[0].angle / (pair[0].angle - pair[1].angle);
        let at = |of: fn(&PrintedLine) -> f64| of(&pair[0]) + share * (of(&pair[1]) - of(&pair[0]));
        let [driver, follower] = [at(|line| line.speed), at(|line| line.follower_speed)];
        let most = cycle.lines.iter().map(|line| line.follower_speed).fold(0.0, f64::max);
        Some(Self {
            before: -cycle.state.minimum.angle,
            after: cycle.state.reversal_angle?,
            missed: [driver - cycle.state.minimum.speed, most - follower],
        })
    }
}

/// Whether the extremes are on the line of centres; or as far from it as is stated, the driver's before it, the follower's
/// past it.
fn extremes(stated: Stated, found: Vec<Middle>, count: usize) -> Finding {
    let [before, after] = [|of: &Middle| of.before, |of: &Middle| of.after]
        .map(|of| range(found.iter().map(|middle| of(middle).to_degrees())));
    let [driver, follower] = [0, 1].map(|which| range(found.iter().map(|middle| middle.missed[which])));
    let said = [&before[..], &driver[1..], &after[..], &follower[..]].concat();
    let there = |which: usize| found.iter().filter(|middle| is_there(middle.missed[which])).count();
    let holds = stated.pick(stated.is_rounding_of(&said), there(0) == count && there(1) == count);
    Finding::new(
        holds && found.len() == count,
        format!(
            "the driver is slowest {:.2} to {:.2}° before the line of centres, and on the line the driver's speed is \
             within 1 rad/s of this minimum in {} of {count} runs. The follower is fastest {:.1} to {:.1}° past the \
             line, and on the line the follower's speed is within 1 rad/s of this maximum in {} of {count} runs",
            before[0],
            before[1],
            there(0),
            after[0],
            after[1],
            there(1)
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::super::study::steady;
    use super::*;

    #[test]
    fn the_minimum_is_on_the_line_to_one_unit_with_six_and_four_pins_and_the_follower_s_maximum_never() {
        for (cycle, (row, _)) in cycles().iter().zip(steady()) {
            let [driver, follower] = Middle::of(cycle).expect("a line of centres").missed;
            assert!(is_there(driver) || row.mechanism == Mechanism::THREE_PIN, "{}: {driver}", row.slug());
            assert!(!is_there(follower), "{}: {follower}", row.slug());
        }
    }
}
