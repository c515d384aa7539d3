//! Signs that a country or a field writes in a way of its own: the comma before decimals, `t` for hours, `lg` for the logarithm to
//! base two, the degree sign before the kelvin.

use crate::evaluate::value::SideValue;
use crate::join::chain::{ChainSide, Relation};
use crate::judge::sides::Sides;
use crate::judge::substitution::without_space;
use crate::judge::surroundings::text_around;
use crate::judge::verdict::is_agreed;
use crate::token::{MathFunction, Span, Token, TokenKind, any};

/// A side with each of its tokens changed that a rule has something for; none if it changes nothing. Lists inside tokens are changed,
/// too.
fn changed(side: &[Token], change: &dyn Fn(&TokenKind) -> Option<TokenKind>) -> Option<Vec<Token>> {
    let mut out = side.to_vec();
    let mut found = false;
    for token in &mut out {
        if let Some(kind) = change(&token.kind) {
            (token.kind, found) = (kind, true);
            continue;
        }
        for list in token.kind.lists() {
            if let Some(inner) = changed(list, change) {
                (*list, found) = (inner, true);
            }
        }
    }
    found.then_some(out)
}

/// A side with each number that has one comma before three digits, and no point, as one with decimals: `7,874` as 7.874.
fn with_decimal_commas(side: &[Token]) -> Option<Vec<Token>> {
    changed(side, &|kind| match kind {
        TokenKind::Number(digits) if digits.matches(',').count() == 1 && !digits.contains('.') => {
            let (_, decimals) = digits.split_once(',')?;
            (decimals.len() == 3).then(|| TokenKind::Number(digits.replace(',', ".")))
        }
        _ => None,
    })
}

/// Whether the sides agree once the commas before three digits in them part decimals. Where nothing else of the text says so, this
/// alone cannot tell a comma of decimals from a factor of a thousand that is wrong.
pub(crate) fn agree_with_decimal_commas(left: &ChainSide, right: &ChainSide, relation: Relation) -> bool {
    let [one, other] = [left, right].map(|side| with_decimal_commas(&side.tokens));
    if one.is_none() && other.is_none() {
        return false;
    }
    let (one, other) = (one.as_ref().unwrap_or(&left.tokens), other.as_ref().unwrap_or(&right.tokens));
    is_agreed(one, other, relation)
}

/// A side with `lg` as the logarithm to base two, as in texts on algorithms; none if it has none.
pub(super) fn with_binary_logarithm(side: &[Token]) -> Option<Vec<Token>> {
    changed(side, &|kind| {
        (*kind == TokenKind::Function(MathFunction::Lg)).then_some(TokenKind::Function(MathFunction::LogTo(2)))
    })
}

/// A side with `t` as the sign of hours, as in Scandinavian texts; none if it has none.
pub(super) fn in_hours(side: &[Token]) -> Option<Vec<Token>> {
    changed(side, &|kind| (*kind == TokenKind::Word("t".to_owned())).then(|| TokenKind::Word("h".to_owned())))
}

/// A side without the degree signs before the sign of the kelvin; none if it has none.
pub(super) fn with_bare_kelvins(side: &[Token]) -> Option<Vec<Token>> {
    let is_kelvin = |token: &&Token| token.word() == Some("K");
    let next_is_kelvin = |at: usize| side[at + 1..].iter().find(|token| !token.is_space()).filter(is_kelvin).is_some();
    let is_sign = |at: usize| side[at].word() == Some("°") && next_is_kelvin(at);
    let out: Vec<Token> = (0..side.len()).filter(|at| !is_sign(*at)).map(|at| side[at].clone()).collect();
    (out.len() < side.len()).then_some(out)
}

/// Both sides with the low points between digits of the left one as signs of products, as schools write 2.3 for two times three; none if it
/// has none, or if the right side has decimals. Longer numbers have decimals, and so have those whose last digit is a nought or a one.
pub(super) fn with_points_of_products(left: &[Token], right: &[Token]) -> Option<Sides> {
    if any(right, &|kind| matches!(kind, TokenKind::Number(digits) if digits.contains('.'))) {
        return None;
    }
    let mut out = Vec::with_capacity(left.len() + 2);
    for token in left {
        let digits = token.number().filter(|digits| digits.len() == 3 && !digits.starts_with('0'));
        match digits.and_then(|digits| digits.split_once('.')).filter(|(one, other)| one.len() == 1 && *other > "1") {
            Some((one, other)) => {
                let number = |digits: &str| Token::new(TokenKind::Number(digits.to_owned()), token.span);
                out.extend([number(one), Token::new(TokenKind::Operator('·'), token.span), number(other)]);
            }
            None => out.push(token.clone()),
        }
    }
    (out.len() > left.len()).then(|| [out, right.to_vec()])
}

/// Least and most years that are taken for those of a season.
const YEARS: std::ops::Range<u32> = 1900..2100;

/// Whether a side is a number that names something, and the two years of its season in brackets: the wave 2 (2010/11).
pub(crate) fn is_dated_label(side: &[Token]) -> bool {
    let solid = without_space(side);
    let [number, open, first, stroke, second, close] = solid.as_slice() else { return false };
    let whole = |token: &Token| token.number().and_then(|digits| digits.parse::<u32>().ok());
    let follows = |year: u32, next: u32| next == year + 1 || next == (year + 1) % 100;
    open.is_sign('(')
        && close.is_sign(')')
        && stroke.is_one_of("/-")
        && whole(number).is_some()
        && whole(first).zip(whole(second)).is_some_and(|(year, next)| YEARS.contains(&year) && follows(year, next))
}

/// Whether a result is a hundred times a share, and so in per cent whose sign is lost, in a text that speaks of per cent: the left side
/// computes a share of at most one, the right one is a printed number.
pub(crate) fn lacks_percent_sign(text: &str, around: Span, values: Option<&(SideValue, SideValue)>) -> bool {
    let Some((left, right)) = values else { return false };
    let bare = |of: &SideValue| !of.has_unit && of.angle.is_none();
    let is_share = left.number().is_ok_and(|of| of.point > 0.0 && of.point <= 1.0);
    let is_printed = right.is_literal() && !left.is_literal();
    let is_hundredfold = || left.scaled(100.0).meets(right, 0.0);
    is_share && is_printed && bare(left) && bare(right) && is_hundredfold() && speaks_of_percent(text, around)
}

/// Whether the text close around a formula speaks of per cent.
fn speaks_of_percent(text: &str, span: Span) -> bool {
    let (before, after) = text_around(text, span);
    [before, after].into_iter().any(|near| {
        let near = near.to_lowercase();
        ["%", "percent", "per cent", "prozent", "procent", "pour cent", "por ciento"]
            .iter()
            .any(|word| near.contains(word))
    })
}
