//! What the program prints: the columns, and the cards that ask for them.

use super::*;
use crate::evidence::PROGRAM;
use crate::meyer::runs::table::{listing, rows};
use geneva_case1973::deck;
use geneva_case1973::{Constants, Hypothesis, Row, weakest};
use geneva_dynamics::steady::PrintedLine;
use geneva_mimic::SolverStats;
use geneva_mimic::language::{CardLayout, Deck, Program, RunOptions, deck_named, print_out};
use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, OnceLock};

pub(super) fn claims() -> Vec<Claim> {
    [columns(), vec![output()]].concat()
}

/// The five columns: what is printed, and what stands above it.
fn columns() -> Vec<Claim> {
    let of = |id: &'static str, printed: &'static str, meaning: &'static str| {
        at("Appendix B, program")
            .statement(id, printed, meaning)
            .first_route(PROGRAM, move |stated| in_all_runs(MEYER.printed_text(id), stated, by_program()))
            .second_route(crate::evidence::QUADRATURE, move |stated| {
                in_all_runs(MEYER.printed_text(id), stated, by_integrals())
            })
            .but_not("the driver's velocity and acceleration are swapped")
    };
    vec![
        of(
            "meyer.listing.heading",
            "TIME,DISPL,VEL,ACCEL,PHIDOT",
            "headings of the columns: time, the driver's displacement, velocity and acceleration, the follower's \
             velocity",
        ),
        of(
            "meyer.listing.printed",
            "T,THETA,1DX,2DX,PHIDOT",
            "the contents of the columns: time, the driver's angle with its two derivatives, the follower's speed",
        ),
    ]
}

/// The five printed quantities of a line, in the order of the columns, and the driver's angle.
type Columns = ([f64; 5], f64);

/// The lines of all rows by the program; none for a row of which there is no run.
fn by_program() -> &'static [Option<Vec<Columns>>] {
    static RUNS: OnceLock<Vec<Option<Vec<Columns>>>> = OnceLock::new();
    let of =
        |line: &PrintedLine| ([line.time, line.turned, line.speed, line.acceleration, line.follower_speed], line.angle);
    let columns = |row: &Row| Some(Hypothesis::AS_RUN.printout(row)?.lines.iter().map(of).collect());
    RUNS.get_or_init(|| rows().iter().map(columns).collect())
}

/// The time of the last line of the first run by the program, if runs end at this time, in s.
pub(super) fn last_line(end: f64) -> Option<f64> {
    let integrator = geneva_mimic::SolverParameters { run_length: end, ..listing().integrator() };
    let lines = Hypothesis::AS_RUN.program(rows().first()?)?.run(&integrator).ok()?.lines;
    lines.last().map(|line| line.time)
}

/// The lines of all rows by the solution over the angle.
fn by_integrals() -> &'static [Option<Vec<Columns>>] {
    static RUNS: OnceLock<Vec<Option<Vec<Columns>>>> = OnceLock::new();
    let of =
        |line: &PrintedLine| ([line.time, line.turned, line.speed, line.acceleration, line.follower_speed], line.angle);
    let run = |row: &Row| {
        let lines = Hypothesis::WITHOUT_LAG.engagement(row)?.run(listing().interval, listing().duration).ok()?;
        Some(lines.iter().map(of).collect())
    };
    RUNS.get_or_init(|| rows().iter().map(run).collect())
}

/// The words for the five printed quantities: in the heading, and in the program.
const WORDS: [[&str; 2]; 5] =
    [["TIME", "T"], ["DISPL", "THETA"], ["VEL", "1DX"], ["ACCEL", "2DX"], ["PHIDOT", "PHIDOT"]];

/// Whether the columns are what words in this order call them, in all runs: one rises by the print interval, of the
/// others one is the rate of another and the third that of the second, by the trapezoids between the lines but for a
/// fifth of all change, and the last is the second by the transmission ratio of the mechanism by coordinates. Where an
/// angle is reset, the acceleration jumps.
fn in_all_runs(words: &str, stated: Stated, runs: &[Option<Vec<Columns>>]) -> Finding {
    let interval = listing().interval;
    let words: Vec<&str> = words.split(',').collect();
    let place = |quantity: usize| words.iter().position(|word| WORDS[quantity].contains(word));
    let named = |row: &Row, line: &Columns| {
        let [time, turned, speed, acceleration, follower] =
            [0, 1, 2, 3, 4].map(|k| place(k).map_or(f64::NAN, |at| line.0[at]));
        let [speed, acceleration] = stated.pick([speed, acceleration], [acceleration, speed]);
        let ratio = PinKinematics::new(&row.mechanism, line.1).angular_velocity() / DRIVER.0;
        ([time, turned, speed, acceleration], follower - ratio * speed)
    };
    let holds = |(row, run): (&Row, &Option<Vec<Columns>>)| {
        let lines: Vec<_> = run.as_ref()?.iter().map(|line| named(row, line)).collect();
        let steps = |of: usize| lines.windows(2).map(move |pair| (pair[1].0[of] - pair[0].0[of], pair));
        let is_rate = |of: usize| {
            let (mut changed, mut missed) = (0.0, 0.0);
            for (change, pair) in steps(of) {
                changed += change.abs();
                missed += (change - interval * (pair[0].0[of + 1] + pair[1].0[of + 1]) / 2.0).abs();
            }
            missed < changed / 5.0
        };
        let even = steps(0).all(|(step, _)| agrees(step, interval));
        Some(even && is_rate(1) && is_rate(2) && lines.iter().all(|line| line.1.abs() < 1e-3 * (1.0 + line.0[2].abs())))
    };
    Finding::for_all(
        rows().iter().zip(runs),
        |of| holds(of) == Some(true),
        |found, all| format!("the columns contain what their headings say in {found} of {all} runs"),
    )
}

