//! The joining stage: what readers leave in pieces becomes the tokens that are evaluated.
//!
//! Numbers are split over elements, prefixes stand apart from their unit, exponents have an empty base. Afterwards there are
//! no scripts, accents, groups without meaning and tables any more: a letter has its subscript in its name, and an exponent is
//! a [`TokenKind::Power`] behind what it belongs to.

use crate::join::joined_operations::join_operations;
use crate::join::split_units::{self, prefixed_unit, pressure_column};
use crate::join::{congruence, equation_columns};
use crate::token::{MathFunction, NamedOperation, Span, Token, TokenKind, any, show, trim_space};

/// Joins the tokens of a formula.
pub(crate) fn join_tokens(tokens: &[Token]) -> Vec<Token> {
    let rows = equation_columns::with_wide_gaps(rows(tokens));
    let rows = equation_columns::without_row_remarks(&rows).unwrap_or(rows);
    let rows = equation_columns::read_down(&rows).or_else(|| equation_columns::part_equations(&rows)).unwrap_or(rows);
    let tokens = flatten(&rows);
    merged(congruence::as_remainders(&tokens).unwrap_or(tokens))
}

/// Tables at the top become rows; inside brackets they are matrices.
fn rows(tokens: &[Token]) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::new();
    for token in tokens {
        let TokenKind::Table(table) = &token.kind else {
            out.push(token.clone());
            continue;
        };
        if out.iter().rev().find(|token| !token.is_space()).is_some_and(|before| before.is_one_of("([{|")) {
            out.push(Token::new(TokenKind::Unknown("a matrix".to_owned()), token.span));
            continue;
        }
        let end = Token::new(TokenKind::Line, Span { start: token.span.end, end: token.span.end });
        for row in table {
            out.push(end.clone());
            out.extend(rows(row));
        }
        out.push(end);
    }
    out
}

/// The name that letters and signs make.
fn name_of(tokens: &[Token]) -> String {
    show(tokens).chars().filter(|c| !c.is_whitespace() && !"{},._()".contains(*c)).collect()
}

fn join_inner(tokens: &[Token]) -> Vec<Token> {
    merged(flatten(tokens))
}

fn unknown(what: &str, span: Span) -> Token {
    Token::new(TokenKind::Unknown(what.to_owned()), span)
}

/// Whether the first bracket closes only at the end.
fn is_bracketed(tokens: &[Token]) -> bool {
    let [first, .., last] = tokens else { return false };
    if !first.is_one_of("([") || !last.is_one_of(")]") {
        return false;
    }
    let mut depth = 0i32;
    for (at, token) in tokens.iter().enumerate() {
        depth += i32::from(token.is_one_of("([")) - i32::from(token.is_one_of(")]"));
        if depth == 0 && at + 1 < tokens.len() {
            return false;
        }
    }
    depth == 0
}

/// Whether the next group is an argument of a command that is not known.
fn is_argument(before: &[Token]) -> bool {
    let of = before.iter().rev().find(|token| !matches!(token.kind, TokenKind::Group(_)));
    of.is_some_and(|of| matches!(&of.kind, TokenKind::Unknown(name) if name.starts_with('\\')))
}

/// Whether there is more than one command that is not known and its arguments: otherwise it only dresses up what is in them.
fn is_part(tokens: &[Token]) -> bool {
    let is_dress = |token: &Token| match &token.kind {
        TokenKind::Group(_) | TokenKind::Space(_) | TokenKind::Cell | TokenKind::Line => true,
        TokenKind::Unknown(name) => name.starts_with('\\'),
        _ => false,
    };
    !tokens.iter().all(is_dress)
}

/// A sign in an argument ends neither a side nor a row.
fn held_together(token: Token) -> Token {
    let ends = match token.kind {
        TokenKind::Operator(c) => !"+-·×/()[]{}|*^_′±∓√".contains(c),
        TokenKind::Line | TokenKind::Space(9..) => true,
        _ => false,
    };
    if ends { unknown("a sign in an argument", token.span) } else { token }
}

/// A comma in an argument ends no side.
fn without_comma(token: Token) -> Token {
    if token.is_sign(',') { unknown("a comma in an argument", token.span) } else { token }
}

