//! The single edit that makes two sides agree.

use crate::chain::{Relation, Side};

/// An edit of one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Hint {
    /// What to change, in words.
    pub words: String,
}

/// The one near edit that makes the sides agree.
pub(crate) fn hint(_left: &Side, _right: &Side, _relation: Relation) -> Option<Hint> {
    None
}
