//! The joining stage: what readers leave in pieces becomes the tokens that are evaluated.
//!
//! Numbers are split over elements, prefixes stand apart from their unit, exponents have an empty base. Afterwards there are
//! no scripts, accents, groups without meaning and tables any more: a letter has its subscript in its name, and an exponent is
//! a [`Kind::Power`] behind what it belongs to.

use crate::columns;
use crate::pieces::{self, column, prefixed};
use crate::token::{Function, Kind, Span, Token, any, show, trimmed};

/// Joins the tokens of a formula.
pub(crate) fn joined(tokens: &[Token]) -> Vec<Token> {
    let rows = rows(tokens);
    let rows = columns::without_remarks(&rows).unwrap_or(rows);
    let rows = columns::read_down(&rows).unwrap_or(rows);
    merged(flat(&rows))
}

/// Tables at the top become rows; inside brackets they are matrices.
fn rows(tokens: &[Token]) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::new();
    for token in tokens {
        let Kind::Table(table) = &token.kind else {
            out.push(token.clone());
            continue;
        };
        if out.iter().rev().find(|token| !token.is_space()).is_some_and(|before| before.is_one_of("([{|")) {
            out.push(Token::new(Kind::Unknown("a matrix".to_owned()), token.span));
            continue;
        }
        let end = Token::new(Kind::Line, Span { start: token.span.end, end: token.span.end });
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

fn inside(tokens: &[Token]) -> Vec<Token> {
    merged(flat(tokens))
}

fn unknown(what: &str, span: Span) -> Token {
    Token::new(Kind::Unknown(what.to_owned()), span)
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
    let of = before.iter().rev().find(|token| !matches!(token.kind, Kind::Group(_)));
    of.is_some_and(|of| matches!(&of.kind, Kind::Unknown(name) if name.starts_with('\\')))
}

/// Whether there is more than one command that is not known and its arguments: otherwise it only dresses up what is in them.
fn is_part(tokens: &[Token]) -> bool {
    let is_dress = |token: &Token| match &token.kind {
        Kind::Group(_) | Kind::Space(_) | Kind::Cell | Kind::Line => true,
        Kind::Unknown(name) => name.starts_with('\\'),
        _ => false,
    };
    !tokens.iter().all(is_dress)
}

/// A sign in an argument ends neither a side nor a row.
fn held_together(token: Token) -> Token {
    let ends = match token.kind {
        Kind::Operator(c) => !"+-·×/()[]{}|*^_′±∓√".contains(c),
        Kind::Line | Kind::Space(9..) => true,
        _ => false,
    };
    if ends { unknown("a sign in an argument", token.span) } else { token }
}

/// A comma in an argument ends no side.
fn without_comma(token: Token) -> Token {
    if token.is(',') { unknown("a comma in an argument", token.span) } else { token }
}

fn flat(tokens: &[Token]) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::new();
    let mut related = false;
    for (at, token) in tokens.iter().enumerate() {
        let span = token.span;
        match &token.kind {
            Kind::Cell => {
                let next = tokens[at + 1..].iter().find(|token| !token.is_space());
                // Two of them part two equations.
                let doubled = at > 0
                    && tokens[..at]
                        .iter()
                        .rev()
                        .find(|token| !token.is_space())
                        .is_some_and(|before| before.kind == Kind::Cell);
                let goes_on = |next: &Token| match next.kind {
                    Kind::Operator(c) => !doubled || !"([√".contains(c),
                    Kind::Line | Kind::Cell => true,
                    _ => false,
                };
                let continues = next.is_none_or(goes_on);
                if related && !continues {
                    out.push(Token::new(Kind::Space(20), span));
                    related = false;
                }
            }
            Kind::Table(_) => out.push(unknown("a table", span)),
            Kind::Group(inner) if is_argument(&tokens[..at]) => {
                let held = if is_part(tokens) { held_together } else { without_comma };
                out.extend(flat(inner).into_iter().map(held));
            }
            Kind::Group(inner) => out.extend(flat(inner)),
            Kind::Scripts(base, sub, sup) => scripts([base, sub, sup], span, &mut out),
            Kind::Accent(base, sign) => {
                let letter = show(base);
                let basis = matches!(sign.trim(), "^" | "ˆ" | "̂").then(|| match letter.trim() {
                    "i" | "x" | "ı" | "\\imath" => Some(1),
                    "j" | "y" | "ȷ" | "\\jmath" => Some(2),
                    "k" | "z" => Some(3),
                    _ => None,
                });
                out.push(match basis.flatten() {
                    Some(which) => Token::new(Kind::Basis(which), span),
                    None if crate::token::has_number(base) => unknown("a sign above a number", span),
                    None => Token::new(Kind::Name(name_of(base) + sign.trim()), span),
                });
            }
            Kind::Fraction(above, below) => {
                out.push(Token::new(Kind::Fraction(inside(above), inside(below)), span));
            }
            Kind::Root(of, index) => out.push(Token::new(Kind::Root(inside(of), inside(index)), span)),
            Kind::Operator(c) if "∫∂∮∇∬∯…⋯∏∑".contains(*c) => {
                out.push(unknown(&c.to_string(), span))
            }
            Kind::Operator(c @ ('%' | '°' | '$')) => out.push(Token::new(Kind::Word(c.to_string()), span)),
            Kind::Space(0) => {}
            kind => {
                match kind {
                    Kind::Operator('=' | '≈') => related = true,
                    Kind::Line => related = false,
                    _ => {}
                }
                out.push(token.clone());
            }
        }
    }
    out
}

