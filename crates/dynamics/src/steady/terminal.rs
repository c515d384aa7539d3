//! The steady state: the motion that repeats itself from engagement to engagement.
//!
//! For a switch at ψ the speed is known there (u = Q). Backward from there to entry it is a₁ u − b₁, forward to the end
//! a₂ u + b₂, all four positive. Repetition means u = (b₁ + b₂)/(a₁ − a₂), and a₂/a₁ is the contraction κ, so that
//! a₁ − a₂ = a₁ (1 − κ) is found without cancellation. The switch is where the two agree: there is one, because
//! u_end(u_entry) rises everywhere by less than the difference at entry.

use super::engagement::Engagement;
use super::error::SteadyError;
use super::extremes::Extreme;
use super::rule::{Row, dot};
use super::stretch::{Points, Spread};
use super::switch::Switch;
use std::cell::Cell;

/// The motion that repeats itself. Speeds are the driver's θ', in radians per unit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyState {
    /// Speed at the start of each engagement, and at its end.
    pub entry_speed: f64,
    /// Greatest speed in the cycle: the true one, wherever it is.
    pub peak: Extreme,
    /// Least speed in the cycle.
    pub minimum: Extreme,
    /// Units of time from one engagement to the next.
    pub period: f64,
    /// Fold over period. Meyer 1973, Recommendation 7, asks for it.
    pub mean_speed: f64,
    /// Crank angle in radians where friction changes its sign past the line of centres; none if the end comes before.
    ///
    /// The other change is at 0.
    pub switch_angle: Option<f64>,
    /// Factor by which one engagement reduces a small difference of the squares of two speeds; between 0 and 1.
    ///
    /// Differences of speeds are reduced by the same factor.
    pub contraction: f64,
}

impl SteadyState {
    /// Arithmetic mean of the greatest and the least speed. Meyer 1973, chapter II: "average terminal velocity".
    pub fn mean_of_extremes(&self) -> f64 {
        f64::midpoint(self.peak.speed, self.minimum.speed)
    }
}

/// a₁, b₁, a₂, b₂ and 1 − κ.
struct Balance {
    back: (f64, f64),
    forth: (f64, f64),
    loss: f64,
}

impl Balance {
    /// The u at the switch that repeats itself.
    fn repeated(&self) -> f64 {
        (self.back.1 + self.forth.1) / (self.back.0 * self.loss)
    }
}

/// Products and sums up to the lower end of each stretch with the plus sign, and from there to the end with the minus
/// sign.
struct Sums {
    up: Vec<(f64, f64)>,
    on: Vec<(f64, f64)>,
    /// ln of the contraction from the lower end of each stretch on.
    log: Vec<f64>,
}

impl Engagement {
    /// The steady state.
    ///
    /// # Errors
    ///
    /// [`SteadyError::NoTerminalSpeed`] without friction, folded at the exit: the speed grows without end.
    pub fn steady_state(&self) -> Result<SteadyState, SteadyError> {
        let (entry, switch) = self.repeated_entry()?;
        let log = self.log_contraction(switch);
        let passage = self.pass_with(entry, switch);
        let [peak, minimum] = passage.extremes();
        let period = passage.duration();
        Ok(SteadyState {
            entry_speed: passage.entry_speed(),
            peak,
            minimum,
            period,
            mean_speed: self.fold() / period,
            switch_angle: passage.switch_angle(),
            contraction: libm::exp(log),
        })
    }

    /// u at entry in the steady state, and the switch.
    pub(super) fn repeated_entry(&self) -> Result<(f64, Option<Switch>), SteadyError> {
        let short = self.ends_before_centres || self.to_end < self.to_exit;
        if let Some(entry) = short.then(|| self.repeated_without_switch()).flatten() {
            return Ok((entry, None));
        }
        let sums = self.sums();
        let loss = -libm::expm1(sums.log[0]);
        // Without friction the contraction does not depend on the switch.
        let brakes = if self.friction == 0.0 { loss > 4.0 * f64::EPSILON } else { loss > 0.0 };
        if !brakes {
            return Err(SteadyError::NoTerminalSpeed { contraction: libm::exp(sums.log[0]) });
        }
        let last = self.to_end.min(self.to_exit) - 1;
        let panel = (0..last).find(|&number| {
            let balance = self.balance_at_end(&sums, number);
            self.excess(self.panels[number].points.high, balance.repeated()) <= 0.0
        });
        let number = panel.unwrap_or(last);
        let panel = &self.panels[number];
        let gap = self.rule.cumulative(&panel.points.gap(self.inertia, self.friction));
        let coarse = |shares: &Row| self.balance_within(&sums, number, shares, dot(shares, &gap)).repeated();
        let end = Cell::new(f64::NAN);
        let fine = |w: f64| {
            let balance = self.balance_at(&sums, number, w);
            let square = balance.repeated();
            // Level in w at the switch, as u at the switch moves with the motion.
            end.set(balance.forth.0 * square + balance.forth.1);
            square
        };
        let switch = self.switch_within(number, coarse, fine);
        let entry = end.get();
        if entry.is_finite() {
            Ok((entry, Some(switch)))
        } else {
            Err(SteadyError::NoTerminalSpeed { contraction: 1.0 })
        }
    }

