//! The command line `geneva`: argument parsing and printing, nothing else.
//!
//! Every command turns its arguments into text. What the text says of a mechanism comes from `ask`, of claims from the
//! ledger, of a deck from the language, of a text from the proofreader, and the book from the press. Exit codes: 0 everything
//! matches the record, 1 something differs, 2 bad usage, bad input or no access. Here is the list of the commands, with their
//! examples; the options of each are in its own file.
//!
//! The program is [`main`]. It is a library too, so that a test can ask thousands of lines with [`answer`] without starting
//! a process for each.

mod book;
mod check;
mod claims;
mod completions;
mod coverage;
mod destination;
mod differing;
mod ebook;
mod errata;
mod escapement;
mod fields;
#[cfg(test)]
mod fuzz;
mod input;
mod mimic;
mod new;
mod number_pages;
mod output;
mod pin;
mod preprocess;
mod print;
mod printable;
mod progress;
mod proofread;
mod quick_return;
mod record;
mod signals;
mod summary;
mod sweep;
mod threads;
mod typed;
mod version;
mod wheel;
mod wheel_check;
mod workspace;

use clap::error::{ContextKind, ContextValue};
use clap::{CommandFactory, Parser, Subcommand};
use output::{Outcome, OutputStreams, ProcessStreams, TextLayout};
use printable::{escape_and_shorten, escaped};
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the program with the arguments and the streams of this process.
pub fn main() -> ExitCode {
    respond(std::env::args_os(), &mut ProcessStreams).into()
}

/// The answer to a command line where nothing is a terminal: what the process would write, and its exit code.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CommandOutput {
    /// What goes to standard output, without colours. The rows of a sweep are not here: they are written as they come.
    pub stdout: String,
    /// What goes to standard error, without colours.
    pub stderr: String,
    /// The exit code: 0 everything matches the record, 1 something differs, 2 bad usage, bad input or no access.
    pub code: u8,
}

/// Runs a command line, the program's name first, and keeps what it says.
///
/// Files are read and written, and the environment counts, as for the program.
pub fn answer(line: impl IntoIterator<Item = OsString>) -> CommandOutput {
    let mut answer = CommandOutput::default();
    answer.code = respond(line, &mut answer).code();
    answer
}

/// Whether the program understands a command line, the program's name first. Nothing that it asks for is done.
///
/// # Errors
///
/// What the program would say of it.
pub fn check(line: impl IntoIterator<Item = OsString>) -> Result<(), String> {
    match parse(line) {
        Err(error) if error.use_stderr() => Err(error.to_string()),
        _ => Ok(()),
    }
}

/// Checks every claim of the sources, derives its verdict, and builds the book.
///
/// Without a command: checks all claims, reports what no longer matches the record, builds the book and says where it is.
#[derive(Debug, Parser)]
#[command(
    name = "geneva",
    version,
    max_term_width = 100,
    after_help = "\
Examples:
  geneva                                       check all claims and build the book
  geneva claims --source pin --format json     the claims of one source as JSON
  geneva errata                                the mistakes in the sources
  geneva coverage --source pin                 the claims on each line of a source
  geneva wheel --stations 6 --rpm 360          sizes, times and peaks of your own wheel
  geneva pin --crank-radius 40 --stations 6 --angle -20 --rad-s 8 --steps
                                               your own pin in a slot, with the steps of the solution
  geneva quick-return --ground 0.3 --crank 0.1 --crank-angle 75 --rpm 60
                                               your own quick-return mechanism, at one instant
  geneva escapement --slots 4 --friction 0.3 --torque 2 --driver-inertia 1 --follower-inertia 15
                                               your own Geneva escapement: how fast it runs
  geneva sweep --slots 4 --friction 0.1:0.4:7 --inertia-ratio 0.1:1:10 --output sweep.csv
                                               many escapements, one row each
  geneva mimic run predators                   run a deck of cards in the language of 1973
  geneva proofread notes.tex chapters/         recompute every chain of numbers in texts of yours
  geneva check examples/paper                  compare the numbers of a paper with computed values
  geneva new my-check --from notes.md          make a crate that checks a document of yours
  geneva book --open                           build the book and open it
  geneva completions bash                      shell completions for bash

Exit codes: 0 everything matches the record, 1 something differs, 2 bad usage, bad input or no access."
)]
struct Arguments {
    /// What to do; without it, check all claims and build the book.
    #[command(subcommand)]
    command: Option<Command>,
}

