//! What either reset angle could explain of a table if its inertias were not known.
//!
//! The right reset does not give the tables of six and three pins with the printed inertias. So here both inertias are
//! free, and one factor of all frictions may be chosen. Sought are the inertias that are best by least squares and, by
//! trying many, those with which most results are within a unit of the printed ones.

use super::golden_section::{Motions, inertias, ratios};
use crate::{Hypothesis, Reset, Row};

/// A table with the inputs that reproduce its peaks, minima and periods best, by least squares.
#[derive(Clone, Debug, PartialEq)]
pub struct InertiaFit {
    /// Moments of inertia of driver and follower, in in lb s².
    pub inertias: [f64; 2],
    /// By how many units of its last printed place each computed result is off.
    pub misfits: Vec<f64>,
}

impl InertiaFit {
    /// The best inertias of a mechanism's table with this reset; none if they have no motion.
    pub fn new(table: &[Row], reset: Reset) -> Option<Self> {
        Self::with_friction(table, reset, 1.0)
    }

    /// The best inertias if all frictions are so many times the printed ones; none if they have no motion.
    pub fn with_friction(table: &[Row], reset: Reset, friction: f64) -> Option<Self> {
        let angle = angle(table, reset)?;
        let [driver, follower] = inertias(table, angle, friction)?;
        let misfits = Motions::new(table, angle, friction, driver / follower)?.misfits(follower);
        Some(Self { inertias: [driver, follower], misfits })
    }

    /// Results within one unit of the last printed place.
    pub fn within_one(&self) -> usize {
        self.misfits.iter().filter(|off| off.abs() <= 1.0 + 1e-9).count()
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
pub fn most_within_one(table: &[Row], reset: Reset) -> Option<usize> {
    let angle = angle(table, reset)?;
    let [least, most] = ratios(table, 1.0)?.map(libm::log);
    let of = |step: u32| {
        let ratio = libm::exp(least + (most - least) * f64::from(step) / f64::from(RATIOS));
        Motions::new(table, angle, 1.0, ratio).map_or(0, |motions| most_at_one_point(&motions.root_ranges()))
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

/// The reset angle of a table in radians.
fn angle(table: &[Row], reset: Reset) -> Option<f64> {
    Some(Hypothesis { reset, ..Hypothesis::WITHOUT_LAG }.angle(table.first()?))
}
