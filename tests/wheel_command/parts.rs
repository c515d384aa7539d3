//! Are the sizes of the parts those of the library, whatever length is given?

use crate::{geneva, number, object, pin, refusal, stdout};
use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};

#[test]
fn the_parts_are_those_of_the_library() {
    let wheel = Wheel::with_pins(7, 2).expect("possible");
    let choices = Choices {
        pin_diameter: Some(6.0),
        play: Some(Play::from_slot(0.04)),
        wheel_shaft: Some(9.0),
        driver_shaft: Some(1.5),
        ..Choices::default()
    };
    for (option, scale) in [
        ("--crank-radius", Scale::CrankRadius(45.0)),
        ("--centre-distance", Scale::CentreDistance(45.0)),
        ("--wheel-radius", Scale::WheelRadius(45.0)),
    ] {
        let words = ["wheel", "--stations", "7", "--pins", "2", option, "45", "--pin-diameter", "6", "--play", "0.04"];
        let found = object(&[&words[..], &["--wheel-shaft", "9", "--driver-shaft", "1.5"]].concat());
        let sizes = Sizes::new(wheel, scale, &choices).expect("it fits");
        let least = sizes.clearance().closest_approach();
        let disc = sizes.locking_disc.expect("a dwell");
        let shared = sizes.shared_tolerance().expect("play enough");
        let (tolerance, play) = (sizes.centre_tolerance(), sizes.dwell_play().expect("a dwell"));
        for (key, right) in [
            ("crank_radius_mm", sizes.crank_radius),
            ("centre_distance_mm", sizes.centre_distance),
            ("wheel_radius_mm", sizes.wheel_radius),
            ("pin_diameter_mm", 6.0),
            ("play_mm", 0.04),
            ("bore_play_mm", 0.01),
            ("slot_width_mm", sizes.slot_width),
            ("slot_depth_mm", sizes.slot_depth),
            ("tip_radius_mm", sizes.tip_radius),
            ("horn_thickness_mm", sizes.horn_thickness),
            ("bottom_clearance_mm", 0.05 * 6.0),
            ("slot_end_mm", sizes.centre_distance - sizes.crank_radius - 0.3),
            ("slot_web_mm", sizes.web),
            ("bore_web_mm", sizes.slot_end - sizes.slot_width / 2.0 - (sizes.wheel_shaft + 0.01) / 2.0),
            ("locking_arc_radius_mm", sizes.locking_arc_radius),
            ("locking_radius_mm", disc.radius),
            ("crescent_radius_mm", disc.crescent.radius),
            ("crescent_centre_mm", disc.crescent.centre),
            ("plate_radius_mm", sizes.plate_radius),
            ("wheel_shaft_mm", sizes.wheel_shaft),
            ("wheel_shaft_limit_mm", sizes.wheel_shaft_limit),
            ("wheel_bore_mm", sizes.wheel_shaft + 0.01),
            ("driver_shaft_mm", sizes.driver_shaft),
            ("driver_shaft_limit_mm", sizes.driver_shaft_limit),
            ("driver_bore_mm", sizes.driver_shaft + 0.01),
            ("disc_web_mm", disc.crescent.centre - disc.crescent.radius - (sizes.driver_shaft + 0.01) / 2.0),
            ("crescent_web_mm", 2.0 * (disc.crescent.centre - disc.crescent.radius)),
            ("plate_shaft_mm", 1.5),
            ("plate_shaft_limit_mm", sizes.plate_shaft_limit),
            ("plate_bore_mm", 1.5 + 0.01),
            ("plate_web_mm", sizes.crank_radius - 3.0 - 1.51 / 2.0),
            ("plate_rim_mm", sizes.plate_radius - sizes.crank_radius - 3.0),
            ("centres_nearer_mm", tolerance.nearer),
            ("centres_farther_mm", tolerance.farther),
            ("least_clearance_mm", least.distance),
            ("least_clearance_at_deg", least.crank_angle.to_degrees()),
            ("bottom_gap_mm", 0.3 + 0.02),
            ("all_locking_mm", shared.locking),
            ("all_nearer_mm", shared.nearer),
            ("all_farther_mm", shared.farther),
            ("all_crank_radius_mm", shared.crank),
            ("all_width_mm", shared.width),
            ("all_slot_direction_at_rim_mm", shared.direction * sizes.wheel_radius),
            ("all_slot_end_mm", shared.slot_end),
            ("crank_radius_tolerance_mm", sizes.crank_radius_tolerance().expect("a disc")),
            ("locking_gap_mm", sizes.locking_gap().expect("a disc")),
            ("slot_direction_tolerance_deg", sizes.slot_direction_tolerance().expect("a disc").to_degrees()),
            ("dwell_backlash_deg", play.middle.to_degrees()),
            ("dwell_backlash_held_fraction", play.held),
            ("greatest_dwell_backlash_deg", play.greatest.to_degrees()),
            ("greatest_dwell_backlash_until_entry_deg", play.until_entry.to_degrees()),
        ] {
            approx::assert_relative_eq!(number(&found, key), right, max_relative = 1e-14);
        }
    }
}

