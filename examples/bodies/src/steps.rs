//! Bodies moved in small steps of time: the witness, which knows forces and no formula of the leaflet.

use std::f64::consts::FRAC_PI_3;

/// How many steps a motion is cut into.
const STEPS: u32 = 2000;

/// Height fallen through, in metres, and speed, in metres per second, of a body that is let go: after a time in seconds, with a
/// constant acceleration in metres per second squared.
pub(crate) fn fall(acceleration: f64, time: f64) -> [f64; 2] {
    let step = time / f64::from(STEPS);
    (0..STEPS).fold([0.0, 0.0], |[height, speed], _| {
        let later = speed + acceleration * step;
        [height + (speed + later) / 2.0 * step, later]
    })
}

/// Time, in seconds, in which a body that is let go falls through a height in metres, with a constant acceleration in metres per
/// second squared.
pub(crate) fn fall_time(acceleration: f64, height: f64) -> f64 {
    halved([0.0, 100.0], |time| fall(acceleration, time)[0] < height)
}

/// Period, in seconds, of a pendulum of a length in metres that swings as a spring does, with the restoring acceleration of
/// gravity, in metres per second squared, times the angle.
pub(crate) fn small_period(gravity: f64, length: f64) -> f64 {
    period(1.0, |angle| -gravity / length * angle)
}

/// How much longer than that of a small swing the period of a swing by 60° to each side is, in per cent.
pub(crate) fn lengthening() -> f64 {
    100.0 * (period(FRAC_PI_3, |angle| -angle.sin()) / small_period(1.0, 1.0) - 1.0)
}

/// Period of a swing that begins at rest at this angle, in radians: four times the time to the middle, in seconds.
fn period(from: f64, acceleration: impl Fn(f64) -> f64) -> f64 {
    let is_before = |time: f64| swing(from, time, &acceleration) > 0.0;
    // From before the middle, twice the time is never past the next middle, which is three times as late.
    let mut early = 1e-3;
    while is_before(2.0 * early) {
        early *= 2.0;
    }
    4.0 * halved([early, 2.0 * early], is_before)
}

/// Angle of a pendulum at a time in seconds, in steps of Runge and Kutta, which are right to the fourth order.
fn swing(from: f64, time: f64, acceleration: impl Fn(f64) -> f64) -> f64 {
    let step = time / f64::from(STEPS);
    let rate = |[angle, speed]: [f64; 2]| [speed, acceleration(angle)];
    let moved =
        |[angle, speed]: [f64; 2], by: f64, [first, second]: [f64; 2]| [angle + by * first, speed + by * second];
    let end = (0..STEPS).fold([from, 0.0], |state, _| {
        let a = rate(state);
        let b = rate(moved(state, step / 2.0, a));
        let c = rate(moved(state, step / 2.0, b));
        let d = rate(moved(state, step, c));
        let mean = [0, 1].map(|at| (a[at] + 2.0 * b[at] + 2.0 * c[at] + d[at]) / 6.0);
        moved(state, step, mean)
    });
    end[0]
}

/// The first place in an interval at which something no longer is so, by halving the interval.
fn halved(interval: [f64; 2], is_before: impl Fn(f64) -> bool) -> f64 {
    let half = |[early, late]: [f64; 2], _| {
        let middle = (early + late) / 2.0;
        if is_before(middle) { [middle, late] } else { [early, middle] }
    };
    (0..60).fold(interval, half)[1]
}
