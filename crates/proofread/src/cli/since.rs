//! What a change brings in: findings that the text of an earlier revision does not have.

use super::baseline::fingerprint;
use super::documents::Document;
use crate::finding::Finding;
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

/// An earlier revision, of the repository in which each file is.
pub(crate) struct Since {
    revision: String,
    changed: RefCell<HashMap<PathBuf, BTreeSet<PathBuf>>>,
}

fn git(folder: &Path, arguments: &[&OsStr]) -> Result<Vec<u8>, String> {
    let output = Command::new("git")
        .arg("-C")
        .arg(folder)
        .args(arguments)
        .output()
        .map_err(|why| format!("git cannot be started, which --since needs: {why}"))?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(format!("git: {}", said.lines().next().unwrap_or("it failed without a word")))
}

fn words<const N: usize>(words: [&str; N]) -> [&OsStr; N] {
    words.map(OsStr::new)
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    }
}

impl Since {
    pub fn new(revision: &str) -> Self {
        Self { revision: revision.to_owned(), changed: RefCell::default() }
    }

    fn path<'d>(&self, document: &'d Document) -> Result<&'d Path, String> {
        document.path.as_deref().ok_or_else(|| format!("{}: --since needs files", document.name))
    }

    /// Whether the file differs from the revision, or is not in it.
    pub fn changed(&self, document: &Document) -> Result<bool, String> {
        let path = self.path(document)?;
        let folder = folder_of(path);
        let whole = std::fs::canonicalize(path).map_err(|why| format!("{}: {why}", path.display()))?;
        let top = git(&folder, &words(["rev-parse", "--show-toplevel"]))?;
        let top = PathBuf::from(String::from_utf8_lossy(&top).trim_end());
        let mut known = self.changed.borrow_mut();
        if !known.contains_key(&top) {
            if self.revision.starts_with('-') {
                return Err(format!("`{}` is no revision", self.revision));
            }
            let revision = format!("{}^{{commit}}", self.revision);
            git(&top, &words(["rev-parse", "--verify", "--quiet", &revision]))
                .map_err(|_| format!("git does not know the revision `{}`", self.revision))?;
            let changed = git(&top, &words(["diff", "--name-only", "--no-renames", "-z", &self.revision, "--"]))?;
            let new = git(&top, &words(["ls-files", "--others", "--exclude-standard", "-z"]))?;
            let names = [changed, new].concat();
            let names = names.split(|byte| *byte == 0).filter(|name| !name.is_empty());
            let base = std::fs::canonicalize(&top).unwrap_or_else(|_| top.clone());
            let paths = names.map(|name| base.join(String::from_utf8_lossy(name).as_ref())).collect();
            known.insert(top.clone(), paths);
        }
        Ok(known.get(&top).is_some_and(|paths| paths.contains(&whole)))
    }

    /// The text of the file at the revision, or none if it was not there.
    pub fn text(&self, document: &Document) -> Result<Option<String>, String> {
        let path = self.path(document)?;
        let Some(name) = path.file_name() else { return Ok(None) };
        let object = format!("{}:./{}", self.revision, name.to_string_lossy());
        let text = git(&folder_of(path), &words(["show", &object]));
        Ok(text.ok().map(|bytes| String::from_utf8_lossy(&bytes).into_owned()))
    }
}

/// Leaves what was not there before; a case that occurs twice must have been there twice.
pub(crate) fn remove_known(findings: &mut Vec<Finding>, before: &[Finding]) {
    let mut known: HashMap<String, usize> = HashMap::new();
    for finding in before {
        *known.entry(fingerprint(finding)).or_default() += 1;
    }
    findings.retain(|finding| match known.get_mut(&fingerprint(finding)) {
        Some(left) if *left > 0 => {
            *left -= 1;
            false
        }
        _ => true,
    });
}
