//! MathML's presentation elements to tokens.

use super::tags::Element;
use super::words::{number, number_length, plain_chars, span_of_chars, tokenise_words};
use crate::decimal::parse_decimal;
use crate::token::{MathFunction, NamedOperation, SourceChar, Token, TokenKind, trim_space};

/// The tokens of an element.
pub(crate) fn tokens(of: &Element) -> Vec<Token> {
    tokens_in(of, false)
}

/// The tokens of an element in one whose letters are upright, or not.
fn tokens_in(of: &Element, upright: bool) -> Vec<Token> {
    let mut out = Vec::new();
    push_tokens(of, upright, &mut out);
    out
}

fn row_tokens(of: &Element, upright: bool) -> Vec<Token> {
    let mut out = Vec::new();
    let mut rest = of.children.as_slice();
    while let [child, behind @ ..] = rest {
        // Upright letters side by side are a word or a unit.
        let letters = rest.iter().take_while(|of| is_upright_letter(of, upright)).count();
        rest = match rest {
            _ if letters > 1 => {
                let word: Vec<SourceChar> = rest[..letters].iter().flat_map(|of| plain_chars(&of.text)).collect();
                tokenise_words(&word, &mut out);
                &rest[letters..]
            }
            [open, table, close, behind @ ..] if push_matrix([open, table, close], &mut out) => behind,
            _ => {
                push_tokens(child, upright, &mut out);
                behind
            }
        };
    }
    out
}

/// Whether the letters in an element are upright, which it may say itself.
fn is_upright(of: &Element, outer: bool) -> bool {
    of.attribute("mathvariant").map_or(outer, |variant| variant == "normal")
}

fn is_upright_letter(of: &Element, outer: bool) -> bool {
    of.name == "mi"
        && is_upright(of, outer)
        && of.children.is_empty()
        && matches!(of.text.as_slice(), [one] if one.c.is_alphabetic())
}

/// Adds a matrix or a determinant, if a table in brackets is one; whether it is. In a column by itself may be a binomial
/// coefficient, unless its maker says otherwise.
fn push_matrix([open, table, close]: [&Element; 3], out: &mut Vec<Token>) -> bool {
    let sign = |of: &Element| if of.name == "mo" { of.text.iter().map(|sign| sign.c).collect() } else { String::new() };
    let is_bar = match (sign(open).trim(), sign(close).trim()) {
        ("(", ")") | ("[", "]") => false,
        ("|", "|") => true,
        _ => return false,
    };
    let mut table = table;
    while let ("mrow" | "mstyle", [inner]) = (table.name.as_str(), table.children.as_slice()) {
        table = inner;
    }
    let is_row = |row: &Element| matches!(row.name.as_str(), "mtr" | "mlabeledtr");
    let columns = table.children.iter().map(|row| row.children.len()).max().unwrap_or(0);
    let is_column = columns < 2 && table.attribute("notation") != Some("matrix");
    if table.name != "mtable" || is_column || !table.children.iter().all(is_row) {
        return false;
    }
    let cells = |row: &Element| {
        let cell = |cell: &Element| trim_space(&tokens(cell)).to_vec();
        let between = [Token::new(TokenKind::Cell, row.span)];
        row.children.iter().map(cell).collect::<Vec<_>>().join(between.as_slice())
    };
    let rows: Vec<Vec<Token>> = table.children.iter().map(cells).collect();
    // Equations in brackets are rows of their own.
    if rows.iter().flatten().any(|token| token.is_one_of("=≈")) {
        return false;
    }
    let last = out.iter().rposition(|token| !token.is_space());
    let det =
        last.filter(|at| matches!(&out[*at].kind, TokenKind::Word(name) | TokenKind::Unknown(name) if name == "det"));
    out.truncate(det.unwrap_or(out.len()));
    let operation = if is_bar || det.is_some() { NamedOperation::Determinant } else { NamedOperation::Matrix };
    out.push(Token::new(TokenKind::Call(operation, rows), open.span.join(close.span)));
    true
}

fn trim_chars(signs: &[SourceChar]) -> &[SourceChar] {
    let start = signs.iter().take_while(|sign| sign.c.is_whitespace()).count();
    let end = signs.iter().rev().take_while(|sign| sign.c.is_whitespace()).count();
    signs.get(start..signs.len().saturating_sub(end)).unwrap_or_default()
}

