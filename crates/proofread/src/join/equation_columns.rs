//! Aligned equations side by side that go on in the rows below: each column of equations is read down.

use crate::token::{Span, Token, TokenKind, any, trim_space};
use crate::unit::unit;

/// The width of the space that parts two equations, wider than that of `\quad`.
pub(crate) const EQUATION_END: u8 = 11;

/// Most pairs of columns that are looked at.
const MOST_COLUMNS: usize = 8;

/// How many spaces in a row are as wide as what parts equations.
const SPACES_OF_GAP: usize = 5;

/// The tokens with the last of many spaces in a row as a wide one, unless a unit, a sign or words go on behind them.
pub(crate) fn with_wide_gaps(mut tokens: Vec<Token>) -> Vec<Token> {
    let mut spaces = 0;
    for at in 0..tokens.len() {
        let is_gap = matches!(tokens[at].kind, TokenKind::Space(1..9));
        spaces = if is_gap { spaces + 1 } else { 0 };
        let goes_on = tokens
            .get(at + 1)
            .is_none_or(|next| matches!(next.kind, TokenKind::Space(_) | TokenKind::Word(_) | TokenKind::Operator(_)));
        if spaces >= SPACES_OF_GAP && !goes_on {
            tokens[at].kind = TokenKind::Space(EQUATION_END);
        }
    }
    tokens
}

/// The rows of a formula, each with its cells.
fn cells(tokens: &[Token]) -> Vec<Vec<&[Token]>> {
    let rows = tokens.split(|token| token.kind == TokenKind::Line);
    rows.map(|row| row.split(|token| token.kind == TokenKind::Cell).collect()).collect()
}

fn begins_with_relation(cell: &[Token]) -> bool {
    trim_space(cell).first().is_some_and(|first| match &first.kind {
        // In smaller letters or a colour: \small{= 3}.
        TokenKind::Group(inner) => begins_with_relation(inner),
        _ => first.is_one_of("=≈"),
    })
}

/// Whether a cell is a remark: words, or a number in brackets, and no equation.
fn is_remark(cell: &[Token]) -> bool {
    let prose =
        |kind: &TokenKind| matches!(kind, TokenKind::Word(word) if word.chars().count() > 1 && unit(word).is_none());
    let bracketed = matches!(trim_space(cell), [open, .., close] if open.is_sign('(') && close.is_sign(')'));
    let relation = |kind: &TokenKind| matches!(kind, TokenKind::Operator('=' | '≈'));
    (any(cell, &prose) || bracketed) && !cell.iter().any(|token| relation(&token.kind))
}

/// The rows of aligned equations without the remarks in the cells behind them, or none if there are no such remarks.
pub(crate) fn without_row_remarks(tokens: &[Token]) -> Option<Vec<Token>> {
    let mut rows = cells(tokens);
    let mut found = false;
    for row in &mut rows {
        let aligned = row.len() > 2 && begins_with_relation(row[1]) && trim_space(row[1]).len() > 1;
        let keep = row.iter().skip(2).position(|cell| is_remark(cell)).filter(|_| aligned);
        // A word between two equations is none.
        let keep = keep.filter(|keep| !row[2 + keep..].iter().any(|cell| begins_with_relation(cell)));
        if let Some(keep) = keep.filter(|keep| row[2..2 + keep].iter().all(|cell| trim_space(cell).is_empty())) {
            row.truncate(2 + keep);
            found = true;
        }
    }
    let at = tokens.first()?.span;
    let mut out = Vec::with_capacity(tokens.len());
    for row in rows.into_iter().filter(|_| found) {
        out.push(Token::new(TokenKind::Line, at));
        for (which, cell) in row.into_iter().enumerate() {
            if which > 0 {
                out.push(Token::new(TokenKind::Cell, at));
            }
            out.extend_from_slice(cell);
        }
    }
    found.then_some(out)
}

/// Whether the second equation of a row goes on from the row above: nothing stands before its equals sign.
fn goes_on(row: &[&[Token]]) -> bool {
    row.len() >= 4 && trim_space(row[2]).is_empty() && begins_with_relation(row[3])
}

/// Whether a row has its relations where aligned equations have them, in every second cell.
fn is_aligned(row: &[&[Token]]) -> bool {
    row.iter().skip(1).step_by(2).all(|cell| trim_space(cell).is_empty() || begins_with_relation(cell))
}

/// Whether two cells are an equation of their own: something stands before the relation and behind it, and it does not go on with a sign.
fn is_equation(cells: &[&[Token]]) -> bool {
    match cells {
        [left, right] => {
            // It may also be asked whether it holds, or said that it doesn't.
            let is_other = trim_space(right).first().is_some_and(|first| first.is_one_of("≡∼≠<>≤≥"));
            let related = begins_with_relation(right) || is_other;
            let begins = trim_space(left).first().is_some_and(|first| !first.is_one_of("+·×/"));
            begins && related && trim_space(right).len() > 1
        }
        _ => false,
    }
}

