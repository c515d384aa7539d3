//! Is a file, and the changelog's part for the next release, short enough to be read at once?

use std::path::Path;

/// How many lines a file of Rust may have.
const LONGEST: usize = 600;

/// How many it may have if it says why it is one file.
const LONGEST_OF_ONE_IDEA: usize = 900;

/// How the module's comment of such a file begins the sentence that says why.
const REASON: &str = "One file, because ";

/// The files that are longer than the others, for one idea each.
const OF_ONE_IDEA: &[&str] = &[];

/// How many lines of the changelog may wait for a release.
const LONGEST_UNRELEASED: usize = 100;

/// What is wrong with the length of a file of Rust.
fn fault_of_length(file: &str, text: &str, of_one_idea: &[&str]) -> Option<String> {
    let lines = text.lines().count();
    let comment: Vec<&str> = text.lines().map_while(|line| line.strip_prefix("//!")).map(str::trim).collect();
    let reason = comment.join(" ").split_once(REASON).map(|(_, reason)| reason.to_owned());
    let has_reason = reason.is_some_and(|reason| reason.split_whitespace().count() >= 5);
    let is_listed = of_one_idea.contains(&file);
    if lines <= LONGEST {
        let is_excepted = is_listed || has_reason;
        is_excepted
            .then(|| format!("{file} has {lines} lines and needs no reason and no place in OF_ONE_IDEA any more"))
    } else if lines > LONGEST_OF_ONE_IDEA {
        Some(format!("{file} has {lines} lines: split it"))
    } else if has_reason && is_listed {
        None
    } else {
        Some(format!(
            "{file} has {lines} lines: split it. If it is one idea, let its comment (//!) say why, beginning with “{REASON}”, and list \
             it in OF_ONE_IDEA"
        ))
    }
}

/// The path of a file from the root of the repository.
fn from_the_root(path: &Path) -> String {
    path.strip_prefix(crate::path("")).expect("inside").to_string_lossy().replace('\\', "/")
}

#[test]
fn no_file_is_too_long() {
    let files: Vec<(String, String)> = ["crates", "tests", "book"]
        .into_iter()
        .flat_map(|folder| crate::files(folder, &[".rs"]))
        .map(|(path, text)| (from_the_root(&path), text))
        .collect();
    let faults: Vec<String> =
        files.iter().filter_map(|(file, text)| fault_of_length(file, text, OF_ONE_IDEA)).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    for listed in OF_ONE_IDEA {
        assert!(files.iter().any(|(file, _)| file == listed), "OF_ONE_IDEA: there is no {listed}");
    }
}

#[test]
fn a_long_file_needs_a_reason_and_a_place_in_the_list() {
    let fault = |lines: usize, comment: &str, of_one_idea: &[&str]| {
        let text = format!("//! Reads.\n//!\n//! {comment}\n{}", "code\n".repeat(lines - 3));
        fault_of_length("reader.rs", &text, of_one_idea).unwrap_or_default()
    };
    let reason = "One file, because its cases\n//! are tried in one order.";
    assert_eq!(fault(LONGEST, "", &[]), "");
    assert!(fault(LONGEST + 1, "", &[]).contains("split it"));
    assert!(fault(LONGEST + 1, reason, &[]).contains("OF_ONE_IDEA"));
    assert!(fault(LONGEST + 1, "", &["reader.rs"]).contains("OF_ONE_IDEA"));
    assert!(fault(LONGEST + 1, "One file, because so.", &["reader.rs"]).contains("OF_ONE_IDEA"));
    assert_eq!(fault(LONGEST_OF_ONE_IDEA - 1, reason, &["reader.rs"]), "");
    assert!(fault(LONGEST_OF_ONE_IDEA + 1, reason, &["reader.rs"]).ends_with("split it"));
    assert!(fault(LONGEST - 1, reason, &[]).contains("needs no reason"));
    assert!(fault(LONGEST, "", &["reader.rs"]).contains("needs no reason"));
}

/// How many lines a changelog has between the heading of what is unreleased and the next release.
fn unreleased_lines(changelog: &str) -> Option<usize> {
    let (_, after) = changelog.split_once("\n## [Unreleased]\n")?;
    Some(after.lines().take_while(|line| !line.starts_with("## ")).count())
}

#[test]
fn the_changelog_has_few_unreleased_lines() {
    let changelog = std::fs::read_to_string(crate::path("CHANGELOG.md")).expect("the changelog");
    let lines = unreleased_lines(&changelog).expect("a section [Unreleased]");
    assert!(
        lines <= LONGEST_UNRELEASED,
        "{lines} lines of CHANGELOG.md are unreleased, more than {LONGEST_UNRELEASED}: shorten them, or make a release"
    );
    assert_eq!(
        unreleased_lines("# Changelog\n\n## [Unreleased]\n\n### Added\n\n- A.\n\n## [0.1.0]\n\n- B.\n"),
        Some(5)
    );
    assert_eq!(unreleased_lines("# Changelog\n\n## [Unreleased]\n"), Some(0));
    assert_eq!(unreleased_lines("# Changelog\n\n## [0.1.0]\n"), None);
}
