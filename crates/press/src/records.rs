//! The ledger as data: a claim, a slip, a line of a source, all of them in files, and what each of their fields says.

use crate::citing::{LICENCE, TITLE, VERSION};
use crate::edition::Edition;
use crate::fields::{self, Row, Value};
use crate::{address, bibliography};
use geneva_documents::LEDGER;
use geneva_evidence::Document;
use geneva_evidence::{
    Check, Consequence, Entry, Finding, Judged, Line, Slip, TracedSlip, entry_numbers, without_ellipses,
};
use std::collections::BTreeSet;

/// A field of the files by its path, a point before the field of an object, and what it says.
pub type Field = (&'static str, &'static str);

/// What the fields on the origin of a mistake say.
const ORIGIN: &str =
    "How the mistake came about, as far as we can tell: `copy`, `misprint`, `arithmetic`, `concept` or `unknown`.";

/// What the fields of a claim say.
pub const OF_A_CLAIM: &[Field] = &[
    ("id", "The name of the claim. It stays the same from version to version."),
    (
        "source",
        "The source: `pin`, `quick-return`, `jazar` (the handout), `meyer` (the thesis) or `wild` (pages elsewhere).",
    ),
    (
        "locator",
        "Where in the source the claim is. For a page elsewhere, this is its address and the day on which we read it.",
    ),
    (
        "kind",
        "What sort of claim it is: `value` (a printed number), `equation`, `figure`, `statement`, or `example` (sizes of a mechanism that a program builds).",
    ),
    ("meaning", "What the source says here, in our words."),
    (
        "printed",
        "The characters that the source prints, formulas in TeX. In CSV some begin with `=`, `+` or `-`: have a spreadsheet import the column as text.",
    ),
    ("unit", "The unit of the printed number, as printed. Empty if there is none."),
    (
        "computed",
        "The result of the calculation that the source describes, done again: in the printed unit and not rounded. Null \
         if the claim is not a number.",
    ),
    ("witnessed", "The number that the second route gives, which is meant to share no formula with the first."),
    ("from_rounded", "The number that follows from the source's own rounded steps, where we followed them."),
    ("verdict", "The verdict that the program derived. *How it is checked* explains each verdict."),
    ("expected", "The verdict on record. We write it down by hand, and a test compares it with the derived one."),
    (
        "holds",
        "True if the derived verdict is the verdict on record and nothing contradicts it. In a released version, this \
         is so for every claim.",
    ),
    ("complaints", "What contradicts the verdict, in words. The list is empty where `holds` is true."),
    (
        "evidence",
        "The kinds of evidence of the two routes, the first route first. The list is empty if a claim cannot be decided.",
    ),
    ("findings", "What we found when we tried the forms of an equation, a figure or a statement."),
    (
        "findings.form",
        "Which form was tried (the printed one, the corrected one or a near miss), and by which route (the first or the witness).",
    ),
    ("findings.holds", "Whether this form holds."),
    ("findings.how", "How we know, in words."),
    (
        "truth",
        "Whether what is printed is right: `right`, `wrong` or `open`. The book counts claims separately if they are \
         wrong only in the copy, that is, if their `consequence` is `copy`.",
    ),
    (
        "right_value",
        "The right number. It is given if a digit of the printed number is wrong, or if the source makes a mistake in this claim.",
    ),
    (
        "slip",
        "The mistake that reaches the claim. A mistake has the id of the claim in which it is made, and errata.json describes it, or copies.json if only the copy has it.",
    ),
    (
        "consequence",
        "What that mistake changes: `result`, `conclusion`, `remark`, `number`, `derivation` or `wording`; or `copy` if only the copy has it.",
    ),
    ("reading", "How we read a vague sentence."),
    (
        "neighbour",
        "The near miss of a statement that is right: a false statement close to it, which both routes must refuse. \
         Null if the printed statement is wrong, because then the printed statement is itself the near miss.",
    ),
    ("missing", "What is missing, if we could not decide the claim."),
    ("erratum", "What should be printed instead. Null if no mistake reaches the claim."),
    ("erratum.printed", "The printed characters again."),
    ("erratum.corrected", "The characters that should be printed instead."),
    ("erratum.reason", "Why the printed characters are wrong."),
    ("erratum.witness", "The second, independent reason."),
    ("erratum.origin", ORIGIN),
    (
        "erratum.inherited_by",
        "The other claims that the mistake reaches. Only the claim in which the mistake is made lists them.",
    ),
];

