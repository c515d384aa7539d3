//! `--staged`: what is about to be committed counts, and not what is on the disk.

use crate::command::{git, run};
use std::fs;
use std::path::Path;

const WRONG: &str = "It is $3 + 3 = 7$.\n";
const RIGHT: &str = "It is $3 + 3 = 6$.\n";

/// A repository without a commit; none where there is no git.
fn repository() -> Option<tempfile::TempDir> {
    let folder = tempfile::tempdir().expect("a folder");
    if !git(folder.path(), &["init", "-q", "-b", "main"]) {
        println!("skipped: there is no git here");
        return None;
    }
    Some(folder)
}

fn write(folder: &Path, name: &str, text: &str) {
    let file = folder.join(name);
    fs::create_dir_all(file.parent().expect("a folder")).expect("made");
    fs::write(file, text).expect("written");
}

fn commit(folder: &Path) {
    assert!(git(folder, &["add", "--all"]) && git(folder, &["commit", "-q", "--no-verify", "-m", "a commit"]));
}

/// Exit code, standard output and standard error for files of a folder.
fn staged(folder: &Path, names: &[&str]) -> (u8, String, String) {
    let files: Vec<String> = names.iter().map(|name| folder.join(name).to_string_lossy().into_owned()).collect();
    let mut line = vec!["--staged"];
    line.extend(files.iter().map(String::as_str));
    run(&line)
}

#[test]
fn what_is_staged_counts_and_not_the_disk() {
    let Some(folder) = repository() else { return };
    let folder = folder.path();
    // Before the first commit, all is new.
    write(folder, "parts/a.md", WRONG);
    assert!(git(folder, &["add", "--all"]));
    write(folder, "parts/a.md", RIGHT);
    write(folder, "parts/untracked.md", WRONG);
    for name in [".", "parts", "parts/a.md"] {
        let (code, out, told) = staged(folder, &[name]);
        assert!(code == 1 && out.contains("1 finding:") && out.contains(WRONG.trim()), "{name}: {out}{told}");
    }
    fs::remove_dir_all(folder.join("parts")).expect("removed");
    for name in [".", "parts", "parts/a.md", "elsewhere/../parts"] {
        let (code, out, told) = staged(folder, &[name]);
        assert!(code == 1 && out.contains("1 finding:") && out.contains(WRONG.trim()), "{name}: {out}{told}");
    }
    write(folder, "parts/a.md", RIGHT);
    assert!(git(folder, &["add", "--all"]));
    write(folder, "parts/a.md", WRONG);
    assert_eq!(staged(folder, &["."]).0, 0);
}

#[test]
fn only_what_is_new_since_the_last_commit_is_reported() {
    let Some(folder) = repository() else { return };
    let folder = folder.path();
    let long = "A line of text that goes on.\n".repeat(20);
    write(folder, "a.md", &format!("{long}{WRONG}"));
    write(folder, "b.md", WRONG);
    commit(folder);
    write(folder, "a.md", &format!("{WRONG}{long}And $2 + 2 = 5$.\n"));
    assert_eq!(staged(folder, &["."]).0, 0, "nothing is staged yet");
    assert!(git(folder, &["add", "--all"]));
    let (code, out, told) = staged(folder, &["."]);
    assert!(code == 1 && out.contains("1 finding:") && out.contains("2 + 2"), "{out}{told}");
    // A revision takes the place of HEAD.
    commit(folder);
    assert_eq!(staged(folder, &["."]).0, 0);
    let name = folder.to_string_lossy().into_owned();
    let (code, out, _) = run(&["--staged", "--since", "HEAD~1", &name]);
    assert!(code == 1 && out.contains("1 finding:"), "{out}");
    let (code, _, told) = run(&["--staged", "--since", "nowhere", &name]);
    assert!(code == 2 && told.contains("git does not know the revision `nowhere`"), "{told}");
    // A file that was moved is what it was; a copy is new.
    assert!(git(folder, &["mv", "a.md", "c.md"]) && git(folder, &["rm", "-q", "b.md"]));
    for name in [".", "a.md", "b.md", "c.md"] {
        assert_eq!(staged(folder, &[name]).0, 0, "{name}");
    }
    write(folder, "d.md", WRONG);
    assert!(git(folder, &["add", "--all"]));
    write(folder, "d.md", RIGHT);
    assert_eq!(staged(folder, &["d.md"]).0, 0, "it is b.md, moved");
    write(folder, "b.md", WRONG);
    assert!(git(folder, &["add", "b.md"]));
    assert_eq!(staged(folder, &["d.md"]).0, 1);
}

