//! An identity between rational functions, proven at more points than its degree allows it to fail at.

use super::degree::DegreeBound;
use crate::scalars::field::Field;
use crate::scalars::surd::Surd;
use dashu_ratio::{RBig, Relaxed};
use std::array::from_fn;
use std::fmt;

/// A statement "this expression is zero for all values of its `V` variables".
pub trait Identity<const V: usize> {
    /// Left side minus right side, over any field.
    fn difference<S: Field>(&self, variables: &[S; V]) -> S;
}

/// What makes an identity certain: a polynomial of these degrees that is zero on so many points is zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proof {
    /// Bound of the degree of the difference's numerator, in each variable.
    pub degrees: Vec<u32>,
    /// Number of points at which the difference was evaluated exactly: the product of (degree + 1).
    pub points: usize,
}

/// A point where the two sides differ, exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refutation {
    /// The values of the variables.
    pub at: Vec<RBig>,
    /// Left side minus right side there.
    pub difference: RBig,
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let degrees: Vec<_> = self.degrees.iter().map(u32::to_string).collect();
        write!(f, "exact at {} points, degree at most {}", self.points, degrees.join(", "))
    }
}

impl fmt::Display for Refutation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at: Vec<_> = self.at.iter().map(RBig::to_string).collect();
        write!(f, "fails at ({}): the sides differ by {}", at.join(", "), self.difference)
    }
}

impl std::error::Error for Refutation {}

/// Proves or refutes `identity` by exact arithmetic on a grid of rationals.
///
/// The degree of the difference's numerator is found by running it on [`DegreeBound`]s. A polynomial of degree at
/// most d in a variable that vanishes at d + 1 values of it vanishes for all; over several variables the same holds
/// on the product grid. The values are the whole numbers from 2 up; an identity must have no pole there (a division
/// by zero stops the proof with a panic, as any division by zero of a rational does).
pub fn prove<const V: usize>(identity: &impl Identity<V>) -> Result<Proof, Refutation> {
    let bound = identity.difference(&from_fn(DegreeBound::<V>::variable));
    on_a_grid(&bound, |at| identity.difference(at).canonicalize())
}

/// A statement "this expression is zero for all values of its variables" with a square root in it.
pub trait IdentityWithRoot<const V: usize> {
    /// Left side minus right side, over any field that has the root.
    fn difference<S: Field>(&self, root: &S, variables: &[S; V]) -> S;
}

/// Proves or refutes an identity in which √D stands, as [`prove`] does, with the root kept exact.
///
/// A refutation tells the part of the difference without the root, or what stands before the root if that is zero.
pub fn prove_with_root<const D: u32, const V: usize>(identity: &impl IdentityWithRoot<V>) -> Result<Proof, Refutation> {
    let bound = identity.difference(&DegreeBound::root(), &from_fn(DegreeBound::<V>::variable));
    on_a_grid(&bound, |at| {
        let at = at.clone().map(Surd::<Relaxed, D>::from_plain);
        let difference = identity.difference(&Surd::root(), &at);
        let plain = difference.plain.canonicalize();
        if plain.is_zero() { difference.rooted.canonicalize() } else { plain }
    })
}

/// Looks for a point of the grid at which `difference` is not zero; there are none if the bound is a bound.
fn on_a_grid<const V: usize>(
    bound: &DegreeBound<V>,
    difference: impl Fn(&[Relaxed; V]) -> RBig,
) -> Result<Proof, Refutation> {
    let sides: [usize; V] = bound.numerator().map(|degree| degree as usize + 1);
    let points: usize = sides.iter().product();
    for index in 0..points {
        let mut rest = index;
        let at: [Relaxed; V] = from_fn(|v| {
            let k = rest % sides[v];
            rest /= sides[v];
            abscissa(k)
        });
        let difference = difference(&at);
        if !difference.is_zero() {
            return Err(Refutation { at: at.map(Relaxed::canonicalize).to_vec(), difference });
        }
    }
    Ok(Proof { degrees: bound.numerator().to_vec(), points })
}

/// The k-th value: 2, 3, 4 … Whole numbers keep the fractions short; zero and one are where formulas have their poles.
fn abscissa(k: usize) -> Relaxed {
    Relaxed::from(k + 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Binomial {
        wrong: i64,
    }

    impl Identity<2> for Binomial {
        /// (x + y)² − (x² + (2 + wrong) x y + y²)
        fn difference<S: Field>(&self, [x, y]: &[S; 2]) -> S {
            let (x, y) = (x.clone(), y.clone());
            let sum = x.clone() + y.clone();
            sum.clone() * sum - x.clone() * x.clone() - S::integer(2 + self.wrong) * x * y.clone() - y.clone() * y
        }
    }

    #[test]
    fn a_true_identity_is_proven_on_a_full_grid() {
        let proof = prove(&Binomial { wrong: 0 }).expect("the binomial formula holds");
        assert_eq!(proof, Proof { degrees: vec![2, 2], points: 9 });
    }

    #[test]
    fn a_false_identity_is_refuted_with_a_point() {
        let refutation = prove(&Binomial { wrong: 1 }).expect_err("three is not two");
        assert_eq!(refutation.difference, RBig::from(-4));
    }

    /// Two fractions that would be one if the root were a whole number.
    struct RootForOne;

    impl IdentityWithRoot<1> for RootForOne {
        fn difference<S: Field>(&self, root: &S, [x]: &[S; 1]) -> S {
            let factor = (S::integer(2) + root.clone()) / S::integer(3);
            factor / (x.clone() + root.clone()) - S::one() / (x.clone() + S::one())
        }
    }

    #[test]
    fn a_root_is_not_taken_for_a_whole_number() {
        assert!(prove_with_root::<2, 1>(&RootForOne).is_err());
    }
}
