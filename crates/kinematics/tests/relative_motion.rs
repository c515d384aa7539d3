//! Do the vector diagrams give what differentiation gives?

use geneva_kinematics::pin_vectors::PinMotion;
use geneva_kinematics::relative_motion::{accelerations, velocities};
use geneva_kinematics::{Turn, pin_vectors, rational};
use nalgebra::Vector2;

#[test]
fn the_diagram_gives_what_differentiation_gives() {
    let crank = Turn::from_half_tangent(&rational(5, 2));
    let motion = pin_vectors::solve(&rational(2, 1), &rational(3, 1), &crank, &rational(7, 1)).expect("off the pivot");
    assert_eq!(velocities(&motion.position, &motion.pin_velocity), Some(motion));
}

#[test]
fn a_bead_on_a_steady_spoke_feels_coriolis_across_and_nothing_else_across() {
    // Follower at ω = 3, bead at (2, 0) sliding outwards at 5 without speeding up along the spoke.
    let (position, velocity) = (Vector2::new(2.0, 0.0), Vector2::new(5.0, 6.0));
    let motion = velocities(&position, &velocity).expect("off the pivot");
    assert_eq!(motion.follower_speed, 3.0);
    let found = accelerations(&motion, &Vector2::new(-18.0, 30.0)).expect("off the pivot");
    assert_eq!(found.coriolis, Vector2::new(0.0, 30.0));
    assert_eq!(found.follower_acceleration, 0.0);
    assert_eq!(found.sliding_tangential, Vector2::zeros());
}

#[test]
fn on_the_pivot_there_is_no_diagram() {
    let (origin, velocity) = (Vector2::new(0.0, 0.0), Vector2::new(1.0, 0.0));
    assert_eq!(velocities(&origin, &velocity), None);
    assert_eq!(accelerations(&PinMotion::new(origin, velocity, 1.0), &velocity), None);
}
