//! One engagement: the solution of the equation of motion between two hand-overs, for all entry speeds at once.

use super::circle::{Circle, CirclePoint};
use super::quadrature::{GaussLegendre, NODES, rule};
use super::subinterval::{NodeMapping, Nodes, NodesOf, SubintervalSolution, bisection_tree, middle};
use crate::{DynamicsError, Parameters};
use std::f64::consts::PI;
use std::ops::RangeInclusive;
use std::sync::{LazyLock, OnceLock};

/// The relative tolerances that an [`Engagement`] can be asked for, dimensionless.
pub const TOLERANCES: RangeInclusive<f64> = 1e-13..=1e-6;

/// The relative tolerance of an [`Engagement`] that is not asked for another, dimensionless.
pub const TOLERANCE: f64 = 1e-12;

/// Most subintervals, of sixteen nodes each, into which half an engagement is divided.
pub const MOST_SUBINTERVALS: usize = 4096;

/// The motion over one engagement of an escapement, worked out but for the speed at entry.
///
/// It starts at the crank angle −π/m and lasts for a turn of the driver that is called the reset angle: 2π/m in a
/// mechanism, where the next pin then takes over.
///
/// ```
/// use geneva_dynamics::steady::Engagement;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = |torque: f64| { // in N m
///     let inertias = Inertias::new(2e-6, 1e-6)?; // kg m²
///     Engagement::new(&Parameters::new(Mechanism::FOUR_PIN, inertias, torque, 0.2)?)
/// };
/// let (weak, strong) = (timer(1e-3)?.steady_state()?, timer(4e-3)?.steady_state()?);
/// assert!((strong.mean_speed / weak.mean_speed - 2.0).abs() < 1e-12); // by the law of similarity
/// assert!((strong.period / weak.period - 0.5).abs() < 1e-12);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Engagement {
    parameters: Parameters,
    reset: f64,
    /// w at the end, negative before the line of centres.
    end: f64,
    tolerance: f64,
    /// A change of the energy by more than this factor is divided: the time goes as the inverse of its root.
    pub(super) energy_range: f64,
    pub(super) rule: &'static GaussLegendre,
    pub(super) circle: Circle,
    /// I_D/I_f.
    pub(super) inertia: f64,
    /// μ.
    pub(super) friction: f64,
    /// √E: θ' over √u.
    pub(super) unit: f64,
    /// By rising w, from the line of centres to the exit or to the end, whichever is farther.
    pub(super) subintervals: Vec<Subinterval>,
    /// How many of them lie within the mechanism's engagement.
    pub(super) to_exit: usize,
    /// How many of them lie nearer to the line of centres than the end.
    pub(super) to_end: usize,
    /// Whether the end comes before the line of centres, or on it.
    pub(super) ends_before_centres: bool,
}

/// One subinterval, with both signs of the friction.
#[derive(Clone, Debug)]
pub(super) struct Subinterval {
    pub nodes: NodesOf<'static>,
    /// Friction with the plus sign past the line of centres; mirrored, with the minus sign before it.
    pub plus: SubintervalSolution,
    /// e^Λ and J of the plus sign from the line of centres to the subinterval's lower end, dimensionless.
    pub before: (f64, f64),
    /// Made when it is asked for: the motion has this sign from the contact reversal on only.
    trailing: OnceLock<Trailing>,
}

/// The trailing flank: friction with the minus sign past the line of centres.
#[derive(Clone, Debug)]
pub(super) struct Trailing {
    pub minus: SubintervalSolution,
    /// Λ of the plus sign less Λ of the minus sign at the upper end, without cancellation, dimensionless.
    pub gap: f64,
}

impl Subinterval {
    /// e^Λ and J of the plus sign from the line of centres to the subinterval's upper end, dimensionless.
    pub(super) fn upper_integrals(&self) -> (f64, f64) {
        let (product, sum) = self.before;
        (product * self.plus.factor_end, sum + self.plus.integral_end / product)
    }
}

/// Λ with the plus sign over subintervals, dimensionless.
pub(super) fn exponents(subintervals: &[Subinterval]) -> f64 {
    subintervals.iter().map(|of| of.plus.exponent).sum()
}

