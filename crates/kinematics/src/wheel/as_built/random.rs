//! A small generator of random numbers that gives the same numbers on every machine.

use nalgebra::Vector2;
use std::f64::consts::PI;

/// The generator SplitMix64: a counter whose values are mixed.
///
/// Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (OOPSLA 2014), figure 17; constants of Vigna's
/// public-domain `splitmix64.c` (2015).
///
/// ```
/// use geneva_kinematics::wheel::as_built::SplitMix64;
///
/// // The first number of the published generator for the seed 1234567.
/// assert_eq!(SplitMix64::new(1_234_567).next_u64(), 6_457_827_717_110_365_317);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SplitMix64 {
    state: u64,
}

/// The odd integer nearest to 2⁶⁴ over the golden ratio.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

impl SplitMix64 {
    /// The generator with this seed.
    pub const fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// The generator of the `index`-th of many things drawn under one seed, whichever is drawn first.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::SplitMix64;
    ///
    /// let numbers = [0, 1].map(|index| SplitMix64::of_index(7, index).next_u64());
    /// assert_ne!(numbers[0], numbers[1]);
    /// ```
    pub fn of_index(seed: u64, index: u64) -> Self {
        let mut first = Self::new(seed ^ index.wrapping_mul(0xd134_2543_de82_ef95));
        Self::new(first.next_u64())
    }

    /// The next 64 bits.
    pub fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(STEP);
        let mut mixed = self.state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// The next number from 0 up to but not including 1, a multiple of 2⁻⁵³, dimensionless.
    pub fn next_unit(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
    }

    /// The next number from −1 up to but not including 1, dimensionless.
    pub fn next_signed(&mut self) -> f64 {
        2.0 * self.next_unit() - 1.0
    }

    /// The next point within a circle of this radius about the origin, in its unit, all points being equally likely.
    pub fn next_within(&mut self, radius: f64) -> Vector2<f64> {
        let (share, turn) = (self.next_unit(), self.next_unit());
        let (sine, cosine) = libm::sincos(2.0 * PI * turn);
        Vector2::new(cosine, sine) * (radius * share.sqrt())
    }

    /// The next number of the standard normal distribution, by the polar method of Marsaglia, dimensionless.
    pub fn next_normal(&mut self) -> f64 {
        loop {
            let (x, y) = (self.next_signed(), self.next_signed());
            let square = x * x + y * y;
            if square > 0.0 && square < 1.0 {
                return x * (-2.0 * libm::log(square) / square).sqrt();
            }
        }
    }
}
