//! The normal force and the torque of friction that it makes: from the moments on the follower to Eq. (1-14).
//!
//! Half powers of 1 + a² − 2 a cos θ = R² are powers of R, so every exponent is counted in halves. Forces are over
//! I_f/r.

use super::{Form, follower_acceleration, friction_torque, over, pose, power};
use crate::{Pose, Sign};
use geneva_kinematics::{Expression, Identity};

/// a sin θ (1 − a²)/R^speed θ'² + (a cos θ − 1)/R^gain θ'', the brackets of these displays; θ' = 1.
fn brackets(
    pose: &Pose<Expression>,
    radius: Expression,
    angular_acceleration: Expression,
    powers: [u32; 2],
) -> Expression {
    let [of_speed, of_gain] = powers;
    over(pose.cross * pose.shape, radius, of_speed) + over(pose.numerator, radius, of_gain) * angular_acceleration
}

/// N R = I_f φ'', moments about o. The print has I_P θ'': another letter's inertia, and the driver's acceleration.
///
/// Both sides are moments; the left is the rate of I_f φ'. Variables: R², h, g, θ'', I_P.
pub struct MomentEquation(
    /// As printed or put right.
    pub Form,
);

impl Identity<5> for MomentEquation {
    fn difference(&self, [square, numerator, cross, angular_acceleration, odd]: [Expression; 5]) -> Expression {
        let pose = pose(square, numerator, cross);
        let corrected = pose.follower_acceleration(&Expression::ONE, &angular_acceleration);
        follower_acceleration(&pose, angular_acceleration) - self.0.pick(odd * angular_acceleration, corrected)
    }
}

/// N = I_f φ''/R. The print has I_P θ''/R. Variables: R, h, g, θ'', I_P.
pub struct ForceFromMoment(
    /// As printed or put right.
    pub Form,
);

impl Identity<5> for ForceFromMoment {
    fn difference(&self, [radius, numerator, cross, angular_acceleration, odd]: [Expression; 5]) -> Expression {
        let pose = pose(radius * radius, numerator, cross);
        let corrected = pose.follower_acceleration(&Expression::ONE, &angular_acceleration);
        let force = self.0.pick(odd * angular_acceleration, corrected) / radius;
        follower_acceleration(&pose, angular_acceleration) / radius - force
    }
}

/// N = I_f [Eq. (1-8)] / (r R^outer), the display before (1-13): printed with three half powers outside, which are one.
///
/// Variables: R, h, g, θ''.
pub struct ForceSubstituted {
    /// Half powers outside the brackets.
    pub outer: u32,
}

impl ForceSubstituted {
    /// The display as printed or put right.
    pub fn of(form: Form) -> Self {
        Self { outer: form.pick(3, 1) }
    }
}

impl Identity<4> for ForceSubstituted {
    fn difference(&self, [radius, numerator, cross, angular_acceleration]: [Expression; 4]) -> Expression {
        let pose = pose(radius * radius, numerator, cross);
        follower_acceleration(&pose, angular_acceleration) / radius
            - over(brackets(&pose, radius, angular_acceleration, [4, 2]), radius, self.outer)
    }
}

/// Eq. (1-13): half powers three and three are printed under θ'² and θ''; the first must be five.
///
/// Variables: R, h, g, θ''.
pub struct NormalForce {
    /// Half powers under θ'² and under θ''.
    pub powers: [u32; 2],
}

impl NormalForce {
    /// The display as printed or put right.
    pub fn of(form: Form) -> Self {
        Self { powers: form.pick([3, 3], [5, 3]) }
    }
}

impl Identity<4> for NormalForce {
    fn difference(&self, [radius, numerator, cross, angular_acceleration]: [Expression; 4]) -> Expression {
        let pose = pose(radius * radius, numerator, cross);
        follower_acceleration(&pose, angular_acceleration) / radius
            - brackets(&pose, radius, angular_acceleration, self.powers)
    }
}

/// The display after (1-13): τ₂ = −a r μ |sin θ/R^sine I_f/r [Eq. (1-13)]|. Half powers three, three, three are
/// printed; one, five, three are right.
///
/// Variables: R, h, g, θ'', μ.
pub struct FrictionSubstituted {
    /// Half powers under sin θ, under θ'² and under θ''.
    pub powers: [u32; 3],
    /// The sign that opens the bars.
    pub contact: Sign,
}

impl FrictionSubstituted {
    /// The display as printed or put right.
    pub fn of(form: Form, contact: Sign) -> Self {
        Self { powers: form.pick([3, 3, 3], [1, 5, 3]), contact }
    }
}

impl Identity<5> for FrictionSubstituted {
    fn difference(&self, [radius, numerator, cross, angular_acceleration, friction]: [Expression; 5]) -> Expression {
        let pose = pose(radius * radius, numerator, cross);
        let [sine, speed, driver] = self.powers;
        let between = over(pose.cross, radius, sine) * brackets(&pose, radius, angular_acceleration, [speed, driver]);
        self.contact.of(friction_torque(&pose, angular_acceleration, friction)) - friction * self.contact.of(between)
    }
}

/// Eq. (1-14): τ₂ = −a μ I_f |a sin² θ (1 − a²)/R⁶ θ'² + sin θ (a cos θ − 1)/R⁴ θ''|. Variables: R², h, g, θ'', μ.
pub struct FrictionOfMotion {
    /// The sign that opens the bars.
    pub contact: Sign,
}

impl Identity<5> for FrictionOfMotion {
    fn difference(&self, [square, numerator, cross, angular_acceleration, friction]: [Expression; 5]) -> Expression {
        let pose = pose(square, numerator, cross);
        let between = printed_friction(&pose, angular_acceleration, friction);
        self.contact.of(friction_torque(&pose, angular_acceleration, friction)) - self.contact.of(between)
    }
}

/// a μ times what stands between the bars of Eq. (1-14), with θ' = 1: a² sin² θ and a sin θ are g² and g.
pub(super) fn printed_friction(
    pose: &Pose<Expression>,
    angular_acceleration: Expression,
    friction: Expression,
) -> Expression {
    let (square, cross) = (pose.square, pose.cross);
    let of_speed = over(power(cross, 2) * pose.shape, square, 3);
    let of_gain = over(cross * pose.numerator, square, 2);
    friction * (of_speed + of_gain * angular_acceleration)
}
