//! Fig. 8 and what chapter II reads off it: where driver and follower are fastest and slowest.

use super::instants::statement;
use super::runs::{Column, Hypothesis, Mechanism};
use super::study::{EXAMPLES, row, steady, stepped};
use super::*;
use crate::Evidence::{Integration, Steps};
use geneva_dynamics::program::Program;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Sign, similarity::Similarity};
use geneva_kinematics::escapement::pins_needed;

const BEFORE: &str = "Chapter II, sentence around Fig. 8";
const RISE: &str = "Chapter II, paragraph on the rise time in Fig. 8";
const PEAKS: &str = "Chapter II, paragraph on the peaks in Fig. 8";

const LOST: &str = "The curves are not in the copy, and the run that they show is not named";

/// A figure of which the copy has the number only.
pub fn lost(id: &'static str, locator: &'static str, meaning: &'static str, printed: &'static str) -> Claim {
    Claim::figure(WORK, id, locator, meaning, printed, Check::Missing { reason: LOST })
        .expecting(Verdict::NotReproducible)
}

pub fn claims() -> Vec<Claim> {
    [curve(), at_entry(), at_the_centres()].concat()
}

fn curve() -> Vec<Claim> {
    vec![
        lost("meyer.fig-8", "Fig. 8", "speeds of driver and follower over time, four pins", "FIGURE 8"),
        Claim::statement(
            WORK,
            "meyer.shape",
            BEFORE,
            "no parameter changes the shape of the curve of speeds",
            "will not change the shape of the curve",
            Check::corrected_equation(
                (Integration, || {
                    let [low, high] = shapes(&[".20", ".35"]);
                    Finding::new(
                        agrees(low, high),
                        format!("with four pins peak over minimum is {low:.2} for μ = .20 and {high:.2} \
                                for .35"),
                    )
                }),
                || {
                    let alike = |friction: &str| {
                        let own: Vec<f64> = four(friction).map(|state| state.1.peak.speed / state.1.minimum.speed).collect();
                        own.len() > 3 && own.iter().all(|shape| (shape / own[0] - 1.0).abs() < 1e-8)
                    };
                    let holds = [".20", ".25", ".30", ".35"].into_iter().all(alike);
                    Finding::new(holds, "with four pins and one friction all torques give the same peak over \
                            minimum")
                },
                (ExactIdentity, || all_proven(&Sign::BOTH.map(Similarity))),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "The torque alone will not change the shape of the curve", slip: Slip {
 id: "",
reason: "Eq. (1-19) is the same equation if all speeds grow as the root of K/I_f and times shrink by \
                    it. Friction and the quotient of the inertias do change the shape: how deep the minimum is \
                    and where the peak stands.",
witness: "The law of similarity is proven for the equation with either sign of the friction.",
origin: Origin::Concept,
consequence: Consequence::Conclusion,
changes: "",
} }),
        Claim::value(
            WORK,
            "meyer.fig-8.rise",
            RISE,
            "rise time of the run that is drawn",
            ("0.025", "seconds"),
            Check::Missing {
                reason: "The text does not name the run. The first minima of two of the four-pin runs round to the printed \
                         time, and the table gives other rise times for both",
            },
        )
        .expecting(Verdict::NotReproducible),
        Claim::statement(
            WORK,
            "meyer.first-minimum",
            RISE,
            "by the first minimum of its speed the driver moves as it will for ever",
            "by the first minimum in velocity, the driver has achieved its steady state",
            Check::corrected_equation(
                (Integration, || {
                    let steady = engagement(Mechanism::FourPin, ".35", ".10").and_then(|of| of.steady_state().ok());
                    let part = first_minimum().1 / steady.map_or(f64::NAN, |state| state.minimum.speed);
                    Finding::new(
                        (part - 1.0).abs() <= 0.01,
                        format!("the first minimum is {part:.4} of the steady one, with the friction \
                                that brakes best"),
                    )
                }),
                || {
                    let end = engagement(Mechanism::FourPin, ".35", ".10").and_then(|of| {
                        Some(of.passage(0.0).ok()?.end_speed() / of.steady_state().ok()?.entry_speed)
                    });
                    let end = end.unwrap_or(f64::NAN);
                    Finding::new((end - 1.0).abs() < 0.01, format!("the second pin enters at {end:.5} of the steady speed"))
                },
                (Steps, || {
                    let part = stepped(Mechanism::FourPin)
                        .and_then(|cycle| Some((cycle.first_end / cycle.squares.last()?).sqrt()))
                        .unwrap_or(f64::NAN);
                    Finding::new((part - 1.0).abs() < 0.01, format!("{part:.5} by steps"))
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "by the entry of the second pin, the driver has achieved its steady state within one per cent, if μ \
                        is .35", slip: Slip {
 id: "",
reason: "The first minimum is that of the first engagement, before the speed has been handed on \
                    once. With the best brake of the four-pin runs it is 1.8 per cent below the steady minimum, \
                    with the least 8. One engagement then takes a difference to less than a thousandth, or to a \
                    twenty-fifth.",
witness: "The speed at the end of the first engagement, taken in steps, is that of the steady motion.",
origin: Origin::Concept,
consequence: Consequence::Conclusion,
changes: "",
} }),
    ]
}

fn at_entry() -> Vec<Claim> {
    vec![
        Claim::value(
            WORK,
            "meyer.fig-8.quarter",
            PEAKS,
            "turn of the driver between two peaks, with four slots",
            ("90", "°"),
            Check::number(
                (ClosedForm, || Escapement::all()[1].driver_half_angle().to_degrees() * 2.0),
                (LimitCase, || pins_needed(4).map_or(f64::NAN, |pins| 360.0 / pins.approximate())),
            ),
        ),
        elsewhere(
            "meyer.peaks-at-entry",
            "the driver is fastest when a pin enters",
            "the driver velocity is a maximum at pin entry",
            "the driver velocity is no maximum at pin entry; its maximum stands 0.2 to 1.7° after it with six pins, and 7 to \
             15° before the exit with four and three",
        ),
        statement(
            "meyer.still-at-entry",
            PEAKS,
            "the follower stands still when a pin enters or leaves",
            "the follower must be instantaneously stationary",
            (Vectors, || {
                for_each(
                    |at| {
                        [-1.0, 1.0].iter().all(|side| vanishes(Seen::new(at, side * at.driver_half_angle()).turning()))
                    },
                    "the pin moves along its slot at both ends",
                )
            }),
            (LimitCase, || exactly(|at| is_zero(&at.leaving.across), "the leaving pin moves along its slot")),
        ),
        elsewhere(
            "meyer.peaks-at-rest",
            "the driver is fastest when the follower stands still",
            "the peaks in driver velocity coincide with the zero points",
            "the peaks in driver velocity stand beside the zero points: after them with six pins, before them with four and \
             three",
        ),
        elsewhere(
            "meyer.peaks-at-exit",
            "the driver's speed rises from the line of centres until the pin leaves",
            "until it again reaches a maximum as the pin leaves the slot",
            "until a maximum, which with four and three pins comes 7 to 15° before the pin leaves the slot",
        ),
        statement(
            "meyer.leaves-as-entered",
            PEAKS,
            "in the steady motion the speed at the exit is that at the entry",
            "the same as when it entered",
            (Integration, || {
                let ends = EXAMPLES.map(|(mechanism, friction, torque)| {
                    let of = engagement(mechanism, friction, torque)?;
                    let entry = of.steady_state().ok()?.entry_speed;
                    Some(of.passage(entry).ok()?.end_speed() / entry)
                });
                Finding::new(
                    ends.iter().all(|end| end.is_some_and(|end| (end - 1.0).abs() < 1e-9)),
                    "a run of each mechanism, by passing the speed of entry on",
                )
            }),
            (Steps, || {
                let same = |mechanism: &Mechanism| {
                    let ends = stepped(*mechanism).and_then(|cycle| cycle.squares.first().zip(cycle.squares.last()));
                    ends.is_some_and(|(first, last)| (last / first - 1.0).abs() < 1e-9)
                };
                Finding::new(Mechanism::ALL.iter().all(same), "the same in steps")
            }),
        ),
    ]
}

fn at_the_centres() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "meyer.extremes-on-centres",
            PEAKS,
            "on the line of centres the driver is slowest and the follower fastest",
            "the driver velocity is a minimum and the follower velocity is a maximum",
            Check::corrected_equation(
                (ClosedForm, || {
                    // On the line sin θ = 0, so that B, C and D vanish: θ'' = E/A, and φ'' is a part of it.
                    let gains = EXAMPLES.map(|(mechanism, friction, torque)| {
                        engagement(mechanism, friction, torque)
                            .and_then(|of| Some(of.parameters().acceleration(0.0, 10.0).ok()?.value))
                            .unwrap_or(f64::NAN)
                    });
                    Finding::new(
                        gains.iter().all(|gain| *gain == 0.0),
                        format!("there the driver gains {:.0}, {:.0} and {:.0} rad/s²", gains[0], gains[1], gains[2]),
                    )
                }),
                || {
                    let holds = steady().iter().all(|(_, state)| {
                        let minimum = state.minimum.angle.to_degrees();
                        let change = state.switch_angle.map_or(f64::NAN, f64::to_degrees);
                        (-6.0..-0.4).contains(&minimum) && (9.0..25.0).contains(&change)
                    });
                    Finding::new(
                        holds,
                        "in all runs the driver is slowest 0.4 to 6° before the line, and the follower ceases to be sped up 9 \
                         to 25° after it",
                    )
                },
                (Steps, || {
                    let places = Mechanism::ALL.map(|mechanism| {
                        let cycle = stepped(mechanism)?;
                        let slowest = cycle.greatest(|_, speed| -speed);
                        let fastest = cycle.greatest(|angle, speed| {
                            speed * cycle.parameters.pose(angle).velocity_ratio()
                        });
                        Some([slowest.to_degrees(), fastest.to_degrees()])
                    });
                    let holds = places.iter().all(|at| {
                        at.is_some_and(|[slow, fast]| (-6.0..-0.4).contains(&slow) && (9.0..25.0).contains(&fast))
                    });
                    Finding::new(holds, format!("driver and follower by steps, in degrees: {:.1?}", places.map(Option::unwrap_or_default)))
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: "the driver velocity has just passed its minimum, and the follower \
                    velocity still rises", slip: Slip {
 id: "",
reason: "On the line of centres nothing but the spring acts along the motion, θ'' = E/A, which is \
                    positive. The minimum comes 0.4 to 6° before the line; the follower is fastest where the pin \
                    changes over to the other flank of the slot, 9 to 25° after it.",
witness: "Both places are found again in steps.",
origin: Origin::Concept,
consequence: Consequence::Conclusion,
changes: "",
} }),
    ]
}

/// A place that has the peak of the driver at entry or exit.
fn elsewhere(id: &'static str, meaning: &'static str, printed: &'static str, corrected: &'static str) -> Claim {
    let check = Check::corrected_equation(
        (ClosedForm, || {
            // At the ends B and D vanish, C does not: the follower stands still, but it is accelerated, and so rubs.
            let gains = EXAMPLES.map(|(mechanism, friction, torque)| {
                engagement(mechanism, friction, torque)
                    .and_then(|of| {
                        let (at, entry_speed) = (of.parameters(), of.steady_state().ok()?.entry_speed);
                        Some(at.acceleration(-at.slots().engagement_half_angle(), entry_speed).ok()?.value)
                    })
                    .unwrap_or(f64::NAN)
            });
            Finding::new(
                gains.iter().all(|gain| agrees(1.0 + gain, 1.0)),
                format!(
                    "in the steady motion the driver gains {:.0} rad/s² there with six pins, {:.0} with four and {:.0} with \
                     three: at a maximum it would gain nothing",
                    gains[0], gains[1], gains[2]
                ),
            )
        }),
        || {
            let holds = steady().iter().all(|(row, state)| is_beside(row.mechanism, state.peak.angle));
            Finding::new(holds, "so it is in the steady motion of all runs")
        },
        (Steps, || {
            let at = Mechanism::ALL.map(|of| stepped(of).map_or(f64::NAN, |cycle| cycle.greatest(|_, speed| speed)));
            let holds = Mechanism::ALL.iter().zip(at).all(|(mechanism, angle)| is_beside(*mechanism, angle));
            let [six, four, three] = at.map(f64::to_degrees);
            Finding::new(
                holds,
                format!(
                    "by steps at {six:.1}°, {four:.1}° and {three:.1}° for six, four and \
                    three pins"
                ),
            )
        }),
    );
    Claim::statement(WORK, id, PEAKS, meaning, printed, check).expecting(Verdict::Corrected).with_erratum(Erratum {
        corrected,
        slip: Slip {
            id: "",
            reason: "When a pin enters or leaves, the follower stands still but is being accelerated, and so the \
                    pin presses and rubs. With six pins the spring is the stronger and the speed still rises; \
                    with four and three the friction is, and the speed has been falling since before the exit.",
            witness: "The engagement is gone through in steps of the angle.",
            origin: Origin::Concept,
            consequence: Consequence::Conclusion,
            changes: "",
        },
    })
}

/// Whether an angle is where the driver of a mechanism is fastest: see the corrections.
fn is_beside(mechanism: Mechanism, angle: f64) -> bool {
    let half = 180.0 / f64::from(mechanism.pins());
    let angle = angle.to_degrees();
    match mechanism {
        Mechanism::SixPin => (0.15..1.75).contains(&(angle + half)),
        _ => (7.0..15.0).contains(&(half - angle)),
    }
}

/// The four-pin rows of a friction, each with its steady motion.
fn four(friction: &str) -> impl Iterator<Item = &'static (&'static runs::Row, geneva_dynamics::steady::SteadyState)> {
    steady()
        .iter()
        .filter(move |(row, _)| row.mechanism == Mechanism::FourPin && row.printed(Column::Friction) == friction)
}

