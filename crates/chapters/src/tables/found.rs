//! What proofreading found: the texts of the first contact, and the misprints that still stand in a textbook.

use crate::computed;
use crate::proofreading_record::{Answer, Contact, Judgement, ToolRun, contacts, flags, runs, unit_flags};
use geneva_press::chain::{chain, words};
use geneva_press::html::{Cells, Table, escape, table};

/// The texts that nobody had looked at, with what became of their flags: the later rounds by text, the first two in one row each.
pub(super) fn texts() -> anyhow::Result<Table> {
    let contacts = contacts()?;
    let runs = runs()?;
    let row = |name: String, round: &str, format: &str, of: &[&ToolRun]| {
        let such = |flag: &&Contact| flag.round == round && of.iter().any(|run| run.text == flag.text);
        let count = |judgement| contacts.iter().filter(such).filter(|flag| flag.judgement == judgement).count();
        let sum = |what: fn(&ToolRun) -> u32| of.iter().map(|run| what(run)).sum::<u32>();
        vec![
            escape(&name),
            escape(format),
            format!("{} of {}", sum(|run| run.checked), sum(|run| run.checkable)),
            sum(|run| run.flags).to_string(),
            count(Judgement::Real).to_string(),
            (count(Judgement::Rounding) + count(Judgement::Convention)).to_string(),
            count(Judgement::Ours).to_string(),
        ]
    };
    let of_round = |name: &str| runs.iter().filter(|run| run.run == name).collect::<Vec<&ToolRun>>();
    let mut rows = Vec::new();
    for (name, words) in [("first", "First round"), ("second", "Second round")] {
        let of = of_round(name);
        rows.push(row(format!("{words}, {} texts", of.len()), name, "several", &of));
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
    for (name, words) in later {
        let (with, without): (Vec<&ToolRun>, Vec<&ToolRun>) = of_round(name).into_iter().partition(|run| run.flags > 0);
        rows.extend(with.iter().map(|run| row(run.text.clone(), name, &run.format, &[run])));
        if !without.is_empty() {
            rows.push(row(format!("{} more texts of the {words} round", without.len()), name, "several", &without));
        }
    }
    table(
        "All flags on a number in texts that we had not looked at before. From the third round on, the texts are in \
         the order in which we ran them",
        Cells::NamedNumbers,
        &["Text", "Format", "Chains checked", "Flags", "Real errors", "Rounding, convention", "Misread"],
        rows.into_iter().map(Ok).collect::<Vec<_>>(),
    )
}

/// The rounds of first contact.
pub(super) fn rounds() -> anyhow::Result<Table> {
    table(
        "Rounds with texts that we had not looked at before: flags on a number, how many of them mark real errors, with the 95 % \
         interval of their share, how many are misreadings, and the real errors among the flags that the repaired program raises in the whole texts",
        Cells::NamedNumbers,
        &["Round", "Texts", "Flags", "Real errors", "Share", "Misread", "After repairs"],
        computed::found::rounds()?.into_iter().map(Ok).collect::<Vec<_>>(),
    )
}

/// The misprints on a number that still stand in the newest state.
pub(super) fn misprints() -> anyhow::Result<Table> {
    let rows = flags()?
        .into_iter()
        .filter(|flag| flag.judgement == Judgement::Real && flag.printed_new == Answer::Yes)
        .map(|flag| {
            let or_none = |text: &str| if text.is_empty() { Ok("–".to_owned()) } else { words(text) };
            Ok(vec![
                place(&flag.module, &flag.element),
                chain(&flag.chain)?,
                or_none(&flag.recomputed)?,
                or_none(&flag.hint)?,
                words(&flag.why)?,
            ])
        });
    table(
        "Numbers in University Physics, newest state, that don't follow from what is printed beside them",
        Cells::Wide,
        &["Module, element", "Printed", "Recomputed", "Hint of the program", "Our reading"],
        rows,
    )
}

/// The misprints on a number in other books by the same publisher.
pub(super) fn others() -> anyhow::Result<Table> {
    let rows = contacts()?
        .into_iter()
        .filter(|flag| flag.round == "publisher" && flag.judgement == Judgement::Real)
        .map(|flag| {
            let module = flag.file.split('/').rev().nth(1).unwrap_or(&flag.file);
            let line = format!("<code>{}</code> <small>line {}</small>", escape(module), flag.line);
            Ok(vec![format!("{}, {line}", escape(&flag.text)), chain(&flag.chain)?, words(&flag.why)?])
        });
    table(
        "Numbers in five other books by OpenStax that don't follow from what is printed beside them",
        Cells::Words,
        &["Book, module", "Printed", "Our reading"],
        rows,
    )
}

/// The misprints on a unit that still stand in the newest state.
pub(super) fn units() -> anyhow::Result<Table> {
    let rows = unit_flags()?
        .into_iter()
        .filter(|flag| flag.judgement == Judgement::Real)
        .map(|flag| Ok(vec![place(&flag.module, &flag.element), chain(&flag.chain)?, words(&flag.why)?]));
    table(
        "Places in University Physics, newest state, where the number is right and the unit or an exponent isn't",
        Cells::Words,
        &["Module, element", "Printed", "Our reading"],
        rows,
    )
}

fn place(module: &str, element: &str) -> String {
    format!("<code>{}</code> <small>{}</small>", escape(module), escape(element))
}
