//! Of the program: what the reset after a quarter of a turn does to six and to three pins.

use super::Number;
use geneva_dynamics::Pose;
use geneva_kinematics::{Mechanism, Turn};
use geneva_ledger::meyer::runs::Hypothesis;

/// The numbers of the chapter on the program.
pub const NUMBERS: &[(&str, Number)] = &[
    ("program.three-at-the-reset", || Ok(format!("{:.2}", ratio_at_the_reset(Mechanism::THREE_PIN)))),
    ("program.six-at-the-reset", || Ok(format!("{:.2}", -ratio_at_the_reset(Mechanism::SIX_PIN)))),
];

/// The follower's speed over the driver's where the program resets the angle, in the sense in which a pin drives it.
fn ratio_at_the_reset(mechanism: Mechanism) -> f64 {
    let angle = Hypothesis::WITHOUT_LAG.angle(mechanism) - mechanism.engagement_half_angle();
    Pose::new(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle)).velocity_ratio()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_pins_are_dropped_while_the_follower_turns_and_six_are_followed_until_it_runs_backwards() {
        assert!(ratio_at_the_reset(Mechanism::THREE_PIN) > 0.1);
        assert!(ratio_at_the_reset(Mechanism::SIX_PIN) < -0.1);
        // To the five digits of the reset angle.
        assert!(ratio_at_the_reset(Mechanism::FOUR_PIN).abs() < 1e-5);
    }
}
