//! Units that are written in pieces, and powers of ten behind an `e`.

use crate::token::{Span, Token, TokenKind};
use crate::unit::{pair, takes_prefix, unit};

fn word(text: &str, span: Span) -> Token {
    Token::new(TokenKind::Word(text.to_owned()), span)
}

fn last(tokens: &[Token]) -> Option<&Token> {
    tokens.iter().rev().find(|token| !token.is_space())
}

fn is_unit(token: &Token) -> bool {
    token.word().is_some_and(|word| unit(word).is_some())
}

/// Whether what stands before makes a unit out of a letter: a number, a bracket, or another unit with a sign of a product.
pub(crate) fn takes_unit(before: &[Token]) -> bool {
    let Some(token) = last(before) else { return false };
    match token.kind {
        TokenKind::Number(_) | TokenKind::Power(_) | TokenKind::Fraction(..) => true,
        TokenKind::Operator(')') => true,
        TokenKind::Operator('·' | '/') => {
            let at = before.iter().rposition(|of| std::ptr::eq(of, token)).unwrap_or(0);
            last(&before[..at]).is_some_and(|of| is_unit(of) || matches!(of.kind, TokenKind::Power(_)))
        }
        _ => false,
    }
}

/// A unit whose name has a subscript: pounds of force or of mass, and what the sun has.
pub(crate) fn unit_with_subscript(base: &[Token], sub: &str) -> Option<&'static str> {
    let [Token { kind: TokenKind::Word(base) | TokenKind::Name(base), .. }] = base else { return None };
    Some(match (base.as_str(), sub) {
        ("lb", "f") => "lbf",
        ("lb", "m") => "lbm",
        ("kg" | "kgf", "f") => "kgf",
        ("M", "⊙" | "☉") => "M⊙",
        ("L", "⊙" | "☉") => "L⊙",
        ("R", "⊙" | "☉") => "R⊙",
        _ => return None,
    })
}

/// Parts of a unit that are written without anything between them before a negative exponent, as in `kgms⁻¹`.
const PARTS: [&str; 17] =
    ["mol", "kg", "kJ", "Pa", "dm", "cm", "mm", "km", "g", "m", "s", "J", "N", "W", "V", "C", "A"];

/// The units that run together in a word, the last of which has a negative exponent.
fn run_together(text: &str) -> Option<Vec<&'static str>> {
    let mut rest = text;
    let mut found = Vec::new();
    while !rest.is_empty() {
        let part = PARTS.iter().find(|part| rest.starts_with(**part))?;
        rest = &rest[part.len()..];
        found.push(*part);
    }
    (2..=3).contains(&found.len()).then_some(found)
}

/// Whether it is a negative exponent.
pub(crate) fn is_below(token: &Token) -> bool {
    matches!(&token.kind, TokenKind::Power(power) if power.first().is_some_and(|first| first.is_sign('-')))
}

/// Powers of ten in brackets behind a number, `6.7(10)⁻⁴` or `6.7(10⁻⁴)`, lose the brackets.
pub(crate) fn unwrap_powers_of_ten(tokens: Vec<Token>) -> Vec<Token> {
    let is_ten = |token: Option<&Token>| token.and_then(Token::number) == Some("10");
    if !tokens.windows(2).any(|pair| pair[0].is_sign('(') && is_ten(pair.get(1))) {
        return tokens;
    }
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let last = out.iter().rev().find(|token| !token.is_space());
        let signed = last.is_some_and(|last| last.is_one_of("×·"));
        let behind = out.iter().rev().filter(|token| !token.is_space()).nth(usize::from(signed));
        let number = behind.is_some_and(|before| before.number().is_some());
        let power = match tokens.get(at + 1..).unwrap_or_default() {
            [_, close, power, ..] if close.is_sign(')') => Some((power, 4)),
            [_, power, close, ..] if close.is_sign(')') => Some((power, 4)),
            _ => None,
        };
        if let Some((power, taken)) = power
            && token.is_sign('(')
            && number
            && is_ten(tokens.get(at + 1))
            && matches!(power.kind, TokenKind::Power(_))
        {
            if !signed {
                out.push(Token::new(TokenKind::Operator('×'), token.span));
            }
            out.extend([tokens[at + 1].clone(), power.clone()]);
            at += taken;
            continue;
        }
        out.push(token.clone());
        at += 1;
    }
    out
}

