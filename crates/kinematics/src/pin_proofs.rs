//! At which ratio of lengths a four-slot follower is at rest as the pin enters, as an identity that can be proven exactly.
//!
//! ```
//! use geneva_kinematics::pin_proofs::StandstillOfFourSlots;
//! use geneva_kinematics::prove;
//!
//! assert!(prove(&StandstillOfFourSlots).is_ok());
//! ```

use crate::{Expression, Field, Identity};

/// Standstill of a four-slot follower as the pin enters: the condition on k = l / R, multiplied out.
///
/// The slots of four are 90° apart, so the pin enters and leaves at β = ±45°: k − cos θ = sin θ. The follower stands
/// still if k cos θ = 1. With cos θ = 1/k and sin θ = k − 1/k the pin is on its circle, cos² + sin² = 1, exactly if
/// (k² − 1)(k² − 2) = 0. Variable: k.
pub struct StandstillOfFourSlots;

impl Identity<1> for StandstillOfFourSlots {
    fn difference(&self, [ratio]: [Expression; 1]) -> Expression {
        let square = ratio * ratio;
        let product = (square - 1) * (square - 2);
        square * four_slot_entry_misfit(&ratio) - product
    }
}

/// How far the pin is off its circle if it is at β = 45° and the follower stands still: cos² θ + sin² θ − 1,
/// dimensionless.
///
/// Zero for the ratios k = l / R at which a four-slot follower is at rest as the pin enters; k must not be zero.
///
/// ```
/// use geneva_kinematics::pin_proofs::four_slot_entry_misfit;
/// use geneva_kinematics::{Rational, Surd};
/// use num_traits::Zero;
///
/// // The right ratio for four slots is √2, a number that no fraction is.
/// assert!(four_slot_entry_misfit(&Surd::<Rational, 2>::root()).is_zero());
/// assert!(four_slot_entry_misfit(&1.5) > 0.0);
/// ```
pub fn four_slot_entry_misfit<S: Field>(ratio: &S) -> S {
    let cos = S::one() / ratio.clone();
    let sin = ratio.clone() - cos.clone();
    cos.clone() * cos + sin.clone() * sin - S::one()
}
