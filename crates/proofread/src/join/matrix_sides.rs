//! Sides that are matrices: sums, multiples and products of them as one expression for each entry.

use crate::join::chain::ChainSide;
use crate::token::{NamedOperation, Span, Token, TokenKind, any, trim_space};

/// An expression for each entry, in rows.
type Entries = Vec<Vec<Vec<Token>>>;

/// Most rows and columns.
const LARGEST: usize = 6;

/// Most tokens of all entries together.
const LONGEST: usize = 4000;

fn rows_of(token: &Token) -> Option<&[Vec<Token>]> {
    match &token.kind {
        TokenKind::Call(NamedOperation::Matrix, rows) => Some(rows),
        _ => None,
    }
}

/// Whether a side has a matrix outside of other things.
pub(crate) fn has_matrix(side: &ChainSide) -> bool {
    side.tokens.iter().any(|token| rows_of(token).is_some())
}

/// The rows of the matrix that is all of a side.
pub(crate) fn only_matrix(side: &ChainSide) -> Option<&[Vec<Token>]> {
    let mut solid = side.tokens.iter().filter(|token| !token.is_space() && !token.is_one_of("()[]"));
    solid.next().and_then(rows_of).filter(|_| solid.next().is_none())
}

/// Whether a side is a matrix in which a bar parts the columns of a system of equations from its right sides.
pub(crate) fn is_augmented(side: &ChainSide) -> bool {
    let has_bar = |row: &Vec<Token>| row.iter().any(|token| token.is_sign('|'));
    only_matrix(side).is_some_and(|rows| rows.iter().all(has_bar))
}

/// Whether all numbers in the matrices of a side are zeros and ones.
pub(crate) fn has_bits_alone(side: &ChainSide) -> bool {
    let is_other = |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if !matches!(&**digits, "0" | "1"));
    !any(&side.tokens, &is_other)
}

/// How two matrices are multiplied.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum MatrixProduct {
    /// Rows by columns.
    RowsByColumns,
    /// Entry by entry, as programs multiply arrays.
    EntryByEntry,
}

/// The entries of two sides in pairs, each at the place of its side; none if one is no expression in matrices, or their shapes differ.
pub(crate) fn paired_entries(
    left: &ChainSide,
    right: &ChainSide,
    multiply: MatrixProduct,
) -> Option<Vec<[ChainSide; 2]>> {
    let (of_left, of_right) = (expand(&left.tokens, multiply)?, expand(&right.tokens, multiply)?);
    let alike = of_left.len() == of_right.len() && of_left.iter().zip(&of_right).all(|(a, b)| a.len() == b.len());
    let side = |of: &ChainSide, tokens: Vec<Token>| ChainSide { relation: of.relation, tokens, span: of.span };
    let entries = of_left.into_iter().flatten().zip(of_right.into_iter().flatten());
    alike.then(|| entries.map(|(one, other)| [side(left, one), side(right, other)]).collect())
}

/// The entries of a sum of terms.
fn expand(side: &[Token], multiply: MatrixProduct) -> Option<Entries> {
    let mut sum: Option<Entries> = None;
    let (mut from, mut depth) = (0, 0usize);
    let mut sign = None;
    for at in 0..=side.len() {
        let token = side.get(at);
        if let Some(token) = token {
            depth += usize::from(token.is_one_of("([{"));
            depth = depth.saturating_sub(usize::from(token.is_one_of(")]}")));
        }
        // A sign behind that of a product is the sign of a factor.
        let is_of_factor = trim_space(&side[..at]).last().is_some_and(|before| before.is_one_of("·×*"));
        if token.is_some_and(|token| depth > 0 || is_of_factor || !token.is_one_of("+-")) {
            continue;
        }
        let term = trim_space(&side[from..at]);
        if !(term.is_empty() && sum.is_none() && token.is_some()) {
            let entries = product(term, multiply)?;
            sum = Some(match sum {
                None if sign == Some('-') => joined(None, '-', &entries)?,
                None => entries,
                Some(so_far) => joined(Some(&so_far), sign?, &entries)?,
            });
        }
        sign = token.map(|token| if token.is_sign('-') { '-' } else { '+' });
        from = at + 1;
    }
    sum.filter(|entries| entries.iter().flatten().map(Vec::len).sum::<usize>() <= LONGEST)
}

fn sign_at(sign: char, near: &[Token]) -> Token {
    Token::new(TokenKind::Operator(sign), near.first().map_or(Span::default(), |token| token.span))
}

