//! One cycle as key times: few enough angles that straight lines between them are the motion.

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::PI;

/// How far the wheel may be from its true angle between two keys, in degrees.
pub(super) const TOLERANCE: f64 = 0.05;
/// Places between two keys at which the angle is compared.
const PROBES: u32 = 8;
/// Halvings after which an interval is taken as it is.
const DEEPEST: u32 = 12;

/// One key: a share of the cycle, and both angles in radians there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Key {
    /// From 0 to 1: from the middle of a dwell to the middle of the next.
    pub share: f64,
    /// Crank angle of the nearest pin from the line of centres.
    pub theta: f64,
    /// Wheel angle, from −α to α.
    pub phi: f64,
}

/// Keys of one cycle, from the middle of a dwell to the middle of the next, first and last included.
///
/// Symmetric about the line of centres: the first half is found by halving intervals, the second mirrors it.
pub(super) fn keys(wheel: &Wheel) -> Vec<Key> {
    let (half, pitch) = (wheel.engagement_half_angle(), 2.0 * PI / f64::from(wheel.pins()));
    let phi = |theta: f64| wheel.engaged(theta).map_or(0.0, |motion| motion.angle);
    let mut thetas = vec![-half];
    halve(-half, 0.0, DEEPEST, &phi, &mut thetas);
    let key = |theta: f64, phi: f64| Key { share: theta / pitch + 1.0 / 2.0, theta, phi };
    let rising: Vec<Key> = thetas.into_iter().map(|theta| key(theta, phi(theta))).collect();
    let falling = rising.iter().rev().skip(1).map(|at| key(-at.theta, -at.phi));
    let mut keys = rising.clone();
    keys.extend(falling);
    if half < pitch / 2.0 - 1e-9 {
        let alpha = wheel.half_pitch_angle();
        keys.insert(0, Key { share: 0.0, theta: -pitch / 2.0, phi: -alpha });
        keys.push(Key { share: 1.0, theta: pitch / 2.0, phi: alpha });
    }
    keys
}

/// Adds the ends of the parts of (from, to] on which a straight line keeps to the tolerance.
fn halve(from: f64, to: f64, depth: u32, phi: &impl Fn(f64) -> f64, ends: &mut Vec<f64>) {
    let (first, last) = (phi(from), phi(to));
    let off = |k: u32| {
        let share = f64::from(k) / f64::from(PROBES);
        (phi(from + share * (to - from)) - (first + share * (last - first))).abs()
    };
    if depth == 0 || (1..PROBES).all(|k| off(k).to_degrees() <= TOLERANCE) {
        ends.push(to);
        return;
    }
    let middle = (from + to) / 2.0;
    halve(from, middle, depth - 1, phi, ends);
    halve(middle, to, depth - 1, phi, ends);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_lines_between_the_keys_are_the_motion() {
        for (stations, pins) in [(3, 1), (3, 6), (4, 1), (4, 4), (6, 2), (12, 1), (18, 2)] {
            let wheel = Wheel::with_pins(stations, pins).expect("possible");
            let keys = keys(&wheel);
            assert_eq!((keys[0].share.abs() < 1e-12, keys[keys.len() - 1].share), (true, 1.0));
            for pair in keys.windows(2) {
                assert!(pair[0].share < pair[1].share && pair[0].phi <= pair[1].phi);
                for k in 0..=50 {
                    let part = f64::from(k) / 50.0;
                    let theta = pair[0].theta + part * (pair[1].theta - pair[0].theta);
                    let line = pair[0].phi + part * (pair[1].phi - pair[0].phi);
                    let motion = wheel.motion(0, theta).expect("in the turn");
                    // At the very ends of a turn the motion counts the neighbouring pin.
                    let off = line - motion.angle - motion.stations as f64 * 2.0 * wheel.half_pitch_angle();
                    assert!(off.to_degrees().abs() < 1.02 * TOLERANCE, "{stations}, {pins}: {theta}");
                }
            }
        }
    }

    #[test]
    fn few_keys_are_enough() {
        for stations in 3..=18 {
            let count = keys(&Wheel::new(stations).expect("possible")).len();
            assert!((11..=80).contains(&count), "{stations}: {count}");
        }
    }
}
