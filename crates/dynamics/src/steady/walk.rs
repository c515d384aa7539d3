//! Through an engagement, piece by piece.

use super::engagement::Engagement;
use super::halves::Net;
use super::rule::{POINTS, Row};
use super::stretch::{Branch, Points, Spread};
use super::switch::Split;

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
    pub points: Net<'a>,
    pub phase: Phase,
    /// u at the points.
    pub squares: Row,
    /// u at the start and at the end of the piece.
    pub ends: [f64; 2],
    /// How long it takes, in units of 1/√E.
    pub duration: f64,
}

/// The part of the outermost stretch over which a start from rest has points spread for it. There u is a small
/// difference of sums, which must be known to that many more digits: the piece has to be short. Measured: see the tests.
const REST: f64 = 1.0 / 32.0;

/// How often a piece may be halved for that.
const HALVINGS: u32 = 200;

/// What goes through an engagement, piece by piece.
pub(super) struct Walk<'a> {
    engagement: &'a Engagement,
    /// u.
    pub square: f64,
    /// In units of 1/√E.
    pub time: f64,
    /// The pieces, if they are asked for.
    pub pieces: Option<Vec<Piece<'a>>>,
}

impl<'a> Walk<'a> {
    /// Before the first piece, with u at entry.
    pub fn new(engagement: &'a Engagement, entry: f64) -> Self {
        Self { engagement, square: entry, time: 0.0, pieces: None }
    }

    /// From entry to end.
    pub fn over(mut self, split: Option<&Split>) -> Self {
        let engagement = self.engagement;
        let last = if engagement.ends_before_centres { engagement.to_end } else { 0 };
        for panel in engagement.panels[last..engagement.to_exit].iter().rev() {
            let points: &Points = &panel.points;
            if self.square == 0.0 {
                let outer = points.high - REST * (points.high - points.low);
                self.add_between(outer, points.high, Phase::Approach, Spread::FromRest, 0);
                self.add_between(points.low, outer, Phase::Approach, Spread::Even, 0);
            } else {
                self.add(points, Some(points), &panel.plus, Phase::Approach, 0);
            }
        }
        if engagement.ends_before_centres {
            return self;
        }
        for (number, panel) in engagement.panels[..engagement.to_end].iter().enumerate() {
            let points: &Points = &panel.points;
            match split {
                Some(split) if split.switch.panel == number => {
                    let [before, after] = &*split.parts;
                    if before.points.low < before.points.high {
                        self.add(&before.points, None, &before.branch, Phase::Driving, 0);
                    }
                    self.square = split.square;
                    if after.points.low < after.points.high {
                        self.add(&after.points, None, &after.branch, Phase::Held, 0);
                    }
                }
                Some(split) if split.switch.panel < number => {
                    self.add(points, Some(points), &engagement.held(panel).minus, Phase::Held, 0);
                }
                _ => self.add(points, Some(points), &panel.plus, Phase::Driving, 0),
            }
        }
        self
    }

    /// Goes on over points, which may be those of a stretch; divides them if the energy changes too much.
    fn add(&mut self, points: &Points, shared: Option<&'a Points>, branch: &Branch, phase: Phase, halvings: u32) {
        let engagement = self.engagement;
        let (squares, end) = branch.motion(phase == Phase::Approach, self.square);
        let (low, high) = (points.low, points.high);
        let middle = low + (high - low) / 2.0;
        let divide = halvings < HALVINGS && low < middle && middle < high;
        if divide && energy_range(engagement, points, &squares) > engagement.energy_range {
            let parts = [(low, middle), (middle, high)];
            let order = if phase == Phase::Approach { [1, 0] } else { [0, 1] };
            for (low, high) in order.map(|part| parts[part]) {
                self.add_between(low, high, phase, Spread::Even, halvings + 1);
            }
            return;
        }
        let duration = engagement.rule.integral(&points.rates(&squares));
        self.time += duration;
        if let Some(pieces) = &mut self.pieces {
            let points = shared.map_or_else(|| Net::Own(Box::new(points.clone())), Net::Shared);
            pieces.push(Piece { points, phase, squares, ends: [self.square, end], duration });
        }
        self.square = end;
    }

    /// Goes on over a part of a stretch.
    fn add_between(&mut self, low: f64, high: f64, phase: Phase, spread: Spread, halvings: u32) {
        if high > low {
            let engagement = self.engagement;
            let points = Points::new(&engagement.circle, engagement.rule, low, high, spread);
            let branch = points.branch(engagement.rule, engagement.inertia, engagement.sigma(phase));
            // From rest the energy starts at zero, and the points are spread for that.
            let halvings = if matches!(spread, Spread::FromRest) { HALVINGS } else { halvings };
            self.add(&points, None, &branch, phase, halvings);
        }
    }
}

/// Greatest over least of (i + ρ²) u, twice the energy, at four of the points, the outermost two among them.
fn energy_range(engagement: &Engagement, points: &Points, squares: &Row) -> f64 {
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for index in (0..POINTS).step_by(POINTS / 3) {
        let lead = points.lead[index];
        let energy = (engagement.inertia + lead * lead) * squares[index];
        least = least.min(energy);
        most = most.max(energy);
    }
    most / least
}
