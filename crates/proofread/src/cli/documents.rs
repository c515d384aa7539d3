//! The documents that were asked for: files, folders, standard input, and lines of JSON.

use super::arguments::{Input, TYPST};
use super::case_lines::are_accepted_cases;
use super::index::StagedFile;
use super::nearest::missing;
use crate::reader::{
    ArchiveFormat, ArchivedText, LONGEST, MadePage, TextFormat, UnreadKind, UnreadParts, read_archive, read_typst,
};
use geneva_host::files;
use geneva_host::printable::{escape_and_shorten, in_words, shown_path};
use serde_json::Value;
use std::fs;
use std::io::{BufRead, BufReader, Cursor, Read};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// The name that stands for standard input.
pub(crate) const STANDARD_INPUT: &str = "-";
/// What can be read, for errors.
const WANTED: &str = "a text file or a folder of them, or - for standard input";

/// A text and its name.
pub(crate) struct Document {
    pub name: String,
    /// The text as its author sees it.
    pub text: String,
    pub format: TextFormat,
    /// What the file is written in, by its name for programs.
    pub written_in: &'static str,
    /// The page that is proofread in place of the text, if the file is no text.
    pub made: Option<MadePage>,
    /// What of the file is not read, beside parts of the text.
    pub not_read: UnreadParts,
    /// The file, if it is one.
    pub path: Option<PathBuf>,
    /// The argument that named the file, or the folder in which it was found.
    pub argument: Option<PathBuf>,
    /// What is staged in its place, if that is what was read.
    pub staged: Option<Arc<StagedFile>>,
}

impl Document {
    fn of_text(name: String, text: String, format: TextFormat) -> Self {
        let written_in = format.name();
        Self {
            name,
            text,
            format,
            written_in,
            made: None,
            not_read: UnreadParts::default(),
            path: None,
            argument: None,
            staged: None,
        }
    }

    /// What the file is written in.
    pub(super) fn input(&self) -> Input {
        match ArchiveFormat::from_name(self.written_in) {
            Some(format) => Input::Archive(format),
            None if self.written_in == TYPST => Input::Typst,
            None => Input::One(self.format),
        }
    }

    /// What is proofread, and what it is written in.
    pub(super) fn checked_text(&self) -> (&str, TextFormat) {
        match &self.made {
            Some(made) => (&made.page, TextFormat::Html),
            None => (&self.text, self.format),
        }
    }

    /// What a line of the text is called, if it isn't called by its number.
    pub(super) fn label(&self, line: usize) -> Option<String> {
        self.made.as_ref()?.label(line)
    }

    /// Whether its lines are mark-up that no person reads.
    pub(super) fn is_markup(&self) -> bool {
        self.made.is_none() && matches!(self.format, TextFormat::Xml | TextFormat::Html | TextFormat::Notebook)
    }
}

/// A document in Typst.
fn typst(name: &str, text: String) -> Document {
    let (made, not_read) = read_typst(&text);
    let document = Document::of_text(name.to_owned(), text, TextFormat::Plain);
    Document { written_in: TYPST, made: Some(made), not_read, ..document }
}

/// The documents in a file with this name.
pub(super) fn documents_in(name: &str, bytes: Vec<u8>, input: Input) -> Result<Vec<Document>, String> {
    let of_text = |format, bytes| decode_text(bytes).map(|text| vec![Document::of_text(name.to_owned(), text, format)]);
    match input {
        Input::One(format) => of_text(format, bytes),
        Input::Lines => of_text(TextFormat::Markdown, bytes),
        Input::Typst => Ok(vec![typst(name, decode_text(bytes)?)]),
        Input::Archive(format) => {
            let texts = read_archive(&bytes, format)?.into_iter().map(|text| match text {
                ArchivedText::Page { name: inner, page } => Document {
                    written_in: format.name(),
                    ..Document::of_text(format!("{name}/{inner}"), page, TextFormat::Html)
                },
                ArchivedText::Made(mut made, not_read) => {
                    let text = std::mem::take(&mut made.text);
                    Document {
                        written_in: format.name(),
                        made: Some(made),
                        not_read,
                        ..Document::of_text(name.to_owned(), text, TextFormat::Html)
                    }
                }
            });
            Ok(texts.collect())
        }
    }
}

