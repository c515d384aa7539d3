//! Of the first page: how many of the rows describe no mechanism, how many cells come out.

use anyhow::Context;
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::rows_of;
use geneva_ledger::meyer::runs::{Hypothesis, Row, Score, rows, scores};

/// The numbers of the first page.
pub const NUMBERS: &[(&str, fn() -> anyhow::Result<String>)] = &[
    ("rows", || Ok(rows().len().to_string())),
    ("rows.of-no-mechanism", || Ok(rows().iter().filter(|row| !is_reset_rightly(row)).count().to_string())),
    ("rows.of-a-mechanism", || Ok(rows_of(Mechanism::FOUR_PIN).count().to_string())),
    ("cells", || Ok((3 * rows().len()).to_string())),
    ("cells.by-the-program", || Ok(score(&Hypothesis::WITHOUT_LAG)?.within_one().to_string())),
    ("cells.by-the-mechanisms", || Ok(score(&Hypothesis::IDEAL)?.within_one().to_string())),
];

/// Whether the program takes the angle of a row back by as much as the pins of its mechanism are apart.
fn is_reset_rightly(row: &Row) -> bool {
    Hypothesis::WITHOUT_LAG.angle(row.mechanism) == Hypothesis::IDEAL.angle(row.mechanism)
}

fn score(hypothesis: &Hypothesis) -> anyhow::Result<&'static Score> {
    scores().iter().find(|score| score.hypothesis == *hypothesis).context("a hypothesis that was not compared")
}
