//! Every display put right is proven, every slip is refuted, and each slip by itself is.

use super::*;
use crate::Sign;
use crate::proving::{fails, holds};
use geneva_kinematics::{Identity, prove};

#[track_caller]
fn both<const V: usize, I: Identity<V>>(name: &str, of: impl Fn(Form) -> I) {
    fails(name, &of(Form::Printed));
    holds(name, &of(Form::Corrected));
}

#[test]
fn the_pose_turns_as_the_pair_of_cosine_and_sine_does() {
    // Halves and quarters: nothing is rounded.
    let pose = Pose::from_square(&3.5, &0.25, &(-5.0 / 4.0));
    assert_eq!(turning(&pose), pose.moving_by(&Jet::variable(0.0)));
}

#[test]
fn friction_torque_to_1_12() {
    holds("moment arm", &MomentArm);
    holds("(1-11)", &SineOfFollower);
    holds("R by sines", &SlotRadiusBySines);
    holds("R", &SlotRadius);
    for line in FrictionLine::ALL {
        for contact in Sign::BOTH {
            let torque = FrictionTorque { line, contact };
            // The first display has neither bars nor sign: it is the size, for a positive N sin φ.
            match (line, contact) {
                (FrictionLine::Arm, Sign::Minus) => fails("arm", &torque),
                _ => holds(&format!("{line:?}"), &torque),
            }
        }
    }
}

#[test]
fn normal_force_to_1_14() {
    both("NR", MomentEquation);
    both("N = /R", ForceFromMoment);
    both("before (1-13)", ForceSubstituted::of);
    both("(1-13)", NormalForce::of);
    for contact in Sign::BOTH {
        both("after (1-13)", |form| FrictionSubstituted::of(form, contact));
        // Each of the two wrong exponents is wrong by itself.
        fails("one put right", &FrictionSubstituted { powers: [1, 3, 3], contact });
        fails("the other put right", &FrictionSubstituted { powers: [3, 5, 3], contact });
        holds("(1-14)", &FrictionOfMotion { contact });
    }
    // Of all half powers up to eight, one pair is right.
    for speed in 0..=8 {
        for angular_acceleration in 0..=8 {
            let right = prove(&NormalForce { powers: [speed, angular_acceleration] }).is_ok();
            assert_eq!(right, [speed, angular_acceleration] == [5, 3]);
        }
    }
}

#[test]
fn kinetic_energy_to_1_16() {
    holds("(1-9), (1-10) left", &LagrangeIsPower);
    both("T", |form| KineticEnergy(EnergyLine::Members(form)));
    holds("T with (1-7)", &KineticEnergy(EnergyLine::Substituted));
    holds("(1-16)", &KineticEnergy(EnergyLine::Bracketed));
    holds("dT/dθ'", &Momentum);
}

#[test]
fn derivatives_of_the_kinetic_energy() {
    holds("Undone", &MomentumRate::of(MomentumLine::Undone, Form::Printed));
    for line in MomentumLine::SLIPPED {
        both(&format!("{line:?}"), |form| MomentumRate::of(line, form));
        fails("I_b alone", &MomentumRate { line, letter: Form::Printed, quotient: Form::Corrected });
    }
    let (line, letter) = (MomentumLine::Quotient, Form::Corrected);
    fails("sign of the quotient alone", &MomentumRate { line, letter, quotient: Form::Printed });
    for line in PositionLine::ALL {
        holds(&format!("∂T/∂θ {line:?}"), &PositionRate::of(line));
    }
    both("T with I_b", PositionRate::energy);
}

#[test]
fn equation_of_motion_to_1_19() {
    holds("(1-17) first", &LeftSide(LeftSideLine::Minus));
    both("(1-17)", |form| LeftSide(LeftSideLine::Closed(form)));
    for contact in Sign::BOTH {
        both("after (1-17)", |form| EquationOfMotion {
            line: MotionLine::Substituted { square: form, bars: form },
            contact,
        });
        let square_lost = MotionLine::Substituted { square: Form::Printed, bars: Form::Corrected };
        fails("square alone", &EquationOfMotion { line: square_lost, contact });
        holds("(1-19)", &EquationOfMotion { line: MotionLine::Short, contact });
        holds("(1-18)", &EquationOfMotion { line: MotionLine::Divided { bars: Form::Corrected }, contact });
    }
    // Brackets are as good as bars for the plus sign, and wrong for the minus sign.
    for line in [
        MotionLine::Divided { bars: Form::Printed },
        MotionLine::Substituted { square: Form::Corrected, bars: Form::Printed },
    ] {
        holds("brackets, plus", &EquationOfMotion { line, contact: Sign::Plus });
        fails("brackets, minus", &EquationOfMotion { line, contact: Sign::Minus });
    }
    both("A", |form| CoefficientPrinted(Coefficient::A(form)));
    for coefficient in [Coefficient::B, Coefficient::C, Coefficient::D, Coefficient::E] {
        holds(&format!("{coefficient:?}"), &CoefficientPrinted(coefficient));
    }
}

#[test]
fn the_singularity_does_not_exist() {
    holds("θ∞", &SingularAngle);
    holds("(a − 1)²", &BoundAsSquare);
    holds("a = 1", &AtOne);
    holds("positive", &OffTheSingularity);
}

#[test]
fn appendices_b_and_d() {
    both("demonstration", Demonstration);
    for contact in Sign::BOTH {
        both("(1-19) again", |form| BarsReprinted { dots: form, bars: form, contact });
        fails("dots alone", &BarsReprinted { dots: Form::Printed, bars: Form::Corrected, contact });
    }
    let bars_lost = |contact| BarsReprinted { dots: Form::Corrected, bars: Form::Printed, contact };
    holds("bars lost, plus", &bars_lost(Sign::Plus));
    fails("bars lost, minus", &bars_lost(Sign::Minus));
    for sign in Sign::BOTH {
        for line in Opening::ALL {
            holds(&format!("{line:?}"), &BarsOpened { line, sign });
        }
        for line in StartingLine::ALL {
            both(&format!("start {line:?}"), |dots| StartingEquation { line, dots, sign });
        }
        holds("θ₀''", &StartingAcceleration { sign });
    }
    holds("start at entry", &StartAtEntry);
}
