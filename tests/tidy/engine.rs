//! Does the engine know no subject, and does a document use no other?

use geneva_documents::LEDGER;

/// Words of this book's subject. The engine derives verdicts on any document, so none of them is in its code, its comments or
/// its tests.
const SUBJECT: [&str; 21] = [
    "crank",
    "cranks",
    "dwell",
    "escapement",
    "escapements",
    "follower",
    "geneva",
    "indexing",
    "lever",
    "levers",
    "mechanism",
    "mechanisms",
    "mimic",
    "pin",
    "pins",
    "slot",
    "slots",
    "stations",
    "thesis",
    "wheel",
    "wheels",
];

/// Which folder of the documents may use which other.
const MAY_USE: [(&str, &str); 1] = [("wild", "pin")];

/// The words of a text in small letters, without the names of our crates.
fn words(text: &str) -> impl Iterator<Item = String> {
    let text = text.replace("geneva_", "").replace("geneva-", "");
    let words = text.split(|c: char| !c.is_alphanumeric()).map(str::to_lowercase).collect::<Vec<_>>();
    words.into_iter()
}

/// The words of our subject or of our sources in a text.
fn subject_in(text: &str) -> Vec<String> {
    let of_a_source = |word: &str| {
        let names = LEDGER.documents().iter().flat_map(|document| [document.slug, document.title]);
        names.flat_map(|name| name.split([' ', '-'])).any(|name| name == word && !PLAIN.contains(&name))
    };
    words(text).filter(|word| SUBJECT.contains(&&**word) || word == "1973" || of_a_source(word)).collect()
}

/// Words of the sources' names that are plain English.
const PLAIN: [&str; 5] = ["elsewhere", "pages", "problem", "return", "wild"];

#[test]
fn the_book_builder_names_no_subject_and_no_source() {
    let files = crate::files("crates/press/src", &[".rs"]);
    assert!(files.len() > 40, "{} files", files.len());
    for (path, text) in files {
        let is_test = path.ends_with("samples.rs") || path.iter().any(|part| part == "tests.rs");
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
        let found = subject_in(code);
        assert!(is_test || found.is_empty(), "{} names {found:?}: take it from the Book", path.display());
    }
}

#[test]
fn the_engine_names_no_mechanism_and_no_source() {
    assert_eq!(subject_in("/// The Wheel's pin, by Meyer in 1973"), ["wheel", "pin", "meyer", "1973"]);
    assert!(subject_in("use geneva_exact::Field; // spinning pages of a problem").is_empty());
    for package in ["crates/evidence", "crates/exact"] {
        let files = crate::files(package, &[".rs", ".toml"]);
        assert!(files.len() > 8, "{package}");
        for (path, text) in files {
            for (number, line) in text.lines().enumerate() {
                let found = subject_in(line);
                assert!(found.is_empty(), "{}:{}: {}: {line}", path.display(), number + 1, found.join(", "));
            }
        }
    }
}

#[test]
fn a_document_uses_another_only_as_declared() {
    let folders = ["pin", "quick_return", "jazar", "meyer", "wild"];
    let named = |line: &str, folder: &str| {
        let paths = [format!("crate::{folder}"), format!("crate::{}", folder.to_uppercase())];
        paths.iter().any(|path| {
            line.match_indices(&**path)
                .any(|(at, _)| !line[at + path.len()..].starts_with(|c: char| c.is_alphanumeric()))
        })
    };
    assert!(named("use crate::pin::PinProblem;", "pin") && named("crate::PIN.claims()", "pin"));
    assert!(!named("use crate::pinion;", "pin"));
    let (mut used, mut files) = (Vec::new(), 0);
    for folder in folders {
        for (path, text) in crate::files(&format!("crates/documents/src/{folder}"), &[".rs"]) {
            files += 1;
            for other in folders.into_iter().filter(|other| *other != folder) {
                if let Some(line) = text.lines().find(|line| named(line, other)) {
                    let allowed = MAY_USE.contains(&(folder, other));
                    assert!(allowed, "{}: {folder} may not use {other}: {line}", path.display());
                    used.push((folder, other));
                }
            }
        }
    }
    assert!(files > 80, "{files}");
    for allowed in MAY_USE {
        assert!(used.contains(&allowed), "{allowed:?} is used no more: take it off the list");
    }
}
