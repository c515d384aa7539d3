//! Where are the pins that are in no slot, and is there room between slots and axes?

use geneva_kinematics::escapement::{ApproachCoefficient, RimExcess};
use geneva_kinematics::{Mechanism, prove};

#[test]
fn a_pin_is_outside_the_rim_exactly_while_it_is_in_no_slot() {
    println!("{}", prove(&RimExcess).expect("an identity"));
    for escapement in Mechanism::ALL {
        let half = escapement.engagement_half_angle();
        for step in -999..=999 {
            let clearance = escapement.idle_clearance(half * f64::from(step) / 1000.0).unwrap();
            assert!(clearance > 0.0, "{step}");
        }
        // On the line of centres, and at the hand-over, where the two pins at the rim are in their slots.
        for crank in [0.0, half, -half] {
            println!("{} slots, {crank}: {}", escapement.slots(), escapement.idle_clearance(crank).unwrap());
            assert!(escapement.idle_clearance(crank).unwrap() > 0.4);
        }
        assert!(escapement.idle_clearance(2.0 * half).is_err());
    }
}

#[test]
fn a_pin_comes_in_from_the_side_with_the_square_of_the_angle() {
    for coefficient in ApproachCoefficient::ALL {
        println!("{coefficient:?}: {}", prove(&coefficient).expect("an identity"));
    }
    for escapement in Mechanism::ALL {
        // The pin that comes after the first is the last one, counted round.
        let (pin, slot) = (escapement.pins() as usize - 1, escapement.slots() as usize - 1);
        for before in [1e-2, 1e-3] {
            let layout = escapement.layout(escapement.engagement_half_angle() - before).unwrap();
            let meeting = layout.meeting(pin, slot).unwrap();
            approx::assert_relative_eq!(meeting.beside.abs(), before * before, max_relative = 5.0 * before);
            approx::assert_relative_eq!(meeting.out - escapement.rim_radius(), before, max_relative = 5.0 * before);
        }
    }
}

#[test]
fn there_is_room_between_slots_and_axes() {
    for escapement in Mechanism::ALL {
        let (a, rim) = (escapement.centre_distance_ratio(), escapement.rim_radius());
        let alpha = escapement.follower_half_angle();
        approx::assert_relative_eq!(escapement.shaft_limit(), a - rim, max_relative = 1e-14);
        approx::assert_relative_eq!(escapement.slot_length(), rim - (a - 1.0), max_relative = 1e-14);
        let layout = escapement.layout(0.0).unwrap();
        let (one, next) = (&layout.slots[0], &layout.slots[1]);
        approx::assert_relative_eq!(escapement.web(), (one.bottom - next.bottom).norm(), max_relative = 1e-14);
        approx::assert_relative_eq!(escapement.slot_length(), (one.mouth - one.bottom).norm(), max_relative = 1e-14);
        let chord = (one.mouth - next.mouth).norm();
        approx::assert_relative_eq!(escapement.rim_arc(), chord * alpha / alpha.sin(), max_relative = 1e-14);
        println!(
            "{} slots: length {}, arc {}, web {}, shaft {}",
            escapement.slots(),
            escapement.slot_length(),
            escapement.rim_arc(),
            escapement.web(),
            escapement.shaft_limit()
        );
    }
}
