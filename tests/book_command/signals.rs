//! A build that is ended by a signal leaves nothing behind, and leaves the old book as it was.

use super::{inside, names};
use crate::{is_ignored, is_ignored_by, refusal, small_workspace, until};
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use tempfile::TempDir;

const TERMINATE: (&str, i32) = ("TERM", 15);

/// The number of the signal `HUP`.
#[cfg(target_os = "linux")]
const HANG_UP: i32 = 1;

/// The signals that end a program here. Two of them do not where the tests run in the background of a shell or under `nohup`:
/// what starts there ignores them, and so do its children.
fn signals() -> impl Iterator<Item = (&'static str, i32)> {
    [("HUP", 1), ("INT", 2)].into_iter().filter(|(_, number)| !is_ignored(*number)).chain([TERMINATE])
}

/// One of them.
fn signal(at: usize) -> (&'static str, i32) {
    signals().nth(at).unwrap_or(TERMINATE)
}

/// A workspace whose book takes seconds, since it leads to the records for which every verdict is derived, and an old book in
/// its folder `out`.
fn workspace() -> TempDir {
    workspace_of("Every [claim](data/claims.json).")
}

/// A workspace with so many chapters of this text that a build takes a moment, and an old book in its folder `out`.
fn workspace_of(text: &str) -> TempDir {
    const CHAPTERS: usize = 60;
    let workspace = small_workspace();
    let (source, out) = (workspace.path().join("book/src"), workspace.path().join("out"));
    let summary: String = (0..CHAPTERS).map(|number| format!("- [Chapter {number}](c{number}.md)\n")).collect();
    fs::write(source.join("SUMMARY.md"), summary).expect("writable");
    for number in 0..CHAPTERS {
        fs::write(source.join(format!("c{number}.md")), format!("# Chapter {number}\n\n{text}\n")).expect("writable");
    }
    fs::create_dir(&out).expect("writable");
    fs::write(out.join("index.html"), "old").expect("writable");
    fs::write(out.join(".geneva-book"), "index.html\n").expect("writable");
    workspace
}

/// Starts a build into `out`, and waits until its hidden folder holds `awaited`.
#[track_caller]
fn started(mut command: Command, workspace: &Path, awaited: &str) -> (Child, PathBuf) {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program runs");
    let hidden = workspace.join(".out.geneva-build");
    until(awaited, || {
        assert!(child.try_wait().expect("a child").is_none(), "it ended before {awaited} was there");
        hidden.join(awaited).exists()
    });
    (child, hidden)
}

fn send(signal: &str, child: &Child) {
    let status = Command::new("kill").args(["-s", signal, &child.id().to_string()]).status().expect("kill runs");
    assert!(status.success());
}

fn build(workspace: &TempDir) -> Command {
    inside(workspace.path(), &["book", "build", "--output", "out"])
}

/// Ends a build by a signal: it says nothing, leaves nothing, and does not touch the old book.
#[track_caller]
fn assert_is_ended(workspace: &TempDir, child: Child, (signal, number): (&str, i32)) {
    send(signal, &child);
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.signal(), Some(number), "{signal}: {output:?}");
    assert!(output.stdout.is_empty() && output.stderr.is_empty(), "{signal}: {output:?}");
    assert_eq!(names(workspace.path()), ["book", "crates", "out"], "{signal}");
    assert_eq!(names(&workspace.path().join("out")), [".geneva-book", "index.html"], "{signal}");
}

#[test]
fn a_signal_ends_the_build_and_nothing_is_left() {
    let workspace = workspace();
    for signal in signals() {
        let (child, _) = started(build(&workspace), workspace.path(), "lock");
        assert_is_ended(&workspace, child, signal);
    }
    // Pages come late, where there is more to do before them: one signal must do.
    let workspace = workspace_of("Text.");
    let (child, _) = started(build(&workspace), workspace.path(), "new/c3.html");
    assert_is_ended(&workspace, child, signal(1));
}

#[test]
fn what_a_killed_build_leaves_is_cleared_by_the_next() {
    let workspace = workspace();
    let (mut child, hidden) = started(build(&workspace), workspace.path(), "lock");
    child.kill().expect("it runs");
    child.wait().expect("it ends");
    assert!(hidden.join("lock").is_file());
    fs::create_dir_all(hidden.join("new/css")).expect("writable");

    let (child, _) = started(build(&workspace), workspace.path(), "lock");
    until("an empty folder", || !hidden.join("new").exists());
    assert_is_ended(&workspace, child, signal(0));
}

#[test]
fn a_second_build_at_the_same_time_is_refused() {
    let workspace = workspace();
    let (child, hidden) = started(build(&workspace), workspace.path(), "lock");
    let said = refusal(build(&workspace));
    assert!(said.contains("another build into") && said.contains("wait for it"), "{said}");
    assert!(hidden.join("lock").is_file());
    assert_is_ended(&workspace, child, TERMINATE);
}

#[cfg(target_os = "linux")]
#[test]
fn a_signal_that_is_ignored_stays_ignored() {
    let workspace = workspace();
    let mut command = Command::new("sh");
    command.args(["-c", "trap '' HUP; exec \"$0\" book build --output out", env!("CARGO_BIN_EXE_geneva")]);
    command.current_dir(workspace.path());
    let (mut child, hidden) = started(command, workspace.path(), "lock");
    // The system drops what is ignored before the program sees it.
    assert!(is_ignored_by(child.id(), HANG_UP));
    send("HUP", &child);
    assert!(child.try_wait().expect("a child").is_none() && hidden.join("lock").is_file());
    assert_is_ended(&workspace, child, signal(1));
}
