//! Does the program `geneva` say what the ledger says, and does it behave as a program should?
//!
//! What a page looks like is pinned under `snapshots/command-line`; what must hold whatever it looks like is asserted. The
//! program itself runs, with its output in a pipe, for each pinned page and wherever a process may behave otherwise than its
//! library: streams, signals, files, threads. All other lines are asked of the library, and a test compares the two.

mod book_command;
mod documents_command;
mod escapement_command;
mod limits_command;
mod mimic_command;
mod new_command;
mod pin_command;
mod pipes_command;
mod quick_return_command;
mod sweep_command;
mod terminal_command;
mod values_command;
mod wheel_command;

use geneva_cli::CommandOutput;
use geneva_documents::LEDGER;
use geneva_evidence::without_ellipses;
use geneva_figures::Figure;
use insta_cmd::assert_cmd_snapshot;
use serde_json::{Map, Value};
use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The program, whatever the terminal and the settings of whoever runs the test.
fn geneva(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_geneva"));
    command.args(arguments);
    for variable in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "COLUMNS"] {
        command.env_remove(variable);
    }
    command
}

/// Pins standard output, standard error and exit code under a name.
#[track_caller]
fn pin(name: &str, arguments: &[&str]) {
    settings().bind(|| assert_cmd_snapshot!(name, geneva(arguments)));
}

/// Pins the same of what the library answers: for pages that need every verdict, which each process derives anew.
#[track_caller]
fn pin_answer(name: &str, arguments: &[&str]) {
    settings().bind(|| insta::assert_snapshot!(name, page_of(&answered(arguments))));
}

/// What is pinned of a process.
fn page_of(CommandOutput { stdout, stderr, code }: &CommandOutput) -> String {
    let success = *code == 0;
    format!("success: {success}\nexit_code: {code}\n----- stdout -----\n{stdout}\n----- stderr -----\n{stderr}")
}

/// Waits for what another process does, however busy the machine is.
#[track_caller]
fn until(awaited: &str, mut is_there: impl FnMut() -> bool) {
    let end = Instant::now() + Duration::from_secs(600);
    while !is_there() {
        assert!(Instant::now() < end, "{awaited} never came");
        sleep(Duration::from_millis(1));
    }
}

/// What the process `geneva errata` writes, with its exit code: it derives every verdict, so it runs once for all tests that
/// look at it.
fn errata() -> &'static CommandOutput {
    static ERRATA: OnceLock<CommandOutput> = OnceLock::new();
    ERRATA.get_or_init(|| {
        let Output { status, stdout, stderr } = run(&["errata"]);
        let [stdout, stderr] = [stdout, stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
        let code = status.code().and_then(|code| code.try_into().ok()).expect("an exit code");
        CommandOutput { stdout, stderr, code }
    })
}

/// A path inside of the workspace.
fn path(inside: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("crates/geneva is in it").join(inside)
}

