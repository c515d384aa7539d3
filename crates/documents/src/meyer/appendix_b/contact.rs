//! The equation solved for its highest derivative, and how the program knows the sign of the friction.

use super::program::{self, by_coefficients};
use super::*;
use crate::meyer::letters::factors;
use crate::meyer::listed::parts_of;
use crate::meyer::reading::{Letters, decide};
use crate::meyer::runs::study::{by_deck, scores};
use crate::meyer::runs::table::{listing, rows};
use crate::meyer::slips::{LOST_BARS, SOLVED_WITH_BARS};
use crate::meyer::spring::constant;
use geneva_case1973::{EXPLAINED, Hypothesis, Reset, Score, within_one};
use geneva_dynamics::Sign;
use geneva_dynamics::equation_proofs::OneFormulaSolution;
use geneva_mimic::language::{CardLayout, Deck, Program, RunOptions, deck_named};

const PROGRAM: Locator = at("Appendix B, paragraphs before the program");

pub(super) fn claims() -> Vec<Claim> {
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
            .read(Evidence::CLOSED_FORM, holds)
            .corrected(r"A\ddot{\theta} + B\dot{\theta}^2 + |C\dot{\theta}^2 + D\ddot{\theta}| = E", LOST_BARS)
            .in_places(5),
        at("Appendix B, line after the repeated Eq. (1-19)")
            .statement(
                "meyer.app-b.cannot-be-solved",
                "cannot be solved",
                "whether the equation, with its bars, can be solved for the acceleration",
            )
            .first_route(Evidence::EXACT_IDENTITY, |stated| {
                let Finding { holds, how, .. } = all_proven(&Sign::BOTH.map(OneFormulaSolution));
                Finding::new(
                    holds == stated.pick(true, false),
                    format!("one formula with bars gives the solution for either sign, because {how}"),
                )
            })
            .second_route(Evidence::VECTORS, |stated| {
                let in_one = |letters: &Letters| {
                    let [a, b, c, d, e] = ["A", "B", "C", "D", "E"].map(|name| letters[name]);
                    let square = letters["theta'"] * letters["theta'"];
                    let size = (a * c * square + d * (e - b * square)).abs();
                    (a * (e - b * square) + c * d * square - size) / (a * a - d * d)
                };
                // Where Newton's laws leave one acceleration.
                let single: Vec<_> = instants().filter(|letters| letters["A"] > letters["D"].abs()).collect();
                let solved = single.iter().filter(|letters| agrees(in_one(letters), letters["theta''"])).count();
                Finding::new(
                    single.len() > 30 && (solved == single.len()) == stated.pick(true, false),
                    format!(
                        "at {solved} of {} instants, one formula gives the acceleration that Newton's laws require",
                        single.len()
                    ),
                )
            })
            .corrected("can be solved in one formula wherever A > |D|", SOLVED_WITH_BARS)
            .interpreted_as(
                "We take “solved” to mean that a formula gives the acceleration in terms of the other letters. The \
                 text then replaces the absolute-value bars by a sign, which it takes from an earlier acceleration. \
                 Whether the computer needed this replacement is the subject of other claims, whose verdict is open.",
            ),
        PROGRAM
            .statement(
                "meyer.app-b.must-be-solved",
                "it must first be solved",
                "the equation must be solved for the acceleration before MIMIC can integrate it",
            )
            .missing(IMPLICIT),
    ]
}

/// Why it is open what a program had to do about the loop of acceleration and sign.
const IMPLICIT: &str = "Languages like MIMIC have an implicit function, IMP, which finds the value that satisfies a \
                        given equation. The thesis says that the computer cannot solve simultaneous equations, but \
                        does not mention IMP, and we do not know whether the MIMIC of 1973 had it. With IMP, the \
                        absolute-value bars can stay, and the friction's sign can come from the same instant. Without \
                        IMP, the lines for acceleration and sign form a loop that cannot be sorted";

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

