//! The command: its output in each form, accepted cases, changes, and exit codes.

use clap::{Args, FromArgMatches};
use proofread::cli::{self, CommandStreams};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

fn arguments(line: &[&str]) -> cli::ProofreadArguments {
    let command = cli::ProofreadArguments::augment_args(clap::Command::new("proofread"));
    let matches = command.try_get_matches_from(line).expect("a command line");
    cli::ProofreadArguments::from_arg_matches(&matches).expect("a command line")
}

#[derive(Default)]
struct CapturedStreams {
    out: String,
    told: String,
}

impl CommandStreams for CapturedStreams {
    fn print(&mut self, text: &str) -> Result<(), String> {
        self.out += &anstream::adapter::strip_str(text).to_string();
        Ok(())
    }

    fn print_error(&mut self, text: &str) {
        self.told += &anstream::adapter::strip_str(text).to_string();
    }
}

/// Exit code, standard output and standard error.
pub(crate) fn run(line: &[&str]) -> (u8, String, String) {
    let mut kept = CapturedStreams::default();
    let code = cli::run(&arguments(&[&["proofread"], line].concat()), &mut kept);
    (code, kept.out, kept.told)
}

const TEXT: &str = "The speed is $43.4 - 29.8 = 13.8\\ \\mathrm{km/s}$.\n\nIt is $\\tan 31.0^\\circ = 0.609$.\n";

fn folder() -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.md");
    fs::write(&file, TEXT).expect("written");
    let name = file.to_str().expect("UTF-8").to_owned();
    (folder, name)
}

#[test]
fn a_person_sees_the_place_the_numbers_and_the_hint() {
    let (_folder, file) = folder();
    let (code, out, told) = run(&[&file]);
    assert_eq!((code, told.as_str()), (1, ""));
    for line in [
        "last-digit: the last digit differs".to_owned(),
        format!(" --> {file}:1:29"),
        "  |                             ^^^^^^^^^^^^^^^^^^ printed 13.8 km/s, recomputed 13.6 km/s".to_owned(),
        format!(" --> {file}:3:26"),
        "  = hint: `0.601` for `0.609` would agree".to_owned(),
        "Checked 2 chains of 2 chains that arithmetic can check, in 2 formulas or lines and 1 document.".to_owned(),
        "2 findings: 2 on a number.".to_owned(),
    ] {
        assert!(out.lines().any(|of| of == line), "{line}\nis not in\n{out}");
    }
}

/// Whether a value is as the schema says: a few words of JSON Schema are enough for ours.
fn fits(value: &Value, schema: &Value, root: &Value, at: &str) {
    if let Some(name) = schema["$ref"].as_str() {
        let name = name.strip_prefix("#/$defs/").expect("a definition");
        return fits(value, &root["$defs"][name], root, at);
    }
    if let Some(allowed) = schema["enum"].as_array() {
        assert!(allowed.contains(value), "{at}: {value} is none of {allowed:?}");
    }
    let kinds: Vec<&str> = match &schema["type"] {
        Value::String(kind) => vec![kind],
        Value::Array(kinds) => kinds.iter().filter_map(Value::as_str).collect(),
        _ => Vec::new(),
    };
    let kind = match value {
        Value::Null => "null",
        Value::Bool(_) => "boolean",
        Value::Number(number) if number.is_f64() || !kinds.contains(&"integer") => "number",
        Value::Number(_) => "integer",
        Value::String(_) => "string",
        Value::Array(_) => "array",
        Value::Object(_) => "object",
    };
    assert!(kinds.contains(&kind), "{at}: {kind} is none of {kinds:?}");
    for (key, inner) in value.as_object().into_iter().flatten() {
        let schema = &schema["properties"][key];
        assert!(!schema.is_null(), "{at}: the schema does not know {key}");
        fits(inner, schema, root, &format!("{at}.{key}"));
    }
    for key in schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str) {
        assert!(value.get(key).is_some(), "{at} lacks {key}");
    }
    for inner in value.as_array().into_iter().flatten() {
        fits(inner, &schema["items"], root, &format!("{at}[]"));
    }
}

fn schema() -> Value {
    serde_json::from_str(include_str!("../schema/proofread.schema.json")).expect("a schema")
}

/// Asserts that a whole report is as the schema says.
pub(crate) fn fits_schema(whole: &Value) {
    let schema = schema();
    fits(whole, &schema, &schema, "whole");
}

