//! Is a text in the code spelt as it is meant? A letter that slips in a label or in a message that hardly anybody meets makes a
//! word that is found nowhere else. So each word of these texts stands in a second place, in a chapter, a test, a snapshot or
//! more code, or in the list of those that need only one.

use std::collections::{BTreeMap, BTreeSet};

/// Words that stand in one place alone and are spelt as they are meant: commands of TeX, units, names.
const ALONE: &str = "tests/tidy/spelling.txt";

/// Where words are looked for.
const FOLDERS: [(&str, &[&str]); 5] = [
    ("crates", &[".rs", ".css", ".toml"]),
    ("tests", &[".rs"]),
    ("book/src", &[".md"]),
    ("docs", &[".md"]),
    ("snapshots", &[".snap"]),
];

/// The words of a text in small letters: letters without a break, two or more.
fn words(text: &str) -> impl Iterator<Item = String> {
    text.split(|c: char| !c.is_alphabetic()).filter(|word| word.chars().nth(1).is_some()).map(str::to_lowercase)
}

/// A text without its escaped signs: `\n` is a space, `\"` a mark.
fn unescaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut signs = text.chars();
    while let Some(c) = signs.next() {
        match c {
            '\\' => out.push(signs.next().filter(|c| !"nrtu".contains(*c)).unwrap_or(' ')),
            _ => out.push(c),
        }
    }
    out
}

/// What stands between quotation marks in the code of a file, without comments, tests and names in braces.
fn quoted(text: &str) -> String {
    let code = &text[..text.find("#[cfg(test)]").unwrap_or(text.len())];
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    let (mut out, mut inside, mut braces) = (String::new(), false, 0_usize);
    for line in lines {
        let mut signs = line.chars();
        while let Some(c) = signs.next() {
            match c {
                '\\' if inside => {
                    out.push(c);
                    out.extend(signs.next());
                }
                '"' => {
                    inside = !inside;
                    braces = 0;
                    out.push(' ');
                }
                '{' if inside => {
                    braces += 1;
                    out.push(' ');
                }
                '}' if inside => braces = braces.saturating_sub(1),
                _ if inside && braces == 0 => out.push(c),
                _ => {}
            }
        }
        out.push('\n');
    }
    unescaped(&out)
}

/// The words of texts in code that stand in no other place, each with its file.
fn alone(code: &[(String, String)], elsewhere: &[String]) -> BTreeMap<String, String> {
    let mut places: BTreeMap<String, usize> = BTreeMap::new();
    for text in code.iter().map(|(_, text)| text).chain(elsewhere) {
        words(&unescaped(text)).for_each(|word| *places.entry(word).or_default() += 1);
    }
    let of_code = |(file, text): &(String, String)| -> Vec<(String, String)> {
        words(&quoted(text)).map(|word| (word, file.clone())).collect()
    };
    code.iter().flat_map(of_code).filter(|(word, _)| places.get(word).is_none_or(|count| *count == 1)).collect()
}

#[test]
fn each_word_of_a_text_in_the_code_has_a_second_place_or_is_listed() {
    let (mut code, mut elsewhere) = (Vec::new(), Vec::new());
    for (folder, endings) in FOLDERS {
        for (path, text) in crate::files(folder, endings) {
            let file = path.strip_prefix(crate::path("")).expect("inside").to_string_lossy().replace('\\', "/");
            if file.ends_with(".rs") && file.contains("/src/") && !file.contains("/tests") {
                code.push((file, text));
            } else {
                elsewhere.push(text);
            }
        }
    }
    let found = alone(&code, &elsewhere);
    let list = std::fs::read_to_string(crate::path(ALONE)).expect("the list");
    let listed: BTreeSet<&str> = list.lines().collect();
    assert!(list.lines().is_sorted() && listed.len() == list.lines().count(), "{ALONE} is sorted, each word once");
    let unlisted: Vec<String> = found
        .iter()
        .filter(|(word, _)| !listed.contains(word.as_str()))
        .map(|(word, file)| format!("{word} in {file}"))
        .collect();
    assert!(unlisted.is_empty(), "spelt as meant? Then they belong into {ALONE}: {unlisted:#?}");
    let needless: Vec<&&str> = listed.iter().filter(|word| !found.contains_key(**word)).collect();
    assert!(needless.is_empty(), "these stand in a second place, or in none: {needless:?}");
}

#[test]
fn a_slip_is_found_and_a_name_is_none() {
    let source =
        "// a commxnt\nlet of = format!(\"the wheel {xheel} of\\nplay\");\n#[cfg(test)]\nmod tests { \"textx\" }";
    assert_eq!(words(&quoted(source)).collect::<Vec<_>>(), ["the", "wheel", "of", "play"]);
    let code = |text: &str| [("code.rs".to_owned(), format!("\"{text}\""))];
    let elsewhere = ["The wheel has an axial play.".to_owned()];
    assert!(alone(&code("the axial play"), &elsewhere).is_empty());
    assert_eq!(alone(&code("the axixl play"), &elsewhere).into_keys().collect::<Vec<_>>(), ["axixl"]);
}
