//! Where the driver is fastest and slowest.
//!
//! u is level where p u + f = 0, that is where 1 + N (1 + 2 ρ) u = 0, with N = (ρ + σ k) k and its sign turned round before
//! the line of centres.

use super::contact_reversal::{COARSE, STEPS};
use super::engagement::Engagement;
use super::passage::{ContactMode, Passage, Traversal};
use super::quadrature::{NODES, dot};
use crate::DynamicsError;

/// A greatest or least speed of the driver, and where it has it.
///
/// ```
/// use geneva_dynamics::steady::Engagement;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(0.1, 1.0)?, 1.0, 0.2)?;
/// let engagement = Engagement::new(&timer)?;
/// let passage = engagement.passage(2.0)?;
/// let [fastest, slowest] = passage.extremes();
/// assert!(slowest.speed < passage.mean_speed() && passage.mean_speed() < fastest.speed);
/// // Where the speed is least the driver has no acceleration: that is inside the engagement.
/// assert!(slowest.angle.abs() < timer.mechanism().engagement_half_angle()); // rad
/// assert!(timer.acceleration(slowest.angle, slowest.speed)?.value.abs() < 1e-6);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// θ', in radians per unit of time.
    pub speed: f64,
    /// θ, in radians from the line of centres.
    pub angle: f64,
    /// Time from the entry, in units of time.
    pub time: f64,
}

/// A place in a passage.
#[derive(Clone, Copy, Debug)]
struct Spot {
    traversal: usize,
    at: f64,
    square: f64,
    /// From the start of the traversal, in units of 1/√E.
    time: f64,
}

impl Passage<'_> {
    /// The greatest speed of the driver in this passage, its ends included.
    pub fn fastest(&self) -> Extreme {
        self.extreme(&self.spots(), |new, old| new > old)
    }

    /// The least speed of the driver in this passage, its ends included.
    pub fn slowest(&self) -> Extreme {
        self.extreme(&self.spots(), |new, old| new < old)
    }

    /// The greatest and the least speed of the driver in this passage, in this order, for the price of one.
    pub fn extremes(&self) -> [Extreme; 2] {
        let spots = self.spots();
        [self.extreme(&spots, |new, old| new > old), self.extreme(&spots, |new, old| new < old)]
    }

    fn extreme(&self, spots: &[Spot], better: impl Fn(f64, f64) -> bool) -> Extreme {
        let mut best: Option<Spot> = None;
        for spot in spots {
            if best.is_none_or(|best| better(spot.square, best.square)) {
                best = Some(*spot);
            }
        }
        // A passage has a traversal, and with it its two ends.
        best.map_or(Extreme { speed: f64::NAN, angle: f64::NAN, time: f64::NAN }, |spot| self.at_spot(spot))
    }

    /// The first place that is slower than those before and behind it.
    pub(super) fn first_valley(&self) -> Option<Extreme> {
        let mut spots = self.spots();
        spots.sort_by(|a, b| a.traversal.cmp(&b.traversal).then(a.time.total_cmp(&b.time)));
        let is_valley = |w: &&[Spot]| w[1].square < w[0].square && w[1].square < w[2].square;
        spots.windows(3).find(is_valley).map(|w| self.at_spot(w[1]))
    }

    /// The ends, and where the speed is level: times from the start, in units of 1/√E.
    pub(super) fn level_times(&self) -> Vec<f64> {
        let before =
            |spot: &Spot| self.traversals[..spot.traversal].iter().map(|traversal| traversal.duration).sum::<f64>();
        self.spots().iter().map(|spot| before(spot) + spot.time).collect()
    }

    fn at_spot(&self, spot: Spot) -> Extreme {
        let angle = self.engagement.circle.angle(spot.at);
        let angle = if self.traversals[spot.traversal].mode == ContactMode::Approach { -angle } else { angle };
        let before: f64 = self.traversals[..spot.traversal].iter().map(|traversal| traversal.duration).sum();
        Extreme { speed: self.speed(spot.square), angle, time: (before + spot.time) / self.engagement.unit }
    }

    /// The ends, and where u is level.
    fn spots(&self) -> Vec<Spot> {
        let mut spots = Vec::with_capacity(4);
        for (number, traversal) in self.traversals.iter().enumerate() {
            if number == 0 {
                spots.push(Spot { traversal: number, at: traversal.start(), square: traversal.ends[0], time: 0.0 });
            }
            if number + 1 == self.traversals.len() {
                spots.push(Spot {
                    traversal: number,
                    at: traversal.end(),
                    square: traversal.ends[1],
                    time: traversal.duration,
                });
            }
            self.level_spots(number, traversal, &mut spots);
        }
        spots
    }

    fn level_spots(&self, number: usize, traversal: &Traversal<'_>, spots: &mut Vec<Spot>) {
        let (nodes, mode, circle) = (&traversal.nodes, traversal.mode, &self.engagement.circle);
        let [low, high] =
            if mode == ContactMode::Approach { [traversal.ends[1], traversal.ends[0]] } else { traversal.ends };
        let (sigma, mirror) = (self.engagement.sigma(mode), mirror(mode));
        let slope_at = |w: f64, square: f64| {
            let place = circle.place(w);
            slope(sigma, mirror, place.rho, place.k, square)
        };
        let mut slopes = [0.0; NODES];
        for (index, value) in slopes.iter_mut().enumerate() {
            *value = slope(sigma, mirror, nodes.rho[index], nodes.k[index], traversal.squares[index]);
        }
        let place = |index: usize| nodes.w_at(self.engagement.rule.nodes[index]);
        let ends = [slope_at(nodes.low, low), slope_at(nodes.high, high)];
        // A bit for each place where u grows, the two ends included; then one for each change between neighbours.
        let mut growing = u32::from(ends[0] > 0.0) | u32::from(ends[1] > 0.0) << (NODES + 1);
        for (index, slope) in slopes.iter().enumerate() {
            growing |= u32::from(*slope > 0.0) << (index + 1);
        }
        let mut changes = (growing ^ (growing >> 1)) & ((1 << (NODES + 1)) - 1);
        while changes != 0 {
            let index = changes.trailing_zeros() as usize;
            changes &= changes - 1;
            let from = if index == 0 { (nodes.low, ends[0]) } else { (place(index - 1), slopes[index - 1]) };
            let to = if index == NODES { (nodes.high, ends[1]) } else { (place(index), slopes[index]) };
            spots.push(self.level(number, traversal, from, to));
        }
    }

    /// The place between two, each with the slope there, at which u is level.
    fn level(&self, number: usize, traversal: &Traversal<'_>, low: (f64, f64), high: (f64, f64)) -> Spot {
        let rising = low.1 > 0.0;
        let (first, last, width) = (low.0, high.0, traversal.nodes.high - traversal.nodes.low);
        let (sigma, mirror, enough) =
            (self.engagement.sigma(traversal.mode), mirror(traversal.mode), self.engagement.fine());
        // Where the straight line is level.
        let start = first + (last - first) * (low.1 / (low.1 - high.1));
        let (mut low, mut high) = (first, last);
        let (mut w, mut refining) = (start.clamp(first, last), false);
        for _ in 0..STEPS {
            let (square, time) = if refining {
                self.partial_traversal(number, w)
            } else {
                (dot(&traversal.nodes.shares(self.engagement.rule, w), &traversal.squares), 0.0)
            };
            let place = self.engagement.circle.place(w);
            let (rho, k, angular_velocity) = (place.rho, place.k, place.angular_velocity());
            let value = slope(sigma, mirror, rho, k, square);
            // Its rate by w where u is level.
            let both = (rho + sigma * k) * k;
            let across = rho - self.engagement.circle.centre;
            let change = -k * k + rho * across + 2.0 * sigma * k * across;
            let rate = (change * angular_velocity - 2.0 * k * both) * place.jacobian;
            let rate = mirror * square * rate;
            let next = w - value / rate;
            let moved = next - w;
            if refining && libm::fabs(moved) <= enough * width {
                let pace = place.jacobian / angular_velocity / square.sqrt();
                let late = mirror * moved;
                // u is level to the second order of the step.
                return Spot { traversal: number, at: next, square, time: time + late * pace };
            }
            if !refining {
                *(if (value > 0.0) == rising { &mut low } else { &mut high }) = w;
            }
            let inside = next >= low && next <= high;
            refining |= inside && libm::fabs(moved) <= COARSE * width;
            w = if inside || refining { next.clamp(first, last) } else { low + (high - low) / 2.0 };
        }
        let (square, time) = self.partial_traversal(number, w);
        Spot { traversal: number, at: w, square, time }
    }
}

