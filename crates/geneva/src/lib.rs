//! The command line `geneva`: argument parsing and printing, nothing else.
//!
//! Every command turns its arguments into text. What the text says of a mechanism comes from `ask`, of claims from the
//! ledger, of a deck from the language, of a text from the proofreader, and the book from the press. Exit codes: 0 everything matches the record, 1 something differs, 2 bad usage, bad input or no access.
//!
//! The program is [`main`]. It is a library too, so that a test can ask thousands of lines with [`answer`] without starting
//! a process for each.

mod arguments;
mod book;
mod claims;
mod completions;
mod coverage;
mod destination;
mod differing;
mod errata;
mod escapement;
mod fields;
mod format;
#[cfg(test)]
mod fuzz;
mod input;
mod mimic;
mod output;
mod preprocess;
mod print;
mod printable;
mod progress;
mod proofread;
mod quick_return;
mod signals;
mod summary;
mod sweep;
mod threads;
mod typed;
mod wheel;
mod workspace;

use arguments::{Arguments, Command};
use format::Output;
use output::{Outcome, Own, Streams};
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the program with the arguments and the streams of this process.
pub fn main() -> ExitCode {
    respond(std::env::args_os(), &mut Own).into()
}

/// The answer to a command line where nothing is a terminal: what the process would write, and its exit code.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Answer {
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
pub fn answer(line: impl IntoIterator<Item = OsString>) -> Answer {
    let mut answer = Answer::default();
    answer.code = respond(line, &mut answer).code();
    answer
}

/// Does what a command line asks for, and says on these streams what there is to say.
fn respond(line: impl IntoIterator<Item = OsString>, streams: &mut dyn Streams) -> Outcome {
    let done = match arguments::parse(line) {
        Ok(arguments) => run(arguments, streams),
        Err(error) => output::explain(&error, streams),
    };
    done.unwrap_or_else(|error| {
        output::complain(&error, streams);
        Outcome::Failed
    })
}

fn run(arguments: Arguments, streams: &mut dyn Streams) -> anyhow::Result<Outcome> {
    match arguments.command {
        None => verify_and_build(streams),
        Some(Command::Claims(wanted)) => {
            output::write(&claims::page(&wanted)?, &wanted.to.output, streams)?;
            Ok(as_recorded(claims::derived(&wanted), streams))
        }
        Some(Command::Errata(wanted)) => {
            output::write(&errata::page(&wanted)?, &wanted.to.output, streams)?;
            Ok(as_recorded(errata::derived(&wanted), streams))
        }
        Some(Command::Coverage(wanted)) => {
            let (page, outcome) = coverage::page(&wanted)?;
            streams.print(&page)?;
            Ok(outcome)
        }
        Some(Command::Wheel(wanted)) => say(&wheel::page(&wanted)?, &wanted.to, streams),
        Some(Command::QuickReturn(wanted)) => say(&quick_return::page(&wanted)?, &wanted.to, streams),
        Some(Command::Escapement(wanted)) => say(&escapement::page(&wanted)?, &wanted.to, streams),
        Some(Command::Sweep(wanted)) => {
            if let Some(told) = sweep::written(&wanted)? {
                streams.print(&told)?;
            }
            Ok(Outcome::AsRecorded)
        }
        Some(Command::Mimic(wanted)) => say(&mimic::page(&wanted.action)?, mimic::destination(&wanted.action), streams),
        Some(Command::Proofread(wanted)) => Ok(proofread::run(&wanted, streams)),
        Some(Command::Book(wanted)) => book::run(wanted, streams),
        Some(Command::Completions { shell }) => {
            streams.print(&completions::script(shell)?)?;
            Ok(Outcome::AsRecorded)
        }
        Some(Command::Preprocess(call)) => preprocess::run(call, streams),
    }
}

/// Writes an answer with which nothing is compared where it was asked for.
fn say(text: &str, to: &Output, streams: &mut dyn Streams) -> anyhow::Result<Outcome> {
    output::write(text, &to.output, streams)?;
    Ok(Outcome::AsRecorded)
}

/// Checks all claims and builds the book, even if some verdict differs: what happens without arguments.
fn verify_and_build(streams: &mut dyn Streams) -> anyhow::Result<Outcome> {
    let verdicts = {
        let _step = progress::step("deriving the verdicts");
        geneva_ledger::verdicts()
    };
    streams.print(&summary::page(verdicts))?;
    book::build(&book::BuildArguments::default(), streams)?;
    Ok(as_recorded(verdicts, streams))
}

/// Whether each of these verdicts matches the record. Those that differ are named on standard error.
fn as_recorded<'a>(
    verdicts: impl IntoIterator<Item = &'a geneva_ledger::Judged>,
    streams: &mut dyn Streams,
) -> Outcome {
    let verdicts: Vec<_> = verdicts.into_iter().collect();
    differing::tell(verdicts.iter().copied(), streams);
    Outcome::as_recorded_if(verdicts.into_iter().all(geneva_ledger::Judged::holds))
}
