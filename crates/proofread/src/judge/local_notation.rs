//! Signs that a country or a field writes in a way of its own: the comma before decimals, `t` for hours, `lg` for the logarithm to
//! base two, the degree sign before the kelvin.

use crate::evaluate::value::SideValue;
use crate::join::chain::{ChainSide, Relation};
use crate::judge::number_marks::touch;
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

/// A side with the points behind exponents and before a power of ten as signs of products, `2^2.3^2` and `3.10^2`; none if there are none.
pub(super) fn with_low_points(side: &[Token]) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = Vec::with_capacity(side.len() + 1);
    let mut found = false;
    for (at, token) in side.iter().enumerate() {
        let is_raised = matches!(side.get(at + 1), Some(Token { kind: TokenKind::Power(_), .. }));
        if let Some(factor) = token.number().filter(|_| is_raised).and_then(|digits| digits.strip_suffix(".10")) {
            let kinds = [factor, "10"].map(|digits| TokenKind::Number(digits.to_owned()));
            let [factor, ten] = kinds.map(|kind| Token::new(kind, token.span));
            out.extend([factor, Token::new(TokenKind::Operator('·'), token.span), ten]);
            found = true;
            continue;
        }
        let mut copy = token.clone();
        for list in copy.kind.lists() {
            if let Some(changed) = with_low_points(list) {
                (*list, found) = (changed, true);
            }
        }
        let is_raised = out.last().is_some_and(|last| matches!(last.kind, TokenKind::Power(_)));
        if let TokenKind::Number(digits) = &mut copy.kind
            && is_raised
            && let Some(behind) = digits.strip_prefix('.').map(str::to_owned)
        {
            *digits = behind;
            out.push(Token::new(TokenKind::Operator('·'), token.span));
            found = true;
        }
        out.push(copy);
    }
    found.then_some(out)
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

/// A side with the points between the thousands of its numbers left out, `10.000`, if the formula has a decimal comma; none if there are no such
/// numbers.
pub(super) fn with_points_of_thousands(formula: &str, side: &[Token]) -> Option<Vec<Token>> {
    let is_digit = |at: usize| formula.as_bytes().get(at).is_some_and(u8::is_ascii_digit);
    let has_comma = formula.match_indices(',').any(|(at, _)| at > 0 && is_digit(at - 1) && is_digit(at + 1));
    let groups = |digits: &str| {
        let mut groups = digits.split('.');
        let first = groups.next().unwrap_or_default();
        first.len() < 4 && first != "0" && digits.contains('.') && groups.all(|group| group.len() == 3)
    };
    let plain = |kind: &TokenKind| match kind {
        TokenKind::Number(digits) if groups(digits) => Some(TokenKind::Number(digits.replace('.', ""))),
        _ => None,
    };
    has_comma.then(|| changed(side, &plain)).flatten()
}

/// Least and most years that are taken for those of a season.
const YEARS: std::ops::Range<u32> = 1900..2100;

/// Whether a side is a number that names something, and the two years of its season in brackets: the wave 2 (2010/11).
fn is_dated_label(side: &[Token]) -> bool {
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

/// Whether a side is a number that names something, with years in brackets, or in running text with a range.
pub(crate) fn is_label(side: &[Token], is_plain: bool, values: Option<&(SideValue, SideValue)>) -> bool {
    is_dated_label(side) || (is_plain && is_label_with_range(side, values))
}

/// Whether a side is a number that names something, with a range of whole numbers in brackets apart from it, whose size is a positive
/// number: the group 3 (12-15) = 7.
fn is_label_with_range(side: &[Token], values: Option<&(SideValue, SideValue)>) -> bool {
    let [label, space, open, range @ .., close] = side else { return false };
    let [first, stroke, second] = range else { return false };
    let whole = |token: &Token| token.number().and_then(|digits| digits.parse::<u32>().ok());
    let is_range = stroke.is_sign('-') && touch(range) && whole(first).zip(whole(second)).is_some_and(|(a, b)| a < b);
    let is_size = values.and_then(|(_, right)| right.number().ok()).is_some_and(|of| of.point > 0.0);
    whole(label).is_some() && space.is_space() && open.is_sign('(') && close.is_sign(')') && is_range && is_size
}

/// Prefixes of units that stand for a power of ten by themselves, and this power.
const BARE_PREFIXES: [(&str, &str); 3] = [("k", "3"), ("M", "6"), ("G", "9")];

/// A side with the prefixes behind its numbers as powers of ten, as in rates: `8/(25 M)`; none if it has none.
pub(super) fn with_bare_prefixes(side: &[Token]) -> Option<Vec<Token>> {
    // Most sides have no letters, and need no copy.
    let has_letter = |token: &Token| matches!(token.kind, TokenKind::Word(_) | TokenKind::Name(_));
    if !side.iter().any(|token| has_letter(token) || token.inner().next().is_some()) {
        return None;
    }
    let mut out: Vec<Token> = Vec::with_capacity(side.len() + 3);
    let mut found = false;
    for token in side {
        let mut copy = token.clone();
        for list in copy.kind.lists() {
            if let Some(inner) = with_bare_prefixes(list) {
                (*list, found) = (inner, true);
            }
        }
        let behind_number = out.iter().rev().find(|of| !of.is_space()).is_some_and(|of| of.number().is_some());
        let prefix = match &copy.kind {
            TokenKind::Word(word) | TokenKind::Name(word) if behind_number => {
                BARE_PREFIXES.iter().find(|(prefix, _)| prefix == word)
            }
            _ => None,
        };
        let Some((_, power)) = prefix else {
            out.push(copy);
            continue;
        };
        let power = vec![Token::new(TokenKind::Number((*power).to_owned()), token.span)];
        let kinds = [TokenKind::Operator('·'), TokenKind::Number("10".to_owned()), TokenKind::Power(power)];
        out.extend(kinds.map(|kind| Token::new(kind, token.span)));
        found = true;
    }
    found.then_some(out)
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
