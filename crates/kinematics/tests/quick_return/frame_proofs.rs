//! Are the equations of a moving frame proven, and refuted with another factor or other brackets?

use geneva_kinematics::prove;
use geneva_kinematics::quick_return::frame_proofs::{AccelerationInAFrame, Brackets, VelocityInAFrame};

#[test]
fn both_equations_hold_along_both_axes() {
    for first in [true, false] {
        assert!(prove(&VelocityInAFrame { first }).is_ok());
        let brackets = Brackets::FromTheRight;
        assert!(prove(&AccelerationInAFrame { first, brackets, coriolis: 2 }).is_ok());
    }
}

#[test]
fn neither_another_factor_nor_the_other_brackets_will_do() {
    for first in [true, false] {
        for coriolis in [-2, 0, 1, 3] {
            let brackets = Brackets::FromTheRight;
            assert!(prove(&AccelerationInAFrame { first, brackets, coriolis }).is_err(), "{coriolis}");
        }
        let brackets = Brackets::FromTheLeft;
        assert!(prove(&AccelerationInAFrame { first, brackets, coriolis: 2 }).is_err());
    }
}
