//! Does the series say what the diagrams say?

use geneva_kinematics::quick_return::series::polar_rates;
use geneva_kinematics::quick_return::{Drive, LeverMotion};
use geneva_kinematics::{Turn, rational};

#[test]
fn the_series_says_what_the_diagrams_say_exactly() {
    let crank = Turn::from_half_tangent(&rational(2, 3));
    let (ground, radius) = (rational(9, 4), rational(1, 1));
    let drive = Drive { speed: rational(5, 1), acceleration: rational(-7, 2) };
    let rates = polar_rates(&ground, &radius, &crank, &drive).expect("off the pivot");
    let motion = LeverMotion::new(&ground, &radius, &crank, &drive).expect("off the pivot");
    assert_eq!(rates.angular_velocity, motion.velocities.follower_speed);
    assert_eq!(rates.angular_acceleration, motion.accelerations.follower_acceleration);
    assert_eq!(rates.position.clone() * rates.sliding, motion.velocities.sliding_velocity);
    assert_eq!(rates.position * rates.sliding_rate, motion.accelerations.sliding_tangential);
}

#[test]
fn there_are_no_rates_on_the_pivot() {
    let half_turn = Turn { cos: rational(-1, 1), sin: rational(0, 1) };
    let drive = Drive::steady(rational(1, 1));
    assert_eq!(polar_rates(&rational(1, 1), &rational(1, 1), &half_turn, &drive), None);
}
