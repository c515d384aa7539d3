//! Does every command that a document prints work as it is printed?
//!
//! Each command is in one of these groups, and the test fails for one that is in none. A line for our own programs is read by
//! their own parser, and runs if it asks for nothing of the reader's. A line that `.ci/run` runs has run there. In other
//! lines of Cargo, the names of packages, programs of tests and tests are looked up. What is left is in [`OTHERS`].

use crate::{answered, geneva};
use geneva_cli::check;
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use toml::Table;

/// Programs by whose names a command begins.
const PROGRAMS: [&str; 9] = ["bash", "cargo", "geneva", "git", "mdbook", "npm", "pip", "proofread", "rustup"];

/// The one command that accepts all changes of snapshots.
const ACCEPTS: &str = "INSTA_UPDATE=always cargo test --no-fail-fast";

/// Commands that are tried nowhere, with the reason.
const OTHERS: [(&str, &str); 19] = [
    ("cargo insta", "the name of a tool"),
    ("cargo insta review", "it asks questions"),
    ("cargo install --path crates/proofread", "it compiles a program that the tests have compiled"),
    ("cargo install --path crates/geneva", "it compiles a program that the tests have compiled"),
    ("cargo nextest run -p geneva-documents", "it needs a program that we do not install"),
    ("cargo package --workspace --no-verify", "what was tried once, in a decision"),
    ("cargo run -p geneva-example-drag", "a test builds its book"),
    ("cargo run -- book test", "`mdbook test book`, which `.ci/run` runs, asks the same preprocessor to test the same"),
    ("cargo run -- record numbers.toml", "a test in `tests/typed.rs` records these numbers"),
    ("find corpus -name '*.cnxml'", "of the system"),
    ("grep '\"document\"'", "of the system"),
    ("git diff snapshots", "git's own"),
    ("git status", "git's own"),
    ("mdbook serve book", "`mdbook build book`, which `.ci/run` runs, and it does not end"),
    ("mdbook test book --chapter NAME", "`mdbook test book`, which `.ci/run` runs, and NAME is the reader's"),
    ("pip install .", "`.ci/run` builds and installs the same package without optimisation"),
    ("proofread lsp", "an editor starts it and speaks to it, as the tests of the proofreader do"),
    ("pip install fonttools brotli", "only who changes the font needs them"),
    ("proofread --staged", "what it finds depends on what is staged; the proofreader's own tests run it in a hook"),
];

/// Commands that name a command of ours and leave the rest open, which is all that may be wrong with them.
const NAMES: [&str; 8] = [
    "proofread --format jsonl",
    "geneva escapement --friction MU",
    "geneva mimic check",
    "geneva mimic sort",
    "geneva new",
    "geneva proofread",
    "geneva wheel",
    "geneva wheel …",
];

/// What a reader puts in, and something that could be there.
const BY_READER: [(&str, &str); 16] = [
    ("FILE", "file.md"),
    ("COPY", "copy.txt"),
    ("DIR", "folder"),
    ("NAME", "pin"),
    ("MU", "0.3"),
    ("my-copy-of-the-thesis.txt", "copy.txt"),
    ("notes.tex", "notes.tex"),
    ("chapters/", "chapters/"),
    ("homework.ipynb", "homework.ipynb"),
    ("accepted.jsonl", "accepted.jsonl"),
    ("book/src", "book/src"),
    ("examples/paper", "examples/paper"),
    ("examples/paper/paper.tex", "examples/paper/paper.tex"),
    ("origin/main", "main"),
    ("HEAD", "HEAD"),
    (".", "."),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("crates/geneva is in it").to_owned()
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
}