fn settings() -> insta::Settings {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(path("snapshots/command-line"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings
}

#[track_caller]
fn run(arguments: &[&str]) -> Output {
    geneva(arguments).output().expect("the program runs")
}

/// Standard output of a process that exits with `code`.
#[track_caller]
fn written(arguments: &[&str], code: i32) -> String {
    let output = run(arguments);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {output:?}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// What the program's library answers to a line. Claims that one test has asked for are not judged again for another.
fn answered(arguments: &[&str]) -> CommandOutput {
    geneva_cli::answer(["geneva"].iter().chain(arguments).map(OsString::from))
}

/// What goes to standard output for a line with this exit code.
#[track_caller]
fn stdout(arguments: &[&str], code: u8) -> String {
    let answer = answered(arguments);
    assert_eq!(answer.code, code, "{arguments:?}: {answer:?}");
    answer.stdout
}

/// What goes to standard error for a line with exit code 2, for which nothing else is said.
#[track_caller]
fn refused(arguments: &[&str]) -> String {
    let answer = answered(arguments);
    assert_eq!(answer.code, 2, "{arguments:?}: {answer:?}");
    assert!(answer.stdout.is_empty(), "{arguments:?}: {answer:?}");
    answer.stderr
}

/// Standard error of a process that fails with exit code 2 and has said nothing else.
#[track_caller]
fn refusal(mut command: Command) -> String {
    let output = command.output().expect("the program runs");
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(output.stdout.is_empty(), "{output:?}");
    String::from_utf8(output.stderr).expect("UTF-8")
}

fn json(arguments: &[&str]) -> Vec<Value> {
    serde_json::from_str(&stdout(arguments, 0)).expect("an array")
}

/// The object that the program writes for these arguments.
#[track_caller]
fn object(arguments: &[&str]) -> Map<String, Value> {
    serde_json::from_str(&stdout(&[arguments, &["--format", "json"]].concat(), 0)).expect("an object")
}

#[track_caller]
fn number(object: &Map<String, Value>, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("{key} is {}", object[key]))
}

/// What the ledger finds right about a claim that is a number.
#[track_caller]
fn right(id: &str) -> f64 {
    let judged =
        LEDGER.verdicts().iter().find(|judged| judged.claim.id == id).unwrap_or_else(|| panic!("no claim {id}"));
    judged.right_value.or(judged.computed).unwrap_or_else(|| panic!("{id} is no number"))
}

/// The number on a line of a sheet, and the rest of the line.
#[track_caller]
fn on_sheet(line: &str) -> f64 {
    line.split_whitespace().next().and_then(|word| word.replace('−', "-").parse().ok()).expect("a number")
}

/// Nothing on a sheet is wider than a line, and nothing but text goes into a pipe.
#[track_caller]
fn assert_is_plain(sheet: &str) {
    for line in sheet.lines() {
        assert!(line.chars().count() <= 100, "{line}");
        assert_eq!(line.trim_end(), line);
        assert!(!line.contains('\u{1b}'), "{line}");
    }
}

/// A drawing that the program writes has the paths of the figure, and needs no page around it.
#[track_caller]
fn assert_is_drawn(arguments: &[&str], figure: &Figure) {
    let svg = stdout(&[arguments, &["--format", "svg"]].concat(), 0);
    assert!(!svg.contains("var("), "a colour that only a browser understands");
    let drawn = roxmltree::Document::parse(&svg).expect("XML");
    let expected = roxmltree::Document::parse(&figure.svg).expect("XML");
    assert!(drawn.root_element().has_tag_name(("http://www.w3.org/2000/svg", "svg")));
    let paths = |document: &roxmltree::Document| -> Vec<String> {
        document.descendants().filter_map(|node| node.attribute("d")).map(str::to_owned).collect()
    };
    assert_eq!(paths(&drawn), paths(&expected), "{arguments:?}: {}", figure.id);
}

/// Whether a signal is ignored here, as `INT` is in what a shell runs in the background: children ignore it too.
fn is_ignored(signal: i32) -> bool {
    is_ignored_by(std::process::id(), signal)
}

/// Whether a signal is ignored by this process.
fn is_ignored_by(process: u32, signal: i32) -> bool {
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let ignored = status.lines().find_map(|line| u64::from_str_radix(line.strip_prefix("SigIgn:")?.trim(), 16).ok());
    ignored.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

/// A workspace with a book of one chapter.
fn small_workspace() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for inside in ["book/src", "crates/documents"] {
        fs::create_dir_all(folder.path().join(inside)).expect("writable");
    }
    for (file, text) in [
        ("crates/documents/Cargo.toml", ""),
        ("book/book.toml", "[book]\ntitle = \"Small\"\n[build]\ncreate-missing = false\n"),
        ("book/src/SUMMARY.md", "- [Only](only.md)\n"),
        ("book/src/only.md", "# Only\n\nA chapter.\n"),
    ] {
        fs::write(folder.path().join(file), text).expect("writable");
    }
    folder
}

#[test]
fn every_command_explains_itself_with_an_example() {
    for (name, arguments) in [
        ("help", &["--help"][..]),
        ("help-claims", &["claims", "--help"]),
        ("help-errata", &["errata", "--help"]),
        ("help-coverage", &["coverage", "--help"]),
        ("help-wheel", &["wheel", "--help"]),
        ("help-quick-return", &["quick-return", "--help"]),
        ("help-escapement", &["escapement", "--help"]),
        ("help-sweep", &["sweep", "--help"]),
        ("help-proofread", &["proofread", "--help"]),
        ("help-record", &["record", "--help"]),
        ("help-check", &["check", "--help"]),
        ("help-new", &["new", "--help"]),
        ("help-book", &["book", "--help"]),
        ("help-book-build", &["book", "build", "--help"]),
        ("help-book-print", &["book", "print", "--help"]),
        ("help-book-epub", &["book", "epub", "--help"]),
        ("help-book-test", &["book", "test", "--help"]),
        ("help-completions", &["completions", "--help"]),
        ("help-preprocess", &["preprocess", "--help"]),
    ] {
        assert!(stdout(arguments, 0).contains("Example"), "{name}");
        pin(name, arguments);
    }
}

#[test]
fn the_program_writes_what_its_library_answers() {
    let escapement =
        ["--friction", "0.3", "--torque", "2", "--driver-inertia", "1", "--follower-inertia", "15", "--slots"];
    let escapement = |more: &[&'static str]| [&["escapement"], &escapement[..], more].concat();
    let quick_return = ["quick-return", "--ground", "0.3", "--crank", "0.1", "--crank-angle", "75", "--rpm", "60"];
    let size = ["--crank-radius", "50"];
    for line in [
        vec!["--version"],
        vec!["wheel", "--help"],
        vec!["clams"],
        vec!["claims", "--source", "jazar"],
        vec!["claims", "--source", "pin", "--format", "json"],
        vec!["claims", "--source", "quick-return", "--format", "csv"],
        vec!["errata", "--source", "jazar", "--format", "markdown"],
        vec!["errata", "--source", "pin", "--format", "json"],
        vec!["errata", "--source", "quick-return", "--all", "--format", "csv"],
        vec!["coverage"],
        vec!["coverage", "--source", "pin", "--against", "no/such/copy.txt"],
        vec!["wheel", "--stations", "6", "--rpm", "360"],
        [&["wheel", "--stations", "6", "--format", "dxf"], &size[..]].concat(),
        [&["wheel", "--stations", "6", "--format", "csv"], &size[..]].concat(),
        vec!["wheel", "--stations", "2"],
        vec!["wheel", "--stations", "\u{1b}[31m6"],
        quick_return.to_vec(),
        [&quick_return[..], &["--format", "svg"]].concat(),
        [&quick_return[..], &["--branch", "near"]].concat(),
        escapement(&["4"]),
        escapement(&["6", "--format", "json"]),
        escapement(&["3", "--format", "csv"]),
        escapement(&["5"]),
        vec!["sweep", "--slots", "4", "--friction", "-1", "--inertia-ratio", "1"],
        vec!["mimic", "decks"],
        vec!["mimic", "run", "decay"],
        vec!["mimic", "run", "decay", "--set", "N"],
        vec!["completions", "fish"],
        vec!["preprocess", "supports", "latex"],
        vec!["book", "build", "--output", "/"],
    ] {
        let (output, answer) = (run(&line), answered(&line));
        assert_eq!(output.status.code(), Some(answer.code.into()), "{line:?}: {output:?}");
        assert_eq!(String::from_utf8_lossy(&output.stdout), answer.stdout, "{line:?}");
        assert_eq!(String::from_utf8_lossy(&output.stderr), answer.stderr, "{line:?}");
    }
}

#[cfg(unix)]
#[test]
fn without_a_text_on_standard_input_nothing_counts_as_checked() {
    let program = geneva(&[]).get_program().to_owned();
    let shell = |line: &str| {
        let output = Command::new("sh").args(["-c", line]).env("GENEVA", &program).output().expect("a shell");
        let words = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
        (output.status.code(), words)
    };
    for (line, code, words) in [
        ("\"$GENEVA\" proofread - <&-", 2, "standard input is closed or empty, so there is no text to check"),
        ("\"$GENEVA\" proofread - </dev/null", 2, "pipe a text into it, or give files"),
        ("\"$GENEVA\" proofread --input jsonl - </dev/null", 2, "standard input is closed or empty"),
        ("echo | \"$GENEVA\" proofread -", 0, "Nothing found."),
        ("echo '$2+2=5$' | \"$GENEVA\" proofread -", 1, "1 finding: 1 on a number."),
    ] {
        let (answered, said) = shell(line);
        assert!(answered == Some(code) && said.contains(words), "{line}: {answered:?} {said}");
    }
}

#[test]
fn the_version_is_that_of_the_workspace() {
    let page = stdout(&["--version"], 0);
    assert!(page.starts_with(concat!("geneva ", env!("CARGO_PKG_VERSION"))), "{page}");
    // What it says of a folder depends on the folder.
    let elsewhere = tempfile::tempdir().expect("a temporary folder");
    let output = geneva(&["--version"]).current_dir(elsewhere.path()).output().expect("the program runs");
    let page = String::from_utf8(output.stdout).expect("UTF-8");
    let says = |words: &str| page.contains(words);
    assert!(says(", commit ") != says("is not recorded in it") && !says("The project in"), "{page}");
}

#[test]
fn claims_are_listed_by_source_and_by_verdict() {
    pin("claims-of-pin", &["claims", "--source", "pin"]);
    pin("claims-of-pin-corrected", &["claims", "--source", "pin", "--verdict", "corrected"]);
    pin("claims-of-pin-from-rounded-json", &claims_of_pin("from-rounded", "json"));
    let open = ["claims", "--source", "quick-return", "--verdict", "not-reproducible", "--format", "json"];
    pin("claims-of-quick-return-not-reproducible-json", &open);
    pin("claims-of-pin-corrected-csv", &claims_of_pin("corrected", "csv"));
    pin("claims-none", &claims_of_pin("read-off", "text"));
}

fn claims_of_pin<'a>(verdict: &'a str, format: &'a str) -> [&'a str; 7] {
    ["claims", "--source", "pin", "--verdict", verdict, "--format", format]
}

#[test]
fn a_line_of_claims_is_at_most_100_characters_long() {
    // An address stays in one piece.
    for line in stdout(&["claims"], 0).lines().filter(|line| !line.starts_with("wild, http")) {
        assert!(line.chars().count() <= 100, "{line}");
    }
}

#[test]
fn json_says_what_the_ledger_says() {
    let rows = json(&["claims", "--format", "json"]);
    assert_eq!(rows.len(), LEDGER.claims().len());
    for (row, judged) in rows.iter().zip(LEDGER.verdicts()) {
        let id = judged.claim.id;
        assert_eq!((&row["id"], &row["verdict"]), (&id.into(), &judged.verdict.slug().into()));
        assert_eq!(row["printed"], without_ellipses(judged.claim), "{id}");
        for (key, value) in [("computed", judged.computed), ("right_value", judged.right_value)] {
            assert_eq!(row[key].as_f64().map(f64::to_bits), value.map(f64::to_bits), "{id} {key}");
        }
        let erratum = judged.claim.erratum.as_ref();
        assert_eq!(row["slip"].as_str(), erratum.map(|erratum| erratum.slip.id), "{id}");
        assert_eq!(row["erratum"]["reason"].as_str(), erratum.map(|erratum| erratum.slip.reason), "{id}");
    }
}

/// What a cell says of a value: numbers with all their digits, lists joined, objects in cells of their own.
fn in_a_cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Array(values) => values.iter().map(in_a_cell).collect::<Vec<_>>().join("; "),
        Value::Object(finding) => {
            let holds = if finding["holds"] == true { "holds" } else { "fails" };
            format!("{} {holds}: {}", in_a_cell(&finding["form"]), in_a_cell(&finding["how"]))
        }
        other => other.to_string(),
    }
}

