//! The closed diagrams and the differentiated loop closure give one motion, as identities that can be proven exactly.
//!
//! Frame and letters as in the [module](super). The unit of length is the pin's height over the line of centres, so the
//! crank's component q = R sin φ is 1; p = R cos φ is its other one, and x is the pin's other coordinate, so l = x − p. That
//! leaves out only positions on the line of centres, and an equation between rational functions that holds everywhere else
//! holds there too. Few variables make short proofs.
//!
//! ```
//! use geneva_kinematics::prove;
//! use geneva_kinematics::quick_return::proofs::{DiagramAgainstSeries, LeverQuantity};
//!
//! assert!(prove(&DiagramAgainstSeries(LeverQuantity::LeverSpeed)).is_ok());
//! assert!(prove(&DiagramAgainstSeries(LeverQuantity::Sliding)).is_ok());
//! ```

use super::motion::{Drive, LeverMotion};
use super::series::polar_rates;
use crate::pin_vectors::quarter_turn;
use crate::{Expression, Identity, Turn};

/// What of the motion is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeverQuantity {
    /// ψ̇.
    LeverSpeed,
    /// ψ̈.
    LeverAcceleration,
    /// ṙ, multiplied by r.
    Sliding,
    /// r̈, multiplied by r.
    SlidingAcceleration,
    /// The Coriolis term's first component.
    Coriolis,
}

/// The closed diagrams and the differentiated loop closure give one motion. Variables: p, x, ω, ω̇.
pub struct DiagramAgainstSeries(
    /// What is compared.
    pub LeverQuantity,
);

impl Identity<4> for DiagramAgainstSeries {
    fn difference(&self, [p, x, speed, acceleration]: [Expression; 4]) -> Expression {
        let drive = Drive { speed, acceleration };
        let (ground, crank) = placed(p, x);
        let rates = polar_rates(&ground, &Expression::ONE, &crank, &drive).expect("the pin is off the pivot");
        let LeverMotion { velocities, accelerations, .. } =
            LeverMotion::new(&ground, &Expression::ONE, &crank, &drive).expect("the pin is off the pivot");
        let square = rates.position.dot(&rates.position);
        match self.0 {
            LeverQuantity::LeverSpeed => velocities.follower_speed - rates.angular_velocity,
            LeverQuantity::LeverAcceleration => accelerations.follower_acceleration - rates.angular_acceleration,
            LeverQuantity::Sliding => velocities.sliding_velocity.dot(&rates.position) - rates.sliding * square,
            LeverQuantity::SlidingAcceleration => {
                accelerations.sliding_tangential.dot(&rates.position) - rates.sliding_rate * square
            }
            LeverQuantity::Coriolis => {
                let across = quarter_turn(&rates.position).x;
                accelerations.coriolis.x - 2 * rates.angular_velocity * rates.sliding * across
            }
        }
    }
}

/// The ground distance and the crank, of length one times its own, for a pin at (x, 1) and a crank (p, 1).
fn placed(p: Expression, x: Expression) -> (Expression, Turn<Expression>) {
    (x - p, Turn { cos: p, sin: Expression::ONE })
}
