//! Two folders trade places, in one step where the system can do that.

use std::fs;
use std::io;
use std::path::Path;

/// Lets two folders of one file system trade places. Whether the system can: if it cannot, both are where they were.
#[cfg(any(target_os = "linux", target_vendor = "apple"))]
pub(super) fn at_once(one: &Path, other: &Path) -> io::Result<bool> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    match renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE) {
        Ok(()) => Ok(true),
        Err(Errno::NOSYS | Errno::INVAL | Errno::NOTSUP) => Ok(false),
        Err(error) => Err(error.into()),
    }
}

/// Says that the system cannot: others than Linux and those of Apple have no call for it.
#[cfg(not(any(target_os = "linux", target_vendor = "apple")))]
pub fn at_once(_: &Path, _: &Path) -> io::Result<bool> {
    Ok(false)
}

/// Moves `out` to `old` and `new` to `out`. If the second move fails, the first one is undone.
///
/// Between the two moves there is nothing at `out`. If the program is killed just then, the next build puts `old` back.
pub(super) fn in_two_steps(new: &Path, out: &Path, old: &Path) -> io::Result<()> {
    fs::rename(out, old)?;
    fs::rename(new, out).inspect_err(|_| {
        // If this fails too, the next build tries again.
        let _ = fs::rename(old, out);
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::PathBuf;
    use tempfile::TempDir;

    /// A folder with folders of these names, each with a file of its name.
    fn folders(names: &[&str]) -> (TempDir, Vec<PathBuf>) {
        let around = TempDir::new().unwrap();
        let paths: Vec<_> = names.iter().map(|name| around.path().join(name)).collect();
        for (name, path) in names.iter().zip(&paths) {
            fs::create_dir(path).unwrap();
            fs::write(path.join(name), "").unwrap();
        }
        (around, paths)
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn two_folders_trade_places() {
        let (_around, paths) = folders(&["one", "other"]);
        if at_once(&paths[0], &paths[1]).unwrap() {
            assert!(paths[0].join("other").is_file() && paths[1].join("one").is_file());
            assert!(at_once(&paths[0], &paths[0].join("absent")).is_err());
        } else {
            assert!(paths[0].join("one").is_file() && paths[1].join("other").is_file());
        }
    }

    #[test]
    fn two_steps_do_the_same_and_a_failed_second_one_undoes_the_first() {
        let (around, paths) = folders(&["new", "out"]);
        let old = around.path().join("old");
        in_two_steps(&paths[0], &paths[1], &old).unwrap();
        assert!(paths[1].join("new").is_file() && old.join("out").is_file() && !paths[0].exists());
        in_two_steps(&paths[0], &paths[1], &around.path().join("older")).unwrap_err();
        assert!(paths[1].join("new").is_file());
    }
}
