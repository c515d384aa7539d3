//! Does a public name say what it stands for? A type's name stands for one thing in all crates, and a function's is a verb, a
//! question or a quantity. Both are looked up by strangers, in a list, far from the line that they were made for.

use super::known::{Comparison, assert_known, lines};
use super::sources::{Source, public_items, sources, sources_of};
use std::collections::BTreeMap;

/// Names of types that stand for several things all the same, one a line: the name, a colon, and each thing, between semicolons.
const KNOWN_TYPES: &str = "tests/tidy/type_names.txt";

/// How many lines of that kind there may be: lower it when a name stands for one thing again.
const MOST_KNOWN_TYPES: usize = 1;

/// Functions that are named by such a word all the same, one a line: the word, and how many functions of that name there are.
const KNOWN_FUNCTIONS: &str = "tests/tidy/function_names.txt";

/// How many such functions there may be in all: lower it when one has another name.
const MOST_KNOWN_FUNCTIONS: usize = 28;

/// How a type is declared.
const TYPES: [&str; 5] = ["struct", "enum", "trait", "type", "union"];

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

/// What the list of names of types becomes, by the types in the code.
fn comparison_of_types(known: &[String], places: &BTreeMap<&str, Vec<String>>) -> Comparison {
    let places_of = |name: &str| places.get(name).map_or(&[][..], Vec::as_slice);
    let split =
        |line: &str| line.split_once(": ").map_or((line.to_owned(), String::new()), |(a, b)| (a.into(), b.into()));
    let known: BTreeMap<String, String> = known.iter().map(|line| split(line)).collect();
    let (mut left, mut complaints) = (Vec::new(), Vec::new());
    for (name, things) in known.iter().filter(|(name, _)| places_of(name).len() > 1) {
        left.push(format!("{name}: {things}"));
        let things = things.split(';').filter(|thing| thing.trim().len() > 3).count();
        let places = places_of(name);
        if places.len() != things {
            complaints.push(format!(
                "{name} stands for {} things, and its line says {things}: let it say those of\n    {}",
                places.len(),
                places.join("\n    ")
            ));
        }
    }
    for (name, places) in places.iter().filter(|(name, places)| places.len() > 1 && !known.contains_key(**name)) {
        complaints
            .push(format!("{name} stands for several things; say in a name which:\n    {}", places.join("\n    ")));
    }
    Comparison { left, complaints }
}

#[test]
fn a_public_type_name_stands_for_one_thing() {
    let known = lines(KNOWN_TYPES);
    assert!(known.len() <= MOST_KNOWN_TYPES, "{KNOWN_TYPES} only gets shorter");
    let places = places_by_name(sources(), &TYPES);
    assert_known(KNOWN_TYPES, &known, comparison_of_types(&known, &places));
}

/// Whether a function's name is a preposition, pronoun or participle alone.
fn is_bare(name: &str) -> bool {
    [PREPOSITIONS, PRONOUNS, PARTICIPLES].iter().any(|words| words.split(' ').any(|word| word == name))
}

/// The names of functions in a list, with how many functions each has.
fn counts(known: &[String]) -> BTreeMap<&str, usize> {
    let counts = known.iter().filter_map(|line| line.split_once(' '));
    counts.filter_map(|(name, count)| Some((name, count.parse().ok()?))).collect()
}

/// What the list of names of functions becomes, by the functions in the code.
fn comparison_of_functions(known: &[String], places: &BTreeMap<&str, Vec<String>>) -> Comparison {
    let known = counts(known);
    let bare: BTreeMap<&str, &Vec<String>> =
        places.iter().filter(|(name, _)| is_bare(name)).map(|(a, b)| (*a, b)).collect();
    let left = |(name, before): (&&str, &usize)| {
        let now = bare.get(name)?.len();
        Some(format!("{name} {}", now.min(*before)))
    };
    let complaint = |(name, places): (&&str, &&Vec<String>)| {
        let before = known.get(name).copied().unwrap_or(0);
        (places.len() > before).then(|| {
            format!(
                "functions called `{name}`: {} now, {before} before; name a new one by a verb, a question or a quantity:\n    {}",
                places.len(),
                places.join("\n    ")
            )
        })
    };
    Comparison {
        left: known.iter().filter_map(left).collect(),
        complaints: bare.iter().filter_map(complaint).collect(),
    }
}

