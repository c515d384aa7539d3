//! The data of the runs by golden section, over the solution by integrals.

use super::BUT_FOR_THE_PEAK;
use crate::{Column, EXPLAINED, Hypothesis, Row, series};
use geneva_dynamics::existence::{critical_friction, critical_inertia_ratio};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

/// The runs whose data are sought.
const RUNS: Hypothesis = Hypothesis::WITHOUT_LAG;

/// Torques that come into question, in in lb.
const TORQUES: [f64; 2] = [1e-4, 1e2];

/// The follower's inertias that come into question, in in lb s².
const FOLLOWERS: [f64; 2] = [1e-8, 1e-2];

/// The greatest inertia of the driver that comes into question, over the follower's.
const GREATEST_RATIO: f64 = 10.0;

/// The torque with which a row's minimum and period are reproduced best, in in lb.
pub fn torque(row: &Row) -> Option<f64> {
    let [driver, follower] = RUNS.inertias(row);
    let steady = SteadyResults::new(row.mechanism, row.friction(), driver / follower, RUNS.angle(row))?;
    Some(least(TORQUES, |torque| steady.misfit(row, BUT_FOR_THE_PEAK, torque / follower)))
}

/// The friction, dimensionless, with which a row's minimum and period are reproduced best.
///
/// It is between none and the greatest with which the equation of motion has a solution everywhere.
pub fn friction(row: &Row) -> Option<f64> {
    let [driver, follower] = RUNS.inertias(row);
    let greatest = critical_friction(row.mechanism, driver / follower).ok()?.friction;
    Some(least_between([0.0, greatest], |friction| {
        let steady = SteadyResults::new(row.mechanism, friction, driver / follower, RUNS.angle(row));
        steady.map_or(f64::INFINITY, |steady| steady.misfit(row, BUT_FOR_THE_PEAK, row.torque() / follower))
    }))
}

/// The inertias of driver and follower that reproduce the peaks, minima and periods of a mechanism's table best, in
/// in lb s².
///
/// The driver's angle is reset after `reset` radians, and all frictions are `friction` times the printed ones.
pub fn inertias(table: &[Row], reset: f64, friction: f64) -> Option<[f64; 2]> {
    let ratio = least(ratios(table, friction)?, |ratio| {
        let motions = Motions::new(table, reset, friction, ratio);
        motions.map_or(f64::INFINITY, |motions| motions.misfit(motions.best_follower()))
    });
    let follower = Motions::new(table, reset, friction, ratio)?.best_follower();
    Some([ratio * follower, follower])
}

/// The inertia of the driver over the follower's, dimensionless, least and greatest: from where the equation of motion has
/// a solution everywhere.
pub fn ratios(table: &[Row], friction: f64) -> Option<[f64; 2]> {
    let most_friction = friction * table.iter().map(Row::friction).fold(0.0, f64::max);
    Some([critical_inertia_ratio(table.first()?.mechanism, most_friction).ok()?, GREATEST_RATIO])
}

/// The steady motions of a table, one for each friction.
pub struct Motions<'a>(Vec<(&'a [Row], SteadyResults)>);

