//! The command: files in, findings out. `geneva proofread` and the program `proofread` both run it.

mod arguments;
mod baseline;
mod case_lines;
mod documents;
mod html;
mod index;
mod json;
mod lsp;
mod nearest;
mod output;
mod project;
mod sarif;
mod since;
mod staged;
mod text;
mod tree;

pub use arguments::{EXAMPLES, ProofreadArguments};
pub use output::{CommandStreams, TextLayout};

use crate::certainty::list_first_by_share;
use crate::check::{CheckOptions, CheckReport, proofread};
use crate::evaluate::binding::NamePolicy;
use crate::judge::caveat::Caveat;
use crate::judge::section::ReportSection;
use crate::judge::unchecked::UncheckedKind;
use crate::named_counts::NamedCounts;
use crate::reader::{Definitions, TextFormat, UnreadKind, UnreadParts, unread_fences};
use crate::statistics::find_statistics;
use crate::tell::finding::ChainFinding;
use crate::tell::finding_group::{FindingGroup, group_findings};
use crate::tell::tally::CheckTally;
use crate::tell::unchecked_chain::UncheckedChain;
use arguments::OutputFormat;
use baseline::{Baseline, IdleCases};
use documents::{Document, Source};
use geneva_host::files::{NewFile, OutputOption};
use geneva_host::printable::shown_path;
use output::RunStatus;
use project::{Project, UncheckedParts};
use since::{EarlierText, Since};
use staged::Staging;
use std::path::{Path, PathBuf};
use tree::FileTree;

/// What a document gave, ready to be written.
struct CheckedDocument<'d> {
    document: &'d Document,
    findings: Vec<FindingGroup>,
    /// Differences that are less certain and not listed.
    apart: usize,
    tally: CheckTally,
    not_checked: NamedCounts<UncheckedKind>,
    not_read: UnreadParts,
    /// The chains that were not checked, if they are to be listed.
    unchecked: Option<Vec<UncheckedChain>>,
}

/// Runs the command; the exit code is 0 if nothing was found, 1 if something was, and 2 if an argument or input is wrong.
///
/// ```
/// use clap::{Args, FromArgMatches};
/// use proofread::cli::{CommandStreams, ProofreadArguments, run};
///
/// struct Output(String);
///
/// impl CommandStreams for Output {
///     fn print(&mut self, text: &str) -> Result<(), String> {
///         self.0 += text;
///         Ok(())
///     }
///
///     fn print_error(&mut self, text: &str) {
///         self.0 += text;
///     }
/// }
///
/// let file = std::env::temp_dir().join(format!("proofread-example-{}.md", std::process::id()));
/// std::fs::write(&file, "$2 + 2 = 5$")?;
/// let command = ProofreadArguments::augment_args(clap::Command::new("proofread"));
/// let matches = command.get_matches_from(["proofread".as_ref(), file.as_os_str()]);
/// let arguments = ProofreadArguments::from_arg_matches(&matches).expect("the options of the command");
/// let mut output = Output(String::new());
/// assert_eq!(run(&arguments, &mut output), 1);
/// assert!(output.0.contains("printed 5, recomputed 4"));
/// std::fs::remove_file(&file)?;
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn run(arguments: &ProofreadArguments, streams: &mut dyn CommandStreams) -> u8 {
    let outcome = if arguments.lsp {
        lsp::serve().map(|well| if well { RunStatus::Clean } else { RunStatus::Found })
    } else {
        CommandRun::new(arguments, streams).and_then(|run| run.run_all())
    };
    match outcome {
        Ok(outcome) => outcome.code(),
        Err(message) => {
            streams.print_error(&output::format_error(&message));
            RunStatus::Failed.code()
        }
    }
}

/// Most tokens that are evaluated in the search for hints in all lines of JSON of a run, as many as in ten documents.
const HINT_EFFORT: usize = 6_000_000;

