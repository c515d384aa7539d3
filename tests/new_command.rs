//! `geneva new`: what it makes of a text in each format, what it refuses, and whether the crate builds, runs and is guarded.

use crate::{answered, refused, stdout};
use geneva_evidence::number_tokens;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

type SampleText = (&'static str, &'static str, &'static [(u32, &'static str)], &'static [&'static str]);

/// A text of each format: its name, its characters, the numbers that it shows by their lines, and the claims that are offered.
/// Digits of markup, code, comments and addresses are sevens.
const TEXTS: [SampleText; 6] = [
    (
        "Notes 2.md",
        "---\ndate: 7777-07-07\n---\n# Falling\n\n1. It falls for 3.19 s.\n\nSo is, for `7` and <b id=\"s7\">all</b>,\n$$v = g t$$\nand \
         $h = \\frac{1}{2} g t^2$.\n\nFour times the height takes twice as long. <!-- 77 -->\nFigure 2 shows how it falls. See \
         https://example.org/77.\n",
        &[(6, "3.19"), (10, "1 2 2"), (12, "four twice"), (13, "2")],
        &["value 6 3.19 s", "equation 9 v = g t", "statement 12 Four times", "figure 13 Figure 2 shows how it falls."],
    ),
    (
        "thesis.tex",
        "\\documentclass[77pt]{article}\n\\newcommand{\\half}{7/7}\n\\begin{document}\n% 7\nIt takes $2.02\\,\\mathrm{s}$, as \
         Fig.~1 shows.\n\\begin{equation}\n\\label{eq:77}\nT = 2 \\pi \\sqrt{\\frac{l}{g}}.\n\\end{equation}\nA mass of 12 kg needs no \
         more time.\n\\end{document}\n",
        &[(5, "2.02 1"), (8, "2"), (10, "12")],
        &["value 5 2.02 s", "equation 8 T = 2", "statement 10 A mass of 12 kg"],
    ),
    (
        "section.cnxml",
        "<document id=\"m77\"><metadata>77</metadata>\n<para id=\"p-7\">The speed is <m:math><m:mn>3</m:mn><m:mtext>.</m:mtext><m:mn>5\
         </m:mn></m:math> m/s,\nand 10<sup>2</sup> more. Then it is 4.5 m/s in all.</para></document>\n",
        &[(2, "3.5"), (3, "10 2 4.5")],
        &["value 2 3.5 m/s", "statement 3 Then it is 4.5 m/s in all."],
    ),
    (
        "page.html",
        "<html><head><title>7</title><style>p { margin: 7px }</style></head><body>\n<p class=\"c7\">It is 1.62 m/s<sup>2</sup> there,\
         <br>3 on this side.</p>\n<pre>7</pre></body></html>\n",
        &[(2, "1.62 2 3")],
        &["value 2 1.62 m/s²"],
    ),
    (
        "book.ipynb",
        "{\"cells\": [\n{\"cell_type\": \"code\", \"source\": [\"7\"]},\n{\"cell_type\": \"markdown\", \"source\": [\n\"It takes 2.01 s.\\n\",\n\
         \"That is one swing.\"]}], \"nbformat\": 7}\n",
        &[(4, "2.01"), (5, "one")],
        &["value 4 2.01 s"],
    ),
    ("data.txt", "The bar has 3 holes and 2 ends.\n", &[(1, "3 2")], &["statement 1 The bar has 3 holes"]),
];

/// The folder of the project, in which the engine is.
fn project() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("crates/geneva is in it").to_owned()
}

/// A folder with a text.
fn folder_with(name: &str, text: &str) -> (TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    fs::write(&path, text).expect("written");
    let path = path.to_str().expect("UTF-8").to_owned();
    (folder, path)
}

fn shown(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap_or_else(|why| panic!("{name}: {why}"))
}

