//! MathML's presentation elements to tokens.

use super::tags::Element;
use super::words::{number, number_length, plain_chars, span_of_chars, tokenise_words};
use crate::token::{MathFunction, SourceChar, Token, TokenKind, trim_space};

/// The tokens of an element.
pub(crate) fn tokens(of: &Element) -> Vec<Token> {
    let mut out = Vec::new();
    push_tokens(of, &mut out);
    out
}

fn row_tokens(of: &Element) -> Vec<Token> {
    let mut out = Vec::new();
    for child in &of.children {
        push_tokens(child, &mut out);
    }
    out
}

fn trim_chars(signs: &[SourceChar]) -> &[SourceChar] {
    let start = signs.iter().take_while(|sign| sign.c.is_whitespace()).count();
    let end = signs.iter().rev().take_while(|sign| sign.c.is_whitespace()).count();
    signs.get(start..signs.len().saturating_sub(end)).unwrap_or_default()
}

fn push_tokens(of: &Element, out: &mut Vec<Token>) {
    let text = plain_chars(&of.text);
    let text = trim_chars(&text);
    let mut push = |kind: TokenKind| out.push(Token::new(kind, of.span));
    let child = |at: usize| of.children.get(at).map(tokens).unwrap_or_default();
    match (of.name.as_str(), of.children.len()) {
        ("math" | "mrow" | "mstyle" | "mpadded" | "semantics" | "mtd" | "menclose" | "merror" | "maction", _) => {
            // Text outside any element is an author's slip, and read.
            if of.children.is_empty() {
                tokenise_words(text, out);
            }
            out.extend(row_tokens(of));
        }
        ("annotation" | "annotation-xml" | "mphantom" | "none" | "mprescripts" | "maligngroup" | "malignmark", _) => {}
        ("mn", _) => {
            let plain: Vec<SourceChar> = text.iter().filter(|sign| !sign.c.is_whitespace()).copied().collect();
            match number_length(&plain) {
                length if length > 0 && length == plain.len() => out.push(number(&plain)),
                _ => tokenise_words(text, out),
            }
        }
        ("mi", _) => identifier(of, text, out),
        ("mo", _) => {
            let name: String = text.iter().map(|sign| sign.c).collect();
            match (text, MathFunction::from_name(&name)) {
                ([], _) => {}
                (_, Some(function)) => push(TokenKind::Function(function)),
                ([one], _) if !one.c.is_alphanumeric() && !"°%½¼…".contains(one.c) => {
                    out.push(Token::new(TokenKind::Operator(one.c), one.span));
                }
                _ => tokenise_words(text, out),
            }
        }
        ("mtext" | "ms", _) => {
            let name: String = text.iter().map(|sign| sign.c).collect();
            match MathFunction::from_name(&name) {
                Some(function) => push(TokenKind::Function(function)),
                None => {
                    let raw: Vec<SourceChar> = of.text.iter().filter(|sign| sign.c != '\n').copied().collect();
                    tokenise_words(&raw, out);
                }
            }
        }
        ("mspace", _) => {
            let em = of.attribute("width").and_then(|width| width.strip_suffix("em")?.parse::<f64>().ok());
            let newline = of.attribute("linebreak") == Some("newline");
            let tenths = em.unwrap_or(0.2).clamp(0.0, 20.0) * 10.0;
            push(TokenKind::Space(if newline { 20 } else { tenths as u8 }));
        }
        // The line below a column of numbers that are added.
        ("mfrac", 2) if begins_with(&child(0), "+") && !begins_with(&child(1), "+-") => {
            push(TokenKind::Unknown("a sum in a column".to_owned()));
        }
        ("mfrac", 2) => push(TokenKind::Fraction(child(0), child(1))),
        ("msqrt", _) => push(TokenKind::Root(row_tokens(of), Vec::new())),
        ("mroot", 2) => push(TokenKind::Root(child(0), child(1))),
        ("msup", 2) => push(TokenKind::Scripts(child(0), Vec::new(), child(1))),
        ("msub", 2) => push(TokenKind::Scripts(child(0), child(1), Vec::new())),
        ("msubsup", 3) => push(TokenKind::Scripts(child(0), child(1), child(2))),
        ("mover", 2) => {
            let sign = crate::token::show(&child(1));
            push(TokenKind::Accent(child(0), sign));
        }
        ("mtable", _) if is_stack(of) => push(TokenKind::Unknown("a fraction of fractions".to_owned())),
        ("mtable", _) => {
            let rows = of.children.iter().map(|row| row.children.iter().map(tokens).collect()).collect();
            push(TokenKind::Table(side_by_side(rows)));
        }
        ("mtr" | "mlabeledtr", _) => out.extend(row_tokens(of)),
        ("mfenced", _) => {
            let bracket = |name, usual| of.attribute(name).and_then(|text| text.trim().chars().next()).unwrap_or(usual);
            push(TokenKind::Operator(bracket("open", '(')));
            for (at, child) in of.children.iter().enumerate() {
                if at > 0 {
                    out.push(Token::new(TokenKind::Operator(','), child.span));
                }
                push_tokens(child, out);
            }
            out.push(Token::new(TokenKind::Operator(bracket("close", ')')), of.span));
        }
        (name, _) => push(TokenKind::Unknown(name.to_owned())),
    }
    // A leaf that was not closed has taken what follows it.
    if matches!(of.name.as_str(), "mn" | "mi" | "mo" | "mtext" | "ms") {
        out.extend(row_tokens(of));
    }
}

