//! The source line by line, so that nothing in it is passed over.
//!
//! The sources' sentences are not ours to print. What can be kept is the sequence of the numbers in each line, as a
//! fingerprint. The inventory names, in the order of the source, the claim that each number belongs to; the numbers
//! of those claims, strung together, must give the fingerprint. A digit that no claim accounts for, a claim with a
//! wrong digit and a claim that was dropped all change it.

use crate::{Claim, claim};

/// One line of the source's text.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// The line's number in the source's text, from 1.
    pub number: u32,
    /// Fingerprint of the sequence of numbers printed in the line; see [`fingerprint`].
    pub fingerprint: u64,
    /// What stands in it, in order.
    pub entries: &'static [Entry],
}

/// What stands in one place of a line.
#[derive(Clone, Copy, Debug)]
pub enum Entry {
    /// The claim with this id is made here. If its printed characters have dots (`\ldots`), as much as stands before.
    Claim(&'static str),
    /// What stands behind the n-th dots of the claim with this id, in the same line or in a later one; what the dots
    /// stand for are entries in between.
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
        /// Id, in the same name space as those of claims.
        id: &'static str,
        /// The numbers printed there, as they stand.
        numbers: &'static str,
        /// Why it is no claim.
        reason: &'static str,
    },
}

/// A letter of the source, and what this book writes instead.
#[derive(Clone, Copy, Debug)]
pub struct Symbol {
    /// The characters in the source.
    pub printed: &'static str,
    /// The book's symbol, in TeX.
    pub ours: &'static str,
    /// What it stands for.
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

    /// The numbers that the entry accounts for, in order.
    pub fn numbers(&self) -> Vec<String> {
        match self {
            Self::Claim(id) => claim(id).map_or_else(Vec::new, |claim| {
                numeric_tokens(piece(claim.printed, 0)).into_iter().chain(numeric_tokens(claim.unit)).collect()
            }),
            Self::Rest(id, dots) => {
                claim(id).map_or_else(Vec::new, |claim| numeric_tokens(piece(claim.printed, *dots)))
            }
            Self::Again(id) => claim(id).map_or_else(Vec::new, |claim| numeric_tokens(claim.printed)),
            Self::Reading(_) => Vec::new(),
            Self::Label(number) => numeric_tokens(number),
            Self::Exception { numbers, .. } => numeric_tokens(numbers),
        }
    }
}

/// What stands in a claim's printed characters for the number of another claim.
const DOTS: &str = r"\ldots";

/// What stands behind the n-th dots of a claim's printed characters; before the first ones for n = 0.
fn piece(printed: &str, dots: usize) -> &str {
    printed.split(DOTS).nth(dots).unwrap_or_default()
}

/// The printed characters of a claim, with the numbers of other claims in place of its dots, as the line has them.
pub fn in_full(of: &Claim) -> String {
    let mut full = of.printed.to_owned();
    let is_made = |entry: &&Entry| entry.claimed() == Some(of.id);
    let Some(line) = of.work.inventory().iter().find(|line| line.entries.iter().any(|entry| is_made(&entry))) else {
        return full;
    };
    let behind = line.entries.iter().skip_while(|entry| !is_made(entry)).skip(1);
    let mut filling = String::new();
    for entry in behind {
        match entry {
            Entry::Rest(id, _) if *id == of.id => full = full.replacen(DOTS, &std::mem::take(&mut filling), 1),
            entry => filling += &entry.numbers().join(" "),
        }
    }
    full
}

impl Line {
    /// Whether the entries account for exactly the numbers of the line.
    pub fn is_accounted_for(&self) -> bool {
        let numbers: Vec<_> = self.entries.iter().flat_map(Entry::numbers).collect();
        fingerprint(&numbers) == self.fingerprint
    }
}

/// The numbers in a text: runs of digits, with points and commas between digits.
pub fn numeric_tokens(text: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let run = &rest[start..];
        let end = run.find(|c: char| !matches!(c, '0'..='9' | '.' | ',')).unwrap_or(run.len());
        tokens.push(run[..end].trim_end_matches(['.', ',']).to_owned());
        rest = &run[end..];
    }
    tokens
}

/// A 64-bit FNV-1a hash of the numbers, joined by spaces.
pub fn fingerprint(numbers: &[String]) -> u64 {
    numbers
        .join(" ")
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_with_their_points_and_commas() {
        assert_eq!(numeric_tokens("x^{2} = 1,950 rad/s^2, or 0.5."), ["2", "1,950", "2", "0.5"]);
        assert!(numeric_tokens("no number, none.").is_empty());
    }

    #[test]
    fn dots_are_filled_with_the_numbers_between() {
        let of = claim("quick-return.projections").expect("a claim with dots");
        let full = in_full(of);
        assert!(!full.contains(DOTS) && numeric_tokens(&full).len() == 3, "{full}");
        let plain = claim("pin.pin-speed-equation").expect("a claim without dots");
        assert_eq!(in_full(plain), plain.printed);
    }

    #[test]
    fn the_fingerprint_is_the_published_hash() {
        assert_eq!(fingerprint(&[]), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fingerprint(&["a".to_owned()]), 0xaf63_dc4c_8601_ec8c);
        assert_ne!(fingerprint(&["1".into(), "2".into()]), fingerprint(&["2".into(), "1".into()]));
    }
}
