//! Brackets behind or around a number that make a symbol of it: the distribution π(3), the residue symbol (3/7).

use crate::evaluate::value::SideValue;
use crate::join::chain::ChainSide;
use crate::judge::substitution::without_space;
use crate::token::{Token, TokenKind, any};

/// How many times larger than the other side a product of π is, if it is no misprint of it.
const FAR: f64 = 2.0;

/// Whether a side is one pair of square brackets, and a comma in it was taken for a point: `[8,1 + 1/7]`.
pub(crate) fn has_comma_as_point(text: &str, side: &ChainSide) -> bool {
    let source = text.get(side.span.range()).unwrap_or_default().trim_start();
    let source = source.strip_prefix("\\left").unwrap_or(source);
    let is_tuple = any(&side.tokens, &|kind| matches!(kind, TokenKind::Operator(',' | ';')));
    source.starts_with('[') && source.trim_end().ends_with(']') && source.contains(',') && !is_tuple
}

/// Whether a side is a number behind which a bracket closes that none in it opens: `P(X > 0.4) = 0.95` with the bracket torn apart.
pub(crate) fn closes_unopened(side: &[Token]) -> bool {
    matches!(without_space(side).as_slice(), [number, close] if number.number().is_some() && close.is_sign(')'))
}

fn is_integer(token: &Token) -> bool {
    token.number().is_some_and(|digits| digits.chars().all(|c| c.is_ascii_digit()))
}

/// Whether π stands before one number in brackets, as the name of a function does: π(3), π[3] and π(10²³), but not π(3)².
fn names_pi(side: &[Token]) -> bool {
    let solid = without_space(side);
    let is_power = |token: &&&Token| matches!(token.kind, TokenKind::Power(_));
    let is_call = |at: usize| match solid.get(at..) {
        Some([name, open, number, rest @ ..]) => {
            let rest = &rest[usize::from(rest.first().as_ref().is_some_and(is_power))..];
            let is_closed = rest.first().is_some_and(|close| close.is_one_of(")]"));
            name.kind == pi()
                && open.is_one_of("([")
                && number.number().is_some()
                && is_closed
                && !rest.get(1).as_ref().is_some_and(is_power)
        }
        _ => false,
    };
    (0..solid.len()).any(is_call)
}

fn pi() -> TokenKind {
    TokenKind::Name("π".to_owned())
}

/// Whether π is a share or a permutation in a side: taken from one, as in 1 − π, or the exponent of −1.
fn shares_pi(side: &[Token]) -> bool {
    let solid = without_space(side);
    let from_one = |of: &[&Token]| of[0].number() == Some("1") && of[1].is_sign('-') && of[2].kind == pi();
    let raised =
        |token: &Token| matches!(&token.kind, TokenKind::Power(power) if power.iter().any(|of| of.kind == pi()));
    let is_sign =
        |of: &[&Token]| of[0].is_sign('-') && of[1].number() == Some("1") && of[2].is_sign(')') && raised(of[3]);
    solid.windows(3).any(from_one)
        || solid.windows(4).any(is_sign)
        || side.iter().any(|token| token.inner().into_iter().any(shares_pi))
}

/// Whether a difference of two values of π is above a stroke, as in the sign of a permutation: (π(2) − π(1))/(2 − 1).
fn calls_pi_twice(side: &[Token]) -> bool {
    side.iter().any(|token| match &token.kind {
        TokenKind::Fraction(above, _) => {
            let mut terms = above.split(|token| token.is_sign('-'));
            let called = terms.by_ref().take(2).filter(|term| names_pi(term)).count();
            called == 2 && terms.next().is_none()
        }
        _ => false,
    })
}

/// Whether π may be the name of a function, a share, a permutation or a distribution: a side shows that it is no factor, unless it gives
/// decimals near the other side; both sides call it; or it is called alone and what it gives is an integer or far from the product.
pub(crate) fn may_name_pi(left: &[Token], right: &[Token], values: Option<&(SideValue, SideValue)>) -> bool {
    let called = [names_pi(left), names_pi(right)];
    let bare = |side: &[Token]| (4..=5).contains(&without_space(side).len());
    let decimal = |side: &[Token]| any(side, &|kind| matches!(kind, TokenKind::Number(of) if of.contains('.')));
    let far =
        values.and_then(|(left, right)| left.number().ok().zip(right.number().ok())).is_some_and(|(one, other)| {
            let factor = (one.point / other.point).abs();
            !(1.0 / FAR..FAR).contains(&factor)
        });
    if calls_pi_twice(left) || calls_pi_twice(right) {
        return true;
    }
    if (shares_pi(left) && (far || !decimal(right))) || (shares_pi(right) && (far || !decimal(left))) {
        return true;
    }
    match called {
        [true, true] => true,
        [true, false] => bare(left) && (far || !decimal(right)),
        [false, true] => bare(right) && (far || !decimal(left)),
        [false, false] => false,
    }
}