/// An upright `k` that closely follows a number as a thousand, with nothing behind it of which it could be the prefix: `48\text{k}`.
pub(crate) fn write_out_thousands(tokens: Vec<Token>) -> Vec<Token> {
    let is_thousand = |at: usize| {
        let before = at.checked_sub(1).and_then(|before| tokens.get(before));
        let next = tokens.get(at + 1);
        // A letter that touches the number in the source may be italic, or one of running text.
        let is_upright = before.is_some_and(|of| of.number().is_some() && of.span.end < tokens[at].span.start);
        let is_prefix = |of: &Token| {
            matches!(of.kind, TokenKind::Word(_) | TokenKind::Name(_) | TokenKind::Power(_) | TokenKind::Unknown(_))
        };
        tokens[at].word() == Some("k") && is_upright && !next.is_some_and(is_prefix)
    };
    if !(0..tokens.len()).any(is_thousand) {
        return tokens;
    }
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len() + 2);
    for (at, token) in tokens.iter().enumerate() {
        if !is_thousand(at) {
            out.push(token.clone());
            continue;
        }
        let three = Token::new(TokenKind::Number("3".to_owned()), token.span);
        let kinds = [TokenKind::Operator('×'), TokenKind::Number("10".to_owned()), TokenKind::Power(vec![three])];
        out.extend(kinds.map(|kind| Token::new(kind, token.span)));
    }
    out
}

/// Whether an angle in radians may end with a token, or a unit whose quotient with an angle it begins.
fn takes_radians(before: &Token) -> bool {
    match &before.kind {
        TokenKind::Number(_) | TokenKind::Power(_) | TokenKind::Fraction(..) | TokenKind::Root(..) => true,
        TokenKind::Operator(c) => ")/".contains(*c),
        TokenKind::Name(name) => name == "π",
        _ => false,
    }
}

/// Words that are several units become several words.
pub(crate) fn split_unit_words(tokens: Vec<Token>) -> Vec<Token> {
    let mut out = Vec::with_capacity(tokens.len());
    let mut rest = tokens.into_iter().peekable();
    while let Some(token) = rest.next() {
        let below = rest.peek().is_some_and(is_below);
        let text = token.word().unwrap_or_default();
        if matches!(text, "radian" | "radians") && last(&out).is_some_and(takes_radians) {
            out.push(word("rad", token.span));
            continue;
        }
        let parts = match pair(text) {
            Some((one, other)) if !matches!(text, "Wh" | "Ah") => vec![one, other],
            _ if below && (text == "ms" || unit(text).is_none()) => run_together(text).unwrap_or_default(),
            _ => Vec::new(),
        };
        if parts.is_empty() {
            out.push(token);
            continue;
        }
        for (at, part) in parts.into_iter().enumerate() {
            // Without a sign, `m` and `s` would become a millisecond again.
            if at > 0 && below {
                out.push(Token::new(TokenKind::Operator('·'), token.span));
            }
            out.push(word(part, token.span));
        }
    }
    out
}

/// Units in square brackets behind a number lose the brackets, and their letters become words.
pub(crate) fn unwrap_unit_brackets(tokens: Vec<Token>) -> Vec<Token> {
    if !tokens.iter().any(|token| token.is_sign('[')) {
        return tokens;
    }
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let behind = token.is_sign('[')
            && last(&out).is_some_and(|of| matches!(of.kind, TokenKind::Number(_) | TokenKind::Power(_)));
        let end = tokens[at..].iter().position(|token| token.is_sign(']')).filter(|_| behind).map(|end| at + end);
        if let Some(units) = end.and_then(|end| letters(&tokens[at + 1..end]).map(|units| (units, end))) {
            out.extend(units.0);
            at = units.1 + 1;
            continue;
        }
        out.push(token.clone());
        at += 1;
    }
    out
}

/// The tokens with their letters joined to words, if all words are units and there is nothing else than products of them.
fn letters(tokens: &[Token]) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = Vec::new();
    let mut joined = false;
    for token in tokens {
        match &token.kind {
            TokenKind::Name(letter) if joined => match out.last_mut() {
                Some(Token { kind: TokenKind::Word(before), span, .. }) => {
                    before.push_str(letter);
                    *span = span.join(token.span);
                }
                _ => return None,
            },
            TokenKind::Name(letter) => out.push(word(letter, token.span)),
            TokenKind::Fraction(above, below) => {
                out.push(Token::new(TokenKind::Fraction(letters(above)?, letters(below)?), token.span));
            }
            TokenKind::Word(_) | TokenKind::Power(_) | TokenKind::Operator('·' | '/') | TokenKind::Space(_) => {
                out.push(token.clone())
            }
            _ => return None,
        }
        joined = matches!(token.kind, TokenKind::Name(_));
    }
    let known = |token: &Token| token.word().is_none_or(|word| unit(word).is_some());
    (!out.is_empty() && out.iter().all(known)).then_some(out)
}

