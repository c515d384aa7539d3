//! The conclusions and recommendations of the thesis.

use super::general_statements::{spread, strong};
use super::instants::statement;
use super::profile::engagement;
use super::runs::{Column, Hypothesis, Mechanism, Row, rows};
use super::study::{row, steady};
use super::*;
use crate::Evidence::{Integration, Steps};
use geneva_dynamics::program::Program;
use geneva_dynamics::timer::Sensitivities;

pub fn claims() -> Vec<Claim> {
    [conclusions(), hand_over::conclusion(), recommendations()].concat()
}

fn conclusions() -> Vec<Claim> {
    vec![
        statement(
            "meyer.small-variations",
            "Conclusion 2",
            "small changes of the parameters change the motion little",
            "will not seriously affect the motion",
            (Integration, || {
                let powers = sensitivities();
                let [torque, friction, driver, follower] = powers;
                Finding::new(
                    powers.iter().all(|power| power.abs() < 1.0),
                    format!(
                        "one per cent more torque, friction, driver's or follower's inertia changes the mean speed by \
                         {torque:.2}, {friction:.2}, {driver:.2} or {follower:.2} per cent, in the worst of the runs"
                    ),
                )
            }),
            (Steps, || {
                let period = |friction| {
                    let row = row(Mechanism::FourPin, friction, ".10")?;
                    Some(Hypothesis::TRUE.cycle_by_steps(row)?[1])
                };
                let power =
                    period(".20").zip(period(".25")).map_or(f64::NAN, |(a, b)| libm::log(b / a) / libm::log(5.0 / 4.0));
                Finding::new(
                    power.abs() < 1.0,
                    format!(
                        "with four pins the period goes as the friction to the power {power:.2}, \
                            by steps"
                    ),
                )
            }),
        ),
    ]
}

