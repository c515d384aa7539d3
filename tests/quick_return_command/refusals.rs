//! What cannot be computed is refused with exit code 2 and a message: what was typed, what is possible and what to give.

use super::{SLOW, command, object};
use crate::{answered, assert_is_plain, number, pin, stdout};

/// The refusal of these options, which is the same in every format.
#[track_caller]
fn refused(options: &[&str]) -> String {
    let said = ["text", "json", "svg"]
        .map(|format| crate::refused(&[&["quick-return", "--format", format], options].concat()));
    assert!(said.iter().all(|other| *other == said[0]), "{said:?}");
    assert!(said[0].starts_with("error: ") && !said[0].contains("panicked"), "{options:?}: {}", said[0]);
    let [said, ..] = said;
    said
}

#[test]
fn impossible_assemblies_say_which_are_possible() {
    for ([ground, crank, angle, degrees], more, value, possible) in [
        (["0.3", "0.1", "--lever-angle", "25"], &[][..], "--lever-angle 25", &["−19.4", "° and 19.4", "--crank-angle"]),
        (["0.3", "0.1", "--lever-angle", "-25"], &[], "--lever-angle -25", &["−19.4", "° and 19.4", "--crank-angle"]),
        (
            ["0.3", "0.1", "--lever-angle", "180"],
            &["--branch", "near"],
            "--lever-angle 180",
            &["−19.4", "19.4", "--crank-angle"],
        ),
        (
            ["0.3", "0.3", "--lever-angle", "90"],
            &[],
            "--lever-angle 90",
            &["between, but not to, −90° and 90°", "all but 180°", "--crank-angle"],
        ),
        (
            ["0.3", "0.3", "--crank-angle", "180"],
            &[],
            "--crank-angle 180",
            &["--ground 0.3", "--crank 0.3", "all but 180°"],
        ),
        (
            ["0.3", "0.3", "--crank-angle", "-540"],
            &[],
            "--crank-angle -540",
            &["--ground 0.3", "--crank 0.3", "all but 180°"],
        ),
        (
            ["0.3", "0.3", "--crank-angle", "179.99"],
            &[],
            "--crank-angle 179.99",
            &["crank radii", "an angle", "at least"],
        ),
        (
            ["0.3", "0.3", "--lever-angle", "89.99"],
            &[],
            "--lever-angle 89.99",
            &["crank radii", "an angle", "at least"],
        ),
        (
            ["0.1", "0.3", "--lever-angle", "10"],
            &["--branch", "near"],
            "--branch near",
            &["--crank 0.3", "--ground 0.1", "all lever angles are"],
        ),
        (
            ["0.3", "0.3", "--lever-angle", "10"],
            &["--branch", "near"],
            "--branch near",
            &["--branch far", "−90°", "90°"],
        ),
    ] {
        let said = refused(&[&["--ground", ground, "--crank", crank, angle, degrees, "--rpm", "60"], more].concat());
        assert!(said.contains(value) && said.contains("give "), "{said}");
        assert!(possible.iter().all(|words| said.contains(words)), "{possible:?}: {said}");
    }
    pin("quick-return-beyond-the-swing", &command(["0.3", "0.1", "--lever-angle", "25", "60"], &[]));
    pin("quick-return-on-the-pivot", &command(["0.3", "0.3", "--crank-angle", "180", "60"], &[]));
    pin(
        "quick-return-without-a-near-branch",
        &command(["0.1", "0.3", "--lever-angle", "10", "60"], &["--branch", "near"]),
    );
}

#[test]
fn the_limit_that_a_refusal_names_is_possible() {
    for crank in ["0.01", "0.07", "0.1", "0.11", "0.17", "0.19", "0.23", "0.26", "0.29"] {
        let said = refused(&["--ground", "0.3", "--crank", crank, "--lever-angle", "90", "--rpm", "60"]);
        let limit = said.split_once("° and ").and_then(|(_, rest)| rest.split_once('°')).expect("a limit").0;
        for (sign, side) in [("", 1.0), ("-", -1.0), ("−", -1.0)] {
            let typed = format!("{sign}{limit}");
            let found = object(["0.3", crank, "--lever-angle", &typed, "60"], &[]);
            // The limit is rounded towards zero, so the lever is a little short of the end of its swing.
            assert!((number(&found, "angle_at_pin_deg") - 90.0).abs() < 2.0, "{crank}: {typed}");
            assert_eq!(number(&found, "crank_angle_deg").signum(), side, "{crank}: {typed}");
        }
    }
}

