//! What the page *Proofread your own text* asks.
//!
//! A page hands over a text with a line of options before it, and gets the findings as JSON. Nothing is computed here: this
//! crate reads the options, calls `geneva-proofread`, and puts what it found into words and places that a page can show.
//!
//! Compiled for WebAssembly it is what the page loads, through the same exports as the figures that a reader moves; compiled
//! for the machine at hand it is what the book's first example and the tests call. Both give the same characters.

mod answer;
#[cfg(target_family = "wasm")]
#[path = "../../live/src/exports.rs"]
mod exports;
mod question;
mod words;

pub use answer::{Answer, Fact, Shown};
pub use question::{Bindings, MOST_BYTES, Question, too_long};
pub use words::name_of_format;

/// The answer to a question as a JSON object: see [`Answer::to_json`] and, for the question, [`Question::parse`].
///
/// A question that cannot be answered gets `error`: what is wrong, and what to give.
pub fn answer(question: &str) -> String {
    let answered = Question::parse(question).and_then(|question| Answer::to(&question));
    match answered {
        Ok(answer) => answer.to_json(),
        Err(message) => serde_json::json!({ "error": message }).to_string(),
    }
}