/// The Markdown files of the project, but for the changelog, which prints commands of earlier versions.
fn documents() -> Vec<PathBuf> {
    let (mut found, mut folders) = (Vec::new(), vec![root()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("readable").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            if path.is_dir() && !["target", ".git", "snapshots", "data"].contains(&&*name) {
                folders.push(path);
            } else if name.ends_with(".md") && name != "CHANGELOG.md" {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// The commands in a document, in their order, without comments and with their continued lines in one.
fn commands(text: &str) -> Vec<String> {
    let (mut found, mut block, mut is_shell) = (Vec::new(), None::<String>, false);
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) if !language.starts_with("rust") => {
                (block, is_shell) = (Some(String::new()), &*language == "sh");
            }
            Event::Text(text) => block.iter_mut().for_each(|block| block.push_str(&text)),
            Event::End(TagEnd::CodeBlock) => {
                let lines = block.take().unwrap_or_default().replace("\\\n", " ");
                let lines = lines.lines().filter(|line| !line.trim_start().starts_with('#'));
                let bare = lines.map(|line| line.split(" #").next().unwrap_or_default());
                let parts = bare.flat_map(|line| line.split(" | ")).filter_map(alone);
                found.extend(parts.filter(|line| is_command(line) || is_shell));
            }
            Event::Code(code) => found.extend(alone(&code).filter(|line| is_command(line))),
            _ => {}
        }
    }
    found
}

/// The command alone: without the words before it in a file of settings or for another program that starts it, and without
/// what a shell does with its answer.
fn alone(line: &str) -> Option<String> {
    let words = line.split_whitespace();
    let words = words.skip_while(|word| ["$", "-", "run:", "entry:", "exec", "parallel", "-X"].contains(word));
    let words: Vec<_> = words.take_while(|word| ![">", "||", "&&"].contains(word)).collect();
    (!words.is_empty()).then(|| words.join(" "))
}

/// A program's name and something behind it, which is not its value in a file of settings.
fn is_command(line: &str) -> bool {
    let mut words = line.split(' ').skip_while(|word| is_variable(word));
    words.next().is_some_and(|word| PROGRAMS.contains(&word)) && words.next().is_some_and(|word| word != "=")
}

fn is_variable(word: &str) -> bool {
    let name = word.split_once('=').map_or("", |(name, _)| name);
    !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_uppercase() || byte == b'_')
}

/// What a line asks of our own programs, if it does.
fn ours(line: &str) -> Option<String> {
    let asked = ["cargo run -- ", "geneva "].iter().find_map(|program| line.strip_prefix(program)).map(str::to_owned);
    asked.or_else(|| line.starts_with("proofread ").then(|| line.to_owned()))
}

/// What is wrong with a line for our own programs.
fn misunderstood(asked: &str, folder: &Path) -> Option<String> {
    // A placeholder prints a question of the book.
    let asked = match asked.split_once("{{question:").and_then(|(_, rest)| rest.strip_suffix("}}")) {
        Some(name) => match geneva_chapters::questions::question(name) {
            Ok(question) => question,
            Err(why) => return Some(why.to_string()),
        },
        None => asked.to_owned(),
    };
    let words: Vec<&str> = asked.split(' ').filter(|word| *word != "…").collect();
    let is_readers = |word: &str| BY_READER.iter().find(|(reader, _)| *reader == word);
    let filled: Vec<&str> = words.iter().map(|word| is_readers(word).map_or(*word, |(_, put)| *put)).collect();
    if let Err(why) = check(["geneva"].iter().chain(&filled).map(OsString::from)) {
        let is_name = NAMES.iter().any(|name| ours(name).as_deref() == Some(&asked));
        return (!is_name || !why.contains("required arguments were not provided")).then_some(why);
    }
    let is_book = words.first() == Some(&"book");
    if is_book || words.iter().any(|word| is_readers(word).is_some()) {
        return None;
    }
    // What is written goes into a folder of its own, where the next command finds it.
    let writes = |word: &&str| ["--output", "--out"].contains(word) || word.ends_with(".deck");
    let (code, said) = if words.iter().any(writes) {
        let output = geneva(&words).current_dir(folder).output().expect("the program runs");
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    } else {
        let answer = answered(&words);
        (Some(answer.code.into()), answer.stderr)
    };
    (code != Some(0)).then(|| format!("exit code {code:?}: {said}"))
}

/// The lines that `.ci/run` runs. Two of them it takes from the README.
fn lines_of_ci() -> Vec<String> {
    let (script, readme) = (read(&root().join(".ci/run")), read(&root().join("README.md")));
    let mut lines: Vec<String> = script.lines().map(|line| line.trim().to_owned()).collect();
    for (pattern, begins) in [("'cargo test .*' README.md", "cargo test "), ("'cargo run' README.md", "cargo run")] {
        assert!(script.contains(&format!("grep -m1 -x {pattern}")), ".ci/run no longer looks for {pattern}");
        lines.extend(readme.lines().find(|line| line.starts_with(begins)).map(str::to_owned));
    }
    lines
}

