//! Can a stranger use the formulas from their comments? Each has an example that runs and asserts something.
//!
//! Two rules without exceptions by name. A public function that belongs to no type has an example in its own comment. A
//! public type that is made with `new` has one in its comment or in that of `new`. Cargo runs the examples; here we ask that
//! they exist, that none is switched off, and that each asserts something.

/// The crates whose comments are held to the rules.
const PACKAGES: [&str; 4] = ["exact", "kinematics", "dynamics", "mimic"];

/// The examples of a comment, each with the word behind its opening fence, which is empty for one that runs.
fn examples(comment: &[&str]) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    let mut open = false;
    for line in comment.iter().map(|line| line.trim().trim_start_matches(['/', '!']).trim()) {
        match line.strip_prefix("```") {
            Some(_) if open => open = false,
            Some(word) => {
                open = true;
                found.push((word.to_owned(), String::new()));
            }
            None if open => {
                if let Some((_, code)) = found.last_mut() {
                    *code += line;
                    code.push('\n');
                }
            }
            None => {}
        }
    }
    found
}

/// Whether an example runs and asserts something.
fn is_checked((word, code): &(String, String)) -> bool {
    word.is_empty() && code.lines().any(|line| line.trim_start().starts_with("assert"))
}

/// The lines of the comment before a line, past the attributes between.
fn comment_of<'a>(lines: &'a [&'a str], at: usize) -> &'a [&'a str] {
    let starts = |line: &str, with: &str| line.trim_start().starts_with(with);
    let end = (0..at).rev().find(|k| !starts(lines[*k], "#[")).map_or(0, |k| k + 1);
    let from = (0..end).rev().find(|k| !starts(lines[*k], "///")).map_or(0, |k| k + 1);
    &lines[from..end]
}

/// The name that follows one of these words at the start of a line.
fn named<'a>(line: &'a str, words: &[&str]) -> Option<&'a str> {
    let rest = words.iter().find_map(|word| line.strip_prefix(word))?;
    rest.split(|of: char| !of.is_alphanumeric() && of != '_').next()
}

/// The type of an `impl` block without a trait that begins at this line.
fn implemented(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("impl").filter(|rest| rest.starts_with([' ', '<']) && !rest.contains(" for "))?;
    // Past the block's own parameters, which may hold brackets themselves.
    let mut depth = 0;
    let past = rest.find(|of: char| {
        depth += i32::from(of == '<') - i32::from(of == '>');
        of == ' ' && depth == 0
    })?;
    named(&rest[past..], &[" "])
}

/// What a file lacks: the functions and types that need an example and have none, each with its line.
fn without_an_example(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let has_one = |at: usize| examples(comment_of(&lines, at)).iter().any(is_checked);
    let mut found = Vec::new();
    let mut block = None;
    for (at, line) in lines.iter().enumerate() {
        if let Some(name) = named(line, &["pub fn ", "pub const fn "])
            && !has_one(at)
        {
            found.push(format!("{}: {name}", at + 1));
        }
        if line.starts_with("impl") {
            block = implemented(line);
        }
        let is_new = named(line, &["    pub fn ", "    pub const fn "]) == Some("new");
        let made = block.filter(|_| is_new && !has_one(at));
        let public = |line: &&str| named(line, &["pub struct ", "pub enum "]).is_some_and(|of| made == Some(of));
        if let Some(of) = lines.iter().position(public)
            && !has_one(of)
        {
            found.push(format!("{}: {}", of + 1, lines[of].trim_end_matches(" {")));
        }
    }
    found
}

#[test]
fn every_formula_has_an_example() {
    let mut found = Vec::new();
    for package in PACKAGES {
        for (path, text) in crate::files(&format!("crates/{package}/src"), &[".rs"]) {
            found.extend(without_an_example(&text).into_iter().map(|item| format!("{}:{item}", path.display())));
        }
    }
    assert!(found.is_empty(), "{} need an example that asserts something:\n{}", found.len(), found.join("\n"));
}

#[test]
fn every_example_runs_and_asserts() {
    let mut count = 0;
    for package in PACKAGES {
        for (path, text) in crate::files(&format!("crates/{package}/src"), &[".rs"]) {
            let comments: Vec<&str> =
                text.lines().filter(|line| ["///", "//!"].iter().any(|of| line.trim_start().starts_with(of))).collect();
            for example in examples(&comments) {
                assert!(is_checked(&example), "{}: no word behind ```, and an assertion: {example:?}", path.display());
                count += 1;
            }
        }
    }
    assert!(count > 100, "only {count} examples were found");
}

#[test]
fn an_example_is_asked_of_free_functions_and_of_types_with_new() {
    let lacking = |text: &str| without_an_example(text).len();
    let example = "/// ```\n/// assert!(true);\n/// ```\n";
    assert_eq!(lacking("/// A speed.\npub fn speed() -> f64 {"), 1);
    assert_eq!(lacking(&format!("/// A speed.\n///\n{example}#[inline]\npub fn speed() -> f64 {{")), 0);
    assert_eq!(lacking("/// A speed.\n/// ```\n/// let speed = 1;\n/// ```\npub fn speed() -> f64 {"), 1);
    assert_eq!(lacking("/// A speed.\n/// ```text\n/// assert\n/// ```\npub fn speed() -> f64 {"), 1);
    assert_eq!(lacking("/// A speed.\nfn speed() -> f64 {"), 0);
    let made = "pub struct Wheel<S> {\n}\nimpl<S: Into<f64>> Wheel<S> {\n    pub fn new() -> Self {";
    assert_eq!(lacking(made), 1);
    assert_eq!(lacking(&format!("{example}{made}")), 0);
    assert_eq!(lacking(&made.replace("    pub fn", &format!("{example}    pub fn"))), 0);
    assert_eq!(lacking(&made.replace("pub struct", "pub(super) struct")), 0);
}
