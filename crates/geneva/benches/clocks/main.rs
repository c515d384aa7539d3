//! The clocks that people feel: from a command to its last line, and from a reader's hand on a live figure to its answer.
//!
//! Each command is a process of its own, its start included, because within one process the verdicts are derived once
//! and kept. The clocks take turns, round by round, so that what else the machine does hits all alike. The best time of each
//! counts, and is printed beside the one on record.
//!
//! `cargo bench -p geneva --bench clocks -- --record book/records/clocks.csv` writes a record.
//! `--rounds N` takes N turns in place of the usual number.

#[path = "../../../case1973/benches/integrators/options.rs"]
mod options;
#[path = "../../../case1973/benches/integrators/record.rs"]
mod record;

use options::BenchOptions;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// Where the record is, from the project's root.
const RECORD: &str = "book/records/clocks.csv";

/// The columns. See `book/records/README.md`.
const COLUMNS: &str = "clock,milliseconds,processor_milliseconds";

/// An answer of a live figure is asked for until this time is over.
const TURN: Duration = Duration::from_millis(100);

/// The commands, as they are typed.
const COMMANDS: [&str; 17] = [
    "--help",
    "claims --format json",
    "claims --format json --source pin",
    "claims --format json --source quick-return",
    "claims --format json --source jazar",
    "claims --format json --source meyer",
    "claims --format json --source wild",
    "errata",
    "coverage --source pin",
    "wheel --stations 6 --rpm 360",
    "wheel --stations 6 --crank-radius 25 --format dxf",
    "wheel --stations 6 --crank-radius 25 --thickness 8 --format stl",
    "quick-return --ground 3 --crank 1 --crank-angle 40 --rpm 60",
    "escapement --slots 4 --friction 0.2 --torque 1 --driver-inertia 1 --follower-inertia 8",
    "sweep --slots 4 --friction 0.1:0.3:21 --inertia-ratio 0.5",
    "mimic run predators",
    "book build",
];

/// The figures that a reader moves, each with the question that its page asks after one step of a control. Sizes and rows are
/// of no source.
const QUESTIONS: [&str; 5] = [
    "wheel?stations=6&crank=-20",
    "design?stations=6",
    "polygon?ground=0.31&radius=0.13&speed=7&unit=m&crank=40",
    "escapement?follower=0.00013",
    "mistake?rows=4,0.17,0.31,151,43,0.0231;6,0.11,0.41,87,61,0.0113;3,0.19,0.17,93,11,0.0517&\
     inertias=6,1.1e-5,1.3e-4;4,1.7e-5,1.3e-4;3,1.9e-5,1.7e-4&headed=6,2.1e-4,1.1e-5&units=1,1,0.001&duration=0.2&\
     delay=0.00005&pi=3.15",
];

/// What the command line asks for.
struct Asked {
    rounds: u32,
    commands: &'static [&'static str],
    record: Option<PathBuf>,
}

/// How long a clock took: by the wall, and on the processors where the system tells.
#[derive(Clone, Copy)]
struct Taken {
    time: Duration,
    processor: Option<Duration>,
}

impl Taken {
    /// The shorter of both, of each time for itself.
    fn or_less(self, other: Option<Self>) -> Self {
        let other = other.unwrap_or(self);
        Self { time: self.time.min(other.time), processor: self.processor.min(other.processor) }
    }
}

impl Asked {
    fn new(arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let options = BenchOptions::read(arguments)?;
        // As a test it only shows that each line is answered. The book comes last and has tests of its own.
        let usual = if options.is_bench {
            Self { rounds: 5, commands: &COMMANDS, record: None }
        } else {
            Self { rounds: 1, commands: &COMMANDS[..COMMANDS.len() - 1], record: None }
        };
        Ok(Self { rounds: options.rounds.unwrap_or(usual.rounds), record: options.record, ..usual })
    }
}

