//! The recommendations of the thesis.

use super::by_steps::groups;
use super::general_statements::with;
use super::runs::table::{listing, rows};
use super::slips::SAMPLED_PEAKS;
use super::terms::Start;
use super::*;
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use geneva_case1973::program::Program1973;
use geneva_case1973::{Column, Hypothesis, Listing, Row, series};

pub(super) fn claims() -> Vec<Claim> {
    vec![not_fast_enough(), spring_rates(), cyclic_oscillations(), front::page_of_definition()]
}

fn not_fast_enough() -> Claim {
    at("Recommendation 1")
        .statement("meyer.not-fast-enough", "not fast enough", "the rise times are too long for a millisecond timer")
        .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            let least = rows().iter().map(|row| row.number(Column::Rise)).fold(f64::INFINITY, f64::min);
            Finding::new(
                least >= stated.pick(TEN, THIRTY),
                format!("the shortest rise time of Appendix E is {least} s"),
            )
        })
        .second_route(RUNGE_KUTTA, |stated| {
            let times = groups().iter().filter_map(|group| {
                let start = Start::by_steps(&group.motion)?;
                Some(start.rise_times.map(|time| time / group.greatest_scale()))
            });
            let times: Vec<f64> = times.flatten().collect();
            let least = times.iter().copied().fold(f64::INFINITY, f64::min);
            Finding::new(
                times.len() == 2 * groups().len() && least >= stated.pick(TEN, THIRTY),
                format!("the shortest rise time is {least:.4} s"),
            )
        })
        .but_not("they are too long for a timer of three hundredths of a second")
        .interpreted_as(
            "A millisecond timer measures less than ten milliseconds, so a longer rise is not fast enough for it.",
        )
}

/// Ten and thirty milliseconds, in s.
const TEN: f64 = 0.01;
const THIRTY: f64 = 0.03;

fn spring_rates() -> Claim {
    spring::no_rate(
        "meyer.recommendation.spring-rates",
        at("Recommendation 2"),
        "the strength of the spring is called a rate, which would be a torque for each radian of winding",
        "spring rates",
        "torques of the spring",
    )
}

fn cyclic_oscillations() -> Claim {
    at("Recommendation 2")
        .statement(
            "meyer.cyclic-oscillations",
            "significant cyclic oscillations in the magnitude of the peak velocity",
            "a strong spring makes the peak of the driver's speed swing from cycle to cycle",
        )
        .first_route(QUADRATURE, |stated| {
            // The motion of the mechanism, looked at as often as lines are printed, or fifty times as often.
            let interval = listing().interval * stated.pick(1.0, 0.02);
            swinging(looked_at(stated), &|row| {
                let of = with(row, EXCESSIVE, 1.0)?;
                let lines = of.run(interval, listing().duration).ok()?;
                Some(lines.iter().map(|line| (line.engagement, line.speed)).collect())
            })
        })
        .second_route(RUNGE_KUTTA, |stated| {
            // The program with its reset angle, its lagged sign and its own π, printing as often.
            let interval = listing().interval * stated.pick(1.0, 0.02);
            swinging(looked_at(stated), &|row| {
                let program = Program1973 { torque: EXCESSIVE * row.torque(), ..Hypothesis::AS_RUN.program(row)? };
                let lines = program.run(&Listing { interval, ..listing() }.integrator()).ok()?.lines;
                Some(lines.iter().map(|line| ((line.turned / program.reset) as usize, line.speed)).collect())
            })
        })
        .interpreted_as(
            "Runs with the same mechanism and the same friction value form a group. We read the recommendation's \
             “excessively high” as ten times the greatest torque that the tables have for the group. We call an \
             oscillation “significant” if, once the rise is over, the highest and the lowest peak differ by 1 rad/s, \
             the unit of the tables, or more. By this measure, the printed velocities oscillate in \
             every group if the torque is about five times that greatest torque or more. At three times the greatest \
             torque, the velocities of some groups do not oscillate. Our first check takes the motion of the \
             mechanisms, and our second check takes the program as it was run, so their numbers differ.",
        )
        .corrected(
            "significant cyclic oscillations in the magnitude of the greatest printed velocity of each cycle, not of \
             the peak velocity",
            SAMPLED_PEAKS,
        )
}

/// By how much a torque exceeds the greatest of the tables.
const EXCESSIVE: f64 = 10.0;

/// Engagements by which a rise is over.
const RISEN: usize = 8;

/// Which lines are looked at: those of the print-out for its peaks, and closer ones for the peaks of the motion.
fn looked_at(stated: Stated) -> &'static str {
    stated.pick("lines printed as often as in the runs", "lines printed much more often than in the runs")
}

/// The engagements and speeds of a run's lines.
type Lines = Vec<(usize, f64)>;

/// Whether the greatest speeds on the lines of successive engagements differ by a unit of the tables or more, in all
/// groups of runs, each with an excessive torque; with words for the lines.
fn swinging(lines_of: &str, lines: &dyn Fn(&Row) -> Option<Lines>) -> Finding {
    let swings = series(rows()).filter_map(|own| {
        let lines = lines(own.last()?)?;
        // The last engagement may be cut short.
        let last = lines.last()?.0;
        let mut peaks = vec![0.0_f64; last];
        for (engagement, speed) in lines.into_iter().filter(|(engagement, _)| *engagement < last) {
            peaks[engagement] = peaks[engagement].max(speed);
        }
        let steady = peaks.get(RISEN..)?;
        let [least, most] = range(steady.iter().copied());
        Some(most - least)
    });
    let swings: Vec<f64> = swings.collect();
    let [least, most] = range(swings.iter().copied());
    Finding::new(
        swings.len() == series(rows()).count() && least >= 1.0,
        format!(
            "with {lines_of}, the highest and the lowest peak differ by {least:.2} to {most:.2} rad/s, depending on \
             which of {} groups the run is from. A significant oscillation needs 1 rad/s or more",
            swings.len()
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn from_five_times_the_greatest_torque_on_the_printed_peaks_of_all_groups_swing_and_with_three_times_not() {
        for (times, expected) in [(3.0, false), (5.0, true), (7.0, true), (30.0, true)] {
            let found = swinging("the printed lines", &|row| {
                let lines = with(row, times, 1.0)?.run(listing().interval, listing().duration).ok()?;
                Some(lines.iter().map(|line| (line.engagement, line.speed)).collect())
            });
            assert_eq!(found.holds, expected, "{times}: {}", found.how);
        }
    }
}