/// The names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_text_of_each_format_becomes_a_crate() {
    for (name, text, numbers, claims) in TEXTS {
        let (folder, from) = folder_with(name, text);
        let made = folder.path().join("My check");
        let said = stdout(&["new", shown(&made), "--from", &from], 0);
        let sum: usize = numbers.iter().map(|(_, line)| number_tokens(line).len()).sum();
        assert!(said.contains(&format!("which prints {sum} numbers in ")), "{name}: {said}");
        assert!(said.contains("cargo run ") && said.contains("leads to the first verdict."), "{said}");
        assert_eq!(
            names(&made),
            [
                ".gitignore",
                "Cargo.lock",
                "Cargo.toml",
                "README.md",
                "book",
                "document.inventory",
                "src",
                "tests",
                "text"
            ]
        );
        assert_eq!(names(folder.path()).len(), 2, "something unfinished is left");
        assert_eq!(read(&made, &format!("text/{name}")), text);
        let inventory = read(&made, "document.inventory");
        let listed: Vec<&str> =
            inventory.lines().filter(|line| line.starts_with("line ") && line.contains(": ")).collect();
        let expected: Vec<String> = numbers.iter().map(|(line, numbers)| format!("line {line}: {numbers}")).collect();
        assert_eq!(listed, expected, "{name}");
        let source = read(&made, "src/claims.rs");
        let code: String = source.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        let code = code.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(code.matches("at(\"line ").count(), claims.len(), "{name}: {source}");
        for claim in claims {
            let [kind, line, printed] = claim.splitn(3, ' ').collect::<Vec<_>>()[..] else { panic!("{claim}") };
            let place = format!("at(\"line {line}\") .{kind}(");
            let (printed, unit) =
                if kind == "value" { printed.split_once(' ').expect("a unit") } else { (printed, "") };
            let after = code.split_once(&place).unwrap_or_else(|| panic!("{name}: no {place} in {code}")).1;
            let after = after.split(".missing(NO_ROUTE)").next().expect("an open claim");
            assert!(after.contains(&format!("\"{printed}")), "{name}: {claim} in {after}");
            assert!(unit.is_empty() || after.contains(&format!("\"{unit}\"")), "{name}: {claim} in {after}");
        }
        let manifest: toml::Table = read(&made, "Cargo.toml").parse().expect("TOML");
        assert_eq!(manifest["package"]["name"].as_str(), Some("my-check"));
        let engine = manifest["dependencies"]["geneva-evidence"]["path"].as_str().expect("a path");
        assert!(Path::new(engine).join("Cargo.toml").is_file(), "{engine}");
        let main = read(&made, "src/main.rs");
        assert!(main.lines().count() <= 15 && main.contains("use my_check::"), "{main}");
        for file in ["README.md", "src/lib.rs", "src/book.rs", "src/document.rs", "tests/ledger.rs", "book/book.toml"] {
            assert!(!read(&made, file).contains('@'), "{name}: {file} has a hole");
        }
    }
}

#[test]
fn what_cannot_be_made_is_refused_with_its_remedy_and_nothing_is_written() {
    let (folder, from) = folder_with("notes.md", "It is 2.5 m.\n");
    let path = |name: &str| shown(&folder.path().join(name)).to_owned();
    let write = |name: &str, bytes: &[u8]| fs::write(folder.path().join(name), bytes).expect("written");
    for (name, bytes) in [
        ("notes.rst", &b"2.5"[..]),
        ("notes.pdf", b"2.5"),
        ("latin.txt", b"\xb0 2.5"),
        ("none.md", b"No number: `7`.\n"),
        ("broken.ipynb", b"2.5"),
        ("one.ipynb", br#"{"cells": [{"cell_type": "markdown", "source": ["2.5\n", "3.5"]}]}"#),
    ] {
        write(name, bytes);
    }
    fs::create_dir(path("full")).expect("made");
    fs::write(path("full/file"), "").expect("written");
    let before = names(folder.path());
    for (target, text, engine, words) in [
        ("new", "notes.rst", None, "give a text that ends in .md, .tex, .xml, .html, .ipynb or .txt"),
        ("new", "notes.pdf", None, "`pdftotext -layout` makes a text of a PDF"),
        ("new", "latin.txt", None, "is not in UTF-8; save it in this encoding"),
        ("new", "none.md", None, "shows no number, so there is nothing to account for"),
        ("new", "broken.ipynb", None, "this is not a Jupyter notebook"),
        ("new", "one.ipynb", None, "give what `jupyter nbconvert --to markdown` makes of it"),
        ("new", "absent.md", None, "give --from a text"),
        ("full", "notes.md", None, "is not empty; give a folder that is not there, or an empty one"),
        ("none.md", "notes.md", None, "is a file; give a folder that is not there"),
        ("absent/new", "notes.md", None, "is no folder, so "),
        ("new", "notes.md", Some("full"), "has no Cargo.lock; give the folder of the project"),
    ] {
        let (target, text) = (path(target), path(text));
        let engine = engine.map(path);
        let mut line = vec!["new", &target, "--from", &text];
        line.extend(engine.iter().flat_map(|engine| ["--engine", engine.as_str()]));
        let said = refused(&line).replace('\n', " ");
        assert!(said.contains(words), "{line:?}: no `{words}` in {said}");
        assert_eq!(names(folder.path()), before, "{line:?}");
    }
    assert!(refused(&["new", &path("new")]).contains("--from <TEXT>"));
    assert_eq!(answered(&["new", &path("new"), "--from", &from, "--engine", shown(&project())]).code, 0);
    // What is there and empty is filled.
    fs::create_dir(path("empty")).expect("made");
    assert_eq!(answered(&["new", &path("empty"), "--from", &from]).code, 0);
    assert_eq!(names(&folder.path().join("empty")), names(&folder.path().join("new")));
}

/// Cargo in a made crate, with the packages that the tests have compiled already as far as they are the same.
fn cargo(made: &Path, arguments: &[&str], with: &[(&str, &str)]) -> (bool, String) {
    let project = project();
    let manifest: toml::Table = read(&project, "Cargo.toml").parse().expect("TOML");
    let profile: toml::Table = [(
        "profile".to_owned(),
        toml::Table::from_iter([("dev".to_owned(), manifest["profile"]["dev"].clone())]).into(),
    )]
    .into_iter()
    .collect();
    let config = made.with_file_name("profile.toml");
    fs::write(&config, profile.to_string()).expect("written");
    let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(program);
    command
        .args(arguments)
        .args(["--offline", "--config", shown(&config)])
        .current_dir(made)
        .env("RUST_BACKTRACE", "0");
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| project.join("target"), |own| project.join(own));
    command.env("CARGO_TARGET_DIR", target).envs(with.iter().copied());
    let output = command.output().expect("Cargo runs");
    let said = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    (output.status.success(), said)
}

