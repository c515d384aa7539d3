//! Of what proofreading found: how many chains were checked, how many flags a person confirmed, and with what precision.

use super::kinds::{INTERVAL, TRIALS};
use super::second_routes::interval::score_interval;
use crate::proofreading_record::{
    Answer, Contact, Flag, Judgement, ToolRun, contacts, errata, flags, run, runs, unit_flags, wilson,
};
use geneva_evidence::{Numbers, OwnNumber, RECORD};

/// The numbers of the page.
pub(crate) fn numbers() -> Vec<OwnNumber> {
    let thousands = |id, run: fn() -> Numbers<u32>| OwnNumber::new(id, "{,}", RECORD, run);
    vec![
        thousands("found.formulas", || Ok(run("old")?.formulas)),
        thousands("found.checkable", || Ok(run("old")?.checkable)),
        thousands("found.checked", || Ok(run("old")?.checked)),
        OwnNumber::count("found.old.flags", || Ok(old_flags()?.len())),
        OwnNumber::count("found.old.real", || Ok(real_count(&old_flags()?))),
        OwnNumber::count("found.old.rounding", || Ok(count_judged(&old_flags()?, Judgement::Rounding))),
        OwnNumber::count("found.old.convention", || Ok(count_judged(&old_flags()?, Judgement::Convention))),
        OwnNumber::count("found.old.ours", || Ok(count_judged(&old_flags()?, Judgement::Ours))),
        share("found.old.precision", SHARE, || Ok([real_count(&old_flags()?), old_flags()?.len()])),
        OwnNumber::count("found.new.flags", || Ok(new_flags()?.len())),
        OwnNumber::count("found.new.real", || Ok(real_count(&new_flags()?))),
        OwnNumber::count("found.new.places", || Ok(real_places(&new_flags()?)?)),
        thousands("found.new.checked", || Ok(run("new")?.checked)),
        share("found.new.rate", "{.1}&nbsp;% (95&nbsp;% interval {.1} to {.1}&nbsp;%)", || {
            Ok([real_places(&new_flags()?)?, run("new")?.checked as usize])
        }),
        OwnNumber::count("found.new.units", || {
            Ok(unit_flags()?.iter().filter(|flag| flag.judgement == Judgement::Real).count())
        }),
        OwnNumber::count("found.new.hints", || {
            let hinted = |flag: &&Flag| flag.judgement == Judgement::Real && !flag.hint.is_empty();
            Ok(new_flags()?.iter().filter(hinted).count())
        }),
        OwnNumber::count("found.hints", || Ok(hints_judged(|_| true)?)),
        OwnNumber::count("found.hints-right", || Ok(hints_judged(|right| right == Answer::Yes)?)),
        OwnNumber::count("found.errata", || Ok(errata()?.len())),
        OwnNumber::count("found.errata-found", || Ok(errata_found()?)),
        share("found.recall", SHARE, || Ok([errata_found()?, errata()?.len()])),
        OwnNumber::new("found.errata-numbers", OF, RECORD, || Ok(errata_of("number")?)),
        OwnNumber::new("found.errata-units", OF, RECORD, || Ok(errata_of("unit")?)),
        noticed_share("found.results", |of| vec![of.results]),
        noticed_share("found.operands", |of| vec![of.operands]),
        noticed_share("found.planted", |of| vec![of.results, of.operands]),
        noticed_share("found.results-visible", |of| vec![of.results.visible()]),
        noticed_share("found.operands-visible", |of| vec![of.operands.visible()]),
        OwnNumber::new("found.operands-invisible", "{.1}&nbsp;%", RECORD, || {
            let of = errors()?.operands;
            Ok(100.0 * f64::from(of.invisible) / f64::from(of.tried.max(1)))
        }),
        share("found.publisher.real", MARKED, || Ok(confirmed_of_all(&round("publisher")?))),
        OwnNumber::count("found.publisher.misread", || Ok(misread_count(&round("publisher")?))),
        OwnNumber::count("found.publisher.faults", || Ok(fault_count(&round("publisher")?))),
        OwnNumber::new("found.publisher.after", OF, RECORD, || {
            Ok(confirmed_of_all(&flags_after_repairs("publisher")?))
        }),
        share("found.last", MARKED, || Ok(confirmed_of_all(&last_rounds()?))),
        OwnNumber::count("found.last.flags", || Ok(last_rounds()?.len())),
        OwnNumber::count("found.last.second", || Ok(second_reader_count(&last_rounds()?))),
        OwnNumber::count("found.last.agreed", || Ok(agreement_count(&last_rounds()?))),
        share("found.doubted", MARKED, || Ok(confirmed_of_all(&rounds_with_doubts()?))),
        OwnNumber::count("found.doubted.faults", || Ok(fault_count(&rounds_with_doubts()?))),
        OwnNumber::count("found.doubted.flags", || Ok(rounds_with_doubts()?.len())),
        OwnNumber::count("found.doubted.misread", || Ok(misread_count(&rounds_with_doubts()?))),
    ]
}

