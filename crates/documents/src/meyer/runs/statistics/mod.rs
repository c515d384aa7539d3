//! The numbers of our own on which the study of the runs rests, each by two routes.
//!
//! They are no claims, because no source prints them: nothing says what they should be, and they have no verdict. But what
//! the book concludes from them must not hang on one program. The first route is what `geneva-case1973` computes. The second
//! is a witness of it, or the witness's runs counted. Likelihoods and chances start from the same peaks, minima and periods
//! in both routes; these have routes of their own, in the claims of the cells. Routes that integrate share the equation of
//! motion and nothing else.

mod routes;

pub use routes::{LITTLE, lagged, shuffled};

use super::study::{delays, explained, scores};
use super::table::{listing, rows};
use geneva_case1973::chance::{self, Shuffled};
use geneva_case1973::fitted::Freed;
use geneva_case1973::likelihood::Law;
use geneva_case1973::weighing::{Others, margins, margins_by_one_row_of_each};
use geneva_case1973::witness::{densities, sampling};
use geneva_case1973::{Column, EXPLAINED, Hypothesis, Reset, Row, Weighing, rows_of};
use geneva_kinematics::Mechanism;
use routes::*;
use std::sync::OnceLock;

/// A number of our own.
pub struct Statistic {
    /// The name under which the book says it.
    pub name: &'static str,
    /// What it counts or measures.
    pub meaning: &'static str,
    /// The second route, in a few words.
    pub by: &'static str,
    /// The number by the first route; none if a run comes to no end.
    pub first: fn() -> Option<f64>,
    /// The number by the second route; none if a run comes to no end.
    pub second: fn() -> Option<f64>,
    /// By how much the two may differ: by chance if one is sampled, and by the steps of a search.
    pub within: f64,
}

/// The mechanisms for which the program's reset is wrong.
pub const OTHERS: [Mechanism; 2] = [Mechanism::SIX_PIN, Mechanism::THREE_PIN];

/// Shuffles that stand for all.
pub const SHUFFLES: usize = 10_000;

/// How far two logarithms of likelihoods may be apart, after the searches for the best spreads.
const OF_A_LOGARITHM: f64 = 0.05;

/// How far the mean of the shuffles may be from the expectation, in cells.
const OF_A_MEAN: f64 = 0.15;

const STEPS: &str = "equal steps of the driver's angle";
const INTEGRATOR: &str = "the program's integrator";
const NEWTON: &str = "Newton's laws, in equal steps of time";
const DEALS: &str = "shuffles by another generator";
const DENSITIES: &str = "densities, summed over each unit";
const TANGENTS: &str = "Gauss and Newton's method, in steps of the angle";

