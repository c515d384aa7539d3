//! Does a stronger spring drive the same motion faster?

use crate::proving::holds;
use geneva_dynamics::similarity::{Scaling, Similarity, SimilarityOfTheSign};
use geneva_dynamics::{Inertias, Parameters, Sign};
use geneva_kinematics::Mechanism;

#[test]
fn the_equation_scales_with_the_drive() {
    for sign in Sign::BOTH {
        holds("similarity", &Similarity(sign));
    }
    holds("similarity of the sign", &SimilarityOfTheSign);
}

#[test]
fn a_stronger_spring_drives_the_same_motion_faster() {
    let inertias = Inertias::new(3.0, 50.0).expect("sound");
    let weak = Parameters::new(Mechanism::FOUR_PIN, inertias, 2.0, 1.0 / 3.0).expect("sound");
    let strong = Parameters::new(Mechanism::FOUR_PIN, inertias, 14.0, 1.0 / 3.0).expect("sound");
    let scaling = Scaling::from_drives(weak.drive(), strong.drive()).expect("both positive");
    for step in -20..=20 {
        let angle = Mechanism::FOUR_PIN.engagement_half_angle() * f64::from(step) / 20.0;
        for speed in [0.0, 1.0, 4.0] {
            let slow = weak.acceleration(angle, speed).expect("one acceleration");
            let fast = strong.acceleration(angle, speed * scaling.speed).expect("one acceleration");
            approx::assert_relative_eq!(fast.value, slow.value * scaling.acceleration, max_relative = 1e-12);
        }
    }
    assert_eq!(Scaling::from_drives(0.0, 1.0), None);
    assert_eq!(Scaling::from_drives(1.0, -1.0), None);
    assert_eq!(Scaling::from_drives(f64::NAN, 1.0), None);
}
