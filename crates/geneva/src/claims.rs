//! The list of claims.

use crate::arguments::{ClaimsArguments, Format};
use crate::fields::{self, Row, Value};
use crate::output::{WIDTH, count, cut, heading, style};
use geneva_ledger::{Check, Decimal, Finding, Judged, Slip, Verdict, in_full};

/// The claims that are wanted, as they are wanted.
pub fn page(wanted: &ClaimsArguments) -> anyhow::Result<String> {
    let of_source = |judged: &&Judged| wanted.source.is_none_or(|source| judged.claim.work == source);
    let of_verdict = |judged: &&Judged| wanted.verdict.is_none_or(|verdict| judged.verdict == verdict);
    let rows: Vec<_> = geneva_ledger::verdicts().iter().filter(of_source).filter(of_verdict).collect();
    match wanted.format {
        Format::Json => fields::json(&rows.into_iter().map(row).collect::<Vec<_>>()),
        Format::Csv => fields::csv(geneva_ledger::verdicts().first().map(row).as_ref(), rows.into_iter().map(row)),
        _ => Ok(table(&rows)),
    }
}

/// All that is known of a claim.
fn row(judged: &Judged) -> Row {
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

/// A line for each claim, under the place in the source. Ids and verdicts are never cut.
fn table(rows: &[&Judged]) -> String {
    let longest = |length: fn(&Judged) -> usize| rows.iter().map(|judged| length(judged)).max().unwrap_or(0);
    let id = longest(|judged| judged.claim.id.len());
    let verdict = Verdict::ALL.iter().map(|verdict| verdict.slug().len()).max().unwrap_or(0);
    let middle = WIDTH.saturating_sub(2 + id + 2 + 2 + verdict);
    let computed = longest(|judged| computed(judged).map_or(0, |number| number.len())).max("computed".len());
    let printed = middle.saturating_sub(2 + computed);

    let bold = heading();
    let mut page =
        format!("{bold}  {:<id$}  {:<printed$}  {:>computed$}  verdict{bold:#}\n", "id", "printed", "computed");
    let mut place = None;
    for judged in rows {
        let (claim, colour) = (judged.claim, style(judged.verdict));
        if place.replace((claim.work, claim.locator)) != Some((claim.work, claim.locator)) {
            page += &format!("{}, {}\n", claim.work, claim.locator);
        }
        let what = match self::computed(judged) {
            Some(number) => format!("{}  {number:>computed$}", cut(&with_unit(&in_full(claim), claim.unit), printed)),
            // A form has nothing to set beside it.
            None => cut(&with_unit(&in_full(claim), claim.unit), middle),
        };
        page += &format!("  {:<id$}  {what}  {colour}{}{colour:#}\n", claim.id, judged.verdict);
    }
    page + &count(rows.len(), "claim") + "\n"
}

/// The printed characters, or what should stand in their place, with the claim's unit.
pub fn with_unit(characters: &str, unit: &str) -> String {
    let space = if unit.is_empty() || unit.starts_with('°') { "" } else { " " };
    format!("{characters}{space}{unit}")
}

/// The computed number with some places more than are printed.
fn computed(judged: &Judged) -> Option<String> {
    let number = judged.computed?;
    Some(match judged.claim.printed.parse::<Decimal>() {
        Ok(printed) => format!("{number:.*}", printed.places() as usize + Decimal::MORE_PLACES),
        Err(_) => number.to_string(),
    })
}
