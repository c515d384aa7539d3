//! Values that are not meant as the value of what stands before them: those among which a reader chooses, approximations of another kind than by
//! digits, and the logarithm of a number.

use crate::join::chain::{ChainSide, Relation};
use crate::judge::substitution::without_space;
use crate::judge::surroundings::{speaks_around, text_before};
use crate::judge::verdict::PairJudgement;
use crate::token::{MathFunction, Token, TokenKind, any};

/// How far around a formula the same expression is looked for, in bytes.
const AROUND: usize = 500;

/// How many values an expression has where a reader chooses among them.
const CHOICES: usize = 3;

/// How far a linear approximation is from the value at most, relative to it.
const LINEAR: f64 = 0.05;

/// Whether the text close by has at least three different numbers behind the same expression: `ln(1.1) ≈ 2.1`, `ln(1.1) ≈ 1.1`, `ln(1.1) ≈ 0.1`.
pub(super) fn is_one_of_choices(text: &str, left: &ChainSide, right: &ChainSide) -> bool {
    let (start, end) = (left.span.start as usize, right.span.start as usize);
    // With its relation, up to the number.
    let Some(expression) = text.get(start..end).filter(|of| of.len() > 3 && !of.contains('\n')) else { return false };
    let computes = |kind: &TokenKind| !matches!(kind, TokenKind::Number(_) | TokenKind::Space(_));
    if !any(&left.tokens, &computes) || expression.len() > AROUND / CHOICES {
        return false;
    }
    let from = text.ceil_char_boundary(start.saturating_sub(AROUND));
    let to = text.floor_char_boundary((end + AROUND).min(text.len()));
    let near = text.get(from..to).unwrap_or_default();
    let mut values: Vec<&str> = Vec::new();
    for (at, _) in near.match_indices(expression).take(2 * CHOICES) {
        let rest = near[at + expression.len()..].trim_start();
        let length = rest.find(|c: char| !(c.is_ascii_digit() || "-−.,".contains(c))).unwrap_or(rest.len());
        let value = rest[..length].trim_end_matches(['.', ',']);
        if !value.is_empty() && !values.contains(&value) {
            values.push(value);
        }
    }
    values.len() >= CHOICES
}

/// Whether the text approximates a function or a root by its tangent, so that the value behind ≈ has digits of its own: √4.5 ≈ 2.125.
pub(super) fn is_linear_approximation(
    text: &str,
    left: &ChainSide,
    right: &ChainSide,
    judgement: &PairJudgement,
) -> bool {
    const WORDS: [&str; 7] = [
        "linear approximation",
        "linearization",
        "linearisation",
        "linearise",
        "linearize",
        "tangent line",
        "differentials",
    ];
    let is_function =
        |kind: &TokenKind| matches!(kind, TokenKind::Function(_) | TokenKind::Root(..) | TokenKind::Power(_));
    right.relation == Some(Relation::Approximate)
        && any(&left.tokens, &is_function)
        && judgement.values.as_ref().is_some_and(|(left, right)| left.meets(right, LINEAR))
        && (speaks_around(text, left.span.join(right.span), &WORDS) || {
            let before = text_before(text, left.span).to_ascii_lowercase();
            WORDS.iter().any(|word| before.contains(word))
        })
}

/// Whether the right side is the logarithm of the left one, as it is printed there, behind a sloppy sign: `0.21 = ln(0.21) = −1.56`.
pub(super) fn leads_to_logarithm(left: &[Token], right: &[Token]) -> bool {
    let (left, right) = (without_space(left), without_space(right));
    let [number] = left.as_slice() else { return false };
    let is_logarithm = |token: &Token| {
        matches!(token.kind, TokenKind::Function(MathFunction::Ln | MathFunction::Log | MathFunction::Lg))
    };
    let inside = match right.as_slice() {
        [function, open, inside, close] if is_logarithm(function) && open.is_sign('(') && close.is_sign(')') => inside,
        [function, inside] if is_logarithm(function) => inside,
        _ => return false,
    };
    number.number().is_some() && number.number() == inside.number()
}
