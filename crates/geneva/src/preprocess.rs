//! mdBook's protocol for preprocessors: a question, or a book in and a book out. Nothing else is printed.

use crate::arguments::{PreprocessArguments, Question};
use crate::output::{Outcome, Streams};
use crate::printable::chain;
use anyhow::{anyhow, ensure};
use geneva_press::Geneva;
use mdbook_preprocessor::{Preprocessor, parse_input};
use std::io::{IsTerminal, stdin};

/// Answers the question, or processes the book on standard input.
pub fn run(call: PreprocessArguments, streams: &mut dyn Streams) -> anyhow::Result<Outcome> {
    if let Some(Question::Supports { renderer }) = call.question {
        return Ok(Outcome::as_recorded_if(Geneva.supports_renderer(&renderer)?));
    }
    ensure!(
        !stdin().is_terminal(),
        "mdBook runs this command and passes it a book; to build the book, run `geneva book`"
    );
    let (context, book) = parse_input(stdin().lock()).map_err(|error| {
        anyhow!(
            "standard input is not a book of mdBook 0.5 ({}). mdBook runs this command; to build the book, run `geneva book`",
            chain(&error)
        )
    })?;
    streams.print(&serde_json::to_string(&Geneva.run(&context, book)?)?)?;
    Ok(Outcome::AsRecorded)
}