#[test]
fn csv_has_a_row_for_each_claim_and_each_slip_and_says_what_json_says() {
    for command in [&["claims"][..], &["errata", "--all"]] {
        let text = stdout(&[command, &["--format", "csv"]].concat(), 0);
        let objects = json(&[command, &["--format", "json"]].concat());
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let columns = reader.headers().expect("a header").clone();
        let rows: Vec<_> = reader.records().map(|row| row.expect("as many cells as columns")).collect();
        assert_eq!(rows.len(), objects.len());
        for (row, object) in rows.iter().zip(&objects) {
            for (column, cell) in columns.iter().zip(row) {
                let value = match column.strip_prefix("erratum_") {
                    Some(inner) => &object["erratum"][inner],
                    None => &object[column],
                };
                assert_eq!(cell, in_a_cell(value), "{} {column}", object["id"]);
            }
        }
        for key in objects[0].as_object().expect("an object").keys().filter(|key| *key != "erratum") {
            assert!(columns.iter().any(|column| column == key), "no column for {key}");
        }
    }
}

#[test]
fn an_answer_goes_into_a_file_if_one_is_named() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("answer");
    for arguments in [
        &["claims", "--source", "pin"][..],
        &["wheel", "--stations", "6", "--format", "svg"],
        &["quick-return", "--ground", "0.3", "--crank", "0.1", "--crank-angle", "75", "--rpm", "60"],
        &[
            "escapement",
            "--slots",
            "4",
            "--friction",
            "0.3",
            "--torque",
            "2",
            "--driver-inertia",
            "1",
            "--follower-inertia",
            "15",
        ],
    ] {
        let mut command = geneva(arguments);
        // In a file there are no colours, whatever is asked of a terminal.
        command.env("CLICOLOR_FORCE", "1").args(["--output", &file.to_string_lossy()]);
        let output = command.output().expect("the program runs");
        assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty(), "{output:?}");
        assert_eq!(fs::read_to_string(&file).expect("it is there"), stdout(arguments, 0), "{arguments:?}");
    }
    let said = refusal(geneva(&["wheel", "--stations", "6", "--output", "no/such/folder/wheel"]));
    assert!(said.contains("cannot write") && said.contains("give "), "{said}");
}

