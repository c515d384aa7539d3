//! Is there one acceleration where A exceeds |D|, and does floating point agree?

use geneva_dynamics::{Coefficients, DynamicsError, Sign};
use geneva_kinematics::{Field, Rational, rational};

/// Accelerations that obey the equation with the sign that their own friction term has, without repetition.
fn solutions(coefficients: &Coefficients<Rational>, speed: &Rational) -> Vec<(Rational, Sign)> {
    let zero = rational(0, 1);
    let mut found: Vec<(Rational, Sign)> = Vec::new();
    for sign in Sign::BOTH {
        if coefficients.a.clone() + sign.apply(coefficients.d.clone()) == zero {
            continue;
        }
        let angular_acceleration = coefficients.acceleration_with(speed, sign);
        let valid = sign.apply(coefficients.between_the_bars(speed, &angular_acceleration)) >= zero;
        if valid && found.iter().all(|(other, _)| *other != angular_acceleration) {
            found.push((angular_acceleration, sign));
        }
    }
    found
}

fn samples() -> impl Iterator<Item = (Coefficients<Rational>, Rational)> {
    (0..20_000_i64).map(|k| {
        let pick = |step: i64, span: i64| rational(k * step % span - span / 2, 3);
        let [b, c, d, e] = [pick(7, 11), pick(5, 13), pick(3, 17), pick(11, 19)];
        (Coefficients { a: rational(k * 13 % 9 + 1, 3), b, c, d, e }, rational(k % 4, 2))
    })
}

#[test]
fn there_is_exactly_one_acceleration_if_a_exceeds_d() {
    let zero = rational(0, 1);
    let mut seen = [0; 3];
    for (coefficients, speed) in samples() {
        let size = if coefficients.d < zero { -coefficients.d.clone() } else { coefficients.d.clone() };
        let solutions = solutions(&coefficients, &speed);
        if coefficients.a > size {
            assert_eq!(solutions.len(), 1, "{coefficients:?} {speed}");
            let switching_function = coefficients.sign_switching_function(&speed);
            let bars = coefficients.between_the_bars(&speed, &solutions[0].0);
            assert_eq!(switching_function.clone() > zero, bars > zero);
            assert_eq!(switching_function < zero, bars < zero);
        } else if coefficients.a < size {
            // Two where E is above the least value of the left side, none below, one at it.
            let corner = -(coefficients.c.clone() * speed.clone() * speed.clone()) / coefficients.d.clone();
            let above = -coefficients.residual(&speed, &corner, Sign::Plus);
            let expected = if above > zero { 2 } else { usize::from(above == zero) };
            assert_eq!(solutions.len(), expected, "{coefficients:?} {speed}");
            seen[expected] += 1;
        }
    }
    assert!(seen[0] > 100 && seen[1] > 0 && seen[2] > 100, "{seen:?}");
}

#[test]
fn floating_point_takes_the_same_side() {
    for (exact, speed) in samples().step_by(7) {
        let [a, b, c, d, e] = [&exact.a, &exact.b, &exact.c, &exact.d, &exact.e].map(Field::approximate);
        let solved = Coefficients { a, b, c, d, e }.acceleration(speed.approximate());
        match solved {
            Ok(acceleration) => {
                let (value, _) = &solutions(&exact, &speed)[0];
                approx::assert_relative_eq!(
                    acceleration.value,
                    value.approximate(),
                    max_relative = 1e-12,
                    epsilon = 1e-12
                );
            }
            Err(error) => assert!(a <= d.abs() * (1.0 + 1e-15), "{error}"),
        }
    }
}

#[test]
fn one_formula_has_the_solution_of_either_sign() {
    let zero = rational(0, 1);
    let mut signs = [0; 2];
    for (coefficients, speed) in samples() {
        let size = if coefficients.d < zero { -coefficients.d.clone() } else { coefficients.d.clone() };
        if coefficients.a > size {
            let switching = coefficients.sign_switching_function(&speed);
            let size = if switching < zero { -switching.clone() } else { switching.clone() };
            let (value, sign) = &solutions(&coefficients, &speed)[0];
            assert_eq!(coefficients.acceleration_in_one_formula(&speed, &size), *value, "{coefficients:?} {speed}");
            signs[usize::from(*sign == Sign::Minus)] += 1;
        }
    }
    assert!(signs.iter().all(|count| *count > 1000), "{signs:?}");
}

#[test]
fn what_cannot_be_solved_is_said() {
    let sound = Coefficients { a: 2.0, b: 1.0, c: -1.0, d: 1.0, e: 3.0 };
    for speed in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(sound.acceleration(speed), Err(DynamicsError::Speed { .. })), "{speed}");
    }
    for d in [2.0, -3.0, f64::NAN] {
        let error = Coefficients { d, ..sound.clone() }.acceleration(1.0).expect_err("A does not exceed |D|");
        assert!(error.to_string().contains("lower the friction"), "{error}");
    }
}
