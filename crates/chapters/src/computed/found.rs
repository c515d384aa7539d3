//! Of what proofreading found: the misprints in textbooks, and how often the program was right.

use super::kinds::{INTERVAL, TRIALS};
use super::second_routes::interval::score_interval;
use crate::proofreading_record::{Answer, Misprint, MisprintKind, books, misprints, rate, wilson};
use geneva_evidence::{Numbers, OwnNumber, RECORD};

/// The numbers of the page.
pub(crate) fn numbers() -> Vec<OwnNumber> {
    vec![
        OwnNumber::count("found.books", || Ok(books()?.len())),
        OwnNumber::new("found.checked", "{,}", RECORD, || Ok(checked()? as u32)),
        OwnNumber::count("found.faults", || Ok(faults(&misprints()?).len())),
        OwnNumber::count("found.faults.units", || {
            Ok(faults(&misprints()?).iter().filter(|of| of.kind == MisprintKind::Unit).count())
        }),
        OwnNumber::count("found.faults.statistics", || {
            Ok(faults(&misprints()?).iter().filter(|of| of.kind == MisprintKind::Statistics).count())
        }),
        share("found.faults.numbers", "{.1}&nbsp;% (95&nbsp;% interval {.1} to {.1}&nbsp;%)", || {
            Ok([faults(&misprints()?).iter().filter(|of| of.kind == MisprintKind::Number).count(), checked()?])
        }),
        measured("found.rate.all", "flags", "all"),
        measured("found.rate.five", "five", "all"),
        measured("found.rate.mathematics", "flags", "mathematics"),
        measured("found.rate.physics", "flags", "physics and engineering"),
        measured("found.apart", "apart", "all"),
        measured("found.hints", "hints", "all"),
        measured("found.reported", "reported", "all"),
        measured("found.planted", "planted", "all"),
        measured("found.displayed", "displayed", "all"),
    ]
}

/// A share in per cent with its interval; with part and all before it.
const COUNTED: &str = "{.0} of {.0} ({.0}&nbsp;%, 95&nbsp;% interval {.0} to {.0}&nbsp;%)";

/// The share of a part in all with its interval: by Wilson's formula, and by trying which shares the counts allow. A form with more
/// than three holes shows the counts too.
fn share(
    id: &'static str,
    form: &'static str,
    counts: impl Fn() -> Numbers<[usize; 2]> + Copy + Send + Sync + 'static,
) -> OwnNumber {
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

/// A rate that was measured at first contact.
fn measured(id: &'static str, measure: &'static str, subject: &'static str) -> OwnNumber {
    share(id, COUNTED, move || {
        let rate = rate(measure, subject)?;
        Ok([rate.good as usize, rate.tried as usize])
    })
}

fn checked() -> anyhow::Result<usize> {
    Ok(books()?.iter().map(|book| book.checked as usize).sum())
}

/// The misprints without those that come from a fault above them.
pub(crate) fn faults(misprints: &[Misprint]) -> Vec<&Misprint> {
    misprints.iter().filter(|misprint| misprint.repeats == Answer::No).collect()
}

/// A share and the ends of its 95 % interval, in per cent.
fn percent(part: usize, all: usize) -> [f64; 3] {
    let (low, high) = wilson(part, all);
    [part as f64 / all.max(1) as f64, low, high].map(|of| 100.0 * of)
}

/// A share in per cent with its interval, for a column that says so.
pub(crate) fn briefly(part: usize, all: usize) -> String {
    let [share, low, high] = percent(part, all);
    format!("{share:.0}&nbsp;% ({low:.0} to&nbsp;{high:.0})")
}