/// Peak over minimum with four pins for two frictions.
fn shapes(frictions: &[&str; 2]) -> [f64; 2] {
    frictions.map(|friction| {
        let first = four(friction).next();
        first.map_or(f64::NAN, |(_, state)| state.peak.speed / state.minimum.speed)
    })
}

/// Interval of the lines among which the first minimum is looked for, and the length of the run, in s.
const FINE: f64 = 2e-5;
const LENGTH: f64 = 0.03;

/// Time and speed of the first minimum of the run with μ = .35 and K = .10.
fn first_minimum() -> (f64, f64) {
    let lines = engagement(Mechanism::FourPin, ".35", ".10").and_then(|of| of.run(FINE, LENGTH).ok());
    let lines: Vec<_> = lines.iter().flatten().map(|line| (line.time, line.speed, line.acceleration)).collect();
    level(&lines)
}

/// Time of the same minimum, by the program on its integrator.
pub fn first_minimum_by_steps() -> f64 {
    let program = engagement(Mechanism::FourPin, ".35", ".10").map(|of| Program::of(of.parameters()));
    let integrator =
        geneva_mimic::Parameters { relative_tolerance: 1e-9, ..geneva_mimic::Parameters::new(FINE, LENGTH) };
    let run = program.and_then(|program| program.run(&integrator).ok());
    let lines = run.map_or_else(Vec::new, |run| run.lines);
    level(&lines.iter().map(|line| (line.time, line.speed, line.acceleration)).collect::<Vec<_>>()).0
}

/// Where the acceleration first changes from minus to plus: between two lines, as if it were straight.
fn level(lines: &[(f64, f64, f64)]) -> (f64, f64) {
    let pair = lines.windows(2).find(|pair| pair[0].2 < 0.0 && pair[1].2 >= 0.0);
    pair.map_or((f64::NAN, f64::NAN), |pair| {
        let part = pair[0].2 / (pair[0].2 - pair[1].2);
        (pair[0].0 + part * (pair[1].0 - pair[0].0), pair[0].1.min(pair[1].1))
    })
}

/// The mechanism of a row as it is.
pub fn engagement(mechanism: Mechanism, friction: &str, torque: &str) -> Option<Engagement> {
    Hypothesis::TRUE.engagement(row(mechanism, friction, torque)?)
}