fn flatten(tokens: &[Token]) -> Vec<Token> {
    let joined = join_operations(tokens);
    let tokens = joined.as_deref().unwrap_or(tokens);
    let mut out: Vec<Token> = Vec::new();
    let mut related = false;
    for (at, token) in tokens.iter().enumerate() {
        let span = token.span;
        match &token.kind {
            TokenKind::Cell => {
                let next = tokens[at + 1..].iter().find(|token| !token.is_space());
                // Two of them part two equations.
                let doubled = at > 0
                    && tokens[..at]
                        .iter()
                        .rev()
                        .find(|token| !token.is_space())
                        .is_some_and(|before| before.kind == TokenKind::Cell);
                let goes_on = |next: &Token| match next.kind {
                    TokenKind::Operator(c) => !doubled || !"([√".contains(c),
                    TokenKind::Line | TokenKind::Cell => true,
                    _ => false,
                };
                // Cells of a table that begin with ≈ behind another one that has it are values of something else.
                let start = tokens[..at].iter().rposition(|of| matches!(of.kind, TokenKind::Cell | TokenKind::Line));
                let before = &tokens[start.map_or(0, |start| start + 1)..at];
                if next.is_some_and(|next| next.is_sign('≈')) && before.iter().any(|of| of.is_sign('≈')) {
                    out.push(Token::new(TokenKind::Operator(';'), span));
                    continue;
                }
                let continues = next.is_none_or(goes_on);
                if related && !continues {
                    out.push(Token::new(TokenKind::Space(20), span));
                    related = false;
                }
            }
            TokenKind::Table(_) => out.push(unknown("a table", span)),
            TokenKind::Group(inner) if is_argument(&tokens[..at]) => {
                let held = if is_part(tokens) { held_together } else { without_comma };
                out.extend(flatten(inner).into_iter().map(held));
            }
            // A value with its sign that is put in behind another sign: 2 + {-3}, but not 2 · {-}3.
            TokenKind::Group(inner)
                if matches!(ungrouped(inner), [first, _, ..] if first.is_one_of("-+")) && ends_with_sign(&out) =>
            {
                out.push(Token::new(TokenKind::Operator('('), span));
                out.extend(flatten(inner));
                out.push(Token::new(TokenKind::Operator(')'), span));
            }
            // An event in braces that are not printed: P{X ≥ 1}.
            TokenKind::Group(inner)
                if out.last().is_some_and(|last| matches!(last.kind, TokenKind::Name(_)))
                    && inner.iter().any(|token| token.is_one_of("<>≤≥")) =>
            {
                out.extend(flatten(inner).into_iter().map(held_together))
            }
            TokenKind::Group(inner) => out.extend(flatten(inner)),
            TokenKind::Scripts(base, sub, sup) => join_scripts([base, sub, sup], span, &mut out),
            TokenKind::Accent(base, sign) => {
                let letter = show(base);
                let basis = matches!(sign.trim(), "^" | "ˆ" | "̂").then(|| match letter.trim() {
                    "i" | "x" | "ı" | "\\imath" => Some(1),
                    "j" | "y" | "ȷ" | "\\jmath" => Some(2),
                    "k" | "z" => Some(3),
                    _ => None,
                });
                out.push(match basis.flatten() {
                    Some(which) => Token::new(TokenKind::Basis(which), span),
                    None if crate::token::has_number(base) => unknown("a sign above a number", span),
                    None => Token::new(TokenKind::Name(name_of(base) + sign.trim()), span),
                });
            }
            TokenKind::Fraction(above, below) => {
                out.push(Token::new(TokenKind::Fraction(join_inner(above), join_inner(below)), span));
            }
            TokenKind::Root(of, index) => {
                out.push(Token::new(TokenKind::Root(join_inner(of), join_inner(index)), span))
            }
            TokenKind::Call(operation, arguments) => {
                out.push(Token::new(
                    TokenKind::Call(*operation, arguments.iter().map(|of| join_cells(of)).collect()),
                    span,
                ));
            }
            TokenKind::Operator(c) if "∫∂∮∇∬∯…⋯∏∑".contains(*c) => {
                out.push(unknown(&c.to_string(), span))
            }
            TokenKind::Operator(c @ ('%' | '°' | '$' | '€' | '£')) => {
                out.push(Token::new(TokenKind::Word(c.to_string()), span))
            }
            TokenKind::Space(0) => {}
            kind => {
                match kind {
                    TokenKind::Operator('=' | '≈') => related = true,
                    TokenKind::Line => related = false,
                    _ => {}
                }
                out.push(token.clone());
            }
        }
    }
    out
}

