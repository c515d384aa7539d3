//! The parts put together: Eqs. (1-17) and (1-18), the five coefficients, and (1-19).

use super::force::printed_friction;
use super::momentum::speed_term;
use super::{Form, friction_torque, growth, momentum_rate, over, pose, position_rate, power};
use crate::{Coefficients, Pose, Sign};
use geneva_kinematics::{Expression, Identity};

/// [I_D + (a cos θ − 1)^exponent I_f/R⁴] θ''.
fn inertia_term(
    pose: &Pose<Expression>,
    angular_acceleration: Expression,
    inertia: Expression,
    exponent: u32,
) -> Expression {
    (inertia + over(power(pose.numerator, exponent), pose.square, 2)) * angular_acceleration
}

/// Lagrange's left side from the kinetic energy.
fn left_side(pose: &Pose<Expression>, angular_acceleration: Expression, inertia: Expression) -> Expression {
    momentum_rate(pose, angular_acceleration, inertia) - position_rate(pose, inertia)
}

/// A line of Lagrange's left side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeftSideLine {
    /// One derivative minus the other, the first of the two lines of (1-17).
    Minus,
    /// Eq. (1-17). Printed with (a cos θ − 1) for its square.
    Closed(Form),
}

/// The lines of Eq. (1-17) against the derivatives of the kinetic energy. Variables: R², h, g, θ'', I_D.
pub struct LeftSide(
    /// Which line.
    pub LeftSideLine,
);

impl Identity<5> for LeftSide {
    fn difference(&self, [square, numerator, cross, angular_acceleration, inertia]: [Expression; 5]) -> Expression {
        let pose = pose(square, numerator, cross);
        let display = match self.0 {
            LeftSideLine::Minus => {
                inertia_term(&pose, angular_acceleration, inertia, 2) - 2 * speed_term(&pose) - -speed_term(&pose)
            }
            LeftSideLine::Closed(form) => {
                inertia_term(&pose, angular_acceleration, inertia, form.pick(1, 2)) - speed_term(&pose)
            }
        };
        left_side(&pose, angular_acceleration, inertia) - display
    }
}

/// A display of the whole equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionLine {
    /// After (1-17): the parts put in. Printed with (a cos θ − 1) for its square, and with brackets for bars.
    Substituted {
        /// The square.
        square: Form,
        /// The bars.
        bars: Form,
    },
    /// Eq. (1-18), over I_f. Printed with brackets for bars.
    Divided {
        /// The bars.
        bars: Form,
    },
    /// Eq. (1-19) with A to E as [`Coefficients`] has them.
    Short,
}

/// The displays of the equation of motion against the balance of power: growth of the kinetic energy and friction, at
/// θ' = 1.
///
/// The driving torque stands alone on both sides and is left out; everything else is brought to the left. Where the
/// print has brackets for bars, it is right for the plus sign only. Variables: R², h, g, θ'', I_D, μ.
pub struct EquationOfMotion {
    /// Which display.
    pub line: MotionLine,
    /// The sign that opens the bars.
    pub contact: Sign,
}

impl Identity<6> for EquationOfMotion {
    fn difference(
        &self,
        [square, numerator, cross, angular_acceleration, inertia, friction]: [Expression; 6],
    ) -> Expression {
        let pose = pose(square, numerator, cross);
        let truth = growth(&pose, angular_acceleration, inertia)
            + self.contact.of(friction_torque(&pose, angular_acceleration, friction));
        let between = printed_friction(&pose, angular_acceleration, friction);
        let bars = |form: Form| form.pick(Sign::Plus, self.contact).of(between);
        let display = match self.line {
            MotionLine::Substituted { square, bars: form } => {
                inertia_term(&pose, angular_acceleration, inertia, square.pick(1, 2)) - speed_term(&pose) + bars(form)
            }
            MotionLine::Divided { bars: form } => {
                let of_speed = over(pose.cross * pose.shape * pose.numerator, pose.square, 3);
                inertia_term(&pose, angular_acceleration, inertia, 2) + of_speed + bars(form)
            }
            MotionLine::Short => {
                let coefficients = Coefficients::of_pose(&pose, &inertia, &friction, &Expression::ZERO);
                coefficients.residual(&Expression::ONE, &angular_acceleration, self.contact)
            }
        };
        truth - display
    }
}

/// One of the five abbreviations after (1-18).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coefficient {
    /// A. Printed with I_f/I_f for I_D/I_f.
    A(Form),
    /// B.
    B,
    /// C.
    C,
    /// D.
    D,
    /// E = K/I_f.
    E,
}

/// The abbreviations as they stand, against what multiplies θ'', θ'², both between the bars, and 1 in the balance.
///
/// A and B: growth of the kinetic energy at θ'' = 1 less that at 0, and at 0. C and D: the friction's torque, at 0, and
/// at 1 less that at 0. E is a definition: K = E I_f. Variables: R², h, g, I_D, I_f, μ, K.
pub struct CoefficientPrinted(
    /// Which abbreviation.
    pub Coefficient,
);

impl Identity<7> for CoefficientPrinted {
    fn difference(&self, [square, h, g, driver, follower, mu, torque]: [Expression; 7]) -> Expression {
        let pose = pose(square, h, g);
        let inertia = driver / follower;
        let left = |angular_acceleration: Expression| growth(&pose, angular_acceleration, inertia);
        let lost = |angular_acceleration: Expression| friction_torque(&pose, angular_acceleration, mu);
        match self.0 {
            Coefficient::A(form) => {
                let first = form.pick(follower, driver) / follower;
                left(Expression::ONE) - left(Expression::ZERO) - (first + over(power(h, 2), square, 2))
            }
            Coefficient::B => left(Expression::ZERO) - over(g * pose.shape * h, square, 3),
            Coefficient::C => lost(Expression::ZERO) - over(mu * power(g, 2) * pose.shape, square, 3),
            Coefficient::D => lost(Expression::ONE) - lost(Expression::ZERO) - over(mu * g * h, square, 2),
            Coefficient::E => {
                // K on I_f alone gives the acceleration E.
                let abbreviated = Coefficients::of_pose(&pose, &inertia, &mu, &(torque / follower));
                abbreviated.e * follower - torque
            }
        }
    }
}
