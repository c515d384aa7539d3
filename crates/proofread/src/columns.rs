//! Aligned equations side by side that go on in the rows below: each column of equations is read down.

use crate::token::{Kind, Token, trimmed};

/// The rows of a formula, each with its cells.
fn cells(tokens: &[Token]) -> Vec<Vec<&[Token]>> {
    let rows = tokens.split(|token| token.kind == Kind::Line);
    rows.map(|row| row.split(|token| token.kind == Kind::Cell).collect()).collect()
}

fn begins_with_relation(cell: &[Token]) -> bool {
    trimmed(cell).first().is_some_and(|first| first.is_one_of("=≈"))
}

/// Whether the second equation of a row goes on from the row above: nothing stands before its equals sign.
fn goes_on(row: &[&[Token]]) -> bool {
    row.len() >= 4 && trimmed(row[2]).is_empty() && begins_with_relation(row[3])
}

/// Whether a row has its relations where aligned equations have them, in every second cell.
fn is_aligned(row: &[&[Token]]) -> bool {
    row.iter().skip(1).step_by(2).all(|cell| trimmed(cell).is_empty() || begins_with_relation(cell))
}

/// The tokens with one column of equations behind the other, or none if there are no such columns.
pub(crate) fn read_down(tokens: &[Token]) -> Option<Vec<Token>> {
    if !tokens.iter().any(|token| token.kind == Kind::Cell) {
        return None;
    }
    let rows = cells(tokens);
    if !rows.iter().any(|row| goes_on(row)) || !rows.iter().all(|row| is_aligned(row)) {
        return None;
    }
    let columns = rows.iter().map(|row| row.len().div_ceil(2)).max().unwrap_or(0);
    let at = tokens.first()?.span;
    let mut out = Vec::with_capacity(tokens.len());
    for column in 0..columns {
        for row in &rows {
            out.push(Token::new(Kind::Line, at));
            out.extend(row.iter().skip(2 * column).take(2).flat_map(|cell| cell.iter().cloned()));
        }
    }
    Some(out)
}
