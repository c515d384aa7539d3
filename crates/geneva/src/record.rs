//! Claims and errata as data, for JSON and CSV.

use geneva_ledger::{Check, Claim, Judged, in_full};
use serde::Serialize;

/// All that is known of a claim.
#[derive(Debug, Serialize)]
pub struct ClaimRecord {
    id: &'static str,
    source: &'static str,
    locator: &'static str,
    kind: &'static str,
    meaning: &'static str,
    printed: String,
    unit: &'static str,
    /// With all its digits; `None` if the claim is no number.
    computed: Option<f64>,
    witnessed: Option<f64>,
    from_rounded: Option<f64>,
    verdict: &'static str,
    expected: &'static str,
    holds: bool,
    complaints: Vec<String>,
    evidence: Vec<&'static str>,
    findings: Vec<FindingRecord>,
    /// Which datum is missing and why.
    missing: Option<&'static str>,
    erratum: Option<ErratumRecord>,
}

/// How a form was found to hold or to fail.
#[derive(Debug, Serialize)]
pub struct FindingRecord {
    form: &'static str,
    holds: bool,
    how: String,
}

/// For `printed` read `corrected`.
#[derive(Debug, Serialize)]
pub struct ErratumRecord {
    printed: String,
    corrected: &'static str,
    reason: &'static str,
    witness: &'static str,
    severity: &'static str,
    inherited_by: &'static [&'static str],
}

/// A claim with an erratum, where only the erratum is of interest.
#[derive(Debug, Serialize)]
pub struct ErratumRow {
    id: &'static str,
    source: &'static str,
    locator: &'static str,
    kind: &'static str,
    meaning: &'static str,
    unit: &'static str,
    computed: Option<f64>,
    verdict: &'static str,
    #[serde(flatten)]
    erratum: ErratumRecord,
}

impl ClaimRecord {
    /// The columns of [`row`](Self::row).
    pub const COLUMNS: [&'static str; 23] = [
        "id",
        "source",
        "locator",
        "kind",
        "meaning",
        "printed",
        "unit",
        "computed",
        "witnessed",
        "from_rounded",
        "verdict",
        "expected",
        "holds",
        "complaints",
        "evidence",
        "findings",
        "missing",
        "erratum_printed",
        "erratum_corrected",
        "erratum_reason",
        "erratum_witness",
        "erratum_severity",
        "erratum_inherited_by",
    ];

    /// The record in cells: numbers with all their digits, lists joined by semicolons, nothing where nothing is known.
    pub fn row(&self) -> [String; Self::COLUMNS.len()] {
        let findings: Vec<_> = self.findings.iter().map(FindingRecord::line).collect();
        let erratum = |part: fn(&ErratumRecord) -> String| self.erratum.as_ref().map_or_else(String::new, part);
        [
            self.id.into(),
            self.source.into(),
            self.locator.into(),
            self.kind.into(),
            self.meaning.into(),
            self.printed.clone(),
            self.unit.into(),
            digits(self.computed),
            digits(self.witnessed),
            digits(self.from_rounded),
            self.verdict.into(),
            self.expected.into(),
            self.holds.to_string(),
            self.complaints.join("; "),
            self.evidence.join("; "),
            findings.join("; "),
            self.missing.unwrap_or_default().into(),
            erratum(|erratum| erratum.printed.clone()),
            erratum(|erratum| erratum.corrected.into()),
            erratum(|erratum| erratum.reason.into()),
            erratum(|erratum| erratum.witness.into()),
            erratum(|erratum| erratum.severity.into()),
            erratum(|erratum| erratum.inherited_by.join("; ")),
        ]
    }
}

impl From<&Judged> for ClaimRecord {
    fn from(judged: &Judged) -> Self {
        let claim = judged.claim;
        let findings = judged.findings.iter();
        Self {
            id: claim.id,
            source: claim.work.slug(),
            locator: claim.locator,
            kind: claim.kind.slug(),
            meaning: claim.meaning,
            printed: in_full(claim),
            unit: claim.unit,
            computed: judged.computed,
            witnessed: judged.witnessed,
            from_rounded: judged.from_rounded,
            verdict: judged.verdict.slug(),
            expected: claim.expected.slug(),
            holds: judged.holds(),
            complaints: judged.complaints(),
            evidence: claim.check.evidence().iter().map(|evidence| evidence.slug()).collect(),
            findings: findings
                .map(|(form, finding)| FindingRecord { form, holds: finding.holds, how: finding.how.clone() })
                .collect(),
            missing: match claim.check {
                Check::Missing { reason } => Some(reason),
                _ => None,
            },
            erratum: ErratumRecord::of(claim),
        }
    }
}

impl FindingRecord {
    fn line(&self) -> String {
        format!("{} {}: {}", self.form, if self.holds { "holds" } else { "fails" }, self.how)
    }
}

impl ErratumRecord {
    fn of(claim: &Claim) -> Option<Self> {
        claim.erratum.as_ref().map(|erratum| Self {
            printed: in_full(claim),
            corrected: erratum.corrected,
            reason: erratum.reason,
            witness: erratum.witness,
            severity: erratum.severity.slug(),
            inherited_by: erratum.inherited_by,
        })
    }
}

impl ErratumRow {
    /// The claim's erratum, if it has one.
    pub fn of(judged: &Judged) -> Option<Self> {
        let claim = judged.claim;
        Some(Self {
            id: claim.id,
            source: claim.work.slug(),
            locator: claim.locator,
            kind: claim.kind.slug(),
            meaning: claim.meaning,
            unit: claim.unit,
            computed: judged.computed,
            verdict: judged.verdict.slug(),
            erratum: ErratumRecord::of(claim)?,
        })
    }
}

/// The shortest digits that read back as the same number.
fn digits(number: Option<f64>) -> String {
    number.map_or_else(String::new, |number| number.to_string())
}
