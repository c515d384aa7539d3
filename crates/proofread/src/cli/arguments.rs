//! The options of the command.
//!
//! They are listed by hand: the macros of clap would take a quarter of the time in which the program is installed.

use crate::evaluate::binding::NamePolicy;
use crate::reader::{ArchiveFormat, TextFormat};
use clap::builder::PossibleValuesParser;
use clap::error::Error;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, value_parser};
use std::path::PathBuf;

/// What stands under the help.
pub const EXAMPLES: &str = "\
Examples:
  proofread notes.tex chapters/
  proofread --units --bindings=always homework.md
  proofread --since main .
  proofread --staged
  proofread --accept accepted.jsonl book/src
  proofread --baseline accepted.jsonl book/src
  proofread --format sarif book/src > proofread.sarif
  proofread --format html book/src > proofread.html
  pdftotext -layout paper.pdf - | proofread --input plain -
  proofread lsp

Exit codes: 0 nothing was found, 1 something was, 2 bad usage or bad input.";

/// How findings are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OutputFormat {
    Text,
    Json,
    Jsonl,
    Sarif,
    Html,
}

/// What all input is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Input {
    One(TextFormat),
    /// An archive with one text or several.
    Archive(ArchiveFormat),
    /// A document in Typst.
    Typst,
    /// One JSON object per line, each with its own format.
    Lines,
}

impl Input {
    /// The names of all, as they are given to `--input`.
    fn names() -> impl Iterator<Item = &'static str> {
        let texts = TextFormat::ALL.iter().map(|(name, _)| *name);
        texts.chain(ArchiveFormat::ALL.iter().map(|(name, _)| *name)).chain([TYPST, LINES])
    }

    fn from_name(name: &str) -> Self {
        let text = TextFormat::from_name(name).map(Self::One);
        text.or_else(|| ArchiveFormat::from_name(name).map(Self::Archive)).unwrap_or(match name {
            TYPST => Self::Typst,
            _ => Self::Lines,
        })
    }

    /// What files are written in whose names end so, without the dot.
    pub(super) fn from_extension(extension: &str) -> Option<Self> {
        match extension {
            "jsonl" | "ndjson" => Some(Self::Lines),
            "typ" => Some(Self::Typst),
            _ => TextFormat::from_extension(extension)
                .map(Self::One)
                .or_else(|| ArchiveFormat::from_extension(extension).map(Self::Archive)),
        }
    }
}

/// The options of the command.
#[derive(Clone, Debug)]
pub struct ProofreadArguments {
    pub(crate) files: Vec<PathBuf>,
    pub(crate) input: Option<Input>,
    pub(crate) format: OutputFormat,
    pub(crate) units: bool,
    pub(crate) doubts: bool,
    pub(crate) less_certain: bool,
    pub(crate) unchecked: bool,
    pub(crate) name_policy: NamePolicy,
    pub(crate) agreeing: bool,
    pub(crate) statistics: bool,
    pub(crate) since: Option<String>,
    pub(crate) staged: bool,
    pub(crate) baseline: Option<PathBuf>,
    pub(crate) accept: Option<PathBuf>,
    /// Whether an editor is to be served instead.
    pub(crate) lsp: bool,
}

/// The command for editors; a file of this name is `./lsp`.
const LSP: &str = "lsp";

/// What stands under the help of the command for editors.
const LSP_OPTIONS: &str = "\
Options of the editor, as initializationOptions or in workspace/didChangeConfiguration, alone or under `proofread`:
  units       true or false   also list numbers that agree although their units do not
  doubts      true or false   also list differences that are set aside
  bindings    never, once or always
  statistics  true or false
  baseline    the path of a file that --accept wrote, from the folder of the editor

A file that is named lsp is given as ./lsp.

Exit codes: 0 the editor asked for the end, 1 it was gone before, 2 standard input is a terminal.";

const WRITTEN: [(&str, OutputFormat); 5] = [
    ("text", OutputFormat::Text),
    ("json", OutputFormat::Json),
    ("jsonl", OutputFormat::Jsonl),
    ("sarif", OutputFormat::Sarif),
    ("html", OutputFormat::Html),
];
pub(super) const FOLLOWED: [(&str, NamePolicy); 3] =
    [("never", NamePolicy::Never), ("once", NamePolicy::Once), ("always", NamePolicy::Always)];
pub(super) const COMPARED: [(&str, bool); 2] = [("never", false), ("always", true)];
const LINES: &str = "jsonl";
/// The name of Typst, for programs.
pub(super) const TYPST: &str = "typst";