/// How many fractions of integers in brackets a side is the product of; none if it is anything else.
fn bracketed_fractions(side: &[Token]) -> Option<usize> {
    let solid: Vec<&Token> = without_space(side).into_iter().filter(|token| !token.is_one_of("·×")).collect();
    let is_symbol = |of: &[&Token]| match of {
        [open, Token { kind: TokenKind::Fraction(above, below), .. }, close] => {
            let integer = |of: &[Token]| match of {
                [minus, number] => minus.is_sign('-') && is_integer(number),
                [number] => is_integer(number),
                _ => false,
            };
            open.is_sign('(') && close.is_sign(')') && integer(above) && integer(below)
        }
        _ => false,
    };
    let solid = match solid.as_slice() {
        [minus, rest @ ..] if minus.is_sign('-') => rest,
        all => all,
    };
    let pieces = solid.chunks(3);
    (!solid.is_empty() && pieces.clone().all(is_symbol)).then(|| pieces.count())
}

/// Whether a side is nothing but integers or sizes such as 2 × 3 in brackets, one behind the other.
pub(crate) fn is_all_bracketed(side: &[Token]) -> bool {
    let solid = without_space(side);
    let pieces: Vec<&[&Token]> = solid.split(|token| token.is_sign(')')).collect();
    let is_piece = |piece: &[&Token]| match piece {
        [rest @ .., open, number]
            if open.is_sign('(') && (is_integer(number) || matches!(number.kind, TokenKind::Name(_))) =>
        {
            rest.iter().all(|of| of.is_one_of("·×∘"))
        }
        [rest @ .., open, rows, times, columns] if open.is_sign('(') && times.is_sign('×') => {
            is_integer(rows) && is_integer(columns) && rest.iter().all(|of| of.is_one_of("·×"))
        }
        _ => false,
    };
    matches!(pieces.as_slice(), [all @ .., end] if end.is_empty() && !all.is_empty() && all.iter().all(|of| is_piece(of)))
}

/// Whether brackets are cycles of permutations or the sizes of matrices: both sides are nothing else.
pub(crate) fn may_be_cycles(left: &[Token], right: &[Token]) -> bool {
    let without_square =
        |side: &[Token]| -> Vec<Token> { side.iter().filter(|token| !token.is_one_of("[]")).cloned().collect() };
    is_all_bracketed(&without_square(left)) && is_all_bracketed(&without_square(right))
}

/// Whether square brackets side by side may be the places of a number, as `[6][3]` of 63: a side is nothing but two or more of them.
pub(crate) fn may_be_places(side: &[Token]) -> bool {
    let mut depth = 0usize;
    let (mut groups, mut outside) = (0, false);
    for token in side.iter().filter(|token| !token.is_space()) {
        match &token.kind {
            TokenKind::Operator('[') => {
                groups += usize::from(depth == 0);
                depth += 1;
            }
            TokenKind::Operator(']') => depth = depth.saturating_sub(1),
            TokenKind::Number(_) | TokenKind::Operator('·' | '×' | '+' | '-') => outside |= depth == 0,
            _ => outside = true,
        }
    }
    groups > 1 && !outside
}

/// Whether pairs in square brackets may be the classes that they stand for: `[(6, 3)] = [(4, 1)]`.
pub(crate) fn may_be_classes(left: &[Token], right: &[Token]) -> bool {
    let is_class = |side: &[Token]| {
        let solid = without_space(side);
        matches!(solid.as_slice(), [open, pair, .., end, close]
            if open.is_sign('[') && pair.is_sign('(') && end.is_sign(')') && close.is_sign(']'))
            && solid.iter().any(|token| token.is_sign(','))
    };
    is_class(left) && is_class(right)
}

/// Whether decimals stand alone in square brackets in a side, or in one whose end is round, as for the integers next to them: `[-1.4] + [0.8)`.
pub(crate) fn has_bracketed_decimals(side: &[Token]) -> bool {
    let solid = without_space(side);
    let is_decimal = |token: &Token| token.number().is_some_and(|digits| digits.contains('.'));
    (0..solid.len()).any(|at| match &solid[at..] {
        [open, number, close, ..] if open.is_sign('[') && is_decimal(number) => close.is_one_of("])"),
        [open, sign, number, close, ..] if open.is_sign('[') && sign.is_sign('-') && is_decimal(number) => {
            close.is_one_of("])")
        }
        _ => false,
    })
}

