//! The language of 1973: what each word does, and where that is known from.

use geneva_mimic::language::{CARDS, FUNCTIONS, WordEvidence};
use geneva_press::html::{Cells, Table, escape, table};

/// The functions.
pub(super) fn functions() -> anyhow::Result<Table> {
    let rows = FUNCTIONS.iter().map(|function| {
        Ok(row(&format!("{}({})", function.name, function.arguments), function.meaning, function.evidence))
    });
    table("The functions of MIMIC as we built them", Cells::Words, &["Function", "Value", "Known from"], rows)
}

/// The control cards, and the names that are known without a card.
pub(super) fn cards() -> anyhow::Result<Table> {
    let rows = CARDS.iter().map(|card| {
        let gap = if card.arguments.is_empty() || card.arguments.starts_with('(') { "" } else { " " };
        Ok(row(&format!("{}{gap}{}", card.name, card.arguments), card.meaning, card.evidence))
    });
    let caption = "Control cards, and names that need no card";
    table(caption, Cells::Words, &["Card", "What it does", "Known from"], rows)
}

fn row(written: &str, meaning: &str, evidence: WordEvidence) -> Vec<String> {
    vec![format!("<code>{}</code>", escape(written)), escape(meaning), escape(evidence.words())]
}
