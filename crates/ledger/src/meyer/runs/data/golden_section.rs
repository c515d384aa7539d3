//! The data of the runs by golden section, over the solution by integrals.

use super::*;
use geneva_dynamics::existence::{critical_friction, critical_inertia_ratio};
use geneva_dynamics::steady::Engagement;

/// Torques that come into question, in in lb.
const TORQUES: [f64; 2] = [1e-4, 1e2];

/// The follower's inertias that come into question, in in lb s².
const FOLLOWERS: [f64; 2] = [1e-8, 1e-2];

/// The greatest inertia of the driver that comes into question, over the follower's.
const GREATEST_RATIO: f64 = 10.0;

/// The torque with which a row's minimum and period are reproduced best, in in lb.
pub fn torque(row: &Row) -> Option<f64> {
    let [driver, follower] = printed_inertias(row);
    let steady = Steady::of(row.mechanism, row.friction(), driver / follower)?;
    Some(least(TORQUES, |torque| steady.misfit(row, BUT_FOR_THE_PEAK, torque / follower)))
}

/// The friction with which a row's minimum and period are reproduced best.
///
/// It is between none and the greatest with which the equation of motion has a solution everywhere.
pub fn friction(row: &Row) -> Option<f64> {
    let [driver, follower] = printed_inertias(row);
    let greatest = critical_friction(row.mechanism, driver / follower).ok()?.friction;
    Some(least_between([0.0, greatest], |friction| {
        let steady = Steady::of(row.mechanism, friction, driver / follower);
        steady.map_or(f64::INFINITY, |steady| steady.misfit(row, BUT_FOR_THE_PEAK, row.torque() / follower))
    }))
}

/// The inertias of driver and follower that reproduce a mechanism's peaks, minima and periods best, in in lb s².
pub fn inertias(mechanism: Mechanism) -> Option<[f64; 2]> {
    let series: Vec<_> = series().filter(|own| own[0].mechanism == mechanism).collect();
    let most_friction = series.iter().map(|own| own[0].friction()).fold(0.0, f64::max);
    let ratios = [critical_inertia_ratio(mechanism, most_friction).ok()?, GREATEST_RATIO];
    // The motions with a ratio, and the follower that suits them best with its sum of squares.
    let with = |ratio: f64| {
        let of = |own: &&'static [Row]| Some((*own, Steady::of(mechanism, own[0].friction(), ratio)?));
        let motions: Vec<_> = series.iter().map(of).collect::<Option<_>>()?;
        let misfit = |follower: f64| -> f64 {
            let of = |(own, steady): &(&[Row], Steady)| -> f64 {
                own.iter().map(|row| steady.misfit(row, RESULTS, row.torque() / follower)).sum()
            };
            motions.iter().map(of).sum()
        };
        let follower = least(FOLLOWERS, misfit);
        Some((follower, misfit(follower)))
    };
    let ratio = least(ratios, |ratio| with(ratio).map_or(f64::INFINITY, |(_, misfit)| misfit));
    let (follower, _) = with(ratio)?;
    Some([ratio * follower, follower])
}

/// Peak, minimum and period of a steady motion with a torque and a follower of one.
struct Steady {
    peak: f64,
    minimum: f64,
    period: f64,
}

impl Steady {
    fn of(mechanism: Mechanism, friction: f64, ratio: f64) -> Option<Self> {
        let unit = Parameters::new(mechanism, Inertias::new(ratio, 1.0).ok()?, 1.0, friction).ok()?;
        let steady = Engagement::reset_after(&unit, reset(mechanism), TOLERANCE).ok()?.steady_state().ok()?;
        Some(Self { peak: steady.peak.speed, minimum: steady.minimum.speed, period: steady.period })
    }

    /// Sum of the squares of the misfits of a row's results, for the torque over the follower's inertia.
    fn misfit(&self, row: &Row, results: &[Column], drive: f64) -> f64 {
        let unit = drive.sqrt();
        let of = |column: &Column| {
            let computed = match column {
                Column::Peak => self.peak * unit,
                Column::Minimum => self.minimum * unit,
                _ => self.period / unit,
            };
            let off = misfit(row, *column, computed);
            off * off
        };
        results.iter().map(of).sum()
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
