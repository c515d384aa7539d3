//! One passage of a pin through its slot: the motion of one engagement from one entry speed.

use super::engagement::{Engagement, Panel};
use super::error::SteadyError;
use super::rule::{POINTS, Row};
use super::stretch::{Branch, Points, Spread};
use super::switch::Switch;
use std::borrow::Cow;

/// What the motion over one engagement is from one speed at entry.
#[derive(Clone, Debug)]
pub struct Passage<'a> {
    pub(super) engagement: &'a Engagement,
    /// u at entry.
    pub(super) entry: f64,
    /// u at the end.
    pub(super) end: f64,
    pub(super) switch: Option<Switch>,
    /// In the order of the motion.
    pub(super) pieces: Vec<Piece<'a>>,
}

/// The sign of the friction, and on which side of the line of centres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Phase {
    /// Before the line of centres: minus.
    Approach,
    /// Past it, and the pin drives the follower: plus.
    Driving,
    /// Past it, and the follower runs ahead: minus.
    Held,
}

/// A part of the motion with one sign, on the points of a rule.
#[derive(Clone, Debug)]
pub(super) struct Piece<'a> {
    pub points: Cow<'a, Points>,
    pub phase: Phase,
    /// u at the points.
    pub squares: Row,
    /// u at the start and at the end of the piece.
    pub ends: [f64; 2],
    /// How long it takes, in units of 1/√E.
    pub duration: f64,
}

/// A change of the energy by more than this factor is divided: the time goes as the inverse of its root. Measured: for
/// tolerances from 10⁻¹¹ on, and below.
const ENERGY_RANGE: [f64; 2] = [3.0, 2.0];

/// How often a piece may be halved for that.
const HALVINGS: u32 = 200;

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

    /// The switch of the motion with this u on the line of centres, if it comes before the end.
    fn switch_from(&self, mut square: f64) -> Option<Switch> {
        for (number, panel) in self.panels[..self.to_end.min(self.to_exit)].iter().enumerate() {
            let next = panel.plus.up(square);
            // At the exit ρ is zero but for rounding.
            if number + 1 == self.to_exit || self.excess(panel.points.high, next) <= 0.0 {
                let coarse = |shares: &Row| {
                    let (growth, drive) = panel.plus.between(shares);
                    growth * (square + drive)
                };
                let fine = |w: f64| {
                    let points = Points::new(&self.circle, self.rule, panel.points.low, w, Spread::Even);
                    points.branch(self.rule, self.inertia, self.friction).up(square)
                };
                return Some(self.switch_within(number, coarse, fine));
            }
            square = next;
        }
        None
    }

    pub(super) fn pass(&self, entry: f64) -> Passage<'_> {
        let switch = if self.ends_before_centres { None } else { self.switch_from(self.approach(entry)) };
        self.pass_with(entry, switch)
    }

    pub(super) fn pass_with(&self, entry: f64, switch: Option<Switch>) -> Passage<'_> {
        let pieces = Vec::with_capacity(2 * self.panels.len() + 2);
        let mut passage = Passage { engagement: self, entry, end: entry, switch, pieces };
        let last = if self.ends_before_centres { self.to_end } else { 0 };
        for panel in self.panels[last..self.to_exit].iter().rev() {
            if passage.end == 0.0 {
                passage.add_between(panel.points.low, panel.points.high, Phase::Approach, Spread::FromRest, 0);
            } else {
                passage.add(panel, Phase::Approach);
            }
        }
        if self.ends_before_centres {
            return passage;
        }
        for (number, panel) in self.panels[..self.to_end].iter().enumerate() {
            let points = &panel.points;
            match switch {
                Some(switch) if switch.panel == number => {
                    passage.add_between(points.low, switch.at, Phase::Driving, Spread::Even, 0);
                    passage.end = switch.square;
                    passage.add_between(switch.at, points.high, Phase::Held, Spread::Even, 0);
                }
                Some(switch) if switch.panel < number => passage.add(panel, Phase::Held),
                _ => passage.add(panel, Phase::Driving),
            }
        }
        passage
    }
}

impl<'a> Passage<'a> {
    /// Goes on over a stretch of the engagement.
    fn add(&mut self, panel: &'a Panel, phase: Phase) {
        let branch = if phase == Phase::Held { &panel.minus } else { &panel.plus };
        let piece = Piece::new(Cow::Borrowed(&panel.points), branch, phase, self.end);
        self.keep_or_halve(piece, 0);
    }