/// What the fields of a mistake say.
pub const OF_A_SLIP: &[Field] = &[
    ("id", "The name of the mistake, which is the id of the claim in which it is made."),
    ("source", "The source, as in claims.json."),
    ("locator", "Where the mistake is made."),
    ("meaning", "What the source says there, in our words."),
    ("consequence", "What the mistake changes, as in claims.json."),
    ("origin", ORIGIN),
    ("places", "The claims that the mistake reaches, among them the claim in which it is made."),
    ("printed", "The characters that the source prints, formulas in TeX."),
    ("corrected", "The characters that should be printed instead."),
    ("unit", "The unit of measurement of the number, as printed and as corrected. Empty if there is none."),
    ("reason", "Why the printed characters are wrong."),
    ("witness", "The second, independent reason."),
    ("changes", "What the mistake does to the results, in words. Empty if it does nothing to them."),
    ("wrong_numbers", "How many printed numbers are wrong because of the mistake."),
    ("greatest_change", "The largest relative deviation of the wrong numbers from the right ones."),
];

/// What the fields of an entry in a line say.
pub const OF_AN_ENTRY: &[Field] = &[
    ("source", "The source, as in claims.json. Pages elsewhere are left out."),
    ("line", "The number of the line in the text of the copy, counted from 1."),
    (
        "entry",
        "What is in this place of the line: `claim` (a claim is made here), `rest` (more of a claim that began earlier), `again` (a claim's number is printed once more), `reading` (a claim about numbers that another entry accounts for), `label` (the number of an equation or a figure) or `exception` (nothing to check).",
    ),
    ("id", "The claim, the label, or the exception's own name."),
    (
        "numbers",
        "The printed numbers that the entry accounts for, in digits and in words. Together, the entries of a line contain \
         all numbers of the line, in their order.",
    ),
    ("reason", "Why there is nothing to check. Null unless the entry is an exception."),
];

/// The files of the records of this edition: their names and texts.
pub fn files(edition: &Edition) -> anyhow::Result<Vec<(&'static str, String)>> {
    let of_sources = LEDGER.slips().iter().filter(|places| places.slip.consequence != Consequence::Copy);
    let copies: Vec<_> = slips_of_copies().map(slip).collect();
    let entries = entries()?;
    let works: Vec<_> = bibliography::rows().collect();
    Ok(vec![
        ("claims.json", versioned("claims", edition, LEDGER.verdicts().iter().copied().map(claim))?),
        ("errata.json", versioned("errata", edition, of_sources.map(slip))?),
        ("copies.json", versioned("copies", edition, copies.iter().cloned())?),
        ("copies.csv", fields::csv(copies.first(), copies.iter().cloned())?),
        ("coverage.json", versioned("entries", edition, entries.iter().cloned())?),
        ("coverage.csv", fields::csv(entries.first(), entries.iter().cloned())?),
        ("works.csv", fields::csv(works.first(), works.iter().cloned())?),
        ("CITATION.cff", include_str!("../../../CITATION.cff").to_owned()),
    ])
}

