//! Tail probabilities and quantiles of the distributions that tests are made with.

use statrs::function::beta::{beta_reg, inv_beta_reg};
use statrs::function::erf::{erfc, erfc_inv};
use statrs::function::gamma::gamma_ur;

/// Probability that a standard normal variable exceeds `z` in size, on either side.
pub(super) fn normal_two_sided(z: f64) -> f64 {
    erfc(z.abs() / std::f64::consts::SQRT_2)
}

/// Probability that a variable with Student's distribution with `df` > 0 degrees of freedom exceeds `t` in size, on either side.
pub(super) fn student_two_sided(t: f64, df: f64) -> f64 {
    match df / t.powi(2) {
        ratio if ratio.is_nan() || ratio.is_infinite() => 1.0,
        ratio => beta_reg(df / 2.0, 0.5, (ratio / (1.0 + ratio)).clamp(0.0, 1.0)),
    }
}

/// Probability that a variable with Fisher's distribution with these degrees of freedom, both > 0, exceeds `f`.
pub(super) fn fisher_upper(f: f64, between: f64, within: f64) -> f64 {
    if f <= 0.0 {
        return 1.0;
    }
    beta_reg(within / 2.0, between / 2.0, (within / (within + between * f)).clamp(0.0, 1.0))
}

/// Probability that a variable with the χ² distribution with `df` > 0 degrees of freedom exceeds `x`.
pub(super) fn chi_squared_upper(x: f64, df: f64) -> f64 {
    if x <= 0.0 { 1.0 } else { gamma_ur(df / 2.0, x / 2.0) }
}

/// The value that a standard normal variable exceeds in size with the probability `p` in (0, 1).
pub(super) fn normal_quantile(p: f64) -> f64 {
    std::f64::consts::SQRT_2 * erfc_inv(p)
}

/// The value that a variable with Student's distribution with `df` degrees of freedom exceeds in size with the probability `p`.
pub(super) fn student_quantile(p: f64, df: f64) -> f64 {
    let share = inv_beta_reg(df / 2.0, 0.5, p);
    libm::sqrt(df * (1.0 - share) / share)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(computed: f64, known: f64) {
        assert!((computed - known).abs() <= 1e-9 * known.abs(), "{computed} for {known}");
    }

    /// Closed forms: Student's distribution with 1 and 2 degrees of freedom, Fisher's with 2 above, χ² with 2, 4 and 6.
    #[test]
    fn tails_agree_with_closed_forms() {
        for t in [0.01, 0.3, 1.0, 2.2, 12.706, 300.0] {
            near(student_two_sided(t, 1.0), 1.0 - 2.0 / std::f64::consts::PI * libm::atan(t));
            let tail = libm::sqrt(2.0 + t * t);
            near(student_two_sided(t, 2.0), 2.0 / (tail * (tail + t)));
            near(student_two_sided(-t, 7.0), fisher_upper(t * t, 1.0, 7.0));
        }
        for x in [0.02, 1.0, 3.91, 17.0, 60.0] {
            near(chi_squared_upper(x, 2.0), libm::exp(-x / 2.0));
            near(chi_squared_upper(x, 4.0), libm::exp(-x / 2.0) * (1.0 + x / 2.0));
            near(chi_squared_upper(x, 6.0), libm::exp(-x / 2.0) * (1.0 + x / 2.0 + x * x / 8.0));
            near(chi_squared_upper(x, 1.0), normal_two_sided(libm::sqrt(x)));
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
}
