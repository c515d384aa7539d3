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

use crate::{DynamicsError, Pose, Sign};
use geneva_kinematics::{Field, Turn};

/// A: inertia that the driver feels, over the follower's, dimensionless: I_D / I_f + (a cos θ − 1)² / R⁴.
///
/// Meyer 1973, after (1-18).
///
/// ```
/// use geneva_dynamics::Pose;
/// use geneva_dynamics::equation::coefficient_a;
/// use geneva_kinematics::Turn;
///
/// // On the line of centres with a = 2 both members turn at one speed: their inertias add up.
/// let middle = Pose::new(&2.0, &Turn::from_radians(0.0));
/// assert_eq!(coefficient_a(&middle, &3.0), 3.0 + 1.0); // I_D = 3 I_f
/// ```
#[inline]
pub fn coefficient_a<S: Field>(pose: &Pose<S>, inertia_ratio: &S) -> S {
    let ratio = pose.velocity_ratio();
    inertia_ratio.clone() + ratio.clone() * ratio
}

/// B: a (1 − a²) sin θ (a cos θ − 1) / R⁶, half the rate of change of A with θ, dimensionless.
///
/// Meyer 1973, after (1-18).
///
/// ```
/// use geneva_dynamics::Pose;
/// use geneva_dynamics::equation::{coefficient_a, coefficient_b};
/// use geneva_kinematics::{Jet, Turn, rational};
///
/// // Half the rate of A, exactly.
/// let pose = Pose::new(&rational(2, 1), &Turn::from_half_tangent(&rational(1, 2)));
/// let moving = pose.moving_by(&Jet::<_, 2>::variable(rational(0, 1)));
/// let rate = coefficient_a(&moving, &Jet::constant(rational(3, 1))).rate();
/// assert_eq!(coefficient_b(&pose), rate / rational(2, 1));
/// ```
#[inline]
pub fn coefficient_b<S: Field>(pose: &Pose<S>) -> S {
    pose.acceleration_ratio() * pose.velocity_ratio()
}

/// C: friction from the square of the speed, μ a² sin² θ (1 − a²) / R⁶, dimensionless. Meyer 1973, after (1-18).
///
/// ```
/// use geneva_dynamics::Pose;
/// use geneva_dynamics::equation::coefficient_c;
/// use geneva_kinematics::{Turn, rational};
///
/// // With a = 2, sin θ = 4/5 and R² = 13/5: μ · 4 (16/25) (1 − 4) / (13/5)³.
/// let pose = Pose::new(&rational(2, 1), &Turn::from_half_tangent(&rational(1, 2)));
/// assert_eq!(coefficient_c(&pose, &rational(1, 1)), rational(-960, 2197));
/// ```
#[inline]
pub fn coefficient_c<S: Field>(pose: &Pose<S>, friction: &S) -> S {
    friction.clone() * (pose.k_sin_theta.clone() / pose.radius_squared.clone()) * pose.acceleration_ratio()
}

/// D: friction from the acceleration, μ a sin θ (a cos θ − 1) / R⁴, dimensionless. Meyer 1973, after (1-18).
///
/// ```
/// use geneva_dynamics::Pose;
/// use geneva_dynamics::equation::coefficient_d;
/// use geneva_kinematics::{Turn, rational};
///
/// // With a = 2, cos θ = 3/5, sin θ = 4/5 and R² = 13/5: μ · (8/5) (1/5) / (13/5)².
/// let pose = Pose::new(&rational(2, 1), &Turn::from_half_tangent(&rational(1, 2)));
/// assert_eq!(coefficient_d(&pose, &rational(1, 1)), rational(8, 169));
/// ```
#[inline]
pub fn coefficient_d<S: Field>(pose: &Pose<S>, friction: &S) -> S {
    friction.clone() * (pose.k_sin_theta.clone() / pose.radius_squared.clone()) * pose.velocity_ratio()
}

