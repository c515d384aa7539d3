//! What proofreading found: the texts of the first contact, and the misprints that still stand in a textbook.

use crate::found::{Answer, Contact, Judgement, contacts, flags, runs, unit_flags};
use crate::html::{Cells, Table, escape, table};

/// The texts that nobody had looked at, with what became of their flags.
pub fn texts() -> anyhow::Result<Table> {
    let contacts = contacts()?;
    let row = |round: &'static str| {
        let contacts = &contacts;
        move |run: crate::found::Run| {
            let count = |such: &dyn Fn(&&Contact) -> bool| {
                contacts.iter().filter(|flag| flag.round == round && flag.text == run.text).filter(such).count()
            };
            let of = |judgement| count(&move |flag| flag.judgement == judgement);
            Ok(vec![
                escape(&run.text),
                format!("{round}, {}", run.format),
                format!("{} of {}", run.checked, run.checkable),
                run.flags.to_string(),
                of(Judgement::Real).to_string(),
                (of(Judgement::Rounding) + of(Judgement::Convention)).to_string(),
                of(Judgement::Ours).to_string(),
            ])
        }
    };
    let mut rows = Vec::new();
    for round in ["first", "second"] {
        rows.extend(runs()?.into_iter().filter(|run| run.run == round).map(row(round)));
    }
    table(
        "Texts that we had not looked at before, in the order in which they were run, and the flags on a number",
        Cells::NamedNumbers,
        &["Text", "Round, format", "Chains checked", "Flags", "Really wrong", "Rounding, convention", "Misread"],
        rows,
    )
}

/// The misprints on a number that still stand in the newest state.
pub fn misprints() -> anyhow::Result<Table> {
    let rows = flags()?
        .into_iter()
        .filter(|flag| flag.judgement == Judgement::Real && flag.printed_new == Answer::Yes)
        .map(|flag| {
            let or_none = |text: &str| if text.is_empty() { "none".to_owned() } else { escape(text) };
            Ok(vec![
                place(&flag.module, &flag.element),
                chain(&flag.chain),
                or_none(&flag.recomputed),
                or_none(flag.hint.replace('`', "").as_str()),
                escape(&flag.why),
            ])
        });
    table(
        "Numbers in University Physics, newest state, that don't follow from what is printed beside them",
        Cells::Words,
        &["Module, element", "Printed", "Recomputed", "Hint of the program", "Our reading"],
        rows,
    )
}

/// The misprints on a unit that still stand in the newest state.
pub fn units() -> anyhow::Result<Table> {
    let rows = unit_flags()?
        .into_iter()
        .filter(|flag| flag.judgement == Judgement::Real)
        .map(|flag| Ok(vec![place(&flag.module, &flag.element), chain(&flag.chain), escape(&flag.why)]));
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

/// A chain that a phone may break behind a sign, and nowhere inside a number.
fn chain(text: &str) -> String {
    escape(text)
}
