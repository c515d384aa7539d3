//! Where the engine is, on which the new crate depends.

use crate::printable::shown_path;
use anyhow::{Context, bail};
use geneva_host::printable::in_words;
use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the project, with the crates of the engine.
pub(super) struct Engine {
    /// The folder, from the root of the file system.
    pub folder: String,
    /// The versions of all packages that it is built from.
    pub lock: Vec<u8>,
}

/// What the folder must have.
const NEEDED: [&str; 4] =
    ["Cargo.lock", "crates/evidence/Cargo.toml", "crates/press/Cargo.toml", "crates/proofread/Cargo.toml"];

impl Engine {
    /// The engine in this folder; without one, that of the project around the current directory, around this program, or from which
    /// it was compiled.
    pub(super) fn find(asked: Option<&Path>) -> anyhow::Result<Self> {
        if let Some(asked) = asked {
            let Some(lacking) = NEEDED.iter().find(|needed| !asked.join(needed).is_file()) else {
                return Self::new(asked);
            };
            bail!(
                "--engine {} has no {lacking}; give the folder of the project that has book, crates and examples",
                shown_path(asked)
            );
        }
        let starts =
            [std::env::current_dir().ok(), std::env::current_exe().ok(), Some(env!("CARGO_MANIFEST_DIR").into())];
        let found = starts.iter().flatten().find_map(|start| around(start));
        Self::new(&found.context(
            "the engine is not found from here, nor from this program; give the folder of the project with --engine DIR",
        )?)
    }

    fn new(folder: &Path) -> anyhow::Result<Self> {
        let shown = shown_path(folder);
        let unreadable = |error: std::io::Error| {
            anyhow::Error::msg(format!(
                "cannot read {shown}: {}; give another folder with --engine DIR",
                in_words(&error)
            ))
        };
        let whole = fs::canonicalize(folder).map_err(unreadable)?;
        let lock = fs::read(whole.join(NEEDED[0])).map_err(unreadable)?;
        let folder = whole.to_str();
        let folder = folder.with_context(|| format!("--engine {shown} is not named in UTF-8; give another folder"))?;
        Ok(Self { folder: folder.to_owned(), lock })
    }
}

/// The project around a folder or a file.
fn around(start: &Path) -> Option<PathBuf> {
    let is_project = |folder: &&Path| NEEDED.iter().all(|needed| folder.join(needed).is_file());
    start.ancestors().find(is_project).map(Path::to_owned)
}