struct CommandRun<'a> {
    arguments: &'a ProofreadArguments,
    streams: &'a mut dyn CommandStreams,
    baseline: Baseline,
    /// The file that the accepted cases are written to.
    accepted: Option<NewFile>,
    writer: Box<dyn ReportWriter>,
    project: Project,
    /// What the search for hints in lines of JSON may still cost: there may be any number of them.
    hint_effort: usize,
    sum: CheckTally,
    not_checked: NamedCounts<UncheckedKind>,
    not_read: UnreadParts,
    documents: usize,
    found: FoundCounts,
    less_certain: usize,
    failed: bool,
}

/// A form of output.
trait ReportWriter {
    /// What is written for a document.
    fn document(&mut self, checked: &CheckedDocument<'_>) -> String;
    /// What is written at the end.
    fn end(&mut self, sum: &RunTotals) -> String;
}

/// How many findings are listed, by their list, and how many places they have.
#[derive(Clone, Copy, Debug, Default)]
struct FoundCounts {
    findings: [usize; 7],
    places: [usize; 7],
}

impl FoundCounts {
    fn add(&mut self, group: &FindingGroup) {
        let list = group.finding.section as usize;
        self.findings[list] += 1;
        self.places[list] += group.place_count();
    }

    /// Findings on a list.
    fn on(&self, list: ReportSection) -> usize {
        self.findings[list as usize]
    }

    /// Whether anything that is wrong is listed.
    fn has_differences(&self) -> bool {
        self.findings.iter().sum::<usize>() > self.on(ReportSection::Agreeing)
    }

    /// The places of all that is wrong.
    fn differing_places(&self) -> usize {
        self.places.iter().sum::<usize>() - self.places[ReportSection::Agreeing as usize]
    }
}

/// What all documents gave together.
struct RunTotals {
    tally: CheckTally,
    documents: usize,
    found: FoundCounts,
    /// Differences that are less certain, listed or not, without those that are accepted or were there before.
    less_certain: usize,
    accepted: usize,
    /// The accepted cases that left nothing out; none where only what is new was looked at.
    idle_cases: IdleCases,
    /// The files that include others which were read for their definitions alone.
    unchecked_parts: Vec<UncheckedParts>,
    not_checked: NamedCounts<UncheckedKind>,
    not_read: UnreadParts,
    units_listed: bool,
    doubts_listed: bool,
    less_certain_listed: bool,
    unchecked_listed: bool,
    /// How to go on, if a commit is stopped.
    ways_out: Option<String>,
}

impl<'a> CommandRun<'a> {
    fn new(arguments: &'a ProofreadArguments, streams: &'a mut dyn CommandStreams) -> Result<Self, String> {
        let baseline = match (&arguments.baseline, &arguments.accept) {
            (Some(path), _) => Baseline::read(path)?,
            (None, Some(path)) if path.exists() => Baseline::read(path)?,
            (None, Some(path)) => Baseline::beside(path),
            _ => Baseline::default(),
        };
        if let Some(why) = arguments.accept.as_deref().and_then(|path| nearest::missing_folder(path, "--accept")) {
            return Err(why);
        }
        let option = OutputOption { name: "--accept", instead: "" };
        let accepted = arguments.accept.as_deref().map(|path| NewFile::new(path, option)).transpose()?;
        let writer: Box<dyn ReportWriter> = match arguments.format {
            OutputFormat::Text => Box::new(text::TextWriter(streams.layout())),
            OutputFormat::Json => Box::new(json::JsonWriter::default()),
            OutputFormat::Jsonl => Box::new(json::JsonLinesWriter),
            OutputFormat::Html => Box::new(html::HtmlWriter::default()),
            OutputFormat::Sarif => Box::new(sarif::SarifWriter::default()),
        };
        Ok(Self {
            arguments,
            streams,
            baseline,
            accepted,
            writer,
            project: Project::default(),
            hint_effort: HINT_EFFORT,
            sum: CheckTally::default(),
            not_checked: NamedCounts::default(),
            not_read: UnreadParts::default(),
            documents: 0,
            found: FoundCounts::default(),
            less_certain: 0,
            failed: false,
        })
    }

