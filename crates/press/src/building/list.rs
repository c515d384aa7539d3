//! The list of a book's own files, which a build leaves in the book's folder.
//!
//! A later build replaces the folder, so it has to know what else is in it. The list is only ever compared with what a
//! folder holds; no path is taken from it, so a list that somebody has changed cannot lead out of the folder.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};

/// The name of the list. It does not list itself.
pub(super) const NAME: &str = ".geneva-book";

/// Writes the list of all files in the folder `book`: one path a line, with `/` between its parts, sorted.
pub(super) fn write(book: &Path) -> anyhow::Result<()> {
    let mut files = BTreeSet::new();
    collect(book, "", &mut files)?;
    let text: String = files.iter().map(|file| format!("{file}\n")).collect();
    let list = book.join(NAME);
    fs::write(&list, text).with_context(|| format!("cannot write {}", list.display()))
}

fn collect(folder: &Path, below: &str, files: &mut BTreeSet<String>) -> anyhow::Result<()> {
    let entries = fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    for entry in entries {
        let entry = entry.with_context(|| format!("cannot read {}", folder.display()))?;
        let path = entry.path();
        let name = entry.file_name().into_string().ok().filter(|name| !name.contains('\n'));
        let name = name.with_context(|| {
            format!("the name of {} is not one line of UTF-8: rename the file in the book's sources", path.display())
        })?;
        let kind = entry.file_type().with_context(|| format!("cannot read {}", path.display()))?;
        let listed = format!("{below}{name}");
        if kind.is_dir() {
            collect(&path, &format!("{listed}/"), files)?;
        } else {
            ensure!(kind.is_file(), "{} is neither a file nor a folder: leave it out of the book", path.display());
            if listed != NAME {
                files.insert(listed);
            }
        }
    }
    Ok(())
}

/// Refuses a folder that holds anything but a book with its list, and names what else it holds.
pub(super) fn refuse_foreign(folder: &Path) -> anyhow::Result<()> {
    let cannot = || format!("cannot read {}: choose another output folder", folder.display());
    let listed = Listed::read(folder).with_context(cannot)?;
    let mut foreign = Vec::new();
    let list = listed.clone().unwrap_or_default();
    list.foreign(folder, "", &mut foreign).with_context(cannot)?;
    if foreign.is_empty() {
        return Ok(());
    }
    let (folder, names) = (folder.display(), named(&foreign));
    if listed.is_some() {
        bail!(
            "{folder} holds more than the book that was built there: {names}. Move the rest out, or choose another output \
             folder"
        );
    }
    bail!(
        "{folder} holds files that this command did not write: {names}. Delete them if you do not need them, or choose \
         another output folder. A book that plain mdBook or an earlier version built also counts"
    )
}

/// The first few names, and how many more there are.
fn named(names: &[String]) -> String {
    const FEW: usize = 4;
    // A name may hold what a terminal takes for a command.
    let shown = |name: &String| format!("`{}`", name.replace(char::is_control, "\u{fffd}"));
    let mut text = names.iter().take(FEW).map(shown).collect::<Vec<_>>().join(", ");
    if names.len() > FEW {
        text.push_str(&format!(" and {} more", names.len() - FEW));
    }
    text
}

/// Removes the files on a folder's list, and the folder itself; returns whether nothing is left of it.
///
/// Files that are not on the list stay, and so do the folders that hold them. The list goes last: if the removal is cut
/// short, the next one can finish it.
pub(super) fn remove(folder: &Path) -> bool {
    if !folder.symlink_metadata().is_ok_and(|there| there.is_dir()) {
        return folder.symlink_metadata().is_err_and(|error| error.kind() == ErrorKind::NotFound);
    }
    if let Ok(Some(listed)) = Listed::read(folder) {
        listed.remove(folder, "");
        // What cannot be removed stays, and the answer says so.
        let _ = fs::remove_file(folder.join(NAME));
    }
    fs::remove_dir(folder).is_ok()
}

/// What a list holds.
#[derive(Clone, Default)]
struct Listed {
    files: BTreeSet<String>,
    folders: BTreeSet<String>,
}

/// What an entry of a folder is to a list.
enum Kind {
    File,
    Folder,
    Foreign { is_folder: bool },
}

impl Listed {
    /// The list in a folder, if it has one.
    fn read(folder: &Path) -> io::Result<Option<Self>> {
        let list = folder.join(NAME);
        match list.symlink_metadata() {
            Ok(there) if there.is_file() => {}
            Ok(_) => return Ok(None),
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(error),
        }
        let text = String::from_utf8_lossy(&fs::read(list)?).into_owned();
        let files: BTreeSet<String> = text.lines().chain([NAME]).map(str::to_owned).collect();
        let above = |file: &String| file.match_indices('/').map(|(at, _)| file[..at].to_owned()).collect::<Vec<_>>();
        let folders = files.iter().flat_map(above).collect();
        Ok(Some(Self { files, folders }))
    }

