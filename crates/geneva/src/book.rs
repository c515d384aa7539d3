//! The book: built, opened, tested.

use crate::arguments::{BookAction, BookArguments, BuildArguments};
use crate::output::{Outcome, Streams};
use crate::{print, progress, signals, workspace};
use anyhow::Context;
use geneva_press::Geneva;
use geneva_press::building::{self, Built};

/// Builds the book or tests its chapters.
pub fn run(wanted: BookArguments, streams: &mut dyn Streams) -> anyhow::Result<Outcome> {
    match wanted.action {
        None => build(&wanted.build, streams)?,
        Some(BookAction::Build(wanted)) => build(&wanted, streams)?,
        Some(BookAction::Print(wanted)) => print::run(&wanted, streams)?,
        Some(BookAction::Test) => test(streams)?,
    }
    Ok(Outcome::AsRecorded)
}

/// Builds the book, says where it is and how to open it, and opens it on request.
pub fn build(wanted: &BuildArguments, streams: &mut dyn Streams) -> anyhow::Result<()> {
    let root = workspace::root()?;
    let out = wanted.output.clone().unwrap_or_else(|| root.join("target").join("book"));
    let Built { first_page, kept } = {
        let _step = progress::step(format!("building the book in {}", out.display()));
        signals::clear_up_first()?;
        building::build(&root, &out, Geneva)?
    };
    let folder = first_page.parent().unwrap_or(&out);
    streams.print(&format!("The book is in {}\n", folder.display()))?;
    for kept in kept {
        streams.print(&format!(
            "Files that were added while the old book was being replaced are in {}\n",
            kept.display()
        ))?;
    }
    if wanted.open {
        open::that_detached(&first_page)
            .with_context(|| format!("no program was found to open {}; open it in a browser", first_page.display()))?;
    } else {
        streams.print(&format!("Open {} in a browser.\n", first_page.display()))?;
    }
    Ok(())
}

fn test(streams: &mut dyn Streams) -> anyhow::Result<()> {
    {
        let _step = progress::step("testing the chapters");
        building::test(&workspace::root()?, Geneva)?;
    }
    streams.print("Every Rust block of the book compiles and runs.\n")?;
    Ok(())
}
