//! Where the output goes: to standard output as it comes, or to a file that is either complete or not there.
//!
//! What is for a file is collected in a file without a name, which the system takes away with the program, however that
//! ends. When it is complete it is copied beside the file, and the copy takes its place. Only a program that is
//! ended while it copies leaves something behind: the copy, named as the file with `.unfinished-` and some letters.

use crate::output::{STANDARD_OUTPUT, UNWRITABLE};
use crate::printable::in_words;
use anyhow::{Context, anyhow, bail, ensure};
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Seek, Write};
use std::path::{Path, PathBuf};

/// Where the output is written.
pub enum Destination {
    /// Standard output.
    Output,
    /// A file, and what has been collected for it.
    File { target: PathBuf, collected: File },
}

impl Destination {
    /// What was asked for: a path, or `-`.
    pub fn new(asked: &str) -> anyhow::Result<Self> {
        if asked == STANDARD_OUTPUT {
            return Ok(Self::Output);
        }
        // A link stays a link; what it leads to is replaced, or made.
        let target = followed(asked);
        match fs::metadata(&target) {
            Ok(there) if there.is_file() => {
                // The system lets a file be replaced that may not be written, and whoever made it so did not want that.
                // The mode counts for the superuser too.
                ensure!(
                    !there.permissions().readonly(),
                    "--output {asked} is a read-only file; give another file, or - for standard output"
                );
                OpenOptions::new().write(true).open(&target).map_err(|error| unwritable(asked, &error))?;
            }
            Ok(there) if there.is_dir() => {
                bail!("--output {asked} is a folder; give a file in it, or - for standard output")
            }
            Ok(_) => {
                bail!("--output {asked} is not a file that can be replaced; give another, or - for standard output")
            }
            Err(_) if asked.ends_with(std::path::is_separator) => {
                bail!("--output {asked} is a folder that doesn't exist; give a file, or - for standard output")
            }
            Err(_) if target.file_name().is_none() => {
                bail!("--output '{asked}' is not a file; give one, or - for standard output")
            }
            Err(_) if target.is_symlink() => {
                bail!("--output {asked} is a link that leads nowhere; give a file, or - for standard output")
            }
            Err(_) => {}
        }
        let collected = tempfile::tempfile_in(folder(&target)).map_err(|error| unwritable(asked, &error))?;
        Ok(Self::File { target, collected })
    }

    /// Adds bytes. Whether any more are wanted: a reader that has seen enough closes the pipe.
    pub fn add(&mut self, bytes: &[u8]) -> anyhow::Result<bool> {
        match self {
            Self::Output => match io::stdout().lock().write_all(bytes) {
                Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(false),
                result => result.map(|()| true).context(UNWRITABLE),
            },
            Self::File { target, collected } => {
                collected.write_all(bytes).map(|()| true).map_err(|error| unwritable(&target.to_string_lossy(), &error))
            }
        }
    }

    /// Puts the file in its place, if there is one: says which.
    pub fn finish(self) -> anyhow::Result<Option<PathBuf>> {
        match self {
            Self::Output => match io::stdout().lock().flush() {
                Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error).context(UNWRITABLE),
                _ => Ok(None),
            },
            Self::File { target, collected } => {
                replace(&target, collected).map_err(|error| unwritable(&target.to_string_lossy(), &error))?;
                Ok(Some(target))
            }
        }
    }
}

/// Refuses to write the output over one of the files that are read.
pub fn apart_from<'a>(asked: &str, inputs: impl IntoIterator<Item = &'a Path>) -> anyhow::Result<()> {
    let Some(target) = fs::canonicalize(asked).ok().filter(|_| asked != STANDARD_OUTPUT) else { return Ok(()) };
    let own = inputs.into_iter().find(|input| is_one_file(input, &target));
    match own {
        Some(own) => bail!(
            "--output {asked} would overwrite {}, which is an input; give another file, or - for standard output",
            own.display()
        ),
        None => Ok(()),
    }
}

/// Where a path leads: through links also to a file that is not there yet.
fn followed(asked: &str) -> PathBuf {
    /// More links in a row than any system follows.
    const MOST_LINKS: usize = 40;
    if let Ok(target) = fs::canonicalize(asked) {
        return target;
    }
    let mut target = PathBuf::from(asked);
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&target) else { break };
        target = folder(&target).join(next);
    }
    target
}

/// Whether two paths are one file, be it under two names.
fn is_one_file(one: &Path, other: &Path) -> bool {
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

fn unwritable(target: &str, error: &io::Error) -> anyhow::Error {
    let cause = in_words(error);
    anyhow!("cannot write {target}: {cause}; give another --output, in a folder that exists, or - for standard output")
}