#[test]
fn json_is_as_the_schema_says() {
    let schema = schema();
    let (_folder, file) = folder();
    let (code, out, _) = run(&["--format", "json", "--agreeing", "--unchecked", &file]);
    let whole: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(code, 1);
    fits(&whole, &schema, &schema, "whole");
    let first = &whole["documents"][0]["findings"][0];
    assert_eq!(first["verdict"], "last-digit");
    assert_eq!(first["recomputed"], "13.6 km/s");
    assert_eq!(first["at"]["start"]["column"], 29);
    assert!(whole["documents"][0]["unchecked"].is_array());
    let (_, lines, _) = run(&["--format", "jsonl", &file]);
    for line in lines.lines() {
        fits(&serde_json::from_str(line).expect("JSON"), &schema["$defs"]["line"], &schema, "line");
    }
    assert_eq!(lines.lines().count(), 2);
}

#[test]
fn what_is_not_checked_is_summed_up_and_listed_on_request() {
    let (_folder, file) = folder();
    fs::write(&file, "$2 + 2 = 4$, $\\foo{7} = 36$, $2x = 3y$\n\n~~~python\nx = 1\n~~~\n").expect("written");
    let (code, out, _) = run(&[&file]);
    assert_eq!(code, 0);
    for line in [
        "Checked 1 chain of 2 chains that arithmetic can check, in 3 formulas or lines and 1 document.",
        "Not checked: 1 chain with `\\foo`, 1 with letters. --unchecked lists them.",
        "Not read, with an equals sign and a digit: 1 fence of `python`.",
    ] {
        assert!(out.lines().any(|of| of == line), "{line}\nis not in\n{out}");
    }
    let (code, out, _) = run(&["--unchecked", &file]);
    assert_eq!(code, 0);
    assert!(
        out.contains(&format!("not checked: `\\foo` is not known\n --> {file}:1:15\n  = \\foo{{7}} = 36\n")),
        "{out}"
    );
    assert!(out.contains("not checked: the letter x has no value\n"), "{out}");
    let aside = Path::new(&file).with_file_name("b.md");
    fs::write(&aside, "$1 = 0.08$").expect("written");
    let (code, told, _) = run(&["--unchecked", aside.to_str().expect("UTF-8")]);
    assert!(
        code == 0 && told.contains("not checked: set aside, since a number may be part of something else"),
        "{told}"
    );
    let (_, lines, _) = run(&["--unchecked", "--format", "jsonl", &file]);
    let first: Value = serde_json::from_str(lines.lines().next().expect("a line")).expect("JSON");
    let document = &first["document"];
    assert_eq!(document["unchecked"][0]["reason"], "`\\foo` is not known");
    assert_eq!(document["unchecked"][0]["chain_at"]["start"]["column"], 15);
    assert_eq!(document["not_checked"][0], serde_json::json!({ "kind": "command", "name": "\\foo", "count": 1 }));
    assert_eq!(document["not_read"][0], serde_json::json!({ "kind": "fence", "name": "python", "count": 1 }));
}

#[test]
fn files_that_are_not_read_are_counted_and_missing_ones_are_told() {
    let (folder, _) = folder();
    for name in ["a.rst", "b.RST", "c.pptx", "d.png", "sub.org"] {
        fs::write(folder.path().join(name), "1 + 1 = 3").expect("written");
    }
    let place = folder.path().to_str().expect("UTF-8");
    let (_, out, _) = run(&[place]);
    let line = "Not read: 2 files of `.rst`, 1 file of `.org`, 1 file of `.pptx`.";
    assert!(out.lines().any(|of| of == line), "{out}");
    for missing in [format!("{place}/b.md"), format!("{place}/chapters"), format!("{place}/chapters/")] {
        let (code, _, told) = run(&[&missing]);
        assert_eq!(code, 2);
        assert!(told.contains("No such file or directory"), "{told}");
    }
    fs::remove_file(folder.path().join("a.md")).expect("removed");
    let (code, _, told) = run(&[place]);
    assert_eq!(code, 2);
    assert!(told.contains("4 have formats that are not read"), "{told}");
}

