//! What is about to be committed: which of the staged files the next commit changes, and where they are asked for.

use super::arguments::Input;
use super::documents::{self, STANDARD_INPUT, Source};
use super::index::{StagedFile, StagedFiles};
use crate::reader::UnreadParts;
use geneva_host::files::whole_path;
use geneva_host::git::{Blob, Repository, StagedChange};
use geneva_host::printable::shown_path;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, HashMap};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// A repository with what the next commit changes in it.
struct Changed {
    repository: Arc<Repository>,
    changes: Vec<StagedChange>,
    conflicts: Vec<PathBuf>,
    /// The files of the commit that is being merged, if one is: what they have is not new.
    merged: HashMap<PathBuf, Blob>,
}

/// What is staged in the repositories around the arguments.
pub(crate) struct Staging {
    /// The arguments with their whole paths.
    arguments: Vec<(PathBuf, PathBuf)>,
    by_top: BTreeMap<PathBuf, Changed>,
    files: Arc<StagedFiles>,
}

impl Staging {
    /// Reads the lists of what is staged, and of what of it differs from a revision. Without a revision that is `HEAD`, or nothing
    /// before the first commit; without arguments they are of the whole repository around the working directory.
    pub(super) fn new(revision: Option<&str>, arguments: &[PathBuf]) -> Result<Self, String> {
        let mut out = Self { arguments: Vec::new(), by_top: BTreeMap::new(), files: Arc::default() };
        let mut files = StagedFiles::default();
        let here = [PathBuf::from(".")];
        for argument in if arguments.is_empty() { &here } else { arguments } {
            if argument.as_os_str() == STANDARD_INPUT {
                return Err("standard input is not staged; give --staged files, or leave it out".to_owned());
            }
            let mut whole = whole_path(argument);
            // The file or its folder may be gone from the disk.
            let repository = whole.ancestors().find_map(Repository::containing).ok_or_else(|| {
                format!(
                    "{} is in no repository of git; give --staged files of one, or leave it out",
                    shown_path(argument)
                )
            })?;
            let top = repository.top().to_owned();
            let mut shown = argument.clone();
            if arguments.is_empty() {
                let up = whole.strip_prefix(&top).map_or(0, |inside| inside.components().count());
                shown = std::iter::repeat_n(Component::ParentDir, up).collect();
                whole.clone_from(&top);
            }
            out.arguments.push((shown, whole));
            if let Entry::Vacant(place) = out.by_top.entry(top.clone()) {
                let changed = Changed::new(repository, revision)?;
                let all = changed.repository.staged_files()?.into_iter();
                all.for_each(|(path, blob)| files.add(top.join(path), changed.repository.clone(), blob));
                place.insert(changed);
            }
        }
        out.files = Arc::new(files);
        Ok(out)
    }

    /// All staged files, from which definitions are taken.
    pub(super) fn files(&self) -> Arc<StagedFiles> {
        self.files.clone()
    }

    /// The changed files that the arguments name, in the order of their names, and how many in folders are not read.
    pub(super) fn sources(&self, input: Option<Input>, unread: &mut UnreadParts) -> Vec<Result<Source, String>> {
        let mut out = Vec::new();
        for (shown, whole) in &self.arguments {
            // A submodule has its own index.
            let Some((top, changed)) = self.by_top.iter().rfind(|(top, _)| whole.starts_with(top)) else { continue };
            let inside = whole.strip_prefix(top).unwrap_or(Path::new(""));
            let is_folder = inside.as_os_str().is_empty()
                || whole.is_dir()
                || self.files.below(whole).next().is_some_and(|file| file != whole)
                || changed.changes.iter().any(|change| change.path != inside && change.path.starts_with(inside));
            if is_folder {
                changed.sources_below(inside, shown, input, &mut out, unread);
                continue;
            }
            let change = changed.changes.iter().find(|change| change.path == inside);
            let file = change.and_then(|change| changed.file(change));
            if changed.conflicts.iter().any(|path| path == inside) {
                out.push(Err(conflict(shown)));
            } else if let Some(file) = file {
                out.push(Source::staged(shown.clone(), input, None, file));
            } else if change.is_none() && self.files.blob(whole).is_none() {
                out.push(Err(format!(
                    "{} is not staged in git; give a file or folder that is, or leave out --staged",
                    shown_path(shown)
                )));
            }
        }
        out
    }
}

fn conflict(path: &Path) -> String {
    format!(
        "{}: a merge left this file in conflict, so nothing of it is staged; resolve it and add it",
        shown_path(path)
    )
}

impl Changed {
    fn new(repository: Repository, revision: Option<&str>) -> Result<Self, String> {
        let commit = repository.commit(revision.unwrap_or("HEAD"))?;
        if let (None, Some(revision)) = (&commit, revision) {
            return Err(super::since::unknown_revision(revision, &repository));
        }
        let mut changes = repository.staged_changes(commit.as_deref())?;
        changes.sort_by(|one, other| one.path.cmp(&other.path));
        let conflicts = repository.conflicts()?;
        let other = if revision.is_none() { repository.commit("MERGE_HEAD")? } else { None };
        let merged = other.map(|other| repository.files(&other)).transpose()?.into_iter().flatten().collect();
        Ok(Self { repository: Arc::new(repository), changes, conflicts, merged })
    }

    fn file(&self, change: &StagedChange) -> Option<StagedFile> {
        let StagedChange { path, staged, earlier } = change.clone();
        let earlier = earlier.into_iter().chain(self.merged.get(&path).cloned()).collect();
        Some(StagedFile::new(self.repository.clone(), staged?, earlier))
    }

    /// The changed files below a folder that a search of it on the disk would find, without lines of JSON.
    fn sources_below(
        &self,
        inside: &Path,
        shown: &Path,
        input: Option<Input>,
        out: &mut Vec<Result<Source, String>>,
        unread: &mut UnreadParts,
    ) {
        let found = |path: &Path| {
            let below = path.strip_prefix(inside).ok()?.to_owned();
            documents::is_searched(&below).then_some(below)
        };
        for change in &self.changes {
            let Some(below) = found(&change.path) else { continue };
            let Some(file) = self.file(change) else { continue };
            if !documents::is_taken_from_folder(&below) {
                documents::count_unread(&below, unread);
                continue;
            }
            out.push(Source::staged(shown.join(below), input, Some(shown.to_owned()), file));
        }
        for path in &self.conflicts {
            if let Some(below) = found(path).filter(|below| documents::is_taken_from_folder(below)) {
                out.push(Err(conflict(&shown.join(below))));
            }
        }
    }
}
