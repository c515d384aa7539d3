//! Which numbers of pins and slots an escapement can have, as identities. Meyer 1973, after Eq. (1-3).
//!
//! ```
//! use geneva_kinematics::escapement::entry_proofs::PinsAndSlots;
//! use geneva_kinematics::prove;
//!
//! assert!(prove(&PinsAndSlots::Factors).is_ok() && prove(&PinsAndSlots::NeverTwo).is_ok());
//! ```

use crate::{Expression, Identity};

/// Numbers of pins and slots. Variables: m − 2 and n − 2, because n = 2 is a pole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PinsAndSlots {
    /// (m − 2)(n − 2) − 4 = 2mn (1/2 − 1/m − 1/n): the third line asks for two integers whose product is 4.
    Factors,
    /// m − 2 = 4 / (n − 2), m by the fourth line: above zero for every n, and as small as one likes only as n grows
    /// without end. Meyer 1973, remark after the table of Eq. (1-3).
    NeverTwo,
}

impl Identity<2> for PinsAndSlots {
    fn difference(&self, [pins_less_two, slots_less_two]: [Expression; 2]) -> Expression {
        let (m, n) = (pins_less_two + 2, slots_less_two + 2);
        let by_formula = 2 * n / slots_less_two;
        let sum = |m: Expression| 1 / m + 1 / n - Expression::ONE / 2;
        let twice_product = 2 * m * n;
        match self {
            Self::Factors => pins_less_two * slots_less_two - 4 + twice_product * sum(m),
            Self::NeverTwo => by_formula - 2 - 4 / slots_less_two,
        }
    }
}
