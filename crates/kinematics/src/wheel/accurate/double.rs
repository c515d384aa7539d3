//! Numbers of twice the working precision: an `f64` and what its rounding left out.
//!
//! Every step is an IEEE operation with one result on every machine; no fused multiply-add is asked for, because
//! without the instruction it is slow. All of it can run at compile time. No exponent here is near its limits, so
//! the exactness of sums (Knuth) and of products (Dekker, with Veltkamp's halves) holds throughout.

/// The unevaluated sum of two numbers, the second at most half a unit in the last place of the first.
///
/// Sums, products and quotients are right to about 100 bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::wheel) struct Double {
    /// The nearest `f64`, in the number's own unit.
    pub hi: f64,
    /// What is left, in the number's own unit.
    pub lo: f64,
}

/// The sum of two numbers without loss, the first at least as great in size as the second, or zero.
#[inline]
pub(super) const fn ordered_sum(a: f64, b: f64) -> Double {
    let hi = a + b;
    Double { hi, lo: (a - hi) + b }
}

/// The sum of any two numbers without loss.
const fn sum(a: f64, b: f64) -> Double {
    let hi = a + b;
    let from_b = hi - a;
    Double { hi, lo: (a - (hi - from_b)) + (b - from_b) }
}

/// The product of two numbers without loss.
const fn product(a: f64, b: f64) -> Double {
    let ((a_head, a_tail), (b_head, b_tail)) = (halves(a), halves(b));
    let hi = a * b;
    Double { hi, lo: ((a_head * b_head - hi) + a_head * b_tail + a_tail * b_head) + a_tail * b_tail }
}

/// A number as the sum of two of at most 26 bits each.
const fn halves(x: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0; // 2^27 + 1
    let scaled = FACTOR * x;
    let head = scaled - (scaled - x);
    (head, x - head)
}

impl Double {
    /// π; its own rounding is below 2⁻¹⁰⁸.
    pub(crate) const PI: Self = Self { hi: std::f64::consts::PI, lo: f64::from_bits(0x3ca1_a626_3314_5c07) };
    /// What [`Double::PI`] leaves out of π, dimensionless.
    pub(crate) const PI_REST: f64 = f64::from_bits(0xb92f_1976_b7ed_8fbc);
    /// One.
    pub(crate) const ONE: Self = Self::from(1.0);

    /// A number of working precision.
    pub(crate) const fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }

    /// The sum.
    pub(crate) const fn plus(self, other: Self) -> Self {
        let (high, low) = (sum(self.hi, other.hi), sum(self.lo, other.lo));
        let first = ordered_sum(high.hi, high.lo + low.hi);
        ordered_sum(first.hi, first.lo + low.lo)
    }

    /// The number with the opposite sign.
    pub(crate) const fn negate(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }

    /// The difference.
    pub(crate) const fn minus(self, other: Self) -> Self {
        self.plus(other.negate())
    }

    /// The product.
    pub(crate) const fn times(self, other: Self) -> Self {
        let high = product(self.hi, other.hi);
        ordered_sum(high.hi, high.lo + (self.hi * other.lo + self.lo * other.hi))
    }

    /// The quotient.
    pub(crate) const fn over(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self.minus(other.times(Self::from(first)));
        let second = rest.hi / other.hi;
        let rest = rest.minus(other.times(Self::from(second)));
        ordered_sum(first, second).plus(Self::from(rest.hi / other.hi))
    }

    /// The square root, of a positive number.
    pub(crate) fn root(self) -> Self {
        let first = Self::from(self.hi.sqrt());
        let rest = self.minus(first.times(first));
        first.plus(Self::from(rest.hi / (2.0 * first.hi)))
    }

    /// Half the number.
    pub(crate) const fn half(self) -> Self {
        Self { hi: 0.5 * self.hi, lo: 0.5 * self.lo }
    }

    /// Twice the number.
    pub(crate) const fn twice(self) -> Self {
        Self { hi: 2.0 * self.hi, lo: 2.0 * self.lo }
    }

    /// The number as an integer number of parts of one (a power of two) and the rest, both in its own unit: the product of
    /// the first with a short factor is exact.
    pub(crate) fn split(self, parts_of_one: f64) -> (f64, f64) {
        let head = libm::floor(self.hi * parts_of_one) / parts_of_one;
        (head, (self.hi - head) + self.lo)
    }
}

/// n π / d for integers below 2²⁶, with a second part that is itself right to 50 bits.
///
/// Near the ends of the engagement that second part is all that is left of an angle.
pub(in crate::wheel) fn fraction_of_pi(n: u32, d: u32) -> Double {
    let (n, d) = (f64::from(n), f64::from(d));
    let nearest = Double::PI.times(Double::from(n)).over(Double::from(d)).hi;
    let (from_pi, from_rest, back) = (product(Double::PI.hi, n), product(Double::PI.lo, n), product(nearest, d));
    let rest = sum(from_pi.hi, -back.hi).plus(sum(from_pi.lo, -back.lo)).plus(from_rest);
    let rest = rest.plus(Double::from(Double::PI_REST * n)).over(Double::from(d));
    ordered_sum(nearest, rest.hi)
}