/// All of them, in the order of the chapter.
pub static STATISTICS: [Statistic; 29] = [
    Statistic {
        name: "runs.minima",
        meaning: "minima right to one unit, reset after 90° and the inertias of Fig. 11",
        by: STEPS,
        first: || Some(score(Hypothesis::WITHOUT_LAG)?.on(Column::Minimum)?.within_one as f64),
        second: || count_cycles(Hypothesis::WITHOUT_LAG, &Mechanism::ALL, &[Column::Minimum], 1.0),
        within: 0.0,
    },
    Statistic {
        name: "runs.periods",
        meaning: "periods right to one unit, reset after 90° and the inertias of Fig. 11",
        by: STEPS,
        first: || Some(score(Hypothesis::WITHOUT_LAG)?.on(Column::Period)?.within_one as f64),
        second: || count_cycles(Hypothesis::WITHOUT_LAG, &Mechanism::ALL, &[Column::Period], 1.0),
        within: 0.0,
    },
    Statistic {
        name: "runs.peaks",
        meaning: "peaks right to one unit, reset after 90° and the inertias of Fig. 11",
        by: INTEGRATOR,
        first: || Some(score(Hypothesis::WITHOUT_LAG)?.on(Column::Peak)?.within_one as f64),
        second: || count(&Mechanism::ALL, &[Column::Peak], 1.0, without_lag),
        within: 0.0,
    },
    Statistic {
        name: "runs.peaks-lagged",
        meaning: "peaks right to one unit, the program as listed",
        by: NEWTON,
        first: || Some(lagged(0.1)?.on(Column::Peak)?.within_one as f64),
        second: || count_lagged(&Mechanism::ALL, &[Column::Peak], 1.0),
        within: 0.0,
    },
    Statistic {
        name: "runs.exact",
        meaning: "cells right to the printed digit, the program as listed",
        by: NEWTON,
        first: || Some(score(Hypothesis::AS_RUN)?.fits.iter().map(|fit| fit.exact).sum::<usize>() as f64),
        second: || count_lagged(&Mechanism::ALL, &EXPLAINED, 0.5),
        within: 0.0,
    },
    Statistic {
        name: "runs.exact.mechanisms",
        meaning: "cells right to the printed digit, the mechanisms as they are",
        by: STEPS,
        first: || Some(score(Hypothesis::IDEAL)?.fits.iter().map(|fit| fit.exact).sum::<usize>() as f64),
        second: || count_cycles(Hypothesis::IDEAL, &Mechanism::ALL, &EXPLAINED, 0.5),
        within: 0.0,
    },
    Statistic {
        name: "runs.others-by-the-mechanisms",
        meaning: "cells for six and three pins right to one unit, the mechanisms as they are",
        by: STEPS,
        first: || Some(score(Hypothesis::IDEAL)?.within_one_of(&OTHERS) as f64),
        second: || count_cycles(Hypothesis::IDEAL, &OTHERS, &EXPLAINED, 1.0),
        within: 0.0,
    },
    Statistic {
        name: "runs.others-by-the-program",
        meaning: "cells for six and three pins right to one unit, the program as listed",
        by: NEWTON,
        first: || Some(lagged(0.1)?.within_one_of(&OTHERS) as f64),
        second: || count_lagged(&OTHERS, &EXPLAINED, 1.0),
        within: 0.0,
    },
    Statistic {
        name: "runs.by-chance",
        meaning: "cells to be expected by chance, the program as listed",
        by: DEALS,
        first: || chance::expected_cells(score(Hypothesis::AS_RUN)?, &Mechanism::ALL),
        second: || Some(mean(&sampling::cells(score(Hypothesis::AS_RUN)?, &Mechanism::ALL, SHUFFLES)?)),
        within: OF_A_MEAN,
    },
    Statistic {
        name: "runs.others.by-chance",
        meaning: "cells for six and three pins to be expected by chance, the program as listed",
        by: DEALS,
        first: || chance::expected_cells(score(Hypothesis::AS_RUN)?, &OTHERS),
        second: || Some(mean(&sampling::cells(score(Hypothesis::AS_RUN)?, &OTHERS, SHUFFLES)?)),
        within: OF_A_MEAN,
    },
    Statistic {
        name: "runs.others.by-chance.mechanisms",
        meaning: "cells for six and three pins to be expected by chance, the mechanisms as they are",
        by: DEALS,
        first: || chance::expected_cells(score(Hypothesis::IDEAL)?, &OTHERS),
        second: || Some(mean(&sampling::cells(score(Hypothesis::IDEAL)?, &OTHERS, SHUFFLES)?)),
        within: OF_A_MEAN,
    },
    Statistic {
        name: "runs.others.as-many",
        meaning: "share of the shuffles that explain as many cells as the mechanisms do, per cent",
        by: DEALS,
        first: || as_many(chance::shuffles_of_cells(score(Hypothesis::IDEAL)?, &OTHERS, 10 * SHUFFLES)?),
        second: || as_many(sampling::cells(score(Hypothesis::IDEAL)?, &OTHERS, 10 * SHUFFLES)?),
        within: 0.5,
    },
    Statistic {
        name: "runs.reset",
        meaning: "least margin of ln L over another reset, all rows",
        by: DENSITIES,
        first: || least(margins(scores(), Others::AnotherReset)?),
        second: || of_all_rows(Others::AnotherReset),
        within: OF_A_LOGARITHM,
    },
    Statistic {
        name: "runs.reset.one-row",
        meaning: "least margin of ln L over another reset, one row of each group",
        by: DENSITIES,
        first: || least(margins_by_one_row_of_each(scores(), Others::AnotherReset)?),
        second: || of_one_row_of_each(Others::AnotherReset),
        within: OF_A_LOGARITHM,
    },
    Statistic {
        name: "runs.margin",
        meaning: "least margin of ln L over another reset or other inertias, all rows",
        by: DENSITIES,
        first: || least(margins(scores(), Others::AnotherResetOrInertias)?),
        second: || of_all_rows(Others::AnotherResetOrInertias),
        within: OF_A_LOGARITHM,
    },
    Statistic {
        name: "runs.margin.one-row",
        meaning: "least margin of ln L over another reset or other inertias, one row of each group",
        by: DENSITIES,
        first: || least(margins_by_one_row_of_each(scores(), Others::AnotherResetOrInertias)?),
        second: || of_one_row_of_each(Others::AnotherResetOrInertias),
        within: OF_A_LOGARITHM,
    },
    Statistic {
        name: "runs.sampled",
        meaning: "least margin of ln L over true peaks, all rows",
        by: DENSITIES,
        first: || least(margins(scores(), Others::TruePeaks)?),
        second: || of_all_rows(Others::TruePeaks),
        within: OF_A_LOGARITHM,
    },
    Statistic {
        name: "freed.six",
        meaning: "cells for six pins right to one unit with the best inertias, right reset",
        by: TANGENTS,
        first: || freed(Mechanism::SIX_PIN, Reset::OfTheMechanism),
        second: || freed_in_steps(Mechanism::SIX_PIN, Reset::OfTheMechanism),
        within: 0.0,
    },
    Statistic {
        name: "freed.three",
        meaning: "cells for three pins right to one unit with the best inertias, right reset",
        by: TANGENTS,
        first: || freed(Mechanism::THREE_PIN, Reset::OfTheMechanism),
        second: || freed_in_steps(Mechanism::THREE_PIN, Reset::OfTheMechanism),
        within: 0.0,
    },
    Statistic {
        name: "freed.six.quarter",
        meaning: "cells for six pins right to one unit with the best inertias, reset after 90°",
        by: TANGENTS,
        first: || freed(Mechanism::SIX_PIN, Reset::QuarterTurn),
        second: || freed_in_steps(Mechanism::SIX_PIN, Reset::QuarterTurn),
        within: 0.0,
    },
    Statistic {
        name: "freed.three.quarter",
        meaning: "cells for three pins right to one unit with the best inertias, reset after 90°",
        by: TANGENTS,
        first: || freed(Mechanism::THREE_PIN, Reset::QuarterTurn),
        second: || freed_in_steps(Mechanism::THREE_PIN, Reset::QuarterTurn),
        within: 0.0,
    },
    Statistic {
        name: "freed.six.less-friction",
        meaning: "cells for six pins right to one unit with the best inertias, right reset, a hundredth of the friction",
        by: TANGENTS,
        first: || little_friction(Mechanism::SIX_PIN),
        second: || little_friction_in_steps(Mechanism::SIX_PIN),
        within: 0.0,
    },
    Statistic {
        name: "runs.fifth",
        meaning: "least margin of ln L, the listed lag over lags of a fifth of the print interval or more",
        by: DENSITIES,
        first: || over_a_fifth(|score| Some(score.likelihoods())),
        second: || over_a_fifth(by_densities),
        within: OF_A_LOGARITHM,
    },
    Statistic {
        name: "runs.lag.normal",
        meaning: "margin of ln L of no lag over the listed lag, normal law",
        by: DENSITIES,
        first: || Some(lagged(0.0)?.likelihoods()[0] - lagged(0.1)?.likelihoods()[0]),
        second: || Some(by_densities(lagged(0.0)?)?[0] - by_densities(lagged(0.1)?)?[0]),
        within: OF_A_LOGARITHM,
    },
    Statistic {
        name: "runs.lag.exponential",
        meaning: "margin of ln L of the listed lag over no lag, exponential law",
        by: DENSITIES,
        first: || Some(lagged(0.1)?.likelihoods()[1] - lagged(0.0)?.likelihoods()[1]),
        second: || Some(by_densities(lagged(0.1)?)?[1] - by_densities(lagged(0.0)?)?[1]),
        within: OF_A_LOGARITHM,
    },
    Statistic {
        name: "runs.lag.by-table",
        meaning: "margin of ln L of the listed lag over no lag, a spread for each column of each table, by either law",
        by: DENSITIES,
        first: || {
            let of = |part, law| Some(Weighing::BY_TABLE.log_likelihood(lagged(part)?, law));
            least(Law::ALL.map(|law| Some(of(0.1, law)? - of(0.0, law)?)).into_iter().collect::<Option<Vec<_>>>()?)
        },
        second: || {
            let of = |part, law| densities::log_likelihood(&Weighing::BY_TABLE, lagged(part)?, law);
            least(Law::ALL.map(|law| Some(of(0.1, law)? - of(0.0, law)?)).into_iter().collect::<Option<Vec<_>>>()?)
        },
        within: OF_A_LOGARITHM,
    },
    Statistic {
        name: "rise.chance",
        meaning: "rise times to be expected by chance, with the definition that gives the most",
        by: DEALS,
        first: || greatest(explained().iter().map(|tried| tried.as_run.by_chance)),
        second: || {
            let mean_of = |times: &[f64]| mean(&sampling::rises(rows(), &[times], false, SHUFFLES));
            greatest(explained().iter().map(|tried| mean_of(&tried.as_run.times)))
        },
        within: OF_A_MEAN,
    },
    Statistic {
        name: "rise.by-chance.usual",
        meaning: "rise times that the best definition explains in the median of all shuffles",
        by: DEALS,
        first: || middle(shuffled(Shuffled::InTables).to_vec()),
        second: || middle(sampling::rises(rows(), &definitions(), false, SHUFFLES)),
        within: 0.0,
    },
    Statistic {
        name: "rise.by-chance.equal-torques",
        meaning: "rise times that the best definition explains in the median of all shuffles among equal torques",
        by: DEALS,
        first: || middle(shuffled(Shuffled::AmongEqualTorques).to_vec()),
        second: || middle(sampling::rises(rows(), &definitions(), true, SHUFFLES)),
        within: 0.0,
    },
];

