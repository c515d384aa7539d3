//! The equation of motion from the balance of energy: no Lagrange, no generalised coordinate.
//!
//! The driving torque does the work K θ' per unit of time; friction takes μ |N| times the speed at which the pin
//! slides; what is left goes into the kinetic energy of the two members. The normal force follows from the moments on
//! the follower, N R = I_f φ'', and the sliding speed is |dR/dt|. Everything comes from the pin's place as a power
//! series.
//!
//! ```
//! use geneva_dynamics::energy::{GrowthOfKineticEnergy, SquareOfTheSlot};
//! use geneva_kinematics::prove;
//!
//! assert!(prove(&SquareOfTheSlot).is_ok()); // the law of cosines
//! assert!(prove(&GrowthOfKineticEnergy).is_ok());
//! ```

use crate::{Coefficients, Pose, Sign};
use geneva_kinematics::{Expression, Field, Identity, Jet, Turn, angular_velocity, pin_slot};

/// Kinetic energy of both members over I_f, (I_D/I_f θ'² + φ'²)/2, from φ'/θ', θ' and I_D/I_f; in the unit of `speed`
/// squared.
///
/// Meyer 1973, Eq. (1-16).
///
/// ```
/// use geneva_dynamics::energy::kinetic_energy;
///
/// // Both members at 2 rad/s, I_D = 3 I_f: (3 + 1) · 2² / 2, times I_f.
/// assert_eq!(kinetic_energy(&1.0, &2.0, &3.0), 8.0);
/// ```
pub fn kinetic_energy<S: Field>(velocity_ratio: &S, speed: &S, inertia_ratio: &S) -> S {
    let follower = velocity_ratio.clone() * speed.clone();
    (inertia_ratio.clone() * speed.clone() * speed.clone() + follower.clone() * follower) / S::integer(2)
}

/// The pose in the units of (p, q) = crank pair and centre distance one, in squares of that unit.
///
/// The coefficients are quotients of the pose's numbers, so its unit of length drops out. R² is taken as the sum of
/// squares that it is in the pin's place; [`SquareOfTheSlot`] says that this is the law of cosines.
fn pose_of_pair<S: Field>(crank: &Turn<S>) -> Pose<S> {
    let along = S::one() - crank.cos.clone();
    let radius_squared = crank.cos.clone() * crank.cos.clone() + crank.sin.clone() * crank.sin.clone();
    Pose {
        numerator: crank.cos.clone() - radius_squared.clone(),
        k_sin_theta: crank.sin.clone(),
        radius_squared: along.clone() * along + crank.sin.clone() * crank.sin.clone(),
        one_minus_k_squared: radius_squared - S::one(),
    }
}

/// The pin's distance from the pivot, squared, is r² + c² − 2 r c cos θ. Variables: p = r cos θ, q = r sin θ, c.
pub struct SquareOfTheSlot;

impl Identity<3> for SquareOfTheSlot {
    fn difference(&self, [p, q, distance]: [Expression; 3]) -> Expression {
        let place = pin_slot::pin_from_pivot(&distance, &Turn { cos: p, sin: q });
        let law = p * p + q * q + distance * distance - 2 * distance * p;
        place.x * place.x + place.y * place.y - law
    }
}

/// The balance of energy is θ' times the equation of motion (1-19), for either sign of the bars.
///
/// Over I_f: i θ' θ'' + φ' φ'' − E θ' + μ |φ'' R R'|/R² = θ' (A θ'' + B θ'² + |C θ'² + D θ''| − E), with R R' = dR²/dt
/// / 2. What stands between bars has the sign of the normal force times that of the sliding. φ', φ'' and R² are series
/// of the pose, which [`PoseOfThePin`] and [`SquareOfTheSlot`] tie to the pin's place; nothing of Lagrange's enters. At
/// the speed θ' = 1: every term is of one degree in θ'² and θ'', so the unit of time may be so chosen. Variables: R²,
/// h, g, θ'', i = I_D/I_f, μ and E = K/I_f.
pub struct EnergyBalance {
    /// Sign of the normal force: plus on the leading flank.
    pub normal: Sign,
    /// Sign of the sliding: plus outward, which is past the line of centres.
    pub sliding: Sign,
}

