//! The equation of motion with real joints, and its solution with the flank decided beforehand.
//!
//! With λ and κ for the arms of the contact and the journals, Newton and Euler say of follower and driver
//!
//! I_f φ'' = λ N − H, I_D θ'' = K − G − κ N,
//!
//! where H and G are the drag torques. The slot makes φ'' = p θ'² + q θ''. So the follower asks for the moment
//! M = I_f (p θ'² + q θ'') + H, which λ N gives it, and the driver feels κ N = (κ/λ) M. With m = κ/λ:
//!
//! (I_D + m q I_f) θ'' = K − G − m (I_f p θ'² + H).
//!
//! **Its flank.** λ > 0 makes the signs of N and M one. Multiply M by I_D + m q I_f and put the solution in: m drops
//! out, and what is left is I_D (I_f p θ'² + H) + q I_f (K − G). If both factors of θ'' are positive, this number
//! decides the flank. It knows neither the friction nor the pin's radius nor the journals: the pin bears on the flank on
//! which it would bear without any friction. Proven in [`equation_proofs`](super::equation_proofs).

use super::Joints;
use super::contact::{Arms, Journals, Reach};
use crate::error::not_negative;
use crate::{DynamicsError, Parameters, Sign};
use geneva_kinematics::Field;
use geneva_kinematics::bisection::bisect;

/// Terms of the equation of motion at one crank angle, without the contact; inertias and torques over I_f.
///
/// ```
/// use geneva_dynamics::joints::Terms;
///
/// // Both members at one speed, I_D = 3 I_f, no friction (κ = λ): K / (I_D + I_f).
/// let terms = Terms { inertia: 3.0, drive: 8.0, drag: 0.0, ratio: 1.0, bend: 0.0 };
/// assert_eq!(terms.angular_acceleration(&25.0, &1.0), 2.0); // rad/s², at 5 rad/s
/// assert_eq!(terms.moment(&25.0, &2.0), 2.0); // the follower asks for I_f φ''
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Terms<S> {
    /// I_D / I_f, dimensionless.
    pub inertia: S,
    /// (K − G) / I_f, per square of the unit of time.
    pub drive: S,
    /// H / I_f, per square of the unit of time.
    pub drag: S,
    /// q = φ'/θ', dimensionless.
    pub ratio: S,
    /// p, the follower's acceleration over the square of a constant speed of the driver, dimensionless.
    pub bend: S,
}

impl<S: Field> Terms<S> {
    /// M / I_f = p θ'² + q θ'' + H / I_f, the moment that the follower asks for, per square of the unit of time.
    pub fn moment(&self, square: &S, angular_acceleration: &S) -> S {
        self.bend.clone() * square.clone() + self.ratio.clone() * angular_acceleration.clone() + self.drag.clone()
    }

    /// Factor of θ'' for a contact with m = κ/λ, dimensionless: I_D / I_f + m q.
    pub fn slope(&self, leverage: &S) -> S {
        self.inertia.clone() + leverage.clone() * self.ratio.clone()
    }

    /// θ'' at a square of the speed, for a contact with m = κ/λ, in radians per square of the unit of time.
    pub fn angular_acceleration(&self, square: &S, leverage: &S) -> S {
        let held = self.bend.clone() * square.clone() + self.drag.clone();
        (self.drive.clone() - leverage.clone() * held) / self.slope(leverage)
    }

    /// i (p θ'² + H / I_f) + q (K − G) / I_f, per square of the unit of time: its sign is that of the normal force.
    pub fn flank_switching_function(&self, square: &S) -> S {
        let held = self.bend.clone() * square.clone() + self.drag.clone();
        self.inertia.clone() * held + self.ratio.clone() * self.drive.clone()
    }
}

/// Motion and forces at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointMotion {
    /// θ'', in radians per square of the unit of time.
    pub angular_acceleration: f64,
    /// φ'', acceleration of the follower, in radians per square of the unit of time.
    pub follower_acceleration: f64,
    /// N r, normal force times crank radius, in the unit of torque; positive on the leading flank.
    pub normal_moment: f64,
    /// The flank: plus for the leading one, on which N > 0; plus where N is zero.
    pub flank: Sign,
    /// Sliding of the pin's surface on the slot's side over θ', outward, in crank radii.
    pub sliding: f64,
}

