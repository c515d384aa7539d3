//! The external wheel's jerk is greatest on the line of centres, for every number of stations.
//!
//! Notation: k centre distance in crank radii, c = cos θ, v = 1 − c, D = 1 + k² − 2 k c. The jerk is proportional to
//! q / D³ with q = c D − 4 k (1 − c²). On the line of centres D = e = (k − 1)² and q = e, so the jerk there is e / e³.
//! With y = 2 k v / e the two sums D³ ± e² q are made of terms none of which is negative for 0 ≤ v ≤ 1, which the whole
//! engagement keeps to; so |q| / D³ ≤ e / e³.
//!
//! ```
//! use geneva_kinematics::prove;
//! use geneva_kinematics::wheel_jerk_proofs::JerkBound;
//!
//! assert!([true, false].into_iter().all(|plus| prove(&JerkBound { plus }).is_ok()));
//! ```

use crate::{Expression, Identity};

/// D³ ± e² q = e³ times a sum without a negative term: 2 − v + 3 y² + y³ + y v with plus, v + y (6 − v) + 3 y² + y³ with
/// minus. Variables: k and v.
pub struct JerkBound {
    /// Whether the sum has the plus sign.
    pub plus: bool,
}

impl Identity<2> for JerkBound {
    fn difference(&self, [k, v]: [Expression; 2]) -> Expression {
        let (c, e) = (1 - v, (k - 1).squared());
        let d = 1 + k * k - 2 * k * c;
        let q = c * d - 4 * k * (1 - c * c);
        let y = 2 * k * v / e;
        let cube = d * d * d;
        let higher = 3 * y * y + y * y * y;
        if self.plus {
            cube + e * e * q - e * e * e * (2 - v + higher + y * v)
        } else {
            cube - e * e * q - e * e * e * (v + y * (6 - v) + higher)
        }
    }
}
