//! Of what proofreading found: how many chains were checked, how many flags a person confirmed, and with what precision.

use super::Number;
use crate::found::{
    Answer, Contact, Flag, Judgement, Run, contacts, errata, flags, run, runs, sums, unit_flags, wilson,
};

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
    ("found.new.places", || Ok(places(&new()?)?.to_string())),
    ("found.new.checked", || Ok(thousands(run("new")?.checked))),
    ("found.new.rate", || rate()),
    ("found.new.units", || unit_misprints()),
    ("found.new.hints", || hints(&new()?)),
    ("found.hints", || hints_judged(|_| true)),
    ("found.hints-right", || hints_judged(|right| right == Answer::Yes)),
    ("found.errata", || Ok(errata()?.len().to_string())),
    ("found.errata-found", || Ok(errata_found()?.to_string())),
    ("found.recall", || Ok(precision(errata_found()?, errata()?.len()))),
    ("found.errata-numbers", || errata_of("number")),
    ("found.errata-units", || errata_of("unit")),
    ("found.results", || planted(|of| [of.results])),
    ("found.operands", || planted(|of| [of.operands])),
    ("found.planted", || planted(|of| [of.results, of.operands])),
    ("found.results-visible", || planted(|of| [of.results.visible()])),
    ("found.operands-visible", || planted(|of| [of.operands.visible()])),
    ("found.operands-invisible", invisible),
    ("found.first.commas", || commas()),
    ("found.second.agreed", || Ok(agreed(&round("second")?).to_string())),
    ("found.third.texts", || texts("third")),
    ("found.third.flags", || Ok(round("third")?.len().to_string())),
    ("found.third.early", || {
        let first: Vec<String> = of_run("third")?.into_iter().take(14).map(|run| run.text).collect();
        Ok(round("third")?.iter().filter(|flag| first.contains(&flag.text)).count().to_string())
    }),
    ("found.third.real", || Ok(right(&round("third")?).to_string())),
    ("found.third.precision", || share(&round("third")?)),
    ("found.third.faults", || Ok(faults("third")?.to_string())),
    ("found.third.with-fault", || with_fault("third")),
    ("found.stop.texts", || Ok(until_stop()?.0.to_string())),
    ("found.stop.english", || {
        let mut flags = until_stop()?.1;
        flags.retain(|flag| flag.text != "Solid state physics");
        Ok(format!("{} of {}, {}", right(&flags), flags.len(), share(&flags)?))
    }),
    ("found.fourth.texts", || Ok(listed("fourth", ENOUGH)?.0.to_string())),
    ("found.fourth.run", || texts("fourth")),
    ("found.fourth.all", || all_of("fourth")),
    ("found.fourth.commands", || Ok(because("fourth", "a command that isn't known")?.to_string())),
    ("found.fifth.flags", || Ok(first_of("fifth")?.len().to_string())),
    ("found.fifth.faults", || Ok(distinct(&first_of("fifth")?).to_string())),
    ("found.fifth.cut", || {
        Ok(first_of("fifth")?.iter().filter(|flag| flag.judgement == Judgement::Rounding).count().to_string())
    }),
    ("found.sixth.faults", || Ok(faults("sixth")?.to_string())),
    ("found.sixth.with-fault", || with_fault("sixth")),
    ("found.sixth.rest", || rest("sixth")),
    ("found.sixth.misread", || Ok(misread(&round("sixth")?).to_string())),
    ("found.after.new", || {
        let again: Vec<_> = contacts()?.into_iter().filter(|flag| flag.round == "again").collect();
        Ok(again
            .iter()
            .filter(|flag| flag.judgement == Judgement::Real && flag.after == Answer::Yes)
            .count()
            .to_string())
    }),
    ("found.aside.first", || kept("first")),
    ("found.aside.second", || kept("second")),
    ("found.aside.third", || kept("third")),
    ("found.aside.fourth", || kept("fourth")),
    ("found.aside.fifth", || kept("fifth")),
    ("found.aside.all-real", || Ok(asked()?.len().to_string())),
    ("found.aside.lost", || Ok(asked()?.iter().filter(|flag| flag.aside == Some(Answer::Yes)).count().to_string())),
    ("found.sums.signs", || Ok(thousands(sums()?.iter().map(|of| of.signs).sum()))),
    ("found.sums.of-numbers", || Ok(sums()?.iter().map(|of| of.of_numbers).sum::<u32>().to_string())),
    ("found.seventh.misread", || Ok(misread(&round("seventh")?).to_string())),
    ("found.seventh.understood", || Ok(because("seventh", "kiloohms")?.to_string())),
    ("found.seventh.rest", || rest("seventh")),
    ("found.eighth.flags", || Ok(round("eighth")?.len().to_string())),
    ("found.publisher.real", || confirmed(&round("publisher")?)),
    ("found.publisher.misread", || Ok(misread(&round("publisher")?).to_string())),
    ("found.publisher.faults", || Ok(faults("publisher")?.to_string())),
    ("found.publisher.after", || after_repairs("publisher")),
    ("found.ninth.second", || Ok(confirmed_again(&round("ninth")?).to_string())),
    ("found.ninth.flags", || Ok(round("ninth")?.len().to_string())),
    ("found.tenth.letters", || Ok(because("tenth", "einbein")?.to_string())),
    ("found.eleventh.repeated", || {
        let most = richest("eleventh")?;
        let of_it = |flag: &Contact| most.as_ref().is_some_and(|most| flag.text == most.text);
        let flags: Vec<Contact> = round("eleventh")?.into_iter().filter(of_it).collect();
        Ok((flags.len() - right(&flags)).to_string())
    }),
    ("found.last", || confirmed(&last()?)),
    ("found.last.flags", || Ok(last()?.len().to_string())),
    ("found.last.second", || Ok(confirmed_again(&last()?).to_string())),
    ("found.last.agreed", || Ok(agreed(&last()?).to_string())),
    ("found.doubted", || confirmed(&with_doubts()?)),
    ("found.doubted.faults", || Ok(distinct(&with_doubts()?).to_string())),
    ("found.doubted.flags", || Ok(with_doubts()?.len().to_string())),
    ("found.doubted.misread", || Ok(misread(&with_doubts()?).to_string())),
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
fn places(flags: &[Flag]) -> anyhow::Result<usize> {
    let places: std::collections::BTreeSet<_> = flags
        .iter()
        .filter(|flag| flag.judgement == Judgement::Real)
        .map(|flag| (&flag.module, &flag.element))
        .collect();
    Ok(places.len())
}

