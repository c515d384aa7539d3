//! Accepted cases: a file with a line of JSON for each, which people may edit and add reasons to.

use super::nearest::missing;
use crate::reader::LONGEST;
use crate::tell::finding::ChainFinding;
use geneva_host::files::{self, NewFile};
use geneva_host::printable::shown_path;
use serde_json::{Value, json};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

/// The cases by file and fingerprint.
#[derive(Default)]
pub(crate) struct Baseline {
    cases: BTreeMap<(String, String), Value>,
    met: Cell<usize>,
}

/// What stays the same of a finding when lines move.
pub(crate) fn fingerprint(finding: &ChainFinding) -> String {
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    format!("{}: {} | {}", finding.verdict.name(), squeezed(&finding.left), squeezed(&finding.right))
}

/// A path without `./`, so that a file has one name however it was reached.
fn plain(file: &str) -> String {
    let parts = Path::new(file).components().filter(|part| *part != std::path::Component::CurDir);
    parts.collect::<std::path::PathBuf>().to_string_lossy().into_owned()
}

impl Baseline {
    /// Reads the file.
    pub(super) fn read(path: &Path) -> Result<Self, String> {
        let wrong = |why: String| format!("{}: {why}; give a file that --accept wrote", shown_path(path));
        const WANTED: &str = "a file that --accept wrote";
        if let Some(why) = missing(path, WANTED) {
            return Err(why);
        }
        let bytes = files::read(path, LONGEST as u64, WANTED)?;
        let text = String::from_utf8(bytes).map_err(|_| wrong("this is not text in UTF-8".to_owned()))?;
        let mut cases = BTreeMap::new();
        for (number, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
            let case: Value = serde_json::from_str(line).map_err(|why| wrong(format!("line {}: {why}", number + 1)))?;
            let key = |name: &str| case[name].as_str().map(str::to_owned);
            let (Some(file), Some(of)) = (key("file"), key("case")) else {
                return Err(wrong(format!("line {}: an accepted case needs `file` and `case`", number + 1)));
            };
            cases.insert((plain(&file), of), case);
        }
        Ok(Self { cases, met: Cell::new(0) })
    }

    /// Whether the lines of a file are accepted cases, and no documents.
    pub(super) fn is_in(path: &Path) -> bool {
        let mut line = Vec::new();
        let Ok(file) = files::open(path, "a file") else { return false };
        let read = BufReader::new(file).take(LONGEST as u64).read_until(b'\n', &mut line);
        let first: Option<Value> = read.ok().and_then(|_| serde_json::from_slice(&line).ok());
        first.is_some_and(|first| first["case"].is_string() && first["file"].is_string() && first["text"].is_null())
    }

    /// Whether a finding is accepted.
    pub(super) fn is_accepted(&self, file: &str, finding: &ChainFinding) -> bool {
        let found = self.cases.contains_key(&(plain(file), fingerprint(finding)));
        self.met.set(self.met.get() + usize::from(found));
        found
    }

    /// Accepts a finding; the reason of one that was accepted before is kept.
    pub(super) fn accept(&mut self, file: &str, finding: &ChainFinding) {
        self.met.set(self.met.get() + 1);
        let case = fingerprint(finding);
        let file = plain(file);
        let new = json!({ "file": file, "case": case, "why": "" });
        self.cases.entry((file, case)).or_insert(new);
    }

    /// How many findings were accepted.
    pub(super) fn accepted_count(&self) -> usize {
        self.met.get()
    }

    /// Writes the cases, and puts the file in its place.
    pub(super) fn write(&self, mut file: NewFile) -> Result<(), String> {
        for case in self.cases.values() {
            file.add(format!("{case}\n").as_bytes())?;
        }
        file.finish().map(drop)
    }
}
