//! One passage of a pin through its slot: the motion of one engagement from one entry speed.

use super::engagement::{Engagement, Panel};
use super::error::SteadyError;
use super::rule::Row;
use super::stretch::{Points, Spread};
use super::switch::{Split, Switch};
use super::walk::{Phase, Piece, Walk};

/// What the motion over one engagement is from one speed at entry.
#[derive(Clone, Debug)]
pub struct Passage<'a> {
    pub(super) engagement: &'a Engagement,
    /// u at entry.
    pub(super) entry: f64,
    /// u at the end.
    pub(super) end: f64,
    /// How long it takes, in units of 1/√E.
    time: f64,
    pub(super) switch: Option<Switch>,
    /// In the order of the motion.
    pub(super) pieces: Vec<Piece<'a>>,
}

impl Engagement {
    /// The motion from a speed at entry, θ' ≥ 0 in radians per unit of time.
    ///
    /// # Errors
    ///
    /// [`SteadyError::Speed`] for a speed that is negative or not finite, or whose square over E is not.
    pub fn passage(&self, entry_speed: f64) -> Result<Passage<'_>, SteadyError> {
        let (speed, square) = (entry_speed / self.unit, (entry_speed / self.unit) * (entry_speed / self.unit));
        if speed >= 0.0 && square.is_finite() { Ok(self.pass(square)) } else { Err(SteadyError::Speed(entry_speed)) }
    }

    /// The hand-over map: the driver's speed at the end of an engagement from that at its start.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::passage`].
    pub fn hand_over(&self, entry_speed: f64) -> Result<f64, SteadyError> {
        Ok(self.passage(entry_speed)?.end_speed())
    }

    /// u on the line of centres, or at an end before it, from u at entry.
    fn approach(&self, entry: f64) -> f64 {
        let last = if self.ends_before_centres { self.to_end } else { 0 };
        self.panels[last..self.to_exit].iter().rev().fold(entry, |square, panel| panel.plus.approach(square))
    }

    /// The stretch divided at the switch of the motion with this u on the line of centres, if that comes before the end.
    fn split_from(&self, mut square: f64) -> Option<Split> {
        let mut excess = self.excess(0.0, square);
        for (number, panel) in self.panels[..self.to_end.min(self.to_exit)].iter().enumerate() {
            let next = panel.plus.up(square);
            let ends = [excess, self.excess(panel.points.high, next)];
            // At the exit ρ is zero but for rounding.
            if number + 1 == self.to_exit || ends[1] <= 0.0 {
                let coarse = |shares: &Row| {
                    let (growth, drive) = panel.plus.between(shares);
                    growth * (square + drive)
                };
                let mut before = None;
                let fine = |w: f64| before.insert(self.part(panel.points.low, w, self.friction)).branch.up(square);
                let found = self.switch_within(&panel.points, ends, coarse, fine);
                let after = self.part(found.at, panel.points.high, -self.friction);
                let switch = Switch { panel: number, at: found.switch };
                let parts = before.map(|before| Box::new([before, after]));
                return parts.map(|parts| Split { switch, square: found.square, parts });
            }
            (square, excess) = (next, ends[1]);
        }
        None
    }

    pub(super) fn pass(&self, entry: f64) -> Passage<'_> {
        let split = if self.ends_before_centres { None } else { self.split_from(self.approach(entry)) };
        self.pass_with(entry, split.as_ref())
    }

    /// The motion from u at entry, of which it is known where it switches.
    pub(super) fn pass_with(&self, entry: f64, split: Option<&Split>) -> Passage<'_> {
        let mut walk = Walk::new(self, entry);
        walk.pieces = Some(Vec::with_capacity(2 * self.panels.len() + 2));
        let walk = walk.over(split);
        let (end, time, switch) = (walk.square, walk.time, split.map(|split| split.switch));
        Passage { engagement: self, entry, end, time, switch, pieces: walk.pieces.unwrap_or_default() }
    }

    /// How long that motion takes, in units of 1/√E: the same number as its passage has.
    pub(super) fn time_with(&self, entry: f64, split: Option<&Split>) -> f64 {
        Walk::new(self, entry).over(split).time
    }
}

