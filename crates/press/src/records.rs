//! The ledger as data: a claim, a slip, a line of a source, all of them in files, and what each of their fields says.

use crate::book::Book;
use crate::edition::Edition;
use crate::fields::{self, DataRow, FieldValue};
use crate::lookup::unknown;
use crate::{address, citing, works};
use geneva_evidence::{
    Check, Consequence, Document, Entry, Finding, Judged, Ledger, Line, Slip, TracedSlip, entry_numbers,
    without_ellipses,
};
use std::collections::BTreeSet;

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

/// The files of the records of this edition: their names and texts.
pub fn files(book: &Book, edition: &Edition) -> anyhow::Result<Vec<(&'static str, String)>> {
    let ledger = book.ledger;
    let of_sources = ledger.slips().iter().filter(|places| places.slip.consequence != Consequence::Copy);
    let copies: Vec<_> = slips_of_copies(ledger).map(slip).collect();
    let entries = entries(ledger)?;
    let works: Vec<_> = works::rows(book.works).collect();
    let claims = ledger.verdicts().iter().copied().map(|judged| claim(ledger, judged));
    let versioned = |what, rows: &mut dyn Iterator<Item = DataRow>| versioned(book, what, edition, rows);
    let mut files = vec![
        ("claims.json", versioned("claims", &mut claims.into_iter())?),
        ("errata.json", versioned("errata", &mut of_sources.map(slip))?),
        ("copies.json", versioned("copies", &mut copies.iter().cloned())?),
        ("copies.csv", fields::csv(copies.first(), copies.iter().cloned())?),
        ("coverage.json", versioned("entries", &mut entries.iter().cloned())?),
        ("coverage.csv", fields::csv(entries.first(), entries.iter().cloned())?),
        ("works.csv", fields::csv(works.first(), works.iter().cloned())?),
        ("CITATION.cff", citing::cff_of_edition(book.citation_file, edition)),
    ];
    // A book that cites no work has no list of works, and so on.
    files.retain(|(_, text)| !text.is_empty());
    Ok(files)
}

/// Rows in a file that says what it belongs to, in which edition of the project.
fn versioned(
    book: &Book,
    what: &'static str,
    edition: &Edition,
    rows: &mut dyn Iterator<Item = DataRow>,
) -> anyhow::Result<String> {
    let imprint = &book.imprint;
    fields::json(&DataRow(vec![
        ("title", imprint.title.into()),
        ("version", imprint.version.into()),
        ("commit", edition.commit.as_deref().into()),
        ("changed", edition.commit.as_ref().map(|_| edition.is_changed).into()),
        ("license", imprint.licence.into()),
        ("address", address::known(imprint).map(|address| address.book).into()),
        (what, FieldValue::List(rows.map(FieldValue::Object).collect())),
    ]))
}

