//! `--since`: texts of strangers run nothing and hide nothing, and what cannot be compared is told.

use crate::command::{git, run};
use std::fs;
use std::path::Path;

const WRONG: &str = "New: $2 + 2 = 5$\n";

/// A repository with one commit that has a file `a.md`; none where there is no git.
fn repository() -> Option<tempfile::TempDir> {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.md"), "Old: $1 + 1 = 3$\n").expect("written");
    if !git(folder.path(), &["init", "-q"]) {
        println!("skipped: there is no git here");
        return None;
    }
    assert!(git(folder.path(), &["add", "."]) && git(folder.path(), &["commit", "-q", "-m", "first"]));
    Some(folder)
}

fn name(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

#[test]
fn a_text_runs_no_program_and_hides_nothing() {
    let Some(folder) = repository() else { return };
    let (ran, evil) = (folder.path().join("RAN"), folder.path().join("evil"));
    // A folder that looks like a repository with no work tree of its own: git lets it be committed.
    for inside in ["objects", "refs/heads"] {
        fs::create_dir_all(evil.join(inside)).expect("made");
        fs::write(evil.join(inside).join("keep"), "").expect("written");
    }
    fs::write(evil.join("HEAD"), "ref: refs/heads/main\n").expect("written");
    let settings = format!("[core]\n\tworktree = .\n\tfsmonitor = \"touch '{}'\"\n", ran.display());
    fs::write(evil.join("config"), settings).expect("written");
    fs::write(evil.join("text.md"), "Nothing.\n").expect("written");
    assert!(git(folder.path(), &["add", "."]) && git(folder.path(), &["commit", "-q", "-m", "second"]));
    fs::write(evil.join("text.md"), WRONG).expect("written");
    for path in [folder.path(), &evil, &evil.join("text.md")] {
        let (code, out, told) = run(&["--since", "HEAD", name(path)]);
        assert!(code == 1 && out.contains("1 finding:") && out.contains(WRONG.trim()), "{out}{told}");
    }
    assert!(!ran.exists());
}

#[test]
fn a_repository_inside_is_compared_with_the_one_around_it() {
    let Some(folder) = repository() else { return };
    let inside = folder.path().join("inside");
    fs::create_dir(&inside).expect("made");
    fs::write(inside.join("b.md"), WRONG).expect("written");
    assert!(git(&inside, &["init", "-q"]) && git(&inside, &["add", "."]));
    assert!(git(&inside, &["commit", "-q", "-m", "theirs"]));
    let (code, out, _) = run(&["--since", "HEAD", name(folder.path())]);
    assert!(code == 1 && out.contains(WRONG.trim()), "{out}");
    // Whoever names it means it.
    assert_eq!(run(&["--since", "HEAD", name(&inside)]).0, 0);
}

#[cfg(unix)]
#[test]
fn no_file_is_skipped_for_its_name() {
    use std::os::unix::ffi::OsStrExt;
    let Some(folder) = repository() else { return };
    let odd = folder.path().join("odd \n");
    fs::create_dir(&odd).expect("made");
    let file = |name: &[u8]| odd.join(std::ffi::OsStr::from_bytes(name));
    let names = [&b"caf\xe9.md"[..], b"b .md", b"c\n.md", b"-d.md", b"\xf0\x9f.md"];
    names.iter().for_each(|name| fs::write(file(name), "Old: $1 + 1 = 3$\n").expect("written"));
    assert!(git(folder.path(), &["add", "."]) && git(folder.path(), &["commit", "-q", "-m", "odd"]));
    assert_eq!(run(&["--since", "HEAD", name(folder.path())]).0, 0);
    names.iter().for_each(|name| fs::write(file(name), format!("Old: $1 + 1 = 3$\n\n{WRONG}")).expect("written"));
    for path in [folder.path(), &odd] {
        let (code, out, told) = run(&["--since", "HEAD", name(path)]);
        assert!(code == 1 && told.is_empty() && out.contains("5 findings:"), "{out}{told}");
    }
    // Nor is it if the whole repository is in such a folder.
    let moved = folder.path().with_extension("moved \n");
    fs::rename(folder.path(), &moved).expect("renamed");
    let (code, out, told) = run(&["--since", "HEAD", name(&moved)]);
    fs::rename(&moved, folder.path()).expect("renamed");
    assert!(code == 1 && told.is_empty() && out.contains("5 findings:"), "{out}{told}");
}

#[test]
fn what_cannot_be_compared_is_told_with_the_remedy() {
    let Some(folder) = repository() else { return };
    let inside = name(folder.path());
    for revision in ["nowhere", "-x", "^HEAD", "HEAD..HEAD", ""] {
        let (code, out, told) = run(&[&format!("--since={revision}"), inside]);
        let words = format!("git does not know the revision `{revision}` in ");
        assert!(code == 2 && out.is_empty() && told.contains(&words) && told.contains("give a commit"), "{told}");
    }
    assert_eq!(run(&["--since", ":/first", inside]).0, 0);
    let elsewhere = tempfile::tempdir().expect("a folder");
    let other = elsewhere.path().join("b.md");
    fs::write(&other, WRONG).expect("written");
    let (code, _, told) = run(&["--since", "HEAD", name(&other)]);
    let words = format!("{} is in no repository of git; give --since files of one, or leave it out", name(&other));
    assert!(code == 2 && told.contains(&words), "{told}");
    let (code, _, told) = run(&["--since", "HEAD", "-"]);
    assert!(code == 2 && told.contains("standard input has no earlier revision; give --since files"), "{told}");
    let lines = folder.path().join("all.jsonl");
    fs::write(&lines, "{\"id\": \"x\", \"text\": \"$1 + 1 = 3$\"}\n").expect("written");
    let (code, _, told) = run(&["--since", "HEAD", name(&lines)]);
    assert!(code == 2 && told.contains("x: a line of JSON has no earlier revision"), "{told}");
}
