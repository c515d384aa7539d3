//! The folder in which a book is put together: hidden, beside the output, and of one build at a time.
//!
//! It holds `lock`, which the build has locked until it ends, however it ends; `new`, in which the book grows; and, while
//! books are exchanged, `old`. Nobody but a build writes into `new`. What is in `old` was at the output or is about to be
//! there, so it is only ever removed by its list.

use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use anyhow::{Context, bail, ensure};

use super::{exchange, list};

/// The builds of this process. A build holds them while it does what must not be cut short.
static UNDER_WAY: Mutex<Vec<Paths>> = Mutex::new(Vec::new());

fn under_way() -> MutexGuard<'static, Vec<Paths>> {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Clears up after all builds of this process, then calls `end`, which should end it.
///
/// For signals. Output folders are left as they were before. Builds that fail or finish in the meantime wait until `end`
/// returns, so they have no time to report that their folder is gone.
pub fn abandon(end: impl FnOnce()) {
    let mut builds = under_way();
    for paths in builds.drain(..) {
        paths.stop();
        // The process ends; the next build reports what is kept.
        let _ = paths.settle();
        paths.release();
    }
    end();
}

/// Where a build works.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Paths {
    out: PathBuf,
    folder: PathBuf,
}

/// A build's own folder. It goes away with the value.
pub struct Site {
    paths: Paths,
    /// Locked as long as it is open.
    _lock: File,
    /// What was found in place of an old book and is not the book's, and where it is now.
    kept: Vec<PathBuf>,
}

impl Site {
    /// Makes the folder for a build into `out`, and clears up after a build that was killed: if it had just moved the old
    /// book away, the book comes back.
    ///
    /// Refuses if another build into `out` is under way, or if `out` holds anything but a book.
    pub fn open(out: &Path) -> anyhow::Result<Self> {
        let paths = Paths::of(out)?;
        let mut builds = under_way();
        let lock = paths.lock()?;
        match paths.settle().and_then(|kept| paths.check().map(|()| kept)) {
            Ok(kept) => {
                builds.push(paths.clone());
                Ok(Self { paths, _lock: lock, kept: kept.into_iter().collect() })
            }
            Err(error) => {
                paths.release();
                Err(error)
            }
        }
    }

    /// The folder in which the book grows.
    pub fn new_book(&self) -> PathBuf {
        self.paths.new()
    }

    /// Puts the new book, which is complete and has its list, in its place, and removes the old one.
    ///
    /// Says where files are now that came into the output at the last moment, if any did.
    pub fn finish(mut self) -> anyhow::Result<Vec<PathBuf>> {
        // Let go before `self` is dropped, which asks for it again.
        let _builds = under_way();
        self.paths.check()?;
        self.paths.put()?;
        self.kept.extend(self.paths.settle()?);
        Ok(std::mem::take(&mut self.kept))
    }
}

impl Drop for Site {
    fn drop(&mut self) {
        let mut builds = under_way();
        if let Some(at) = builds.iter().position(|paths| *paths == self.paths) {
            builds.swap_remove(at);
            // What cannot be cleared now, the next build clears.
            let _ = self.paths.settle();
            self.paths.release();
        }
    }
}

impl Paths {
    fn of(out: &Path) -> anyhow::Result<Self> {
        let (Some(parent), Some(name)) = (out.parent(), out.file_name()) else {
            bail!("{} has no name: choose another output folder", out.display());
        };
        let mut hidden = OsString::from(".");
        hidden.push(name);
        hidden.push(".geneva-build");
        Ok(Self { out: out.to_owned(), folder: parent.join(hidden) })
    }

    fn new(&self) -> PathBuf {
        self.folder.join("new")
    }

    fn old(&self) -> PathBuf {
        self.folder.join("old")
    }

