//! The study of `geneva-case1973` on the printed tables, each part of it made once.

use super::table;
use crate::meyer::terms::MISSING;
use geneva_case1973::{Column, Listing, Row, Run, Score, compared};
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

pub use table::rows;

/// The rows of one mechanism and one friction, by rising torque; nothing else changes among them.
pub fn series() -> impl Iterator<Item = &'static [Row]> {
    geneva_case1973::series(rows())
}

/// What the listing of the program fixes for all runs.
pub fn listing() -> Listing {
    table::listing()
}

/// The interval of the printed lines, in s.
pub fn interval() -> f64 {
    listing().interval
}

/// In how many rows a column of these runs comes within one unit of the last printed place.
pub fn within_one(column: Column, runs: &[Run]) -> usize {
    geneva_case1973::within_one(column, rows(), runs)
}

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

/// Which definition of a rise time the tables could use.
pub mod rise_times {
    use super::*;
    pub use geneva_case1973::rise_times::{EVENTS, Group, Misread, OF_A_PART, Tried};

    /// Each definition with each part of the velocity that may be missing, then other events of a start.
    pub fn explained() -> &'static [Tried] {
        static TRIED: OnceLock<Vec<Tried>> = OnceLock::new();
        TRIED.get_or_init(|| geneva_case1973::rise_times::explained(rows(), MISSING))
    }

    /// The rows of a mechanism that a definition, with the thesis's own part, explains as they were run, to one unit of the
    /// last place.
    pub fn explained_rows(mechanism: Mechanism, name: &str) -> Vec<&'static Row> {
        let is_it = |tried: &&Tried| tried.name == name && tried.part.is_none_or(|part| part == MISSING);
        let times = explained().iter().find(is_it).map_or(&[][..], |tried| &tried.as_run.times);
        let explains = |(row, time): &(&Row, &f64)| {
            row.mechanism == mechanism && Column::Rise.is_within_one(row.number(Column::Rise), **time)
        };
        rows().iter().zip(times).filter(explains).map(|(row, _)| row).collect()
    }

    /// All groups of rows with one mechanism and one friction.
    pub fn groups() -> Vec<Group<'static>> {
        geneva_case1973::rise_times::groups(rows())
    }
}

/// The runs by a deck in the language of the thesis.
pub mod deck {
    use super::*;
    use geneva_case1973::Reset;
    use geneva_case1973::deck::AS_LISTED as NAMES;
    pub use geneva_case1973::deck::{data, deck, run};

    /// The names of the deck with other values in the program of the thesis, each with the claim that has the program's
    /// number.
    pub const AS_LISTED: [(&str, &str); 2] = [(NAMES[0], "meyer.listing.quarter-turn"), (NAMES[1], "meyer.listing.pi")];

    /// The names with other values in the program of the thesis, with its numbers.
    pub fn as_listed() -> [(&'static str, f64); 2] {
        geneva_case1973::deck::as_listed(&listing())
    }

    /// All rows by the deck as it is, or with the values of the program of the thesis; run once.
    ///
    /// None for another reset, or if a run comes to no end.
    pub fn runs(reset: Reset) -> Option<&'static [Run]> {
        static RUNS: [OnceLock<Option<Vec<Run>>>; 2] = [const { OnceLock::new() }; 2];
        let kept = match reset {
            Reset::OfTheMechanism => &RUNS[0],
            Reset::QuarterTurn => &RUNS[1],
            Reset::After(_) => return None,
        };
        kept.get_or_init(|| geneva_case1973::deck::runs(rows(), reset)).as_deref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_case1973::Hypothesis;

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
