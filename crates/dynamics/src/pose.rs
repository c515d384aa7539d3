//! The four numbers of the mechanism's pose from which every coefficient of the equation of motion is made.

use geneva_kinematics::{Field, Jet, Turn, pin_slot};

/// Pose of the mechanism, with the crank radius as the unit of length: all that the equation of motion asks of the
/// geometry.
///
/// ```
/// use geneva_dynamics::Pose;
/// use geneva_kinematics::{Jet, Turn, rational};
///
/// // k = 2 and the crank at cosine 3/5, sine 4/5, without rounding.
/// let pose = Pose::new(&rational(2, 1), &Turn::from_half_tangent(&rational(1, 2)));
/// assert_eq!((pose.numerator.clone(), pose.radius_squared.clone()), (rational(1, 5), rational(13, 5)));
/// assert_eq!(pose.velocity_ratio(), rational(1, 13));
/// // The acceleration ratio is the rate of the velocity ratio.
/// let moving = pose.moving_by(&Jet::<_, 2>::variable(rational(0, 1)));
/// assert_eq!(pose.acceleration_ratio(), moving.velocity_ratio().rate());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<S> {
    /// k cos θ − 1, dimensionless, with the centre distance k in crank radii (a in Meyer 1973): zero as the pin enters and leaves, positive between.
    pub numerator: S,
    /// k sin θ, dimensionless: half the rate of change of `radius_squared` with θ.
    pub k_sin_theta: S,
    /// 1 + k² − 2 k cos θ, the square of the pin's distance from the follower's pivot over that of the crank radius,
    /// dimensionless.
    pub radius_squared: S,
    /// 1 − k², dimensionless, negative for centres farther apart than a crank radius.
    pub one_minus_k_squared: S,
}

impl<S: Field> Pose<S> {
    /// The pose at centre distance over crank radius `ratio` and a crank angle from the line of centres.
    #[inline]
    pub fn new(ratio: &S, crank: &Turn<S>) -> Self {
        Self {
            numerator: ratio.clone() * crank.cos.clone() - S::one(),
            k_sin_theta: ratio.clone() * crank.sin.clone(),
            radius_squared: pin_slot::slot_radius_squared(ratio, crank),
            one_minus_k_squared: S::one() - ratio.clone() * ratio.clone(),
        }
    }

    /// The pose from the squared distance of the pin in crank radii, k cos θ − 1 and k sin θ. The law of cosines gives the fourth
    /// number, `one_minus_k_squared` = −(`radius_squared` + 2 `numerator`).
    ///
    /// For exact proofs: with the square as a variable of its own, degrees stay low. The three are bound by
    /// `radius_squared` = `numerator`² + `k_sin_theta`²; what is proven without using that holds all the more with it.
    pub fn from_square(square: &S, numerator: &S, cross: &S) -> Self {
        Self {
            numerator: numerator.clone(),
            k_sin_theta: cross.clone(),
            radius_squared: square.clone(),
            one_minus_k_squared: -(square.clone() + S::integer(2) * numerator.clone()),
        }
    }

    /// Angular velocity of the follower over that of the driver, dimensionless. Meyer 1973, Eq. (1-7).
    #[inline]
    pub fn velocity_ratio(&self) -> S {
        self.numerator.clone() / self.radius_squared.clone()
    }

    /// Angular acceleration of the follower over the square of a constant speed of the driver, dimensionless.
    ///
    /// Meyer 1973, Eq. (1-8).
    #[inline]
    pub fn acceleration_ratio(&self) -> S {
        self.k_sin_theta.clone() * self.one_minus_k_squared.clone()
            / self.radius_squared.clone()
            / self.radius_squared.clone()
    }

    /// Angular acceleration of the follower for a driver of this speed and acceleration, in the unit of the latter.
    ///
    /// Meyer 1973, Eq. (1-8).
    ///
    /// ```
    /// use geneva_dynamics::Pose;
    /// use geneva_kinematics::Turn;
    ///
    /// // On the line of centres with a = 2 the follower keeps up with the driver one to one, at any speed.
    /// let pose = Pose::new(&2.0, &Turn::from_radians(0.0));
    /// assert_eq!(pose.follower_acceleration(&40.0, &3.0), 3.0); // rad/s², at 40 rad/s and 3 rad/s²
    /// ```
    pub fn follower_acceleration(&self, speed: &S, angular_acceleration: &S) -> S {
        self.acceleration_ratio() * speed.clone() * speed.clone() + self.velocity_ratio() * angular_acceleration.clone()
    }

    /// The pose as a power series while θ advances by `advance` (radians; its constant part counts for nothing).
    ///
    /// (a cos θ, a sin θ) turns like any direction, and R² changes as −2 a cos θ does.
    pub fn moving_by<const N: usize>(&self, advance: &Jet<S, N>) -> Pose<Jet<S, N>> {
        let pair = Turn { cos: self.numerator.clone() + S::one(), sin: self.k_sin_theta.clone() }.moving_by(advance);
        let from = |start: &S, factor: i64, series: &Jet<S, N>| {
            Jet::from_coefficients(std::array::from_fn(|k| match k {
                0 => start.clone(),
                _ => S::integer(factor) * series.coefficient(k),
            }))
        };
        Pose {
            numerator: from(&self.numerator, 1, &pair.cos),
            k_sin_theta: pair.sin.clone(),
            radius_squared: from(&self.radius_squared, -2, &pair.cos),
            one_minus_k_squared: Jet::constant(self.one_minus_k_squared.clone()),
        }
    }
}
