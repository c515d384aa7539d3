//! The data of the runs by the method of Gauss and Newton, over the motion in steps.
//!
//! Near a trial the misfits are taken as straight in the unknown. The next trial is where the sum of their squares would
//! be least then. The slopes are those between the last two trials.

use super::steps;
use crate::{Column, EXPLAINED, Hypothesis, Row, series};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;
use nalgebra::{Matrix2, Vector2};

/// The runs whose data are sought.
const RUNS: Hypothesis = Hypothesis::WITHOUT_LAG;

/// Minimum and period: no printed line need fall on a peak.
const SMOOTH: [Column; 2] = [Column::Minimum, Column::Period];

/// Steps of an engagement: for a row, and for a table, whose inertias depend more on small differences.
const OF_A_ROW: u32 = 1000;
const OF_A_TABLE: u32 = 1500;

/// A number found, and how far it can be off.
pub struct Estimate {
    /// The number that was sought, in its own unit.
    pub value: f64,
    /// By how much the number changes if each result was misread at random by a unit of its last place.
    pub reach: f64,
    /// The misfits that are left.
    misfits: Vec<f64>,
}

/// The torque with which a row's minimum and period are reproduced best, in in lb.
pub fn torque(row: &Row) -> Option<Estimate> {
    let [driver, follower] = RUNS.inertias(row);
    let motion = motion(row.mechanism, row.friction(), driver / follower, RUNS.angle(row), OF_A_ROW)?;
    best(FIRST_TORQUE, |torque| Some(misfits(row, &motion, &SMOOTH, torque / follower)))
}

/// The friction with which a row's minimum and period are reproduced best.
pub fn friction(row: &Row) -> Option<Estimate> {
    let [driver, follower] = RUNS.inertias(row);
    best(FIRST_FRICTION, |friction| {
        let motion = motion(row.mechanism, friction, driver / follower, RUNS.angle(row), OF_A_ROW)?;
        Some(misfits(row, &motion, &SMOOTH, row.torque() / follower))
    })
}

/// The inertias of driver and follower that reproduce the peaks, minima and periods of a mechanism's table best, in
/// in lb s², and the misfits that are left, if the driver's angle is reset after `reset` radians.
pub fn inertias(table: &[Row], reset: f64) -> Option<([f64; 2], Vec<f64>)> {
    let mechanism = table.first()?.mechanism;
    // For each ratio of the two the follower is found that suits it best.
    let with = |ratio: f64| {
        let of = |own| Some((own, motion(mechanism, <[Row]>::first(own)?.friction(), ratio, reset, OF_A_TABLE)?));
        let motions: Vec<_> = series(table).map(of).collect::<Option<_>>()?;
        best(FIRST_FOLLOWER, |follower| {
            let rows = motions.iter().flat_map(|(own, motion)| own.iter().map(move |row| (row, motion)));
            Some(rows.flat_map(|(row, motion)| misfits(row, motion, &EXPLAINED, row.torque() / follower)).collect())
        })
    };
    let ratio = best(FIRST_RATIO, |ratio| Some(with(ratio)?.misfits))?.value;
    let Estimate { value: follower, misfits, .. } = with(ratio)?;
    Some(([ratio * follower, follower], misfits))
}