fn is_mark(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| "′'*†″∗+-".contains(c)) || matches!(text, "th" | "st" | "nd" | "rd")
}

fn ungrouped(tokens: &[Token]) -> &[Token] {
    match trimmed(tokens) {
        [Token { kind: Kind::Group(inner), .. }] => ungrouped(inner),
        other => other,
    }
}

fn scripts([base, sub, sup]: [&[Token]; 3], span: Span, out: &mut Vec<Token>) {
    let base = trimmed(base);
    if let [before @ .., last] = ungrouped(base)
        && (last.is('|') || last.is(']'))
        && !sub.is_empty()
        && !sup.is_empty()
    {
        out.extend(flat(before));
        if last.is(']') {
            out.push(last.clone());
        }
        out.push(Token::new(Kind::Limits(inside(sub), inside(sup)), span));
        return;
    }
    if sub.is_empty() {
        return raised(base, sup, span, out);
    }
    let mut base = ungrouped(base);
    if let [first, .., last] = base
        && sup.is_empty()
        && matches!(last.kind, Kind::Name(_) | Kind::Word(_) | Kind::Accent(..))
        && matches!(first.kind, Kind::Number(_) | Kind::Operator(_))
    {
        out.extend(flat(&base[..base.len() - 1]));
        base = &base[base.len() - 1..];
    }
    if let [Token { kind: Kind::Function(function), .. }] = base {
        let of = name_of(sub);
        out.push(match (function, of.as_str()) {
            (Function::Log, "10") => Token::new(Kind::Function(Function::Lg), span),
            (Function::Log, "e") => Token::new(Kind::Function(Function::Ln), span),
            (Function::Log, _) if show(sub).contains(['.', ',']) => unknown("a function with a subscript", span),
            (Function::Log, base) if base.parse().is_ok_and(|base: u8| base > 1) => {
                Token::new(Kind::Function(Function::LogTo(base.parse().unwrap_or(2))), span)
            }
            _ => unknown("a function with a subscript", span),
        });
        return;
    }
    if let Some(unit) = pieces::with_subscript(base, &name_of(sub)) {
        out.push(Token::new(Kind::Word(unit.to_owned()), span));
        if !sup.is_empty() {
            out.push(Token::new(Kind::Power(inside(sup)), span));
        }
        return;
    }
    let strange = |token: &Token| matches!(token.kind, Kind::Operator(c) if !"Δ∇".contains(c));
    if base.is_empty() || base.iter().any(strange) || base[0].number().is_some() {
        out.push(unknown("a subscript of something else than a letter", span));
        return;
    }
    let mut name = format!("{}_{}", name_of(base), name_of(sub));
    let mark = show(sup);
    let is_label = !mark.is_empty() && mark.chars().all(|c| c.is_ascii_alphabetic() || "′'*†″∗+-".contains(c));
    if is_label {
        name = format!("{name}^{mark}");
    }
    out.push(Token::new(Kind::Name(name), span));
    if !sup.is_empty() && !is_label {
        out.push(Token::new(Kind::Power(inside(sup)), span));
    }
}

