//! Ways of writing that only some texts have, each tried where two sides differ: what the sides would be if they were written in one of
//! them, and what shows that they may be.

use crate::decimal::{fixed, parse_decimal};
use crate::evaluate::value::{AngleUnit, SideValue};
use crate::join::chain::{ChainSide, ROW_END, Relation};
use crate::judge::binary_numbers;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::equals_conventions::turns_into_degrees;
use crate::judge::flattened;
use crate::judge::function_arguments::{under_function, with_braced_arguments, with_whole_radicand};
use crate::judge::local_notation;
use crate::judge::number_marks::{integer, touch};
use crate::judge::permutation::as_permutations;
use crate::judge::point_coordinates::as_cartesian;
use crate::judge::sides::Sides;
use crate::judge::substitution::without_space;
use crate::judge::term_notation::{sum_in_degrees, with_braced_sign, without_large_number};
use crate::judge::verdict::judge;
use crate::reader::{Formula, FormulaStyle};
use crate::token::{MathFunction, NamedOperation, Token, TokenKind, any};
use crate::unit::unit;
use std::f64::consts::PI;

/// What two sides would be in each of the ways of writing that they may be in.
pub(crate) fn other_notations(text: &str, formula: &Formula, left: &ChainSide, right: &ChainSide) -> Vec<Sides> {
    let mut out = Vec::new();
    let plain = formula.style == FormulaStyle::Plain;
    for rest in without_label(&left.tokens, plain) {
        out.push([rest, right.tokens.clone()]);
    }
    // A row that begins with a sign may be an equation of its own.
    let breaks = |side: &ChainSide| side.tokens.iter().position(|token| token.kind == TokenKind::Space(ROW_END));
    let behind = breaks(left).map(|at| left.tokens[at + 1..].to_vec());
    let before = breaks(right).map(|at| right.tokens[..at].to_vec());
    out.extend(behind.iter().map(|behind| [behind.clone(), right.tokens.clone()]));
    out.extend(before.iter().map(|before| [left.tokens.clone(), before.clone()]));
    out.extend(behind.zip(before).map(|(behind, before)| [behind, before]));
    let mut each = |change: &dyn Fn(&[Token]) -> Option<Vec<Token>>| {
        let [one, other] = [left, right].map(|side| change(&side.tokens));
        if one.is_none() && other.is_none() {
            return;
        }
        let (one, other) = (one.unwrap_or_else(|| left.tokens.clone()), other.unwrap_or_else(|| right.tokens.clone()));
        out.push([one, other]);
    };
    each(&mixed);
    each(&without_second);
    each(&without_uncertainty);
    each(&with_period);
    each(&|side| with_braced_decimals(text, side));
    each(&in_one_unit);
    each(&binary_numbers::to_base_two);
    each(&binary_numbers::with_base_of_logarithms);
    each(&without_note);
    each(&without_large_number);
    each(&as_remainder);
    each(&as_columns);
    each(&under_function);
    each(&|side| with_braced_arguments(text, side));
    each(&local_notation::with_low_points);
    each(&with_whole_radicand);
    each(&in_degrees_by_factor);
    each(&without_factor_of_degrees);
    each(&from_left_to_right);
    each(&|side| with_raised_points(text, side));
    each(&with_fractional_parts);
    each(&without_dots);
    each(&|side| with_braced_sign(text, side));
    each(&sum_in_degrees);
    each(&local_notation::with_binary_logarithm);
    each(&local_notation::in_hours);
    each(&local_notation::with_bare_kelvins);
    each(&local_notation::with_bare_prefixes);
    let source = text.get(formula.span.range()).unwrap_or_default();
    each(&|side| local_notation::with_points_of_thousands(source, side));
    if formula.style == FormulaStyle::Plain {
        each(&flattened::under_root_sign);
        each(&flattened::with_whole_exponents);
        each(&flattened::with_base_of_logarithm);
    }
    out.extend(binary_numbers::in_decimal(&left.tokens, &right.tokens));
    out.extend(all_in_degrees(&left.tokens, &right.tokens));
    out.extend(other_way_round(&right.tokens).map(|other| [left.tokens.clone(), other]));
    out.extend(as_congruence(&left.tokens, &right.tokens));
    out.extend(as_permutations(&left.tokens, &right.tokens));
    out.extend(as_cartesian(&left.tokens, &right.tokens));
    out.extend(with_temperature(&left.tokens, &right.tokens));
    out.extend(local_notation::with_points_of_products(&left.tokens, &right.tokens));
    out.extend(binary_numbers::with_binary_prefixes(&left.tokens, &right.tokens));
    out.extend(per_hundred(&right.tokens).map(|number| [left.tokens.clone(), number]));
    out
}

