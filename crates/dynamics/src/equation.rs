//! The equation of motion, and its solution for the driver's acceleration with the friction's sign resolved exactly.
//!
//! Meyer 1973, Eqs. (1-18) and (1-19): A θ'' + B θ'² + |C θ'² + D θ''| = E. Friction acts against the motion, which
//! is forward: θ' ≥ 0.
//!
//! **One solution.** Let F(x) be the left side as a function of x = θ''. It is made of two straight pieces with the
//! slopes A + D and A − D. If A > |D|, both slopes are positive: F grows without bound to both sides, so it takes every
//! value E exactly once. If A ≤ |D|, one piece is level or falls while A > 0 makes the other rise: then F has a least
//! value, below it there is no solution and above it there are two (or, with a level piece, one).
//! So A > |D| is necessary and sufficient for one acceleration whatever E is.
//!
//! **Its sign.** On the piece with the sign S, x = (E − (B + S C) θ'²) / (A + S D), and there
//! C θ'² + D x = (A C θ'² + D (E − B θ'²)) / (A + S D). The numerator does not know S, and the denominator is
//! positive: the sign of the numerator is the sign of the friction term. Proven in
//! [`equation_proofs`](crate::equation_proofs).

use crate::{Error, Pose, Sign};
use geneva_kinematics::{Field, Turn};

/// A: inertia that the driver feels, over the follower's, dimensionless: I_D / I_f + (a cos θ − 1)² / R⁴.
///
/// Meyer 1973, after (1-18).
pub fn coefficient_a<S: Field>(pose: &Pose<S>, inertia_ratio: &S) -> S {
    let ratio = pose.velocity_ratio();
    inertia_ratio.clone() + ratio.clone() * ratio
}

/// B: a (1 − a²) sin θ (a cos θ − 1) / R⁶, half the rate of change of A with θ, dimensionless.
///
/// Meyer 1973, after (1-18).
pub fn coefficient_b<S: Field>(pose: &Pose<S>) -> S {
    pose.acceleration_ratio() * pose.velocity_ratio()
}

/// C: friction from the square of the speed, μ a² sin² θ (1 − a²) / R⁶, dimensionless. Meyer 1973, after (1-18).
pub fn coefficient_c<S: Field>(pose: &Pose<S>, friction: &S) -> S {
    friction.clone() * (pose.cross.clone() / pose.square.clone()) * pose.acceleration_ratio()
}

/// D: friction from the acceleration, μ a sin θ (a cos θ − 1) / R⁴, dimensionless. Meyer 1973, after (1-18).
pub fn coefficient_d<S: Field>(pose: &Pose<S>, friction: &S) -> S {
    friction.clone() * (pose.cross.clone() / pose.square.clone()) * pose.velocity_ratio()
}

/// The five coefficients of Eq. (1-19) at one crank angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Coefficients<S> {
    /// A, times θ''; dimensionless.
    pub a: S,
    /// B, times θ'²; dimensionless.
    pub b: S,
    /// C, times θ'² between the bars; dimensionless.
    pub c: S,
    /// D, times θ'' between the bars; dimensionless.
    pub d: S,
    /// E, the torque over the follower's inertia, per square of the unit of time.
    pub e: S,
}

impl<S: Field> Coefficients<S> {
    /// The coefficients at centre distance over crank radius `ratio` and crank angle `crank`, for I_D / I_f, μ and K /
    /// I_f.
    pub fn new(ratio: &S, crank: &Turn<S>, inertia_ratio: &S, friction: &S, drive: &S) -> Self {
        Self::of_pose(&Pose::new(ratio, crank), inertia_ratio, friction, drive)
    }

    /// The coefficients of a pose, for I_D / I_f, μ and K / I_f.
    pub fn of_pose(pose: &Pose<S>, inertia_ratio: &S, friction: &S, drive: &S) -> Self {
        Self {
            a: coefficient_a(pose, inertia_ratio),
            b: coefficient_b(pose),
            c: coefficient_c(pose, friction),
            d: coefficient_d(pose, friction),
            e: drive.clone(),
        }
    }

    /// C θ'² + D θ'', what stands between the bars, in the unit of `angular_acceleration`: its sign is that of sin θ
    /// times the follower's acceleration.
    pub fn between_the_bars(&self, speed: &S, angular_acceleration: &S) -> S {
        self.c.clone() * speed.clone() * speed.clone() + self.d.clone() * angular_acceleration.clone()
    }