fn raised(base: &[Token], sup: &[Token], span: Span, out: &mut Vec<Token>) {
    let mark = show(sup);
    let mark = mark.trim();
    let power = || Token::new(Kind::Power(inside(sup)), crate::token::span_of(sup));
    let scale = mark.strip_prefix(['°', 'o']).map(str::trim).filter(|scale| matches!(*scale, "C" | "F"));
    if matches!(mark, "°" | "o" | "∘" | "0°" | "○") || scale.is_some() {
        out.extend(flat(base));
        out.push(Token::new(Kind::Word(format!("°{}", scale.unwrap_or_default())), span));
        return;
    }
    if base.is_empty() {
        while out.last().is_some_and(Token::is_space) {
            out.pop();
        }
        let takes = out.last().is_some_and(|last| match last.kind {
            Kind::Operator(c) => ")]".contains(c),
            Kind::Word(_)
            | Kind::Number(_)
            | Kind::Name(_)
            | Kind::Fraction(..)
            | Kind::Root(..)
            | Kind::Function(_) => true,
            _ => false,
        });
        out.push(if takes { power() } else { unknown("an exponent of nothing", span) });
        return;
    }
    if is_mark(mark) {
        out.push(Token::new(Kind::Name(name_of(base) + mark), span));
        return;
    }
    if let [Token { kind: Kind::Function(_), .. }] = base {
        out.extend(base.iter().cloned());
        out.push(power());
        return;
    }
    let inner = inside(ungrouped(base));
    let last = inner.last();
    let plain = inner.len() <= 1
        || is_bracketed(&inner)
        || last.is_some_and(|last| {
            matches!(last.kind, Kind::Word(_) | Kind::Number(_) | Kind::Name(_)) || last.is_one_of(")]|")
        });
    if plain {
        out.extend(inner);
    } else {
        out.push(Token::new(Kind::Group(inner), span));
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

/// Joins numbers that were split.
fn numbers(tokens: Vec<Token>) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    for token in tokens {
        if let Kind::Power(inner) = &token.kind
            && trimmed(inner).is_empty()
        {
            continue;
        }
        let Kind::Number(text) = &token.kind else {
            out.push(token);
            continue;
        };
        let digits = |text: &str| text.chars().all(|c| c.is_ascii_digit());
        let whole = out.len();
        let joint = match out.as_slice() {
            [.., Token { kind: Kind::Number(before), .. }, point]
                if point.is('.') && !before.contains('.') && digits(text) =>
            {
                Some((2, format!("{before}.{text}")))
            }
            [.., Token { kind: Kind::Number(before), .. }, comma]
                if comma.is(',') && groups_of_three(before) && starts_with_three(text) =>
            {
                Some((2, format!("{before},{text}")))
            }
            // Thousands that narrow space parts: 12 000.
            [.., Token { kind: Kind::Number(before), .. }, Token { kind: Kind::Space(0..=5), .. }]
                if groups_of_three(before) && starts_with_three(text) =>
            {
                Some((2, format!("{before},{text}")))
            }
            [.., Token { kind: Kind::Number(before), .. }] if groups_of_three(before) && starts_with_three(text) => {
                Some((1, format!("{before},{text}")))
            }
            [.., Token { kind: Kind::Number(before), .. }] if text.starts_with('.') && !before.contains('.') => {
                Some((1, format!("{before}{text}")))
            }
            _ => None,
        };
        match joint {
            Some((taken, text)) => {
                let start = out[whole - taken].span;
                out.truncate(whole - taken);
                out.push(Token::new(Kind::Number(text), start.join(token.span)));
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
    let tokens = pieces::split(pieces::bracketed(pieces::scaled(numbers(tokens))));
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        // The next token behind space narrower than so many tenths of an em, and its place.
        let next = |narrower: u8| {
            let mut next = at + 1;
            while let Some(Kind::Space(width)) = tokens.get(next).map(|token| &token.kind)
                && *width < narrower
            {
                next += 1;
            }
            tokens.get(next).map(|token| (token, next))
        };
        let text = match &token.kind {
            Kind::Name(text) | Kind::Word(text) => text.as_str(),
            _ => "",
        };
        let is_word = token.word().is_some();
        let combined = match text {
            "Ω" if !is_word && pieces::takes_unit(&out) => Some((Kind::Word("Ω".to_owned()), at, token.span)),
            "e" | "E" => {
                let (number, used) = pieces::power_of_ten(&tokens[at..], &out);
                out.extend(number);
                if used > 0 {
                    at += used;
                    continue;
                }
                None
            }
            "μ" | "k" | "M" | "n" | "m" | "G" | "p" | "c" => {
                let unit = next(if text == "μ" { 3 } else { 0 });
                let below = unit.and_then(|(_, at)| tokens.get(at + 1)).is_some_and(pieces::is_below);
                prefixed(token, text, unit, below, &out)
            }
            "mm" | "cm" | "in" | "inch" | "inches" if is_word => column(&tokens, at, text),
            "deg" if is_word && out.last().is_some_and(|last| last.number().is_some() || last.is_space()) => {
                let behind = out.iter().rev().find(|token| !token.is_space());
                let called = tokens.get(at + 1).is_some_and(|next| next.is('(') || next.number().is_some());
                let fits = behind.is_some_and(|behind| behind.number().is_some()) && !called;
                fits.then(|| (Kind::Word("°".to_owned()), at, token.span))
            }
            "°" if is_word => next(5).and_then(|(next, behind)| {
                let scale = match &next.kind {
                    Kind::Word(scale) => scale,
                    Kind::Name(scale) if behind == at + 1 => scale,
                    _ => return None,
                };
                matches!(scale.as_str(), "C" | "F").then(|| (Kind::Word(format!("°{scale}")), behind, next.span))
            }),
            "Δ" => next(3).and_then(|(next, at)| match &next.kind {
                Kind::Name(name) | Kind::Word(name) => Some((Kind::Name(format!("Δ{name}")), at, next.span)),
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
        let dots = tokens[at..].iter().take(3).filter(|token| token.is('.')).count();
        if dots == 3 && !follows_number {
            out.push(unknown("…", token.span));
            at += 3;
            continue;
        }
        if pieces::is_product(&tokens, at) {
            out.push(Token::new(Kind::Operator('·'), token.span));
            at += 1;
            continue;
        }
        let abbreviated = token.is('.')
            && out.last().is_some_and(|last| last.word() == Some("in"))
            && tokens.get(at + 1).is_some_and(|next| matches!(next.kind, Kind::Power(_)));
        if !abbreviated {
            let function = token.word().and_then(Function::named);
            out.push(
                match function.filter(|function| matches!(function, Function::Sin | Function::Cos | Function::Tan)) {
                    Some(function) => Token::new(Kind::Function(function), token.span),
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
        Kind::Name(name) => !matches!(name.as_str(), "π" | "e" | "c"),
        Kind::Unknown(_) | Kind::Table(_) => true,
        _ => false,
    })
}
