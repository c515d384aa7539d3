//! For tests: an identity holds, with the proof shown.

use geneva_kinematics::{Identity, prove};

/// Stops the test unless the identity is proven.
#[track_caller]
pub(crate) fn holds<const V: usize>(name: &str, identity: &impl Identity<V>) {
    let proof = prove(identity).unwrap_or_else(|refutation| panic!("{name}: {refutation}"));
    println!("{name}: {proof}");
}
