//! Does a check notice what it should, and nothing else? Each test writes a small project into a folder of its own.

mod edits;
mod formats;
mod hostile;
mod second;
mod verdicts;

use geneva_values::{FindingKind, NumbersReport, RecordReport, RecordRequest};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A folder with a text, its values, and a record of both.
struct Project {
    folder: TempDir,
    text: &'static str,
}

impl Project {
    /// The files of a project, before anything is recorded.
    fn new(text: &'static str, source: &str, values: &str) -> Self {
        let project = Self { folder: tempfile::tempdir().expect("a folder"), text };
        project.write(text, source);
        project.write("values.json", values);
        project
    }

    fn path(&self) -> &Path {
        self.folder.path()
    }

    fn write(&self, name: &str, content: &str) {
        fs::write(self.path().join(name), content).expect("written");
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path().join(name)).expect("a text")
    }

    fn text(&self) -> String {
        self.read(self.text)
    }

    /// Changes the text or the record: `from` is there once.
    #[track_caller]
    fn change(&self, name: &str, from: &str, to: &str) {
        let source = self.read(name);
        assert_eq!(source.matches(from).count(), 1, "{from:?} in {source}");
        self.write(name, &source.replace(from, to));
    }

    fn record(&self) -> RecordReport {
        self.record_with(RecordRequest::default()).expect("a record")
    }

    fn record_with(&self, request: RecordRequest) -> Result<RecordReport, String> {
        geneva_values::record(&RecordRequest { named: vec![self.path().to_owned()], ..request })
    }

    fn check(&self) -> NumbersReport {
        geneva_values::check(self.path(), false).expect("a check")
    }

    /// What is not right, each as `kind printed`.
    fn differing(&self) -> Vec<String> {
        let report = self.check();
        let differing = report.findings.iter().filter(|finding| !finding.kind.is_right());
        differing.map(|finding| format!("{} {}", finding.kind.name(), finding.printed)).collect()
    }

    /// How many numbers are right.
    fn right(&self) -> usize {
        self.check().count(FindingKind::Right)
    }
}