/// Whether a cell is an equation by itself: something that is no sign stands before its relation, and something behind it.
fn owns_equation(cell: &[Token]) -> bool {
    let cell = trim_space(cell);
    let Some(at) = cell.iter().position(|token| token.is_one_of("=≈")) else { return false };
    let starts = cell.first().is_some_and(|first| !first.is_one_of("=≈≠<>≤≥+-·×/,.;:)]"));
    at > 0 && starts && !trim_space(&cell[at + 1..]).is_empty()
}

/// The tokens with a wide space between the cells of a row of which one is an equation by itself and the other does not go on with it. None if
/// there are no such cells.
fn part_cells(tokens: &[Token]) -> Option<Vec<Token>> {
    let goes_on = |cell: &[Token]| {
        trim_space(cell).first().is_some_and(|first| match &first.kind {
            TokenKind::Operator(c) => !"([|√".contains(*c),
            TokenKind::Word(_) => true,
            _ => false,
        })
    };
    let is_open = |cell: &[Token]| trim_space(cell).last().is_some_and(|last| last.is_one_of("+-·×/=≈(["));
    let at = tokens.first()?.span;
    let mut out = Vec::with_capacity(tokens.len());
    let mut found = false;
    for (which, row) in cells(tokens).into_iter().enumerate() {
        if which > 0 {
            out.push(Token::new(TokenKind::Line, at));
        }
        let mut before: Option<&[Token]> = None;
        for (place, cell) in row.into_iter().enumerate() {
            let is_empty = trim_space(cell).is_empty();
            let parted = !is_empty
                && before.is_some_and(|before| {
                    (owns_equation(cell) || owns_equation(before)) && !goes_on(cell) && !is_open(before)
                });
            found |= parted;
            if parted {
                out.push(Token::new(TokenKind::Space(EQUATION_END), at));
            } else if place > 0 {
                out.push(Token::new(TokenKind::Cell, at));
            }
            out.extend_from_slice(cell);
            if !is_empty {
                before = Some(cell);
            }
        }
    }
    found.then_some(out)
}

/// The tokens with the relations that have columns of their own in the cells behind them, or none if no row has two such relations.
fn without_relation_columns(tokens: &[Token]) -> Option<Vec<Token>> {
    let is_relation = |cell: &[Token]| matches!(trim_space(cell), [relation] if relation.is_one_of("=≈"));
    let rows = cells(tokens);
    if !rows.iter().any(|row| row.iter().filter(|cell| is_relation(cell)).count() > 1) {
        return None;
    }
    let at = tokens.first()?.span;
    let mut out = Vec::with_capacity(tokens.len());
    for (which, row) in rows.iter().enumerate() {
        if which > 0 {
            out.push(Token::new(TokenKind::Line, at));
        }
        for (place, cell) in row.iter().enumerate() {
            if place > 0 && !is_relation(row[place - 1]) {
                out.push(Token::new(TokenKind::Cell, at));
            }
            out.extend_from_slice(cell);
        }
    }
    Some(out)
}

/// The tokens without the columns between equations side by side that are empty or have nothing but words, or none if there are no such
/// columns.
fn without_word_columns(tokens: &[Token]) -> Option<Vec<Token>> {
    let rows = cells(tokens);
    let is_word = |token: &Token| token.is_space() || token.word().is_some_and(|word| word.chars().count() > 1);
    let widest = rows.iter().map(Vec::len).max().unwrap_or(0).min(2 * MOST_COLUMNS);
    let is_dropped = |at: usize| {
        at > 1 && at + 2 < widest && rows.iter().all(|row| row.get(at).is_none_or(|of| of.iter().all(is_word)))
    };
    let dropped: Vec<bool> = (0..widest).map(is_dropped).collect();
    if !dropped.contains(&true) {
        return None;
    }
    let at = tokens.first()?.span;
    let mut out = Vec::with_capacity(tokens.len());
    for (which, row) in rows.iter().enumerate() {
        if which > 0 {
            out.push(Token::new(TokenKind::Line, at));
        }
        let kept = row.iter().enumerate().filter(|(place, _)| !dropped.get(*place).is_some_and(|dropped| *dropped));
        let kept: Vec<&[Token]> = kept.map(|(_, cell)| *cell).collect();
        for (count, cell) in kept.into_iter().enumerate() {
            if count > 0 {
                out.push(Token::new(TokenKind::Cell, at));
            }
            out.extend_from_slice(cell);
        }
    }
    Some(out)
}

