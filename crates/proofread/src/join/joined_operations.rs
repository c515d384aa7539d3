//! Operations and numbers that readers leave in pieces: sums with printed limits, numbers of choices, repeating decimals, dots behind
//! decimals.

use crate::token::{NamedOperation, Token, TokenKind, trim_space};

/// Decimals to which a period is written out.
const DECIMALS: usize = 15;

/// The tokens with these operations as one token each, or none if there are none.
pub(crate) fn join_operations(tokens: &[Token]) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = Vec::new();
    let (mut at, mut found) = (0, false);
    while at < tokens.len() {
        let rest = &tokens[at..];
        let joined = over_index(rest)
            .or_else(|| scripted_choices(rest))
            .or_else(|| typed_choices(rest, &tokens[..at]))
            .or_else(|| called_choices(rest))
            .or_else(|| period(rest))
            .or_else(|| dots(rest))
            .or_else(|| dots_with_sign(rest));
        match joined {
            Some((kind, taken)) => {
                if !found {
                    out.extend_from_slice(&tokens[..at]);
                    found = true;
                }
                let span = rest[..taken].iter().fold(rest[0].span, |span, token| span.join(token.span));
                out.push(Token::new(kind, span));
                at += taken;
            }
            None => {
                if found {
                    out.push(rest[0].clone());
                }
                at += 1;
            }
        }
    }
    found.then_some(out)
}

fn is_integer(token: &Token) -> bool {
    token.number().is_some_and(|digits| digits.chars().all(|c| c.is_ascii_digit()))
}

fn choices_of(letter: &Token) -> Option<NamedOperation> {
    match &letter.kind {
        TokenKind::Name(name) | TokenKind::Word(name) if name == "C" => Some(NamedOperation::Binomial),
        TokenKind::Name(name) | TokenKind::Word(name) if name == "P" => Some(NamedOperation::Permutations),
        _ => None,
    }
}

/// A sum or product with an index and its limits below and above the sign.
fn over_index(rest: &[Token]) -> Option<(TokenKind, usize)> {
    let TokenKind::Scripts(base, sub, sup) = &rest.first()?.kind else { return None };
    let [sign] = trim_space(base) else { return None };
    let operation = match sign.kind {
        TokenKind::Operator('∑') => NamedOperation::Sum,
        TokenKind::Operator('∏') => NamedOperation::Product,
        _ => return None,
    };
    let equals = sub.iter().position(|token| token.is_sign('='))?;
    let (index, first) = (trim_space(&sub[..equals]), trim_space(&sub[equals + 1..]));
    let named = matches!(index, [Token { kind: TokenKind::Name(_), .. }]);
    (named && !first.is_empty() && !sup.is_empty())
        .then(|| (TokenKind::Call(operation, vec![index.to_vec(), first.to_vec(), sup.clone()]), 1))
}

/// The number of choices with its numbers beside a letter: ₅C₂.
fn scripted_choices(rest: &[Token]) -> Option<(TokenKind, usize)> {
    let TokenKind::Scripts(nothing, below, above) = &rest.first()?.kind else { return None };
    let nothing = nothing.iter().all(|token| matches!(&token.kind, TokenKind::Group(of) if of.is_empty()));
    let n = match (below.as_slice(), above.as_slice()) {
        (n, []) | ([], n) if nothing && !n.is_empty() => n,
        _ => return None,
    };
    let next = 1 + rest[1..].iter().take_while(|token| token.is_space()).count();
    let TokenKind::Scripts(letter, k, power) = &rest.get(next)?.kind else { return None };
    let [letter] = trim_space(letter) else { return None };
    let operation = choices_of(letter).filter(|_| power.is_empty() && !k.is_empty())?;
    Some((TokenKind::Call(operation, vec![n.to_vec(), k.clone()]), next + 1))
}

/// The number of choices typed in a line: 7C2.
fn typed_choices(rest: &[Token], before: &[Token]) -> Option<(TokenKind, usize)> {
    let [n, letter, k, ..] = rest else { return None };
    // In running text, a digit behind a letter is taken for its exponent.
    let k = match &k.kind {
        TokenKind::Scripts(base, below, raised) if base.is_empty() && below.is_empty() => match raised.as_slice() {
            [raised] => raised,
            _ => return None,
        },
        _ => k,
    };
    let touch = n.span.end == letter.span.start && letter.span.end == k.span.start;
    let operation = choices_of(letter).filter(|_| touch && is_integer(n) && is_integer(k))?;
    let digits = |token: &Token| token.number().and_then(|digits| digits.parse::<u32>().ok());
    let ends = rest.get(3).is_none_or(|next| {
        next.is_space() || next.is_one_of("=≈+-·×/),.;") || matches!(next.kind, TokenKind::Line | TokenKind::Cell)
    });
    let starts = before.last().is_none_or(|before| {
        before.is_space() || before.is_one_of("=≈+-·×/(,.;") || matches!(before.kind, TokenKind::Line | TokenKind::Cell)
    });
    let ordered = digits(n).zip(digits(k)).is_some_and(|(n, k)| k > 0 && n >= k && n < 100);
    (ends && starts && ordered).then(|| (TokenKind::Call(operation, vec![vec![n.clone()], vec![k.clone()]]), 3))
}

