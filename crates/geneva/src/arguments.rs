//! The command line: the list of commands, with their examples. The options of a command stand in its own file.

use crate::book::BookArguments;
use crate::claims::ClaimsArguments;
use crate::coverage::CoverageArguments;
use crate::errata::ErrataArguments;
use crate::escapement::EscapementArguments;
use crate::mimic::MimicArguments;
use crate::preprocess::PreprocessArguments;
use crate::printable::{escaped, shown};
use crate::quick_return::QuickReturnArguments;
use crate::sweep::SweepArguments;
use crate::wheel::WheelArguments;
use clap::error::{ContextKind, ContextValue};
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsString;

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
  geneva quick-return --ground 0.3 --crank 0.1 --crank-angle 75 --rpm 60
                                               your own quick-return mechanism, at one instant
  geneva escapement --slots 4 --friction 0.3 --torque 2 --driver-inertia 1 --follower-inertia 15
                                               your own Geneva escapement: how fast it runs
  geneva sweep --slots 4 --friction 0.1:0.4:7 --inertia-ratio 0.1:1:10 --output sweep.csv
                                               many escapements, one row each
  geneva mimic run predators                   run a deck of cards in the language of 1973
  geneva proofread notes.tex chapters/         recompute every chain of numbers in texts of yours
  geneva book --open                           build the book and open it
  geneva completions bash                      shell completions for bash

Exit codes: 0 everything matches the record, 1 something differs, 2 bad usage, bad input or no access."
)]
pub struct Arguments {
    /// What to do; without it, check all claims and build the book.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// Reads a command line.
///
/// # Errors
///
/// Says what is wrong with it, or answers a request for help or the version. Values are repeated in a form that is harmless
/// for a terminal, and cut where they are long.
pub fn parse(line: impl IntoIterator<Item = OsString>) -> Result<Arguments, clap::Error> {
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
                ContextValue::String(typed) => Some((kind, shown(typed))),
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

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the claims: what is printed, what we compute, and the verdict
    #[command(after_help = "\
Examples:
  geneva claims --source pin
  geneva claims --verdict corrected
  geneva claims --format json --output claims.json")]
    Claims(ClaimsArguments),
    /// List the mistakes in the sources, most serious first, each with its correction, reason and witness
    #[command(after_help = "\
Examples:
  geneva errata
  geneva errata --consequence result
  geneva errata --source jazar --all
  geneva errata --format markdown --output errata.md")]
    Errata(ErrataArguments),
    /// Show the claims on each line of a source, or compare the numbers in your copy of it with ours
    #[command(after_help = "\
Examples:
  geneva coverage
  geneva coverage --source pin --against my-copy.txt
  geneva coverage --source pin --record my-copy.txt > pin.inventory

With --against, the exit code is 1 if the numbers on some line of your copy differ from the ledger's. With --record, a \
line keeps its claims and exceptions if its numbers haven't changed; you fill in the rest by hand.")]
    Coverage(CoverageArguments),
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
  geneva wheel --index-time 0.4 --dwell-time 1

An option that would have no effect is refused, and the message says what to add.")]
    Wheel(Box<WheelArguments>),
    /// Compute or draw a quick-return mechanism: velocities and accelerations at one instant
    #[command(after_help = "\
Examples:
  geneva quick-return --ground 0.3 --crank 0.1 --crank-angle 75 --rpm 60
  geneva quick-return --ground 0.3 --crank 0.1 --lever-angle -10 --branch near --rpm 60
  geneva quick-return --ground 0.1 --crank 0.3 --crank-angle 75 --rpm -60 --format json
  geneva quick-return --ground 0.3 --crank 0.1 --crank-angle 75 --rpm 60 \\
                      --format svg --output drawing.svg

The pin on the crank slides in the slot of the lever, which turns about its pivot.")]
    QuickReturn(QuickReturnArguments),
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
    Escapement(EscapementArguments),
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

The last column is the status: ok; jams if the friction is critical or more; no-terminal-speed if there is no friction; \
too-sharp if the motion changes too quickly to be computed; long-rise if only the rise takes too many engagements to be \
followed. A number that doesn't exist is left empty.

If you interrupt a sweep, FILE stays as it was, or is not created. If the program is killed just as it puts the complete \
rows in place, it may leave FILE.unfinished- with some letters after it, which you can delete.")]
    Sweep(SweepArguments),
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
    Mimic(MimicArguments),
    /// Recompute every chain of numbers in texts of yours, with units and to the printed digits
    #[command(after_help = proofread::cli::EXAMPLES.replace("proofread ", "geneva proofread "))]
    Proofread(proofread::cli::Arguments),
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
    Book(BookArguments),
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
    Preprocess(PreprocessArguments),
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_arguments_do_not_contradict_one_another() {
        super::Arguments::command().debug_assert();
    }
}
