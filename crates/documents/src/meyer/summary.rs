//! What the abstract says was found: a terminal velocity, its use, and the time that it takes.

use super::general_statements::with;
use super::newton::Newton;
use super::runs::table::rows;
use super::terms::starts;
use super::*;
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use geneva_case1973::{Column, Hypothesis, Row};
use geneva_evidence::Decimal;
use std::sync::OnceLock;

const ABSTRACT: Locator = at("Abstract, last paragraph");

/// The claims of the abstract.
pub(super) fn claims() -> Vec<Claim> {
    vec![
        ABSTRACT
            .statement(
                "meyer.abstract.terminal",
                "does reach a terminal velocity",
                "the mechanism reaches a terminal velocity",
            )
            .first_route(QUADRATURE, |stated| {
                let of = |row: &Row| Some(with(row, 1.0, stated.pick(1.0, 0.0))?.steady_state().ok()?.multiplier);
                let left: Vec<f64> = rows().iter().filter_map(of).collect();
                let worst = left.iter().copied().reduce(f64::max);
                let reduced = worst.map_or_else(String::new, |worst| {
                    format!(
                        ", and an engagement reduces a small difference from the steady speed to {worst:.2} of its \
                         size or less"
                    )
                });
                Finding::new(
                    left.len() == rows().len() && worst.is_some_and(|worst| worst < 1.0),
                    format!("{} of {} runs have a steady motion{reduced}", left.len(), rows().len()),
                )
            })
            .second_route(RUNGE_KUTTA, |stated| {
                let settled = |row: &Row| {
                    let [before, last] = last_two(row, stated.pick(1.0, 0.0));
                    (before.1 / last.1 - 1.0).abs() <= crate::evidence::STEPS_TOLERANCE.relative
                };
                Finding::for_all(rows(), settled, |count, all| {
                    format!("{count} of {all} runs repeat their speed after {ENGAGEMENTS} engagements")
                })
            })
            .but_not("the mechanism reaches one without friction too"),
        ABSTRACT
            .statement(
                "meyer.abstract.fifty",
                "as much as fifty milliseconds",
                "the longest time to the terminal velocity",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let said = tabulated(stated);
                let times = rows().iter().map(|row| 1e3 * row.number(Column::Rise));
                let (longest, beyond) = (times.clone().fold(0.0, f64::max), times.filter(|time| *time > said + 0.5));
                let beyond = beyond.count();
                Finding::new(
                    beyond == 0 && (longest - said).abs() <= 0.5,
                    format!("{beyond} of {} rise times of Appendix E are above {said} ms", rows().len()),
                )
            })
            .second_route(QUADRATURE, |stated| {
                let longest = |reading: usize| starts().iter().map(move |(_, start)| 1e3 * start.rise_times[reading]);
                let most = [0, 1].map(|reading| longest(reading).fold(0.0, f64::max));
                let beyond = [0, 1].map(|reading| longest(reading).filter(|time| *time > FIFTY).count());
                let said = stated.decimals();
                let as_said =
                    || said.len() == 3 && (0..2).all(|reading| said[reading + 1].is_rounding_of(most[reading]));
                Finding::new(
                    starts().len() == rows().len()
                        && stated.pick(beyond.iter().all(|count| *count > 0) && as_said(), beyond == [0, 0]),
                    format!(
                        "the velocity at each angle is steady to one per cent only after more than {FIFTY} ms in {} \
                         runs, and after {:.1} ms in the slowest run. The average of peak and minimum is steady to one \
                         per cent only after more than {FIFTY} ms in {} runs, and after {:.1} ms in the slowest run",
                        beyond[0], most[0], beyond[1], most[1]
                    ),
                )
            })
            .interpreted_as("We read “as much as” as saying that no run takes longer.")
            .corrected(
                "more than fifty milliseconds: up to 101 in Appendix E, and for the mechanisms themselves up to 103 by \
                 the velocity at each angle, or up to 145 by the average of peak and minimum",
                Slip {
                    id: "",
                    reason: "The claim disagrees with the thesis's own tables. Most of the rise times of six pins in \
                             Appendix E are longer than fifty milliseconds, and one of four pins. The tables alone \
                             do not decide the matter, because no definition of the rise time that we tried reproduces \
                             their rise times. But some of the computed motions take longer than the abstract's time \
                             to come within one per cent of the terminal velocity, whether we take the velocity \
                             at each angle or the average of peak and minimum.",
                    witness: "We solved the equation of motion for the ideal mechanisms.",
                    origin: Origin::Unknown,
                    consequence: Consequence::Conclusion,
                    changes: "If you plan with the time given in the abstract, you allow too little time. The longest \
                              rise in the tables takes twice that time. In the ideal mechanisms, the longest rise \
                              takes twice the abstract's time if we go by the velocity at each angle, and nearly three \
                              times the abstract's time if we go by the average of peak and minimum.",
                },
            ),
    ]
}

