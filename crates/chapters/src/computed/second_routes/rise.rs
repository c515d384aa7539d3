//! A start from rest in equal steps of the crank, until it is the steady motion by one measure or another.

use super::motion::{SpeedAt, SteppedEngagement, SteppedPassage};

/// Engagements after which a start counts as one that never ends.
const MOST: usize = 3000;

/// A start from rest, beside the motion that it comes to.
pub(crate) struct SteppedRise<'a> {
    engagement: &'a SteppedEngagement,
    /// The engagement that repeats itself.
    pub steady: SteppedPassage<'a>,
}

impl<'a> SteppedRise<'a> {
    /// The start of an escapement; none if it has no steady motion.
    pub(crate) fn new(engagement: &'a SteppedEngagement) -> Option<Self> {
        Some(Self { engagement, steady: engagement.steady_passage()? })
    }

    /// The engagements from rest, one after the other, each with the time at which it begins.
    pub(crate) fn passages(&self) -> impl Iterator<Item = (f64, SteppedPassage<'a>)> {
        let (mut square, mut time) = (0.0, 0.0);
        let engagement = self.engagement;
        (0..MOST).map(move |_| {
            let (start, passage) = (time, engagement.passage(square));
            square = passage.end_square();
            time += passage.times().last().copied().unwrap_or(f64::NAN);
            (start, passage)
        })
    }

    /// Time from rest until the speed is within this part of the steady one, angle by angle, from then on.
    pub(crate) fn until_profile(&self, part: f64) -> Option<f64> {
        self.until_all_within(|steady| part * steady)
    }

    /// Time from rest until the speed is within what is allowed of the steady one, angle by angle, from then on.
    pub(crate) fn until_all_within(&self, allowed: impl Fn(f64) -> f64) -> Option<f64> {
        let steady = self.steady.speeds();
        let mut reached = 0.0;
        for (start, passage) in self.passages() {
            let over: Vec<f64> = passage
                .speeds()
                .iter()
                .zip(&steady)
                .map(|(speed, steady)| (speed - steady).abs() - allowed(*steady))
                .collect();
            let Some(last) = over.iter().rposition(|over| *over > 0.0) else { return Some(reached) };
            let times = passage.times();
            reached = start + times[last];
            if let Some(next) = times.get(last + 1) {
                reached += over[last] / (over[last] - over[last + 1]) * (next - times[last]);
            }
        }
        None
    }

    /// Time from rest until an engagement ends whose mean of least and greatest speed is within this part of the steady one.
    /// The start at rest is no least speed.
    pub(crate) fn until_average(&self, part: f64) -> Option<f64> {
        let steady = self.steady.mean_of_extremes();
        let mut passages = self.passages().enumerate().peekable();
        while let Some((count, (_, passage))) = passages.next() {
            let first = (count == 0).then(|| first_least(&passage)).flatten();
            let least = first.unwrap_or_else(|| passage.least_speed()).speed;
            if (f64::midpoint(least, passage.greatest_speed().speed) - steady).abs() <= part * steady {
                return passages.peek().map(|(_, (start, _))| *start);
            }
        }
        None
    }

    /// Engagements from rest until one begins with at least so large a part of the steady speed at entry.
    pub(crate) fn engagements_until_entry(&self, part: f64) -> Option<usize> {
        let enough = part * part * self.steady.squares[0];
        self.passages().position(|(_, passage)| passage.end_square() >= enough).map(|before| before + 1)
    }

    /// Whether least and greatest speed of each engagement, and each speed at entry but that at rest, are less than so much from
    /// the steady ones.
    pub(crate) fn is_steady_from_the_first_least(&self, difference: f64) -> Option<bool> {
        const LOOKED_AT: usize = 40;
        let steady =
            [self.steady.least_speed().speed, self.steady.greatest_speed().speed, self.steady.squares[0].sqrt()];
        for (count, (_, passage)) in self.passages().take(LOOKED_AT).enumerate() {
            let first = count == 0;
            let least = if first { first_least(&passage)? } else { passage.least_speed() }.speed;
            let entry = if first { steady[2] } else { passage.squares[0].sqrt() };
            let own = [least, passage.greatest_speed().speed, entry];
            if own.iter().zip(steady).any(|(own, steady)| (own - steady).abs() >= difference) {
                return Some(false);
            }
        }
        Some(true)
    }
}

/// The least speed of an engagement after its first greatest one.
pub(crate) fn first_least(passage: &SteppedPassage<'_>) -> Option<SpeedAt> {
    let speeds = passage.speeds();
    let at = speeds.windows(3).position(|three| three[1] < three[0] && three[1] <= three[2])?;
    let (before, here, after) = (speeds[at], speeds[at + 1], speeds[at + 2]);
    let (rise, bend) = ((after - before) / 2.0, after - 2.0 * here + before);
    let angles = passage.angles();
    let angle = angles[at + 1] - rise / bend * (angles[at + 1] - angles[at]);
    Some(SpeedAt { angle, speed: here - rise * rise / (2.0 * bend) })
}
