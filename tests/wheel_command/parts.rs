//! Are the sizes of the parts those of the library, whatever length is given?

use crate::{geneva, number, object, pin, refusal};
use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};

#[test]
fn the_parts_are_those_of_the_library() {
    let wheel = Wheel::with_pins(7, 2).expect("possible");
    let choices = Choices { pin_diameter: Some(6.0), play: Some(Play::of(0.04)), ..Choices::default() };
    for (option, scale) in [
        ("--crank-radius", Scale::CrankRadius(45.0)),
        ("--centre-distance", Scale::CentreDistance(45.0)),
        ("--wheel-radius", Scale::WheelRadius(45.0)),
    ] {
        let found =
            object(&["wheel", "--stations", "7", "--pins", "2", option, "45", "--pin-diameter", "6", "--play", "0.04"]);
        let sizes = Sizes::new(wheel, scale, &choices).expect("it fits");
        let least = sizes.clearance().least();
        let disc = sizes.locking_disc.expect("a dwell");
        let tolerance = sizes.centre_tolerance();
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
            ("slot_end_mm", sizes.centre_distance - sizes.crank_radius),
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
            ("centres_nearer_mm", tolerance.nearer),
            ("centres_farther_mm", tolerance.farther),
            ("least_clearance_mm", least.distance),
            ("least_clearance_at_deg", least.crank_angle.to_degrees()),
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
        (&["--pin-diameter", "60"][..], "thinner pin or less play (--pin-diameter 60, --play MM)"),
        (&["--play", "90"], "--play 90"),
        (&["--horn", "40"], "a thinner pin or a thinner horn (--pin-diameter MM, --horn 40)"),
        (&["--wheel-shaft", "80"], "must be less than 69.9750 mm; take a thinner shaft (--wheel-shaft 80)"),
        (&["--driver-shaft", "30"], "(--driver-shaft 30)"),
        (&["--pin-diameter", "0.01", "--play", "200"], "mm"),
    ] {
        let wheel = [&["wheel", "--stations", "6", "--crank-radius", "50"], options].concat();
        let refused = refusal(geneva(&wheel));
        assert!(refused.starts_with("error: ") && refused.contains(said), "{options:?}: {refused}");
    }
    pin("wheel-that-does-not-fit", &["wheel", "--stations", "6", "--crank-radius", "50", "--pin-diameter", "60"]);
}