fn push_tokens(of: &Element, outer: bool, out: &mut Vec<Token>) {
    let upright = is_upright(of, outer);
    let text = plain_chars(&of.text);
    let text = trim_chars(&text);
    let mut push = |kind: TokenKind| out.push(Token::new(kind, of.span));
    let child = |at: usize| of.children.get(at).map(|of| tokens_in(of, upright)).unwrap_or_default();
    match (of.name.as_str(), of.children.len()) {
        ("math" | "mrow" | "mstyle" | "mpadded" | "semantics" | "mtd" | "menclose" | "merror" | "maction", _) => {
            // Text outside any element is an author's slip, and read.
            if of.children.is_empty() {
                tokenise_words(text, out);
            }
            out.extend(row_tokens(of, upright));
        }
        ("annotation" | "annotation-xml" | "mphantom" | "none" | "mprescripts" | "maligngroup" | "malignmark", _) => {}
        ("mn", _) => {
            let plain: Vec<SourceChar> = text.iter().filter(|sign| !sign.c.is_whitespace()).copied().collect();
            match number_length(&plain) {
                length if length > 0 && length == plain.len() => out.push(number(&plain)),
                _ => {
                    let from = out.len();
                    tokenise_words(text, out);
                    factor_letters(&mut out[from..]);
                }
            }
        }
        ("mi", _) => identifier(text, upright, out),
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
            let em = of.attribute("width").and_then(|width| parse_decimal(width.strip_suffix("em")?));
            let newline = of.attribute("linebreak") == Some("newline");
            let tenths = em.unwrap_or(0.2).clamp(0.0, 20.0) * 10.0;
            push(TokenKind::Space(if newline { 20 } else { tenths as u8 }));
        }
        // The line below a column of numbers that are added.
        ("mfrac", 2) if begins_with(&child(0), "+") && !begins_with(&child(1), "+-") => {
            push(TokenKind::Unknown("a sum in a column".to_owned()));
        }
        // Without a stroke: a binomial coefficient, as `{7 \choose 4}`.
        ("mfrac", 2) if of.attribute("linethickness").is_some_and(|width| width.starts_with('0')) => {
            push(TokenKind::Call(NamedOperation::Binomial, vec![child(0), child(1)]));
        }
        ("mfrac", 2) => push(TokenKind::Fraction(child(0), child(1))),
        ("msqrt", _) => push(TokenKind::Root(row_tokens(of, upright), Vec::new())),
        ("mroot", 2) => push(TokenKind::Root(child(0), child(1))),
        ("msup", 2) => push(TokenKind::Scripts(child(0), Vec::new(), child(1))),
        ("msub", 2) => push(TokenKind::Scripts(child(0), child(1), Vec::new())),
        ("msubsup", 3) => push(TokenKind::Scripts(child(0), child(1), child(2))),
        // The limits of a sum or a product stand below and above it.
        ("munderover", 3) if matches!(trim_space(&child(0)), [one] if one.is_one_of("∑∏")) => {
            push(TokenKind::Scripts(child(0), child(1), child(2)))
        }
        ("mover", 2) => {
            let sign = crate::token::show(&child(1));
            push(TokenKind::Accent(child(0), sign));
        }
        ("mtable", _) if is_stack(of) => push(TokenKind::Unknown("a fraction of fractions".to_owned())),
        ("mtable", _) => {
            let rows =
                of.children.iter().map(|row| row.children.iter().map(|of| tokens_in(of, upright)).collect()).collect();
            push(TokenKind::Table(side_by_side(rows)));
        }
        ("mtr" | "mlabeledtr", _) => out.extend(row_tokens(of, upright)),
        ("mfenced", _) => {
            let bracket = |name, usual| of.attribute(name).and_then(|text| text.trim().chars().next()).unwrap_or(usual);
            push(TokenKind::Operator(bracket("open", '(')));
            for (at, child) in of.children.iter().enumerate() {
                if at > 0 {
                    out.push(Token::new(TokenKind::Operator(','), child.span));
                }
                push_tokens(child, upright, out);
            }
            out.push(Token::new(TokenKind::Operator(bracket("close", ')')), of.span));
        }
        // What has another name in the notation out of which the formula was made.
        (name, _) => push(TokenKind::Unknown(name.strip_prefix("unknown-").unwrap_or(name).to_owned())),
    }
    // A leaf that was not closed has taken what follows it.
    if matches!(of.name.as_str(), "mn" | "mi" | "mo" | "mtext" | "ms") {
        out.extend(row_tokens(of, upright));
    }
}

