//! Chapter II to Fig. 8, the abstract, and what the headings of Appendix E say beside their numbers.

use super::general_statements::with;
use super::instants::statement;
use super::runs::{Column, Hypothesis, Mechanism, Row, rows, steps};
use super::*;
use crate::Dimension as Exponents;
use crate::Evidence::{Integration, Steps};
use geneva_dynamics::steady::SteadyState;
use geneva_dynamics::{Parameters, Sign};
use std::sync::OnceLock;

const ABSTRACT: &str = "Abstract, last paragraph";
const LIST: &str = "Chapter II, list of parameters";
const TABLES: &str = "Appendix E, title and headings";

/// The claims of the abstract.
pub fn of_abstract() -> Vec<Claim> {
    vec![
        statement(
            "meyer.abstract.terminal",
            ABSTRACT,
            "the mechanism reaches a terminal velocity",
            "does reach a terminal velocity",
            (Integration, || {
                let worst = steady().iter().map(|(_, state)| state.contraction).fold(0.0, f64::max);
                Finding::new(
                    steady().len() == rows().len() && worst < 1.0,
                    format!(
                        "in all runs, each engagement leaves {worst:.2} or less of a difference \
                            of speeds"
                    ),
                )
            }),
            (Steps, || {
                let holds = Mechanism::ALL.iter().filter_map(|of| stepped(*of)).all(|cycle| {
                    let [first, last] = [cycle.squares.first(), cycle.squares.last()].map(|u| u.copied());
                    first.zip(last).is_some_and(|(first, last)| (last / first - 1.0).abs() < 1e-9)
                });
                Finding::new(holds, "one run of each mechanism, taken in steps from rest, repeats itself")
            }),
        ),
        Claim::statement(
            WORK,
            "meyer.abstract.fifty",
            ABSTRACT,
            "the largest rise time",
            "as much as fifty milliseconds",
            Check::corrected_equation(
                (OtherPlaceInSource, || {
                    let beyond = rows().iter().filter(|row| row.number(Column::Rise) > 0.050).count();
                    Finding::new(beyond == 0, format!("{beyond} of {} rise times are larger", rows().len()))
                }),
                || {
                    let largest = rows().iter().map(|row| row.number(Column::Rise)).fold(0.0, f64::max);
                    Finding::new(
                        libm::round(1000.0 * largest) == 101.0,
                        format!("the largest of Appendix E is {largest} s"),
                    )
                },
                (Integration, || {
                    let slowest = row(Mechanism::SixPin, ".20", ".03");
                    let times = [Hypothesis::BEST, Hypothesis::TRUE]
                        .map(|of| slowest.and_then(|row| of.rise(row)?.until_entry_speed(0.01)).unwrap_or(f64::NAN));
                    Finding::new(
                        times.iter().all(|time| *time > 0.1),
                        format!(
                            "in that run the entry speed is within one per cent after {:.3} s, without the fold of the \
                             program after {:.3} s",
                            times[0], times[1]
                        ),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "as much as one hundred and one milliseconds",
            slip: Slip {
                id: "",
                reason: "Appendix E has eleven rise times above fifty milliseconds; the largest, \
                    with six pins, is 0.101 s.",
                witness: "The equation of motion, solved, takes more than a tenth of a second in that run.",
                origin: Origin::Arithmetic,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
    ]
}

/// The claims of chapter II before Fig. 8.
pub fn of_parameters() -> Vec<Claim> {
    vec![
        statement(
            "meyer.six-parameters",
            "Chapter II, sentence before the list of parameters",
            "the equation of motion with its geometry has six parameters",
            "six parameters",
            (OtherPlaceInSource, || {
                let says = |id: &str, what: &str| claim(id).is_some_and(|claim| claim.printed.contains(what));
                Finding::new(
                    says("meyer.four-parameters", "four") && says("meyer.one-geometric-parameter", "n and θ_0"),
                    "the sentences after the list count four beside n and θ_0",
                )
            }),
            (ExactIdentity, || {
                let Finding { holds, how } = all_proven(&Sign::BOTH.map(geneva_dynamics::similarity::Similarity));
                let shape = ["n", "μ", "I_D/I_f"];
                let scale = ["K/I_f"];
                // θ_0 goes with n, and two quotients are made of three quantities.
                let count = shape.len() + scale.len() + 2;
                Finding::new(
                    holds && count == 6,
                    format!(
                        "of the six, θ_0 goes with n, K/I_f sets the scale of speeds alone, and n, μ and I_D/I_f shape \
                         the motion; {how}"
                    ),
                )
            }),
        ),
        Claim::statement(
            WORK,
            "meyer.parameter.entry-angle",
            LIST,
            "the angle θ_0 is where the pin enters",
            "θ_0 : the angular position of the pin as it enters",
            Check::corrected_equation(
                (LimitCase, || {
                    let positive = ["three", "four", "six"].map(|n| printed(&format!("meyer.app-a.{n}-slots.theta")));
                    let enters = Escapement::all().into_iter().map(|at| -at.driver_half_angle());
                    let holds = positive.iter().zip(enters).all(|(printed, at)| agrees(*printed, at.to_degrees()));
                    Finding::new(holds, "Eq. (1-3) and Appendix A have it positive; a pin enters before the line")
                }),
                || {
                    let holds = Escapement::all().iter().all(|at| {
                        vanishes(Seen::new(at, -at.driver_half_angle()).turning()) && at.driver_half_angle() > 0.0
                    });
                    Finding::new(holds, "−θ_0 is where the follower still rests, and θ_0 = π/m is positive")
                },
                (OtherPlaceInSource, || {
                    let start = claim("meyer.app-d.angles").map_or("", |claim| claim.printed);
                    Finding::new(start.matches('-').count() == 3, "Appendix D enters with three negative angles")
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "θ_0 : the size of the angle of the pin from the line of centres as it enters",
            slip: Slip {
                id: "",
                reason: "In Eq. (1-3) and in Appendix A θ_0 is π/m and positive. The pin enters at −π/m, as Fig. 5 \
                    counts the angle, and so Appendices B and D have it.",
                witness: "Appendix D prints the three angles of entry with a minus sign.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        no_rate(
            "meyer.parameter.spring",
            LIST,
            "K is a constant of the spring that is multiplied by an angle",
            "K: the torsional spring constant of the driving spring",
            "K: the torque of the driving spring",
        ),
        Claim::statement(
            WORK,
            "meyer.inertias-vary",
            "Chapter II, sentence after the estimate of I",
            "the inertias of the runs are near the estimate",
            "did vary somewhat from this figure",
            Check::corrected_equation(
                (OtherPlaceInSource, || {
                    let times = over_estimate();
                    Finding::new(times.iter().all(|x| *x < 2.0), format!("over the estimate: {times:.0?}"))
                }),
                || {
                    let times = over_estimate();
                    let holds = times.first() == Some(&6.0) && times.last() == Some(&100.0);
                    Finding::new(holds, format!("over the estimate: {times:.0?}"))
                },
                (ClosedForm, || {
                    // A disc of the same thickness: its diameter goes with the fourth root of its moment of inertia.
                    let sizes = over_estimate();
                    let inches: Vec<f64> = sizes.iter().map(|times| 0.5 * times.sqrt().sqrt()).collect();
                    let [small, large] = [inches.first(), inches.last()].map(|inch| inch.copied().unwrap_or(f64::NAN));
                    Finding::new(
                        small > 0.5 && large > small,
                        format!(
                            "such discs of the same thickness have diameters of {small:.2} to \
                                {large:.2} inch"
                        ),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "were 6 to 100 times this figure",
            slip: Slip {
                id: "",
                reason: "The runs have 3, 6, 10, 40 and 50 × 10^-6 in lb sec²; the estimate is 0.5 × 10^-6.",
                witness: "Steel discs with these moments of inertia would be 0.8 to 1.6 inch wide, not half an inch.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
    ]
}

/// Whether the printed minimum of a row is that of a motion, to one unit of its last place.
fn is_minimum_of(row: &Row, state: &SteadyState) -> bool {
    (state.minimum.speed - row.number(Column::Minimum)).abs() <= 1.0
}

/// The axis of Fig. 11.
pub fn of_axis() -> Claim {
    no_rate(
        "meyer.fig-11.abscissa",
        "Fig. 11, abscissae",
        "the driving quantity is a spring constant, in inch-pounds per radian",
        "SPRING CONSTANT, IN LB/RAD",
        "TORQUE OF THE SPRING, IN LB",
    )
}

/// What the headings of Appendix E say beside their numbers.
pub fn of_headings() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "meyer.app-e.mechanisms",
            TABLES,
            "the runs with six and with three pins are of the mechanisms named",
            "SUMMARY OF COMPUTER RUNS",
            Check::corrected_equation(
                (Integration, || {
                    let others = steady().iter().filter(|(row, _)| row.mechanism != Mechanism::FourPin);
                    let (all, near) = others.fold((0, 0), |(all, near), (row, state)| {
                        (all + 1, near + usize::from(is_minimum_of(row, state)))
                    });
                    Finding::new(
                        near == all,
                        format!("{near} of {all} minima with six and three pins are the mechanism's, to one unit"),
                    )
                }),
                || {
                    let others = || rows().iter().filter(|row| row.mechanism != Mechanism::FourPin);
                    let near = others().filter(|row| {
                        let state = Hypothesis::BEST.engagement(row).and_then(|of| of.steady_state().ok());
                        state.is_some_and(|state| is_minimum_of(row, &state))
                    });
                    let (near, all) = (near.count(), others().count());
                    Finding::new(near == all, format!("with one fold for all, {near} of {all} are"))
                },
                (Steps, || {
                    let off = [Hypothesis::BEST, Hypothesis::TRUE].map(|of| {
                        let found =
                            [(Mechanism::SixPin, ".03"), (Mechanism::ThreePin, ".08")].map(|(mechanism, torque)| {
                                let row = row(mechanism, ".20", torque)?;
                                let time = of.cycle_by_steps(row)?[1] / of.parameters(row)?.drive().sqrt();
                                Some((time - row.number(Column::Period)).abs())
                            });
                        found.map(|off| off.unwrap_or(f64::INFINITY))
                    });
                    Finding::new(
                        off[0].iter().all(|off| *off <= 1e-3) && off[1].iter().all(|off| *off > 1e-3),
                        format!(
                            "periods by steps differ from the printed ones by {:.1} and {:.1} ms with the fold of 90°, \
                             and by {:.1} and {:.1} ms without",
                            1e3 * off[0][0],
                            1e3 * off[0][1],
                            1e3 * off[1][0],
                            1e3 * off[1][1]
                        ),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "SUMMARY OF COMPUTER RUNS, those for six and three pins with the driver \
                    put back after 90°",
            slip: Slip {
                id: "",
                reason: "The program puts the driver back to the start of an engagement after a quarter turn, \
                    whatever the number of pins; six pins need 60°, three need 120°. None of the peaks printed \
                    for six and three pins is one of the mechanism named.",
                witness: "The periods, computed in steps with the fold of 90°, agree with the tables, and without it \
                    do not.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
        no_rate("meyer.app-e.torque-unit", TABLES, "K is per radian", "K in lb/rad", "K in lb"),
    ]
}

/// A place that calls the torque of the spring a rate.
fn no_rate(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    corrected: &'static str,
) -> Claim {
    let check = Check::corrected_equation(
        (Integration, || {
            // A rate times the angle turned would drive each engagement with more torque than the one before.
            let turned = |engagements: f64| engagements * PI / 2.0;
            let row = row(Mechanism::FourPin, ".20", ".08");
            let period = |engagements| {
                let driven = row.and_then(|row| with(row, turned(engagements), 1.0));
                driven.and_then(|of| Some(of.steady_state().ok()?.period)).unwrap_or(f64::NAN)
            };
            let [first, second] = [1.0, 2.0].map(period);
            Finding::new(
                agrees(first, second),
                format!(
                    "with K times the angle turned, engagements would take {first:.4} s, then {second:.4} s: no one period"
                ),
            )
        }),
        || {
            let inertia = Exponents::FORCE * Exponents::LENGTH * Exponents::TIME * Exponents::TIME;
            let found = inertia * Exponents::ANGULAR_ACCELERATION;
            Finding::new(found == Exponents::FORCE * Exponents::LENGTH, format!("K = I_f E is a {found}"))
        },
        (OtherPlaceInSource, || {
            let torque = claim("meyer.eq-1-15").is_some_and(|claim| claim.printed.ends_with("= K"));
            Finding::new(torque, "Eq. (1-15) sets the torque equal to K")
        }),
    );
    Claim::statement(WORK, id, locator, meaning, printed, check).expecting(Verdict::Corrected).with_erratum(Erratum {
        corrected,
        slip: Slip {
            id: "",
            reason: "The torque of the spring is K itself, not K times an angle.",
            witness: "Eq. (1-15) has no angle.",
            origin: Origin::Concept,
            consequence: Consequence::Conclusion,
            changes: "",
        },
    })
}

/// The inertias of the runs over the estimate, by size.
fn over_estimate() -> Vec<f64> {
    let estimate = printed("meyer.disc.inertia");
    let ids = ["meyer.app-e.4-pin.driver", "meyer.app-e.6-pin.follower", "meyer.app-e.6-pin.driver"];
    let more = ["meyer.app-e.3-pin.follower", "meyer.app-e.4-pin.follower"];
    ids.iter().chain(&more).map(|id| printed(id) / estimate).collect()
}

/// The row of Appendix E with this friction and torque, as printed.
pub fn row(mechanism: Mechanism, friction: &str, torque: &str) -> Option<&'static Row> {
    let is = |row: &&Row| row.printed(Column::Friction) == friction && row.printed(Column::Torque) == torque;
    rows().iter().filter(|row| row.mechanism == mechanism).find(is)
}

/// All rows, each with the steady motion of the mechanism as it is.
pub fn steady() -> &'static [(&'static Row, SteadyState)] {
    static STEADY: OnceLock<Vec<(&Row, SteadyState)>> = OnceLock::new();
    let of = |row| Some((row, Hypothesis::TRUE.engagement(row)?.steady_state().ok()?));
    STEADY.get_or_init(|| rows().iter().filter_map(of).collect())
}

/// An engagement of the steady motion, in equal steps of the driver's angle.
pub struct Stepped {
    pub parameters: Parameters,
    pub angles: Vec<f64>,
    /// Squares of the driver's speed.
    pub squares: Vec<f64>,
    /// The square at the end of the first engagement from rest.
    pub first_end: f64,
}

impl Stepped {
    /// The angle at which a quantity of angle and speed is greatest: by the parabola through its three greatest values.
    pub fn greatest(&self, of: impl Fn(f64, f64) -> f64) -> f64 {
        let values: Vec<_> = self.angles.iter().zip(&self.squares).map(|(angle, u)| of(*angle, u.sqrt())).collect();
        let Some(at) = (0..values.len()).max_by(|a, b| values[*a].total_cmp(&values[*b])) else { return f64::NAN };
        let beside = at.checked_sub(1).and_then(|before| Some((values.get(before)?, values.get(at + 1)?)));
        let shift = beside.map_or(0.0, |(before, after)| (after - before) / (2.0 * values[at] - before - after) / 2.0);
        self.angles[at] + shift * (self.angles[1] - self.angles[0])
    }
}

/// A run of each mechanism by steps, without its fold: six pins .20 and .03, four .35 and .10, three .20 and .08.
pub fn stepped(mechanism: Mechanism) -> Option<&'static Stepped> {
    static STEPPED: OnceLock<Vec<(Mechanism, Option<Stepped>)>> = OnceLock::new();
    let all =
        STEPPED.get_or_init(|| EXAMPLES.map(|(of, friction, torque)| (of, take_steps(of, friction, torque))).into());
    all.iter().find(|(of, _)| *of == mechanism)?.1.as_ref()
}

/// The runs that are taken in steps.
pub const EXAMPLES: [(Mechanism, &str, &str); 3] =
    [(Mechanism::SixPin, ".20", ".03"), (Mechanism::FourPin, ".35", ".10"), (Mechanism::ThreePin, ".20", ".08")];

/// Steps of an engagement, and engagements.
const STEPS: u32 = 900;
const CYCLES: usize = 16;

fn take_steps(mechanism: Mechanism, friction: &str, torque: &str) -> Option<Stepped> {
    let parameters = Hypothesis::TRUE.parameters(row(mechanism, friction, torque)?)?;
    let fold = 2.0 * parameters.slots().engagement_half_angle();
    let angles = steps::angles(&parameters, fold, STEPS);
    let next = |squares: &Vec<f64>| Some(steps::squares(&parameters, &angles, *squares.last()?));
    let first = steps::squares(&parameters, &angles, 0.0);
    let first_end = *first.last()?;
    let squares = std::iter::successors(Some(first), next).nth(CYCLES - 1)?;
    Some(Stepped { parameters, angles, squares, first_end })
}