/// A part of all.
const OF: &str = "{.0} of {.0}";
/// A share in per cent with its interval; with part and all before it, and with what they are.
const SHARE: &str = "{.0}&nbsp;% (95&nbsp;% interval {.0} to {.0}&nbsp;%)";
const MARKED: &str = "{.0} of {.0} flags mark real errors: {.0}&nbsp;% (95&nbsp;% interval {.0} to {.0}&nbsp;%)";

/// The share of a part in all with its interval: by Wilson's formula, and by trying which shares the counts allow. A form with more
/// than three holes shows the counts too.
fn share(id: &'static str, form: &'static str, counts: fn() -> Numbers<[usize; 2]>) -> OwnNumber {
    let is_counted = form.matches('{').count() > 3;
    let numbers = move |interval: fn(usize, usize) -> [f64; 2]| -> Numbers {
        let [part, all] = counts()?;
        let before = if is_counted { vec![part as f64, all as f64] } else { Vec::new() };
        Ok([before, vec![100.0 * part as f64 / all as f64], interval(part, all).to_vec()].concat())
    };
    let by_formula = |part, all| {
        let [_, low, high] = percent(part, all);
        [low, high]
    };
    OwnNumber::new(id, form, INTERVAL, move || numbers(by_formula)).with_second_route(
        "how far its flags can be trusted",
        TRIALS,
        move || numbers(score_interval),
    )
}

fn old_flags() -> anyhow::Result<Vec<Flag>> {
    Ok(flags()?.into_iter().filter(|flag| flag.flagged_old == Answer::Yes).collect())
}

fn new_flags() -> anyhow::Result<Vec<Flag>> {
    Ok(flags()?.into_iter().filter(|flag| flag.flagged_new == Answer::Yes).collect())
}

fn count_judged(flags: &[Flag], judgement: Judgement) -> usize {
    flags.iter().filter(|flag| flag.judgement == judgement).count()
}

fn real_count(flags: &[Flag]) -> usize {
    count_judged(flags, Judgement::Real)
}

/// In how many elements there is a misprint on the number.
fn real_places(flags: &[Flag]) -> anyhow::Result<usize> {
    let places: std::collections::BTreeSet<_> = flags
        .iter()
        .filter(|flag| flag.judgement == Judgement::Real)
        .map(|flag| (&flag.module, &flag.element))
        .collect();
    Ok(places.len())
}

fn errata_found() -> anyhow::Result<usize> {
    Ok(errata()?.iter().filter(|erratum| erratum.found != "no").count())
}

/// How many hints of misprints in all texts are such.
fn hints_judged(such: fn(Answer) -> bool) -> anyhow::Result<usize> {
    let in_book = flags()?.into_iter().filter_map(|flag| flag.hint_right);
    let elsewhere = contacts()?.into_iter().filter_map(|flag| flag.hint_right);
    Ok(in_book.chain(elsewhere).filter(|right| such(*right)).count())
}

/// How many of the errata of a kind the program finds, and how many there are.
fn errata_of(kind: &str) -> anyhow::Result<[usize; 2]> {
    let errata = errata()?;
    let of_kind = || errata.iter().filter(|erratum| erratum.kind == kind);
    Ok([of_kind().filter(|erratum| erratum.found != "no").count(), of_kind().count()])
}

/// A round of first contact, and what became of its flags.
pub(crate) struct ContactRound {
    /// What the page calls it.
    pub(crate) name: &'static str,
    /// Texts.
    pub(crate) texts: usize,
    /// Flags on a number.
    pub(crate) flags: usize,
    /// Flags that mark real errors.
    pub(crate) real: usize,
    /// Their share, with its interval.
    pub(crate) share: String,
    /// Flags that are misreadings.
    pub(crate) misread: usize,
    /// The real errors among the flags after the repairs.
    pub(crate) after_repairs: String,
}

