//! The book: built, opened, tested.

use crate::ebook::EpubArguments;
use crate::output::{Outcome, OutputStreams};
use crate::print::PrintArguments;
use crate::{ebook, print, progress, signals, workspace};
use anyhow::Context;
use clap::{Args, Subcommand};
use geneva_chapters::BOOK;
use geneva_press::building::BuiltBook;
use std::path::PathBuf;

/// Options of `geneva book`.
#[derive(Args, Debug)]
pub(crate) struct BookArguments {
    /// What to do with the book; without it, build.
    #[command(subcommand)]
    pub action: Option<BookAction>,
    /// Without an action: how to build.
    #[command(flatten)]
    pub build: BuildArguments,
}

/// Actions of `geneva book`.
#[derive(Debug, Subcommand)]
pub(crate) enum BookAction {
    /// Build the book; this is what `geneva book` does
    #[command(after_help = "\
Example:
  geneva book build --output public --open")]
    Build(BuildArguments),
    /// Print the whole book into one PDF, with Chromium or Chrome
    ///
    /// The contents get the numbers of their pages, and the PDF an outline. The browser is the program that $CHROMIUM names,
    /// or the first that is installed.
    #[command(after_help = "\
Example:
  geneva book print --output geneva-verified.pdf")]
    Print(PrintArguments),
    /// Make the whole book an ebook, in EPUB 3
    ///
    /// It has the chapters that `geneva book print` has, with formulas in MathML and drawings in SVG. It needs no browser.
    #[command(after_help = "\
Example:
  geneva book epub --output geneva-verified.epub")]
    Epub(EpubArguments),
    /// Compile and run every Rust block in every chapter
    #[command(after_help = "\
Example:
  geneva book test")]
    Test,
}

/// Options of `geneva book build`.
#[derive(Args, Debug, Default)]
pub(crate) struct BuildArguments {
    /// Build into this directory; a book already there is replaced once the new one is complete
    /// [default: target/book in the workspace]
    #[arg(long, value_name = "DIR", alias = "out")]
    pub output: Option<PathBuf>,
    /// Open the book once it is built
    #[arg(long)]
    pub open: bool,
}

/// Builds the book or tests its chapters.
pub(crate) fn run(wanted: BookArguments, streams: &mut dyn OutputStreams) -> anyhow::Result<Outcome> {
    match wanted.action {
        None => build(&wanted.build, streams)?,
        Some(BookAction::Build(wanted)) => build(&wanted, streams)?,
        Some(BookAction::Print(wanted)) => print::run(&wanted, streams)?,
        Some(BookAction::Epub(wanted)) => ebook::run(&wanted, streams)?,
        Some(BookAction::Test) => test(streams)?,
    }
    Ok(Outcome::AsRecorded)
}

/// Builds the book, says where it is and how to open it, and opens it on request.
pub(crate) fn build(wanted: &BuildArguments, streams: &mut dyn OutputStreams) -> anyhow::Result<()> {
    let root = workspace::root()?;
    let out = wanted.output.clone().unwrap_or_else(|| root.join("target").join("book"));
    let BuiltBook { first_page, kept } = {
        let _step = progress::step(format!("building the book in {}", out.display()));
        signals::clear_up_first()?;
        geneva_press::build(&BOOK, &root, &out)?
    };
    let folder = first_page.parent().unwrap_or(&out);
    let layout = streams.layout();
    streams.print(&layout.folded(&format!("The book is in {}\n", folder.display())))?;
    for kept in kept {
        streams.print(&layout.folded(&format!(
            "Files that were added while the old book was being replaced are in {}\n",
            kept.display()
        )))?;
    }
    if wanted.open {
        open::that_detached(&first_page)
            .with_context(|| format!("no program was found to open {}; open it in a browser", first_page.display()))?;
    } else {
        streams.print(&layout.folded(&format!("Open {} in a browser.\n", first_page.display())))?;
    }
    Ok(())
}

/// What is said once the chapters have been tested.
pub(crate) const TESTED: &str = "Every Rust block of the book compiles and runs.\n";

fn test(streams: &mut dyn OutputStreams) -> anyhow::Result<()> {
    {
        let _step = progress::step("testing the chapters");
        geneva_press::test(&BOOK, &workspace::root()?)?;
    }
    streams.print(TESTED)?;
    Ok(())
}