/// Whether a side is written as a product of two pairs in brackets, and the commas in them were taken for points: `(0,3)·(1/2,5)`.
pub(crate) fn has_pairs_as_decimals(text: &str, side: &ChainSide) -> bool {
    let source = text.get(side.span.range()).unwrap_or_default();
    // Thousands are parted by commas, too.
    let is_thousands = |part: &str| part.len() == 3 && part.bytes().all(|c| c.is_ascii_digit());
    let is_pair = |inside: &str| {
        let parts: Vec<&str> = inside.split(',').map(str::trim).take(3).collect();
        let is_part = |part: &&str| !part.is_empty() && part.len() <= LONGEST_PART;
        parts.len() == 2 && parts.iter().all(is_part) && !is_thousands(parts[1]) && !inside.contains(['.', '='])
    };
    let inside = source.split('(').skip(1).filter_map(|behind| behind.split_once(')')).map(|(inside, _)| inside);
    let is_list = any(&side.tokens, &|kind| matches!(kind, TokenKind::Operator(',' | ';')));
    !is_list && inside.take(MOST_PAIRS).filter(|inside| is_pair(inside)).count() > 1
}

/// The longest coordinate of a pair, in bytes, and the most pairs that are looked at.
const LONGEST_PART: usize = 12;
const MOST_PAIRS: usize = 20;

/// Whether fractions in brackets are symbols of quadratic residues: they equal 1, −1 or 0, or other fractions in brackets.
pub(crate) fn may_be_residue_symbols(left: &[Token], right: &[Token]) -> bool {
    let is_residue = |side: &[Token]| {
        let factors = without_space(side);
        let small = |token: &&Token| token.number().is_none_or(|digits| matches!(digits, "0" | "1"));
        factors.iter().all(|token| token.number().is_some() || token.is_one_of("()-·×")) && factors.iter().all(small)
    };
    let is_sign = |side: &[Token]| is_residue(side) || bracketed_fractions(side).is_some();
    (bracketed_fractions(left).is_some() && is_sign(right)) || (bracketed_fractions(right).is_some() && is_sign(left))
}

/// Whether bars around an integer on the left may be those of the order of an element of a group, which is an integer: `|3| = 4`.
pub(crate) fn may_be_order(left: &[Token], right: &[Token]) -> bool {
    let is_order = match without_space(left).as_slice() {
        [open, element, close] => open.is_sign('|') && is_integer(element) && close.is_sign('|'),
        [open, minus, element, close] => {
            open.is_sign('|') && minus.is_sign('-') && is_integer(element) && close.is_sign('|')
        }
        _ => false,
    };
    is_order && !any(right, &|kind| matches!(kind, TokenKind::Number(digits) if digits.contains('.')))
}

/// Whether a side is a letter with an index or an argument that looks like a unit, a unit vector or a constant with a factor or an
/// exponent: T(4) for an estimate with four steps, ŷ(−1) for a fitted value, π⁰ for a value under a hypothesis.
pub(crate) fn may_be_indexed_letter(side: &[Token]) -> bool {
    let is_letter = |token: &Token| match &token.kind {
        TokenKind::Word(word) => word.chars().count() == 1,
        TokenKind::Basis(_) => true,
        _ => false,
    };
    match without_space(side).as_slice() {
        [letter, Token { kind: TokenKind::Power(power), .. }] => {
            (is_letter(letter) || matches!(letter.kind, TokenKind::Name(_)))
                && matches!(power.as_slice(), [zero] if zero.number() == Some("0"))
        }
        [letter, open, argument @ .., close] => {
            let signed = argument.split_last().is_some_and(|(number, sign)| {
                number.number().is_some() && matches!(sign, [] | [_]) && sign.iter().all(|sign| sign.is_one_of("+-"))
            });
            is_letter(letter) && open.is_sign('(') && close.is_sign(')') && signed
        }
        _ => false,
    }
}

/// Whether a side is one number with its unit in brackets: (2.00 A).
pub(crate) fn is_bracketed_quantity(side: &[Token]) -> bool {
    matches!(without_space(side).as_slice(), [open, number, unit, close]
        if open.is_sign('(') && number.number().is_some() && unit.word().is_some() && close.is_sign(')'))
}