    /// Goes on over a part of a stretch.
    fn add_between(&mut self, low: f64, high: f64, phase: Phase, spread: Spread, halvings: u32) {
        if high > low {
            let engagement = self.engagement;
            let points = Points::new(&engagement.circle, engagement.rule, low, high, spread);
            let branch = points.branch(engagement.rule, engagement.inertia, engagement.sigma(phase));
            let piece = Piece::new(Cow::Owned(points), &branch, phase, self.end);
            // From rest the energy starts at zero, and the points are spread for that.
            self.keep_or_halve(piece, if matches!(spread, Spread::FromRest) { HALVINGS } else { halvings });
        }
    }

    fn keep_or_halve(&mut self, mut piece: Piece<'a>, halvings: u32) {
        let (low, high, phase) = (piece.points.low, piece.points.high, piece.phase);
        let range = ENERGY_RANGE[usize::from(self.engagement.tolerance() < 1e-11)];
        let middle = low + (high - low) / 2.0;
        if halvings < HALVINGS && low < middle && middle < high && piece.energy_range(self.engagement) > range {
            let parts = [(low, middle), (middle, high)];
            let order = if phase == Phase::Approach { [1, 0] } else { [0, 1] };
            for (low, high) in order.map(|part| parts[part]) {
                self.add_between(low, high, phase, Spread::Even, halvings + 1);
            }
        } else {
            self.end = piece.ends[1];
            piece.duration = self.engagement.rule.integral(&piece.rates());
            self.pieces.push(piece);
        }
    }

    /// Within a piece, its part from its start to w, on points of its own.
    pub(super) fn part(&self, number: usize, w: f64) -> Piece<'a> {
        let (engagement, whole) = (self.engagement, &self.pieces[number]);
        let (low, high) = if whole.phase == Phase::Approach { (w, whole.points.high) } else { (whole.points.low, w) };
        let points = Points::new(&engagement.circle, engagement.rule, low, high, whole.points.spread);
        let branch = points.branch(engagement.rule, engagement.inertia, engagement.sigma(whole.phase));
        let mut part = Piece::new(Cow::Owned(points), &branch, whole.phase, whole.ends[0]);
        part.duration = engagement.rule.integral(&part.rates());
        part
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
        self.pieces.iter().map(|piece| piece.duration).sum::<f64>() / self.engagement.unit
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
        let beyond: f64 = self.panels[exit.min(end)..end].iter().map(|panel| panel.minus.exponent).sum();
        let short = growth(&self.panels[end.min(exit)..exit]);
        let gap = switch.map_or(0.0, |switch| {
            let panel = &self.panels[switch.panel];
            let points = Points::new(&self.circle, self.rule, switch.at, panel.points.high, Spread::Even);
            let rest: f64 = self.panels[switch.panel + 1..end.min(exit)].iter().map(|panel| panel.gap).sum();
            rest + self.rule.integral(&points.gap(self.inertia, self.friction))
        });
        beyond - short - gap
    }
}

impl<'a> Piece<'a> {
    /// The motion from u at the start over these points. Its duration is still to be found.
    fn new(points: Cow<'a, Points>, branch: &Branch, phase: Phase, start: f64) -> Self {
        let (squares, end) = if phase == Phase::Approach {
            (branch.squares_of_approach(start), branch.approach(start))
        } else {
            (branch.squares_up(start), branch.up(start))
        };
        Self { points, phase, squares, ends: [start, end], duration: 0.0 }
    }

    /// Greatest over least of (i + ρ²) u, twice the energy, at four of the points, the outermost two among them.
    fn energy_range(&self, engagement: &Engagement) -> f64 {
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for index in (0..POINTS).step_by(POINTS / 3) {
            let lead = self.points.lead[index];
            let energy = (engagement.inertia + lead * lead) * self.squares[index];
            least = least.min(energy);
            most = most.max(energy);
        }
        most / least
    }

    /// dt per unit of the rule, at the points, where the unit of time is 1/√E.
    pub fn rates(&self) -> Row {
        let mut rates = self.points.angle;
        for (rate, square) in rates.iter_mut().zip(&self.squares) {
            *rate /= square.sqrt();
        }
        rates
    }
}
