//! Is the hand-over without rounding where the drawing in floating point ends?

use geneva_kinematics::escapement::{Configuration, HandOver, RelativePosition, Roots, Slot};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::{Field, Mechanism, Surd, Turn, pin_vectors};
use nalgebra::Vector2;
use num_traits::{One, Zero};

/// π over 3, 4 or 6, the only numbers of slots and of pins there are.
fn exact_part_of_half_turn(count: u32) -> Turn<Roots> {
    let half = Roots::one() / Roots::integer(2);
    let root_of_two = Roots::from_plain(Surd::root());
    match count {
        3 => Turn { cos: half.clone(), sin: Roots::root() * half },
        4 => Turn { cos: root_of_two.clone() * half.clone(), sin: root_of_two * half },
        _ => Turn { cos: Roots::root() * half.clone(), sin: half },
    }
}

/// So many angles, each one pitch further than the one before.
fn turned(first: Turn<Roots>, pitch: &Turn<Roots>, count: u32) -> Vec<Turn<Roots>> {
    std::iter::successors(Some(first), |angle| Some(angle.plus(pitch))).take(count as usize).collect()
}

#[test]
fn at_the_hand_over_both_pins_move_along_their_slots_exactly() {
    let (zero, one) = (Roots::zero(), Roots::one());
    for escapement in Mechanism::ALL {
        let HandOver { layout, leaving, entering, follower_speeds, gap } = escapement.hand_over();
        let (half, ratio) = (exact_part_of_half_turn(escapement.slots()), layout.follower_axis.x.clone());
        let rim = half.cos / half.sin;
        let straight =
            |outward| RelativePosition { out: rim.clone(), beside: zero.clone(), outward, across: zero.clone() };
        assert_eq!(leaving, straight(one.clone()));
        assert_eq!(entering, straight(-one.clone()));
        assert_eq!(follower_speeds, [zero.clone(), zero.clone()]);
        assert_eq!(gap, Vector2::new(zero.clone(), zero.clone()));
        // The two are the pins and slots of the whole drawing, and no other pin is on or inside the rim.
        let (pin, slot) = (escapement.pins() as usize - 1, escapement.slots() as usize - 1);
        assert_eq!(layout.engaged, [(0, 0), (pin, slot)]);
        assert_eq!((layout.meeting(0, 0), layout.meeting(pin, slot)), (Some(leaving), Some(entering)));
        for (index, place) in layout.pins.iter().enumerate() {
            let from_follower = place - &layout.follower_axis;
            let beyond = from_follower.dot(&from_follower) - rim.clone() * rim.clone();
            assert_eq!(beyond.is_zero(), index == 0 || index == pin, "{index}");
            assert!(beyond.approximate() > -1e-15);
        }
        // By the other route: what carries the follower's point under the pin is nothing.
        for angle in [exact_part_of_half_turn(escapement.pins()), exact_part_of_half_turn(escapement.pins()).reversed()]
        {
            let motion = pin_vectors::solve(&one, &ratio, &angle.supplement(), &one).unwrap();
            assert_eq!(motion.follower_speed, zero);
            assert_eq!(motion.sliding_velocity, motion.pin_velocity);
        }
    }
}

#[test]
fn pitches_make_a_turn_and_the_half_angles_a_quarter_exactly() {
    for escapement in Mechanism::ALL {
        let halves = [escapement.pins(), escapement.slots()].map(exact_part_of_half_turn);
        // They are the angles of the drawing: of pin 0 and of slot 0.
        let layout = escapement.hand_over().layout;
        assert_eq!(layout.pins[0], halves[0].direction());
        assert_eq!(layout.slots[0].direction, halves[1].supplement().direction());
        assert_eq!(halves[0].plus(&halves[1]), Turn { cos: Roots::zero(), sin: Roots::one() });
        for (half, count) in halves.iter().zip([escapement.pins(), escapement.slots()]) {
            let around = turned(half.clone(), &half.plus(half), count + 1);
            assert_eq!(around.first(), around.last());
        }
    }
}

