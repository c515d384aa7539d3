//! Shares of assemblies that turn.

use super::super::assembly::sized;
use geneva_kinematics::wheel::as_built::{Assemblies, BuiltPin, ErrorShape, SizeErrors, SplitMix64, Yield};
use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};

fn four(play: f64) -> Sizes {
    let choices = Choices { play: Some(Play::from_slot(play)), pin_diameter: Some(6.0), ..Choices::default() };
    Sizes::new(Wheel::new(4).unwrap(), Scale::CrankRadius(25.0), &choices).unwrap()
}

#[test]
fn groups_of_assemblies_add_up_whichever_is_first() {
    let assemblies = Assemblies::new(&four(0.2), SizeErrors::from_greatest(0.1), ErrorShape::Normal, 3);
    let all = assemblies.count(0..120).unwrap();
    let parts = assemblies.count(70..120).unwrap().plus(assemblies.count(0..70).unwrap());
    assert_eq!(all, parts);
    assert!(all.turning > 0 && all.turning < 120, "{all:?}");
}

#[test]
fn more_play_lets_more_assemblies_turn_and_larger_errors_fewer() {
    let share = |play: f64, error: f64| {
        let assemblies = Assemblies::new(&four(play), SizeErrors::from_greatest(error), ErrorShape::Uniform, 1);
        assemblies.count(0..400).unwrap().share()
    };
    for error in [0.05, 0.1, 0.2] {
        let shares = [0.1, 0.2, 0.35, 0.5, 0.8].map(|play| share(play, error));
        assert!(shares.is_sorted(), "{shares:?}");
    }
    assert!(share(0.35, 0.05) >= share(0.35, 0.1) && share(0.35, 0.1) >= share(0.35, 0.2));
}

#[test]
fn uniform_numbers_and_normal_numbers_have_their_moments() {
    let mut random = SplitMix64::new(5);
    let n = 200_000;
    let mean = |values: &[f64], power: i32| values.iter().map(|x| x.powi(power)).sum::<f64>() / values.len() as f64;
    let uniform: Vec<f64> = (0..n).map(|_| random.next_signed()).collect();
    assert!(mean(&uniform, 1).abs() < 0.01 && (mean(&uniform, 2) - 1.0 / 3.0).abs() < 0.01);
    let normal: Vec<f64> = (0..n).map(|_| random.next_normal()).collect();
    assert!(mean(&normal, 1).abs() < 0.01 && (mean(&normal, 2) - 1.0).abs() < 0.02);
    assert!((mean(&normal, 4) - 3.0).abs() < 0.1);
}

#[test]
fn the_interval_of_a_share_has_it() {
    let [low, high] = Yield { tried: 1000, turning: 900 }.interval();
    // Wilson's score for 0.9 of 1000 by hand: 0.90 − 0.0202, 0.90 + 0.0171.
    assert!((low - 0.8798).abs() < 1e-4 && (high - 0.9171).abs() < 1e-4, "{low} {high}");
    assert_eq!(Yield { tried: 10, turning: 10 }.interval()[1], 1.0);
}

#[test]
fn the_generator_is_the_published_one() {
    let mut random = SplitMix64::new(1_234_567);
    let numbers = [0; 3].map(|_| random.next_u64());
    assert_eq!(numbers, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]);
}

#[test]
fn sizes_are_drawn_within_their_errors() {
    let sizes = sized(6, 2, &Choices::default());
    let errors = SizeErrors::from_greatest(0.1);
    let built = Assemblies::new(&sizes, errors, ErrorShape::Normal, 8).assembly(4);
    for slot in built.slots() {
        assert!((slot.width - sizes.slot_width).abs() <= 0.1 && slot.width != sizes.slot_width);
    }
    assert!((built.centre_distance - sizes.centre_distance).abs() <= 0.1);
}

#[test]
fn axes_are_anywhere_within_the_play_of_their_bores_and_all_else_is_as_without_it() {
    let tight = Assemblies::new(&four(0.2), SizeErrors::from_greatest(0.05), ErrorShape::Normal, 3);
    let loose = tight.clone().with_bore_play(0.3);
    let (mut far, mut right, count) = (0.0_f64, 0, 2000);
    for k in 0..count {
        let (parts, axes) = loose.loose_assembly(k);
        assert_eq!(parts, tight.assembly(k), "{k}");
        let shifts = [axes[0], axes[1] - nalgebra::Vector2::new(parts.centre_distance, 0.0)];
        for shift in shifts {
            assert!(shift.norm() <= 0.15, "{shift}");
            far = far.max(shift.norm());
        }
        right += usize::from(shifts[0].x > 0.0);
        let distance = loose.assembly(k).centre_distance;
        assert!((distance - parts.centre_distance).abs() <= 0.3 && distance != parts.centre_distance);
    }
    // A quarter of the places is within half of the greatest shift, and half on either side.
    let near = (0..count).filter(|k| loose.loose_assembly(*k).1[0].norm() < 0.075).count();
    assert!((near as f64 / count as f64 - 0.25).abs() < 0.04, "{near}");
    assert!((right as f64 / count as f64 - 0.5).abs() < 0.05 && far > 0.149, "{right} {far}");
}

