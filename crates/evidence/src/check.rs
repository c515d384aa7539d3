//! How a claim is checked: two routes that share no code, and what each of them must refuse.

use crate::{Evidence, Stated};
use geneva_exact::{Proof, Refutation};
use std::fmt;
use std::panic::Location;
use std::sync::Arc;

/// A way to a number.
pub type NumberFn = dyn Fn() -> f64 + Send + Sync;

/// A way to find whether something holds that needs no characters.
pub type TestFn = dyn Fn() -> Finding + Send + Sync;

/// Whether characters hold in the place of those of an equation, and how that was found.
pub type DecisionFn = dyn Fn(&str) -> Finding + Send + Sync;

/// A way to find whether a statement holds, which is tried on the right statement and on its neighbour.
pub type ChoiceFn = dyn Fn(Stated<'_>) -> Finding + Send + Sync;

/// Whether characters hold wherever they are read and evaluated; none if they cannot be read.
pub type ReadingFn = dyn Fn(&str) -> Option<bool> + Send + Sync;

/// How a claim is checked.
#[derive(Clone)]
pub enum Check {
    /// A number, computed once and computed again by a witness.
    Number {
        /// What the source says it did gives this value, in the printed unit.
        computed: Route<NumberFn>,
        /// The number again, by a route that shares no code with the first.
        witness: Route<NumberFn>,
        /// What the source's own rounded intermediate results give, if it is computed from any.
        from_rounded: Option<Arc<NumberFn>>,
        /// Resolution of the reading, in the printed unit, if the number was read from a curve or print-out.
        resolution: Option<Arc<NumberFn>>,
        /// The right value by two routes, if there is a slip in what the source did.
        right: Option<[Route<NumberFn>; 2]>,
    },
    /// An equation that holds or fails. Both routes read its characters, so each can be tried on misprints of them, which a
    /// program makes. What the letters stand for comes from two places.
    Equation {
        /// Decides on the characters, as printed and as corrected.
        first: Route<DecisionFn>,
        /// Reads and evaluates the right characters, with other values of their letters.
        witness: Route<ReadingFn>,
        /// What the characters say in the letters of mathematics, if the source's own are not ours to print.
        said: Option<&'static str>,
        /// Something else that shows which equation is right, beside the witness.
        also: Option<Route<TestFn>>,
    },
    /// A statement or a figure. Each route is tried twice, on what is right and on a neighbour that is wrong.
    Statement {
        /// The first route.
        first: Route<ChoiceFn>,
        /// A route that shares no code with the first.
        witness: Route<ChoiceFn>,
        /// The neighbour in words; none if it is the printed form, which is wrong.
        neighbour: Option<&'static str>,
    },
    /// A value that the check needs is missing from the source.
    Missing {
        /// Which value is missing, and why nothing in the source replaces it.
        reason: &'static str,
    },
}

/// A way to a result, with the kind of evidence that it is.
pub struct Route<R: ?Sized> {
    /// The kind of evidence.
    pub evidence: &'static Evidence,
    /// Computes the result.
    pub run: Arc<R>,
    /// The line of our code that states it; of a route that reads characters, the line that states what the letters are.
    pub stated_at: &'static Location<'static>,
}

/// Whether a form holds, and how that was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Whether it holds.
    pub holds: bool,
    /// How that was found, in a clause.
    pub how: String,
    /// Whether it could be evaluated. If it could not, it is neither right nor wrong, so a claim with such a finding
    /// differs from its record, whatever the record says.
    pub evaluated: bool,
}

impl Check {
    /// The kinds of evidence used, the first route's first; of a witness that has something beside it, the other kind.
    pub fn evidence(&self) -> Vec<&'static Evidence> {
        match self {
            Self::Number { computed, witness, .. } => vec![computed.evidence, witness.evidence],
            Self::Equation { first, witness, also, .. } => {
                vec![first.evidence, also.as_ref().map_or(witness.evidence, |also| also.evidence)]
            }
            Self::Statement { first, witness, .. } => vec![first.evidence, witness.evidence],
            Self::Missing { .. } => Vec::new(),
        }
    }

    /// Where in our code the two routes are stated, the first route's first, as of [`evidence`](Self::evidence).
    pub fn places(&self) -> Vec<&'static Location<'static>> {
        match self {
            Self::Number { computed, witness, .. } => vec![computed.stated_at, witness.stated_at],
            Self::Equation { first, witness, also, .. } => {
                vec![first.stated_at, also.as_ref().map_or(witness.stated_at, |also| also.stated_at)]
            }
            Self::Statement { first, witness, .. } => vec![first.stated_at, witness.stated_at],
            Self::Missing { .. } => Vec::new(),
        }
    }
}

impl<R: ?Sized> Route<R> {
    /// A route that is stated where this is called.
    #[track_caller]
    pub fn new(evidence: &'static Evidence, run: Arc<R>) -> Self {
        Self { evidence, run, stated_at: Location::caller() }
    }
}

impl fmt::Debug for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Check").field(&self.evidence()).finish()
    }
}

impl<R: ?Sized> Clone for Route<R> {
    fn clone(&self) -> Self {
        Self { evidence: self.evidence, run: Arc::clone(&self.run), stated_at: self.stated_at }
    }
}

impl Finding {
    /// It holds if `holds`, found so.
    pub fn new(holds: bool, how: impl Into<String>) -> Self {
        Self { holds, how: how.into(), evaluated: true }
    }

    /// It holds if each of some items does and there is one; the clause says for how many of how many that is so.
    pub fn for_all<T>(
        items: impl IntoIterator<Item = T>,
        holds: impl Fn(T) -> bool,
        how: impl FnOnce(usize, usize) -> String,
    ) -> Self {
        let found: Vec<bool> = items.into_iter().map(holds).collect();
        let right = found.iter().filter(|right| **right).count();
        Self::new(right > 0 && right == found.len(), how(right, found.len()))
    }

    /// Whether characters hold that were read and evaluated; none if they cannot be read.
    pub fn of_reading(holds: Option<bool>) -> Self {
        let how = "we read the printed characters and evaluated them";
        holds.map_or_else(|| Self::not_evaluated("the characters cannot be read"), |holds| Self::new(holds, how))
    }

    /// Whether this holds and another finding too.
    pub fn and(self, other: Self) -> Self {
        let how = format!("{}; {}", self.how, other.how);
        Self { holds: self.holds && other.holds, how, evaluated: self.evaluated && other.evaluated }
    }

    /// What was found in several cases, one after the other; if it is the same in all of them, it is said once.
    pub fn of_cases(holds: bool, findings: &[Self]) -> Self {
        let how: Vec<&str> = findings.iter().map(|finding| finding.how.as_str()).collect();
        let same = how.len() > 1 && how.iter().all(|other| *other == how[0]);
        Self::new(holds, if same { format!("in each of {} cases, {}", how.len(), how[0]) } else { how.join("; ") })
    }

    /// It could not be evaluated, and why.
    pub fn not_evaluated(why: impl Into<String>) -> Self {
        Self { holds: false, how: why.into(), evaluated: false }
    }
}

impl From<Result<Proof, Refutation>> for Finding {
    fn from(result: Result<Proof, Refutation>) -> Self {
        match result {
            Ok(proof) => Self::new(true, proof.to_string()),
            Err(refutation) if refutation.difference.is_none() => Self::not_evaluated(refutation.to_string()),
            Err(refutation) => Self::new(false, refutation.to_string()),
        }
    }
}