#[test]
fn the_exact_drawing_is_where_the_rounded_one_ends() {
    for escapement in Mechanism::ALL {
        let exact = escapement.hand_over().layout;
        let rounded = escapement.layout(escapement.engagement_half_angle()).unwrap();
        assert_eq!(exact.engaged, rounded.engaged);
        let close = |exact: &Vector2<Roots>, rounded: &Vector2<f64>| {
            approx::assert_abs_diff_eq!(exact.map(|x| x.approximate()), *rounded, epsilon = 1e-14);
        };
        close(&exact.follower_axis, &rounded.follower_axis);
        exact.pins.iter().zip(&rounded.pins).for_each(|(exact, rounded)| close(exact, rounded));
        for (exact, rounded) in exact.slots.iter().zip(&rounded.slots) {
            close(&exact.mouth, &rounded.mouth);
            close(&exact.bottom, &rounded.bottom);
        }
        let early = escapement.layout(-escapement.engagement_half_angle()).unwrap();
        assert_eq!(early.engaged, [(0, 0), (1, 1)]);
    }
}

#[test]
fn engaged_pins_stay_in_their_slots_and_the_other_sense_is_the_mirror_image() {
    for escapement in Mechanism::ALL {
        let half = escapement.engagement_half_angle();
        for step in -40_i32..=40 {
            let crank = half * f64::from(step) / 40.0;
            let layout = escapement.layout(crank).unwrap();
            assert_eq!(layout.engaged.len(), if step.abs() == 40 { 2 } else { 1 });
            for &(pin, slot) in &layout.engaged {
                let meeting = layout.meeting(pin, slot).unwrap();
                approx::assert_abs_diff_eq!(meeting.beside, 0.0, epsilon = 1e-14);
                let (least, most) = (escapement.centre_distance_ratio() - 1.0, escapement.rim_radius());
                assert!(meeting.out > least - 1e-14 && meeting.out < most + 1e-14, "{step}");
                // Across the slot the pin carries the follower: R φ̇, clockwise.
                let speed = escapement.wheel().velocity_ratio(crank).unwrap();
                approx::assert_abs_diff_eq!(meeting.across, -meeting.out * speed, epsilon = 1e-14);
            }
            let mirrored = escapement.layout(-crank).unwrap();
            for pin in 0..layout.pins.len() {
                let (one, other) = (layout.pins[pin], mirrored.pins[(layout.pins.len() - pin) % layout.pins.len()]);
                approx::assert_abs_diff_eq!(one, Vector2::new(other.x, -other.y), epsilon = 1e-14);
            }
        }
        // The wheel's π/m is the nearest number to it, a unit above the quotient.
        let most = escapement.wheel().engagement_half_angle();
        let beyond = [most.next_up(), -most.next_up(), f64::NAN, f64::INFINITY];
        assert!(beyond.iter().all(|&crank| escapement.layout(crank).is_err()));
        assert_eq!(escapement.layout(0.1).unwrap().meeting(99, 0), None);
    }
}

#[test]
fn with_other_numbers_the_pin_does_not_come_in_along_the_slot() {
    for (slots, pins) in (3..=12).flat_map(|slots| (2..=12).map(move |pins| (slots, pins))) {
        let half = |count: i32| Turn::from_radians(std::f64::consts::PI / f64::from(count));
        let (crank, slot) = (half(pins), half(slots));
        let (follower_axis, direction) = (Vector2::new(1.0 / slot.sin, 0.0), slot.supplement().direction());
        let mouth = follower_axis + direction * (slot.cos / slot.sin);
        let bottom = follower_axis + direction * (1.0 / slot.sin - 1.0);
        let layout = Configuration {
            follower_axis,
            pins: vec![crank.direction()],
            slots: vec![Slot { direction, mouth, bottom }],
            engaged: vec![(0, 0)],
        };
        let meeting = layout.meeting(0, 0).unwrap();
        let straight = meeting.beside.abs() + meeting.across.abs() < 1e-12;
        assert_eq!(straight, (slots - 2) * (pins - 2) == 4, "{slots} slots, {pins} pins");
    }
}
