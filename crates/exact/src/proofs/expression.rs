//! A formula run on expressions gives its own expression: what was done with which variable, and nothing else.

use crate::scalars::field::{Field, assign_from_binary};
use num_traits::{One, Zero};
use std::collections::{BTreeSet, HashMap};
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

/// A rational expression in numbered variables, by its place in a table of all expressions that were built.
///
/// Two are equal exactly if they were built by the same operations from the same parts, so equal means equal for all
/// values of the variables. Nothing is simplified, but that zero is not added or multiplied by, nor one.
///
/// ```
/// use geneva_exact::{Expression, rational};
///
/// let [x, y] = [0, 1].map(Expression::variable);
/// let product = (x + y) * (x - y) / (1 + y);
/// assert_eq!(product.at(&[rational(5, 1), rational(3, 1)]), rational(4, 1)); // (25 − 9) / 4
/// assert_eq!(product.degrees(2), [2, 2]); // of the numerator, in x and in y
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Expression(usize);

/// How an expression is built from its parts: expressions in the table, numbers of earlier steps in a list of
/// [steps](Expression::steps).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Built<T> {
    Variable(usize),
    Integer(i64),
    Root,
    Negated(T),
    Sum(T, T),
    Product(T, T),
    Quotient(T, T),
}

impl<T> Built<T> {
    fn map<U>(self, part: impl Fn(T) -> U) -> Built<U> {
        match self {
            Self::Variable(index) => Built::Variable(index),
            Self::Integer(n) => Built::Integer(n),
            Self::Root => Built::Root,
            Self::Negated(a) => Built::Negated(part(a)),
            Self::Sum(a, b) => Built::Sum(part(a), part(b)),
            Self::Product(a, b) => Built::Product(part(a), part(b)),
            Self::Quotient(a, b) => Built::Quotient(part(a), part(b)),
        }
    }
}

/// All expressions by their places, and their places by how they are built.
struct Table {
    built: Vec<Built<Expression>>,
    places: HashMap<Built<Expression>, usize>,
}

fn table() -> MutexGuard<'static, Table> {
    static TABLE: LazyLock<Mutex<Table>> = LazyLock::new(|| {
        let built = vec![Built::Integer(0), Built::Integer(1)];
        let places = built.iter().zip(0..).map(|(built, place)| (*built, place)).collect();
        Mutex::new(Table { built, places })
    });
    TABLE.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Expression {
    /// 0, the first in the table.
    pub const ZERO: Self = Self(0);
    /// 1, the second.
    pub const ONE: Self = Self(1);

    fn new(built: Built<Self>) -> Self {
        let mut table = table();
        let next = table.built.len();
        let place = *table.places.entry(built).or_insert(next);
        if place == next {
            table.built.push(built);
        }
        Self(place)
    }

    /// The variable with this index.
    pub fn variable(index: usize) -> Self {
        Self::new(Built::Variable(index))
    }

    /// A root: a constant that is not an integer and equal to no other expression. Which integer stands under it, the
    /// proof says: [`prove_with_root`](crate::prove_with_root).
    pub fn root() -> Self {
        Self::new(Built::Root)
    }

    /// The product of this with itself.
    pub fn squared(self) -> Self {
        self * self
    }

    /// The value for these values of the variables, in the unit of what is expressed, of an expression without a root.
    ///
    /// A variable without a value stops the program with a panic, as a division by zero does if `S` is exact.
    pub fn at<S: Field>(self, variables: &[S]) -> S {
        value(&self.steps(), variables, &S::zero())
    }

    /// Degree of the numerator in each of so many variables, at most, over the expressions that were divided by.
    pub fn degrees(self, variables: usize) -> Vec<u32> {
        super::degree::degrees(&self.steps(), variables)
    }

    /// The expression taken apart: each step has the numbers of earlier ones as parts, and the last is the whole.
    pub(super) fn steps(self) -> Vec<Built<usize>> {
        let table = table();
        let (mut needed, mut open) = (BTreeSet::new(), vec![self.0]);
        while let Some(place) = open.pop() {
            if needed.insert(place) {
                match table.built[place] {
                    Built::Variable(_) | Built::Integer(_) | Built::Root => {}
                    Built::Negated(a) => open.push(a.0),
                    Built::Sum(a, b) | Built::Product(a, b) | Built::Quotient(a, b) => open.extend([a.0, b.0]),
                }
            }
        }
        // Parts are in the table before the whole, so rising places are an order of evaluation.
        let numbers: HashMap<usize, usize> =
            needed.iter().enumerate().map(|(number, place)| (*place, number)).collect();
        needed.iter().map(|place| table.built[*place].map(|part| numbers[&part.0])).collect()
    }
}

