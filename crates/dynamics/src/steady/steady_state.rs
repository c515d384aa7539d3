//! The steady state: the motion that repeats itself from engagement to engagement, the fixed point of the return map.
//!
//! For a switch at ψ the speed is known there (u = Q). Backward from there to entry it is a₁ u − b₁, forward to the end
//! a₂ u + b₂, all four positive. Repetition means u = (b₁ + b₂)/(a₁ − a₂), and a₂/a₁ is the multiplier κ of the return
//! map, so that a₁ − a₂ = a₁ (1 − κ) is found without cancellation. The switch is where the two agree: there is one,
//! because u_end(u_entry) rises everywhere by less than the difference at entry.

use super::contact_reversal::{ContactReversal, Split, SplitPart};
use super::engagement::{Engagement, Subinterval, Trailing, exponents};
use super::extremes::Extreme;
use super::quadrature::{NodalValues, dot};
use super::subinterval::SubintervalSolution;
use crate::DynamicsError;
use std::cell::LazyCell;

/// The motion that repeats itself. Speeds are the driver's θ'.
///
/// ```
/// use geneva_dynamics::steady::Engagement;
/// use geneva_dynamics::{DynamicsError, Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
/// use std::f64::consts::FRAC_PI_2;
///
/// let timer = |friction| Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, friction);
/// let steady = Engagement::new(&timer(0.2)?)?.steady_state()?;
/// assert!((steady.mean_speed * steady.period - FRAC_PI_2).abs() < 1e-12); // four pins: a quarter of a turn
/// assert!(0.0 < steady.multiplier && steady.multiplier < 1.0);
/// assert!(steady.minimum.speed < steady.mean_of_extremes() && steady.mean_of_extremes() < steady.peak.speed);
/// // Without friction the speed grows without end.
/// assert!(matches!(Engagement::new(&timer(0.0)?)?.steady_state(), Err(DynamicsError::NoTerminalSpeed { .. })));
/// # Ok::<(), DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyState {
    /// Speed at the start of each engagement, and at its end, in radians per unit of time.
    pub entry_speed: f64,
    /// Greatest speed in the cycle: the true one, wherever it is.
    pub peak: Extreme,
    /// Least speed in the cycle.
    pub minimum: Extreme,
    /// Time from one engagement to the next, in units of time.
    pub period: f64,
    /// Reset angle over period, in radians per unit of time. Meyer 1973, Recommendation 7, asks for it.
    pub mean_speed: f64,
    /// Crank angle in radians where friction changes its sign past the line of centres; none if the end comes before.
    ///
    /// The other change is at 0.
    pub reversal_angle: Option<f64>,
    /// Factor by which one engagement reduces a small difference of the squares of two speeds, dimensionless; between 0
    /// and 1.
    ///
    /// Differences of speeds are reduced by the same factor.
    pub multiplier: f64,
}

impl SteadyState {
    /// Arithmetic mean of the greatest and the least speed, in radians per unit of time.
    ///
    /// Meyer 1973, chapter II: "average terminal velocity".
    pub fn mean_of_extremes(&self) -> f64 {
        f64::midpoint(self.peak.speed, self.minimum.speed)
    }
}

/// The maps from u at the contact reversal: backward to entry, and forward to the end.
struct Balance {
    /// a₁, b₁.
    back: (f64, f64),
    /// a₂, b₂.
    forth: (f64, f64),
}

impl Balance {
    /// For a switch at a place: e^Λ and J of the plus sign to the exit, and to the place, and what follows.
    fn new(all: (f64, f64), through: (f64, f64), forth: (f64, f64)) -> Self {
        Self { back: (all.0 / through.0, all.0 * (through.1 + all.1)), forth }
    }

    /// The u at the switch that repeats itself, from ln of the multiplier.
    fn repeated(&self, log: f64) -> f64 {
        (self.back.1 + self.forth.1) / (self.back.0 * -libm::expm1(log))
    }

    /// The u at the switch that repeats itself to some digits, without a logarithm if there is little cancellation.
    fn about(&self, log: impl FnOnce() -> f64) -> f64 {
        let difference = self.back.0 - self.forth.0;
        if difference > 1e-6 * self.back.0 { (self.back.1 + self.forth.1) / difference } else { self.repeated(log()) }
    }

