//! Is a run on the steady profile from the reported time on, and not before?

use super::escapement;
use geneva_dynamics::DynamicsError;
use geneva_dynamics::steady::{Engagement, PrintedLine};
use geneva_kinematics::Mechanism;

fn engagement(friction: f64) -> Engagement {
    Engagement::new(&escapement(Mechanism::FOUR_PIN, 0.06, friction)).expect("an engagement")
}

#[test]
fn from_then_on_each_printed_speed_is_near_the_steady_one_and_just_before_it_is_not() {
    for friction in [0.2, 0.25, 0.3, 0.35] {
        let (of, part) = (engagement(friction), 0.01);
        let reached = of.until_profile(part).expect("a rise");
        let cycle = of.steady_cycle(4000).expect("a cycle");
        let steady = |angle: f64| {
            let pair = cycle.windows(2).find(|pair| pair[0].angle <= angle && angle <= pair[1].angle)?;
            let share = (angle - pair[0].angle) / (pair[1].angle - pair[0].angle);
            Some(pair[0].speed + share * (pair[1].speed - pair[0].speed))
        };
        let lines = of.run(reached / 400.0, 3.0 * reached).expect("a run");
        let off = |line: &PrintedLine| (line.speed / steady(line.angle).expect("a speed") - 1.0).abs();
        let last = lines.iter().rfind(|line| off(line) > part).expect("a departure");
        assert!((last.time - reached).abs() < 2.0 * reached / 400.0, "{friction}: {} {reached}", last.time);
    }
}

#[test]
fn a_part_that_is_none_is_refused() {
    for part in [0.0, 1.0, -1.0, f64::NAN] {
        assert!(matches!(engagement(0.3).until_profile(part), Err(DynamicsError::OutOfRange { .. })));
    }
}
