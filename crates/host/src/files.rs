//! Files that are read with a bound, and files that are written whole or not at all.
//!
//! What is to be written is collected in a file without a name, which the system takes away with the program, however that
//! ends. When it is complete it is copied beside the file, and the copy takes its place. Only a program that is
//! ended while it copies leaves something behind: the copy, named as the file with `.unfinished-` and some letters.

use crate::printable::{in_words, shown_path};
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, Write};
use std::path::{Component, Path, PathBuf};

/// Opens a regular file to be read; `wanted` says in errors what to give instead.
///
/// # Errors
///
/// It is no regular file, or cannot be opened.
pub fn open(path: &Path, wanted: &str) -> Result<File, String> {
    let name = shown_path(path);
    let unreadable = |error| format!("cannot read {name}: {}; give {wanted}", in_words(&error));
    // Asked before the file is opened: opening a pipe waits for somebody to write.
    let there = fs::metadata(path).map_err(unreadable)?;
    if there.is_dir() {
        return Err(format!("{name} is a folder; give {wanted}"));
    }
    if !there.is_file() {
        return Err(format!("{name} is a pipe or a device, not a regular file; give {wanted}"));
    }
    File::open(path).map_err(unreadable)
}

/// A path as the system names it (without links) as far as it leads to something, with the rest as it is written. The last
/// name of a path that leads to no folder is kept, so that a link is itself and not what it leads to.
///
/// ```
/// use geneva_host::files::whole_path;
/// use std::path::Path;
///
/// let here = std::env::current_dir()?.canonicalize()?;
/// assert_eq!(whole_path(Path::new("no-such-folder/../file.md")), here.join("file.md"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn whole_path(path: &Path) -> PathBuf {
    if let Some(folder) = path.canonicalize().ok().filter(|real| real.is_dir()) {
        return folder;
    }
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let above = absolute.ancestors().skip(1);
    let there = above.filter_map(|folder| Some((folder, folder.canonicalize().ok()?))).next();
    let Some((folder, mut whole)) = there else { return absolute };
    for part in absolute.strip_prefix(folder).unwrap_or(Path::new("")).components() {
        match part {
            Component::ParentDir => drop(whole.pop()),
            Component::Normal(name) => whole.push(name),
            _ => {}
        }
    }
    whole
}

/// The bytes of a regular file, at most so many; `wanted` says in errors what to give instead.
///
/// # Errors
///
/// It is no regular file, cannot be read, or is larger.
pub fn read(path: &Path, most: u64, wanted: &str) -> Result<Vec<u8>, String> {
    read_stream(open(path, wanted)?, &shown_path(path), most)
}

/// All that a stream of this name has, at most so many bytes.
///
/// # Errors
///
/// It cannot be read, or is larger.
pub fn read_stream(source: impl Read, name: &str, most: u64) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    // Read no further than the bound: a file may grow while it is read.
    let read = source.take(most.saturating_add(1)).read_to_end(&mut bytes);
    read.map_err(|error| format!("cannot read {name}: {}", in_words(&error)))?;
    if bytes.len() as u64 > most {
        return Err(format!("{name} is larger than {}, the most that is read; give a shorter text", size(most)));
    }
    Ok(bytes)
}

fn size(bytes: u64) -> String {
    if bytes.is_multiple_of(1 << 20) {
        return format!("{} MiB", bytes >> 20);
    }
    format!("{} MB", bytes / 1_000_000)
}

/// The option that names a file to be written, for errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutputOption {
    /// Its name, such as `--output`.
    pub name: &'static str,
    /// What can be given instead of a file, such as `, or - for standard output`; may be empty.
    pub instead: &'static str,
}

/// A file that will be written: whole, or not at all.
#[derive(Debug)]
pub struct NewFile {
    target: PathBuf,
    collected: File,
    option: OutputOption,
}

impl NewFile {
    /// Begins to write the file at a path, which may be there already.
    ///
    /// # Errors
    ///
    /// In its place is something that can't be replaced, or nothing can be written there.
    pub fn new(asked: &Path, option: OutputOption) -> Result<Self, String> {
        let OutputOption { name, instead } = option;
        let shown = shown_path(asked);
        // A link stays a link; what it leads to is replaced, or made.
        let target = followed(asked);
        let is_folder = asked.as_os_str().to_string_lossy().ends_with(std::path::is_separator);
        match fs::metadata(&target) {
            Ok(there) if there.is_file() => {
                // The system lets a file be replaced that may not be written, and whoever made it so did not want that.
                // The mode counts for the superuser too.
                if there.permissions().readonly() {
                    return Err(format!("{name} {shown} is a read-only file; give another file{instead}"));
                }
                OpenOptions::new().write(true).open(&target).map_err(|error| unwritable(asked, option, &error))?;
            }
            Ok(there) if there.is_dir() => {
                return Err(format!("{name} {shown} is a folder; give a file in it{instead}"));
            }
            Ok(_) => {
                return Err(format!("{name} {shown} is not a file that can be replaced; give another{instead}"));
            }
            Err(_) if is_folder => {
                return Err(format!("{name} {shown} is a folder that doesn't exist; give a file{instead}"));
            }
            Err(_) if target.file_name().is_none() => {
                return Err(format!("{name} '{shown}' is not a file; give one{instead}"));
            }
            Err(_) if target.is_symlink() => {
                return Err(format!("{name} {shown} is a link that leads nowhere; give a file{instead}"));
            }
            Err(_) => {}
        }
        let collected = tempfile::tempfile_in(folder(&target)).map_err(|error| unwritable(asked, option, &error))?;
        Ok(Self { target, collected, option })
    }

