//! The book as an ebook.

use crate::output::OutputStreams;
use crate::{progress, signals, workspace};
use anyhow::{Context, Error, bail};
use clap::Args;
use geneva_chapters::BOOK;
use geneva_host::files::{NewFile, OutputOption};
use geneva_press::epub;
use std::fs;
use std::io::ErrorKind;
use std::path::PathBuf;

/// Options of `geneva book epub`.
#[derive(Args, Debug, Default)]
pub(crate) struct EpubArguments {
    /// Write this file; one that is there is replaced once the new one is complete
    /// [default: target/geneva-verified.epub in the workspace]
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Builds the book in a folder of its own, and takes the ebook out of it.
pub(crate) fn run(wanted: &EpubArguments, streams: &mut dyn OutputStreams) -> anyhow::Result<()> {
    let root = workspace::root()?;
    let out = match &wanted.output {
        Some(out) => out.clone(),
        None => {
            let target = root.join("target");
            fs::create_dir_all(&target).with_context(|| format!("cannot make the folder {}", target.display()))?;
            target.join(epub::file(&BOOK))
        }
    };
    // Asked first: to build takes a while.
    let mut file = NewFile::new(&out, OutputOption { name: "--output", instead: "" }).map_err(Error::msg)?;
    let folder = tempfile::tempdir().context("cannot make a folder for a while")?;
    let book = folder.path().join("book");
    {
        let _step = progress::step("building the book");
        signals::clear_up_first()?;
        geneva_press::build(&BOOK, &root, &book)?;
    }
    let ebook = match fs::read(book.join(epub::file(&BOOK))) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == ErrorKind::NotFound => {
            bail!("the book in {} has no page for an ebook: no chapter of the list of pages is in it", root.display())
        }
        Err(error) => return Err(error).context("cannot read the ebook"),
    };
    file.add(&ebook).map_err(Error::msg)?;
    let out = file.finish().map_err(Error::msg)?;
    streams.print(&streams.layout().folded(&format!("The book is in {}.\n", out.display())))
}
