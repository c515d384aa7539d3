//! Are the rules of the house kept?

use geneva_ledger::numeric_tokens;
use std::collections::BTreeMap;
use toml::Table;

/// Which rooms of the workspace each room may use.
const MAY_USE: &[(&str, &[&str])] = &[
    ("kinematics", &[]),
    ("dynamics", &["kinematics", "mimic"]),
    ("mimic", &[]),
    ("ledger", &["kinematics", "dynamics", "mimic"]),
    ("figures", &["kinematics", "dynamics", "mimic"]),
    ("press", &["kinematics", "dynamics", "mimic", "ledger", "figures"]),
    ("geneva", &["kinematics", "dynamics", "mimic", "ledger", "figures", "press"]),
];

fn manifest(path: &str) -> Table {
    let text = std::fs::read_to_string(crate::path(path)).expect("a manifest");
    text.parse().expect("TOML")
}

#[test]
fn dependencies_point_one_way() {
    let rooms: BTreeMap<_, _> = MAY_USE.iter().copied().collect();
    for entry in std::fs::read_dir(crate::path("crates")).expect("the rooms") {
        let room = entry.expect("readable").file_name().to_string_lossy().into_owned();
        let allowed = rooms.get(room.as_str()).unwrap_or_else(|| panic!("say in this test what {room} may use"));
        let manifest = manifest(&format!("crates/{room}/Cargo.toml"));
        for section in ["dependencies", "dev-dependencies", "build-dependencies"] {
            let used = manifest.get(section).and_then(|used| used.as_table()).cloned().unwrap_or_default();
            for name in used.keys().filter_map(|name| name.strip_prefix("geneva-")) {
                assert!(allowed.contains(&name), "{room} must not use {name}");
            }
        }
    }
}

#[test]
fn versions_stand_in_one_place() {
    for entry in std::fs::read_dir(crate::path("crates")).expect("the rooms") {
        let room = entry.expect("readable").file_name().to_string_lossy().into_owned();
        let manifest = manifest(&format!("crates/{room}/Cargo.toml"));
        for section in ["dependencies", "dev-dependencies"] {
            let used = manifest.get(section).and_then(|used| used.as_table()).cloned().unwrap_or_default();
            for (name, value) in &used {
                let inherited = value.get("workspace").and_then(|w| w.as_bool()) == Some(true);
                assert!(inherited, "{room}: {name} takes its version from the workspace");
            }
        }
    }
}

#[test]
fn every_file_says_what_it_is_about_and_is_not_too_long() {
    for folder in ["crates", "tests", "book"] {
        for (path, text) in crate::files(folder, &[".rs"]) {
            assert!(text.starts_with("//!"), "{} does not open with //!", path.display());
            assert!(text.lines().count() <= 600, "{} has {} lines: split it", path.display(), text.lines().count());
        }
    }
}

#[test]
fn nothing_is_switched_off_or_left_unfinished() {
    // Built from pieces, or this file would find itself.
    let words = [["#[igno", "re"], ["un", "safe {"], ["todo", "!("], ["unimple", "mented!("], ["dbg", "!("]];
    for folder in ["crates", "tests", "book"] {
        for (path, text) in crate::files(folder, &[".rs"]) {
            for word in words.map(|pieces| pieces.concat()) {
                assert!(!text.contains(&word), "{} has {word}", path.display());
            }
        }
    }
}

#[test]
fn no_printed_decimal_stands_outside_the_ledger() {
    for room in [
        "crates/kinematics",
        "crates/dynamics",
        "crates/mimic",
        "crates/figures",
        "crates/press",
        "crates/geneva",
        "tests",
    ] {
        for (path, text) in crate::files(room, &[".rs"]) {
            for (at, line) in text.lines().enumerate() {
                for token in numeric_tokens(line) {
                    let owner = crate::owner(&token);
                    assert!(owner.is_none(), "{}:{}: {token} belongs to {owner:?}", path.display(), at + 1);
                }
            }
        }
    }
}

#[test]
fn formulas_use_no_mathematics_of_the_platform() {
    // Methods of f64 that the platform's library computes, each a little differently.
    let methods = [
        "sin", "cos", "tan", "asin", "acos", "atan", "sin_cos", "exp", "ln", "powf", "powi", "cbrt", "hypot", "atan2",
        "exp2", "log2", "log10", "sinh", "cosh", "tanh",
    ];
    // Modules of tests alone: what they compute is compared, not pinned.
    let tests = ["program/tests.rs", "judge_tests.rs", "drawn.rs", "clearance.rs", "figures/src/checks.rs"];
    for room in
        ["crates/kinematics/src", "crates/dynamics/src", "crates/mimic/src", "crates/ledger/src", "crates/figures/src"]
    {
        for (path, text) in crate::files(room, &[".rs"]) {
            if tests.iter().any(|name| path.ends_with(name)) || path.iter().any(|part| part == "tests") {
                continue;
            }
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            let is_code = |line: &&str| !line.trim_start().starts_with("//");
            let code = code.lines().filter(is_code).collect::<Vec<_>>().join("\n");
            for method in methods {
                // Of dual numbers: at an angle of zero, which every platform has alike, or of what is not pinned.
                let calls = [format!(".{method}("), format!("f64::{method}")];
                let excused = ["sin_cos", "atan"].contains(&method)
                    && ["ledger/src/jazar/mod.rs", "ledger/src/duals.rs"].iter().any(|of| path.ends_with(of));
                let called = calls.iter().find(|call| code.contains(*call));
                assert!(called.is_none() || excused, "{} calls {called:?}; use libm's", path.display());
            }
        }
    }
}

#[test]
fn the_changelog_keeps_its_kinds() {
    let text = std::fs::read_to_string(crate::path("CHANGELOG.md")).expect("a changelog");
    for line in text.lines().filter_map(|line| line.strip_prefix("### ")) {
        assert!(["Added", "Changed", "Fixed", "Removed", "Verdicts", "Errata"].contains(&line), "what is {line}?");
    }
}

#[test]
fn a_snapshot_is_reviewed_before_it_is_kept() {
    for entry in ["series", "drawings", "ledger", "command-line"] {
        for file in std::fs::read_dir(crate::path("snapshots").join(entry)).expect("an area of snapshots") {
            let name = file.expect("readable").file_name().to_string_lossy().into_owned();
            assert!(name.ends_with(".snap"), "snapshots/{entry}/{name} is not a reviewed snapshot");
        }
    }
}
