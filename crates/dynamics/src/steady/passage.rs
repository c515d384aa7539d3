//! One passage of a pin through its slot: the motion of one engagement from one entry speed.

use super::contact_reversal::{ContactReversal, Split};
use super::engagement::{Engagement, exponents};
use super::quadrature::{NODES, NodalValues};
use super::subinterval::{NodeMapping, Nodes, NodesOf, SubintervalSolution, middle};
use crate::DynamicsError;

/// Motion over one engagement from one speed at entry.
///
/// ```
/// use geneva_dynamics::steady::Engagement;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
/// use std::f64::consts::FRAC_PI_2;
///
/// // Without friction, from one hand-over to the next, all of the work goes into the driver.
/// let (driver_inertia, torque) = (2.0, 3.0); // kg m², N m
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(driver_inertia, 1.0)?, torque, 0.0)?;
/// let engagement = Engagement::new(&timer)?;
/// let passage = engagement.passage(1.0)?; // rad/s at entry
/// let square = 1.0 + 2.0 * torque * FRAC_PI_2 / driver_inertia; // over a quarter of a turn
/// assert!((passage.end_speed() - square.sqrt()).abs() < 1e-12); // rad/s
/// assert!((passage.multiplier() - 1.0).abs() < 1e-12); // no difference is ever forgotten
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Passage<'a> {
    pub(super) engagement: &'a Engagement,
    /// u at entry.
    pub(super) entry: f64,
    /// u at the end.
    pub(super) end: f64,
    /// How long it takes, in units of 1/√E.
    time: f64,
    pub(super) reversal: Option<ContactReversal>,
    /// In the order of the motion.
    pub(super) traversals: Vec<Traversal<'a>>,
}