#[test]
fn accepted_cases_are_left_out_wherever_they_move() {
    let (folder, file) = folder();
    let cases = folder.path().join("accepted.jsonl");
    let cases = cases.to_str().expect("UTF-8");
    assert_eq!(run(&["--accept", cases, &file]).0, 0);
    fs::write(&file, format!("More.\n\n{TEXT}\n$2 + 2 = 5$\n")).expect("written");
    let (code, out, _) = run(&["--baseline", cases, &file]);
    assert_eq!(code, 1);
    assert!(out.contains("1 finding:") && out.contains("2 cases left out as accepted"), "{out}");
    // A reason that a person wrote stays.
    let told =
        fs::read_to_string(cases).expect("readable").replacen("\"why\":\"\"", "\"why\":\"as in the original\"", 1);
    fs::write(cases, told).expect("written");
    assert_eq!(run(&["--accept", cases, &file]).0, 0);
    let kept = fs::read_to_string(cases).expect("readable");
    assert_eq!((kept.lines().count(), kept.contains("as in the original")), (3, true));
    assert_eq!(run(&["--baseline", cases, &file]).0, 0);
    // The cases lie in the folder themselves, and are no document.
    let (code, out, told) = run(&["--accept", cases, folder.path().to_str().expect("UTF-8")]);
    assert_eq!((code, out.as_str()), (0, ""), "{told}");
    let name = folder.path().to_str().expect("UTF-8");
    assert_eq!(run(&["--baseline", cases, name]).0, 0);
    // A file has one name, however it was reached.
    let other = format!("{name}/./{}", Path::new(&file).file_name().and_then(|name| name.to_str()).expect("a name"));
    assert_eq!(run(&["--baseline", cases, &other]).0, 0);
    // Nor are they a document where nobody says what they are, but other lines of JSON are.
    let (code, _, told) = run(&[name]);
    assert_eq!((code, told.as_str()), (1, ""));
    fs::write(folder.path().join("more.jsonl"), "{\"case\": 1, \"file\": 2}\n").expect("written");
    let (code, _, told) = run(&[name]);
    assert!(code == 2 && told.contains("the object needs `text`"), "{told}");
}

#[test]
fn nothing_is_summed_up_where_nothing_was_read() {
    let (code, out, told) = run(&["there-is-no-such-file.md"]);
    assert_eq!((code, out.as_str()), (2, ""), "{told}");
}