#[test]
fn values_that_are_no_lengths_angles_or_speeds_are_named() {
    let usual = |option: &str| match option {
        "--ground" => "0.3",
        "--crank" => "0.1",
        "--rpm" => "60",
        _ => "7",
    };
    for (option, value, said_of) in [
        ("--ground", "0", "above zero"),
        ("--ground", "-0", "above zero"),
        ("--ground", "-0.3", "above zero"),
        ("--ground", "nan", "above zero"),
        ("--ground", "long", "above zero"),
        ("--ground", "1e-310", "between 1e-30 and 1e30"),
        ("--ground", "5e-324", "between 1e-30 and 1e30"),
        ("--ground", "1e31", "between 1e-30 and 1e30"),
        ("--crank", "0", "above zero"),
        ("--crank", "inf", "between 1e-30 and 1e30"),
        ("--crank", "1e-31", "between 1e-30 and 1e30"),
        ("--crank", "0,1", "a decimal point, not a comma"),
        ("--crank-angle", "nan", "in degrees"),
        ("--crank-angle", "inf", "in degrees"),
        ("--crank-angle", "up", "degrees"),
        ("--lever-angle", "nan", "in degrees"),
        ("--lever-angle", "7°", "degrees"),
        ("--rpm", "0", "the crank must turn"),
        ("--rpm", "-0", "the crank must turn"),
        ("--rpm", "nan", "the crank must turn"),
        ("--rpm", "inf", "between 1e-30 and 1e30"),
        ("--rpm", "1e200", "between 1e-30 and 1e30"),
        ("--rpm", "-1e-200", "between 1e-30 and 1e30"),
        ("--rpm", "-inf", "between 1e-30 and 1e30"),
        ("--crank-angle", "--lever", "degrees"),
        ("--rpm", "fast", "turns per minute"),
    ] {
        let angle = if option == "--lever-angle" { option } else { "--crank-angle" };
        let options = ["--ground", "--crank", angle, "--rpm"]
            .map(|name| [name, if name == option { value } else { usual(name) }])
            .concat();
        let said = refused(&options);
        assert!(said.contains(option) && said.contains("give ") && said.contains(said_of), "{option} {value}: {said}");
        assert!(said.to_lowercase().contains(value), "{option} {value}: {said}");
    }
}

#[test]
fn one_angle_is_wanted_and_a_branch_only_of_a_lever() {
    let both = ["--ground", "0.3", "--crank", "0.1", "--rpm", "60", "--crank-angle", "75", "--lever-angle", "10"];
    for (options, words) in [
        (&both[..], &["--crank-angle", "--lever-angle", "cannot be used"]),
        (&both[..6], &["--crank-angle", "--lever-angle", "required"]),
        (&[&both[..8], &["--branch", "near"]].concat(), &["--crank-angle", "--branch", "cannot be used"]),
        (&[&both[..8], &["--branch", "far"]].concat(), &["--crank-angle", "--branch", "cannot be used"]),
        (&[&both[..6], &["--branch", "near"]].concat(), &["--crank-angle", "--lever-angle", "required"]),
        (&both[2..8], &["--ground", "<LENGTH>", "required"]),
    ] {
        let said = refused(options);
        assert!(words.iter().all(|word| said.contains(word)), "{words:?}: {said}");
    }
    pin("quick-return-without-an-angle", &[&["quick-return"], &both[..6]].concat());
    pin("quick-return-branch-of-a-crank", &command(SLOW, &["--branch", "near"]));
}

#[test]
fn a_figure_is_only_of_a_drawing_and_csv_of_a_series() {
    pin("quick-return-is-no-series", &command(SLOW, &["--format", "csv"]));
    for format in ["text", "json"] {
        let said = crate::refused(&command(SLOW, &["--format", format, "--figure", "velocity"]));
        assert!(said.contains("--figure velocity") && said.contains("give --format svg"), "{said}");
    }
    let said = crate::refused(&command(SLOW, &["--format", "svg", "--figure", "velocty"]));
    assert!(said.contains("'velocity'"), "{said}");
}

#[test]
fn no_number_makes_it_panic_or_write_what_is_no_number() {
    let numbers = ["1e-30", "0.1", "0.3", "0.30000000000000004", "1", "90", "180", "180.00000000000003", "1e30"];
    for ground in numbers {
        for crank in numbers {
            for (angle, degrees) in [("--crank-angle", "180"), ("--crank-angle", "1e300"), ("--lever-angle", "90")] {
                for rpm in ["1e-30", "-1e30"] {
                    let answer = answered(&command([ground, crank, angle, degrees, rpm], &["--format", "json"]));
                    let text = &answer.stdout;
                    match answer.code {
                        0 => {
                            assert!(!text.contains("\"x\": null") && !text.contains("\"magnitude\": null"), "{text}")
                        }
                        2 => assert!(answer.stderr.starts_with("error: ") && text.is_empty(), "{answer:?}"),
                        _ => panic!("{ground} {crank} {angle} {degrees} {rpm}: {answer:?}"),
                    }
                }
            }
        }
    }
}

#[test]
fn the_sheet_is_no_wider_than_a_line_and_plain_in_a_pipe() {
    for instant in super::INSTANTS.into_iter().chain([
        ["0.30000000000000004", "179.99999999999", "--crank-angle", "-33.3", "180.00000000000003"],
        ["1e30", "1e-30", "--crank-angle", "20", "-1e30"],
    ]) {
        assert_is_plain(&stdout(&command(instant, &[]), 0));
    }
}

#[test]
fn a_pin_is_too_near_below_a_thousandth_of_the_crank() {
    // It is two crank radii times the cosine of half the crank angle from the lever's pivot.
    let at = |degrees| ["--ground", "0.3", "--crank", "0.3", "--rpm", "60", "--crank-angle", degrees];
    assert!(refused(&at("179.943")).contains("at least 0.001 crank radii away"));
    stdout(&[&["quick-return"][..], &at("179.942")].concat(), 0);
}