    /// u at entry, if the end of the engagement comes before the switch.
    fn repeated_without_switch(&self) -> Option<f64> {
        let last = if self.ends_before_centres { self.to_end } else { 0 };
        // u at the end is the offset, and a part of u at entry.
        let mut offset = 0.0;
        for panel in self.panels[last..self.to_exit].iter().rev() {
            offset = panel.plus.approach(offset);
        }
        let beyond = if self.ends_before_centres { &[][..] } else { &self.panels[..self.to_end] };
        for panel in beyond {
            offset = panel.plus.up(offset);
        }
        let rest: f64 = self.panels[self.to_end..self.to_exit].iter().map(|panel| panel.plus.exponent).sum();
        let entry = offset / -libm::expm1(-rest);
        let switches = || self.excess(self.panels[self.to_end - 1].points.high, entry) <= 0.0;
        (self.ends_before_centres || !switches()).then_some(entry)
    }

    fn sums(&self) -> Sums {
        let (exit, end) = (self.to_exit, self.to_end);
        let mut up = Vec::with_capacity(exit + 1);
        let (mut product, mut sum) = (1.0, 0.0);
        up.push((product, sum));
        for panel in &self.panels[..exit] {
            sum += panel.plus.drive_end / product;
            product *= panel.plus.growth_end;
            up.push((product, sum));
        }
        let (mut on, mut log) = (vec![(1.0, 0.0); end + 1], vec![0.0; end + 1]);
        log[end] = -self.panels[end.min(exit)..exit].iter().map(|panel| panel.plus.exponent).sum::<f64>();
        for number in (0..end).rev() {
            let branch = &self.panels[number].minus;
            let (factor, offset) = on[number + 1];
            let factor = factor * branch.growth_end;
            on[number] = (factor, offset + factor * branch.drive_end);
            log[number] = log[number + 1] + if number < exit { -self.panels[number].gap } else { branch.exponent };
        }
        Sums { up, on, log }
    }

    /// For a switch at the upper end of a stretch.
    fn balance_at_end(&self, sums: &Sums, number: usize) -> Balance {
        let (all, drive) = sums.up[self.to_exit];
        let (product, sum) = sums.up[number + 1];
        Balance {
            back: (all / product, all * (sum + drive)),
            forth: sums.on[number + 1],
            loss: -libm::expm1(sums.log[number + 1]),
        }
    }

    /// For a switch within a stretch, by what its points count there.
    fn balance_within(&self, sums: &Sums, number: usize, shares: &Row, gap: f64) -> Balance {
        let panel = &self.panels[number];
        let (all, drive) = sums.up[self.to_exit];
        let (product, sum) = sums.up[number];
        let (growth, part) = panel.plus.between(shares);
        let (held, held_part) = panel.minus.between(shares);
        let (factor, offset) = sums.on[number + 1];
        let factor = factor * panel.minus.growth_end;
        Balance {
            back: (all / (product * growth), all * (sum + part / product + drive)),
            forth: (factor / held, offset + factor * (panel.minus.drive_end - held_part)),
            loss: -libm::expm1(sums.log[number + 1] - (panel.gap - gap)),
        }
    }

    /// For a switch within a stretch, on points of its own.
    fn balance_at(&self, sums: &Sums, number: usize, w: f64) -> Balance {
        let panel = &self.panels[number].points;
        let (all, drive) = sums.up[self.to_exit];
        let (product, sum) = sums.up[number];
        let before = Points::new(&self.circle, self.rule, panel.low, w, Spread::Even);
        let after = Points::new(&self.circle, self.rule, w, panel.high, Spread::Even);
        let plus = before.branch(self.rule, self.inertia, self.friction);
        let minus = after.branch(self.rule, self.inertia, -self.friction);
        let gap = self.rule.integral(&after.gap(self.inertia, self.friction));
        let (factor, offset) = sums.on[number + 1];
        let factor = factor * minus.growth_end;
        Balance {
            back: (all / (product * plus.growth_end), all * (sum + plus.drive_end / product + drive)),
            forth: (factor, offset + factor * minus.drive_end),
            loss: -libm::expm1(sums.log[number + 1] - gap),
        }
    }
}
