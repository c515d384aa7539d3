//! What either reset angle could explain of a table if its inertias were not known.
//!
//! The right reset does not give the tables of six and three pins with the printed inertias. So here both inertias are
//! free, and one factor of all frictions may be chosen. Sought are the inertias that are best by least squares and, by
//! trying many, those with which most results are within a unit of the printed ones.

use super::golden_section::{Motions, inertias, ratios};
use super::*;

/// A table with the inputs that reproduce its peaks, minima and periods best, by least squares.
#[derive(Clone, Debug, PartialEq)]
pub struct Freed {
    /// Moments of inertia of driver and follower, in in lb s².
    pub inertias: [f64; 2],
    /// By how many units of its last printed place each computed result is off.
    pub misfits: Vec<f64>,
}

impl Freed {
    /// The best inertias of a mechanism's table with this reset; none if they have no motion.
    pub fn inertias(reset: Reset, mechanism: Mechanism) -> Option<Self> {
        Self::with_friction(reset, mechanism, 1.0)
    }

    /// The best inertias if all frictions are so many times the printed ones; none if they have no motion.
    pub fn with_friction(reset: Reset, mechanism: Mechanism, friction: f64) -> Option<Self> {
        let angle = angle(reset, mechanism);
        let [driver, follower] = inertias(mechanism, angle, friction)?;
        let misfits = Motions::of(mechanism, angle, friction, driver / follower)?.misfits(follower);
        Some(Self { inertias: [driver, follower], misfits })
    }

    /// Results within one unit of the last printed place.
    pub fn within_one(&self) -> usize {
        within_one(&self.misfits)
    }

    /// The root of the mean square of the misfits, in units of the last printed place.
    pub fn mean_misfit(&self) -> f64 {
        (self.misfits.iter().map(|off| off * off).sum::<f64>() / self.misfits.len() as f64).sqrt()
    }
}

/// The most results of a table that any of many inertias bring within one unit of the printed ones.
///
/// The ratio of the two goes in [`RATIOS`] steps through all that come into question. With each of them the best follower
/// is found exactly, since every result allows it a range.
pub fn most_within_one(reset: Reset, mechanism: Mechanism) -> Option<usize> {
    let [least, most] = ratios(mechanism, 1.0)?.map(libm::log);
    let of = |step: u32| {
        let ratio = libm::exp(least + (most - least) * f64::from(step) / f64::from(RATIOS));
        Motions::of(mechanism, angle(reset, mechanism), 1.0, ratio)
            .map_or(0, |motions| most_at_one_point(&motions.near()))
    };
    (0..=RATIOS).map(of).max()
}

/// Steps in which the ratio of the inertias is tried.
pub const RATIOS: u32 = 400;

/// The most ranges that have a point in common.
fn most_at_one_point(ranges: &[[f64; 2]]) -> usize {
    let covers = |at: f64| ranges.iter().filter(|[low, high]| (*low..=*high).contains(&at)).count();
    ranges.iter().map(|[low, _]| covers(*low)).max().unwrap_or(0)
}

fn within_one(misfits: &[f64]) -> usize {
    misfits.iter().filter(|off| off.abs() <= 1.0 + 1e-9).count()
}

fn angle(reset: Reset, mechanism: Mechanism) -> f64 {
    Hypothesis { reset, ..Hypothesis::WITHOUT_LAG }.angle(mechanism)
}

#[cfg(test)]
mod tests {
    use super::*;

    const OTHERS: [Mechanism; 2] = [Mechanism::SIX_PIN, Mechanism::THREE_PIN];

    #[test]
    fn both_routes_find_the_best_inertias_and_count_as_many_results() {
        for mechanism in OTHERS {
            for reset in [Reset::OfTheMechanism, Reset::QuarterTurn] {
                let freed = Freed::inertias(reset, mechanism).expect("a motion");
                let (in_steps, misfits) = gauss_newton::inertias(mechanism, angle(reset, mechanism)).expect("a motion");
                for (by_sections, in_steps) in freed.inertias.iter().zip(in_steps) {
                    assert!((by_sections / in_steps - 1.0).abs() < 1e-3, "{:?} {in_steps:?}", freed.inertias);
                }
                assert_eq!(freed.within_one(), within_one(&misfits), "{mechanism:?} {reset:?}");
            }
        }
    }

    #[test]
    fn the_right_reset_explains_the_tables_with_no_inertias_and_the_quarter_turn_does() {
        for mechanism in OTHERS {
            let [own, quarter] =
                [Reset::OfTheMechanism, Reset::QuarterTurn].map(|of| Freed::inertias(of, mechanism).expect("a motion"));
            assert_eq!(own.misfits.len(), 48);
            assert!(own.within_one() <= 6 && quarter.within_one() >= 47, "{own:?} {quarter:?}");
            assert!(own.mean_misfit() > 5.0 && quarter.mean_misfit() < 0.5);
            // Other inertias bring more of the results near, but the rest must then be farther off.
            let [most, of_the_program] =
                [Reset::OfTheMechanism, Reset::QuarterTurn].map(|of| most_within_one(of, mechanism).expect("a motion"));
            assert!((own.within_one()..=30).contains(&most) && of_the_program == 48, "{most} {of_the_program}");
        }
    }

    #[test]
    fn trying_followers_one_by_one_brings_nearly_as_many_results_near_and_never_more() {
        for mechanism in OTHERS {
            let angle = angle(Reset::OfTheMechanism, mechanism);
            let most = most_within_one(Reset::OfTheMechanism, mechanism).expect("a motion");
            let [least, greatest] = ratios(mechanism, 1.0).expect("a motion").map(libm::log);
            let of = |step: u32| {
                let ratio = libm::exp(least + (greatest - least) * f64::from(step) / 100.0);
                let motions = Motions::of(mechanism, angle, 1.0, ratio)?;
                (0..400).map(|step| within_one(&motions.misfits(1e-6 * libm::pow(1.015, f64::from(step))))).max()
            };
            let found = (0..=100).filter_map(of).max().expect("a motion");
            assert!((most - 3..=most).contains(&found), "{found} {most}");
        }
    }

    #[test]
    fn less_friction_fits_ever_better_but_comes_to_no_good_fit() {
        for mechanism in OTHERS {
            let with = |friction| Freed::with_friction(Reset::OfTheMechanism, mechanism, friction).expect("a motion");
            let all = [1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01].map(with);
            assert!(all.windows(2).all(|pair| pair[1].mean_misfit() < pair[0].mean_misfit()));
            let [.., before, last] = &all;
            assert!(last.within_one() <= 14 && last.mean_misfit() > 2.0, "{last:?}");
            // The end is reached but for a hair, with inertias that grow as the friction falls.
            assert!(before.mean_misfit() - last.mean_misfit() < 0.01);
            assert!((last.inertias[1] / before.inertias[1] - 2.0).abs() < 0.01, "{last:?}");
        }
    }

    #[test]
    fn ranges_are_counted_where_most_of_them_meet() {
        assert_eq!(most_at_one_point(&[[0.0, 1.0], [0.5, 2.0], [0.9, 0.95], [3.0, 4.0]]), 3);
        assert_eq!(most_at_one_point(&[]), 0);
    }
}
