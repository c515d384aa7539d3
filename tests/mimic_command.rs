//! Does `geneva mimic` check, sort and run decks, and does it say what is wrong with them?

use crate::{geneva, json, pin, refused, stdout};
use geneva_case1973::Hypothesis;
use geneva_documents::meyer::runs::table::rows;
use serde_json::Value;
use std::fs;
use std::io::Write;
use std::process::{Command, Stdio};
use tempfile::TempDir;

const DECK: &str = "\
* a weight falls in a fluid
 CON(G)
 PAR(DRAG)
 DT .5
 V INT(G-DRAG*V,0.)
 WAY INT(V,0.)
 HDR(TIME,SPEED,WAY)
 OUT(T,V,WAY)
 PLO(T,V)
 FIN(T,1.5)
 END
 10.
 0.
 2.
";

/// A folder with a file in it.
fn folder(name: &str, text: &str) -> (TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    fs::write(&path, text).expect("written");
    (folder, path.to_str().expect("UTF-8").to_owned())
}

/// The program with a deck on its standard input.
fn fed(arguments: &[&str], deck: &str) -> (String, String, Option<i32>) {
    let mut command: Command = geneva(arguments);
    let pipes = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = pipes.spawn().expect("it starts");
    child.stdin.take().expect("a pipe").write_all(deck.as_bytes()).expect("written");
    let output = child.wait_with_output().expect("it ends");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    (text(output.stdout), text(output.stderr), output.status.code())
}

#[test]
fn what_is_known_of_the_language_is_listed() {
    pin("mimic-functions", &["mimic", "functions"]);
    pin("mimic-decks", &["mimic", "decks"]);
    pin("mimic-sort", &["mimic", "sort", "escapement"]);
    let deck = stdout(&["mimic", "decks", "oscillator"], 0);
    assert!(deck.contains("INT(ACCEL,V0)"), "{deck}");
}

#[test]
fn a_deck_of_the_project_is_printed_as_a_line_printer_would() {
    pin("mimic-run", &["mimic", "run", "decay"]);
    let (_folder, path) = folder("fall.deck", DECK);
    let page = stdout(&["mimic", "run", &path], 0);
    assert!(page.contains("run 2 of 2") && page.contains("DRAG = 2") && page.contains("* V against T"), "{page}");
}

#[test]
fn json_and_csv_say_the_same_and_all_of_it() {
    let (_folder, path) = folder("fall.deck", DECK);
    let found = json(&["mimic", "run", &path, "--format", "json"]);
    assert_eq!(found.len(), 2);
    assert_eq!(found[0]["parameters"], serde_json::json!({"G": 10.0, "DRAG": 0.0}));
    assert_eq!(found[0]["columns"], serde_json::json!(["T", "V", "WAY"]));
    let row = |run: usize, row: usize| -> Vec<f64> {
        let cells = found[run]["rows"][row].as_array().expect("a row");
        cells.iter().map(|cell| cell.as_f64().expect("a number")).collect()
    };
    assert!((row(0, 3)[2] - 10.0 * 1.5 * 1.5 / 2.0).abs() < 1e-9, "{:?}", row(0, 3));
    assert!((row(1, 3)[1] - 5.0 * (1.0 - libm::exp(-3.0))).abs() < 1e-4, "{:?}", row(1, 3));
    let csv = stdout(&["mimic", "run", &path, "--format", "csv"], 0);
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("run,G,DRAG,T,V,WAY"));
    for (at, line) in lines.enumerate() {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        assert_eq!(cells[0], if at < 4 { 1.0 } else { 2.0 });
        assert_eq!(cells[3..], row(at / 4, at % 4)[..]);
    }
}

#[test]
fn a_plot_is_drawn() {
    for deck in ["predators", "decay", "escapement"] {
        let svg = stdout(&["mimic", "run", deck, "--format", "svg"], 0);
        let document = roxmltree::Document::parse(&svg).expect("well-formed");
        let curves = document.descendants().filter(|node| node.attribute("class") == Some("curve")).count();
        assert_eq!(curves, if deck == "predators" { 1 } else { 2 }, "{deck}");
        assert!(!svg.contains("var(--"));
    }
}

