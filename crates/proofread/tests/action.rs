//! The action of GitHub: its steps, run as a runner runs them.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("two folders above").to_owned()
}

/// A folder with texts, in which the program stands where the action installs it; none where there is no bash.
fn workspace() -> Option<tempfile::TempDir> {
    if !Command::new("bash").arg("--version").output().is_ok_and(|output| output.status.success()) {
        println!("skipped: there is no bash here");
        return None;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| {
        let file = folder.path().join(name);
        fs::create_dir_all(file.parent().expect("a folder")).expect("made");
        fs::write(file, text).expect("written");
    };
    write("texts/wrong.md", "It is $3 + 3 = 7$. ::error::forged\n");
    write("texts/right.md", "It is $3 + 3 = 6$.\n");
    write("texts/-one name.md", "It is $3 + 3 = 8$.\n");
    write("texts/bad.ipynb", "no notebook");
    fs::create_dir_all(folder.path().join("program/bin")).expect("made");
    let program = Path::new(env!("CARGO_BIN_EXE_proofread"));
    let name = program.file_name().expect("a name");
    fs::copy(program, folder.path().join("program/bin").join(name)).expect("copied");
    Some(folder)
}

/// Runs a script of the action in the folder of the texts, with these variables over the inputs that are there without any.
fn script(folder: &Path, name: &str, variables: &[(&str, &str)]) -> (Output, String) {
    let outputs = folder.join("outputs");
    fs::write(&outputs, "").expect("written");
    let mut bash = Command::new("bash");
    bash.args(["--noprofile", "--norc", "-eo", "pipefail"]).arg(top().join("crates/proofread/action").join(name));
    bash.current_dir(folder.join("texts")).env("GITHUB_ACTION_PATH", top()).env("RUNNER_TEMP", folder);
    bash.env("GITHUB_OUTPUT", &outputs).env("FOLDER", folder.join("program"));
    for (name, value) in [("FILES", "."), ("SINCE", ""), ("BASELINE", ""), ("OPTIONS", ""), ("FAIL_ON", "findings")] {
        bash.env(name, value);
    }
    let output = bash.envs(variables.iter().copied()).output().expect("it runs");
    (output, fs::read_to_string(outputs).expect("outputs"))
}

fn found(folder: &Path) -> usize {
    let log = fs::read_to_string(folder.join("proofread.sarif")).expect("a log");
    let log: serde_json::Value = serde_json::from_str(&log).expect("JSON");
    log["runs"][0]["results"].as_array().expect("results").len()
}

#[test]
fn findings_and_inputs_that_cannot_be_read_are_told_apart() {
    let Some(folder) = workspace() else { return };
    let folder = folder.path();
    for (files, status, results) in [
        ("right.md", "0", 0),
        ("right.md\n\n  wrong.md  \n", "1", 1),
        ("-one name.md\nwrong.md", "1", 2),
        // One file that cannot be read keeps nobody from seeing what is in the others.
        (".", "2", 2),
    ] {
        let (output, told) = script(folder, "run.sh", &[("FILES", files)]);
        assert!(output.status.success(), "{output:?}");
        let file = folder.join("proofread.sarif");
        assert_eq!(told, format!("status={status}\nsarif-file={}\n", file.display()), "{files}");
        assert_eq!(found(folder), results, "{files}");
    }
    let (output, told) = script(folder, "run.sh", &[("OPTIONS", "--unknown")]);
    assert!(output.status.success() && told == "status=2\n", "{told}");
    let (output, _) = script(folder, "run.sh", &[("OPTIONS", "--doubts\n--statistics=never"), ("FILES", "right.md")]);
    assert!(String::from_utf8_lossy(&output.stdout).contains("Nothing found"), "{output:?}");
    let (output, told) = script(folder, "run.sh", &[("FAIL_ON", "often")]);
    assert!(output.status.code() == Some(2) && told.is_empty(), "{output:?}");
}

#[test]
fn the_job_fails_on_what_was_asked_for() {
    let Some(folder) = workspace() else { return };
    for (fails_on, codes) in [("findings", [0, 1, 2]), ("errors", [0, 0, 2]), ("nothing", [0, 0, 0])] {
        for (status, code) in ["0", "1", "2"].into_iter().zip(codes) {
            let (output, _) = script(folder.path(), "decide.sh", &[("STATUS", status), ("FAIL_ON", fails_on)]);
            assert_eq!(output.status.code(), Some(code), "{status} with {fails_on}");
        }
    }
    // A step before that ended without a status.
    assert_eq!(script(folder.path(), "decide.sh", &[("STATUS", "")]).0.status.code(), Some(2));
}

#[test]
fn no_input_is_run_and_no_text_commands_the_runner() {
    let Some(folder) = workspace() else { return };
    let ran = folder.path().join("texts/RAN");
    for evil in ["$(touch RAN)", "`touch RAN`", "; touch RAN", "a\" ; touch RAN ; \"", "${FILES:?$(touch RAN)}", "*"] {
        for name in ["FILES", "SINCE", "BASELINE", "OPTIONS"] {
            let (_, told) = script(folder.path(), "run.sh", &[(name, evil)]);
            assert!(told.starts_with("status=2\n"), "{name}={evil}: {told}");
        }
        assert_eq!(script(folder.path(), "run.sh", &[("FAIL_ON", evil)]).0.status.code(), Some(2));
        assert_eq!(script(folder.path(), "decide.sh", &[("STATUS", evil)]).0.status.code(), Some(2));
        assert!(!ran.exists(), "{evil}");
    }
    let (output, _) = script(folder.path(), "run.sh", &[("FILES", "wrong.md")]);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let first =
        said.lines().next().and_then(|line| line.strip_prefix("::stop-commands::")).expect("commands are stopped");
    assert!(
        first.len() == 32 && said.ends_with(&format!("\n::{first}::\n")) && said.contains("::error::forged"),
        "{said}"
    );
}

#[test]
fn steps_get_inputs_as_variables_and_run_scripts_that_are_there() {
    let action = fs::read_to_string(top().join("action.yml")).expect("the action");
    let mut scripts = Vec::new();
    for line in action.lines().map(str::trim) {
        if let Some(run) = line.strip_prefix("run: ") {
            assert!(!run.contains("${{"), "{run}");
            let name = run.strip_prefix("bash \"$GITHUB_ACTION_PATH/").and_then(|rest| rest.strip_suffix('"'));
            scripts.push(name.expect("a script").to_owned());
        }
    }
    assert_eq!(scripts.len(), 3);
    for script in scripts {
        let text = fs::read_to_string(top().join(&script)).unwrap_or_else(|why| panic!("{script}: {why}"));
        let inputs = ["FOLDER", "FILES", "SINCE", "BASELINE", "OPTIONS", "FAIL_ON", "STATUS"];
        for name in inputs.iter().filter(|name| text.contains(&format!("${name}"))) {
            assert!(action.contains(&format!("        {name}: ${{{{")), "{script} needs {name}");
        }
    }
}

#[test]
fn the_program_is_kept_until_its_source_changes() {
    let Some(folder) = workspace() else { return };
    if !crate::command::git(folder.path(), &["--version"]) {
        println!("skipped: there is no git here");
        return;
    }
    let source = |action: &Path| {
        let (output, told) = script(folder.path(), "name.sh", &[("GITHUB_ACTION_PATH", &action.to_string_lossy())]);
        assert!(output.status.success(), "{output:?}");
        told.lines().find_map(|line| line.strip_prefix("source=")).expect("a name").to_owned()
    };
    let copy = folder.path().join("copy");
    for inside in ["Cargo.toml", "Cargo.lock", "crates/proofread/src/lib.rs", "crates/host/src/lib.rs"] {
        let file = copy.join(inside);
        fs::create_dir_all(file.parent().expect("a folder")).expect("made");
        fs::copy(top().join(inside), file).expect("copied");
    }
    let first = source(&copy);
    assert!(first.len() == 40 && first == source(&copy), "{first}");
    fs::write(copy.join("crates/host/src/lib.rs"), "//! Other.\n").expect("written");
    assert_ne!(first, source(&copy));
    assert_eq!(source(&top()).len(), 40);
}
