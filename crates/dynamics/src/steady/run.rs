//! The motion at times: a run from rest on a print grid, and the steady cycle instant by instant.

use super::engagement::Engagement;
use super::passage::{ContactMode, Passage, Traversal};
use super::quadrature::{GaussLegendre, NodalValues, dot};
use super::subinterval::NodeMapping;
use crate::DynamicsError;

/// One printed line of a run.
///
/// ```
/// use geneva_dynamics::steady::Engagement;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let (driver_inertia, torque) = (2.0, 1.0); // kg m², N m
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(driver_inertia, 1.0)?, torque, 0.2)?;
/// let lines = Engagement::new(&timer)?.run(0.01, 0.1)?; // every 0.01 s, to 0.1 s
/// assert_eq!(lines.len(), 11);
/// assert!(lines[0].speed < 1e-15); // from rest
/// // It starts with the acceleration of the driver alone.
/// let turned = torque / driver_inertia * 0.01 * 0.01 / 2.0; // rad
/// assert!((lines[1].turned / turned - 1.0).abs() < 1e-3);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrintedLine {
    /// Time from the start, in units of time.
    pub time: f64,
    /// Angle in radians through which the driver has turned.
    pub turned: f64,
    /// Crank angle in radians from the line of centres.
    pub angle: f64,
    /// Driver's speed θ', in radians per unit of time.
    pub speed: f64,
    /// Driver's acceleration θ'', in radians per square of the unit of time.
    pub acceleration: f64,
    /// Follower's speed φ', in radians per unit of time.
    pub follower_speed: f64,
    /// Number of the engagement, from 0.
    pub engagement: usize,
}

/// Most lines of a run.
pub const MOST_PRINTED: usize = 1_000_000;

impl Engagement {
    /// A run from rest, at entry, printed at each multiple of an interval up to a duration, both in units of time.
    ///
    /// The exact motion: no step of time is made, so that nothing but the rounding depends on the interval.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::new`]; [`DynamicsError::NotPositive`] for an interval or duration that is not positive and finite;
    /// [`DynamicsError::TooMany`] for more than [`MOST_PRINTED`] lines or engagements.
    pub fn run(&self, interval: f64, duration: f64) -> Result<Vec<PrintedLine>, DynamicsError> {
        for (name, asked) in [("print interval", interval), ("duration", duration)] {
            if !(asked > 0.0 && asked.is_finite()) {
                return Err(DynamicsError::NotPositive { name, asked });
            }
        }
        // A duration within rounding of a multiple is one.
        let count = duration / interval * (1.0 + 1e-12);
        if count >= MOST_PRINTED as f64 {
            return Err(DynamicsError::TooMany { name: "printed lines", limit: MOST_PRINTED });
        }
        let last = count.floor() as usize;
        // Lines fall between the nodes of the rule.
        let engagement = self.refine()?;
        let mut lines = Vec::with_capacity(last + 1);
        let (mut square, mut start) = (0.0, 0.0);
        for number in 0..MOST_PRINTED {
            let passage = engagement.pass(square);
            start = passage.print(&mut lines, PrintSchedule { interval, last, number }, start);
            if lines.len() > last {
                return Ok(lines);
            }
            square = passage.end;
        }
        Err(DynamicsError::TooMany { name: "engagements", limit: MOST_PRINTED })
    }
}

/// Where lines are printed: at multiples of an interval up to the last, in the engagement of a number.
pub(super) struct PrintSchedule {
    /// In units of time.
    pub interval: f64,
    pub last: usize,
    pub number: usize,
}

impl Passage<'_> {
    /// Adds the lines that fall within the passage, which begins at `start`, and gives its end, both in units of 1/√E.
    pub(super) fn print(&self, lines: &mut Vec<PrintedLine>, grid: PrintSchedule, mut start: f64) -> f64 {
        for traversal in &self.traversals {
            let clock = traversal.clock(self.engagement.rule);
            let end = start + clock.whole;
            while lines.len() <= grid.last {
                let time = lines.len() as f64 * grid.interval;
                if time * self.engagement.unit >= end {
                    break;
                }
                lines.push(self.line(traversal, &clock, time * self.engagement.unit - start, time, grid.number));
            }
            start = end;
        }
        start
    }

    /// The line at the end of the passage.
    pub(super) fn last_line(&self, time: f64, number: usize) -> Option<PrintedLine> {
        let traversal = self.traversals.last()?;
        let clock = traversal.clock(self.engagement.rule);
        Some(self.line(traversal, &clock, clock.whole, time, number))
    }

    pub(super) fn line(
        &self,
        traversal: &Traversal<'_>,
        clock: &Clock,
        since: f64,
        time: f64,
        number: usize,
    ) -> PrintedLine {
        let engagement = self.engagement;
        let backward = traversal.mode == ContactMode::Approach;
        let s = clock.s_at_time(engagement.rule, backward, since.max(0.0));
        let w = traversal.nodes.w_at(s);
        let square = traversal.square_between(engagement.rule, s);
        let (angle, place) = (engagement.circle.angle(w), engagement.circle.place(w));
        let angle = if backward { -angle } else { angle };
        let k = if backward { -place.k } else { place.k };
        let sigma = if traversal.mode == ContactMode::Recess { engagement.friction } else { -engagement.friction };
        let both = place.rho + sigma * k;
        let force = 1.0 + both * k * place.angular_velocity() * square;
        let acceleration = force / (engagement.inertia + place.rho * both);
        let speed = self.speed(square);
        let half = engagement.parameters().mechanism().engagement_half_angle();
        PrintedLine {
            time,
            turned: engagement.reset() * number as f64 + (angle + half),
            angle,
            speed,
            acceleration: acceleration * (engagement.unit * engagement.unit),
            follower_speed: place.rho * speed,
            engagement: number,
        }
    }
}

