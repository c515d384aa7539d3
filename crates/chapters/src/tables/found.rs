//! What proofreading found: the texts of the first contact, and the misprints that still stand in a textbook.

use crate::computed;
use crate::proofreading_record::{Answer, Contact, Flag, Judgement, ToolRun, contacts, flags, runs, unit_flags};
use geneva_press::chain::{chain, words};
use geneva_press::html::escape;
use geneva_press::table::{Cells, Table};

/// A row of the table of texts: a text, or several in one, of a round.
struct RoundTexts<'a> {
    name: String,
    /// The round, as the records call it.
    round: &'a str,
    format: &'a str,
    runs: Vec<&'a ToolRun>,
}

/// The texts that nobody had looked at, with what became of their flags: the later rounds by text, the first two in one row each.
pub(super) fn texts() -> anyhow::Result<Table> {
    let contacts = contacts()?;
    let runs = runs()?;
    let of_round = |name: &str| runs.iter().filter(|run| run.run == name).collect::<Vec<&ToolRun>>();
    let several = |name, round, runs| RoundTexts { name, round, format: "several", runs };
    let mut rows = Vec::new();
    for (round, words) in [("first", "First round"), ("second", "Second round")] {
        let of = of_round(round);
        rows.push(several(format!("{words}, {} texts", of.len()), round, of));
    }
    // The records call the last text of the fourth round "fifth", the fifth round "sixth", and so on.
    let later = [
        ("third", "third"),
        ("fourth", "fourth"),
        ("fifth", ""),
        ("sixth", "fifth"),
        ("seventh", "sixth"),
        ("eighth", "seventh"),
        ("ninth", "eighth"),
        ("tenth", "ninth"),
        ("eleventh", "tenth"),
    ];
    for (round, words) in later {
        let (with, without): (Vec<&ToolRun>, Vec<&ToolRun>) =
            of_round(round).into_iter().partition(|run| run.flags > 0);
        rows.extend(with.into_iter().map(|run| text_row(round, run)));
        if !without.is_empty() {
            rows.push(several(format!("{} more texts of the {words} round", without.len()), round, without));
        }
    }
    let judged = |row: &RoundTexts<'_>, judgements: &[Judgement]| {
        let such = |flag: &&Contact| flag.round == row.round && row.runs.iter().any(|run| run.text == flag.text);
        contacts.iter().filter(such).filter(|flag| judgements.contains(&flag.judgement)).count()
    };
    let sum = |row: &RoundTexts<'_>, what: fn(&ToolRun) -> u32| row.runs.iter().map(|run| what(run)).sum::<u32>();
    Table::with_rows(Cells::NamedNumbers, rows)
        .column("Text", |row| escape(&row.name))
        .column("Format", |row| escape(row.format))
        .column("Chains checked", |row| format!("{} of {}", sum(row, |run| run.checked), sum(row, |run| run.checkable)))
        .column("Flags", |row| sum(row, |run| run.flags))
        .column("Real errors", |row| judged(row, &[Judgement::Real]))
        .column("Rounding, convention", |row| judged(row, &[Judgement::Rounding, Judgement::Convention]))
        .column("Misread", |row| judged(row, &[Judgement::Ours]))
        .finish()
}

/// The row of one text.
fn text_row<'a>(round: &'a str, run: &'a ToolRun) -> RoundTexts<'a> {
    RoundTexts { name: run.text.clone(), round, format: &run.format, runs: vec![run] }
}

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
