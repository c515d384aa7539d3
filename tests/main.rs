//! What must hold between the crates: one file for each question.
//!
//! The files in this folder make two test programs. This one has what can be asked of the libraries, the book and the
//! repository. The other belongs to `crates/geneva`, starts in `command_line.rs` and has the files that run the command
//! line, whose names end in `_command`: Cargo tells the path of a built program only to the tests of its own package.

mod book_pages;
mod book_sources;
mod browser;
mod citing;
mod coverage;
mod crate_picture;
mod displays;
mod ebook;
mod first_page;
mod fonts;
mod live;
mod meanings;
mod mimic_decks;
mod moving_pictures;
mod old_addresses;
mod pin_over_the_engagement;
mod printed;
mod proofread_page;
mod prose;
mod records;

mod scoped;
mod search;
mod snapshots;
mod solver_record;
mod supply;
mod tidy;
mod typed;
mod verify_page;

use geneva_documents::LEDGER;
use geneva_evidence::{Decimal, numeric_tokens};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// A path inside the project.
fn path(inside: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(inside)
}

/// All files below a folder of the project whose names end in one of `endings`, with their text.
#[track_caller]
fn files(folder: &str, endings: &[&str]) -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    let mut folders = vec![path(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder") {
            let entry = entry.expect("readable").path();
            if entry.is_dir() {
                folders.push(entry);
            } else if endings.iter().any(|ending| entry.to_string_lossy().ends_with(ending)) {
                let text = std::fs::read_to_string(&entry).expect("text");
                found.push((entry, text));
            }
        }
    }
    found.sort();
    assert!(!found.is_empty(), "no file in {folder} ends in {endings:?}");
    found
}

/// The texts that have formulas, numbers and examples of ours: those of the pages, and the documents beside the book.
#[track_caller]
fn texts() -> Vec<(PathBuf, String)> {
    let mut found = files("book/src", &[".md"]);
    found.extend(documents());
    found
}

/// The documents beside the book, which belong to its project: a decision tells of its day and isn't one of them.
#[track_caller]
fn documents() -> Vec<(PathBuf, String)> {
    let mut found = files("docs", &[".md"]);
    found.retain(|(path, _)| path.parent().is_some_and(|folder| folder.ends_with("docs")));
    found
}

/// Whether a number tells where it comes from: a decimal of three digits or more that are no outer zeros. A half, a zero
/// or a one with its zeros is anybody's.
fn is_telling(number: &str) -> bool {
    let digits = number.trim_matches(['0', '.']).chars().filter(char::is_ascii_digit).count();
    number.contains('.') && digits >= 3
}

/// The claim that prints this number, or whose erratum corrects to it, if the number tells where it comes from.
fn owner(number: &str) -> Option<&'static str> {
    // The first claim of each number, listed once for all that ask.
    static OWNERS: OnceLock<HashMap<String, &str>> = OnceLock::new();
    let owners = OWNERS.get_or_init(|| {
        let mut owners = HashMap::new();
        for claim in LEDGER.claims() {
            let corrected = claim.erratum.as_ref().map(|erratum| erratum.corrected);
            for text in [claim.printed].into_iter().chain(corrected).filter(|text| text.parse::<Decimal>().is_ok()) {
                for token in numeric_tokens(text) {
                    owners.entry(token).or_insert(claim.id);
                }
            }
        }
        owners
    });
    owners.get(number).copied().filter(|_| is_telling(number))
}
