//! Is a book that is built from what earlier builds have kept the book that is built from scratch, whatever has changed?

use super::*;
use crate::cache;
use crate::samples::{FIRST, LED, SECOND};
use std::collections::BTreeMap;

/// All files of a built book, by their paths in it.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let (mut found, mut folders) = (BTreeMap::new(), vec![folder.to_owned()]);
    while let Some(inside) = folders.pop() {
        for entry in fs::read_dir(&inside).expect("a folder") {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).expect("inside").to_owned();
                found.insert(name, fs::read(&path).expect("readable"));
            }
        }
    }
    found
}

/// A workspace with a target directory, and a book with all kinds of placeholders and a file that a chapter includes.
fn workspace_with_target() -> TempDir {
    let root = workspace_of(
        "# Chapter\n\nTwice 21 is {{double:21}} as in {{cite:johnson}}, $a+b$.\n\n{{figure:circle}}\n\n{{table:rows; Rows of \
         {{count:all}}}}\n\nSee {{ref:rows}}. It takes {{claim:leaflet.time}}.\n\n{{cite-claim:leaflet.time}}\n\n```text\n\
         {{#include ../records/times.csv}}\n```\n\n| a | b |\n|---|---|\n| c | 1 |\n",
    );
    let book = root.path().join("book");
    for folder in ["target", "book/records", "book/theme"] {
        fs::create_dir(root.path().join(folder)).expect("a folder");
    }
    fs::write(book.join("records/times.csv"), "fall,2.02\n").expect("written");
    fs::write(book.join("theme/own.css"), "p { color: red }\n").expect("written");
    change(
        &book.join("book.toml"),
        "[preprocessor.sample]",
        "[output.html]\nadditional-css = [\"theme/own.css\"]\n[preprocessor.sample]",
    );
    root
}

fn change(file: &Path, from: &str, to: &str) {
    let text = fs::read_to_string(file).expect("text");
    assert!(text.contains(from), "{from} is not in {text}");
    fs::write(file, text.replace(from, to)).expect("written");
}

/// Builds the book twice, with what is kept and from scratch, and gives its files.
#[track_caller]
fn compared(root: &TempDir, what: &str) -> BTreeMap<PathBuf, Vec<u8>> {
    let [kept, scratch] = ["kept", "scratch"].map(|out| root.path().join(out));
    build(&BOOK, root.path(), &kept).unwrap_or_else(|error| panic!("{what}: {error:#}"));
    build_afresh(&BOOK, root.path(), &scratch).unwrap_or_else(|error| panic!("{what}: {error:#}"));
    let (kept, scratch) = (files(&kept), files(&scratch));
    let names = |files: &BTreeMap<PathBuf, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&kept), names(&scratch), "{what}");
    for (name, bytes) in &scratch {
        assert!(kept[name] == *bytes, "{what}: {} is not what a build from scratch makes", name.display());
    }
    scratch
}

#[test]
fn whatever_changes_the_book_is_the_one_that_is_built_from_scratch() {
    let root = workspace_with_target();
    let mut before = compared(&root, "the first build");
    assert_eq!(compared(&root, "the second build"), before);
    for (file, from, to) in [
        (FIRST, "as in", "which is in"),
        (FIRST, "{{double:21}}", "{{double:22}}"),
        (FIRST, "{{cite:johnson}}", "{{cite:alon}}"),
        (FIRST, "$a+b$", "$a-b$"),
        (FIRST, "; Rows of", "; All rows of"),
        (FIRST, "{{figure:circle}}\n\n", ""),
        (FIRST, "| c | 1 |", "| d | 1 |"),
        (SECOND, "Text", LED),
        (SECOND, "Text", "{{ref:rows}}. Text"),
        (SECOND, "Text", "Text\n\n{{erratum:leaflet.speed}}\n\nText"),
        ("src/SUMMARY.md", "Another chapter", "A second chapter"),
        ("records/times.csv", "2.02", "2.03"),
        ("theme/own.css", "red", "blue"),
        ("theme/head.hbs", "", "<meta name=\"author\" content=\"Nobody\">"),
        ("theme/head.hbs", "Nobody", "Somebody"),
        ("book.toml", "A trial", "Another trial"),
        ("book.toml", "[output.html]", "[output.html]\ndefault-theme = \"navy\""),
        (FIRST, "{{table:rows", "{{figure:circle}}\n\n{{table:rows"),
    ] {
        let path = root.path().join("book").join(file);
        if from.is_empty() {
            fs::write(&path, to).expect("written");
        } else {
            change(&path, from, to);
        }
        let after = compared(&root, &format!("{file}: `{from}` is `{to}` now"));
        assert!(after != before, "{file}: `{from}` changes nothing");
        before = after;
    }
}

#[test]
fn a_kept_file_that_is_damaged_or_in_the_way_changes_nothing() {
    let root = workspace_with_target();
    let whole = compared(&root, "the first build");
    let kept = || files(&root.path().join("target").join(cache::FOLDER));
    let shelves = kept();
    assert_eq!(shelves.len(), 2, "{:?}", shelves.keys());
    for (name, bytes) in &shelves {
        let path = root.path().join("target").join(cache::FOLDER).join(name);
        for damaged in [&bytes[..bytes.len() / 2], b"", &[&bytes[..200], &[0; 100], &bytes[300..]].concat()] {
            fs::write(&path, damaged).expect("written");
            assert!(compared(&root, "a damaged file") == whole);
            assert!(kept()[name] == *bytes, "it is made anew");
        }
    }
    fs::remove_dir_all(root.path().join("target").join(cache::FOLDER)).expect("removed");
    fs::write(root.path().join("target").join(cache::FOLDER), "in the way").expect("written");
    assert!(compared(&root, "a file in the way") == whole);
}

#[test]
fn a_chapter_that_does_not_build_is_named_again_by_the_next_build() {
    let root = workspace_with_target();
    let whole = compared(&root, "the first build");
    let page = root.path().join("book").join(FIRST);
    change(&page, "{{double:21}}", "{{double:many}}");
    for _ in 0..2 {
        let error = build(&BOOK, root.path(), &root.path().join("kept")).expect_err("no number");
        assert!(format!("{error:#}").contains(&format!("{}: line 3: ", FIRST.trim_start_matches("src/"))), "{error:#}");
    }
    change(&page, "{{double:many}}", "{{double:21}}");
    assert!(compared(&root, "put right") == whole);
}

#[test]
fn two_builds_at_the_same_time_make_the_same_book() {
    let root = workspace_with_target();
    let outs: Vec<_> = (0..4).map(|number| root.path().join(format!("out-{number}"))).collect();
    // The first build writes the files of data among the chapters, which the others then find as they should be.
    let whole = compared(&root, "alone");
    fs::remove_dir_all(root.path().join("target").join(cache::FOLDER)).expect("removed");
    std::thread::scope(|scope| {
        for out in &outs {
            scope.spawn(|| build(&BOOK, root.path(), out).expect("built"));
        }
    });
    assert!(outs.iter().all(|out| files(out) == whole));
    assert!(compared(&root, "afterwards") == whole);
}
