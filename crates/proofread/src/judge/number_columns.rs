//! Columns of two numbers that are written as numbers of choices: `\binom{8+15}{14+25} = \binom{23}{39}`.

use crate::join::chain::ChainSide;
use crate::judge::verdict::evaluate_freely;
use crate::token::{NamedOperation, Token, TokenKind, trim_space};

/// Both sides as columns, if each is a number of choices of more than there are, which is zero and seldom meant.
pub(crate) fn as_columns(sides: [&ChainSide; 2]) -> Option<[ChainSide; 2]> {
    let column = |side: &ChainSide| {
        let [Token { kind: TokenKind::Call(NamedOperation::Binomial, rows), span, .. }] = trim_space(&side.tokens)
        else {
            return None;
        };
        let choices = evaluate_freely(&side.tokens, None).ok()?.number().ok()?.point;
        let matrix = Token::new(TokenKind::Call(NamedOperation::Matrix, rows.clone()), *span);
        (choices == 0.0).then(|| ChainSide { tokens: vec![matrix], ..side.clone() })
    };
    Some([column(sides[0])?, column(sides[1])?])
}
