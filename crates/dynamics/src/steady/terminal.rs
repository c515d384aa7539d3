//! The steady state: the motion that repeats itself from engagement to engagement.
//!
//! For a switch at ψ the speed is known there (u = Q). Backward from there to entry it is a₁ u − b₁, forward to the end
//! a₂ u + b₂, all four positive. Repetition means u = (b₁ + b₂)/(a₁ − a₂), and a₂/a₁ is the contraction κ, so that
//! a₁ − a₂ = a₁ (1 − κ) is found without cancellation. The switch is where the two agree: there is one, because
//! u_end(u_entry) rises everywhere by less than the difference at entry.

use super::engagement::{Engagement, Panel};
use super::error::SteadyError;
use super::extremes::Extreme;
use super::rule::{Row, dot};
use super::stretch::Branch;
use super::switch::{Part, Split, Switch};
use std::cell::LazyCell;

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

/// What a [`SteadyState`] is without its extremes, for two thirds of the price. The numbers are the same to the last bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Terminal {
    /// [`SteadyState::entry_speed`].
    pub entry_speed: f64,
    /// [`SteadyState::period`].
    pub period: f64,
    /// [`SteadyState::mean_speed`].
    pub mean_speed: f64,
    /// [`SteadyState::switch_angle`].
    pub switch_angle: Option<f64>,
    /// [`SteadyState::contraction`].
    pub contraction: f64,
}

/// a₁, b₁, a₂, b₂.
struct Balance {
    back: (f64, f64),
    forth: (f64, f64),
}

impl Balance {
    /// For a switch at a place: e^Λ and J of the plus sign to the exit, and to the place, and what follows.
    fn new(all: (f64, f64), through: (f64, f64), forth: (f64, f64)) -> Self {
        Self { back: (all.0 / through.0, all.0 * (through.1 + all.1)), forth }
    }

    /// The u at the switch that repeats itself, from ln of the contraction.
    fn repeated(&self, log: f64) -> f64 {
        (self.back.1 + self.forth.1) / (self.back.0 * -libm::expm1(log))
    }

    /// The same to some digits, without a logarithm if there is little cancellation.
    fn about(&self, log: impl FnOnce() -> f64) -> f64 {
        let difference = self.back.0 - self.forth.0;
        if difference > 1e-6 * self.back.0 { (self.back.1 + self.forth.1) / difference } else { self.repeated(log()) }
    }

    /// u at the end of the engagement, and at entry, from that at the switch.
    fn end(&self, square: f64) -> f64 {
        self.forth.0 * square + self.forth.1
    }
}

/// The motion with the minus sign from a place to the end: a factor and an offset of u, and ln of the contraction.
#[derive(Clone, Copy)]
struct Rest {
    on: (f64, f64),
    log: f64,
}

/// The motion that repeats itself: u at entry, where it switches, ln of the contraction.
pub(super) struct Repeated {
    pub entry: f64,
    pub split: Option<Split>,
    pub log: f64,
}

impl Engagement {
    /// The steady state.
    ///
    /// # Errors
    ///
    /// [`SteadyError::NoTerminalSpeed`] without friction, folded at the exit: the speed grows without end.
    pub fn steady_state(&self) -> Result<SteadyState, SteadyError> {
        let repeated = self.repeated()?;
        let passage = self.pass_with(repeated.entry, repeated.split.as_ref());
        let [peak, minimum] = passage.extremes();
        let period = passage.duration();
        Ok(SteadyState {
            entry_speed: passage.entry_speed(),
            peak,
            minimum,
            period,
            mean_speed: self.fold() / period,
            switch_angle: passage.switch_angle(),
            contraction: libm::exp(repeated.log),
        })
    }

    /// The steady state without its extremes: for maps of many escapements.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`].
    pub fn terminal(&self) -> Result<Terminal, SteadyError> {
        let Repeated { entry, split, log } = self.repeated()?;
        let period = self.time_with(entry, split.as_ref()) / self.unit;
        Ok(Terminal {
            entry_speed: self.unit * entry.sqrt(),
            period,
            mean_speed: self.fold() / period,
            switch_angle: split.map(|split| self.circle.angle(split.switch.at)),
            contraction: libm::exp(log),
        })
    }