/// The commands.
#[derive(Debug, Subcommand)]
enum Command {
    /// List the claims: what is printed, what we compute, and the verdict
    #[command(after_help = "\
Examples:
  geneva claims --source pin
  geneva claims --verdict wrong
  geneva claims pin.radius
  geneva claims pin.radius --printed 37.2
  geneva claims --format json --output claims.json")]
    Claims(claims::ClaimsArguments),
    /// List the mistakes in the sources, most serious first, each with its correction, reason and witness
    #[command(after_help = "\
Examples:
  geneva errata
  geneva errata --consequence result
  geneva errata --source jazar --all
  geneva errata --format markdown --output errata.md")]
    Errata(errata::ErrataArguments),
    /// Show the claims on each line of a source, or compare the numbers in your copy of it with ours
    #[command(after_help = "\
Examples:
  geneva coverage
  geneva coverage --source pin --against my-copy.txt
  geneva coverage --source pin --record my-copy.txt > pin.inventory

With --against, the exit code is 1 if the numbers on some line of your copy differ from the ledger's. With --record, a \
line keeps its claims and exceptions if its numbers haven't changed; you fill in the rest by hand.")]
    Coverage(coverage::CoverageArguments),
    /// Compute or draw a Geneva wheel: sizes, times, motion and loads
    #[command(after_help = "\
Examples:
  geneva wheel --stations 6 --rpm 360 --crank-radius 50
  geneva wheel --stations 6 --rpm 360 --crank-radius 50 --inertia 0.002 --friction-torque 0.3
  geneva wheel --stations 8 --centre-distance 100 --pin-diameter 8 --play 0.05 --wheel-shaft 20
  geneva wheel --stations 5 --type internal --rpm 60 --at -90 --at 30
  geneva wheel --stations 4 --pins 2 --format json
  geneva wheel --stations 6 --rpm 60 --format fields --output numbers.csv
  geneva wheel --stations 6 --rpm 60 --format csv --output cycle.csv
  geneva wheel --stations 6 --format svg --output wheel.svg
  geneva wheel --stations 6 --crank-radius 50 --format dxf --output wheel.dxf
  geneva wheel --stations 6 --crank-radius 50 --thickness 8 --format stl --output wheel.stl
  geneva wheel --stations 6 --type internal --crank-radius 40 --thickness 6 --out ring
  geneva wheel --index-time 0.4 --dwell-time 1
  geneva wheel --stations 6 --index-time 0.4 --table-mass 2 --table-diameter 300 --out wheel
  geneva wheel check --stations 6 --centre-distance 50.4 --crank-radius 25 --outside-diameter 87.1

Lengths are in millimetres, or with a unit: 0.5in, 1/8in, 1-1/2in, 2cm. With --unit in, the sheet has inches, too. An option that would have no effect is \
refused, and the message says what to add.")]
    Wheel(Box<wheel::WheelArguments>),
    /// Solve a pin in a slot at one instant: how fast the wheel turns and the pin slides, with every step
    #[command(after_help = "\
Examples:
  geneva pin --crank-radius 40 --stations 6 --angle -20 --rad-s 8
  geneva pin --crank-radius 2 --centre-distance 4 --unit in --angle-from-extension 160 --rpm 90 --steps
  geneva pin --crank-radius 40 --stations 6 --angle -20 --rad-s 8 --format json

The pin on the driver slides in a slot of the wheel, which turns against the driver. Angles are counted in the driver's \
sense.")]
    Pin(pin::PinArguments),
    /// Compute or draw a quick-return mechanism: velocities and accelerations at one instant
    #[command(after_help = "\
Examples:
  geneva quick-return --ground 0.3 --crank 0.1 --crank-angle 75 --rpm 60
  geneva quick-return --ground 0.3 --crank 0.1 --lever-angle -10 --branch near --rpm 60
  geneva quick-return --ground 0.1 --crank 0.3 --crank-angle 75 --rpm -60 --format json
  geneva quick-return --ground 300 --crank 100 --unit mm --lever-angle 15 --rad-s 6 --steps
  geneva quick-return --ground 0.3 --crank 0.1 --crank-angle 75 --rpm 60 \\
                      --format svg --output drawing.svg

The pin on the crank slides in the slot of the lever, which turns about its pivot.")]
    QuickReturn(quick_return::QuickReturnArguments),
    /// Compute or draw a Geneva escapement: terminal speed, period and rise from rest
    #[command(after_help = "\
Examples:
  geneva escapement --slots 4 --friction 0.3 --torque 2 --driver-inertia 1 --follower-inertia 15
  geneva escapement --slots 6 --friction 0.2 --torque 1 --driver-inertia 1 --follower-inertia 5 \\
                    --format json
  geneva escapement --slots 4 --friction 0 --torque 1 --driver-inertia 1 --follower-inertia 5 \\
                    --duration 20 --interval 0.1 --format csv --output run.csv
  geneva escapement --slots 6 --friction 0.2 --torque 1 --driver-inertia 1 --follower-inertia 5 \\
                    --reset-deg 90

A spring turns the driver. The driver's pins are spaced all the way round and push the slotted follower from stop to \
stop: each pin enters as the one before it leaves. Any coherent units will do, for example a torque in in lb with inertias \
in in lb s², or N m with kg m². Times are then in s, and speeds in rad/s.")]
    Escapement(escapement::EscapementArguments),
    /// Compute many escapements over ranges of friction, inertia ratio and torque, as CSV
    #[command(after_help = "\
Examples:
  geneva sweep --slots 4 --friction 0.1:0.4:7 --inertia-ratio 0.1
  geneva sweep --slots 3,4,6 --friction 0.05:0.4:50 --inertia-ratio 0.01:1:50:log --output sweep.csv
  geneva sweep --slots 6 --friction 0.3 --inertia-ratio 0.6 --torque 1:100:5:log \\
               --follower-inertia 1e-5 --threads 2 --output sweep.csv

A range gives its two ends, the number of values including both ends, and how they are spaced. Rows run through the \
torques first, then through the inertia ratios, the frictions and the slots. There can be up to ten million rows. Units \
and numbers are those of geneva escapement.

The last column is the status: ok; may-jam if the friction is critical or more; no-terminal-speed if there is no friction; \
too-sharp if the motion changes too quickly to be computed; long-rise if only the rise takes too many engagements to be \
followed. A number that doesn't exist is left empty.

If you interrupt a sweep, FILE stays as it was, or is not created. If the program is killed just as it puts the complete \
rows in place, it may leave FILE.unfinished- with some letters after it, which you can delete.")]
    Sweep(sweep::SweepArguments),
    /// Check, sort or run a deck in MIMIC, the simulation language of the 1973 thesis
    #[command(
        disable_help_subcommand = true,
        after_help = "\
Examples:
  geneva mimic decks
  geneva mimic run predators
  geneva mimic run my.deck --data my.cards --format csv --output run.csv
  geneva mimic run escapement --set MU=0.2 --format svg --output run.svg
  geneva mimic sort escapement
  geneva mimic run --listing-in my-copy-of-the-thesis.txt --runs appendix-e --format json"
    )]
    Mimic(mimic::MimicArguments),
    /// Recompute every chain of numbers in texts of yours, with units and to the printed digits
    #[command(after_help = ::proofread::cli::EXAMPLES.replace("proofread ", "geneva proofread "))]
    Proofread(::proofread::cli::ProofreadArguments),
    /// Tie the numbers in texts of yours to the values that a program computed
    #[command(after_help = "\
