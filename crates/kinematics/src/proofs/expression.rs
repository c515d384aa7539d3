//! Expressions that know whether they were built alike.

use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, PoisonError};

/// An arithmetic expression, by its place in a table of all expressions that were built.
///
/// Two have the same place exactly if they were built by the same operations from the same parts, so equal means
/// equal for all values of the variables. Nothing is simplified.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Expression(usize);

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Built {
    Variable(usize),
    Integer(i64),
    Root,
    Sum(Expression, Expression),
    Product(Expression, Expression),
    Quotient(Expression, Expression),
    Negated(Expression),
}

impl Expression {
    fn new(built: Built) -> Self {
        static TABLE: LazyLock<Mutex<HashMap<Built, usize>>> = LazyLock::new(Mutex::default);
        let mut table = TABLE.lock().unwrap_or_else(PoisonError::into_inner);
        let next = table.len();
        Self(*table.entry(built).or_insert(next))
    }

    /// The variable with this index.
    pub(crate) fn variable(index: usize) -> Self {
        Self::new(Built::Variable(index))
    }

    /// A root: a constant that is no whole number and equal to no other expression.
    pub(crate) fn root() -> Self {
        Self::new(Built::Root)
    }

    /// A whole number.
    pub(crate) fn integer(n: i64) -> Self {
        Self::new(Built::Integer(n))
    }

    /// This plus the other.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self::new(Built::Sum(self, other))
    }

    /// This times the other.
    pub(crate) fn times(self, other: Self) -> Self {
        Self::new(Built::Product(self, other))
    }

    /// This over the other.
    pub(crate) fn over(self, other: Self) -> Self {
        Self::new(Built::Quotient(self, other))
    }

    /// Minus this.
    pub(crate) fn negated(self) -> Self {
        Self::new(Built::Negated(self))
    }
}