impl Engagement {
    /// The motion from a speed at entry, θ' ≥ 0 in radians per unit of time.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Speed`] for a speed that is negative or not finite, or whose square over E is not.
    pub fn passage(&self, entry_speed: f64) -> Result<Passage<'_>, DynamicsError> {
        let (speed, square) = (entry_speed / self.unit, (entry_speed / self.unit) * (entry_speed / self.unit));
        if speed >= 0.0 && square.is_finite() {
            Ok(self.pass(square))
        } else {
            Err(DynamicsError::Speed { name: "entry speed", asked: entry_speed })
        }
    }

    /// The return map of one engagement: the driver's speed at the end of an engagement from that at its start, both in
    /// radians per unit of time.
    ///
    /// ```
    /// use geneva_dynamics::steady::Engagement;
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    ///
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
    /// let engagement = Engagement::new(&timer)?;
    /// let terminal = engagement.steady_state()?.entry_speed; // the fixed point of the map
    /// assert!((engagement.return_map(terminal)? / terminal - 1.0).abs() < 1e-12);
    /// assert!(engagement.return_map(0.9 * terminal)? > 0.9 * terminal); // from below it is approached
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Engagement::passage`].
    pub fn return_map(&self, entry_speed: f64) -> Result<f64, DynamicsError> {
        Ok(self.passage(entry_speed)?.end_speed())
    }

    /// u on the line of centres, or at an end before it, from u at entry.
    fn approach(&self, entry: f64) -> f64 {
        let last = if self.ends_before_centres { self.to_end } else { 0 };
        self.subintervals[last..self.to_exit].iter().rev().fold(entry, |square, of| of.plus.approach(square))
    }

    /// The subinterval divided at the switch of the motion with this u on the line of centres, if that comes before the
    /// end.
    fn split_from(&self, mut square: f64) -> Option<Split> {
        let mut excess = self.switching_function(0.0, square);
        for (number, subinterval) in self.subintervals[..self.to_end.min(self.to_exit)].iter().enumerate() {
            let next = subinterval.plus.up(square);
            let ends = [excess, self.switching_function(subinterval.nodes.high, next)];
            // At the exit ρ is zero but for rounding.
            if number + 1 == self.to_exit || ends[1] <= 0.0 {
                let coarse = |shares: &NodalValues| {
                    let (factor, integral) = subinterval.plus.interpolate(shares);
                    factor * (square + integral)
                };
                let mut before = None;
                let fine =
                    |w: f64| before.insert(self.part(subinterval.nodes.low, w, self.friction)).solution.up(square);
                let found = self.reversal_within(&subinterval.nodes, ends, coarse, fine);
                let after = self.part(found.at, subinterval.nodes.high, -self.friction);
                let reversal = ContactReversal { subinterval: number, at: found.reversal };
                let parts = before.map(|before| Box::new([before, after]));
                return parts.map(|parts| Split { reversal, square: found.square, parts });
            }
            (square, excess) = (next, ends[1]);
        }
        None
    }

    /// The subinterval divided at the switch of the motion from u at entry, if that comes before the end.
    fn split(&self, entry: f64) -> Option<Split> {
        if self.ends_before_centres { None } else { self.split_from(self.approach(entry)) }
    }

    pub(super) fn pass(&self, entry: f64) -> Passage<'_> {
        self.pass_with(entry, self.split(entry).as_ref())
    }

    /// u at the end of that motion and how long it takes, in units of time: the numbers that its passage has.
    pub(super) fn end_of(&self, entry: f64) -> (f64, f64) {
        let march = March::new(self, entry).finish(self.split(entry).as_ref());
        (march.square, march.time / self.unit)
    }

    /// The motion from u at entry, of which it is known where it switches.
    pub(super) fn pass_with(&self, entry: f64, split: Option<&Split>) -> Passage<'_> {
        let mut march = March::new(self, entry);
        march.traversals = Some(Vec::with_capacity(2 * self.subintervals.len() + 2));
        let march = march.finish(split);
        let (end, time, reversal) = (march.square, march.time, split.map(|split| split.reversal));
        Passage { engagement: self, entry, end, time, reversal, traversals: march.traversals.unwrap_or_default() }
    }

    /// How long that motion takes, in units of 1/√E: the same number as its passage has.
    pub(super) fn time_with(&self, entry: f64, split: Option<&Split>) -> f64 {
        March::new(self, entry).finish(split).time
    }
}

impl<'a> Passage<'a> {
    /// Within a traversal, u at w and the time from its start, in units of 1/√E, on nodes of its own.
    pub(super) fn partial_traversal(&self, number: usize, w: f64) -> (f64, f64) {
        let (engagement, whole) = (self.engagement, &self.traversals[number]);
        let mirrored = whole.mode == ContactMode::Approach;
        let (low, high) = if mirrored { (w, whole.nodes.high) } else { (whole.nodes.low, w) };
        let nodes = engagement.nodes(low, high, whole.nodes.mapping);
        let solution = engagement.solution(&nodes, engagement.sigma(whole.mode));
        let (squares, end) = solution.motion(mirrored, whole.ends[0]);
        (end, engagement.rule.integral(&nodes.rates(&squares)))
    }

    /// The escapement and how far it turns.
    pub fn engagement(&self) -> &'a Engagement {
        self.engagement
    }

    /// Driver's speed at the start, in radians per unit of time.
    pub fn entry_speed(&self) -> f64 {
        self.speed(self.entry)
    }

    /// Driver's speed at the end, in radians per unit of time.
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
    pub fn reversal_angle(&self) -> Option<f64> {
        self.reversal.map(|reversal| self.engagement.circle.angle(reversal.at))
    }

    /// Driver's speed where the follower starts to run ahead of the pin, in radians per unit of time; none if the end comes
    /// before.
    pub fn reversal_speed(&self) -> Option<f64> {
        let trailing = self.traversals.iter().find(|part| part.mode == ContactMode::Trailing)?;
        Some(self.speed(trailing.ends[0]))
    }

    /// Duration, in units of time.
    pub fn duration(&self) -> f64 {
        self.time / self.engagement.unit
    }

    /// The reset angle over the duration, in radians per unit of time.
    pub fn mean_speed(&self) -> f64 {
        self.engagement.reset() / self.duration()
    }

    /// The multiplier, slope of the return map in u, dimensionless: the factor by which the squares of two speeds that
    /// are close at entry differ at the end. Below 1, except without friction and reset at the exit, where it is 1.
    ///
    /// With κ for it, ln κ = −∫ 4 μ i k²/((i + ρ²)² − (μ k ρ)²) dψ from the switch to the exit: what is lost before the
    /// line of centres and gained past it up to the switch is the same. A reset angle elsewhere adds the loss of an
    /// engagement that ends with the follower in motion.
    pub fn multiplier(&self) -> f64 {
        libm::exp(self.engagement.log_multiplier(self.reversal))
    }
}

impl Engagement {
    /// σ = S μ in the mirror image that w ≥ 0 is.
    pub(super) fn sigma(&self, mode: ContactMode) -> f64 {
        if mode == ContactMode::Trailing { -self.friction } else { self.friction }
    }

    /// ln of the multiplier with this contact reversal.
    pub(super) fn log_multiplier(&self, reversal: Option<ContactReversal>) -> f64 {
        let (exit, end) = (self.to_exit, self.to_end);
        if self.ends_before_centres {
            return -exponents(&self.subintervals[end..exit]);
        }
        let beyond: f64 = self.subintervals[exit.min(end)..end].iter().map(|of| self.trailing(of).minus.exponent).sum();
        let short = exponents(&self.subintervals[end.min(exit)..exit]);
        let gap = reversal.map_or(0.0, |reversal| {
            let subinterval = &self.subintervals[reversal.subinterval];
            let nodes = self.nodes(reversal.at, subinterval.nodes.high, NodeMapping::Linear);
            let rest: f64 =
                self.subintervals[reversal.subinterval + 1..end.min(exit)].iter().map(|of| self.trailing(of).gap).sum();
            rest + self.rule.integral(&nodes.gap(self.inertia, self.friction))
        });
        beyond - short - gap
    }
}

/// The flank on which the pin bears, and with it the sign of the friction, on either side of the line of centres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ContactMode {
    /// Leading flank, before the line of centres, where the pin slides inward: minus.
    Approach,
    /// Leading flank, past the line of centres, where it slides outward: plus.
    Recess,
    /// Trailing flank, past the line of centres, where the follower runs ahead: minus.
    Trailing,
}

/// The motion through a subinterval, or a part of one, in one contact mode.
#[derive(Clone, Debug)]
pub(super) struct Traversal<'a> {
    pub nodes: NodesOf<'a>,
    pub mode: ContactMode,
    /// u at the nodes.
    pub squares: NodalValues,
    /// u at the start and at the end of the traversal, dimensionless.
    pub ends: [f64; 2],
    /// How long it takes, in units of 1/√E.
    pub duration: f64,
}

/// The part of the outermost subinterval over which a start from rest has nodes spread for it. There u is a small
/// difference of sums, which must be known to that many more digits: the traversal has to be short. Measured: see the
/// tests.
const REST: f64 = 1.0 / 32.0;

/// How often a traversal may be halved for that.
const HALVINGS: u32 = 200;

/// What marches through an engagement, subinterval by subinterval.
pub(super) struct March<'a> {
    engagement: &'a Engagement,
    /// u, dimensionless.
    pub square: f64,
    /// In units of 1/√E.
    pub time: f64,
    /// The traversals, if they are asked for.
    pub traversals: Option<Vec<Traversal<'a>>>,
}

impl<'a> March<'a> {
    /// Before the first traversal, with u at entry.
    pub(super) fn new(engagement: &'a Engagement, entry: f64) -> Self {
        Self { engagement, square: entry, time: 0.0, traversals: None }
    }

    /// From entry to end.
    pub(super) fn finish(mut self, split: Option<&Split>) -> Self {
        let engagement = self.engagement;
        let last = if engagement.ends_before_centres { engagement.to_end } else { 0 };
        for subinterval in engagement.subintervals[last..engagement.to_exit].iter().rev() {
            let nodes: &Nodes = &subinterval.nodes;
            if self.square == 0.0 {
                let outer = nodes.high - REST * (nodes.high - nodes.low);
                self.add_between(outer, nodes.high, ContactMode::Approach, NodeMapping::FromRest, 0);
                self.add_between(nodes.low, outer, ContactMode::Approach, NodeMapping::Linear, 0);
            } else {
                self.add(nodes, Some(nodes), &subinterval.plus, ContactMode::Approach, 0);
            }
        }
        if engagement.ends_before_centres {
            return self;
        }
        for (number, subinterval) in engagement.subintervals[..engagement.to_end].iter().enumerate() {
            let nodes: &Nodes = &subinterval.nodes;
            match split {
                Some(split) if split.reversal.subinterval == number => {
                    let [before, after] = &*split.parts;
                    if before.nodes.low < before.nodes.high {
                        self.add(&before.nodes, None, &before.solution, ContactMode::Recess, 0);
                    }
                    self.square = split.square;
                    if after.nodes.low < after.nodes.high {
                        self.add(&after.nodes, None, &after.solution, ContactMode::Trailing, 0);
                    }
                }
                Some(split) if split.reversal.subinterval < number => {
                    self.add(nodes, Some(nodes), &engagement.trailing(subinterval).minus, ContactMode::Trailing, 0);
                }
                _ => self.add(nodes, Some(nodes), &subinterval.plus, ContactMode::Recess, 0),
            }
        }
        self
    }

    /// Goes on over nodes, which may be those of a subinterval; divides them if the energy changes too much.
    fn add(
        &mut self,
        nodes: &Nodes,
        shared: Option<&'a Nodes>,
        solution: &SubintervalSolution,
        mode: ContactMode,
        halvings: u32,
    ) {
        let engagement = self.engagement;
        let (squares, end) = solution.motion(mode == ContactMode::Approach, self.square);
        let (low, high) = (nodes.low, nodes.high);
        let middle = middle(low, high);
        let divide = halvings < HALVINGS && low < middle && middle < high;
        if divide && energy_range(engagement, nodes, &squares) > engagement.energy_range {
            let parts = [(low, middle), (middle, high)];
            let order = if mode == ContactMode::Approach { [1, 0] } else { [0, 1] };
            for (low, high) in order.map(|part| parts[part]) {
                self.add_between(low, high, mode, NodeMapping::Linear, halvings + 1);
            }
            return;
        }
        let duration = engagement.rule.integral(&nodes.rates(&squares));
        self.time += duration;
        if let Some(traversals) = &mut self.traversals {
            let nodes = shared.map_or_else(|| NodesOf::Own(Box::new(nodes.clone())), NodesOf::Shared);
            traversals.push(Traversal { nodes, mode, squares, ends: [self.square, end], duration });
        }
        self.square = end;
    }

    /// Goes on over a part of a subinterval.
    fn add_between(&mut self, low: f64, high: f64, mode: ContactMode, mapping: NodeMapping, halvings: u32) {
        if high > low {
            let engagement = self.engagement;
            let nodes = engagement.nodes(low, high, mapping);
            let solution = engagement.solution(&nodes, engagement.sigma(mode));
            // From rest the energy starts at zero, and the nodes are spread for that.
            let halvings = if matches!(mapping, NodeMapping::FromRest) { HALVINGS } else { halvings };
            self.add(&nodes, None, &solution, mode, halvings);
        }
    }
}

/// Greatest over least of (i + ρ²) u, twice the energy, at four of the nodes, the outermost two among them.
fn energy_range(engagement: &Engagement, nodes: &Nodes, squares: &NodalValues) -> f64 {
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for index in (0..NODES).step_by(NODES / 3) {
        let rho = nodes.rho[index];
        let energy = (engagement.inertia + rho * rho) * squares[index];
        least = least.min(energy);
        most = most.max(energy);
    }
    most / least
}
