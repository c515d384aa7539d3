//! An identity between rational functions, proven at more points than its degree allows it to fail at.

use super::expression::{self, Built, Expression};
use super::numerator::Numerator;
use crate::scalars::surd::Surd;
use dashu_ratio::{RBig, Relaxed};
use num_traits::Zero;
use std::array::from_fn;
use std::fmt;

/// A statement "this expression is zero for all values of its `V` variables".
///
/// ```
/// use geneva_exact::{Expression, Identity, Turn, prove};
///
/// /// cos² θ + sin² θ = 1. Variable: the tangent of θ/2.
/// struct Pythagoras;
///
/// impl Identity<1> for Pythagoras {
///     fn difference(&self, [half]: [Expression; 1]) -> Expression {
///         let turn = Turn::from_half_tangent(&half);
///         turn.cos.squared() + turn.sin.squared() - 1
///     }
/// }
/// assert!(prove(&Pythagoras).is_ok()); // for every angle
/// ```
pub trait Identity<const V: usize> {
    /// Left side minus right side.
    fn difference(&self, variables: [Expression; V]) -> Expression;
}

/// A statement "this expression is zero for all values of its `V` variables" with a square root in it.
///
/// ```
/// use geneva_exact::{Expression, IdentityWithRoot, prove_with_root};
///
/// /// (x + √D)(x − √D) = x² − D, asked for √2: it holds for this D and no other.
/// struct Norm;
///
/// impl IdentityWithRoot<1> for Norm {
///     fn difference(&self, root: Expression, [x]: [Expression; 1]) -> Expression {
///         (x + root) * (x - root) - (x * x - 2)
///     }
/// }
/// assert!(prove_with_root::<2, 1>(&Norm).is_ok());
/// assert!(prove_with_root::<3, 1>(&Norm).is_err());
/// ```
pub trait IdentityWithRoot<const V: usize> {
    /// Left side minus right side.
    fn difference(&self, root: Expression, variables: [Expression; V]) -> Expression;
}

/// Proof of an identity: a polynomial of these degrees that is zero on so many points is zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proof {
    /// Bound of the degree of the difference's numerator, in each variable.
    pub degrees: Vec<u32>,
    /// Number of points at which the difference was evaluated exactly: the product of (degree + 1).
    pub points: usize,
}

/// A point where the two sides differ, exactly, or where one of them has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refutation {
    /// The values of the variables.
    pub at: Vec<RBig>,
    /// Left side minus right side there; none if something is divided by zero there.
    pub difference: Option<RBig>,
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Most variables of a large identity are not in it.
        let degrees: Vec<_> = self.degrees.iter().filter(|degree| **degree > 0).map(u32::to_string).collect();
        match &degrees[..] {
            [] => f.write_str("the two sides are exactly equal, with no variable left in the difference"),
            [only] => write!(
                f,
                "the two sides are exactly equal at {} points, enough to prove an equation of degree {only}",
                self.points
            ),
            [all @ .., last] => {
                write!(
                    f,
                    "the two sides are exactly equal at {} points, enough to prove an equation of degrees {} and \
                     {last} in its variables",
                    self.points,
                    all.join(", ")
                )
            }
        }
    }
}

impl fmt::Display for Refutation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = place(&self.at);
        match &self.difference {
            Some(difference) => write!(f, "with {at}, the two sides differ by {difference}"),
            None => write!(f, "with {at}, something is divided by zero"),
        }
    }
}

impl std::error::Error for Refutation {}

