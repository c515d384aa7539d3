//! Where the output goes: to standard output as it comes, or to a file that is either complete or not there.

use anyhow::{Context, Error, bail};
use geneva_host::files::{NewFile, OutputOption, is_one_file};
use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// What is asked for instead of a file.
pub(crate) const STANDARD_OUTPUT: &str = "-";

/// The message if standard output takes nothing.
pub(crate) const UNWRITABLE: &str = "cannot write to standard output";

const OPTION: OutputOption = OutputOption { name: "--output", instead: ", or - for standard output" };

/// Where the output is written.
pub(crate) enum Destination {
    /// Standard output.
    Output,
    /// A file.
    File(NewFile),
}

impl Destination {
    /// What was asked for: a path, or `-`.
    pub(crate) fn new(asked: &str) -> anyhow::Result<Self> {
        if asked == STANDARD_OUTPUT {
            return Ok(Self::Output);
        }
        NewFile::new(Path::new(asked), OPTION).map(Self::File).map_err(Error::msg)
    }

    /// Adds bytes. Whether any more are wanted: a reader that has seen enough closes the pipe.
    pub(crate) fn add(&mut self, bytes: &[u8]) -> anyhow::Result<bool> {
        match self {
            Self::Output => match io::stdout().lock().write_all(bytes) {
                Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(false),
                result => result.map(|()| true).context(UNWRITABLE),
            },
            Self::File(file) => file.add(bytes).map(|()| true).map_err(Error::msg),
        }
    }

    /// Puts the file in its place, if there is one: says which.
    pub(crate) fn finish(self) -> anyhow::Result<Option<PathBuf>> {
        match self {
            Self::Output => match io::stdout().lock().flush() {
                Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error).context(UNWRITABLE),
                _ => Ok(None),
            },
            Self::File(file) => file.finish().map(Some).map_err(Error::msg),
        }
    }
}

/// Refuses to write the output over one of the files that are read.
pub(crate) fn apart_from<'a>(asked: &str, inputs: impl IntoIterator<Item = &'a Path>) -> anyhow::Result<()> {
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
