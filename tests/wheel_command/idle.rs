//! Is every option that would change nothing refused, and does the message say what would make it count?

use crate::{answered, refused, stdout};
use geneva_ask::wheel::{ActsOn, Argument, ArgumentSlot, arguments};
use geneva_kinematics::wheel::as_built::Process;

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

/// Values of an option, none of which is what holds if it is not given.
fn values(argument: &Argument) -> Vec<&'static str> {
    match argument.place {
        ArgumentSlot::Kind(_) => vec!["internal", "spherical"],
        // What holds if nothing is said depends on the process where a page has an entry for that.
        ArgumentSlot::Choice(choice) => choice.names[1..].to_vec(),
        // One of each is enough, and each process asks for a thousand assemblies.
        ArgumentSlot::Process(_) => vec![Process::Mill.name()],
        ArgumentSlot::Material(_) => vec!["acetal"],
        ArgumentSlot::Stations(_) => vec!["7"],
        ArgumentSlot::Pins(_) | ArgumentSlot::Count(_) => vec!["2", "4"],
        _ => vec!["0.3"],
    }
}

/// Every option with each of its values changes what is said or made, or is refused in words that name it, whatever else is given.
#[test]
fn no_option_of_the_table_is_taken_without_an_effect() {
    let (mut refused, mut silent) = (0, Vec::new());
    for more in [
        &[][..],
        &["--crank-radius", "50"],
        &["--type", "internal"],
        &["--type", "internal", "--crank-radius", "50", "--thickness", "6"],
        &["--type", "spherical", "--crank-radius", "50"],
    ] {
        let wheel = [&["wheel", "--stations", "6"][..], more].concat();
        let in_format =
            |format: &'static str, option: &[&str]| answered(&[&wheel[..], option, &["--format", format]].concat());
        let plain = in_format("json", &[]).stdout;
        for argument in arguments().filter(|argument| !more.contains(&format!("--{}", argument.name).as_str())) {
            let option = format!("--{}", argument.name);
            for value in values(argument).into_iter().filter(|_| argument.name != "stations") {
                let given = [option.as_str(), value];
                let told = in_format("json", &given);
                if told.code != 0 {
                    refused += 1;
                    continue;
                }
                // Mountings are in the files, and materials on the drawings.
                let is_filed = argument.acts_on.contains(&ActsOn::Files)
                    && ["step", "parts"]
                        .into_iter()
                        .any(|format| in_format(format, &given).stdout != in_format(format, &[]).stdout);
                let is_drawn = matches!(argument.place, ArgumentSlot::Material(_));
                if told.stdout == plain && !is_filed && !is_drawn {
                    silent.push(format!("{} {option} {value}", more.join(" ")));
                }
            }
        }
    }
    assert!(silent.is_empty(), "passed over in silence: {silent:#?}");
    assert!(refused > 200, "only {refused} are refused");
}
