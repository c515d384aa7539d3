//! Decks in the simulation language MIMIC: checked, sorted, run.

mod listed;
mod report;

use crate::destination::apart_from;
use crate::input::{MOST_BYTES, STANDARD_INPUT};
use crate::output::{TextLayout, count};
use crate::printable::{escape_and_shorten, shown_path};
use crate::progress;
use crate::threads::Threads;
use crate::typed::{self, CommandFormat, Output, as_typed, formats};
use anyhow::{Error, anyhow, bail, ensure};
use clap::{Args, Subcommand, ValueEnum};
use geneva_case1973::Hypothesis;
use geneva_documents::meyer::runs::table::rows;
use geneva_host::files;
use geneva_mimic::language::{
    CardLayout, DECKS, DataSet, Deck, DeckRun, DeckRuns, Program, RememberedPoints, RunError, RunOptions, deck_named,
    listing_in, nearest_to,
};
use geneva_mimic::{Interpolation, MinStepPolicy, StepSolution};
use rayon::prelude::*;
use std::path::{Path, PathBuf};

/// Options of `geneva mimic`.
#[derive(Args, Debug)]
pub(crate) struct MimicArguments {
    /// Action
    #[command(subcommand)]
    pub action: Action,
}

/// Actions of `geneva mimic`.
#[derive(Debug, Subcommand)]
pub(crate) enum Action {
    /// Check a deck: report each mistake with its card, its column and what is allowed there
    Check {
        /// Which deck.
        #[command(flatten)]
        deck: DeckArguments,
        /// Where the output goes.
        #[command(flatten)]
        to: Output,
    },
    /// List a deck's statements in the order in which they are computed
    Sort {
        /// Which deck.
        #[command(flatten)]
        deck: DeckArguments,
        /// Where the output goes.
        #[command(flatten)]
        to: Output,
    },
    /// Run a deck, once for each set of data
    Run(RunArguments),
    /// List the decks of this project, or print one
    Decks {
        /// The deck to print
        #[arg(value_name = "NAME")]
        name: Option<String>,
        /// Where the output goes.
        #[command(flatten)]
        to: Output,
    },
    /// List the functions and control cards, each with the evidence for it
    Functions {
        /// Where the output goes.
        #[command(flatten)]
        to: Output,
    },
}

/// Which deck.
#[derive(Args, Debug)]
pub(crate) struct DeckArguments {
    /// A file, - for standard input, or the name of a deck of this project (see geneva mimic decks)
    #[arg(value_name = "DECK", required_unless_present = "listing_in")]
    pub deck: Option<String>,
    /// Take the deck from a longer text, such as your own copy of the thesis: everything from the first PAR or CON card to
    /// END
    #[arg(long, value_name = "FILE", conflicts_with = "deck")]
    pub listing_in: Option<PathBuf>,
    /// Where the fields of a card are [default: columns, if every card keeps to them]
    #[arg(long, value_enum)]
    pub layout: Option<LayoutName>,
    /// Give a name another value: a name on a CON or PAR card, for every set of data, or a name that a single card defines
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting, allow_hyphen_values = true)]
    pub set: Vec<(String, f64)>,
}

/// Where the fields of a card are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum LayoutName {
    /// Control before column 10, result from column 10, expression from column 19
    Columns,
    /// Separated by blanks
    Free,
}

