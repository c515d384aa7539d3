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
mod fact;
mod json;
mod question;
mod words;

pub use answer::{PageAnswer, ShownFinding, ShownPlace};
pub use fact::Fact;
pub use question::{MOST_BYTES, NamePolicyChoice, PageQuestion, too_long_message};
pub use words::name_of_format;

#[cfg(target_family = "wasm")]
use answer as module_answer;

/// The answer to a question as a JSON object: see [`PageAnswer::to_json`] and, for the question, [`PageQuestion::parse`].
///
/// A question that cannot be answered gets `error`: what is wrong, and what to give.
///
/// ```
/// let answer = geneva_proofread_page::answer("format=markdown\nIt is $2 + 2 = 5$.");
/// assert!(answer.contains("\"summary\":[\"1 finding: 1 on a number.\""));
/// assert!(geneva_proofread_page::answer("units=perhaps").starts_with("{\"error\":"));
/// ```
pub fn answer(question: &str) -> String {
    let answered = PageQuestion::parse(question).and_then(|question| PageAnswer::for_question(&question));
    match answered {
        Ok(answer) => answer.to_json(),
        Err(message) => json::object([("error", json::text(&message))]),
    }
}
