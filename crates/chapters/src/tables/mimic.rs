//! The language of 1973: what each word does, and where that is known from.

use geneva_mimic::language::{CARDS, FUNCTIONS};
use geneva_press::html::escape;
use geneva_press::table::{Cells, Table};

/// The functions.
pub(super) fn functions() -> anyhow::Result<Table> {
    Table::with_rows(Cells::Words, FUNCTIONS)
        .column("Function", |function| code(&format!("{}({})", function.name, function.arguments)))
        .column("Value", |function| escape(function.meaning))
        .column("Known from", |function| escape(function.evidence.words()))
        .finish()
}

/// The control cards, and the names that are known without a card.
pub(super) fn cards() -> anyhow::Result<Table> {
    let gap = |arguments: &str| if arguments.is_empty() || arguments.starts_with('(') { "" } else { " " };
    Table::with_rows(Cells::Words, CARDS)
        .column("Card", |card| code(&format!("{}{}{}", card.name, gap(card.arguments), card.arguments)))
        .column("What it does", |card| escape(card.meaning))
        .column("Known from", |card| escape(card.evidence.words()))
        .finish()
}

fn code(words: &str) -> String {
    format!("<code>{}</code>", escape(words))
}
