//! The equation solved for θ'', and the acceleration at the start: Appendices B and D.
//!
//! The letters A to E, R and V are free variables here, and F = C θ'² + D θ'' has a sign S.

use super::{Form, pose};
use crate::{Coefficients, Sign, equation};
use geneva_kinematics::{Expression, Identity};

/// Eq. (1-19) as Appendix B repeats it: A θ'' + B θ'² + C θ² + D θ' = E, with a dot of θ'² and of θ'' and both bars
/// lost.
///
/// Against Eq. (1-19). Variables: A, B, C, D, θ, θ', θ''.
pub struct BarsReprinted {
    /// The dots in the last two terms.
    pub dots: Form,
    /// The bars.
    pub bars: Form,
    /// The sign that opens the bars.
    pub contact: Sign,
}

impl Identity<7> for BarsReprinted {
    fn difference(&self, [a, b, c, d, angle, speed, angular_acceleration]: [Expression; 7]) -> Expression {
        let truth = Coefficients { a, b, c, d, e: Expression::ZERO };
        let (squared, last) = self.dots.pick((angle, speed), (speed, angular_acceleration));
        let between = c * squared * squared + d * last;
        let display =
            a * angular_acceleration + b * speed * speed + self.bars.pick(Sign::Plus, self.contact).of(between);
        truth.residual(&speed, &angular_acceleration, self.contact) - display
    }
}

/// A line of Appendix B from F to the acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// A θ'' + B θ'² + S (C θ'² + D θ'') = E.
    WithSign,
    /// A θ'' + B θ'² + S C θ'² + S D θ'' = E.
    Expanded,
    /// θ'' (A + S D) + θ'² (B + S C) = E.
    Collected,
    /// θ'' = (E − (B + S C) θ'²)/(A + S D), times A + S D.
    Solved,
}

impl Opening {
    /// All lines.
    pub const ALL: [Self; 4] = [Self::WithSign, Self::Expanded, Self::Collected, Self::Solved];
}

/// The lines of Appendix B against Eq. (1-19) with |F| = S F, where S is the sign of F.
///
/// Variables: A + S D, B, C, D, E, θ', θ''.
pub struct BarsOpened {
    /// Which line.
    pub line: Opening,
    /// S.
    pub sign: Sign,
}

impl Identity<7> for BarsOpened {
    fn difference(&self, [slope, b, c, d, e, speed, angular_acceleration]: [Expression; 7]) -> Expression {
        let signed = |value: Expression| self.sign.of(value);
        let a = slope - signed(d);
        let square = speed * speed;
        // |F| is the one of F and −F that is not negative.
        let size = self.sign.of(c * square + d * angular_acceleration);
        let truth = a * angular_acceleration + b * square + size - e;
        let display = match self.line {
            Opening::WithSign => {
                let sign = signed(Expression::ONE);
                let between = c * square + d * angular_acceleration;
                a * angular_acceleration + b * square + sign * between - e
            }
            Opening::Expanded => {
                a * angular_acceleration + b * square + signed(c) * square + signed(d) * angular_acceleration - e
            }
            Opening::Collected => angular_acceleration * (a + signed(d)) + square * (b + signed(c)) - e,
            Opening::Solved => {
                let solved = (e - (b + signed(c)) * square) / slope;
                (angular_acceleration - solved) * slope
            }
        };
        truth - display
    }
}

/// A line of Appendix D.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StartingLine {
    /// A θ'' + |D θ''| = E.
    Bars,
    /// R θ'' + |V θ''| = E, the same with the letters of the start.
    StartingLetters,
    /// R θ'' + |V| θ'' = E.
    Outside,
}

impl StartingLine {
    /// All lines.
    pub const ALL: [Self; 3] = [Self::Bars, Self::StartingLetters, Self::Outside];
}

/// The lines of Appendix D against Eq. (1-19) at θ' = 0, for θ'' > 0. Printed with one dot on the last θ''.
///
/// Variables: A, B, C, D, θ'', and a θ' that is not zero, for the term that the print makes of it.
pub struct StartingEquation {
    /// Which line.
    pub line: StartingLine,
    /// One dot as printed, or two.
    pub dots: Form,
    /// Sign of D, which is that of D θ''.
    pub sign: Sign,
}

impl Identity<6> for StartingEquation {
    fn difference(&self, [a, b, c, d, angular_acceleration, speed]: [Expression; 6]) -> Expression {
        let truth = Coefficients { a, b, c, d, e: Expression::ZERO };
        let last = self.dots.pick(speed, angular_acceleration);
        let size = match self.line {
            StartingLine::Bars | StartingLine::StartingLetters => self.sign.of(d * last),
            StartingLine::Outside => self.sign.of(d) * last,
        };
        truth.residual(&Expression::ZERO, &angular_acceleration, self.sign) - (a * angular_acceleration + size)
    }
}

/// θ₀'' = E/(R + |V|) solves Eq. (1-19) at rest. Variables: A, B, C, |D|, E.
pub struct StartingAcceleration {
    /// Sign of V = D.
    pub sign: Sign,
}

impl Identity<5> for StartingAcceleration {
    fn difference(&self, [a, b, c, size, e]: [Expression; 5]) -> Expression {
        let d = self.sign.of(size);
        let truth = Coefficients { a, b, c, d, e };
        let start = e / (a + size);
        truth.residual(&Expression::ZERO, &start, self.sign)
    }
}

/// The start is at entry, where a cos θ = 1: there V = 0 and R = I_D/I_f, so that θ₀'' = K/I_D whatever the friction.
///
/// Multiplied out. Variables: a sin θ, I_D, I_f, μ, K.
pub struct StartAtEntry;

impl Identity<5> for StartAtEntry {
    fn difference(&self, [cross, driver, follower, friction, torque]: [Expression; 5]) -> Expression {
        // R² = h² + g² with h = 0.
        let pose = pose(cross * cross, Expression::ZERO, cross);
        let inertia = driver / follower;
        let a = equation::coefficient_a(&pose, &inertia);
        let d = equation::coefficient_d(&pose, &friction);
        torque / follower / (a + d) - torque / driver
    }
}

/// The demonstration of Appendix B: m x'' + c x' + k x = 0. Printed with one dot on its first term.
///
/// Against x'' = −(c x' + k x)/m, which the lines of program beside it compute. The second display, printed as
/// x' = −(c x' + k x)/m, has the same slip. Variables: m, c, k, x, x'.
pub struct Demonstration(
    /// As printed or put right.
    pub Form,
);

impl Identity<5> for Demonstration {
    fn difference(&self, [mass, damping, stiffness, place, speed]: [Expression; 5]) -> Expression {
        let rest = damping * speed + stiffness * place;
        let angular_acceleration = -rest / mass;
        mass * self.0.pick(speed, angular_acceleration) + rest
    }
}
