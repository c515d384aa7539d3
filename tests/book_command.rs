//! Does `geneva book` replace its own book and nothing else, however it ends?

use crate::{geneva, piped_into, refusal, small_workspace};
use geneva_chapters::EXAMPLES;
use geneva_documents::LEDGER;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::process::Command;

#[cfg(unix)]
mod signals;

/// A build in a workspace.
fn inside(workspace: &Path, arguments: &[&str]) -> Command {
    let mut command = geneva(arguments);
    command.current_dir(workspace);
    command
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<_> =
        entries.map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_place_where_nothing_can_be_written_leaves_the_old_book() {
    let workspace = small_workspace();
    let inside = |arguments: &[&str]| inside(workspace.path(), arguments);
    assert!(inside(&["book", "--output", "out"]).output().expect("the program runs").status.success());
    let page = workspace.path().join("out/index.html");
    let old = fs::read(&page).expect("the book is there");
    assert!(!page.with_file_name("data").exists(), "data to which no page leads");

    // Permissions do not stop every user; a file where a folder should be does.
    fs::write(workspace.path().join("file"), "").expect("writable");
    for output in ["file", "file/book", "book", ".", "/"] {
        let said = refusal(inside(&["book", "build", "--out", output]));
        assert!(said.contains("choose another output folder"), "{said}");
    }

    fs::write(workspace.path().join("book/src/SUMMARY.md"), "- [Missing](missing.md)\n").expect("writable");
    let said = refusal(inside(&["book", "--output", "out"]));
    assert!(said.contains("missing.md"), "{said}");
    assert_eq!(fs::read(&page).expect("the book is still there"), old);
    assert_eq!(names(workspace.path()), ["book", "crates", "file", "out"]);
}

#[test]
fn files_that_it_did_not_write_are_refused_and_stay() {
    let workspace = small_workspace();
    let out = workspace.path().join("out");
    fs::create_dir_all(out.join(".git")).expect("writable");
    for (file, text) in [
        ("index.html", "Book generated using mdBook: Small"),
        (".geneva-book", "index.html\n"),
        (".git/HEAD", ""),
        ("CNAME", ""),
    ] {
        fs::write(out.join(file), text).expect("writable");
    }
    let said = refusal(inside(workspace.path(), &["book", "build", "--output", "out"]));
    assert!(
        said.starts_with("error: ") && said.contains("`.git/`, `CNAME`. Move the rest out, or choose another"),
        "{said}"
    );
    assert_eq!(names(&out), [".geneva-book", ".git", "CNAME", "index.html"]);
    assert!(out.join(".git/HEAD").is_file());
    assert_eq!(names(workspace.path()), ["book", "crates", "out"]);
}

#[test]
fn outside_of_a_workspace_nothing_is_built() {
    let elsewhere = tempfile::tempdir().expect("a temporary folder");
    for arguments in [&["book"][..], &["book", "build", "--output", "out"], &["book", "test"]] {
        let said = refusal(inside(elsewhere.path(), arguments));
        let here = elsewhere.path().canonicalize().expect("it exists");
        assert!(said.contains("no book found") && said.contains(&*here.to_string_lossy()), "{said}");
        assert!(said.contains("change to a folder of the project"), "{said}");
    }
    // The verdicts do not need the book.
    let output = inside(elsewhere.path(), &[]).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(2));
    let [said, page] = [output.stderr, output.stdout].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    assert!(said.contains("no book found") && page.lines().count() > 5 && !page.contains("The book is in"), "{said}");
    assert!(names(elsewhere.path()).is_empty());
}

/// A workspace like ours in which the crates of the chapters have nothing but the number one.
fn workspace_with_crates() -> tempfile::TempDir {
    let workspace = small_workspace();
    let write = |file: &str, text: &str| {
        let path = workspace.path().join(file);
        fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
        fs::write(path, text).expect("writable");
    };
    let package = |name: &str| format!("[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n");
    let mut manifest = format!("{}[lib]\npath = \"lib.rs\"\n[dependencies]\n", package("geneva-suite"));
    for name in EXAMPLES.crates {
        write(&format!("crates/{name}/Cargo.toml"), &package(name));
        write(&format!("crates/{name}/src/lib.rs"), "pub const ONE: u8 = 1;\n");
        manifest += &format!("{name} = {{ path = \"crates/{name}\" }}\n");
    }
    write("Cargo.toml", &format!("{manifest}[workspace]\nexclude = [\"crates/documents\"]\n"));
    write("lib.rs", "");
    workspace
}

