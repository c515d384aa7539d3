//! The folder that a book is built into: what cannot be one is refused before anything is built.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};

/// The output folder as an absolute path with links resolved. It may be absent; its parent is made if that is absent.
///
/// The chapters are in `source`: a book that is built there would become part of the next one.
pub(super) fn find(out: &Path, source: &Path) -> anyhow::Result<PathBuf> {
    // Without a slash at the end, which would follow a link.
    let out: PathBuf = out.components().collect();
    ensure!(!out.as_os_str().is_empty(), "the output folder has no name: name one");
    let whole = match out.symlink_metadata() {
        Ok(there) if there.is_dir() || there.is_symlink() => standing(&out, there.is_symlink())?,
        Ok(_) => bail!("{} is not a folder: choose another output folder", out.display()),
        Err(error) if [ErrorKind::NotFound, ErrorKind::NotADirectory].contains(&error.kind()) => absent(&out)?,
        Err(error) => return Err(error).with_context(|| unusable(&out)),
    };
    ensure!(
        !whole.starts_with(source),
        "{} is in the folder of the chapters, {}: choose another output folder",
        out.display(),
        source.display()
    );
    Ok(whole)
}

/// A folder that is there, or a link to one.
fn standing(out: &Path, is_link: bool) -> anyhow::Result<PathBuf> {
    let whole = match out.canonicalize() {
        Ok(whole) => whole,
        Err(error) if is_link => {
            bail!(
                "{} is a link to something that is not there ({error}): remove the link, or choose another output folder",
                out.display()
            )
        }
        Err(error) => return Err(error).with_context(|| unusable(out)),
    };
    ensure!(
        whole.is_dir(),
        "{} is a link to something that is not a folder: choose another output folder",
        out.display()
    );
    let Some(parent) = whole.parent() else {
        bail!("{} is the root of the file system: choose another output folder", out.display())
    };
    may_be_moved(&whole, parent)
        .with_context(|| format!("{} cannot be replaced: choose another output folder", out.display()))?;
    Ok(whole)
}

/// Checks that the system would let a folder be moved out of its parent.
#[cfg(unix)]
fn may_be_moved(folder: &Path, parent: &Path) -> io::Result<()> {
    use rustix::fs::{Access, access};
    use std::os::unix::fs::MetadataExt;
    access(folder, Access::READ_OK | Access::WRITE_OK | Access::EXEC_OK)?;
    if folder.metadata()?.dev() != parent.metadata()?.dev() {
        return Err(io::Error::other("another file system is mounted there"));
    }
    Ok(())
}

/// Checks nothing: other systems only say so when the folder is moved.
#[cfg(not(unix))]
fn may_be_moved(_: &Path, _: &Path) -> io::Result<()> {
    Ok(())
}

/// A folder that is to be made.
fn absent(out: &Path) -> anyhow::Result<PathBuf> {
    let whole = std::path::absolute(out).with_context(|| unusable(out))?;
    let (Some(parent), Some(name)) = (whole.parent(), whole.file_name()) else {
        bail!("{} cannot be made: choose another output folder", out.display());
    };
    fs::create_dir_all(parent)
        .with_context(|| format!("cannot make the folder {}: choose another output folder", parent.display()))?;
    Ok(parent.canonicalize().with_context(|| unusable(out))?.join(name))
}

fn unusable(out: &Path) -> String {
    format!("cannot use {}: choose another output folder", out.display())
}

#[cfg(test)]
mod tests {
    use super::*;
    use tempfile::TempDir;

    #[track_caller]
    fn refusal(out: &Path) -> String {
        let said = format!("{:#}", find(out, Path::new("/no/such/source")).unwrap_err());
        assert!(said.contains("choose another output folder"), "{said}");
        said
    }

    #[test]
    fn an_absent_folder_is_taken_and_its_parent_made() {
        let around = TempDir::new().unwrap();
        let whole = find(&around.path().join("new/place/out/"), Path::new("/src")).unwrap();
        assert_eq!(whole, around.path().canonicalize().unwrap().join("new/place/out"));
        assert!(whole.parent().unwrap().is_dir() && !whole.exists());
    }

    #[test]
    fn what_is_no_folder_is_named() {
        let around = TempDir::new().unwrap();
        let file = around.path().join("file");
        fs::write(&file, "").unwrap();
        assert!(refusal(&file).contains("file is not a folder"));
        assert!(refusal(&file.join("out")).contains("cannot make the folder"));
        assert!(refusal(&around.path().join("no/such/..")).contains("cannot be made"));
        assert!(find(Path::new(""), Path::new("/src")).unwrap_err().to_string().contains("has no name"));
    }

    #[test]
    fn the_folder_of_the_chapters_is_not_for_the_book() {
        let around = TempDir::new().unwrap();
        let source = around.path().canonicalize().unwrap();
        for out in [around.path().to_owned(), around.path().join("book")] {
            let said = format!("{:#}", find(&out, &source).unwrap_err());
            assert!(said.contains("is in the folder of the chapters"), "{said}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_followed_and_must_lead_to_a_folder() {
        use std::os::unix::fs::symlink;
        let around = TempDir::new().unwrap();
        let [real, link, dangling, to_file] =
            ["real", "link", "dangling", "to-file"].map(|name| around.path().join(name));
        fs::create_dir(&real).unwrap();
        fs::write(around.path().join("file"), "").unwrap();
        symlink("real", &link).unwrap();
        symlink("nowhere", &dangling).unwrap();
        symlink("file", &to_file).unwrap();
        assert_eq!(find(&link, Path::new("/src")).unwrap(), real.canonicalize().unwrap());
        for dangling in [dangling.clone(), dangling.join("")] {
            assert!(refusal(&dangling).contains("dangling is a link to something that is not there"));
        }
        assert!(refusal(&to_file).contains("to-file is a link to something that is not a folder"));
        assert!(refusal(Path::new("/")).contains("the root of the file system"));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_mount_point_cannot_be_replaced() {
        assert!(refusal(Path::new("/proc")).contains("/proc cannot be replaced"));
    }
}
