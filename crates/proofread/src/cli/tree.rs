//! Where files are: on the disk, or in the index of git, which has them as they will be committed.

use super::index::StagedFiles;
use geneva_host::files;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Files by their paths.
#[derive(Clone, Default)]
pub(crate) enum FileTree {
    #[default]
    Disk,
    /// The files that are staged, whatever is on the disk in their places.
    Staged(Arc<StagedFiles>),
}

impl FileTree {
    /// The one name of a regular file, by which it is known however it is reached; none if there is no such file.
    pub(super) fn file(&self, path: &Path) -> Option<PathBuf> {
        match self {
            Self::Disk => path.canonicalize().ok().filter(|file| file.is_file()),
            Self::Staged(staged) => Some(files::whole_path(path)).filter(|file| staged.blob(file).is_some()),
        }
    }

    /// What is in a folder, in any order: its files and, on the disk, its folders.
    pub(super) fn entries(&self, folder: &Path) -> Vec<PathBuf> {
        match self {
            Self::Disk => {
                let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
                entries.map(|entry| entry.path()).collect()
            }
            Self::Staged(staged) => staged.files_in(folder),
        }
    }

    /// The bytes of a file, at most so many; `wanted` says in errors what to give instead.
    pub(super) fn read(&self, file: &Path, most: u64, wanted: &str) -> Result<Vec<u8>, String> {
        match self {
            Self::Disk => files::read(file, most, wanted),
            Self::Staged(staged) => staged.read(file, most, wanted),
        }
    }
}
