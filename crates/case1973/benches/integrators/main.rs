//! What accuracy costs: the solver over the angle, two methods of a library in the time, and the program of 1973.
//!
//! Forty-nine escapements start from rest and run for eight steady periods. Each contestant is asked for the driver's
//! speed at 64 times, or for the steady state. They take turns, round by round, so that what else the machine does
//! hits all alike; the best time of a contestant counts. Its true error is the largest relative one of all numbers that
//! it was asked for, against the solver over the angle at its finest.
//!
//! `cargo bench -p geneva-case1973 --bench integrators -- --record book/records/integrators.csv` writes a record.
//! `--rounds N` takes N turns in place of the usual number.

mod line;
mod map;
mod options;
mod others;
mod race;
mod record;
#[path = "../../../dynamics/benches/rows/mod.rs"]
mod rows;
mod time_domain;

use line::RecordLine;
use map::Taken;
use options::BenchOptions;
use race::{Contestant, RaceScore};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// A contestant who is done sooner goes on until the time is over, for the best of several.
const TURN: Duration = Duration::from_millis(25);

/// Tolerance and threads of the maps.
const MAP: ([f64; 2], u32) = ([1e-8, 1e-10], 2);

/// What the command line asks for.
struct Asked {
    rounds: u32,
    rows: usize,
    sides: &'static [u32],
    record: Option<PathBuf>,
}

impl Asked {
    fn new(arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let options = BenchOptions::read(arguments)?;
        // As a test it only shows that it works.
        let usual = if options.is_bench {
            Self { rounds: 7, rows: usize::MAX, sides: &[128, 256, 512], record: None }
        } else {
            Self { rounds: 1, rows: 6, sides: &[8], record: None }
        };
        Ok(Self { rounds: options.rounds.unwrap_or(usual.rounds), record: options.record, ..usual })
    }
}

fn contestants() -> Vec<Contestant> {
    let mut all = Vec::new();
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        all.push(Contestant { name: "angle-steady", tolerance, solve: others::steady, truth: race::steady });
        all.push(Contestant { name: "angle-terminal", tolerance, solve: others::terminal, truth: race::terminal });
        all.push(Contestant { name: "angle-run", tolerance, solve: others::run, truth: race::speeds });
    }
    for tolerance in [1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12] {
        let mut run = |name, solve| all.push(Contestant { name, tolerance, solve, truth: race::speeds });
        run("dopri5", time_domain::dopri5);
        run("dop853", time_domain::dop853);
        run("dopri5-located", time_domain::dopri5_located);
        run("dop853-located", time_domain::dop853_located);
    }
    for tolerance in [5e-5, 5e-6, 5e-7, 5e-8, 5e-9, 5e-10, 1e-10] {
        all.push(Contestant { name: "mimic", tolerance, solve: others::program, truth: race::speeds });
    }
    all
}

fn main() -> ExitCode {
    let outcome = Asked::new(std::env::args().skip(1)).and_then(|asked| run(&asked));
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(asked: &Asked) -> Result<(), String> {
    let rows = race::rows(asked.rows).map_err(|error| error.to_string())?;
    let contestants = contestants();
    let mut best: Vec<Option<RaceScore>> = vec![None; contestants.len()];
    let maps: Vec<_> =
        MAP.0.iter().flat_map(|tolerance| asked.sides.iter().map(move |side| (*side, *tolerance))).collect();
    let mut best_maps: Vec<Option<Taken>> = vec![None; maps.len()];
    for _ in 0..asked.rounds {
        for (contestant, best) in contestants.iter().zip(&mut best) {
            let start = Instant::now();
            loop {
                let result = contestant.race(&rows);
                if best.is_none_or(|best| result.time < best.time) {
                    *best = Some(result);
                }
                if start.elapsed() >= TURN {
                    break;
                }
            }
        }
        for ((side, tolerance), best) in maps.iter().zip(&mut best_maps) {
            let taken = map::map(*side, *tolerance, MAP.1);
            let least = best.unwrap_or(taken);
            let (time, processor) = (taken.time.min(least.time), taken.processor.min(least.processor));
            *best = Some(Taken { time, processor, ..taken });
        }
    }
    let mut lines = Vec::new();
    for (contestant, best) in contestants.iter().zip(&best) {
        let Some(best) = best else { continue };
        lines.push(RecordLine {
            contestant: contestant.name.to_owned(),
            tolerance: contestant.tolerance,
            runs: Some(best.runs),
            evaluations: best.evaluations,
            milliseconds: best.time.as_secs_f64() * 1e3,
            true_error: (best.runs > 0).then_some(best.error),
            ..RecordLine::default()
        });
    }
    for ((_, tolerance), taken) in maps.iter().zip(&best_maps) {
        let Some(taken) = taken else { continue };
        lines.push(RecordLine {
            contestant: "map".to_owned(),
            tolerance: *tolerance,
            milliseconds: taken.time.as_secs_f64() * 1e3,
            points: Some(taken.points),
            threads: Some(MAP.1),
            processor_milliseconds: taken.processor.map(|time| time.as_secs_f64() * 1e3),
            ..RecordLine::default()
        });
    }
    lines.sort_by(|one, other| one.contestant.cmp(&other.contestant));
    print(&lines);
    let mut comments = record::machine();
    comments.push(format!("rows: {}, times: {}, best of {} rounds", rows.len(), race::TIMES, asked.rounds));
    comments.push(format!("truth: the solver over the angle at {:e}", race::REFERENCE));
    comments.iter().for_each(|comment| println!("{comment}"));
    if let Some(path) = &asked.record {
        let lines: Vec<_> = lines.iter().map(|line| line.fields().join(",")).collect();
        let path = record::write(path, &comments, line::COLUMNS, &lines);
        let path = path.map_err(|error| format!("the record cannot be written: {error}"))?;
        println!("written: {}", path.display());
    }
    Ok(())
}

fn print(lines: &[RecordLine]) {
    let all: Vec<_> = std::iter::once(line::COLUMNS.split(',').map(str::to_owned).collect())
        .chain(lines.iter().map(|line| line.fields().to_vec()))
        .collect();
    let width = |column: usize| all.iter().map(|fields: &Vec<String>| fields[column].len()).max().unwrap_or(0);
    let widths: Vec<_> = (0..line::COLUMNS.split(',').count()).map(width).collect();
    for fields in &all {
        let cells: Vec<_> = fields.iter().zip(&widths).map(|(field, width)| format!("{field:>width$}")).collect();
        println!("{}", cells.join("  ").trim_end());
    }
}