impl<'a> Passage<'a> {
    /// Within a piece, u at w and the time from its start, in units of 1/√E, on points of its own.
    pub(super) fn within(&self, number: usize, w: f64) -> (f64, f64) {
        let (engagement, whole) = (self.engagement, &self.pieces[number]);
        let mirrored = whole.phase == Phase::Approach;
        let (low, high) = if mirrored { (w, whole.points.high) } else { (whole.points.low, w) };
        let points = Points::new(&engagement.circle, engagement.rule, low, high, whole.points.spread);
        let branch = points.branch(engagement.rule, engagement.inertia, engagement.sigma(whole.phase));
        let (squares, end) = branch.motion(mirrored, whole.ends[0]);
        (end, engagement.rule.integral(&points.rates(&squares)))
    }

    /// The escapement and how far it turns.
    pub fn engagement(&self) -> &'a Engagement {
        self.engagement
    }

    /// Driver's speed at the start, in radians per unit of time.
    pub fn entry_speed(&self) -> f64 {
        self.speed(self.entry)
    }

    /// Driver's speed at the end.
    pub fn end_speed(&self) -> f64 {
        self.speed(self.end)
    }

    /// θ' from u.
    pub(super) fn speed(&self, square: f64) -> f64 {
        self.engagement.unit * square.sqrt()
    }

    /// Crank angle in radians at which the follower starts to run ahead of the pin; none if the end comes before.
    ///
    /// Friction changes its sign there and at 0, on the line of centres, and nowhere else.
    pub fn switch_angle(&self) -> Option<f64> {
        self.switch.map(|switch| self.engagement.circle.angle(switch.at))
    }

    /// How long it takes, in units of time.
    pub fn duration(&self) -> f64 {
        self.time / self.engagement.unit
    }

    /// The fold over the duration, in radians per unit of time.
    pub fn mean_speed(&self) -> f64 {
        self.engagement.fold() / self.duration()
    }

    /// Factor by which the squares of two speeds that are close at entry differ at the end: below 1, except without
    /// friction and folded at the exit, where it is 1.
    ///
    /// With κ for it, ln κ = −∫ 4 μ i k²/((i + ρ²)² − (μ k ρ)²) dψ from the switch to the exit: what is lost before the
    /// line of centres and gained past it up to the switch is the same. A fold elsewhere adds the loss of an engagement
    /// that ends with the follower in motion.
    pub fn contraction(&self) -> f64 {
        libm::exp(self.engagement.log_contraction(self.switch))
    }
}

impl Engagement {
    /// σ = S μ in the mirror image that w ≥ 0 is.
    pub(super) fn sigma(&self, phase: Phase) -> f64 {
        if phase == Phase::Held { -self.friction } else { self.friction }
    }

    /// ln of the contraction with this switch.
    pub(super) fn log_contraction(&self, switch: Option<Switch>) -> f64 {
        let (exit, end) = (self.to_exit, self.to_end);
        let growth = |panels: &[Panel]| -> f64 { panels.iter().map(|panel| panel.plus.exponent).sum() };
        if self.ends_before_centres {
            return -growth(&self.panels[end..exit]);
        }
        let beyond: f64 = self.panels[exit.min(end)..end].iter().map(|panel| self.held(panel).minus.exponent).sum();
        let short = growth(&self.panels[end.min(exit)..exit]);
        let gap = switch.map_or(0.0, |switch| {
            let panel = &self.panels[switch.panel];
            let points = Points::new(&self.circle, self.rule, switch.at, panel.points.high, Spread::Even);
            let rest: f64 = self.panels[switch.panel + 1..end.min(exit)].iter().map(|panel| self.held(panel).gap).sum();
            rest + self.rule.integral(&points.gap(self.inertia, self.friction))
        });
        beyond - short - gap
    }
}
