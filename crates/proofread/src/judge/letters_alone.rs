//! Letters that may be units or quantities: which are units by themselves, and what speaks against it.

use crate::join::chain::ChainSide;
use crate::token::{Token, TokenKind, any, has_number};

/// Letters that are units by themselves often enough.
pub(super) const ALONE: &str = "mgsJNVWKALCFHT";

/// Whether a letter stands in these tokens with no number before it: `T/100`, `T ≈ 3`.
pub(super) fn stands_alone(tokens: &[Token], letter: &str) -> bool {
    let mut solid = tokens.iter().filter(|token| !token.is_space());
    let mut before: Option<&Token> = None;
    solid.any(|token| {
        let counted =
            before.replace(token).is_some_and(|of| !matches!(of.kind, TokenKind::Operator(_)) || of.is_sign(')'));
        let is_letter = matches!(&token.kind, TokenKind::Name(name) if name == letter);
        // With an exponent, it is still behind its number, and with an index it is another one.
        let is_other = matches!(&token.kind, TokenKind::Scripts(_, index, _) if counted || !index.is_empty());
        (is_letter && !counted) || (!is_other && token.inner().any(|inner| stands_alone(inner, letter)))
    })
}

/// Whether a term without a unit is beside one with a unit: then the letter is none.
pub(super) fn has_mixed_terms(side: &ChainSide) -> bool {
    let has_unit = |kind: &TokenKind| matches!(kind, TokenKind::Word(_));
    let terms = side.tokens.split(|token| token.is_one_of("+-")).filter(|term| has_number(term));
    let with: Vec<bool> = terms.map(|term| any(term, &has_unit)).collect();
    with.contains(&true) && with.contains(&false)
}