/// Where documents come from.
pub(crate) struct Source {
    path: Option<PathBuf>,
    format: Input,
    /// The folder that was asked for, if the file was found in one.
    folder: Option<PathBuf>,
    /// What is staged in the place of the file, if that is to be read.
    staged: Option<Arc<StagedFile>>,
}

impl Source {
    /// A file that is read as it is staged, with the folder in which it was found.
    pub(super) fn staged(
        path: PathBuf,
        input: Option<Input>,
        folder: Option<PathBuf>,
        staged: StagedFile,
    ) -> Result<Self, String> {
        let found = file(&path, input).ok_or_else(|| unknown_format(&path))?;
        Ok(Self { folder, staged: Some(Arc::new(staged)), ..found })
    }

    /// The file with the folder in which it was found, if other files may define something for it.
    pub(super) fn file_of_project(&self) -> Option<(&Path, Option<&Path>)> {
        let in_project = |path: &&Path| match self.format {
            Input::One(TextFormat::Latex) => true,
            Input::One(TextFormat::Xml) => is_xml(path),
            _ => false,
        };
        let path = self.path.as_deref().filter(in_project)?;
        Some((path, self.folder.as_deref()))
    }

    /// The file, if it was found in a folder and is no text in spite of its name: nobody asked for it by name.
    pub(super) fn found_without_text(&self) -> Option<&Path> {
        let is_text = !matches!(self.format, Input::Archive(_)) && self.staged.is_none();
        let path = self.path.as_deref().filter(|_| is_text && self.folder.is_some())?;
        let mut start = Vec::new();
        fs::File::open(path).ok()?.take(START as u64).read_to_end(&mut start).ok()?;
        has_zero_bytes(&start).then_some(path)
    }

    /// Whether it is this file.
    pub(super) fn is_file(&self, file: &Path) -> bool {
        let real = |path: &Path| path.canonicalize().ok();
        self.path.as_deref().and_then(real).is_some_and(|mine| real(file) == Some(mine))
    }
}

/// Folders that hold no texts of the author.
const SKIPPED: [&str; 3] = ["target", "node_modules", "__pycache__"];
/// Folders into which Quarto, Jupyter Book, Sphinx and Jekyll write what they make out of the author's texts.
const OUTPUT: [&str; 3] = ["_book", "_site", "_build"];
/// Deepest folder that is searched.
const DEEPEST: usize = 64;

/// Endings of files that hold texts or numbers in formats that are not read.
const UNREAD: &str = " rst rest adoc asciidoc asc org rnw rtex rmarkdown snw lnw mdx lyx tm texi texinfo textile wiki mediawiki \
    tei dita doc rtf pages pdf ps djvu pptx ppt odp xlsx xls xlsm ods csv tsv nb cdf mw wxm wxmx \
    lhs lagda markua typst mdoc ";

/// The sources that the arguments name, folders in the order of their names, and how many files in them are not read.
pub(crate) fn sources(
    paths: &[PathBuf],
    input: Option<Input>,
    unread: &mut UnreadParts,
) -> Result<Vec<Result<Source, String>>, String> {
    let mut out = Vec::new();
    for path in paths {
        if path.as_os_str() == STANDARD_INPUT {
            let format = input.unwrap_or(Input::One(TextFormat::Markdown));
            out.push(Ok(Source { path: None, format, folder: None, staged: None }));
        } else if path.is_dir() {
            let before = out.len();
            folder(path, input, 0, &mut out, unread);
            for found in out[before..].iter_mut().flatten() {
                found.folder = Some(path.clone());
            }
            if out.len() == before {
                let others = unread.total();
                let others =
                    if others == 0 { String::new() } else { format!("; {others} have formats that are not read") };
                return Err(format!(
                    "{}: no file in this folder has a name that tells a format ({KNOWN}){others}; give files, and say --input",
                    shown_path(path)
                ));
            }
        } else if let Some(why) = missing(path, WANTED) {
            out.push(Err(why));
        } else {
            out.push(file(path, input).ok_or_else(|| unknown_format(path)));
        }
    }
    Ok(out)
}

/// Endings of names that tell a format, for errors.
const KNOWN: &str = "md, qmd, Rmd, tex, typ, docx, odt, epub, xml, cnxml, ptx, html, ipynb, txt, csv or jsonl";

fn unknown_format(path: &Path) -> String {
    format!("{}: the name tells no format ({KNOWN}); say --input", shown_path(path))
}

fn is_hidden(name: &str) -> bool {
    name.starts_with('.')
}

