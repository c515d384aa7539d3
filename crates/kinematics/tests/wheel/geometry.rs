//! Which wheels can be built, and do they have the sizes of a pin in a slot?

use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_slot::PinSlot;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::PI;

#[test]
fn what_cannot_be_built_is_said_with_what_can() {
    assert_eq!(Wheel::new(2), Err(KinematicsError::Stations(2)));
    assert!(Wheel::new(1001).is_err());
    for (stations, most) in [(3, 6), (4, 4), (5, 3), (6, 3), (7, 2), (1000, 2)] {
        assert!(Wheel::with_pins(stations, most).is_ok(), "{stations}");
        assert_eq!(
            Wheel::with_pins(stations, most + 1),
            Err(KinematicsError::Pins { asked: most + 1, most, stations })
        );
        assert!(Wheel::with_pins(stations, 0).is_err());
    }
    let message = Wheel::with_pins(6, 4).unwrap_err().to_string();
    assert!(message.contains("4 pins") && message.contains("1 to 3"), "{message}");
    for speed in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Wheel::new(4).unwrap().dwell_time(speed).is_err(), "{speed}");
    }
}

#[test]
fn sizes_are_those_of_the_pin_in_a_slot() {
    for stations in [3, 4, 7, 60] {
        let wheel = Wheel::new(stations).unwrap();
        let mechanism = PinSlot::new(1.0, wheel.centre_distance_ratio()).unwrap();
        approx::assert_relative_eq!(
            mechanism.engagement_half_angle(),
            wheel.engagement_half_angle(),
            max_relative = 1e-13
        );
        // Pythagoras in the triangle at entry: crank and wheel radius are its legs.
        let hypotenuse = libm::hypot(1.0, wheel.wheel_radius_ratio());
        approx::assert_relative_eq!(hypotenuse, wheel.centre_distance_ratio(), max_relative = 1e-14);
        assert!(wheel.slot_length_ratio() > 0.0 && wheel.slot_length_ratio() < 1.0);
    }
}

#[test]
fn motion_and_dwell_make_a_turn() {
    for (stations, pins) in [(3, 1), (4, 4), (6, 2), (18, 2)] {
        let wheel = Wheel::with_pins(stations, pins).unwrap();
        approx::assert_relative_eq!(wheel.motion_fraction() + wheel.dwell_fraction(), 1.0, max_relative = 1e-15);
        let cycle = wheel.indexing_time(3.0).unwrap() + wheel.dwell_time(3.0).unwrap();
        approx::assert_relative_eq!(cycle * f64::from(pins), 2.0 * PI / 3.0, max_relative = 1e-14);
    }
    assert_eq!(Wheel::with_pins(4, 4).unwrap().dwell_fraction(), 0.0);
}
