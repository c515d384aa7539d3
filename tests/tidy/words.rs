//! Does the code use the field's words? No name in it contains a word that was given up for a word of the field.

use super::sources::{is_of_a_name, masked};

/// Words that no name has as a part: the word, the crates, and what the field says. Comments and texts are free.
const GIVEN_UP: &[(&str, &[&str], &str)] = &[
    ("gain", &["exact", "kinematics", "dynamics", "case1973"], "angular acceleration"),
    ("decider", &["exact", "kinematics", "dynamics", "case1973", "evidence", "documents"], "switching function"),
    ("switch", &["dynamics", "case1973"], "contact reversal, or switching function"),
    ("turning_rate", &["exact", "kinematics", "dynamics", "evidence", "documents", "figures"], "angular acceleration"),
    ("memory", &["dynamics", "case1973"], "decay constant, or delay line"),
    ("contraction", &["dynamics", "figures"], "multiplier"),
    ("preload", &["dynamics"], "constant drag torque"),
    ("stretch", &["exact", "kinematics", "dynamics", "figures"], "subinterval, or Jacobian"),
    ("half_station", &["exact", "kinematics", "dynamics", "evidence", "documents", "figures"], "half pitch angle"),
    (
        "neat",
        &["exact", "kinematics", "dynamics", "figures", "evidence", "documents", "press", "chapters"],
        "what it does",
    ),
    (
        "had_been",
        &["exact", "kinematics", "dynamics", "figures", "evidence", "documents", "press", "chapters"],
        "what it is",
    ),
    ("shade", &["figures"], "colour"),
    ("lean", &["press", "chapters"], "minified"),
    ("house", &["press", "chapters", "geneva"], "architecture"),
];

/// The names of a file: its words of code, without comments and texts.
fn names(text: &str) -> Vec<String> {
    masked(text).split(|c| !is_of_a_name(c)).filter(|name| !name.is_empty()).map(str::to_owned).collect()
}

/// A name in small letters with its words apart.
fn in_words(name: &str) -> String {
    let mut words = String::from("_");
    let mut before = '_';
    for c in name.chars() {
        if c.is_uppercase() && before.is_lowercase() {
            words.push('_');
        }
        words.extend(c.to_lowercase());
        before = c;
    }
    words + "_"
}

/// What is wrong with the names of a file of a crate.
fn given_up(package: &str, text: &str) -> Vec<String> {
    let of_package: Vec<_> = GIVEN_UP.iter().filter(|(_, packages, _)| packages.contains(&package)).collect();
    let mut found: Vec<String> = Vec::new();
    for name in names(text) {
        let words = in_words(&name);
        let word = of_package.iter().find(|(word, ..)| words.contains(&format!("_{word}_")));
        found.extend(word.map(|(word, _, field)| format!("{name}: for “{word}” the field says {field}")));
    }
    found
}

#[test]
fn names_are_made_of_the_fields_words() {
    for package in GIVEN_UP.iter().flat_map(|(_, packages, _)| *packages) {
        assert!(crate::path("crates").join(package).is_dir(), "there is no crate {package} any more");
    }
    let mut wrong = Vec::new();
    for (path, text) in crate::files("crates", &[".rs"]) {
        let path = path.to_string_lossy().replace('\\', "/");
        let package = path.split("crates/").nth(1).and_then(|rest| rest.split('/').next()).unwrap_or_default();
        wrong.extend(given_up(package, &text).into_iter().map(|what| format!("{path}: {what}")));
    }
    wrong.dedup();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    for (package, text) in [
        ("dynamics", "let gain = 1.0;"),
        ("dynamics", "pub struct SignDecider;"),
        ("figures", "fn with_shade() {}"),
        ("kinematics", "rates.turning_rate"),
    ] {
        assert_eq!(given_up(package, &format!("{text}\n")).len(), 1, "{package}: {text}");
    }
    for (package, text) in [
        ("dynamics", "// No gain.\nlet switching_function = \"a \\\" gain\";"),
        ("figures", "let gain = 1.0;"),
        ("dynamics", "again"),
    ] {
        assert!(given_up(package, &format!("{text}\n")).is_empty(), "{package}: {text}");
    }
}
