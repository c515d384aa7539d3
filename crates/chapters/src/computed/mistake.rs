//! Of the mistake to be made again: how many cells of the tables come within one unit with three settings of the figure.

use super::Number;
use crate::rows::score;
use geneva_case1973::{EXPLAINED, Hypothesis, Reset, Score, rows_of};
use geneva_documents::meyer::runs::table::rows;
use geneva_kinematics::Mechanism;

/// The numbers of the page.
pub const NUMBERS: &[(&str, Number)] = &[
    ("mistake.cells", || Ok((EXPLAINED.len() * rows().len()).to_string())),
    ("mistake.quarter-turn", || within_one(&Hypothesis::WITHOUT_LAG)),
    ("mistake.own-angles", || {
        let own_angles = Hypothesis { reset: Reset::OfTheMechanism, ..Hypothesis::AS_RUN };
        Ok(Score::new(own_angles, rows()).within_one().to_string())
    }),
    ("mistake.four", || {
        let score = score(&Hypothesis::WITHOUT_LAG)?;
        Ok(score.within_one_of(&[Mechanism::FOUR_PIN]).to_string())
    }),
    ("mistake.four.cells", || Ok((EXPLAINED.len() * rows_of(rows(), Mechanism::FOUR_PIN).len()).to_string())),
    ("mistake.as-run", || within_one(&Hypothesis::AS_RUN)),
];

/// How many cells come within one unit of the last place.
fn within_one(hypothesis: &Hypothesis) -> anyhow::Result<String> {
    Ok(score(hypothesis)?.within_one().to_string())
}
