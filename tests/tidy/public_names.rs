//! Does a public name say what it stands for? A type's name stands for one thing in all crates, and a function's is a verb, a
//! question or a quantity. Both are looked up by strangers, in a list, far from the line that they were made for.

use super::sources::{Source, public_items, sources, sources_of};
use std::collections::BTreeMap;

/// Names of types that stand for several things all the same, one a line: the name, a colon, and each thing, between semicolons.
const KNOWN_TYPES: &str = "tests/tidy/type_names.txt";

/// How many lines of that kind there may be: lower it when a name stands for one thing again.
const MOST_KNOWN_TYPES: usize = 73;

/// Functions that are named by such a word all the same, one a line: the word, and how many functions of that name there are.
const KNOWN_FUNCTIONS: &str = "tests/tidy/function_names.txt";

/// How many such functions there may be in all: lower it when one has another name.
const MOST_KNOWN_FUNCTIONS: usize = 160;

/// Words that only lead from one thing to another. `from` is Rust's name for what makes a value from another one.
const PREPOSITIONS: &str = "\
    about above across after against along among apart around at before behind below beneath beside between beyond \
    by despite down during except for inside into like near of off on onto out outside over past per since through \
    to toward under until up upon with within without";

/// Words that stand for something that was said elsewhere, and words that only join.
const PRONOUNS: &str = "\
    all also and another any anything both but each either every everything few here how it many more neither none \
    nothing one only or other others own several some something such that them then there these they this those \
    together what where which who";

/// Participles that do not say of what. Those that name an operation on the value at hand, as `rounded` does, are none.
const PARTICIPLES: &str = "\
    asked called carried changing chosen cited claimed cleared coming counted described describing done drawn \
    explained folded followed following found freed given giving going gone headed held joined judged kept known \
    left linked listed lost made making met missing moved moving named parted placed placing put_in quoted said \
    saying seen settled shown sought spent stated taken taking telling tied told tried typed unexplained unread \
    unsaid untold witnessed written";

/// Where public items of some kind are declared, by their names: `figures/svg/canvas.rs`.
fn places_by_name<'a>(sources: &'a [Source], keywords: &'a [&str]) -> BTreeMap<&'a str, Vec<String>> {
    let mut places: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for source in sources {
        for (_, name, line) in public_items(&source.code, keywords) {
            places.entry(name).or_default().push(format!("{}/src/{}:{line}", source.package, source.file));
        }
    }
    places
}

/// What has to change in the list of names of types, or in the code: a line for each, none if both agree.
fn complaints_on_types(known: &str, places: &BTreeMap<&str, Vec<String>>) -> Vec<String> {
    let count = |name: &str| places.get(name).map_or(0, Vec::len);
    let known: BTreeMap<&str, &str> = known.lines().map(|line| line.split_once(": ").unwrap_or((line, ""))).collect();
    let mut complaints = Vec::new();
    for (name, things) in &known {
        let things = things.split(';').filter(|thing| thing.trim().len() > 3).count();
        match count(name) {
            0 | 1 => complaints.push(format!("{name} stands for one thing at most; delete its line")),
            count if count != things => complaints.push(format!(
                "{name} stands for {count} things, and its line says {things}: let it say those of\n    {}",
                places[name].join("\n    ")
            )),
            _ => {}
        }
    }
    for (name, places) in places.iter().filter(|(name, places)| places.len() > 1 && !known.contains_key(**name)) {
        complaints
            .push(format!("{name} stands for several things; say in a name which:\n    {}", places.join("\n    ")));
    }
    complaints
}

#[test]
fn a_public_type_name_stands_for_one_thing() {
    let known = std::fs::read_to_string(crate::path(KNOWN_TYPES)).expect("the list");
    assert!(known.lines().is_sorted(), "{KNOWN_TYPES} is sorted");
    assert!(known.lines().count() <= MOST_KNOWN_TYPES, "{KNOWN_TYPES} only gets shorter");
    let complaints =
        complaints_on_types(&known, &places_by_name(sources(), &["struct", "enum", "trait", "type", "union"]));
    assert!(complaints.is_empty(), "{KNOWN_TYPES}:\n{}", complaints.join("\n"));
}

