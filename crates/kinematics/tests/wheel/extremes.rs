//! Do the closed forms of the extremes agree with the formulas at their places?

use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::wheel::{Wheel, acceleration_ratio, jerk_ratio};

#[test]
fn the_closed_forms_are_the_formulas_at_their_places() {
    for stations in 3..=60 {
        let wheel = Wheel::new(stations).unwrap();
        let ratio = wheel.centre_distance_ratio();
        let at = |angle: f64| Turn::from_radians(angle);
        approx::assert_relative_eq!(wheel.peak_velocity(), velocity_ratio(&ratio, &at(0.0)), max_relative = 1e-11);
        let entry = acceleration_ratio(&ratio, &at(-wheel.engagement_half_angle()));
        approx::assert_relative_eq!(wheel.entry_acceleration(), entry, max_relative = 1e-11);
        let peak = wheel.acceleration_peak();
        approx::assert_relative_eq!(peak.ratio, -acceleration_ratio(&ratio, &at(peak.angle)), max_relative = 1e-11);
        assert!(jerk_ratio(&ratio, &at(peak.angle)).abs() < 1e-9 * peak.ratio, "{stations}");
        assert!(peak.angle > 0.0 && peak.angle < wheel.engagement_half_angle(), "{stations}");
        assert!(peak.ratio > wheel.entry_acceleration(), "{stations}");
    }
}
