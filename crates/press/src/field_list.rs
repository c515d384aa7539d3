//! What each field of the data says: the list `fields.csv`, which stands beside the files that it describes.

use crate::book::Book;
use crate::fields::{DataRow, FieldValue};
use crate::lookup::unknown;
use crate::records::{claim, entries, slip};
use std::collections::BTreeSet;

/// The list's name among the data.
pub const FILE: &str = "fields.csv";

/// A field of the files by its path, a point before the field of an object, and what it says.
pub type FieldMeaning = (&'static str, &'static str);

/// What the fields on the origin of a mistake say.
const ORIGIN: &str =
    "How the mistake came about, as far as we can tell: `copy`, `misprint`, `arithmetic`, `concept` or `unknown`.";

/// What the fields of a claim say.
pub const OF_A_CLAIM: &[FieldMeaning] = &[
    ("id", "The name of the claim. It stays the same from version to version."),
    ("source", "The source, by the name with which the ids of its claims begin."),
    (
        "locator",
        "Where in the source the claim is. For a page elsewhere, this is its address and the day on which we read it.",
    ),
    (
        "kind",
        "What sort of claim it is: `value` (a printed number), `equation`, `figure`, `statement`, or `example` (what a program builds).",
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
    ("verdict", "The verdict that the program derived."),
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
pub const OF_A_SLIP: &[FieldMeaning] = &[
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
pub const OF_AN_ENTRY: &[FieldMeaning] = &[
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

/// Every JSON file, and the fields around the list of its rows: path, types and meaning.
const OF_A_FILE: [(&str, &str, &str); 9] = [
    ("$schema", "text", "The JSON Schema of the file, which stands beside it."),
    ("format", "text", "The version of the format. It changes when a field goes away or changes what it means."),
    ("title", "text", "The project."),
    ("version", "text", "The version of the project that wrote the file."),
    (
        "commit",
        "text or null",
        "The commit of that version in git. Null if the project was not in a repository of its own.",
    ),
    (
        "changed",
        "true or false or null",
        "True if the project was not as the commit has it. Null if the commit is null.",
    ),
    ("license", "text", "The licence."),
    ("address", "text or null", "Where the book can be read. Null if that isn't settled."),
    ("claims, errata, copies or entries", "list", "The rows: what the file is named after, or the entries of lines."),
];

/// What all files of a kind have in common: the files, the fields, the types and what they say.
const OF_ALL: [(&str, &str, &str, &str); 4] = [
    (
        "CSV of claims, errata, copies or coverage",
        "all fields",
        "text",
        "The fields are those of the JSON file. The fields of an object are columns, for example `erratum_reason`, and a list is one cell, with semicolons between its items.",
    ),
    (
        "CSV of a figure",
        "all columns",
        "number",
        "The head of a column is a name and, in square brackets, a unit, which is 1 for a pure number.",
    ),
    (
        "CSV of a table",
        "all columns",
        "text",
        "The text of the table's cells. A hyphen stands for the minus sign of a number, and `^` precedes a superscript. Units that are not in the cells are in the caption.",
    ),
    (
        "CSV of a figure or a table",
        "the file beside it, whose name ends in `-metadata.json`",
        "",
        "The caption, the licence, and the edition of the book that the numbers come from, in the form of CSV on the Web (https://www.w3.org/TR/tabular-data-primer/).",
    ),
];

/// The fields around the list of rows belong to this group in a book's own meanings.
const EVERY_JSON: &str = "every JSON file";

/// Rows that are described: their name, the files that have them, and what their fields say.
const DESCRIBED: [(&str, &str, &[FieldMeaning]); 3] = [
    ("claims", "claims.json", OF_A_CLAIM),
    ("errata", "errata.json, copies.json, copies.csv", OF_A_SLIP),
    ("coverage", "coverage.json, coverage.csv", OF_AN_ENTRY),
];

/// The rows of the list: those of the builder, then what the book alone has.
pub fn rows(book: &Book) -> anyhow::Result<Vec<DataRow>> {
    let row = |file: &str, field: &str, types: &str, meaning: &str| {
        DataRow(vec![
            ("file", file.to_owned().into()),
            ("field", field.to_owned().into()),
            ("type", types.to_owned().into()),
            ("meaning", meaning.to_owned().into()),
        ])
    };
    let around = OF_A_FILE.iter().map(|(path, types, meaning)| {
        let own = own_meaning(book, EVERY_JSON, path);
        row(EVERY_JSON, path, types, own.unwrap_or(meaning))
    });
    let mut all: Vec<_> = around.collect();
    for (name, files, _) in DESCRIBED {
        let (fields, rows) = described(book, name)?;
        all.extend(fields.iter().map(|(path, meaning)| row(files, path, &types(&rows, path), meaning)));
    }
    all.extend(OF_ALL.iter().map(|(file, field, types, meaning)| row(file, field, types, meaning)));
    let is_known = |file: &str| file == EVERY_JSON || DESCRIBED.iter().any(|(name, ..)| *name == file);
    let own = book.field_meanings.iter().filter(|(file, ..)| !is_known(file));
    all.extend(own.map(|(file, path, meaning)| row(file, path, "number", meaning)));
    Ok(all)
}

/// What a book says of a field in place of the builder's words.
fn own_meaning(book: &Book, file: &str, path: &str) -> Option<&'static str> {
    let own = book.field_meanings.iter().find(|(of, known, _)| *of == file && *known == path);
    own.map(|(.., meaning)| *meaning)
}

/// The fields of such rows, with what each says in this book, and one row to each of the ledger's to see of what type they
/// are.
pub fn described(book: &Book, file: &str) -> anyhow::Result<(Vec<FieldMeaning>, Vec<DataRow>)> {
    let (ledger, fields) = (book.ledger, meanings(book, file)?);
    let rows = match file {
        "claims" => ledger.verdicts().iter().copied().map(|judged| claim(ledger, judged)).collect(),
        "errata" => ledger.slips().iter().map(slip).collect(),
        _ => entries(ledger)?,
    };
    Ok((fields, rows))
}

/// The fields around the rows of every JSON file, with what each says in this book.
pub(crate) fn around(book: &Book) -> impl Iterator<Item = FieldMeaning> {
    let fields = OF_A_FILE.iter().filter(|(path, ..)| !path.contains(' '));
    fields.map(|(path, _, meaning)| (*path, own_meaning(book, EVERY_JSON, path).unwrap_or(meaning)))
}

/// The fields of the rows that are described under a name, with what each says in this book.
pub(crate) fn meanings(book: &Book, file: &str) -> anyhow::Result<Vec<FieldMeaning>> {
    let found = DESCRIBED.iter().find(|(name, ..)| *name == file);
    let (.., fields) = found.ok_or_else(|| unknown("file that is described", file, DESCRIBED.iter().map(|of| of.0)))?;
    let in_this_book = |(path, meaning): &FieldMeaning| (*path, own_meaning(book, file, path).unwrap_or(meaning));
    Ok(fields.iter().map(in_this_book).collect())
}

/// Of what types the values at a path are, in words.
pub fn types(rows: &[DataRow], path: &str) -> String {
    let mut found = BTreeSet::new();
    for row in rows {
        collect(row, path, &mut found);
    }
    found.into_iter().map(|(_, name)| name).collect::<Vec<_>>().join(" or ")
}

fn collect(row: &DataRow, path: &str, found: &mut BTreeSet<(u8, &'static str)>) {
    let (key, rest) = path.split_once('.').map_or((path, None), |(key, rest)| (key, Some(rest)));
    let Some((_, value)) = row.0.iter().find(|(name, _)| *name == key) else { return };
    match (value, rest) {
        (FieldValue::Object(inner) | FieldValue::Worded(inner, _), Some(rest)) => collect(inner, rest, found),
        (FieldValue::List(values), Some(rest)) => values.iter().for_each(|value| {
            if let FieldValue::Object(inner) | FieldValue::Worded(inner, _) = value {
                collect(inner, rest, found);
            }
        }),
        (_, Some(_)) => {}
        (value, None) => drop(found.insert(value.kind())),
    }
}