/// Whether `.ci/run` installs this program in this version, or in any if none is named.
fn is_installed_by_ci(line: &str) -> bool {
    let words: Vec<_> = line.split(' ').collect();
    let tool = match words[..] {
        ["cargo", "install", tool] => format!("tool {tool} "),
        ["cargo", "install", tool, "--version", version] => format!("tool {tool} {version} "),
        _ => return false,
    };
    lines_of_ci().iter().any(|line| format!("{line} ").starts_with(&tool))
}

/// The packages of the workspace, each with its folder.
fn packages() -> BTreeMap<String, PathBuf> {
    let folders = fs::read_dir(root().join("crates")).expect("the crates").map(|entry| entry.expect("readable").path());
    let named = folders.chain([root()]).map(|folder| {
        let manifest: Table = read(&folder.join("Cargo.toml")).parse().expect("TOML");
        (manifest["package"]["name"].as_str().expect("a name").to_owned(), folder)
    });
    named.collect()
}

/// What is wrong with a line of Cargo: a name that nothing bears.
fn misnamed(line: &str) -> Option<String> {
    let mut words: Vec<String> =
        line.split(' ').skip_while(|word| is_variable(word)).skip(1).map(str::to_owned).collect();
    let settings: Table = read(&root().join(".cargo/config.toml")).parse().expect("TOML");
    if let Some(long) = words.first().and_then(|word| settings["alias"].get(word)) {
        let long = long.as_str().expect("an alias").split(' ').map(str::to_owned);
        words.splice(..1, long);
    }
    let kind = words.first().map(String::as_str);
    if !matches!(kind, Some("test" | "bench" | "clippy")) {
        return Some("it is in no list".to_owned());
    }
    let packages = packages();
    let (mut folders, mut targets, mut filters) = (Vec::new(), Vec::new(), Vec::new());
    let mut rest = words.iter().skip(1).map(String::as_str);
    while let Some(word) = rest.next() {
        match word {
            "-p" => match packages.get(rest.next().unwrap_or_default()) {
                Some(folder) => folders.push(folder.clone()),
                None => return Some("no such package".to_owned()),
            },
            "--test" => targets.push(("test", "tests", rest.next().unwrap_or_default())),
            "--bench" => targets.push(("bench", "benches", rest.next().unwrap_or_default())),
            "--skip" => filters.push(rest.next().unwrap_or_default()),
            "--record" if root().join(rest.next().unwrap_or_default()).is_file() => {}
            "--profile" if matches!(rest.next(), Some("dev" | "release")) => {}
            "-D" if rest.next() == Some("warnings") => {}
            "--workspace" | "--doc" | "--all-targets" | "--no-fail-fast" | "--nocapture" | "--" => {}
            word if word.starts_with('-') => return Some(format!("the option {word} is in no list")),
            word => filters.push(word),
        }
    }
    if folders.is_empty() {
        folders.push(root());
    }
    let has_target = |folder: &PathBuf, (section, place, name): (&str, &str, &str)| {
        let manifest: Table = read(&folder.join("Cargo.toml")).parse().expect("TOML");
        let listed = manifest.get(section).and_then(|all| all.as_array()).into_iter().flatten();
        let mut named = listed.filter_map(|target| target.get("name").and_then(|of| of.as_str()));
        let file = folder.join(place).join(name);
        named.any(|of| of == name) || file.with_extension("rs").is_file() || file.join("main.rs").is_file()
    };
    if let Some((_, _, name)) = targets.iter().find(|target| !folders.iter().any(|folder| has_target(folder, **target)))
    {
        return Some(format!("no program of tests or benches `{name}`"));
    }
    let bears = |folder: &PathBuf, name: &str| {
        sources(folder).any(|(path, text)| {
            let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            stem.contains(name) || text.lines().any(|line| line.trim_start().starts_with("fn ") && line.contains(name))
        })
    };
    let name = |filter: &str| filter.trim_end_matches("::").to_owned();
    let lost = filters.iter().find(|filter| !folders.iter().any(|folder| bears(folder, &name(filter))));
    lost.map(|filter| format!("no test's name contains `{filter}`"))
}

