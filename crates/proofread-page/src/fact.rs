//! What is told of a finding beside its sentence.

/// Something known about a finding.
#[derive(Clone, Debug, PartialEq)]
pub struct Fact {
    /// What it is: printed, recomputed, hint and so on.
    pub label: &'static str,
    /// What is said.
    pub text: String,
}