#[test]
fn the_length_that_was_given_comes_back() {
    for (option, key) in [
        ("--crank-radius", "crank_radius_mm"),
        ("--centre-distance", "centre_distance_mm"),
        ("--wheel-radius", "wheel_radius_mm"),
    ] {
        for kind in ["external", "internal"] {
            let found = object(&["wheel", "--stations", "9", option, "33.3", "--type", kind]);
            approx::assert_relative_eq!(number(&found, key), 33.3, max_relative = 1e-15);
        }
    }
}

#[test]
fn what_does_not_fit_is_refused_with_how_much_and_what_to_change() {
    for (options, said) in [
        (&["--pin-diameter", "60"][..], "run into each other by 13.1 mm; give --pin-diameter up to 21.91"),
        (&["--play", "90"], "--play 90"),
        (&["--bottom-clearance", "45"], "--bottom-clearance 45"),
        (&["--horn", "40"], "give --horn from 3 to 26.38"),
        (&["--wheel-shaft", "80"], "it is too thick for the parts around it; give --wheel-shaft up to 69.97"),
        (
            &["--driver-shaft", "30"],
            "give --driver-shaft up to 14.96 for sound walls and locking arcs, or let the shaft end in the plate",
        ),
        (&["--locking-arc-radius", "90"], "--locking-arc-radius 90: a locking arc runs into the slots"),
        (&["--locking-play", "60"], "give --locking-play up to"),
        (&["--pin-diameter", "0.01", "--play", "200"], "mm"),
    ] {
        let wheel = [&["wheel", "--stations", "6", "--crank-radius", "50"], options].concat();
        let refused = refusal(geneva(&wheel));
        assert!(refused.starts_with("error: ") && refused.contains(said), "{options:?}: {refused}");
    }
    let refused = refusal(geneva(&["wheel", "--stations", "6", "--crank-radius", "50", "--bottom-clearance", "-1"]));
    assert!(refused.contains("'-1' for '--bottom-clearance") && refused.contains("zero or more"), "{refused}");
    pin("wheel-that-does-not-fit", &["wheel", "--stations", "6", "--crank-radius", "50", "--pin-diameter", "60"]);
}

#[test]
fn the_knock_is_that_of_the_library_at_the_drivers_speed() {
    let found = object(&["wheel", "--stations", "6", "--crank-radius", "25", "--rpm", "60"]);
    let wheel = Wheel::new(6).expect("possible");
    let sizes = Sizes::new(wheel, Scale::CrankRadius(25.0), &Choices::default()).expect("it fits");
    let (knock, pin) = (sizes.knock().expect("met"), 25.0 * 2.0 * std::f64::consts::PI);
    for (key, right) in [
        ("knock_mm_s", knock.centred),
        ("knock_within_backlash_mm_s", knock.within),
        ("greatest_knock_mm_s", knock.drifted),
    ] {
        approx::assert_relative_eq!(number(&found, key), right * pin, max_relative = 1e-12);
    }
    assert!(knock.centred < knock.within && 4.0 * knock.within < knock.drifted);
}

