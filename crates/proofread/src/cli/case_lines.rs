//! Files whose lines are accepted cases, and no documents.

use crate::reader::LONGEST;
use geneva_host::files;
use serde_json::Value;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

/// Whether the lines of a file are accepted cases, and no documents.
pub(super) fn are_accepted_cases(path: &Path) -> bool {
    let mut line = Vec::new();
    let Ok(file) = files::open(path, "a file") else { return false };
    let read = BufReader::new(file).take(LONGEST as u64).read_until(b'\n', &mut line);
    let first: Option<Value> = read.ok().and_then(|_| serde_json::from_slice(&line).ok());
    first.is_some_and(|first| first["case"].is_string() && first["file"].is_string() && first["text"].is_null())
}