/// Options of `geneva mimic run`.
#[derive(Args, Debug)]
pub(crate) struct RunArguments {
    /// Which deck.
    #[command(flatten)]
    pub deck: DeckArguments,
    /// File of data cards that replace those after the deck's END; - for standard input
    #[arg(long, value_name = "FILE")]
    pub data: Option<PathBuf>,
    /// Data of the thesis in place of data cards, for a PAR card with slots, angle at the start, friction, torque, and the
    /// inertias of follower and driver
    #[arg(long, value_enum, conflicts_with = "data")]
    pub runs: Option<RunsName>,
    /// Largest relative error of a step, estimated by comparing the whole step with two half steps
    #[arg(long, value_name = "T", value_parser = tolerance, default_value = "5e-6", allow_hyphen_values = true)]
    pub tolerance: f64,
    /// Size below which the error of an integral is judged as if it had this size, or the largest of all so far if that is
    /// smaller
    #[arg(long, value_name = "SIZE", value_parser = typed::positive, default_value = "1e-3", allow_hyphen_values = true)]
    pub floor: f64,
    /// Which value of a step is kept; we don't know which one MIMIC kept
    #[arg(long, value_enum, default_value_t = KeptName::HalfSteps)]
    pub kept: KeptName,
    /// What to do if a step would have to be shorter than DTMIN
    #[arg(long, value_enum, default_value_t = AtDtmin::Keep)]
    pub at_dtmin: AtDtmin,
    /// How a TDL interpolates between the values that it keeps
    #[arg(long, value_enum, default_value_t = Between::Linear)]
    pub delay_between: Between,
    /// How many values a TDL keeps
    #[arg(long, value_enum, default_value_t = DelayKeeps::All)]
    pub delay_keeps: DelayKeeps,
    /// Output format
    #[arg(long, default_value = "print", value_parser = formats(&[
        (CommandFormat::Print, "Tables and character plots, as the line printer wrote them"),
        (CommandFormat::Json, "An array with an object for each run: parameters, columns, steps, forced_steps, steps_longer_than_delay, rows"),
        (CommandFormat::Csv, "One row per printed point, with the number of its run"),
        (CommandFormat::Svg, "The first plot of the first run as a drawing; without PLO, all OUT columns against the first"),
    ]))]
    pub format: CommandFormat,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// Sets of data that the ledger knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum RunsName {
    /// The runs of Appendix E, with the inertias of Fig. 11 for six pins
    AppendixE,
}

/// Which value of a step is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum KeptName {
    /// The value of the whole step
    FullStep,
    /// The value of the two half steps
    HalfSteps,
    /// Both values, extrapolated
    Extrapolated,
}

/// What to do if a step would have to be shorter than DTMIN.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum AtDtmin {
    /// Keep the step, and count it
    Keep,
    /// Stop the run
    Stop,
}

/// How a delay interpolates between its values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Between {
    /// Along a straight line
    Linear,
    /// With the earlier of the two values
    Hold,
}

/// How many values a delay keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum DelayKeeps {
    /// The values of all steps
    All,
    /// As many as its third argument says
    AsAsked,
}

/// NAME=VALUE.
fn setting(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or("no = in it; give a name, = and a number")?;
    if name.trim().is_empty() {
        return Err("no name before the =; give a name of the deck, = and a number".to_owned());
    }
    let value = value.trim().parse().ok().filter(|value: &f64| value.is_finite());
    Ok((
        name.trim().to_ascii_uppercase(),
        value.ok_or("no number after the =; give one, with a decimal point, not a comma")?,
    ))
}

/// A relative error: above zero and below 1.
fn tolerance(text: &str) -> Result<f64, String> {
    let value = typed::positive(text)?;
    if value < 1.0 {
        return Ok(value);
    }
    Err(format!(
        "{} must be below 1; give a fraction of each integral's size, such as 5e-6",
        escape_and_shorten(text.trim())
    ))
}

/// The answer to the action that is wanted.
pub(crate) fn page(action: &Action, layout: TextLayout) -> anyhow::Result<String> {
    apart_from(&destination(action).output, inputs(action))?;
    match action {
        Action::Check { deck, .. } => {
            let (name, deck) = read(deck)?;
            let program = program(&name, &deck)?;
            if deck.has_data() {
                deck.data_sets().map_err(|faults| anyhow!("{name}\n{faults}"))?;
            }
            Ok(report::check_report(&name, &deck, &program, layout))
        }
        Action::Sort { deck, .. } => {
            let (name, deck) = read(deck)?;
            Ok(report::statements_in_order(&deck, &program(&name, &deck)?, layout))
        }
        Action::Run(wanted) => run(wanted),
        Action::Decks { name: None, .. } => Ok(listed::decks(layout)),
        Action::Decks { name: Some(name), .. } => deck_named(name).map(str::to_owned).ok_or_else(|| {
            let known = DECKS.map(|(name, _)| name);
            anyhow!(
                "'{}' is not a deck of this project{}; give one of {}",
                escape_and_shorten(name),
                nearest(name, known),
                known.join(", ")
            )
        }),
        Action::Functions { .. } => Ok(listed::functions(layout)),
    }
}

/// Where the output of an action goes.
pub(crate) fn destination(action: &Action) -> &Output {
    match action {
        Action::Check { to, .. } | Action::Sort { to, .. } | Action::Decks { to, .. } | Action::Functions { to } => to,
        Action::Run(wanted) => &wanted.to,
    }
}

