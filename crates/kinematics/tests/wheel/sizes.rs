//! Do the default sizes run clear, and do errors say what does not fit?

use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, SizesError, Wheel};

fn sized(stations: u32, choices: &Choices) -> Result<Sizes, SizesError> {
    Sizes::new(Wheel::new(stations).unwrap(), Scale::CentreDistance(100.0), choices)
}

#[test]
fn every_wheel_has_sizes_that_run_clear() {
    for stations in (3..=60).chain([100, 300, 1000]) {
        for pins in 1..=6 {
            let Ok(wheel) = Wheel::with_pins(stations, pins) else { continue };
            for a in [0.7, 50.0] {
                let sizes = Sizes::new(wheel, Scale::CrankRadius(a), &Choices::default()).unwrap();
                let clearance = sizes.clearance();
                let gap = sizes.play.slot / 2.0;
                let least = clearance.closest_approach().distance;
                assert!((least / gap - 1.0).abs() < 1e-6, "{stations} stations, {pins} pins: {clearance:?}");
            }
        }
    }
}

#[test]
fn thin_and_fat_pins_run_clear_or_are_refused() {
    let mut refused = Vec::new();
    for stations in [3, 4, 6, 8, 12, 60] {
        let a = 100.0 / Wheel::new(stations).unwrap().centre_distance_ratio();
        for tenth in 1..=9 {
            for horn in [0.3, 1.0, 2.0] {
                for play in [0.0, 0.02, 0.2] {
                    let pin = 0.05 * f64::from(tenth) * a;
                    let play = Play::from_slot(play * pin);
                    let choices = Choices {
                        pin_diameter: Some(pin),
                        play: Some(play),
                        horn_thickness: Some(horn * pin),
                        ..Choices::default()
                    };
                    match sized(stations, &choices) {
                        Ok(sizes) => {
                            let clearance = sizes.clearance();
                            let (least, gap) = (clearance.closest_approach().distance, play.slot / 2.0);
                            let said =
                                format!("{stations} stations, pin {tenth}, horn {horn}, {play:?}: {clearance:?}");
                            if play.slot < 0.1 * pin {
                                assert!((least - gap).abs() <= 1e-6 * pin, "{said}");
                            } else {
                                // With so much play a small disc's edges pass the horns nearer than it fits its arc.
                                assert!(least > 0.3 * gap && least <= gap * (1.0 + 1e-9), "{said}");
                            }
                        }
                        Err(SizesError::DoesNotFit { what, by, .. }) => {
                            assert!(by >= 0.0, "{what} {by}");
                            refused.push(what);
                        }
                        Err(other) => panic!("{other}"),
                    }
                }
            }
        }
    }
    refused.sort_unstable();
    refused.dedup();
    assert_eq!(refused.len(), 4, "{refused:?}");
}

#[test]
fn each_length_gives_the_same_wheel() {
    for stations in [3, 4, 6, 60, 1000] {
        let wheel = Wheel::new(stations).unwrap();
        let sizes = |scale| Sizes::new(wheel, scale, &Choices::default()).unwrap();
        let first = sizes(Scale::CrankRadius(50.0));
        assert_eq!(first.crank_radius, 50.0);
        for scale in [Scale::CentreDistance(first.centre_distance), Scale::WheelRadius(first.wheel_radius)] {
            let other = sizes(scale);
            approx::assert_relative_eq!(other.crank_radius, 50.0, max_relative = 1e-14);
            approx::assert_relative_eq!(other.tip_radius, first.tip_radius, max_relative = 1e-13);
            approx::assert_relative_eq!(other.plate_radius, first.plate_radius, max_relative = 1e-13);
        }
        // Pythagoras, at entry.
        let hypotenuse = libm::hypot(first.crank_radius, first.wheel_radius);
        approx::assert_relative_eq!(hypotenuse, first.centre_distance, max_relative = 1e-14);
    }
}

#[test]
fn six_stations_have_the_sizes_of_a_right_triangle() {
    let sizes =
        sized(6, &Choices { play: Some(Play::from_slot(0.0)), bottom_clearance: Some(0.0), ..Choices::default() })
            .unwrap();
    approx::assert_relative_eq!(sizes.crank_radius, 50.0, max_relative = 1e-14);
    approx::assert_relative_eq!(sizes.wheel_radius, 7500.0_f64.sqrt(), max_relative = 1e-14);
    assert_eq!(sizes.pin_diameter, 0.3 * sizes.crank_radius);
    let disc = sizes.locking_disc.unwrap();
    approx::assert_relative_eq!(disc.radius, 50.0 - 1.5 * 15.0, max_relative = 1e-14);
    approx::assert_relative_eq!(sizes.slot_depth, 7500.0_f64.sqrt() - 50.0 + 7.5, max_relative = 1e-14);
}

