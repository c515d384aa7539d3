//! What other programs start it by: the hooks of pre-commit, the action of GitHub, and the package of Python.

use proofread::TextFormat;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The repository's top.
fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("two folders above").to_owned()
}

fn read(inside: &str) -> String {
    std::fs::read_to_string(top().join(inside)).unwrap_or_else(|why| panic!("{inside}: {why}"))
}

/// The endings that tell a format, as the library has them, without those of tables, which are mostly data.
fn endings() -> BTreeSet<String> {
    let source = read("crates/proofread/src/reader/mod.rs");
    let (_, table) = source.split_once("fn from_extension").expect("the table of endings");
    let (table, _) = table.split_once("_ => return None").expect("its end");
    let words = table.split('"').skip(1).step_by(2);
    let is_text = |word: &&str| TextFormat::from_extension(word).is_some_and(|format| format != TextFormat::Csv);
    // Those that only the command reads stand elsewhere.
    words.filter(is_text).chain(["typ", "docx", "docm", "odt", "epub"]).map(str::to_owned).collect()
}

#[test]
fn hooks_are_for_the_formats_that_are_read() {
    let hooks = read(".pre-commit-hooks.yaml");
    let patterns: Vec<&str> = hooks.lines().filter_map(|line| line.trim().strip_prefix("files: ")).collect();
    let [texts, "*texts"] = patterns.as_slice() else { panic!("{patterns:?}") };
    let named = texts.strip_prefix(r"&texts '(?i)\.(").and_then(|rest| rest.strip_suffix(")$'")).expect("a pattern");
    let named: BTreeSet<String> = named.split('|').map(str::to_owned).collect();
    assert!(named.len() > 15);
    assert_eq!(named, endings());
}

#[test]
fn hooks_start_the_command() {
    let hooks = read(".pre-commit-hooks.yaml");
    let entries: Vec<&str> = hooks.lines().filter_map(|line| line.trim().strip_prefix("entry: ")).collect();
    assert_eq!(entries, ["proofread --staged", "proofread"]);
    // The environment that pre-commit makes has what the package of Python installs.
    let package = read("pyproject.toml");
    let manifest = "crates/proofread/Cargo.toml";
    assert!(package.contains(&format!("\nmanifest-path = \"{manifest}\"\n")), "{package}");
    let program = read(manifest);
    assert!(program.contains("[[bin]]\nname = \"proofread\"\n"), "{program}");
    for shared in ["name = \"geneva-", "description = \""] {
        let line = |of: &str| of.lines().find(|line| line.starts_with(shared)).map(str::to_owned);
        assert!(line(&program).is_some() && line(&program) == line(&package), "{shared}");
    }
}

/// A Python that is new enough for the package.
fn python() -> Option<Command> {
    let words = ["-c", "import sys; sys.exit(sys.version_info < (3, 9))"];
    let found = Command::new("python3").args(words).status().is_ok_and(|status| status.success());
    if !found {
        println!("skipped: there is no Python 3.9 or newer here");
    }
    found.then(|| Command::new("python3"))
}

#[test]
fn the_package_of_python_finds_what_the_program_finds() {
    let Some(mut python) = python() else { return };
    let package = top().join("crates/proofread/python");
    let tests = package.join("tests");
    python.args(["-B", "-m", "unittest", "discover", "-s"]).arg(tests).env("PYTHONPATH", &package);
    let output = python.env("PROOFREAD_PROGRAM", env!("CARGO_BIN_EXE_proofread")).output().expect("it runs");
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() && told.contains("Ran ") && !told.contains("Ran 0"), "{told}");
}
