//! Does the driver balance torque, inertia and friction, and on which flank does the pin press?

use geneva_dynamics::forces::Flank;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

fn escapement(friction: f64) -> Parameters {
    Parameters::new(Mechanism::FOUR_PIN, Inertias::new(1.0, 12.0).expect("sound"), 5.0, friction).expect("sound")
}

#[test]
fn the_driver_balances_torque_inertia_and_friction() {
    for mechanism in Mechanism::ALL {
        let inertias = Inertias::new(3.0, 4.0).expect("sound");
        let escapement = Parameters::new(mechanism, inertias, 2.0, 1.0 / 3.0).expect("sound");
        for step in -50..=50 {
            let angle = mechanism.engagement_half_angle() * f64::from(step) / 50.0;
            for speed in [0.0, 1.0, 9.0] {
                let forces = escapement.contact_forces(angle, speed).expect("one acceleration");
                let angular_acceleration = escapement.acceleration(angle, speed).expect("one acceleration").value;
                // Moments about the driver's axis: the normal force has the arm R φ'/θ'.
                let pose = escapement.pose(angle);
                let reaction = forces.normal_moment * pose.radius_squared.sqrt() * pose.velocity_ratio();
                let balance = 2.0 - reaction - forces.friction_torque - 3.0 * angular_acceleration;
                assert!(balance.abs() < 1e-12 * (1.0 + speed * speed), "{mechanism:?} {angle} {speed} {balance}");
            }
        }
    }
}

#[test]
fn a_fast_driver_is_driven_back_by_the_follower_past_the_line_of_centres() {
    let escapement = escapement(0.0);
    let flank = |angle: f64, speed: f64| escapement.contact_forces(angle, speed).expect("sound").flank;
    assert_eq!(flank(-1.0 / 3.0, 100.0), Flank::Leading);
    assert_eq!(flank(1.0 / 3.0, 100.0), Flank::Trailing);
    assert_eq!(flank(1.0 / 3.0, 0.0), Flank::Leading);
}

#[test]
fn there_is_no_friction_where_the_pin_does_not_slide_and_force_follows_length() {
    let escapement = escapement(1.0 / 4.0);
    let middle = escapement.contact_forces(0.0, 3.0).expect("sound");
    assert_eq!(middle.friction_torque, 0.0);
    assert!(middle.normal_moment > 0.0);
    assert_eq!(middle.normal_force(2.0), middle.normal_moment / 2.0);
    assert!(escapement.contact_forces(1.0 / 3.0, f64::NAN).is_err());
}