#[test]
fn what_does_not_fit_is_said() {
    let pin = |pin| Choices { pin_diameter: Some(pin), ..Choices::default() };
    let message = sized(3, &pin(30.0)).unwrap_err().to_string();
    assert!(message.contains("slots run into each other by ") && message.contains("thinner pin"), "{message}");
    // With a pin of 0.4 a no arc through the edges of the opening is right.
    let message = sized(12, &pin(0.4 * 100.0 * libm::sin(std::f64::consts::PI / 12.0))).unwrap_err().to_string();
    assert!(message.contains("run into the wheel's horns"), "{message}");
    assert!(matches!(sized(6, &pin(0.0)), Err(SizesError::Kinematics(KinematicsError::Length { .. }))));
    assert!(matches!(sized(6, &pin(f64::NAN)), Err(SizesError::Kinematics(_))));
    for clearance in [-0.1, f64::INFINITY, f64::NAN] {
        let choices = Choices { bottom_clearance: Some(clearance), ..Choices::default() };
        let message = sized(6, &choices).unwrap_err().to_string();
        assert!(message.starts_with("clearance at the slot's bottom"), "{message}");
    }
    let message = sized(6, &Choices { bottom_clearance: Some(40.0), ..Choices::default() }).unwrap_err().to_string();
    assert!(message.contains("slots run into each other") && message.contains("shallower slots"), "{message}");
    for play in [-0.1, f64::INFINITY, f64::NAN] {
        let choices = Choices { play: Some(Play { locking: play, ..Play::from_slot(0.1) }), ..Choices::default() };
        let message = sized(6, &choices).unwrap_err().to_string();
        assert!(message.starts_with("locking play"), "{message}");
    }
    let limit = sized(6, &Choices::default()).unwrap().wheel_shaft_limit;
    let shaft = |shaft| sized(6, &Choices { wheel_shaft: Some(shaft), ..Choices::default() });
    assert_eq!(shaft(0.99 * limit).unwrap().wheel_shaft, 0.99 * limit);
    assert!(matches!(shaft(limit), Err(SizesError::Shaft { asked, most, .. }) if asked == most));
    let wheel = Wheel::new(6).unwrap();
    for scale in [Scale::CrankRadius(0.0), Scale::CentreDistance(f64::NAN), Scale::WheelRadius(f64::INFINITY)] {
        assert!(Sizes::new(wheel, scale, &Choices::default()).is_err(), "{scale:?}");
    }
}

#[test]
fn a_bore_is_there_only_if_a_shaft_is_given() {
    for (stations, pins) in [(3, 1), (4, 4), (6, 2), (12, 1), (24, 1)] {
        let wheel = Wheel::with_pins(stations, pins).unwrap();
        let of = |choices: Choices| Sizes::new(wheel, Scale::CentreDistance(100.0), &choices).unwrap();
        let none = of(Choices::default());
        assert_eq!([none.wheel_bore(), none.driver_bore(), none.plate_bore()], [0.0; 3]);
        let outline = none.outline();
        assert!(
            [Some(outline.wheel), outline.disc, Some(outline.plate)]
                .into_iter()
                .flatten()
                .all(|of| of.holes.is_empty())
        );

        // The plate has room for a shaft that the disc has none for.
        let thick = 1.5 * none.driver_shaft_limit.max(1.0);
        let plate = of(Choices { plate_shaft: Some(thick), ..Choices::default() });
        assert_eq!([plate.driver_bore(), plate.plate_bore()], [0.0, thick + plate.play.bore]);
        let both = Choices { driver_shaft: Some(thick), ..Choices::default() };
        let message = Sizes::new(wheel, Scale::CentreDistance(100.0), &both).unwrap_err().to_string();
        assert!(message.contains("end in the plate"), "{message}");
        let through = of(Choices { driver_shaft: Some(0.5 * none.driver_shaft_limit), ..Choices::default() });
        assert_eq!(through.plate_shaft, through.driver_shaft);
    }
    let most = sized(6, &Choices::default()).unwrap().plate_shaft_limit;
    let refused = sized(6, &Choices { plate_shaft: Some(most), ..Choices::default() });
    assert!(matches!(refused, Err(SizesError::Shaft { asked, .. }) if asked == most));
}