/// What a side may be without the label before it: `5.1 (3 + 4)`, `[2] 3 · 4`, `Day 3 — 12 · 4`, `1° 3 + 4`. In a formula only brackets and a
/// raised sign show a label.
fn without_label(side: &[Token], plain: bool) -> Vec<Vec<Token>> {
    let starts = |at: usize| {
        let next = side[at..].iter().find(|token| !token.is_space());
        next.is_some_and(|next| match &next.kind {
            TokenKind::Operator(c) => "([√-".contains(*c),
            TokenKind::Number(_) | TokenKind::Function(_) | TokenKind::Fraction(..) | TokenKind::Root(..) => true,
            _ => false,
        })
    };
    let (length, marked) = match side {
        [open, number, close, ..] if open.is_one_of("([") && close.is_one_of(")]") && number.number().is_some() => {
            (3, true)
        }
        [number, degree, ..] if number.number().is_some() && degree.word() == Some("°") => (2, true),
        [number, ..] if number.number().is_some() => (1, false),
        _ => return Vec::new(),
    };
    let mut ends = Vec::new();
    match side.get(length..).unwrap_or_default() {
        [space, ..] if space.is_space() && (plain || marked) => ends.push(length + 1),
        [sign, space, ..] if plain && sign.is_one_of("-/.") && space.is_space() => ends.push(length + 2),
        _ => {}
    }
    // A dash with space on both sides.
    let dashes = side.windows(3).position(|of| of[0].is_space() && of[1].is_sign('-') && of[2].is_space());
    ends.extend(dashes.filter(|_| plain).map(|at| at + 3));
    let computes = |token: &Token| {
        token.is_one_of("+-×·/([√")
            || matches!(token.kind, TokenKind::Fraction(..) | TokenKind::Root(..) | TokenKind::Function(_))
    };
    ends.retain(|end| *end < side.len() && starts(*end) && side[*end..].iter().any(computes));
    ends.into_iter().map(|end| side[end..].to_vec()).collect()
}

/// A side whose quotients end before the power of ten that follows: `100/20 × 10^6` as five million.
fn from_left_to_right(side: &[Token]) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = Vec::with_capacity(side.len() + 2);
    let mut found = false;
    for token in side.iter().filter(|token| !token.is_space()) {
        let mut copy = token.clone();
        let lists = if matches!(copy.kind, TokenKind::Fraction(..)) { copy.kind.lists() } else { Vec::new() };
        for list in lists {
            if let Some(changed) = from_left_to_right(list) {
                (*list, found) = (changed, true);
            }
        }
        out.push(copy);
        let [.., above, slash, below, times, ten, power] = out.as_slice() else { continue };
        let is_pi = above.kind == TokenKind::Name("π".to_owned());
        let numbers = (above.number().is_some() || is_pi) && below.number().is_some() && ten.number() == Some("10");
        if numbers && slash.is_sign('/') && times.is_one_of("×·") && matches!(power.kind, TokenKind::Power(_)) {
            let (at, span) = (out.len() - 6, above.span);
            out.insert(at + 3, Token::new(TokenKind::Operator(')'), span));
            out.insert(at, Token::new(TokenKind::Operator('('), span));
            found = true;
        }
    }
    found.then_some(out)
}

