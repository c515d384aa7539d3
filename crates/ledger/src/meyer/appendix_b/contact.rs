//! The equation solved for its highest derivative, and how the program knows the sign of the friction.

use super::program::{self, by_coefficients};
use super::*;
use crate::meyer::letters::factors;
use crate::meyer::reading::{Letters, decide};
use crate::meyer::runs::{self, EXPLAINED, Hypothesis, Reset, Score, deck, scores, within_one};
use crate::meyer::slips::LOST_BARS;
use crate::meyer::spring::no_rate;
use geneva_mimic::language::{Choices, Deck, Layout, Program, deck_named};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

const PROGRAM: Place = at("Appendix B, paragraphs before the program");

pub fn claims() -> Vec<Claim> {
    [solved(), lines(), described(), old_acceleration()].concat()
}

fn solved() -> Vec<Claim> {
    vec![
        at("Appendix B, Eq. (1-19) repeated")
            .equation(
                "meyer.app-b.eq-1-19",
                r"A\ddot{\theta} + B\dot{\theta}^2 + C\theta^2 + D\dot{\theta} = E",
                "the equation of motion",
            )
            .proven_by(factors)
            .read(ClosedForm, holds)
            .corrected(r"A\ddot{\theta} + B\dot{\theta}^2 + |C\dot{\theta}^2 + D\ddot{\theta}| = E", LOST_BARS),
        at("Appendix B, line after Eq. (1-19) repeated")
            .statement(
                "meyer.app-b.cannot-be-solved",
                "cannot be solved",
                "in its present form the equation cannot be solved for the acceleration",
            )
            .by(Vectors, |stated| {
                // What is straight in the acceleration has no second difference.
                let bent = instants().any(|letters| {
                    let square = letters["theta'"] * letters["theta'"];
                    let left = |angular_acceleration: f64| {
                        let between = letters["C"] * square + letters["D"] * angular_acceleration;
                        letters["A"] * angular_acceleration
                            + letters["B"] * square
                            + stated.pick(between.abs(), between)
                    };
                    let step = 4.0 * (1.0 + letters["theta''"].abs());
                    !vanishes((left(step) - 2.0 * left(0.0) + left(-step)) / step)
                });
                Finding::new(
                    bent,
                    "the left side over the acceleration is not one straight line, wherever it was tried",
                )
            })
            .by(ClosedForm, |stated| {
                // One expression for all instants, if there is one: that without a sign.
                let solved = |letters: &Letters| {
                    let square = letters["theta'"] * letters["theta'"];
                    let angular_acceleration =
                        (letters["E"] - (letters["B"] + letters["C"]) * square) / (letters["A"] + letters["D"]);
                    let between = letters["C"] * square + letters["D"] * angular_acceleration;
                    let size = stated.pick(between.abs(), between);
                    letters["A"] * angular_acceleration + letters["B"] * square + size - letters["E"]
                };
                let failing = instants().filter(|letters| !vanishes(solved(letters) / letters["E"].abs().max(1.0)));
                let failing = failing.count();
                Finding::new(failing > 0, format!("solved as if there were no bars, it fails at {failing} instants"))
            })
            .but_not("without its bars it could not be solved either")
            .read_as("as long as its bars stand: they must be opened first, with a sign for each side of the kink"),
    ]
}

/// The two lines of the display of S: an equation and its condition each.
fn cases(tex: &str) -> Option<Vec<(String, String)>> {
    let plain = tex.replace(r"\begin{aligned}", "").replace(r"\end{aligned}", "").replace("&&", "&");
    plain
        .split(r"\\")
        .map(|case| {
            let (equation, condition) = case.split_once(r"\text{if }")?;
            Some((equation.replace('&', ""), condition.replace('&', "")))
        })
        .collect()
}

/// Whether the equation with S is that with bars, if S is what the display gives for F of either sign: s, by which the
/// bars open, times what is given must be one.
fn opens_the_bars(tex: &str) -> Finding {
    let sizes = cases(tex).into_iter().flatten().filter_map(|(equation, condition)| {
        let (name, given) = equation.split_once('=')?;
        let sign = match condition.split_whitespace().collect::<Vec<_>>()[..] {
            ["F", ">", "0"] => "(1)",
            ["F", "<", "0"] => "(-1)",
            _ => return None,
        };
        (name.trim() == "S").then(|| format!("({given}){sign}S"))
    });
    let sizes: Vec<String> = sizes.collect();
    let opened = sizes.iter().map(|size| decide(&characters("meyer.app-b.with-sign").replace('S', size), factors));
    let opened: Vec<Finding> = opened.collect();
    let holds = opened.len() == 2 && sizes[0] != sizes[1] && opened.iter().all(|finding| finding.holds);
    Finding::new(holds, "the next display with the value of each line for S, and the bars opened by its sign")
}