/// The files that are read.
fn inputs(action: &Action) -> Vec<&Path> {
    let (deck, data) = match action {
        Action::Check { deck, .. } | Action::Sort { deck, .. } => (deck, None),
        Action::Run(wanted) => (&wanted.deck, wanted.data.as_deref()),
        Action::Decks { .. } | Action::Functions { .. } => return Vec::new(),
    };
    [deck.deck.as_deref().map(Path::new), deck.listing_in.as_deref(), data].into_iter().flatten().collect()
}

/// The nearest of the names that are known, in words.
fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest_to(name, known).map_or_else(String::new, |nearest| format!("; the nearest is {nearest}"))
}

/// The text of a file, or of standard input, and what that is called. A byte order mark is no part of it.
fn text_of(path: &Path) -> anyhow::Result<(String, String)> {
    let (name, bytes) = if path == Path::new(STANDARD_INPUT) {
        let name = "standard input".to_owned();
        let read = files::read_stream(std::io::stdin().lock(), &name, MOST_BYTES);
        (name, read.map_err(Error::msg)?)
    } else {
        let wanted = format!("a text file, or {STANDARD_INPUT} for standard input");
        (shown_path(path), files::read(path, MOST_BYTES, &wanted).map_err(Error::msg)?)
    };
    let text = String::from_utf8(bytes).map_err(|_| anyhow!("{name} is not text in UTF-8; give cards in UTF-8"))?;
    let text = text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text);
    Ok((name, text))
}

/// The deck that is wanted, and what it is called.
fn read(wanted: &DeckArguments) -> anyhow::Result<(String, Deck)> {
    let (name, text) = match (&wanted.deck, &wanted.listing_in) {
        (_, Some(path)) => {
            let (name, text) = text_of(path)?;
            let listing = listing_in(&text).map(str::to_owned).ok_or_else(|| {
                anyhow!("{name} contains no program; give a text with one, from a card PAR(…) or CON(…) to END")
            })?;
            (name, listing)
        }
        (Some(deck), None) if deck == STANDARD_INPUT || Path::new(deck).exists() => text_of(Path::new(deck))?,
        (Some(deck), None) => {
            let own = deck_named(deck).ok_or_else(|| {
                anyhow!(
                    "'{}' is neither a file nor a deck of this project{}; geneva mimic decks lists the decks",
                    shown_path(Path::new(deck)),
                    nearest(deck, DECKS.map(|(name, _)| name))
                )
            })?;
            (deck.clone(), own.to_owned())
        }
        (None, None) => bail!("the deck is missing; give a file, or --listing-in FILE"),
    };
    let layout = match wanted.layout {
        Some(LayoutName::Columns) => CardLayout::Columns,
        Some(LayoutName::Free) => CardLayout::Free,
        None => CardLayout::detect(&text),
    };
    let mut deck = Deck::read(&text, layout).map_err(|faults| anyhow!("{name}\n{faults}"))?;
    for (set, value) in &wanted.set {
        let is_parameter = deck.parameters().contains(&set.as_str());
        ensure!(
            is_parameter || deck.set(set, *value),
            "--set {}={}: no CON or PAR card of {name} lists this name, and no single card without a control variable \
             defines it{}; give another name",
            escape_and_shorten(set),
            as_typed(*value),
            nearest(set, deck.parameters().into_iter().chain(deck.results()))
        );
    }
    Ok((name, deck))
}

fn program(name: &str, deck: &Deck) -> anyhow::Result<Program> {
    Program::new(deck).map_err(|faults| anyhow!("{name}\n{faults}"))
}

fn run(wanted: &RunArguments) -> anyhow::Result<String> {
    let reads_both = wanted.data.as_deref() == Some(Path::new(STANDARD_INPUT))
        && (wanted.deck.deck.as_deref() == Some(STANDARD_INPUT)
            || wanted.deck.listing_in.as_deref() == Some(Path::new(STANDARD_INPUT)));
    ensure!(!reads_both, "--data -: standard input already holds the deck; give a file for one of the two");
    let (name, mut deck) = read(&wanted.deck)?;
    if let Some(path) = &wanted.data {
        let (file, text) = text_of(path)?;
        ensure!(
            !text.trim().is_empty() || deck.parameters().is_empty(),
            "--data {}: {} is empty; give {}, one for each name on the CON and PAR cards",
            shown_path(path),
            if path == Path::new(STANDARD_INPUT) { "standard input" } else { "the file" },
            count(deck.parameters().len(), "number")
        );
        deck = deck.with_data(&file, &text);
    }
    let program = program(&name, &deck)?;
    let sets = data_sets(wanted, &name, &deck)?;
    let choices = choices(wanted);
    let told = |RunError { number, trouble }| {
        let of = if sets.len() > 1 { format!(", run {number} of {}", sets.len()) } else { String::new() };
        anyhow!("{name}{of}: {trouble}")
    };
    let all = if let [_] = sets[..] {
        let _step = progress::step("running the deck");
        program.runs(&sets, &choices).map_err(told)?
    } else {
        let threads = Threads::new(None)?;
        threads.pool()?.install(|| runs(&program, &sets, &choices, threads.number)).map_err(told)?
    };
    let _step = progress::step("writing the numbers");
    match wanted.format {
        CommandFormat::Json => report::json(&all),
        CommandFormat::Csv => report::csv(&all),
        CommandFormat::Svg => report::svg(&name, &all),
        _ => report::print_outs(&name, &all),
    }
}

