//! The checks of a ledger, for the pages of its book: made by the builder, compiled for WebAssembly.

mod exports;

/// The reply to a question of a page.
fn module_answer(question: &str) -> String {
    ledger::LEDGER.reply(question)
}