/// How the display of S is read: its two lines, with their conditions.
fn holds_by_cases(tex: &str) -> Option<bool> {
    let cases = cases(tex)?;
    for moment in moments() {
        let side = |formula: &str| Some(reading::value(formula, moment.letters())).filter(|value| value.is_finite());
        let mut met = 0;
        for (equation, condition) in &cases {
            let greater = condition.contains('>');
            let (left, right) = condition.split_once(['>', '<'])?;
            let (left, right) = (side(left)?, side(right)?);
            if (left > right && greater) || (left < right && !greater) {
                met += 1;
                if !reading::holds(equation, [moment])? {
                    return Some(false);
                }
            }
        }
        if met != 1 {
            return Some(false);
        }
    }
    Some(true)
}

fn lines() -> Vec<Claim> {
    vec![
        at("Appendix B, display of F")
            .equation("meyer.app-b.f", r"F = (C\dot{\theta}^2 + D\ddot{\theta})", "what stands between the bars")
            .proven_by(factors)
            .read(ClosedForm, holds),
        at("Appendix B, display of S")
            .equation(
                "meyer.app-b.s",
                r"\begin{aligned} S &= +1 && \text{if } F > 0 \\ S &= -1 && \text{if } F < 0 \end{aligned}",
                "its sign; where F is zero either value will do",
            )
            .decided(opens_the_bars)
            .read(ClosedForm, holds_by_cases),
        at("Appendix B, 1st display after S")
            .equation(
                "meyer.app-b.with-sign",
                r"A\ddot{\theta} + B\dot{\theta}^2 + S(C\dot{\theta}^2 + D\ddot{\theta}) = E",
                "the equation with S for the bars",
            )
            .proven_by(factors)
            .read(ClosedForm, holds),
        at("Appendix B, 2nd display after S")
            .equation(
                "meyer.app-b.expanded",
                r"A\ddot{\theta} + B\dot{\theta}^2 + SC\dot{\theta}^2 + SD\ddot{\theta} = E",
                "the same multiplied out",
            )
            .proven_by(factors)
            .read(ClosedForm, holds),
        at("Appendix B, 3rd display after S")
            .equation("meyer.app-b.collected", r"\ddot{\theta}(A+SD) + \dot{\theta}^2(B+SC) = E", "the same collected")
            .proven_by(factors)
            .read(ClosedForm, holds),
        at("Appendix B, 4th display after S")
            .equation(
                "meyer.app-b.solved",
                r"\ddot{\theta} = \frac{E - (B+SC)\dot{\theta}^2}{A+SD}",
                "the acceleration",
            )
            .proven_by(factors)
            .read(ClosedForm, holds),
    ]
}