/// Makes names of the letters behind a number in one element: the `y` of `<mn>2y</mn>`. Letters that are units stay what they are.
fn factor_letters(tokens: &mut [Token]) {
    const LETTERS: &str = "abcknpqrtuvwxyz";
    for at in 1..tokens.len() {
        let follows = tokens[at - 1].number().is_some();
        let is_name = |word: &&str| match word.len() {
            1 => LETTERS.contains(*word),
            2 => word.bytes().all(|c| c.is_ascii_lowercase()) && word.contains(['x', 'y', 'z']),
            _ => false,
        };
        if let Some(name) = tokens[at].word().filter(is_name).filter(|_| follows).map(str::to_owned) {
            tokens[at].kind = TokenKind::Name(name);
        }
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

fn identifier(text: &[SourceChar], upright: bool, out: &mut Vec<Token>) {
    let name: String = text.iter().map(|sign| sign.c).collect();
    let span = span_of_chars(text);
    match text {
        [] => {}
        _ if MathFunction::from_name(&name).is_some() => {
            out.extend(MathFunction::from_name(&name).map(|function| Token::new(TokenKind::Function(function), span)));
        }
        [one] if "%°$".contains(one.c) => out.push(Token::new(TokenKind::Word(name), span)),
        // Some programs take a sign for a letter.
        [one] if one.c.is_ascii_punctuation() || "·×±∓≈≠≤≥≡∼≃≅→⇒∝".contains(one.c) => {
            out.push(Token::new(TokenKind::Operator(one.c), span))
        }
        [one] if !one.c.is_ascii_digit() && !upright => {
            out.push(Token::new(TokenKind::Name(name), span));
        }
        _ => tokenise_words(text, out),
    }
}

/// The columns at which another equation begins behind a whole one of the same row, whose relation stands in a cell of its own.
fn equation_starts(rows: &[Vec<Vec<Token>>]) -> Vec<usize> {
    let is_relation = |token: &Token| token.is_one_of("=≈≠<>≤≥");
    let relates = |cell: &[Token]| cell.iter().any(is_relation);
    let mut starts = Vec::new();
    for row in rows {
        // Whether a relation stands before, and something behind it; and whether an empty cell stands between.
        let (mut is_related, mut is_whole, mut is_apart) = (false, false, false);
        for (at, cell) in row.iter().enumerate() {
            let solid = trim_space(cell);
            let (Some(first), Some(last)) = (solid.first(), solid.last()) else {
                is_apart = is_whole;
                continue;
            };
            let begins = match &first.kind {
                TokenKind::Operator(c) => "([{|√-".contains(*c),
                TokenKind::Word(_) => false,
                _ => true,
            };
            // The relation of an equation that begins here stands in the same cell or at the start of the next one.
            let next = row[at + 1..].iter().map(|cell| trim_space(cell)).find(|cell| !cell.is_empty());
            let has_own = relates(solid) || next.and_then(<[Token]>::first).is_some_and(is_relation);
            let has_number = crate::token::has_number(solid);
            if is_whole && begins && (has_own || (is_apart && has_number)) && !(relates(solid) && is_relation(first)) {
                starts.push(at);
                (is_related, is_whole) = (relates(solid), relates(solid) && !is_relation(last));
            } else {
                is_related |= relates(solid);
                is_whole = is_related && !is_relation(last) && !last.is_one_of("+-·×/(");
            }
            is_apart = false;
        }
    }
    starts.sort_unstable();
    starts.dedup();
    starts
}

/// The rows of a table whose columns are parted at these, the parts one below the other.
fn parted_at(starts: &[usize], rows: Vec<Vec<Vec<Token>>>) -> Vec<Vec<Token>> {
    let bounds: Vec<usize> = [0].into_iter().chain(starts.iter().copied()).chain([usize::MAX]).collect();
    let part = |row: &[Vec<Token>], from: usize, to: usize| -> Vec<Token> {
        row.iter().take(to).skip(from).flatten().cloned().collect()
    };
    bounds.windows(2).flat_map(|of| rows.iter().map(move |row| part(row, of[0], of[1]))).collect()
}

/// The rows of a table; cells that each have an equation of their own are rows by themselves, column by column.
pub(crate) fn side_by_side(rows: Vec<Vec<Vec<Token>>>) -> Vec<Vec<Token>> {
    let owns = |cell: &Vec<Token>| {
        let Some(at) = cell.iter().position(|token| token.is_sign('=')) else { return false };
        let left = cell[..at].iter().any(|token| !token.is_space() && !matches!(token.kind, TokenKind::Operator(_)));
        left && !trim_space(&cell[at + 1..]).is_empty()
    };
    if !rows.iter().any(|row| row.iter().filter(|cell| owns(cell)).count() >= 2) {
        return parted_at(&equation_starts(&rows), rows);
    }
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let mut out: Vec<Vec<Token>> = vec![Vec::new(); columns * rows.len()];
    let height = rows.len();
    for (at, row) in rows.into_iter().enumerate() {
        for (column, mut cell) in row.into_iter().enumerate() {
            // What stands below an equation does not go on with it, be it a sign or a bracket.
            if owns(&cell) {
                cell.push(Token::new(TokenKind::Space(20), cell[0].span));
            }
            out[column * height + at] = cell;
        }
    }
    out
}