    fn run_all(mut self) -> Result<RunStatus, String> {
        let arguments = self.arguments;
        let revision = arguments.since.as_deref();
        let accepting = arguments.accept.is_some();
        let (since, sources) = if arguments.staged {
            let staging = Staging::new(revision, &arguments.files)?;
            self.project = Project::new(FileTree::Staged(staging.files()));
            (None, staging.sources(arguments.input, &mut self.not_read))
        } else {
            let since = revision.map(|revision| Since::new(revision, &arguments.files)).transpose()?;
            (since, documents::sources(&arguments.files, arguments.input, &mut self.not_read)?)
        };
        for (file, folder) in sources.iter().flatten().filter_map(Source::file_of_project) {
            self.project.add(file, folder);
        }
        // What is new alone is looked at with the files that have changed.
        let is_all = revision.is_none() && !arguments.staged;
        let files = sources.iter().flatten().filter_map(Source::file_of_project).filter(|_| is_all);
        let files: Vec<PathBuf> = files.map(|(file, _)| file.to_owned()).collect();
        for source in sources {
            let source: Source = match source {
                Ok(source) => source,
                Err(message) => {
                    self.complain(&message);
                    continue;
                }
            };
            // The accepted cases are lines of JSON, too, but no documents.
            if [&arguments.baseline, &arguments.accept].into_iter().flatten().any(|cases| source.is_file(cases)) {
                continue;
            }
            if let Some(path) = source.found_without_text() {
                self.not_read.count(UnreadKind::Binary, &shown_path(path), 1);
                continue;
            }
            documents::read_documents(&source, &mut |document| match document
                .and_then(|document| self.proofread_document(&document, since.as_ref()))
            {
                Ok(()) => Ok(()),
                Err(message) => {
                    self.complain(&message);
                    Ok(())
                }
            })?;
        }
        let sum = RunTotals {
            tally: self.sum,
            documents: self.documents,
            found: self.found,
            less_certain: self.less_certain,
            accepted: self.baseline.accepted_count(),
            idle_cases: self.idle_cases(),
            unchecked_parts: self.project.unchecked_parts(&files),
            not_checked: std::mem::take(&mut self.not_checked),
            not_read: std::mem::take(&mut self.not_read),
            units_listed: arguments.units,
            doubts_listed: arguments.doubts,
            less_certain_listed: arguments.less_certain,
            unchecked_listed: arguments.unchecked,
            ways_out: self.ways_out(),
        };
        if let (Some(path), Some(file)) = (&arguments.accept, self.accepted.take()) {
            self.baseline.write(file)?;
            self.streams.print_error(&format!(
                "{} accepted in {}\n",
                crate::tell::summary::describe_count(sum.accepted, "case"),
                shown_path(path)
            ));
        } else if self.documents > 0 || !self.failed || !matches!(arguments.format, OutputFormat::Text) {
            let end = self.writer.end(&sum);
            self.streams.print(&end)?;
        }
        let found = !accepting && self.found.has_differences();
        Ok(match (self.failed, found) {
            (true, _) => RunStatus::Failed,
            (false, true) => RunStatus::Found,
            (false, false) => RunStatus::Clean,
        })
    }

    /// How to go on after a commit was stopped.
    fn ways_out(&self) -> Option<String> {
        if !self.arguments.staged || !self.found.has_differences() {
            return None;
        }
        let program = called_program();
        Some(match &self.arguments.baseline {
            Some(path) => {
                let file = shown_path(path);
                format!(
                    "To go on, correct this and add it, or accept it with `{program} --staged --accept {file}` and add {file}."
                )
            }
            None => format!(
                "To go on, correct this and add it, or accept it with `{program} --staged --accept accepted.jsonl` and \
                     have the hook run `proofread --staged --baseline accepted.jsonl` (with pre-commit: `args: [--baseline, \
                     accepted.jsonl]`)."
            ),
        })
    }

    /// The accepted cases that left nothing out. What is new alone says nothing about them.
    fn idle_cases(&self) -> IdleCases {
        let ProofreadArguments { since, staged, baseline, name_policy, agreeing, statistics, .. } = self.arguments;
        if since.is_some() || *staged || baseline.is_none() || self.failed {
            return IdleCases::default();
        }
        self.baseline.idle_cases(|list| match list {
            ReportSection::Statistics => *statistics,
            ReportSection::Bindings => *name_policy != NamePolicy::Never,
            ReportSection::Agreeing => *agreeing,
            ReportSection::Numbers | ReportSection::Units | ReportSection::Doubts | ReportSection::LessCertain => true,
        })
    }

