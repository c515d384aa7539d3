//! What cannot be computed is refused with exit code 2 and a message: what was typed, why it fails, and what to give.

use super::{Design, FOUR, command, object};
use crate::{answered, pin};

/// The refusal of these options in these formats, in all of which it is the same.
#[track_caller]
fn refused(design: Design, more: &[&str], formats: &[&str]) -> String {
    let said: Vec<_> = formats
        .iter()
        .map(|format| crate::refused(&command(design, &[&["--format", format], more].concat())))
        .collect();
    assert!(said.iter().all(|other| *other == said[0]), "{said:?}");
    assert!(said[0].starts_with("error: ") && !said[0].contains("panicked"), "{design:?} {more:?}: {}", said[0]);
    assert!(said[0].contains("give "), "{design:?} {more:?}: {}", said[0]);
    said[0].clone()
}

const ALL: [&str; 4] = ["text", "json", "csv", "svg"];

#[test]
fn values_that_no_escapement_has_are_named() {
    let options = ["--slots", "--friction", "--torque", "--driver-inertia", "--follower-inertia"];
    for (at, value, said_of) in [
        (0, "5", "5 slots"),
        (0, "0", "3, 4 or 6"),
        (0, "2", "3, 4 or 6"),
        (0, "1000", "3, 4 or 6"),
        (0, "-4", "3, 4 or 6"),
        (0, "4.0", "3, 4 or 6"),
        (0, "four", "3, 4 or 6"),
        (1, "-0.3", "-0.3 is not zero or more"),
        (1, "nan", "nan is not zero or more"),
        (1, "inf", "between 1e-30 and 1e30"),
        (1, "-inf", "zero or more"),
        (1, "0,3", "a decimal point"),
        (2, "0", "above zero"),
        (2, "-2", "above zero"),
        (2, "nan", "above zero"),
        (2, "inf", "between 1e-30 and 1e30"),
        (2, "1e200", "between 1e-30 and 1e30"),
        (2, "1e-300", "between 1e-30 and 1e30"),
        (2, "strong", "above zero"),
        (3, "0", "above zero"),
        (3, "-1", "above zero"),
        (3, "nan", "above zero"),
        (3, "5e-324", "between 1e-30 and 1e30"),
        (3, "", "above zero"),
        (4, "0", "above zero"),
        (4, "inf", "between 1e-30 and 1e30"),
        (4, "1e31", "between 1e-30 and 1e30"),
        (4, "--torque", "above zero"),
    ] {
        let mut design = FOUR;
        design[at] = value;
        let said = refused(design, &[], &ALL);
        let option = if at == 0 { "slots" } else { options[at] };
        assert!(said.contains(option) && said.contains(said_of), "{option} {value}: {said}");
    }
    pin("escapement-of-five", &command(["5", "0.3", "2", "4e-6", "6e-5"], &[]));
}

#[test]
fn too_much_friction_names_the_limit_and_the_angle() {
    for slots in ["3", "4", "6"] {
        let said = refused([slots, "3", "2", "4e-6", "6e-5"], &[], &ALL);
        let limit = said.split_once("from ").and_then(|(_, rest)| rest.split_once(' ')).expect("a limit").0;
        let limit: f64 = limit.parse().expect("a number");
        assert!(said.contains("--friction 3 is too high") && said.contains("° to either side"), "{said}");
        // The limit itself is refused, and a little less is not.
        refused([slots, &limit.to_string(), "2", "4e-6", "6e-5"], &[], &ALL);
        let less = (0.998 * limit).to_string();
        let found = object([slots, &less, "2", "4e-6", "6e-5"], &[])["critical_friction"].as_f64().expect("a number");
        // It is told in as many digits as a reader needs.
        assert!(found <= limit && limit - found < 2e-3 * limit && said.contains(&format!("from {limit} on")), "{said}");
        let limit = found;
        // Within rounding of it the motion is too sharp.
        let nearly = (limit * (1.0 - 1e-15)).to_string();
        let said = refused([slots, &nearly, "2", "4e-6", "6e-5"], &[], &ALL);
        assert!(said.contains("too quickly") && said.contains("--driver-inertia 4e-6"), "{said}");
    }
    pin("escapement-that-jams", &command(["4", "3", "2", "4e-6", "6e-5"], &[]));
}