/// An escapement with its joints, of which the equation of motion has one solution wherever a pin is in its slot.
///
/// ```
/// use geneva_dynamics::joints::{Escapement, Joints};
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// // With ideal joints it is the equation of motion of `Parameters`.
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(0.1, 1.0)?, 1.0, 0.2)?;
/// let ideal = Escapement::new(&timer, Joints::IDEAL)?;
/// let (angle, speed) = (0.3, 2.0); // rad, rad per unit of time
/// let motion = ideal.motion(angle, speed)?;
/// assert!((motion.angular_acceleration - timer.acceleration(angle, speed)?.value).abs() < 1e-12);
/// // What friction does not take of the torque's power goes into both members.
/// let growth = 0.1 * speed * motion.angular_acceleration
///     + timer.pose(angle).velocity_ratio() * speed * motion.follower_acceleration;
/// assert!((ideal.power(angle, speed)?.growth() - growth).abs() < 1e-12);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Escapement {
    parameters: Parameters,
    joints: Joints,
    pub(super) journals: Journals,
    /// Crank angle at which the sliding turns: minus this on the leading flank, plus this on the trailing one.
    reversal: f64,
}

/// A place in the engagement, for any speed.
pub(super) struct JointPose {
    pub reach: Reach<f64>,
    pub terms: Terms<f64>,
}

impl Escapement {
    /// An escapement with these joints.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Negative`], [`DynamicsError::PinTooThick`] and [`DynamicsError::DragTorque`] for sizes out of range;
    /// [`DynamicsError::SelfLocking`] if friction can hold the follower against any force;
    /// [`DynamicsError::Jams`] if somewhere no acceleration, or more than one, obeys the equation.
    pub fn new(parameters: &Parameters, joints: Joints) -> Result<Self, DynamicsError> {
        let escapement = Self::assemble(parameters, joints)?;
        escapement.exists()?;
        Ok(escapement)
    }

    /// An escapement with sizes in range, which may lock or jam.
    pub(super) fn assemble(parameters: &Parameters, joints: Joints) -> Result<Self, DynamicsError> {
        for (name, asked) in joints.named() {
            not_negative(name, asked)?;
        }
        if joints.pin_radius >= 1.0 {
            return Err(DynamicsError::PinTooThick { asked: joints.pin_radius });
        }
        if joints.driver_drag_torque >= parameters.torque() {
            return Err(DynamicsError::DragTorque { asked: joints.driver_drag_torque, torque: parameters.torque() });
        }
        let journals = Journals::new(&joints, parameters.friction());
        let reversal = reversal_angle(parameters, joints.pin_radius);
        Ok(Self { parameters: *parameters, joints, journals, reversal })
    }

    /// Slots, inertias, torque and friction.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// The joints.
    pub fn joints(&self) -> Joints {
        self.joints
    }

    /// Angle before the line of centres, in radians, where the sliding of a pin of finite radius on the leading flank turns
    /// outward; on the trailing flank it turns as far behind. Zero for a pin that is a point.
    pub fn reversal_angle(&self) -> f64 {
        self.reversal
    }

    /// Motion and forces at a crank angle (radians from the line of centres, within the engagement) and a speed of the
    /// driver (≥ 0, radians per unit of time).
    ///
    /// # Errors
    ///
    /// [`DynamicsError::OutsideTheSlot`], [`DynamicsError::Speed`].
    pub fn motion(&self, angle: f64, speed: f64) -> Result<JointMotion, DynamicsError> {
        let limit = self.parameters.mechanism().engagement_half_angle();
        // Half a turn over the number of pins is known to its last place only.
        let within = angle.abs() <= limit * (1.0 + f64::EPSILON);
        if !within {
            return Err(DynamicsError::OutsideTheSlot { asked: angle, limit });
        }
        if !(speed >= 0.0 && (speed * speed).is_finite()) {
            return Err(DynamicsError::Speed { name: "driver speed", asked: speed });
        }
        let (place, square) = (self.place(angle), speed * speed);
        let flank = Sign::from_number(place.terms.flank_switching_function(&square));
        let sliding = place.reach.sliding(&self.joints.pin_radius, flank);
        let arms = self.arms(&place.reach, flank, Sign::from_number(sliding));
        let angular_acceleration = place.terms.angular_acceleration(&square, &(arms.driver / arms.follower));
        let moment = place.terms.moment(&square, &angular_acceleration);
        let follower_acceleration = moment - place.terms.drag;
        let normal_moment = self.parameters.inertias().follower() * moment / arms.follower;
        Ok(JointMotion { angular_acceleration, follower_acceleration, normal_moment, flank, sliding })
    }

