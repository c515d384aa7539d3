//! Which files, threads and terminals the program refuses, whatever the command: it ends soon, with a message, and leaves
//! everything as it was.

use crate::{geneva, refusal, refused, run, stdout};
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};

/// Two decks' worth of room: what is read at most, and some more.
const TOO_LARGE: u64 = 16_000_001;

/// Runs in a folder.
fn inside(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = geneva(arguments);
    command.current_dir(folder);
    command
}

/// Every way to name a file that is read.
const READERS: [&[&str]; 7] = [
    &["coverage", "--source", "pin", "--against"],
    &["coverage", "--source", "pin", "--record"],
    &["mimic", "check"],
    &["mimic", "sort"],
    &["mimic", "run"],
    &["mimic", "run", "--listing-in"],
    &["mimic", "run", "oscillator", "--data"],
];

#[test]
fn only_regular_files_of_a_bounded_size_are_read() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    // A file of this size without its bytes: nothing is written.
    File::create(folder.path().join("large")).and_then(|file| file.set_len(TOO_LARGE)).expect("a large file");
    fs::create_dir(folder.path().join("folder")).expect("writable");
    let pipe = Command::new("mkfifo").arg(folder.path().join("pipe")).status().is_ok_and(|status| status.success());
    for reader in READERS {
        let mut refused = vec![("large", "large is larger than 16 MB"), ("folder", "folder is a folder; give ")];
        if pipe {
            // Nobody writes into it: whoever opens it waits for ever.
            refused.push(("pipe", "pipe is a pipe or a device, not a regular file; give "));
        }
        if Path::new("/dev/zero").exists() {
            refused.push(("/dev/zero", "/dev/zero is a pipe or a device, not a regular file; give "));
        }
        for (file, words) in refused {
            let said = refusal(inside(folder.path(), &[reader, &[file]].concat()));
            assert!(said.starts_with(&format!("error: {words}")) && !said.contains("os error"), "{reader:?}: {said}");
        }
    }
    let large = File::open(folder.path().join("large")).expect("it is there");
    let mut command = geneva(&["mimic", "check", "-"]);
    command.stdin(Stdio::from(large));
    assert!(refusal(command).starts_with("error: standard input is larger than 16 MB"));
}

#[test]
fn what_would_fill_the_memory_is_refused_before_it_is_made() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let stl = |stations: &'static str, play: &'static str| {
        let words = ["wheel", "--stations", stations, "--crank-radius", "50", "--thickness", "8", "--format", "stl"];
        [&words[..], &["--play", play]].concat()
    };
    for (stations, play) in [("6", "1e-6"), ("1000", "0.01")] {
        let said = refusal(geneva(&stl(stations, play)));
        assert!(
            said.contains("corners, but at most 200000 are written; give a larger --play") && said.contains(play),
            "{said}"
        );
    }
    assert_eq!(
        inside(folder.path(), &stl("6", "0.05")).stdout(Stdio::null()).status().expect("it runs").code(),
        Some(0)
    );
    let angles: Vec<String> = (0..10_001).map(|number| format!("--at={number}")).collect();
    let line: Vec<&str> = ["wheel", "--stations", "6"].into_iter().chain(angles.iter().map(String::as_str)).collect();
    let said = refused(&line);
    assert!(said.contains("--at and --at-wheel give 10001 angles, but at most 10000"), "{said}");
    assert_eq!(geneva(&line[..line.len() - 1]).stdout(Stdio::null()).status().expect("it runs").code(), Some(0));
    fs::write(folder.path().join("long"), "1 ".repeat(60_000)).expect("writable");
    let said = refusal(inside(folder.path(), &["coverage", "--source", "pin", "--against", "long"]));
    assert!(said.contains("long: line 1 has more than 100000 characters; give --against your copy"), "{said}");
}