/// Tokens in brackets, unless they are one number.
fn bracketed(tokens: &[Token]) -> Vec<Token> {
    match tokens {
        [one] if one.number().is_some() => tokens.to_vec(),
        _ => [&[sign_at('(', tokens)], tokens, &[sign_at(')', tokens)]].concat(),
    }
}

fn joined(one: Option<&Entries>, sign: char, other: &Entries) -> Option<Entries> {
    let alike = |one: &Entries| one.len() == other.len() && one.iter().zip(other).all(|(a, b)| a.len() == b.len());
    if one.is_some_and(|one| !alike(one)) {
        return None;
    }
    let entry = |row: usize, column: usize| {
        let behind = &other[row][column];
        let before = one.map(|one| &one[row][column]);
        let before = before.map(|of| if sign == '·' { bracketed(of) } else { of.clone() }).unwrap_or_default();
        [before.as_slice(), &[sign_at(sign, behind)], &bracketed(behind)].concat()
    };
    Some(other.iter().enumerate().map(|(row, of)| (0..of.len()).map(|column| entry(row, column)).collect()).collect())
}

/// The entries of a product of numbers and matrices.
fn product(term: &[Token], multiply: MatrixProduct) -> Option<Entries> {
    let mut product: Option<Entries> = None;
    let mut scalar: Vec<Token> = Vec::new();
    let mut at = 0;
    while let Some(token) = term.get(at) {
        // The brackets of a matrix are no brackets of its own.
        let is_wrapped = token.is_one_of("([")
            && term.get(at + 1).is_some_and(|inner| rows_of(inner).is_some())
            && term.get(at + 2).is_some_and(|close| close.is_one_of(")]"));
        let matrix = if is_wrapped { &term[at + 1] } else { token };
        let Some(rows) = rows_of(matrix) else {
            let between = product.is_some();
            if between && !(token.is_space() || token.is_one_of("·×")) {
                return None;
            }
            if !between {
                scalar.push(token.clone());
            }
            at += 1;
            continue;
        };
        at += if is_wrapped { 3 } else { 1 };
        let matrix = cells(rows)?;
        let mut power = 1;
        if let Some(Token { kind: TokenKind::Power(exponent), .. }) = term.get(at) {
            power = match exponent.as_slice() {
                [number] if number.number() == Some("2") => 2,
                _ => return None,
            };
            at += 1;
        }
        for _ in 0..power {
            product = Some(match &product {
                None => matrix.clone(),
                Some(before) if multiply == MatrixProduct::EntryByEntry => joined(Some(before), '·', &matrix)?,
                Some(before) => multiplied(before, &matrix)?,
            });
        }
    }
    while scalar.last().is_some_and(|last| last.is_space() || last.is_one_of("·×")) {
        scalar.pop();
    }
    let entries = product?;
    if scalar.is_empty() {
        return Some(entries);
    }
    let times = |entry: &Vec<Token>| [&bracketed(&scalar), &[sign_at('·', entry)][..], &bracketed(entry)].concat();
    Some(entries.iter().map(|row| row.iter().map(times).collect()).collect())
}

/// The cells of the rows, all of one length.
fn cells(rows: &[Vec<Token>]) -> Option<Entries> {
    let split = |row: &Vec<Token>| -> Vec<Vec<Token>> {
        row.split(|token| token.kind == TokenKind::Cell).map(|cell| trim_space(cell).to_vec()).collect()
    };
    let out: Entries = rows.iter().map(split).collect();
    let columns = out.first()?.len();
    let fits = out.len() <= LARGEST && columns <= LARGEST && out.iter().all(|row| row.len() == columns);
    (fits && out.iter().flatten().all(|cell| !cell.is_empty())).then_some(out)
}

fn multiplied(one: &Entries, other: &Entries) -> Option<Entries> {
    let inner = other.len();
    if one.iter().any(|row| row.len() != inner) {
        return None;
    }
    let columns = other.first()?.len();
    let entry = |row: &Vec<Vec<Token>>, column: usize| {
        let mut sum: Vec<Token> = Vec::new();
        for (a, b) in row.iter().zip(other.iter().map(|of| &of[column])) {
            if !sum.is_empty() {
                sum.push(sign_at('+', a));
            }
            sum.extend(bracketed(a));
            sum.push(sign_at('·', b));
            sum.extend(bracketed(b));
        }
        sum
    };
    let out: Entries = one.iter().map(|row| (0..columns).map(|column| entry(row, column)).collect()).collect();
    (out.iter().flatten().map(Vec::len).sum::<usize>() <= LONGEST).then_some(out)
}