/// What has to change in the list of names of functions, or in the code: a line for each, none if both agree.
fn complaints_on_functions(known: &str, places: &BTreeMap<&str, Vec<String>>) -> Vec<String> {
    let known: BTreeMap<&str, usize> = known
        .lines()
        .map(|line| line.split_once(' ').unwrap_or((line, "")))
        .map(|(name, count)| (name, count.parse().unwrap_or(0)))
        .collect();
    let is_bare = |name: &str| {
        [PREPOSITIONS, PRONOUNS, PARTICIPLES].iter().any(|words| words.split(' ').any(|word| word == name))
    };
    let mut complaints = Vec::new();
    for (name, before) in &known {
        let now = places.get(name).map_or(0, Vec::len);
        if now == 0 || !is_bare(name) {
            complaints.push(format!("no function is called `{name}` alone; delete the line `{name} {before}`"));
        } else if now < *before {
            complaints.push(format!("fewer functions are called `{name}`: write `{name} {now}` for `{name} {before}`"));
        }
    }
    for (name, places) in places.iter().filter(|(name, _)| is_bare(name)) {
        let before = known.get(name).copied().unwrap_or(0);
        if places.len() > before {
            complaints.push(format!(
                "functions called `{name}`: {} now, {before} before; name a new one by a verb, a question or a quantity:\n    {}",
                places.len(),
                places.join("\n    ")
            ));
        }
    }
    complaints
}

#[test]
fn a_public_function_is_a_verb_a_question_or_a_quantity() {
    let known = std::fs::read_to_string(crate::path(KNOWN_FUNCTIONS)).expect("the list");
    assert!(known.lines().is_sorted(), "{KNOWN_FUNCTIONS} is sorted");
    let sum: usize = known.lines().filter_map(|line| line.split_once(' ')?.1.parse::<usize>().ok()).sum();
    assert!(sum <= MOST_KNOWN_FUNCTIONS, "{KNOWN_FUNCTIONS} only gets shorter: {sum} functions");
    let complaints = complaints_on_functions(&known, &places_by_name(sources(), &["fn"]));
    assert!(complaints.is_empty(), "{KNOWN_FUNCTIONS}:\n{}", complaints.join("\n"));
}

/// The sources of two made-up crates of one file each.
#[cfg(test)]
fn made_up(texts: [&str; 2]) -> Vec<Source> {
    let crates = ["wheels", "levers"].into_iter().zip(texts);
    crates.flat_map(|(package, text)| sources_of(package, [("lib.rs".to_owned(), text.to_owned())])).collect()
}

#[test]
fn a_type_name_that_stands_for_two_things_is_found_and_its_line_expires() {
    let complaints = |texts: [&str; 2], known: &str| {
        let sources = made_up(texts);
        complaints_on_types(known, &places_by_name(&sources, &["struct", "enum", "trait", "type"])).join("\n")
    };
    let twice = ["pub struct Instant {", "pub enum Instant {"];
    assert!(complaints(twice, "").starts_with("Instant stands for several things"));
    assert_eq!(complaints(twice, "Instant: of a pin; of a lever"), "");
    assert!(complaints(twice, "Instant: of a pin").starts_with("Instant stands for 2 things, and its line says 1"));
    assert!(complaints(twice, "Instant: ; ").starts_with("Instant stands for 2 things, and its line says 0"));
    assert!(complaints([twice[0], ""], "Instant: of a pin; of a lever").ends_with("delete its line"));
    for other in [
        "pub(crate) struct Instant;",
        "/// pub struct Instant;",
        "struct Instant;",
        "#[cfg(test)]\npub struct Instant;",
        "pub fn Instant() {",
    ] {
        assert_eq!(complaints([twice[0], other], ""), "", "{other}");
    }
}

#[test]
fn a_function_that_is_named_by_a_bare_word_is_found_and_its_line_expires() {
    let complaints = |texts: [&str; 2], known: &str| {
        let sources = made_up(texts);
        complaints_on_functions(known, &places_by_name(&sources, &["fn"])).join("\n")
    };
    let two = ["impl Wheel {\n    pub fn at(angle: f64) -> Self {", "pub const fn at() {"];
    assert!(complaints(two, "").starts_with("functions called `at`: 2 now, 0 before"));
    assert!(complaints(two, "at 1").starts_with("functions called `at`: 2 now, 1 before"));
    assert_eq!(complaints(two, "at 2"), "");
    assert!(complaints(two, "at 3").starts_with("fewer functions are called `at`: write `at 2`"));
    assert!(complaints(["", ""], "at 2").contains("delete the line `at 2`"));
    assert!(complaints(["pub fn turn() {", ""], "turn 1").contains("delete the line `turn 1`"));
    for (name, is_bare) in
        [("told", true), ("one", true), ("put_in", true), ("from", false), ("with_play", false), ("rounded", false)]
    {
        assert_eq!(!complaints([&format!("pub fn {name}() {{"), ""], "").is_empty(), is_bare, "{name}");
    }
    for other in ["pub(crate) fn at() {", "fn at() {", "/// pub fn at() {"] {
        assert_eq!(complaints([other, ""], ""), "", "{other}");
    }
}
