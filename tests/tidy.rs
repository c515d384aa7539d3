//! Are the rules of the repository kept?

mod circles;
mod engine;
mod examples;
mod folders;
mod known;
mod lengths;
mod paths;
mod public_names;
mod sources;
mod spelling;
mod units;
mod waits;
mod words;

use geneva_evidence::numeric_tokens;
use toml::Table;

/// Which crates of the workspace each crate may use.
const MAY_USE: &[(&str, &[&str])] = &[
    ("host", &[]),
    ("exact", &[]),
    ("evidence", &["exact"]),
    ("kinematics", &["exact"]),
    ("dynamics", &["kinematics", "mimic"]),
    ("mimic", &[]),
    ("case1973", &["kinematics", "dynamics", "mimic"]),
    ("documents", &["evidence", "kinematics", "dynamics", "mimic", "case1973"]),
    ("figures", &["kinematics", "dynamics", "mimic", "case1973"]),
    ("proofread", &["host"]),
    ("values", &["evidence", "exact", "fields", "host", "proofread"]),
    ("workshop", &["kinematics"]),
    ("fields", &[]),
    ("ask", &["fields", "kinematics", "dynamics", "figures", "workshop"]),
    ("live", &["kinematics", "dynamics", "mimic", "case1973", "figures", "ask"]),
    ("live-design", &["live"]),
    ("live-files", &["ask", "live"]),
    ("press", &["evidence", "fields", "host"]),
    (
        "chapters",
        &[
            "fields",
            "kinematics",
            "mimic",
            "case1973",
            "evidence",
            "documents",
            "figures",
            "ask",
            "live",
            "press",
            "proofread",
            "proofread-page",
        ],
    ),
    ("proofread-page", &["proofread"]),
    (
        "geneva",
        &[
            "host",
            "kinematics",
            "dynamics",
            "mimic",
            "case1973",
            "evidence",
            "documents",
            "figures",
            "ask",
            "proofread",
            "values",
            "workshop",
            "live",
            "live-files",
            "press",
            "chapters",
        ],
    ),
];

/// Crates that turn answers into pages, and the mathematics that they therefore don't need: whoever computes has a home elsewhere.
const COMPUTE_NOTHING: [&str; 2] = ["press", "chapters"];
const MATHEMATICS: [&str; 4] = ["libm", "nalgebra", "num-dual", "ode_solvers"];

/// Each crate, what it depends on, and whether the version is the workspace's.
fn dependencies() -> Vec<(String, String, bool)> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(crate::path("crates")).expect("the crates") {
        let package = entry.expect("readable").file_name().to_string_lossy().into_owned();
        let text = std::fs::read_to_string(crate::path(&format!("crates/{package}/Cargo.toml"))).expect("a manifest");
        let manifest: Table = text.parse().expect("TOML");
        for section in ["dependencies", "dev-dependencies", "build-dependencies"] {
            for (name, value) in manifest.get(section).and_then(|used| used.as_table()).into_iter().flatten() {
                let inherited = value.get("workspace").and_then(|of| of.as_bool()) == Some(true);
                found.push((package.clone(), name.clone(), inherited));
            }
        }
    }
    found
}

#[test]
fn dependencies_point_one_way() {
    for (package, name, _) in dependencies() {
        let is_mathematics = MATHEMATICS.contains(&&*name);
        assert!(
            !COMPUTE_NOTHING.contains(&&*package) || !is_mathematics,
            "{package} must not use {name}: ask for the number"
        );
        let Some(name) = name.strip_prefix("geneva-") else { continue };
        let (_, allowed) = MAY_USE
            .iter()
            .find(|(known, _)| *known == package)
            .unwrap_or_else(|| panic!("say here what {package} may use"));
        assert!(allowed.contains(&name), "{package} must not use {name}");
    }
}

#[test]
fn versions_stand_in_one_place() {
    for (package, name, inherited) in dependencies() {
        assert!(inherited, "{package}: {name} takes its version from the workspace");
    }
}

#[test]
fn every_file_says_what_it_is_about() {
    for folder in ["crates", "tests", "book"] {
        for (path, text) in crate::files(folder, &[".rs"]) {
            assert!(text.starts_with("//!"), "{} does not open with //!", path.display());
        }
    }
}

#[test]
fn the_first_line_of_a_doc_comment_stands_alone() {
    // In an alphabetical list it has no neighbour to lean on.
    const LEANING: [&str; 7] = ["The same", "That of", "Those of", "As above", "See above", "Ditto", "Likewise"];
    for folder in ["crates", "tests", "book"] {
        for (path, text) in crate::files(folder, &[".rs"]) {
            let mut before = "";
            for (number, line) in text.lines().map(str::trim).enumerate() {
                let first = line.strip_prefix("/// ").filter(|_| !before.starts_with("///"));
                let leaning = first.and_then(|words| LEANING.iter().find(|opening| words.starts_with(**opening)));
                assert!(leaning.is_none(), "{}:{}: say what it is: {line}", path.display(), number + 1);
                before = line;
            }
        }
    }
}