    /// Adds bytes.
    ///
    /// # Errors
    ///
    /// There is no room for them.
    pub fn add(&mut self, bytes: &[u8]) -> Result<(), String> {
        self.collected.write_all(bytes).map_err(|error| unwritable(&self.target, self.option, &error))
    }

    /// Puts the file in its place, and tells which it is.
    ///
    /// # Errors
    ///
    /// There is no room for it, and then the place is as it was.
    pub fn finish(self) -> Result<PathBuf, String> {
        let Self { target, collected, option } = self;
        replace(&target, collected).map_err(|error| unwritable(&target, option, &error))?;
        Ok(target)
    }
}

/// Whether two paths are one file, be it under two names.
pub fn is_one_file(one: &Path, other: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let number = |path: &Path| fs::metadata(path).ok().map(|there| (there.dev(), there.ino()));
        number(one).is_some() && number(one) == number(other)
    }
    #[cfg(not(unix))]
    {
        fs::canonicalize(one).is_ok_and(|one| fs::canonicalize(other).is_ok_and(|other| one == other))
    }
}

/// Where a path leads: through links also to a file that is not there yet.
fn followed(asked: &Path) -> PathBuf {
    /// More links in a row than any system follows.
    const MOST_LINKS: usize = 40;
    if let Ok(target) = fs::canonicalize(asked) {
        return target;
    }
    let mut target = asked.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&target) else { break };
        target = folder(&target).join(next);
    }
    target
}

/// Copies what was collected beside the target, and renames the copy.
fn replace(target: &Path, mut collected: File) -> io::Result<()> {
    let name = target.file_name().unwrap_or_default().to_string_lossy();
    let prefix = format!("{name}.unfinished-");
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix);
    let permissions = fs::metadata(target).ok().map(|there| there.permissions());
    if let Some(permissions) = permissions.clone().or_else(usual) {
        builder.permissions(permissions);
    }
    let mut copy = builder.tempfile_in(folder(target))?;
    collected.rewind()?;
    io::copy(&mut collected, copy.as_file_mut())?;
    if let Some(permissions) = permissions {
        copy.as_file().set_permissions(permissions)?;
    }
    copy.persist(target).map_err(|error| error.error)?;
    Ok(())
}

/// The permissions of any new file; the system takes away what the user's mask does.
#[cfg(unix)]
fn usual() -> Option<fs::Permissions> {
    use std::os::unix::fs::PermissionsExt;
    Some(fs::Permissions::from_mode(0o666))
}

/// None: the system gives its own.
#[cfg(not(unix))]
fn usual() -> Option<fs::Permissions> {
    None
}

fn folder(target: &Path) -> &Path {
    target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn unwritable(target: &Path, option: OutputOption, error: &io::Error) -> String {
    let OutputOption { name, instead } = option;
    let cause = in_words(error);
    format!("cannot write {}: {cause}; give another {name}, in a folder that exists{instead}", shown_path(target))
}

#[cfg(test)]
mod tests {
    use super::*;

    const OPTION: OutputOption = OutputOption { name: "--to", instead: "" };

    #[test]
    fn a_file_is_read_up_to_the_bound() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a");
        fs::write(&file, "12345").unwrap();
        assert_eq!(read(&file, 5, "a file"), Ok(b"12345".to_vec()));
        assert!(
            read(&file, 4, "a file").is_err_and(|told| told.contains("is larger than 0 MB, the most that is read"))
        );
        let told = read(folder.path(), 5, "a file of text").unwrap_err();
        assert!(told.ends_with("is a folder; give a file of text"), "{told}");
        let told = read(&folder.path().join("b"), 5, "a file of text").unwrap_err();
        assert!(told.starts_with("cannot read ") && told.ends_with("; give a file of text"), "{told}");
        #[cfg(unix)]
        for device in ["/dev/full", "/dev/zero"] {
            let told = read(Path::new(device), 5, "a file").unwrap_err();
            assert_eq!(told, format!("{device} is a pipe or a device, not a regular file; give a file"));
        }
    }

    #[test]
    fn a_file_is_as_it_was_until_the_new_one_is_complete() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, "old").unwrap();
        let mut file = NewFile::new(&path, OPTION).unwrap();
        file.add(b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"old");
        drop(file);
        assert_eq!(fs::read(&path).unwrap(), b"old");
        let mut file = NewFile::new(&path, OPTION).unwrap();
        file.add(b"new").unwrap();
        file.finish().unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        let told = NewFile::new(&folder.path().join("none/a"), OPTION).unwrap_err();
        assert!(told.ends_with("; give another --to, in a folder that exists") && !told.contains("os error"), "{told}");
    }
}