pub(crate) fn git(folder: &Path, arguments: &[&str]) -> bool {
    let identity = ["-c", "user.name=T", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false"];
    let done = Command::new("git").arg("-C").arg(folder).args(identity).args(arguments).output();
    done.is_ok_and(|output| output.status.success())
}

#[test]
fn only_what_a_change_brings_in_is_reported() {
    let (folder, file) = folder();
    if !git(folder.path(), &["init", "-q"]) {
        println!("skipped: there is no git here");
        return;
    }
    assert!(git(folder.path(), &["add", "."]) && git(folder.path(), &["commit", "-q", "-m", "first"]));
    let name = folder.path().to_str().expect("UTF-8");
    assert_eq!(run(&["--since", "HEAD", name]).0, 0);
    fs::write(&file, format!("Moved.\n\n{TEXT}\nNew: $2 + 2 = 5$\n")).expect("written");
    fs::write(folder.path().join("new.md"), "$1 + 1 = 3$").expect("written");
    let (code, out, _) = run(&["--since", "HEAD", name]);
    assert_eq!(code, 1);
    assert!(out.contains("2 findings:") && out.contains("New: $2 + 2 = 5$"), "{out}");
    let (code, _, told) = run(&["--since", "nowhere", name]);
    assert_eq!(code, 2);
    assert!(told.contains("does not know the revision `nowhere`"), "{told}");
}

#[test]
fn wrong_input_is_told_and_the_rest_is_read() {
    let (folder, file) = folder();
    let lines = folder.path().join("all.jsonl");
    fs::write(&lines, "{\"id\": \"x\", \"format\": \"latex\", \"text\": \"$1 + 1 = 3$\"}\nno JSON\n").expect("written");
    let (code, out, told) = run(&["--format", "jsonl", lines.to_str().expect("UTF-8"), &file]);
    assert_eq!(code, 2);
    assert!(told.contains("all.jsonl:2: this is not a JSON object"), "{told}");
    assert_eq!(out.lines().count(), 3);
    let binary = folder.path().join("b.txt");
    fs::write(&binary, [0u8, 1, 2]).expect("written");
    for (path, words) in
        [("nowhere.md", "nowhere.md"), ("src", "in this folder"), (binary.to_str().expect("UTF-8"), "zero bytes")]
    {
        let (code, _, told) = run(&[path]);
        assert_eq!(code, 2);
        assert!(told.contains(words), "{told}");
    }
    // In a folder it is named, and the others are checked.
    fs::remove_file(&lines).expect("removed");
    let (code, out, told) = run(&[folder.path().to_str().expect("UTF-8")]);
    assert_eq!((code, told.as_str()), (1, ""));
    assert!(out.contains("Not read: 1 file with zero bytes `") && out.contains("b.txt`"), "{out}");
}

#[test]
fn nothing_that_a_terminal_obeys_is_printed() {
    let (folder, _) = folder();
    let file = folder.path().join("c.md");
    fs::write(&file, "\u{1b}[31m\u{202e} $2 + 2 = 5$ \u{7}").expect("written");
    let mut kept = CapturedStreams::default();
    cli::run(&arguments(&["proofread", file.to_str().expect("UTF-8")]), &mut kept);
    let obeyed = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
    assert!(!kept.out.contains(obeyed) && kept.out.contains("printed 5, recomputed 4"), "{:?}", kept.out);
}

#[test]
fn a_name_that_leads_nowhere_is_told_with_the_nearest() {
    let (folder, file) = folder();
    fs::create_dir(folder.path().join("none")).expect("made");
    fs::create_dir(folder.path().join("chapters")).expect("made");
    fs::write(folder.path().join("chapters/one.md"), "$2 + 2 = 4$").expect("written");
    fs::write(folder.path().join("a.pdf"), "").expect("written");
    let at = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let wanted = "give a text file or a folder of them, or - for standard input";
    for (given, words) in [
        (
            at("chapers"),
            format!("{}: No such file or directory; the nearest name is {}/; {wanted}", at("chapers"), at("chapters")),
        ),
        (
            at("chapers/one.md"),
            format!(
                "{}: No such file or directory; the nearest name is {}; {wanted}",
                at("chapers/one.md"),
                at("chapters/one.md")
            ),
        ),
        (at("nofile.md"), format!("cannot read {}: No such file or directory; {wanted}", at("nofile.md"))),
        (format!("{file}/"), format!("{file}/ is no folder; give the file as {file}")),
        (
            at("a.pdf"),
            "a.pdf: the name tells no format (md, qmd, Rmd, tex, typ, docx, odt, epub, xml, cnxml, ptx, html, ipynb, txt, csv or jsonl); say --input"
                .to_owned(),
        ),
        (at("none"), "no file in this folder has a name that tells a format".to_owned()),
        ("/dev/full.md\u{202e}".to_owned(), "/dev/full.md\\u{202e}".to_owned()),
    ] {
        let (code, _, told) = run(&[&given]);
        assert!(code == 2 && told.contains(&words), "{words}\nis not in\n{told}");
    }
    for (option, given, words) in [
        (
            "--accept",
            at("chapers/cases"),
            format!("{} is a folder that is missing; the nearest name is {}/; ", at("chapers"), at("chapters")),
        ),
        ("--accept", at("a.pdf/cases"), format!("{} is no folder; ", at("a.pdf"))),
        ("--baseline", at("a.pdg"), format!("the nearest name is {}; give a file that --accept wrote", at("a.pdf"))),
    ] {
        let (code, _, told) = run(&[option, &given, &file]);
        assert!(code == 2 && told.contains(&words), "{words}\nis not in\n{told}");
    }
    // What is right beside it is read all the same.
    let (code, out, _) = run(&[&at("nofile.md"), &file]);
    assert!(code == 2 && out.contains("2 findings:"), "{out}");
}

#[test]
fn what_a_program_has_made_of_the_texts_is_counted_and_not_read() {
    let (folder, _file) = folder();
    for name in ["_site", "parts/_book", "_build/html", "_drafts"] {
        fs::create_dir_all(folder.path().join(name)).expect("made");
        fs::write(folder.path().join(name).join("a.md"), TEXT).expect("written");
    }
    let top = folder.path().to_str().expect("UTF-8");
    let (_, out, told) = run(&[top]);
    assert!(out.contains("and 2 documents.") && told.is_empty(), "{out}{told}");
    for name in ["_site", "_book", "_build"] {
        assert!(out.contains(&format!("1 folder of output `{name}`")), "{out}");
    }
    // Whoever asks for one gets it.
    assert_eq!(run(&[&format!("{top}/_site")]).0, 1);
}

#[test]
fn fences_that_are_not_read_are_listed_with_their_places() {
    let (_folder, file) = folder();
    let text =
        "Text.\n\n```python\n# a\nx = 2 + 3\n```\n\n```\n1 + 1 = 2\n```\n\n```sh\nls\n```\n\n```math\n1 + 1 = 2\n```\n";
    fs::write(&file, text).expect("written");
    let (code, out, _) = run(&["--unchecked", &file]);
    assert_eq!(code, 0);
    for (line, why, shown) in [
        (3, "a fence of `python` is not read", "x = 2 + 3"),
        (8, "a fence without a language is not read", "1 + 1 = 2"),
    ] {
        assert!(out.contains(&format!("not checked: {why}\n --> {file}:{line}:1\n  = {shown}\n")), "{out}");
    }
    assert_eq!(out.matches("not checked: ").count(), 2, "{out}");
    assert!(!run(&[&file]).1.contains("not checked: "));
}

/// The summary of the program, run in a folder.
fn run_in(folder: &Path, line: &[&str]) -> (Option<i32>, String) {
    let out = Command::new(env!("CARGO_BIN_EXE_proofread")).args(line).current_dir(folder).output().expect("it runs");
    (out.status.code(), String::from_utf8_lossy(&out.stdout).into_owned())
}

#[test]
fn accepted_cases_hold_from_every_folder() {
    let (folder, _file) = folder();
    let top = folder.path();
    fs::create_dir_all(top.join("book/src")).expect("made");
    fs::rename(top.join("a.md"), top.join("book/src/a.md")).expect("moved");
    assert_eq!(run_in(top, &["--accept", "book/cases.jsonl", "book"]).0, Some(0));
    let cases = fs::read_to_string(top.join("book/cases.jsonl")).expect("written");
    assert!(cases.lines().count() == 2 && cases.lines().all(|line| line.contains("\"file\":\"src/a.md\"")), "{cases}");
    for (from, cases, file) in [
        ("", "book/cases.jsonl", "book/src"),
        ("book", "cases.jsonl", "src/a.md"),
        ("book/src", "../cases.jsonl", "a.md"),
        ("book/src", "../cases.jsonl", "../../book"),
    ] {
        let (code, out) = run_in(&top.join(from), &["--baseline", cases, file]);
        assert_eq!((code, out.contains("2 cases left out as accepted.")), (Some(0), true), "{from}: {out}");
        assert!(!out.contains("accepted case"), "{out}");
        assert_eq!(run_in(&top.join(from), &["--accept", cases, file]).0, Some(0));
    }
    assert_eq!(fs::read_to_string(top.join("book/cases.jsonl")).expect("written"), cases, "accepted once");
    // Another file that is called so from another folder is another one.
    fs::write(top.join("book/a.md"), TEXT).expect("written");
    fs::write(top.join("book/src/cases.jsonl"), cases.replace("src/a.md", "a.md")).expect("written");
    assert_eq!(run_in(&top.join("book"), &["--baseline", "src/cases.jsonl", "src/a.md"]).0, Some(0));
    assert_eq!(run_in(&top.join("book"), &["--baseline", "src/cases.jsonl", "a.md"]).0, Some(1));
    // A file that names the texts from where the command was run still holds there.
    fs::create_dir(top.join("made")).expect("made");
    fs::write(top.join("made/cases.jsonl"), cases.replace("src/a.md", "book/src/a.md")).expect("written");
    assert_eq!(run_in(top, &["--baseline", "made/cases.jsonl", "book/src"]).0, Some(0));
}

#[test]
fn accepted_cases_that_leave_nothing_out_are_told() {
    let (folder, file) = folder();
    let at = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let cases = at("cases.jsonl");
    fs::write(at("b.md"), "It is $2 + 2 = 5$, and *t*(28) = 2.20, *p* = .36. $12 \\cdot 5.0 = 60\\,$m\n")
        .expect("written");
    assert_eq!(run(&["--accept", &cases, &file, &at("b.md")]).0, 0);
    let summary = |line: &[&str]| run(&[&["--baseline", &cases], line].concat()).1;
    assert!(!summary(&[&file, &at("b.md")]).contains("accepted case"));
    let out = summary(&[&file]);
    assert!(out.contains("2 accepted cases belong to a file that was not read: b.md."), "{out}");
    // A list that is not asked for says nothing, nor does a run that looks for what is new.
    assert!(!summary(&["--statistics=never", &file, &at("b.md")]).contains("any more"));
    fs::write(&file, TEXT.replace("0.609", "0.601")).expect("written");
    let out = summary(&[&file, &at("b.md")]);
    assert!(out.contains("1 accepted case is not found any more.") && !out.contains("not read"), "{out}");
    let sum: Value = serde_json::from_str(&summary(&["--format", "json", &file])).expect("JSON");
    assert_eq!((&sum["sum"]["accepted_gone"], &sum["sum"]["accepted_unread"]), (&1.into(), &2.into()));
    // A case of a list that is not shown is still there.
    fs::write(&file, "It is $3.0\\,\\mathrm{m} \\cdot 2.0\\,\\mathrm{m} = 6.0\\,\\mathrm{m}$.\n").expect("written");
    assert_eq!(run(&["--units", "--accept", &at("units.jsonl"), &file]).0, 0);
    let (code, out, _) = run(&["--baseline", &at("units.jsonl"), &file]);
    assert_eq!((code, out.contains("any more")), (0, false), "{out}");
}

#[test]
fn accepted_cases_are_written_whole_or_not_at_all() {
    let (folder, file) = folder();
    let at = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let (code, _, told) = run(&["--accept", &at("none/x"), &file]);
    let words = format!(
        "--accept {}: {} is a folder that is missing; make it, or give a file in a folder that is there",
        at("none/x"),
        at("none")
    );
    assert!(code == 2 && told.contains(&words), "{told}");
    let (code, _, told) = run(&["--baseline", &at("none"), &file]);
    assert!(code == 2 && told.contains("give a file that --accept wrote"), "{told}");
    #[cfg(unix)]
    for option in ["--accept", "--baseline"] {
        let (code, _, told) = run(&[option, "/dev/full", &file]);
        assert!(code == 2 && told.contains("/dev/full is a pipe or a device, not a regular file"), "{told}");
    }
    // A run that ends before its end leaves what was there.
    let cases = at("cases.jsonl");
    fs::write(&cases, "no case\n").expect("written");
    assert_eq!(run(&["--accept", &cases, &file]).0, 2);
    assert_eq!(fs::read_to_string(&cases).expect("readable"), "no case\n");
    assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 2);
}