/// A side without what stands in brackets behind its result, in another unit, as a decimal or with more digits: `36.9° (0.644 rad)`, `1/2 (0.5)`,
/// `298 (298.15) K`.
fn without_second(side: &[Token]) -> Option<Vec<Token>> {
    let close = side.iter().rposition(|token| token.is_one_of(")]}"))?;
    let mut open = side[..close].iter().rposition(|token| token.is_one_of("([{"))?;
    let is_reference = close == open + 2 && integer(&side[open + 1]).is_some();
    let mut apart = side[open].is_sign('[') && is_reference;
    // It is a printed value, and nothing computed.
    let inner = &side[open + 1..close];
    let numbers = inner.iter().filter_map(Token::number).filter(|digits| *digits != "10").count();
    let printed = numbers < 2
        && !inner.iter().any(|token| {
            matches!(token.kind, TokenKind::Fraction(..) | TokenKind::Root(..) | TokenKind::Function(_))
                || token.is_one_of("+([√")
        });
    // The number of an equation behind a dash: 12 – (1).
    let last = side[..open].iter().rposition(|token| !token.is_space())?;
    if side[last].is_sign('-') && is_reference && last > 0 && side[last - 1].is_space() {
        (open, apart) = (last, true);
    }
    let before = side[..open].iter().rev().find(|token| !token.is_space())?;
    apart |= side[open - 1].is_space() || before.word().is_some() || matches!(before.kind, TokenKind::Power(_));
    // It says once more what stands before it: 1/2 (0.5).
    apart |= printed && judge(&side[..open], inner, Relation::Equal, None).verdict == ChainVerdict::Consistent;
    let is_unit = |token: &Token| {
        token.is_space() || matches!(token.kind, TokenKind::Word(_) | TokenKind::Power(_)) || token.is_one_of("/·")
    };
    (apart && printed && !before.is_one_of("+-×·/([{") && side[close + 1..].iter().all(is_unit))
        .then(|| [&side[..open], &side[close + 1..]].concat())
}

/// Units that are parts of others, in which quantities are given together, and how many of them make one.
const PARTS: [(&str, &str, f64); 8] = [
    ("h", "min", 60.0),
    ("min", "s", 60.0),
    ("hr", "min", 60.0),
    ("ft", "in", 12.0),
    ("lb", "oz", 16.0),
    ("kg", "g", 1000.0),
    ("m", "cm", 100.0),
    ("km", "m", 1000.0),
];

/// A side with quantities in two units, `1 h 30 min`, in the larger one, also above and below strokes; none if there is no such quantity.
fn in_one_unit(side: &[Token]) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = Vec::with_capacity(side.len());
    let mut found = false;
    for token in side {
        let mut copy = token.clone();
        for list in copy.kind.lists() {
            if let Some(changed) = in_one_unit(list) {
                (*list, found) = (changed, true);
            }
        }
        out.push(copy);
        let solid: Vec<usize> = (0..out.len()).rev().filter(|at| !out[*at].is_space()).take(4).collect();
        let [d, c, b, a] = solid.as_slice() else { continue };
        let number = |at: usize| out[at].number().and_then(parse_decimal);
        let words = out[*b].word().zip(out[*d].word());
        let part =
            words.and_then(|(one, other)| PARTS.iter().find(|(large, small, _)| *large == one && *small == other));
        if let (Some(whole), Some(rest), Some((.., parts))) = (number(*a), number(*c), part)
            && a + 4 <= out.len()
        {
            let (span, unit) = (out[*a].span.join(out[*c].span), out[*b].clone());
            out.truncate(*a);
            out.push(Token::new(TokenKind::Number(fixed(whole + rest / parts, 8)), span));
            out.push(unit);
            found = true;
        }
    }
    found.then_some(out)
}

/// A side without the mark of a note, `12^(3)`, on its last number.
fn without_note(side: &[Token]) -> Option<Vec<Token>> {
    let (last, rest) = side.split_last()?;
    let TokenKind::Power(mark) = &last.kind else { return None };
    let [open, number, close] = mark.as_slice() else { return None };
    (open.is_one_of("([") && close.is_one_of(")]") && integer(number).is_some()).then(|| rest.to_vec())
}

