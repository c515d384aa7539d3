//! `geneva record` and `geneva check` on the example and on small projects.

use crate::{answered, geneva, refused, stdout};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

fn example() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("crates/geneva is in it").join("examples/paper")
}

/// A copy of the example without its programs.
fn copy() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["paper.tex", "values.json", "second.json", "numbers.toml"] {
        fs::copy(example().join(name), folder.path().join(name)).expect("copied");
    }
    folder
}

fn shown(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

#[test]
fn the_paper_agrees_with_its_values() {
    let example = example();
    let said = stdout(&["check", shown(&example)], 0);
    assert!(said.contains("12 right, 16 no value.") && said.contains("refused its neighbours: 12 of 12."), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    let recorded = stdout(&["record", shown(&example)], 0);
    assert!(recorded.contains("numbers.toml is up to date: 28 numbers."), "{recorded}");
}

#[test]
fn a_changed_digit_of_the_paper_is_found() {
    let folder = copy();
    let paper = folder.path().join("paper.tex");
    let text = fs::read_to_string(&paper).expect("a text");
    fs::write(&paper, text.replace("2.1532", "2.1523")).expect("written");
    let said = stdout(&["check", shown(folder.path())], 1);
    assert!(
        said.contains(
            "paper.tex:30:15: stale: printed 2.1523 s, period_60 is 2.153242351783843 s now; write 2.1532 s; the second"
        ),
        "{said}"
    );
    let page: Value =
        serde_json::from_str(&stdout(&["check", shown(folder.path()), "--format", "json"], 1)).expect("JSON");
    assert_eq!(
        (&page["summary"]["counts"]["stale"], &page["summary"]["right"]),
        (&Value::from(1), &Value::from(false))
    );
    let numbers = page["numbers"].as_array().expect("a list");
    let stale = numbers.iter().find(|number| number["kind"] == "stale").expect("a number");
    assert_eq!(
        (&stale["verdict"], &stale["write"], &stale["line"]),
        (&Value::from("wrong"), &Value::from("2.1532"), &Value::from(30))
    );
    let log: Value =
        serde_json::from_str(&stdout(&["check", shown(folder.path()), "--format", "sarif"], 1)).expect("JSON");
    let result = &log["runs"][0]["results"][0];
    assert_eq!((&result["ruleId"], &result["level"]), (&Value::from("stale"), &Value::from("error")));
    assert_eq!(result["locations"][0]["physicalLocation"]["region"]["startLine"], 30);
}

#[test]
fn texts_can_be_named_with_their_values() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    fs::write(path("report.md"), "The mean is 4.57 mm.\n").expect("written");
    fs::write(path("results.csv"), "name,value,unit\nmean,4.5678,mm\n").expect("written");
    let (report, results) = (path("report.md"), path("results.csv"));
    let said = stdout(&["record", shown(&report), "--values", shown(&results)], 0);
    assert!(said.contains("1 number, 1 new entry") && said.contains("Tied to: 1 value."), "{said}");
    assert!(stdout(&["check", shown(folder.path())], 0).contains("1 right"));
    let said = refused(&["record", shown(&report), "--values", shown(&report)]);
    assert!(said.contains("numbers.toml does not name report.md; add it to `texts`, `values` or `second`"), "{said}");
}

#[test]
fn what_cannot_be_read_is_told_with_its_remedy() {
    let folder = tempfile::tempdir().expect("a folder");
    let said = refused(&["check", shown(folder.path())]);
    assert!(said.contains("numbers.toml") && said.contains("give a record that `geneva record` wrote"), "{said}");
    fs::write(folder.path().join("a.md"), "It is 31.75.\n").expect("written");
    let said = refused(&["record", shown(folder.path())]);
    assert!(said.contains("there is no values.json, values.csv or values.toml"), "{said}");
    fs::write(folder.path().join("values.json"), "{\"drag\": NaN}").expect("written");
    let said = refused(&["record", shown(folder.path())]);
    assert!(said.contains("values.json: key drag: NaN is not a finite number"), "{said}");
}

#[test]
fn staged_files_count_in_place_of_those_on_the_disk() {
    let folder = copy();
    let git = |arguments: &[&str]| {
        let done = Command::new("git").arg("-C").arg(folder.path()).args(arguments).output();
        done.is_ok_and(|output| output.status.success())
    };
    if !git(&["init", "--quiet"]) {
        return;
    }
    let said = refused(&["check", "--staged", shown(folder.path())]);
    assert!(said.contains("is not staged in git"), "{said}");
    assert!(git(&["add", "--all"]));
    let paper = folder.path().join("paper.tex");
    let text = fs::read_to_string(&paper).expect("a text");
    fs::write(&paper, text.replace("2.1532", "2.1523")).expect("written");
    stdout(&["check", shown(folder.path())], 1);
    stdout(&["check", "--staged", shown(folder.path())], 0);
    assert!(git(&["add", "--all"]));
    assert_eq!(answered(&["check", "--staged", shown(folder.path())]).code, 1);
}

#[cfg(unix)]
#[test]
fn a_hook_reads_what_is_being_committed() {
    use std::os::unix::fs::PermissionsExt;
    let folder = copy();
    let git = |arguments: &[&str]| {
        let identity = ["-c", "user.name=A", "-c", "user.email=a@example.org"];
        let done = Command::new("git").arg("-C").arg(folder.path()).args(identity).args(arguments).output();
        done.is_ok_and(|output| output.status.success())
    };
    if !git(&["init", "--quiet"]) {
        return;
    }
    let hook = folder.path().join(".git/hooks/pre-commit");
    fs::create_dir_all(hook.parent().expect("a folder")).expect("made");
    let program = geneva(&[]).get_program().to_string_lossy().into_owned();
    fs::write(&hook, format!("#!/bin/sh\nexec '{program}' check --staged .\n")).expect("written");
    fs::set_permissions(&hook, fs::Permissions::from_mode(0o755)).expect("made a program");
    assert!(git(&["add", "--all"]) && git(&["commit", "-qm", "all is right"]));
    let paper = folder.path().join("paper.tex");
    let text = fs::read_to_string(&paper).expect("a text");
    fs::write(&paper, text.replace("2.1532", "2.1523")).expect("written");
    // Git makes an index for these commits alone.
    assert!(!git(&["commit", "-qam", "a wrong digit"]) && !git(&["commit", "-qm", "a wrong digit", "paper.tex"]));
    assert!(git(&["add", "--all"]) && !git(&["commit", "-qm", "a wrong digit"]));
    fs::write(&paper, text.replace("An amplitude", "Any amplitude")).expect("written");
    assert!(git(&["commit", "-qam", "another word"]));
}

/// A book of mdBook with a chapter, its values and its record.
fn book(chapter: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        fs::write(path, text).expect("written");
    };
    let command = geneva(&[]).get_program().to_string_lossy().replace('\\', "/");
    write(
        "book.toml",
        &format!("[book]\ntitle = \"Sizes\"\n\n[preprocessor.numbers]\ncommand = \"{command} numbers\"\n"),
    );
    write("src/SUMMARY.md", "# Summary\n\n- [Width](parts/width.md)\n");
    write("src/parts/width.md", chapter);
    write("values.json", r#"{"width": {"value": 4.5678, "unit": "mm"}, "height": 7}"#);
    let [text, values, record] =
        ["src/parts/width.md", "values.json", "numbers.toml"].map(|name| folder.path().join(name));
    stdout(&["record", shown(&text), "--values", shown(&values), "--record", shown(&record)], 0);
    folder
}

/// The pages of a book, built by mdBook, which runs the preprocessor.
fn built(folder: &Path) -> impl Fn(&str) -> String {
    let mut book = mdbook_driver::MDBook::load(folder).expect("a book");
    book.config.build.build_dir = "out".into();
    book.build().expect("built");
    let out = folder.join("out");
    move |page| fs::read_to_string(out.join(page)).unwrap_or_else(|why| panic!("{page}: {why}"))
}

#[test]
fn a_book_gets_pages_on_its_numbers() {
    let folder = book("# Width\n\nThe mean width is 4.57 mm.\n");
    let page = built(folder.path());
    let coverage = page("numbers-coverage.html");
    for words in
        ["1 number in 1 text: 1 right.", "<code>width</code>", "1 value that no number prints: <code>height</code>"]
    {
        assert!(coverage.contains(words), "no `{words}` in {coverage}");
    }
    assert!(coverage.contains("href=\"parts/width.html\""), "{coverage}");
    assert!(page("numbers-errata.html").contains("No number is wrong, and none is open."));
}

#[test]
fn a_book_shows_what_is_wrong_where_its_author_wants_it() {
    let folder = book("# Width\n\nThe mean width is 4.57 mm.\n");
    let chapter = folder.path().join("src/parts/width.md");
    fs::write(&chapter, "# Width\n\nThe mean width is 4.58 mm, or 5 mm.\n\n{{numbers:errata}}\n").expect("written");
    let page = built(folder.path());
    let width = page("parts/width.html");
    assert!(
        width.contains("1 number is wrong") && width.contains("<td style=\"text-align: right\">4.57 mm</td>"),
        "{width}"
    );
    assert!(width.contains("1 number is open.") && width.contains("href=\"../parts/width.html\""), "{width}");
    assert!(!folder.path().join("out/numbers-errata.html").exists());
    // The page has a row for the number that nobody has recorded, too.
    assert!(page("numbers-coverage.html").contains("5 mm"));
}

#[test]
fn a_book_without_a_record_is_not_built() {
    let folder = book("# Width\n\nThe mean width is 4.57 mm.\n");
    let record = folder.path().join("numbers.toml");
    fs::remove_file(&record).expect("removed");
    let book = mdbook_driver::MDBook::load(folder.path()).expect("a book");
    assert!(book.build().is_err());
}

/// The blocks of code of a kind on the page that explains the commands.
fn blocks_of_the_page(kind: &str) -> Vec<String> {
    let page = example().join("../../book/src/your-document.md");
    let page = fs::read_to_string(page).expect("the page");
    let opening = format!("```{kind}\n");
    page.split(&opening).skip(1).map(|rest| rest.split("```").next().unwrap_or_default().to_owned()).collect()
}

#[test]
fn the_page_that_explains_the_commands_shows_what_they_say() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    fs::write(path("report.md"), &blocks_of_the_page("markdown")[0]).expect("written");
    fs::write(path("values.json"), &blocks_of_the_page("json")[0]).expect("written");
    let said = stdout(&["record", shown(folder.path())], 0);
    assert!(said.contains("5 new entries") && said.contains("Tied to: 3 open, 2 value."), "{said}");
    let record = fs::read_to_string(path("numbers.toml")).expect("a record");
    let decided = ["none = \"given\"", "none = \"given\"", "value = \"loss\""]
        .iter()
        .fold(record, |record, tie| record.replacen("open = true", tie, 1));
    fs::write(path("numbers.toml"), decided).expect("written");
    let said = stdout(&["check", shown(folder.path())], 1);
    let expected = &blocks_of_the_page("text")[0];
    assert_eq!(said.replace(&format!("{}/", shown(folder.path())), ""), *expected);
    let toml = blocks_of_the_page("toml");
    assert!(toml[0].contains("[preprocessor.numbers]\ncommand = \"geneva numbers\""), "{toml:?}");
}
