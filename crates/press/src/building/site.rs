//! The folder in which a book is put together: hidden, beside the output, and of one build at a time.
//!
//! It holds a file `lock` and two folders, `new` and `old`. The lock is held until the build ends, even if the build is
//! killed. The new book grows in `new`, where only builds write, so everything in there may be removed. `old` is there
//! while the books trade places. It holds what was at the output, so it is only ever removed by its list.

use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use anyhow::{Context, bail, ensure};

use super::{exchange, list};

/// The builds of this process. A build holds them while it does what must not be cut short.
static UNDER_WAY: Mutex<Vec<Paths>> = Mutex::new(Vec::new());

fn under_way() -> MutexGuard<'static, Vec<Paths>> {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Clears up after all builds of this process, then calls `end`, which should end the process.
///
/// This is for signals. The output folders stay as they were. A build that fails because its folder is gone waits until
/// `end` returns, so it does not report the failure.
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
pub(super) struct Site {
    paths: Paths,
    /// Locked as long as it is open.
    _lock: File,
    /// Folders that hold files which somebody added to an old book before it was removed.
    kept: Vec<PathBuf>,
}

impl Site {
    /// Makes the folder for a build into `out`, and clears up after a build that was killed: if it had just moved the old
    /// book away, the book comes back.
    ///
    /// Refuses if another build into `out` is under way, or if `out` holds anything but a book.
    pub(super) fn open(out: &Path) -> anyhow::Result<Self> {
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
    pub(super) fn new_book(&self) -> PathBuf {
        self.paths.new_book()
    }

    /// Puts the new book, which is complete and has its list, in its place, and removes the old one.
    ///
    /// Returns the folders that hold files which came into the output at the last moment.
    pub(super) fn finish(mut self) -> anyhow::Result<Vec<PathBuf>> {
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

    fn new_book(&self) -> PathBuf {
        self.folder.join("new")
    }

    fn old_book(&self) -> PathBuf {
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

    /// Refuses an output that is there, unless it is empty or a book and nothing else.
    fn check(&self) -> anyhow::Result<()> {
        let Ok(there) = self.out.symlink_metadata() else { return Ok(()) };
        ensure!(there.is_dir(), "{} is not a folder: choose another output folder", self.out.display());
        list::refuse_foreign(&self.out)
    }

    /// Moves the new book to the output. A book that is there is in `old` then.
    fn put(&self) -> anyhow::Result<()> {
        let (new, old, out) = (self.new_book(), self.old_book(), &self.out);
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

    /// Clears `new` and `old`. If there is no book at the output, the old one goes back there. If there is one, the old one
    /// is removed; files that are not on its list are kept in a folder, which is returned.
    fn settle(&self) -> anyhow::Result<Option<PathBuf>> {
        let (new, old) = (self.new_book(), self.old_book());
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
        let old = self.old_book();
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

    /// Stops the build of this process: from now on it fails as soon as it writes into `new`.
    ///
    /// Pages make the folders that they are written to, so it is not enough to remove the folder. A file takes its place.
    fn stop(&self) {
        // A millisecond after each: a build that writes all the time can win some of them.
        const TRIES: u32 = 2000;
        // Long enough for a build that is writing to find out, and to wait from then on.
        const PAUSE: Duration = Duration::from_millis(20);
        let new = self.new_book();
        for _ in 0..TRIES {
            if remove_all(&new).is_ok() && File::create_new(&new).is_ok() {
                return std::thread::sleep(PAUSE);
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// Removes the folder, if nothing is left in it but the lock.
    fn release(&self) {
        // If somebody has put something else there, the folder stays.
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
mod tests;