    /// The equation's terms at a crank angle.
    pub(super) fn place(&self, angle: f64) -> JointPose {
        let pose = self.parameters.pose(angle);
        let reach = Reach::from_pose(&pose);
        let (inertias, joints) = (self.parameters.inertias(), &self.joints);
        let terms = Terms {
            inertia: inertias.ratio(),
            drive: (self.parameters.torque() - joints.driver_drag_torque) / inertias.follower(),
            drag: joints.follower_drag_torque / inertias.follower(),
            ratio: reach.ratio,
            bend: pose.acceleration_ratio(),
        };
        JointPose { reach, terms }
    }

    /// κ and λ: the arms of contact and journals.
    pub(super) fn arms(&self, reach: &Reach<f64>, flank: Sign, sliding: Sign) -> Arms<f64> {
        let contact = reach.arms(&self.joints.pin_radius, &self.parameters.friction(), flank, sliding);
        contact.with_journals(&self.journals.driver, &self.journals.follower, flank)
    }
}

/// Crank angle behind the line of centres at which a pin of this radius stops sliding inward on the trailing flank.
///
/// On the leading flank it is the mirror image. There R dR/dθ + ρ (R² + h)/R, with h = a cos θ − 1, rises all the way
/// from entry to the line of centres: the first term by h + 1, the second by −ρ g h/R³ with g = a sin θ < 0. At entry
/// it is −R + ρ R < 0 if ρ < 1, on the line of centres it is not negative.
fn reversal_angle(parameters: &Parameters, pin: f64) -> f64 {
    if pin == 0.0 {
        return 0.0;
    }
    let inward = |angle| Reach::from_pose(&parameters.pose(angle)).sliding(&pin, Sign::Minus) < 0.0;
    bisect([0.0, parameters.mechanism().engagement_half_angle()], inward)[1]
}

/// Power at one instant, in the unit of the torque times radians per unit of time; or, summed over a time, work done,
/// in the unit of the torque times radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power {
    /// K θ', from the spring, in the unit of the torque per unit of time; as work in the unit of the torque.
    pub input: f64,
    /// μ |N| times the sliding speed of the pin's surface, in the same unit; not negative.
    pub sliding: f64,
    /// Into the driver's bearing, in the same unit; not negative.
    pub driver_bearing: f64,
    /// Into the follower's bearing, in the same unit; not negative.
    pub follower_bearing: f64,
}

impl Power {
    /// Power that friction takes in all three places, in the same unit.
    pub fn losses(&self) -> f64 {
        self.sliding + self.driver_bearing + self.follower_bearing
    }

    /// Growth of the kinetic energy of both members, in the same unit.
    pub fn growth(&self) -> f64 {
        self.input - self.losses()
    }

    /// All four times a factor.
    pub(super) fn times(&self, factor: f64) -> Self {
        Self {
            input: self.input * factor,
            sliding: self.sliding * factor,
            driver_bearing: self.driver_bearing * factor,
            follower_bearing: self.follower_bearing * factor,
        }
    }
}

impl Escapement {
    /// Balance of power at a crank angle (radians, within the engagement) and a speed of the driver (≥ 0).
    ///
    /// # Errors
    ///
    /// As for [`Escapement::motion`].
    pub fn power(&self, angle: f64, speed: f64) -> Result<Power, DynamicsError> {
        let motion = self.motion(angle, speed)?;
        Ok(self.work_rate(self.place(angle).reach.ratio, &motion).times(speed))
    }

    /// The power over θ', that is the work per radian of the driver.
    pub(super) fn work_rate(&self, ratio: f64, motion: &JointMotion) -> Power {
        let load = motion.normal_moment.abs();
        let joints = self.joints();
        Power {
            input: self.parameters().torque(),
            sliding: self.parameters().friction() * load * motion.sliding.abs(),
            driver_bearing: self.journals.driver * load + joints.driver_drag_torque,
            follower_bearing: (self.journals.follower * load + joints.follower_drag_torque) * ratio,
        }
    }
}
