//! The compiled crates that the chapters use.
//!
//! A `target` directory may hold several builds of one crate, and rustdoc, given such a folder, refuses to
//! choose. Cargo knows which files went into one build, and says so.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, ensure};

/// Fills `target/book-libs` with the libraries of one build of a package, and no others.
pub(crate) fn link(root: &Path, package: &str) -> anyhow::Result<PathBuf> {
    let folder = root.join("target").join("book-libs");
    let trouble = || format!("cannot write {}", folder.display());
    if folder.exists() {
        fs::remove_dir_all(&folder).with_context(trouble)?;
    }
    fs::create_dir_all(&folder).with_context(trouble)?;
    for library in built(root, package)? {
        let Some(name) = library.file_name() else { continue };
        let link = folder.join(name);
        if !link.exists() && fs::hard_link(&library, &link).is_err() {
            fs::copy(&library, &link).with_context(trouble)?;
        }
    }
    folder.canonicalize().with_context(trouble)
}

/// Builds the library of a package and lists the libraries that went into it.
fn built(root: &Path, package: &str) -> anyhow::Result<Vec<PathBuf>> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .current_dir(root)
        .args(["build", "--quiet", "--package", package, "--lib"])
        .arg("--message-format=json-render-diagnostics")
        .output()
        .context("cannot run cargo: install Rust from https://rustup.rs")?;
    ensure!(
        output.status.success(),
        "cargo does not build the crates that the chapters use:\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let mut libraries = Vec::new();
    for message in String::from_utf8_lossy(&output.stdout).lines() {
        let message: serde_json::Value = serde_json::from_str(message).context("cargo's list of libraries")?;
        if message["reason"] != "compiler-artifact" {
            continue;
        }
        let files = message["filenames"].as_array().into_iter().flatten();
        libraries.extend(files.filter_map(|file| file.as_str()).map(PathBuf::from).filter(|file| is_library(file)));
    }
    Ok(libraries)
}

fn is_library(file: &Path) -> bool {
    file.extension().is_some_and(|kind| ["rlib", "so", "dylib", "dll"].iter().any(|library| kind == *library))
}
