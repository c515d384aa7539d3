//! What proofreading found: the rounds of first contact, and the misprints that still stand in a textbook.

use crate::computed;
use crate::proofreading_record::{Answer, Contact, Flag, Judgement, contacts, flags, unit_flags};
use geneva_press::chain::{chain, words};
use geneva_press::html::escape;
use geneva_press::table::{Cells, Table};

/// The rounds of first contact.
pub(super) fn rounds() -> anyhow::Result<Table> {
    Table::with_rows(Cells::NamedNumbers, computed::found::rounds()?)
        .column("Round", |round| round.name)
        .column("Texts", |round| round.texts)
        .column("Flags", |round| round.flags)
        .column("Real errors", |round| round.real)
        .column("Share", |round| round.share.clone())
        .column("Misread", |round| round.misread)
        .column("After repairs", |round| round.after_repairs.clone())
        .finish()
}

/// The misprints on a number that still stand in the newest state.
pub(super) fn misprints() -> anyhow::Result<Table> {
    let or_none = |text: &str| if text.is_empty() { Ok("–".to_owned()) } else { words(text) };
    let still = |flag: &Flag| flag.judgement == Judgement::Real && flag.printed_new == Answer::Yes;
    Table::with_rows(Cells::Wide, flags()?.into_iter().filter(still))
        .column("Module, element", |flag| place(&flag.module, &flag.element))
        .column("Printed", |flag| chain(&flag.chain))
        .column("Recomputed", |flag| or_none(&flag.recomputed))
        .column("Hint of the program", |flag| or_none(&flag.hint))
        .column("Our reading", |flag| words(&flag.why))
        .finish()
}

/// The misprints on a number in other books by the same publisher.
pub(super) fn others() -> anyhow::Result<Table> {
    let real = |flag: &Contact| flag.round == "publisher" && flag.judgement == Judgement::Real;
    let place = |flag: &Contact| {
        let module = flag.file.split('/').rev().nth(1).unwrap_or(&flag.file);
        format!("{}, <code>{}</code> <small>line {}</small>", escape(&flag.text), escape(module), flag.line)
    };
    Table::with_rows(Cells::Words, contacts()?.into_iter().filter(real))
        .column("Book, module", place)
        .column("Printed", |flag| chain(&flag.chain))
        .column("Our reading", |flag| words(&flag.why))
        .finish()
}

/// The misprints on a unit that still stand in the newest state.
pub(super) fn units() -> anyhow::Result<Table> {
    Table::with_rows(Cells::Words, unit_flags()?.into_iter().filter(|flag| flag.judgement == Judgement::Real))
        .column("Module, element", |flag| place(&flag.module, &flag.element))
        .column("Printed", |flag| chain(&flag.chain))
        .column("Our reading", |flag| words(&flag.why))
        .finish()
}

fn place(module: &str, element: &str) -> String {
    format!("<code>{}</code> <small>{}</small>", escape(module), escape(element))
}
