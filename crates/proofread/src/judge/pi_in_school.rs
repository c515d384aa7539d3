//! What schools take π for: 22/7 and few decimals, where they give all printed digits.

use crate::judge::sides::Sides;
use crate::token::{Token, TokenKind, any};

/// Both sides with each of these quotients for π; none if π is not in them, or in the argument of a function.
pub(super) fn with_school_pi(left: &[Token], right: &[Token]) -> Vec<Sides> {
    let has_function = |side: &[Token]| any(side, &|kind| matches!(kind, TokenKind::Function(_)));
    if has_function(left) || has_function(right) {
        return Vec::new();
    }
    let written = |pi| {
        let [one, other] = [left, right].map(|side| with_pi_as(pi, side));
        let is_changed = one.is_some() || other.is_some();
        is_changed.then(|| [one.unwrap_or_else(|| left.to_vec()), other.unwrap_or_else(|| right.to_vec())])
    };
    PI_IN_SCHOOL.into_iter().filter_map(written).collect()
}

/// What schools take π for, above and below a stroke.
const PI_IN_SCHOOL: [[&str; 2]; 3] = [["22", "7"], ["3.14", "1"], ["3.142", "1"]];

/// A side with this quotient for π; none if π is not in it.
fn with_pi_as(pi: [&str; 2], side: &[Token]) -> Option<Vec<Token>> {
    let mut out = side.to_vec();
    let mut found = false;
    for token in &mut out {
        if token.kind == TokenKind::Name("π".to_owned()) {
            let exact = |digits: &str| format!("{digits}{}0000000000", if digits.contains('.') { "" } else { "." });
            let [above, below] = pi.map(|digits| vec![Token::new(TokenKind::Number(exact(digits)), token.span)]);
            token.kind = TokenKind::Group(vec![Token::new(TokenKind::Fraction(above, below), token.span)]);
            found = true;
            continue;
        }
        for list in token.kind.lists() {
            if let Some(changed) = with_pi_as(pi, list) {
                (*list, found) = (changed, true);
            }
        }
    }
    found.then_some(out)
}
