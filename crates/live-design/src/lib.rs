//! The designer of wheels as a module of its own.
//!
//! The page of the designer needs none of the other figures that a reader moves, and their pages don't need the designer. So the
//! designer is compiled for WebAssembly apart from them. There is nothing here but what joins `geneva-live` and the exports.

#[cfg(target_family = "wasm")]
#[path = "../../live/src/exports.rs"]
mod exports;

#[cfg(target_family = "wasm")]
use answer as module_answer;

/// The answer to a question to the designer, `design?arguments`, as [`geneva_live::answer()`] gives it. Any other figure is refused.
///
/// ```
/// let answer = geneva_live_design::answer("design?stations=8");
/// assert_eq!(answer, geneva_live::answer("design?stations=8"));
/// assert!(geneva_live_design::answer("pin?").starts_with("{\"error\":"));
/// ```
pub fn answer(question: &str) -> String {
    geneva_live::answer_among(&[&geneva_live::DESIGN], question)
}