    /// u at the end of the engagement, and at entry, from that at the switch.
    fn end(&self, square: f64) -> f64 {
        self.forth.0 * square + self.forth.1
    }
}

/// The motion with the minus sign from a place to the end: a factor and an offset of u, and ln of the multiplier.
#[derive(Clone, Copy)]
struct Rest {
    on: (f64, f64),
    log: f64,
}

/// The fixed point of the return map.
pub(super) struct FixedPoint {
    /// u at entry, dimensionless.
    pub entry: f64,
    /// The contact reversal.
    pub split: Option<Split>,
    /// ln of the multiplier, dimensionless.
    pub log: f64,
}

impl Engagement {
    /// The steady state of this engagement: the motion that the return map leaves unchanged.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NoTerminalSpeed`] without friction, reset at the exit: the speed grows without end.
    pub fn steady_state(&self) -> Result<SteadyState, DynamicsError> {
        let repeated = self.fixed_point()?;
        let passage = self.pass_with(repeated.entry, repeated.split.as_ref());
        let [peak, minimum] = passage.extremes();
        let period = passage.duration();
        Ok(SteadyState {
            entry_speed: passage.entry_speed(),
            peak,
            minimum,
            period,
            mean_speed: self.reset() / period,
            reversal_angle: passage.reversal_angle(),
            multiplier: libm::exp(repeated.log),
        })
    }

