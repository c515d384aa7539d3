//! The index of git: what is staged in the place of the files on the disk.
//!
//! The work tree is not looked at. A file that is right on the disk is reported if it is staged with a mistake, and the other way round.

use crate::reader::LONGEST;
use geneva_host::files;
use geneva_host::git::{Blob, Repository};
use geneva_host::printable::shown_path;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The staged files of the repositories around the arguments, by their whole paths.
#[derive(Default)]
pub(crate) struct StagedFiles {
    files: BTreeMap<PathBuf, (Arc<Repository>, Blob)>,
}

impl StagedFiles {
    /// Adds what is staged at a path.
    pub(super) fn add(&mut self, file: PathBuf, repository: Arc<Repository>, blob: Blob) {
        self.files.insert(file, (repository, blob));
    }

    /// What is staged at a path.
    pub(super) fn blob(&self, file: &Path) -> Option<&Blob> {
        self.files.get(file).map(|(_, blob)| blob)
    }

    /// The files in a folder, without those in its folders.
    pub(super) fn files_in(&self, folder: &Path) -> Vec<PathBuf> {
        let below = self.below(folder);
        below.filter(|file| file.parent() == Some(folder)).cloned().collect()
    }

    /// The files below a folder, or the file itself if it is one.
    pub(super) fn below(&self, folder: &Path) -> impl Iterator<Item = &PathBuf> {
        let from = self.files.range(folder.to_owned()..);
        from.map(|(file, _)| file).take_while(move |file| file.starts_with(folder))
    }

    /// The bytes that are staged at a path, at most so many.
    pub(super) fn read(&self, file: &Path, most: u64, wanted: &str) -> Result<Vec<u8>, String> {
        let (repository, blob) = self
            .files
            .get(file)
            .ok_or_else(|| format!("{} is not staged in git; give {wanted} that is", shown_path(file)))?;
        content(repository, blob, &shown_path(file), most)
    }
}

/// The bytes of a blob, at most so many.
fn content(repository: &Repository, blob: &Blob, name: &str, most: u64) -> Result<Vec<u8>, String> {
    let bytes = repository.content(blob).map_err(|why| format!("{name}: {why}"))?;
    files::read_stream(bytes.as_slice(), name, most)
}

/// A file that the next commit brings or changes.
#[derive(Debug)]
pub(crate) struct StagedFile {
    repository: Arc<Repository>,
    staged: Blob,
    /// What it was in each of the commits before in which it was there.
    earlier: Vec<Blob>,
}

impl StagedFile {
    /// What is staged, with what it was in each of the commits before in which it was there.
    pub(super) fn new(repository: Arc<Repository>, staged: Blob, earlier: Vec<Blob>) -> Self {
        Self { repository, staged, earlier }
    }

    /// What is staged; `name` is for errors.
    pub(super) fn content(&self, name: &str) -> Result<Vec<u8>, String> {
        content(&self.repository, &self.staged, name, LONGEST as u64)
    }

    /// What it was: nothing if it is new, and several texts if commits are merged.
    pub(super) fn earlier_contents(&self, name: &str) -> Result<Vec<Vec<u8>>, String> {
        self.earlier.iter().map(|blob| content(&self.repository, blob, name, LONGEST as u64)).collect()
    }
}