    fn complain(&mut self, message: &str) {
        self.failed = true;
        self.streams.print_error(&output::format_error(message));
    }

    /// Proofreads a document and writes what it gave.
    fn proofread_document(&mut self, document: &Document, since: Option<&Since>) -> Result<(), String> {
        let before = match &document.staged {
            Some(staged) => Some(EarlierText::of_staged(staged, document)?),
            None => since.map(|since| since.earlier_text(document)).transpose()?,
        };
        let before = match before {
            Some(EarlierText::Same) => return Ok(()),
            Some(EarlierText::Other(texts)) => texts,
            Some(EarlierText::Missing) | None => Vec::new(),
        };
        let definitions =
            document.path.as_deref().filter(|_| matches!(document.format, TextFormat::Latex | TextFormat::Xml));
        let definitions = definitions.and_then(|path| self.project.definitions(path));
        let mut report = self
            .report(document, document.path.is_none(), definitions.as_deref())
            .map_err(|why| format!("{}: {why}", shown_path(Path::new(&document.name))))?;
        let mut findings = std::mem::take(&mut report.findings);
        self.baseline.note(document, &findings);
        self.retain_listed(&mut findings);
        let mut before: Vec<Vec<ChainFinding>> = before
            .iter()
            .filter_map(|before| self.report(before, false, definitions.as_deref()).ok())
            .map(|report| report.findings)
            .collect();
        before.iter_mut().for_each(|findings| self.retain_listed(findings));
        since::remove_known(&mut findings, &before);
        let mut apart = 0;
        if self.arguments.accept.is_some() {
            // Whoever accepts the first one accepts the share, too, so that the next one isn't listed in its place.
            let is_by_share = |of: &ChainFinding| matches!(of.caveat, Some(Caveat::Share { .. }));
            findings.retain(|of| self.is_listed(of) || is_by_share(of));
            findings.iter().for_each(|finding| self.baseline.accept(document, finding));
        } else {
            let path = document.path.as_deref();
            findings.retain(|finding| !self.baseline.is_accepted(&document.name, path, finding));
            list_first_by_share(&mut findings);
            let found = findings.len();
            let in_list = |of: &&ChainFinding| of.section == ReportSection::LessCertain;
            self.less_certain += findings.iter().filter(in_list).count();
            findings.retain(|finding| self.is_listed(finding));
            apart = found - findings.len();
        }
        self.sum.add(&report.tally);
        self.not_checked.add(&report.not_checked);
        report.not_read.add(&document.not_read);
        self.not_read.add(&report.not_read);
        self.documents += 1;
        let findings = group_findings(findings);
        findings.iter().for_each(|group| self.found.add(group));
        if self.arguments.accept.is_none() {
            let CheckReport { tally, not_checked, not_read, unchecked, .. } = report;
            let unchecked = self.arguments.unchecked.then_some(unchecked);
            let checked = CheckedDocument { document, findings, apart, tally, not_checked, not_read, unchecked };
            let text = self.writer.document(&checked);
            self.streams.print(&text)?;
        }
        Ok(())
    }

