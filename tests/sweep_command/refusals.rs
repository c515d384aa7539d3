//! What cannot be swept is refused with exit code 2 and a message: what was typed, why it fails, and what to give.

use crate::{geneva, pin, refusal};

/// The refusal of a sweep in which one option has this value.
#[track_caller]
fn refused(option: &str, value: &str) -> String {
    let mut options = vec!["sweep"];
    for (name, usual) in [("--slots", "4"), ("--friction", "0.3"), ("--inertia-ratio", "0.5"), ("--output", "-")] {
        options.extend([name, if name == option { value } else { usual }]);
    }
    if !options.contains(&option) {
        options.extend([option, value]);
    }
    let said = crate::refused(&options);
    assert!(said.starts_with("error: ") && !said.contains("panicked"), "{option} {value}: {said}");
    assert!(said.contains("give "), "{option} {value}: {said}");
    said
}

#[test]
fn values_that_no_escapement_has_are_named() {
    for (option, value, words) in [
        ("--slots", "5", "3, 4 or 6"),
        ("--slots", "4,5", "5 slots"),
        ("--slots", "4,4", "twice"),
        ("--slots", "", "3, 4 or 6"),
        ("--slots", "-4", "3, 4 or 6"),
        ("--friction", "-0.1:0.3:5", "-0.1 is not zero or more"),
        ("--friction", "0:inf:5", "inf is too large or too small"),
        ("--friction", "nan", "nan is not zero or more"),
        ("--inertia-ratio", "0:1:5", "0 is not above zero"),
        ("--inertia-ratio", "1:1e31:5", "between 1e-30 and 1e30"),
        ("--inertia-ratio", "-1", "above zero"),
        ("--torque", "1:-1:5", "-1 is not above zero"),
        ("--torque", "0", "0 is not above zero"),
        ("--follower-inertia", "0", "0 is not above zero"),
        ("--follower-inertia", "light", "above zero"),
        ("--reset-deg", "225", "less than 225°"),
        ("--reset-deg", "0", "less than 225°"),
        ("--reset-deg", "nan", "less than 225°"),
        ("--threads", "0", "from 1 to 1024"),
        ("--threads", "1e3", "from 1 to 1024"),
        ("--threads", "-2", "from 1 to 1024"),
        ("--threads", "100000", "from 1 to 1024"),
    ] {
        let said = refused(option, value);
        let name = option.trim_start_matches('-');
        assert!(said.contains(words) && said.contains(name), "{option} {value}: {said}");
    }
}

#[test]
fn what_is_no_range_is_told_what_one_is() {
    for (value, words) in [
        ("", "FROM:TO:COUNT"),
        ("a", "FROM:TO:COUNT"),
        ("0.1:0.3", "FROM:TO:COUNT"),
        ("0.1:0.3:5:log:7", "FROM:TO:COUNT"),
        ("0.1:0,3:5", "give 0.3, with a decimal point"),
        ("0.1:0.3:0", "1 or more"),
        ("0.1:0.3:-5", "1 or more"),
        ("0.1:0.3:many", "1 or more"),
        ("0.1:0.3:99999999999999999999", "1 or more"),
        ("0.1:0.3:1", "2 or more"),
        ("0.3:0.3:5", "2 or more"),
        ("0.1:0.3:5:even", "linear or log"),
        ("0:0.3:5:log", "equal ratios"),
    ] {
        let said = refused("--friction", value);
        assert!(said.contains("--friction") && said.contains(words), "{value}: {said}");
    }
    let zero = ["sweep", "--slots", "4", "--friction", "0:0.3:5", "--inertia-ratio", "1", "--output", "-"];
    assert!(crate::refused(&[&zero[..], &["--spacing", "log"]].concat()).contains("equal ratios"));
    assert!(crate::refused(&[&zero[..], &["--spacing", "logs"]].concat()).contains("'log'"));
}

#[test]
fn too_many_rows_are_refused_before_any_is_computed() {
    for (friction, ratio) in [("0.1:0.3:10000001", "1"), ("0.1:0.3:10000", "1:2:1001"), ("0:1:1000000000000", "1:2:99")]
    {
        let mut command = geneva(&["sweep", "--slots", "4", "--friction", friction, "--inertia-ratio", ratio]);
        command.args(["--torque", "1:2:18446744073709551615", "--output", "-"]);
        let said = refusal(command);
        assert!(said.contains("more than 10000000 rows") && said.contains("give smaller counts"), "{said}");
    }
    let options = ["sweep", "--slots", "3,4", "--friction", "0.1:0.3:5000", "--inertia-ratio", "0.5:1:1001"];
    pin("sweep-of-too-many-rows", &[&options[..], &["--output", "-"]].concat());
}
