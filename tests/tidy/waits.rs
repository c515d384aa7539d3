//! Does a test wait for what it waits for, and never for a time? On a busy machine any time is too short, and a time that is
//! compared says more about the machine than about the program. What something costs is measured by a benchmark.

/// What waits for a time, or asks how late it is.
const WORDS: [&str; 10] = [
    "setTimeout",
    "setInterval",
    "sleep(",
    "Instant::now",
    "elapsed(",
    "Duration::from_",
    "_timeout(",
    "SystemTime",
    "performance.now",
    "Date.now",
];

/// Lines of tests that have such a word all the same: the file, a part of the line, and why.
const EXCEPTIONS: &[(&str, &str, &str)] = &[
    ("crates/press/src/cache/tests.rs", "SystemTime::now() - 2 * LONG", "the age that a file pretends to have"),
    (
        "crates/proofread/tests/lsp.rs",
        "const PATIENCE: Duration = Duration::from_secs(600)",
        "patience for another process",
    ),
    ("crates/proofread/tests/lsp.rs", "recv_timeout(PATIENCE)", "the same patience"),
    ("crates/proofread/src/cli/lsp/session/tests.rs", "start: Instant::now()", "where a made-up time begins"),
    ("crates/proofread/src/cli/lsp/session/tests.rs", "Duration::from_millis(ms)", "the same made-up time"),
    ("tests/command_line.rs", "Instant::now() + Duration::from_secs(600)", "patience for another process"),
    ("tests/command_line.rs", "assert!(Instant::now() < end", "the same patience"),
    ("tests/command_line.rs", "sleep(Duration::from_millis(1))", "between two looks at what is awaited"),
    ("tests/browser/devtools.rs", "const PATIENCE: Duration = Duration::from_secs(600)", "patience for the browser"),
    ("tests/browser/devtools.rs", "Instant::now() + PATIENCE", "the same patience"),
    ("tests/browser/devtools.rs", "end.saturating_duration_since(Instant::now())", "the same patience"),
    ("tests/browser/devtools.rs", "recv_timeout(left)", "the same patience"),
    (
        "tests/browser/devtools.rs",
        "await new Promise(done => setTimeout(done, 10))",
        "between two looks at what is awaited",
    ),
    (
        "tests/browser/devtools.rs",
        "const own = setTimeout; globalThis.setTimeout",
        "has no page give up after some seconds",
    ),
    ("tests/browser/policy.rs", "setTimeout('window.ran=7')", "what a policy must not run"),
    (
        "tests/live/module.rs",
        "const own = setTimeout; globalThis.setTimeout",
        "counts frames instead of the page's seconds",
    ),
    ("tests/live/module.rs", "globalThis.setTimeout = own", "the end of that"),
];

/// The tests in a file: all of a file of tests, and of another what is behind the mark of its tests.
fn tests_in<'a>(path: &str, text: &'a str) -> &'a str {
    let is_of_tests = path.starts_with("tests/") || path.contains("/tests/") || path.ends_with("tests.rs");
    let mark = text.find("#[cfg(test)]").unwrap_or(text.len());
    if is_of_tests { text } else { &text[mark..] }
}

/// The lines of a file's tests that have such a word.
fn waits<'a>(path: &str, text: &'a str) -> Vec<&'a str> {
    let is_code = |line: &&str| !line.trim_start().starts_with("//");
    let has_one = |line: &&str| WORDS.iter().any(|word| line.contains(word));
    tests_in(path, text).lines().filter(is_code).filter(has_one).collect()
}

#[test]
fn tests_wait_for_events_and_compare_no_times() {
    let root = crate::path("");
    // This file names what it looks for.
    let own = |path: &String| path.ends_with("tidy/waits.rs") || path.ends_with("axe.min.js");
    let files: Vec<_> = ["tests", "crates"]
        .into_iter()
        .flat_map(|folder| crate::files(folder, &[".rs", ".js", ".html"]))
        .map(|(path, text)| (path.strip_prefix(&root).expect("inside").to_string_lossy().replace('\\', "/"), text))
        .filter(|(path, _)| !own(path))
        .collect();
    let mut needed = vec![false; EXCEPTIONS.len()];
    let mut wrong = Vec::new();
    for (path, text) in &files {
        for line in waits(path, text) {
            match EXCEPTIONS.iter().position(|(file, part, _)| file == path && line.contains(part)) {
                Some(at) => needed[at] = true,
                None => wrong.push(format!("{path}: {}", line.trim())),
            }
        }
    }
    assert!(wrong.is_empty(), "wait for an event, or measure it in a benchmark:\n{}", wrong.join("\n"));
    for ((file, part, _), needed) in EXCEPTIONS.iter().zip(needed) {
        assert!(needed, "{file}: `{part}` is no exception any more");
    }
}

#[test]
fn a_wait_is_found_in_tests_alone() {
    let library = "sleep(PAUSE);\n#[cfg(test)]\nmod tests {\n    // sleep(PAUSE);\n    sleep(PAUSE);\n}\n";
    assert_eq!(waits("crates/press/src/building.rs", library), ["    sleep(PAUSE);"]);
    assert_eq!(waits("crates/press/src/building/tests.rs", library).len(), 2);
    assert_eq!(waits("tests/live.rs", "await new Promise(done => setTimeout(done, 80))").len(), 1);
    assert_eq!(waits("crates/mimic/tests/running.rs", "assert!(start.elapsed().as_secs() < 10);").len(), 1);
    assert_eq!(waits("tests/live.rs", "await until(() => play.textContent)"), [""; 0]);
}
