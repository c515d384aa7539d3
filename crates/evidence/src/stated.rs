//! What is put to a route of a statement: the right form or a neighbour that is wrong, with the characters it is made of.

use crate::Decimal;
use crate::number_words::{next_number_word, number_in_word};
use std::ops::Range;

/// Which of two neighbouring statements is put to a route, and its characters. A check that cannot fail is not a check: a
/// route that accepts the right one must refuse the wrong one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stated<'a> {
    characters: &'a str,
    right: bool,
}

impl<'a> Stated<'a> {
    /// The one that is right, with the printed characters or, if these are wrong, with those of the correction.
    pub fn right(characters: &'a str) -> Self {
        Self { characters, right: true }
    }

    /// The one that is wrong, with the printed characters: the printed form if it is corrected, else a neighbour made for
    /// the purpose, which has them all the same.
    pub fn wrong(characters: &'a str) -> Self {
        Self { characters, right: false }
    }

    /// What the statement says differently from its neighbour: a sign, a row, an exponent, a relation.
    pub fn pick<T>(self, right: T, wrong: T) -> T {
        if self.right { right } else { wrong }
    }

    /// The characters: of the printed form, or of its correction.
    pub fn characters(self) -> &'a str {
        self.characters
    }

    /// The numbers of the characters, in digits or in words, in their order; without a sign. Digits beside a letter belong
    /// to a name, and those beside a hyphen and digits to a label.
    pub fn numbers(self) -> Vec<f64> {
        numbers_in(self.characters).into_iter().map(|(_, number)| number).collect()
    }

    /// Those in digits, with their places.
    pub fn decimals(self) -> Vec<Decimal> {
        numbers_in(self.characters).into_iter().filter_map(|(at, _)| decimal(&self.characters[at])).collect()
    }

    /// Whether these numbers round to those in digits, one by one, and there are no others.
    pub fn is_rounding_of(self, numbers: &[f64]) -> bool {
        let said = self.decimals();
        said.len() == numbers.len() && said.iter().zip(numbers).all(|(said, number)| said.is_rounding_of(*number))
    }

    /// The first of them; not a number if there is none.
    pub fn number(self) -> f64 {
        self.numbers().first().copied().unwrap_or(f64::NAN)
    }

    /// The first number as a count; zero if there is none that is an integer of at most ten thousand.
    pub fn count(self) -> u32 {
        let number = self.number();
        if number.fract() == 0.0 && number <= 1e4 { number as u32 } else { 0 }
    }
}

/// The numbers in a text, in digits or in words, and where they stand.
pub fn numbers_in(text: &str) -> Vec<(Range<usize>, f64)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(next) = text[at..].chars().next() {
        let rest = &text[at..];
        let of = |belongs: fn(char) -> bool| rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        let length = match next {
            'a'..='z' | 'A'..='Z' => of(|c| c.is_ascii_alphabetic()),
            '0'..='9' | '.' => of(|c| c.is_ascii_digit() || c == '.'),
            other => other.len_utf8(),
        };
        let piece = &rest[..length];
        let (before, behind) = (text[..at].chars().next_back(), rest[length..].chars().next());
        let number = if next.is_ascii_alphabetic() {
            number_in_word(piece)
        } else if is_named(text, at..at + length, before, behind) {
            None
        } else {
            decimal(piece).map(|decimal| decimal.to_f64())
        };
        found.extend(number.map(|number| (at..at + length, number)));
        at += length;
    }
    found
}

/// A number in digits; a point may end it.
fn decimal(piece: &str) -> Option<Decimal> {
    piece.trim_end_matches('.').parse().ok()
}

/// Whether digits are part of a name or of a label.
fn is_named(text: &str, at: Range<usize>, before: Option<char>, behind: Option<char>) -> bool {
    let letter = |c: Option<char>| c.is_some_and(|c| c.is_alphabetic() || c == '_');
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let label = (before == Some('-') && digit(text[..at.start].chars().nth_back(1)))
        || (behind == Some('-') && digit(text[at.end..].chars().nth(1)));
    letter(before) || letter(behind) || label
}

/// The next number in the same way of writing: another last digit, or the next word.
pub fn another(piece: &str) -> String {
    match next_number_word(piece) {
        Some(word) => word.to_owned(),
        None => {
            let last = piece.rfind(|c: char| c.is_ascii_digit()).unwrap_or(0);
            let digit = piece[last..].chars().next().and_then(|c| c.to_digit(10)).unwrap_or(0);
            format!("{}{}{}", &piece[..last], (digit + 1) % 10, &piece[last + 1..])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_in_digits_and_in_words_and_names_are_none() {
        let found = |text: &'static str| Stated::right(text).numbers();
        assert_eq!(found("-30° , -45° , or -60°"), [30.0, 45.0, 60.0]);
        assert_eq!(found("as many as Fifty turns, .283 of them"), [50.0, 0.283]);
        assert_eq!(found("INT(2DX,0.) of equation 1-18, P2 and \\omega_4"), [0.0]);
        assert!(found("someone, everyone").is_empty());
        assert_eq!(Stated::right("n=2").count(), 2);
    }

    #[test]
    fn another_number_is_written_in_the_same_way() {
        assert_eq!([another("two"), another("0.19"), another("100.")], ["three", "0.10", "101."]);
    }
}
