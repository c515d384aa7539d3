//! The parts of the study of `geneva-case1973` that take long, on the printed tables: each is made once.

use super::table::rows;
use crate::meyer::terms::MISSING;
use geneva_case1973::rise_times::Tried;
use geneva_case1973::{Reset, Run, Score, compared, deck, rise_times};
use std::sync::OnceLock;

/// The scores of all compared hypotheses.
pub fn scores() -> &'static [Score<'static>] {
    static SCORES: OnceLock<Vec<Score>> = OnceLock::new();
    SCORES.get_or_init(|| compared().into_iter().map(|hypothesis| Score::of(hypothesis, rows())).collect())
}

/// The program with the sign chosen by the acceleration of so long ago, in s, and its score: none for the exact sign, then
/// parts of the print interval up to all of it.
pub fn delays() -> &'static [(f64, Score<'static>)] {
    static SCORES: OnceLock<Vec<(f64, Score)>> = OnceLock::new();
    SCORES.get_or_init(|| geneva_case1973::delays(rows()))
}

/// The interval that reproduces the peaks of all rows best, in s: see [`fitting_interval`](geneva_case1973::fitting_interval).
pub fn fitting_interval(by_steps: bool) -> f64 {
    static FITTING: [OnceLock<f64>; 2] = [const { OnceLock::new() }; 2];
    *FITTING[usize::from(by_steps)].get_or_init(|| geneva_case1973::fitting_interval(rows(), by_steps))
}

/// Each definition of a rise time with each part of the velocity that may be missing, then other events of a start.
pub fn explained() -> &'static [Tried] {
    static TRIED: OnceLock<Vec<Tried>> = OnceLock::new();
    TRIED.get_or_init(|| rise_times::explained(rows(), MISSING))
}

/// The names of the deck with other values in the program of the thesis, each with the claim that has the program's
/// number.
pub const AS_LISTED: [(&str, &str); 2] =
    [(deck::AS_LISTED[0], "meyer.listing.quarter-turn"), (deck::AS_LISTED[1], "meyer.listing.pi")];

/// All rows by the deck as it is, or with the values of the program of the thesis.
///
/// None for another reset, or if a run comes to no end.
pub fn by_deck(reset: Reset) -> Option<&'static [Run]> {
    static RUNS: [OnceLock<Option<Vec<Run>>>; 2] = [const { OnceLock::new() }; 2];
    let kept = match reset {
        Reset::OfTheMechanism => &RUNS[0],
        Reset::QuarterTurn => &RUNS[1],
        Reset::After(_) => return None,
    };
    kept.get_or_init(|| deck::runs(rows(), reset)).as_deref()
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_case1973::{Column, Hypothesis};

    #[test]
    fn a_run_that_comes_to_nothing_makes_the_tables_impossible() {
        let all = Score::of(Hypothesis::WITHOUT_LAG, rows());
        let mut results = all.results.clone();
        results[7] = None;
        let one_less = Score::of_results(all.hypothesis, rows(), results);
        let [all, one_less] = [all, one_less].map(|score| *score.on(Column::Minimum).expect("a fit"));
        assert_eq!(one_less.within_one, all.within_one - 1);
        assert!(all.likelihoods[0].log.is_finite() && one_less.likelihoods[0].log == f64::NEG_INFINITY);
        assert!(one_less.mean.is_finite());
    }
}