fn described() -> Vec<Claim> {
    vec![
        PROGRAM
            .statement(
                "meyer.app-b.actual-program",
                "actual program used",
                "the printed program is the one that was run: its reset is that of the tables",
            )
            .by(Evidence::Quadrature, |stated| {
                let of = |reset: Reset| {
                    let wanted = Hypothesis { reset, ..Hypothesis::WITHOUT_LAG };
                    scores().iter().find(|score| score.hypothesis == wanted).map_or(0, Score::within_one)
                };
                more_cells(of(Reset::QuarterTurn), of(Reset::OfTheMechanism), stated)
            })
            .by(Evidence::Program, |stated| {
                let of = |reset: Reset| {
                    let runs = deck::runs(reset).unwrap_or_default();
                    EXPLAINED.iter().map(|column| within_one(*column, runs)).sum()
                };
                more_cells(of(Reset::QuarterTurn), of(Reset::OfTheMechanism), stated)
            })
            .but_not("what was run resets the angle as each mechanism needs it")
            .read_as("As far as the tables tell: the data cards at its end are not printed."),
        PROGRAM
            .statement(
                "meyer.app-b.first-seven-cards",
                "first seven cards",
                "seven control cards come first, and data cards at the end",
            )
            .missing(
                "The program in the copy has seven lines before its first equation, if five comments are counted as \
                 cards, and ends without data. Whether these are the seven meant is not said, and no data cards are \
                 there",
            ),
        no_rate("meyer.app-b.spring-constant", PROGRAM, "what K is called", "spring constant", "torque of the spring"),
        PROGRAM
            .statement(
                "meyer.app-b.letters",
                "G,H,I,J, and L",
                "the program's letters G to L are the factors of Eq. (1-18), A to E those of Eq. (1-19)",
            )
            .by(ClosedForm, |stated| {
                by_coefficients(|lines, at| {
                    let c = &at.coefficients;
                    let [third, fourth] = stated.pick([c.c, c.d], [c.d, c.c]);
                    [
                        (lines["G"], at.ratio),
                        (lines["H"], at.pose.numerator),
                        (lines["I"], at.pose.cross),
                        (lines["J"], at.pose.shape),
                        (lines["L"], at.pose.square),
                        (lines["A"], c.a),
                        (lines["B"], c.b),
                        (lines["C"], third),
                        (lines["D"], fourth),
                        (lines["E"], c.e),
                    ]
                })
            })
            .by(Vectors, |stated| {
                let said = [program::A, program::B, program::C, program::D, program::E, program::G];
                let said = said.into_iter().chain([program::H, program::I, program::J, program::L]);
                let holds = said.into_iter().all(|line| {
                    let (name, formula) = program::named(line);
                    let exchanged = match name.as_str() {
                        "C" => "D",
                        "D" => "C",
                        other => other,
                    };
                    program::holds(&format!("{} = {formula}", stated.pick(name.as_str(), exchanged))) == Some(true)
                });
                Finding::new(holds, "each line, read and evaluated, against the mechanism by coordinates")
            })
            .but_not("C and D the other way round"),
        PROGRAM
            .statement(
                "meyer.app-b.simultaneous",
                "cannot solve simultaneous equations",
                "F cannot be computed from the same instant's acceleration, which itself depends on F",
            )
            .by(LimitCase, |stated| {
                let stuck = cannot_be_sorted(stated.pick("2DX", "OLD2DX"));
                let left = if stuck.is_empty() { "none".to_owned() } else { stuck.join(", ") };
                Finding::new(
                    !stuck.is_empty(),
                    format!("of the lines sorted by what they need, these are left: {left}"),
                )
            })
            .by(ClosedForm, |stated| {
                // Round the loop: a change of the acceleration that F is made of changes the one that F leads to.
                let loops = instants().any(|letters| {
                    let square = letters["theta'"] * letters["theta'"];
                    let old = letters["theta''"];
                    let led_to = |angular_acceleration: f64| {
                        let between = letters["C"] * square + letters["D"] * stated.pick(angular_acceleration, old);
                        let sign = if between < 0.0 { -1.0 } else { 1.0 };
                        (letters["E"] - (letters["B"] + sign * letters["C"]) * square)
                            / (letters["A"] + sign * letters["D"])
                    };
                    let far = 1.0 + 2.0 * (letters["C"] * square / letters["D"]).abs();
                    !vanishes(led_to(far) - led_to(-far))
                });
                Finding::new(loops, "the acceleration that the lines give depends on the one they were given for F")
            })
            .but_not("it could not be computed from the acceleration of a moment before either")
            .read_as(
                "Statements that are written out one by one are carried out in an order that is found by sorting them. \
                 An implicit function, IMP, is named where such languages are described; whether this one had it is not \
                 known.",
            ),
    ]
}

fn old_acceleration() -> Vec<Claim> {
    vec![
        PROGRAM
            .statement(
                "meyer.app-b.delay",
                "t-DT/10",
                "the old acceleration is that of a tenth of the print interval before",
            )
            .by(OtherPlaceInSource, |stated| {
                let listed = parts_of_the_interval("meyer.listing.delay");
                Finding::new(
                    listed == Some(stated.pick(stated.number(), 1.0)),
                    format!("the listing divides the interval by {}", listed.unwrap_or(f64::NAN)),
                )
            })
            .by(Evidence::RungeKutta, delay_explains)
            .but_not("it is that of a whole print interval before"),
        PROGRAM
            .statement("meyer.app-b.small-time", "SMT", "SMT is true until the time zero and false after it")
            .by(Evidence::Program, |stated| {
                let rest = stated.pick(SMALL_TIME, "FSW(T,TRUE,FALSE,FALSE)");
                let lines = in_force(rest, "NOT(REST)").unwrap_or_default();
                // The lines of the start must be in force at the start, and at no other time.
                let holds = !lines.is_empty() && lines.iter().all(|[time, rest, _]| (*rest == 1.0) == (*time == 0.0));
                Finding::new(holds, "the truth of the deck's own start, printed at each line of a run")
            })
            .by(OtherPlaceInSource, |stated| {
                let said = stated.pick([true, true, false], [true, false, false]);
                Finding::new(
                    listed().any(|truths| truths == said),
                    "the listing's values, in an order that fits S and SMT",
                )
            })
            .but_not("it is true before the time zero only"),
    ]
}