/// Rows in a file that says what it belongs to, in which edition of the project.
fn versioned(what: &'static str, edition: &Edition, rows: impl Iterator<Item = Row>) -> anyhow::Result<String> {
    fields::json(&Row(vec![
        ("title", TITLE.into()),
        ("version", VERSION.into()),
        ("commit", edition.commit.as_deref().into()),
        ("changed", edition.commit.as_ref().map(|_| edition.is_changed).into()),
        ("license", LICENCE.into()),
        ("address", address::known().map(|address| address.book.as_str()).into()),
        (what, Value::List(rows.map(Value::Object).collect())),
    ]))
}

/// What was lost or changed on the way to the copies, of pages elsewhere too.
pub fn slips_of_copies() -> impl Iterator<Item = &'static TracedSlip> {
    LEDGER.slips().iter().filter(|places| places.slip.consequence == Consequence::Copy)
}

/// Every entry of every line of the documents.
fn entries() -> anyhow::Result<Vec<Row>> {
    let mut rows = Vec::new();
    for work in LEDGER.mirrored() {
        let lines = work.lines()?.iter();
        rows.extend(lines.flat_map(|line| line.entries.iter().map(move |of| entry(work, line, of))));
    }
    Ok(rows)
}

fn entry(work: &'static Document, line: &Line, entry: &Entry) -> Row {
    let (kind, id) = match entry {
        Entry::Claim(id) => ("claim", *id),
        Entry::Rest(id, _) => ("rest", *id),
        Entry::Again(id) => ("again", *id),
        Entry::Reading(id) => ("reading", *id),
        Entry::Label(label) => ("label", *label),
        Entry::Exception { id, .. } => ("exception", *id),
    };
    let reason = if let Entry::Exception { reason, .. } = entry { Some(reason.clone()) } else { None };
    Row(vec![
        ("source", work.slug.into()),
        ("line", line.number.into()),
        ("entry", kind.into()),
        ("id", id.into()),
        ("numbers", entry_numbers(work, entry).into()),
        ("reason", reason.into()),
    ])
}

/// The fields of a file's rows, and one row to each of the ledger's to see of what type they are.
pub fn described(file: &str) -> anyhow::Result<(&'static [Field], Vec<Row>)> {
    match file {
        "claims" => Ok((OF_A_CLAIM, LEDGER.verdicts().iter().copied().map(claim).collect())),
        "errata" => Ok((OF_A_SLIP, LEDGER.slips().iter().map(slip).collect())),
        "coverage" => Ok((OF_AN_ENTRY, entries()?)),
        _ => anyhow::bail!("no file `{file}` is described; there are: claims, errata, coverage"),
    }
}

/// Of what types the values at a path are, in words.
pub fn types(rows: &[Row], path: &str) -> String {
    let mut found = BTreeSet::new();
    for row in rows {
        collect(row, path, &mut found);
    }
    found.into_iter().map(|(_, name)| name).collect::<Vec<_>>().join(" or ")
}