/// A side in which what looks like a binomial coefficient is a column of two numbers.
fn as_columns(side: &[Token]) -> Option<Vec<Token>> {
    let mut found = false;
    let changed = side.iter().map(|token| match &token.kind {
        TokenKind::Call(NamedOperation::Binomial, rows) => {
            found = true;
            Token::new(TokenKind::Call(NamedOperation::Matrix, rows.clone()), token.span)
        }
        _ => token.clone(),
    });
    let changed = changed.collect();
    found.then_some(changed)
}

/// Both sides as remainders, if the modulus stands behind the right one alone: `17 = 2 mod 5`.
fn as_congruence(left: &[Token], right: &[Token]) -> Option<Sides> {
    let is_mod = |token: &Token| token.word() == Some("mod");
    let at = right.iter().position(is_mod).filter(|_| !left.iter().any(is_mod))?;
    let sign = |c| Token::new(TokenKind::Operator(c), right[at].span);
    let both = [&[sign('(')], left, &[sign(')')], &right[at..]].concat();
    Some([both, right.to_vec()])
}

/// A side in which a sign of per cent between two numbers gives the remainder, as in programs: `20 % -4`.
fn as_remainder(side: &[Token]) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = side.iter().filter(|token| !token.is_space()).cloned().collect();
    let at = (1..out.len()).find(|at| {
        let behind = out.get(at + 1).filter(|next| !next.is_sign('-')).or(out.get(at + 2));
        out[*at].word() == Some("%") && out[at - 1].number().is_some() && behind.is_some_and(|of| of.number().is_some())
    })?;
    out[at] = Token::new(TokenKind::Word("mod".to_owned()), out[at].span);
    Some(out)
}

/// A side whose two values behind ± are given in the other order, as they are after a division by a negative number.
fn other_way_round(side: &[Token]) -> Option<Vec<Token>> {
    let mut out = side.to_vec();
    for token in &mut out {
        if token.is_sign('±') {
            token.kind = TokenKind::Operator('∓');
            return Some(out);
        }
        for list in token.kind.lists() {
            if let Some(changed) = other_way_round(list) {
                *list = changed;
                return Some(out);
            }
        }
    }
    None
}

/// Both sides with the sign of degrees on each number, if it is on one of the terms of a sum alone: `90 - 21.5° = 68.5`.
fn all_in_degrees(left: &[Token], right: &[Token]) -> Option<Sides> {
    let is_degree = |token: &Token| token.word() == Some("°");
    let is_term =
        |token: &Token| token.number().is_some() || is_degree(token) || token.is_space() || token.is_one_of("+-()");
    let adds = left.iter().skip(1).any(|token| token.is_one_of("+-"));
    if !adds || !left.iter().any(is_degree) || !left.iter().chain(right).all(is_term) {
        return None;
    }
    let [one, other] = [left, right].map(|side| {
        let mut out: Vec<Token> = Vec::with_capacity(2 * side.len());
        for (at, token) in side.iter().enumerate() {
            out.push(token.clone());
            let next = side[at + 1..].iter().find(|next| !next.is_space());
            if token.number().is_some() && !next.is_some_and(is_degree) {
                out.push(Token::new(TokenKind::Word("°".to_owned()), token.span));
            }
        }
        out
    });
    Some([one, other])
}

/// A side that a factor 180/π changes to degrees without their sign, with it; none if there is no such factor.
fn in_degrees_by_factor(side: &[Token]) -> Option<Vec<Token>> {
    let at = side.first()?.span;
    let sign = |c| Token::new(TokenKind::Operator(c), at);
    let degree = Token::new(TokenKind::Word("°".to_owned()), at);
    turns_into_degrees(side).then(|| [&[sign('(')], side, &[sign(')'), degree]].concat())
}

