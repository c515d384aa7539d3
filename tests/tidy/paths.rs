//! Do the documents for contributors name files and folders that are there?

use std::collections::BTreeSet;
use std::path::Path;

/// What the build makes, and what stands for any name.
const MADE: [&str; 3] = ["target/", "book/src/data", "NAME"];

/// All files and folders below a folder, relative to the root of the repository.
fn below(folder: &Path, found: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let entry = entry.expect("readable").path();
        let name = entry.strip_prefix(crate::path("")).expect("below the root").to_string_lossy().replace('\\', "/");
        if name.starts_with("target") || name.starts_with(".git/") {
            continue;
        }
        if entry.is_dir() {
            below(&entry, found);
        }
        found.insert(name);
    }
}

/// The words in backticks that look like a path.
fn paths(text: &str) -> impl Iterator<Item = &str> {
    let is_path = |word: &&str| {
        let of_path = |c: char| c.is_ascii_alphanumeric() || "_-./".contains(c);
        let ends = [".rs", ".md", ".csv", ".toml", ".js", ".css", ".snap"];
        word.chars().all(of_path) && (word.contains('/') || ends.iter().any(|end| word.ends_with(end)))
    };
    text.split('`').skip(1).step_by(2).filter(is_path)
}

/// The documents for contributors.
const DOCUMENTS: [&str; 4] = ["docs/architecture.md", "docs/solver.md", "CONTRIBUTING.md", "README.md"];

/// Whether a word is the end of a path that is there; a crate's folder of sources need not be named.
fn is_there(word: &str, known: &BTreeSet<String>) -> bool {
    let end = format!("/{}", word.trim_matches('/'));
    known.iter().any(|path| {
        let path = format!("/{path}");
        path.ends_with(&end) || path.replacen("/src", "", 1).ends_with(&end)
    })
}

#[test]
fn what_the_pages_for_contributors_name_is_there() {
    let mut known = BTreeSet::new();
    below(&crate::path(""), &mut known);
    for page in DOCUMENTS {
        let text = std::fs::read_to_string(crate::path(page)).expect("a page");
        let named: Vec<_> = paths(&text).filter(|word| !MADE.iter().any(|made| word.contains(made))).collect();
        assert!(!named.is_empty(), "{page} names no path");
        for word in named {
            assert!(is_there(word, &known), "{page}: there is no {word}");
        }
    }
    assert!(is_there("evidence/judge.rs", &known) && is_there("wheel/geometry.rs", &known));
    assert!(!is_there("wheel/extremes.r", &known) && !is_there("evidence/statistics.rs", &known));
}

#[test]
fn the_links_of_the_documents_for_contributors_lead_to_files() {
    let mut count = 0;
    for page in DOCUMENTS {
        let text = std::fs::read_to_string(crate::path(page)).expect("a document");
        let folder = Path::new(page).parent().expect("a folder");
        for link in text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next()) {
            if link.is_empty() || link.starts_with("http") {
                continue;
            }
            let file = crate::path("").join(folder).join(link);
            assert!(file.exists(), "{page}: there is no {link}");
            count += 1;
        }
    }
    assert!(count > 15, "only {count} links");
}
