//! The command line: every command, its options, and their help.

use crate::escapement::EscapementArguments;
use crate::mimic::MimicArguments;
use crate::printable::{escaped, shown};
use crate::quick_return::QuickReturnArguments;
use crate::sweep::SweepArguments;
use crate::wheel::WheelArguments;
use anyhow::bail;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::{ContextKind, ContextValue};
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use geneva_ledger::{Consequence, Verdict, Work};
use std::ffi::OsString;
use std::path::PathBuf;

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

/// Options of `geneva claims`.
#[derive(Args, Debug)]
pub struct ClaimsArguments {
    /// List only the claims of this source
    #[arg(long, value_parser = sources())]
    pub source: Option<Work>,
    /// List only the claims with this verdict
    #[arg(long, value_parser = verdicts())]
    pub verdict: Option<Verdict>,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (Format::Text, "A readable table"),
        (Format::Json, "An array of objects, with everything known about each claim"),
        (Format::Csv, "The data of the JSON, one row per claim"),
    ]))]
    pub format: Format,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// Options of `geneva errata`.
#[derive(Args, Debug)]
pub struct ErrataArguments {
    /// List only the mistakes in this source [default: all sources but wild]
    #[arg(long, value_parser = sources())]
    pub source: Option<Work>,
    /// List only the mistakes with this consequence
    #[arg(long, value_parser = consequences(), conflicts_with = "all")]
    pub consequence: Option<Consequence>,
    /// Also list what the copy we had has lost or changed; we don't know whether the original has it too
    #[arg(long)]
    pub all: bool,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (Format::Text, "Readable paragraphs"),
        (Format::Json, "An array of objects"),
        (Format::Csv, "The data of the JSON, one row per mistake"),
        (Format::Markdown, "A list by source"),
    ]))]
    pub format: Format,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// Options of `geneva coverage`.
#[derive(Args, Debug)]
pub struct CoverageArguments {
    /// Show only this source
    #[arg(long, value_parser = documents())]
    pub source: Option<Work>,
    /// Compare the numbers on each line with those in FILE, your own copy of the source's text
    #[arg(long, value_name = "FILE", requires = "source")]
    pub against: Option<PathBuf>,
    /// Write a new inventory file for the ledger, with the numbers in FILE, your own copy of the source's text
    #[arg(long, value_name = "FILE", requires = "source", conflicts_with = "against")]
    pub record: Option<PathBuf>,
}

/// Options of `geneva book`.
#[derive(Args, Debug)]
pub struct BookArguments {
    /// What to do with the book; without it, build.
    #[command(subcommand)]
    pub action: Option<BookAction>,
    /// Without an action: how to build.
    #[command(flatten)]
    pub build: BuildArguments,
}

/// Actions of `geneva book`.
#[derive(Debug, Subcommand)]
pub enum BookAction {
    /// Build the book; this is what `geneva book` does
    #[command(after_help = "\
Example:
  geneva book build --output public --open")]
    Build(BuildArguments),
    /// Print the whole book into one PDF, with Chromium or Chrome
    ///
    /// The contents get the numbers of their pages, and the PDF an outline. The browser is the program that $CHROMIUM names,
    /// or the first that is installed.
    #[command(after_help = "\
Example:
  geneva book print --output geneva-verified.pdf")]
    Print(PrintArguments),
    /// Compile and run every Rust block in every chapter
    #[command(after_help = "\
Example:
  geneva book test")]
    Test,
}

/// Options of `geneva book build`.
#[derive(Args, Debug, Default)]
pub struct BuildArguments {
    /// Build into this directory; a book already there is replaced once the new one is complete
    /// [default: target/book in the workspace]
    #[arg(long, value_name = "DIR", alias = "out")]
    pub output: Option<PathBuf>,
    /// Open the book once it is built
    #[arg(long)]
    pub open: bool,
}

