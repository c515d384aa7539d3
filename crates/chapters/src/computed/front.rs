//! The first page: how many claims are right, how many rows describe no mechanism, how many cells are reproduced.

use super::kinds::{COMPARISON, CRANK_STEPS, PROGRAM, QUADRATURE};
use super::second_routes::NEWTON;
use super::second_routes::printed_rows::{count_near, rows_as_mechanisms, rows_as_run, rows_on_the_integrator};
use crate::lookup::{judged, of_documents};
use crate::rows::score;
use geneva_case1973::{EXPLAINED, Hypothesis, Row, SixPin};
use geneva_documents::LEDGER;
use geneva_documents::meyer::runs::data::inputs;
use geneva_documents::meyer::runs::table::rows;
use geneva_evidence::{Consequence, Decimal, Judged, Kind, Truth};
use geneva_evidence::{Numbers, OwnNumber, RECORD};

/// What changes a result or a conclusion.
const GRAVE: [Consequence; 2] = [Consequence::Result, Consequence::Conclusion];

/// The runs with the inertias of six pins as in the table's heading.
const AS_HEADED: Hypothesis = Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::WITHOUT_LAG };

/// The printed number that stands for all on the first page: a peak of the six pins.
const EXAMPLE: &str = "meyer.app-e.6-pin.mu-0.20.k-0.03.max";

/// By how much two routes to that peak may differ, in rad/s: less than its last digit on the page.
const ALLOWED: f64 = 0.01;

/// A number of the claim that stands for all.
fn in_the_example(number: fn(&Judged) -> Option<f64>) -> Numbers<f64> {
    Ok(number(judged(EXAMPLE)?).ok_or("the example has no such number")?)
}

/// The peak of the same run among these, by another route.
fn peak_of_the_example<'a>(runs: impl IntoIterator<Item = (&'a Row, Option<[f64; 3]>)>) -> Numbers<f64> {
    let mut runs = runs.into_iter();
    let found = runs.find(|(row, _)| format!("meyer.app-e.{}.max", row.slug()) == EXAMPLE);
    Ok(found.and_then(|(_, results)| results).ok_or("the example has no run")?[0])
}

/// The numbers of the first page.
pub(super) fn numbers() -> Vec<OwnNumber> {
    let is_copy = |slip| slip == Some(Consequence::Copy);
    let is_grave = |slip: Option<Consequence>| slip.is_some_and(|slip| GRAVE.contains(&slip));
    vec![
        OwnNumber::count("claims.right", || Ok(claims(Truth::Right, |_| true))),
        OwnNumber::count("claims.wrong", move || Ok(claims(Truth::Wrong, |slip| !is_copy(slip)))),
        OwnNumber::count("claims.wrong-gravely", move || Ok(claims(Truth::Wrong, is_grave))),
        OwnNumber::count("claims.wrong-lightly", move || {
            Ok(claims(Truth::Wrong, |slip| !is_copy(slip) && !is_grave(slip)))
        }),
        OwnNumber::count("claims.copy", move || Ok(claims(Truth::Wrong, is_copy))),
        OwnNumber::count("claims.inputs", inputs_that_are_right),
        OwnNumber::count("claims.by-accident", right_by_accident),
        OwnNumber::count("claims.of-one-line", || Ok(of_one_line(|_| true))).with_second_route(
            "one line makes most of the wrong claims",
            RECORD,
            || Ok(places_of_one_line(&[Kind::Value, Kind::Equation, Kind::Figure, Kind::Statement, Kind::Example])),
        ),
        OwnNumber::count("claims.of-one-line.numbers", || Ok(of_one_line(|kind| kind == Kind::Value)))
            .with_second_route("one line makes most of the wrong claims", RECORD, || {
                Ok(places_of_one_line(&[Kind::Value]))
            }),
        OwnNumber::count("claims.of-one-line.statements", || Ok(of_one_line(|kind| kind == Kind::Statement)))
            .with_second_route("one line makes most of the wrong claims", RECORD, || {
                Ok(places_of_one_line(&[Kind::Statement]))
            }),
        OwnNumber::count("claims.open", || Ok(claims(Truth::Open, |_| true))),
        OwnNumber::count("slips.grave", || Ok(GRAVE.map(|of| LEDGER.slips_of(of).count()).iter().sum::<usize>())),
        OwnNumber::count("rows", || Ok(rows().len())),
        OwnNumber::count("rows.of-no-mechanism", || Ok(rows().iter().filter(|row| !is_reset_rightly(row)).count()))
            .with_second_route("most rows describe no mechanism", RECORD, || {
                // The pins of four slots are a quarter of a turn apart, and no others.
                Ok(rows().iter().filter(|row| row.mechanism.slots() != 4).count())
            }),
        OwnNumber::new("example.as-run", "{.1}", PROGRAM, || in_the_example(|judged| judged.computed))
            .with_second_route("the program explains the tables", NEWTON, || peak_of_the_example(rows_as_run()))
            .with_allowance(ALLOWED),
        OwnNumber::new("example.right", "{.1}", QUADRATURE, || in_the_example(|judged| judged.right_value))
            .with_second_route("the mechanisms don't explain the tables", CRANK_STEPS, || {
                peak_of_the_example(rows_as_mechanisms())
            })
            .with_allowance(ALLOWED),
        OwnNumber::count("cells", || Ok(3 * rows().len())),
        OwnNumber::new("cells.by-the-program", "{.0}", COMPARISON, || Ok(score(&Hypothesis::AS_RUN)?.within_one()))
            .with_second_route("the program explains the tables", NEWTON, || Ok(count_near(rows_as_run(), &EXPLAINED))),
        OwnNumber::new("cells.by-the-heading", "{.0}", COMPARISON, || Ok(score(&AS_HEADED)?.within_one()))
            .with_second_route("the heading is wrong", PROGRAM, || {
                Ok(count_near(rows_on_the_integrator(AS_HEADED), &EXPLAINED))
            }),
        OwnNumber::new("cells.by-the-mechanisms", "{.0}", COMPARISON, || Ok(score(&Hypothesis::IDEAL)?.within_one()))
            .with_second_route("the mechanisms don't explain the tables", CRANK_STEPS, || {
                Ok(count_near(rows_as_mechanisms(), &EXPLAINED))
            }),
    ]
}