/// Replaces words in a file of a crate that are there once.
fn replace(made: &Path, file: &str, pairs: &[(&str, &str)]) {
    let mut text = read(made, file);
    for (old, new) in pairs {
        assert_eq!(text.matches(old).count(), 1, "{file}: {old}");
        text = text.replace(old, new);
    }
    fs::write(made.join(file), text).expect("written");
}

#[test]
fn a_made_crate_builds_runs_and_says_what_is_not_yet_accounted_for() {
    let (name, text, ..) = TEXTS[0];
    let (folder, from) = folder_with(name, text);
    // A name that no other package has: the target directory is that of the tests.
    let made = folder.path().join("made-check");
    stdout(&["new", shown(&made), "--from", &from], 0);
    let (is_built, said) = cargo(&made, &["run"], &[]);
    assert!(is_built && !said.contains("warning: unused"), "{said}");
    let left = "3 of 7 numbers in 1 line are not accounted for yet; the first: line 10: 1, 2, 2";
    assert!(said.contains("4 claims: 4 open") && said.contains(left), "{said}");
    let book = made.join("target/book");
    assert!(read(&book, "coverage.html").contains("Not yet accounted for"));
    assert!(read(&book, "document.html").contains("3.19"));
    let (passes, said) = cargo(&made, &["test", "--test", "ledger"], &[]);
    assert!(passes, "{said}");

    // The way that README.md leads: two routes, the unit, the id, the rest of a line.
    let number = ("notes-2.first-number", "notes-2.fall-time");
    let routes = ".first_route(Evidence::CLOSED_FORM, || (2.0 * 50.0 / 9.81_f64).sqrt())\n            \
                  .second_route(Evidence::LIMIT_CASE, || 50.0 / (9.81_f64 * 50.0 / 2.0).sqrt())";
    replace(
        &made,
        "src/claims.rs",
        &[("\"notes-2.first-number\", \"3.19\", \"s\", \"first number\")\n            .missing(NO_ROUTE)", &{
            format!("\"{}\", \"3.19\", \"s\", \"time of the fall\")\n            {routes}", number.1)
        })],
    );
    replace(&made, "src/document.rs", &[("first number", "time")]);
    replace(&made, "book/src/document.md", &[number]);
    replace(
        &made,
        "document.inventory",
        &[
            number,
            (
                "line 10: 1 2 2\n",
                "line 10: 1 2 2\n  exception notes-2.height (1 2 2): the formula is checked elsewhere\n",
            ),
        ],
    );
    let (is_built, said) = cargo(&made, &["run"], &[]);
    assert!(is_built && said.contains("4 claims: 1 right, 3 open\nall of the 7 numbers are accounted for"), "{said}");
    let (passes, said) = cargo(&made, &["test", "--test", "ledger"], &[]);
    assert!(
        !passes && said.contains("0 lines are still to be accounted for, and 1 are on record; write 0 there"),
        "{said}"
    );

    // With nothing left to do, all guards count; a wrong digit and a text that has changed are noticed.
    replace(&made, "tests/ledger.rs", &[("LINES_TO_DO: usize = 1", "LINES_TO_DO: usize = 0")]);
    replace(&made, "src/claims.rs", &[("\"3.19\"", "\"3.18\"")]);
    replace(&made, &format!("text/{name}"), &[("3.19", "3.18")]);
    let (passes, said) = cargo(&made, &["test", "--no-fail-fast", "--test", "ledger"], &[]);
    for words in [
        "vectors is used by no claim",
        "notes-2.fall-time: recorded as reproduced, but found",
        "claim notes-2.fall-time has 3.18, the line there 3.19",
        "document.inventory is not that of the text",
    ] {
        assert!(!passes && said.contains(words), "no `{words}` in {said}");
    }
    let (_, said) = cargo(&made, &["test", "--test", "ledger", "the_inventory"], &[("RECORD_INVENTORY", "1")]);
    assert!(read(&made, "document.inventory").contains("line 6: 3.18\nline 9"), "{said}");
}
