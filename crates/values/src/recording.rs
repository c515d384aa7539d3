//! Writing a record: what is new is proposed, what a person has decided stays.

use crate::places::{descriptions, place};
use crate::project::{Project, discover, path_from, record_path};
use crate::proposal::ValueIndex;
use crate::record_file::{NumberEntry, RECORD_NAME, Record, Tie};
use geneva_host::files::{NewFile, OutputOption};
use geneva_host::printable::shown_path;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What to record.
#[derive(Clone, Debug, Default)]
pub struct RecordRequest {
    /// A folder with its texts and values, or texts.
    pub named: Vec<PathBuf>,
    /// Files of values.
    pub values: Vec<PathBuf>,
    /// Files of values that were computed in a second way.
    pub second: Vec<PathBuf>,
    /// The record, if it isn't `numbers.toml` in the folder of the texts.
    pub record: Option<PathBuf>,
    /// Whether entries whose number has disappeared are taken out.
    pub prune: bool,
}

/// From this chance on, a tie is marked in the record.
const LIKELY: f64 = 0.05;

/// What was recorded.
#[derive(Clone, Debug, Default)]
pub struct RecordReport {
    /// The record.
    pub path: PathBuf,
    /// Whether the record has changed.
    pub is_changed: bool,
    /// Numbers of the texts.
    pub numbers: usize,
    /// Pairs of a number and a value that were compared exactly, to propose values.
    pub compared: usize,
    /// New entries.
    pub added: usize,
    /// In how many of the new entries a number that has nothing to do with the values would have one by chance, because many values
    /// lie close together.
    pub by_chance: f64,
    /// Entries whose number was found in other words or with other digits, and is described anew.
    pub moved: usize,
    /// All entries by what they are tied to: `value`, `open`, `candidates`, or the kind of number that is no value.
    pub ties: BTreeMap<String, usize>,
    /// Entries whose number isn't in its text, in words.
    pub missing: Vec<String>,
    /// Whether these were taken out.
    pub is_pruned: bool,
}

/// The record that is asked for: one that is there, or a new one.
fn project(request: &RecordRequest) -> Result<Project, String> {
    let here = Path::new(".");
    let named_folder = match &*request.named {
        [one] if one.is_dir() => Some(one.as_path()),
        // The record itself stands for its folder, as it does for a check.
        [one] if one.ends_with(RECORD_NAME) => one.parent().map(|of| if of.as_os_str().is_empty() { here } else { of }),
        _ => None,
    };
    if named_folder.is_some() && !(request.values.is_empty() && request.second.is_empty()) {
        return Err("--values and --second go with texts; name the texts in place of their folder".to_owned());
    }
    let first = request.named.first().ok_or("name a folder, or texts and --values")?;
    let folder = || first.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let path = match (&request.record, named_folder) {
        (Some(path), _) => record_path(path),
        (None, Some(folder)) => folder.join(RECORD_NAME),
        (None, None) => folder().join(RECORD_NAME),
    };
    let is_there = path.exists();
    if let Some(folder) = named_folder {
        if is_there {
            return Project::open(&path, false);
        }
        let mut found = discover(folder)?;
        let base = path.parent().unwrap_or(Path::new("."));
        let base = if base.as_os_str().is_empty() { Path::new(".") } else { base };
        if base != folder {
            let from_record = |names: &[String]| {
                names.iter().map(|name| path_from(base, &folder.join(name))).collect::<Result<Vec<_>, _>>()
            };
            found = Record::new(from_record(&found.texts)?, from_record(&found.values)?, from_record(&found.second)?);
        }
        return Ok(Project::new(path, found));
    }
    let mut project = match is_there {
        true => Project::open(&path, false)?,
        false => Project::new(path, Record::default()),
    };
    let names =
        |files: &[PathBuf]| files.iter().map(|file| path_from(&project.folder, file)).collect::<Result<Vec<_>, _>>();
    let [texts, values, second] = [names(&request.named)?, names(&request.values)?, names(&request.second)?];
    if !is_there {
        if values.is_empty() {
            return Err("name the file of values with --values".to_owned());
        }
        project.record = Record::new(texts, values, second);
        return Ok(project);
    }
    let shown = shown_path(&project.path);
    let lists = [(texts, &project.record.texts), (values, &project.record.values), (second, &project.record.second)];
    let new: Vec<String> =
        lists.into_iter().flat_map(|(asked, known)| asked.into_iter().filter(|name| !known.contains(name))).collect();
    if let [first, ..] = &*new {
        return Err(format!(
            "{shown} does not name {first}; add it to `texts`, `values` or `second` at the top of the record"
        ));
    }
    Ok(project)
}

