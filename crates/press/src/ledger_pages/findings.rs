//! What was found of an equation, a figure or a statement, in sentences.

use crate::html::prose;
use geneva_evidence::{Judged, sentences};

/// How a form was found to hold or to fail, with the reading; for a missing value, what is missing.
pub fn how(judged: &Judged) -> String {
    let all: Vec<_> = sentences(judged).iter().map(|sentence| with_minus_signs(sentence)).collect();
    all.join("<br> ")
}

/// What was found, as a page has it: with a minus sign before negative numbers.
pub fn with_minus_signs(found: &str) -> String {
    prose(&found.replace(" -", " −").replace("(-", "(−"))
}
