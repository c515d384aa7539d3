//! One row of the ledger.

use crate::slugs::slugs;
use crate::{Check, Erratum, Slip, Verdict, Work};

/// What a source says in one place, how it is checked, and the verdict on record.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Stable id: the work's slug, then words joined by hyphens and points.
    pub id: &'static str,
    /// The source.
    pub work: Work,
    /// Where in the source, in the manner of a printed errata list.
    pub locator: &'static str,
    /// What sort of claim.
    pub kind: Kind,
    /// What it says, in our words.
    pub meaning: &'static str,
    /// The printed characters.
    pub printed: &'static str,
    /// The unit of the printed number, as printed; empty for none.
    pub unit: &'static str,
    /// How it is checked.
    pub check: Check,
    /// The verdict on record, which the derived one must equal.
    pub expected: Verdict,
    /// Which reading of a vague sentence is checked: the kindest that its words bear.
    pub reading: Option<&'static str>,
    /// What is wrong, if something is.
    pub erratum: Option<Erratum>,
}

/// The sort of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A printed number.
    Value,
    /// An equation or a formula.
    Equation,
    /// A figure, or what a text says of one.
    Figure,
    /// A sentence that can be checked.
    Statement,
}

impl Claim {
    /// A printed number with its unit. Like all claims, expected to be reproduced, and without an erratum.
    pub fn value(
        work: Work,
        id: &'static str,
        locator: &'static str,
        meaning: &'static str,
        (printed, unit): (&'static str, &'static str),
        check: Check,
    ) -> Self {
        let (kind, expected) = (Kind::Value, Verdict::Reproduced);
        Self { id, work, locator, kind, meaning, printed, unit, check, expected, reading: None, erratum: None }
    }

    /// An equation or a formula.
    pub fn equation(
        work: Work,
        id: &'static str,
        locator: &'static str,
        meaning: &'static str,
        printed: &'static str,
        check: Check,
    ) -> Self {
        Self { kind: Kind::Equation, ..Self::value(work, id, locator, meaning, (printed, ""), check) }
    }

    /// A figure, or what a text says of one.
    pub fn figure(
        work: Work,
        id: &'static str,
        locator: &'static str,
        meaning: &'static str,
        printed: &'static str,
        check: Check,
    ) -> Self {
        Self { kind: Kind::Figure, ..Self::value(work, id, locator, meaning, (printed, ""), check) }
    }

    /// A sentence that can be checked.
    pub fn statement(
        work: Work,
        id: &'static str,
        locator: &'static str,
        meaning: &'static str,
        printed: &'static str,
        check: Check,
    ) -> Self {
        Self { kind: Kind::Statement, ..Self::value(work, id, locator, meaning, (printed, ""), check) }
    }

    /// Records another verdict than `reproduced`.
    #[must_use]
    pub fn expecting(self, expected: Verdict) -> Self {
        Self { expected, ..self }
    }

    /// The characters that are right: those of the correction, if there is one; what they say, if they are not printed.
    pub fn right_characters(&self) -> &'static str {
        match (self.check.reader().and_then(|reader| reader.said), &self.erratum) {
            (Some(said), _) => said,
            (None, Some(erratum)) => erratum.corrected,
            (None, None) => self.printed,
        }
    }

    /// Says how a vague sentence is read.
    #[must_use]
    pub fn read_as(self, reading: &'static str) -> Self {
        Self { reading: Some(reading), ..self }
    }

    /// Records an erratum. A slip without an id is one of this place and gets the claim's.
    #[must_use]
    pub fn with_erratum(self, erratum: Erratum) -> Self {
        let slip = if erratum.slip.id.is_empty() { Slip { id: self.id, ..erratum.slip } } else { erratum.slip };
        Self { erratum: Some(Erratum { slip, ..erratum }), ..self }
    }

    /// Records that the claim is a place of a slip of which the right number tells whether it changes anything here.
    #[must_use]
    pub fn affected_by(self, slip: Slip) -> Self {
        self.with_erratum(Erratum { corrected: "", slip })
    }
}

slugs!(Kind { Value = "value", Equation = "equation", Figure = "figure", Statement = "statement" });