/// The tokens with a wide space before each aligned equation that begins behind a whole one: in the same row, where all rows have whole
/// equations side by side, or in a row of its own. None if there is no such equation.
pub(crate) fn part_equations(tokens: &[Token]) -> Option<Vec<Token>> {
    if !tokens.iter().any(|token| token.kind == TokenKind::Cell) {
        return None;
    }
    let related = without_relation_columns(tokens);
    let tokens = related.as_deref().unwrap_or(tokens);
    let parted = part_cells(tokens);
    let tokens = parted.as_deref().unwrap_or(tokens);
    let rows = cells(tokens);
    let is_empty = |cells: &[&[Token]]| cells.iter().all(|cell| trim_space(cell).is_empty());
    let side_by_side = rows.iter().all(|row| row.chunks(2).all(|of| is_empty(of) || is_equation(of)));
    // Two columns that have an equation of their own in each row.
    let is_own = |at: usize| {
        let mut parts = rows.iter().filter_map(|row| row.chunks(2).nth(at)).filter(|part| !is_empty(part)).peekable();
        at > 0 && parts.peek().is_some() && parts.all(is_equation)
    };
    let widest = rows.iter().map(|row| row.len().div_ceil(2)).max().unwrap_or(0).min(MOST_COLUMNS);
    let own: Vec<bool> = (0..widest).map(is_own).collect();
    let at = tokens.first()?.span;
    let mut out = Vec::with_capacity(tokens.len() + rows.len());
    let (mut found, mut is_whole) = (false, false);
    for (which, row) in rows.iter().enumerate() {
        let parts: Vec<&[&[Token]]> = match (side_by_side, own.iter().position(|own| *own)) {
            (true, _) => row.chunks(2).collect(),
            (false, Some(at)) if 2 * at < row.len() => {
                std::iter::once(&row[..2 * at]).chain(row[2 * at..].chunks(2)).collect()
            }
            (false, _) => vec![row.as_slice()],
        };
        for (place, part) in parts.into_iter().enumerate() {
            let begins = part.get(..2).is_some_and(is_equation);
            let parted = begins && (is_whole || (place > 0 && !side_by_side));
            found |= parted;
            match (parted, place) {
                // Not the sign of a row, behind which a side may go on.
                (true, _) => out.push(Token::new(TokenKind::Space(EQUATION_END), at)),
                (false, 0) if which > 0 => out.push(Token::new(TokenKind::Line, at)),
                (false, 0) => {}
                (false, _) => out.push(Token::new(TokenKind::Cell, at)),
            }
            for (which, cell) in part.iter().enumerate() {
                if which > 0 {
                    out.push(Token::new(TokenKind::Cell, at));
                }
                out.extend_from_slice(cell);
            }
            is_whole = begins || (is_whole && is_empty(part));
        }
    }
    if found { Some(out) } else { parted }
}

/// The tokens with one column of equations behind the other, or none if there are no such columns.
pub(crate) fn read_down(tokens: &[Token]) -> Option<Vec<Token>> {
    if !tokens.iter().any(|token| token.kind == TokenKind::Cell) {
        return None;
    }
    read_columns(tokens).or_else(|| read_columns(&without_word_columns(tokens)?))
}

fn read_columns(tokens: &[Token]) -> Option<Vec<Token>> {
    let rows = cells(tokens);
    if are_solutions(&rows) {
        return Some(column_by_column(&rows, tokens.first()?.span));
    }
    if !rows.iter().any(|row| goes_on(row)) || !rows.iter().all(|row| is_aligned(row)) {
        return None;
    }
    // There is nothing above the first row, so its last part belongs to the row itself, and so do those below.
    if rows.iter().find(|row| row.len() > 1).is_some_and(|first| goes_on(first)) {
        return None;
    }
    let columns = rows.iter().map(|row| row.len().div_ceil(2)).max().unwrap_or(0);
    // A column in which no row has a left side is none of equations: its cells go on with their rows.
    let has_start =
        |column: usize| rows.iter().any(|row| row.get(2 * column).is_some_and(|of| !trim_space(of).is_empty()));
    let is_used =
        |column: usize| rows.iter().any(|row| row.get(2 * column + 1).is_some_and(|of| !trim_space(of).is_empty()));
    if (0..columns).any(|column| is_used(column) && !has_start(column)) {
        return None;
    }
    Some(column_by_column(&rows, tokens.first()?.span))
}

/// The tokens of the rows with one pair of columns behind the other.
fn column_by_column(rows: &[Vec<&[Token]>], at: Span) -> Vec<Token> {
    let columns = rows.iter().map(|row| row.len().div_ceil(2)).max().unwrap_or(0);
    let mut out = Vec::new();
    for column in 0..columns {
        for row in rows {
            out.push(Token::new(TokenKind::Line, at));
            out.extend(row.iter().skip(2 * column).take(2).flat_map(|cell| cell.iter().cloned()));
        }
    }
    out
}

/// Whether several solutions stand side by side: each begins with an expression in the first row and goes on with relations below it, and
/// the cells between them are empty.
fn are_solutions(rows: &[Vec<&[Token]>]) -> bool {
    let is_empty = |cell: &&[Token]| trim_space(cell).is_empty();
    let mut used = rows.iter().filter(|row| !row.iter().all(is_empty));
    let Some(first) = used.next() else { return false };
    let filled = |row: &Vec<&[Token]>, fits: fn(&[Token]) -> bool| {
        row.iter().enumerate().all(|(at, cell)| is_empty(cell) || at % 2 == 1 && fits(cell))
    };
    let starts = first.iter().filter(|cell| !is_empty(cell)).count();
    let rest: Vec<&Vec<&[Token]>> = used.collect();
    starts > 1
        && !rest.is_empty()
        && filled(first, |cell| !cell.iter().any(|token| token.is_one_of("=≈")))
        && rest.into_iter().all(|row| filled(row, begins_with_relation))
}