#[test]
fn the_program_mdbook_tests_the_chapters_without_being_told_where_the_crates_are() {
    let workspace = workspace_with_crates();
    let book = workspace.path().join("book").canonicalize().expect("it exists");
    let tested = |number: u8| {
        let text = format!("# Only\n\n```rust\nuse {}::ONE;\nassert_eq!(ONE, {number});\n```\n", EXAMPLES.crates[0]);
        fs::write(book.join("src/only.md"), &text).expect("writable");
        let chapter = json!({"name": "Only", "content": text, "number": [1], "sub_items": [], "path": "only.md",
                             "source_path": "only.md", "parent_names": []});
        let context = json!({"root": book, "config": {"book": {}}, "renderer": "test", "mdbook_version": "0.5.4"});
        piped_into(inside(&book, &["preprocess"]), &json!([context, {"items": [{"Chapter": chapter}]}]).to_string())
    };
    let output = tested(1);
    assert!(output.status.success(), "{output:?}");
    let answer: Value = serde_json::from_slice(&output.stdout).expect("a book and nothing else");
    assert_eq!(answer["items"][0]["Chapter"]["content"], "", "nothing is left for a rustdoc that knows no crates");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "Every Rust block of the book compiles and runs.\n");

    let output = tested(2);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && output.stdout.is_empty(), "{said}");
    assert!(said.contains("only.md") && said.contains("assertion") && !said.contains("E0463"), "{said}");
}

#[test]
fn a_book_that_is_built_without_rust_says_so_and_not_that_a_target_is_missing() {
    let workspace = small_workspace();
    fs::create_dir_all(workspace.path().join("crates/live")).expect("writable");
    fs::write(workspace.path().join("crates/live/Cargo.toml"), "").expect("writable");
    fs::write(workspace.path().join("book/src/only.md"), "# Only\n\n{{live:wheel}}\n").expect("writable");
    let mut command = inside(workspace.path(), &["book", "--output", "out"]);
    let output = command.env("PATH", "").env_remove("CARGO").output().expect("the program runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(said.contains("cargo does not run") && said.contains("https://rustup.rs"), "{said}");
    assert!(!said.contains("rustup target add"), "{said}");
}

#[test]
fn printing_says_what_it_lacks() {
    let workspace = small_workspace();
    let printing = |browser: &str, output: &str| {
        let mut command = inside(workspace.path(), &["book", "print", "--output", output]);
        command.env("CHROMIUM", browser).env("PATH", "");
        refusal(command)
    };
    let said = printing("", "book.pdf");
    assert!(said.contains("printing needs Chromium or Chrome") && said.contains("$CHROMIUM"), "{said}");
    for output in ["nowhere/book.pdf", "book"] {
        let said = printing("any", output);
        assert!(said.contains("name a file in a folder that is there with --output"), "{said}");
    }
    // A book without our chapters.
    let said = printing("any", "book.pdf");
    assert!(said.contains("has no page to be printed"), "{said}");
    assert_eq!(names(workspace.path()), ["book", "crates"]);
}

#[test]
fn an_ebook_goes_to_a_file_in_a_folder_that_is_there() {
    let workspace = small_workspace();
    for (output, why) in [
        ("nowhere/book.epub", "give another --output, in a folder that exists"),
        ("book", "is a folder; give a file in it"),
    ] {
        let said = refusal(inside(workspace.path(), &["book", "epub", "--output", output]));
        assert!(said.contains(why), "{said}");
    }
    assert_eq!(names(workspace.path()), ["book", "crates"]);
}

#[test]
fn a_renderer_of_others_gets_chapters_without_placeholders() {
    let workspace = small_workspace();
    let book = workspace.path().join("book").canonicalize().expect("it exists");
    let text = "# Only\n\nIt is {{printed:pin.radius}} in $x^2$.\n\n{{figure:pin-position}}\n\n{{live:wheel}}\n";
    let chapter = json!({"name": "Only", "content": text, "number": [1], "sub_items": [], "path": "only.md",
                         "source_path": "only.md", "parent_names": []});
    let context = json!({"root": book, "config": {"book": {}}, "renderer": "made-up", "mdbook_version": "0.5.4"});
    let input = json!([context, {"items": [{"Chapter": chapter}]}]).to_string();
    let output = piped_into(inside(&book, &["preprocess"]), &input);
    assert!(output.status.success(), "{output:?}");
    let answer: Value = serde_json::from_slice(&output.stdout).expect("a book and nothing else");
    let content = answer["items"][0]["Chapter"]["content"].as_str().expect("text");
    let printed = LEDGER.claim("pin.radius").expect("a claim").printed;
    for part in [printed, "<math", "<svg", "<figcaption>"] {
        assert!(content.contains(part), "no `{part}` in {content}");
    }
    for part in ["{{", "<button", "<input", "<script"] {
        assert!(!content.contains(part), "`{part}` in {content}");
    }
}
