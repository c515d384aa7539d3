//! The parametric graphs, Figs. 9 to 11, and the general statements on them.

use super::instants::statement;
use super::profile::engagement;
use super::profile::{first_minimum_by_steps, lost};
use super::runs::{Column, Hypothesis, Mechanism, Row, rise_times, rows};
use super::study::row;
use super::*;
use crate::Evidence::{Integration, Steps};
use geneva_dynamics::steady::{Engagement, SteadyError};
use geneva_dynamics::{Parameters, Sign, similarity::Similarity};
use std::sync::OnceLock;

const FIRST: &str = "Chapter II, 1st general statement";
const SECOND: &str = "Chapter II, 2nd general statement";
const THIRD: &str = "Chapter II, 3rd general statement";

pub fn claims() -> Vec<Claim> {
    let mut claims = torque();
    claims.extend(graphs());
    claims.push(study::of_axis());
    claims.push(lost("meyer.fig-11", "Fig. 11", "rise time and terminal velocity over torque, six pins", "FIGURE 11"));
    claims.extend(friction());
    claims
}

fn torque() -> Vec<Claim> {
    vec![
        statement(
            "meyer.more-torque",
            FIRST,
            "more torque, more speed and less rise time",
            "the lower the rise time, and the greater the terminal velocity",
            (Integration, || {
                let [weak, strong] = [".08", ".14"].map(|torque| settling(".20", torque));
                Finding::new(
                    strong.0 < weak.0 && strong.1 > weak.1,
                    format!(
                        "{:.4} s and {:.0} rad/s against {:.4} s and {:.0} rad/s",
                        weak.0, weak.1, strong.0, strong.1
                    ),
                )
            }),
            (ExactIdentity, scaling),
        ),
        Claim::statement(
            WORK,
            "meyer.least-rise-time",
            FIRST,
            "the rise time does not fall below a least one, however strong the spring",
            "reach a certain minimum",
            Check::corrected_equation(
                (ExactIdentity, || {
                    let Finding { how, .. } = scaling();
                    Finding::new(false, format!("a torque k² times as large takes 1/k of the time, for any k; {how}"))
                }),
                || {
                    let [weak, strong] = [".08", ".14"].map(|torque| settling(".20", torque));
                    let expected = (0.08_f64 / 0.14).sqrt();
                    let found = strong.0 / weak.0;
                    Finding::new(
                        (found / expected - 1.0).abs() < 1e-6,
                        format!("rise times {found:.4} to one, roots of the torques {expected:.4} to one"),
                    )
                },
                (OtherPlaceInSource, || {
                    // With four pins and μ = .25: over a range of torque of 1.75, still falling at its end.
                    let own: Vec<f64> = four(".25").map(|row| row.number(Column::Rise)).collect();
                    Finding::new(
                        own.len() == 4 && own.is_sorted_by(|a, b| a > b),
                        format!("the column for four pins and μ = .25 falls to its end: {own:?}"),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "fall without end, as the inverse of the root of the torque",
            slip: Slip {
                id: "",
                reason: "Eq. (1-19) is the same for a larger torque if all times are shortened by its root. The \
                    inertia of the system sets how long a rise takes, √(I_f/K), and no least time.",
                witness: "Where the printed rise times are regular they fall to the end of the column.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
    ]
}

fn graphs() -> Vec<Claim> {
    vec![
        lost("meyer.fig-9", "Fig. 9", "rise time and terminal velocity over torque, three pins", "FIGURE 9"),
        Claim::statement(
            WORK,
            "meyer.fig-10.rise-axis",
            "Figs. 10 and 11, ordinates",
            "the rise time is the time until the terminal velocity is reached but for one part in a hundred",
            "RISE TIME TO 99% OF TERMINAL VELOCITY",
            Check::corrected_equation(
                (Integration, || {
                    let counts: Vec<usize> = rise_times::explained()
                        .iter()
                        .flat_map(|(_, both)| both.map(|of| of.within_one.iter().sum()))
                        .collect();
                    Finding::new(
                        counts.contains(&rows().len()),
                        format!(
                            "{} definitions, for the runs and for the mechanism, give {counts:?} of {} printed ones to \
                             one unit",
                            rise_times::DEFINITIONS.len(),
                            rows().len()
                        ),
                    )
                }),
                || {
                    let groups = rise_times::groups();
                    let impossible = groups.iter().filter(|group| !group.possible).count();
                    Finding::new(
                        impossible > 0,
                        format!(
                            "in {impossible} of {} groups with one friction the printed times cannot go as the inverse root of \
                             K, which any definition by the motion gives",
                            groups.len()
                        ),
                    )
                },
                (Steps, || {
                    let printed = row(Mechanism::FourPin, ".35", ".10").map_or(f64::NAN, |row| row.number(Column::Rise));
                    let first = first_minimum_by_steps();
                    Finding::new(
                        (first - printed).abs() <= 1e-3,
                        format!("with μ = .35 and K = .10 the first minimum is at {first:.4} s; printed \
                                is {printed}"),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "RISE TIME, BY NO ONE DEFINITION", slip: Slip {
 id: "",
reason: "No time to 99 per cent gives the column of Appendix E that the plots summarize, and times \
                    that had one definition would fall as the inverse of the root of the torque. The text has \
                    another definition, by the first minimum.",
witness: "For the least slow of the four-pin runs the printed time is that of the first minimum, in \
                    steps.",
origin: Origin::Concept,
consequence: Consequence::Conclusion,
changes: "",
} }),
        lost("meyer.fig-10", "Fig. 10", "rise time and terminal velocity over torque, four pins", "FIGURE 10"),
    ]
}

fn friction() -> Vec<Claim> {
    vec![
        statement(
            "meyer.less-friction",
            SECOND,
            "less friction, longer rise",
            "The more frictionless the system, the greater is the rise time",
            (Integration, || {
                let times = FRICTIONS.map(|friction| settling(friction, ".10").0);
                let left = FRICTIONS.map(|friction| {
                    engagement(Mechanism::FourPin, friction, ".10")
                        .and_then(|of| Some(of.steady_state().ok()?.contraction))
                        .unwrap_or(f64::NAN)
                });
                Finding::new(
                    left.is_sorted_by(|a, b| a > b) && times[0] > times[3],
                    format!("with four pins and K = .10 an engagement leaves {left:.5?} of a difference"),
                )
            }),
            (OtherPlaceInSource, || {
                let times: Vec<f64> = FRICTIONS
                    .iter()
                    .filter_map(|friction| Some(row(Mechanism::FourPin, friction, ".10")?.number(Column::Rise)))
                    .collect();
                Finding::new(times.len() == 4 && times.is_sorted_by(|a, b| a > b), format!("the column has {times:?}"))
            }),
        ),
        statement(
            "meyer.no-friction",
            SECOND,
            "without friction there is no terminal velocity",
            "will never reach a terminal velocity",
            (Integration, || {
                let ends = Mechanism::ALL.map(|mechanism| {
                    let own = rows().iter().find(|row| row.mechanism == mechanism);
                    let free = own.and_then(|row| with(row, 1.0, 0.0));
                    free.is_some_and(|of| matches!(of.steady_state(), Err(SteadyError::NoTerminalSpeed { .. })))
                });
                Finding::new(ends == [true; 3], "for each of the three the speed grows without end")
            }),
            (ExactIdentity, || {
                // At the exit the follower stands still: the spring's work is in the driver alone, and comes again.
                let Finding { holds, how } = exactly(|at| is_zero(&at.leaving.across), "the follower hands nothing on");
                Finding::new(
                    holds,
                    format!(
                        "{how}, so that each engagement adds the work of the spring to the \
                        driver"
                    ),
                )
            }),
        ),
        Claim::statement(
            WORK,
            "meyer.almost-linear",
            THIRD,
            "terminal velocity is nearly proportional to the torque",
            "An almost linear relationship exists",
            Check::corrected_equation(
                (OtherPlaceInSource, || {
                    let (fit, all) = allow(1.0);
                    Finding::new(
                        fit == all,
                        format!("{fit} of {all} columns of printed periods allow the power one of the torque"),
                    )
                }),
                || {
                    let (fit, all) = allow(0.5);
                    Finding::new(
                        fit == all,
                        format!("{fit} of {all} columns of printed periods allow the power one half"),
                    )
                },
                (ExactIdentity, scaling),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "The terminal velocity grows as the square root of the driving torque",
            slip: Slip {
                id: "",
                reason: "Eq. (1-19) is the same for k² times the torque if all speeds are k times as large. Over the \
                    short ranges of the runs a root is nearly straight, but twice the torque gives 1.41 times \
                    the speed.",
                witness: "The law of similarity is proven for the equation; the printed periods follow it.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
    ]
}

pub const FRICTIONS: [&str; 4] = [".20", ".25", ".30", ".35"];

pub fn four_pins() -> impl Iterator<Item = &'static Row> {
    rows().iter().filter(|row| row.mechanism == Mechanism::FourPin)
}

pub fn four(friction: &str) -> impl Iterator<Item = &'static Row> {
    four_pins().filter(move |row| row.printed(Column::Friction) == friction)
}

fn scaling() -> Finding {
    all_proven(&Sign::BOTH.map(Similarity))
}

fn settling(friction: &str, torque: &str) -> (f64, f64) {
    let rise = row(Mechanism::FourPin, friction, torque).and_then(|row| Hypothesis::TRUE.rise(row));
    rise.and_then(|rise| Some((rise.until_entry_speed(0.01)?, rise.steady.peak.speed))).unwrap_or((f64::NAN, f64::NAN))
}

/// How many columns of printed periods, with one mechanism and one friction, may go as this inverse power of the torque
/// from the first row to the last, if each may be off by a unit of its last place; and how many columns there are. The
/// mean speed goes as the inverse of the period.
fn allow(power: f64) -> (usize, usize) {
    let of = |own: &[Row]| {
        own.first().zip(own.last()).is_some_and(|(first, last)| {
            let expected = libm::pow(last.torque() / first.torque(), power);
            let [slow, fast] = [first, last].map(|row| row.number(Column::Period));
            ((slow - 1e-3) / (fast + 1e-3)..=(slow + 1e-3) / (fast - 1e-3)).contains(&expected)
        })
    };
    runs::series().fold((0, 0), |(fit, all), own| (fit + usize::from(of(own)), all + 1))
}

pub fn with(row: &Row, torque: f64, friction: f64) -> Option<Engagement> {
    let at = Hypothesis::TRUE.parameters(row)?;
    let changed = Parameters::new(at.slots(), at.inertias(), at.torque() * torque, at.friction() * friction).ok()?;
    Engagement::with_tolerance(&changed, 1e-11).ok()
}

pub fn spread(values: &[f64]) -> f64 {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    if values.len() < 2 { f64::NAN } else { values.iter().copied().fold(0.0, f64::max) / least - 1.0 }
}

pub fn strong() -> Option<&'static Engagement> {
    static STRONG: OnceLock<Option<Engagement>> = OnceLock::new();
    STRONG.get_or_init(|| engagement(Mechanism::FourPin, ".20", ".14")).as_ref()
}