/// The numbers of choices as functions of two integers: C(7, 4), and P(9, 2) where it is a whole number.
fn called_choices(rest: &[Token]) -> Option<(TokenKind, usize)> {
    let letter = rest.first()?;
    let operation = choices_of(letter)?;
    let end = rest.iter().take(12).position(|token| token.is_sign(')'))?;
    let solid: Vec<&Token> = rest[1..=end].iter().filter(|token| !token.is_space()).collect();
    let [open, n, comma, k, _] = solid.as_slice() else { return None };
    let digits = |token: &Token| token.number().and_then(|digits| digits.parse::<u32>().ok());
    let ordered = digits(n).zip(digits(k)).is_some_and(|(n, k)| n >= k);
    let mut behind =
        rest[end + 1..].iter().filter(|token| !matches!(token.kind, TokenKind::Space(_) | TokenKind::Cell));
    let is_equated = behind.next().is_some_and(|next| next.is_one_of("=≈"));
    let result = behind.next().filter(|_| is_equated);
    let is_whole = result.is_some_and(is_integer);
    // An entry of a matrix: C(1,1) = 5.4321.
    let is_decimal = result.and_then(Token::number).is_some_and(|digits| {
        digits.split_once('.').is_some_and(|(_, decimals)| decimals.len() > 1 && decimals.contains(|c| c != '0'))
    });
    let is_entry = is_decimal && behind.next().is_none_or(|next| next.is_one_of(",;.") || next.kind == TokenKind::Line);
    let is_binomial = operation == NamedOperation::Binomial && !is_entry;
    (open.is_sign('(') && comma.is_sign(',') && ordered && (is_binomial || is_whole))
        .then(|| (TokenKind::Call(operation, vec![vec![(*n).clone()], vec![(*k).clone()]]), end + 1))
}

/// A repeating decimal whose period has a line above it.
fn period(rest: &[Token]) -> Option<(TokenKind, usize)> {
    let whole = rest.first()?.number().filter(|digits| !digits.contains('…'))?;
    let points = usize::from(rest.get(1)?.is_sign('.'));
    let TokenKind::Accent(base, sign) = &rest.get(1 + points)?.kind else { return None };
    let [period] = trim_space(base) else { return None };
    let digits = period.number().filter(|_| is_integer(period))?;
    let single = digits.len() == 1 && sign == "˙";
    if !(single || sign == "¯") || (points == 1) == whole.contains('.') {
        return None;
    }
    let start = if points == 1 { format!("{whole}.") } else { whole.to_owned() };
    Some((TokenKind::Number(repeated(&start, digits)), 2 + points))
}

/// Decimals with a period behind them, written out.
fn repeated(start: &str, period: &str) -> String {
    let decimals = start.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let more: String = period.chars().cycle().take(DECIMALS.saturating_sub(decimals)).collect();
    format!("{start}{more}")
}

/// Decimals that go on with dots: with a period that is printed twice, or three times if it is one digit, they are known to the end. Two
/// last digits that are equal say nothing: 1/17 is 0.0588…
fn dots(rest: &[Token]) -> Option<(TokenKind, usize)> {
    let first = rest.first()?;
    let number = first.number().filter(|digits| digits.contains('.') && !digits.contains('…'))?;
    let next = rest.get(1)?;
    let is_dots = match &next.kind {
        TokenKind::Unknown(dots) => dots == "…",
        TokenKind::Operator('…') => true,
        _ => false,
    };
    let typed = rest.get(1..4).is_some_and(|three| three.iter().all(|token| token.is_sign('.')));
    let taken = if typed { 4 } else { 2 };
    let behind = rest.get(taken..).unwrap_or_default().iter().find(|token| !token.is_space());
    let ends = behind.is_none_or(|behind| match &behind.kind {
        TokenKind::Operator(c) => "=≈)]}.;/-·×".contains(*c),
        TokenKind::Word(_) | TokenKind::Line | TokenKind::Cell | TokenKind::Space(_) => true,
        _ => false,
    });
    if !(is_dots || typed) || first.span.end < next.span.start || !ends {
        return None;
    }
    let (_, decimals) = number.split_once('.')?;
    // One digit that is printed twice may be one that only happens to stand there: 0.0588….
    let repeats = |length: usize| {
        let times = if length == 1 { 3 } else { 2 };
        let Some(start) = decimals.len().checked_sub(times * length) else { return false };
        (1..times).all(|at| decimals[start + at * length..].starts_with(&decimals[start..start + length]))
    };
    let written = match (1..=6).find(|length| repeats(*length)) {
        Some(length) => repeated(number, &decimals[decimals.len() - length..]),
        None => format!("{number}…"),
    };
    Some((TokenKind::Number(written), taken))
}

/// Decimals that go on with dots, the last of which bears a raised sign: `32.23...^\circ`.
fn dots_with_sign(rest: &[Token]) -> Option<(TokenKind, usize)> {
    let number = rest.first()?.number().filter(|digits| digits.contains('.') && !digits.contains('…'))?;
    let typed = rest.get(1..3).is_some_and(|two| two.iter().all(|token| token.is_sign('.')));
    let at = if typed { 3 } else { 1 };
    let TokenKind::Scripts(base, sub, sup) = &rest.get(at)?.kind else { return None };
    let is_dots = match base.as_slice() {
        [point] if typed => point.is_sign('.'),
        [dots] => dots.is_sign('…') || matches!(&dots.kind, TokenKind::Unknown(dots) if dots == "…"),
        _ => false,
    };
    let base = vec![Token::new(TokenKind::Number(format!("{number}…")), rest[0].span)];
    (is_dots && sub.is_empty()).then(|| (TokenKind::Scripts(base, Vec::new(), sup.clone()), at + 1))
}
