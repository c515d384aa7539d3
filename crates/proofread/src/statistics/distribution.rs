//! Tail probabilities and quantiles of the distributions that tests are made with.
//!
//! Regularised incomplete gamma and beta functions by their series and continued fractions: Abramowitz and Stegun, *Handbook of
//! Mathematical Functions*, 6.5.29, 6.5.31 and 26.5.8. The relative error is below 1e-9 up to a million degrees of freedom.

use libm::{erfc, exp, lgamma, log};
use std::f64::consts::SQRT_2;

/// Degrees of freedom from which on a distribution is taken for its limit.
const MANY: f64 = 1e7;

/// Most terms of a series or a continued fraction.
const MOST_TERMS: u32 = 100_000;

/// Probability that a standard normal variable exceeds `z` in size, on either side.
pub(super) fn normal_two_sided(z: f64) -> f64 {
    erfc(z.abs() / SQRT_2)
}

/// Probability that a variable with Student's distribution with `df` > 0 degrees of freedom exceeds `t` in size, on either side.
pub(super) fn student_two_sided(t: f64, df: f64) -> f64 {
    let square = t * t;
    if df > MANY { normal_two_sided(t) } else { beta_regularised([df / 2.0, 0.5], [df, square]) }
}

/// Probability that a variable with Fisher's distribution with these degrees of freedom, both > 0, exceeds `f`.
pub(super) fn fisher_upper(f: f64, between: f64, within: f64) -> f64 {
    match f {
        f if f <= 0.0 => 1.0,
        f if within > MANY => chi_squared_upper(between * f, between),
        f => beta_regularised([within / 2.0, between / 2.0], [within, between * f]),
    }
}

/// Probability that a variable with the χ² distribution with `df` > 0 degrees of freedom exceeds `x`.
pub(super) fn chi_squared_upper(x: f64, df: f64) -> f64 {
    if x <= 0.0 { 1.0 } else { gamma_upper(df.min(MANY) / 2.0, x / 2.0) }
}

/// The value that a standard normal variable exceeds in size with the probability `p` in (0, 1).
pub(super) fn normal_quantile(p: f64) -> f64 {
    exceeded_with(p, &normal_two_sided)
}

/// The value that a variable with Student's distribution with `df` degrees of freedom exceeds in size with the probability `p`.
pub(super) fn student_quantile(p: f64, df: f64) -> f64 {
    exceeded_with(p, &|t| student_two_sided(t, df))
}

/// Where a falling function has the value `p`, by halving.
fn exceeded_with(p: f64, tail: &dyn Fn(f64) -> f64) -> f64 {
    let mut high = 1.0;
    while tail(high) > p && high < 1e12 {
        high *= 2.0;
    }
    let mut low = 0.0;
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if tail(middle) > p { low = middle } else { high = middle }
    }
    f64::midpoint(low, high)
}

/// Regularised incomplete beta function of x = u/(u + v) with the parameters `a` and `b`.
fn beta_regularised([a, b]: [f64; 2], [u, v]: [f64; 2]) -> f64 {
    let (x, rest) = (u / (u + v), v / (u + v));
    if x.is_nan() || rest <= 0.0 {
        return 1.0;
    }
    if x <= 0.0 {
        return 0.0;
    }
    let front = exp(lgamma(a + b) - lgamma(a) - lgamma(b) + a * log(x) + b * log(rest));
    if x < (a + 1.0) / (a + b + 2.0) {
        front * beta_fraction(a, b, x) / a
    } else {
        1.0 - front * beta_fraction(b, a, rest) / b
    }
}

/// The continued fraction of the incomplete beta function, by Lentz's method.
fn beta_fraction(a: f64, b: f64, x: f64) -> f64 {
    let mut fraction = LentzFraction::new(1.0, 1.0 / nonzero(1.0 - (a + b) * x / (a + 1.0)));
    fraction.value = fraction.denominator;
    for term in 1..MOST_TERMS {
        let m = f64::from(term);
        fraction.add(m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m)), 1.0);
        let last = fraction.add(-(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0)), 1.0);
        if (last - 1.0).abs() < 1e-15 {
            break;
        }
    }
    fraction.value
}

/// Regularised upper incomplete gamma function of `x` > 0 with the parameter `a`.
fn gamma_upper(a: f64, x: f64) -> f64 {
    let front = exp(a * log(x) - x - lgamma(a));
    if x < a + 1.0 {
        let (mut term, mut sum) = (1.0 / a, 1.0 / a);
        for n in 1..MOST_TERMS {
            term *= x / (a + f64::from(n));
            sum += term;
            if term < 1e-16 * sum {
                break;
            }
        }
        return (1.0 - front * sum).max(0.0);
    }
    let start = x + 1.0 - a;
    let mut fraction = LentzFraction::new(1e300, 1.0 / nonzero(start));
    fraction.value = fraction.denominator;
    for n in 1..MOST_TERMS {
        let n = f64::from(n);
        let last = fraction.add(-n * (n - a), start + 2.0 * n);
        if (last - 1.0).abs() < 1e-15 {
            break;
        }
    }
    front * fraction.value
}

