//! Two neighbouring sides, as tokens.

use crate::token::Token;

/// Both sides in another way of writing, the left one first.
pub(crate) type Sides = [Vec<Token>; 2];
