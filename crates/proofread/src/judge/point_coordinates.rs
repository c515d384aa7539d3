//! Coordinates of points that are equal although their numbers are not: in polar form, and homogeneous ones.

use crate::evaluate::expression::Evaluator;
use crate::evaluate::operation::listed;
use crate::evaluate::printed::Mode;
use crate::evaluate::reading::ReadingChoices;
use crate::judge::sides::Sides;
use crate::token::{MathFunction, Token, TokenKind, any, has_number, trim_space};

/// How far two products of coordinates may be apart, relative to them.
const NOISE: f64 = 1e-9;

/// The pieces of a list in brackets that is all of a side.
fn pieces(side: &[Token], brackets: [char; 2]) -> Option<Vec<&[Token]>> {
    match trim_space(side) {
        [open, inner @ .., close] if open.is_sign(brackets[0]) && close.is_sign(brackets[1]) => Some(listed(inner)),
        _ => None,
    }
}

/// Whether an angle is printed with π or its degree sign.
fn is_angle(tokens: &[Token]) -> bool {
    any(tokens, &|kind| match kind {
        TokenKind::Name(name) => name == "π",
        TokenKind::Word(word) => word == "°",
        _ => false,
    })
}

/// Two pairs of a radius and an angle with the Cartesian coordinates of their points; none if the sides are no such pairs.
pub(super) fn as_cartesian(left: &[Token], right: &[Token]) -> Option<Sides> {
    let [one, other] = [left, right].map(|side| {
        let pieces = pieces(side, ['(', ')'])?;
        let [radius, angle] = pieces.as_slice() else { return None };
        (has_number(radius) && !is_angle(radius)).then_some([*radius, *angle])
    });
    let (one, other) = (one?, other?);
    if !is_angle(one[1]) && !is_angle(other[1]) {
        return None;
    }
    Some([one, other].map(cartesian))
}

/// The tokens of `(r cos φ, r sin φ)`.
fn cartesian([radius, angle]: [&[Token]; 2]) -> Vec<Token> {
    let span = radius.first().map_or_else(Default::default, |first| first.span);
    let sign = |c| Token::new(TokenKind::Operator(c), span);
    let part = |function| {
        let function = Token::new(TokenKind::Function(function), span);
        [&[sign('(')], radius, &[sign(')'), sign('·'), function, sign('(')], angle, &[sign(')')]].concat()
    };
    [vec![sign('(')], part(MathFunction::Cos), vec![sign(',')], part(MathFunction::Sin), vec![sign(')')]].concat()
}

/// Whether two lists in square brackets are multiples of each other, as homogeneous coordinates of one point are.
pub(super) fn are_proportional(left: &[Token], right: &[Token]) -> bool {
    let values = |side: &[Token]| -> Option<Vec<f64>> {
        let pieces = pieces(side, ['[', ']'])?;
        let value = |piece: &[Token]| {
            let value = Evaluator::new(Mode::Point, ReadingChoices::USUAL, None).evaluate_all(piece).ok()?;
            value.number().ok().map(|number| number.point)
        };
        pieces.into_iter().map(value).collect()
    };
    let (Some(one), Some(other)) = (values(left), values(right)) else { return false };
    let has_size = |of: &[f64]| of.len() > 1 && of.iter().any(|of| *of != 0.0);
    let alike = |a: f64, b: f64| (a - b).abs() <= NOISE * a.abs().max(b.abs());
    has_size(&one)
        && has_size(&other)
        && one.len() == other.len()
        && (0..one.len()).all(|at| (0..at).all(|before| alike(one[at] * other[before], one[before] * other[at])))
}