/// Whether a sign of a sum or a product is the last token that is no space.
fn ends_with_sign(tokens: &[Token]) -> bool {
    tokens.iter().rev().find(|token| !token.is_space()).is_some_and(|last| last.is_one_of("+-·×/"))
}

/// An argument of an operation, whose cells stay apart.
fn join_cells(tokens: &[Token]) -> Vec<Token> {
    let mut out = Vec::new();
    for part in tokens.split_inclusive(|token| token.kind == TokenKind::Cell) {
        match part.split_last() {
            Some((cell, rest)) if cell.kind == TokenKind::Cell => {
                out.extend(join_inner(rest));
                out.push(cell.clone());
            }
            _ => out.extend(join_inner(part)),
        }
    }
    out
}

fn is_mark(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| "′'*†″∗+-".contains(c)) || matches!(text, "th" | "st" | "nd" | "rd")
}

fn ungrouped(tokens: &[Token]) -> &[Token] {
    match trim_space(tokens) {
        [Token { kind: TokenKind::Group(inner), .. }] => ungrouped(inner),
        other => other,
    }
}

fn join_scripts([base, sub, sup]: [&[Token]; 3], span: Span, out: &mut Vec<Token>) {
    let base = trim_space(base);
    if let [before @ .., last] = ungrouped(base)
        && (last.is_sign('|') || last.is_sign(']'))
        && !sub.is_empty()
        && !sup.is_empty()
    {
        out.extend(flatten(before));
        if last.is_sign(']') {
            out.push(last.clone());
        }
        out.push(Token::new(TokenKind::Limits(join_inner(sub), join_inner(sup)), span));
        return;
    }
    if sub.is_empty() {
        return join_superscript(base, sup, span, out);
    }
    let mut base = ungrouped(base);
    if let [first, .., last] = base
        && sup.is_empty()
        && matches!(last.kind, TokenKind::Name(_) | TokenKind::Word(_) | TokenKind::Accent(..))
        && matches!(first.kind, TokenKind::Number(_) | TokenKind::Operator(_))
    {
        out.extend(flatten(&base[..base.len() - 1]));
        base = &base[base.len() - 1..];
    }
    if let [Token { kind: TokenKind::Function(function), .. }] = base {
        let of = name_of(sub);
        out.push(match (function, of.as_str()) {
            (MathFunction::Log, "10") => Token::new(TokenKind::Function(MathFunction::Lg), span),
            (MathFunction::Log, "e") => Token::new(TokenKind::Function(MathFunction::Ln), span),
            (MathFunction::Log, _) if show(sub).contains(['.', ',']) => unknown("a function with a subscript", span),
            (MathFunction::Log, base) if base.parse().is_ok_and(|base: u8| base > 1) => {
                Token::new(TokenKind::Function(MathFunction::LogTo(base.parse().unwrap_or(2))), span)
            }
            _ => unknown("a function with a subscript", span),
        });
        return;
    }
    if let Some(unit) = split_units::unit_with_subscript(base, &name_of(sub)) {
        out.push(Token::new(TokenKind::Word(unit.to_owned()), span));
        if !sup.is_empty() {
            out.push(Token::new(TokenKind::Power(join_inner(sup)), span));
        }
        return;
    }
    let strange = |token: &Token| matches!(token.kind, TokenKind::Operator(c) if !"Δ∇".contains(c));
    if let ([digits], Some(of)) = (base, base_of(sub))
        && sup.is_empty()
        && is_whole_in(digits, of)
    {
        let digits = with_groups_before(digits, of, out);
        let span = digits.span.join(span);
        let of = Token::new(TokenKind::Number(of.to_string()), span);
        out.push(Token::new(TokenKind::Call(NamedOperation::InBase, vec![vec![digits], vec![of]]), span));
        return;
    }
    if base.is_empty() || base.iter().any(strange) || base[0].number().is_some() {
        // A bracket that closes still does.
        out.extend(base.last().filter(|last| last.is_one_of(")]}⌋⌉")).cloned());
        out.push(unknown("a subscript of something else than a letter", span));
        return;
    }
    let mut name = format!("{}_{}", name_of(base), name_of(sub));
    let mark = show(sup);
    let is_label = !mark.is_empty() && mark.chars().all(|c| c.is_ascii_alphabetic() || "′'*†″∗+-".contains(c));
    if is_label {
        name = format!("{name}^{mark}");
    }
    out.push(Token::new(TokenKind::Name(name), span));
    if !sup.is_empty() && !is_label {
        out.push(Token::new(TokenKind::Power(join_inner(sup)), span));
    }
}

