//! Files of data to which the pages lead.
//!
//! They are written among the chapters, where mdBook finds what it copies into the book; they are not committed.

use crate::cache::Shelf;
use crate::fields;
use anyhow::{Context, bail};
use std::fs;
use std::path::Path;

/// The folder among the chapters and in the book.
pub(crate) const FOLDER: &str = "data";
/// How the name ends of the file that describes a CSV file.
pub(crate) const DESCRIBING: &str = "-metadata.json";

/// A file of data.
pub struct PageFile {
    name: String,
    text: String,
}

impl PageFile {
    /// The numbers of a figure or a table, as CSV.
    pub fn csv(name: &str, csv: String) -> Self {
        Self { name: format!("{name}.csv"), text: csv }
    }

    /// What a file of [`PageFile::csv`] shows, as metadata for tables on the web (CSVW): a title with the units that the
    /// caption names, the book and edition that it comes from, and the address of the licence.
    pub fn metadata(&self, title: &str, source: &str, licence: &str) -> anyhow::Result<Self> {
        let text = fields::json(&serde_json::json!({
            "@context": "http://www.w3.org/ns/csvw",
            "url": self.name,
            "dc:title": title,
            "dc:source": source,
            "dc:license": { "@id": licence },
        }))?;
        Ok(Self { name: format!("{}{DESCRIBING}", self.name), text })
    }

    /// A file under this name, such as a script or a style sheet.
    pub fn text_file(name: &str, text: String) -> Self {
        Self { name: name.to_owned(), text }
    }

    /// The file with another text.
    pub(crate) fn with_text(self, change: impl FnOnce(&str) -> String) -> Self {
        Self { text: change(&self.text), ..self }
    }

    /// What is in it.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its path from a page.
    pub fn path(&self) -> String {
        format!("{FOLDER}/{}", self.name)
    }
}

/// Files that may come from a shelf; see [`Shelf::recall`].
pub(crate) fn recall(
    shelf: &Shelf,
    what: &str,
    parts: &[&str],
    make: impl FnOnce() -> anyhow::Result<Vec<PageFile>>,
) -> anyhow::Result<Vec<PageFile>> {
    Ok(from_texts(shelf.recall(what, parts, || Ok(as_texts(make()?).collect()))?.into_iter()).collect())
}

/// The name and the text of each file, one after the other.
pub(crate) fn as_texts(files: Vec<PageFile>) -> impl Iterator<Item = String> {
    files.into_iter().flat_map(|file| [file.name, file.text])
}

/// The files of which these are the names and texts.
pub(crate) fn from_texts(mut texts: impl Iterator<Item = String>) -> impl Iterator<Item = PageFile> {
    std::iter::from_fn(move || Some(PageFile { name: texts.next()?, text: texts.next()? }))
}

/// Whether this is a folder of chapters, where files of data are written. There is none where a book is handed over without
/// its folder.
pub fn has_place(chapters: &Path) -> bool {
    chapters.join("SUMMARY.md").is_file()
}

/// Whether a page leads to a file of data.
pub fn is_led_to(page: &str) -> bool {
    page.contains(&format!("{FOLDER}/"))
}

/// Writes the files of all pages into the folder of the chapters, and removes what is there besides.
///
/// A file that stands as it should is left alone, so that a builder that watches the chapters is not woken.
///
/// Where there are no chapters, as when a book is handed over without its folder, nothing is written.
pub fn write(chapters: &Path, files: &[PageFile]) -> anyhow::Result<()> {
    if !has_place(chapters) {
        return Ok(());
    }
    let mut names: Vec<_> = files.iter().map(|file| file.name.as_str()).collect();
    names.sort_unstable();
    if let Some(twice) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        bail!("two figures or tables have the name `{}`: name one of them otherwise", twice[0]);
    }
    let folder = chapters.join(FOLDER);
    if files.is_empty() && !folder.exists() {
        return Ok(());
    }
    let cannot =
        || format!("cannot write in {}: the book is built from a folder that can be written", folder.display());
    fs::create_dir_all(&folder).with_context(cannot)?;
    let as_the_chapters = fs::metadata(chapters.join("SUMMARY.md")).with_context(cannot)?.permissions();
    for file in files {
        let path = folder.join(&file.name);
        if fs::read_to_string(&path).is_ok_and(|standing| standing == file.text) {
            continue;
        }
        let beside = tempfile::NamedTempFile::new_in(&folder).with_context(cannot)?;
        fs::write(beside.path(), &file.text).with_context(cannot)?;
        // Whoever may read the chapters may read what belongs to them; a temporary file is its maker's alone.
        fs::set_permissions(beside.path(), as_the_chapters.clone()).with_context(cannot)?;
        beside.persist(&path).with_context(cannot)?;
    }
    for entry in fs::read_dir(&folder).with_context(cannot)? {
        let entry = entry.with_context(cannot)?;
        let name = entry.file_name();
        // A name that begins with a point is that of a file on its way.
        if !name.to_str().is_some_and(|name| names.binary_search(&name).is_ok() || name.starts_with('.')) {
            fs::remove_file(entry.path()).with_context(cannot)?;
        }
    }
    Ok(())
}
