//! The motion in equal steps of the driver's angle, by Runge and Kutta: the second route to the solution over the angle.
//!
//! u = θ'² as a function of the angle has twice the acceleration for its derivative.

use crate::{Hypothesis, Row};
use geneva_dynamics::{Coefficients, Inertias, Parameters, Pose};
use geneva_kinematics::Mechanism;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The driver's angles that steps lead to, with the factors of the equation of motion at each, and du/dθ there and in
/// the middle between two.
#[derive(Clone)]
pub struct Course {
    /// The driver's angles from the line of centres, or how far it has turned.
    pub angles: Arc<[f64]>,
    coefficients: Vec<Coefficients<f64>>,
    ends: Vec<Slope>,
    middles: Vec<Slope>,
}

/// du/dθ at one crank angle. With each sign of the friction it is a straight line in u, and so is the function whose
/// sign the friction has. Each is given by its value at u = 0 and its growth for each unit of u.
#[derive(Clone)]
struct Slope {
    switching: [f64; 2],
    plus: [f64; 2],
    minus: [f64; 2],
}

impl Slope {
    fn new(terms: &Coefficients<f64>) -> Self {
        let Coefficients { a, b, c, d, e } = *terms;
        // A θ'' + B u + S (C u + D θ'') = E, and du/dθ = 2 θ''.
        let with = |sign: f64| [2.0 * e / (a + sign * d), -2.0 * (b + sign * c) / (a + sign * d)];
        Self { switching: [d * e, a * c - d * b], plus: with(1.0), minus: with(-1.0) }
    }

    fn at(&self, square: f64) -> f64 {
        let square = square.max(0.0);
        let along = |[start, growth]: [f64; 2]| start + growth * square;
        along(if along(self.switching) < 0.0 { self.minus } else { self.plus })
    }
}

/// Angles, and how the mechanism stands at them and in the middle between two: the same for all frictions, inertias and
/// torques.
struct Poses {
    angles: Arc<[f64]>,
    ends: Vec<Pose<f64>>,
    middles: Vec<Pose<f64>>,
}

impl Poses {
    fn from_angles(parameters: &Parameters, angles: Vec<f64>, engaged: impl Fn(f64) -> f64) -> Self {
        let pose = |angle: f64| parameters.pose(engaged(angle));
        let ends = angles.iter().map(|angle| pose(*angle)).collect();
        let middles = angles.windows(2).map(|pair| pose(pair[0] + (pair[1] - pair[0]) / 2.0)).collect();
        Self { angles: angles.into(), ends, middles }
    }

    /// The poses of an engagement that starts at entry and lasts for a turn of `reset` radians, found once.
    fn engagement(parameters: &Parameters, reset: f64, steps: u32) -> Arc<Self> {
        type Known = Mutex<HashMap<(Mechanism, u64, u32), Arc<Poses>>>;
        static KNOWN: OnceLock<Known> = OnceLock::new();
        let mechanism = parameters.mechanism();
        let of = || {
            let (start, step) = (-mechanism.engagement_half_angle(), reset / f64::from(steps));
            let angles = (0..=steps).map(|k| start + step * f64::from(k)).collect();
            Arc::new(Self::from_angles(parameters, angles, |angle| angle))
        };
        let mut known = KNOWN.get_or_init(Known::default).lock().unwrap_or_else(PoisonError::into_inner);
        Arc::clone(known.entry((mechanism, reset.to_bits(), steps)).or_insert_with(of))
    }

    fn course(&self, parameters: &Parameters) -> Course {
        let (ratio, friction, drive) = (parameters.inertias().ratio(), parameters.friction(), parameters.drive());
        let all = |poses: &[Pose<f64>]| -> Vec<_> {
            poses.iter().map(|pose| Coefficients::from_pose(pose, &ratio, &friction, &drive)).collect()
        };
        let slopes = |of: &[Coefficients<f64>]| of.iter().map(Slope::new).collect();
        let (coefficients, middles) = (all(&self.ends), all(&self.middles));
        let (ends, middles) = (slopes(&coefficients), slopes(&middles));
        Course { angles: Arc::clone(&self.angles), coefficients, ends, middles }
    }
}

impl Course {
    /// The course through an engagement that starts at entry and lasts for a turn of `reset` radians.
    pub fn of_engagement(parameters: &Parameters, reset: f64, steps: u32) -> Self {
        Poses::engagement(parameters, reset, steps).course(parameters)
    }

    /// The course where the driver has turned so far; `engaged` gives the angle of the pin in its slot.
    pub fn from_angles(parameters: &Parameters, turned: Vec<f64>, engaged: impl Fn(f64) -> f64) -> Self {
        Poses::from_angles(parameters, turned, engaged).course(parameters)
    }

    /// The factors of the equation of motion at each angle.
    pub fn coefficients(&self) -> &[Coefficients<f64>] {
        &self.coefficients
    }

    /// u at the angles, from its value at the first, in units of squared speed.
    pub fn squares(&self, first: f64) -> Vec<f64> {
        let mut squares = Vec::with_capacity(self.angles.len());
        squares.push(first);
        let mut state = first;
        for ((angles, ends), middle) in self.angles.windows(2).zip(self.ends.windows(2)).zip(&self.middles) {
            state = step(angles[1] - angles[0], state, [&ends[0], middle, &ends[1]], Slope::at);
            squares.push(state);
        }
        squares
    }
}

