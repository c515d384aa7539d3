//! Words in products and quotients of quantities that are no units: what a quantity is of, `1\text{ mol Al}`, and what is counted,
//! `25\text{ units/mL}`.
//!
//! A word behind a unit is a label. One behind a number is counted, and cancels as a unit does. Both are read so only if the chain makes
//! sense with them: all its sides with units are of one dimension and count the same things.

use crate::evaluate::value::{Literal, SideValue};
use crate::join::chain::{Chain, ChainSide};
use crate::judge::counted_nouns::{may_be_counted, without_counted_nouns};
use crate::judge::verdict::evaluate_freely;
use crate::token::{Token, TokenKind, any, has_number};
use crate::unit::{COUNTED, counted, unit};

/// Most words behind a unit that are one label.
const MOST_LABELS: usize = 3;

/// Letters from which on a word behind a number is hardly the sign of a quantity.
const SHORTEST: usize = 3;

/// Words that say where something is, when, or how it is related to others, and not what it is of.
const RELATIONS: &str = " per of to for and or in at the by is are from with on so then if each every than as not north south east west \
    up down left right upward upwards downward downwards forward backward before after ago late later early earlier northward \
    southward eastward westward northeast northwest southeast southwest clockwise counterclockwise gauge absolute over under mod \
    force ";

/// How often each thing is counted in a side, below a stroke less than not at all.
type Counts = Vec<(String, i32)>;

fn last_solid(tokens: &[Token]) -> Option<usize> {
    tokens.iter().rposition(|token| !token.is_space())
}

fn is_unit(token: &Token) -> bool {
    token.word().is_some_and(|word| unit(word).is_some())
}

/// Whether terms are added anywhere in these tokens, which is no sign before a number.
fn adds(tokens: &[Token]) -> bool {
    let mut before: Option<&Token> = None;
    tokens.iter().filter(|token| !token.is_space()).any(|token| {
        let follows = before.replace(token).is_some_and(|before| !before.is_one_of("(+-·×/"));
        let is_inner = !matches!(token.kind, TokenKind::Power(_)) && token.inner().any(adds);
        (follows && token.is_one_of("+-")) || is_inner
    })
}

/// The words without those that are labels, and with the others as what is counted; none if a word is neither.
fn without_labels(tokens: &[Token], is_below: bool, counts: &mut Counts) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut labels = 0;
    for token in tokens {
        if let TokenKind::Fraction(above, below) = &token.kind {
            let above = without_labels(above, is_below, counts)?;
            let below = without_labels(below, !is_below, counts)?;
            out.push(Token::new(TokenKind::Fraction(above, below), token.span));
            labels = 0;
            continue;
        }
        let Some(word) = token.word().filter(|word| unit(word).is_none()) else {
            labels = if token.is_space() { labels } else { 0 };
            out.push(token.clone());
            continue;
        };
        let lower = word.to_ascii_lowercase();
        let is_relation = RELATIONS.split_ascii_whitespace().any(|known| known == lower);
        if is_relation || !may_be_counted(word) {
            return None;
        }
        let at = last_solid(&out)?;
        let before = at.checked_sub(1).and_then(|at| last_solid(&out[..=at]));
        let behind_power =
            matches!(out[at].kind, TokenKind::Power(_)) && before.is_some_and(|before| is_unit(&out[before]));
        if is_unit(&out[at]) || behind_power {
            labels += 1;
            if labels > MOST_LABELS {
                return None;
            }
            out.truncate(at + 1);
            continue;
        }
        if word.chars().count() < SHORTEST && lower != "qt" {
            return None;
        }
        let divides = out[at].is_sign('/') && before.is_some_and(|before| is_unit(&out[before]));
        let is_number = out[at].number().is_some() && !before.is_some_and(|before| out[before].is_sign('/'));
        if !divides && !is_number {
            return None;
        }
        let thing = lower.strip_suffix('s').unwrap_or(&lower).to_owned();
        let count = if divides == is_below { 1 } else { -1 };
        match counts.iter_mut().find(|(of, _)| *of == thing) {
            Some((_, sum)) => *sum += count,
            None => counts.push((thing, count)),
        }
        out.push(Token::new(TokenKind::Word(counted(word)), token.span));
    }
    Some(out)
}

/// A chain without the words that count or label its numbers, if it makes sense so.
pub(crate) fn without_words(chain: &Chain) -> Option<Chain> {
    without_counted_nouns(chain).or_else(|| without_cancelled_words(chain))
}

/// A chain without the labels in it, and with what is counted as units, if it makes sense so.
fn without_cancelled_words(chain: &Chain) -> Option<Chain> {
    let is_other = |kind: &TokenKind| matches!(kind, TokenKind::Word(word) if unit(word).is_none());
    if !chain.sides.iter().any(|side| has_number(&side.tokens) && any(&side.tokens, &is_other)) {
        return None;
    }
    let mut sides = Vec::with_capacity(chain.sides.len());
    let mut values: Vec<(SideValue, Counts)> = Vec::new();
    for side in &chain.sides {
        if !has_number(&side.tokens) {
            sides.push(side.clone());
            continue;
        }
        let mut counts = Counts::new();
        let tokens = without_labels(&side.tokens, false, &mut counts)?;
        // In a sum, each term counts something.
        if !counts.is_empty() && adds(&tokens) {
            return None;
        }
        counts.retain(|(_, count)| *count != 0);
        counts.sort_unstable();
        values.push((evaluate_freely(&tokens, None).ok()?, counts));
        sides.push(ChainSide { tokens, ..side.clone() });
    }
    let ((result, of_result), computed) = values.split_last()?;
    let computes = computed.iter().any(|(value, _)| value.literal == Literal::No && value.has_unit);
    if result.literal != Literal::Number || !result.has_unit || !computes {
        return None;
    }
    let fits = |(value, counts): &(SideValue, Counts)| {
        // What the result is for one of: MeV/nucleon.
        let for_one = || {
            counts.is_empty()
                && !result.dimension.is_none()
                && of_result.iter().all(|(_, count)| *count == -1)
                && !sides.iter().rev().skip(1).any(|side| {
                    any(&side.tokens, &|kind| matches!(kind, TokenKind::Word(word) if word.starts_with(COUNTED)))
                })
        };
        !value.has_unit || value.dimension == result.dimension && (counts == of_result || for_one())
    };
    computed.iter().all(fits).then(|| Chain { sides, ..chain.clone() })
}