#[test]
fn the_errata_are_those_of_the_ledger() {
    settings().bind(|| insta::assert_snapshot!("errata", page_of(errata())));
    pin_answer("errata-json", &["errata", "--format", "json"]);
    pin_answer("errata-markdown", &["errata", "--format", "markdown"]);
    pin("errata-of-jazar-with-copies", &["errata", "--source", "jazar", "--all"]);
}

#[test]
fn every_place_of_a_slip_is_listed_with_it() {
    for row in json(&["errata", "--all", "--format", "json"]) {
        let places: Vec<_> = row["places"].as_array().expect("places").iter().filter_map(Value::as_str).collect();
        let of = |claim: &&geneva_evidence::Claim| claim.erratum.is_some_and(|erratum| erratum.slip.id == row["id"]);
        assert_eq!(places.len(), LEDGER.claims().iter().copied().filter(of).count(), "{}", row["id"]);
        assert_eq!(row["id"], places[0]);
    }
}

#[test]
fn a_wrong_name_is_answered_with_the_nearest() {
    pin("wrong-source", &["claims", "--source", "pim"]);
    pin("wrong-verdict", &["claims", "--verdict", "reproducd"]);
    pin("wrong-format", &["errata", "--format", "markdwon"]);
    pin("wrong-command", &["clams"]);
    pin("wrong-shell", &["completions", "bosh"]);
    pin("wrong-option", &["book", "test", "--out", "elsewhere"]);
    pin("copy-of-no-source", &["coverage", "--against", "copy.txt"]);
}