/// Whether the point at `at` is the sign of a product: between two units, close between a letter and a letter or bracket, or close behind a
/// function and before another one.
pub(crate) fn is_product(tokens: &[Token], at: usize) -> bool {
    if tokens[at].is_sign('.')
        && let Some(next) = tokens.get(at + 1)
        && matches!(next.kind, TokenKind::Function(_))
        && tokens[at].span.end == next.span.start
        && has_function_behind_sign(&tokens[..at])
    {
        return true;
    }
    if let [.., Token { kind: TokenKind::Name(_), .. }, point, next] = &tokens[..tokens.len().min(at + 2)]
        && point.is_sign('.')
        && (next.is_sign('(') || matches!(next.kind, TokenKind::Name(_)))
        && at > 0
    {
        return true;
    }
    if !tokens[at].is_sign('.') || at == 0 || !tokens.get(at + 1).is_some_and(is_unit) {
        return false;
    }
    match &tokens[at - 1].kind {
        TokenKind::Power(_) => at > 1 && is_unit(&tokens[at - 2]),
        _ => is_unit(&tokens[at - 1]),
    }
}

/// Whether the last factor of these tokens is a function of something.
fn has_function_behind_sign(tokens: &[Token]) -> bool {
    let factor = tokens.iter().rev().take_while(|token| !token.is_one_of("+-=≈.,;") && !token.is_space());
    factor.into_iter().any(|token| matches!(token.kind, TokenKind::Function(_)))
}

/// The power of ten that an `e` behind a number stands for, as in 1.5e−3, and how many tokens it takes.
pub(crate) fn power_of_ten(tokens: &[Token], before: &[Token]) -> (Vec<Token>, usize) {
    let nothing = (Vec::new(), 0);
    let (Some(e), Some(number)) = (tokens.first(), before.last().and_then(Token::number)) else { return nothing };
    let sign = usize::from(tokens.get(1).is_some_and(|token| token.is_one_of("+-")));
    let Some(digits) = tokens.get(1 + sign).and_then(Token::number) else { return nothing };
    let upright = e.word().is_some();
    // An italic e may be the base of the logarithms or a charge.
    let plain = digits.len() <= 3 && digits.chars().all(|c| c.is_ascii_digit());
    if !plain || !(upright || number.contains('.') || (sign == 0 && digits.len() == 2)) {
        return nothing;
    }
    let made =
        [TokenKind::Operator('×'), TokenKind::Number("10".to_owned()), TokenKind::Power(tokens[1..2 + sign].to_vec())];
    (made.into_iter().map(|kind| Token::new(kind, e.span)).collect(), 2 + sign)
}

/// A length of mercury or water as a pressure: cm Hg, inches of mercury.
pub(crate) fn pressure_column(tokens: &[Token], at: usize, length: &str) -> Option<(TokenKind, usize, Span)> {
    let words = tokens.iter().enumerate().skip(at + 1).filter(|(_, token)| !token.is_space() && !token.is_sign('.'));
    let mut words = words.filter(|(_, token)| token.word() != Some("of"));
    let (last, next) = words.next()?;
    let of = match next.word()? {
        "Hg" | "mercury" => "Hg",
        "water" => "water",
        _ => return None,
    };
    let length = if length.starts_with("in") { "in" } else { length };
    Some((TokenKind::Word(format!("{length}{of}")), last, next.span))
}

/// A prefix and its unit, which stand apart.
pub(crate) fn prefixed_unit(
    token: &Token,
    text: &str,
    next: Option<(&Token, usize)>,
    below: bool,
    out: &[Token],
) -> Option<(TokenKind, usize, Span)> {
    let (next, at) = next?;
    let is_word = token.word().is_some();
    let unit = match &next.kind {
        TokenKind::Word(unit) => unit,
        TokenKind::Name(unit) if (text == "μ" && !is_word) || unit == "Ω" => unit,
        _ => return None,
    };
    if !is_word && text != "μ" && unit != "Ω" {
        return None;
    }
    let before = out.iter().rev().find(|token| !token.is_space());
    let follows = before.is_some_and(|before| match before.kind {
        TokenKind::Number(_) | TokenKind::Power(_) | TokenKind::Fraction(..) => true,
        TokenKind::Operator(c) => ")/]".contains(c),
        _ => false,
    });
    let follows = follows || out.last().is_none_or(Token::is_space);
    let takes = takes_prefix(unit) && (unit != "g" || text == "μ" || text == "k") && (follows || unit == "g");
    // Metres and seconds below them, which only touch each other in this text: m s⁻¹.
    let product = text == "m" && below;
    (takes && !product).then(|| (TokenKind::Word(format!("{text}{unit}")), at, next.span))
}
