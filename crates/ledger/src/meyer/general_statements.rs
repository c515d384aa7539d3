//! The parametric graphs, Figs. 9 to 11, and the general statements on them.

use super::instants::statement;
use super::profile::engagement;
use super::profile::{first_minimum_by_steps, lost};
use super::runs::{Column, Hypothesis, Mechanism, Row, rows};
use super::study::row;
use super::*;
use crate::Evidence::{Integration, Steps};
use geneva_dynamics::steady::{Engagement, Rise, SteadyError};
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
                    format!("{:.4} s and {:.0} rad/s against {:.4} s and {:.0} rad/s", weak.0, weak.1, strong.0, strong.1),
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
            Check::corrected_form(
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
            reason: "Eq. (1-19) is the same for a larger torque if all times are shortened by its root. The inertia of the \
                     system sets how long a rise takes, √(I_f/K), and no least time.",
            witness: "Where the printed rise times are regular they fall to the end of the column.",
            severity: Severity::Conceptual,
            inherited_by: &[],
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
            Check::corrected_form(
                (Integration, || {
                    let counts = explained();
                    let best = counts.iter().max().copied().unwrap_or(0);
                    let all = four_pins().count();
                    Finding::new(
                        best == all,
                        format!(
                            "with four pins, five such times (of entry speed, mean speed, peak, minimum and mean of extremes) \
                             give {counts:?} of {all} printed ones within a thousandth of a second"
                        ),
                    )
                }),
                || {
                    let scaled = |friction: &str| {
                        let times = four(friction).map(|row| row.number(Column::Rise) * row.torque().sqrt());
                        let (low, high) = times.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), time| {
                            (low.min(time), high.max(time))
                        });
                        high / low
                    };
                    let spread = [".20", ".35"].map(scaled);
                    Finding::new(
                        spread.iter().all(|spread| *spread > 1.2),
                        format!(
                            "printed times times the root of K, which no definition changes, differ by factors of {:.2} and \
                             {:.2} for one friction",
                            spread[0], spread[1]
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
        .with_erratum(Erratum {
            corrected: "RISE TIME, BY NO ONE DEFINITION",
            reason: "No time to 99 per cent gives the column of Appendix E that the plots summarize, and times that had one \
                     definition would fall as the inverse of the root of the torque. The text has another definition, by \
                     the first minimum.",
            witness: "For the least slow of the four-pin runs the printed time is that of the \
                    first minimum, in steps.",
            severity: Severity::Conceptual,
            inherited_by: &[],
        }),
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
            Check::corrected_form(
                (OtherPlaceInSource, || {
                    let (least, most) = powers();
                    Finding::new(
                        least > 0.9,
                        format!(
                            "in the printed peaks velocity goes as the torque to the power \
                                {least:.2} to {most:.2}"
                        ),
                    )
                }),
                || {
                    let (least, most) = powers();
                    Finding::new(
                        least > 0.45 && most < 0.55,
                        format!("in the printed peaks the power is {least:.2} to {most:.2}"),
                    )
                },
                (ExactIdentity, scaling),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "The terminal velocity grows as the square root of the driving torque",
            reason: "Eq. (1-19) is the same for k² times the torque if all speeds are k times as large. Over the short \
                     ranges of the runs a root is nearly straight, but twice the torque gives 1.41 times the speed.",
            witness: "The law of similarity is proven for the equation; the printed peaks follow it.",
            severity: Severity::Conceptual,
            inherited_by: &[],
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

fn explained() -> [usize; 5] {
    type Definition = fn(&Rise) -> Option<f64>;
    let definitions: [Definition; 5] = [
        |rise| rise.until_entry_speed(0.01),
        |rise| rise.until_mean_speed(0.01),
        |rise| rise.until_peak(0.01),
        |rise| rise.until_minimum(0.01),
        |rise| rise.until_mean_of_extremes(0.01),
    ];
    let rises: Vec<_> = four_pins().filter_map(|row| Some((row, Hypothesis::TRUE.rise(row)?))).collect();
    definitions.map(|definition| {
        let near = |(row, rise): &&(&Row, Rise)| {
            definition(rise).is_some_and(|time| (time - row.number(Column::Rise)).abs() <= 1e-3)
        };
        rises.iter().filter(near).count()
    })
}

pub fn powers() -> (f64, f64) {
    let of = |mechanism: Mechanism, friction: &str| {
        let own: Vec<_> = rows()
            .iter()
            .filter(|row| row.mechanism == mechanism && row.printed(Column::Friction) == friction)
            .collect();
        own.first().zip(own.last()).map_or(f64::NAN, |(first, last)| {
            libm::log(last.number(Column::Peak) / first.number(Column::Peak))
                / libm::log(last.torque() / first.torque())
        })
    };
    let all = Mechanism::ALL.into_iter().flat_map(|mechanism| FRICTIONS.map(|friction| of(mechanism, friction)));
    all.fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), power| (least.min(power), most.max(power)))
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