#[test]
fn coverage_accounts_for_every_line() {
    pin("coverage-of-pin", &["coverage", "--source", "pin"]);
}

#[test]
fn a_copy_with_other_numbers_differs() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("copy.txt"), "One line with 10 and 2.\nNo number.\n").expect("writable");
    let mut command = geneva(&["coverage", "--source", "pin", "--against", "copy.txt"]);
    command.current_dir(folder.path());
    settings().bind(|| assert_cmd_snapshot!("coverage-of-another-text", command));
}

#[test]
fn a_copy_that_cannot_be_read_is_named() {
    let said = refusal(geneva(&["coverage", "--source", "pin", "--against", "no/such/copy.txt"]));
    assert!(said.starts_with("error: cannot read no/such/copy.txt: "), "{said}");
    assert!(said.ends_with("; give --against a text file with your copy of pin\n"), "{said}");
    let said = refusal(geneva(&["coverage", "--source", "pin", "--record", "no/such/copy.txt"]));
    assert!(said.ends_with("; give --record a text file with your copy of pin\n"), "{said}");
}

#[test]
fn a_copy_with_other_numbers_is_recorded_for_the_entries_to_be_filled_in() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("copy.txt"), "One line with 10 and 2.\nNo number.\n").expect("writable");
    let mut command = geneva(&["coverage", "--source", "pin", "--record", "copy.txt"]);
    command.current_dir(folder.path());
    settings().bind(|| assert_cmd_snapshot!("coverage-recorded", command));
}