/// The five coefficients of Eq. (1-19) at one crank angle.
///
/// ```
/// use geneva_dynamics::{Coefficients, Sign};
/// use geneva_kinematics::Turn;
///
/// // On the line of centres with a = 2, without friction: the torque accelerates both inertias, K / (I_D + I_f).
/// let (inertia_ratio, friction, drive) = (3.0, 0.0, 8.0); // I_D / I_f, μ, K / I_f in 1/s²
/// let coefficients = Coefficients::new(&2.0, &Turn::from_radians(0.0), &inertia_ratio, &friction, &drive);
/// let speed = 5.0; // rad/s
/// assert_eq!(coefficients.acceleration(speed)?.value, 2.0); // rad/s²
/// assert_eq!(coefficients.residual(&speed, &2.0, Sign::Plus), 0.0); // it obeys the equation of motion
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Coefficients<S> {
    /// A, the factor of θ''; dimensionless.
    pub a: S,
    /// B, the factor of θ'²; dimensionless.
    pub b: S,
    /// C, the factor of θ'² between the bars; dimensionless.
    pub c: S,
    /// D, the factor of θ'' between the bars; dimensionless.
    pub d: S,
    /// E, the torque over the follower's inertia, per square of the unit of time.
    pub e: S,
}

impl<S: Field> Coefficients<S> {
    /// The coefficients at centre distance over crank radius `ratio` and crank angle `crank`, for I_D / I_f, μ and K /
    /// I_f.
    pub fn new(ratio: &S, crank: &Turn<S>, inertia_ratio: &S, friction: &S, drive: &S) -> Self {
        Self::from_pose(&Pose::new(ratio, crank), inertia_ratio, friction, drive)
    }

    /// The coefficients of a pose, for I_D / I_f, μ and K / I_f.
    #[inline]
    pub fn from_pose(pose: &Pose<S>, inertia_ratio: &S, friction: &S, drive: &S) -> Self {
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
    #[inline]
    pub fn between_the_bars(&self, speed: &S, angular_acceleration: &S) -> S {
        self.c.clone() * speed.clone() * speed.clone() + self.d.clone() * angular_acceleration.clone()
    }

    /// A θ'' + B θ'² + S (C θ'² + D θ'') − E, in the unit of `angular_acceleration`: zero if the motion obeys the
    /// equation with this sign for the bars.
    pub fn residual(&self, speed: &S, angular_acceleration: &S, sign: Sign) -> S {
        let square = speed.clone() * speed.clone();
        self.a.clone() * angular_acceleration.clone()
            + self.b.clone() * square
            + sign.apply(self.between_the_bars(speed, angular_acceleration))
            - self.e.clone()
    }

    /// (E − (B + S C) θ'²) / (A + S D), the acceleration if the bars have this sign, in radians per square of the unit
    /// of time. Meyer 1973, Appendix B.
    #[inline]
    pub fn acceleration_with(&self, speed: &S, sign: Sign) -> S {
        let both = self.b.clone() + sign.apply(self.c.clone());
        (self.e.clone() - both * speed.clone() * speed.clone()) / (self.a.clone() + sign.apply(self.d.clone()))
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
    #[inline]
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
    /// The driver's unique acceleration at a speed (≥ 0, radians per unit of time), with the sign of the bars.
    ///
    /// ```
    /// use geneva_dynamics::{Coefficients, DynamicsError};
    ///
    /// // A = 1 is less than |D| = 2: with E = 1 the two signs of the bars would give two accelerations.
    /// let jamming = Coefficients { a: 1.0, b: 0.0, c: 0.0, d: 2.0, e: 1.0 };
    /// assert!(matches!(jamming.acceleration(0.0), Err(DynamicsError::NotUnique { .. })));
    /// ```
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Speed`] for a speed that is negative or not finite; [`DynamicsError::NotUnique`] unless A > |D|.
    pub fn acceleration(&self, speed: f64) -> Result<Acceleration, DynamicsError> {
        if !(speed >= 0.0 && speed.is_finite()) {
            return Err(DynamicsError::Speed { name: "driver speed", asked: speed });
        }
        let single = self.a > self.d.abs();
        if !single {
            return Err(DynamicsError::NotUnique { a: self.a, d: self.d.abs() });
        }
        Ok(self.with_own_sign(speed))
    }

    /// The acceleration at this speed of the driver (radians per unit of time), with the sign of the [switching
    /// function](Self::sign_switching_function) for the bars: the unique one where A > |D|, which is not looked at, and
    /// without a meaning elsewhere.
    #[inline]
    pub fn with_own_sign(&self, speed: f64) -> Acceleration {
        let sign = Sign::from_number(self.sign_switching_function(&speed));
        Acceleration { value: self.acceleration_with(&speed, sign), sign }
    }
}
