//! Whether the claims of a document account for all numbers that a line of it prints.

use crate::inventory::numbers_in_unit;
use crate::{Claim, Document, Entry, Line, joined_or_none, number_tokens};

/// The characters that take the place of another claim's number in a claim's printed characters.
const DOTS: &str = r"\ldots";

/// The numbers that an entry of a line accounts for, in order.
pub fn entry_numbers(document: &'static Document, entry: &Entry) -> Vec<String> {
    let claim = |id: &str| document.claim(id);
    match entry {
        Entry::Claim(id) => claim(id).map_or_else(Vec::new, |claim| {
            number_tokens(piece(claim.printed, 0)).into_iter().chain(numbers_in_unit(claim.unit)).collect()
        }),
        Entry::Rest(id, dots) => claim(id).map_or_else(Vec::new, |claim| number_tokens(piece(claim.printed, *dots))),
        Entry::Again(id) => claim(id).map_or_else(Vec::new, |claim| number_tokens(claim.printed)),
        Entry::Reading(_) => Vec::new(),
        Entry::Label(number) => number_tokens(number),
        Entry::Exception { numbers, .. } => numbers.clone(),
    }
}

/// Where the entries of a line and the numbers printed in it part, in words; none if the entries account for exactly these
/// numbers.
pub fn line_gap(document: &'static Document, line: &Line) -> Option<String> {
    let mut ahead = &line.numbers[..];
    for entry in &line.entries {
        let numbers = entry_numbers(document, entry);
        match ahead.strip_prefix(&numbers[..]) {
            Some(behind) => ahead = behind,
            None => return Some(apart(entry, &numbers, ahead)),
        }
    }
    (!ahead.is_empty()).then(|| format!("no entry accounts for {}", joined_or_none(ahead)))
}

/// The numbers of a line that its entries leave over, in their order. An entry may skip numbers that no entry accounts for yet.
///
/// # Errors
///
/// In words, the first entry whose numbers are not in the line behind those of the entries before it.
pub fn numbers_left(document: &'static Document, line: &Line) -> Result<Vec<String>, String> {
    let (mut ahead, mut left) = (&line.numbers[..], Vec::new());
    for entry in &line.entries {
        let numbers = entry_numbers(document, entry);
        let mut places = 0..=ahead.len().saturating_sub(numbers.len());
        let Some(at) = places.find(|at| ahead[*at..].starts_with(&numbers)) else {
            return Err(apart(entry, &numbers, ahead));
        };
        // What says no number stands anywhere.
        let skipped = if numbers.is_empty() { 0 } else { at };
        left.extend_from_slice(&ahead[..skipped]);
        ahead = &ahead[skipped + numbers.len()..];
    }
    left.extend_from_slice(ahead);
    Ok(left)
}

/// How an entry differs from what the line has in its place.
fn apart(entry: &Entry, numbers: &[String], ahead: &[String]) -> String {
    format!("{entry} has {}, the line there {}", joined_or_none(numbers), joined_or_none(ahead))
}

/// What comes after the n-th dots of a claim's printed characters; before the first ones for n = 0.
fn piece(printed: &str, dots: usize) -> &str {
    printed.split(DOTS).nth(dots).unwrap_or_default()
}

/// The printed characters of a claim, with the numbers of other claims in place of its dots, as the line has them.
pub fn without_ellipses(claim: &Claim) -> String {
    let mut full = claim.printed.to_owned();
    let is_made = |entry: &&Entry| entry.claimed() == Some(claim.id);
    let lines = claim.document.lines().unwrap_or_default();
    let Some(line) = lines.iter().find(|line| line.entries.iter().any(|entry| is_made(&entry))) else {
        return full;
    };
    let behind = line.entries.iter().skip_while(|entry| !is_made(entry)).skip(1);
    let mut filling = String::new();
    for entry in behind {
        match entry {
            Entry::Rest(id, _) if *id == claim.id => full = full.replacen(DOTS, &std::mem::take(&mut filling), 1),
            entry => filling += &entry_numbers(claim.document, entry).join(" "),
        }
    }
    full
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cache, InventoryFile, Locator};

    /// A sum of two printed numbers, in one line.
    static SUM: Document = Document {
        slug: "sum",
        title: "sum",
        citation: "A sum",
        inventory: Some(InventoryFile {
            path: "sum.inventory",
            text: "# A sum.\n\nline 1: 2 0.5 5.3\n  claim sum.sum\n  claim sum.first\n  rest sum.sum 1\n  label 5.3\n",
        }),
        claims: || {
            let here = Locator::new(&SUM, "line 1");
            vec![
                here.equation("sum.sum", r"2 + \ldots = 0.5", "the sum").missing("made up"),
                here.value("sum.first", "1", "", "a number").missing("made up"),
            ]
        },
        answers: &[],
        given: Vec::new,
        conclusions: &[],
        symbols: &[],
        units: &[],
        test: "",
        cache: Cache::new(),
    };

    #[test]
    fn dots_are_filled_with_the_numbers_between() {
        let [sum, first] = ["sum.sum", "sum.first"].map(|id| SUM.lookup(id));
        assert_eq!((without_ellipses(sum), without_ellipses(first)), ("2 + 1 = 0.5".to_owned(), "1".to_owned()));
    }

    #[test]
    fn a_gap_is_where_the_entries_and_the_numbers_part() {
        let gap = |numbers, entries| line_gap(&SUM, &Line { number: 1, numbers: number_tokens(numbers), entries });
        let labels = || vec![Entry::Label("1-2"), Entry::Label("5.3")];
        assert_eq!(gap("1 2 5.3", labels()), None);
        assert_eq!(gap("1 2 5.4", labels()).as_deref(), Some("label 5.3 has 5.3, the line there 5.4"));
        assert_eq!(gap("1", labels()).as_deref(), Some("label 1-2 has 1 2, the line there 1"));
        assert_eq!(gap("1 2 5.3 7", labels()).as_deref(), Some("no entry accounts for 7"));
        assert_eq!(gap("1 2", vec![Entry::Claim("none"), Entry::Label("1-2")]), None);
        let left = |numbers, entries| numbers_left(&SUM, &Line { number: 1, numbers: number_tokens(numbers), entries });
        assert_eq!(left("1 2 5.3", labels()), Ok(Vec::new()));
        assert_eq!(left("7 1 2 8 5.3 9", labels()), Ok(number_tokens("7 8 9")));
        assert_eq!(left("5.3 1 2", labels()), Err("label 5.3 has 5.3, the line there none".to_owned()));
        assert_eq!(left("1", labels()), Err("label 1-2 has 1 2, the line there 1".to_owned()));
        assert_eq!(left("4 1 2", vec![Entry::Claim("none"), Entry::Label("1-2")]), Ok(number_tokens("4")));
        assert_eq!(left("4", Vec::new()), Ok(number_tokens("4")));
        let lines = SUM.lines().expect("an inventory");
        assert_eq!(line_gap(&SUM, &lines[0]).as_deref(), Some("claim sum.first has 1, the line there 0.5 5.3"));
    }
}
