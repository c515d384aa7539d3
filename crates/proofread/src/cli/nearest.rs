//! Paths that lead nowhere, with the name beside them that was probably meant.

use geneva_host::printable::{in_words, shown_path};
use std::fs;
use std::path::{Path, PathBuf};

/// Most names in a folder that are compared.
const MOST_COMPARED: usize = 10_000;

/// Why a path leads nowhere, with the name beside it that was probably meant; none if it leads somewhere. `wanted` is what to give.
pub(crate) fn missing(path: &Path, wanted: &str) -> Option<String> {
    let why = fs::metadata(path).err()?;
    let name = shown_path(path);
    let text = path.to_string_lossy();
    let bare = text.trim_end_matches(std::path::is_separator);
    if bare.len() < text.len() && Path::new(bare).is_file() {
        return Some(format!("{name} is no folder; give the file as {}", shown_path(Path::new(bare))));
    }
    let nearest = nearest(path).map(|near| format!("; the nearest name is {}", shown_as_it_is(&near)));
    Some(format!("cannot read {name}: {}{}; give {wanted}", in_words(&why), nearest.unwrap_or_default()))
}

/// Why no file can be written at a path, if its folder is missing; `option` is the option that names it.
pub(crate) fn missing_folder(path: &Path, option: &str) -> Option<String> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty())?;
    if folder.is_dir() {
        return None;
    }
    let what = if folder.exists() { "is no folder" } else { "is a folder that is missing" };
    let nearest = nearest(folder).filter(|near| near.is_dir());
    let nearest = nearest.map(|near| format!("; the nearest name is {}", shown_as_it_is(&near))).unwrap_or_default();
    let (name, folder) = (shown_path(path), shown_path(folder));
    Some(format!("{option} {name}: {folder} {what}{nearest}; make it, or give a file in a folder that is there"))
}

/// A path as it is shown, a folder with a stroke at its end.
fn shown_as_it_is(path: &Path) -> String {
    let stroke = if path.is_dir() { std::path::MAIN_SEPARATOR_STR } else { "" };
    shown_path(path) + stroke
}

/// The path that is nearest to one that leads nowhere: the first of its names that is not there is replaced by the nearest one in
/// its folder, and what stands behind it must be there.
fn nearest(path: &Path) -> Option<PathBuf> {
    let is_there = |folder: &Path| folder.as_os_str().is_empty() || folder.is_dir();
    let lacking = path.ancestors().find(|of| of.parent().is_some_and(is_there))?;
    let wanted = lacking.file_name()?.to_string_lossy();
    let folder = lacking.parent().filter(|folder| !folder.as_os_str().is_empty());
    let behind = path.strip_prefix(lacking).ok()?;
    let entries = fs::read_dir(folder.unwrap_or(Path::new("."))).ok()?.filter_map(Result::ok).take(MOST_COMPARED);
    let near = entries.filter_map(|entry| {
        let name = entry.file_name();
        let distance = strsim::damerau_levenshtein(&wanted, &name.to_string_lossy());
        let found = folder.map_or_else(|| PathBuf::from(&name), |folder| folder.join(&name));
        let found = if behind.as_os_str().is_empty() { found } else { found.join(behind) };
        // A third of the letters: another name is no slip.
        (distance > 0 && 3 * distance <= wanted.chars().count() && found.exists()).then_some((distance, found))
    });
    near.min().map(|(_, found)| found)
}
