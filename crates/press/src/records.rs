//! The ledger as data: a claim, a slip, all of them in files.

use crate::fields::{self, Row, Value};
use geneva_ledger::{Check, Consequence, Finding, Judged, Places, Slip, in_full, slips, verdicts};

/// All claims, and all slips of the sources, as JSON.
pub fn files() -> anyhow::Result<[(&'static str, String); 2]> {
    let of_sources = slips().iter().filter(|places| places.slip.consequence != Consequence::Copy);
    Ok([
        ("claims.json", fields::json(&verdicts().iter().map(claim).collect::<Vec<_>>())?),
        ("errata.json", fields::json(&of_sources.map(slip).collect::<Vec<_>>())?),
    ])
}

/// All that is known of a claim.
pub fn claim(judged: &Judged) -> Row {
    let (claim, slip) = (judged.claim, judged.claim.erratum.as_ref().map(|erratum| &erratum.slip));
    let evidence: Vec<_> = claim.check.evidence().iter().map(|evidence| evidence.slug()).collect();
    let findings: Vec<_> = judged.findings.iter().map(|(form, finding)| found(form, finding)).collect();
    let (neighbour, missing) = match claim.check {
        Check::Statement { neighbour, .. } => (neighbour, None),
        Check::Missing { reason } => (None, Some(reason)),
        _ => (None, None),
    };
    Row(vec![
        ("id", claim.id.into()),
        ("source", claim.work.slug().into()),
        ("locator", claim.locator.into()),
        ("kind", claim.kind.slug().into()),
        ("meaning", claim.meaning.into()),
        ("printed", in_full(claim).into()),
        ("unit", claim.unit.into()),
        // Missing if the claim is no number.
        ("computed", judged.computed.into()),
        ("witnessed", judged.witnessed.into()),
        ("from_rounded", judged.from_rounded.into()),
        ("verdict", judged.verdict.slug().into()),
        ("expected", claim.expected.slug().into()),
        ("holds", judged.holds().into()),
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
        let places = geneva_ledger::slip(claim.id);
        let all = places.into_iter().flat_map(|places| &places.claims).map(|judged| judged.claim.id);
        all.filter(|id| *id != claim.id).collect::<Vec<_>>()
    };
    Row(vec![
        ("printed", slip.map(|_| in_full(claim)).into()),
        ("corrected", slip.map(|_| judged.corrected().unwrap_or_default()).into()),
        ("reason", slip.map(|slip| slip.reason).into()),
        ("witness", slip.map(|slip| slip.witness).into()),
        ("origin", slip.map(|slip| slip.origin.slug()).into()),
        ("inherited_by", slip.map(|_| inherited()).into()),
    ])
}

/// All that is known of a slip.
pub fn slip(places: &Places) -> Row {
    let (slip, main) = (&places.slip, places.main());
    // The claims that it reaches.
    let ids: Vec<_> = places.claims.iter().map(|judged| judged.claim.id).collect();
    Row(vec![
        ("id", slip.id.into()),
        ("source", main.claim.work.slug().into()),
        ("locator", main.claim.locator.into()),
        ("meaning", main.claim.meaning.into()),
        ("consequence", slip.consequence.slug().into()),
        ("origin", slip.origin.slug().into()),
        ("places", ids.into()),
        ("printed", in_full(main.claim).into()),
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
