//! The equation of motion from the balance of energy: no Lagrange, no generalised coordinate.
//!
//! The driving torque does the work K θ' per unit of time; friction takes μ |N| times the speed at which the pin
//! slides; what is left goes into the kinetic energy of the two members. The normal force follows from the moments on
//! the follower, N R = I_f φ'', and the sliding speed is |dR/dt|. Everything comes from the pin's place as a power
//! series.

use crate::{Coefficients, Pose, Sign};
use geneva_kinematics::{Field, Identity, Jet, Turn, angular_velocity, pin_slot};

/// Kinetic energy of both members over I_f, (I_D/I_f θ'² + φ'²)/2, from φ'/θ', θ' and I_D/I_f.
///
/// Meyer 1973, Eq. (1-16).
pub fn kinetic_energy<S: Field>(velocity_ratio: &S, speed: &S, inertia_ratio: &S) -> S {
    let follower = velocity_ratio.clone() * speed.clone();
    (inertia_ratio.clone() * speed.clone() * speed.clone() + follower.clone() * follower) / S::integer(2)
}

/// What the pin's place tells about one instant, for a driver of some speed and acceleration.
struct Motion<S> {
    /// φ'.
    follower_speed: S,
    /// φ''.
    follower_gain: S,
}

impl<S: Field> Motion<S> {
    /// From the pin's place; `crank` may be a pair of any length, which is then the crank's radius.
    ///
    /// A proof stops with a panic, as at any pole, if the pin is on the follower's pivot.
    fn of_pin(distance: &S, crank: &Turn<S>, speed: &S, gain: &S) -> Self {
        let half = gain.clone() / S::integer(2);
        let advance = Jet::<S, 3>::from_coefficients([S::zero(), speed.clone(), half]);
        let place = pin_slot::pin_from_pivot(&Jet::constant(distance.clone()), &crank.moving_by(&advance));
        let turning = angular_velocity(&place).expect("the pin is off the follower's pivot");
        Self { follower_speed: turning.value(), follower_gain: turning.rate() }
    }
}

/// The pose in the units of (p, q) = crank pair and centre distance one, in squares of that unit.
///
/// The coefficients are quotients of the pose's numbers, so its unit of length drops out. R² is taken as the sum of
/// squares that it is in the pin's place; [`SquareOfTheSlot`] says that this is the law of cosines.
fn pose_of_pair<S: Field>(crank: &Turn<S>) -> Pose<S> {
    let along = S::one() - crank.cos.clone();
    let radius_squared = crank.cos.clone() * crank.cos.clone() + crank.sin.clone() * crank.sin.clone();
    Pose {
        lead: crank.cos.clone() - radius_squared.clone(),
        cross: crank.sin.clone(),
        square: along.clone() * along + crank.sin.clone() * crank.sin.clone(),
        shape: radius_squared - S::one(),
    }
}

/// The pin's distance from the pivot, squared, is r² + c² − 2 r c cos θ. Variables: p = r cos θ, q = r sin θ, c.
pub struct SquareOfTheSlot;