    /// A θ'' + B θ'² + S (C θ'² + D θ'') − E, in the unit of `angular_acceleration`: zero if the motion obeys the
    /// equation with this sign for the bars.
    pub fn residual(&self, speed: &S, angular_acceleration: &S, sign: Sign) -> S {
        let square = speed.clone() * speed.clone();
        self.a.clone() * angular_acceleration.clone()
            + self.b.clone() * square
            + sign.of(self.between_the_bars(speed, angular_acceleration))
            - self.e.clone()
    }

    /// (E − (B + S C) θ'²) / (A + S D), the acceleration if the bars have this sign, in radians per square of the unit
    /// of time. Meyer 1973, Appendix B.
    pub fn acceleration_with(&self, speed: &S, sign: Sign) -> S {
        let both = self.b.clone() + sign.of(self.c.clone());
        (self.e.clone() - both * speed.clone() * speed.clone()) / (self.a.clone() + sign.of(self.d.clone()))
    }

    /// [A (E − B θ'²) + C D θ'² − `size`] / (A² − D²), with the size of the [switching
    /// function](Self::sign_switching_function): the acceleration, in radians per square of the unit of time, in one
    /// formula for both signs of the bars. It is the one solution where A > |D|.
    pub fn acceleration_in_one_formula(&self, speed: &S, size: &S) -> S {
        let square = speed.clone() * speed.clone();
        let [a, b, c, d] = [&self.a, &self.b, &self.c, &self.d].map(Clone::clone);
        let above = a.clone() * (self.e.clone() - b * square.clone()) + c * d.clone() * square - size.clone();
        above / (a.clone() * a - d.clone() * d)
    }

    /// A C θ'² + D (E − B θ'²), per square of the unit of time: where A > |D|, its sign is the sign of what stands
    /// between the bars.
    pub fn sign_switching_function(&self, speed: &S) -> S {
        let square = speed.clone() * speed.clone();
        self.a.clone() * self.c.clone() * square.clone() + self.d.clone() * (self.e.clone() - self.b.clone() * square)
    }
}

/// The driver's angular acceleration at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acceleration {
    /// θ'', in radians per square of the unit of time.
    pub value: f64,
    /// The sign of C θ'² + D θ''; plus where it is zero.
    pub sign: Sign,
}

impl Coefficients<f64> {
    /// The one acceleration at this speed of the driver (≥ 0, radians per unit of time), with the sign of the bars.
    ///
    /// # Errors
    ///
    /// [`Error::Speed`] for a speed that is negative or not finite; [`Error::NotUnique`] unless A > |D|.
    pub fn acceleration(&self, speed: f64) -> Result<Acceleration, Error> {
        if !(speed >= 0.0 && speed.is_finite()) {
            return Err(Error::Speed { name: "driver speed", asked: speed });
        }
        let single = self.a > self.d.abs();
        if !single {
            return Err(Error::NotUnique { a: self.a, d: self.d.abs() });
        }
        let sign = Sign::from_number(self.sign_switching_function(&speed));
        Ok(Acceleration { value: self.acceleration_with(&speed, sign), sign })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_kinematics::{Rational, rational};

    /// Accelerations that obey the equation with the sign that their own friction term has, without repetition.
    fn solutions(coefficients: &Coefficients<Rational>, speed: &Rational) -> Vec<(Rational, Sign)> {
        let zero = rational(0, 1);
        let mut found: Vec<(Rational, Sign)> = Vec::new();
        for sign in Sign::BOTH {
            if coefficients.a.clone() + sign.of(coefficients.d.clone()) == zero {
                continue;
            }
            let angular_acceleration = coefficients.acceleration_with(speed, sign);
            let valid = sign.of(coefficients.between_the_bars(speed, &angular_acceleration)) >= zero;
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
            assert!(matches!(sound.acceleration(speed), Err(Error::Speed { .. })), "{speed}");
        }
        for d in [2.0, -3.0, f64::NAN] {
            let error = Coefficients { d, ..sound.clone() }.acceleration(1.0).expect_err("A does not exceed |D|");
            assert!(error.to_string().contains("lower the friction"), "{error}");
        }
    }
}
