//! The command: files in, findings out. `geneva proofread` and the program `proofread` both run it.

mod arguments;
mod baseline;
mod documents;
mod json;
mod output;
mod project;
mod sarif;
mod since;
mod text;

pub use arguments::{Arguments, EXAMPLES};
pub use output::{Streams, TextLayout};

use crate::check::{Options, Report, Tally, proofread};
use crate::finding::{Finding, List};
use crate::reader::{Definitions, Format};
use arguments::Written;
use baseline::Baseline;
use documents::{Document, Source};
use output::Outcome;
use project::Project;

/// What a document gave, ready to be written.
struct Checked<'d> {
    document: &'d Document,
    findings: Vec<Finding>,
    tally: Tally,
}

/// Runs the command; the exit code is 0 if nothing was found, 1 if something was, and 2 if an argument or input is wrong.
pub fn run(arguments: &Arguments, streams: &mut dyn Streams) -> u8 {
    let outcome = Run::new(arguments, streams).and_then(|run| run.all());
    match outcome {
        Ok(outcome) => outcome.code(),
        Err(message) => {
            streams.tell(&output::error(&message));
            Outcome::Failed.code()
        }
    }
}

struct Run<'a> {
    arguments: &'a Arguments,
    streams: &'a mut dyn Streams,
    baseline: Baseline,
    writer: Box<dyn Writer>,
    project: Project,
    sum: Tally,
    documents: usize,
    found: [usize; 5],
    failed: bool,
}

/// A form of output.
trait Writer {
    /// What is written for a document.
    fn document(&mut self, checked: &Checked<'_>) -> String;
    /// What is written at the end.
    fn end(&mut self, sum: &Sum) -> String;
}

/// What all documents gave together.
struct Sum {
    tally: Tally,
    documents: usize,
    /// Findings on numbers, units and bindings, pairs that agree, and doubts.
    found: [usize; 5],
    accepted: usize,
    units_listed: bool,
    doubts_listed: bool,
}

impl<'a> Run<'a> {
    fn new(arguments: &'a Arguments, streams: &'a mut dyn Streams) -> Result<Self, String> {
        let baseline = match (&arguments.baseline, &arguments.accept) {
            (Some(path), _) => Baseline::read(path)?,
            (None, Some(path)) if path.exists() => Baseline::read(path)?,
            _ => Baseline::default(),
        };
        let writer: Box<dyn Writer> = match arguments.format {
            Written::Text => Box::new(text::Text(streams.layout())),
            Written::Json => Box::new(json::Json::default()),
            Written::Jsonl => Box::new(json::Lines),
            Written::Sarif => Box::new(sarif::Sarif::default()),
        };
        Ok(Self {
            arguments,
            streams,
            baseline,
            writer,
            project: Project::default(),
            sum: Tally::default(),
            documents: 0,
            found: [0; 5],
            failed: false,
        })
    }

    fn all(mut self) -> Result<Outcome, String> {
        let arguments = self.arguments;
        let since = arguments.since.as_deref().map(since::Since::new);
        let accepting = arguments.accept.is_some();
        let sources = documents::sources(&arguments.files, arguments.input)?;
        for (file, folder) in sources.iter().flatten().filter_map(Source::latex) {
            self.project.add(file, folder);
        }
        for source in sources {
            let source: Source = match source {
                Ok(source) => source,
                Err(message) => {
                    self.complain(&message);
                    continue;
                }
            };
            // The accepted cases are lines of JSON, too, but no documents.
            if [&arguments.baseline, &arguments.accept].into_iter().flatten().any(|cases| source.is(cases)) {
                continue;
            }
            documents::each(&source, &mut |document| match document
                .and_then(|document| self.one(&document, since.as_ref()))
            {
                Ok(()) => Ok(()),
                Err(message) => {
                    self.complain(&message);
                    Ok(())
                }
            })?;
        }
        let sum = Sum {
            tally: self.sum,
            documents: self.documents,
            found: self.found,
            accepted: self.baseline.accepted(),
            units_listed: arguments.units,
            doubts_listed: arguments.doubts,
        };
        if let Some(path) = &arguments.accept {
            self.baseline.write(path)?;
            self.streams.tell(&format!(
                "{} accepted in {}\n",
                crate::summary::count(sum.accepted, "case"),
                path.display()
            ));
        } else if self.documents > 0 || !self.failed || !matches!(arguments.format, Written::Text) {
            let end = self.writer.end(&sum);
            self.streams.print(&end)?;
        }
        let agreeing = self.found[List::Agreeing as usize];
        let found = !accepting && self.found.iter().sum::<usize>() > agreeing;
        Ok(match (self.failed, found) {
            (true, _) => Outcome::Failed,
            (false, true) => Outcome::Found,
            (false, false) => Outcome::Clean,
        })
    }

    fn complain(&mut self, message: &str) {
        self.failed = true;
        self.streams.tell(&output::error(message));
    }

    /// Proofreads a document and writes what it gave.
    fn one(&mut self, document: &Document, since: Option<&since::Since>) -> Result<(), String> {
        if let Some(since) = since
            && !since.changed(document)?
        {
            return Ok(());
        }
        let definitions = document.path.as_deref().filter(|_| document.format == Format::Latex);
        let definitions = definitions.and_then(|path| self.project.definitions(path));
        let report = self
            .report(document, &document.text, definitions.as_deref())
            .map_err(|why| format!("{}: {why}", document.name))?;
        let mut findings = report.findings;
        if let Some(before) = since.map(|since| since.text(document)).transpose()?.flatten() {
            let before = self
                .report(document, &before, definitions.as_deref())
                .map(|report| report.findings)
                .unwrap_or_default();
            since::remove_known(&mut findings, &before);
        }
        if self.arguments.accept.is_some() {
            findings.iter().for_each(|finding| self.baseline.accept(&document.name, finding));
        } else {
            findings.retain(|finding| !self.baseline.has(&document.name, finding));
        }
        self.sum.add(&report.tally);
        self.documents += 1;
        for finding in &findings {
            self.found[finding.list as usize] += 1;
        }
        if self.arguments.accept.is_none() {
            let text = self.writer.document(&Checked { document, findings, tally: report.tally });
            self.streams.print(&text)?;
        }
        Ok(())
    }

    /// The findings that were asked for.
    fn report(&self, document: &Document, text: &str, definitions: Option<&Definitions>) -> Result<Report, String> {
        let Arguments { follow, agreeing, .. } = *self.arguments;
        let options = Options { follow, agreeing, definitions, ..Options::default() };
        let mut report = proofread(text, document.format, options).map_err(|why| why.to_string())?;
        report.findings.retain(|finding| match finding.list {
            List::Units => self.arguments.units,
            List::Doubts => self.arguments.doubts,
            List::Numbers | List::Bindings | List::Agreeing => true,
        });
        Ok(report)
    }
}
