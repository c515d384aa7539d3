//! The documents that were asked for: files, folders, standard input, and lines of JSON.

use super::arguments::Input;
use super::baseline::Baseline;
use crate::reader::{Format, LONGEST};
use serde_json::Value;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

/// A text and its name.
pub(crate) struct Document {
    pub name: String,
    pub text: String,
    pub format: Format,
    /// The file, if it is one.
    pub path: Option<PathBuf>,
}

/// Where documents come from.
pub(crate) struct Source {
    path: Option<PathBuf>,
    /// None for lines of JSON.
    format: Option<Format>,
    /// The folder that was asked for, if the file was found in one.
    folder: Option<PathBuf>,
}

impl Source {
    /// The file with the folder in which it was found, if it is LaTeX.
    pub fn latex(&self) -> Option<(&Path, Option<&Path>)> {
        let path = self.path.as_deref().filter(|_| self.format == Some(Format::Latex))?;
        Some((path, self.folder.as_deref()))
    }

    /// Whether it is this file.
    pub fn is(&self, file: &Path) -> bool {
        let real = |path: &Path| path.canonicalize().ok();
        self.path.as_deref().and_then(real).is_some_and(|mine| real(file) == Some(mine))
    }
}

/// Folders that hold no texts of the author.
const SKIPPED: [&str; 3] = ["target", "node_modules", "__pycache__"];
/// Deepest folder that is searched.
const DEEPEST: usize = 64;

/// The sources that the arguments name, folders in the order of their names.
pub(crate) fn sources(paths: &[PathBuf], input: Option<Input>) -> Result<Vec<Result<Source, String>>, String> {
    let mut out = Vec::new();
    for path in paths {
        if path.as_os_str() == "-" {
            let format = input.map_or(Some(Format::Markdown), Input::format);
            out.push(Ok(Source { path: None, format, folder: None }));
        } else if path.is_dir() {
            let before = out.len();
            folder(path, input, 0, &mut out);
            for found in out[before..].iter_mut().flatten() {
                found.folder = Some(path.clone());
            }
            if out.len() == before {
                return Err(format!("{}: no file here whose name tells a format that is read", path.display()));
            }
        } else {
            out.push(file(path, input).ok_or_else(|| {
                let known = "md, tex, xml, cnxml, ptx, html, ipynb, txt or jsonl";
                format!("{}: the name tells no format ({known}); say --input", path.display())
            }));
        }
    }
    Ok(out)
}

fn file(path: &Path, input: Option<Input>) -> Option<Source> {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let of_lines = matches!(extension, "jsonl" | "ndjson");
    let format = match input {
        Some(input) => input.format(),
        None if of_lines => None,
        None => Some(Format::of_extension(extension)?),
    };
    Some(Source { path: Some(path.to_owned()), format, folder: None })
}

fn folder(path: &Path, input: Option<Input>, depth: usize, out: &mut Vec<Result<Source, String>>) {
    let entries = match std::fs::read_dir(path) {
        Ok(entries) => entries,
        Err(why) => {
            out.push(Err(format!("{}: {why}", path.display())));
            return;
        }
    };
    let mut entries: Vec<_> = entries.filter_map(Result::ok).collect();
    entries.sort_by_key(std::fs::DirEntry::file_name);
    for entry in entries {
        let name = entry.file_name().to_string_lossy().into_owned();
        let Ok(kind) = entry.file_type() else { continue };
        if name.starts_with('.') {
            continue;
        }
        if kind.is_dir() && depth < DEEPEST && !SKIPPED.contains(&name.as_str()) {
            folder(&entry.path(), input, depth + 1, out);
        } else if kind.is_file() {
            // Whatever the input is said to be, only files whose name tells a text are taken from a folder.
            if let Some(found) =
                file(&entry.path(), None).filter(|found| found.format.is_some() || !Baseline::is_in(&entry.path()))
            {
                let format = input.map_or(found.format, Input::format);
                out.push(Ok(Source { format, ..found }));
            }
        }
    }
}

/// Hands over the documents of a source.
pub(crate) fn each(
    source: &Source,
    take: &mut dyn FnMut(Result<Document, String>) -> Result<(), String>,
) -> Result<(), String> {
    let name = source.path.as_ref().map_or("standard input".to_owned(), |path| path.display().to_string());
    let stream: Box<dyn Read> = match &source.path {
        None => Box::new(std::io::stdin()),
        Some(path) => match File::open(path) {
            Ok(file) => Box::new(file),
            Err(why) => return take(Err(format!("{name}: {why}"))),
        },
    };
    match source.format {
        Some(format) => {
            let text = whole(stream).map_err(|why| format!("{name}: {why}"));
            take(text.map(|text| Document { name, text, format, path: source.path.clone() }))
        }
        None => lines(&name, BufReader::new(stream), take),
    }
}

fn whole(stream: impl Read) -> Result<String, String> {
    let mut bytes = Vec::new();
    stream.take(LONGEST as u64 + 1).read_to_end(&mut bytes).map_err(|why| why.to_string())?;
    if bytes.len() > LONGEST {
        return Err(crate::reader::Unreadable::TooLong.to_string());
    }
    text(bytes)
}

pub(crate) fn text(bytes: Vec<u8>) -> Result<String, String> {
    if bytes.iter().take(4096).any(|byte| *byte == 0) {
        return Err("this is not text: it has zero bytes".to_owned());
    }
    // An old file in another encoding is read all the same; only its letters with accents are lost.
    Ok(String::from_utf8(bytes).unwrap_or_else(|wrong| String::from_utf8_lossy(wrong.as_bytes()).into_owned()))
}

fn lines(
    name: &str,
    mut stream: impl BufRead,
    take: &mut dyn FnMut(Result<Document, String>) -> Result<(), String>,
) -> Result<(), String> {
    let mut number = 0usize;
    loop {
        let mut bytes = Vec::new();
        let limit = LONGEST as u64 * 2;
        match stream.by_ref().take(limit).read_until(b'\n', &mut bytes) {
            Ok(0) => return Ok(()),
            Ok(_) => {}
            Err(why) => return take(Err(format!("{name}: {why}"))),
        }
        number += 1;
        if bytes.trim_ascii().is_empty() {
            continue;
        }
        let wrong = |why: String| format!("{name}:{number}: {why}");
        take(text(bytes).and_then(|line| record(&line, number)).map_err(wrong))?;
    }
}

/// A document out of a line of JSON.
fn record(line: &str, number: usize) -> Result<Document, String> {
    let value: Value = serde_json::from_str(line).map_err(|why| format!("this is not a JSON object: {why}"))?;
    let text = value["text"].as_str().ok_or("the object needs `text`, a string")?.to_owned();
    let name = match &value["id"] {
        Value::String(id) => id.clone(),
        Value::Number(id) => id.to_string(),
        _ => format!("line {number}"),
    };
    let format = match &value["format"] {
        Value::Null => Format::Markdown,
        Value::String(format) => Format::named(format).or_else(|| Format::of_extension(format)).ok_or_else(|| {
            let known: Vec<&str> = Format::ALL.iter().map(|(name, _)| *name).collect();
            format!("the format `{format}` is not known; it is one of {}", known.join(", "))
        })?,
        _ => return Err("`format` must be a string".to_owned()),
    };
    Ok(Document { name, text, format, path: None })
}
