//! Sums of money among the sides of a chain.

use crate::join::chain::ChainSide;
use crate::token::{Token, TokenKind, any};
use crate::unit::currency;
use std::cell::Cell;

/// Whether a sum of money is anywhere in tokens.
pub(crate) fn has_money(tokens: &[Token]) -> bool {
    any(tokens, &|kind| matches!(kind, TokenKind::Word(word) if word == "cents" || currency(word).is_some()))
}

/// Whether the sign of a currency comes first, as in `$5`.
pub(crate) fn starts_with_money(side: &ChainSide) -> bool {
    side.tokens.first().and_then(Token::word).is_some_and(|word| currency(word).is_some())
}

/// Whether two sides have several currencies, whose rate of exchange is not known.
pub(crate) fn has_several_currencies(sides: [&ChainSide; 2]) -> bool {
    let found = Cell::new(None);
    let is_another = |kind: &TokenKind| {
        let TokenKind::Word(word) = kind else { return false };
        let Some(sign) = currency(word) else { return false };
        found.replace(Some(sign)).is_some_and(|before| before != sign)
    };
    sides.into_iter().any(|side| any(&side.tokens, &is_another))
}
