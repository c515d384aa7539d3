//! Does the circle of the steady motion give the pose of the mechanism?

use geneva_dynamics::Pose;
use geneva_kinematics::{Mechanism, Turn};
use source::Circle;
use std::f64::consts::PI;

/// The variable, compiled here by itself because the crate keeps it private.
#[allow(dead_code, unreachable_pub, reason = "a file of the library, of which the tests use a part")]
#[path = "../../src/steady/circle.rs"]
mod source;

#[test]
fn the_circle_has_the_pose_of_the_mechanism() {
    for mechanism in Mechanism::ALL {
        let circle = Circle::lookup(mechanism);
        for step in 0..=300 {
            let angle = PI * f64::from(step) / 300.0;
            let (w, pose) =
                (circle.w_at_angle(angle), Pose::new(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle)));
            let place = circle.place(w);
            assert!((circle.angle(w) - angle).abs() < 2e-15 * (1.0 + angle), "{mechanism:?} {angle}");
            assert!((place.rho - pose.velocity_ratio()).abs() < 2e-13 * circle.radius, "{mechanism:?} {angle}");
            assert!(
                (place.k - pose.k_sin_theta / pose.radius_squared).abs() < 2e-13 * circle.radius,
                "{mechanism:?} {angle}"
            );
            let rate = -place.k * place.angular_velocity();
            assert!((rate - pose.acceleration_ratio()).abs() < 2e-12 * circle.radius, "{mechanism:?} {angle}");
        }
        assert!((circle.angle(circle.exit) - mechanism.engagement_half_angle()).abs() < 1e-15);
        assert!(circle.place(circle.exit).rho.abs() < 1e-15 * circle.radius);
    }
}