fn value_names<T>(of: &[(&'static str, T)]) -> PossibleValuesParser {
    PossibleValuesParser::new(of.iter().map(|(name, _)| *name))
}

impl Args for ProofreadArguments {
    fn augment_args(command: Command) -> Command {
        let option = |name: &'static str, value: &'static str| Arg::new(name).long(name).value_name(value);
        let switch = |name: &'static str| Arg::new(name).long(name).action(ArgAction::SetTrue);
        let stdio = switch("stdio").help("As it is anyway; some editors say so");
        let lsp = Command::new(LSP)
            .about("Serve an editor, which shows findings while a text is written")
            .after_help(LSP_OPTIONS)
            .arg(stdio);
        // Behind an option or a file, the name is that of a file.
        let command = command
            .subcommand(lsp)
            .args_conflicts_with_subcommands(true)
            .subcommand_negates_reqs(true)
            .disable_help_subcommand(true);
        command.args([
            Arg::new("files")
                .value_name("FILE")
                .required_unless_present("staged")
                .num_args(1..)
                .value_parser(value_parser!(PathBuf))
                .help(
                    "Files and folders to read; `-` is standard input. A folder is searched for files whose format the name \
                     tells. A LaTeX file is read with the macros of the local files that it includes and of those that \
                     include it",
                ),
            option("input", "FORMAT").value_parser(PossibleValuesParser::new(Input::names())).help(
                "What all input is written in; jsonl is one object per line with `id`, `format` and `text` [default: told by \
                 the name of each file; markdown on standard input]",
            ),
            option("format", "FORMAT")
                .value_parser(value_names(&WRITTEN))
                .default_value("text")
                .help("How findings are written; sarif is for code review, html a page for people"),
            switch("units").help("Also list numbers that agree although their units do not"),
            switch("doubts").help(
                "Also list differences that are set aside, since the text may have been misread or the result is truncated",
            ),
            switch("less-certain").help(
                "Also list differences that are less often a fault of the text: what computes nothing, is short or slight, or is \
                 in a document where a third of the pairs differ",
            ),
            switch("unchecked")
                .help("Also list the chains that were not checked, each with the reason; they count as nothing found"),
            option("bindings", "WHEN")
                .value_parser(value_names(&FOLLOWED))
                .num_args(0..=1)
                .require_equals(true)
                .default_value("never")
                .default_missing_value("always")
                .help(
                    "Put values that the text gives to names into formulas; once: only names with one value, in a short \
                     document",
                ),
            option("statistics", "WHEN")
                .value_parser(value_names(&COMPARED))
                .num_args(0..=1)
                .require_equals(true)
                .default_value("always")
                .default_missing_value("always")
                .help(
                    "Compare p-values with their tests, confidence intervals with estimates, shares with counts, and the totals \
                     of tables with their parts; 60 of the 95 that this list found in new texts were real",
                ),
            switch("agreeing").help("Also list pairs that agree, for programs; they count as nothing found"),
            option("since", "REV").help("Report only what has come in since this revision, with the help of git"),
            switch("staged").help(
                "Read files as they are staged in git, and report only what is new since HEAD, or since the revision of --since; \
                 without files, all of the repository",
            ),
            option("baseline", "FILE").value_parser(value_parser!(PathBuf)).help("Leave out the cases in this file"),
            option("accept", "FILE")
                .value_parser(value_parser!(PathBuf))
                .conflicts_with("baseline")
                .help("Write all cases found to this file, as accepted; a reason given there for a case is kept"),
        ])
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for ProofreadArguments {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let text = |name: &str| matches.get_one::<String>(name).map(String::as_str);
        let path = |name: &str| matches.get_one::<PathBuf>(name).cloned();
        let input = text("input").map(Input::from_name);
        Ok(Self {
            files: matches.get_many("files").into_iter().flatten().cloned().collect(),
            input,
            format: choice(text("format"), &WRITTEN).unwrap_or(OutputFormat::Text),
            units: matches.get_flag("units"),
            doubts: matches.get_flag("doubts"),
            less_certain: matches.get_flag("less-certain"),
            unchecked: matches.get_flag("unchecked"),
            name_policy: choice(text("bindings"), &FOLLOWED).unwrap_or_default(),
            agreeing: matches.get_flag("agreeing"),
            statistics: choice(text("statistics"), &COMPARED).unwrap_or(true),
            since: text("since").map(str::to_owned),
            staged: matches.get_flag("staged"),
            baseline: path("baseline"),
            accept: path("accept"),
            lsp: matches.subcommand_matches(LSP).is_some(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

fn choice<T: Copy>(name: Option<&str>, of: &[(&'static str, T)]) -> Option<T> {
    of.iter().find(|(known, _)| Some(*known) == name).map(|(_, value)| *value)
}
