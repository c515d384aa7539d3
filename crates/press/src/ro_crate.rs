//! What the data of a built book are, for programs that collect research data: a list of the files in the form of RO-Crate 1.1.

use crate::book::Book;
use crate::changelog::release_date;
use crate::data::{DESCRIBING, FOLDER};
use crate::edition::Edition;
use anyhow::Context;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// The list's name, in the folder of the data.
const FILE: &str = "ro-crate-metadata.json";
/// The media types of files, by the ends of their names.
const MEDIA_TYPES: [(&str, &str); 4] =
    [("csv", "text/csv"), ("json", "application/json"), ("atom", "application/atom+xml"), ("cff", "application/yaml")];

/// A file of the data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataFile {
    /// Its name.
    pub name: String,
    /// What the pages say below the figure or the table whose numbers it has; empty for another file.
    pub caption: String,
    media_type: &'static str,
}

impl DataFile {
    /// The first words of the caption: the number, and the sentence behind it.
    pub fn title(&self) -> &str {
        let ends = [". ", "? ", ": "]
            .map(|end| self.caption.match_indices(end).map(|(at, _)| at).nth(usize::from(end == ". ")));
        let end = ends.into_iter().flatten().min().unwrap_or(self.caption.len());
        self.caption[..end].trim_end_matches('.')
    }
}

/// The files of the data of a book that is built in a folder, in the order of their names: those of a media type that is
/// known, but for those that only describe another one.
///
/// # Errors
///
/// If a file cannot be read.
pub fn data_files(book: &Path) -> anyhow::Result<Vec<DataFile>> {
    let folder = book.join(FOLDER);
    let reading = || format!("cannot read {}", folder.display());
    let mut names = Vec::new();
    for entry in fs::read_dir(&folder).with_context(reading)? {
        names.extend(entry.with_context(reading)?.file_name().into_string());
    }
    names.sort_unstable();
    let file = |name: &String| {
        let (_, end) = name.rsplit_once('.')?;
        let (_, media_type) = MEDIA_TYPES.iter().find(|(of, _)| *of == end)?;
        (!name.ends_with(DESCRIBING) && name != FILE).then(|| {
            let described = fs::read_to_string(folder.join(format!("{name}{DESCRIBING}"))).unwrap_or_default();
            let described: Value = serde_json::from_str(&described).unwrap_or_default();
            let caption = described["dc:title"].as_str().unwrap_or_default().to_owned();
            DataFile { name: name.clone(), caption, media_type }
        })
    };
    Ok(names.iter().filter_map(file).collect())
}

/// Writes the list of the data of a book that is built in a folder. A book without data gets none.
pub(crate) fn write(book: &Book, folder: &Path, edition: &Edition) -> anyhow::Result<()> {
    if !folder.join(FOLDER).is_dir() {
        return Ok(());
    }
    let files = data_files(folder)?;
    let path = folder.join(FOLDER).join(FILE);
    let text = format!("{:#}\n", listed(book, &files, edition));
    fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))
}

fn listed(book: &Book, files: &[DataFile], edition: &Edition) -> Value {
    let imprint = &book.imprint;
    let released = release_date(book.changelog, edition.version);
    let date = edition.date.as_deref().or(released);
    let parts: Vec<Value> = files.iter().map(|file| json!({ "@id": file.name })).collect();
    let mut root = json!({
        "@id": "./",
        "@type": "Dataset",
        "name": format!("{}: data", imprint.title),
        "description": format!("{}. {}.", imprint.subtitle, edition.reference()),
        "version": edition.version,
        "license": { "@id": imprint.licence_address },
        "author": { "@id": "#authors" },
        "hasPart": parts,
    });
    if let Some(date) = date {
        root["datePublished"] = date.into();
    }
    let mut graph = vec![
        json!({
            "@id": FILE,
            "@type": "CreativeWork",
            "conformsTo": { "@id": "https://w3id.org/ro/crate/1.1" },
            "about": { "@id": "./" },
        }),
        root,
        json!({ "@id": imprint.licence_address, "@type": "CreativeWork", "name": imprint.licence_words }),
        json!({ "@id": "#authors", "@type": "Organization", "name": imprint.authors }),
    ];
    graph.extend(files.iter().map(|file| {
        let mut entity =
            json!({ "@id": file.name, "@type": "File", "name": file.name, "encodingFormat": file.media_type });
        if !file.caption.is_empty() {
            entity["description"] = file.caption.as_str().into();
        }
        entity
    }));
    json!({ "@context": "https://w3id.org/ro/crate/1.1/context", "@graph": graph })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn captioned(caption: &str) -> String {
        let file = DataFile { name: "a.csv".to_owned(), caption: caption.to_owned(), media_type: "text/csv" };
        file.title().to_owned()
    }

    #[test]
    fn a_title_is_the_number_and_the_first_sentence() {
        assert_eq!(captioned("Figure 7.1. How fast is it? Each mark is a run."), "Figure 7.1. How fast is it");
        assert_eq!(captioned("Table 9.1. Six pins: K in in·lb. More."), "Table 9.1. Six pins");
        assert_eq!(captioned("Figure 1.2. The pin. It slides."), "Figure 1.2. The pin");
        assert_eq!([captioned("Figure 1.2. The pin."), captioned("")], ["Figure 1.2. The pin", ""]);
    }
}