/// What was lost or changed on the way to the copies, of pages elsewhere too.
pub fn slips_of_copies(ledger: &'static Ledger) -> impl Iterator<Item = &'static TracedSlip> {
    ledger.slips().iter().filter(|places| places.slip.consequence == Consequence::Copy)
}

/// Every entry of every line of the documents.
pub fn entries(ledger: &'static Ledger) -> anyhow::Result<Vec<DataRow>> {
    let mut rows = Vec::new();
    for document in ledger.mirrored() {
        let lines = document.lines()?.iter();
        rows.extend(lines.flat_map(|line| line.entries.iter().map(move |of| entry(document, line, of))));
    }
    Ok(rows)
}

fn entry(document: &'static Document, line: &Line, entry: &Entry) -> DataRow {
    let (kind, id) = match entry {
        Entry::Claim(id) => ("claim", *id),
        Entry::Rest(id, _) => ("rest", *id),
        Entry::Again(id) => ("again", *id),
        Entry::Reading(id) => ("reading", *id),
        Entry::Label(label) => ("label", *label),
        Entry::Exception { id, .. } => ("exception", *id),
    };
    let reason = if let Entry::Exception { reason, .. } = entry { Some(reason.clone()) } else { None };
    DataRow(vec![
        ("source", document.slug.into()),
        ("line", line.number.into()),
        ("entry", kind.into()),
        ("id", id.into()),
        ("numbers", entry_numbers(document, entry).into()),
        ("reason", reason.into()),
    ])
}

/// The names of the files that are described, with what their fields say.
const DESCRIBED: [(&str, &[FieldMeaning]); 3] =
    [("claims", OF_A_CLAIM), ("errata", OF_A_SLIP), ("coverage", OF_AN_ENTRY)];

/// The fields of a file's rows, with what each says in this book, and one row to each of the ledger's to see of what type they
/// are.
pub fn described(book: &Book, file: &str) -> anyhow::Result<(Vec<FieldMeaning>, Vec<DataRow>)> {
    let ledger = book.ledger;
    let found = DESCRIBED.iter().find(|(name, _)| *name == file);
    let (_, fields) = found.ok_or_else(|| unknown("file that is described", file, DESCRIBED.iter().map(|of| of.0)))?;
    let in_this_book = |(path, meaning): &FieldMeaning| {
        let own = book.field_meanings.iter().find(|(of, known, _)| *of == file && known == path);
        (*path, own.map_or(*meaning, |(.., own)| own))
    };
    let rows = match file {
        "claims" => ledger.verdicts().iter().copied().map(|judged| claim(ledger, judged)).collect(),
        "errata" => ledger.slips().iter().map(slip).collect(),
        _ => entries(ledger)?,
    };
    Ok((fields.iter().map(in_this_book).collect(), rows))
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

/// All that is known of a claim.
pub fn claim(ledger: &'static Ledger, judged: &Judged) -> DataRow {
    let (claim, slip) = (judged.claim, judged.claim.erratum.as_ref().map(|erratum| &erratum.slip));
    let evidence: Vec<_> = claim.check.evidence().iter().map(|evidence| evidence.slug).collect();
    let findings: Vec<_> = judged.findings.iter().map(|(form, finding)| found(form, finding)).collect();
    let (neighbour, missing) = match claim.check {
        Check::Statement { neighbour, .. } => (neighbour, None),
        Check::Missing { reason } => (None, Some(reason)),
        _ => (None, None),
    };
    DataRow(vec![
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
        ("erratum", FieldValue::Object(erratum(ledger, judged, slip))),
    ])
}

/// How a form was found to hold or to fail.
fn found(form: &str, finding: &Finding) -> FieldValue {
    let row =
        DataRow(vec![("form", form.into()), ("holds", finding.holds.into()), ("how", finding.how.clone().into())]);
    FieldValue::Worded(row, format!("{form} {}: {}", if finding.holds { "holds" } else { "fails" }, finding.how))
}

/// For `printed` read `corrected`; all is missing where there is no slip.
fn erratum(ledger: &'static Ledger, judged: &Judged, slip: Option<&Slip>) -> DataRow {
    let claim = judged.claim;
    // The other claims that the slip reaches, in the record of the one in which it is made.
    let inherited = || {
        let places = ledger.slip(claim.id);
        let all = places.into_iter().flat_map(|places| &places.claims).map(|judged| judged.claim.id);
        all.filter(|id| *id != claim.id).collect::<Vec<_>>()
    };
    DataRow(vec![
        ("printed", slip.map(|_| without_ellipses(claim)).into()),
        ("corrected", slip.map(|_| judged.corrected().unwrap_or_default()).into()),
        ("reason", slip.map(|slip| slip.reason).into()),
        ("witness", slip.map(|slip| slip.witness).into()),
        ("origin", slip.map(|slip| slip.origin.slug()).into()),
        ("inherited_by", slip.map(|_| inherited()).into()),
    ])
}

/// All that is known of a slip.
pub fn slip(places: &TracedSlip) -> DataRow {
    let (slip, main) = (&places.slip, places.main());
    // The claims that it reaches.
    let ids: Vec<_> = places.claims.iter().map(|judged| judged.claim.id).collect();
    DataRow(vec![
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