#[test]
fn definitions_come_from_the_index_too() {
    let Some(folder) = repository() else { return };
    let folder = folder.path();
    let main = "\\documentclass{article}\\input{names}\\begin{document}\\input{text}\\end{document}\n";
    write(folder, "main.tex", main);
    write(folder, "names.tex", "\\newcommand{\\three}{3}\n");
    write(folder, "text.tex", "It is $\\three + 3 = 7$.\n");
    assert!(git(folder, &["add", "--all"]));
    write(folder, "names.tex", "\\newcommand{\\three}{4}\n");
    let (code, out, _) = staged(folder, &["text.tex"]);
    assert!(code == 1 && out.contains("printed 7, recomputed 6"), "{out}");
    fs::remove_file(folder.join("names.tex")).expect("removed");
    fs::remove_file(folder.join("main.tex")).expect("removed");
    assert_eq!(staged(folder, &["."]).0, 1);
    // A file that is on the disk alone defines nothing.
    write(folder, "main.tex", main);
    write(folder, "names.tex", "\\newcommand{\\three}{3}\n");
    assert!(git(folder, &["rm", "-q", "--cached", "names.tex"]));
    let (code, out, _) = staged(folder, &["text.tex"]);
    assert!(code == 0 && out.contains("\\three"), "{out}");
}

/// Begins to merge two branches that change the same line of `a.md`, each with a file of its own with such a text if one is given.
fn begin_merge_in_conflict(folder: &Path, own: Option<&str>) {
    write(folder, "a.md", RIGHT);
    commit(folder);
    for (branch, text) in [("one", "One: $3 + 3 = 7$\n"), ("two", "Two: $3 + 3 = 8$\n")] {
        assert!(git(folder, &["checkout", "-q", "-b", branch, "main"]));
        write(folder, "a.md", text);
        own.into_iter().for_each(|own| write(folder, &format!("{branch}.md"), own));
        commit(folder);
    }
    assert!(!git(folder, &["merge", "-q", "one"]));
}

#[test]
fn a_conflict_a_submodule_and_a_file_that_is_not_staged_are_told_apart() {
    let Some(folder) = repository() else { return };
    let folder = folder.path();
    begin_merge_in_conflict(folder, None);
    for name in [".", "a.md"] {
        let (code, _, told) = staged(folder, &[name]);
        assert!(code == 2 && told.contains("a.md: a merge left this file in conflict"), "{told}");
    }
    assert!(git(folder, &["reset", "-q", "--hard"]));
    let inside = folder.join("inside");
    write(&inside, "b.md", WRONG);
    assert!(git(&inside, &["init", "-q"]));
    commit(&inside);
    assert!(git(folder, &["add", "inside"]));
    assert_eq!(staged(folder, &["."]).0, 0, "it has its own commits");
    write(&inside, "b.md", "It is $2 + 2 = 5$.\n");
    assert!(git(&inside, &["add", "b.md"]));
    assert_eq!(staged(folder, &["inside", "."]).0, 1, "whoever names it means it");
    write(folder, "new.md", WRONG);
    let (code, _, told) = staged(folder, &["new.md"]);
    assert!(code == 2 && told.contains("new.md is not staged in git; give a file or folder that is"), "{told}");
    let (code, _, told) = run(&["--staged", "-"]);
    assert!(code == 2 && told.contains("standard input is not staged"), "{told}");
    let elsewhere = tempfile::tempdir().expect("a folder");
    let (code, _, told) = staged(elsewhere.path(), &["a.md"]);
    assert!(code == 2 && told.contains("is in no repository of git; give --staged files of one"), "{told}");
}

#[cfg(unix)]
#[test]
fn a_hook_reads_what_is_being_committed() {
    use std::os::unix::fs::PermissionsExt;
    let Some(folder) = repository() else { return };
    let folder = folder.path();
    let hook = folder.join(".git/hooks/pre-commit");
    write(
        folder,
        ".git/hooks/pre-commit",
        &format!("#!/bin/sh\nexec '{}' --staged\n", env!("CARGO_BIN_EXE_proofread")),
    );
    fs::set_permissions(&hook, fs::Permissions::from_mode(0o755)).expect("made a program");
    write(folder, "a.md", RIGHT);
    write(folder, "b.md", RIGHT);
    assert!(git(folder, &["add", "--all"]) && git(folder, &["commit", "-qm", "all is right"]));
    // A mistake that is staged, and mended on the disk alone.
    write(folder, "a.md", WRONG);
    assert!(git(folder, &["add", "a.md"]));
    write(folder, "a.md", RIGHT);
    assert!(!git(folder, &["commit", "-qm", "a mistake"]));
    // Git makes an index for these commits alone.
    write(folder, "a.md", WRONG);
    assert!(!git(folder, &["commit", "-qam", "a mistake"]) && !git(folder, &["commit", "-qm", "a mistake", "a.md"]));
    // A commit of another file doesn't have the mistake.
    write(folder, "b.md", "It is $3 + 3 = 6$, I think.\n");
    assert!(git(folder, &["commit", "-qm", "another file", "b.md"]));
    write(folder, "a.md", RIGHT);
    write(folder, "c.md", WRONG);
    assert!(git(folder, &["add", "--all"]) && !git(folder, &["commit", "-qm", "a new file"]));
    write(folder, "c.md", RIGHT);
    assert!(git(folder, &["add", "--all"]) && git(folder, &["commit", "-qm", "all is right"]));
    // From a folder below, git starts its hooks at the top.
    write(folder, "below/d.md", WRONG);
    assert!(git(folder, &["add", "--all"]) && !git(&folder.join("below"), &["commit", "-qm", "below"]));
    assert!(git(folder, &["mv", "c.md", "e.md"]) && git(folder, &["rm", "-qf", "below/d.md"]));
    assert!(git(folder, &["commit", "-qm", "moved and removed"]));
}