/// Options of `geneva book print`.
#[derive(Args, Debug, Default)]
pub struct PrintArguments {
    /// Write this file; one that is there is replaced once the new one is complete
    /// [default: target/geneva-verified.pdf in the workspace]
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Options of `geneva preprocess`, as mdBook gives them.
#[derive(Args, Debug)]
pub struct PreprocessArguments {
    /// A question instead of a book.
    #[command(subcommand)]
    pub question: Option<Question>,
}

/// Questions that mdBook asks before it passes a book.
#[derive(Debug, Subcommand)]
pub enum Question {
    /// Exit with 0 if the renderer is supported, otherwise with 1
    Supports {
        /// mdBook's name for the renderer
        renderer: String,
    },
}

/// Where the output goes.
#[derive(Args, Debug)]
pub struct Output {
    /// Write to this file, or to standard output (-); an existing file is replaced once the new one is complete
    #[arg(long, value_name = "FILE", default_value = "-")]
    pub output: String,
}

/// Output formats. A word means the same to every command that knows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Readable text.
    Text,
    /// Text as a line printer wrote it.
    Print,
    /// Everything known, with all digits.
    Json,
    /// A series: one row per claim, mistake or time.
    Csv,
    /// The numbers of one mechanism: one row per field, as CSV.
    Fields,
    /// A drawing as a standalone file.
    Svg,
    /// A drawing for cutting machines.
    Dxf,
    /// A model for OpenSCAD.
    Scad,
    /// A mesh for printing.
    Stl,
    /// Markdown for a page.
    Markdown,
}

impl Format {
    /// Its name at the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Print => "print",
            Self::Json => "json",
            Self::Csv => "csv",
            Self::Fields => "fields",
            Self::Svg => "svg",
            Self::Dxf => "dxf",
            Self::Scad => "scad",
            Self::Stl => "stl",
            Self::Markdown => "markdown",
        }
    }

    /// Refuses an option that applies to this format only, if another is wanted; `what` is what it applies to.
    pub fn only_with(self, wanted: Self, option: &str, typed: Option<String>, what: &str) -> anyhow::Result<()> {
        match typed {
            Some(typed) if wanted != self => {
                bail!("{option} {typed} applies only to {what}; give --format {} with it, or leave it out", self.name())
            }
            _ => Ok(()),
        }
    }
}

/// The formats of a command, each with its help. A command without a series says what to use instead of CSV.
pub fn formats(known: &'static [(Format, &'static str)]) -> impl TypedValueParser<Value = Format> {
    let has_series = known.iter().any(|(format, _)| *format == Format::Csv);
    let names = known.iter().map(|(format, told)| PossibleValue::new(format.name()).help(*told));
    let refused = (!has_series).then(|| PossibleValue::new(Format::Csv.name()).hide(true));
    PossibleValuesParser::new(names.chain(refused)).try_map(move |name| {
        let format = known.iter().map(|(format, _)| *format).find(|format| format.name() == name);
        format.ok_or(
            "csv is for a series of rows, but this is a single mechanism; use fields for its numbers, one \
                   in each row, or json",
        )
    })
}

/// The name of a value as it is typed.
pub fn name_of(value: impl ValueEnum) -> Option<String> {
    Some(value.to_possible_value()?.get_name().to_owned())
}

fn sources() -> impl TypedValueParser<Value = Work> {
    named(Work::ALL, Work::slug, Work::citation)
}

/// The sources that are read line by line.
fn documents() -> impl TypedValueParser<Value = Work> {
    named(Work::DOCUMENTS, Work::slug, Work::citation)
}

fn consequences() -> impl TypedValueParser<Value = Consequence> {
    named(Consequence::ALL, Consequence::slug, Consequence::meaning)
}

fn verdicts() -> impl TypedValueParser<Value = Verdict> {
    named(Verdict::ALL, Verdict::slug, Verdict::meaning)
}

/// One of the values in a list of the ledger's, by its name.
fn named<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    slug: fn(T) -> &'static str,
    meaning: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.iter().map(|value| PossibleValue::new(slug(*value)).help(meaning(*value))))
        .try_map(move |name| all.iter().copied().find(|value| slug(*value) == name).ok_or("not a known name"))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_arguments_do_not_contradict_one_another() {
        super::Arguments::command().debug_assert();
    }
}
