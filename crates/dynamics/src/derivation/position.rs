//! ∂T/∂θ, line by line.

use super::kinetic_energy::effective_inertia;
use super::momentum::speed_term;
use super::{Form, over, pose, position_rate, power, turning};
use geneva_kinematics::{Expression, Field, Identity, Jet};

/// A line of ∂T/∂θ, in the order of the print.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PositionLine {
    /// ∂/∂θ [½ {I_D + (a cos θ − 1)²/R⁴ I_f} θ'²], after (1-16), not yet differentiated.
    Undone,
    /// The same again, where this derivative is taken up. Printed with I_b for I_D, which does not matter to a
    /// derivative with θ: the statement holds all the same.
    UndoneAgain,
    /// 0 + ½ I_f θ'² ∂/∂θ [(a cos θ − 1)²/R⁴].
    Outside,
    /// By the rule of quotients.
    Quotient,
    /// R² cancelled.
    Cancelled,
    /// −I_f θ'² before the brackets.
    Factored,
    /// 1 + 2 (a cos θ − 1)/R² put as (a² − 1)/R².
    Closed,
}

impl PositionLine {
    /// All lines.
    pub const ALL: [Self; 7] =
        [Self::Undone, Self::UndoneAgain, Self::Outside, Self::Quotient, Self::Cancelled, Self::Factored, Self::Closed];
}

/// The lines of ∂T/∂θ against the series of the kinetic energy in θ.
///
/// The letter I_b can be told from I_D only in T itself: with `energy`, the line that has it is compared before it is
/// differentiated. Variables: R², h, g, I_D, I_b.
pub struct PositionRate {
    /// Which line.
    pub line: PositionLine,
    /// The letter in [`PositionLine::UndoneAgain`]: I_b as printed, or I_D.
    pub letter: Form,
    /// Whether to compare the energy in the brackets instead of its derivative, for the two lines that show it.
    pub energy: bool,
}

impl PositionRate {
    /// The derivative that a line gives, in the letter of the print.
    pub fn of(line: PositionLine) -> Self {
        Self { line, letter: Form::Printed, energy: false }
    }

    /// The energy that the line with the odd letter is the derivative of.
    pub fn energy(letter: Form) -> Self {
        Self { line: PositionLine::UndoneAgain, letter, energy: true }
    }
}

impl Identity<5> for PositionRate {
    fn difference(&self, [square, h, g, inertia, odd]: [Expression; 5]) -> Expression {
        let pose = pose(square, h, g);
        let moving = turning(&pose);
        let letter = match self.line {
            PositionLine::UndoneAgain => self.letter.pick(odd, inertia),
            _ => inertia,
        };
        let braces = effective_inertia(&moving, Jet::constant(letter)) / Jet::integer(2);
        if self.energy {
            return crate::energy::kinetic_energy(&pose.velocity_ratio(), &Expression::ONE, &inertia) - braces.value();
        }
        let display = match self.line {
            PositionLine::Undone | PositionLine::UndoneAgain => braces.rate(),
            PositionLine::Outside => {
                let quotient = over(power(moving.numerator, 2), moving.square, 2);
                quotient.rate() / 2
            }
            PositionLine::Quotient => {
                let first = over(power(square, 2) * 2 * h * -g, square, 4);
                let second = over(power(h, 2) * 2 * square * (2 * g), square, 4);
                (first - second) / 2
            }
            PositionLine::Cancelled => {
                let first = over(-(2 * h * g), square, 2);
                let second = over(-(2 * power(h, 2) * (2 * g)), square, 3);
                (first + second) / 2
            }
            PositionLine::Factored => {
                let braces = 1 + h * 2 / square;
                -(over(h * g, square, 2) * braces)
            }
            PositionLine::Closed => -speed_term(&pose),
        };
        position_rate(&pose, inertia) - display
    }
}
