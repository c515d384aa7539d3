//! The characters of an equation as an identity, proven without rounding.
//!
//! What is not rational in a display is given: sine and cosine, the half powers of one base, the sign that opens bars.
//! Then it is an [`Expression`], which has a value on any field, and [`geneva_kinematics::prove`] decides it for all
//! values of the letters.

use super::number::Number;
use super::tree::Function;
use super::{Display, Illegible, Moment};
use crate::Finding;
use geneva_kinematics::{Expression, Field, Identity, prove};

/// An expression has the four operations and whole powers, and no function.
impl Number for Expression {
    fn integer(n: i64) -> Self {
        <Self as Field>::integer(n)
    }

    fn pi() -> Option<Self> {
        None
    }

    fn size(&self) -> f64 {
        self.approximate()
    }

    fn apply(self, _: Function) -> Option<Self> {
        None
    }

    fn power(self, exponent: f64) -> Option<Self> {
        let whole = (0..=16).find(|whole| f64::from(*whole) == exponent)?;
        Some((0..whole).fold(Self::ONE, |product, _| product * self))
    }
}

/// What the letters stand for, for either sign of what stands between bars: 1 or −1.
pub type Exact = fn(i64) -> Moment<Expression>;

/// How many variables the letters of a display are made of, at most.
const VARIABLES: usize = 9;

/// Proves an equation for both signs of what stands between bars, or refutes it; with it, that what is given for half
/// powers is their value.
///
/// What cannot be read is neither right nor wrong. Characters and letters stand in the ledger's own text: a display that
/// its letters do not suffice for is a mistake there, which must not pass for a slip of the source.
pub fn decide(tex: &str, letters: Exact) -> Finding {
    let mut parts: Vec<Expression> = Vec::new();
    for moment in [1, -1].map(letters) {
        let display = Display::read_line(tex).and_then(|display| display.differences(&moment));
        let differences = display.unwrap_or_else(|illegible: Illegible| panic!("{tex}: {illegible}"));
        for part in differences.into_iter().chain(moment.conditions()) {
            // Without bars both signs are one case.
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
    }
    let findings: Vec<Finding> = parts.into_iter().map(|part| prove::<VARIABLES>(&Zero(part)).into()).collect();
    match findings.iter().find(|finding| !finding.holds) {
        Some(refuted) => refuted.clone(),
        None => {
            let how: Vec<_> = findings.into_iter().map(|finding| finding.how).collect();
            Finding::new(true, format!("the characters: {}", how.join("; ")))
        }
    }
}

/// The statement that an expression is zero.
struct Zero(Expression);

impl Identity<VARIABLES> for Zero {
    fn difference(&self, _: [Expression; VARIABLES]) -> Expression {
        self.0
    }
}
