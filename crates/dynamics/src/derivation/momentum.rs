//! d/dt(∂T/∂θ'), line by line.

use super::kinetic_energy::effective_inertia;
use super::{Form, momentum_rate, over, pose, power, speed, turning};
use crate::Pose;
use geneva_kinematics::{Expression, Identity, Jet};

/// A line of d/dt(∂T/∂θ'), in the order of the print.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MomentumLine {
    /// d/dt [{I_D + (a cos θ − 1)²/R⁴ I_f} θ'], not yet differentiated.
    Undone,
    /// By the rule of quotients. Printed with I_b for I_D, and with "+ (−a cos θ − 1)²" for "− (a cos θ − 1)²".
    Quotient,
    /// R² cancelled. Printed with I_b for I_D.
    Cancelled,
    /// −2 I_f θ'² before the brackets. Printed with I_b for I_D.
    Factored,
    /// 1 + 2 (a cos θ − 1)/R² put as (a² − 1)/R². Printed with I_b for I_D.
    Closed,
}

impl MomentumLine {
    /// All lines.
    pub const ALL: [Self; 5] = [Self::Undone, Self::Quotient, Self::Cancelled, Self::Factored, Self::Closed];

    /// The lines whose print has a slip.
    pub const SLIPPED: [Self; 4] = [Self::Quotient, Self::Cancelled, Self::Factored, Self::Closed];
}

/// The lines of d/dt(∂T/∂θ') against the series of the kinetic energy.
///
/// Variables: R², h, g, θ'', I_D, I_b. The letter I_b counts only if it is taken as printed.
pub struct MomentumRate {
    /// Which line.
    pub line: MomentumLine,
    /// The letter before the brackets: I_b as printed, or I_D.
    pub letter: Form,
    /// The sign and the square of the rule of quotients, which only [`MomentumLine::Quotient`] has.
    pub quotient: Form,
}

impl MomentumRate {
    /// The line with all its slips, or with none.
    pub fn of(line: MomentumLine, form: Form) -> Self {
        Self { line, letter: form, quotient: form }
    }
}

impl Identity<6> for MomentumRate {
    fn difference(
        &self,
        [square, numerator, cross, angular_acceleration, inertia, odd]: [Expression; 6],
    ) -> Expression {
        let pose = pose(square, numerator, cross);
        let letter = self.letter.pick(odd, inertia);
        let first = effective_inertia(&pose, letter) * angular_acceleration;
        let (h, g) = (numerator, cross);
        let display = match self.line {
            MomentumLine::Undone => {
                let moving = effective_inertia(&turning(&pose), Jet::constant(inertia));
                (moving * speed(angular_acceleration)).rate()
            }
            MomentumLine::Quotient => {
                // −a cos θ − 1 is −(h + 2).
                let square_term = self.quotient.pick(power(h + 2, 2), -power(h, 2));
                let second = square_term * 2 * square * (2 * g);
                first + over(power(square, 2) * (2 * h * -g), square, 4) + over(second, square, 4)
            }
            MomentumLine::Cancelled => {
                let one = over(-(2 * h * g), square, 2);
                first + one - over(power(h, 2) * 2 * (2 * g), square, 3)
            }
            MomentumLine::Factored => {
                let braces = 1 + 2 * h / square;
                first - 2 * (over(g * h, square, 2) * braces)
            }
            MomentumLine::Closed => first - 2 * speed_term(&pose),
        };
        momentum_rate(&pose, angular_acceleration, inertia) - display
    }
}

/// a (a² − 1) sin θ (a cos θ − 1)/R⁶, which all the closed displays have.
pub(super) fn speed_term(pose: &Pose<Expression>) -> Expression {
    over(-pose.shape * pose.cross * pose.numerator, pose.square, 3)
}
