//! What stands on a card: names, numbers and signs, each with its columns.

use super::diagnostic::{Problem, is_unprintable};
use core::ops::Range;

/// A name, a number or a sign.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum CardToken {
    /// A name, in capitals.
    Name(String),
    /// A number.
    Number(f64),
    /// One of + − * / ( ) , =, and `^` for `**`.
    Sign(char),
}

/// A token and its columns, counted from 0.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlacedToken {
    pub(super) token: CardToken,
    pub(super) at: Range<usize>,
}

impl PlacedToken {
    /// Its name, if it is one.
    pub(super) fn name(&self) -> Option<&str> {
        if let CardToken::Name(name) = &self.token { Some(name) } else { None }
    }

    /// Whether it is this sign.
    pub(super) fn is(&self, sign: char) -> bool {
        self.token == CardToken::Sign(sign)
    }

    /// Whether it is one of these signs.
    pub(super) fn is_one_of(&self, signs: &[char]) -> bool {
        signs.iter().any(|sign| self.is(*sign))
    }

    /// As it is told in messages.
    pub(super) fn words(&self) -> String {
        match &self.token {
            CardToken::Name(name) => format!("the name {name}"),
            CardToken::Number(number) => format!("the number {number}"),
            CardToken::Sign('^') => "**".to_owned(),
            CardToken::Sign(sign) => sign.to_string(),
        }
    }
}

/// The tokens of some columns of a card, and what cannot be read of them.
pub(super) fn tokens(card: &[char], columns: Range<usize>) -> (Vec<PlacedToken>, Vec<(Range<usize>, Problem)>) {
    let (mut found, mut problems) = (Vec::new(), Vec::new());
    let mut at = columns.start;
    let end = columns.end.min(card.len());
    while at < end {
        let sign = card[at];
        if sign.is_whitespace() && !is_unprintable(sign) {
            at += 1;
            continue;
        }
        let start = at;
        let token = if sign.is_ascii_alphanumeric() || sign == '.' {
            at = word_end(card, start, end);
            let text: String = card[start..at].iter().collect::<String>().to_ascii_uppercase();
            let is_name =
                !text.contains('.') && text.chars().any(|sign| sign.is_ascii_alphabetic()) && !is_exponent(&text);
            if is_name {
                CardToken::Name(text)
            } else if let Some(number) = text.parse().ok().filter(|number: &f64| number.is_finite()) {
                CardToken::Number(number)
            } else {
                problems.push((start..at, Problem::Number(text)));
                CardToken::Number(1.0)
            }
        } else if sign == '*' && card.get(start + 1) == Some(&'*') && start + 1 < end {
            at = start + 2;
            CardToken::Sign('^')
        } else {
            at = start + 1;
            if !"+-*/(),=".contains(sign) {
                problems.push((start..at, Problem::Sign(sign)));
                continue;
            }
            CardToken::Sign(sign)
        };
        found.push(PlacedToken { token, at: start..at });
    }
    (found, problems)
}

/// Where the name or number that begins here ends. A sign behind an exponent's E belongs to it.
fn word_end(card: &[char], start: usize, end: usize) -> usize {
    let mut at = start;
    while at < end {
        let sign = card[at];
        let so_far = &card[start..at];
        let is_exponent_sign = (sign == '+' || sign == '-')
            && so_far.last().is_some_and(|last| last.eq_ignore_ascii_case(&'E'))
            && is_mantissa(&so_far[..so_far.len() - 1])
            && card.get(at + 1).filter(|_| at + 1 < end).is_some_and(char::is_ascii_digit);
        if !(sign.is_ascii_alphanumeric() || sign == '.' || is_exponent_sign) {
            break;
        }
        at += 1;
    }
    at
}

fn is_mantissa(text: &[char]) -> bool {
    text.iter().any(char::is_ascii_digit) && text.iter().all(|sign| sign.is_ascii_digit() || *sign == '.')
}

/// Whether it is an integer with an exponent, such as 5E3: no name is meant.
fn is_exponent(text: &str) -> bool {
    text.split_once('E').is_some_and(|(mantissa, exponent)| {
        let digits = |text: &str| !text.is_empty() && text.chars().all(|sign| sign.is_ascii_digit());
        digits(mantissa) && digits(exponent.trim_start_matches(['+', '-']))
    })
}