fn begins_with(tokens: &[Token], signs: &str) -> bool {
    trim_space(tokens).first().is_some_and(|first| first.is_one_of(signs))
}

/// Whether a table is a column whose cells are parted by lines, which stand for strokes of fractions.
fn is_stack(table: &Element) -> bool {
    fn has_line(of: &Element) -> bool {
        let line = |notation: &str| matches!(notation, "top" | "bottom");
        (of.name == "menclose" && of.attribute("notation").is_some_and(line)) || of.children.iter().any(has_line)
    }
    table.children.len() > 1 && table.children.iter().all(|row| row.children.len() == 1) && has_line(table)
}

fn identifier(of: &Element, text: &[SourceChar], out: &mut Vec<Token>) {
    let name: String = text.iter().map(|sign| sign.c).collect();
    let span = span_of_chars(text);
    match text {
        [] => {}
        _ if MathFunction::from_name(&name).is_some() => {
            out.extend(MathFunction::from_name(&name).map(|function| Token::new(TokenKind::Function(function), span)));
        }
        [one] if "%°$".contains(one.c) => out.push(Token::new(TokenKind::Word(name), span)),
        [one] if !one.c.is_ascii_digit() && of.attribute("mathvariant") != Some("normal") => {
            out.push(Token::new(TokenKind::Name(name), span));
        }
        _ => tokenise_words(text, out),
    }
}

/// The rows of a table; cells that each have an equation of their own are rows by themselves, column by column.
pub(crate) fn side_by_side(rows: Vec<Vec<Vec<Token>>>) -> Vec<Vec<Token>> {
    let owns = |cell: &Vec<Token>| {
        let Some(at) = cell.iter().position(|token| token.is_sign('=')) else { return false };
        let left = cell[..at].iter().any(|token| !token.is_space() && !matches!(token.kind, TokenKind::Operator(_)));
        left && !trim_space(&cell[at + 1..]).is_empty()
    };
    if !rows.iter().any(|row| row.iter().filter(|cell| owns(cell)).count() >= 2) {
        return rows.into_iter().map(|row| row.into_iter().flatten().collect()).collect();
    }
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let mut out: Vec<Vec<Token>> = vec![Vec::new(); columns * rows.len()];
    let height = rows.len();
    for (at, row) in rows.into_iter().enumerate() {
        for (column, cell) in row.into_iter().enumerate() {
            out[column * height + at] = cell;
        }
    }
    out
}
