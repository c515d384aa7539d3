//! Does a pipe get text alone, and may its reader go when it likes?

use crate::{errata, geneva};
use geneva_cli::CommandOutput;
use std::io::{BufRead, BufReader};
use std::process::Stdio;

#[test]
fn nothing_but_text_goes_into_a_pipe() {
    let CommandOutput { stdout, stderr, code } = errata();
    assert!(!stdout.contains('\u{1b}') && stderr.is_empty() && *code == 0, "{stderr}");
    for arguments in [
        &["claims", "--source", "quick-return"][..],
        &["errata", "--source", "quick-return", "--all"],
        &["coverage"],
        &["--help"],
        &["claims", "--source", "pim"],
        &["wheel", "--stations", "6"],
        &["wheel", "--stations", "2"],
    ] {
        for no_color in [None, Some("1")] {
            let mut command = geneva(arguments);
            command.envs(no_color.map(|value| ("NO_COLOR", value)));
            let output = command.output().expect("the program runs");
            let escapes = [&output.stdout, &output.stderr].into_iter().flatten().filter(|byte| **byte == 0x1b);
            assert_eq!(escapes.count(), 0, "{arguments:?}");
            assert_eq!(output.stderr.is_empty(), output.status.success(), "{arguments:?}");
        }
    }
}

#[test]
fn colour_is_shown_when_asked_for_and_no_color_wins() {
    let coloured = |variables: &[(&str, &str)]| {
        let output =
            geneva(&["claims", "--source", "pin"]).envs(variables.iter().copied()).output().expect("the program runs");
        output.stdout.contains(&0x1b)
    };
    assert!(coloured(&[("CLICOLOR_FORCE", "1")]));
    assert!(!coloured(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]));
}

#[test]
fn a_reader_that_has_seen_enough_is_no_error() {
    let claims = ["claims", "--source", "quick-return"];
    for arguments in [
        &claims[..],
        &[&claims[..], &["--format", "json"]].concat(),
        &["mimic", "run", "escapement"],
        &["completions", "zsh"],
    ] {
        let mut child =
            geneva(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program runs");
        let mut line = String::new();
        // The reader is dropped, and the pipe with it, after one line.
        BufReader::new(child.stdout.take().expect("a pipe")).read_line(&mut line).expect("a line");
        let output = child.wait_with_output().expect("it ends");
        assert!(output.status.success() && output.stderr.is_empty(), "{arguments:?}: {output:?}");
    }
    // Closed before the first character.
    let mut child = geneva(&claims).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program runs");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
}
