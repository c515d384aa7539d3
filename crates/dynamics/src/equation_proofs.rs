//! Identities that show why the equation of motion has one solution, and why its sign is known beforehand.
//!
//! Notation as in [`equation`](crate::equation); A to E and θ' are free variables, so nothing depends on what they
//! stand for. Where the slopes A + D and A − D are divided by, they are the variables instead of A and D.
//!
//! ```
//! use geneva_dynamics::Sign;
//! use geneva_dynamics::equation_proofs::{SwitchingFunctionDecidesSign, SolutionOfOneSign};
//! use geneva_kinematics::prove;
//!
//! for sign in Sign::BOTH {
//!     assert!(prove(&SolutionOfOneSign(sign)).is_ok() && prove(&SwitchingFunctionDecidesSign(sign)).is_ok());
//! }
//! ```

use crate::{Coefficients, Sign};
use geneva_kinematics::{Expression, Identity};

/// Coefficients with A and D from the two slopes A + D and A − D.
fn of_slopes([plus, minus, b, c, e]: [Expression; 5]) -> Coefficients<Expression> {
    Coefficients { a: (plus + minus) / 2, b, c, d: (plus - minus) / 2, e }
}

/// The solution of one sign obeys the equation with that sign. Variables: A + D, A − D, B, C, E, θ'.
pub struct SolutionOfOneSign(
    /// The sign of the bars.
    pub Sign,
);

impl Identity<6> for SolutionOfOneSign {
    fn difference(&self, [plus, minus, b, c, e, speed]: [Expression; 6]) -> Expression {
        let coefficients = of_slopes([plus, minus, b, c, e]);
        coefficients.residual(&speed, &coefficients.acceleration_with(&speed, self.0), self.0)
    }
}

/// (A + S D) (C θ'² + D θ'') = A C θ'² + D (E − B θ'²) for the solution of either sign. Variables: A + D, A − D, B, C,
/// E, θ'.
pub struct SwitchingFunctionDecidesSign(
    /// The sign of the bars.
    pub Sign,
);

impl Identity<6> for SwitchingFunctionDecidesSign {
    fn difference(&self, [plus, minus, b, c, e, speed]: [Expression; 6]) -> Expression {
        let coefficients = of_slopes([plus, minus, b, c, e]);
        let angular_acceleration = coefficients.acceleration_with(&speed, self.0);
        let slope = if self.0 == Sign::Plus { plus } else { minus };
        slope * coefficients.between_the_bars(&speed, &angular_acceleration)
            - coefficients.sign_switching_function(&speed)
    }
}

/// The solution of either sign is [one formula](Coefficients::acceleration_in_one_formula) with the size of the switching
/// function: that function with this sign before it. Variables: A + D, A − D, B, C, E, θ'.
pub struct OneFormulaSolution(
    /// The sign of the bars, which is the sign of the switching function.
    pub Sign,
);

impl Identity<6> for OneFormulaSolution {
    fn difference(&self, [plus, minus, b, c, e, speed]: [Expression; 6]) -> Expression {
        let coefficients = of_slopes([plus, minus, b, c, e]);
        let size = self.0.apply(coefficients.sign_switching_function(&speed));
        coefficients.acceleration_in_one_formula(&speed, &size) - coefficients.acceleration_with(&speed, self.0)
    }
}

/// On one piece the left side grows by A + S D per unit of θ''. Variables: A, B, C, D, E, θ', θ'' and its growth.
pub struct SlopeOfOneSign(
    /// The sign of the bars.
    pub Sign,
);

impl Identity<8> for SlopeOfOneSign {
    fn difference(&self, [a, b, c, d, e, speed, angular_acceleration, growth]: [Expression; 8]) -> Expression {
        let coefficients = Coefficients { a, b, c, d, e };
        let after = coefficients.residual(&speed, &(angular_acceleration + growth), self.0);
        let slope = a + self.0.apply(d);
        after - coefficients.residual(&speed, &angular_acceleration, self.0) - slope * growth
    }
}

/// The two solutions are −2 (A C θ'² + D (E − B θ'²)) / (A² − D²) apart: one and the same where the friction changes
/// sign, so that the acceleration is continuous there. Variables: A + D, A − D, B, C, E, θ'.
pub struct SolutionsMeet;

impl Identity<6> for SolutionsMeet {
    fn difference(&self, [plus, minus, b, c, e, speed]: [Expression; 6]) -> Expression {
        let coefficients = of_slopes([plus, minus, b, c, e]);
        let [first, second] = Sign::BOTH.map(|sign| coefficients.acceleration_with(&speed, sign));
        let product = plus * minus;
        first - second + 2 * coefficients.sign_switching_function(&speed) / product
    }
}