impl Identity<3> for SquareOfTheSlot {
    fn difference<S: Field>(&self, [p, q, distance]: &[S; 3]) -> S {
        let place = pin_slot::pin_from_pivot(distance, &Turn { cos: p.clone(), sin: q.clone() });
        let radius_squared = p.clone() * p.clone() + q.clone() * q.clone();
        let law = radius_squared + distance.clone() * distance.clone() - S::integer(2) * distance.clone() * p.clone();
        place.x.clone() * place.x.clone() + place.y.clone() * place.y.clone() - law
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
    fn difference<S: Field>(&self, [square, lead, cross, gain, inertia, friction, drive]: &[S; 7]) -> S {
        let pose = Pose::from_square(square, lead, cross);
        let moving = pose.moving_by(&Jet::<S, 2>::variable(S::zero()));
        let follower = moving.velocity_ratio() * Jet::from_coefficients([S::one(), gain.clone()]);
        let sliding = moving.square.rate() / S::integer(2);
        let lost = self.normal.of(follower.rate()) * self.sliding.of(sliding) / square.clone();
        let growth = inertia.clone() * gain.clone() + follower.value() * follower.rate();
        let balance = growth - drive.clone() + friction.clone() * lost;
        let coefficients = Coefficients::of_pose(&pose, inertia, friction, drive);
        balance - coefficients.residual(&S::one(), gain, self.normal.times(self.sliding))
    }
}

/// The growth of the kinetic energy that the balance uses is the derivative of the kinetic energy.
///
/// dT/dt = i θ' θ'' + φ' φ'', T from [`kinetic_energy`]. Variables: R², h, g, θ', θ'', i.
pub struct GrowthOfKineticEnergy;

impl Identity<6> for GrowthOfKineticEnergy {
    fn difference<S: Field>(&self, [square, lead, cross, speed, gain, inertia]: &[S; 6]) -> S {
        let pose = Pose::from_square(square, lead, cross);
        let moving = pose.moving_by(&Jet::<S, 2>::from_coefficients([S::zero(), speed.clone()]));
        let speeds = Jet::from_coefficients([speed.clone(), gain.clone()]);
        let energy = kinetic_energy(&moving.velocity_ratio(), &speeds, &Jet::constant(inertia.clone()));
        let follower = pose.velocity_ratio() * speed.clone() * pose.follower_acceleration(speed, gain);
        energy.rate() - inertia.clone() * speed.clone() * gain.clone() - follower
    }
}

/// What the pose says of the follower is what the pin's place says: φ' and φ'' for any motion of the driver.
///
/// Variables: p = (r/c) cos θ, q = (r/c) sin θ, θ', θ''.
pub struct PoseOfThePin {
    /// Whether it is about φ', or about φ''.
    pub speed: bool,
}

impl Identity<4> for PoseOfThePin {
    fn difference<S: Field>(&self, [p, q, speed, gain]: &[S; 4]) -> S {
        let crank = Turn { cos: p.clone(), sin: q.clone() };
        let motion = Motion::of_pin(&S::one(), &crank, speed, gain);
        let pose = pose_of_pair(&crank);
        if self.speed {
            motion.follower_speed - pose.velocity_ratio() * speed.clone()
        } else {
            motion.follower_gain - pose.follower_acceleration(speed, gain)
        }
    }
}

/// Virtual work: the moment arm of the friction is how far the pin slides per radian, c sin φ = dR/dθ.
///
/// Multiplied by R it reads c (R sin φ) = R dR/dθ, and R sin φ is the pin's distance from the line of centres.
/// Variables: p = r cos θ, q = r sin θ, c.
pub struct MomentArmIsSliding;

impl Identity<3> for MomentArmIsSliding {
    fn difference<S: Field>(&self, [p, q, distance]: &[S; 3]) -> S {
        let crank = Turn { cos: p.clone(), sin: q.clone() };
        let place = pin_slot::pin_from_pivot(distance, &crank);
        let moving = pin_slot::pin_from_pivot(&Jet::constant(distance.clone()), &crank.moving::<2>(S::one()));
        let square = moving.x.clone() * moving.x.clone() + moving.y.clone() * moving.y.clone();
        distance.clone() * place.y.clone() - square.rate() / S::integer(2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::proving::holds;
    use geneva_kinematics::{Rational, rational};

    #[test]
    fn energy_gives_the_equation_of_motion() {
        for normal in Sign::BOTH {
            for sliding in Sign::BOTH {
                holds("energy balance", &EnergyBalance { normal, sliding });
            }
        }
        holds("growth of kinetic energy", &GrowthOfKineticEnergy);
        holds("R² of the pin", &SquareOfTheSlot);
        holds("moment arm is sliding", &MomentArmIsSliding);
        for speed in [true, false] {
            holds("pose of the pin", &PoseOfThePin { speed });
        }
    }

    #[test]
    fn a_pair_of_any_length_gives_the_same_coefficients() {
        let (distance, radius) = (rational(9, 1), rational(5, 1));
        let crank = Turn::<Rational>::from_half_tangent(&rational(2, 7));
        let ratio = distance.clone() / radius.clone();
        let scale = radius / distance;
        let pair = Turn { cos: crank.cos.clone() * scale.clone(), sin: crank.sin.clone() * scale };
        let [inertia, friction, drive] = [rational(1, 3), rational(2, 5), rational(7, 2)];
        assert_eq!(
            Coefficients::of_pose(&pose_of_pair(&pair), &inertia, &friction, &drive),
            Coefficients::new(&ratio, &crank, &inertia, &friction, &drive)
        );
    }
}
