//! What every log of findings for code review has: the Static Analysis Results Interchange Format, version 2.1.0 (OASIS).

use crate::tell::line_index::LineColumn;
use geneva_host::files::whole_path;
use geneva_host::git::Repository;
use serde_json::{Value, json};
use std::path::{Component, Path};

/// Where a file is, as code review names it: by its path in its repository, or below the working directory where there is none.
pub fn file_uri(path: &Path) -> String {
    // A file that is staged may be gone from the disk.
    let whole = path.canonicalize().unwrap_or_else(|_| whole_path(path));
    let top = whole.ancestors().find_map(Repository::containing).map(|repository| repository.top().to_owned());
    let top = top.or_else(|| std::env::current_dir().and_then(|folder| folder.canonicalize()).ok());
    match top.and_then(|top| whole.strip_prefix(top).ok()) {
        Some(inside) => encoded(path_names(inside)),
        None => format!("file:///{}", encoded(path_names(&whole))),
    }
}

/// The names of which a path is made.
fn path_names(path: &Path) -> impl Iterator<Item = &[u8]> {
    path.components().filter_map(|part| match part {
        Component::Normal(name) => Some(name.as_encoded_bytes()),
        _ => None,
    })
}

/// Names with strokes between them, and a code for each byte that may mean something else.
pub(crate) fn encoded<'n>(names: impl Iterator<Item = &'n [u8]>) -> String {
    let mut out = String::new();
    for name in names {
        out += if out.is_empty() { "" } else { "/" };
        for byte in name {
            match byte {
                b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'.' | b'-' | b'_' | b'~' => out.push(char::from(*byte)),
                _ => out += &format!("%{byte:02X}"),
            }
        }
    }
    out
}

/// A stretch of a file, from a place to the one behind its last character.
pub fn region(start: LineColumn, end: LineColumn) -> Value {
    json!({
        "startLine": start.line,
        "startColumn": start.column,
        "endLine": end.line,
        "endColumn": end.column,
    })
}

/// Where in a file something is.
pub fn location(uri: &str, start: LineColumn, end: LineColumn) -> Value {
    json!({ "physicalLocation": { "artifactLocation": { "uri": uri }, "region": region(start, end) } })
}

/// Where people read about the program; none while it has no address.
pub fn help_uri() -> Option<&'static str> {
    [env!("CARGO_PKG_REPOSITORY"), env!("CARGO_PKG_HOMEPAGE")].into_iter().find(|address| !address.is_empty())
}

/// A whole log of a program, with its rules and its results.
pub fn log(tool: &str, rules: &[Value], results: Vec<Value>) -> String {
    let mut driver = json!({ "name": tool, "version": env!("CARGO_PKG_VERSION"), "rules": rules });
    if let Some(address) = help_uri() {
        driver["informationUri"] = address.into();
    }
    let run = json!({
        "tool": { "driver": driver },
        "columnKind": "unicodeCodePoints",
        "results": results,
    });
    let schema = "https://json.schemastore.org/sarif-2.1.0.json";
    format!("{:#}\n", json!({ "$schema": schema, "version": "2.1.0", "runs": [run] }))
}
