//! Exact proofs: degrees, expressions, identities.

mod degree;
mod expression;
mod identity;