/// Whether the equation with S is the equation with bars, if S is what the display gives for F of either sign.
///
/// The sign s by which the bars open, times the given value, must be one.
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
    let opened =
        sizes.iter().map(|size| decide(&MEYER.printed_text("meyer.app-b.with-sign").replace('S', size), factors));
    let opened: Vec<Finding> = opened.collect();
    let holds = opened.len() == 2 && sizes[0] != sizes[1] && opened.iter().all(|finding| finding.holds);
    Finding::new(
        holds,
        "for each of the two lines, we gave S the line's value, opened the bars to match and proved the next display",
    )
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
            .equation("meyer.app-b.f", r"F = (C\dot{\theta}^2 + D\ddot{\theta})", "the expression between the bars")
            .proven_by(factors)
            .read(Evidence::CLOSED_FORM, holds),
        at("Appendix B, display of S")
            .equation(
                "meyer.app-b.s",
                r"\begin{aligned} S &= +1 && \text{if } F > 0 \\ S &= -1 && \text{if } F < 0 \end{aligned}",
                "sign of the expression between the bars; where F is zero, either value will do",
            )
            .decided(opens_the_bars)
            .read(Evidence::CLOSED_FORM, holds_by_cases),
        at("Appendix B, 1st display after S")
            .equation(
                "meyer.app-b.with-sign",
                r"A\ddot{\theta} + B\dot{\theta}^2 + S(C\dot{\theta}^2 + D\ddot{\theta}) = E",
                "the equation with S in place of the bars",
            )
            .proven_by(factors)
            .read(Evidence::CLOSED_FORM, holds),
        at("Appendix B, 2nd display after S")
            .equation(
                "meyer.app-b.expanded",
                r"A\ddot{\theta} + B\dot{\theta}^2 + SC\dot{\theta}^2 + SD\ddot{\theta} = E",
                "the equation with S, multiplied out",
            )
            .proven_by(factors)
            .read(Evidence::CLOSED_FORM, holds),
        at("Appendix B, 3rd display after S")
            .equation(
                "meyer.app-b.collected",
                r"\ddot{\theta}(A+SD) + \dot{\theta}^2(B+SC) = E",
                "the equation with S and its terms collected",
            )
            .proven_by(factors)
            .read(Evidence::CLOSED_FORM, holds),
        at("Appendix B, 4th display after S")
            .equation(
                "meyer.app-b.solved",
                r"\ddot{\theta} = \frac{E - (B+SC)\dot{\theta}^2}{A+SD}",
                "the acceleration",
            )
            .proven_by(factors)
            .read(Evidence::CLOSED_FORM, holds),
    ]
}

fn described() -> Vec<Claim> {
    vec![
        PROGRAM
            .statement(
                "meyer.app-b.actual-program",
                "actual program used",
                "the printed program, with its reset, is the program that was run for the tables",
            )
            .first_route(crate::evidence::QUADRATURE, |stated| {
                let of = |reset: Reset| {
                    let wanted = Hypothesis { reset, ..Hypothesis::WITHOUT_LAG };
                    scores().iter().find(|score| score.hypothesis == wanted).map_or(0, Score::within_one)
                };
                more_cells(of(Reset::QuarterTurn), of(Reset::OfTheMechanism), stated)
            })
            .second_route(crate::evidence::PROGRAM, |stated| {
                let of = |reset: Reset| {
                    let runs = by_deck(reset).unwrap_or_default();
                    EXPLAINED.iter().map(|column| within_one(*column, rows(), runs)).sum()
                };
                more_cells(of(Reset::QuarterTurn), of(Reset::OfTheMechanism), stated)
            })
            .but_not("the program that was run resets the angle as each mechanism needs it")
            .interpreted_as(
                "We judge only what the tables can tell, because the data cards at the program's end are not printed.",
            ),
        PROGRAM
            .statement(
                "meyer.app-b.first-seven-cards",
                "first seven cards",
                "seven control cards come first, and data cards come at the end",
            )
            .missing(
                "The program in the copy we had has seven lines before its first equation, if we count five comments, \
                 and it ends without data. The thesis does not say whether these are the seven cards that it \
                 means, and the data cards are missing",
            ),
        constant("meyer.app-b.spring-constant", PROGRAM, "what K is called", "spring constant"),
        PROGRAM
            .statement(
                "meyer.app-b.letters",
                "G,H,I,J, and L",
                "the program's letters G to L are the factors of Eq. (1-18), and its letters A to E are the factors \
                 of Eq. (1-19)",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                by_coefficients(|lines, at| {
                    let c = &at.coefficients;
                    let [third, fourth] = stated.pick([c.c, c.d], [c.d, c.c]);
                    [
                        (lines["G"], at.ratio),
                        (lines["H"], at.pose.numerator),
                        (lines["I"], at.pose.k_sin_theta),
                        (lines["J"], at.pose.one_minus_k_squared),
                        (lines["L"], at.pose.radius_squared),
                        (lines["A"], c.a),
                        (lines["B"], c.b),
                        (lines["C"], third),
                        (lines["D"], fourth),
                        (lines["E"], c.e),
                    ]
                })
            })
            .second_route(Evidence::VECTORS, |stated| {
                let said = [program::A, program::B, program::C, program::D, program::E, program::G];
                let said = said.into_iter().chain([program::H, program::I, program::J, program::L]);
                let holds = said.into_iter().all(|line| {
                    let (name, formula) = program::named(line);
                    let exchanged = match name.as_str() {
                        "C" => "D",
                        "D" => "C",
                        other => other,
                    };
                    program_letters::holds(&format!("{} = {formula}", stated.pick(name.as_str(), exchanged)))
                        == Some(true)
                });
                Finding::new(
                    holds,
                    "we read and evaluated each line and compared it with the mechanism computed in coordinates",
                )
            })
            .but_not("C and D are swapped"),
        PROGRAM
            .statement(
                "meyer.app-b.simultaneous",
                "cannot solve simultaneous equations",
                "F, the expression between the absolute-value bars, cannot be computed from the acceleration at the \
                 same instant, because that acceleration itself depends on F",
            )
            .missing(IMPLICIT),
    ]
}

