//! Does the equation of motion never divide by zero?

use crate::proving::holds;
use geneva_dynamics::singularity::{OffTheSingularity, StartAtEntry};

#[test]
fn nothing_is_divided_by_zero() {
    holds("positive", &OffTheSingularity);
    holds("start at entry", &StartAtEntry);
}
