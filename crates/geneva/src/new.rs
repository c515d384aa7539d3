//! `geneva new`: a crate in which a document is checked, claim by claim.

mod engine;
mod first_claims;
mod names;
mod sentences;
mod templates;

use crate::input::MOST_BYTES;
use crate::output::{TextLayout, count};
use crate::printable::shown_path;
use anyhow::{Context, Error, bail, ensure};
use clap::Args;
use engine::Engine;
use geneva_evidence::number_tokens;
use geneva_host::files;
use geneva_host::printable::in_words;
use proofread::TextFormat;
use proofread::reader::shown_lines;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Options of `geneva new`.
#[derive(Args, Debug)]
pub(crate) struct NewArguments {
    /// The folder to make; it may be there already if it is empty
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// The document: a text in Markdown, LaTeX, XML, HTML, a Jupyter notebook or plain lines, by the ending of its name
    #[arg(long, value_name = "TEXT")]
    pub from: PathBuf,
    /// The folder of the project that has the engine [default: found from here and from this program]
    #[arg(long, value_name = "DIR")]
    pub engine: Option<PathBuf>,
}

/// A text that is to be checked.
struct SourceText {
    /// Its file's name.
    name: String,
    /// Its characters.
    text: String,
    /// What it is written in.
    format: TextFormat,
    /// What each line of its file shows.
    shown: Vec<String>,
}

/// A file of the new crate: its path there, and its bytes.
type MadeFile = (String, Vec<u8>);

/// Makes the crate, and says what to do next.
pub(crate) fn page(wanted: &NewArguments, layout: TextLayout) -> anyhow::Result<String> {
    let place = Place::new(&wanted.folder)?;
    let source = SourceText::read(&wanted.from)?;
    let engine = Engine::find(wanted.engine.as_deref())?;
    let package = names::package(&place.name);
    let crate_files = templates::files(&source, &engine, &package)?;
    place.fill(&crate_files)?;
    let printing = source.shown.iter().map(|line| number_tokens(line).len()).filter(|numbers| *numbers > 0);
    let (lines, numbers) = printing.fold((0, 0), |(lines, sum), numbers| (lines + 1, sum + numbers));
    let made = format!(
        "{} is a crate for {}, which prints {} in {}. In this folder,",
        shown_path(&wanted.folder),
        shown_path(&wanted.from),
        count(numbers, "number"),
        count(lines, "line")
    );
    Ok(layout.wrapped("", &made)
        + &layout.wrapped("  cargo run   ", "builds the book and says what is not yet accounted for;")
        + &layout.wrapped("  cargo test  ", "says what is wrong with the ledger;")
        + &layout.wrapped("  README.md   ", "leads to the first verdict."))
}

impl SourceText {
    fn read(path: &Path) -> anyhow::Result<Self> {
        let shown_name = shown_path(path);
        let name = path.file_name().and_then(|name| name.to_str()).filter(|name| !name.contains(char::is_control));
        let name = name.with_context(|| {
            format!("--from {shown_name} is no name of a file in UTF-8; give a text, such as notes.md")
        })?;
        let extension = Path::new(name).extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let format = TextFormat::from_extension(extension).with_context(|| {
            let pdf = match extension.eq_ignore_ascii_case("pdf") {
                true => "; `pdftotext -layout` makes a text of a PDF",
                false => "",
            };
            format!("--from {shown_name}: give a text that ends in .md, .tex, .xml, .html, .ipynb or .txt{pdf}")
        })?;
        let bytes = files::read(path, MOST_BYTES, "--from a text").map_err(Error::msg)?;
        let text = String::from_utf8(bytes).ok().with_context(|| {
            format!("--from {shown_name} is not in UTF-8; save it in this encoding, and give it again")
        })?;
        let shown = shown_lines(&text, format).map_err(|error| Error::msg(format!("--from {shown_name}: {error}")))?;
        ensure!(
            shown.iter().any(|line| !number_tokens(line).is_empty()),
            "--from {shown_name} shows no number, so there is nothing to account for; give a text that prints some"
        );
        Ok(Self { name: name.to_owned(), text, format, shown })
    }
}

/// Where the crate is to be.
struct Place {
    /// The folder, which is not there or empty.
    folder: PathBuf,
    /// The folder that it is in.
    parent: PathBuf,
    /// Its name.
    name: String,
    is_there: bool,
}

impl Place {
    fn new(asked: &Path) -> anyhow::Result<Self> {
        let shown = shown_path(asked);
        let unreadable = |error: &io::Error| format!("cannot read {shown}: {}; give another folder", in_words(error));
        let is_there = match fs::read_dir(asked) {
            Ok(mut inside) => {
                ensure!(
                    inside.next().is_none(),
                    "{shown} is not empty; give a folder that is not there, or an empty one"
                );
                true
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => false,
            Err(error) if error.kind() == io::ErrorKind::NotADirectory => {
                bail!("{shown} is a file; give a folder that is not there, or an empty one")
            }
            Err(error) => bail!(unreadable(&error)),
        };
        ensure!(is_there || !asked.is_symlink(), "{shown} is a link that leads nowhere; give another folder");
        // What is there may be named by dots.
        let folder = if is_there {
            fs::canonicalize(asked).map_err(|error| Error::msg(unreadable(&error)))?
        } else {
            asked.into()
        };
        let name = folder.file_name().map(|name| name.to_string_lossy().into_owned());
        let name = name.with_context(|| format!("{shown} is no name for a folder; give one, such as my-check"))?;
        let parent =
            folder.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_owned();
        ensure!(
            parent.is_dir(),
            "{} is no folder, so {shown} cannot be made in it; make it first, or give another",
            shown_path(&parent)
        );
        Ok(Self { folder, parent, name, is_there })
    }

    /// Puts all files in their place, or none.
    fn fill(&self, files: &[MadeFile]) -> anyhow::Result<()> {
        let unwritable = |error: io::Error| {
            let shown = shown_path(&self.folder);
            Error::msg(format!("cannot make {shown}: {}; give a folder where you may write", in_words(&error)))
        };
        let mut builder = tempfile::Builder::new();
        let prefix = format!("{}.unfinished-", self.name);
        builder.prefix(&prefix);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // Those of any new folder; the system takes away what the user's mask does.
            builder.permissions(fs::Permissions::from_mode(0o777));
        }
        let beside = if self.is_there { &self.folder } else { &self.parent };
        let unfinished = builder.tempdir_in(beside).map_err(unwritable)?;
        let write = |(path, bytes): &MadeFile| {
            let path = unfinished.path().join(path);
            path.parent().map_or(Ok(()), fs::create_dir_all)?;
            fs::write(path, bytes)
        };
        files.iter().try_for_each(write).map_err(unwritable)?;
        if !self.is_there {
            return fs::rename(unfinished.path(), &self.folder).map_err(unwritable);
        }
        let mut moved = Vec::new();
        if let Err(error) = move_all(unfinished.path(), &self.folder, &mut moved) {
            for path in moved.iter().rev() {
                // What was empty is to be empty again, as far as the system lets it.
                let _ = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
            }
            return Err(unwritable(error));
        }
        Ok(())
    }
}

/// Moves what is in a folder to another one, and notes what is there now.
fn move_all(from: &Path, to: &Path, moved: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let target = to.join(entry.file_name());
        fs::rename(entry.path(), &target)?;
        moved.push(target);
    }
    Ok(())
}