Examples:
  geneva record examples/paper
  geneva record report.md --values results.json --second again.csv

The record lists each number with the words around it and the value that rounds to its digits. A number that fits several \
values, or none, is left for you to decide. What you write into the record stays when you run the command again.

Numbers are read with a point before the decimals. Those in code, comments and definitions of macros are not read.")]
    Record(record::RecordArguments),
    /// Check the numbers in texts of yours against the values that they are tied to
    #[command(after_help = "\
Examples:
  geneva check examples/paper
  geneva check --staged
  geneva check examples/paper --format json

The printed digits are the tolerance: a value must round to them, and the neighbours of each right number must fail. With \
a second file of values, both values must round to the printed digits.

In a book of mdBook, two lines in book.toml add pages on what is wrong and on where each number comes from:
  [preprocessor.numbers]
  command = \"geneva numbers\"

Exit codes: 0 all numbers are right, 1 something differs or is undecided, 2 bad usage or bad input.")]
    Check(check::CheckArguments),
    /// Make a crate in which you check a document of yours, claim by claim
    #[command(after_help = "\
Examples:
  geneva new my-check --from notes.md
  geneva new ../thesis-check --from thesis.tex --engine .

The crate has the text, an inventory of each number that it prints, the first claims to fill in, a book, tests, and a README that \
leads to the first verdict. It depends on the crates of this project by their folder. `cargo run` in it builds the book and says \
which numbers are not yet accounted for. If anything fails, nothing is written.

