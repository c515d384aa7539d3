//! The command line `geneva`: argument parsing and printing, nothing else.
//!
//! Every command turns its arguments into text. What the text says comes from the ledger, of a wheel or a quick-return
//! mechanism from the kinematics and the figures, of an escapement from the dynamics, of a deck from the language, and
//! the book from the press. Exit
//! codes: 0 all is as recorded, 1 something differs, 2 bad usage, bad input or no access.

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
#[cfg(test)]
mod fuzz;
mod input;
mod mimic;
mod output;
mod preprocess;
mod printable;
mod progress;
mod quick_return;
mod signals;
mod summary;
mod sweep;
mod threads;
mod typed;
mod wheel;
mod workspace;

use arguments::{Arguments, Command, Output};
use output::{Outcome, print};
use std::process::ExitCode;

fn main() -> ExitCode {
    match arguments::parse(std::env::args_os()).map_or_else(|error| output::explain(&error), run) {
        Ok(outcome) => outcome.into(),
        Err(error) => {
            output::complain(&error);
            Outcome::Failed.into()
        }
    }
}

fn run(arguments: Arguments) -> anyhow::Result<Outcome> {
    match arguments.command {
        None => verify_and_build(),
        Some(Command::Claims(wanted)) => {
            output::write(&claims::page(&wanted)?, &wanted.to.output)?;
            Ok(as_recorded(claims::derived(&wanted)))
        }
        Some(Command::Errata(wanted)) => {
            output::write(&errata::page(&wanted)?, &wanted.to.output)?;
            Ok(as_recorded(errata::derived(&wanted)))
        }
        Some(Command::Coverage(wanted)) => {
            let (page, outcome) = coverage::page(&wanted)?;
            print(&page)?;
            Ok(outcome)
        }
        Some(Command::Wheel(wanted)) => answer(&wheel::page(&wanted)?, &wanted.to, Outcome::AsRecorded),
        Some(Command::QuickReturn(wanted)) => answer(&quick_return::page(&wanted)?, &wanted.to, Outcome::AsRecorded),
        Some(Command::Escapement(wanted)) => answer(&escapement::page(&wanted)?, &wanted.to, Outcome::AsRecorded),
        Some(Command::Sweep(wanted)) => {
            sweep::run(&wanted)?;
            Ok(Outcome::AsRecorded)
        }
        Some(Command::Mimic(wanted)) => {
            answer(&mimic::page(&wanted.action)?, mimic::destination(&wanted.action), Outcome::AsRecorded)
        }
        Some(Command::Book(wanted)) => book::run(wanted),
        Some(Command::Completions { shell }) => {
            print(&completions::script(shell)?)?;
            Ok(Outcome::AsRecorded)
        }
        Some(Command::Preprocess(call)) => preprocess::run(call),
    }
}

/// Writes an answer where it was asked for.
fn answer(text: &str, to: &Output, outcome: Outcome) -> anyhow::Result<Outcome> {
    output::write(text, &to.output)?;
    Ok(outcome)
}

/// What happens without arguments. The book is built even if some verdict differs.
fn verify_and_build() -> anyhow::Result<Outcome> {
    let verdicts = {
        let _step = progress::step("deriving the verdicts");
        geneva_ledger::verdicts()
    };
    print(&summary::page(verdicts))?;
    book::build(&arguments::BuildArguments::default())?;
    Ok(as_recorded(verdicts))
}

/// Whether each of these verdicts is the one on record. Those that differ are named on standard error.
fn as_recorded<'a>(verdicts: impl IntoIterator<Item = &'a geneva_ledger::Judged>) -> Outcome {
    let verdicts: Vec<_> = verdicts.into_iter().collect();
    differing::tell(verdicts.iter().copied());
    Outcome::as_recorded_if(verdicts.into_iter().all(geneva_ledger::Judged::holds))
}
