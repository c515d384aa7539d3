//! The start from rest, engagement by engagement.
//!
//! "Rise time to 99 %" needs a definition: of what, and counted to when. Each that is offered here has its own name, and
//! [`RiseMeasure`] lists those of which books and programs may speak.

use super::engagement::Engagement;
use super::extremes::Extreme;
use super::passage::{ContactMode, Passage, Traversal};
use super::quadrature::dot;
use super::steady_state::SteadyState;
use crate::DynamicsError;
use geneva_kinematics::bisection::bisect_times;

/// One engagement of a start from rest. Times are from the start, speeds the driver's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RiseCycle {
    /// When it starts, in units of time.
    pub start: f64,
    /// When it ends, in units of time.
    pub end: f64,
    /// Speed at its start, in radians per unit of time.
    pub entry_speed: f64,
    /// Speed at its end, in radians per unit of time.
    pub end_speed: f64,
    /// Greatest speed in the engagement, with the time from the start of the run.
    pub peak: Extreme,
    /// Least speed in the engagement, with the time from the start of the run.
    pub minimum: Extreme,
    /// Reset angle over duration, in radians per unit of time.
    pub mean_speed: f64,
}

/// A start from rest until nothing changes by more than the tolerance any more.
///
/// ```
/// use geneva_dynamics::steady::Engagement;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// let engagement = Engagement::new(&timer)?;
/// let rise = engagement.rise(0.001)?; // until the speed is within 0.1 % of the steady one
/// assert_eq!(rise.cycles[0].entry_speed, 0.0); // from rest
/// assert!(rise.cycles.windows(2).all(|two| two[0].entry_speed < two[1].entry_speed));
/// assert!(rise.until_entry_speed(0.1) < rise.until_entry_speed(0.01)); // to within 10 % it takes less time
/// let last = rise.cycles.last().expect("a cycle");
/// assert_eq!(engagement.engagements_to_settle(0.001)?, (rise.cycles.len(), last.end));
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Rise {
    /// The steady state that is approached.
    pub steady: SteadyState,
    /// The engagements, in order, until the speed at the end is within `settled` of the steady one.
    pub cycles: Vec<RiseCycle>,
}

/// What tells that a start from rest is over: the measures of a rise time, each with the name by which it is called.
///
/// ```
/// use geneva_dynamics::steady::RiseMeasure;
///
/// assert_eq!(RiseMeasure::ALL.map(RiseMeasure::name), ["profile", "average", "entry speed", "small difference"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RiseMeasure {
    /// The speed at every crank angle is the steady one from then on.
    Profile,
    /// An engagement is over whose mean of peak and minimum is the steady one.
    Average,
    /// An engagement begins at the steady entry speed.
    EntrySpeed,
    /// A small difference of two motions has fallen to the part that may be left.
    SmallDifference,
}

impl RiseMeasure {
    /// All measures.
    pub const ALL: [Self; 4] = [Self::Profile, Self::Average, Self::EntrySpeed, Self::SmallDifference];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Profile => "profile",
            Self::Average => "average",
            Self::EntrySpeed => "entry speed",
            Self::SmallDifference => "small difference",
        }
    }

    /// What it measures, to one per cent, in words.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Profile => {
                "time from rest until the speed at every angle is within 1 % of its steady value from then on"
            }
            Self::Average => {
                "time from rest until the end of the first engagement whose mean of peak and minimum is within 1 % of \
                 its steady value"
            }
            Self::EntrySpeed => {
                "time from rest until an engagement begins with at least 99 % of the entry speed of the steady state"
            }
            Self::SmallDifference => "time in which a small difference from the steady motion falls to 1 % of its size",
        }
    }
}

/// Most engagements of a [`Rise`].
pub const MOST_CYCLES: usize = 100_000;

/// Places of each traversal at which two velocity profiles are compared.
const PLACES: u32 = 32;

/// Halvings of the way between two of them.
const HALVINGS: u32 = 40;