fn unit_misprints() -> anyhow::Result<String> {
    Ok(unit_flags()?.iter().filter(|flag| flag.judgement == Judgement::Real).count().to_string())
}

/// How many misprints have a hint.
fn hints(flags: &[Flag]) -> anyhow::Result<String> {
    let with = flags.iter().filter(|flag| flag.judgement == Judgement::Real && !flag.hint.is_empty());
    Ok(with.count().to_string())
}

/// The share of checked chains of the newest state that are wrong.
fn rate() -> anyhow::Result<String> {
    let (wrong, checked) = (places(&new()?)?, f64::from(run("new")?.checked));
    let (low, high) = wilson(wrong, checked as usize);
    Ok(format!(
        "{:.1}&nbsp;% (95&nbsp;% interval {:.1} to {:.1}&nbsp;%)",
        100.0 * wrong as f64 / checked,
        100.0 * low,
        100.0 * high
    ))
}

fn errata_found() -> anyhow::Result<usize> {
    Ok(errata()?.iter().filter(|erratum| erratum.found != "no").count())
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

/// A round of first contact as a row of the table: its name, texts and flags, the real errors with their share, the misreadings, and the real
/// errors among the flags after the repairs.
pub fn rounds() -> anyhow::Result<Vec<Vec<String>>> {
    let count = |name: &str| Ok::<_, anyhow::Error>(of_run(name)?.len());
    let row = |words: &str, texts: usize, flags: &[Contact], after: &str| -> anyhow::Result<Vec<String>> {
        let counts = [texts, flags.len(), right(flags)].map(|count| count.to_string());
        Ok([
            vec![words.to_owned()],
            counts.to_vec(),
            vec![briefly(right(flags), flags.len()), misread(flags).to_string(), after_repairs(after)?],
        ]
        .concat())
    };
    let (third, fourth) = (until_stop()?, listed("fourth", ENOUGH)?);
    let whole = |words: &str, name: &str| row(words, count(name)?, &round(name)?, name);
    Ok(vec![
        whole("first", "first")?,
        whole("second", "second")?,
        row("third", third.0, &third.1, "third")?,
        row("fourth", fourth.0, &fourth.1, "fourth")?,
        row("one more text", count("fifth")?, &first_of("fifth")?, "fifth")?,
        // In the records, the one more text of the fourth round is the fifth.
        whole("fifth", "sixth")?,
        whole("sixth", "seventh")?,
        whole("seventh", "eighth")?,
        whole("eighth", "ninth")?,
        whole("ninth", "tenth")?,
        whole("tenth", "eleventh")?,
    ])
}

/// The flags of the rounds whose program knew the rule for doubts.
fn with_doubts() -> anyhow::Result<Vec<Contact>> {
    Ok([round("sixth")?, round("seventh")?, round("eighth")?, last()?].concat())
}

/// The flags of the last three rounds, which took one list of texts.
fn last() -> anyhow::Result<Vec<Contact>> {
    Ok([round("ninth")?, round("tenth")?, round("eleventh")?].concat())
}

/// The confirmed flags among some, with their share.
fn confirmed(flags: &[Contact]) -> anyhow::Result<String> {
    Ok(format!("{} of {} flags mark real errors: {}", right(flags), flags.len(), share(flags)?))
}

/// How many flags a second reader confirms.
fn confirmed_again(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.second_judge == Some(Judgement::Real)).count()
}