/// The sources of a package and its tests.
fn sources(folder: &Path) -> impl Iterator<Item = (PathBuf, String)> {
    let mut folders: Vec<_> = ["src", "tests"].iter().map(|place| folder.join(place)).collect();
    // The tests of the command line are with those between the crates.
    folders.extend(folder.ends_with("crates/geneva").then(|| root().join("tests")));
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten() {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|kind| kind == "rs") {
                found.push((path.clone(), read(&path)));
            }
        }
    }
    found.into_iter()
}

/// What is wrong with a command that a document prints.
fn fault(line: &str, folder: &Path) -> Option<String> {
    if line.contains("INSTA_UPDATE") {
        return (line != ACCEPTS).then(|| format!("there is one command for it: {ACCEPTS}"));
    }
    if OTHERS.iter().any(|(known, _)| *known == line) || lines_of_ci().iter().any(|of_ci| of_ci == line) {
        return None;
    }
    if let Some(asked) = ours(line) {
        return misunderstood(&asked, folder);
    }
    match line.strip_prefix("bash ") {
        Some(script) if root().join(script).is_file() => None,
        _ if is_installed_by_ci(line) => None,
        _ if line.split(' ').any(|word| word == "cargo") => misnamed(line),
        _ => Some("it is in no list".to_owned()),
    }
}

#[test]
fn every_command_that_a_document_prints_works() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (mut faults, mut seen) = (Vec::new(), Vec::new());
    for document in documents() {
        for line in commands(&read(&document)) {
            if let Some(why) = fault(&line, folder.path()) {
                faults.push(format!("{}: `{line}`: {why}", document.display()));
            }
            seen.push(line);
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(seen.len() > 100, "{}", seen.len());
    let unused =
        OTHERS.iter().map(|(line, _)| *line).chain(NAMES).filter(|known| !seen.iter().any(|line| line == known));
    assert_eq!(unused.collect::<Vec<_>>(), Vec::<&str>::new(), "no document prints these any more");
    let accepting = seen.iter().filter(|line| *line == ACCEPTS).count();
    assert_eq!(accepting, 2, "CONTRIBUTING and the document on the architecture say how to accept snapshots");
    let manifest: Table = read(&root().join("Cargo.toml")).parse().expect("TOML");
    let default = manifest["workspace"]["default-members"].as_array().expect("a list");
    let default: Vec<_> = default.iter().filter_map(|member| member.as_str()).collect();
    assert_eq!(default, [".", "crates/geneva"], "{ACCEPTS} accepts what the tests of these packages have written");
}

#[test]
fn a_command_that_does_not_work_is_found() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (line, why) in [
        ("cargo run -- claims --sources pin", "unexpected argument"),
        ("geneva wheel --stations 2", "exit code"),
        ("geneva mimic check --deep", "unexpected argument"),
        ("geneva {{question:no-such}}", "question"),
        ("cargo test -p geneva-ledgr", "no such package"),
        ("cargo test -p geneva-documents --test verdict", "`verdict`"),
        ("cargo test --test suite no_such_test_at_all", "`no_such_test_at_all`"),
        ("cargo test --wokspace", "--wokspace"),
        ("cargo swift", "no list"),
        ("cargo install mdbook --version 0.4.0", "no list"),
        ("INSTA_UPDATE=always cargo test --workspace", "one command"),
        ("mdbook test book -L target/book-libs", "no list"),
        ("mdbook biuld book", "no list"),
        ("bash .ci/runn", "no list"),
        ("rustup target add wasm32-wasip9", "no list"),
    ] {
        let said = fault(line, folder.path());
        assert!(said.as_ref().is_some_and(|said| said.contains(why)), "{line}: {said:?}");
    }
    let text = "Say `geneva claims`, `geneva` or `cargo  test\n--doc`.\n\n```sh\ncargo fast   # soon\ngeneva wheel \\\n  --help\n```\n\n\
                ```toml\nproofread = { path = \"x\" }\n```\n\n```yaml\n- run: geneva errata\n```\n\n```rust\ngeneva wheel;\n```\n";
    let expected = ["geneva claims", "cargo test --doc", "cargo fast", "geneva wheel --help", "geneva errata"];
    assert_eq!(commands(text), expected);
}