fn main() -> ExitCode {
    match Asked::new(std::env::args().skip(1)).and_then(|asked| run(&asked)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(asked: &Asked) -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut best: Vec<(String, Option<Taken>)> = Vec::new();
    best.extend(asked.commands.iter().map(|line| (format!("geneva {line}"), None)));
    best.extend(QUESTIONS.iter().map(|question| {
        let name = question.split('?').next().unwrap_or(question);
        (format!("live figure {name}"), None)
    }));
    for _ in 0..asked.rounds {
        let commands = asked.commands.iter().map(|line| command(line, folder.path()));
        let answers = QUESTIONS.iter().map(|question| live(question));
        for (taken, (_, best)) in commands.chain(answers).zip(&mut best) {
            *best = Some(taken?.or_less(*best));
        }
    }
    let taken: Vec<_> = best.into_iter().filter_map(|(clock, taken)| Some((clock, taken?))).collect();
    print(&taken);
    let mut comments = record::machine();
    comments.push(format!("best of {} rounds", asked.rounds));
    comments.iter().for_each(|comment| println!("{comment}"));
    if let Some(path) = &asked.record {
        let path = record::write(path, &comments, COLUMNS, &lines(&taken));
        let path = path.map_err(|error| format!("the record cannot be written: {error}"))?;
        println!("written: {}", path.display());
    }
    Ok(())
}

/// Runs a command to its end. A book goes into the folder, where no reader has it open.
fn command(line: &str, folder: &Path) -> Result<Taken, String> {
    let mut program = Command::new(env!("CARGO_BIN_EXE_geneva"));
    program.args(line.split(' ')).stdout(Stdio::null()).stderr(Stdio::null());
    program.current_dir(root());
    if line == "book build" {
        program.arg("--output").arg(folder.join("book"));
    }
    let (before, start) = (of_children(), Instant::now());
    let status = program.status().map_err(|error| format!("geneva {line}: {error}"))?;
    let time = start.elapsed();
    if !status.success() {
        return Err(format!("geneva {line}: {status}"));
    }
    Ok(Taken { time, processor: of_children().zip(before).and_then(|(after, before)| after.checked_sub(before)) })
}

/// Asks a live figure, again and again for a while, as compiled for this machine; the best time counts.
fn live(question: &str) -> Result<Taken, String> {
    let (mut best, begin) = (None, Instant::now());
    while best.is_none() || begin.elapsed() < TURN {
        let start = Instant::now();
        let answer = black_box(geneva_live::answer(black_box(question)));
        best = Some(Taken { time: start.elapsed(), processor: None }.or_less(best));
        if answer.starts_with("{\"error\"") {
            return Err(format!("{question}: {answer}"));
        }
    }
    best.ok_or_else(|| format!("{question}: not asked"))
}

/// How long all children that have ended were on a processor, by Linux, which tells it in hundredths of a second.
fn of_children() -> Option<Duration> {
    let text = fs::read_to_string("/proc/self/stat").ok()?;
    // The name of the program is in brackets and may have spaces; the times are the 14th and 15th fields behind it.
    let fields: Vec<_> = text.rsplit_once(") ")?.1.split(' ').collect();
    let ticks = |place: usize| fields.get(place)?.parse::<u64>().ok();
    Some(Duration::from_millis(10 * (ticks(13)? + ticks(14)?)))
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn milliseconds(time: Duration) -> String {
    format!("{:.3}", time.as_secs_f64() * 1e3)
}

fn lines(taken: &[(String, Taken)]) -> Vec<String> {
    let processor = |taken: &Taken| taken.processor.map_or_else(String::new, milliseconds);
    taken.iter().map(|(clock, own)| format!("{clock},{},{}", milliseconds(own.time), processor(own))).collect()
}

/// Prints each clock with its time, the time on record, and the ratio of the two. On another machine all ratios are off
/// by about the same factor, so the one to look at is the one that differs from the others.
fn print(taken: &[(String, Taken)]) {
    let record = fs::read_to_string(root().join(RECORD)).unwrap_or_default();
    let on_record = |clock: &str| {
        let line = record.lines().find(|line| line.split(',').next() == Some(clock))?;
        line.split(',').nth(1)?.parse::<f64>().ok()
    };
    println!("{:64} {:>12} {:>12} {:>12} {:>6}", "clock", "ms", "processor ms", "on record", "ratio");
    for (clock, own) in taken {
        let [record, ratio] = on_record(clock).map_or(["none".to_owned(), String::new()], |record| {
            [format!("{record:.3}"), format!("{:.2}", own.time.as_secs_f64() * 1e3 / record)]
        });
        let processor = own.processor.map_or_else(String::new, milliseconds);
        println!("{clock:64} {:>12} {processor:>12} {record:>12} {ratio:>6}", milliseconds(own.time));
    }
}