impl Engagement {
    /// The engagement of an escapement, from entry to exit, to the tolerance [`TOLERANCE`].
    ///
    /// # Errors
    ///
    /// [`DynamicsError::TooSharp`] if the friction is within rounding of the critical one, or the inertias differ too much.
    pub fn new(parameters: &Parameters) -> Result<Self, DynamicsError> {
        Self::with_tolerance(parameters, TOLERANCE)
    }

    /// The engagement of an escapement, to a relative tolerance of [`TOLERANCES`]. A greater one takes less time.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::new`], and [`DynamicsError::OutOfRange`].
    pub fn with_tolerance(parameters: &Parameters, tolerance: f64) -> Result<Self, DynamicsError> {
        let exit = Circle::lookup(parameters.mechanism()).exit;
        Self::to(parameters, 2.0 * parameters.mechanism().engagement_half_angle(), exit, tolerance)
    }

    /// The motion of a calculation that goes back to −π/m after a turn of `reset` radians, whether or not a pin leaves
    /// there.
    ///
    /// The equation is evaluated beyond the exit if the reset angle is more than 2π/m, and short of it if less. The
    /// reset angle must be positive and less than π + π/m. Meyer 1973, Appendix B, does so with one reset angle for all
    /// mechanisms.
    ///
    /// ```
    /// use geneva_dynamics::steady::Engagement;
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    /// use std::f64::consts::{FRAC_PI_2, PI};
    ///
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
    /// // Four pins follow one another by a quarter of a turn: with that reset angle it is the mechanism.
    /// let reset = Engagement::reset_after(&timer, FRAC_PI_2, 1e-12)?;
    /// assert_eq!(reset.steady_state()?, Engagement::new(&timer)?.steady_state()?);
    /// assert!(Engagement::reset_after(&timer, 2.0 * PI, 1e-12).is_err());
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Engagement::with_tolerance`], and [`DynamicsError::Reset`].
    ///
    /// Beyond the exit the equation has one solution if it has within: with |ρ| = x there, k² = c² a² − (c + x)², and
    /// at the place within where ρ = x it is c² a² − (c − x)², which is more; so |D| − ρ² = x (μ k − x) is less.
    pub fn reset_after(parameters: &Parameters, reset: f64, tolerance: f64) -> Result<Self, DynamicsError> {
        let half = parameters.mechanism().engagement_half_angle();
        if reset == 2.0 * half {
            return Self::with_tolerance(parameters, tolerance);
        }
        let (limit, end) = (PI + half, reset - half);
        if !(reset > 0.0 && end < PI) {
            return Err(DynamicsError::Reset { asked: reset, limit });
        }
        let circle = Circle::lookup(parameters.mechanism());
        Self::to(parameters, reset, circle.w_at_angle(end.abs()).copysign(end), tolerance)
    }

    /// `end` is w at the end, negative before the line of centres.
    fn to(parameters: &Parameters, reset: f64, end: f64, tolerance: f64) -> Result<Self, DynamicsError> {
        if !TOLERANCES.contains(&tolerance) {
            return Err(DynamicsError::OutOfRange {
                name: "tolerance",
                asked: tolerance,
                least: *TOLERANCES.start(),
                most: *TOLERANCES.end(),
            });
        }
        Self::divided(parameters, reset, end, tolerance, &Scales::of_integrals(tolerance))
    }

    fn divided(
        parameters: &Parameters,
        reset: f64,
        end: f64,
        tolerance: f64,
        scales: &Scales,
    ) -> Result<Self, DynamicsError> {
        let mut engagement = Self {
            parameters: *parameters,
            reset,
            tolerance,
            energy_range: scales.energy_range,
            rule: rule(),
            circle: Circle::lookup(parameters.mechanism()),
            inertia: parameters.inertias().ratio(),
            friction: parameters.friction(),
            unit: parameters.drive().sqrt(),
            subintervals: Vec::with_capacity(8),
            to_exit: 0,
            to_end: 0,
            ends_before_centres: end <= 0.0,
            end,
        };
        let (exit, reach) = (engagement.circle.exit, end.abs());
        // At the exit A falls to i within √i: places, which are known to some units of 2⁻⁵³, must be finer than that.
        if engagement.inertia.sqrt() * tolerance < 4.0 * f64::EPSILON {
            return Err(DynamicsError::TooSharp { angle: engagement.circle.angle(exit), margin: engagement.inertia });
        }
        engagement.divide(0.0, exit.min(reach), scales)?;
        let nearer = engagement.subintervals.len();
        engagement.divide(exit.min(reach), exit.max(reach), scales)?;
        let farther = engagement.subintervals.len();
        (engagement.to_exit, engagement.to_end) = if end > exit { (nearer, farther) } else { (farther, nearer) };
        Ok(engagement)
    }

    /// Adds subintervals from `low` to `high`, each short enough for its nodes to resolve.
    fn divide(&mut self, low: f64, high: f64, scales: &Scales) -> Result<(), DynamicsError> {
        if low >= high {
            return Ok(());
        }
        let mut rest = Vec::with_capacity(8);
        let tree = bisection_tree(self.parameters.mechanism());
        rest.push((low, high, (low == 0.0 && high == self.circle.exit).then_some(0)));
        while let Some((low, high, number)) = rest.pop() {
            let middle = middle(low, high);
            let shared = number.and_then(|number| tree.get(number));
            let places =
                shared.map_or_else(|| [low, middle, high].map(|w| self.circle.place(w)), |shared| shared.places);
            if self.resolves(low, middle, high, &places, scales) {
                let nodes = shared.map_or_else(
                    || NodesOf::Own(Box::new(self.nodes(low, high, NodeMapping::Linear))),
                    |shared| NodesOf::Shared(&shared.nodes),
                );
                let plus = self.solution(&nodes, self.friction);
                let before = self.subintervals.last().map_or((1.0, 0.0), Subinterval::upper_integrals);
                self.subintervals.push(Subinterval { nodes, plus, before, trailing: OnceLock::new() });
            } else if self.subintervals.len() + rest.len() < MOST_SUBINTERVALS && low < middle && middle < high {
                let child = |which: usize| number.map(|number| number.saturating_mul(2).saturating_add(which));
                rest.push((middle, high, child(2)));
                rest.push((low, middle, child(1)));
            } else {
                let sigma = if middle < self.circle.exit { -self.friction } else { self.friction };
                let margin = self.inert(&self.circle.place(middle), sigma).value;
                return Err(DynamicsError::TooSharp { angle: self.circle.angle(middle), margin });
            }
        }
        Ok(())
    }

    /// Whether no pole of the equation is too near, and its solution does not grow too much, from low to high.
    fn resolves(&self, low: f64, middle: f64, high: f64, places: &[CirclePoint; 3], scales: &Scales) -> bool {
        let near = scales.distance * (high - low) / 2.0;
        // Poles that do not depend on the friction: w = ±i, where ψ is infinite, and where 1 + 2 ρ = 0. That is at
        // ψ = π ± i ln a, where w is on the unit circle and its imaginary part tanh(ln a / 2) = (a − 1)/(a + 1).
        let along = high - self.circle.far.0;
        let far = (1.0 + low * low).min(along * along + self.circle.far.1 * self.circle.far.1) >= near * near;
        // Of the two signs this one has the nearer poles: at ρ > 0 where ρ > 0, at ρ < 0 where ρ < 0.
        let sigma = if middle < self.circle.exit { -self.friction } else { self.friction };
        far && places.iter().rev().all(|place| {
            let inert = self.inert(place, sigma);
            let other = inert.value - 2.0 * sigma * place.k * place.rho;
            let (part, rest) = (place.rho + sigma * place.k, place.rho - sigma * place.k);
            let scale = 2.0 * place.k * place.jacobian * (high - low);
            inert.has_no_root_within(near * place.jacobian)
                && libm::fabs(part) * scale <= scales.exponent * inert.value
                && libm::fabs(rest) * scale <= scales.exponent * other
        })
    }

    /// A + S D past the line of centres, with the first two derivatives by ψ, for σ = S μ.
    fn inert(&self, place: &CirclePoint, sigma: f64) -> Parabola {
        let centre = self.circle.centre;
        let (rho, k, across) = (place.rho, place.k, place.rho - centre);
        Parabola {
            value: self.inertia + rho * (rho + sigma * k),
            slope: -2.0 * rho * k + sigma * (rho * across - k * k),
            bend: 2.0 * k * k - 2.0 * rho * across - sigma * k * (4.0 * rho - 3.0 * centre),
        }
    }

    /// The nodes of the rule between two w.
    pub(super) fn nodes(&self, low: f64, high: f64, mapping: NodeMapping) -> Nodes {
        Nodes::new(&self.circle, self.rule, low, high, mapping)
    }

    /// The solution at nodes with σ = S μ.
    pub(super) fn solution(&self, nodes: &Nodes, sigma: f64) -> SubintervalSolution {
        nodes.solution(self.rule, self.inertia, sigma)
    }

    /// A subinterval with the minus sign.
    pub(super) fn trailing<'a>(&self, subinterval: &'a Subinterval) -> &'a Trailing {
        subinterval.trailing.get_or_init(|| {
            let minus = self.solution(&subinterval.nodes, -self.friction);
            let difference = subinterval.plus.exponent - minus.exponent;
            // Where the difference has lost digits it is found by itself.
            let gap = if difference > 0.01 * libm::fabs(subinterval.plus.exponent) {
                difference
            } else {
                self.rule.integral(&subinterval.nodes.gap(self.inertia, self.friction))
            };
            Trailing { minus, gap }
        })
    }

    /// This engagement with subintervals so short that values between their nodes are as good as the integrals.
    pub(super) fn refine(&self) -> Result<Self, DynamicsError> {
        Self::divided(&self.parameters, self.reset, self.end, self.tolerance, &Scales::between(self.tolerance))
    }

    /// The escapement.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Turn of the driver from the start of this engagement to that of the next, in radians.
    pub fn reset(&self) -> f64 {
        self.reset
    }

    /// The relative tolerance that was asked for, dimensionless.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Into how many subintervals, of sixteen nodes each, half the engagement was divided.
    pub fn subintervals(&self) -> usize {
        self.subintervals.len()
    }
}

/// A function of ψ about one place, by its first three derivatives.
struct Parabola {
    value: f64,
    slope: f64,
    bend: f64,
}

impl Parabola {
    /// Whether the nearer root, real or complex, is at least so far away; `value` > 0.
    fn has_no_root_within(&self, distance: f64) -> bool {
        let discriminant = self.slope * self.slope - 2.0 * self.value * self.bend;
        if discriminant < 0.0 {
            2.0 * self.value >= distance * distance * self.bend
        } else {
            // 2 value ≥ distance (|slope| + √discriminant), without the root.
            let rest = 2.0 * self.value - distance * libm::fabs(self.slope);
            rest >= 0.0 && rest * rest >= distance * distance * discriminant
        }
    }
}

/// What is asked of a subinterval is this much less than what is asked of the whole. Measured: see the tests.
const SAFETY: f64 = 1.0 / 1024.0;

/// What a subinterval with [`NODES`] nodes resolves.
struct Scales {
    /// Least distance of a pole, in half lengths.
    distance: f64,
    /// Most change of Λ.
    exponent: f64,
    /// Most change of the energy, where the time is asked for.
    energy_range: f64,
}

impl Scales {
    /// For integrals over a subinterval, whose error is the square of that between its nodes.
    fn of_integrals(tolerance: f64) -> Self {
        // Measured: see the tests.
        let energy_range = if tolerance < 1e-11 { 2.0 } else { 3.0 };
        Self { energy_range, ..Self::between((SAFETY * tolerance).sqrt()) }
    }

    /// For values between the nodes.
    ///
    /// A polynomial through n nodes errs as e⁻ⁿ, where e is the sum of the half axes of the ellipse through the pole;
    /// for an exponential function of range x, as (x/2)ⁿ/(2ⁿ⁻¹ n!).
    fn between(tolerance: f64) -> Self {
        let root = sixteenth_root(tolerance);
        Self { distance: (1.0 / root - root) / 2.0, exponent: 2.0 * root * *GROWTH, energy_range: 2.0 }
    }
}

/// The root of order sixteen, by four of order two.
fn sixteenth_root(x: f64) -> f64 {
    const { assert!(NODES == 16) };
    x.sqrt().sqrt().sqrt().sqrt()
}

/// Root of order n of 2ⁿ⁻¹ n!.
static GROWTH: LazyLock<f64> = LazyLock::new(|| {
    let factorial: f64 = (1..=NODES).map(|n| n as f64).product();
    sixteenth_root(factorial * libm::exp2(NODES as f64 - 1.0))
});