/// The value of an expression's [steps](Expression::steps) for these values of the variables and of the root. A division
/// by zero does what it does in these numbers.
pub(super) fn value<S: Field>(steps: &[Built<usize>], variables: &[S], root: &S) -> S {
    evaluated(steps, variables, root, |_| false).unwrap_or_else(S::zero)
}

/// The value of an expression's steps as by [`value`]; none if something is divided by what is `refused`.
pub(super) fn evaluated<S: Field>(
    steps: &[Built<usize>],
    variables: &[S],
    root: &S,
    refused: impl Fn(&S) -> bool,
) -> Option<S> {
    let mut values: Vec<S> = Vec::with_capacity(steps.len());
    for step in steps {
        let of = |number: usize| values[number].clone();
        let next = match *step {
            Built::Variable(index) => variables[index].clone(),
            Built::Integer(n) => S::integer(n),
            Built::Root => root.clone(),
            Built::Negated(a) => -of(a),
            Built::Sum(a, b) => of(a) + of(b),
            Built::Product(a, b) => of(a) * of(b),
            Built::Quotient(_, b) if refused(&values[b]) => return None,
            Built::Quotient(a, b) => of(a) / of(b),
        };
        values.push(next);
    }
    values.pop()
}

impl Add for Expression {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        match (self, other) {
            (zero, kept) | (kept, zero) if zero.is_zero() => kept,
            (a, b) => Self::new(Built::Sum(a, b)),
        }
    }
}

impl Sub for Expression {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Expression {
    type Output = Self;
    fn neg(self) -> Self {
        if self.is_zero() { self } else { Self::new(Built::Negated(self)) }
    }
}

impl Mul for Expression {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        match (self, other) {
            (kept, _) if kept.is_zero() => kept,
            (kept, one) if one.is_one() => kept,
            (_, kept) if kept.is_zero() => kept,
            (one, kept) if one.is_one() => kept,
            (a, b) => Self::new(Built::Product(a, b)),
        }
    }
}

impl Div for Expression {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if self.is_zero() || other.is_one() { self } else { Self::new(Built::Quotient(self, other)) }
    }
}

assign_from_binary!([] Expression);

/// Whole numbers stand in formulas as they are written: `1 - 2 * x`.
macro_rules! with_whole_numbers {
    ($($operation:ident $name:ident),*) => {$(
        impl $operation<i64> for Expression {
            type Output = Self;
            fn $name(self, other: i64) -> Self {
                self.$name(Self::integer(other))
            }
        }
        impl $operation<Expression> for i64 {
            type Output = Expression;
            fn $name(self, other: Expression) -> Expression {
                Expression::integer(self).$name(other)
            }
        }
    )*};
}
with_whole_numbers!(Add add, Sub sub, Mul mul, Div div);

impl Zero for Expression {
    fn zero() -> Self {
        Self::ZERO
    }
    /// Only the constant zero is known to be zero: an expression does not know values.
    fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }
}

impl One for Expression {
    fn one() -> Self {
        Self::ONE
    }
}

impl Field for Expression {
    fn integer(n: i64) -> Self {
        Self::new(Built::Integer(n))
    }
    /// An expression has no value: not a number.
    fn approximate(&self) -> f64 {
        f64::NAN
    }
}