fn old_acceleration() -> Vec<Claim> {
    vec![
        PROGRAM
            .statement(
                "meyer.app-b.delay",
                "t-DT/10",
                "the old acceleration is the acceleration as it was a tenth of the print interval earlier",
            )
            .missing(
                "The card of the delay, TDL, asks for this acceleration. Whether the program gets it depends on what \
                 the system does when an integration step is longer than the delay, and nothing about that is printed. \
                 In such a step, our system takes the latest value, and in each of the runs this happens in more than \
                 half of the steps. The tables let us distinguish a delay of a tenth of the interval from a delay of \
                 the whole interval, but not from a delay of a twentieth",
            ),
        PROGRAM
            .statement("meyer.app-b.small-time", "SMT", "SMT is true until time zero and false after it")
            .first_route(crate::evidence::PROGRAM, |stated| {
                let rest = stated.pick(SMALL_TIME, "FSW(T,TRUE,FALSE,FALSE)");
                let lines = in_force(rest, "NOT(REST)").unwrap_or_default();
                // The lines of the start must be in force at the start, and at no other time.
                let holds = !lines.is_empty() && lines.iter().all(|[time, rest, _]| (*rest == 1.0) == (*time == 0.0));
                Finding::new(holds, "at each line of a run, we printed whether the deck's start expression is true")
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let said = stated.pick([true, true, false], [true, false, false]);
                Finding::new(
                    listed().any(|truths| truths == said),
                    "we compared the listing's values, taken in an order that fits both S and SMT",
                )
            })
            .but_not("it is true only before time zero"),
    ]
}

/// The escapement's deck's expression for being at the start.
pub(super) const SMALL_TIME: &str = "FSW(T,TRUE,TRUE,FALSE)";

/// The time and two truth values at each printed line of a run of the escapement's deck.
///
/// The expressions tell whether it is the start, and whether it is later.
pub(super) fn in_force(rest: &str, moving: &str) -> Option<Vec<[f64; 3]>> {
    let cards = deck_named("escapement")?.lines().map(|card| match card.split_whitespace().next() {
        Some("REST") if card.contains(SMALL_TIME) => format!("         REST   = {rest}"),
        Some("MOVING") if card.contains("NOT(REST)") => format!("         MOVING = {moving}"),
        Some(first) if first.starts_with("HDR(") => "*".to_owned(),
        Some(first) if first.starts_with("OUT(") => "                  OUT(T,REST,MOVING)".to_owned(),
        _ => card.to_owned(),
    });
    let text = cards.collect::<Vec<_>>().join("\n");
    let cards = Deck::read(&text, CardLayout::detect(&text)).ok()?;
    let run = Program::new(&cards).ok()?.run(cards.data_sets().ok()?.first()?, &RunOptions::default()).ok()?;
    run.rows.into_iter().map(|row| row.try_into().ok()).collect()
}

