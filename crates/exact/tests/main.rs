//! Fields, and proofs over them. The files are named after the modules that they test.

#![allow(clippy::unwrap_used, reason = "clippy knows the functions of a test program as tests only by #[test]")]

mod proofs;
mod scalars;

use geneva_exact::{Field, Turn};

/// A quotient of sums and products of its arguments, as most rates are: (k cos φ - 1) / (1 - 2 k cos φ + k²).
fn rate<S: Field>(ratio: &S, turn: &Turn<S>) -> S {
    let along = ratio.clone() * turn.cos.clone();
    (along.clone() - S::one()) / (ratio.clone() * ratio.clone() - along * S::integer(2) + S::one())
}
