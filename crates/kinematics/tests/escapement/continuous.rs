//! Which pairs of pins and slots have one pin in a slot at all times, and which of them rest at the hand-over?

use geneva_kinematics::escapement::{ContinuityStep, ContinuousEscapement, HandOverMotion, possible_pairs};
use geneva_kinematics::pin_slot::{pin_from_pivot, velocity_ratio};
use geneva_kinematics::{Expression, Field, Identity, Mechanism, Rational, Surd, Turn, prove};
use std::f64::consts::PI;

fn all() -> impl Iterator<Item = ContinuousEscapement> {
    (2..=24).flat_map(|pins| (3..=24).filter_map(move |slots| ContinuousEscapement::new(pins, slots)))
}

#[test]
fn every_step_is_proven_for_all_angles() {
    for step in ContinuityStep::ALL {
        println!("{step:?}: {}", prove(&step).expect("an identity"));
    }
}

/// The centre distance of the escapements at rest, for other numbers: the gap must be seen.
struct WithAGap;

impl Identity<2> for WithAGap {
    fn difference(&self, [half_crank, half_slot]: [Expression; 2]) -> Expression {
        let (crank, slot) = (Turn::from_half_tangent(&half_crank), Turn::from_half_tangent(&half_slot));
        pin_from_pivot(&(1 / slot.sin), &crank).perp(&slot.direction())
    }
}

#[test]
fn the_distance_of_the_three_leaves_a_gap_with_other_numbers() {
    assert!(prove(&WithAGap).is_err());
}

#[test]
fn the_axes_are_apart_exactly_where_a_pair_exists() {
    for (pins, slots) in (1..=40).flat_map(|pins| (1..=40).map(move |slots| (pins, slots))) {
        let [crank, slot] = [pins, slots].map(|count: u32| PI / f64::from(count));
        let apart = (crank + slot).sin() / slot.sin() > 1.0 + 1e-12;
        assert_eq!(ContinuousEscapement::new(pins, slots).is_some(), apart, "{pins} pins, {slots} slots");
    }
    // Here the follower's axis would be on the circle of the pins.
    assert_eq!(ContinuousEscapement::new(3, 3), None);
}

#[test]
fn the_three_escapements_are_those_at_rest() {
    let resting: Vec<_> = all().filter(|at| at.hand_over_motion() == HandOverMotion::Rests).collect();
    let pairs: Vec<_> = resting.iter().rev().map(|at| (at.slots(), at.pins())).collect();
    assert_eq!(pairs, possible_pairs());
    for at in resting {
        let escapement = Mechanism::new(at.slots()).expect("one of the three");
        let close = |one: f64, other: f64| approx::assert_relative_eq!(one, other, max_relative = 1e-15);
        close(at.centre_distance_ratio(), escapement.centre_distance_ratio());
        close(at.rim_radius(), escapement.rim_radius());
        approx::assert_abs_diff_eq!(at.hand_over_ratio(), 0.0, epsilon = 1e-15);
    }
}

#[test]
fn the_follower_turns_on_stops_or_turns_back_by_the_sum_of_the_angles() {
    for at in all() {
        let (ratio, half) = (at.centre_distance_ratio(), at.engagement_half_angle());
        let speed = |part: f64| velocity_ratio(&ratio, &Turn::from_radians(half * part));
        approx::assert_abs_diff_eq!(speed(1.0), at.hand_over_ratio(), epsilon = 1e-13 * speed(0.0));
        // The least speed of the engagement is that of its ends.
        let least = (-50..=50).map(|k| speed(f64::from(k) / 50.0)).fold(f64::INFINITY, f64::min);
        assert!(least > speed(1.0) - 1e-13 * speed(0.0));
        let sign = match at.hand_over_motion() {
            HandOverMotion::TurnsOn => speed(1.0) > 1e-9,
            HandOverMotion::Rests => speed(1.0).abs() < 1e-13,
            HandOverMotion::TurnsBack => speed(1.0) < -1e-9,
        };
        assert!(sign, "{at:?}: {}", speed(1.0));
        // The rim keeps out all pins but the engaged one.
        for pin in 1..at.pins() {
            let place = pin_from_pivot(&ratio, &Turn::from_radians(half * (0.9 + 2.0 * f64::from(pin))));
            assert!(place.norm() > at.rim_radius(), "{at:?}");
        }
    }
}

#[test]
fn five_pins_and_five_slots_are_a_golden_ratio_apart_exactly() {
    type Root = Surd<Rational, 5>;
    let golden = (Root::integer(1) + Root::root()) / Root::integer(2);
    // sin 2x / sin x = 2 cos x, and cos 36° is half the golden ratio.
    let cos = golden.clone() / Root::integer(2);
    let at = ContinuousEscapement::new(5, 5).expect("a pair");
    approx::assert_relative_eq!(at.centre_distance_ratio(), golden.approximate(), max_relative = 1e-15);
    // Both pins give the follower cos 72° = (√5 − 1)/4; the sine stands in the ratio only by its sign.
    let speed = (golden.clone() * cos.clone() - Root::integer(1))
        / (Root::integer(1) + golden.clone() * golden.clone() - Root::integer(2) * golden * cos);
    assert_eq!(speed, (Root::root() - Root::integer(1)) / Root::integer(4));
    approx::assert_relative_eq!(at.hand_over_ratio(), speed.approximate(), max_relative = 1e-14);
    assert_eq!(at.hand_over_motion(), HandOverMotion::TurnsOn);
}