/// A number in a base with the groups of digits before it, as in 100 1011: three or four digits each but for the first one, of which there
/// may be fewer. They are taken from what stands before it.
fn with_groups_before(last: &Token, base: u32, out: &mut Vec<Token>) -> Token {
    let (mut digits, mut span) = (last.number().unwrap_or_default().to_owned(), last.span);
    let size = digits.len();
    while let Some(at) = out.iter().rposition(|token| !token.is_space())
        && (3..=4).contains(&size)
        && digits.len() % size == 0
        && digits.len() < 40
        && is_whole_in(&out[at], base)
        && let Some(before) = out[at].number().filter(|before| before.len() <= size)
        && !(at > 0 && out[at - 1].is_one_of(".,"))
    {
        digits.insert_str(0, before);
        span = out[at].span.join(span);
        out.truncate(at);
    }
    Token::new(TokenKind::Number(digits), span)
}

/// The base of numbers that a subscript names, in digits or as a word.
fn base_of(sub: &[Token]) -> Option<u32> {
    const WORDS: [(&str, u32); 8] =
        [("two", 2), ("three", 3), ("four", 4), ("five", 5), ("eight", 8), ("ten", 10), ("bin", 2), ("dec", 10)];
    let text = show(ungrouped(sub));
    let text = text.trim().trim_matches(['(', ')']);
    let word = WORDS.iter().find(|(word, _)| *word == text).map(|(_, base)| *base);
    word.or_else(|| text.parse().ok().filter(|base| (2..=10).contains(base) || *base == 16))
}

/// Whether a token is a whole number whose digits a base has.
fn is_whole_in(token: &Token, base: u32) -> bool {
    token.number().is_some_and(|digits| digits.len() <= 40 && digits.chars().all(|c| c.is_digit(base)))
}

fn join_superscript(base: &[Token], sup: &[Token], span: Span, out: &mut Vec<Token>) {
    let mark = show(sup);
    let mark = mark.trim();
    let power = || Token::new(TokenKind::Power(join_inner(sup)), crate::token::span_of(sup));
    let scale = mark.strip_prefix(['°', 'o']).map(str::trim).filter(|scale| matches!(*scale, "C" | "F"));
    if matches!(mark, "°" | "o" | "∘" | "0°" | "○") || scale.is_some() {
        out.extend(flatten(base));
        out.push(Token::new(TokenKind::Word(format!("°{}", scale.unwrap_or_default())), span));
        return;
    }
    if base.is_empty() {
        while out.last().is_some_and(Token::is_space) {
            out.pop();
        }
        let takes = out.last().is_some_and(|last| match last.kind {
            TokenKind::Operator(c) => ")]⌋⌉".contains(c),
            TokenKind::Word(_)
            | TokenKind::Number(_)
            | TokenKind::Name(_)
            | TokenKind::Fraction(..)
            | TokenKind::Root(..)
            | TokenKind::Function(_) => true,
            _ => false,
        });
        out.push(if takes { power() } else { unknown("an exponent of nothing", span) });
        return;
    }
    if is_mark(mark) {
        out.push(Token::new(TokenKind::Name(name_of(base) + mark), span));
        return;
    }
    if let [Token { kind: TokenKind::Function(_), .. }] = base {
        out.extend(base.iter().cloned());
        out.push(power());
        return;
    }
    let inner = join_inner(ungrouped(base));
    let last = inner.last();
    let plain = inner.len() <= 1
        || is_bracketed(&inner)
        || last.is_some_and(|last| {
            matches!(last.kind, TokenKind::Word(_) | TokenKind::Number(_) | TokenKind::Name(_)) || last.is_one_of(")]|")
        });
    if plain {
        out.extend(inner);
    } else {
        out.push(Token::new(TokenKind::Group(inner), span));
    }
    out.push(power());
}