/// All runs, as many at a time as there are threads, which share the memory that one run may have. A run that needs more
/// of it is made again by itself.
fn runs(program: &Program, sets: &[DataSet], choices: &RunOptions, threads: usize) -> Result<Vec<DeckRun>, RunError> {
    let step = progress::bar(sets.len(), "runs", false);
    let shared = RunOptions { at_once: threads.max(1), ..*choices };
    let mut all = DeckRuns::default();
    for some in sets.chunks(shared.at_once) {
        let run = |set| {
            let run = program.run(set, &shared);
            step.add(1);
            run
        };
        let made: Vec<_> = some.par_iter().map(run).collect();
        for (set, run) in some.iter().zip(made) {
            all.add(program, run.or_else(|_| program.run(set, choices)))?;
        }
    }
    Ok(all.into_inner())
}

/// The sets of data: those of the ledger, or those of the data cards; what --set gives counts more.
fn data_sets(wanted: &RunArguments, name: &str, deck: &Deck) -> anyhow::Result<Vec<DataSet>> {
    let names: Vec<String> = deck.parameters().into_iter().map(str::to_owned).collect();
    let given: Vec<_> = wanted.deck.set.iter().filter(|(name, _)| names.contains(name)).cloned().collect();
    let sets = if wanted.runs.is_some() {
        let columns = Hypothesis::AS_RUN.data_card(&rows()[0]).len();
        ensure!(
            names.len() == columns,
            "--runs appendix-e: each of these runs gives {columns} numbers (slots, angle at the start, friction, torque, \
             inertias of follower and driver), but the CON and PAR cards of {name} ask for {}; give a deck that asks for \
             {columns}, such as escapement",
            names.len()
        );
        let card = |row| names.iter().cloned().zip(Hypothesis::AS_RUN.data_card(row)).collect();
        rows().iter().map(|row| DataSet(card(row))).collect()
    } else if !deck.has_data() && names.iter().all(|name| given.iter().any(|(of, _)| of == name)) {
        vec![DataSet::default()]
    } else {
        // Faults of a file of data name it.
        let of = if wanted.data.is_some() { String::new() } else { format!("{name}\n") };
        deck.data_sets().map_err(|faults| anyhow!("{of}{faults}"))?
    };
    Ok(sets.into_iter().map(|set| DataSet(set.0.into_iter().chain(given.iter().cloned()).collect())).collect())
}

fn choices(wanted: &RunArguments) -> RunOptions {
    let usual = RunOptions::default();
    let kept = match wanted.kept {
        KeptName::FullStep => StepSolution::FullStep,
        KeptName::HalfSteps => StepSolution::TwoHalfSteps,
        KeptName::Extrapolated => StepSolution::Extrapolated,
    };
    let at_smallest_step = match wanted.at_dtmin {
        AtDtmin::Keep => MinStepPolicy::Continue,
        AtDtmin::Stop => MinStepPolicy::Stop,
    };
    let interpolation = match wanted.delay_between {
        Between::Linear => Interpolation::Linear,
        Between::Hold => Interpolation::Hold,
    };
    let remembered = match wanted.delay_keeps {
        DelayKeeps::All => RememberedPoints::All,
        DelayKeeps::AsAsked => RememberedPoints::AsAsked,
    };
    let integrator = geneva_mimic::SolverParameters {
        relative_tolerance: wanted.tolerance,
        absolute_floor: wanted.floor,
        kept,
        at_smallest_step,
        ..usual.integrator
    };
    RunOptions { integrator, interpolation, remembered, ..usual }
}
