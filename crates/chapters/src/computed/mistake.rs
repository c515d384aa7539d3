//! Of the mistake to be made again: how many cells of the tables come within one unit with three settings of the figure.

use super::kinds::{COMPARISON, PROGRAM};
use super::second_routes::NEWTON;
use super::second_routes::printed_rows::{count_near, rows_as_run, rows_on_the_integrator, rows_with_listed_lag};
use crate::rows::score;
use geneva_case1973::{EXPLAINED, Hypothesis, Reset, Score, rows_of};
use geneva_documents::meyer::runs::table::rows;
use geneva_evidence::OwnNumber;
use geneva_kinematics::Mechanism;

/// The numbers of the page.
pub(super) fn numbers() -> Vec<OwnNumber> {
    const OWN_ANGLES: Hypothesis = Hypothesis { reset: Reset::OfTheMechanism, ..Hypothesis::AS_RUN };
    vec![
        OwnNumber::count("mistake.cells", || Ok(EXPLAINED.len() * rows().len())),
        within_one("mistake.quarter-turn", Hypothesis::WITHOUT_LAG).with_second_route(
            "the lag explains little",
            PROGRAM,
            || Ok(count_near(rows_on_the_integrator(Hypothesis::WITHOUT_LAG), &EXPLAINED)),
        ),
        OwnNumber::new("mistake.own-angles", "{.0}", COMPARISON, || Ok(Score::new(OWN_ANGLES, rows()).within_one()))
            .with_second_route("the right angles don't give the tables", NEWTON, || {
                Ok(count_near(rows_with_listed_lag(OWN_ANGLES), &EXPLAINED))
            }),
        OwnNumber::new("mistake.four", "{.0}", COMPARISON, || {
            Ok(score(&Hypothesis::WITHOUT_LAG)?.within_one_of(&[Mechanism::FOUR_PIN]))
        })
        .with_second_route("for four pins the reset is right", PROGRAM, || {
            let all = rows_on_the_integrator(Hypothesis::WITHOUT_LAG);
            Ok(count_near(all.filter(|(row, _)| row.mechanism == Mechanism::FOUR_PIN), &EXPLAINED))
        }),
        OwnNumber::count("mistake.four.cells", || Ok(EXPLAINED.len() * rows_of(rows(), Mechanism::FOUR_PIN).len())),
        within_one("mistake.as-run", Hypothesis::AS_RUN).with_second_route(
            "a quarter of a turn gives the tables",
            NEWTON,
            || Ok(count_near(rows_as_run(), &EXPLAINED)),
        ),
    ]
}

/// How many cells come within one unit of the last place.
fn within_one(id: &'static str, hypothesis: Hypothesis) -> OwnNumber {
    OwnNumber::new(id, "{.0}", COMPARISON, move || Ok(score(&hypothesis)?.within_one()))
}