/// A side in which a factor 180/π before an inverse function makes degrees of its radians, without the factor, since the function gives an
/// angle; none if there is no such factor.
fn without_factor_of_degrees(side: &[Token]) -> Option<Vec<Token>> {
    if !turns_into_degrees(side) {
        return None;
    }
    let is_inverse = |at: usize| {
        let mut behind = side[at + 1..].iter().filter(|token| !token.is_space() && !token.is_one_of("·×"));
        let inverse = |power: &Token| matches!(&power.kind, TokenKind::Power(of) if of.first().is_some_and(|sign| sign.is_sign('-')));
        match behind.next().map(|token| &token.kind) {
            Some(TokenKind::Function(MathFunction::Arcsin | MathFunction::Arccos | MathFunction::Arctan)) => true,
            Some(TokenKind::Function(_)) => behind.next().is_some_and(inverse),
            _ => false,
        }
    };
    let at = (0..side.len()).find(|at| matches!(side[*at].kind, TokenKind::Fraction(..)) && is_inverse(*at))?;
    let one = Token::new(TokenKind::Number("1".to_owned()), side[at].span);
    let times = Token::new(TokenKind::Operator('·'), side[at].span);
    let rest = side[at + 1..].iter().skip_while(|token| token.is_space() || token.is_one_of("·×")).cloned();
    Some(side[..at].iter().cloned().chain([one, times]).chain(rest).collect())
}

/// Where one or two digits in brackets stand directly behind decimals.
fn bracketed_digits(side: &[Token]) -> Vec<usize> {
    let fits = |at: &usize| match &side[*at..*at + 4] {
        [decimals, open, digits, close] => {
            let short = integer(digits).is_some() && digits.number().is_some_and(|of| of.len() < 4);
            open.is_sign('(')
                && close.is_sign(')')
                && short
                && touch(&side[*at..*at + 4])
                && decimals.number().is_some_and(|of| of.contains('.'))
        }
        _ => false,
    };
    (0..side.len().saturating_sub(3)).filter(fits).collect()
}

/// A side without the uncertainties of its last digits, `12.5(3)`.
fn without_uncertainty(side: &[Token]) -> Option<Vec<Token>> {
    let found = bracketed_digits(side);
    let dropped = |at: usize| found.iter().any(|of| (of + 1..of + 4).contains(&at));
    (!found.is_empty())
        .then(|| side.iter().enumerate().filter(|(at, _)| !dropped(*at)).map(|(_, token)| token.clone()).collect())
}

/// A side with repeating decimals, `0.1(6)`, written out.
fn with_period(side: &[Token]) -> Option<Vec<Token>> {
    let found = bracketed_digits(side);
    let mut out = without_uncertainty(side)?;
    for (gone, at) in found.into_iter().enumerate() {
        let period = side[at + 2].number()?.repeat(8);
        if let TokenKind::Number(digits) = &mut out[at - 3 * gone].kind {
            digits.push_str(&period);
        }
    }
    Some(out)
}

/// A side with its raised points, `3·5`, as decimal points; none if no two integers have a point close between them.
fn with_raised_points(text: &str, side: &[Token]) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = Vec::with_capacity(side.len());
    let (mut at, mut found) = (0, false);
    while let Some(token) = side.get(at) {
        if let [whole, point, decimals] = side.get(at..at + 3).unwrap_or_default()
            && point.is_sign('·')
            && let (Some(one), Some(other)) = (whole.number(), decimals.number())
            && [one, other].iter().all(|of| of.chars().all(|c| c.is_ascii_digit()))
            && text.get(whole.span.end as usize..decimals.span.start as usize).is_some_and(|of| !of.contains(' '))
        {
            out.push(Token::new(TokenKind::Number(format!("{one}.{other}")), whole.span.join(decimals.span)));
            (at, found) = (at + 3, true);
            continue;
        }
        let inner: Vec<Option<Vec<Token>>> = token.inner().map(|inner| with_raised_points(text, inner)).collect();
        let mut copy = token.clone();
        for (list, changed) in copy.kind.lists().into_iter().zip(inner) {
            if let Some(changed) = changed {
                (*list, found) = (changed, true);
            }
        }
        out.push(copy);
        at += 1;
    }
    found.then_some(out)
}