/// Whether the angle in the program is, as it is rounded there, that by which the pins of a row are apart.
fn is_reset_rightly(row: &Row) -> bool {
    let reset: Option<Decimal> =
        LEDGER.claim("meyer.listing.quarter-turn").and_then(|claim| claim.printed.parse().ok());
    reset.is_some_and(|reset| reset.is_rounding_of(Hypothesis::IDEAL.angle(row)))
}

/// How many of the inputs of the thesis's runs are right, which we know only from the results.
fn inputs_that_are_right() -> Numbers<usize> {
    let truths = inputs().map(|id| Ok(judged(&id)?.truth()));
    let truths: Vec<Truth> = truths.collect::<anyhow::Result<_>>()?;
    Ok(truths.into_iter().filter(|truth| *truth == Truth::Right).count())
}

/// How many results of rows that describe no mechanism are right all the same.
fn right_by_accident() -> Numbers<usize> {
    let others = rows().iter().filter(|row| !is_reset_rightly(row));
    let results = others.flat_map(|row| ["max", "min", "period"].map(|result| (row, result)));
    let truths = results.map(|(row, result)| Ok(judged(&format!("meyer.app-e.{}.{result}", row.slug()))?.truth()));
    let truths: Vec<Truth> = truths.collect::<anyhow::Result<_>>()?;
    Ok(truths.into_iter().filter(|truth| *truth == Truth::Right).count())
}

/// How many claims of some kinds are wrong because of the one line of the program that resets the driver's angle.
fn of_one_line(kinds: fn(Kind) -> bool) -> usize {
    let own = |judged: &&Judged| judged.claim.erratum.as_ref().is_some_and(|erratum| erratum.slip.id == FAULTY_LINE);
    let wrong = of_documents().filter(own).filter(|judged| judged.truth() == Truth::Wrong);
    wrong.filter(|judged| kinds(judged.claim.kind)).count()
}

/// How many claims of some kinds are among the places of that mistake.
fn places_of_one_line(kinds: &[Kind]) -> usize {
    let of_line = GRAVE.into_iter().flat_map(|of| LEDGER.slips_of(of)).filter(|places| places.slip.id == FAULTY_LINE);
    of_line.flat_map(|places| &places.claims).filter(|judged| kinds.contains(&judged.claim.kind)).count()
}

/// The mistake of that line.
const FAULTY_LINE: &str = "meyer.listing.fold";

/// How many claims are right, wrong or open, and reached by such a slip or by none.
fn claims(truth: Truth, by: impl Fn(Option<Consequence>) -> bool) -> usize {
    let slip = |judged: &Judged| judged.claim.erratum.as_ref().map(|erratum| erratum.slip.consequence);
    of_documents().filter(|judged| judged.truth() == truth && by(slip(judged))).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::computed::own_text;
    use geneva_evidence::PlainVerdict;

    #[test]
    fn one_line_makes_more_wrong_claims_than_any_other_mistake_and_than_all_others_together() {
        let own = of_one_line(|_| true);
        let count = |name: &str| own_text(name).expect("a number").parse::<usize>().expect("a count");
        let [numbers, statements] = ["claims.of-one-line.numbers", "claims.of-one-line.statements"].map(count);
        assert_eq!(numbers + statements, own);
        // One more number is reproduced in error: a peak that the print-out missed.
        assert_eq!(count("runs.in-error"), numbers + 1);
        let most = GRAVE.into_iter().flat_map(|of| LEDGER.slips_of(of)).map(|places| places.claims.len()).max();
        assert_eq!(most, Some(own));
        let wrong = claims(Truth::Wrong, |slip| slip != Some(Consequence::Copy));
        assert!(2 * own > wrong, "{own} of {wrong}");
    }

    #[test]
    fn the_first_page_counts_what_the_five_plain_verdicts_count() {
        let count = |name: &str| own_text(name).expect("a number").parse::<usize>().expect("a count");
        let of = |verdict| of_documents().filter(|judged| judged.plain() == verdict).count();
        let plain = [PlainVerdict::Right, PlainVerdict::RightAsRead].map(of);
        assert!(plain.iter().all(|of| *of > 0), "{plain:?}");
        assert_eq!(count("claims.right"), plain.iter().sum::<usize>());
        assert_eq!(count("claims.wrong"), of(PlainVerdict::Wrong));
        assert_eq!(count("claims.wrong-gravely") + count("claims.wrong-lightly"), of(PlainVerdict::Wrong));
        assert_eq!(count("claims.copy"), of(PlainVerdict::WrongInCopy));
        assert_eq!(count("claims.open"), of(PlainVerdict::Open));
        assert_eq!(PlainVerdict::ALL.iter().map(|verdict| of(*verdict)).sum::<usize>(), of_documents().count());
    }

    #[test]
    fn the_inputs_of_the_runs_are_right_but_for_two_inertias_and_a_few_results_are_by_accident() {
        assert_eq!(inputs_that_are_right().expect("judged") + 2, inputs().count());
        let others = 3 * rows().iter().filter(|row| !is_reset_rightly(row)).count();
        let accidents = right_by_accident().expect("judged");
        assert!(accidents > 0 && 5 * accidents < others, "{accidents} of {others}");
    }
}
