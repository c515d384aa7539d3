//! Of what proofreading found: how many chains were checked, how many flags a person confirmed, and with what precision.

use super::Number;
use crate::found::{Answer, Contact, Flag, Judgement, contacts, errata, flags, run, runs, unit_flags, wilson};

/// The numbers of the page.
pub const NUMBERS: &[(&str, Number)] = &[
    ("found.formulas", || Ok(thousands(run("old")?.formulas))),
    ("found.checkable", || Ok(thousands(run("old")?.checkable))),
    ("found.checked", || Ok(thousands(run("old")?.checked))),
    ("found.old.flags", || Ok(old()?.len().to_string())),
    ("found.old.real", || Ok(real(&old()?).to_string())),
    ("found.old.rounding", || Ok(of(&old()?, Judgement::Rounding).to_string())),
    ("found.old.convention", || Ok(of(&old()?, Judgement::Convention).to_string())),
    ("found.old.ours", || Ok(of(&old()?, Judgement::Ours).to_string())),
    ("found.old.precision", || Ok(precision(real(&old()?), old()?.len()))),
    ("found.new.flags", || Ok(new()?.len().to_string())),
    ("found.new.real", || Ok(real(&new()?).to_string())),
    ("found.new.places", || places(&new()?)),
    ("found.new.units", || unit_misprints()),
    ("found.new.hints", || hints(&new()?)),
    ("found.hints", || hints_judged(|_| true)),
    ("found.hints-right", || hints_judged(|right| right == Answer::Yes)),
    ("found.errata", || Ok(errata()?.len().to_string())),
    ("found.errata-found", || Ok(errata()?.iter().filter(|erratum| erratum.found != "no").count().to_string())),
    ("found.errata-numbers", || errata_of("number")),
    ("found.errata-units", || errata_of("unit")),
    ("found.results", || planted(|run| (run.results, run.results_noticed))),
    ("found.operands", || planted(|run| (run.operands, run.operands_noticed))),
    ("found.first.texts", || texts("first")),
    ("found.first.flags", || Ok(round("first")?.len().to_string())),
    ("found.first.real", || Ok(right(&round("first")?).to_string())),
    ("found.first.precision", || Ok(precision(right(&round("first")?), round("first")?.len()))),
    ("found.first.commas", || commas()),
    ("found.after.flags", || Ok(after()?.len().to_string())),
    ("found.after.real", || Ok(right(&after()?).to_string())),
    ("found.after.new", || {
        Ok(right(&after()?.into_iter().filter(|flag| flag.round == "again").collect::<Vec<_>>()).to_string())
    }),
    ("found.after.precision", || Ok(precision(right(&after()?), after()?.len()))),
];

fn old() -> anyhow::Result<Vec<Flag>> {
    Ok(flags()?.into_iter().filter(|flag| flag.flagged_old == Answer::Yes).collect())
}

fn new() -> anyhow::Result<Vec<Flag>> {
    Ok(flags()?.into_iter().filter(|flag| flag.flagged_new == Answer::Yes).collect())
}

fn of(flags: &[Flag], judgement: Judgement) -> usize {
    flags.iter().filter(|flag| flag.judgement == judgement).count()
}

fn real(flags: &[Flag]) -> usize {
    of(flags, Judgement::Real)
}

/// In how many elements there is a misprint on the number.
fn places(flags: &[Flag]) -> anyhow::Result<String> {
    let places: std::collections::BTreeSet<_> = flags
        .iter()
        .filter(|flag| flag.judgement == Judgement::Real)
        .map(|flag| (&flag.module, &flag.element))
        .collect();
    Ok(places.len().to_string())
}

fn unit_misprints() -> anyhow::Result<String> {
    Ok(unit_flags()?.iter().filter(|flag| flag.judgement == Judgement::Real).count().to_string())
}

/// How many misprints have a hint.
fn hints(flags: &[Flag]) -> anyhow::Result<String> {
    let with = flags.iter().filter(|flag| flag.judgement == Judgement::Real && !flag.hint.is_empty());
    Ok(with.count().to_string())
}

/// How many hints of misprints in all texts are such.
fn hints_judged(such: fn(Answer) -> bool) -> anyhow::Result<String> {
    let in_book = flags()?.into_iter().filter_map(|flag| flag.hint_right);
    let elsewhere = contacts()?.into_iter().filter_map(|flag| flag.hint_right);
    Ok(in_book.chain(elsewhere).filter(|right| such(*right)).count().to_string())
}

/// How many of the errata of a kind the program finds.
fn errata_of(kind: &str) -> anyhow::Result<String> {
    let errata = errata()?;
    let of = || errata.iter().filter(|erratum| erratum.kind == kind);
    Ok(format!("{} of {}", of().filter(|erratum| erratum.found != "no").count(), of().count()))
}

/// The flags of a round.
fn round(name: &str) -> anyhow::Result<Vec<Contact>> {
    Ok(contacts()?.into_iter().filter(|flag| flag.round == name).collect())
}

/// The flags that remain in the texts of the first round after the repairs, and those that came with them.
fn after() -> anyhow::Result<Vec<Contact>> {
    let such = |flag: &Contact| flag.after == Answer::Yes && flag.round != "second";
    Ok(contacts()?.into_iter().filter(such).collect())
}

fn right(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.judgement == Judgement::Real).count()
}

fn texts(round: &str) -> anyhow::Result<String> {
    Ok(runs()?.iter().filter(|run| run.run == round).count().to_string())
}

/// How many flags of the first round come from the decimal comma.
fn commas() -> anyhow::Result<String> {
    Ok(round("first")?.iter().filter(|flag| flag.why.contains("decimal comma")).count().to_string())
}

/// A share in per cent with its interval.
fn precision(part: usize, all: usize) -> String {
    let (low, high) = wilson(part, all);
    let share = 100.0 * part as f64 / all.max(1) as f64;
    format!("{share:.0}&nbsp;% (95&nbsp;% interval {:.0} to {:.0}&nbsp;%)", 100.0 * low, 100.0 * high)
}

/// The share of planted errors that were noticed, in per cent.
fn planted(of: fn(&crate::found::Run) -> (Option<u32>, Option<u32>)) -> anyhow::Result<String> {
    let run = run("old")?;
    let (Some(tried), Some(noticed)) = of(&run) else { anyhow::bail!("no errors were planted") };
    let share = 100.0 * f64::from(noticed) / f64::from(tried.max(1));
    Ok(format!("{} of {} ({share:.0}&nbsp;%)", thousands(noticed), thousands(tried)))
}

/// An integer with a comma between thousands.
fn thousands(number: u32) -> String {
    if number < 1000 { number.to_string() } else { format!("{},{:03}", number / 1000, number % 1000) }
}
