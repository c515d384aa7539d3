//! The characters of an equation as an identity, proven without rounding.
//!
//! What is not rational in a display is given: sine and cosine, the half powers of one base, the sign that opens bars.
//! Then it is an [`Expression`], which has a value on any field, and [`geneva_exact::prove`] decides it for all
//! values of the letters.

use super::number::Number;
use super::tree::Function;
use super::{Display, Illegible, Moment};
use crate::Finding;
use geneva_exact::{Expression, Field, Identity, IdentityWithRoot, prove, prove_with_root};
use std::collections::{HashMap, HashSet};
use std::sync::{Arc, LazyLock, Mutex, OnceLock, PoisonError};

/// An expression has the four operations and whole powers, and no function.
impl Number for Expression {
    fn integer(n: i64) -> Self {
        <Self as Field>::integer(n)
    }

    fn pi() -> Option<Self> {
        None
    }

    /// Only the constant zero is known to be zero.
    fn size(&self) -> f64 {
        if *self == Self::ZERO { 0.0 } else { self.approximate() }
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
const VARIABLES: usize = 14;

/// Proves an equation for both signs of what stands between bars, or refutes it; with it, that what is given for half
/// powers is their value.
///
/// What cannot be read or evaluated is neither right nor wrong: characters that make no formula, a name that stands for
/// nothing, a division by zero. It must not pass for a slip of the source, so the finding says that it was not evaluated.
pub fn decide(tex: &str, letters: Exact) -> Finding {
    decided(Display::read(tex).and_then(Display::without_number), letters)
}

/// Proves or refutes an equation of joined lines, as [`decide`] does a whole one.
pub fn decide_joined(tex: &str, letters: Exact) -> Finding {
    decided(Display::read_joined(tex).and_then(Display::without_number), letters)
}

fn decided(display: Result<Display, Illegible>, letters: Exact) -> Finding {
    let (mut parts, mut conditions) = (Vec::new(), Vec::new());
    let mut root = None;
    for sign in [1, -1] {
        let moment = letters(sign);
        match display.as_ref().map_err(Clone::clone).and_then(|display| display.differences(&moment, sign)) {
            Ok(differences) => parts.extend(differences),
            Err(illegible) => return Finding::not_evaluated(illegible.to_string()),
        }
        root = moment.under_root();
        conditions.extend(moment.conditions());
    }
    all_zero(parts, conditions, root)
}

/// Proves an equation that holds only where something vanishes: its two sides, times a factor, are as far apart as that is from
/// zero. Of a chain, some sides may be equal everywhere, but not all.
pub fn decide_multiple(tex: &str, letters: fn() -> (Moment<Expression>, Expression, Expression)) -> Finding {
    let (moment, factor, vanishing) = letters();
    let differences = |display: Display| {
        let signs = if display.has_double_sign() { &[1, -1][..] } else { &[1] };
        signs.iter().map(|sign| display.differences(&moment, *sign)).collect::<Result<Vec<_>, _>>()
    };
    let differences = match Display::read(tex).and_then(Display::without_number).and_then(differences) {
        Ok(differences) => differences.concat(),
        Err(illegible) => return Finding::not_evaluated(illegible.to_string()),
    };
    let (equal, apart): (Vec<_>, Vec<_>) =
        differences.into_iter().partition(|part| zero(*part, moment.under_root()).holds);
    if apart.is_empty() {
        return Finding::new(false, "the two sides are equal everywhere");
    }
    let parts = apart.into_iter().map(|part| part * factor - vanishing).chain(equal).collect();
    all_zero(parts, moment.conditions(), moment.under_root())
}

/// Whether all parts are zero, and all conditions. The third part of a vector of the plane is so without a proof.
fn all_zero(mut parts: Vec<Expression>, conditions: Vec<Expression>, root: Option<u32>) -> Finding {
    if parts.iter().any(|part| *part != Expression::ZERO) {
        parts.retain(|part| *part != Expression::ZERO);
    }
    let findings: Vec<Finding> = without_repetition(parts).map(|part| zero(part, root)).collect();
    let given = || without_repetition(conditions).map(|condition| zero(condition, root));
    let not_evaluated = findings.iter().find(|finding| !finding.evaluated);
    let refuted = not_evaluated.or_else(|| findings.iter().find(|finding| !finding.holds)).cloned();
    let refuted = refuted.or_else(|| given().find(|finding: &Finding| !finding.holds));
    refuted.unwrap_or_else(|| Finding::of_cases(true, &findings))
}

/// Without bars both signs are one case.
fn without_repetition(parts: Vec<Expression>) -> impl Iterator<Item = Expression> {
    let mut seen = HashSet::new();
    parts.into_iter().filter(move |part| seen.insert(*part))
}

/// Whether an expression is zero, found once: the lines of a display have one proof, and what is given is given to many.
fn zero(part: Expression, root: Option<u32>) -> Finding {
    type Found = HashMap<(Expression, Option<u32>), Arc<OnceLock<Finding>>>;
    static FOUND: LazyLock<Mutex<Found>> = LazyLock::new(Mutex::default);
    let own = Arc::clone(FOUND.lock().unwrap_or_else(PoisonError::into_inner).entry((part, root)).or_default());
    let find = || match root {
        None => prove(&Zero(part)).into(),
        Some(2) => prove_with_root::<2, VARIABLES>(&Zero(part)).into(),
        Some(3) => prove_with_root::<3, VARIABLES>(&Zero(part)).into(),
        Some(other) => Finding::not_evaluated(format!("no proof is prepared for the root of {other}, only of 2 and 3")),
    };
    own.get_or_init(find).clone()
}

/// The statement that an expression is zero.
struct Zero(Expression);

impl Identity<VARIABLES> for Zero {
    fn difference(&self, _: [Expression; VARIABLES]) -> Expression {
        self.0
    }
}

impl IdentityWithRoot<VARIABLES> for Zero {
    fn difference(&self, _: Expression, _: [Expression; VARIABLES]) -> Expression {
        self.0
    }
}
