//! Are the derivatives of truncated power series exact?

use crate::rate;
use geneva_exact::{Jet, Rational, Turn, rational};
use num_dual::third_derivative;
use num_traits::One;

#[test]
fn derivatives_of_a_rational_function_are_exact() {
    // 1 / x at 2: derivatives -1/4, 2/8, -6/16.
    let inverse = Jet::<Rational, 4>::one() / Jet::variable(rational(2, 1));
    let derivatives: Vec<_> = (0..4).filter_map(|k| inverse.derivative(k)).collect();
    assert_eq!(derivatives, [rational(1, 2), rational(-1, 4), rational(1, 4), rational(-3, 8)]);
    assert_eq!(inverse.derivative(4), None);
}

#[test]
fn a_library_of_dual_numbers_agrees() {
    let turn = Turn::from_radians(0.3).moving::<4>(1.0);
    let ratio = Jet::constant(1.5);
    let ours = rate(&ratio, &turn);
    let (_, first, second, third) = third_derivative(
        |t| {
            use num_dual::DualNum;
            let (c, k) = (t.cos(), 1.5);
            (c * k - 1.0) / (c * (-2.0 * k) + 1.0 + k * k)
        },
        0.3,
    );
    for (order, theirs) in [(1, first), (2, second), (3, third)] {
        let ours = ours.derivative(order).expect("carried");
        approx::assert_relative_eq!(ours, theirs, max_relative = 1e-13);
    }
}
