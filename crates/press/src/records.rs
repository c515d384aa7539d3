//! The ledger as data: a claim, a slip, a line of a source.

use crate::fields::{DataRow, FieldValue};
use geneva_evidence::{
    Check, Consequence, Document, Entry, Finding, Judged, Ledger, Line, Slip, TracedSlip, entry_numbers,
    without_ellipses,
};

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