impl Engagement {
    /// The start from rest, at entry, until the speed at an end is within a relative `settled` (between 0 and 1) of the
    /// steady state's entry speed.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]; [`DynamicsError::OutOfRange`] if `settled` is not between 0 and 1;
    /// [`DynamicsError::TooMany`] if [`MOST_CYCLES`] are not enough.
    pub fn rise(&self, settled: f64) -> Result<Rise, DynamicsError> {
        let mut cycles = Vec::new();
        let (steady, ..) = self.settle(settled, MOST_CYCLES, |square, start| {
            let passage = self.pass(square);
            let duration = passage.duration();
            let [peak, minimum] = passage.extremes().map(|extreme| Extreme { time: start + extreme.time, ..extreme });
            cycles.push(RiseCycle {
                start,
                end: start + duration,
                entry_speed: passage.entry_speed(),
                end_speed: passage.end_speed(),
                peak,
                minimum,
                mean_speed: self.reset() / duration,
            });
            (passage.end, duration)
        })?;
        Ok(Rise { steady, cycles })
    }

    /// Engagements from rest until the speed at the end is within a relative `settled` (between 0 and 1) of the steady one, and
    /// the time, in units of time.
    ///
    /// # Errors
    ///
    /// The errors of [`Engagement::rise`].
    pub fn engagements_to_settle(&self, settled: f64) -> Result<(usize, f64), DynamicsError> {
        self.engagements_to_settle_within(settled, MOST_CYCLES)
    }

    /// Engagements from rest as by [`Engagement::engagements_to_settle`], `most` of them at most, and the time, in units of time.
    ///
    /// # Errors
    ///
    /// The errors of [`Engagement::rise`]; [`DynamicsError::TooMany`] if `most` engagements are not enough.
    pub fn engagements_to_settle_within(&self, settled: f64, most: usize) -> Result<(usize, f64), DynamicsError> {
        let (_, count, time) = self.settle(settled, most, |square, _| self.end_of(square))?;
        Ok((count, time))
    }

    /// Goes from rest through one engagement after another until the speed at an end is within a relative `settled` of the steady
    /// one: the steady state, how many engagements and how long.
    ///
    /// `pass` goes through an engagement: from u at its start and the time there to u at its end and how long it takes.
    fn settle(
        &self,
        settled: f64,
        most: usize,
        mut pass: impl FnMut(f64, f64) -> (f64, f64),
    ) -> Result<(SteadyState, usize, f64), DynamicsError> {
        if !(settled > 0.0 && settled < 1.0) {
            return Err(DynamicsError::OutOfRange { name: "settled part", asked: settled, least: 0.0, most: 1.0 });
        }
        let steady = self.steady_state()?;
        let (mut time, mut square) = (0.0, 0.0);
        for count in 1..=most {
            let (end, duration) = pass(square, time);
            (square, time) = (end, time + duration);
            if near(self.unit * square.sqrt(), steady.entry_speed, settled) {
                return Ok((steady, count, time));
            }
        }
        Err(DynamicsError::TooMany { name: "engagements", limit: most })
    }