Numbers are those that a reader sees: not in markup, code, comments and addresses.")]
    New(new::NewArguments),
    /// Build the book, or test its chapters
    #[command(
        args_conflicts_with_subcommands = true,
        disable_help_subcommand = true,
        after_help = "\
Examples:
  geneva book --open
  geneva book build --output public
  geneva book test"
    )]
    Book(book::BookArguments),
    /// Write shell completions to standard output
    #[command(after_help = "\
Example:
  geneva completions bash > ~/.local/share/bash-completion/completions/geneva")]
    Completions {
        /// The shell
        #[arg(value_name = "SHELL")]
        shell: clap_complete::Shell,
    },
    /// Act as mdBook's preprocessor: read a book from standard input and write it to standard output
    #[command(
        hide = true,
        disable_help_subcommand = true,
        after_help = "\
Example, in book.toml:
  [preprocessor.geneva]
  command = \"cargo run -q -p geneva -- preprocess\""
    )]
    Preprocess(preprocess::PreprocessArguments),
    /// Act as mdBook's preprocessor for a book of yours: add pages on its numbers, by its record
    #[command(
        hide = true,
        disable_help_subcommand = true,
        after_help = "\
Example, in book.toml beside a record that `geneva record` wrote:
  [preprocessor.numbers]
  command = \"geneva numbers\"
  record = \"numbers.toml\"

A chapter that contains {{numbers:errata}} or {{numbers:coverage}} gets that page there. Otherwise it is added as the \
last chapter."
    )]
    Numbers(number_pages::NumberPagesArguments),
}

/// Does what a command line asks for, and says on these streams what there is to say.
fn respond(line: impl IntoIterator<Item = OsString>, streams: &mut dyn OutputStreams) -> Outcome {
    let done = match parse(line) {
        Ok(arguments) => run(arguments, streams),
        Err(error) => output::explain(&error, streams),
    };
    done.unwrap_or_else(|error| {
        output::complain(&error, streams);
        Outcome::Failed
    })
}

fn run(arguments: Arguments, streams: &mut dyn OutputStreams) -> anyhow::Result<Outcome> {
    match arguments.command {
        None => verify_and_build(streams),
        Some(Command::Claims(wanted)) => {
            let layout = output::layout_for(&wanted.to.output, streams);
            if let Some((page, outcome)) = claims::accounts(&wanted, layout)? {
                output::write_output(&page, &wanted.to.output, streams)?;
                return Ok(outcome);
            }
            output::write_output(&claims::page(&wanted, layout)?, &wanted.to.output, streams)?;
            Ok(as_recorded(claims::wanted_verdicts(&wanted), streams))
        }
        Some(Command::Errata(wanted)) => {
            let layout = output::layout_for(&wanted.to.output, streams);
            output::write_output(&errata::page(&wanted, layout)?, &wanted.to.output, streams)?;
            Ok(as_recorded(errata::wanted_verdicts(&wanted), streams))
        }
        Some(Command::Coverage(wanted)) => {
            let (page, outcome) = coverage::page(&wanted, streams.layout())?;
            streams.print(&page)?;
            Ok(outcome)
        }
        Some(Command::Wheel(wanted)) => match &wanted.action {
            Some(wheel::WheelAction::Check(check)) => {
                say(|layout| wheel_check::page(check, layout), &check.to, streams)
            }
            None => say(|layout| wheel::page(&wanted, layout), &wanted.to, streams),
        },
        Some(Command::Pin(wanted)) => say(|layout| pin::page(&wanted, layout), &wanted.to, streams),
        Some(Command::QuickReturn(wanted)) => say(|layout| quick_return::page(&wanted, layout), &wanted.to, streams),
        Some(Command::Escapement(wanted)) => say(|layout| escapement::page(&wanted, layout), &wanted.to, streams),
        Some(Command::Sweep(wanted)) => {
            if let Some(told) = sweep::write_sweep(&wanted)? {
                streams.print(&streams.layout().folded(&told))?;
            }
            Ok(Outcome::AsRecorded)
        }
        Some(Command::Mimic(wanted)) => {
            say(|layout| mimic::page(&wanted.action, layout), mimic::destination(&wanted.action), streams)
        }
        Some(Command::Proofread(wanted)) => Ok(proofread::run(&wanted, streams)),
        Some(Command::Record(wanted)) => {
            let page = record::page(wanted, streams.layout())?;
            streams.print(&page)?;
            Ok(Outcome::AsRecorded)
        }
        Some(Command::Check(wanted)) => {
            let (page, outcome) = check::page(&wanted, streams.layout())?;
            streams.print(&page)?;
            Ok(outcome)
        }
        Some(Command::New(wanted)) => {
            let page = new::page(&wanted, streams.layout())?;
            streams.print(&page)?;
            Ok(Outcome::AsRecorded)
        }
        Some(Command::Book(wanted)) => book::run(wanted, streams),
        Some(Command::Completions { shell }) => {
            streams.print(&completions::script(shell)?)?;
            Ok(Outcome::AsRecorded)
        }
        Some(Command::Preprocess(call)) => preprocess::run(call, streams),
        Some(Command::Numbers(call)) => number_pages::run(&call, streams),
    }
}