#[test]
fn a_public_function_is_a_verb_a_question_or_a_quantity() {
    let known = lines(KNOWN_FUNCTIONS);
    let sum: usize = counts(&known).values().sum();
    assert!(sum <= MOST_KNOWN_FUNCTIONS, "{KNOWN_FUNCTIONS} only gets shorter: {sum} functions");
    assert_known(KNOWN_FUNCTIONS, &known, comparison_of_functions(&known, &places_by_name(sources(), &["fn"])));
}

/// The sources of two made-up crates of one file each.
#[cfg(test)]
fn made_up(texts: [&str; 2]) -> Vec<Source> {
    let crates = ["wheels", "levers"].into_iter().zip(texts);
    crates.flat_map(|(package, text)| sources_of(package, [("lib.rs".to_owned(), text.to_owned())])).collect()
}

/// What is left of a list, and the first words of the complaints, with two made-up crates.
#[cfg(test)]
fn compared(
    texts: [&str; 2],
    keywords: &[&str],
    known: &str,
    by: fn(&[String], &BTreeMap<&str, Vec<String>>) -> Comparison,
) -> [String; 2] {
    let sources = made_up(texts);
    let known: Vec<String> = known.lines().map(str::to_owned).collect();
    let Comparison { left, complaints } = by(&known, &places_by_name(&sources, keywords));
    [left.join("\n"), complaints.join("\n").split(';').next().unwrap_or_default().to_owned()]
}

#[test]
fn a_type_name_that_stands_for_two_things_is_found_and_its_line_expires() {
    let compared = |texts: [&str; 2], known: &str| compared(texts, &TYPES, known, comparison_of_types);
    let twice = ["pub struct Instant {", "pub enum Instant {"];
    let line = "Instant: of a pin; of a lever";
    assert_eq!(compared(twice, line), [line, ""]);
    assert_eq!(compared(twice, ""), ["", "Instant stands for several things"]);
    for (line, count) in
        [("Instant: of a pin", 1), ("Instant: ; ", 0), ("Instant: of a pin; of a lever; of a wheel", 3)]
    {
        let [left, complaint] = compared(twice, line);
        assert!(
            left == line && complaint.starts_with(&format!("Instant stands for 2 things, and its line says {count}"))
        );
    }
    assert_eq!(compared([twice[0], ""], line), ["", ""]);
    for other in [
        "pub(crate) struct Instant;",
        "/// pub struct Instant;",
        "struct Instant;",
        "#[cfg(test)]\npub struct Instant;",
        "pub fn Instant() {",
    ] {
        assert_eq!(compared([twice[0], other], ""), ["", ""], "{other}");
    }
}

#[test]
fn a_function_that_is_named_by_a_bare_word_is_found_and_its_line_expires() {
    let compared = |texts: [&str; 2], known: &str| compared(texts, &["fn"], known, comparison_of_functions);
    let two = ["impl Wheel {\n    pub fn at(angle: f64) -> Self {", "pub const fn at() {"];
    assert_eq!(compared(two, ""), ["", "functions called `at`: 2 now, 0 before"]);
    assert_eq!(compared(two, "at 1"), ["at 1", "functions called `at`: 2 now, 1 before"]);
    assert_eq!(compared(two, "at 2"), ["at 2", ""]);
    assert_eq!(compared(two, "at 3"), ["at 2", ""]);
    assert_eq!(compared(["", ""], "at 2"), ["", ""]);
    assert_eq!(compared(["pub fn turn() {", ""], "turn 1"), ["", ""]);
    for (name, expected) in
        [("told", true), ("one", true), ("put_in", true), ("from", false), ("with_play", false), ("rounded", false)]
    {
        let [_, complaint] = compared([&format!("pub fn {name}() {{"), ""], "");
        assert_eq!(!complaint.is_empty(), expected, "{name}");
    }
    for other in ["pub(crate) fn at() {", "fn at() {", "/// pub fn at() {"] {
        assert_eq!(compared([other, ""], ""), ["", ""], "{other}");
    }
}