fn groups_of_three(text: &str) -> bool {
    let whole = text.split('.').next().unwrap_or_default();
    let mut groups = whole.split(',');
    let first = groups.next().unwrap_or_default();
    (1..=3).contains(&first.len()) && first != "0" && !text.contains('.') && groups.all(|group| group.len() == 3)
}

fn starts_with_three(text: &str) -> bool {
    text.split(['.', ',']).next().is_some_and(|first| first.len() == 3)
}

/// Whether a number behind an equation with a comma and a space begins another equation: `39 = 6² + 3, 124 = 11² + 3`.
fn begins_equation(before: &[Token], number: &Token, next: Option<&Token>) -> bool {
    let gap = before.last().map_or(0, |comma| number.span.start.saturating_sub(comma.span.end));
    (1..=2).contains(&gap)
        && next.is_some_and(|next| next.is_sign('='))
        && before.iter().any(|token| token.is_sign('='))
}

/// Joins numbers that were split.
fn numbers(tokens: Vec<Token>) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        if let TokenKind::Power(inner) = &token.kind
            && trim_space(inner).is_empty()
        {
            continue;
        }
        let TokenKind::Number(text) = &token.kind else {
            out.push(token);
            continue;
        };
        let digits = |text: &str| text.chars().all(|c| c.is_ascii_digit());
        let whole = out.len();
        let joint = match out.as_slice() {
            [.., Token { kind: TokenKind::Number(before), .. }, point]
                if point.is_sign('.') && !before.contains('.') && digits(text) =>
            {
                Some((2, format!("{before}.{text}")))
            }
            [.., Token { kind: TokenKind::Number(before), .. }, comma]
                if comma.is_sign(',')
                    && groups_of_three(before)
                    && starts_with_three(text)
                    && !begins_equation(&out, &token, tokens.peek()) =>
            {
                Some((2, format!("{before},{text}")))
            }
            // Digits of one number of which some are marked: 1\mathbf{4}5.
            [.., Token { kind: TokenKind::Number(before), span, .. }]
                if span.end == token.span.start && span.end > span.start && digits(text) && !before.ends_with('…') =>
            {
                Some((1, format!("{before}{text}")))
            }
            // Thousands that narrow space parts: 12 000.
            [.., Token { kind: TokenKind::Number(before), .. }, Token { kind: TokenKind::Space(0..=5), .. }]
                if groups_of_three(before) && starts_with_three(text) =>
            {
                Some((2, format!("{before},{text}")))
            }
            [.., Token { kind: TokenKind::Number(before), .. }]
                if groups_of_three(before) && starts_with_three(text) =>
            {
                Some((1, format!("{before},{text}")))
            }
            [.., Token { kind: TokenKind::Number(before), .. }] if text.starts_with('.') && !before.contains('.') => {
                Some((1, format!("{before}{text}")))
            }
            _ => None,
        };
        match joint {
            Some((taken, text)) => {
                let start = out[whole - taken].span;
                out.truncate(whole - taken);
                out.push(Token::new(TokenKind::Number(text), start.join(token.span)));
            }
            None => {
                // A part of a date, of an angle or of a code, or a number in base two.
                let code = text.len() > 1 && text.starts_with('0') && !text.contains(['.', ',']);
                let decimals = out.last().is_some_and(|last| last.is_one_of(".,·"));
                out.push(if code && !decimals { unknown("digits behind a zero", token.span) } else { token });
            }
        }
    }
    out
}

