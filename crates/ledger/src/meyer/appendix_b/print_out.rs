//! What the program prints: the columns, and the cards that ask for them.

use super::*;
use crate::Evidence::Program as ByProgram;
use crate::meyer::runs::choice::weakest;
use crate::meyer::runs::{Constants, Hypothesis, Row, deck, duration, interval, usual};
use geneva_dynamics::program::Line;
use geneva_mimic::language::{Choices, Deck, Layout, Program, deck_named, print_out};

pub fn claims() -> Vec<Claim> {
    vec![columns(), output()]
}

/// The five columns.
fn columns() -> Claim {
    at("Appendix B, program")
        .statement(
            "meyer.listing.heading",
            "TIME,DISPL,VEL,ACCEL,PHIDOT",
            "headings of the columns: time, the driver's displacement, velocity and acceleration, the follower's \
             velocity",
        )
        .by(ByProgram, |stated| {
            rates(stated, |row| {
                let lines = Hypothesis::as_run().program(row)?.run(&usual()).ok()?.lines;
                Some(lines.iter().map(|line| [line.time, line.turned, line.speed, line.acceleration]).collect())
            })
        })
        .by(Evidence::Quadrature, |stated| {
            rates(stated, |row| {
                let lines = Hypothesis::WITHOUT_LAG.engagement(row)?.run(interval(), duration()).ok()?;
                Some(lines.iter().map(|line| [line.time, line.turned, line.speed, line.acceleration]).collect())
            })
        })
        .but_not("velocity and acceleration the other way round")
}

/// Whether the third printed quantity is the rate of the second, and the fourth that of the third: the trapezoids between
/// the lines of a run give the changes, but for a tenth of all change. Where an angle is reset, the acceleration jumps.
fn rates(stated: Stated, run: impl Fn(&Row) -> Option<Vec<[f64; 4]>>) -> Finding {
    let holds = |lines: Vec<[f64; 4]>| {
        let [first, second, third] = stated.pick([1, 2, 3], [1, 3, 2]);
        [[first, second], [second, third]].iter().all(|[of, rate]| {
            let (mut changed, mut missed) = (0.0, 0.0);
            for pair in lines.windows(2) {
                let change = pair[1][*of] - pair[0][*of];
                changed += change.abs();
                missed += (change - (pair[1][0] - pair[0][0]) * (pair[0][*rate] + pair[1][*rate]) / 2.0).abs();
            }
            missed < changed / 10.0
        })
    };
    let (found, all) = (weakest().filter(|row| run(row).is_some_and(holds)).count(), weakest().count());
    Finding::new(found == all, format!("each column is the rate of the one before in {found} of {all} runs"))
}

/// The cards behind FIN.
fn output() -> Claim {
    at("Appendix B, paragraphs after the program")
        .statement(
            "meyer.app-b.output-cards",
            "remainder of the cards",
            "the cards behind FIN print and plot: they take no part in the motion",
        )
        .by(ByProgram, |stated| {
            let kinds = [&OUTPUT[..], stated.pick(&[], &["FIN"])].concat();
            let of_output = kinds.iter().filter(|kind| prints_alone(kind) == Some(true)).count();
            Finding::new(
                of_output == kinds.len(),
                format!(
                    "a deck without the cards of one kind prints otherwise and takes the same steps: {of_output} of {} \
                     kinds",
                    kinds.len()
                ),
            )
        })
        .by(LimitCase, |stated| {
            // The program translated by hand has none of these cards; it has the numbers of FIN.
            let length = duration() * stated.pick(1.0, 0.5);
            let translated = |row: &Row| {
                let integrator = geneva_mimic::Parameters { run_length: length, ..usual() };
                Hypothesis { constants: Constants::Exact, ..Hypothesis::as_run() }.program(row)?.run(&integrator).ok()
            };
            let same = weakest().filter(|row| {
                let angle = Hypothesis::as_run().angle(row.mechanism);
                let by_deck = deck::deck(&[(deck::AS_LISTED[0].0, angle)]).and_then(|cards| {
                    let program = Program::new(&cards).ok()?;
                    program.run(&deck::data(&program, row), &Choices::default()).ok()
                });
                by_deck.zip(translated(row)).is_some_and(|(by_deck, translated)| {
                    let near = |(of, line): (&Vec<f64>, &Line)| (of[2] - line.speed).abs() < 1e-6 * (1.0 + line.speed);
                    let (rows, lines) = (by_deck.rows, translated.lines);
                    rows.len() == lines.len() && rows.iter().zip(&lines).all(near)
                })
            });
            let (same, all) = (same.count(), weakest().count());
            Finding::new(
                same == all,
                format!("a translation without them prints the same speeds in {same} of {all} runs"),
            )
        })
        .but_not("the FIN card as well")
        .read_as("END, the last of them, commands nothing: it ends the deck.")
}

/// The kinds of cards behind FIN.
const OUTPUT: [&str; 5] = ["HDR", "OUT", "PLO", "SCA", "ZER"];

/// Whether a deck prints otherwise and takes the same steps if it has no cards of a kind, nor those that belong to them.
/// FIN, without which no run would end, is put off instead.
fn prints_alone(kind: &str) -> Option<bool> {
    let text = deck_named("escapement")?;
    let plot = text.lines().find(|line| line.contains("PLO("))?;
    let scaled = text
        .replace(plot, &[plot, "                  SCA(.002,2.5,2.5)", "                  ZER(0.,0.,-100.)"].join("\n"));
    let run = |text: &str| {
        let deck = Deck::read(text, Layout::of(text)).ok()?;
        let program = Program::new(&deck).ok()?;
        let run = program.run(deck.data_sets().ok()?.first()?, &Choices::default()).ok()?;
        Some((run.work, print_out(&run, "")))
    };
    let belongs = |line: &str| {
        let own = line.contains(&format!("{kind}("));
        own || (kind == "PLO" && ["SCA(", "ZER("].iter().any(|card| line.contains(card)))
    };
    let without = scaled.lines().map(|line| match line {
        _ if !belongs(line) => line,
        _ if kind == "FIN" => "                  FIN(T,2.*LENGTH)",
        _ => "*",
    });
    let without: Vec<&str> = without.collect();
    let [(steps, print), (other_steps, other_print)] = [run(&scaled)?, run(&without.join("\n"))?];
    Some(steps == other_steps && print != other_print)
}