/// Writes an answer with which nothing is compared where it was asked for.
fn say(
    page: impl FnOnce(TextLayout) -> anyhow::Result<String>,
    to: &typed::Output,
    streams: &mut dyn OutputStreams,
) -> anyhow::Result<Outcome> {
    let page = page(output::layout_for(&to.output, streams))?;
    output::write_output(&page, &to.output, streams)?;
    Ok(Outcome::AsRecorded)
}

/// Checks all claims and builds the book, even if some verdict differs: what happens without arguments.
fn verify_and_build(streams: &mut dyn OutputStreams) -> anyhow::Result<Outcome> {
    let verdicts = {
        let _step = progress::step("deriving the verdicts");
        geneva_documents::LEDGER.verdicts()
    };
    streams.print(&summary::page(verdicts, streams.layout()))?;
    book::build(&book::BuildArguments::default(), streams)?;
    Ok(as_recorded(verdicts.iter().copied(), streams))
}

/// Whether each of these verdicts matches the record. Those that differ are named on standard error.
fn as_recorded<'a>(
    verdicts: impl IntoIterator<Item = &'a geneva_evidence::Judged>,
    streams: &mut dyn OutputStreams,
) -> Outcome {
    let verdicts: Vec<_> = verdicts.into_iter().collect();
    differing::report_differing(verdicts.iter().copied(), streams);
    Outcome::as_recorded_if(verdicts.into_iter().all(geneva_evidence::Judged::matches_record))
}

/// Reads a command line.
///
/// # Errors
///
/// Says what is wrong with it, or answers a request for help or the version. Values are repeated in a form that is harmless
/// for a terminal, and cut where they are long.
fn parse(line: impl IntoIterator<Item = OsString>) -> Result<Arguments, clap::Error> {
    let line: Vec<_> = line.into_iter().collect();
    Arguments::try_parse_from(&line).map_err(|error| {
        let harmless = line.iter().map(|word| escaped(&word.to_string_lossy()).into_owned());
        // The same error with the same words, in which nothing is left that a terminal obeys.
        let mut error = match Arguments::try_parse_from(harmless) {
            Err(harmless) if harmless.kind() == error.kind() => harmless,
            _ => Arguments::command().error(error.kind(), escaped(&plain(&error))),
        };
        let long: Vec<_> = error
            .context()
            .filter_map(|(kind, value)| match value {
                ContextValue::String(typed) => Some((kind, escape_and_shorten(typed))),
                _ => None,
            })
            .filter(|(_, shown)| shown.ends_with('…'))
            .collect();
        if !long.is_empty() {
            error.insert(ContextKind::Suggested, ContextValue::None);
        }
        for (kind, shown) in long {
            error.insert(kind, ContextValue::String(shown));
        }
        error
    })
}

/// What an error says, in one line.
fn plain(error: &clap::Error) -> String {
    let text = error.render().to_string();
    text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_arguments_do_not_contradict_one_another() {
        super::Arguments::command().debug_assert();
    }
}
