//! Questions that use an equation and do not ask whether it holds.

use crate::judge::denial;
use crate::judge::surroundings::text_around;
use crate::token::Span;

/// Words of a question for a number.
const HOW_MANY: [&str; 4] = ["how many", "hoeveel", "wie viele", "combien"];

/// Whether the text asks if the formula holds, or says that it does not.
pub(crate) fn is_meant_false(text: &str, span: Span) -> bool {
    denial::is_meant_false(text, span) && !asks_how_many(text, span)
}

/// Whether the formula stands in a question for a number.
fn asks_how_many(text: &str, span: Span) -> bool {
    let (before, after) = text_around(text, span);
    let before = before.to_ascii_lowercase();
    let sentence = before.rsplit(['.', '?', '!']).next().unwrap_or_default();
    let ends = after.find(['.', '?', '!']).is_some_and(|at| after[at..].starts_with('?'));
    ends && HOW_MANY.iter().any(|question| sentence.contains(question))
}