/// A side with what is behind a comma in braces, `0{,}438`, as decimals, also before three digits; none if there is no such number.
fn with_braced_decimals(text: &str, side: &[Token]) -> Option<Vec<Token>> {
    let mut found = false;
    let changed = side.iter().map(|token| {
        let mut copy = token.clone();
        let braced = text.get(token.span.range()).is_some_and(|source| source.contains("{,}"));
        if let TokenKind::Number(digits) = &mut copy.kind
            && braced
            && digits.matches(',').count() == 1
            && !digits.contains('.')
        {
            *digits = digits.replace(',', ".");
            found = true;
        }
        for list in copy.kind.lists() {
            if let Some(changed) = with_braced_decimals(text, list) {
                (*list, found) = (changed, true);
            }
        }
        copy
    });
    let changed = changed.collect();
    found.then_some(changed)
}

/// A side with decimals that were rounded before dots were put behind them, `5/7 = 0.7143…`; none if there are no dots.
fn without_dots(side: &[Token]) -> Option<Vec<Token>> {
    let cut = |token: &Token| match token.number().and_then(|digits| digits.strip_suffix('…')) {
        Some(digits) => Token::new(TokenKind::Number(digits.to_owned()), token.span),
        None => token.clone(),
    };
    side.iter()
        .any(|token| token.number().is_some_and(|digits| digits.ends_with('…')))
        .then(|| side.iter().map(cut).collect())
}

/// A side with numbers in braces that are computed from fractions, roots or functions as their fractional parts, `{9π}`; none if there are none.
fn with_fractional_parts(side: &[Token]) -> Option<Vec<Token>> {
    let open = side.iter().position(|token| token.is_sign('{'))?;
    let length = side[open..].iter().position(|token| token.is_sign('}'))?;
    let (inner, rest) = (&side[open + 1..open + length], &side[open + length + 1..]);
    let sign = |c| Token::new(TokenKind::Operator(c), side[open].span);
    let part =
        [&[sign('('), sign('(')], inner, &[sign(')'), sign('-'), sign('⌊')], inner, &[sign('⌋'), sign(')')]].concat();
    let rest = with_fractional_parts(rest).unwrap_or_else(|| rest.to_vec());
    let is_irrational = |kind: &TokenKind| match kind {
        TokenKind::Name(name) => name == "π",
        kind => matches!(kind, TokenKind::Function(_) | TokenKind::Root(..) | TokenKind::Fraction(..)),
    };
    (any(inner, &is_irrational) && !inner.iter().any(|token| token.is_one_of("{[,;")))
        .then(|| [&side[..open], &part, &rest].concat())
}

/// Both sides with the sign of degrees Celsius for a bare one of degrees, if the other side is in kelvins: `900 K = 627°`.
fn with_temperature(left: &[Token], right: &[Token]) -> Option<Sides> {
    let has = |side: &[Token], sign: &str| side.iter().any(|token| token.word() == Some(sign));
    let celsius = |side: &[Token]| {
        let change = |token: &Token| match token.word() {
            Some("°") => Token::new(TokenKind::Word("°C".to_owned()), token.span),
            _ => token.clone(),
        };
        side.iter().map(change).collect()
    };
    let beside = (has(left, "K") && has(right, "°")) || (has(left, "°") && has(right, "K"));
    beside.then(|| [celsius(left), celsius(right)])
}

/// Whether a bare number is divided by an angle, as a phasor may be written: 12/−30°.
pub(crate) fn has_phasor(side: &[Token]) -> bool {
    let is_phasor = |of: &[&Token]| {
        let [bare, stroke, angle @ ..] = of else { return false };
        let angle = match angle {
            [minus, rest @ ..] if minus.is_sign('-') => rest,
            all => all,
        };
        bare.number().is_some()
            && stroke.is_sign('/')
            && matches!(angle, [number, sign, ..] if number.number().is_some() && sign.word() == Some("°"))
    };
    let plain = without_space(side);
    let here = (0..plain.len()).any(|at| is_phasor(&plain[at..]));
    here || side.iter().any(|token| token.inner().any(has_phasor))
}

/// Whether a side is one number in brackets, which may mean something else than the number: [4,6] = 12, {3.7} = 0.7.
pub(crate) fn is_bracketed_number(side: &[Token]) -> bool {
    matches!(without_space(side).as_slice(), [open, number, close] | [open, Token { kind: TokenKind::Operator('-'), .. }, number, close] if (!open.is_sign('(') || without_space(side).len() == 3) && open.is_one_of("([{") && close.is_one_of(")]}") && number.number().is_some())
}

