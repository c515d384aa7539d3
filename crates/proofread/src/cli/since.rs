//! What a change brings in: findings that the text of an earlier revision does not have.
//!
//! Texts may be by strangers, so that nothing of a text's folder is asked or run. The repository is the one around an argument,
//! and of that only the objects are read. A file that is not in the revision is new, and so is one in a repository within.

use super::baseline::fingerprint;
use super::documents::{Document, STANDARD_INPUT, documents_in};
use super::index::StagedFile;
use crate::tell::finding::ChainFinding;
use geneva_host::git::{Blob, Repository};
use geneva_host::printable::{escape_and_shorten, shown_path};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A commit and its files.
struct Commit {
    repository: Repository,
    files: HashMap<PathBuf, Blob>,
}

/// An earlier revision, of the repository around each argument.
pub(crate) struct Since {
    commits: HashMap<PathBuf, Arc<Commit>>,
}

/// A document at the earlier revision.
pub(crate) enum EarlierText {
    /// It was as it is.
    Same,
    /// It was another text, or several of them if commits are merged.
    Other(Vec<Document>),
    /// It was not there.
    Missing,
}

impl EarlierText {
    /// Compares what a document was, in each of the commits in which it was there, with what it is.
    fn new(contents: Vec<Vec<u8>>, document: &Document) -> Self {
        // Of an archive, the text with the same name.
        let own = document.path.as_deref().map_or_else(|| document.name.clone(), |path| path.display().to_string());
        let found = |content| {
            let texts = documents_in(&own, content, document.input()).ok()?;
            texts.into_iter().find(|before| before.name == document.name)
        };
        let texts: Vec<Document> = contents.into_iter().filter_map(found).collect();
        if texts.iter().any(|before| before.checked_text() == document.checked_text()) {
            Self::Same
        } else if texts.is_empty() {
            Self::Missing
        } else {
            Self::Other(texts)
        }
    }

    /// What a staged document was.
    pub(super) fn of_staged(file: &StagedFile, document: &Document) -> Result<Self, String> {
        if document.path.is_none() {
            return Err(no_earlier_line(document));
        }
        Ok(Self::new(file.earlier_contents(&escape_and_shorten(&document.name))?, document))
    }
}

fn no_earlier_line(document: &Document) -> String {
    format!(
        "{}: a line of JSON has no earlier revision; leave out --since and --staged, or the file",
        escape_and_shorten(&document.name)
    )
}

impl Since {
    /// Looks the revision up in the repositories around the arguments. What an argument that leads nowhere lacks is not told here.
    pub(super) fn new(revision: &str, arguments: &[PathBuf]) -> Result<Self, String> {
        let mut by_top: HashMap<PathBuf, Arc<Commit>> = HashMap::new();
        let mut commits = HashMap::new();
        for argument in arguments {
            let name = shown_path(argument);
            if argument.as_os_str() == STANDARD_INPUT {
                return Err("standard input has no earlier revision; give --since files, or leave it out".to_owned());
            }
            if !argument.exists() {
                continue;
            }
            let repository = Repository::containing(argument).ok_or_else(|| {
                format!("{name} is in no repository of git; give --since files of one, or leave it out")
            })?;
            let commit = match by_top.get(repository.top()) {
                Some(known) => known.clone(),
                None => {
                    let top = repository.top().to_owned();
                    let found = commit(repository, revision).map_err(|why| format!("{name}: {why}"))?;
                    by_top.entry(top).or_insert(Arc::new(found)).clone()
                }
            };
            commits.insert(argument.clone(), commit);
        }
        Ok(Self { commits })
    }

    /// What a document was at the revision.
    pub(super) fn earlier_text(&self, document: &Document) -> Result<EarlierText, String> {
        let (Some(path), Some(argument)) = (&document.path, &document.argument) else {
            return Err(no_earlier_line(document));
        };
        let Some(Commit { repository, files }) = self.commits.get(argument).map(Arc::as_ref) else {
            return Ok(EarlierText::Missing);
        };
        let whole = std::fs::canonicalize(path).unwrap_or_else(|_| path.clone());
        let blob = whole.strip_prefix(repository.top()).ok().and_then(|name: &Path| files.get(name));
        let Some(blob) = blob else { return Ok(EarlierText::Missing) };
        let content = repository.content(blob).map_err(|why| format!("{}: {why}", shown_path(path)))?;
        Ok(EarlierText::new(vec![content], document))
    }
}

fn commit(repository: Repository, revision: &str) -> Result<Commit, String> {
    let name = repository.commit(revision)?.ok_or_else(|| unknown_revision(revision, &repository))?;
    let files = repository.files(&name)?.into_iter().collect();
    Ok(Commit { repository, files })
}

/// What is told of a revision that git does not know.
pub(super) fn unknown_revision(revision: &str, repository: &Repository) -> String {
    format!(
        "git does not know the revision `{}` in {}; give a commit, a branch or a tag, and fetch it first where git has only a \
         part of the history",
        escape_and_shorten(revision),
        shown_path(repository.top())
    )
}

/// Leaves what was in none of the texts before; a case that occurs twice must have been twice in one of them.
pub(crate) fn remove_known(findings: &mut Vec<ChainFinding>, before: &[Vec<ChainFinding>]) {
    let mut known: HashMap<String, usize> = HashMap::new();
    for text in before {
        let mut counts: HashMap<String, usize> = HashMap::new();
        for finding in text {
            *counts.entry(fingerprint(finding)).or_default() += 1;
        }
        for (case, count) in counts {
            let most = known.entry(case).or_default();
            *most = count.max(*most);
        }
    }
    findings.retain(|finding| match known.get_mut(&fingerprint(finding)) {
        Some(left) if *left > 0 => {
            *left -= 1;
            false
        }
        _ => true,
    });
}
