//! The source line by line, so that nothing in it is passed over.
//!
//! The sources' sentences are not ours to print. What can be kept are the numbers in each line, in digits and in words, in
//! their order. The inventory names, in the order of the source, the claim that each number belongs to; the numbers of
//! those claims, strung together, must be those of the line. A digit or a number word that no claim accounts for, a claim
//! with a wrong digit and a claim that was dropped all make a difference.

use crate::number_words::number_in_word;
use std::fmt;

/// One line of the source's text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The line's number in the source's text, from 1.
    pub number: u32,
    /// The numbers printed in it, in order; see [`number_tokens`].
    pub numbers: Vec<String>,
    /// What the line contains, in order.
    pub entries: Vec<Entry>,
}

/// What one place of a line contains.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Entry {
    /// The claim with this id is made here. If its printed characters have dots (`\ldots`), this covers what comes
    /// before them.
    Claim(&'static str),
    /// What comes after the n-th dots of the claim with this id, in the same line or in a later one. Entries in between
    /// account for the dots themselves.
    Rest(&'static str, usize),
    /// The number of the claim with this id is printed here once more.
    Again(&'static str),
    /// The claim with this id is made here too, about numbers that another entry accounts for.
    Reading(&'static str),
    /// The number of an equation or figure, which names it or refers to it. Some claim's locator must bear it.
    Label(&'static str),
    /// No claim: an id of its own, the numbers printed there, and why nothing is to be checked.
    ///
    /// It expires: as soon as a claim bears the id, the entry is no longer needed, and the coverage test says so.
    Exception {
        /// Id, in the same name space as the ids of claims.
        id: &'static str,
        /// The numbers printed there, as printed.
        numbers: Vec<String>,
        /// Why it is no claim.
        reason: String,
    },
}

/// A letter of the source, and what this book writes instead.
#[derive(Clone, Copy, Debug)]
pub struct Symbol {
    /// The characters in the source.
    pub printed: &'static str,
    /// The book's symbol, in TeX.
    pub ours: &'static str,
    /// What it means, or of a letter of the whole book what else is to be said; may be empty.
    pub meaning: &'static str,
}

impl Entry {
    /// The id of the claim that is made here, if one is.
    pub fn claimed(&self) -> Option<&'static str> {
        match self {
            Self::Claim(id) | Self::Reading(id) => Some(id),
            Self::Rest(..) | Self::Again(_) | Self::Label(_) | Self::Exception { .. } => None,
        }
    }
}

impl fmt::Display for Entry {
    /// The entry as written in the inventory file, without the numbers and the reason of an exception.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Claim(id) => write!(f, "claim {id}"),
            Self::Rest(id, dots) => write!(f, "rest {id} {dots}"),
            Self::Again(id) => write!(f, "again {id}"),
            Self::Reading(id) => write!(f, "reading {id}"),
            Self::Label(number) => write!(f, "label {number}"),
            Self::Exception { id, .. } => write!(f, "exception {id}"),
        }
    }
}

/// Numbers with spaces between, or that there are none.
pub fn joined_or_none(numbers: &[String]) -> String {
    if numbers.is_empty() { "none".to_owned() } else { numbers.join(" ") }
}

/// The numbers in a text, in their order: runs of digits, with points and commas between digits, raised digits as if they
/// were not raised; fractions that are one character; and words that say a number, in small letters.
pub fn number_tokens(text: &str) -> Vec<String> {
    printed_numbers(text).map(|printed| lowered(printed).map_or(printed.to_lowercase(), str::to_owned)).collect()
}

/// The numbers in a text that are in digits and not raised: runs of digits, with points and commas between digits.
pub fn numeric_tokens(text: &str) -> Vec<String> {
    let in_digits = |printed: &&str| printed.starts_with(|c: char| c.is_ascii_digit());
    printed_numbers(text).filter(in_digits).map(str::to_owned).collect()
}

/// The numbers in a text as they are printed, in digits, in characters of their own and in words.
fn printed_numbers(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    let pieces = std::iter::from_fn(move || {
        let next = rest.chars().next()?;
        let length = match next {
            '0'..='9' => digits_at_the_start(rest),
            _ if is_letter(next) => rest.find(|c| !is_letter(c)).unwrap_or(rest.len()),
            other => other.len_utf8(),
        };
        let (piece, behind) = rest.split_at(length);
        rest = behind;
        Some(piece)
    });
    let is_number = |piece: &&str| piece.starts_with(char::is_numeric) || number_in_word(piece).is_some();
    pieces.filter(is_number).map(|piece| piece.trim_end_matches(['.', ',']))
}

/// Whether a character belongs to a word. A Roman numeral that is one character is a number.
fn is_letter(c: char) -> bool {
    c.is_alphabetic() && !c.is_numeric()
}

/// A raised digit as if it were not raised.
fn lowered(printed: &str) -> Option<&'static str> {
    const RAISED: [(&str, &str); 10] = [
        ("⁰", "0"),
        ("¹", "1"),
        ("²", "2"),
        ("³", "3"),
        ("⁴", "4"),
        ("⁵", "5"),
        ("⁶", "6"),
        ("⁷", "7"),
        ("⁸", "8"),
        ("⁹", "9"),
    ];
    RAISED.iter().find(|(raised, _)| *raised == printed).map(|(_, digit)| *digit)
}

/// The numbers in a unit. Its words say none: a second is a time there.
pub(crate) fn numbers_in_unit(unit: &str) -> impl Iterator<Item = String> {
    number_tokens(unit).into_iter().filter(|token| number_in_word(token).is_none())
}

/// How long a run of digits at the start of a text is, with its points and commas.
fn digits_at_the_start(text: &str) -> usize {
    let end = text.find(|c: char| !matches!(c, '0'..='9' | '.' | ',')).unwrap_or(text.len());
    // Behind a point a comma parts two numbers.
    text[..end].find(".,").unwrap_or(end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_with_their_points_and_commas() {
        assert_eq!(numeric_tokens("x^{2} = 1,950 rad/s^2, or 0.5."), ["2", "1,950", "2", "0.5"]);
        assert_eq!(numeric_tokens("FSW(F,-1.,1.,1.)"), ["1", "1", "1"]);
        assert!(numeric_tokens("no number, none, or two of them, squared: ²").is_empty());
    }

    #[test]
    fn numbers_are_found_in_words_and_in_raised_digits_too() {
        let found = number_tokens("The FIRST 2 of three-quarters, 1.5 lb/in³ and ½; both second.");
        assert_eq!(found, ["first", "2", "three", "quarters", "1.5", "3", "½", "both", "second"]);
        assert_eq!(number_tokens("2DX of eq. 1-18,4 at 0.2,1"), ["2", "1", "18,4", "0.2,1"]);
        assert!(number_tokens("in seconds, to someone or none, in chapter II").is_empty());
        assert_eq!(numbers_in_unit("× 10^-6 in lb sec² per second").collect::<Vec<_>>(), ["10", "6", "2"]);
    }
}
