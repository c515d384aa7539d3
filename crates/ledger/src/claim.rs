//! One row of the ledger.

use crate::{Verdict, Work};
use geneva_kinematics::{Proof, Refutation};
use std::fmt;

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

/// How a claim is checked.
#[derive(Clone, Debug)]
pub enum Check {
    /// A number: computed, and computed again by a witness.
    Number {
        /// The value in the printed unit.
        computed: Route<f64>,
        /// The same by a route that shares no code with the first.
        witness: Route<f64>,
        /// What the source's own rounded intermediate results give, if it is computed from any.
        from_rounded: Option<fn() -> f64>,
        /// Resolution of the reading, in the printed unit, if the number was read from a curve or print-out.
        resolution: Option<f64>,
    },
    /// A form (equation, statement, figure) that holds or fails.
    Form {
        /// The form as printed.
        printed: Route<Finding>,
        /// The corrected form, if the printed one fails.
        corrected: Option<fn() -> Finding>,
        /// Another route to the form that is right: the corrected one if there is one, else the printed one.
        witness: Route<Finding>,
    },
    /// A datum is missing from the source.
    Missing {
        /// Which, and why nothing in the source replaces it.
        reason: &'static str,
    },
}

/// A way to a result, with the kind of evidence that it is.
#[derive(Clone, Copy, Debug)]
pub struct Route<T> {
    /// The kind of evidence.
    pub evidence: Evidence,
    /// Computes the result.
    pub run: fn() -> T,
}

/// The kinds of evidence.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Evidence {
    /// A formula evaluated.
    ClosedForm,
    /// An identity proven over the rationals at more points than its degree allows it to fail.
    ExactIdentity,
    /// A derivative taken by truncated power series of where things are.
    Jet,
    /// Derivatives by another library's automatic differentiation.
    AutomaticDerivative,
    /// Vectors from coordinates.
    Vectors,
    /// A case in which the answer is known.
    LimitCase,
    /// The dimensions of the quantities.
    Dimension,
    /// What the same source says elsewhere.
    OtherPlaceInSource,
    /// The equation of motion solved over the driver's angle.
    Integration,
    /// The equation of motion solved step by step.
    Steps,
}

/// Whether a form holds, and how that was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Whether it holds.
    pub holds: bool,
    /// How that was found, in a clause.
    pub how: String,
}

/// What is wrong with a printed form; its correction is checked with the claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Erratum {
    /// What should stand there.
    pub corrected: &'static str,
    /// Why.
    pub reason: &'static str,
    /// Which second witness says so, in words.
    pub witness: &'static str,
    /// How grave.
    pub severity: Severity,
    /// Ids of the claims that inherit the slip.
    pub inherited_by: &'static [&'static str],
}

/// How grave a slip is, by where it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The copy lost or changed a character; the original is not to blame.
    Transcription,
    /// A slip of the pen or a misprint of the source: a wrong or missing word, sign or symbol.
    Typographical,
    /// A wrong or carelessly rounded computation.
    Arithmetical,
    /// A wrong idea.
    Conceptual,
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
        let (kind, expected, erratum) = (Kind::Value, Verdict::Reproduced, None);
        Self { id, work, locator, kind, meaning, printed, unit, check, expected, erratum }
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

    /// Records an erratum.
    #[must_use]
    pub fn with_erratum(self, erratum: Erratum) -> Self {
        Self { erratum: Some(erratum), ..self }
    }
}

impl Check {
    /// A number and its witness.
    pub fn number(computed: (Evidence, fn() -> f64), witness: (Evidence, fn() -> f64)) -> Self {
        Self::Number { computed: computed.into(), witness: witness.into(), from_rounded: None, resolution: None }
    }

    /// The same, with what the source's rounded intermediate results give.
    pub fn number_from_rounded(
        computed: (Evidence, fn() -> f64),
        witness: (Evidence, fn() -> f64),
        from_rounded: fn() -> f64,
    ) -> Self {
        Self::Number {
            computed: computed.into(),
            witness: witness.into(),
            from_rounded: Some(from_rounded),
            resolution: None,
        }
    }

    /// A form that is right as printed, and its witness.
    pub fn form(printed: (Evidence, fn() -> Finding), witness: (Evidence, fn() -> Finding)) -> Self {
        Self::Form { printed: printed.into(), corrected: None, witness: witness.into() }
    }

    /// A form that fails as printed, its correction, and the correction's witness.
    pub fn corrected_form(
        printed: (Evidence, fn() -> Finding),
        corrected: fn() -> Finding,
        witness: (Evidence, fn() -> Finding),
    ) -> Self {
        Self::Form { printed: printed.into(), corrected: Some(corrected), witness: witness.into() }
    }

    /// The kinds of evidence used, the first route's first.
    pub fn evidence(&self) -> Vec<Evidence> {
        match self {
            Self::Number { computed, witness, .. } => vec![computed.evidence, witness.evidence],
            Self::Form { printed, witness, .. } => vec![printed.evidence, witness.evidence],
            Self::Missing { .. } => Vec::new(),
        }
    }
}

impl<T> From<(Evidence, fn() -> T)> for Route<T> {
    fn from((evidence, run): (Evidence, fn() -> T)) -> Self {
        Self { evidence, run }
    }
}

impl Finding {
    /// It holds if `holds`, found so.
    pub fn new(holds: bool, how: impl Into<String>) -> Self {
        Self { holds, how: how.into() }
    }
}

impl From<Result<Proof, Refutation>> for Finding {
    fn from(result: Result<Proof, Refutation>) -> Self {
        match result {
            Ok(proof) => Self::new(true, proof.to_string()),
            Err(refutation) => Self::new(false, refutation.to_string()),
        }
    }
}

/// Gives an enum the names it has in data, and shows it by them.
macro_rules! slugs {
    ($type:ident { $($variant:ident = $slug:literal),+ $(,)? }) => {
        impl $type {
            /// All values.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// The name used in data.
            pub fn slug(self) -> &'static str {
                match self { $(Self::$variant => $slug),+ }
            }
        }

        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.pad(self.slug())
            }
        }
    };
}

slugs!(Kind { Value = "value", Equation = "equation", Figure = "figure", Statement = "statement" });

slugs!(Evidence {
    ClosedForm = "closed-form",
    ExactIdentity = "exact-identity",
    Jet = "jet",
    AutomaticDerivative = "automatic-derivative",
    Vectors = "vectors",
    LimitCase = "limit-case",
    Dimension = "dimension",
    OtherPlaceInSource = "other-place-in-source",
    Integration = "integration",
    Steps = "steps",
});

impl Evidence {
    /// What the kind of evidence is, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::ClosedForm => "a formula evaluated",
            Self::ExactIdentity => {
                "an identity between rational functions, proven by exact evaluation on a large enough grid"
            }
            Self::Jet => "a derivative taken by power series of where things are",
            Self::AutomaticDerivative => "the wheel's angle differentiated by another library's dual numbers",
            Self::Vectors => "lengths and angles measured between points given by their coordinates",
            Self::LimitCase => "cases in which the answer is known, or all cases of a list gone through",
            Self::Dimension => "the dimensions of the quantities",
            Self::OtherPlaceInSource => "what the same source says elsewhere",
            Self::Integration => "the equation of motion solved over the driver's angle, by integrals",
            Self::Steps => "the equation of motion solved in steps of time or angle",
        }
    }
}

slugs!(Severity {
    Transcription = "transcription",
    Typographical = "typographical",
    Arithmetical = "arithmetical",
    Conceptual = "conceptual",
});
