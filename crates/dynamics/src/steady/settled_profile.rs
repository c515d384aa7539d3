//! When a start from rest has taken on the speeds of the steady motion, angle by angle.

use super::engagement::Engagement;
use super::passage::{ContactMode, Passage};
use super::quadrature::dot;
use super::rise::MOST_CYCLES;
use crate::Error;

/// Places of each traversal at which two motions are compared.
const PLACES: u32 = 32;

/// Halvings of the way between two of them.
const HALVINGS: u32 = 40;

impl Engagement {
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
    /// # Ok::<(), geneva_dynamics::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]; [`Error::OutOfRange`] if `part` is not between 0 and 1; [`Error::TooMany`] if
    /// [`MOST_CYCLES`] engagements are not enough.
    pub fn until_profile(&self, part: f64) -> Result<f64, Error> {
        if !(part > 0.0 && part < 1.0) {
            return Err(Error::OutOfRange { name: "part", asked: part, least: 0.0, most: 1.0 });
        }
        let engagement = self.refined()?;
        let repeated = engagement.fixed_point()?;
        let steady = engagement.pass_with(repeated.entry, repeated.split.as_ref());
        let (mut square, mut time, mut reached) = (0.0, 0.0, 0.0);
        for _ in 0..MOST_CYCLES {
            let passage = engagement.pass(square);
            match passage.last_departure(&steady, part) {
                Some(since) => reached = time + since,
                None => return Ok(reached),
            }
            time += passage.duration();
            square = passage.end;
        }
        Err(Error::TooMany { name: "engagements", limit: MOST_CYCLES })
    }
}

impl Passage<'_> {
    /// Time from the start of this passage to the last place where its speed departs by more than a part from another's
    /// at the same angle, in units of time; none if it nowhere does.
    fn last_departure(&self, other: &Self, part: f64) -> Option<f64> {
        let rule = self.engagement.rule;
        // The place that was looked at before, later in the motion: its traversal and its w.
        let mut later: Option<(usize, f64)> = None;
        for (number, traversal) in self.traversals.iter().enumerate().rev() {
            let mirrored = traversal.mode == ContactMode::Approach;
            let departs = |s: f64| {
                let w = traversal.nodes.at(s);
                let there = other.square_at(w, mirrored);
                let off = libm::fabs((traversal.square_between(rule, s) / there).sqrt() - 1.0);
                off > part || off.is_nan()
            };
            for place in 0..=PLACES {
                // Backwards in the motion.
                let back = 1.0 - 2.0 * f64::from(place) / f64::from(PLACES);
                let s = if mirrored { -back } else { back };
                if !departs(s) {
                    later = Some((number, s));
                    continue;
                }
                let mut ends = [s, later.map_or(s, |(at, later)| if at == number { later } else { s })];
                for _ in 0..HALVINGS {
                    let middle = f64::midpoint(ends[0], ends[1]);
                    ends[usize::from(!departs(middle))] = middle;
                }
                let (_, since) = self.within(number, traversal.nodes.at(ends[0]));
                let before: f64 = self.traversals[..number].iter().map(|traversal| traversal.duration).sum();
                return Some((before + since) / self.engagement.unit);
            }
        }
        None
    }

    /// u at w, on the way to the line of centres or past it.
    fn square_at(&self, w: f64, mirrored: bool) -> f64 {
        let own = |of: &&super::passage::Traversal<'_>| (of.mode == ContactMode::Approach) == mirrored;
        let found = self.traversals.iter().filter(own).find(|of| of.nodes.low <= w && w <= of.nodes.high);
        found.map_or(f64::NAN, |of| dot(&of.nodes.shares(self.engagement.rule, w), &of.squares))
    }
}
