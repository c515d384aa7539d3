//! For tests: an identity holds, with the proof and the time it took shown.

use geneva_kinematics::{Identity, prove};
use std::time::Instant;

/// Stops the test unless the identity is proven.
#[track_caller]
pub fn holds<const V: usize>(name: &str, identity: &impl Identity<V>) {
    let start = Instant::now();
    let proof = prove(identity).unwrap_or_else(|refutation| panic!("{name}: {refutation}"));
    println!("{name}: {proof}; {:?}", start.elapsed());
}
