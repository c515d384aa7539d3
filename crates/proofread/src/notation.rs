//! Ways of writing that only some texts have, each tried where two sides differ: what the sides would be if they were written in one of
//! them, and what shows that they may be.

use crate::chain::Side;
use crate::reader::{Formula, Written};
use crate::token::{Kind, Span, Token};
use crate::unit::unit;
use crate::value::{Angle, Value};
use std::f64::consts::PI;

/// Both sides in another way of writing.
pub(crate) type Sides = [Vec<Token>; 2];

/// What two sides would be in each of the ways of writing that they may be in.
pub(crate) fn others(text: &str, formula: &Formula, left: &Side, right: &Side) -> Vec<Sides> {
    let sides = || [left.tokens.clone(), right.tokens.clone()];
    let mut out = Vec::new();
    if formula.written == Written::Plain && starts_line(text, left.span) {
        out.extend(without_item(&left.tokens).map(|rest| [rest, right.tokens.clone()]));
    }
    let mixed = sides().map(|side| mixed(&side));
    if mixed.iter().any(Option::is_some) {
        let [one, other] = mixed;
        out.push([one.unwrap_or_else(|| left.tokens.clone()), other.unwrap_or_else(|| right.tokens.clone())]);
    }
    if is_binary(&left.tokens) && is_binary(&right.tokens) {
        out.push(sides().map(|side| in_decimal(&side)));
    }
    if formula.written == Written::Plain {
        let roots = sides().map(|side| under_root(&side));
        if roots.iter().any(Option::is_some) {
            let [one, other] = roots;
            out.push([one.unwrap_or_else(|| left.tokens.clone()), other.unwrap_or_else(|| right.tokens.clone())]);
        }
    }
    out.extend(per_hundred(&right.tokens).map(|number| [left.tokens.clone(), number]));
    out
}

/// Whether only space and marks of a list are before a place on its line.
fn starts_line(text: &str, span: Span) -> bool {
    let before = text.get(..span.start as usize).unwrap_or_default();
    let line = before.rsplit('\n').next().unwrap_or_default();
    line.trim_matches([' ', '\t', '-', '*', '+', '>', '#']).is_empty()
}

/// A side without the number of its item, `4.5 (1.05)^2`: behind it are space and a bracket or another number.
fn without_item(side: &[Token]) -> Option<Vec<Token>> {
    let [item, space, rest @ ..] = side else { return None };
    let goes_on = rest.first().is_some_and(|first| first.is_one_of("([") || !matches!(first.kind, Kind::Operator(_) | Kind::Word(_)));
    (item.number().is_some() && space.is_space() && goes_on).then(|| rest.to_vec())
}

fn integer(token: &Token) -> Option<u32> {
    token.number().and_then(|digits| digits.parse().ok())
}

/// Whether tokens stand one behind the other without anything between them in the text.
fn touch(tokens: &[Token]) -> bool {
    tokens.windows(2).all(|pair| pair[0].span.end == pair[1].span.start)
}

/// A side with its mixed numbers, `1-3/4`, as sums; none if there is none.
fn mixed(side: &[Token]) -> Option<Vec<Token>> {
    let mut out = Vec::with_capacity(side.len());
    let (mut at, mut found) = (0, false);
    while let Some(token) = side.get(at) {
        let of = side.get(at..at + 5).unwrap_or_default();
        if let [whole, hyphen, above, stroke, below] = of
            && hyphen.is('-')
            && stroke.is('/')
            && touch(of)
            && integer(whole).is_some()
            && let (Some(above), Some(below)) = (integer(above), integer(below))
            && above < below
            && below <= 64
        {
            let sign = |c| Token::new(Kind::Operator(c), token.span);
            out.extend([sign('('), whole.clone(), sign('+')]);
            out.extend_from_slice(&of[2..]);
            out.push(sign(')'));
            (at, found) = (at + 5, true);
            continue;
        }
        out.push(token.clone());
        at += 1;
    }
    found.then_some(out)
}

/// Whether a side has integers with the digits 0 and 1 only, one of them a long one.
fn is_binary(side: &[Token]) -> bool {
    let digits: Vec<&str> = side.iter().filter_map(Token::number).collect();
    let plain = side.iter().all(|token| matches!(token.kind, Kind::Number(_) | Kind::Space(_) | Kind::Operator(_)));
    plain && digits.iter().all(|of| of.chars().all(|c| c == '0' || c == '1')) && digits.iter().any(|of| of.len() > 1)
}

fn in_decimal(side: &[Token]) -> Vec<Token> {
    let decimal = |token: &Token| {
        let value = token.number().and_then(|digits| u64::from_str_radix(digits, 2).ok());
        value.map_or_else(|| token.clone(), |value| Token::new(Kind::Number(value.to_string()), token.span))
    };
    side.iter().map(decimal).collect()
}

/// The number of a side such as `6.7 L/100 km`, whose unit has a number in it.
fn per_hundred(side: &[Token]) -> Option<Vec<Token>> {
    let solid: Vec<&Token> = side.iter().filter(|token| !token.is_space()).collect();
    let [number, above, stroke, hundred, below] = solid.as_slice() else { return None };
    let is_unit = |token: &Token| token.word().is_some_and(|word| unit(word).is_some());
    let fits = number.number().is_some() && is_unit(above) && stroke.is('/') && is_unit(below);
    let power = hundred.number().is_some_and(|digits| digits.len() > 2 && digits.trim_end_matches('0') == "1");
    (fits && power).then(|| vec![(*number).clone()])
}

