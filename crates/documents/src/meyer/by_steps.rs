//! The motion of each mechanism with each friction of the runs, from rest, by equal steps of the driver's angle.
//!
//! The second route of chapter II's statements: nothing here uses the solution by integrals. One motion stands for all
//! torques of a group, those of a row are it with other scales: see [`Group::scale`].

use super::runs::table::rows;
use geneva_case1973::witness::steps::Course;
use geneva_case1973::{Hypothesis, Row, series};
use geneva_dynamics::{Coefficients, Parameters};
use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

/// The runs of one mechanism with one friction.
pub(super) struct Group {
    /// The rows, by rising torque.
    pub rows: &'static [Row],
    /// The motion of the first row.
    pub motion: Motion,
}

impl Group {
    /// By how much a row's speeds are greater than the first row's, and its times less: the root of the torques.
    pub(super) fn scale(&self, row: &Row) -> f64 {
        self.rows.first().map_or(f64::NAN, |first| (row.torque() / first.torque()).sqrt())
    }

    /// The scale of the row with the greatest torque.
    pub(super) fn greatest_scale(&self) -> f64 {
        self.rows.iter().map(|row| self.scale(row)).fold(0.0, f64::max)
    }
}

/// All twelve groups, for the mechanisms as they are.
pub(super) fn groups() -> &'static [Group] {
    static GROUPS: OnceLock<Vec<Group>> = OnceLock::new();
    GROUPS.get_or_init(|| {
        let group = |rows: &'static [Row]| {
            let motion = Motion::of(&Hypothesis::IDEAL.parameters(rows.first()?)?)?;
            Some(Group { rows, motion })
        };
        series(rows()).filter_map(group).collect()
    })
}

/// A start from rest until an engagement repeats the one before.
#[derive(Clone)]
pub struct Motion {
    /// The escapement.
    pub parameters: Parameters,
    /// The driver's angles from the line of centres, the same in each engagement.
    pub angles: Arc<[f64]>,
    course: Course,
    /// The engagements, in order.
    pub engagements: Vec<Engagement>,
}

/// One engagement of a motion, at each of its angles.
#[derive(Clone)]
pub struct Engagement {
    /// The square of the driver's speed.
    pub squares: Vec<f64>,
    /// The time from the start of the motion.
    pub times: Vec<f64>,
}

/// Steps of an engagement: an even number, so that the friction changes its sign on the line of centres between two.
const STEPS: u32 = 900;

/// Most engagements, and the change of the square of the speed in an engagement from which on it counts as repeated.
const MOST: usize = 200;
const REPEATED: f64 = 1e-12;

impl Motion {
    /// A motion from rest; the motion of a group of runs is not made again. None if it does not come to repeat itself.
    pub fn repeating(parameters: &Parameters) -> Option<Cow<'static, Self>> {
        let known = groups().iter().map(|group| &group.motion).find(|motion| motion.parameters == *parameters);
        known.map(Cow::Borrowed).or_else(|| Self::of(parameters).map(Cow::Owned))
    }

    /// A motion from rest until it repeats itself, computed now.
    fn of(parameters: &Parameters) -> Option<Self> {
        let mut motion = Self::from_rest(parameters, 1);
        for _ in 0..MOST {
            let last = motion.engagements.last()?;
            if last.change().abs() <= REPEATED {
                return Some(motion);
            }
            motion.go_on();
        }
        None
    }

    /// A motion of so many engagements from rest, at least one.
    pub fn from_rest(parameters: &Parameters, engagements: usize) -> Self {
        let reset = 2.0 * parameters.mechanism().engagement_half_angle();
        let course = Course::of_engagement(parameters, reset, STEPS);
        let angles = Arc::clone(&course.angles);
        let mut motion = Self { parameters: *parameters, angles, course, engagements: Vec::new() };
        motion.enter(0.0, 0.0);
        for _ in 1..engagements {
            motion.go_on();
        }
        motion
    }

    /// Adds an engagement that goes on from the last one.
    fn go_on(&mut self) {
        let Some(last) = self.engagements.last() else { return };
        let (square, time) = (last.end(), last.finish());
        self.enter(square, time);
    }

    /// Adds an engagement with this square of the speed at its start, which is at this time.
    fn enter(&mut self, square: f64, start: f64) {
        let squares = self.course.squares(square);
        let slopes: Vec<f64> =
            self.course.coefficients().iter().zip(&squares).map(|(terms, u)| slope(terms, *u)).collect();
        let mut times = vec![start];
        for k in 1..squares.len() {
            let step = self.angles[k] - self.angles[k - 1];
            let piece = [squares[k - 1], step * slopes[k - 1], step * slopes[k], squares[k]];
            times.push(times[k - 1] + step * root_mean(piece));
        }
        self.engagements.push(Engagement { squares, times });
    }

    /// The engagement that repeats itself.
    pub fn steady(&self) -> Option<&Engagement> {
        self.engagements.last()
    }

    /// The turning points of a quantity of angle and speed within an engagement, in order, by the parabola through
    /// three neighbours.
    pub fn turns(&self, engagement: &Engagement, of: impl Fn(f64, f64) -> f64) -> Vec<Turning> {
        let values: Vec<f64> = self.values(engagement, of);
        let mut found = Vec::new();
        for k in 1..values.len().saturating_sub(1) {
            let [before, after] = [values[k] - values[k - 1], values[k + 1] - values[k]];
            if before * after < 0.0 {
                let part = (before + after) / (before - after) / 2.0;
                let between =
                    |of: &[f64]| of[k] + part * if part > 0.0 { of[k + 1] - of[k] } else { of[k] - of[k - 1] };
                found.push(Turning {
                    angle: between(&self.angles),
                    time: between(&engagement.times),
                    value: values[k] + (before + after) * part / 4.0,
                    is_greatest: before > 0.0,
                });
            }
        }
        found
    }

    /// The greatest value of a quantity in an engagement, at a turning point or an end.
    pub fn greatest(&self, engagement: &Engagement, of: impl Fn(f64, f64) -> f64 + Copy) -> Turning {
        let values = self.values(engagement, of);
        let end = |k: usize| Turning {
            angle: self.angles[k],
            time: engagement.times[k],
            value: values[k],
            is_greatest: true,
        };
        let turns = self.turns(engagement, of).into_iter().filter(|turning| turning.is_greatest);
        let ends = [end(0), end(values.len() - 1)];
        turns.chain(ends).fold(end(0), |best, next| if next.value > best.value { next } else { best })
    }

    /// The driver's least speed between the ends of an engagement, and where it is.
    pub fn least(&self, engagement: &Engagement) -> Option<Turning> {
        let turns = self.turns(engagement, |_, speed| speed).into_iter();
        turns.filter(|turning| !turning.is_greatest).min_by(|a, b| a.value.total_cmp(&b.value))
    }

    /// A quantity of angle and speed at each angle.
    pub fn values(&self, engagement: &Engagement, of: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        self.angles.iter().zip(&engagement.squares).map(|(angle, u)| of(*angle, u.max(0.0).sqrt())).collect()
    }

    /// The follower's speed, for [`Motion::turns`].
    pub fn follower(&self) -> impl Fn(f64, f64) -> f64 + Copy {
        let parameters = self.parameters;
        move |angle, speed| speed * parameters.pose(angle).velocity_ratio()
    }
}

