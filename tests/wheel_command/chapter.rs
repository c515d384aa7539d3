//! Does the program do what the chapter *Make a wheel* says of it? Its commands are run as they are typed there, and what its
//! sentences say of the answers is looked up in them.

use crate::{object, refused, stdout};
use geneva_chapters::questions;
use std::fs;

/// The arguments of the commands in the chapter, each with the folder for its files, if it has one, put here.
fn commands(folder: &str) -> Vec<Vec<String>> {
    let chapter = fs::read_to_string(crate::path("book/src/making.md")).expect("the chapter");
    let fenced = chapter.split("```sh\n").skip(1).filter_map(|rest| rest.split("```").next());
    let lines = fenced.flat_map(|block| {
        block
            .replace("\\\n", " ")
            .lines()
            .map(str::trim)
            .filter(|line| !line.is_empty())
            .map(str::to_owned)
            .collect::<Vec<_>>()
    });
    let with_folder = |line: String| {
        let words = line.strip_prefix("cargo run -- ").expect("a command of ours").split_whitespace();
        let mut arguments: Vec<String> = words.map(str::to_owned).collect();
        if let Some(at) = arguments.iter().position(|word| word == "--out") {
            arguments[at + 1] = format!("{folder}/{}", arguments[at + 1]);
        }
        arguments
    };
    lines.map(with_folder).collect()
}

#[test]
fn the_commands_of_the_chapter_are_answered_and_write_the_files_that_it_names() {
    let folder = tempfile::tempdir().expect("a folder");
    let commands = commands(folder.path().to_str().expect("UTF-8"));
    assert!(commands.len() >= 7, "only {commands:?}");
    for arguments in &commands {
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        assert!(stdout(&arguments, 0).lines().count() > 5, "{arguments:?}");
    }
    // The files of the folder are those of the table, and the curve over the sizes.
    let chapter = fs::read_to_string(crate::path("book/src/making.md")).expect("the chapter");
    let table = chapter.split("| File | For |").nth(1).and_then(|rest| rest.split("\n\n").next()).expect("a table");
    let mut named: Vec<&str> = table.split('`').skip(1).step_by(2).chain(["sizes.csv", "sizes.svg"]).collect();
    named.sort_unstable();
    let written = fs::read_dir(folder.path().join("my-wheel")).expect("a folder");
    let mut written: Vec<String> =
        written.map(|file| file.expect("a file").file_name().to_string_lossy().into_owned()).collect();
    written.sort_unstable();
    assert_eq!(written, named);
    // The sizes of the curve go from half to twice that of the wheel.
    let radii: Vec<f64> = csv::Reader::from_path(folder.path().join("my-wheel/sizes.csv"))
        .expect("a table")
        .into_records()
        .map(|row| row.expect("CSV")[0].parse().expect("a radius"))
        .collect();
    let own = questions::value(&questions::question("table").expect("a question"), "crank_radius_mm").expect("a size");
    let [least, most] = [radii[0], radii[radii.len() - 1]].map(|radius| radius / own);
    assert!(radii.len() > 5 && (0.5..0.6).contains(&least) && (1.8..=2.0).contains(&most), "{radii:?}");
}

#[test]
fn the_commands_of_the_tasks_are_the_questions_from_which_their_numbers_are() {
    let typed: Vec<String> = commands("").iter().map(|words| words.join(" ").replace("--out /", "--out ")).collect();
    for name in ["table", "printed", "checked", "replaced", "worked"] {
        let question = questions::question(name).expect("a question");
        assert!(typed.contains(&question), "no command of the chapter is `{question}`: {typed:?}");
    }
}

#[test]
fn the_nearest_wheel_for_270_degrees_has_four_stations_and_one_pin() {
    let found = stdout(&["wheel", "--dwell-angle", "270"], 0);
    let nearest = found.split("Nearest").nth(1).expect("a list");
    assert!(
        nearest
            .lines()
            .nth(1)
            .is_some_and(|line| line.contains("270.0") && line.ends_with("external, 4 stations, 1 pin"))
    );
}

#[test]
fn the_check_of_the_chapter_blames_the_centre_distance() {
    let question = questions::question("checked").expect("a question");
    let found = object(&question.split(' ').collect::<Vec<_>>());
    assert_eq!(found["culprit"], "centre distance");
    let first = found["change_first"].as_str().expect("words");
    assert!(first.contains("put the axes 50"), "{first}");
    assert_eq!(found["lands_on_corner"], true);
    // Without a size, what rests on it is not told, and the option that would tell it is named.
    let words: Vec<&str> = question.split(' ').collect();
    for (without, lost) in [("--slot-width", "index_backlash_deg"), ("--locking-disc-radius", "dwell_backlash_deg")] {
        let at = words.iter().position(|word| *word == without).expect("an option");
        let fewer = object(&[&words[..at], &words[at + 2..]].concat());
        assert!(!found[lost].is_null() && fewer[lost].is_null() && fewer["turns"].is_null(), "{without}");
        let unmeasured = fewer["unmeasured"].as_array().expect("options");
        assert!(unmeasured.contains(&without.trim_start_matches('-').into()), "{unmeasured:?}");
    }
}

#[test]
fn one_of_three_holes_of_the_printed_hub_would_be_in_a_slot() {
    let question = questions::question("printed").expect("a question").replace("--hub-holes 4 ", "");
    let words: Vec<&str> = question.split(" --out").next().expect("a question").split(' ').collect();
    let said = refused(&[&words[..], &["--format", "dxf"]].concat());
    assert!(said.contains("a hole of the hub runs into a slot"), "{said}");
}

#[test]
fn what_the_table_of_mountings_adds_is_in_the_parts() {
    let chapter = fs::read_to_string(crate::path("book/src/making.md")).expect("the chapter");
    let table = chapter.split("| To get | Add, for example |").nth(1).and_then(|rest| rest.split("\n\n").next());
    let options = table.expect("a table").split('`').skip(1).step_by(2);
    let mut tried = 0;
    let bare = "wheel --stations 6 --crank-radius 50 --wheel-shaft 12 --driver-shaft 10 --thickness 8 --format step";
    let without = stdout(&bare.split(' ').collect::<Vec<_>>(), 0);
    for option in options {
        let screws = if option.starts_with("--driver-hub") { " --hub-screw M4" } else { "" };
        let asked = format!("{bare} {option}{screws}");
        assert_ne!(stdout(&asked.split(' ').collect::<Vec<_>>(), 0), without, "{option}");
        tried += 1;
    }
    assert_eq!(tried, 8);
}