    /// Entry speed, in radians per unit of time, and period, in units of time, of the steady state alone, for two
    /// thirds of the price: for maps of many escapements. The numbers are the same to the last bit.
    ///
    /// ```
    /// use geneva_dynamics::steady::Engagement;
    /// use geneva_dynamics::{Inertias, Parameters};
    /// use geneva_kinematics::Mechanism;
    ///
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
    /// let engagement = Engagement::new(&timer)?;
    /// let whole = engagement.steady_state()?;
    /// assert_eq!(engagement.entry_speed_and_period()?, (whole.entry_speed, whole.period));
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`].
    pub fn entry_speed_and_period(&self) -> Result<(f64, f64), DynamicsError> {
        let FixedPoint { entry, split, .. } = self.fixed_point()?;
        Ok((self.unit * entry.sqrt(), self.time_with(entry, split.as_ref()) / self.unit))
    }

    /// The fixed point of the return map.
    pub(super) fn fixed_point(&self) -> Result<FixedPoint, DynamicsError> {
        let short = self.ends_before_centres || self.to_end < self.to_exit;
        if let Some(entry) = short.then(|| self.fixed_point_without_reversal()).flatten() {
            return Ok(FixedPoint { entry, split: None, log: self.log_multiplier(None) });
        }
        let (exit, end) = (self.to_exit, self.to_end);
        let mut rest = Rest { on: (1.0, 0.0), log: -exponents(&self.subintervals[end.min(exit)..exit]) };
        for subinterval in self.subintervals[exit.min(end)..end].iter().rev() {
            rest = self.rest_with(subinterval, rest, true);
        }
        // Without friction the multiplier does not depend on the switch, and there must be some by the reset angle.
        if self.friction == 0.0 && -libm::expm1(rest.log) <= 4.0 * f64::EPSILON {
            return Err(DynamicsError::NoTerminalSpeed { multiplier: libm::exp(rest.log) });
        }
        // From the end on, until a subinterval starts before the switch.
        let all = self.subintervals[..exit].last().map_or((1.0, 0.0), Subinterval::upper_integrals);
        let mut number = end.min(exit) - 1;
        let mut high = f64::NEG_INFINITY;
        let low = loop {
            let subinterval = &self.subintervals[number];
            let before = self.rest_with(subinterval, rest, false);
            let square = Balance::new(all, subinterval.before, before.on).about(|| before.log);
            let low = self.switching_function(subinterval.nodes.low, if number == 0 { 0.0 } else { square });
            if number == 0 || low > 0.0 {
                break low;
            }
            (rest, high, number) = (before, low, number - 1);
        };
        let (entry, split, log) = self.fixed_point_within(number, [low, high], all, rest);
        if entry.is_finite() {
            Ok(FixedPoint { entry, split, log })
        } else {
            Err(DynamicsError::NoTerminalSpeed { multiplier: 1.0 })
        }
    }

    /// u at entry, the division and ln of the multiplier if the switch is in this subinterval. `ends` is the excess at
    /// its ends, `all` the plus sign from the line of centres to the exit, `rest` what follows the subinterval.
    fn fixed_point_within(
        &self,
        number: usize,
        ends: [f64; 2],
        all: (f64, f64),
        rest: Rest,
    ) -> (f64, Option<Split>, f64) {
        let subinterval = &self.subintervals[number];
        let (nodes, trailing) = (&subinterval.nodes, self.trailing(subinterval));
        let gap = LazyCell::new(|| self.rule.cumulative(&nodes.gap(self.inertia, self.friction)).0);
        let coarse = |shares: &NodalValues| {
            let [plus, minus] = [&subinterval.plus, &trailing.minus].map(|of| of.interpolate(shares));
            let factor = rest.on.0 * trailing.minus.factor_end;
            let forth = (factor / minus.0, rest.on.1 + factor * (trailing.minus.integral_end - minus.1));
            let (product, sum) = subinterval.before;
            let balance = Balance::new(all, (product * plus.0, sum + plus.1 / product), forth);
            balance.about(|| rest.log - (trailing.gap - dot(shares, &gap)))
        };
        let mut last: Option<(f64, f64, Box<[SplitPart; 2]>)> = None;
        let fine = |w: f64| {
            let before = self.part(nodes.low, w, self.friction);
            let after = self.part(w, nodes.high, -self.friction);
            let gap = self.rule.integral(&after.nodes.gap(self.inertia, self.friction));
            let rest = on_with(&after.solution, rest, -gap);
            let (product, sum) = subinterval.before;
            let through = (product * before.solution.factor_end, sum + before.solution.integral_end / product);
            let balance = Balance::new(all, through, rest.on);
            let square = balance.repeated(rest.log);
            // Level in w at the switch, as u at the switch moves with the motion.
            last = Some((balance.end(square), rest.log, Box::new([before, after])));
            square
        };
        let found = self.reversal_within(nodes, ends, coarse, fine);
        let Some((entry, log, parts)) = last else { return (f64::NAN, None, f64::NAN) };
        // The multiplier starts at the switch, not where the subinterval is divided.
        let log = log + self.gap_at(found.at) * (found.reversal - found.at);
        let reversal = ContactReversal { subinterval: number, at: found.reversal };
        (entry, Some(Split { reversal, square: found.square, parts }), log)
    }

    /// What follows the lower end of a subinterval, from what follows its upper end.
    fn rest_with(&self, subinterval: &Subinterval, rest: Rest, beyond: bool) -> Rest {
        let Trailing { minus, gap } = self.trailing(subinterval);
        on_with(minus, rest, if beyond { minus.exponent } else { -gap })
    }

    /// u at entry, if the end of the engagement comes before the switch.
    fn fixed_point_without_reversal(&self) -> Option<f64> {
        let last = if self.ends_before_centres { self.to_end } else { 0 };
        // u at the end is the offset, and a part of u at entry.
        let mut offset = 0.0;
        for subinterval in self.subintervals[last..self.to_exit].iter().rev() {
            offset = subinterval.plus.approach(offset);
        }
        let beyond = if self.ends_before_centres { &[][..] } else { &self.subintervals[..self.to_end] };
        for subinterval in beyond {
            offset = subinterval.plus.up(offset);
        }
        let entry = offset / -libm::expm1(-exponents(&self.subintervals[self.to_end..self.to_exit]));
        let is_reversed = || self.switching_function(self.subintervals[self.to_end - 1].nodes.high, entry) <= 0.0;
        (self.ends_before_centres || !is_reversed()).then_some(entry)
    }
}

/// What follows a part with the minus sign, put after it.
fn on_with(minus: &SubintervalSolution, rest: Rest, log: f64) -> Rest {
    let factor = rest.on.0 * minus.factor_end;
    Rest { on: (factor, rest.on.1 + factor * minus.integral_end), log: rest.log + log }
}