/// Whether a search of a folder comes to a file with this path below it.
pub(super) fn is_searched(below: &Path) -> bool {
    let names: Vec<String> = below.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
    let folders = names.split_last().map_or(&[][..], |(_, folders)| folders);
    folders.len() <= DEEPEST
        && below.components().all(|part| matches!(part, Component::Normal(_)))
        && !names.iter().any(|name| is_hidden(name))
        && !folders.iter().any(|name| SKIPPED.contains(&name.as_str()) || OUTPUT.contains(&name.as_str()))
}

/// Whether a file that is staged somewhere in a folder is read. Lines of JSON have no earlier revision, and tables are mostly data.
pub(super) fn is_taken_from_folder(path: &Path) -> bool {
    file(path, None).is_some_and(|found| found.format != Input::Lines && found.format != Input::One(TextFormat::Csv))
}

/// Counts a file in a folder whose format is not read.
pub(super) fn count_unread(path: &Path, unread: &mut UnreadParts) {
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let Some((_, ending)) = name.rsplit_once('.') else { return };
    if UNREAD.split_whitespace().any(|known| known == ending) {
        unread.count(UnreadKind::File, &format!(".{ending}"), 1);
    }
}

fn file(path: &Path, input: Option<Input>) -> Option<Source> {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let format = input.or_else(|| Input::from_extension(extension))?;
    Some(Source { path: Some(path.to_owned()), format, folder: None, staged: None })
}

fn folder(
    path: &Path,
    input: Option<Input>,
    depth: usize,
    out: &mut Vec<Result<Source, String>>,
    unread: &mut UnreadParts,
) {
    let entries = match fs::read_dir(path) {
        Ok(entries) => entries,
        Err(why) => {
            out.push(Err(format!("cannot read {}: {}; give another folder", shown_path(path), in_words(&why))));
            return;
        }
    };
    let mut entries: Vec<_> = entries.filter_map(Result::ok).collect();
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let name = entry.file_name().to_string_lossy().into_owned();
        let Ok(kind) = entry.file_type() else { continue };
        if is_hidden(&name) {
            continue;
        }
        if kind.is_dir() && OUTPUT.contains(&name.as_str()) {
            unread.count(UnreadKind::Folder, &name, 1);
        } else if kind.is_dir() && depth < DEEPEST && !SKIPPED.contains(&name.as_str()) {
            folder(&entry.path(), input, depth + 1, out, unread);
        } else if kind.is_symlink() && file(&entry.path(), None).is_some() {
            // A link may lead anywhere, and around in circles.
            unread.count(UnreadKind::Link, "", 1);
        } else if kind.is_file() {
            // Whatever the input is said to be, only files whose name tells a text are taken from a folder. Tables are mostly data.
            let is_text =
                |found: &Source| found.format != Input::One(TextFormat::Csv) && !name.starts_with(OPEN_IN_OFFICE);
            if let Some(found) = file(&entry.path(), None)
                .filter(is_text)
                .filter(|found| found.format != Input::Lines || !are_accepted_cases(&entry.path()))
            {
                // An archive is none of the other formats, whatever the others are said to be.
                let given = input.filter(|_| !matches!(found.format, Input::Archive(_)));
                let format = given.unwrap_or(found.format);
                out.push(Ok(Source { format, ..found }));
            } else {
                count_unread(&entry.path(), unread);
            }
        }
    }
}

/// How the name of a file begins that Word puts beside one which is open in it.
const OPEN_IN_OFFICE: &str = "~$";
/// The content of a file, as it is staged if that is asked for.
fn opened(path: &Path, staged: Option<&StagedFile>) -> Result<Box<dyn Read>, String> {
    Ok(match staged {
        Some(staged) => Box::new(Cursor::new(staged.content(&shown_path(path))?)),
        None => Box::new(files::open(path, WANTED)?),
    })
}