#[test]
fn a_merge_brings_in_what_neither_side_had() {
    let Some(folder) = repository() else { return };
    let folder = folder.path();
    begin_merge_in_conflict(folder, Some(WRONG));
    for (text, code) in [
        ("Both: $3 + 3 = 7$ and $3 + 3 = 8$\n", 0),
        ("Twice: $3 + 3 = 7$ and $3 + 3 = 7$\n", 1),
        ("Another: $3 + 3 = 9$\n", 1),
    ] {
        write(folder, "a.md", text);
        assert!(git(folder, &["add", "--all"]));
        let (found, out, told) = staged(folder, &["."]);
        assert!(found == code && (code == 0 || out.contains("1 finding:")), "{text}: {out}{told}");
    }
    // Without the merge, what the other side had is new.
    let name = folder.to_string_lossy().into_owned();
    assert!(run(&["--staged", "--since", "HEAD", &name]).1.contains("2 findings:"));
}

#[test]
fn names_are_shown_from_the_working_directory() {
    let Some(folder) = repository() else { return };
    write(folder.path(), "below/a.md", WRONG);
    write(folder.path(), "b.csv", "a,b\n");
    write(folder.path(), "c.jsonl", "{\"text\": \"$3 + 3 = 7$\"}\n");
    assert!(git(folder.path(), &["add", "--all"]));
    for (place, name) in [("", "below/a.md:1:"), ("below", "../below/a.md:1:")] {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_proofread"));
        let output = command.arg("--staged").current_dir(folder.path().join(place)).output().expect("it runs");
        let out = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.code() == Some(1) && out.contains(&format!(" --> {name}")), "{out}");
        assert!(out.contains("1 finding:"), "{out}");
    }
}

#[test]
fn a_stopped_commit_is_told_both_ways_out() {
    let Some(folder) = repository() else { return };
    let folder = folder.path();
    write(folder, "a.md", WRONG);
    assert!(git(folder, &["add", "--all"]));
    let words = |out: &str| out.split_whitespace().collect::<Vec<_>>().join(" ");
    let (code, out, _) = staged(folder, &["."]);
    assert_eq!(code, 1);
    assert!(words(&out).contains("correct this and add it, or accept it with `proofread --staged --accept"), "{out}");
    assert!(words(&out).contains("`proofread --staged --baseline accepted.jsonl`"), "{out}");
    // The command that is told works as it stands, also where the program is not on the path.
    let program = env!("CARGO_BIN_EXE_proofread");
    let told = std::process::Command::new(program).args(["--staged"]).current_dir(folder).output().expect("it runs");
    let told = words(&String::from_utf8_lossy(&told.stdout));
    assert!(told.contains(&format!("`{program} --staged --accept accepted.jsonl`")), "{told}");
    // The second way leads out.
    let [cases, top] = ["cases.jsonl", "."].map(|name| folder.join(name).to_string_lossy().into_owned());
    assert_eq!(run(&["--staged", "--accept", &cases, &top]).0, 0);
    assert_eq!(run(&["--staged", "--baseline", &cases, &top]).0, 0);
    write(folder, "b.md", WRONG);
    assert!(git(folder, &["add", "--all"]));
    let (code, out, _) = run(&["--staged", "--baseline", &cases, &top]);
    assert!(code == 1 && words(&out).contains(&format!("--accept {cases}` and add {cases}.")), "{out}");
    // Without a commit, and where nothing is found, nothing is stopped.
    assert!(!run(&[&top]).1.contains("To go on"));
    write(folder, "a.md", RIGHT);
    write(folder, "b.md", RIGHT);
    assert!(git(folder, &["add", "--all"]));
    assert!(!staged(folder, &["."]).1.contains("To go on"));
}
