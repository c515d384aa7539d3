//! How likely rounded numbers are, given computed ones.
//!
//! The statistical model: a printed number is the computed one and an error of unknown spread, rounded to the unit of its
//! last place.

use std::f64::consts::SQRT_2;

/// Likelihood of rounded numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Likelihood {
    /// The spread of the errors with which they are most likely, in units of the last place.
    pub spread: f64,
    /// The natural logarithm of the likelihood with this spread, dimensionless: zero if each number is certain, negative infinity if one cannot be.
    pub log: f64,
}

/// Distribution of errors about the computed number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Normal: large errors are all but impossible.
    Normal,
    /// Exponential to either side: large errors happen now and then, as when a print-out is misread.
    Exponential,
}

impl Law {
    /// Both, the normal one first.
    pub const ALL: [Self; 2] = [Self::Normal, Self::Exponential];

    /// The chance of an error above a number of units, which is not negative.
    fn beyond(self, units: f64, spread: f64) -> f64 {
        match self {
            Self::Normal => libm::erfc(units / (spread * SQRT_2)) / 2.0,
            Self::Exponential => libm::exp(-units / spread) / 2.0,
        }
    }

    /// The chance that an error of zero mean rounds to a number so many units away.
    fn chance(self, off: f64, spread: f64) -> f64 {
        let near = off - 0.5;
        let beyond_near = if near < 0.0 { 1.0 - self.beyond(-near, spread) } else { self.beyond(near, spread) };
        beyond_near - self.beyond(off + 0.5, spread)
    }

    /// The natural logarithm, dimensionless, of the likelihood of deviations of this size with this spread, both in units of
    /// the last place.
    pub fn log_likelihood(self, units: &[f64], spread: f64) -> f64 {
        units.iter().map(|off| libm::log(self.chance(*off, spread))).sum()
    }

    /// The likelihood of deviations of this size, in units, with the spread that suits them best.
    pub fn maximum_likelihood(self, units: &[f64]) -> Likelihood {
        let at = |octaves: f64| {
            let spread = LEAST_SPREAD * libm::exp2(octaves);
            Likelihood { spread, log: self.log_likelihood(units, spread) }
        };
        type Trial = (f64, Likelihood);
        let better = |a: Trial, b: Trial| if b.1.log > a.1.log { b } else { a };
        let tried = |octaves: f64| (octaves, at(octaves));
        // First in steps, then between the neighbours of the best.
        let rough = (1..=OCTAVES * PER_OCTAVE).map(|step| f64::from(step) / f64::from(PER_OCTAVE));
        let best = rough.map(tried).fold(tried(0.0), better);
        let fine = (-FINER..=FINER).map(|step| best.0 + f64::from(step) / f64::from(FINER) / f64::from(PER_OCTAVE));
        fine.filter(|octaves| *octaves >= 0.0).map(tried).fold(best, better).1
    }
}

/// Spreads that are tried: from 1/256 of a unit of the last place, 8 to an octave, over 20 octaves, and so many to either
/// side of the best.
pub const LEAST_SPREAD: f64 = 1.0 / 256.0;
const PER_OCTAVE: u32 = 8;
const OCTAVES: u32 = 20;
const FINER: i32 = 32;