/// Hands over the documents of a source.
pub(crate) fn read_documents(
    source: &Source,
    take: &mut dyn FnMut(Result<Document, String>) -> Result<(), String>,
) -> Result<(), String> {
    let (stream, name): (Box<dyn Read>, String) = match &source.path {
        None => (Box::new(std::io::stdin()), "standard input".to_owned()),
        Some(path) => match opened(path, source.staged.as_deref()) {
            Ok(stream) => (stream, path.display().to_string()),
            Err(why) => return take(Err(why)),
        },
    };
    let is_stream = source.path.is_none();
    if source.format == Input::Lines {
        return lines(&name, is_stream, BufReader::new(stream), take);
    }
    let bytes = files::read_stream(stream, &escape_and_shorten(&name), LONGEST as u64);
    let found = bytes.and_then(|bytes| match bytes.is_empty() && is_stream {
        // Whatever was to write a text into it has failed, or was never started.
        true => Err(EMPTY.to_owned()),
        false => {
            documents_in(&name, bytes, source.format).map_err(|why| format!("{}: {why}", escape_and_shorten(&name)))
        }
    });
    let argument = source.folder.clone().or_else(|| source.path.clone());
    match found {
        Err(why) => take(Err(why)),
        Ok(found) => found.into_iter().try_for_each(|document| {
            take(Ok(Document {
                path: source.path.clone(),
                argument: argument.clone(),
                staged: source.staged.clone(),
                ..document
            }))
        }),
    }
}

/// What is told if nothing at all comes from standard input.
const EMPTY: &str =
    "standard input is closed or empty, so there is no text to check; pipe a text into it, or give files";

/// Whether a file may be a part of a book in PreTeXt.
pub(super) fn is_xml(file: &Path) -> bool {
    let extension = file.extension().unwrap_or_default();
    ["ptx", "xml", "mbx"].iter().any(|known| extension.eq_ignore_ascii_case(known))
}

/// How many bytes of a file show whether it is text.
const START: usize = 4096;

/// Whether a zero byte stands in the first bytes of a file, which then is no text.
fn has_zero_bytes(bytes: &[u8]) -> bool {
    bytes.iter().take(START).any(|byte| *byte == 0)
}

/// Bytes as text.
pub(crate) fn decode_text(bytes: Vec<u8>) -> Result<String, String> {
    if has_zero_bytes(&bytes) {
        return Err("this is not text: it has zero bytes; give a text file".to_owned());
    }
    // An old file in another encoding is read all the same; only its letters with accents are lost.
    Ok(String::from_utf8(bytes).unwrap_or_else(|wrong| String::from_utf8_lossy(wrong.as_bytes()).into_owned()))
}

fn lines(
    name: &str,
    is_stream: bool,
    mut stream: impl BufRead,
    take: &mut dyn FnMut(Result<Document, String>) -> Result<(), String>,
) -> Result<(), String> {
    let mut number = 0usize;
    loop {
        let mut bytes = Vec::new();
        let limit = LONGEST as u64 * 2;
        match stream.by_ref().take(limit).read_until(b'\n', &mut bytes) {
            Ok(0) if number == 0 && is_stream => return take(Err(EMPTY.to_owned())),
            Ok(0) => return Ok(()),
            Ok(_) => {}
            Err(why) => return take(Err(format!("cannot read {}: {}", escape_and_shorten(name), in_words(&why)))),
        }
        number += 1;
        if bytes.trim_ascii().is_empty() {
            continue;
        }
        let wrong = |why: String| format!("{}:{number}: {why}", shown_path(Path::new(name)));
        take(decode_text(bytes).and_then(|line| record(&line, number)).map_err(wrong))?;
    }
}

/// A document out of a line of JSON.
fn record(line: &str, number: usize) -> Result<Document, String> {
    let value: Value = serde_json::from_str(line).map_err(|why| format!("this is not a JSON object: {why}"))?;
    let text = value["text"].as_str().ok_or("the object needs `text`, a string")?.to_owned();
    let name = match &value["id"] {
        Value::String(id) if !id.is_empty() => id.clone(),
        Value::Number(id) => id.to_string(),
        _ => format!("line {number}"),
    };
    let format = match &value["format"] {
        Value::Null => TextFormat::Markdown,
        Value::String(format) if [TYPST, "typ"].contains(&format.as_str()) => return Ok(typst(&name, text)),
        Value::String(format) => {
            TextFormat::from_name(format).or_else(|| TextFormat::from_extension(format)).ok_or_else(|| {
                let known = TextFormat::ALL.iter().map(|(name, _)| *name).chain([TYPST]);
                let known = known.collect::<Vec<_>>().join(", ");
                let mut told =
                    format!("the format `{}` is not known; it is one of {known}", escape_and_shorten(format));
                if ArchiveFormat::from_extension(format).is_some() {
                    told += ", and a document in another one is no text: give its file to the command";
                }
                told
            })?
        }
        _ => return Err("`format` must be a string".to_owned()),
    };
    Ok(Document::of_text(name, text, format))
}
