//! Claims that a reader checks in the page: the ledger's own checks, compiled for WebAssembly, and the scripts that ask them.
//!
//! The builder makes a crate of two files below the target directory, which only calls the crate that has the ledger. So a book has
//! this by naming that crate, without a line of its own.

use crate::book::{Book, LedgerCrate};
use crate::cache::Shelf;
use crate::data::PageFile;
use crate::modules::{self, Compilation, THREAD};
use anyhow::Context;
use geneva_evidence::MOST_CHARACTERS;
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// What puts the buttons into a page; all else comes with the first touch.
pub(crate) const SCRIPT: &str = "data/verify.js";
const SCRIPT_TEXT: &str = include_str!("../theme/verify.js");
const PANEL: &str = include_str!("../theme/verify-panel.js");
const STYLE: &str = include_str!("../theme/verify.css");
/// The library of the crate that is made: its two files.
const LIBRARY: [(&str, &str); 2] =
    [("lib.rs", include_str!("../theme/verify-module.rs")), ("exports.rs", include_str!("../../live/src/exports.rs"))];

/// What is in a page that asks for the script: a claim's note, the list of all claims, a prepared check.
const ASKING: [&str; 3] = ["class=\"note\" id=\"note-", "<ul class=\"claims\"", " data-verify"];

/// The checks of a book's ledger as text, made from the workspace `root`, or why they cannot be made; none if the book names no crate
/// with a ledger.
pub(crate) fn packed_checks(book: &Book, root: &Path, shelf: &Shelf) -> Option<Result<String, String>> {
    let of = book.ledger_crate?;
    let compiled = compiled(&of, root).map_err(|why| format!("{why:#}"));
    Some(compiled.and_then(|module| modules::packed(&module, shelf)))
}

/// Puts the script into each page that has something to check, and gives the files that it loads.
///
/// A module that cannot be made is left out, with the reason on standard error: the book is whole without it.
pub(crate) fn load_into_pages(
    book: &Book,
    pages: &mut dyn Iterator<Item = &mut String>,
    packed: Option<Result<String, String>>,
    shelf: &Shelf,
) -> anyhow::Result<Vec<PageFile>> {
    let asking: Vec<&mut String> = pages.filter(|page| ASKING.iter().any(|part| page.contains(part))).collect();
    let checks = book.ledger_crate.zip(packed).filter(|_| !asking.is_empty());
    let Some((of, packed)) = checks else { return Ok(Vec::new()) };
    let packed = match packed {
        Ok(packed) => packed,
        Err(why) => {
            eprintln!("No claim can be checked in the pages of this book: {why}");
            return Ok(Vec::new());
        }
    };
    for page in asking {
        page.push_str(&format!("\n\n<script src=\"{SCRIPT}\" defer></script>\n"));
    }
    let record = shelf.text("record", &[], || record(book, &of))?;
    Ok(vec![
        PageFile::text_file("verify.js", SCRIPT_TEXT.to_owned()),
        PageFile::text_file("verify-panel.js", format!("{THREAD}{PANEL}")),
        PageFile::text_file("verify.css", STYLE.to_owned()),
        PageFile::text_file("verify-module.js", format!("{record}genevaModule('{packed}');\n")),
    ])
}

/// The verdicts with which the book is built, in plain words, how many characters may be put in, and the command that checks a claim.
fn record(book: &Book, of: &LedgerCrate) -> anyhow::Result<String> {
    let verdicts: BTreeMap<&str, &str> =
        book.ledger.verdicts().iter().map(|judged| (judged.claim.id, judged.plain().words())).collect();
    let record = serde_json::json!({ "command": of.command, "most": MOST_CHARACTERS, "verdicts": verdicts });
    Ok(format!("genevaRecord = {};\n", serde_json::to_string(&record)?))
}

/// The compiled checks of a ledger.
fn compiled(of: &LedgerCrate, root: &Path) -> anyhow::Result<Vec<u8>> {
    let folder = root.join(of.folder).canonicalize().with_context(|| format!("no folder {}", of.folder))?;
    let workspace = folder.ancestors().find(|above| above.join(LOCK).is_file());
    let workspace = workspace.with_context(|| format!("no {LOCK} in {} or above it", folder.display()))?;
    let target = modules::target_directory(workspace, root);
    let own = made(of, &folder, workspace, &target)?;
    let compilation = Compilation { workspace, folder: &own, package: None, target: &target, profile: PROFILE };
    compilation.module(&crate_name(of)).map_err(anyhow::Error::msg)
}

const LOCK: &str = "Cargo.lock";
/// The profile of a crate that is made. What a workspace sets for single packages in the profile of its figures is not meant for it.
const PROFILE: &str = "verify";
/// The folder below the target directory in which crates are made.
const MADE: &str = "verify";

/// The name of the crate that is made: books that share a target directory have modules of their own.
fn crate_name(of: &LedgerCrate) -> String {
    format!("verify-{}", of.package)
}

/// The folder of the crate that calls the ledger's, with its files as they should be.
fn made(of: &LedgerCrate, folder: &Path, workspace: &Path, target: &Path) -> anyhow::Result<PathBuf> {
    let own = target.join(MADE).join(of.package);
    let source = own.join("src");
    fs::create_dir_all(&source).with_context(|| format!("cannot make {}", source.display()))?;
    let path = folder.to_str().with_context(|| format!("{} is not UTF-8", folder.display()))?;
    let manifest = format!(
        "[package]\nname = \"{}\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n[lib]\ncrate-type = [\"cdylib\"]\n\n\
         [dependencies]\nledger = {{ package = {:?}, path = {path:?} }}\n\n[workspace]\n\n{}",
        crate_name(of),
        of.package,
        modules::PROFILE_SETTINGS.replace(modules::PROFILE, PROFILE)
    );
    for (name, text) in LIBRARY {
        write_if_other(&source.join(name), text)?;
    }
    write_if_other(&own.join("Cargo.toml"), &manifest)?;
    // Cargo takes the versions of the workspace, and leaves out what is not needed.
    let lock = workspace.join(LOCK);
    let versions = fs::read_to_string(&lock).with_context(|| format!("cannot read {}", lock.display()))?;
    let known = own.join("workspace.lock");
    if !own.join(LOCK).is_file() || fs::read_to_string(&known).is_ok_and(|known| known != versions) {
        write_if_other(&own.join(LOCK), &versions)?;
    }
    // After the other one, so that a build at the same time never finds none.
    write_if_other(&known, &versions)?;
    Ok(own)
}

/// Writes a file that does not hold this text already, whole.
fn write_if_other(path: &Path, text: &str) -> anyhow::Result<()> {
    if fs::read_to_string(path).is_ok_and(|known| known == text) {
        return Ok(());
    }
    // Another build may read it now.
    let write = || {
        let mut file = NamedTempFile::new_in(path.parent().unwrap_or(Path::new(".")))?;
        file.write_all(text.as_bytes())?;
        file.persist(path)?;
        Ok::<_, std::io::Error>(())
    };
    write().with_context(|| format!("cannot write {}", path.display()))
}