/// How many of these flags are the program's own misreadings.
fn misread(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.judgement == Judgement::Ours).count()
}

/// The flags of a round.
fn round(name: &str) -> anyhow::Result<Vec<Contact>> {
    Ok(contacts()?.into_iter().filter(|flag| flag.round == name).collect())
}

/// The flags that the program raises after the repairs in the texts of a round.
fn after(name: &str) -> anyhow::Result<Vec<Contact>> {
    let texts: Vec<String> = runs()?.into_iter().filter(|run| run.run == name).map(|run| run.text).collect();
    let such = |flag: &Contact| flag.after == Answer::Yes && texts.contains(&flag.text);
    Ok(contacts()?.into_iter().filter(such).collect())
}

fn of_run(name: &str) -> anyhow::Result<Vec<Run>> {
    Ok(runs()?.into_iter().filter(|run| run.run == name).collect())
}

/// How many flags of a round are judged.
const ENOUGH: usize = 40;

/// The flags of a round in the order of its texts and files, up to the end of the file with the flag that makes them enough, and in how
/// many texts they are.
fn listed(name: &str, enough: usize) -> anyhow::Result<(usize, Vec<Contact>)> {
    let all = round(name)?;
    let last = all.get(enough - 1).or(all.last()).cloned();
    let is_last = |flag: &&Contact| last.as_ref().is_some_and(|last| last.text == flag.text && last.file == flag.file);
    let end = all.iter().rposition(|flag| is_last(&flag)).map_or(0, |at| at + 1);
    let order = of_run(name)?;
    let texts = order.iter().position(|run| last.as_ref().is_some_and(|last| last.text == run.text));
    Ok((texts.map_or(0, |at| at + 1), all.into_iter().take(end).collect()))
}