/// How finely two inertias are known, in in lb s².
///
/// It is how much the inertias found change if each result was misread at random by a unit of its last place.
pub fn uncertainties(table: &[Row], [driver, follower]: [f64; 2]) -> Option<[f64; 2]> {
    let mechanism = table.first()?.mechanism;
    let reset = RUNS.angle(table.first()?);
    // The sums of the products of the slopes of all results, in the logarithms of the ratio and of the follower.
    let mut products = Matrix2::zeros();
    for own in series(table) {
        let with = |change: f64| {
            let ratio = driver / follower * libm::exp(change);
            motion(mechanism, own[0].friction(), ratio, reset, OF_A_TABLE)
        };
        let (less, same, more) = (with(-DIFFERENCE)?, with(0.0)?, with(DIFFERENCE)?);
        let drive = |row: &Row, change: f64| row.torque() / (follower * libm::exp(change));
        for row in own {
            for column in EXPLAINED {
                let off = |computed| row.misfit(column, computed);
                let of_ratio = off(more(column, drive(row, 0.0))) - off(less(column, drive(row, 0.0)));
                let of_follower =
                    off(same(column, drive(row, DIFFERENCE))) - off(same(column, drive(row, -DIFFERENCE)));
                let slopes = Vector2::new(of_ratio, of_follower) / (2.0 * DIFFERENCE);
                products += slopes * slopes.transpose();
            }
        }
    }
    let inverse = products.try_inverse()?;
    let [of_ratio, of_follower, of_both] = [(0, 0), (1, 1), (0, 1)].map(|at| inverse[at]);
    Some([driver * (of_ratio + of_follower + 2.0 * of_both).sqrt(), follower * of_follower.sqrt()])
}

/// Of a logarithm, for slopes.
const DIFFERENCE: f64 = 1e-3;

/// First trials, in in lb, in in lb s², and without dimension: a spring and a wheel far too large, a driver as heavy as
/// the follower, little friction.
const FIRST_TORQUE: f64 = 1.0;
const FIRST_FOLLOWER: f64 = 1e-2;
const FIRST_RATIO: f64 = 1.0;
const FIRST_FRICTION: f64 = 0.1;

/// A result of the motion that repeats itself, for the torque over the follower's inertia.
fn motion(
    mechanism: Mechanism,
    friction: f64,
    ratio: f64,
    reset: f64,
    steps: u32,
) -> Option<impl Fn(Column, f64) -> f64> {
    let unit = Parameters::new(mechanism, Inertias::new(ratio, 1.0).ok()?, 1.0, friction).ok()?;
    let [least, time, greatest] = steps::cycle(&unit, reset, steps)?;
    Some(move |column, drive: f64| match column {
        Column::Peak => greatest * drive.sqrt(),
        Column::Minimum => least * drive.sqrt(),
        _ => time / drive.sqrt(),
    })
}

/// The misfits of a row's results.
fn misfits(row: &Row, motion: &impl Fn(Column, f64) -> f64, results: &[Column], drive: f64) -> Vec<f64> {
    results.iter().map(|column| row.misfit(*column, motion(*column, drive))).collect()
}

/// The positive number with which the sum of the squares of misfits is least, sought over its logarithm.
fn best(first: f64, misfits: impl Fn(f64) -> Option<Vec<f64>>) -> Option<Estimate> {
    let (mut logarithm, mut step) = (libm::log(first), FIRST_STEP);
    let mut old = misfits(first)?;
    for _ in 0..MOST_TRIALS {
        let Some(new) = misfits(libm::exp(logarithm + step)) else {
            // There is no motion so far away.
            step /= 2.0;
            continue;
        };
        logarithm += step;
        let slopes: Vec<_> = new.iter().zip(&old).map(|(new, old)| (new - old) / step).collect();
        let square: f64 = slopes.iter().map(|slope| slope * slope).sum();
        let next = -slopes.iter().zip(&new).map(|(slope, misfit)| slope * misfit).sum::<f64>() / square;
        if next.abs() <= PRECISION {
            let value = libm::exp(logarithm);
            let reach = value / square.sqrt();
            return Some(Estimate { value, reach, misfits: new });
        }
        step = next.clamp(-LONGEST_STEP, LONGEST_STEP);
        old = new;
    }
    None
}

/// Steps of a logarithm: the first, and the longest, which is a factor of two.
const FIRST_STEP: f64 = 0.1;
const LONGEST_STEP: f64 = std::f64::consts::LN_2;

/// Trials until a logarithm is known to so much; most are spent on coming near.
const MOST_TRIALS: u32 = 60;
const PRECISION: f64 = 1e-8;