#[test]
fn sizes_that_had_better_not_be_made_are_made_with_a_warning() {
    let wheel = ["wheel", "--stations", "6", "--crank-radius", "25"];
    let warnings = |options: &[&str]| {
        let all = [&wheel[..], options].concat();
        let found = object(&all);
        let said: Vec<_> = found["warnings"].as_array().expect("a list").clone();
        assert_eq!(stdout(&all, 0).contains("Warnings"), !said.is_empty(), "{options:?}");
        said
    };
    assert!(warnings(&[]).is_empty());
    for (options, said) in [
        (&["--play", "0"][..], "without play"),
        (&["--pin-diameter", "1", "--play", "0.2"], "hits its rim"),
        (&["--horn", "0.5"], "the horn is only 0.500 mm thick"),
        (&["--driver-shaft", "10.4"], "between crescent and bore is only 0.042 mm thick"),
    ] {
        let found = warnings(options);
        assert!(
            found.iter().any(|text| text.as_str().is_some_and(|text| text.contains(said))),
            "{options:?}: {found:?}"
        );
    }
}

#[test]
fn a_shaft_that_leaves_the_disc_a_thin_wall_is_noticed() {
    let wheel = ["wheel", "--stations", "8", "--centre-distance", "120", "--pin-diameter", "14", "--play", "0.06"];
    for (shaft, thickness) in [("13.5", 0.108), ("12", 0.858)] {
        let found = object(&[&wheel[..], &["--driver-shaft", shaft]].concat());
        approx::assert_abs_diff_eq!(number(&found, "disc_web_mm"), thickness, epsilon = 5e-4);
        let said = format!("the locking disc between crescent and bore is only {thickness:.3} mm thick");
        let warnings = found["warnings"].as_array().expect("a list");
        assert!(warnings.iter().any(|text| text.as_str().is_some_and(|text| text.contains(&said))), "{warnings:?}");
    }
}

#[test]
fn a_play_that_the_program_chose_is_compared_with_a_fit() {
    let wheel = ["wheel", "--stations", "8", "--centre-distance", "120", "--pin-diameter", "14"];
    let said = "the program's play of 0.120 mm is more than a fit H8/e8 has for this pin, 0.032 to 0.086 mm";
    for (options, is_loose) in [(&[][..], true), (&["--play", "0.12"], false), (&["--play", "0.06"], false)] {
        let found = object(&[&wheel[..], options].concat());
        let warnings = found["warnings"].as_array().expect("a list");
        let has = warnings.iter().any(|text| text.as_str().is_some_and(|text| text.contains(said)));
        assert_eq!(has, is_loose, "{options:?}: {warnings:?}");
    }
}

/// What was nothing but the step of the search is found, or missing.
#[test]
fn no_tolerance_is_zero_where_there_is_play() {
    for (options, is_found) in [
        (&["--stations", "250"][..], true),
        (&["--stations", "360"], true),
        (&["--stations", "1000"], true),
        (&["--stations", "6", "--pin-diameter", "0.4", "--play", "0.0005"], true),
        (&["--stations", "6", "--pin-diameter", "0.4", "--play", "0.000001"], false),
    ] {
        let found = object(&[&["wheel", "--crank-radius", "50"], options].concat());
        for key in ["centres_nearer_mm", "centres_farther_mm", "least_clearance_mm"] {
            assert!(found[key].as_f64().is_none_or(|length| length > 0.0), "{options:?} {key}: {}", found[key]);
            assert!(!is_found || found[key].is_number(), "{options:?} {key}: {}", found[key]);
        }
        let limits = ["all_locking_mm", "all_width_mm"].map(|key| found[key].as_f64());
        assert!(limits.iter().flatten().all(|limit| *limit > 0.0), "{options:?}: {limits:?}");
        assert_eq!(limits[0].is_some(), is_found, "{options:?}");
        let play = number(&found, "bore_play_mm");
        assert!(!is_found || number(&found, "centres_nearer_mm") > play, "{options:?}");
    }
}