/// The first flags of a round, as many as are enough.
fn first_of(name: &str) -> anyhow::Result<Vec<Contact>> {
    Ok(round(name)?.into_iter().take(ENOUGH).collect())
}

/// The confirmed flags of a round among all, with their share.
fn all_of(name: &str) -> anyhow::Result<String> {
    let flags = round(name)?;
    Ok(format!("{} of {}, {}", right(&flags), flags.len(), share(&flags)?))
}

/// How many flags of a round have such a reason.
fn because(name: &str, reason: &str) -> anyhow::Result<usize> {
    Ok(round(name)?.iter().filter(|flag| flag.why.contains(reason)).count())
}

/// How many texts of the third round were needed for forty flags, by the rule that was written down before, and their flags.
fn until_stop() -> anyhow::Result<(usize, Vec<Contact>)> {
    const FEWEST_TEXTS: usize = 6;
    let all = round("third")?;
    let (mut texts, mut found) = (0, Vec::new());
    for run in of_run("third")? {
        if texts >= FEWEST_TEXTS && found.len() >= ENOUGH {
            break;
        }
        texts += 1;
        found.extend(all.iter().filter(|flag| flag.text == run.text).cloned());
    }
    Ok((texts, found))
}

/// The confirmed flags among those that the program raises after the repairs in the texts of a round.
fn after_repairs(name: &str) -> anyhow::Result<String> {
    let flags = after(name)?;
    Ok(format!("{} of {}", right(&flags), flags.len()))
}

/// The confirmed flags of a round among those that the rule for doubts would have left, with their share.
fn kept(name: &str) -> anyhow::Result<String> {
    let flags: Vec<Contact> = round(name)?.into_iter().filter(|flag| flag.aside == Some(Answer::No)).collect();
    let percent = 100.0 * right(&flags) as f64 / flags.len().max(1) as f64;
    Ok(format!("{} of {} ({percent:.0}&nbsp;%)", right(&flags), flags.len()))
}

/// The real errors among the flags for which it is known whether the rule for doubts would have set them aside.
fn asked() -> anyhow::Result<Vec<Contact>> {
    Ok(contacts()?.into_iter().filter(|flag| flag.aside.is_some() && flag.judgement == Judgement::Real).collect())
}

fn share(flags: &[Contact]) -> anyhow::Result<String> {
    Ok(precision(right(flags), flags.len()))
}

/// How many faults of the texts the confirmed flags of a round come from.
fn faults(name: &str) -> anyhow::Result<usize> {
    Ok(distinct(&round(name)?))
}

/// How many faults of the texts these flags come from.
fn distinct(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.judgement == Judgement::Real && flag.repeats == Answer::No).count()
}

/// In how many texts of a round at least one flag was confirmed.
fn with_fault(name: &str) -> anyhow::Result<String> {
    let flags = round(name)?;
    let texts: std::collections::BTreeSet<&str> =
        flags.iter().filter(|flag| flag.judgement == Judgement::Real).map(|flag| flag.text.as_str()).collect();
    Ok(texts.len().to_string())
}

/// The run with the most flags of a round.
fn richest(name: &str) -> anyhow::Result<Option<Run>> {
    Ok(of_run(name)?.into_iter().max_by_key(|run| run.flags))
}

/// The confirmed flags of a round among all, without the text that has the most flags.
fn rest(name: &str) -> anyhow::Result<String> {
    let mut flags = round(name)?;
    let most = richest(name)?;
    flags.retain(|flag| most.as_ref().is_none_or(|most| flag.text != most.text));
    Ok(format!("{} of {}, {}", right(&flags), flags.len(), precision(right(&flags), flags.len())))
}

/// On how many flags two readers agree.
fn agreed(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.second_judge == Some(flag.judgement)).count()
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

/// A share and the ends of its 95 % interval, in per cent.
fn percent(part: usize, all: usize) -> [f64; 3] {
    let (low, high) = wilson(part, all);
    [part as f64 / all.max(1) as f64, low, high].map(|of| 100.0 * of)
}