/// A place where a quantity is greater than before and behind it, or less.
#[derive(Clone, Copy, Debug)]
pub struct Turning {
    /// The driver's angle from the line of centres.
    pub angle: f64,
    /// The time from the start of the motion.
    pub time: f64,
    /// The quantity.
    pub value: f64,
    /// Whether it is greater there.
    pub is_greatest: bool,
}

impl Engagement {
    /// The square of the speed at the end.
    pub fn end(&self) -> f64 {
        self.squares.last().copied().unwrap_or(f64::NAN)
    }

    /// Speeds at the start and at the end.
    pub fn ends(&self) -> [f64; 2] {
        [self.squares.first().copied().unwrap_or(f64::NAN).sqrt(), self.end().sqrt()]
    }

    /// By how much the square of the speed changes, over the one at the end.
    fn change(&self) -> f64 {
        self.squares.first().map_or(f64::NAN, |first| 1.0 - first / self.end())
    }

    /// The time at the end.
    pub fn finish(&self) -> f64 {
        self.times.last().copied().unwrap_or(f64::NAN)
    }

    /// How long the engagement lasts.
    pub fn duration(&self) -> f64 {
        self.finish() - self.times.first().copied().unwrap_or(f64::NAN)
    }
}

/// du/dθ, which is twice the acceleration.
fn slope(terms: &Coefficients<f64>, square: f64) -> f64 {
    let found = terms.acceleration(square.max(0.0).sqrt());
    found.map_or(f64::NAN, |acceleration| 2.0 * acceleration.value)
}

/// The mean of 1/√u over a step, with u by the cubic through two values and, between them, the two slopes per step.
///
/// With the square of a number for the part of the step, so that it may begin at rest, where u grows in proportion.
fn root_mean([from, rise, fall, to]: [f64; 4]) -> f64 {
    let u = |s: f64| {
        let rest = 1.0 - s;
        rest * rest * ((1.0 + 2.0 * s) * from + s * rise) + s * s * ((1.0 + 2.0 * rest) * to - rest * fall)
    };
    // The rule of Gauss with five points.
    let [near, far] = [0.538_469_310_105_683_1, 0.906_179_845_938_664];
    let weights = [0.236_926_885_056_189_1, 0.478_628_670_499_366_5, 0.568_888_888_888_888_9];
    let points = [(-far, weights[0]), (-near, weights[1]), (0.0, weights[2]), (near, weights[1]), (far, weights[0])];
    points.iter().map(|(x, weight)| (f64::midpoint(1.0, *x), weight)).map(|(y, w)| w * y / u(y * y).sqrt()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn approx(found: f64, expected: f64, within: f64) {
        assert!((found - expected).abs() <= within, "{found}, not {expected}");
    }

    #[test]
    fn a_step_from_rest_and_one_in_motion_take_their_times() {
        // u = 4 s: the root is twice that of s, and the time is one; u = (1 + s)²: ln 2.
        approx(root_mean([0.0, 4.0, 4.0, 4.0]), 1.0, 1e-14);
        approx(root_mean([1.0, 2.0, 4.0, 4.0]), std::f64::consts::LN_2, 1e-5);
    }

    #[test]
    fn there_are_twelve_groups_and_they_agree_with_the_integrals() {
        assert_eq!(groups().len(), 12);
        for group in groups() {
            let solved = Hypothesis::IDEAL.engagement(&group.rows[0]).expect("an escapement").steady_state();
            let (solved, steady) = (solved.expect("a steady state"), group.motion.steady().expect("an engagement"));
            let least = group.motion.least(steady).expect("a least speed");
            let peak = group.motion.greatest(steady, |_, speed| speed);
            approx(steady.duration() / solved.period, 1.0, 1e-5);
            approx(least.value / solved.minimum.speed, 1.0, 1e-5);
            approx(peak.value / solved.peak.speed, 1.0, 1e-5);
            approx(least.angle, solved.minimum.angle, 1e-5);
            approx(peak.angle, solved.peak.angle, 1e-4);
        }
    }
}
