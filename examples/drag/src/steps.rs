//! Bodies moved in small steps: the witness, which knows forces and no formula of the section.

/// How many steps a motion is cut into.
const STEPS: u32 = 4000;

/// The state after a time in seconds of what begins in this state and changes at this rate, in steps of Runge and Kutta, which are
/// right to the fourth order. The rate may depend on the time.
pub(crate) fn moved<const N: usize>(start: [f64; N], time: f64, rate: impl Fn(f64, [f64; N]) -> [f64; N]) -> [f64; N] {
    let step = time / f64::from(STEPS);
    let ahead = |state: [f64; N], by: f64, slope: [f64; N]| -> [f64; N] {
        std::array::from_fn(|at| state[at] + by * slope[at])
    };
    (0..STEPS).fold(start, |state, number| {
        let now = f64::from(number) * step;
        let a = rate(now, state);
        let b = rate(now + step / 2.0, ahead(state, step / 2.0, a));
        let c = rate(now + step / 2.0, ahead(state, step / 2.0, b));
        let d = rate(now + step, ahead(state, step, c));
        ahead(state, step, std::array::from_fn(|at| (a[at] + 2.0 * b[at] + 2.0 * c[at] + d[at]) / 6.0))
    })
}

/// Speed and way of a body that moves in a line for a time in seconds, from a speed in m/s, with an acceleration in m/s² that depends
/// on its speed.
pub(crate) fn line(speed: f64, time: f64, acceleration: impl Fn(f64) -> f64) -> [f64; 2] {
    moved([speed, 0.0], time, |_, [speed, _]| [acceleration(speed), speed])
}

/// The speed at which a body that begins at rest no longer gains speed. The time in seconds must be long against the time in which it
/// gains most of it.
pub(crate) fn limiting(long: f64, acceleration: impl Fn(f64) -> f64) -> f64 {
    line(0.0, long, acceleration)[0]
}

/// The first place in an interval at which something no longer is so, by halving the interval.
pub(crate) fn halved(interval: [f64; 2], is_before: impl Fn(f64) -> bool) -> f64 {
    let half = |[early, late]: [f64; 2], _| {
        let middle = (early + late) / 2.0;
        if is_before(middle) { [middle, late] } else { [early, middle] }
    };
    let [early, late] = (0..60).fold(interval, half);
    (early + late) / 2.0
}

/// The area under a curve between two places, by Simpson's rule: in this many strips, of which each is a pair.
pub(crate) fn simpson([from, to]: [f64; 2], curve: impl Fn(f64) -> f64) -> f64 {
    const STRIPS: u32 = 400;
    let width = (to - from) / f64::from(STRIPS);
    let strip = |number: u32| {
        let left = from + f64::from(number) * width;
        (curve(left) + 4.0 * curve(left + width / 2.0) + curve(left + width)) * width / 6.0
    };
    (0..STRIPS).map(strip).sum()
}

/// The area under a curve between two places, by the rule of Gauss and Legendre with three places in each strip.
pub(crate) fn gauss([from, to]: [f64; 2], curve: impl Fn(f64) -> f64) -> f64 {
    const STRIPS: u32 = 100;
    let half = (to - from) / f64::from(STRIPS) / 2.0;
    let aside = half * 0.6_f64.sqrt();
    let strip = |number: u32| {
        let middle = from + f64::from(2 * number + 1) * half;
        (5.0 * curve(middle - aside) + 8.0 * curve(middle) + 5.0 * curve(middle + aside)) * half / 9.0
    };
    (0..STRIPS).map(strip).sum()
}

/// The unknowns of as many linear equations, each a row of factors and what they come to; not numbers if they have no one solution.
pub(crate) fn solved<const N: usize>(mut rows: [[f64; N]; N], mut right: [f64; N]) -> [f64; N] {
    for at in 0..N {
        let size = |row: &usize| rows[*row][at].abs();
        let Some(largest) = (at..N).max_by(|one, other| size(one).total_cmp(&size(other))) else { continue };
        rows.swap(at, largest);
        right.swap(at, largest);
        let pivot = rows[at];
        for row in (0..N).filter(|row| *row != at) {
            let factor = rows[row][at] / pivot[at];
            for column in 0..N {
                rows[row][column] -= factor * pivot[column];
            }
            right[row] -= factor * right[at];
        }
    }
    std::array::from_fn(|at| right[at] / rows[at][at])
}

/// The force to the middle that turns a body's velocity by a quarter turn, from its momentum before and after: mass in kg, speed in m/s,
/// radius in m.
pub(crate) fn pull_to_middle([mass, speed, radius]: [f64; 3]) -> f64 {
    let eighth = std::f64::consts::FRAC_PI_4;
    let time = eighth * radius / speed;
    let gained = 2.0 * mass * speed * libm::sin(eighth);
    gained / simpson([-time, time], |now| libm::cos(speed / radius * now))
}