    /// The entries of a folder in the order of their names: path, path from the book's folder on, and kind.
    fn entries(&self, folder: &Path, below: &str) -> io::Result<Vec<(PathBuf, String, Kind)>> {
        let mut entries = Vec::new();
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            // Links are not followed.
            let (name, kind) = (entry.file_name(), entry.file_type()?);
            let path = format!("{below}{}", name.to_string_lossy());
            let is_in = |listed: &BTreeSet<String>| name.to_str().is_some() && listed.contains(&path);
            let kind = if kind.is_file() && is_in(&self.files) {
                Kind::File
            } else if kind.is_dir() && is_in(&self.folders) {
                Kind::Folder
            } else {
                Kind::Foreign { is_folder: kind.is_dir() }
            };
            entries.push((entry.path(), path, kind));
        }
        entries.sort_by(|(_, one, _), (_, other, _)| one.cmp(other));
        Ok(entries)
    }

    fn foreign(&self, folder: &Path, below: &str, found: &mut Vec<String>) -> io::Result<()> {
        for (path, name, kind) in self.entries(folder, below)? {
            match kind {
                Kind::File => {}
                Kind::Folder => self.foreign(&path, &format!("{name}/"), found)?,
                Kind::Foreign { is_folder } => found.push(if is_folder { format!("{name}/") } else { name }),
            }
        }
        Ok(())
    }

    /// Removes what is listed, except for the list, as far as that is possible.
    fn remove(&self, folder: &Path, below: &str) {
        for (path, name, kind) in self.entries(folder, below).unwrap_or_default() {
            match kind {
                Kind::File if name != NAME => {
                    let _ = fs::remove_file(path);
                }
                Kind::Folder => {
                    self.remove(&path, &format!("{name}/"));
                    let _ = fs::remove_dir(path);
                }
                Kind::File | Kind::Foreign { .. } => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tempfile::TempDir;

    /// A folder `out` with these files, and their list.
    fn book(files: &[&str]) -> (TempDir, PathBuf) {
        let around = TempDir::new().unwrap();
        let out = around.path().join("out");
        fs::create_dir(&out).unwrap();
        for file in files {
            add(&out, file);
        }
        write(&out).unwrap();
        (around, out)
    }

    fn add(out: &Path, file: &str) {
        let path = out.join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, file).unwrap();
    }

    fn refusal(out: &Path) -> String {
        format!("{:#}", refuse_foreign(out).unwrap_err())
    }

    #[test]
    fn the_list_is_sorted_and_leaves_itself_out() {
        let (_around, out) = book(&["b.html", "a/z.css", "a/b/c.js", "A.html"]);
        let text = fs::read_to_string(out.join(NAME)).unwrap();
        assert_eq!(text, "A.html\na/b/c.js\na/z.css\nb.html\n");
        write(&out).unwrap();
        assert_eq!(fs::read_to_string(out.join(NAME)).unwrap(), text);
        refuse_foreign(&out).unwrap();
    }

    #[test]
    fn what_is_not_on_the_list_is_named() {
        let (_around, out) = book(&["index.html", "css/book.css"]);
        for (file, name) in [
            (".git/HEAD", "`.git/`"),
            ("CNAME", "`CNAME`"),
            ("photos/one.jpg", "`photos/`"),
            ("css/mine.css", "`css/mine.css`"),
        ] {
            add(&out, file);
            assert!(refusal(&out).contains(name), "{}", refusal(&out));
        }
        fs::create_dir(out.join("empty")).unwrap();
        let said = refusal(&out);
        assert!(said.contains("`empty/` and 1 more. Move the rest out, or choose another output folder"), "{said}");
    }

    #[cfg(unix)]
    #[test]
    fn a_name_is_no_command_to_the_terminal() {
        let (_around, out) = book(&["index.html"]);
        add(&out, "\u{1b}[31mred");
        assert!(refusal(&out).contains("`\u{fffd}[31mred`"));
    }

    #[test]
    fn a_folder_without_a_list_is_empty_or_refused() {
        let out = TempDir::new().unwrap();
        refuse_foreign(out.path()).unwrap();
        add(out.path(), "index.html");
        let said = refusal(out.path());
        assert!(
            said.contains("did not write: `index.html`. Delete them if you do not need them, or choose another"),
            "{said}"
        );
        // A folder in the list's place is no list.
        fs::create_dir(out.path().join(NAME)).unwrap();
        assert!(refusal(out.path()).contains("`.geneva-book/`"));
    }

    #[test]
    fn a_removal_takes_the_listed_files_and_nothing_else() {
        let (_around, out) = book(&["index.html", "css/book.css", "fonts/one.woff2"]);
        add(&out, "css/mine.css");
        assert!(!remove(&out));
        assert!(out.join("css/mine.css").is_file());
        assert!(!out.join("index.html").exists() && !out.join("fonts").exists() && !out.join(NAME).exists());

        let (_around, out) = book(&["index.html", "css/book.css"]);
        assert!(remove(&out) && !out.exists());
        assert!(remove(&out), "nothing is left of what is not there");
    }

    #[test]
    fn a_removal_that_was_cut_short_is_finished() {
        let (_around, out) = book(&["index.html", "css/book.css"]);
        fs::remove_dir_all(out.join("css")).unwrap();
        assert!(remove(&out));
    }

    #[test]
    fn a_changed_list_leads_nowhere() {
        let (around, out) = book(&["index.html"]);
        add(around.path(), "notes.txt");
        let outside = around.path().join("notes.txt");
        let list = format!("../notes.txt\n{}\n/\n..\n.\n\ncss/../../notes.txt\nindex.html\n", outside.display());
        fs::write(out.join(NAME), list).unwrap();
        refuse_foreign(&out).unwrap();
        assert!(remove(&out));
        assert!(outside.is_file());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_in_the_place_of_a_listed_file_or_folder_is_foreign() {
        let (around, out) = book(&["index.html", "css/book.css"]);
        add(around.path(), "mine/book.css");
        fs::remove_file(out.join("index.html")).unwrap();
        fs::remove_dir_all(out.join("css")).unwrap();
        std::os::unix::fs::symlink("../mine/book.css", out.join("index.html")).unwrap();
        std::os::unix::fs::symlink("../mine", out.join("css")).unwrap();
        assert!(refusal(&out).contains("`css`, `index.html`"), "{}", refusal(&out));
        assert!(!remove(&out));
        assert!(out.join("css/book.css").is_file() && out.join("index.html").is_file());
    }
}
