//! The files of a project: its record, its texts and its values, from the disk or as they are staged in git.

use crate::numbered_text::NumberedText;
use crate::record_file::{RECORD_NAME, Record};
use crate::values::Values;
use geneva_evidence::nearest_name;
use geneva_host::files;
use geneva_host::git::{Blob, Repository};
use geneva_host::printable::shown_path;
use proofread::TextFormat;
use std::collections::HashMap;
use std::path::{Component, Path, PathBuf};

/// Largest file that is read, in bytes.
pub const LARGEST: u64 = 64 << 20;

/// Where the contents of files come from.
enum Origin {
    Disk,
    /// The files of a repository as they are staged, by their paths below its top.
    Staged(Repository, HashMap<PathBuf, Blob>),
}

/// A record with what it names.
pub(crate) struct Project {
    /// The folder of the record.
    pub folder: PathBuf,
    /// The record's path.
    pub path: PathBuf,
    /// The record; one that is not there yet has no entries.
    pub record: Record,
    origin: Origin,
}

/// A text of a project.
pub(crate) struct ProjectText {
    /// Its name in the record.
    pub name: String,
    /// Its path, as people are shown it.
    pub path: PathBuf,
    /// Its characters.
    pub source: String,
    pub numbered: NumberedText,
}

/// The path of a record that is named by itself or by its folder.
pub(crate) fn record_path(named: &Path) -> PathBuf {
    if named.is_dir() { named.join(RECORD_NAME) } else { named.to_owned() }
}

/// The folder of a file.
fn folder_of(path: &Path) -> PathBuf {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_owned()
}

impl Project {
    /// The project of a record that is there.
    ///
    /// # Errors
    ///
    /// The record cannot be read, or git has no staged files where they are asked for.
    pub(crate) fn open(named: &Path, is_staged: bool) -> Result<Self, String> {
        let path = record_path(named);
        let folder = folder_of(&path);
        let origin = if is_staged { staged(&folder)? } else { Origin::Disk };
        let mut project = Self { folder, path, record: Record::default(), origin };
        let wanted = "a record that `geneva record` wrote, or its folder";
        let text = project.read(&project.path, wanted)?;
        project.record = Record::parse(&text).map_err(|why| format!("{}: {why}", shown_path(&project.path)))?;
        Ok(project)
    }

    /// A project whose record is not there yet.
    pub(crate) fn new(path: PathBuf, record: Record) -> Self {
        Self { folder: folder_of(&path), path, record, origin: Origin::Disk }
    }

    fn read(&self, path: &Path, wanted: &str) -> Result<String, String> {
        let bytes = match &self.origin {
            Origin::Disk => files::read(path, LARGEST, wanted)?,
            Origin::Staged(repository, files) => {
                let missing = || format!("{} is not staged in git; give {wanted} that is", shown_path(path));
                let folder = folder_of(path).canonicalize().map_err(|_| missing())?;
                let whole = folder.join(path.file_name().unwrap_or_default());
                let inside = whole.strip_prefix(repository.top()).map_err(|_| missing())?;
                repository.content(files.get(inside).ok_or_else(missing)?)?
            }
        };
        String::from_utf8(bytes).map_err(|_| format!("{} is not text in UTF-8; give {wanted}", shown_path(path)))
    }

    /// The texts, with their numbers.
    pub(crate) fn texts(&self) -> Result<Vec<ProjectText>, String> {
        let text = |name: &String| {
            let path = self.folder.join(name);
            let shown = shown_path(&path);
            let extension = path.extension().unwrap_or_default().to_string_lossy().into_owned();
            let format = TextFormat::from_extension(&extension).ok_or_else(|| {
                format!("{shown}: the name tells no format; give a file in md, tex, xml, html, ipynb or txt")
            })?;
            let source = self.read(&path, "a text, or, if it was moved, change its path in the record")?;
            let numbered = NumberedText::read(&source, format).map_err(|why| format!("{shown}: {why}"))?;
            Ok(ProjectText { name: name.clone(), path, source, numbered })
        };
        self.record.texts.iter().map(text).collect()
    }

