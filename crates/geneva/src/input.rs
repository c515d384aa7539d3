//! Reading a user's text files: a deck, its data, the copy of a source.

use crate::printable::{in_words, shown_path};
use anyhow::{Context, anyhow, bail, ensure};
use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

/// The name that stands for standard input.
pub const STANDARD_INPUT: &str = "-";

/// Most bytes of a file or of standard input.
const MOST_BYTES: u64 = 16_000_000;

/// The bytes of standard input.
///
/// # Errors
///
/// It cannot be read, or is larger than [`MOST_BYTES`].
pub fn standard_input() -> anyhow::Result<Vec<u8>> {
    bounded(std::io::stdin().lock(), "standard input")
}

/// The bytes of a file; `wanted` says in errors what to give instead.
///
/// # Errors
///
/// It is no regular file, cannot be read, or is larger than [`MOST_BYTES`].
pub fn file(path: &Path, wanted: &str) -> anyhow::Result<Vec<u8>> {
    let name = shown_path(path);
    let unreadable = |error| anyhow!("cannot read {name}: {}; give {wanted}", in_words(&error));
    // Asked before the file is opened: opening a pipe waits for somebody to write.
    let there = fs::metadata(path).map_err(unreadable)?;
    ensure!(!there.is_dir(), "{name} is a folder; give {wanted}");
    ensure!(there.is_file(), "{name} is a pipe or a device, not a regular file; give {wanted}");
    bounded(File::open(path).map_err(unreadable)?, &name)
}

/// All that a source has, read no further than the bound: a file may grow while it is read.
fn bounded(source: impl Read, name: &str) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.take(MOST_BYTES + 1).read_to_end(&mut bytes).with_context(|| format!("cannot read {name}"))?;
    if bytes.len() as u64 > MOST_BYTES {
        bail!("{name} is larger than {} MB, the most that is read; give a shorter text", MOST_BYTES / 1_000_000);
    }
    Ok(bytes)
}

/// Bytes as text, without a byte order mark.
///
/// # Errors
///
/// They are no UTF-8.
pub fn text(name: &str, bytes: Vec<u8>) -> anyhow::Result<String> {
    let text = String::from_utf8(bytes).map_err(|_| anyhow!("{name} is not text in UTF-8; give cards in UTF-8"))?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}