/// The rise time of the abstract, in ms; printed in a word.
const FIFTY: f64 = 50.0;

/// The longest rise of Appendix E that is stated, in ms, or that of the abstract.
fn tabulated(stated: Stated) -> f64 {
    stated.pick(stated.decimals().first().map_or(f64::NAN, Decimal::to_f64), FIFTY)
}

/// Engagements from rest that are followed by steps.
const ENGAGEMENTS: usize = 24;

/// Duration and end speed of each of the engagements of a run from rest, by Newton's laws in steps, with the friction
/// times a factor; of the mechanism as it is.
fn from_rest(row: &Row, friction: f64) -> Vec<(f64, f64)> {
    // With the friction of the row the motion is asked for again and again.
    static OWN: OnceLock<Vec<Vec<(f64, f64)>>> = OnceLock::new();
    if friction == 1.0 {
        let all = OWN.get_or_init(|| rows().iter().map(|row| followed(row, 1.0)).collect());
        if let Some(known) = rows().iter().zip(all).find(|(other, _)| *other == row) {
            return known.1.clone();
        }
    }
    followed(row, friction)
}

fn followed(row: &Row, friction: f64) -> Vec<(f64, f64)> {
    from_speed(row, friction, 0.0)
}

/// Duration and end speed of each engagement of a run from a speed at entry; fewer of them if the driver does not come
/// through them all.
pub(super) fn from_speed(row: &Row, friction: f64, speed: f64) -> Vec<(f64, f64)> {
    const STEPS: u32 = 200;
    let Some(at) = Hypothesis::IDEAL.parameters(row) else { return Vec::new() };
    let (half, inertias) = (at.mechanism().engagement_half_angle(), at.inertias());
    let pair = Newton {
        radius: 1.0,
        distance: at.mechanism().centre_distance_ratio(),
        friction: friction * at.friction(),
        driver: inertias.driver(),
        follower: inertias.follower(),
    };
    let engagements = pair.engagements(half, STEPS);
    let next = |entry: f64| engagements.passage(entry, &|_| at.torque());
    let passages = std::iter::successors(next(speed * speed), |before| next(before.end));
    passages.take(ENGAGEMENTS).map(|passage| (passage.duration, passage.end.sqrt())).collect()
}

/// The last two of them; not numbers if the driver does not come so far.
fn last_two(row: &Row, friction: f64) -> [(f64, f64); 2] {
    let all = from_rest(row, friction);
    let [before, last] = [2, 1].map(|back| all.len().checked_sub(back).and_then(|at| all.get(at).copied()));
    let none = (f64::NAN, f64::NAN);
    if all.len() == ENGAGEMENTS { [before.unwrap_or(none), last.unwrap_or(none)] } else { [none; 2] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_kinematics::Mechanism;

    #[test]
    fn most_rise_times_of_six_pins_are_longer_than_the_abstract_has_it_and_one_of_four() {
        let longer = |mechanism: Mechanism| {
            let own: Vec<&Row> = rows().iter().filter(|row| row.mechanism == mechanism).collect();
            let longer = own.iter().filter(|row| 1e3 * row.number(Column::Rise) > FIFTY).count();
            (longer, own.len())
        };
        let (six, of_six) = longer(Mechanism::SIX_PIN);
        assert!(2 * six > of_six, "{six} of {of_six}");
        assert_eq!([Mechanism::FOUR_PIN, Mechanism::THREE_PIN].map(|mechanism| longer(mechanism).0), [1, 0]);
    }
}
