//! Names of files that change with their content, so that a browser never shows an old file for a new one.
//!
//! mdBook ends the name of a script, a style or a font with the first four bytes of the SHA-256 of what it copies. But
//! afterwards names are put into these files, they are shortened, and the search is our own. So they are named
//! again here.

use crate::cache;
use anyhow::{Context, ensure};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Hexadecimal digits of a fingerprint.
const DIGITS: usize = 8;

/// Names of the files with a fingerprint: the one now, and the one by the content.
type Names = BTreeMap<String, String>;

/// Gives each file of a built book whose name has a fingerprint the one of its content, and says so wherever the file is
/// named. The pages must not have their policies yet.
pub(crate) fn renew(book: &Path) -> anyhow::Result<()> {
    let mut all = Vec::new();
    collect(book, &mut all)?;
    let (mut waiting, others): (Vec<_>, Vec<_>) = all.into_iter().partition(|path| parts(&name(path)).is_some());
    let mut names = Names::new();
    while !waiting.is_empty() {
        // A file has its fingerprint only when those that it names have theirs.
        let now: Vec<String> = waiting.iter().map(|path| name(path)).collect();
        let before = waiting.len();
        let mut later = Vec::new();
        for path in waiting {
            let content = renamed(&path, &names)?;
            let own = name(&path);
            // A font names nothing.
            let text = std::str::from_utf8(&content).unwrap_or_default();
            if now.iter().any(|other| text.contains(other.as_str())) {
                later.push(path);
                continue;
            }
            let new = renewed(&own, &content);
            if new != own {
                fs::remove_file(&path).with_context(|| format!("cannot remove {}", path.display()))?;
            }
            let path = path.with_file_name(&new);
            fs::write(&path, content).with_context(|| format!("cannot write {}", path.display()))?;
            names.insert(own, new);
        }
        ensure!(
            later.len() < before,
            "the files {} name each other or themselves, so none of them can be named by its content: take one of the names \
             out of them",
            now.join(", ")
        );
        waiting = later;
    }
    for path in others.iter().filter(|path| is_text(path)) {
        fs::write(path, renamed(path, &names)?).with_context(|| format!("cannot write {}", path.display()))?;
    }
    Ok(())
}

/// The content of a file with the new names in place of the old ones.
fn renamed(path: &Path, names: &Names) -> anyhow::Result<Vec<u8>> {
    let content = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    if !is_text(path) {
        return Ok(content);
    }
    let text = String::from_utf8(content).with_context(|| format!("{} is not UTF-8", path.display()))?;
    let changed = names.iter().filter(|(old, new)| old != new);
    Ok(changed.fold(text, |text, (old, new)| text.replace(old, new)).into_bytes())
}

fn is_text(path: &Path) -> bool {
    path.extension().is_some_and(|kind| ["css", "html", "js"].iter().any(|of| kind == *of))
}

/// What stands before and after the fingerprint of a name, if it has one.
fn parts(name: &str) -> Option<(&str, &str)> {
    let (stem, ending) = name.split_once('.')?;
    let (before, fingerprint) = stem.rsplit_once('-')?;
    let is_one = fingerprint.len() == DIGITS && fingerprint.bytes().all(|digit| digit.is_ascii_hexdigit());
    is_one.then_some((before, ending))
}

/// The name of a file by its content; a name without a fingerprint stays as it is.
fn renewed(name: &str, content: &[u8]) -> String {
    let Some((before, ending)) = parts(name) else { return name.to_owned() };
    format!("{before}-{}.{ending}", &cache::digest(content)[..DIGITS])
}

fn name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

/// All files below a folder, in a fixed order.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> anyhow::Result<()> {
    let cannot = || format!("cannot read {}", folder.display());
    let entries = fs::read_dir(folder).with_context(cannot)?;
    let mut entries: Vec<_> =
        entries.map(|entry| Ok(entry.with_context(cannot)?.path())).collect::<anyhow::Result<_>>()?;
    entries.sort();
    for path in entries {
        if path.is_dir() {
            collect(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use tempfile::TempDir;

    fn folder(files: &[(&str, &str)]) -> TempDir {
        let folder = TempDir::new().expect("a folder");
        for (name, text) in files {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            fs::write(path, text).expect("written");
        }
        folder
    }

    #[test]
    fn files_are_named_by_their_content_wherever_they_are_named() {
        let folder = folder(&[
            ("fonts/a-00000000.woff2", "font"),
            ("fonts/fonts-11111111.css", "src: url('../fonts/a-00000000.woff2')"),
            ("b-22222222.min.js", "load('fonts/fonts-11111111.css')"),
            ("page.html", "<link href=\"fonts/fonts-11111111.css\"><script src=\"b-22222222.min.js\"></script>"),
            ("data/plain.js", "b-22222222.min.js"),
            ("short-123.js", "kept"),
        ]);
        renew(folder.path()).expect("renewed");
        let mut files = Vec::new();
        collect(folder.path(), &mut files).expect("files");
        let read = |path: &Path| fs::read_to_string(path).expect("text");
        let named: Vec<_> = files.iter().filter(|path| parts(&name(path)).is_some()).collect();
        assert_eq!(named.len(), 3);
        for path in &named {
            assert_eq!(renewed(&name(path), read(path).as_bytes()), name(path));
        }
        let [b, font, css] = ["b-", "a-", "fonts-"]
            .map(|start| named.iter().map(|path| name(path)).find(|name| name.starts_with(start)).expect("a file"));
        let page = read(&folder.path().join("page.html"));
        assert_eq!(page, format!("<link href=\"fonts/{css}\"><script src=\"{b}\"></script>"));
        assert_eq!(read(&folder.path().join("data/plain.js")), b);
        assert!(read(&folder.path().join("fonts").join(&css)).contains(&font));
        assert!(folder.path().join("short-123.js").is_file());
    }

    #[test]
    fn files_that_name_each_other_in_a_circle_are_refused() {
        let folder = folder(&[("a-00000000.js", "b-11111111.js"), ("b-11111111.js", "a-00000000.js")]);
        let error = renew(folder.path()).expect_err("a circle").to_string();
        assert!(error.contains("a-00000000.js, b-11111111.js name each other"), "{error}");
    }
}