    /// The values, and those that were computed in a second way, if the record names some.
    pub(crate) fn values(&self) -> Result<(Values, Option<Values>), String> {
        let all = |names: &[String]| {
            let mut values = Values::default();
            for name in names {
                let path = self.folder.join(name);
                values.add(&shown_path(&path), &self.read(&path, "a file of values in JSON, CSV or TOML")?)?;
            }
            Ok::<_, String>(values)
        };
        let second = (!self.record.second.is_empty()).then(|| all(&self.record.second)).transpose()?;
        Ok((all(&self.record.values)?, second))
    }
}

/// The staged files of the repository that a folder belongs to.
fn staged(folder: &Path) -> Result<Origin, String> {
    let repository = Repository::containing(folder)
        .ok_or_else(|| format!("{} is in no git repository; leave out --staged", shown_path(folder)))?;
    let files = repository.staged_files()?.into_iter().collect();
    Ok(Origin::Staged(repository, files))
}

/// The texts and the values in a folder, by the names of the files: `values` and `second` with any ending of values.
///
/// # Errors
///
/// The folder cannot be read, or there are no texts or no values in it.
pub(crate) fn discover(folder: &Path) -> Result<Record, String> {
    let shown = shown_path(folder);
    let entries = std::fs::read_dir(folder)
        .map_err(|error| format!("cannot read {shown}: {}; give a folder", geneva_host::printable::in_words(&error)))?;
    let mut names: Vec<String> = entries
        .flatten()
        .filter(|entry| entry.path().is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|name| name != RECORD_NAME && !name.starts_with('.'))
        .collect();
    names.sort();
    let is_text = |name: &&String| {
        // A table is data, unless it is named as a text.
        let format = name.rsplit_once('.').and_then(|(_, extension)| TextFormat::from_extension(extension));
        format.is_some_and(|format| format != TextFormat::Csv)
    };
    let is_values =
        |stem: &str, name: &str| name.strip_prefix(stem).is_some_and(|rest| [".json", ".csv", ".toml"].contains(&rest));
    let of = |stem: &str| names.iter().filter(|name| is_values(stem, name)).cloned().collect::<Vec<_>>();
    let texts: Vec<String> = names.iter().filter(is_text).cloned().collect();
    let (values, second) = (of("values"), of("second"));
    if texts.is_empty() {
        return Err(format!(
            "{shown}: no file in it has a name that tells a format of texts; name texts and values, as in `geneva record src/*.md \
             --values values.json --record numbers.toml`"
        ));
    }
    if values.is_empty() {
        let near = nearest_name("values.json", names.iter().map(String::as_str).filter(|name| !name.ends_with(".md")));
        let near = near.map(|near| format!("; the nearest name is {near}")).unwrap_or_default();
        return Err(format!(
            "{shown}: there is no values.json, values.csv or values.toml{near}; name the file with --values"
        ));
    }
    Ok(Record::new(texts, values, second))
}

/// The path from a folder to a file, with strokes between names. Both are as they were typed.
///
/// # Errors
///
/// The file is not there.
pub(crate) fn path_from(folder: &Path, file: &Path) -> Result<String, String> {
    let whole = |path: &Path| {
        path.canonicalize()
            .map_err(|why| format!("cannot read {}: {}", shown_path(path), geneva_host::printable::in_words(&why)))
    };
    let (folder, file) = (whole(folder)?, whole(file)?);
    let shared = folder.components().zip(file.components()).take_while(|(one, other)| one == other).count();
    let up = folder.components().skip(shared).map(|_| "..".to_owned());
    let down = file.components().skip(shared).filter_map(|part| match part {
        Component::Normal(name) => Some(name.to_string_lossy().into_owned()),
        _ => None,
    });
    Ok(up.chain(down).collect::<Vec<_>>().join("/"))
}
