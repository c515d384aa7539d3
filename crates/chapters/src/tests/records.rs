//! The data of this book: its fields, and that nothing is left out.

use crate::BOOK;
use geneva_evidence::Document;
use geneva_press::address;
use geneva_press::edition::Edition;
use geneva_press::field_list::{self, OF_A_CLAIM, OF_A_SLIP, OF_AN_ENTRY, described, types};
use geneva_press::fields::FieldValue;
use geneva_press::record_files::files;
use geneva_press::records::entries;
use serde_json::Value as Json;
use std::collections::BTreeSet;

const NONE: Edition = Edition::without_commit(BOOK.imprint.version);

/// The paths of all keys below a value.
fn keys(value: &Json, before: &str, found: &mut BTreeSet<String>) {
    match value {
        Json::Object(fields) => {
            for (key, value) in fields {
                let path = if before.is_empty() { key.clone() } else { format!("{before}.{key}") };
                keys(value, &path, found);
                found.insert(path);
            }
        }
        Json::Array(values) => values.iter().for_each(|value| keys(value, before, found)),
        _ => {}
    }
}

#[test]
fn every_field_of_the_files_is_described_and_the_version_is_in_each() {
    let mut seen = 0;
    let edition = Edition { commit: Some("abcdef0".to_owned()), is_changed: true, ..NONE };
    for (name, text) in files(&BOOK, &edition).expect("files") {
        let Some(of) = name.strip_suffix(".json").filter(|of| !of.ends_with(".schema")) else { continue };
        let whole: Json = serde_json::from_str(&text).expect("JSON");
        let schemas = geneva_press::schema::files(&BOOK).expect("schemas");
        let schema = schemas.iter().find(|(name, _)| *name == whole["$schema"]).expect("a schema of this name");
        let schema: Json = serde_json::from_str(&schema.1).expect("JSON");
        assert_eq!(geneva_press::schema::faults(&whole, &schema), Vec::<String>::new(), "{name}");
        assert_eq!(whole["version"], BOOK.imprint.version, "{name}");
        assert_eq!(whole["title"], BOOK.imprint.title, "{name}");
        let address = address::known(&BOOK.imprint).map(|address| address.book);
        assert_eq!(whole["address"].as_str(), address.as_deref(), "{name}");
        let (list, fields) = match of {
            "claims" => ("claims", OF_A_CLAIM),
            "errata" => ("errata", OF_A_SLIP),
            "copies" => ("copies", OF_A_SLIP),
            _ => ("entries", OF_AN_ENTRY),
        };
        assert_eq!(whole["license"], BOOK.imprint.licence, "{name}");
        assert_eq!((&whole["commit"], &whole["changed"]), (&Json::from("abcdef0"), &Json::from(true)), "{name}");
        let around: Vec<_> = whole.as_object().expect("an object").keys().map(String::as_str).collect();
        let mut expected: Vec<_> =
            fields_of("every JSON file").into_iter().filter(|field| !field.contains(' ')).collect();
        expected.push(list.to_owned());
        expected.sort_unstable();
        assert_eq!(around, expected, "{name}");
        assert!(whole[list].as_array().is_some_and(|rows| !rows.is_empty()), "{name} has no {list}");
        let mut found = BTreeSet::new();
        keys(&whole[list], "", &mut found);
        let described: BTreeSet<_> = fields.iter().map(|(path, _)| (*path).to_owned()).collect();
        assert_eq!(found, described, "{name}");
        seen += 1;
    }
    assert_eq!(seen, 4);
    let (_, claims) = files(&BOOK, &NONE).expect("files").swap_remove(0);
    let claims: Json = serde_json::from_str(&claims).expect("JSON");
    assert!(claims["commit"].is_null() && claims["changed"].is_null(), "no repository");
}

/// The fields of these files in the list of all fields.
fn fields_of(of: &str) -> Vec<String> {
    let files = files(&BOOK, &NONE).expect("files");
    let (_, list) = files.iter().find(|(name, _)| *name == field_list::FILE).expect("the list");
    let mut reader = csv::Reader::from_reader(list.as_bytes());
    assert_eq!(reader.headers().expect("names"), vec!["file", "field", "type", "meaning"]);
    let rows = reader.records().map(|row| row.expect("as many cells as columns"));
    rows.filter(|row| &row[0] == of).map(|row| row[1].to_owned()).collect()
}

#[test]
fn the_list_of_fields_has_every_field_and_every_kind_of_file() {
    for (files, fields) in [
        ("claims.json", OF_A_CLAIM),
        ("errata.json, copies.json, copies.csv", OF_A_SLIP),
        ("coverage.json, coverage.csv", OF_AN_ENTRY),
    ] {
        assert!(fields_of(files).iter().eq(fields.iter().map(|(path, _)| path)), "{files}");
    }
    let figure = fields_of("CSV of a figure");
    for column in ["theta", "phi", "slots", "pins"] {
        assert!(figure.iter().any(|field| field == column), "{column}");
    }
    for kind in ["CSV of a table", "CSV of a figure or a table", "CSV of claims, errata, copies or coverage"] {
        assert_eq!(fields_of(kind).len(), 1, "{kind}");
    }
}

#[test]
fn a_field_is_of_the_types_that_its_values_have() {
    let (_, rows) = described(&BOOK, "claims").expect("claims");
    for (path, expected) in [
        ("id", "text"),
        ("computed", "number or null"),
        ("holds", "true or false"),
        ("findings", "list"),
        ("findings.holds", "true or false"),
        ("erratum", "object or null"),
    ] {
        assert_eq!(types(&rows, path), expected, "{path}");
    }
    assert!(described(&BOOK, "claim").is_err());
}

#[test]
fn the_lines_of_the_sources_and_the_characters_of_the_copies_are_all_in_their_files() {
    let numbers = |document: &&'static Document| {
        document.lines().expect("an inventory").iter().map(|line| line.numbers.len()).sum::<usize>()
    };
    let documents = BOOK.ledger.mirrored().iter();
    let listed = entries(BOOK.ledger).expect("entries");
    let in_rows: usize = listed
        .iter()
        .map(|row| match &row.0[4].1 {
            FieldValue::List(numbers) => numbers.len(),
            _ => 0,
        })
        .sum();
    assert_eq!(in_rows, documents.map(numbers).sum::<usize>());
    for claim in BOOK.ledger.claims().iter().filter(|claim| claim.document.is_mirrored()) {
        let id = FieldValue::from(claim.id);
        assert!(listed.iter().any(|row| row.0[3].1 == id), "{} is in no line", claim.id);
    }
}

#[test]
fn every_mistake_is_in_one_of_two_files() {
    let files = files(&BOOK, &NONE).expect("files");
    let of = |name: &str| {
        let (_, text) = files.iter().find(|(file, _)| *file == name).expect("a file");
        serde_json::from_str::<Json>(text).expect("JSON")
    };
    let (errata, copies) = (of("errata.json"), of("copies.json"));
    let listed = [&errata["errata"], &copies["copies"]].into_iter().flat_map(|list| list.as_array().expect("a list"));
    let listed: Vec<_> = listed.map(|slip| slip["id"].as_str().expect("an id")).collect();
    for places in BOOK.ledger.slips() {
        assert_eq!(listed.iter().filter(|id| **id == places.slip.id).count(), 1, "{}", places.slip.id);
    }
    assert_eq!(listed.len(), BOOK.ledger.slips().len());
}
