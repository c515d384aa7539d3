//! Where the book's workspace is.

use anyhow::Context;
use std::path::{Path, PathBuf};

/// The workspace around the current directory.
pub(crate) fn root() -> anyhow::Result<PathBuf> {
    let here = std::env::current_dir().context("the current directory doesn't exist; change to one that does")?;
    find(&here).map(Path::to_owned).with_context(|| {
        format!(
            "no book found: neither {} nor a folder above it holds book/book.toml and crates/documents; \
             change to a folder of the project and try again",
            here.display()
        )
    })
}

fn find(here: &Path) -> Option<&Path> {
    here.ancestors().find(|folder| is_workspace(folder))
}

fn is_workspace(folder: &Path) -> bool {
    folder.join("book/book.toml").is_file() && folder.join("crates/documents/Cargo.toml").is_file()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn workspace_in(folder: &Path) {
        for inside in ["book/src", "crates/documents"] {
            fs::create_dir_all(folder.join(inside)).expect("a temporary folder can be written");
        }
        for file in ["book/book.toml", "crates/documents/Cargo.toml"] {
            fs::write(folder.join(file), "").expect("a temporary folder can be written");
        }
    }

    #[test]
    fn it_is_looked_for_upwards_and_nowhere_else() {
        let temporary = tempfile::tempdir().expect("a temporary folder");
        let near = temporary.path().join("near");
        workspace_in(&near);
        assert_eq!(find(&near.join("book/src")), Some(&*near));
        assert_eq!(find(&near), Some(&*near));
        assert_eq!(find(temporary.path()), None);
    }

    #[test]
    fn it_is_found_from_here() {
        assert!(root().expect("the test runs in the workspace").join("crates/geneva").is_dir());
    }
}
