//! The first page: how many claims are right, how many rows describe no mechanism, how many cells are reproduced.

use super::Number;
use crate::lookup::{judged, of_documents};
use crate::rows::score;
use geneva_case1973::{Hypothesis, Row, SixPin};
use geneva_documents::LEDGER;
use geneva_documents::meyer::runs::data::inputs;
use geneva_documents::meyer::runs::table::rows;
use geneva_evidence::{Consequence, Decimal, Judged, Kind, Truth};

/// What changes a result or a conclusion.
const GRAVE: [Consequence; 2] = [Consequence::Result, Consequence::Conclusion];

/// The runs with the inertias of six pins as in the table's heading.
const AS_HEADED: Hypothesis = Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::WITHOUT_LAG };

/// The numbers of the first page.
pub const NUMBERS: &[(&str, Number)] = &[
    ("claims.right", || Ok(claims(Truth::Right, |_| true))),
    ("claims.wrong", || Ok(claims(Truth::Wrong, |slip| slip != Some(Consequence::Copy)))),
    ("claims.wrong-gravely", || Ok(claims(Truth::Wrong, |slip| slip.is_some_and(|slip| GRAVE.contains(&slip))))),
    ("claims.wrong-lightly", || {
        Ok(claims(Truth::Wrong, |slip| slip.is_none_or(|slip| slip != Consequence::Copy && !GRAVE.contains(&slip))))
    }),
    ("claims.copy", || Ok(claims(Truth::Wrong, |slip| slip == Some(Consequence::Copy)))),
    ("claims.inputs", || Ok(inputs_that_are_right()?.to_string())),
    ("claims.by-accident", || Ok(right_by_accident()?.to_string())),
    ("claims.of-one-line", || Ok(of_one_line(|_| true).to_string())),
    ("claims.of-one-line.numbers", || Ok(of_one_line(|kind| kind == Kind::Value).to_string())),
    ("claims.of-one-line.statements", || Ok(of_one_line(|kind| kind == Kind::Statement).to_string())),
    ("claims.open", || Ok(claims(Truth::Open, |_| true))),
    ("slips.grave", || Ok(GRAVE.map(|of| LEDGER.slips_of(of).count()).iter().sum::<usize>().to_string())),
    ("rows", || Ok(rows().len().to_string())),
    ("rows.of-no-mechanism", || Ok(rows().iter().filter(|row| !is_reset_rightly(row)).count().to_string())),
    ("cells", || Ok((3 * rows().len()).to_string())),
    ("cells.by-the-program", || Ok(score(&Hypothesis::AS_RUN)?.within_one().to_string())),
    ("cells.by-the-heading", || Ok(score(&AS_HEADED)?.within_one().to_string())),
    ("cells.by-the-mechanisms", || Ok(score(&Hypothesis::IDEAL)?.within_one().to_string())),
];

/// Whether the angle in the program is, as it is rounded there, that by which the pins of a row are apart.
fn is_reset_rightly(row: &Row) -> bool {
    let reset: Option<Decimal> =
        LEDGER.claim("meyer.listing.quarter-turn").and_then(|claim| claim.printed.parse().ok());
    reset.is_some_and(|reset| reset.is_rounding_of(Hypothesis::IDEAL.angle(row)))
}

/// How many of the inputs of the thesis's runs are right, which we know only from the results.
fn inputs_that_are_right() -> anyhow::Result<usize> {
    let truths = inputs().map(|id| Ok(judged(&id)?.truth()));
    let truths: Vec<Truth> = truths.collect::<anyhow::Result<_>>()?;
    Ok(truths.into_iter().filter(|truth| *truth == Truth::Right).count())
}

/// How many results of rows that describe no mechanism are right all the same.
fn right_by_accident() -> anyhow::Result<usize> {
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

/// The mistake of that line.
const FAULTY_LINE: &str = "meyer.listing.fold";

/// How many claims are right, wrong or open, and reached by such a slip or by none.
fn claims(truth: Truth, by: fn(Option<Consequence>) -> bool) -> String {
    let slip = |judged: &Judged| judged.claim.erratum.as_ref().map(|erratum| erratum.slip.consequence);
    of_documents().filter(|judged| judged.truth() == truth && by(slip(judged))).count().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::computed::by_name;

    #[test]
    fn one_line_makes_more_wrong_claims_than_any_other_mistake_and_than_all_others_together() {
        let own = of_one_line(|_| true);
        let count = |name: &str| by_name(name).expect("a number").parse::<usize>().expect("a count");
        let [numbers, statements] = ["claims.of-one-line.numbers", "claims.of-one-line.statements"].map(count);
        assert_eq!(numbers + statements, own);
        // One more number is reproduced in error: a peak that the print-out missed.
        assert_eq!(count("runs.in-error"), numbers + 1);
        let most = GRAVE
            .into_iter()
            .flat_map(|consequence| LEDGER.slips_of(consequence))
            .map(|places| places.claims.len())
            .max();
        assert_eq!(most, Some(own));
        let wrong = claims(Truth::Wrong, |slip| slip != Some(Consequence::Copy)).parse::<usize>().expect("a count");
        assert!(2 * own > wrong, "{own} of {wrong}");
    }

    #[test]
    fn the_inputs_of_the_runs_are_right_but_for_two_inertias_and_a_few_results_are_by_accident() {
        assert_eq!(inputs_that_are_right().expect("judged") + 2, inputs().count());
        let others = 3 * rows().iter().filter(|row| !is_reset_rightly(row)).count();
        let accidents = right_by_accident().expect("judged");
        assert!(accidents > 0 && 5 * accidents < others, "{accidents} of {others}");
    }
}