/// The cards after FIN.
fn output() -> Claim {
    at("Appendix B, paragraphs after the program")
        .statement(
            "meyer.app-b.output-cards",
            "remainder of the cards",
            "the cards after FIN print and plot, and they take no part in computing the motion",
        )
        .first_route(PROGRAM, |stated| {
            let kinds = stated.pick(&OUTPUT[..], &["FIN"]).to_vec();
            Finding::for_all(
                kinds,
                |kind| prints_alone(kind) == Some(true),
                |found, all| {
                    format!(
                        "for {found} of {all} kinds of cards, a deck without them prints something else but takes the \
                         same steps"
                    )
                },
            )
        })
        .second_route(Evidence::LIMIT_CASE, |stated| {
            // The program translated by hand has none of these cards; it has the numbers of FIN.
            let length = listing().duration * stated.pick(1.0, 0.5);
            let translated = |row: &Row| {
                let integrator = geneva_mimic::SolverParameters { run_length: length, ..listing().integrator() };
                Hypothesis { constants: Constants::Exact, ..Hypothesis::AS_RUN }.program(row)?.run(&integrator).ok()
            };
            let same = |(row, by_deck): (&Row, &Option<Vec<Vec<f64>>>)| {
                by_deck.as_ref().zip(translated(row)).is_some_and(|(rows, translated)| {
                    let near =
                        |(of, line): (&Vec<f64>, &PrintedLine)| (of[2] - line.speed).abs() < 1e-6 * (1.0 + line.speed);
                    let lines = translated.lines;
                    rows.len() == lines.len() && rows.iter().zip(&lines).all(near)
                })
            };
            Finding::for_all(weakest(rows()).zip(by_deck()), same, |same, all| {
                format!("translated without them, the program prints the same speeds in {same} of {all} runs")
            })
        })
        .but_not("the FIN card takes no part in it either")
        .interpreted_as("END, the last of these cards, is not a command, because it only ends the deck.")
}

/// What the deck prints for the runs with the weakest springs, with the program's reset angle; none where it comes to no
/// end. Run once.
fn by_deck() -> &'static [Option<Vec<Vec<f64>>>] {
    static RUNS: OnceLock<Vec<Option<Vec<Vec<f64>>>>> = OnceLock::new();
    let run = |row: &Row| {
        let angle = Hypothesis::AS_RUN.angle(row);
        let program = Program::new(&deck::deck(&[(deck::AS_LISTED[0], angle)])?).ok()?;
        Some(program.run(&deck::data(&program, row), &RunOptions::default()).ok()?.rows)
    };
    RUNS.get_or_init(|| weakest(rows()).map(run).collect())
}

/// The kinds of cards after FIN.
const OUTPUT: [&str; 5] = ["HDR", "OUT", "PLO", "SCA", "ZER"];

/// Whether a deck prints something else but takes the same steps without the cards of a kind and the cards that belong
/// to them. FIN, without which no run would end, is put off instead.
fn prints_alone(kind: &'static str) -> Option<bool> {
    static FOUND: LazyLock<Mutex<HashMap<&str, Option<bool>>>> = LazyLock::new(Mutex::default);
    if let Some(found) = FOUND.lock().ok()?.get(kind) {
        return *found;
    }
    let found = prints_otherwise_without(kind);
    FOUND.lock().ok()?.insert(kind, found);
    found
}

fn prints_otherwise_without(kind: &str) -> Option<bool> {
    static WHOLE: OnceLock<Option<(SolverStats, String)>> = OnceLock::new();
    let text = deck_named("escapement")?;
    let plot = text.lines().find(|line| line.contains("PLO("))?;
    let scaled = text
        .replace(plot, &[plot, "                  SCA(.002,2.5,2.5)", "                  ZER(0.,0.,-100.)"].join("\n"));
    let run = |text: &str| {
        let deck = Deck::read(text, CardLayout::detect(text)).ok()?;
        let program = Program::new(&deck).ok()?;
        let run = program.run(deck.data_sets().ok()?.first()?, &RunOptions::default()).ok()?;
        Some((run.work, print_out(&run, "")))
    };
    let belongs = |line: &str| {
        let with_it: &[&str] = match kind {
            "OUT" => &["HDR("],
            "PLO" => &["SCA(", "ZER("],
            _ => &[],
        };
        line.contains(&format!("{kind}(")) || with_it.iter().any(|card| line.contains(card))
    };
    let without = scaled.lines().map(|line| match line {
        _ if !belongs(line) => line,
        _ if kind == "FIN" => "                  FIN(T,2.*LENGTH)",
        _ => "*",
    });
    let without: Vec<&str> = without.collect();
    let (steps, print) = WHOLE.get_or_init(|| run(&scaled)).as_ref()?;
    let (other_steps, other_print) = run(&without.join("\n"))?;
    Some(*steps == other_steps && *print != other_print)
}