/// Whether a side adds or multiplies numbers in brackets of their own, which may be those of lines or equations: (4) + (5).
pub(crate) fn are_references(side: &[Token]) -> bool {
    let solid = without_space(side);
    // (2) · 7 = 7, where (2) is a result.
    if let [open, number, close, sign, rest @ ..] = solid.as_slice()
        && !rest.iter().any(|token| token.is_sign('('))
        && open.is_sign('(')
        && integer(number).is_some()
        && close.is_sign(')')
        && sign.is_one_of("+-×·/")
    {
        return true;
    }
    let terms = solid.split(|token| token.is_one_of("+-"));
    let is_reference = |term: &[&Token]| matches!(term, [open, number, close] if open.is_sign('(') && close.is_sign(')') && integer(number).is_some());
    solid.len() > 4 && terms.into_iter().all(is_reference)
}

/// Whether a side has the sign of two units: `au` of the atomic mass and the astronomical unit, `D` of the debye and the dioptre.
pub(crate) fn has_two_meanings(side: &[Token]) -> bool {
    any(side, &|kind| matches!(kind, TokenKind::Word(word) if ["au", "AU", "D"].contains(&word.as_str())))
}

/// A side with its mixed numbers, `1-3/4`, as sums; none if there is none.
fn mixed(side: &[Token]) -> Option<Vec<Token>> {
    let mut out = Vec::with_capacity(side.len());
    let (mut at, mut found) = (0, false);
    while let Some(token) = side.get(at) {
        let of = side.get(at..at + 5).unwrap_or_default();
        if let [whole, hyphen, above, stroke, below] = of
            && hyphen.is_sign('-')
            && stroke.is_sign('/')
            && touch(of)
            && integer(whole).is_some()
            && let (Some(above), Some(below)) = (integer(above), integer(below))
            && above < below
            && below <= 64
        {
            let sign = |c| Token::new(TokenKind::Operator(c), token.span);
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

/// A side such as `6.7 L/100 km` or `98 mL/min/1.73 m²`, whose unit has a number in it, without that part of the unit.
fn per_hundred(side: &[Token]) -> Option<Vec<Token>> {
    let stroke = side.iter().rposition(|token| token.is_sign('/'))?;
    let is_unit = |token: &Token| match &token.kind {
        TokenKind::Word(word) => unit(word).is_some(),
        kind => matches!(kind, TokenKind::Power(_) | TokenKind::Space(_)) || token.is_one_of("/·"),
    };
    let mut below = side[stroke + 1..].iter().filter(|token| !token.is_space());
    let number = below.next()?.number().is_some();
    let units = below.clone().count() > 0 && below.all(is_unit);
    let [first, above @ ..] = &side[..stroke] else { return None };
    let quantity =
        first.number().is_some() && above.iter().all(is_unit) && above.iter().any(|token| token.word().is_some());
    (number && units && quantity).then(|| side[..stroke].to_vec())
}

/// Whether both sides are angles that differ by whole turns.
pub(crate) fn differ_by_turns(left: &SideValue, right: &SideValue) -> bool {
    let degrees = |of: &SideValue| of.angle == Some(AngleUnit::Degrees);
    let moved = |turns: i32| {
        let by = 2.0 * PI * f64::from(turns);
        SideValue { parts: left.parts.map(|part| part.shifted(by)), ..left.clone() }
    };
    degrees(left) && degrees(right) && (-3..=3).any(|turns| turns != 0 && moved(turns).meets(right, 1e-3))
}

/// Whether the right side counts whole pieces, of which there have to be at least as many as the left side says.
pub(crate) fn counts_up(left: &SideValue, right: &SideValue) -> bool {
    let bare = !left.has_unit && !right.has_unit && right.is_literal();
    let whole = |of: f64| of.fract() == 0.0 && of > 0.0;
    match (left.number(), right.number()) {
        (Ok(left), Ok(right)) => bare && whole(right.point) && libm::ceil(left.point) == right.point,
        _ => false,
    }
}
