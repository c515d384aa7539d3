//! Claims and slips as data, for JSON and CSV.

use geneva_ledger::{Check, Judged, Places, in_full, slip as slip_of};
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
    /// Whether what is printed is right: `right`, `wrong` or `open`.
    truth: &'static str,
    /// The right number, where the printed one is not right to all its digits, or is the place of a slip.
    right_value: Option<f64>,
    /// The id of the slip that reaches the claim, which is that of the claim in which it is made.
    slip: Option<&'static str>,
    /// What that slip does.
    consequence: Option<&'static str>,
    /// How a vague sentence is read.
    reading: Option<&'static str>,
    /// The neighbouring statement that both routes must refute; for a corrected one the printed form is.
    neighbour: Option<&'static str>,
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
    corrected: String,
    reason: &'static str,
    witness: &'static str,
    origin: &'static str,
    /// The other claims that the slip reaches, in the record of the one in which it is made.
    inherited_by: Vec<&'static str>,
}

/// A slip with its places.
#[derive(Debug, Serialize)]
pub struct SlipRecord {
    id: &'static str,
    source: &'static str,
    locator: &'static str,
    meaning: &'static str,
    consequence: &'static str,
    origin: &'static str,
    /// The ids of all claims that it reaches.
    places: Vec<&'static str>,
    printed: String,
    corrected: String,
    unit: &'static str,
    reason: &'static str,
    witness: &'static str,
    changes: &'static str,
    /// How many printed numbers are not right because of it.
    wrong_numbers: usize,
    /// The largest of their deviations, relative to what is right.
    greatest_change: Option<f64>,
}

impl ClaimRecord {
    /// The columns of [`row`](Self::row).
    pub const COLUMNS: [&'static str; 29] = [
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
        "truth",
        "right_value",
        "slip",
        "consequence",
        "reading",
        "neighbour",
        "missing",
        "erratum_printed",
        "erratum_corrected",
        "erratum_reason",
        "erratum_witness",
        "erratum_origin",
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
            self.truth.into(),
            digits(self.right_value),
            self.slip.unwrap_or_default().into(),
            self.consequence.unwrap_or_default().into(),
            self.reading.unwrap_or_default().into(),
            self.neighbour.unwrap_or_default().into(),
            self.missing.unwrap_or_default().into(),
            erratum(|erratum| erratum.printed.clone()),
            erratum(|erratum| erratum.corrected.clone()),
            erratum(|erratum| erratum.reason.into()),
            erratum(|erratum| erratum.witness.into()),
            erratum(|erratum| erratum.origin.into()),
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
            truth: judged.truth().slug(),
            right_value: judged.right_value,
            slip: claim.erratum.as_ref().map(|erratum| erratum.slip.id),
            consequence: claim.erratum.as_ref().map(|erratum| erratum.slip.consequence.slug()),
            reading: claim.reading,
            neighbour: match claim.check {
                Check::Statement { neighbour, .. } => neighbour,
                _ => None,
            },
            missing: match claim.check {
                Check::Missing { reason } => Some(reason),
                _ => None,
            },
            erratum: ErratumRecord::of(judged),
        }
    }
}

impl FindingRecord {
    fn line(&self) -> String {
        format!("{} {}: {}", self.form, if self.holds { "holds" } else { "fails" }, self.how)
    }
}

impl ErratumRecord {
    fn of(judged: &Judged) -> Option<Self> {
        let (claim, slip) = (judged.claim, &judged.claim.erratum.as_ref()?.slip);
        let others = slip_of(claim.id).into_iter().flat_map(|places| &places.claims).map(|judged| judged.claim.id);
        Some(Self {
            printed: in_full(claim),
            corrected: judged.corrected().unwrap_or_default(),
            reason: slip.reason,
            witness: slip.witness,
            origin: slip.origin.slug(),
            inherited_by: others.filter(|id| *id != claim.id).collect(),
        })
    }
}

impl From<&Places> for SlipRecord {
    fn from(places: &Places) -> Self {
        let (slip, main) = (&places.slip, places.main());
        Self {
            id: slip.id,
            source: main.claim.work.slug(),
            locator: main.claim.locator,
            meaning: main.claim.meaning,
            consequence: slip.consequence.slug(),
            origin: slip.origin.slug(),
            places: places.claims.iter().map(|judged| judged.claim.id).collect(),
            printed: in_full(main.claim),
            corrected: main.corrected().unwrap_or_default(),
            unit: main.claim.unit,
            reason: slip.reason,
            witness: slip.witness,
            changes: slip.changes,
            wrong_numbers: places.wrong_numbers().count(),
            greatest_change: places.greatest_change(),
        }
    }
}

/// The shortest digits that read back as the same number.
fn digits(number: Option<f64>) -> String {
    number.map_or_else(String::new, |number| number.to_string())
}