#[test]
fn without_arguments_the_verdicts_are_summed_up_and_the_book_is_built() {
    let workspace = small_workspace();
    let leads_to_data = "# Only\n\nEvery [claim](data/claims.json).\n";
    fs::write(workspace.path().join("book/src/only.md"), leads_to_data).expect("writable");
    let mut command = geneva(&[]);
    let output = command.current_dir(workspace.path()).output().expect("the program runs");
    let code = if LEDGER.verdicts().iter().all(|judged| judged.matches_record()) { 0 } else { 1 };
    assert_eq!(output.status.code(), Some(code), "{output:?}");
    assert!(output.stderr.is_empty(), "no progress is shown in a pipe: {output:?}");
    for file in ["index.html", "data/claims.json"] {
        assert!(workspace.path().join("target/book").join(file).is_file(), "{file}");
    }
    let here = workspace.path().canonicalize().expect("it exists");
    let page = String::from_utf8(output.stdout).expect("UTF-8").replace(&*here.to_string_lossy(), "[workspace]");
    settings().bind(|| insta::assert_snapshot!("summary", page));
}

#[test]
fn mdbook_is_told_that_every_renderer_gets_an_answer() {
    // mdBook leaves out in silence whoever says no.
    for renderer in ["html", "test", "latex", "epub", "-90"] {
        assert_eq!(stdout(&["preprocess", "supports", renderer], 0), "", "{renderer}");
    }
}

#[test]
fn mdbook_gets_a_book_for_a_book() {
    let mut output = piped(
        r##"[{"root": "", "config": {"book": {}}, "renderer": "html", "mdbook_version": "0.5.0"},
            {"items": [{"Chapter": {"name": "Only", "content": "# Only\n", "number": [1], "sub_items": [],
             "path": "only.md", "source_path": "only.md", "parent_names": []}}]}]"##,
    );
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
    let book: Value = serde_json::from_slice(&output.stdout).expect("JSON and nothing else");
    assert_eq!(book["items"][0]["Chapter"]["name"], "Only");

    output = piped("no book");
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty() && String::from_utf8_lossy(&output.stderr).contains("geneva book"), "{output:?}");
}

/// A run as mdBook's preprocessor.
fn piped(input: &str) -> Output {
    piped_into(geneva(&["preprocess"]), input)
}

/// A run of a command with this on its standard input.
fn piped_into(mut command: Command, input: &str) -> Output {
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program runs");
    child.stdin.take().expect("a pipe").write_all(input.as_bytes()).expect("it reads");
    child.wait_with_output().expect("it ends")
}

#[test]
fn every_shell_gets_completions() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = stdout(&["completions", shell], 0);
        for word in ["geneva", "claims", "quick-return", "lever-angle", "branch", "acceleration"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
}