/// The statistic with this name.
pub fn statistic(name: &str) -> Option<&'static Statistic> {
    STATISTICS.iter().find(|statistic| statistic.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_case1973::fitted::most_within_one;

    #[test]
    fn both_routes_give_the_same_numbers() {
        for Statistic { name, first, second, within, .. } in &STATISTICS {
            let (first, second) = (first().expect(name), second().expect(name));
            assert!((first - second).abs() <= *within, "{name}: {first} and {second}");
        }
    }

    #[test]
    fn the_best_of_all_definitions_explains_more_than_in_any_shuffle() {
        let found = explained().iter().map(|tried| tried.as_run.rows().max(tried.ideal.rows())).max();
        let [anywhere, alike] = [Shuffled::InTables, Shuffled::AmongEqualTorques].map(shuffled);
        assert!(anywhere.iter().chain(alike).max() < found.as_ref());
        // Where the torque is kept, so is what all definitions have in common.
        assert!(mean(anywhere) < mean(alike));
    }

    #[test]
    fn the_right_reset_explains_the_tables_with_no_inertias_and_the_quarter_turn_does() {
        for mechanism in OTHERS {
            let table = rows_of(rows(), mechanism);
            let of = |reset| Freed::inertias(table, reset).expect("a motion");
            let [own, quarter] = [Reset::OfTheMechanism, Reset::QuarterTurn].map(of);
            assert!(own.within_one() <= 6 && quarter.within_one() >= 47, "{own:?} {quarter:?}");
            assert!(own.mean_misfit() > 5.0 && quarter.mean_misfit() < 0.5);
            // Other inertias bring more of the results near, but the rest must then be farther off.
            let most = |reset| most_within_one(table, reset).expect("a motion");
            assert!((own.within_one()..=30).contains(&most(Reset::OfTheMechanism)));
            assert_eq!(most(Reset::QuarterTurn), EXPLAINED.len() * table.len());
        }
    }

    #[test]
    fn less_friction_fits_ever_better_but_comes_to_no_good_fit() {
        for mechanism in OTHERS {
            let table = rows_of(rows(), mechanism);
            let with = |friction| Freed::with_friction(table, Reset::OfTheMechanism, friction).expect("a motion");
            let all = [1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01].map(with);
            assert!(all.windows(2).all(|pair| pair[1].mean_misfit() < pair[0].mean_misfit()));
            let [.., before, last] = &all;
            assert!(last.within_one() <= 14 && last.mean_misfit() > 2.0, "{last:?}");
            // The end is reached but for a hair, with inertias that grow as the friction falls.
            assert!(before.mean_misfit() - last.mean_misfit() < 0.01);
            assert!((last.inertias[1] / before.inertias[1] - 2.0).abs() < 0.01, "{last:?}");
        }
    }
}
