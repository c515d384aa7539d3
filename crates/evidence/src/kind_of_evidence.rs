//! Kinds of evidence, as values: what a route is, and how exactly it must agree with another.

use crate::tolerance::{ROUTES, Tolerance};
use std::fmt;
use std::hash::{Hash, Hasher};

/// A kind of evidence: how a route finds its result, and how closely it must agree with the other route.
///
/// The kinds that any subject has are constants here. A ledger may have others of its own.
///
/// ```
/// use geneva_evidence::{Agreement, Evidence, Tolerance};
///
/// static STEPS: Tolerance = Tolerance { name: "steps", relative: 1e-5, reason: "a step is of the fourth order" };
/// /// An equation solved in steps of time.
/// const IN_STEPS: &Evidence =
///     &Evidence { slug: "in-steps", name: "steps", meaning: "an equation solved in steps of time", agreement: Agreement::Within(&STEPS) };
/// assert_ne!(IN_STEPS, Evidence::CLOSED_FORM);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Evidence {
    /// The name in data.
    pub slug: &'static str,
    /// What it is in a word or two, for readers.
    pub name: &'static str,
    /// What it is, for readers.
    pub meaning: &'static str,
    /// How closely a number found so must agree with another.
    pub agreement: Agreement,
}

/// How closely two routes to a number must agree.
#[derive(Clone, Copy, Debug)]
pub enum Agreement {
    /// Within a relative tolerance.
    Within(&'static Tolerance),
    /// The route gives another printed number, which is known only to the digits of the one that is checked.
    ToPrintedDigits,
}

impl Evidence {
    /// A formula evaluated.
    pub const CLOSED_FORM: &'static Self = &Self::between_routes("closed-form", "a formula", "a formula evaluated");
    /// An identity proven over the rationals at more points than its degree allows it to fail.
    pub const EXACT_IDENTITY: &'static Self = &Self::between_routes(
        "exact-identity",
        "an exact proof",
        "an identity between rational functions, proven by exact evaluation on a large enough grid",
    );
    /// A derivative taken by truncated power series of where things are.
    pub const JET: &'static Self =
        &Self::between_routes("jet", "power series", "a derivative taken from power series of the positions");
    /// Derivatives by another library's automatic differentiation.
    pub const AUTOMATIC_DERIVATIVE: &'static Self = &Self::between_routes(
        "automatic-derivative",
        "dual numbers",
        "positions and angles differentiated with another library's dual numbers",
    );
    /// Vectors from coordinates.
    pub const VECTORS: &'static Self = &Self::between_routes(
        "vectors",
        "coordinates",
        "lengths and angles measured between points given by their coordinates",
    );
    /// A case in which the answer is known.
    pub const LIMIT_CASE: &'static Self = &Self::between_routes(
        "limit-case",
        "individual cases",
        "cases whose answer is known, or every case of a list, one by one",
    );
    /// The dimensions of the quantities.
    pub const DIMENSION: &'static Self =
        &Self::between_routes("dimension", "dimensions", "the dimensions of the quantities");
    /// What the same source says elsewhere.
    pub const OTHER_PLACE_IN_SOURCE: &'static Self = &Self {
        slug: "other-place-in-source",
        name: "another place in the source",
        meaning: "what the same source says in another place",
        agreement: Agreement::ToPrintedDigits,
    };

    /// A kind of evidence whose numbers agree as far as arithmetic goes: within [`ROUTES`].
    pub const fn between_routes(slug: &'static str, name: &'static str, meaning: &'static str) -> Self {
        Self { slug, name, meaning, agreement: Agreement::Within(&ROUTES) }
    }

    /// The tolerance within which its numbers must agree; none if only printed digits can be compared.
    pub fn tolerance(&self) -> Option<&'static Tolerance> {
        match self.agreement {
            Agreement::Within(tolerance) => Some(tolerance),
            Agreement::ToPrintedDigits => None,
        }
    }
}

impl PartialEq for Evidence {
    fn eq(&self, other: &Self) -> bool {
        self.slug == other.slug
    }
}

impl Eq for Evidence {}

impl Hash for Evidence {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.slug.hash(state);
    }
}

impl fmt::Display for Evidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.slug)
    }
}