    /// What a document has, on all lists.
    fn report(
        &mut self,
        document: &Document,
        is_line: bool,
        definitions: Option<&Definitions>,
    ) -> Result<CheckReport, String> {
        let ProofreadArguments { name_policy, agreeing, unchecked, .. } = *self.arguments;
        let mut options = CheckOptions { name_policy, agreeing, unchecked, definitions, ..CheckOptions::default() };
        let (text, format) = document.checked_text();
        if is_line {
            options.hint_effort = options.hint_effort.min(self.hint_effort);
        }
        let statistics = self.arguments.statistics.then(|| find_statistics(text, format)).transpose();
        let statistics = statistics.map_err(|why| why.to_string())?;
        // What is compared as a statistic is no unchecked chain, which is known from the list of these.
        options.unchecked |= statistics.as_ref().is_some_and(|found| !found.compared.is_empty());
        let mut report = proofread(text, format, options).map_err(|why| why.to_string())?;
        if is_line {
            self.hint_effort -= report.effort.hints;
        }
        if let Some(statistics) = statistics {
            statistics.add_to(&mut report);
        }
        if unchecked {
            let aside = report.findings.iter().filter_map(|of| Some(UncheckedChain::set_aside(of, of.doubt?)));
            report.unchecked.extend(aside);
            if format == TextFormat::Markdown {
                let fences = unread_fences(text).into_iter();
                report.unchecked.extend(fences.map(|(span, name)| UncheckedChain::in_fence(text, span, name)));
            }
            report.unchecked.sort_by_key(|chain| chain.span);
        }
        if let Some(made) = &document.made {
            report.tally.bytes = document.text.len();
            report.findings.iter_mut().for_each(|of| of.map_spans(&|span| made.span_in_text(span)));
            report.unchecked.iter_mut().for_each(|of| of.span = made.span_in_text(of.span));
        }
        Ok(report)
    }

    /// Keeps the findings on the lists that were asked for, and those that are less certain: what was so before a change may be
    /// on the list of numbers behind it, and is nothing new there.
    fn retain_listed(&self, findings: &mut Vec<ChainFinding>) {
        findings.retain(|finding| finding.section == ReportSection::LessCertain || self.is_listed(finding));
    }

    /// Whether a finding is on a list that was asked for.
    fn is_listed(&self, finding: &ChainFinding) -> bool {
        match finding.section {
            ReportSection::Units => self.arguments.units,
            ReportSection::Doubts => self.arguments.doubts,
            ReportSection::LessCertain => self.arguments.less_certain,
            ReportSection::Numbers | ReportSection::Bindings | ReportSection::Agreeing | ReportSection::Statistics => {
                true
            }
        }
    }
}

/// How this program was called, so that its command works where it is not on the path, as in what pre-commit has built.
fn called_program() -> String {
    const NAME: &str = "proofread";
    let called = std::env::args_os().next().map(PathBuf::from);
    let called = called.filter(|path| path.file_stem().is_some_and(|stem| stem == NAME));
    let shown = called.map_or(NAME.to_owned(), |path| path.to_string_lossy().into_owned());
    let is_plain = shown.chars().all(|c| c.is_alphanumeric() || "/\\:._-+".contains(c));
    if is_plain { shown } else { format!("'{}'", shown.replace('\'', r"'\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::{Args, FromArgMatches};

    #[derive(Default)]
    struct CapturedStreams(String);

    impl CommandStreams for CapturedStreams {
        fn print(&mut self, text: &str) -> Result<(), String> {
            self.0 += text;
            Ok(())
        }

        fn print_error(&mut self, text: &str) {
            self.0 += text;
        }
    }

    #[test]
    fn lines_of_json_share_what_the_search_for_hints_may_cost() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("all.jsonl");
        let line = "{\"text\": \"$\\\\tan 31.0^\\\\circ = 0.609$\"}\n";
        std::fs::write(&file, line.repeat(6)).expect("written");
        let command = ProofreadArguments::augment_args(clap::Command::new("proofread"));
        let matches = command.try_get_matches_from(["proofread".as_ref(), file.as_os_str()]).expect("a command line");
        let arguments = ProofreadArguments::from_arg_matches(&matches).expect("a command line");
        let hints = |effort: Option<usize>| {
            let mut kept = CapturedStreams::default();
            let mut run = CommandRun::new(&arguments, &mut kept).expect("a run");
            run.hint_effort = effort.unwrap_or(run.hint_effort);
            run.run_all().expect("an outcome");
            kept.0.matches("would agree").count()
        };
        assert_eq!(hints(None), 6);
        assert_eq!(hints(Some(0)), 0);
        // One search costs some hundred tokens.
        assert!((1..6).contains(&hints(Some(700))), "{}", hints(Some(700)));
    }
}
