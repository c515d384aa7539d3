//! Is every option that would change nothing refused, and does the message say what would make it count?

use crate::{refused, stdout};

const SIZE: [&str; 2] = ["--crank-radius", "50"];

#[test]
fn no_option_is_passed_over_in_silence() {
    let loads = ["--rpm", "60", "--inertia", "0.1"];
    let materials = ["--pin-material", "steel", "--wheel-material", "acetal"];
    for (options, option, add) in [
        (&["--pin-diameter", "8"][..], "--pin-diameter 8", "--crank-radius MM"),
        (&["--play", "0.1"], "--play 0.1", "--crank-radius MM"),
        (&["--horn", "4"], "--horn 4", "--crank-radius MM"),
        (&["--bottom-clearance", "4"], "--bottom-clearance 4", "--crank-radius MM"),
        (&["--wheel-shaft", "4"], "--wheel-shaft 4", "--crank-radius MM"),
        (&["--driver-shaft", "4"], "--driver-shaft 4", "--crank-radius MM"),
        (&["--type", "internal", "--horn", "8"], "--horn 8", "--crank-radius MM"),
        (&["--type", "spherical", "--wheel-shaft", "8", "--crank-radius", "50"], "--wheel-shaft 8", "--type external"),
        (&["--type", "internal", "--driver-shaft", "8", "--crank-radius", "50"], "--driver-shaft 8", "--plate-shaft 8"),
        (&["--thickness", "5", "--density", "7850"], "--thickness 5", "--crank-radius MM"),
        (&["--inertia", "0.1"], "--inertia 0.1", "--rpm R"),
        (&["--friction-torque", "2", "--inertia", "0.1"], "--rpm R", "without a speed"),
        (&["--friction-torque", "2", "--rpm", "60"], "--friction-torque 2", "--inertia KGM2"),
        (&["--type", "internal", "--arm-torque", "8", "--crank-radius", "50"], "--arm-torque 8", "--type external"),
        (&["--type", "internal", "--density", "800", "--crank-radius", "50"], "--density 800", "--thickness MM"),
        (&["--type", "spherical", "--play", "8", "--crank-radius", "50"], "--play 8", "--type external"),
        (&[&materials[..], &loads].concat(), "--wheel-material acetal", "--crank-radius MM"),
        (&[&materials[..], &["--type", "internal"]].concat(), "--wheel-material acetal", "--crank-radius MM"),
        (&["--table-mass", "2"], "--table-mass 2", "--table-diameter MM"),
        (&["--table-diameter", "200"], "--table-diameter 200", "--table-mass KG"),
        (&["--type", "internal", "--crank-radius", "50", "--format", "svg"], "--crank-radius 50", "not to scale"),
        (&["--type", "spherical", "--centre-distance", "50"], "--centre-distance 50", "--wheel-radius"),
        (&["--format", "fields", "--at", "60"], "--at 60", "--format csv"),
        (&["--at-wheel", "31"], "--at-wheel 31", "from −30° to 30°"),
    ] {
        let said = refused(&[&["wheel", "--stations", "6"], options].concat());
        assert!(said.starts_with("error: ") && said.contains(option) && said.contains(add), "{options:?}: {said}");
    }
}

#[test]
fn of_two_that_contradict_each_other_both_are_named() {
    for (options, other) in [
        (&["--crank-radius", "50", "--centre-distance", "90"][..], "--centre-distance"),
        (&["--wheel-radius", "50", "--centre-distance", "90"], "--wheel-radius"),
        (&["--rpm", "60", "--rad-s", "6"], "--rad-s"),
        (&["--rpm", "60", "--index-time", "1"], "--index-time"),
        (&["--inertia", "1", "--total-inertia", "2"], "--total-inertia"),
        (&["--inertia", "1", "--table-mass", "2", "--table-diameter", "300"], "--table-mass"),
        (&["--horn", "5", "--locking-arc-radius", "12", "--crank-radius", "50"], "--locking-arc-radius"),
    ] {
        let said = refused(&[&["wheel", "--stations", "6"], options].concat());
        assert!(said.contains(options[0]) || said.contains(other), "{options:?}: {said}");
    }
}

#[test]
fn beside_wanted_times_only_stations_kind_and_format_count() {
    let times = ["wheel", "--index-time", "1", "--dwell-time", "2"];
    for (option, value) in [
        ("--pins", "1"),
        ("--rpm", "60"),
        ("--crank-radius", "50"),
        ("--play", "0.1"),
        ("--horn", "3"),
        ("--wheel-shaft", "3"),
        ("--inertia", "1"),
        ("--friction-torque", "1"),
        ("--density", "1000"),
        ("--at", "10"),
        ("--format", "svg"),
        ("--format", "fields"),
    ] {
        for stations in [&[][..], &["--stations", "6"]] {
            let said = refused(&[&times[..], stations, &[option, value]].concat());
            assert!(said.contains(&format!("{option} {value}")) && said.contains("propose"), "{option}: {said}");
        }
    }
}

#[test]
fn beside_wanted_times_nothing_is_pressed() {
    let said = refused(&[
        "wheel",
        "--index-time",
        "1",
        "--dwell-time",
        "2",
        "--pin-material",
        "steel",
        "--wheel-material",
        "steel",
    ]);
    assert!(said.contains("--wheel-material steel") && said.contains("propose"), "{said}");
}

/// The other side of it: what is taken changes what is said.
#[test]
fn every_option_that_is_taken_changes_the_answer() {
    let sized = [&["--stations", "6", "--rpm", "60", "--inertia", "0.1"][..], &SIZE].concat();
    let plain = stdout(&[&["wheel", "--format", "json"], &sized[..]].concat(), 0);
    for option in [
        ["--pin-diameter", "8"],
        ["--play", "0.2"],
        ["--horn", "9"],
        ["--bottom-clearance", "0.1"],
        ["--wheel-shaft", "9"],
        ["--driver-shaft", "9"],
        ["--friction-torque", "1"],
        ["--at", "10"],
        ["--pins", "2"],
    ] {
        let other = stdout(&[&["wheel", "--format", "json"], &sized[..], &option].concat(), 0);
        assert_ne!(plain, other, "{option:?}");
    }
    let one = ["wheel", "--stations", "6", "--format", "json", "--crank-radius", "50"];
    let plate = stdout(&[&one[..], &["--thickness", "5", "--density", "7850"]].concat(), 0);
    let thick = stdout(&[&one[..], &["--thickness", "10", "--density", "7850"]].concat(), 0);
    assert_ne!(plate, thick);
}