impl Engagement {
    /// The steady motion over one engagement, from its start to its end, at the ends of `parts` equal parts of the
    /// period.
    ///
    /// Times are from the start of the engagement, which has the number 0.
    ///
    /// ```
    /// use geneva_dynamics::steady::Engagement;
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    /// use std::f64::consts::FRAC_PI_2;
    ///
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
    /// let cycle = Engagement::new(&timer)?.steady_cycle(100)?;
    /// let (first, last) = (&cycle[0], &cycle[100]);
    /// assert!((last.turned - first.turned - FRAC_PI_2).abs() < 1e-12); // rad, with four pins
    /// assert!((last.speed / first.speed - 1.0).abs() < 1e-12); // it repeats itself
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]; [`DynamicsError::TooMany`] for [`MOST_PRINTED`] parts or more.
    pub fn steady_cycle(&self, parts: usize) -> Result<Vec<PrintedLine>, DynamicsError> {
        if parts >= MOST_PRINTED {
            return Err(DynamicsError::TooMany { name: "parts of a period", limit: MOST_PRINTED });
        }
        let engagement = self.refine()?;
        let repeated = engagement.fixed_point()?;
        let passage = engagement.pass_with(repeated.entry, repeated.split.as_ref());
        let period = passage.duration();
        let mut lines = Vec::with_capacity(parts + 1);
        if let Some(last) = parts.checked_sub(1) {
            passage.print(&mut lines, PrintSchedule { interval: period / parts as f64, last, number: 0 }, 0.0);
        }
        lines.extend(passage.last_line(period, 0));
        Ok(lines)
    }
}

impl Traversal<'_> {
    /// w at the start of the traversal, dimensionless.
    pub(super) fn start(&self) -> f64 {
        if self.mode == ContactMode::Approach { self.nodes.high } else { self.nodes.low }
    }

    /// w at its end, dimensionless.
    pub(super) fn end(&self) -> f64 {
        if self.mode == ContactMode::Approach { self.nodes.low } else { self.nodes.high }
    }

    /// u at s between −1 and 1, dimensionless.
    pub(super) fn square_between(&self, rule: &GaussLegendre, s: f64) -> f64 {
        let (mut squares, shares) = (self.squares, rule.shares(s));
        // From rest u starts as the square of 1 − s: what is to be interpolated is the factor, which has no zero.
        let scale = match self.nodes.mapping {
            NodeMapping::Linear => 1.0,
            NodeMapping::FromRest => {
                for (square, point) in squares.iter_mut().zip(&rule.nodes) {
                    *square /= (1.0 - point) * (1.0 - point);
                }
                (1.0 - s) * (1.0 - s)
            }
        };
        (scale * dot(&shares, &squares)).max(0.0)
    }

    /// Times from the start of the traversal at its nodes, in units of 1/√E, with the whole and the rates.
    pub(super) fn clock(&self, rule: &GaussLegendre) -> Clock {
        let rates = self.nodes.rates(&self.squares);
        let (mut times, whole) = rule.cumulative(&rates);
        if self.mode == ContactMode::Approach {
            times = times.map(|time| whole - time);
        }
        Clock { times, rates, whole }
    }
}

/// Times over a traversal.
#[derive(Clone, Debug)]
pub(super) struct Clock {
    times: NodalValues,
    rates: NodalValues,
    /// How long the traversal takes, in units of 1/√E.
    pub whole: f64,
}

impl Clock {
    /// s, dimensionless, at a time from 0 to the whole.
    pub(super) fn s_at_time(&self, rule: &GaussLegendre, backward: bool, time: f64) -> f64 {
        let (mut low, mut high) = (-1.0, 1.0);
        let sign = if backward { -1.0 } else { 1.0 };
        let mut s = sign * (2.0 * time / self.whole - 1.0);
        for _ in 0..60 {
            let shares = rule.shares(s);
            let late = sign * (dot(&shares, &self.times) - time);
            if late > 0.0 {
                high = s;
            } else {
                low = s;
            }
            let next = s - late / dot(&shares, &self.rates);
            let next = if next >= low && next <= high { next } else { low + (high - low) / 2.0 };
            let moved = libm::fabs(next - s);
            s = next;
            if moved <= 1e-9 {
                break;
            }
        }
        s
    }
}