/// What the listing has SMT be, and S, for one value after another of what decides.
const LISTED: ([f64; 3], [bool; 3]) = ([-1.0, 1.0, 1.0], [true, true, false]);

/// The values that SMT may have before time zero, at it and after it, by the listing.
///
/// FSW picks one of three values by the sign of the first, and S tells in which orders they may stand.
pub(super) fn listed() -> impl Iterator<Item = [bool; 3]> {
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let (signs, truths) = LISTED;
    let fitting = orders.into_iter().filter(move |at| signs[at[0]] < 0.0 && signs[at[2]] > 0.0);
    fitting.map(move |at| at.map(|at| truths[at]))
}

/// The number by which a place divides the print interval.
pub(super) fn parts_of_the_interval(id: &str) -> Option<f64> {
    parts_of(MEYER.printed_text(id))
}

/// Whether more cells of the tables come within one unit by the program as printed than by one that is put right.
fn more_cells(as_printed: usize, put_right: usize, stated: Stated) -> Finding {
    let (said, other) = stated.pick((as_printed, put_right), (put_right, as_printed));
    Finding::new(
        said > other,
        format!(
            "with the printed reset, {as_printed} cells of Appendix E agree to within one unit, and with the other \
             reset, {put_right} cells do"
        ),
    )
}

/// Whether a delay of one part of the print interval gives the acceleration another part before.
///
/// We test it in a run of our deck whose lines, and therefore its steps, are much closer.
pub(super) fn is_late_by(card: f64, said: f64) -> Finding {
    const CLOSER: f64 = 0.00001;
    let lines = || -> Option<Vec<[f64; 3]>> {
        let delay = format!("TDL(ACCEL,{:.9},100.)", listing().interval / card);
        let changed = [
            ("HDR(TIME,TURNED,SPEED,ACCELERATION,FOLLOWER)", "HDR(TIME,NOW,OLD)"),
            ("OUT(T,TURNED,SPEED,ACCEL,FOLLOW)", "OUT(T,ACCEL,BEFORE)"),
            ("TDL(ACCEL,DT/10.,100.)", &delay),
            ("DT     = .0005", "DT     = .00001"),
            ("LENGTH = .2", "LENGTH = .004"),
        ];
        let text = deck_named("escapement")?.to_owned();
        let text = changed.iter().fold(text, |text, (old, new)| text.replace(old, new));
        let cards = Deck::read(&text, CardLayout::detect(&text)).ok()?;
        let run = Program::new(&cards).ok()?.run(cards.data_sets().ok()?.first()?, &RunOptions::default()).ok()?;
        run.rows.into_iter().map(|row| row.try_into().ok()).collect()
    };
    let lines = lines().unwrap_or_default();
    // So many lines before, with a straight line between two of them.
    let late = listing().interval / said / CLOSER;
    if !(late > 0.0 && late < lines.len() as f64) {
        return Finding::new(false, "the run does not go back that far");
    }
    let now = |place: f64| {
        let (whole, part) = (place.floor() as usize, place.fract());
        let [before, behind] = [whole, whole + 1].map(|at| lines.get(at).map_or(f64::NAN, |line| line[1]));
        if part < 1e-6 { before } else { before + part * (behind - before) }
    };
    let (mut misfit, mut moved) = (0.0, 0.0);
    for (at, line) in lines.iter().enumerate().skip(late.ceil() as usize + 10) {
        misfit += (line[2] - now(at as f64 - late)).abs();
        moved += (line[2] - line[1]).abs();
    }
    Finding::new(
        misfit < moved / 20.0,
        format!("the misfit is {:.3} of the whole change of the acceleration during the delay", misfit / moved),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_case1973::deck;

    #[test]
    fn most_steps_of_every_run_are_longer_than_the_delay() {
        let program =
            Program::new(&deck::deck(&deck::listed_settings(&listing())).expect("a deck")).expect("a program");
        for row in rows() {
            let run = program.run(&deck::data(&program, row), &RunOptions::default()).expect("a run");
            let (longer, all) = (run.longer_than_delay, run.work.accepted);
            assert!(2 * longer > all && longer < all, "{}: {longer} of {all}", row.slug());
        }
    }
}
