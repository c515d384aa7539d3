//! How high the degree of an expression can be.

use super::expression::Built;
use std::collections::BTreeMap;
use std::iter::zip;

/// Upper bound of the degree, in each variable, of a rational function's numerator over a known denominator.
///
/// The bound remembers what was divided by, expression by expression. So fractions over the same divisor are added
/// over that divisor, and a divisor cancels when it is multiplied by; the bound stays low, and it stays a bound.
#[derive(Clone, Debug, PartialEq)]
struct Bound {
    numerator: Vec<u32>,
    /// What was divided by: the number of each divisor's step, with its power.
    divisors: BTreeMap<usize, u32>,
}

/// The bounds of all steps so far.
struct Bounds(Vec<Bound>);

/// Degree of the numerator of the last of these steps in each of so many variables, at most.
pub(super) fn degrees(steps: &[Built<usize>], variables: usize) -> Vec<u32> {
    let constant = Bound { numerator: vec![0; variables], divisors: BTreeMap::new() };
    let mut bounds = Bounds(Vec::with_capacity(steps.len()));
    for step in steps {
        let next = match *step {
            Built::Integer(_) | Built::Root => constant.clone(),
            Built::Variable(index) => {
                Bound { numerator: (0..variables).map(|v| u32::from(v == index)).collect(), ..constant.clone() }
            }
            Built::Negated(a) => bounds.0[a].clone(),
            Built::Sum(a, b) => bounds.sum(a, b),
            Built::Product(a, b) => bounds.product(a, b),
            Built::Quotient(a, b) => bounds.quotient(a, b),
        };
        bounds.0.push(next);
    }
    bounds.0.pop().unwrap_or(constant).numerator
}

impl Bounds {
    /// `degrees` raised by those of a divisor's numerator, so many times.
    fn raised(&self, degrees: &[u32], divisor: usize, times: u32) -> Vec<u32> {
        zip(degrees, &self.0[divisor].numerator).map(|(degree, more)| degree + times * more).collect()
    }

    /// Both numerators over the least common denominator; the greater degree counts.
    fn sum(&self, a: usize, b: usize) -> Bound {
        let (a, b) = (&self.0[a], &self.0[b]);
        let mut divisors = a.divisors.clone();
        for (divisor, power) in &b.divisors {
            let common = divisors.entry(*divisor).or_insert(0);
            *common = (*common).max(*power);
        }
        let over_common = |bound: &Bound| {
            divisors.iter().fold(bound.numerator.clone(), |degrees, (divisor, power)| {
                self.raised(&degrees, *divisor, power - bound.divisors.get(divisor).unwrap_or(&0))
            })
        };
        let numerator = zip(over_common(a), over_common(b)).map(|(a, b)| a.max(b)).collect();
        Bound { numerator, divisors }
    }

    /// Both numerators and both denominators. A factor that was divided by cancels, if its own numerator is all of it.
    fn product(&self, a: usize, b: usize) -> Bound {
        let mut numerator = self.raised(&self.0[a].numerator, b, 1);
        let mut divisors = self.0[a].divisors.clone();
        for (divisor, power) in &self.0[b].divisors {
            *divisors.entry(*divisor).or_insert(0) += power;
        }
        for factor in [a, b] {
            if let Some(power) = divisors.get_mut(&factor) {
                *power -= 1;
                numerator = zip(numerator, &self.0[factor].numerator).map(|(degree, less)| degree - less).collect();
                divisors.retain(|_, power| *power > 0);
            }
        }
        Bound { numerator, divisors }
    }

    /// Over the other's numerator, which becomes a divisor; times the other's divisors.
    fn quotient(&self, a: usize, b: usize) -> Bound {
        let Bound { mut numerator, mut divisors } = self.0[a].clone();
        for (divisor, power) in &self.0[b].divisors {
            // What both are divided by cancels; the rest of it multiplies the numerator.
            let mine = divisors.entry(*divisor).or_insert(0);
            let shared = *power.min(mine);
            *mine -= shared;
            numerator = self.raised(&numerator, *divisor, power - shared);
        }
        divisors.retain(|_, power| *power > 0);
        *divisors.entry(b).or_insert(0) += 1;
        Bound { numerator, divisors }
    }
}
