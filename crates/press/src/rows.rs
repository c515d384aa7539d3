//! A row of the thesis's tables as an escapement, or why it is none.

use anyhow::Context;
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::least_braked;
use geneva_ledger::meyer::runs::{Hypothesis, Row, Score, scores};

const NONE: &str = "a run's data make no escapement";

/// The escapement of a row, as an ideal mechanism.
pub fn parameters(row: &Row) -> anyhow::Result<Parameters> {
    Hypothesis::IDEAL.parameters(row).context(NONE)
}

/// The motion of a row.
pub fn engagement(row: &Row, hypothesis: &Hypothesis) -> anyhow::Result<Engagement> {
    hypothesis.engagement(row).context(NONE)
}

/// The four-pin run that brakes least, with the weakest spring: the example wherever one run stands for all.
pub fn example() -> anyhow::Result<&'static Row> {
    weakest(least_braked(Mechanism::FOUR_PIN))
}

/// The score of a hypothesis among those compared.
pub fn score(hypothesis: &Hypothesis) -> anyhow::Result<&'static Score<'static>> {
    scores().iter().find(|score| score.hypothesis == *hypothesis).context("a hypothesis that was not compared")
}

/// The row with the weakest spring, of rows by rising torque.
pub fn weakest(rows: Option<&'static [Row]>) -> anyhow::Result<&'static Row> {
    rows.and_then(<[Row]>::first).context("no such run in the tables")
}
