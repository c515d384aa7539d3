//! Do cosine and sine, held as a pair, stay on the circle?

use geneva_exact::{Field, Jet, Rational, Turn, angular_velocity, rational};
use nalgebra::Vector2;

#[test]
fn rational_points_lie_on_the_circle_and_add() {
    let a = Turn::from_half_tangent(&rational(1, 2));
    let b = Turn::from_half_tangent(&rational(-2, 7));
    for turn in [a.clone(), b.clone(), a.plus(&b), a.supplement(), b.reversed()] {
        assert_eq!(turn.cos.clone() * turn.cos + turn.sin.clone() * turn.sin, rational(1, 1));
    }
    assert_eq!(a.plus(&a.reversed()), Turn { cos: rational(1, 1), sin: rational(0, 1) });
}

#[test]
fn a_moving_angle_stays_on_the_circle_to_every_order_carried() {
    let turn = Turn::<Rational>::from_half_tangent(&rational(3, 5)).moving::<6>(rational(7, 3));
    let norm = turn.cos.clone() * turn.cos + turn.sin.clone() * turn.sin;
    assert_eq!(norm, Jet::integer(1));
}

#[test]
fn a_direction_turns_at_its_own_rate_and_the_origin_has_none() {
    let position = Turn::from_half_tangent(&rational(1, 3)).moving::<2>(rational(5, 2)).direction();
    let turning = angular_velocity(&position).expect("off the origin");
    assert_eq!(turning.value(), rational(5, 2));
    let origin = Vector2::<Jet<Rational, 2>>::zeros();
    assert_eq!(angular_velocity(&origin), None);
}

#[test]
fn a_steady_motion_is_the_special_case_of_any() {
    let start = Turn::<Rational>::from_half_tangent(&rational(1, 7));
    let advance = Jet::from_coefficients([rational(9, 1), rational(2, 1), rational(3, 2), rational(0, 1)]);
    let moving = start.moving_by(&advance);
    // cos'' = −advance'' sin − advance'² cos.
    let second = -(rational(3, 1) * start.sin.clone()) - rational(4, 1) * start.cos.clone();
    assert_eq!(moving.cos.derivative(2), Some(second));
    assert_eq!(start.moving::<3>(rational(2, 1)).sin.rate(), rational(2, 1) * start.cos);
}

#[test]
fn degrees_go_through_and_back() {
    for degrees in [-179.0, -45.0, 0.0, 30.0, 150.0, 180.0] {
        approx::assert_relative_eq!(Turn::from_degrees(degrees).degrees(), degrees, max_relative = 1e-15);
    }
}

#[test]
fn cosine_and_sine_at_once_have_the_bits_of_each() {
    let steps = (-200_000..=200_000).map(|k| f64::from(k) * 1.7e-4);
    let powers = (-60..=60).flat_map(|k| [0.7, 0.9, 1.1, 1.3].map(|x: f64| x * f64::powi(2.0, k)));
    for angle in steps.chain(powers).chain([0.0, -0.0]) {
        let turn = Turn::from_radians(angle);
        let apart = [libm::cos(angle), libm::sin(angle)];
        assert_eq!([turn.cos, turn.sin].map(f64::to_bits), apart.map(f64::to_bits), "{angle}");
    }
}