#[test]
fn numbers_come_from_data_cards_from_another_file_and_from_the_command_line() {
    let (folder, path) = folder("fall.deck", DECK);
    let data = folder.path().join("more.cards");
    fs::write(&data, "5.\n1.\n").expect("written");
    let way = |more: &[&str]| {
        let found = json(&[&["mimic", "run", &path, "--format", "json"], more].concat());
        let last = |run: &Value| run["rows"].as_array().and_then(|rows| rows.last()?[1].as_f64()).expect("a number");
        found.iter().map(last).collect::<Vec<_>>()
    };
    assert_eq!(way(&[]).len(), 2);
    assert_eq!(way(&["--data", data.to_str().expect("UTF-8")]).len(), 1);
    assert_eq!(way(&["--set", "DRAG=0", "--set", "G=1"]), [1.5, 1.5]);
    assert_eq!(way(&["--set", "drag=0", "--set", "DT=.25"])[0], 15.0);
    let none = DECK.split(" 10.\n").next().expect("a deck");
    let (text, told, code) = fed(&["mimic", "run", "-", "--set", "G=2", "--set", "DRAG=0", "--format", "csv"], none);
    assert!(code == Some(0) && text.ends_with("1,2.0,0.0,1.5,3.0,2.25\n"), "{text}{told}");
}

#[test]
fn the_runs_of_appendix_e_come_from_the_ledger() {
    let found = json(&["mimic", "run", "escapement", "--runs", "appendix-e", "--format", "json"]);
    assert_eq!(found.len(), rows().len());
    for (run, row) in found.iter().zip(rows()) {
        let numbers: Vec<_> = ["SLOTS", "START", "MU", "TORQUE", "IFOL", "IDRV"]
            .iter()
            .map(|name| run["parameters"][name].as_f64().expect("a number"))
            .collect();
        assert_eq!(numbers, Hypothesis::AS_RUN.data_card(row));
        assert_eq!(run["rows"].as_array().map(Vec::len), Some(401));
    }
    let told = refused(&["mimic", "run", "decay", "--runs", "appendix-e"]);
    assert!(told.contains("the CON and PAR cards of decay ask for 2; give a deck that asks for 6"), "{told}");
}

#[test]
fn a_listing_is_run_out_of_a_longer_text() {
    let text = format!("A thesis.\n\n```\n{DECK}```\n\nIts end.\n");
    let (_folder, path) = folder("thesis.txt", &text);
    let page =
        stdout(&["mimic", "run", "--listing-in", &path, "--set", "DRAG=0", "--set", "G=2", "--format", "csv"], 0);
    assert!(page.ends_with("1,2.0,0.0,1.5,3.0,2.25\n"), "{page}");
    let (_folder, path) = folder("none.txt", "no program here\n");
    let told = refused(&["mimic", "run", "--listing-in", &path]);
    assert!(told.contains("contains no program"), "{told}");
}

#[test]
fn what_is_wrong_is_told_all_at_once_and_nothing_is_run() {
    let wrong = " X COSS(T)\n Y XX+1.\n OUT(X,Y)\n FIN(T,1.)\n END\n";
    for action in ["check", "sort", "run"] {
        let (text, told, code) = fed(&["mimic", action, "-"], wrong);
        assert!(code == Some(2) && text.is_empty(), "{text}");
        assert!(told.contains("card 1, column 4: COSS is not a function; the nearest is COS"), "{told}");
    }
    let (_, told, _) = fed(&["mimic", "check", "-"], &wrong.replace("COSS", "COS"));
    assert!(told.contains("card 2, column 4: no card defines XX; the nearest is X\n     Y XX+1.\n       ^^"), "{told}");
    let (text, _, code) = fed(&["mimic", "check", "-"], DECK);
    assert!(code == Some(0) && text.contains("no mistakes found. 3 statements, 2 integrals"), "{text}");
}

#[test]
fn refusals_name_what_was_asked_and_a_way_out() {
    for (arguments, words) in [
        (
            &["mimic", "run", "no-such-deck"][..],
            "'no-such-deck' is neither a file nor a deck of this project; geneva mimic",
        ),
        (&["mimic", "run", "escapment"], "nor a deck of this project; the nearest is escapement"),
        (&["mimic", "decks", "escapment"], "is not a deck of this project; the nearest is escapement; give one of"),
        (&["mimic", "run", "escapement", "--set", "MUU=.2"], "the nearest is MU; give another name"),
        (&["mimic", "run", "decay", "--set", "DTMX=.2"], "the nearest is DTMAX; give another name"),
        (&["mimic", "run", "-", "--data", "-"], "--data -: standard input already holds the deck"),
        (&["mimic", "decks", "none"], "'none' is not a deck of this project; give one of escapement"),
        (&["mimic", "run", "decay", "--set", "LEFT"], "no = in it; give a name, = and a number"),
        (&["mimic", "run", "decay", "--set", "NONE=2"], "--set NONE=2: no CON or PAR card of decay"),
        (&["mimic", "run", "decay", "--set", "HALF=0"], "decay: card 8 (FIN(T,5.*HALF)): the run would end at T = 0"),
        (&["mimic", "run", "decay", "--set", "=3"], "no name before the =; give a name"),
        (&["mimic", "run", "decay", "--tolerance", "1"], "1 must be below 1; give a fraction of each integral's size"),
        (&["mimic", "run", "vanderpol", "--set", "MU=1e300"], "vanderpol, run 1 of 2: at T = "),
    ] {
        let told = refused(arguments);
        assert!(told.contains(words), "{arguments:?}\n{told}");
    }
}