#[test]
fn an_empty_copy_is_asked_whether_it_is_one() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("empty"), "").expect("writable");
    let output =
        inside(folder.path(), &["coverage", "--source", "pin", "--against", "empty"]).output().expect("it runs");
    let said = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(output.status.code() == Some(1) && said.contains("is this a copy of the right source?"), "{said}");
    let said = refusal({
        let mut command = geneva(&["mimic", "run", "oscillator", "--data", "-"]);
        command.stdin(Stdio::null());
        command
    });
    assert!(said.starts_with("error: --data -: standard input is empty; give 5 numbers, one for each name"), "{said}");
}

#[test]
fn the_threads_of_the_variable_are_held_to_those_of_the_option() {
    let sweep = ["sweep", "--slots", "4", "--friction", "0.1", "--inertia-ratio", "0.1"];
    let decks = ["mimic", "run", "vanderpol", "--format", "csv"];
    let with = |arguments: &[&str], value: &str| {
        let mut command = geneva(arguments);
        command.env("RAYON_NUM_THREADS", value);
        command
    };
    for arguments in [&sweep[..], &decks[..]] {
        for value in ["garbage", "-1", "", "1025", "10000", "99999999999999999999", "1.5"] {
            let said = refusal(with(arguments, value));
            let words = format!("error: the variable RAYON_NUM_THREADS is '{value}', not a number of threads; give an");
            assert!(said.starts_with(&words) && said.contains("from 1 to 1024"), "{said}");
        }
        for value in ["0", "1", "3", "64"] {
            let output = with(arguments, value).output().expect("the program runs");
            let usual = run(arguments);
            assert!(output.status.success() && output.stdout == usual.stdout, "{value}: {output:?}");
        }
    }
    // The option counts more than the variable.
    let output = with(&[&sweep[..], &["--threads", "1"]].concat(), "garbage").output().expect("the program runs");
    assert!(output.status.success(), "{output:?}");
}

#[test]
fn nothing_that_a_terminal_obeys_is_told_back() {
    let signs = ["\u{1b}[31mX", "\u{7}", "\u{9b}2J", "\u{202e}", "a\nb", "\r"];
    let mut lines: Vec<Vec<String>> = Vec::new();
    for sign in signs {
        for line in [
            &["mimic", "check", "?"][..],
            &["mimic", "decks", "?"],
            &["mimic", "run", "decay", "--set", "?=1"],
            &["mimic", "run", "decay", "--set", "N=?"],
            &["mimic", "run", "decay", "--output", "no-folder/?"],
            &["coverage", "--source", "pin", "--against", "?"],
            &["coverage", "--source", "?"],
            &["sweep", "--slots", "4", "--friction", "?", "--inertia-ratio", "1"],
            &["sweep", "--slots", "4", "--friction", "1:2:3:?", "--inertia-ratio", "1"],
            &["wheel", "--?"],
            &["wheel", "--stations", "?"],
            &["?"],
        ] {
            lines.push(line.iter().map(|word| word.replace('?', sign)).collect());
        }
    }
    for line in lines {
        let words: Vec<&str> = line.iter().map(String::as_str).collect();
        let mut command = geneva(&words);
        // With colours, as on a terminal.
        command.env("CLICOLOR_FORCE", "1");
        let said = refusal(command);
        let plain = anstream::adapter::strip_str(&said).to_string();
        let obeyed = |sign: char| sign.is_control() && sign != '\n' || sign == '\u{202e}';
        assert!(!plain.contains(obeyed), "{line:?}: {plain:?}");
        // The program's own colours are all that is stripped: bold, red, yellow, green and underlined.
        let own = said.matches('\u{1b}').count();
        let known = ["[0m", "[1m", "[4m", "[31m", "[32m", "[33m"];
        assert_eq!(
            own,
            known.iter().map(|code| said.matches(&format!("\u{1b}{code}")).count()).sum::<usize>(),
            "{said:?}"
        );
        assert!(!said.contains("\u{1b}[31mX"), "{line:?}: {said:?}");
    }
}