/// Writes a record, or adds to it what is new.
///
/// # Errors
///
/// A file cannot be read, or the record cannot be written. The message says which, and what to do.
pub fn record(request: &RecordRequest) -> Result<RecordReport, String> {
    let mut project = project(request)?;
    let before = project.record.to_text();
    let (values, _) = project.values()?;
    let mut report = RecordReport { path: project.path.clone(), is_pruned: request.prune, ..RecordReport::default() };
    let mut index = ValueIndex::new(&values);
    for text in project.texts()? {
        let all = &mut project.record.entries;
        let mine: Vec<usize> = (0..all.len()).filter(|at| all[*at].text == text.name).collect();
        let placement = place(&mine.iter().map(|at| &all[*at]).collect::<Vec<_>>(), &text.numbered);
        let described = descriptions(&text.name, &text.numbered);
        report.numbers += described.len();
        // New entries, each with the number of the old one that it follows.
        let mut new: BTreeMap<Option<usize>, Vec<NumberEntry>> = BTreeMap::new();
        let mut last = mine.first().and_then(|first| first.checked_sub(1));
        if mine.is_empty() {
            last = all.len().checked_sub(1);
        }
        for ((number, place), entry) in text.numbered.numbers.iter().zip(described).zip(&placement.of_number) {
            let Some(entry) = entry.map(|at| mine[at]) else {
                let proposal = index.propose(number);
                report.by_chance += proposal.chance;
                let mut entry = NumberEntry::new(place, proposal.tie, proposal.factor);
                if proposal.chance >= LIKELY && matches!(entry.tie, Tie::Value { .. }) {
                    entry.remark(&format!(
                        "by chance? {:.0} % of the numbers nearby have a value, too",
                        100.0 * proposal.chance
                    ));
                }
                new.entry(last).or_default().push(entry);
                report.added += 1;
                continue;
            };
            last = Some(entry);
            let known = &all[entry];
            let many = text.numbered.words_around(number, crate::numbered_text::WORDS[1]);
            let is_there = (known.before == place.before && known.after == place.after)
                || (known.before == many[0] && known.after == many[1]);
            if !(is_there && known.printed == place.printed && known.unit == place.unit) {
                all[entry].move_to(place);
                report.moved += 1;
            }
        }
        let is_missing: Vec<usize> =
            mine.iter().zip(&placement.of_entry).filter(|(_, number)| number.is_none()).map(|(at, _)| *at).collect();
        for at in &is_missing {
            let entry = &all[*at];
            let printed = crate::check::with_unit(&entry.printed, &entry.unit);
            report.missing.push(format!("{}: {printed} after \"{}\"", entry.text, entry.before));
        }
        let mut merged: Vec<NumberEntry> = new.remove(&None).unwrap_or_default();
        let mut missing = is_missing.into_iter().peekable();
        for (at, entry) in std::mem::take(all).into_iter().enumerate() {
            if !(missing.next_if_eq(&at).is_some() && request.prune) {
                merged.push(entry);
            }
            merged.extend(new.remove(&Some(at)).unwrap_or_default());
        }
        *all = merged;
    }
    report.compared = index.compared;
    for entry in &project.record.entries {
        let name = match &entry.tie {
            Tie::Value { .. } => "value",
            Tie::Candidates(_) => "candidates",
            Tie::Open => "open",
            Tie::None(kind) if kind.starts_with("quoted") => "quoted",
            Tie::None(kind) => kind,
        };
        *report.ties.entry(name.to_owned()).or_default() += 1;
    }
    let text = project.record.to_text();
    report.is_changed = text != before || !project.path.exists();
    if report.is_changed {
        let mut file = NewFile::new(&project.path, OutputOption { name: "--record", instead: "" })?;
        file.add(text.as_bytes())?;
        file.finish()?;
    }
    Ok(report)
}
