//! Accepted cases: a file with a line of JSON for each, which people may edit and add reasons to.
//!
//! A case names its file by the path from the folder of the accepted cases, so that they hold from whatever folder the command is run.

use super::documents::Document;
use super::nearest::missing;
use crate::judge::section::ReportSection;
use crate::reader::LONGEST;
use crate::tell::finding::ChainFinding;
use geneva_host::files::{self, NewFile, whole_path};
use geneva_host::printable::shown_path;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

/// The whole path of a file, or of a document within it, and the fingerprint of a finding.
type CaseKey = (PathBuf, String);

/// The cases by file and fingerprint.
#[derive(Default)]
pub(crate) struct Baseline {
    /// The folder of the file with the cases.
    folder: PathBuf,
    cases: BTreeMap<CaseKey, Value>,
    /// How many findings were accepted.
    accepted: usize,
    /// The cases that were found, listed or not.
    found: BTreeSet<CaseKey>,
    /// The documents that were read.
    read: BTreeSet<PathBuf>,
}

/// Accepted cases that did not leave out anything.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct IdleCases {
    /// How many are not found any more although their file was read.
    pub gone: usize,
    /// How many are of files that were not read.
    pub unread: usize,
    /// The files that were not read, as the cases name them.
    pub unread_files: Vec<String>,
}

/// What stays the same of a finding when lines move.
pub(crate) fn fingerprint(finding: &ChainFinding) -> String {
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    format!("{}: {} | {}", finding.verdict.name(), squeezed(&finding.left), squeezed(&finding.right))
}

/// The way from a folder to a file, both with their whole paths, with strokes between the names; the file itself if there is none.
fn way(folder: &Path, file: &Path) -> String {
    let common = folder.components().zip(file.components()).take_while(|(one, other)| one == other).count();
    if common == 0 {
        return file.to_string_lossy().into_owned();
    }
    let up = folder.components().skip(common).map(|_| Component::ParentDir.as_os_str());
    let down = file.components().skip(common).map(Component::as_os_str);
    up.chain(down).map(|name| name.to_string_lossy()).collect::<Vec<_>>().join("/")
}

impl Baseline {
    /// Reads the file.
    pub(crate) fn read(path: &Path) -> Result<Self, String> {
        let wrong = |why: String| format!("{}: {why}; give a file that --accept wrote", shown_path(path));
        const WANTED: &str = "a file that --accept wrote";
        if let Some(why) = missing(path, WANTED) {
            return Err(why);
        }
        let bytes = files::read(path, LONGEST as u64, WANTED)?;
        let text = String::from_utf8(bytes).map_err(|_| wrong("this is not text in UTF-8".to_owned()))?;
        let mut out = Self::beside(path);
        for (number, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
            let case: Value = serde_json::from_str(line).map_err(|why| wrong(format!("line {}: {why}", number + 1)))?;
            let key = |name: &str| case[name].as_str().map(str::to_owned);
            let (Some(file), Some(of)) = (key("file"), key("case")) else {
                return Err(wrong(format!("line {}: an accepted case needs `file` and `case`", number + 1)));
            };
            out.cases.insert((whole_path(&out.folder.join(file)), of), case);
        }
        Ok(out)
    }

    /// No cases yet, but a file for them.
    pub(super) fn beside(path: &Path) -> Self {
        let folder = whole_path(path).parent().map(Path::to_owned).unwrap_or_default();
        Self { folder, ..Self::default() }
    }

    /// The keys of a file that the command calls so: by its place, and as cases were written that name it from where the command was
    /// run.
    fn files(&self, name: &str, path: Option<&Path>) -> [PathBuf; 2] {
        let named = whole_path(&self.folder.join(name));
        let Some(path) = path else { return [named.clone(), named] };
        // Of an archive, the document with its name in it.
        let shown = path.display().to_string();
        let inner = name.strip_prefix(&shown).unwrap_or_default().trim_start_matches('/');
        let file = whole_path(path);
        let file = if inner.is_empty() { file } else { file.join(inner) };
        // Another file that is there is not meant.
        let old = if named.exists() { file.clone() } else { named };
        [file, old]
    }

    /// Notes what a document has, listed or not, so that the cases are known that it has no more.
    pub(super) fn note(&mut self, document: &Document, findings: &[ChainFinding]) {
        for file in self.files(&document.name, document.path.as_deref()) {
            let keys = findings.iter().map(|finding| (file.clone(), fingerprint(finding)));
            self.found.extend(keys.filter(|key| self.cases.contains_key(key)));
            self.read.insert(file);
        }
    }

    /// Whether a finding in a file is accepted; `name` is what the command calls the file.
    pub(crate) fn is_accepted(&mut self, name: &str, path: Option<&Path>, finding: &ChainFinding) -> bool {
        let case = fingerprint(finding);
        let is_known = |file| self.cases.contains_key(&(file, case.clone()));
        let found = self.files(name, path).into_iter().any(is_known);
        self.accepted += usize::from(found);
        found
    }

    /// Accepts a finding; the reason of one that was accepted before is kept.
    pub(super) fn accept(&mut self, document: &Document, finding: &ChainFinding) {
        self.accepted += 1;
        let case = fingerprint(finding);
        let [file, old] = self.files(&document.name, document.path.as_deref());
        if self.cases.contains_key(&(old, case.clone())) {
            return;
        }
        let name = document.path.as_ref().map_or_else(|| document.name.clone(), |_| way(&self.folder, &file));
        let new = json!({ "file": name, "case": case, "list": finding.section.name(), "why": "" });
        self.cases.entry((file, case)).or_insert(new);
    }

    /// How many findings were accepted.
    pub(super) fn accepted_count(&self) -> usize {
        self.accepted
    }

    /// The cases that left nothing out, without those of lists for which nothing was looked for.
    pub(super) fn idle_cases(&self, is_looked_for: impl Fn(ReportSection) -> bool) -> IdleCases {
        let mut out = IdleCases::default();
        for (key, case) in self.cases.iter().filter(|(key, _)| !self.found.contains(*key)) {
            let list = [ReportSection::Statistics, ReportSection::Bindings, ReportSection::Agreeing];
            let list = list.into_iter().find(|list| case["list"] == list.name());
            if !self.read.contains(&key.0) {
                out.unread += 1;
                let file = case["file"].as_str().unwrap_or_default();
                if out.unread_files.iter().all(|known| known != file) {
                    out.unread_files.push(file.to_owned());
                }
            } else if list.is_none_or(&is_looked_for) {
                out.gone += 1;
            }
        }
        out
    }

    /// Writes the cases, and puts the file in its place.
    pub(super) fn write(&self, mut file: NewFile) -> Result<(), String> {
        for case in self.cases.values() {
            file.add(format!("{case}\n").as_bytes())?;
        }
        file.finish().map(drop)
    }
}
