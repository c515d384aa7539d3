//! Does the equation of motion never divide by zero?

use crate::proving::holds;
use geneva_dynamics::singularity::{AtOne, BoundAsSquare, OffTheSingularity, SingularAngle, StartAtEntry};

#[test]
fn nothing_is_divided_by_zero() {
    holds("θ∞", &SingularAngle);
    holds("(a − 1)²", &BoundAsSquare);
    holds("a = 1", &AtOne);
    holds("positive", &OffTheSingularity);
    holds("start at entry", &StartAtEntry);
}