/// −1 before the line of centres, in the mirror image that w ≥ 0 is.
fn mirror(mode: ContactMode) -> f64 {
    if mode == ContactMode::Approach { -1.0 } else { 1.0 }
}

/// 1 + N (1 + 2 ρ) u at a place, with N's sign turned round in the mirror image.
#[inline]
fn slope(sigma: f64, mirror: f64, rho: f64, k: f64, square: f64) -> f64 {
    let both = (rho + sigma * k) * k;
    1.0 + mirror * (both * (1.0 + 2.0 * rho) * square)
}

/// Engagements within which there must be one. One is enough: past the line of centres the follower drives the driver.
const LOOKED_AT: usize = 4;

impl Engagement {
    /// The first place from rest where the speed stops falling and rises again, with the time from the start; none if
    /// there is none in the first engagements.
    ///
    /// It is not the least speed of an engagement, which from rest is zero at the start. Meyer 1973, chapter II, takes
    /// it for the end of the rise.
    ///
    /// ```
    /// use geneva_dynamics::steady::Engagement;
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    ///
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(0.1, 1.0)?, 1.0, 0.2)?;
    /// let first = Engagement::new(&timer)?.first_minimum()?.expect("a light driver is slowed by the follower");
    /// // The speed is level there.
    /// assert!(timer.acceleration(first.angle, first.speed)?.value.abs() < 1e-6);
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Engagement::new`].
    pub fn first_minimum(&self) -> Result<Option<Extreme>, DynamicsError> {
        let engagement = self.refine()?;
        let (mut square, mut time) = (0.0, 0.0);
        for _ in 0..LOOKED_AT {
            let passage = engagement.pass(square);
            if let Some(lowest) = passage.first_valley() {
                return Ok(Some(Extreme { time: time + lowest.time, ..lowest }));
            }
            time += passage.duration();
            square = passage.end;
        }
        Ok(None)
    }
}
