//! mdBook's protocol for preprocessors: a question, or a book in and a book out. Nothing else is printed.

use crate::book::TESTED;
use crate::output::{Outcome, OutputStreams};
use crate::printable::chain;
use anyhow::{anyhow, ensure};
use clap::{Args, Subcommand};
use geneva_chapters::BOOK;
use geneva_press::Press;
use mdbook_preprocessor::book::Book;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext, parse_input};
use std::io::{IsTerminal, stdin};

/// The renderer of `mdbook test`.
const TESTS: &str = "test";

/// Options of `geneva preprocess`, as mdBook gives them.
#[derive(Args, Debug)]
pub(crate) struct PreprocessArguments {
    /// A question instead of a book.
    #[command(subcommand)]
    pub question: Option<PreprocessorQuestion>,
}

/// Questions that mdBook asks before it passes a book.
#[derive(Debug, Subcommand)]
pub(crate) enum PreprocessorQuestion {
    /// Exit with 0: every renderer gets an answer
    Supports {
        /// mdBook's name for the renderer
        #[arg(allow_hyphen_values = true)]
        renderer: String,
    },
}

/// Answers the question, or processes the book on standard input.
pub(crate) fn run(call: PreprocessArguments, streams: &mut dyn OutputStreams) -> anyhow::Result<Outcome> {
    if let Some(PreprocessorQuestion::Supports { renderer }) = call.question {
        return Ok(Outcome::as_recorded_if(Press::new(&BOOK).supports_renderer(&renderer)?));
    }
    let (context, book) = read_book("to build the book, run `geneva book`")?;
    let mut book = Press::new(&BOOK).run(&context, book)?;
    if context.renderer == TESTS {
        // mdBook gives rustdoc no crates unless it is told where they are. So the programs are tested here, with those of
        // the project, by mdBook's library, and mdBook gets chapters in which nothing is left to be tested.
        geneva_press::test(&BOOK, context.root.parent().unwrap_or(&context.root))?;
        book.for_each_chapter_mut(|chapter| chapter.content.clear());
        streams.write_stderr(TESTED);
    }
    streams.print(&serde_json::to_string(&book)?)?;
    Ok(Outcome::AsRecorded)
}

/// The book that mdBook passes on standard input.
///
/// # Errors
///
/// There is none. The message says what the user may run `instead`.
pub(crate) fn read_book(instead: &str) -> anyhow::Result<(PreprocessorContext, Book)> {
    ensure!(!stdin().is_terminal(), "mdBook runs this command and passes it a book; {instead}");
    parse_input(stdin().lock()).map_err(|error| {
        anyhow!("standard input is not a book of mdBook 0.5 ({}). mdBook runs this command; {instead}", chain(&error))
    })
}
