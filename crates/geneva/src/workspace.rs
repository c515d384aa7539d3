//! Where the book's workspace is.

use anyhow::Context;
use std::path::{Path, PathBuf};

/// The workspace around the current directory, or else the one in which the program was compiled.
pub fn root() -> anyhow::Result<PathBuf> {
    let here = std::env::current_dir().context("there is no current directory: go to one that exists")?;
    let compiled_in = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap_or(Path::new("/"));
    find(&here, compiled_in).with_context(|| {
        format!(
            "no book found: neither {} nor a folder above it holds book/book.toml and crates/ledger; \
             go to the workspace of the book",
            here.display()
        )
    })
}

fn find(here: &Path, otherwise: &Path) -> Option<PathBuf> {
    here.ancestors().chain([otherwise]).find(|folder| is_workspace(folder)).map(Path::to_owned)
}

fn is_workspace(folder: &Path) -> bool {
    folder.join("book/book.toml").is_file() && folder.join("crates/ledger/Cargo.toml").is_file()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn workspace_in(folder: &Path) {
        for inside in ["book/src", "crates/ledger"] {
            fs::create_dir_all(folder.join(inside)).expect("a temporary folder can be written");
        }
        for file in ["book/book.toml", "crates/ledger/Cargo.toml"] {
            fs::write(folder.join(file), "").expect("a temporary folder can be written");
        }
    }

    #[test]
    fn it_is_looked_for_upwards_and_then_where_the_program_was_compiled() {
        let temporary = tempfile::tempdir().expect("a temporary folder");
        let (near, far) = (temporary.path().join("near"), temporary.path().join("far"));
        workspace_in(&near);
        workspace_in(&far);
        assert_eq!(find(&near.join("book/src"), &far), Some(near.clone()));
        assert_eq!(find(temporary.path(), &far), Some(far));
        assert_eq!(find(temporary.path(), temporary.path()), None);
    }

    #[test]
    fn it_is_found_from_here() {
        assert!(root().expect("the test runs in the workspace").join("crates/geneva").is_dir());
    }
}