#[test]
fn without_friction_there_is_no_terminal_speed() {
    for friction in ["0", "-0", "0.0"] {
        let said = refused(["4", friction, "2", "4e-6", "6e-5"], &[], &["text", "json"]);
        assert!(said.contains("--friction") && said.contains("no terminal speed") && said.contains("csv"), "{said}");
        let figure = ["--format", "svg", "--figure", "normal-force"];
        assert_eq!(crate::refused(&command(["4", friction, "2", "4e-6", "6e-5"], &figure)), said);
    }
    pin("escapement-without-friction", &command(["4", "0", "2", "4e-6", "6e-5"], &[]));
}

#[test]
fn a_modulus_beyond_its_range_is_told_the_range() {
    for (slots, limit) in [("3", "210"), ("4", "225"), ("6", "240")] {
        for reset_angle in ["0", "-90", limit, "360", "nan", "inf", "1e300"] {
            let said = refused([slots, "0.1", "2", "1", "5"], &["--reset-deg", reset_angle], &ALL);
            assert!(said.contains("--reset-deg") && said.contains(&format!("less than {limit}°")), "{said}");
        }
        let said = refused([slots, "0.1", "2", "1", "5"], &["--reset-deg", "right"], &ALL);
        assert!(said.contains("degrees"), "{said}");
    }
    let said = refused(FOUR, &["--reset-deg", "1e-300"], &["text", "json"]);
    assert!(said.contains("--reset-deg 1e-300 is too small"), "{said}");
    let said = crate::refused(&command(FOUR, &["--reset-deg", "80", "--format", "svg", "--figure", "normal-force"]));
    assert!(said.contains("--reset-deg 80") && said.contains("leave --reset-deg out"), "{said}");
}

#[test]
fn a_run_that_is_too_long_or_no_run_is_refused() {
    for (more, words) in [
        (&["--interval", "0"][..], ["'0'", "above zero"]),
        (&["--interval", "-1"], ["'-1'", "above zero"]),
        (&["--interval", "nan"], ["nan is not", "above zero"]),
        (&["--interval", "1e-31"], ["1e-31", "between 1e-30 and 1e30"]),
        (&["--interval", "often"], ["--interval", "above zero"]),
        (&["--duration", "0"], ["'0'", "above zero"]),
        (&["--duration", "inf"], ["inf", "between 1e-30 and 1e30"]),
        (&["--interval", "1e-9", "--duration", "1"], ["more than 1000000 printed lines", "--interval 1e-9"]),
        (&["--interval", "1e-20"], ["more than 1000000 printed lines", "longer interval"]),
        (&["--interval", "2", "--duration", "1"], ["--interval 2", "longer than the run"]),
        (&["--interval", "2"], ["--interval 2", "longer than the run"]),
    ] {
        let said = refused(FOUR, more, &["csv"]);
        assert!(words.iter().all(|word| said.contains(word)), "{words:?}: {said}");
    }
    for option in ["--duration", "--interval"] {
        let said = refused(FOUR, &[option, "0.1"], &["text", "json", "svg"]);
        assert!(said.contains(&format!("{option} 0.1")) && said.contains("--format csv"), "{said}");
    }
    let said = refused(FOUR, &["--figure", "mechanism"], &["text", "json", "csv"]);
    assert!(said.contains("--figure mechanism") && said.contains("--format svg"), "{said}");
}

#[test]
fn no_number_makes_it_panic_or_write_what_is_no_number() {
    for slots in ["3", "6"] {
        for friction in ["0", "1e-300", "1e-9", "0.1", "1e9", "1e30"] {
            for torque in ["1e-30", "1e30"] {
                for driver in ["1e-30", "1", "1e30"] {
                    for (follower, more) in
                        [("1e-30", &[][..]), ("1", &["--reset-deg", "1e-6"]), ("1e30", &["--reset-deg", "200"])]
                    {
                        let more = [more, &["--format", "json"]].concat();
                        let answer = answered(&command([slots, friction, torque, driver, follower], &more));
                        let text = &answer.stdout;
                        match answer.code {
                            0 => assert!(!text.contains("speed\": null") && !text.contains("period\": null")),
                            2 => assert!(answer.stderr.starts_with("error: ") && text.is_empty(), "{answer:?}"),
                            _ => panic!("{slots} {friction} {torque} {driver} {follower}: {answer:?}"),
                        }
                    }
                }
            }
        }
    }
}