#[test]
fn more_play_of_the_bores_lets_fewer_assemblies_turn() {
    let tight = Assemblies::new(&four(0.3), SizeErrors::from_greatest(0.1), ErrorShape::Uniform, 1);
    let shares =
        [0.8, 0.5, 0.3, 0.1, 0.0].map(|play| tight.clone().with_bore_play(play).count(0..300).unwrap().share());
    assert!(shares.is_sorted() && shares[0] < shares[4] - 0.1, "{shares:?}");
}

#[test]
fn pins_are_anywhere_within_their_shift_and_the_disc_within_its_turn_and_all_else_is_as_without() {
    let sizes = sized(6, 2, &Choices::default());
    let tight = Assemblies::new(&sizes, SizeErrors::from_greatest(0.02), ErrorShape::Normal, 3).with_bore_play(0.05);
    let loose = tight.clone().with_pin_shift(0.3).with_disc_turn(0.1);
    let (mut far, mut turned, count) = (0.0_f64, [0.0_f64; 2], 1000);
    for k in 0..count {
        let [one, other] = [&tight, &loose].map(|assemblies| assemblies.assembly(k));
        assert_eq!(
            (one.slots(), one.arcs(), one.centre_distance),
            (other.slots(), other.arcs(), other.centre_distance)
        );
        let at = |pin: &BuiltPin| {
            pin.crank_radius * nalgebra::Vector2::from([pin.direction_error.cos(), pin.direction_error.sin()])
        };
        let turns = one.pins().iter().zip(other.pins()).map(|(one, other)| {
            let shift = (at(other) - at(one)).norm();
            assert!(shift <= 0.3 && one.diameter == other.diameter, "{k}: {shift}");
            far = far.max(shift);
            other.crescent.direction_error - one.crescent.direction_error
        });
        let turns: Vec<f64> = turns.collect();
        assert!((turns[0] - turns[1]).abs() < 1e-15 && turns[0].abs() <= 0.1, "{k}: both are cut into one disc");
        turned = [turned[0].min(turns[0]), turned[1].max(turns[0])];
    }
    assert!(far > 0.29 && turned[0] < -0.09 && turned[1] > 0.09, "{far} {turned:?}");
}

#[test]
fn loose_pins_and_a_loose_disc_let_fewer_assemblies_turn() {
    let tight = Assemblies::new(&four(0.3), SizeErrors::from_greatest(0.05), ErrorShape::Uniform, 1);
    let of = |assemblies: Assemblies| assemblies.count(0..300).unwrap().share();
    let pins = [0.6, 0.4, 0.2, 0.0].map(|shift| of(tight.clone().with_pin_shift(shift)));
    assert!(pins.is_sorted() && pins[0] < pins[3] - 0.2, "{pins:?}");
    // Beyond half a pitch as much as just below it.
    let discs = [9.0, 0.2, 0.1, 0.0].map(|turn| of(tight.clone().with_disc_turn(turn)));
    assert!(discs.is_sorted() && discs[0] < 0.5 * discs[3], "{discs:?}");
}

#[test]
fn shares_are_near_those_of_another_simulation() {
    // Another program drew 40 assemblies for each case, of one error of each kind for all slots, and swept polygons over the turn: shares in
    // per cent for plays of 0.1 to 0.8 mm, with errors of 0.05, 0.1 and 0.2 mm of lengths, diameters and places.
    let others = [
        (0.1, [88.0, 58.0, 33.0]),
        (0.2, [100.0, 83.0, 55.0]),
        (0.35, [100.0, 98.0, 65.0]),
        (0.5, [100.0, 100.0, 95.0]),
        (0.8, [100.0, 100.0, 100.0]),
    ];
    for (play, shares) in others {
        for (error, other) in [0.05, 0.1, 0.2].into_iter().zip(shares) {
            // Which of the places were wrong is not known: all of them, or none.
            let [most, least] = [0.0, error].map(|place| {
                let half = error / 2.0;
                let errors = SizeErrors {
                    arc_radius: half,
                    disc_radius: half,
                    tip_radius: half,
                    crescent_radius: half,
                    place,
                    ..SizeErrors::from_greatest(error)
                };
                let assemblies = Assemblies::new(&four(play), errors, ErrorShape::Uniform, 1).alike();
                100.0 * assemblies.count(0..400).unwrap().share()
            });
            // Twice the standard deviation of 40 assemblies is up to 16 per cent.
            assert!(least - 16.0 <= other && other <= most + 16.0, "{play} {error}: {least} {most} {other}");
        }
    }
}