    /// Makes the folder if it is not there, and locks it for this build.
    fn lock(&self) -> anyhow::Result<File> {
        const TRIES: usize = 1000;
        let path = self.folder.join("lock");
        let cannot = |path: &Path| format!("cannot write {}: choose another output folder", path.display());
        for _ in 0..TRIES {
            match fs::create_dir(&self.folder) {
                Err(error) if error.kind() != ErrorKind::AlreadyExists => {
                    return Err(error).with_context(|| cannot(&self.folder));
                }
                _ => {}
            }
            ensure!(
                self.folder.symlink_metadata().map_or(true, |there| there.is_dir()),
                "{} is not a folder, and a build needs one there: remove it, or choose another output folder",
                self.folder.display()
            );
            let lock = match File::options().create(true).write(true).truncate(false).open(&path) {
                // The folder belonged to a build that has just ended.
                Err(error) if error.kind() == ErrorKind::NotFound => continue,
                lock => lock.with_context(|| cannot(&path))?,
            };
            match lock.try_lock() {
                Ok(()) if is_at(&lock, &path) => return Ok(lock),
                // The lock went away with the build that it belonged to.
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => break,
                Err(TryLockError::Error(error)) => {
                    return Err(error).with_context(|| {
                        format!("cannot lock {}: choose an output folder on another disk", path.display())
                    });
                }
            }
        }
        bail!("another build into {} is under way: wait for it, or choose another output folder", self.out.display())
    }

    /// That the output is absent, empty, or a book and nothing else.
    fn check(&self) -> anyhow::Result<()> {
        let Ok(there) = self.out.symlink_metadata() else { return Ok(()) };
        ensure!(there.is_dir(), "{} is not a folder: choose another output folder", self.out.display());
        list::refuse_foreign(&self.out)
    }

    /// Moves the new book to the output. A book that is there is in `old` then.
    fn put(&self) -> anyhow::Result<()> {
        let (new, old, out) = (self.new(), self.old(), &self.out);
        let moved = if is_there(out) {
            // From here on it may become the old book, of which nothing is removed but by its list.
            fs::rename(&new, &old).and_then(|()| {
                if exchange::at_once(&old, out)? {
                    return Ok(());
                }
                fs::rename(&old, &new)?;
                exchange::in_two_steps(&new, out, &old)
            })
        } else {
            fs::rename(&new, out)
        };
        moved.with_context(|| format!("cannot put the new book in {}: choose another output folder", out.display()))
    }

    /// Clears `new` and `old`. An old book goes back if there is none at the output; else it is removed, and what is not
    /// on its list is kept: says where.
    fn settle(&self) -> anyhow::Result<Option<PathBuf>> {
        let (new, old) = (self.new(), self.old());
        let mut kept = None;
        if is_there(&old) && !is_there(&self.out) {
            fs::rename(&old, &self.out).with_context(|| {
                format!(
                    "cannot put back the old book, which an earlier build moved to {}: move it to {}",
                    old.display(),
                    self.out.display()
                )
            })?;
        } else if !list::remove(&old) {
            kept = Some(self.keep());
        }
        remove_all(&new).with_context(|| format!("cannot remove {}: remove it yourself", new.display()))?;
        Ok(kept)
    }

    /// Moves what is left of an old book to a folder that everybody can see, and says which.
    fn keep(&self) -> PathBuf {
        let old = self.old();
        let beside = |number: usize| {
            let mut name = self.out.clone().into_os_string();
            name.push(if number == 1 { ".kept".to_owned() } else { format!(".kept-{number}") });
            PathBuf::from(name)
        };
        match (1..).map(beside).find(|path| !is_there(path)) {
            Some(kept) if fs::rename(&old, &kept).is_ok() => kept,
            _ => old,
        }
    }

    /// Keeps the build of this process from writing: what it writes into `new` from now on fails.
    ///
    /// Pages make the folders that they are written to, so it is not enough to remove the folder. A file takes its place.
    fn stop(&self) {
        const LONGEST: Duration = Duration::from_secs(2);
        const PAUSE: Duration = Duration::from_millis(20);
        let (new, begun) = (self.new(), Instant::now());
        while begun.elapsed() < LONGEST {
            if remove_all(&new).is_ok() && File::create_new(&new).is_ok() {
                // Enough for a build that is writing to find out, and to wait from then on.
                std::thread::sleep(PAUSE);
                return;
            }
        }
    }

    /// Removes the folder, if nothing is left in it but the lock.
    fn release(&self) {
        // If somebody keeps something there, it stays.
        let _ = fs::remove_file(self.folder.join("lock"));
        let _ = fs::remove_dir(&self.folder);
    }
}

