//! Names that Cargo and the ledger take, from those of a folder and a file.

/// Names that a package cannot have or that would hide another crate: Rust's words, its own crates, folders that Cargo makes, and the
/// crates that the new one uses.
const TAKEN: &str = "\
    abstract alloc as async await become box break build const continue core crate deps do dyn else enum examples extern \
    false final fn for gen geneva-evidence geneva-press geneva-proofread if impl in incremental let loop macro main match mod move \
    mut override priv proc-macro proc_macro proofread pub ref return self static std struct super test trait true try type \
    typeof unsafe unsized use virtual where while yield";

/// Longest name, in characters.
const LONGEST: usize = 50;

/// The name of a package in a folder of this name.
pub(super) fn package(folder: &str) -> String {
    let words = words(folder);
    let named = match words.chars().next() {
        None => "check".to_owned(),
        Some('0'..='9') => format!("check-{words}"),
        Some(_) => words,
    };
    if TAKEN.split_whitespace().any(|taken| taken == named) { format!("{named}-check") } else { named }
}

/// The name of a document in a file of this name, with which the ids of its claims begin.
pub(super) fn slug(file: &str) -> String {
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    match words(stem) {
        // Chapters count the claims of a document by its name, and those of all by this word.
        slug if slug.is_empty() || slug == "all" => "document".to_owned(),
        slug => slug,
    }
}

/// Lower-case letters and digits of a name, with a hyphen for what is between them.
fn words(name: &str) -> String {
    let pieces = name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|piece| !piece.is_empty());
    let joined = pieces.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("-");
    joined.chars().take(LONGEST).collect::<String>().trim_end_matches('-').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_package_has_a_name_that_cargo_takes() {
        for (folder, name) in [
            ("my-check", "my-check"),
            ("My Notes (2nd)", "my-notes-2nd"),
            ("2026_drag", "check-2026-drag"),
            ("Überprüfung", "berpr-fung"),
            ("検査", "check"),
            ("test", "test-check"),
            ("Geneva Press", "geneva-press-check"),
        ] {
            assert_eq!(package(folder), name);
        }
        assert!(package(&"long-name-".repeat(30)).len() <= LONGEST);
    }

    #[test]
    fn a_document_has_a_name_with_which_ids_begin() {
        for (file, name) in [
            ("notes.md", "notes"),
            ("Lecture 3.final.tex", "lecture-3-final"),
            ("検査.txt", "document"),
            ("all.md", "document"),
        ] {
            assert_eq!(slug(file), name);
        }
    }
}
