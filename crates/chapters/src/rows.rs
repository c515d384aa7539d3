//! A row of the thesis's tables as an ideal escapement: what it is asked, and what it answers.

use crate::questions;
use anyhow::Context;
use geneva_ask::escapement::{EscapementQuestion, Further, UnitSystem};
use geneva_case1973::{Hypothesis, Row, Score, rows_with_least_friction};
use geneva_documents::meyer::runs::study::scores;
use geneva_documents::meyer::runs::table::rows;
use geneva_kinematics::Mechanism;

/// Why a row has no such motion.
pub(crate) const NONE: &str = "a run's data make no escapement";

/// The question about the escapement of a row.
pub(crate) fn question(row: &Row) -> EscapementQuestion {
    let [driver_inertia, follower_inertia] = Hypothesis::IDEAL.inertias(row);
    EscapementQuestion {
        slots: row.mechanism.slots(),
        friction: row.friction(),
        torque: row.torque(),
        driver_inertia,
        follower_inertia,
        units: Some(UnitSystem::InLbS),
        reset_deg: None,
        further: Further::default(),
    }
}

/// A number of the answer about a row.
pub(crate) fn number(row: &Row, key: &str) -> anyhow::Result<f64> {
    questions::escapement_value(&question(row), key)
}

/// A number of the answer about a row whose question is changed.
pub(crate) fn number_with(row: &Row, change: impl FnOnce(&mut EscapementQuestion), key: &str) -> anyhow::Result<f64> {
    let mut question = question(row);
    change(&mut question);
    questions::escapement_value(&question, key)
}

/// A number of the answer about each row.
pub(crate) fn numbers<'a>(rows: impl Iterator<Item = &'a Row>, key: &str) -> anyhow::Result<Vec<f64>> {
    rows.map(|row| number(row, key)).collect()
}

/// The four-pin run that brakes least, with the weakest spring: the example wherever one run stands for all.
pub(crate) fn example() -> anyhow::Result<&'static Row> {
    weakest(rows_with_least_friction(rows(), Mechanism::FOUR_PIN))
}

/// The score of a hypothesis among those compared.
pub(crate) fn score(hypothesis: &Hypothesis) -> anyhow::Result<&'static Score<'static>> {
    scores().iter().find(|score| score.hypothesis == *hypothesis).context("a hypothesis that was not compared")
}

/// The row with the weakest spring, of rows by rising torque.
pub(crate) fn weakest(rows: Option<&'static [Row]>) -> anyhow::Result<&'static Row> {
    rows.and_then(<[Row]>::first).context("no such run in the tables")
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_case1973::Column;

    #[test]
    fn a_row_asks_what_its_printed_numbers_would_ask_at_the_command_line() {
        for row in rows() {
            let [driver, follower] = Hypothesis::IDEAL.inertias(row);
            let typed = format!(
                "--slots {} --friction {} --torque {} --driver-inertia {driver} --follower-inertia {follower} --units in-lb-s",
                row.mechanism.slots(),
                row.printed(Column::Friction),
                row.printed(Column::Torque)
            );
            assert_eq!(question(row), EscapementQuestion::parse(&typed).expect("a question"));
        }
    }
}