/// The manifest in a folder of the project.
fn manifest(folder: &str) -> Table {
    let path = crate::path(folder).join("Cargo.toml");
    std::fs::read_to_string(path).expect("a manifest").parse().expect("TOML")
}

#[test]
fn a_library_whose_tests_are_elsewhere_has_none_of_its_own() {
    let mut elsewhere = Vec::new();
    for entry in std::fs::read_dir(crate::path("crates")).expect("the crates") {
        let package = entry.expect("readable").file_name().to_string_lossy().into_owned();
        let library = manifest(&format!("crates/{package}")).get("lib").and_then(|lib| lib.get("test")?.as_bool());
        if library != Some(false) {
            continue;
        }
        for (path, text) in crate::files(&format!("crates/{package}/src"), &[".rs"]) {
            for word in ["#[test]", "cfg(test)"] {
                assert!(
                    !text.contains(word),
                    "{}: this test never runs; move it to crates/{package}/tests",
                    path.display()
                );
            }
        }
        elsewhere.push(package);
    }
    // With tests of their own, these optimised libraries would be compiled twice.
    for package in ["case1973", "dynamics", "kinematics", "mimic"] {
        assert!(elsewhere.iter().any(|name| name == package), "crates/{package}/Cargo.toml: [lib] needs test = false");
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
    for package in [
        "crates/exact",
        "crates/kinematics",
        "crates/dynamics",
        "crates/mimic",
        "crates/case1973",
        "crates/figures",
        "crates/workshop",
        "crates/ask",
        "crates/press",
        "crates/chapters",
        "crates/geneva",
        "tests",
    ] {
        for (path, text) in crate::files(package, &[".rs"]) {
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
    let tests = ["drawn.rs", "stations/clearance.rs", "figures/src/checks.rs"];
    for package in [
        "crates/exact/src",
        "crates/evidence/src",
        "crates/kinematics/src",
        "crates/dynamics/src",
        "crates/mimic/src",
        "crates/case1973/src",
        "crates/documents/src",
        "crates/figures/src",
        "crates/workshop/src",
        "crates/ask/src",
        "crates/proofread/src",
    ] {
        for (path, text) in crate::files(package, &[".rs"]) {
            let named = path.file_stem().is_some_and(|name| name.to_string_lossy().ends_with("_tests"));
            if named || tests.iter().any(|name| path.ends_with(name)) || path.iter().any(|part| part == "tests") {
                continue;
            }
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            let is_code = |line: &&str| !line.trim_start().starts_with("//");
            let code = code.lines().filter(is_code).collect::<Vec<_>>().join("\n");
            for method in methods {
                // Of dual numbers: at an angle of zero, which every platform has alike, or of what is not pinned.
                let calls = [format!(".{method}("), format!("f64::{method}")];
                let excused = ["sin_cos", "atan"].contains(&method)
                    && ["documents/src/jazar/mod.rs", "documents/src/duals.rs"].iter().any(|of| path.ends_with(of));
                let called = calls.iter().find(|call| code.contains(*call));
                assert!(called.is_none() || excused, "{} calls {called:?}; use libm's", path.display());
            }
        }
    }
}

#[test]
fn a_witness_shares_no_code_with_what_it_vouches_for() {
    // What answers the questions of the study in the first way: the solution over the angle, the program's run and what is
    // read off it, and the statistics.
    let first_routes = [
        "Engagement",
        ".engagement(",
        ".run(",
        ".run_by_program(",
        "printout(",
        "read_off(",
        ".likelihoods",
        ".log_likelihood(",
        ".margin(",
        ".maximum_likelihood(",
        "expected_cells",
        "Dealer",
        "golden_section",
        "InertiaFit",
    ];
    let code = |text: &str| {
        let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        lines.collect::<Vec<_>>().join("\n")
    };
    let files = crate::files("crates/case1973/src", &[".rs"]).into_iter().map(|(path, text)| (path, code(&text)));
    let (witnesses, others): (Vec<_>, Vec<_>) = files.partition(|(path, _)| path.iter().any(|part| part == "witness"));
    assert!(witnesses.len() > 5 && others.len() > 10);
    for route in first_routes {
        assert!(others.iter().any(|(_, code)| code.contains(route)), "{route} is no first route any more");
        let called = witnesses.iter().find(|(_, code)| code.contains(route));
        assert!(called.is_none(), "{:?} calls {route}, for which it is a witness", called.map(|(path, _)| path));
    }
    for (path, code) in others.iter().filter(|(path, _)| !path.ends_with("lib.rs")) {
        assert!(!code.contains("witness"), "{} calls a witness of its own", path.display());
    }
}

#[test]
fn a_snapshot_is_reviewed_before_it_is_kept() {
    for entry in ["series", "drawings", "ledger", "pages", "command-line"] {
        for file in std::fs::read_dir(crate::path("snapshots").join(entry)).expect("an area of snapshots") {
            let name = file.expect("readable").file_name().to_string_lossy().into_owned();
            assert!(
                name.ends_with(".snap"),
                "snapshots/{entry}/{name} is not a reviewed snapshot: `cargo insta review` or delete it; git ignores it"
            );
        }
    }
}