/// Whether anything has this name; a link to nowhere counts.
fn is_there(path: &Path) -> bool {
    path.symlink_metadata().is_ok()
}

/// Removes a file or a folder with all that is in it, if it is there.
fn remove_all(path: &Path) -> std::io::Result<()> {
    let removed = match path.symlink_metadata() {
        Ok(there) if there.is_dir() => fs::remove_dir_all(path),
        Ok(_) => fs::remove_file(path),
        Err(error) => Err(error),
    };
    removed.or_else(|error| if error.kind() == ErrorKind::NotFound { Ok(()) } else { Err(error) })
}

/// Whether an open file still has this path.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (file.metadata(), path.symlink_metadata()) {
        (Ok(open), Ok(there)) => (open.dev(), open.ino()) == (there.dev(), there.ino()),
        _ => false,
    }
}

/// Whether a file still has this path, as far as the system tells.
#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.is_file()
}

#[cfg(test)]
mod tests {
    use super::*;
    use tempfile::TempDir;

    /// A folder around the output `out`.
    fn around() -> (TempDir, PathBuf) {
        let around = TempDir::new().unwrap();
        let out = around.path().canonicalize().unwrap().join("out");
        (around, out)
    }

    /// Makes a book of one page, with its list.
    fn book(folder: &Path, page: &str) {
        fs::create_dir_all(folder).unwrap();
        fs::write(folder.join("index.html"), page).unwrap();
        list::write(folder).unwrap();
    }

