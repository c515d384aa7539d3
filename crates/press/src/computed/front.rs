//! The first page: how many claims are right, how many rows describe no mechanism, how many cells are reproduced.

use super::Number;
use crate::lookup::of_documents;
use crate::rows::score;
use geneva_ledger::meyer::runs::{Hypothesis, Row, rows};
use geneva_ledger::{Consequence, Decimal, Judged, Truth, claim, slips_of};

/// What changes a result or a conclusion.
const GRAVE: [Consequence; 2] = [Consequence::Result, Consequence::Conclusion];

/// The numbers of the first page.
pub const NUMBERS: &[(&str, Number)] = &[
    ("claims.right", || Ok(claims(Truth::Right, |_| true))),
    ("claims.wrong", || Ok(claims(Truth::Wrong, |slip| slip != Some(Consequence::Copy)))),
    ("claims.wrong-gravely", || Ok(claims(Truth::Wrong, |slip| slip.is_some_and(|slip| GRAVE.contains(&slip))))),
    ("claims.wrong-lightly", || {
        Ok(claims(Truth::Wrong, |slip| slip.is_none_or(|slip| slip != Consequence::Copy && !GRAVE.contains(&slip))))
    }),
    ("claims.copy", || Ok(claims(Truth::Wrong, |slip| slip == Some(Consequence::Copy)))),
    ("claims.open", || Ok(claims(Truth::Open, |_| true))),
    ("slips.grave", || Ok(GRAVE.map(|of| slips_of(of).count()).iter().sum::<usize>().to_string())),
    ("rows", || Ok(rows().len().to_string())),
    ("rows.of-no-mechanism", || Ok(rows().iter().filter(|row| !is_reset_rightly(row)).count().to_string())),
    ("cells.printed", || Ok((4 * rows().len()).to_string())),
    ("cells", || Ok((3 * rows().len()).to_string())),
    ("cells.by-the-program", || Ok(score(&Hypothesis::as_run())?.within_one().to_string())),
    ("cells.by-the-mechanisms", || Ok(score(&Hypothesis::IDEAL)?.within_one().to_string())),
];

/// Whether the angle in the program is, as it is rounded there, that by which the pins of a row are apart.
fn is_reset_rightly(row: &Row) -> bool {
    let reset: Option<Decimal> = claim("meyer.listing.quarter-turn").and_then(|claim| claim.printed.parse().ok());
    reset.is_some_and(|reset| reset.is_rounding_of(Hypothesis::IDEAL.angle(row.mechanism)))
}

/// How many claims are right, wrong or open, and reached by such a slip or by none.
fn claims(truth: Truth, by: fn(Option<Consequence>) -> bool) -> String {
    let slip = |judged: &Judged| judged.claim.erratum.as_ref().map(|erratum| erratum.slip.consequence);
    of_documents().filter(|judged| judged.truth() == truth && by(slip(judged))).count().to_string()
}