/// What the escapement's deck has for the truth that it is at the start.
pub const SMALL_TIME: &str = "FSW(T,TRUE,TRUE,FALSE)";

/// At each printed line of a run of the escapement's deck, with these expressions for the truths that it is at the start
/// and that it is later: the time, and whether the two are true.
pub fn in_force(rest: &str, moving: &str) -> Option<Vec<[f64; 3]>> {
    let cards = deck_named("escapement")?.lines().map(|card| match card.split_whitespace().next() {
        Some("REST") if card.contains(SMALL_TIME) => format!("         REST   = {rest}"),
        Some("MOVING") if card.contains("NOT(REST)") => format!("         MOVING = {moving}"),
        Some(first) if first.starts_with("HDR(") => "*".to_owned(),
        Some(first) if first.starts_with("OUT(") => "                  OUT(T,REST,MOVING)".to_owned(),
        _ => card.to_owned(),
    });
    let text = cards.collect::<Vec<_>>().join("\n");
    let cards = Deck::read(&text, Layout::of(&text)).ok()?;
    let run = Program::new(&cards).ok()?.run(cards.data_sets().ok()?.first()?, &Choices::default()).ok()?;
    run.rows.into_iter().map(|row| row.try_into().ok()).collect()
}

/// What the listing has SMT be, and S, for one value after another of what decides.
const LISTED: ([f64; 3], [bool; 3]) = ([-1.0, 1.0, 1.0], [true, true, false]);

/// What SMT may be before the time zero, then, and after it, by the listing: FSW picks one of three values by the sign of
/// the first, and S tells in which orders they may stand.
pub fn listed() -> impl Iterator<Item = [bool; 3]> {
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let (signs, truths) = LISTED;
    let fitting = orders.into_iter().filter(move |at| signs[at[0]] < 0.0 && signs[at[2]] > 0.0);
    fitting.map(move |at| at.map(|at| truths[at]))
}

/// Which lines of the motion cannot be put in an order in which each has all it needs, if F is made of this
/// acceleration.
fn cannot_be_sorted(acceleration: &str) -> Vec<String> {
    let between = program::F.replace("OLD2DX", acceleration);
    let said = [program::G, program::H, program::I, program::J, program::L, program::A, program::B, program::C];
    let said = said.into_iter().chain([program::D, program::E, &between, "S = F", program::ACCELERATION]);
    let mut waiting: BTreeMap<String, BTreeSet<String>> =
        said.map(|line| (program::named(line).0, reading::letters_in(program::named(line).1))).collect();
    // Data, what the integrator gives, and the value of a moment before are there from the start.
    loop {
        let names: BTreeSet<String> = waiting.keys().cloned().collect();
        let ready = waiting.iter().find(|(_, needed)| needed.is_disjoint(&names)).map(|(name, _)| name.clone());
        match ready {
            Some(name) => waiting.remove(&name),
            None => return waiting.into_keys().collect(),
        };
    }
}

/// By what a place divides the print interval.
pub fn parts_of_the_interval(id: &str) -> Option<f64> {
    characters(id).split_once("DT/")?.1.trim_end_matches('.').parse().ok()
}

/// By what the listing divides it: so late is the old acceleration.
pub fn delay_parts() -> f64 {
    parts_of_the_interval("meyer.listing.delay").unwrap_or(f64::NAN)
}

/// Whether more cells of the tables come within one unit by the program as printed than by one that is put right.
fn more_cells(as_printed: usize, put_right: usize, stated: Stated) -> Finding {
    let (said, other) = stated.pick((as_printed, put_right), (put_right, as_printed));
    Finding::new(
        said > other,
        format!(
            "{as_printed} cells of Appendix E come within one unit with the printed reset, {put_right} with the other"
        ),
    )
}

/// Whether more cells of the tables come within one unit of their last place with a delay of a tenth of the print
/// interval than with one of all of it, or fewer.
pub fn delay_explains(stated: Stated) -> Finding {
    static FOUND: OnceLock<[usize; 2]> = OnceLock::new();
    let found = FOUND.get_or_init(|| {
        [delay_parts(), 1.0].map(|parts| {
            Score::of(Hypothesis { delay: Some(runs::interval() / parts), ..Hypothesis::WITHOUT_LAG }).within_one()
        })
    });
    let (said, other) = stated.pick((0, 1), (1, 0));
    Finding::new(
        found[said] > found[other],
        format!(
            "{} cells of Appendix E come within one unit with a tenth of the interval, {} with all of it",
            found[0], found[1]
        ),
    )
}