#[test]
fn data_come_from_standard_input_and_faults_in_them_name_where_they_are() {
    let (text, told, code) = fed(&["mimic", "run", "oscillator", "--data", "-", "--format", "csv"], "1. 0. 1. 0. 2.\n");
    assert!(code == Some(0) && text.contains("\n1,1.0,0.0,1.0,0.0,2.0,0.0,2.0,"), "{text}{told}");
    let (folder, path) = folder("few.cards", "1. 2.\n");
    let told = refused(&["mimic", "run", "oscillator", "--data", &path]);
    assert!(
        told.contains(&format!("{path}, line 1, column 6: no number is left for K")) && !told.contains("END"),
        "{told}"
    );
    drop(folder);
}

#[test]
fn an_answer_takes_the_place_of_nothing_that_is_read() {
    let (folder, path) = folder("fall.deck", DECK);
    let other = folder.path().join(".").join("fall.deck");
    let other = other.to_str().expect("UTF-8");
    for arguments in [
        &["mimic", "run", &path, "--output", other][..],
        &["mimic", "check", other, "--output", &path],
        &["mimic", "sort", &path, "--output", &path],
        &["mimic", "run", "--listing-in", &path, "--output", &path],
        &["mimic", "run", "decay", "--data", &path, "--output", &path],
    ] {
        let told = refused(arguments);
        assert!(told.contains("would overwrite") && told.contains("give another file"), "{arguments:?}\n{told}");
    }
    assert_eq!(fs::read_to_string(&path).expect("it is there"), DECK);
    let new = folder.path().join("new");
    stdout(&["mimic", "run", &path, "--output", new.to_str().expect("UTF-8")], 0);
    assert!(new.exists());
}

#[test]
fn a_full_standard_output_is_named() {
    let Ok(full) = fs::File::options().write(true).open("/dev/full") else { return };
    let output = geneva(&["mimic", "functions"]).stdout(full).output().expect("the program runs");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && told.contains("cannot write to standard output: "), "{told}");
}

#[test]
fn a_byte_order_mark_is_no_sign() {
    let text = format!("\u{feff}{DECK}");
    let (_folder, path) = folder("fall.deck", &text);
    let usual = fed(&["mimic", "run", "-", "--format", "csv"], DECK).0;
    assert_eq!(stdout(&["mimic", "run", &path, "--format", "csv"], 0), usual);
    assert_eq!(fed(&["mimic", "run", "-", "--format", "csv"], &text).0, usual);
    assert_eq!(
        stdout(&["mimic", "run", "--listing-in", &path, "--format", "csv", "--set", "G=10", "--set", "DRAG=0"], 0)
            .lines()
            .count(),
        5
    );
}

#[test]
fn a_drawing_needs_two_points_and_two_names() {
    for (deck, words) in [
        (" A 1.\n OUT(T,A)\n FIN(A,-1.)\n END\n", "only one point is printed, because FIN is true from the start"),
        (" OUT(T)\n FIN(T,1.)\n END\n", "only T is printed; give the OUT card a second name"),
    ] {
        let (_, told, code) = fed(&["mimic", "run", "-", "--format", "svg"], deck);
        assert!(code == Some(2) && told.contains(words), "{told}");
    }
}

#[test]
fn a_check_reads_the_data_cards_too() {
    let (_, told, code) = fed(&["mimic", "check", "-"], &DECK.replace(" 2.\n", " 2. zz\n"));
    assert!(code == Some(2) && told.contains("not a number, and everything after END is data"), "{told}");
}

#[test]
fn the_help_names_the_keys_of_json() {
    let help = stdout(&["mimic", "run", "--help"], 0);
    let help: String = help.split_whitespace().collect::<Vec<_>>().join(" ");
    let found = json(&["mimic", "run", "delayed", "--format", "json"]);
    for key in found[0].as_object().expect("an object").keys() {
        assert!(help.contains(key.as_str()), "{key}: {help}");
    }
    assert_eq!(found[0]["steps_longer_than_delay"], 0);
}