#[test]
fn a_long_value_is_told_in_a_few_characters() {
    let (long, digits) = ("x".repeat(3000), "9".repeat(3000));
    for line in [
        &["wheel", &long][..],
        &[&long],
        &["wheel", "--stations", &long],
        &["wheel", "--stations", &digits],
        &["wheel", "--stations", "6", "--rpm", &digits],
        &["sweep", "--slots", "4", "--friction", &digits, "--inertia-ratio", "1"],
        &["sweep", "--slots", "4", "--friction", &long, "--inertia-ratio", "1"],
        &["mimic", "decks", &long],
        &["mimic", "run", "decay", "--set", &format!("{long}=1")],
        &["mimic", "run", "decay", "--set", &format!("N={digits}")],
        &["mimic", "run", "decay", "--tolerance", &digits],
        &["claims", "--source", &long],
        &["wheel", &format!("--{long}")],
    ] {
        let said = refused(line);
        assert!(said.len() < 1000 && said.contains('…'), "{} characters: {}", said.len(), &said[..200]);
    }
}

#[test]
fn a_full_standard_output_is_told_by_help_version_and_completions_too() {
    for arguments in
        [&["--help"][..], &["--version"], &["wheel", "--help"], &["completions", "bash"], &["mimic", "functions"]]
    {
        let Ok(full) = File::options().write(true).open("/dev/full") else { return };
        let output = geneva(arguments).stdout(full).output().expect("the program runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && said.contains("cannot write to standard output: "), "{said}");
        // Whoever gives it /dev/null wants nothing of it.
        assert_eq!(geneva(arguments).stdout(Stdio::null()).status().expect("it runs").code(), Some(0));
    }
}

#[cfg(unix)]
#[test]
fn an_output_is_no_file_that_is_protected_and_no_other_name_of_what_is_read() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = |name: &str| folder.path().join(name);
    let to = |name: &str| inside(folder.path(), &["mimic", "check", "deck", "--output", name]);
    fs::write(path("deck"), stdout(&["mimic", "decks", "decay"], 0)).expect("writable");
    let deck = fs::read_to_string(path("deck")).expect("it is there");

    // Read-only: the mode counts for the superuser too.
    fs::write(path("protected"), "mine\n").expect("writable");
    fs::set_permissions(path("protected"), fs::Permissions::from_mode(0o444)).expect("it is mine");
    symlink("protected", path("to-protected")).expect("a link");
    for name in ["protected", "to-protected"] {
        let said = refusal(to(name));
        assert!(said.contains("is a read-only file; give another"), "{said}");
    }
    assert_eq!(fs::read_to_string(path("protected")).expect("it is there"), "mine\n");

    // Another name of what is read.
    fs::hard_link(path("deck"), path("hard")).expect("a link");
    symlink("deck", path("soft")).expect("a link");
    for name in ["deck", "hard", "soft", "./deck"] {
        let said = refusal(to(name));
        assert!(said.contains("would overwrite deck, which is an input"), "{said}");
    }
    assert_eq!(fs::read_to_string(path("deck")).expect("it is there"), deck);

    // A link to a file that is not there yet: the file is made, and the link stays.
    fs::create_dir(path("elsewhere")).expect("writable");
    symlink("elsewhere/new", path("one")).expect("a link");
    symlink("one", path("two")).expect("a link");
    assert_eq!(to("two").status().expect("it runs").code(), Some(0));
    assert!(path("two").is_symlink() && path("one").is_symlink());
    assert!(fs::read_to_string(path("elsewhere/new")).expect("it was made").starts_with("deck: no mistakes found"));
    // Links that lead nowhere, and a folder that is not there.
    symlink("round", path("about")).expect("a link");
    symlink("about", path("round")).expect("a link");
    symlink("no-folder/new", path("far")).expect("a link");
    for (name, words) in
        [("about", "a link that leads nowhere"), ("far", "cannot write far: "), ("new/", "a folder that doesn't exist")]
    {
        let said = refusal(to(name));
        assert!(said.contains(words) && said.contains("give ") && !said.contains("os error"), "{said}");
    }
}

