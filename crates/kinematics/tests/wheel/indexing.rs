//! Do the vector diagrams give the same pin in its slot?

use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_slot::slot_radius_squared;
use geneva_kinematics::relative_motion::{accelerations, velocities};
use geneva_kinematics::wheel::{Wheel, jerk_ratio};
use nalgebra::Vector2;

#[test]
fn the_pin_in_its_slot_is_that_of_the_vector_diagrams() {
    for stations in [3, 4, 6, 12, 60] {
        let wheel = Wheel::new(stations).unwrap();
        let ratio = wheel.centre_distance_ratio();
        for share in [-0.9, -0.3, 0.1, 0.8] {
            let crank = share * Wheel::engagement_half_angle(&wheel);
            let turn = Turn::from_radians(crank);
            let pin = wheel.pin_in_slot(crank).unwrap();
            approx::assert_relative_eq!(
                pin.radius * pin.radius,
                slot_radius_squared(&ratio, &turn),
                max_relative = 1e-11
            );
            // The wheel's axis is the origin, the driver's (k, 0); for a growing θ the driver turns clockwise.
            let place = Vector2::new(ratio - turn.cos, turn.sin);
            let motion = velocities(&place, &Vector2::new(turn.sin, turn.cos)).unwrap();
            let along = motion.sliding_velocity.dot(&place) / place.norm();
            approx::assert_relative_eq!(pin.sliding, along, max_relative = 1e-10);
            let terms = accelerations(&motion, &Vector2::new(turn.cos, -turn.sin)).unwrap();
            let across = place.perp(&terms.coriolis) / place.norm();
            approx::assert_relative_eq!(pin.coriolis, across, max_relative = 1e-10);
        }
    }
}

#[test]
fn the_jerk_on_the_line_of_centres_is_its_formula_there() {
    for stations in [3, 4, 7, 60, 1000] {
        let wheel = Wheel::new(stations).unwrap();
        let jerk = jerk_ratio(&wheel.centre_distance_ratio(), &Turn::from_radians(0.0));
        approx::assert_relative_eq!(wheel.jerk_peak().ratio, -jerk, max_relative = 1e-11);
    }
}