/// The rounds of first contact.
pub(crate) fn rounds() -> anyhow::Result<Vec<ContactRound>> {
    let count = |name: &str| Ok::<_, anyhow::Error>(of_run(name)?.len());
    let row = |name, texts, flags: &[Contact], after: &str| {
        let (all, real) = (flags.len(), confirmed_count(flags));
        let (share, misread, after_repairs) = (briefly(real, all), misread_count(flags), after_repairs(after)?);
        Ok::<_, anyhow::Error>(ContactRound { name, texts, flags: all, real, share, misread, after_repairs })
    };
    let (third, fourth) = (until_stop()?, flags_until("fourth", ENOUGH)?);
    let whole = |words, name: &str| row(words, count(name)?, &round(name)?, name);
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
fn rounds_with_doubts() -> anyhow::Result<Vec<Contact>> {
    Ok([round("sixth")?, round("seventh")?, round("eighth")?, last_rounds()?].concat())
}

/// The flags of the last three rounds, which took one list of texts.
fn last_rounds() -> anyhow::Result<Vec<Contact>> {
    Ok([round("ninth")?, round("tenth")?, round("eleventh")?].concat())
}

/// How many of some flags are confirmed, and how many there are.
fn confirmed_of_all(flags: &[Contact]) -> [usize; 2] {
    [confirmed_count(flags), flags.len()]
}

/// How many flags a second reader confirms.
fn second_reader_count(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.second_judge == Some(Judgement::Real)).count()
}

/// How many of these flags are the program's own misreadings.
fn misread_count(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.judgement == Judgement::Ours).count()
}

/// The flags of a round.
fn round(name: &str) -> anyhow::Result<Vec<Contact>> {
    Ok(contacts()?.into_iter().filter(|flag| flag.round == name).collect())
}

/// The flags that the program raises after the repairs in the texts of a round.
fn flags_after_repairs(name: &str) -> anyhow::Result<Vec<Contact>> {
    let texts: Vec<String> = runs()?.into_iter().filter(|run| run.run == name).map(|run| run.text).collect();
    let such = |flag: &Contact| flag.after == Answer::Yes && texts.contains(&flag.text);
    Ok(contacts()?.into_iter().filter(such).collect())
}

fn of_run(name: &str) -> anyhow::Result<Vec<ToolRun>> {
    Ok(runs()?.into_iter().filter(|run| run.run == name).collect())
}

/// How many flags of a round are judged.
const ENOUGH: usize = 40;

/// The flags of a round in the order of its texts and files, up to the end of the file with the flag that makes them enough, and in how
/// many texts they are.
fn flags_until(name: &str, enough: usize) -> anyhow::Result<(usize, Vec<Contact>)> {
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
    let flags = flags_after_repairs(name)?;
    Ok(format!("{} of {}", confirmed_count(&flags), flags.len()))
}

/// How many faults of the texts these flags come from.
fn fault_count(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.judgement == Judgement::Real && flag.repeats == Answer::No).count()
}

/// On how many flags two readers agree.
fn agreement_count(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.second_judge == Some(flag.judgement)).count()
}

fn confirmed_count(flags: &[Contact]) -> usize {
    flags.iter().filter(|flag| flag.judgement == Judgement::Real).count()
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

/// The planted errors that were noticed among all, with their share in per cent.
fn noticed_share(id: &'static str, of: fn(&Errors) -> Vec<Planted>) -> OwnNumber {
    OwnNumber::new(id, "{,} of {,} ({.1}&nbsp;%)", RECORD, move || {
        let kinds = of(&errors()?);
        let sum = |what: fn(&Planted) -> u32| f64::from(kinds.iter().map(what).sum::<u32>());
        let (tried, noticed) = (sum(|of| of.tried), sum(|of| of.noticed));
        Ok([noticed, tried, 100.0 * noticed / tried.max(1.0)])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_proofreaders_readme_says_how_reliable_it_is() {
        let readme = include_str!("../../../proofread/README.md").split_whitespace().collect::<Vec<_>>().join(" ");
        let (flags, old) = (rounds_with_doubts().expect("flags"), old_flags().expect("flags"));
        let [share, known] = [(confirmed_count(&flags), flags.len()), (real_count(&old), old.len())]
            .map(|(part, all)| percent(part, all)[0]);
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