#[test]
fn messages_name_what_was_typed_and_what_to_do() {
    for (line, words) in [
        (&["sweep", "--slots", "4,3,3", "--friction", "1", "--inertia-ratio", "1"][..], "--slots lists 3 twice"),
        (&["mimic", "run", "decay", "--set", "FIN=1e-17"], "--set FIN=1e-17: no CON or PAR card of decay"),
        (&["mimic", "run", "decay", "--set", "FIN=1e308"], "--set FIN=1e308: no CON or PAR card of decay"),
        (&["mimic", "decks", "  "], "'  ' is not a deck of this project; give one of"),
        (
            &["mimic", "run", "decay", "--runs", "appendix-e"],
            "the CON and PAR cards of decay ask for 2; give a deck that",
        ),
        (
            &[
                "escapement",
                "--slots",
                "4",
                "--friction",
                "1E309",
                "--torque",
                "1",
                "--driver-inertia",
                "1",
                "--follower-inertia",
                "1",
            ],
            "'--friction <MU>': 1E309 is too large or too small to compute with; give",
        ),
        (
            &["quick-return", "--ground", "1", "--crank", "1e-20", "--lever-angle", "24", "--rpm", "1"],
            "between −5.729e-19°",
        ),
        (&["preprocess"], "standard input is not a book of mdBook 0.5 (Unable to parse the input: EOF"),
        (
            &["mimic", "run", "misprinted", "--set", "DTMIN=5.4"],
            "DTMIN is 5.4: it must not be above DTMAX, which is 0.1,",
        ),
    ] {
        let mut command = geneva(line);
        command.stdin(Stdio::null());
        let said = refusal(command);
        assert!(said.contains(words), "{line:?}: {said}");
        // No row of digits longer than a number of this machine has.
        let digits = said.split(|sign: char| !sign.is_ascii_digit()).map(str::len).max();
        assert!(digits < Some(17), "{said}");
    }
}

#[test]
fn fuzz_the_program_ends_with_a_known_code_and_says_why() {
    // How such lines are made of all options stands in `crates/geneva/src/fuzz.rs`; here the program itself runs.
    const COMMANDS: [&[&str]; 8] = [
        &["claims", "--source", "pin"],
        &["errata", "--source", "pin"],
        &["coverage"],
        &["wheel", "--stations", "6"],
        &["quick-return", "--ground", "0.3", "--crank", "0.1"],
        &["sweep", "--slots", "4", "--friction", "0.1"],
        &["mimic", "run", "decay"],
        &["mimic", "check"],
    ];
    const WORDS: [&str; 21] = [
        "--format",
        "json",
        "csv",
        "svg",
        "--rpm",
        "60",
        "--crank-angle",
        "--inertia-ratio",
        "0.3",
        "1e309",
        "nan",
        "--at",
        "--output",
        "out",
        "--set",
        "N=1",
        "\u{1b}[2J",
        "\u{7}",
        "",
        "--verdict",
        "--threads",
    ];
    let tries: usize = std::env::var("GENEVA_FUZZ").map_or(40, |text| text.parse().expect("a number")).min(2000);
    let seed: u64 = std::env::var("GENEVA_FUZZ_SEED").map_or(7, |text| text.parse().expect("a number"));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut dice = fastrand::Rng::with_seed(seed);
    let mut codes = [0; 3];
    for _ in 0..tries {
        let mut line = COMMANDS[dice.usize(..COMMANDS.len())].to_vec();
        for _ in 0..dice.usize(..6) {
            line.push(WORDS[dice.usize(..WORDS.len())]);
        }
        let output = inside(folder.path(), &line).stdin(Stdio::null()).output().expect("the program runs");
        let code = output.status.code().and_then(|code| usize::try_from(code).ok()).filter(|code| *code < 3);
        let code = code.unwrap_or_else(|| panic!("{line:?}: {output:?}"));
        codes[code] += 1;
        let (said, told) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert_eq!(code == 2, !told.is_empty(), "{line:?}: {told}");
        let obeyed = |sign: char| sign.is_control() && sign != '\n';
        assert!(!told.contains("panicked") && !told.contains(obeyed) && !said.contains(obeyed), "{line:?}: {told:?}");
        let mut words = said.split(|sign: char| !sign.is_alphanumeric());
        assert!(!words.any(|word| ["NaN", "inf"].contains(&word)), "{line:?}");
    }
    println!("{tries} processes: exit codes 0, 1, 2: {codes:?}");
}