fn collect(row: &Row, path: &str, found: &mut BTreeSet<(u8, &'static str)>) {
    let (key, rest) = path.split_once('.').map_or((path, None), |(key, rest)| (key, Some(rest)));
    let Some((_, value)) = row.0.iter().find(|(name, _)| *name == key) else { return };
    match (value, rest) {
        (Value::Object(inner) | Value::Worded(inner, _), Some(rest)) => collect(inner, rest, found),
        (Value::List(values), Some(rest)) => values.iter().for_each(|value| {
            if let Value::Object(inner) | Value::Worded(inner, _) = value {
                collect(inner, rest, found);
            }
        }),
        (_, Some(_)) => {}
        (value, None) => drop(found.insert(value.kind())),
    }
}

/// All that is known of a claim.
pub fn claim(judged: &Judged) -> Row {
    let (claim, slip) = (judged.claim, judged.claim.erratum.as_ref().map(|erratum| &erratum.slip));
    let evidence: Vec<_> = claim.check.evidence().iter().map(|evidence| evidence.slug).collect();
    let findings: Vec<_> = judged.findings.iter().map(|(form, finding)| found(form, finding)).collect();
    let (neighbour, missing) = match claim.check {
        Check::Statement { neighbour, .. } => (neighbour, None),
        Check::Missing { reason } => (None, Some(reason)),
        _ => (None, None),
    };
    Row(vec![
        ("id", claim.id.into()),
        ("source", claim.document.slug.into()),
        ("locator", claim.locator.into()),
        ("kind", claim.kind.slug().into()),
        ("meaning", claim.meaning.into()),
        ("printed", without_ellipses(claim).into()),
        ("unit", claim.unit.into()),
        // Missing if the claim is no number.
        ("computed", judged.computed.into()),
        ("witnessed", judged.witnessed.into()),
        ("from_rounded", judged.from_rounded.into()),
        ("verdict", judged.verdict.slug().into()),
        ("expected", claim.expected.slug().into()),
        ("holds", judged.matches_record().into()),
        ("complaints", judged.complaints().into()),
        ("evidence", evidence.into()),
        ("findings", findings.into()),
        // Whether what is printed is right: `right`, `wrong` or `open`.
        ("truth", judged.truth().slug().into()),
        // Where the printed number is not right to all its digits, or is the place of a slip.
        ("right_value", judged.right_value.into()),
        // The slip that reaches the claim, whose id is that of the claim in which it is made.
        ("slip", slip.map(|slip| slip.id).into()),
        ("consequence", slip.map(|slip| slip.consequence.slug()).into()),
        // How a vague sentence is read.
        ("reading", claim.reading.into()),
        // The neighbouring statement that both routes must refute; for a corrected one the printed form is.
        ("neighbour", neighbour.into()),
        // Which datum is missing and why.
        ("missing", missing.into()),
        ("erratum", Value::Object(erratum(judged, slip))),
    ])
}

/// How a form was found to hold or to fail.
fn found(form: &str, finding: &Finding) -> Value {
    let row = Row(vec![("form", form.into()), ("holds", finding.holds.into()), ("how", finding.how.clone().into())]);
    Value::Worded(row, format!("{form} {}: {}", if finding.holds { "holds" } else { "fails" }, finding.how))
}

/// For `printed` read `corrected`; all is missing where there is no slip.
fn erratum(judged: &Judged, slip: Option<&Slip>) -> Row {
    let claim = judged.claim;
    // The other claims that the slip reaches, in the record of the one in which it is made.
    let inherited = || {
        let places = LEDGER.slip(claim.id);
        let all = places.into_iter().flat_map(|places| &places.claims).map(|judged| judged.claim.id);
        all.filter(|id| *id != claim.id).collect::<Vec<_>>()
    };
    Row(vec![
        ("printed", slip.map(|_| without_ellipses(claim)).into()),
        ("corrected", slip.map(|_| judged.corrected().unwrap_or_default()).into()),
        ("reason", slip.map(|slip| slip.reason).into()),
        ("witness", slip.map(|slip| slip.witness).into()),
        ("origin", slip.map(|slip| slip.origin.slug()).into()),
        ("inherited_by", slip.map(|_| inherited()).into()),
    ])
}

/// All that is known of a slip.
pub fn slip(places: &TracedSlip) -> Row {
    let (slip, main) = (&places.slip, places.main());
    // The claims that it reaches.
    let ids: Vec<_> = places.claims.iter().map(|judged| judged.claim.id).collect();
    Row(vec![
        ("id", slip.id.into()),
        ("source", main.claim.document.slug.into()),
        ("locator", main.claim.locator.into()),
        ("meaning", main.claim.meaning.into()),
        ("consequence", slip.consequence.slug().into()),
        ("origin", slip.origin.slug().into()),
        ("places", ids.into()),
        ("printed", without_ellipses(main.claim).into()),
        ("corrected", main.corrected().unwrap_or_default().into()),
        ("unit", main.claim.unit.into()),
        ("reason", slip.reason.into()),
        ("witness", slip.witness.into()),
        ("changes", slip.changes.into()),
        // How many printed numbers are not right because of it, and the largest of their deviations, relative to what is
        // right.
        ("wrong_numbers", places.wrong_numbers().count().into()),
        ("greatest_change", places.greatest_change().into()),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_documents::LEDGER;
    use serde_json::Value as Json;

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
        let edition = Edition { commit: Some("abcdef0".to_owned()), date: None, is_changed: true };
        for (name, text) in files(&edition).expect("files") {
            let Some(of) = name.strip_suffix(".json") else { continue };
            let whole: Json = serde_json::from_str(&text).expect("JSON");
            assert_eq!(whole["version"], VERSION, "{name}");
            assert_eq!(whole["title"], TITLE, "{name}");
            let address = address::known().map(|address| address.book.as_str());
            assert_eq!(whole["address"].as_str(), address, "{name}");
            let (list, fields) = match of {
                "claims" => ("claims", OF_A_CLAIM),
                "errata" => ("errata", OF_A_SLIP),
                "copies" => ("copies", OF_A_SLIP),
                _ => ("entries", OF_AN_ENTRY),
            };
            assert_eq!(whole["license"], LICENCE, "{name}");
            assert_eq!((&whole["commit"], &whole["changed"]), (&Json::from("abcdef0"), &Json::from(true)), "{name}");
            assert_eq!(whole.as_object().expect("an object").len(), 7, "{name}");
            assert!(whole[list].as_array().is_some_and(|rows| !rows.is_empty()), "{name} has no {list}");
            let mut found = BTreeSet::new();
            keys(&whole[list], "", &mut found);
            let described: BTreeSet<_> = fields.iter().map(|(path, _)| (*path).to_owned()).collect();
            assert_eq!(found, described, "{name}");
            seen += 1;
        }
        assert_eq!(seen, 4);
        let (_, claims) = files(&Edition::NONE).expect("files").swap_remove(0);
        let claims: Json = serde_json::from_str(&claims).expect("JSON");
        assert!(claims["commit"].is_null() && claims["changed"].is_null(), "no repository");
    }

    #[test]
    fn a_field_is_of_the_types_that_its_values_have() {
        let (_, rows) = described("claims").expect("claims");
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
        assert!(described("claim").is_err());
    }

    #[test]
    fn the_lines_of_the_sources_and_the_characters_of_the_copies_are_all_in_their_files() {
        let numbers = |work: &&'static Document| {
            work.lines().expect("an inventory").iter().map(|line| line.numbers.len()).sum::<usize>()
        };
        let listed = entries().expect("entries");
        let in_rows: usize = listed
            .iter()
            .map(|row| match &row.0[4].1 {
                Value::List(numbers) => numbers.len(),
                _ => 0,
            })
            .sum();
        assert_eq!(in_rows, LEDGER.mirrored().iter().map(numbers).sum::<usize>());
        for claim in LEDGER.claims().iter().filter(|claim| claim.document.is_mirrored()) {
            let id = Value::from(claim.id);
            assert!(listed.iter().any(|row| row.0[3].1 == id), "{} is in no line", claim.id);
        }
    }

    #[test]
    fn every_mistake_is_in_one_of_two_files() {
        let files = files(&Edition::NONE).expect("files");
        let of = |name: &str| {
            let (_, text) = files.iter().find(|(file, _)| *file == name).expect("a file");
            serde_json::from_str::<Json>(text).expect("JSON")
        };
        let (errata, copies) = (of("errata.json"), of("copies.json"));
        let listed =
            [&errata["errata"], &copies["copies"]].into_iter().flat_map(|list| list.as_array().expect("a list"));
        let listed: Vec<_> = listed.map(|slip| slip["id"].as_str().expect("an id")).collect();
        for places in LEDGER.slips() {
            assert_eq!(listed.iter().filter(|id| **id == places.slip.id).count(), 1, "{}", places.slip.id);
        }
        assert_eq!(listed.len(), LEDGER.slips().len());
    }
}
