//! Do the folders of a crate import only from those before them, where they show the way of what goes through the crate?

use super::circles::imports;
use super::sources::{Source, sources, sources_of};

/// The folders of the proofreader in the order in which a text goes through them. What none of them is above comes first: tokens,
/// units and counts.
const PROOFREAD: &[&[&str]] = &[
    &["decimal", "effort", "named_counts", "order", "token", "unit"],
    &["reader"],
    &["join"],
    &["evaluate"],
    &["judge"],
    &["tell"],
    &["certainty"],
    &["check"],
    &["statistics"],
    &["cli"],
];

/// The imports of a crate that lead forward in the order of its modules, and the modules that have no place in it.
fn complaints(files: &[&Source], order: &[&[&str]]) -> Vec<String> {
    let place = |file: &Source| {
        let module = file.module.first()?;
        order.iter().position(|level| level.contains(&module.as_str()))
    };
    let placed = files.iter().filter(|file| !file.module.is_empty());
    let lost =
        placed.filter(|file| place(file).is_none()).map(|file| format!("{} is in no folder of the order", file.file));
    let imports = imports(files);
    let forward = imports.iter().filter_map(|((from, to), names)| {
        let (from, to) = (files[*from], files[*to]);
        let names = names.iter().map(String::as_str).collect::<Vec<_>>().join(", ");
        (place(from)? < place(to)?).then(|| {
            format!(
                "{} imports {names} from {}, which comes later: move what both need to the earlier folder",
                from.file, to.file
            )
        })
    });
    lost.chain(forward).collect()
}

#[test]
fn the_proofreaders_folders_import_only_backwards() {
    let files: Vec<&Source> = sources().iter().filter(|source| source.package == "proofread").collect();
    assert!(files.len() > 50, "{} files of the proofreader", files.len());
    let complaints = complaints(&files, PROOFREAD);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

#[test]
fn an_import_forward_and_a_module_without_a_place_are_told() {
    let found = |files: &[(&str, &str)]| {
        let texts = files.iter().map(|(file, text)| ((*file).to_owned(), (*text).to_owned()));
        let files = sources_of("made_up", texts);
        complaints(&files.iter().collect::<Vec<_>>(), &[&["token"], &["reader"], &["judge"]])
    };
    let [reader, judge] = ["reader/mod.rs", "judge/verdict.rs"];
    assert!(
        found(&[(reader, "use crate::token::Token;"), ("token.rs", ""), (judge, "use crate::reader::Formula;")])
            .is_empty()
    );
    for forward in ["use crate::judge::verdict::Verdict;", "fn f() -> super::judge::verdict::Verdict {}"] {
        let told = found(&[(reader, forward), (judge, "")]);
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(told[0].starts_with("reader/mod.rs imports Verdict from judge/verdict.rs"), "{told:?}");
    }
    // Unit tests are free, and what two files of a folder share is its own matter.
    assert!(
        found(&[(reader, "#[cfg(test)]\nmod tests {\n    use crate::judge::verdict::Verdict;\n}"), (judge, "")])
            .is_empty()
    );
    assert_eq!(found(&[("elsewhere.rs", "")]), ["elsewhere.rs is in no folder of the order"]);
}
