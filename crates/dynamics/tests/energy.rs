//! Does the balance of energy give the equation of motion, whatever the unit of length?

use crate::proving::holds;
use geneva_dynamics::energy::{
    EnergyBalance, GrowthOfKineticEnergy, MomentArmIsSliding, PoseOfThePin, SquareOfTheSlot,
};
use geneva_dynamics::{Coefficients, Pose, Sign};
use geneva_kinematics::{Rational, Turn, pin_slot, rational};

#[test]
fn energy_gives_the_equation_of_motion() {
    for normal in Sign::BOTH {
        for sliding in Sign::BOTH {
            holds("energy balance", &EnergyBalance { normal, sliding });
        }
    }
    holds("growth of kinetic energy", &GrowthOfKineticEnergy);
    holds("R² of the pin", &SquareOfTheSlot);
    holds("moment arm is sliding", &MomentArmIsSliding);
    for speed in [true, false] {
        holds("pose of the pin", &PoseOfThePin { speed });
    }
}

#[test]
fn a_pair_of_any_length_gives_the_same_coefficients() {
    let (distance, radius) = (rational(9, 1), rational(5, 1));
    let crank = Turn::<Rational>::from_half_tangent(&rational(2, 7));
    let ratio = distance.clone() / radius.clone();
    let scale = radius / distance;
    let pair = Turn { cos: crank.cos.clone() * scale.clone(), sin: crank.sin.clone() * scale };
    // The pose with the centre distance as the unit of length.
    let (one, squares) = (rational(1, 1), pair.cos.clone() * pair.cos.clone() + pair.sin.clone() * pair.sin.clone());
    let place = pin_slot::pin_from_pivot(&one, &pair);
    let pose = Pose {
        numerator: pair.cos.clone() - squares.clone(),
        k_sin_theta: pair.sin.clone(),
        radius_squared: place.dot(&place),
        one_minus_k_squared: squares - one,
    };
    let [inertia, friction, drive] = [rational(1, 3), rational(2, 5), rational(7, 2)];
    assert_eq!(
        Coefficients::from_pose(&pose, &inertia, &friction, &drive),
        Coefficients::new(&ratio, &crank, &inertia, &friction, &drive)
    );
}