fn recommendations() -> Vec<Claim> {
    vec![
        statement(
            "meyer.not-fast-enough",
            "Recommendation 1",
            "the rise times are too long for a timer of milliseconds",
            "not fast enough",
            (OtherPlaceInSource, || {
                let least = rows().iter().map(|row| row.number(Column::Rise)).fold(f64::INFINITY, f64::min);
                Finding::new(least > 0.01, format!("the shortest of Appendix E is {least} s"))
            }),
            (Integration, || {
                let first = steady().iter().map(|(_, state)| state.period).fold(f64::INFINITY, f64::min);
                Finding::new(first > 0.01, format!("a single engagement takes {first:.4} s or more"))
            }),
        ),
        Claim::statement(
            WORK,
            "meyer.cyclic-oscillations",
            "Recommendation 2",
            "a strong spring makes the peak of the speed swing from cycle to cycle",
            "significant cyclic oscillations in the magnitude of the peak velocity",
            Check::corrected_equation(
                (Integration, || {
                    let peaks = true_peaks();
                    Finding::new(
                        is_seen(spread(&peaks)),
                        format!("true peaks of the last engagements in {:.3} of one another", spread(&peaks)),
                    )
                }),
                || {
                    let [weak, strong, fine] =
                        [(".08", 1.0), (".14", 1.0), (".14", 0.1)].map(|(torque, part)| spread(&seen_peaks(torque, part)));
                    Finding::new(
                        is_seen(strong) && strong > weak && !is_seen(fine),
                        format!(
                            "read from the printed lines the peaks spread by {weak:.3} for K = .08 and {strong:.3} for .14, \
                             from lines ten times as close by {fine:.4}"
                        ),
                    )
                },
                (Steps, || {
                    let [coarse, fine] = [1.0, 0.1].map(|part| spread(&stepped_peaks(part)));
                    Finding::new(
                        is_seen(coarse) && !is_seen(fine),
                        format!("by the program's integrator {coarse:.3}, and {fine:.4} with closer lines"),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "cyclic oscillations in the printed peak velocity, not in that of the driver", slip: Slip {
 id: "",
reason: "The lines of a run are 0.0005 s apart, and the peak falls between them, now nearer to one, \
                    now farther. The stronger the spring, the sharper the peak and the more is missed. The true \
                    peaks of the steady motion are equal.",
witness: "The program, printing ten times as often, shows equal peaks.",
origin: Origin::Concept,
consequence: Consequence::Conclusion,
changes: "",
} }),
        front::page_of_definition(),
        statement(
            "meyer.better-average",
            "Recommendation 7",
            "the average should follow from the time of a revolution, not from peak and minimum",
            "A more appropriate definition would be based on the time",
            (Integration, || {
                let parts = steady().iter().map(|(_, state)| state.mean_of_extremes() / state.mean_speed);
                let (least, most) = parts.fold((f64::INFINITY, 0.0), |(a, b): (f64, f64), x| (a.min(x), b.max(x)));
                let off = steady().iter().map(|(_, state)| state.mean_of_extremes() - state.mean_speed);
                Finding::new(
                    off.fold(f64::INFINITY, f64::min) > 1.0,
                    format!(
                        "mean of peak and minimum over angle by time: {least:.2} to {most:.2} in the runs, in none of them \
                         the same to a printed unit"
                    ),
                )
            }),
            (Steps, || {
                // Both from the printed peak and minimum and from the time of a quarter turn by steps.
                let part = row(Mechanism::FourPin, ".20", ".10").and_then(|row| {
                    let time = Hypothesis::TRUE.cycle_by_steps(row)?[1] / Hypothesis::TRUE.parameters(row)?.drive().sqrt();
                    let middle = (row.number(Column::Peak) + row.number(Column::Minimum)) / 2.0;
                    Some(middle - PI / 2.0 / time)
                });
                let more = part.unwrap_or(f64::NAN);
                Finding::new(
                    more > 1.0,
                    format!("{more:.0} rad/s more with four pins, by the printed speeds and a period by steps"),
                )
            }),
        ),
    ]
}

/// The powers of the mean speed that are the greatest, by their size, of all runs: to torque, friction, driver's and
/// follower's inertia.
fn sensitivities() -> [f64; 4] {
    let of = |row: &Row| Sensitivities::new(&Hypothesis::TRUE.parameters(row)?).ok();
    let further = |worst: f64, power: f64| if power.abs() > worst.abs() || power.is_nan() { power } else { worst };
    rows().iter().fold([0.0; 4], |worst, row| {
        let powers =
            of(row).map_or([f64::NAN; 4], |of| [of.torque, of.friction, of.driver_inertia, of.follower_inertia]);
        std::array::from_fn(|at| further(worst[at], powers[at]))
    })
}

/// Whether peaks that spread so much differ in a printed digit: by a unit of the last place, at the strongest spring.
fn is_seen(spread: f64) -> bool {
    let peak = row(Mechanism::FourPin, ".20", ".14").map_or(f64::NAN, |row| row.number(Column::Peak));
    spread * peak >= 1.0
}

fn true_peaks() -> Vec<f64> {
    let rise = strong().and_then(|of| of.rise(1e-9).ok());
    rise.map_or_else(Vec::new, |rise| rise.cycles.iter().skip(3).map(|cycle| cycle.peak.speed).collect())
}

fn seen_peaks(torque: &str, part: f64) -> Vec<f64> {
    let interval = runs::interval() * part;
    let run = engagement(Mechanism::FourPin, ".20", torque).and_then(|of| of.run(interval, runs::duration()).ok());
    let lines = run.unwrap_or_default();
    // The last engagement may be cut short.
    let last = lines.last().map_or(0, |line| line.engagement);
    let largest = |number: usize| {
        lines.iter().filter(|line| line.engagement == number).map(|line| line.speed).fold(0.0, f64::max)
    };
    (2..last).map(largest).collect()
}

fn stepped_peaks(part: f64) -> Vec<f64> {
    let interval = runs::interval() * part;
    let program = strong().map(|of| Program::of(of.parameters()));
    let integrator = geneva_mimic::Parameters {
        relative_tolerance: 1e-7,
        ..geneva_mimic::Parameters::new(interval, runs::duration())
    };
    let Some((program, run)) = program.and_then(|program| Some((program, program.run(&integrator).ok()?))) else {
        return Vec::new();
    };
    let number = |turned: f64| (turned / program.fold).floor() as usize;
    let last = run.lines.last().map_or(0, |line| number(line.turned));
    let largest = |engagement: usize| {
        let own = run.lines.iter().filter(|line| number(line.turned) == engagement);
        own.map(|line| line.speed).fold(0.0, f64::max)
    };
    (2..last).map(largest).collect()
}