    /// When a start from rest has taken on the steady velocity profile: from then on the driver's speed at every crank
    /// angle is within a relative `part` (between 0 and 1) of the steady one there. In units of time.
    ///
    /// Of two motions the one that is faster at entry is faster at every angle, so the departures fall from engagement
    /// to engagement, and the first one without a departure is the last that has to be looked at. Meyer 1973, chapter II,
    /// lets the rise end when the profile of the driver's velocity is the steady one.
    ///
    /// ```
    /// use geneva_dynamics::steady::Engagement;
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    ///
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
    /// let engagement = Engagement::new(&timer)?;
    /// // To within 1 % it takes longer than to within 10 %, in units of time.
    /// assert!(engagement.until_profile(0.01)? > engagement.until_profile(0.1)?);
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]; [`DynamicsError::OutOfRange`] if `part` is not between 0 and 1; [`DynamicsError::TooMany`] if
    /// [`MOST_CYCLES`] engagements are not enough.
    pub fn until_profile(&self, part: f64) -> Result<f64, DynamicsError> {
        self.until_profile_in(part, MOST_CYCLES)
    }

    /// When the profile is the steady one, as by [`Engagement::until_profile`], in `most` engagements at most. In units of time.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::until_profile`]; [`DynamicsError::TooMany`] if `most` engagements are not enough.
    pub fn until_profile_in(&self, part: f64, most: usize) -> Result<f64, DynamicsError> {
        if !(part > 0.0 && part < 1.0) {
            return Err(DynamicsError::OutOfRange { name: "part", asked: part, least: 0.0, most: 1.0 });
        }
        self.until_all(most, |speed, steady| near(speed, steady, part))
    }

    /// When a start from rest has taken on the steady velocity profile, to one difference at all angles: from then on the
    /// driver's speed at every crank angle is within `difference` (above zero, in radians per unit of time) of the steady
    /// one there. In units of time.
    ///
    /// ```
    /// use geneva_dynamics::steady::Engagement;
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    ///
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
    /// let engagement = Engagement::new(&timer)?;
    /// let steady = engagement.steady_state()?;
    /// // One per cent of the greatest speed allows more than one per cent of each speed, and one of the least less.
    /// let [most, least] = [steady.peak, steady.minimum].map(|extreme| 0.01 * extreme.speed);
    /// assert!(engagement.until_profile_within(most)? <= engagement.until_profile(0.01)?);
    /// assert!(engagement.until_profile_within(least)? >= engagement.until_profile(0.01)?);
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Engagement::until_profile`], with the difference for the part, which has no greatest value.
    pub fn until_profile_within(&self, difference: f64) -> Result<f64, DynamicsError> {
        if !(difference > 0.0 && difference.is_finite()) {
            return Err(DynamicsError::OutOfRange {
                name: "difference",
                asked: difference,
                least: 0.0,
                most: f64::INFINITY,
            });
        }
        self.until_all(MOST_CYCLES, |speed, steady| (speed - steady).abs() <= difference)
    }

    /// When a start from rest is near the steady motion at all angles from then on; each speed beside the steady one at its
    /// angle. In units of time.
    fn until_all(&self, most: usize, is_near: impl Fn(f64, f64) -> bool) -> Result<f64, DynamicsError> {
        let engagement = self.refine()?;
        let repeated = engagement.fixed_point()?;
        let steady = engagement.pass_with(repeated.entry, repeated.split.as_ref());
        let (mut square, mut time, mut reached) = (0.0, 0.0, 0.0);
        for _ in 0..most {
            let passage = engagement.pass(square);
            match passage.last_departure(&steady, &is_near) {
                Some(since) => reached = time + since,
                None => return Ok(reached),
            }
            time += passage.duration();
            square = passage.end;
        }
        Err(DynamicsError::TooMany { name: "engagements", limit: most })
    }

    /// When a start from rest has come to the steady average: the end of the first engagement whose mean of peak and minimum
    /// is within a relative `part` (between 0 and 1) of the steady one, of `most` engagements at most. In units of time.
    ///
    /// In the first engagement, the minimum is the least speed after the first peak, for the start at rest is no minimum.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::until_profile_in`].
    pub fn until_average_in(&self, part: f64, most: usize) -> Result<f64, DynamicsError> {
        if !(part > 0.0 && part < 1.0) {
            return Err(DynamicsError::OutOfRange { name: "part", asked: part, least: 0.0, most: 1.0 });
        }
        let (steady, first) = (self.steady_state()?.mean_of_extremes(), self.first_minimum()?);
        let (mut square, mut time) = (0.0, 0.0);
        for count in 0..most {
            let passage = self.pass(square);
            let ([peak, minimum], duration) = (passage.extremes(), passage.duration());
            let own = first.filter(|first| count == 0 && first.time < duration).unwrap_or(minimum);
            (square, time) = (passage.end, time + duration);
            if near(f64::midpoint(peak.speed, own.speed), steady, part) {
                return Ok(time);
            }
        }
        Err(DynamicsError::TooMany { name: "engagements", limit: most })
    }
}

/// Whether a speed is within a relative part of another.
fn near(speed: f64, steady: f64, part: f64) -> bool {
    (speed - steady).abs() <= part * steady
}