impl<'a> Motions<'a> {
    /// The motions with a ratio of the inertias, all frictions so many times the printed ones.
    pub fn new(table: &'a [Row], reset: f64, friction: f64, ratio: f64) -> Option<Self> {
        let of = |own: &'a [Row]| {
            let row = own.first()?;
            Some((own, SteadyResults::new(row.mechanism, friction * row.friction(), ratio, reset)?))
        };
        series(table).map(of).collect::<Option<_>>().map(Self)
    }

    /// Each row with its motion, and its torque over the follower's inertia.
    fn rows(&self, follower: f64) -> impl Iterator<Item = (&'a Row, &SteadyResults, f64)> {
        self.0.iter().flat_map(move |(own, steady)| own.iter().map(move |row| (row, steady, row.torque() / follower)))
    }

    /// Sum of the squares of the misfits of all results.
    fn misfit(&self, follower: f64) -> f64 {
        self.rows(follower).map(|(row, steady, drive)| steady.misfit(row, &EXPLAINED, drive)).sum()
    }

    /// The follower's inertia with which that sum is least.
    fn best_follower(&self) -> f64 {
        least(FOLLOWERS, |follower| self.misfit(follower))
    }

    /// The misfits of all results, in units of the last printed place.
    pub fn misfits(&self, follower: f64) -> Vec<f64> {
        let each = self.rows(follower).flat_map(|of| EXPLAINED.map(move |column| (of, column)));
        each.map(|((row, steady, drive), column)| steady.off(row, column, drive)).collect()
    }

    /// The square roots of the follower's inertia between which each result is within a unit of the printed one.
    pub fn root_ranges(&self) -> Vec<[f64; 2]> {
        let each = self.rows(1.0).flat_map(|of| EXPLAINED.map(move |column| (of, column)));
        each.map(|((row, steady, torque), column)| steady.root_range(row, column, torque.sqrt())).collect()
    }
}

/// Peak, minimum and period of a steady motion with a torque and a follower of one.
struct SteadyResults {
    peak: f64,
    minimum: f64,
    period: f64,
}

impl SteadyResults {
    fn new(mechanism: Mechanism, friction: f64, ratio: f64, reset: f64) -> Option<Self> {
        let unit = Parameters::new(mechanism, Inertias::new(ratio, 1.0).ok()?, 1.0, friction).ok()?;
        let steady = Engagement::reset_after(&unit, reset, TOLERANCE).ok()?.steady_state().ok()?;
        Some(Self { peak: steady.peak.speed, minimum: steady.minimum.speed, period: steady.period })
    }

    /// By how many units of its last place a row's result is off, for the torque over the follower's inertia.
    fn off(&self, row: &Row, column: Column, drive: f64) -> f64 {
        let unit = drive.sqrt();
        let computed = match column {
            Column::Peak => self.peak * unit,
            Column::Minimum => self.minimum * unit,
            _ => self.period / unit,
        };
        row.misfit(column, computed)
    }

    /// Sum of the squares of the misfits of a row's results, for the torque over the follower's inertia.
    fn misfit(&self, row: &Row, results: &[Column], drive: f64) -> f64 {
        let squared = |column: &Column| {
            let off = self.off(row, *column, drive);
            off * off
        };
        results.iter().map(squared).sum()
    }

    /// The square roots of the follower's inertia between which a result is within a unit of the printed one; `root` is
    /// the square root of the torque.
    fn root_range(&self, row: &Row, column: Column, root: f64) -> [f64; 2] {
        let [low, high] = [-1.0, 1.0].map(|side| row.number(column) + side * column.unit());
        match column {
            Column::Peak => [self.peak * root / high, self.peak * root / low],
            Column::Minimum => [self.minimum * root / high, self.minimum * root / low],
            _ => [low * root / self.period, high * root / self.period],
        }
    }
}

/// Of the solution by integrals: so fine that the place of a least sum of squares is known to six digits.
const TOLERANCE: f64 = 1e-12;

/// The positive number between two with which a function of one minimum is least, sought over its logarithm.
fn least(ends: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    libm::exp(least_between(ends.map(libm::log), |logarithm| of(libm::exp(logarithm))))
}

/// The number between two with which a function of one minimum is least.
fn least_between([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    let part = (5.0_f64.sqrt() - 1.0) / 2.0;
    let mut inner = [high - part * (high - low), low + part * (high - low)];
    let mut values = inner.map(&of);
    for _ in 0..SECTIONS {
        if values[0] < values[1] {
            (high, inner[1], values[1]) = (inner[1], inner[0], values[0]);
            inner[0] = high - part * (high - low);
            values[0] = of(inner[0]);
        } else {
            (low, inner[0], values[0]) = (inner[0], inner[1], values[1]);
            inner[1] = low + part * (high - low);
            values[1] = of(inner[1]);
        }
    }
    f64::midpoint(low, high)
}

/// Sections: each leaves 0.618 of an interval, these a part in 10^10.
const SECTIONS: u32 = 48;