impl Identity<7> for EnergyBalance {
    fn difference(
        &self,
        [square, numerator, cross, angular_acceleration, inertia, friction, drive]: [Expression; 7],
    ) -> Expression {
        let pose = Pose::from_square(&square, &numerator, &cross);
        let moving = pose.moving_by(&Jet::<_, 2>::variable(Expression::ZERO));
        let follower = moving.velocity_ratio() * Jet::from_coefficients([Expression::ONE, angular_acceleration]);
        let sliding = moving.radius_squared.rate() / 2;
        let lost = self.normal.apply(follower.rate()) * self.sliding.apply(sliding) / square;
        let growth = inertia * angular_acceleration + follower.value() * follower.rate();
        let balance = growth - drive + friction * lost;
        let coefficients = Coefficients::from_pose(&pose, &inertia, &friction, &drive);
        balance - coefficients.residual(&Expression::ONE, &angular_acceleration, self.normal.times(self.sliding))
    }
}

/// The growth of the kinetic energy that the balance uses is the derivative of the kinetic energy.
///
/// dT/dt = i θ' θ'' + φ' φ'', T from [`kinetic_energy`]. Variables: R², h, g, θ', θ'', i.
pub struct GrowthOfKineticEnergy;

impl Identity<6> for GrowthOfKineticEnergy {
    fn difference(
        &self,
        [square, numerator, cross, speed, angular_acceleration, inertia]: [Expression; 6],
    ) -> Expression {
        let pose = Pose::from_square(&square, &numerator, &cross);
        let moving = pose.moving_by(&Jet::<_, 2>::from_coefficients([Expression::ZERO, speed]));
        let speeds = Jet::from_coefficients([speed, angular_acceleration]);
        let energy = kinetic_energy(&moving.velocity_ratio(), &speeds, &Jet::constant(inertia));
        let follower = pose.velocity_ratio() * speed * pose.follower_acceleration(&speed, &angular_acceleration);
        energy.rate() - inertia * speed * angular_acceleration - follower
    }
}

/// The pose gives the follower the same φ' and φ'' as the pin's place does, for any motion of the driver.
///
/// Variables: p = (r/c) cos θ, q = (r/c) sin θ, θ', θ''.
pub struct PoseOfThePin {
    /// Whether it is about φ', or about φ''.
    pub speed: bool,
}

impl Identity<4> for PoseOfThePin {
    fn difference(&self, [p, q, speed, angular_acceleration]: [Expression; 4]) -> Expression {
        let crank = Turn { cos: p, sin: q };
        let place = pin_slot::pin_path(&Expression::ONE, &crank.speeding_up(speed, angular_acceleration));
        // A proof stops with a panic, as at any pole, if the pin is on the follower's pivot.
        let follower = angular_velocity(&place).expect("the pin is off the follower's pivot");
        let pose = pose_of_pair(&crank);
        if self.speed {
            follower.value() - pose.velocity_ratio() * speed
        } else {
            follower.rate() - pose.follower_acceleration(&speed, &angular_acceleration)
        }
    }
}

/// Virtual work: the moment arm of the friction is how far the pin slides per radian, c sin φ = dR/dθ.
///
/// Multiplied by R it reads c (R sin φ) = R dR/dθ, and R sin φ is the pin's distance from the line of centres.
/// Variables: p = r cos θ, q = r sin θ, c.
pub struct MomentArmIsSliding;

impl Identity<3> for MomentArmIsSliding {
    fn difference(&self, [p, q, distance]: [Expression; 3]) -> Expression {
        let crank = Turn { cos: p, sin: q };
        let place = pin_slot::pin_from_pivot(&distance, &crank);
        let moving = pin_slot::pin_path(&distance, &crank.moving::<2>(Expression::ONE));
        distance * place.y - (moving.x * moving.x + moving.y * moving.y).rate() / 2
    }
}