    fn page(folder: &Path) -> String {
        fs::read_to_string(folder.join("index.html")).unwrap()
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_book_is_put_in_place_and_nothing_is_left_over() {
        let (around, out) = around();
        for text in ["first", "second"] {
            let site = Site::open(&out).unwrap();
            book(&site.new_book(), text);
            assert_eq!(names(around.path())[0], ".out.geneva-build");
            assert!(site.finish().unwrap().is_empty());
            assert_eq!(page(&out), text);
            assert_eq!(names(around.path()), ["out"]);
        }
    }

    #[test]
    fn a_build_that_ends_early_leaves_the_old_book_alone() {
        let (around, out) = around();
        book(&out, "old");
        let site = Site::open(&out).unwrap();
        book(&site.new_book(), "new");
        drop(site);
        assert_eq!(page(&out), "old");
        assert_eq!(names(around.path()), ["out"]);
    }

    #[test]
    fn a_second_build_is_refused_while_the_first_one_lasts() {
        let (around, out) = around();
        let first = Site::open(&out).unwrap();
        book(&first.new_book(), "first");
        let said = Site::open(&out).err().unwrap().to_string();
        assert!(said.contains("another build into") && said.contains("wait for it, or choose another"), "{said}");
        Site::open(&around.path().join("other")).unwrap();
        first.finish().unwrap();
        assert_eq!(page(&out), "first");
        Site::open(&out).unwrap();
    }

    #[test]
    fn builds_at_once_end_one_by_one_or_are_refused() {
        let (around, out) = around();
        let build = |number: usize| match Site::open(&out) {
            Ok(site) => {
                book(&site.new_book(), &number.to_string());
                site.finish().unwrap();
            }
            Err(error) => assert!(error.to_string().contains("another build"), "{error:#}"),
        };
        std::thread::scope(|scope| {
            for number in 0..8 {
                scope.spawn(move || (0..20).for_each(|round| build(20 * number + round)));
            }
        });
        assert_eq!(names(around.path()), ["out"]);
        list::refuse_foreign(&out).unwrap();
    }

    #[test]
    fn what_a_killed_build_left_is_cleared() {
        let (around, out) = around();
        book(&out, "old");
        let paths = Paths::of(&out).unwrap();
        // A half-made book, and an old one that was being removed.
        fs::create_dir_all(paths.new().join("css")).unwrap();
        fs::write(paths.new().join("index.html"), "half").unwrap();
        fs::write(paths.folder.join("lock"), "").unwrap();
        book(&paths.old(), "older");
        let site = Site::open(&out).unwrap();
        assert_eq!(names(&paths.folder), ["lock"]);
        assert_eq!(page(&out), "old");
        drop(site);
        assert_eq!(names(around.path()), ["out"]);
    }

    #[test]
    fn a_build_that_was_killed_between_the_two_steps_is_repaired() {
        let (around, out) = around();
        book(&out, "old");
        let paths = Paths::of(&out).unwrap();
        book(&paths.new(), "new");
        fs::rename(&out, paths.old()).unwrap();
        let site = Site::open(&out).unwrap();
        assert_eq!(page(&out), "old");
        assert!(!is_there(&paths.old()) && !is_there(&paths.new()));
        drop(site);
        assert_eq!(names(around.path()), ["out"]);
    }

    #[test]
    fn an_old_book_comes_back_even_if_the_build_is_refused() {
        let (_around, out) = around();
        let paths = Paths::of(&out).unwrap();
        book(&paths.old(), "old");
        fs::write(paths.old().join("CNAME"), "").unwrap();
        let said = Site::open(&out).err().unwrap().to_string();
        assert!(said.contains("`CNAME`"), "{said}");
        assert_eq!(page(&out), "old");
        assert!(!is_there(&paths.folder));
    }

    #[test]
    fn what_comes_into_the_output_during_the_build_stays_there() {
        let (_around, out) = around();
        book(&out, "old");
        let site = Site::open(&out).unwrap();
        book(&site.new_book(), "new");
        fs::write(out.join("notes.txt"), "mine").unwrap();
        let said = site.finish().unwrap_err().to_string();
        assert!(said.contains("`notes.txt`"), "{said}");
        assert_eq!(page(&out), "old");
        assert!(out.join("notes.txt").is_file());
    }

    #[test]
    fn what_comes_at_the_last_moment_is_kept() {
        let (around, out) = around();
        for kept in ["out.kept", "out.kept-2"] {
            book(&out, "old");
            let mut site = Site::open(&out).unwrap();
            book(&site.new_book(), "new");
            site.paths.check().unwrap();
            fs::create_dir(out.join("photos")).unwrap();
            fs::write(out.join("photos/one.jpg"), "mine").unwrap();
            site.paths.put().unwrap();
            site.kept.extend(site.paths.settle().unwrap());
            assert_eq!(site.kept, [out.with_file_name(kept)]);
            drop(site);
            assert_eq!(page(&out), "new");
            assert_eq!(names(&out.with_file_name(kept)), ["photos"]);
        }
        assert_eq!(names(around.path()), ["out", "out.kept", "out.kept-2"]);
    }

    #[test]
    fn an_output_that_becomes_something_else_is_left_alone() {
        let (_around, out) = around();
        let site = Site::open(&out).unwrap();
        book(&site.new_book(), "new");
        fs::write(&out, "mine").unwrap();
        assert!(site.finish().unwrap_err().to_string().contains("is not a folder"));
        assert_eq!(fs::read_to_string(&out).unwrap(), "mine");
    }

    #[test]
    fn a_build_that_is_stopped_can_write_no_more() {
        let (around, out) = around();
        book(&out, "old");
        let site = Site::open(&out).unwrap();
        let new = site.new_book();
        std::thread::scope(|scope| {
            scope.spawn(|| {
                while fs::create_dir_all(new.join("css")).and_then(|()| fs::write(new.join("css/a"), "")).is_ok() {}
            });
            site.paths.stop();
        });
        assert!(fs::create_dir_all(new.join("css")).is_err());
        drop(site);
        assert_eq!(page(&out), "old");
        assert_eq!(names(around.path()), ["out"]);
    }

    #[test]
    fn what_is_in_the_way_of_the_hidden_folder_is_named() {
        let (_around, out) = around();
        let paths = Paths::of(&out).unwrap();
        fs::write(&paths.folder, "mine").unwrap();
        let said = Site::open(&out).err().unwrap().to_string();
        assert!(said.contains(".out.geneva-build is not a folder"), "{said}");
        assert!(paths.folder.is_file());
    }

    #[test]
    fn what_somebody_puts_into_the_hidden_folder_stays() {
        let (_around, out) = around();
        let site = Site::open(&out).unwrap();
        let mine = site.paths.folder.join("mine");
        fs::write(&mine, "").unwrap();
        drop(site);
        assert!(mine.is_file());
    }
}
