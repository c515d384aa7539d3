//! Lists of the decks, the functions and the control cards.

use crate::output::{TextLayout, heading};
use geneva_mimic::language::{CARDS, DECKS, FUNCTIONS};

/// The decks of this project, each with its first lines of comment.
pub(super) fn decks(layout: TextLayout) -> String {
    let said = |text: &str| {
        let lines = text.lines().take_while(|line| line.len() > 1 && line.starts_with('*'));
        lines.map(|line| line.trim_start_matches('*').trim()).collect::<Vec<_>>().join(" ")
    };
    DECKS.iter().map(|(name, text)| layout.wrapped(&format!("{name:<12}"), &said(text))).collect()
}

/// The functions and the control cards, each with the evidence for it.
pub(super) fn functions(layout: TextLayout) -> String {
    let bold = heading();
    let mut page = format!("{bold}Functions{bold:#}\n");
    for function in &FUNCTIONS {
        let called = format!("{}({})", function.name, function.arguments);
        page += &layout
            .wrapped(&format!("  {called:<20}"), &format!("{} [{}]", function.meaning, function.evidence.words()));
    }
    page += &format!("\n{bold}Control cards, and names that need no card{bold:#}\n");
    for card in &CARDS {
        let written = format!("{}{}", card.name, card.arguments);
        let written =
            if card.arguments.starts_with('(') { written } else { format!("{} {}", card.name, card.arguments) };
        page += &layout.wrapped(&format!("  {written:<20}"), &format!("{} [{}]", card.meaning, card.evidence.words()));
    }
    page
}