    /// The motion that repeats itself.
    pub(super) fn repeated(&self) -> Result<Repeated, SteadyError> {
        let short = self.ends_before_centres || self.to_end < self.to_exit;
        if let Some(entry) = short.then(|| self.repeated_without_switch()).flatten() {
            return Ok(Repeated { entry, split: None, log: self.log_contraction(None) });
        }
        let (exit, end) = (self.to_exit, self.to_end);
        let mut rest = Rest { on: (1.0, 0.0), log: -exponents(&self.panels[end.min(exit)..exit]) };
        for panel in self.panels[exit.min(end)..end].iter().rev() {
            rest = self.rest_with(panel, rest, true);
        }
        // Without friction the contraction does not depend on the switch, and there must be some by the fold.
        if self.friction == 0.0 && -libm::expm1(rest.log) <= 4.0 * f64::EPSILON {
            return Err(SteadyError::NoTerminalSpeed { contraction: libm::exp(rest.log) });
        }
        // From the end on, until a stretch starts before the switch.
        let all = self.panels[..exit].last().map_or((1.0, 0.0), Panel::after);
        let mut number = end.min(exit) - 1;
        let mut high = f64::NEG_INFINITY;
        let low = loop {
            let panel = &self.panels[number];
            let before = self.rest_with(panel, rest, false);
            let square = Balance::new(all, panel.before, before.on).about(|| before.log);
            let low = self.excess(panel.points.low, if number == 0 { 0.0 } else { square });
            if number == 0 || low > 0.0 {
                break low;
            }
            (rest, high, number) = (before, low, number - 1);
        };
        let (entry, split, log) = self.repeated_within(number, [low, high], all, rest);
        if entry.is_finite() {
            Ok(Repeated { entry, split, log })
        } else {
            Err(SteadyError::NoTerminalSpeed { contraction: 1.0 })
        }
    }

    /// u at entry, the division and ln of the contraction if the switch is in this stretch. `ends` is the excess at its
    /// ends, `all` the plus sign from the line of centres to the exit, `rest` what follows the stretch.
    fn repeated_within(&self, number: usize, ends: [f64; 2], all: (f64, f64), rest: Rest) -> (f64, Option<Split>, f64) {
        let panel = &self.panels[number];
        let (points, held) = (&panel.points, self.held(panel));
        let gap = LazyCell::new(|| self.rule.cumulative(&points.gap(self.inertia, self.friction)).0);
        let coarse = |shares: &Row| {
            let (growth, drive) = panel.plus.between(shares);
            let (held_growth, held_drive) = held.minus.between(shares);
            let factor = rest.on.0 * held.minus.growth_end;
            let forth = (factor / held_growth, rest.on.1 + factor * (held.minus.drive_end - held_drive));
            let (product, sum) = panel.before;
            let balance = Balance::new(all, (product * growth, sum + drive / product), forth);
            balance.about(|| rest.log - (held.gap - dot(shares, &gap)))
        };
        let mut last: Option<(f64, f64, Box<[Part; 2]>)> = None;
        let fine = |w: f64| {
            let before = self.part(points.low, w, self.friction);
            let after = self.part(w, points.high, -self.friction);
            let gap = self.rule.integral(&after.points.gap(self.inertia, self.friction));
            let rest = on_with(&after.branch, rest, -gap);
            let (product, sum) = panel.before;
            let through = (product * before.branch.growth_end, sum + before.branch.drive_end / product);
            let balance = Balance::new(all, through, rest.on);
            let square = balance.repeated(rest.log);
            // Level in w at the switch, as u at the switch moves with the motion.
            last = Some((balance.end(square), rest.log, Box::new([before, after])));
            square
        };
        let found = self.switch_within(points, ends, coarse, fine);
        let Some((entry, log, parts)) = last else { return (f64::NAN, None, f64::NAN) };
        // The contraction starts at the switch, not where the stretch is divided.
        let log = log + self.gap_at(found.at) * (found.switch - found.at);
        let switch = Switch { panel: number, at: found.switch };
        (entry, Some(Split { switch, square: found.square, parts }), log)
    }

    /// What follows the lower end of a stretch, from what follows its upper end.
    fn rest_with(&self, panel: &Panel, rest: Rest, beyond: bool) -> Rest {
        let held = self.held(panel);
        on_with(&held.minus, rest, if beyond { held.minus.exponent } else { -held.gap })
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
        let entry = offset / -libm::expm1(-exponents(&self.panels[self.to_end..self.to_exit]));
        let switches = || self.excess(self.panels[self.to_end - 1].points.high, entry) <= 0.0;
        (self.ends_before_centres || !switches()).then_some(entry)
    }
}

/// ln of the growth with the plus sign over stretches.
fn exponents(panels: &[Panel]) -> f64 {
    panels.iter().map(|panel| panel.plus.exponent).sum()
}

/// What follows a part with the minus sign, put after it.
fn on_with(minus: &Branch, rest: Rest, log: f64) -> Rest {
    let factor = rest.on.0 * minus.growth_end;
    Rest { on: (factor, rest.on.1 + factor * minus.drive_end), log: rest.log + log }
}
