//! A file is either complete or as it was, even if the program is ended in the middle of its work.

use super::SMALL;
use crate::{geneva, is_ignored, refusal, run, until, written};
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// More than any machine computes before the test ends it: millions of rows, on one thread.
const LONG: [&str; 9] =
    ["sweep", "--slots", "3,4,6", "--friction", "0.01:0.02:2000", "--inertia-ratio", "0.5:1:1000", "--threads", "1"];

/// The number of the signal `INT`.
const INTERRUPT: i32 = 2;

fn to<'a>(options: &[&'a str], file: &'a str) -> Vec<&'a str> {
    [options, &["--output", file]].concat()
}

/// The names in a folder, in order.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<_> =
        entries.map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// A sweep that has begun to work and will not end for a long time.
fn begun(folder: &Path) -> Child {
    let mut command = geneva(&to(&LONG, "sweep.csv"));
    let mut child = command.current_dir(folder).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("it runs");
    until("the first row", || {
        assert!(child.try_wait().expect("a child").is_none(), "it is still at work");
        has_written(child.id(), folder)
    });
    child
}

/// Whether a process has written something into a file in this folder, which has no name. Where the system does not tell what
/// a process has open, this says so at once.
fn has_written(process: u32, folder: &Path) -> bool {
    let Ok(opened) = fs::read_dir(format!("/proc/{process}/fd")) else { return true };
    let in_folder = |path: &Path| fs::read_link(path).is_ok_and(|file| file.starts_with(folder));
    let is_written = |path: &Path| fs::metadata(path).is_ok_and(|file| file.len() > 0);
    opened.flatten().map(|entry| entry.path()).any(|path| in_folder(&path) && is_written(&path))
}

/// Ends it: by a signal with this name, or if there is none by force.
fn end(mut child: Child, signal: Option<&str>) {
    match signal {
        None => child.kill().expect("it can be ended"),
        Some(signal) => {
            let number = child.id().to_string();
            let sent = Command::new("kill").args(["-s", signal, &number]).status().expect("the system has `kill`");
            assert!(sent.success());
        }
    }
    assert!(!child.wait().expect("it ends").success());
}

#[test]
fn ended_in_the_middle_it_leaves_nothing_and_an_old_file_as_it_was() {
    let signals: &[_] = if cfg!(unix) { &[Some("INT"), Some("TERM"), None] } else { &[None] };
    for signal in signals.iter().filter(|signal| **signal != Some("INT") || !is_ignored(INTERRUPT)) {
        let folder = tempfile::tempdir().expect("a temporary folder");
        end(begun(folder.path()), *signal);
        assert_eq!(names(folder.path()), [""; 0], "{signal:?}");

        let file = folder.path().join("sweep.csv");
        fs::write(&file, "an old file\n").expect("writable");
        let child = begun(folder.path());
        assert_eq!(fs::read_to_string(&file).expect("it is there"), "an old file\n");
        end(child, *signal);
        assert_eq!(fs::read_to_string(&file).expect("it is still there"), "an old file\n", "{signal:?}");
        assert_eq!(names(folder.path()), ["sweep.csv"], "{signal:?}");
    }
}

#[test]
fn an_old_file_is_replaced_as_a_whole() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("sweep.csv");
    let path = file.to_string_lossy();
    fs::write(&file, "x".repeat(1 << 20)).expect("writable");
    let said = written(&to(&SMALL, &path), 0);
    assert!(said.ends_with("sweep.csv: 16 rows, 11 ok, 1 may-jam, 4 no-terminal-speed\n"), "{said}");
    assert_eq!(fs::read_to_string(&file).expect("it is there"), written(&to(&SMALL, "-"), 0));
    assert_eq!(names(folder.path()), ["sweep.csv"]);
}

#[cfg(unix)]
#[test]
fn others_may_read_it_as_any_new_file_and_a_link_stays_one() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().expect("a temporary folder");
    let [usual, file, link] = ["usual", "sweep.csv", "link.csv"].map(|name| folder.path().join(name));
    let mode = |path: &Path| fs::metadata(path).expect("it is there").permissions().mode() & 0o777;
    fs::write(&usual, "").expect("writable");
    written(&to(&SMALL, &file.to_string_lossy()), 0);
    assert_eq!(mode(&file), mode(&usual));

    symlink(&usual, &link).expect("a link");
    fs::set_permissions(&usual, fs::Permissions::from_mode(0o640)).expect("it is ours");
    written(&to(&SMALL, &link.to_string_lossy()), 0);
    assert!(fs::symlink_metadata(&link).expect("it is there").is_symlink());
    assert_eq!(fs::read(&usual).expect("it is there"), fs::read(&file).expect("it is there"));
    assert_eq!(mode(&usual), 0o640);
}

#[test]
fn a_place_where_no_file_can_be_is_refused_before_the_work() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("file"), "").expect("writable");
    fs::create_dir(folder.path().join("inside")).expect("writable");
    for place in ["no/such/folder/sweep.csv", "file/sweep.csv", "inside", "..", "/", ""] {
        let mut command = geneva(&to(&LONG, place));
        command.current_dir(folder.path());
        let said = refusal(command);
        assert!(said.starts_with("error: ") && said.contains(place) && said.contains("give "), "{place}: {said}");
    }
    assert_eq!(names(folder.path()), ["file", "inside"]);
    #[cfg(unix)]
    assert!(refusal(geneva(&to(&SMALL, "/dev/null"))).contains("not a file"));
}

#[test]
fn a_name_without_a_folder_is_one_in_this_folder() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let output = geneva(&to(&SMALL, "here.csv")).current_dir(folder.path()).output().expect("the program runs");
    assert!(output.status.success() && output.stdout.starts_with(b"here.csv: 16 rows"), "{output:?}");
    assert_eq!(names(folder.path()), ["here.csv"]);
    assert_eq!(fs::read(folder.path().join("here.csv")).expect("it is there"), run(&to(&SMALL, "-")).stdout);
}

#[test]
fn a_reader_that_has_seen_enough_is_no_error() {
    let mut child =
        geneva(&to(&LONG, "-")).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program runs");
    let mut line = String::new();
    BufReader::new(child.stdout.take().expect("a pipe")).read_line(&mut line).expect("a line");
    let output = child.wait_with_output().expect("it ends");
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
}
