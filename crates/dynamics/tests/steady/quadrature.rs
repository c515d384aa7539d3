//! Does the Gauss-Legendre rule integrate what it should, and how fast does its error fall?

/// The rule, compiled here by itself because the crate keeps it private.
#[allow(dead_code, unreachable_pub, reason = "a file of the library, of which the tests use a part")]
#[path = "../../src/steady/quadrature.rs"]
mod source;

use source::{NODES, dot, rule};

#[test]
fn powers_are_integrated_to_the_last_places() {
    let rule = rule();
    for power in 0..2 * NODES as i32 {
        let values = rule.nodes.map(|x| x.powi(power));
        let exact = if power % 2 == 0 { 2.0 / f64::from(power + 1) } else { 0.0 };
        assert!((rule.integral(&values) - exact).abs() < 1e-15, "{power}");
    }
}

#[test]
fn integrals_up_to_a_point_and_values_between_are_those_of_a_polynomial() {
    let rule = rule();
    for power in 0..NODES as i32 {
        let values = rule.nodes.map(|x| (x + 0.25).powi(power));
        let up = |x: f64| (x + 0.25).powi(power + 1) / f64::from(power + 1);
        let (sums, whole) = rule.cumulative(&values);
        assert!((whole - (up(1.0) - up(-1.0))).abs() < 1e-13, "{power}");
        for (point, sum) in rule.nodes.iter().zip(sums) {
            assert!((sum - (up(*point) - up(-1.0))).abs() < 1e-13, "{power} {point}");
        }
        for x in [-1.0, -0.3, rule.nodes[5], rule.nodes[5] + 1e-16, 0.0, 0.999, 1.0] {
            let value = dot(&rule.shares(x), &values);
            assert!((value - (x + 0.25).powi(power)).abs() < 1e-12, "{power} {x}");
        }
    }
}

#[test]
fn the_error_falls_as_the_nearest_pole_says() {
    // 1/(1 + x²/d²) has its poles at distance d: the ellipse through them has the half axes' sum d + √(1 + d²).
    let rule = rule();
    for distance in [0.5, 1.0, 2.0_f64] {
        let values = rule.nodes.map(|x| 1.0 / (1.0 + (x / distance) * (x / distance)));
        let exact = 2.0 * distance * libm::atan(1.0 / distance);
        let bound = 8.0 * (distance + distance.hypot(1.0)).powi(-2 * NODES as i32);
        assert!((rule.integral(&values) - exact).abs() < bound + 1e-15, "{distance}");
    }
}