/// A continued fraction so far: its value, and the quotients of neighbouring numerators and denominators.
struct LentzFraction {
    value: f64,
    numerator: f64,
    denominator: f64,
}

impl LentzFraction {
    fn new(numerator: f64, denominator: f64) -> Self {
        Self { value: 1.0, numerator, denominator }
    }

    /// Adds a term `above / (beside + …)`; by how much it changes the value.
    fn add(&mut self, above: f64, beside: f64) -> f64 {
        self.denominator = 1.0 / nonzero(beside + above * self.denominator);
        self.numerator = nonzero(beside + above / self.numerator);
        let change = self.numerator * self.denominator;
        self.value *= change;
        change
    }
}

fn nonzero(value: f64) -> f64 {
    if value.abs() < 1e-300 { 1e-300 } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use libm::sqrt;

    fn near(computed: f64, known: f64) {
        assert!((computed - known).abs() <= 1e-9 * known.abs(), "{computed} for {known}");
    }

    /// Closed forms: Student's distribution with 1 and 2 degrees of freedom, Fisher's with 2 above, χ² with 2, 4 and 6.
    #[test]
    fn tails_agree_with_closed_forms() {
        for t in [0.01, 0.3, 1.0, 2.2, 12.706, 300.0] {
            near(student_two_sided(t, 1.0), 1.0 - 2.0 / std::f64::consts::PI * libm::atan(t));
            let tail = sqrt(2.0 + t * t);
            near(student_two_sided(t, 2.0), 2.0 / (tail * (tail + t)));
            near(student_two_sided(-t, 7.0), fisher_upper(t * t, 1.0, 7.0));
        }
        for x in [0.02, 1.0, 3.91, 17.0, 60.0] {
            near(chi_squared_upper(x, 2.0), exp(-x / 2.0));
            near(chi_squared_upper(x, 4.0), exp(-x / 2.0) * (1.0 + x / 2.0));
            near(chi_squared_upper(x, 6.0), exp(-x / 2.0) * (1.0 + x / 2.0 + x * x / 8.0));
            near(chi_squared_upper(x, 1.0), normal_two_sided(sqrt(x)));
            near(fisher_upper(x, 2.0, 57.0), libm::pow(1.0 + 2.0 * x / 57.0, -28.5));
        }
        assert_eq!([student_two_sided(0.0, 5.0), fisher_upper(0.0, 1.0, 5.0), chi_squared_upper(0.0, 3.0)], [1.0; 3]);
    }

    #[test]
    fn quantiles_are_those_of_the_printed_tables() {
        for (p, df, known) in [(0.05, 28.0, 2.048), (0.05, 1.0, 12.706), (0.01, 10.0, 3.169), (0.1, 40.0, 1.684)] {
            assert!((student_quantile(p, df) - known).abs() < 5e-4, "{p} {df}");
            near(student_two_sided(student_quantile(p, df), df), p);
        }
        for (p, known) in [(0.05, 1.959_963_984_540), (0.01, 2.575_829_303_549), (0.1, 1.644_853_626_951)] {
            near(normal_quantile(p), known);
        }
    }

    /// The library statrs computes them in other ways.
    #[test]
    fn tails_agree_with_those_of_another_program() {
        use statrs::function::{beta::beta_reg, gamma::gamma_ur};
        let mut random = fastrand::Rng::with_seed(12);
        for _ in 0..4000 {
            let power = |random: &mut fastrand::Rng, range: f64| libm::pow(10.0, range * random.f64());
            let (first, second) = (power(&mut random, 2.0), power(&mut random, 4.0));
            let t = 6.0 * random.f64();
            let same = |mine: f64, other: f64| {
                assert!((mine - other).abs() < 1e-9 * other + 1e-12, "{mine} for {other}: {first} {second} {t}");
            };
            same(student_two_sided(t, second), beta_reg(second / 2.0, 0.5, second / (second + t * t)));
            same(fisher_upper(t, first, second), beta_reg(second / 2.0, first / 2.0, second / (second + first * t)));
            let x = first * (0.2 + 2.0 * random.f64());
            same(chi_squared_upper(x, first), gamma_ur(first / 2.0, x / 2.0));
        }
    }
}