/// A side with all factors behind a root sign under it, whose bar is lost in running text; none if there is no such sign.
fn under_root(side: &[Token]) -> Option<Vec<Token>> {
    let at = side.iter().position(|token| token.is('√'))?;
    if side.get(at + 1)?.is('(') {
        return None;
    }
    let ends = |token: &Token| token.is_one_of("+-");
    let end = side[at..].iter().position(ends).map_or(side.len(), |end| at + end);
    let sign = |c| Token::new(Kind::Operator(c), side[at].span);
    Some([&side[..=at], &[sign('(')], &side[at + 1..end], &[sign(')')], &side[end..]].concat())
}

/// Whether exponents may have lost their place in running text: (6.38 × 106)2 for (6.38 × 10⁶)².
pub(crate) fn has_lost_exponents(side: &[Token]) -> bool {
    let solid: Vec<&Token> = side.iter().filter(|token| !token.is_space()).collect();
    solid.windows(2).any(|pair| {
        let touches = pair[0].span.end == pair[1].span.start;
        let digits = pair[1].number().unwrap_or_default();
        let power = pair[0].is_one_of("×·") && digits.len() > 2 && digits.len() < 5 && digits.starts_with("10") && digits.chars().all(|c| c.is_ascii_digit()) && digits.trim_end_matches('0') != "1";
        power || (touches && pair[0].is(')') && matches!(digits, "2" | "3" | "4"))
    })
}

/// Whether both sides are angles that differ by whole turns.
pub(crate) fn differ_by_turns(left: &Value, right: &Value) -> bool {
    let degrees = |of: &Value| of.angle == Some(Angle::Degrees);
    let moved = |by: f64| Value { parts: left.parts.map(|part| part.moved(by)), ..left.clone() };
    degrees(left) && degrees(right) && [-2.0 * PI, 2.0 * PI].into_iter().any(|by| moved(by).meets(right, 1e-3))
}

/// Whether the right side counts whole pieces, of which there have to be at least as many as the left side says.
pub(crate) fn counts_up(left: &Value, right: &Value) -> bool {
    let bare = !left.has_unit && !right.has_unit && right.is_literal();
    let whole = |of: f64| of.fract() == 0.0 && of > 0.0;
    match (left.number(), right.number()) {
        (Ok(left), Ok(right)) => bare && whole(right.point) && libm::ceil(left.point) == right.point,
        _ => false,
    }
}

/// The number with which a side begins, with its power of ten and unit, if anything is done with it.
pub(crate) fn leading(side: &[Token]) -> Option<&[Token]> {
    let first = side.iter().position(|token| !token.is_space() && !token.is('-'))?;
    side[first].number()?;
    let is_unit = |token: Option<&Token>| token.and_then(Token::word).is_some_and(|word| unit(word).is_some());
    for (at, token) in side.iter().enumerate().skip(first + 1) {
        let next = side[at + 1..].iter().find(|token| !token.is_space());
        let goes_on = match &token.kind {
            Kind::Operator('×' | '·') => next.and_then(Token::number) == Some("10") || is_unit(next),
            Kind::Operator('/') => is_unit(next),
            Kind::Number(digits) => digits == "10",
            Kind::Word(_) | Kind::Power(_) | Kind::Space(_) => true,
            _ => false,
        };
        if !goes_on {
            return Some(&side[..at]);
        }
    }
    None
}

/// Whether the right side is the left one with a number for a letter that was taken for a unit: `5/D = 5/4`.
pub(crate) fn substitutes(left: &[Token], right: &[Token]) -> bool {
    let solid = |side: &[Token]| -> Vec<Kind> {
        side.iter().filter(|token| !token.is_space()).map(|token| token.kind.clone()).collect()
    };
    let (left, right) = (solid(left), solid(right));
    let mut letters = 0;
    let fits = left.iter().zip(&right).all(|(one, other)| match (one, other) {
        (Kind::Word(word), Kind::Number(_)) if word.chars().count() == 1 => {
            letters += 1;
            true
        }
        _ => one == other,
    });
    fits && letters > 0 && left.len() == right.len()
}

/// Whether a side is written like a mark rather than like a sum: `28+92.45` for a place on a line, `181-57-45` for an angle.
pub(crate) fn is_mark(side: &[Token]) -> bool {
    let two = |token: &Token| {
        token.number().is_some_and(|digits| digits.split('.').next().is_some_and(|whole| whole.len() == 2))
    };
    match side {
        [place, plus, feet] => plus.is('+') && integer(place).is_some() && two(feet) && touch(side),
        [degrees, one, minutes, other, seconds] => {
            let numbers = integer(degrees).is_some() && two(minutes) && two(seconds);
            one.is('-') && other.is('-') && numbers && touch(side)
        }
        _ => false,
    }
}

/// Whether a side has an integer with the digits 0 and 1 that is as long as those of other bases.
pub(crate) fn has_bits(side: &[Token]) -> bool {
    let bits = |digits: &str| digits.len() > 4 && digits.contains('0') && digits.chars().all(|c| c == '0' || c == '1');
    let round = |digits: &str| digits.trim_end_matches('0').len() < 2;
    side.iter().filter_map(Token::number).any(|digits| bits(digits) && !round(digits))
}