/// Joins what belongs to one unit or one name.
fn merged(tokens: Vec<Token>) -> Vec<Token> {
    let tokens = split_units::write_out_thousands(split_units::unwrap_powers_of_ten(numbers(tokens)));
    let tokens = split_units::split_unit_words(split_units::unwrap_unit_brackets(tokens));
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        // The next token behind space narrower than so many tenths of an em, and its place.
        let next = |narrower: u8| {
            let mut next = at + 1;
            while let Some(TokenKind::Space(width)) = tokens.get(next).map(|token| &token.kind)
                && *width < narrower
            {
                next += 1;
            }
            tokens.get(next).map(|token| (token, next))
        };
        let text = match &token.kind {
            TokenKind::Name(text) | TokenKind::Word(text) => text.as_str(),
            _ => "",
        };
        let is_word = token.word().is_some();
        let combined = match text {
            "Ω" if !is_word && split_units::takes_unit(&out) => {
                Some((TokenKind::Word("Ω".to_owned()), at, token.span))
            }
            "e" | "E" => {
                let (number, used) = split_units::power_of_ten(&tokens[at..], &out);
                out.extend(number);
                if used > 0 {
                    at += used;
                    continue;
                }
                None
            }
            "μ" | "k" | "M" | "n" | "m" | "G" | "p" | "c" => {
                let unit = next(if text == "μ" { 3 } else { 0 });
                let below = unit.and_then(|(_, at)| tokens.get(at + 1)).is_some_and(split_units::is_below);
                prefixed_unit(token, text, unit, below, &out)
            }
            "mm" | "cm" | "in" | "inch" | "inches" if is_word => pressure_column(&tokens, at, text),
            "deg" if is_word && out.last().is_some_and(|last| last.number().is_some() || last.is_space()) => {
                let behind = out.iter().rev().find(|token| !token.is_space());
                let called = tokens.get(at + 1).is_some_and(|next| next.is_sign('(') || next.number().is_some());
                let fits = behind.is_some_and(|behind| behind.number().is_some()) && !called;
                fits.then(|| (TokenKind::Word("°".to_owned()), at, token.span))
            }
            "°" if is_word => next(5).and_then(|(next, behind)| {
                let scale = match &next.kind {
                    TokenKind::Word(scale) => scale,
                    TokenKind::Name(scale) if behind == at + 1 => scale,
                    _ => return None,
                };
                matches!(scale.as_str(), "C" | "F").then(|| (TokenKind::Word(format!("°{scale}")), behind, next.span))
            }),
            "Δ" => next(3).and_then(|(next, at)| match &next.kind {
                TokenKind::Name(name) | TokenKind::Word(name) => {
                    Some((TokenKind::Name(format!("Δ{name}")), at, next.span))
                }
                _ => None,
            }),
            _ => None,
        };
        if let Some((kind, last, span)) = combined {
            out.push(Token::new(kind, token.span.join(span)));
            at = last + 1;
            continue;
        }
        // Dots behind a number are its further digits, others are terms that are left out.
        let follows_number = out.last().is_some_and(|last| last.number().is_some());
        let dots = tokens[at..].iter().take(3).filter(|token| token.is_sign('.')).count();
        if dots == 3 && !follows_number {
            out.push(unknown("…", token.span));
            at += 3;
            continue;
        }
        if split_units::is_product(&tokens, at) {
            out.push(Token::new(TokenKind::Operator('·'), token.span));
            at += 1;
            continue;
        }
        let abbreviated = token.is_sign('.')
            && out.last().is_some_and(|last| last.word() == Some("in"))
            && tokens.get(at + 1).is_some_and(|next| matches!(next.kind, TokenKind::Power(_)));
        if !abbreviated {
            let function = token.word().and_then(MathFunction::from_name);
            out.push(
                match function
                    .filter(|function| matches!(function, MathFunction::Sin | MathFunction::Cos | MathFunction::Tan))
                {
                    Some(function) => Token::new(TokenKind::Function(function), token.span),
                    None => token.clone(),
                },
            );
        }
        at += 1;
    }
    out
}

/// Whether letters that have no value are among the tokens.
pub(crate) fn has_letters(tokens: &[Token]) -> bool {
    any(tokens, &|kind| match kind {
        TokenKind::Name(name) => !matches!(name.as_str(), "π" | "e" | "c"),
        TokenKind::Unknown(_) | TokenKind::Table(_) => true,
        _ => false,
    })
}
