//! The cards that are no statements, and the names that mean something to the program: one table.

use super::function::WordEvidence;

/// A control card, or a name with a meaning of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Card {
    /// Its name.
    pub name: &'static str,
    /// What is written behind it.
    pub arguments: &'static str,
    /// What it does.
    pub meaning: &'static str,
    /// Where it is known from.
    pub evidence: WordEvidence,
}

const fn card(name: &'static str, arguments: &'static str, evidence: WordEvidence, meaning: &'static str) -> Card {
    Card { name, arguments, meaning, evidence }
}

use WordEvidence::{Assumed, Both, Encyclopedia, Thesis};

/// All control cards, and the names that are known without a card.
pub static CARDS: [Card; 17] = [
    card("C * /", "text", Both, "in column 1: a comment. C needs a blank after it where columns do not count"),
    card(
        "CON",
        "(names)",
        Encyclopedia,
        "constants: read once, from the first data cards. Each CON card begins a new data card",
    ),
    card(
        "PAR",
        "(names)",
        Thesis,
        "parameters: read from the data cards that follow; the program runs once for each set. A set may take several data \
         cards",
    ),
    card("DT", "number", Thesis, "time between two printed points; without such a card, 0.1, which we assume"),
    card("DTMIN", "number", Assumed, "smallest step; without such a card, DT over 2 to the power 30"),
    card("DTMAX", "number", Assumed, "largest step; without such a card, DT"),
    card(
        "FIN",
        "(A, B)",
        Both,
        "ends the run at the first kept step at which A is not below B; with several such cards, whichever is first",
    ),
    card(
        "HDR",
        "(words)",
        Both,
        "heads the columns of an OUT card, one word for each column; the first HDR card belongs to the first OUT card, \
         and so on",
    ),
    card("OUT", "(names)", Both, "prints the values of the names at each printed point"),
    card(
        "PLO",
        "(X, Y, ...)",
        Both,
        "plots Y and the names after it against X, with one line of print for each step of X",
    ),
    card(
        "SCA",
        "(A, B, ...)",
        Thesis,
        "after PLO: X changes by A from line to line, Y by B from column to column, and so on; without this card, \
         scales are chosen to fit",
    ),
    card("ZER", "(A, B, ...)", Thesis, "after PLO: the value of X on the first line, and of Y in the first column"),
    card("END", "", Both, "ends the deck; data cards may follow"),
    card("T", "", Both, "time, from 0"),
    card("TRUE", "", Thesis, "the truth value true; it prints as 1"),
    card("FALSE", "", Thesis, "the truth value false; it prints as 0"),
    card("EOR, EOF", "", Encyclopedia, "in angle brackets: between deck and data, and after them; not needed"),
];

/// The control cards that have parentheses, and END.
pub(super) const WORDS: [&str; 9] = ["CON", "PAR", "FIN", "HDR", "OUT", "PLO", "SCA", "ZER", "END"];

/// Names that are known without a card, and that no card may define.
pub(super) const GIVEN: [&str; 3] = ["T", "TRUE", "FALSE"];

/// Names whose cards set the steps, and which may be used in expressions.
pub(super) const STEPS: [&str; 3] = ["DT", "DTMIN", "DTMAX"];

/// What a reserved name is, if it is one.
pub(super) fn reserved_meaning(name: &str) -> Option<&'static str> {
    if name == "T" {
        Some("time")
    } else if GIVEN.contains(&name) {
        Some("a truth")
    } else if WORDS.contains(&name) {
        Some("a control card")
    } else if super::function::function_named(name).is_some() {
        Some("a function")
    } else {
        None
    }
}