#[test]
fn a_report_for_code_review_names_files_below_the_repository() {
    let uris = |line: &[&str]| -> Vec<String> {
        let (_, out, told) = run(&[&["--format", "sarif"], line].concat());
        let whole: Value = serde_json::from_str(&out).unwrap_or_else(|why| panic!("{why}: {out}{told}"));
        let results = whole["runs"][0]["results"].as_array().expect("results");
        let uri = |of: &Value| of["locations"][0]["physicalLocation"]["artifactLocation"]["uri"].clone();
        results.iter().map(|of| uri(of).as_str().expect("a string").to_owned()).collect()
    };
    let (folder, _) = folder();
    let inside = folder.path().join("a folder");
    fs::create_dir(&inside).expect("made");
    let file = inside.join("b:c.md");
    fs::write(&file, "$2 + 2 = 5$").expect("written");
    let file = file.to_str().expect("UTF-8");
    if git(folder.path(), &["init", "-q"]) {
        assert_eq!(uris(&[file]), ["a%20folder/b%3Ac.md"]);
    }
    let lines = folder.path().join("all.jsonl");
    let ids = ["//evil.example/x", "../../../etc/passwd", "", "http://a.example", "a/./b c", "\u{202e}"];
    let line = |id: &&str| format!("{}\n", serde_json::json!({ "id": id, "text": "$2 + 2 = 5$" }));
    fs::write(&lines, ids.iter().map(line).collect::<String>()).expect("written");
    let expected =
        ["./evil.example/x", "./__/__/__/etc/passwd", "./line%203", "./http%3A/a.example", "./a/b%20c", "./%E2%80%AE"];
    assert_eq!(uris(&[lines.to_str().expect("UTF-8")]), expected);
    // A name that a terminal would obey is told in words.
    let (_, out, _) = run(&[lines.to_str().expect("UTF-8")]);
    assert!(out.contains("--> \\u{202e}:1:") && !out.contains('\u{202e}'), "{out}");
}