impl Rise {
    /// The first engagement of which a speed is within `part` of the steady one.
    fn first(&self, part: f64, steady: f64, speed: fn(&RiseCycle) -> f64) -> Option<&RiseCycle> {
        self.cycles.iter().find(|cycle| near(speed(cycle), steady, part))
    }

    /// When the first engagement starts at a speed within `part` of the steady entry speed, in units of time.
    pub fn until_entry_speed(&self, part: f64) -> Option<f64> {
        let steady = self.steady.entry_speed;
        let last = self.cycles.last().filter(|cycle| near(cycle.end_speed, steady, part));
        let first = self.first(part, steady, |cycle| cycle.entry_speed);
        first.map(|cycle| cycle.start).or(last.map(|cycle| cycle.end))
    }

    /// When the first engagement ends whose mean speed is within `part` of the steady one, in units of time.
    pub fn until_mean_speed(&self, part: f64) -> Option<f64> {
        self.first(part, self.steady.mean_speed, |cycle| cycle.mean_speed).map(|cycle| cycle.end)
    }

    /// When the driver is first at a greatest speed of an engagement that is within `part` of the steady one, in units
    /// of time.
    pub fn until_peak(&self, part: f64) -> Option<f64> {
        self.first(part, self.steady.peak.speed, |cycle| cycle.peak.speed).map(|cycle| cycle.peak.time)
    }

    /// When the driver is first, not counting the start, at a least speed of an engagement within `part` of the steady
    /// one, in units of time.
    pub fn until_minimum(&self, part: f64) -> Option<f64> {
        self.first(part, self.steady.minimum.speed, |cycle| cycle.minimum.speed).map(|cycle| cycle.minimum.time)
    }

    /// When the driver is slowest in its second engagement, in units of time: the first minimum after a hand-over.
    pub fn until_first_minimum(&self) -> Option<f64> {
        self.cycles.get(1).map(|cycle| cycle.minimum.time)
    }
}

impl Passage<'_> {
    /// Time from the start of this passage to the last place where its speed is not near another's at the same angle, in
    /// units of time; none if it is near everywhere.
    fn last_departure(&self, other: &Self, is_near: impl Fn(f64, f64) -> bool) -> Option<f64> {
        let (rule, unit) = (self.engagement.rule, self.engagement.unit);
        // The place that was looked at before, later in the motion: its traversal and its w.
        let mut later: Option<(usize, f64)> = None;
        for (number, traversal) in self.traversals.iter().enumerate().rev() {
            let mirrored = traversal.mode == ContactMode::Approach;
            let departs = |s: f64| {
                let w = traversal.nodes.w_at(s);
                let there = other.square_at(w, mirrored);
                let speeds = [traversal.square_between(rule, s), there].map(|square| unit * square.sqrt());
                !is_near(speeds[0], speeds[1])
            };
            for place in 0..=PLACES {
                // Backwards in the motion.
                let back = 1.0 - 2.0 * f64::from(place) / f64::from(PLACES);
                let s = if mirrored { -back } else { back };
                if !departs(s) {
                    later = Some((number, s));
                    continue;
                }
                let ends = [s, later.map_or(s, |(at, later)| if at == number { later } else { s })];
                let [last, _] = bisect_times(HALVINGS, ends, &departs);
                let (_, since) = self.partial_traversal(number, traversal.nodes.w_at(last));
                let before: f64 = self.traversals[..number].iter().map(|traversal| traversal.duration).sum();
                return Some((before + since) / self.engagement.unit);
            }
        }
        None
    }

    /// u at w, on the way to the line of centres or past it.
    fn square_at(&self, w: f64, mirrored: bool) -> f64 {
        let own = |of: &&Traversal<'_>| (of.mode == ContactMode::Approach) == mirrored;
        let found = self.traversals.iter().filter(own).find(|of| of.nodes.low <= w && w <= of.nodes.high);
        found.map_or(f64::NAN, |of| dot(&of.nodes.shares(self.engagement.rule, w), &of.squares))
    }
}