/// A share in per cent with its interval, for a column that says so.
fn briefly(part: usize, all: usize) -> String {
    let [share, low, high] = percent(part, all);
    format!("{share:.0}&nbsp;% ({low:.0} to&nbsp;{high:.0})")
}

/// A share in per cent with its interval.
fn precision(part: usize, all: usize) -> String {
    let [share, low, high] = percent(part, all);
    format!("{share:.0}&nbsp;% (95&nbsp;% interval {low:.0} to {high:.0}&nbsp;%)")
}

/// Errors that were planted in one kind of number.
#[derive(Clone, Copy)]
struct Planted {
    tried: u32,
    noticed: u32,
    invisible: u32,
}

impl Planted {
    /// Without those that don't show in the printed digits.
    fn visible(self) -> Self {
        Self { tried: self.tried - self.invisible, invisible: 0, ..self }
    }
}

/// The errors that were planted in results and in operands.
struct Errors {
    results: Planted,
    operands: Planted,
}

fn errors() -> anyhow::Result<Errors> {
    let run = run("old")?;
    let of = |tried: Option<u32>, noticed: Option<u32>, invisible: Option<u32>| {
        let all = tried.zip(noticed).zip(invisible);
        let ((tried, noticed), invisible) = all.ok_or_else(|| anyhow::anyhow!("no errors were planted"))?;
        anyhow::ensure!(noticed + invisible <= tried, "{noticed} and {invisible} are more than {tried} planted errors");
        Ok(Planted { tried, noticed, invisible })
    };
    Ok(Errors {
        results: of(run.results, run.results_noticed, run.results_invisible)?,
        operands: of(run.operands, run.operands_noticed, run.operands_invisible)?,
    })
}

/// The share of planted errors that were noticed, in per cent.
fn planted<const N: usize>(of: fn(&Errors) -> [Planted; N]) -> anyhow::Result<String> {
    let kinds = of(&errors()?);
    let sum = |what: fn(&Planted) -> u32| kinds.iter().map(what).sum::<u32>();
    let (tried, noticed) = (sum(|of| of.tried), sum(|of| of.noticed));
    let share = 100.0 * f64::from(noticed) / f64::from(tried.max(1));
    Ok(format!("{} of {} ({share:.1}&nbsp;%)", thousands(noticed), thousands(tried)))
}

/// The share of changed operands that don't change the result in its printed digits.
fn invisible() -> anyhow::Result<String> {
    let of = errors()?.operands;
    Ok(format!("{:.1}&nbsp;%", 100.0 * f64::from(of.invisible) / f64::from(of.tried.max(1))))
}

/// An integer with a comma between thousands.
fn thousands(number: u32) -> String {
    if number < 1000 { number.to_string() } else { format!("{},{:03}", number / 1000, number % 1000) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_proofreaders_readme_says_how_reliable_it_is() {
        let readme = include_str!("../../../proofread/README.md").split_whitespace().collect::<Vec<_>>().join(" ");
        let (flags, old) = (with_doubts().expect("flags"), old().expect("flags"));
        let [share, known] =
            [(right(&flags), flags.len()), (real(&old), old.len())].map(|(part, all)| percent(part, all)[0]);
        let errors = errors().expect("planted errors");
        let [tried, noticed] =
            [errors.results.tried + errors.operands.tried, errors.results.noticed + errors.operands.noticed];
        for phrase in [
            format!("with {} flags in texts by others, {share:.0} % marked real errors", flags.len()),
            format!("whose mark-up it knows, {known:.0} %"),
            format!("{} of {} errors", errata_found().expect("errata"), errata().expect("errata").len()),
            format!("{:.0} % of errors that were planted", percent(noticed as usize, tried as usize)[0]),
        ] {
            assert!(readme.contains(&phrase), "{phrase}");
        }
    }
}