/// A number, in its own unit, at the end of a step of this length, by the classical Runge-Kutta method, from its value at the start and its
/// slope, which the places at the start, in the middle and at the end tell for each value.
pub fn step<P>(length: f64, start: f64, [first, middle, last]: [&P; 3], slope: impl Fn(&P, f64) -> f64) -> f64 {
    let half = length / 2.0;
    let one = slope(first, start);
    let two = slope(middle, start + one * half);
    let three = slope(middle, start + two * half);
    let four = slope(last, start + three * length);
    start + (one + two * 2.0 + three * 2.0 + four) * (length / 6.0)
}

/// Least speed, duration and greatest speed of the engagement that repeats itself, for a torque and a follower of one and
/// so in units of √(K/I_f) and its inverse; none if the steps are too long for the equation.
pub fn cycle(parameters: &Parameters, reset: f64, steps: u32) -> Option<[f64; 3]> {
    type Known = Mutex<HashMap<(Mechanism, [u64; 3], u32), Option<[f64; 3]>>>;
    static KNOWN: OnceLock<Known> = OnceLock::new();
    // The rows of a table begin the search for their data with the same trials.
    let numbers = [parameters.inertias().ratio(), parameters.friction(), reset].map(f64::to_bits);
    let key = (parameters.mechanism(), numbers, steps);
    let known = KNOWN.get_or_init(Known::default);
    if let Some(found) = known.lock().ok()?.get(&key) {
        return *found;
    }
    let found = cycle_of(parameters, reset, steps);
    known.lock().ok()?.insert(key, found);
    found
}

fn cycle_of(parameters: &Parameters, reset: f64, steps: u32) -> Option<[f64; 3]> {
    let ratio = Inertias::new(parameters.inertias().ratio(), 1.0).ok()?;
    let unit = Parameters::new(parameters.mechanism(), ratio, 1.0, parameters.friction()).ok()?;
    let course = Course::of_engagement(&unit, reset, steps);
    let squares = repeated(&course)?;
    let least = squares.windows(3).map(|w| lowest(w[0], w[1], w[2]));
    let least = squares.iter().copied().chain(least).fold(f64::INFINITY, f64::min);
    // The greatest stands upside down.
    let greatest = squares.windows(3).map(|w| -lowest(-w[0], -w[1], -w[2]));
    let greatest = squares.iter().copied().chain(greatest).fold(0.0, f64::max);
    let found = [least.sqrt(), duration(&course, &squares), greatest.sqrt()];
    found.iter().all(|number| number.is_finite()).then_some(found)
}

/// The squares of the engagement that ends as it starts.
///
/// One engagement takes u to nearly a multiple of u and a constant, so what it adds to u is nearly a straight line in
/// u: the line through the last two trials leads to the next.
fn repeated(course: &Course) -> Option<Vec<f64>> {
    let mut first = 1.0;
    let mut last: Option<[f64; 2]> = None;
    for _ in 0..MOST_TRIALS {
        let squares = course.squares(first);
        let added = *squares.last()? - first;
        if added.abs() <= 1e-12 * first {
            return Some(squares);
        }
        let step = last.map_or(added, |[before, added_before]| added * (first - before) / (added_before - added));
        last = Some([first, added]);
        first += step;
    }
    None
}

/// Trials until an engagement repeats itself; a handful is enough.
const MOST_TRIALS: u32 = 50;

/// ∫ dθ / √u by Simpson's rule, with u in the middle of a step by the cubic through values and slopes.
fn duration(course: &Course, squares: &[f64]) -> f64 {
    let angles = &course.angles;
    let slopes: Vec<_> = course.ends.iter().zip(squares).map(|(slope, u)| slope.at(*u)).collect();
    (1..angles.len())
        .map(|k| {
            let (step, a, b) = (angles[k] - angles[k - 1], squares[k - 1], squares[k]);
            let middle = f64::midpoint(a, b) + step / 8.0 * (slopes[k - 1] - slopes[k]);
            step / 6.0 * (1.0 / a.sqrt() + 4.0 / middle.sqrt() + 1.0 / b.sqrt())
        })
        .sum()
}

/// The lowest value of the parabola through three neighbours; the middle one if it is not the lowest of the three.
fn lowest(before: f64, middle: f64, next: f64) -> f64 {
    let bend = before - 2.0 * middle + next;
    if middle < before && middle < next { middle - (next - before) * (next - before) / (8.0 * bend) } else { middle }
}

/// Steps of an engagement of a row.
const STEPS: u32 = 750;

/// The least speed in rad/s, the period in s and the greatest speed in rad/s of the steady cycle of a row under a hypothesis: by
/// equal steps of θ. None if there is no such motion.
pub fn cycle_of_row(hypothesis: &Hypothesis, row: &Row) -> Option<[f64; 3]> {
    let parameters = hypothesis.parameters(row)?;
    let unit = parameters.drive().sqrt();
    let [least, time, greatest] = cycle(&parameters, hypothesis.angle(row), STEPS)?;
    Some([least * unit, time / unit, greatest * unit])
}