/// The values of variables in words: one value of many variables is said once.
fn place(at: &[RBig]) -> String {
    let usual = at.iter().max_by_key(|value| at.iter().filter(|other| other == value).count());
    let others: Vec<_> = at.iter().filter(|value| Some(*value) != usual).collect();
    match (usual, &others[..]) {
        (Some(usual), []) if at.len() == 1 => format!("the variable set to {usual}"),
        (Some(usual), []) => format!("every variable set to {usual}"),
        (Some(usual), [other]) if at.len() > 2 => format!("one variable set to {other} and every other to {usual}"),
        _ => format!("the variables set to {}", at.iter().map(RBig::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// Proves or refutes `identity` by exact arithmetic on a grid of rationals.
///
/// The difference's expression tells the degree of its numerator, at most. A polynomial of degree at most d in a
/// variable that vanishes at d + 1 values of it vanishes for all; over several variables the same holds on the product
/// grid. The values are the integers from 2 up; an identity must have no pole there.
///
/// ```
/// use geneva_exact::{Expression, Identity, prove};
///
/// /// The square of a sum, with or without its mixed term.
/// struct SquareOfSum(i64);
///
/// impl Identity<2> for SquareOfSum {
///     fn difference(&self, [x, y]: [Expression; 2]) -> Expression {
///         (x + y).squared() - (x * x + self.0 * x * y + y * y)
///     }
/// }
/// assert_eq!(prove(&SquareOfSum(2)).map(|proof| proof.points), Ok(9)); // degree 2 in both: 3 · 3 points
/// assert!(prove(&SquareOfSum(0)).is_err_and(|refuted| refuted.difference.is_some()));
/// ```
///
/// # Errors
///
/// [`Refutation`] with the first point of the grid at which the sides differ, or at which something is divided by zero.
pub fn prove<const V: usize>(identity: &(impl Identity<V> + ?Sized)) -> Result<Proof, Refutation> {
    let difference = identity.difference(from_fn(Expression::variable));
    let steps = difference.steps();
    let mut numerator = Numerator::of(&steps, V);
    on_a_grid(difference, V, |at, changed| match numerator.is_zero_at(at, changed) {
        Some(true) => Some(RBig::ZERO),
        Some(false) => Some(value(&steps, &point(at))),
        None => None,
    })
}

/// Proves or refutes an identity in which √D stands, as [`prove`] does, with the root kept exact.
///
/// ```
/// use geneva_exact::{Expression, IdentityWithRoot, prove_with_root};
///
/// /// 1 / (x + √2) = (x − √2) / (x² − 2).
/// struct Conjugate;
///
/// impl IdentityWithRoot<1> for Conjugate {
///     fn difference(&self, root: Expression, [x]: [Expression; 1]) -> Expression {
///         1 / (x + root) - (x - root) / (x * x - 2)
///     }
/// }
/// assert!(prove_with_root::<2, 1>(&Conjugate).is_ok());
/// ```
///
/// # Errors
///
/// [`Refutation`]; its difference is the part without the root, or what stands before the root if that part is zero.
pub fn prove_with_root<const D: u32, const V: usize>(identity: &impl IdentityWithRoot<V>) -> Result<Proof, Refutation> {
    let difference = identity.difference(Expression::root(), from_fn(Expression::variable));
    let steps = difference.steps();
    on_a_grid(difference, V, |at, _| value_with_root::<D>(&steps, &point(at)))
}

fn value(steps: &[Built<usize>], at: &[Relaxed]) -> RBig {
    expression::value(steps, at, &Relaxed::zero()).canonicalize()
}

/// None if something is divided by zero.
fn value_with_root<const D: u32>(steps: &[Built<usize>], at: &[Relaxed]) -> Option<RBig> {
    let at: Vec<_> = at.iter().cloned().map(Surd::<Relaxed, D>::from_plain).collect();
    let value = expression::evaluated(steps, &at, &Surd::root(), Zero::is_zero)?;
    let plain = value.plain.canonicalize();
    Some(if plain.is_zero() { value.rooted.canonicalize() } else { plain })
}

/// Looks for a point of the grid at which the `value` of `difference` is not zero or is none; there are none if the bound
/// of its degree is a bound. From point to point the first variable changes, and the others as the digits of a number do; the
/// last that has changed is told to `value`.
fn on_a_grid(
    difference: Expression,
    variables: usize,
    mut value: impl FnMut(&[usize], usize) -> Option<RBig>,
) -> Result<Proof, Refutation> {
    let degrees = difference.degrees(variables);
    let points = degrees.iter().fold(1_usize, |points, degree| points.saturating_mul(*degree as usize + 1));
    let mut at = vec![LEAST; variables];
    let mut changed = variables.saturating_sub(1);
    for _ in 0..points {
        let difference = value(&at, changed);
        if !difference.as_ref().is_some_and(Zero::is_zero) {
            // Variables that stand nowhere come last.
            let used = degrees.iter().rposition(|degree| *degree > 0).map_or(1, |last| last + 1);
            return Err(Refutation { at: at.into_iter().take(used).map(RBig::from).collect(), difference });
        }
        for (variable, degree) in degrees.iter().enumerate() {
            changed = variable;
            if at[variable] < LEAST + *degree as usize {
                at[variable] += 1;
                break;
            }
            at[variable] = LEAST;
        }
    }
    Ok(Proof { degrees, points })
}

/// The values of a variable are 2, 3, 4 …: integers keep the fractions short; zero and one are where formulas have
/// their poles.
const LEAST: usize = 2;

fn point(at: &[usize]) -> Vec<Relaxed> {
    at.iter().map(|value| Relaxed::from(*value)).collect()
}
