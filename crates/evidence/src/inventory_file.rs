//! The inventory files of the sources: how they are read, and written anew from a copy of the source.
//!
//! A file begins with a comment that ends with an empty line. Then each line of the source that says something has a
//! block, in the order of the source: the line's number and the numbers printed in it, in digits or in words, and indented
//! by two spaces its entries, as [`Entry`] has them. A reason that is too long goes on in the next line, indented by four.
//!
//! ```text
//! # A comment.
//! line 31: 2 4.5 5-26
//!   claim sum.some-equation
//!   again sum.some-length
//!   rest sum.some-equation 1
//!   label 5-26
//!   reading sum.another-way-to-read-the-equation
//!   exception sum.names: names of the two links
//!   exception sum.marks (2 4): marks to be had for the answer
//! line 32
//!   claim sum.some-statement-without-numbers
//! ```

use crate::inventory::{Entry, Line, number_tokens};
use std::collections::BTreeMap;
use thiserror::Error;

/// The inventory file of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InventoryFile {
    /// Where it is, from the root of the workspace, for messages.
    pub path: &'static str,
    /// Its text.
    pub text: &'static str,
}

/// Where an inventory file cannot be read, and why.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{file}, line {line}: {fault}")]
pub struct Malformed {
    /// The file, from the root of the workspace.
    pub file: &'static str,
    /// The line of the file, from 1.
    pub line: usize,
    /// What is wrong there.
    pub fault: Fault,
}

/// What is wrong in a line of an inventory file.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Fault {
    /// A line that is not indented.
    #[error(
        "`{0}` opens no line of the source; write `line NUMBER` or `line NUMBER: NUMBERS`, and a comment behind `#`"
    )]
    NoLine(String),
    /// A line of the source that does not come later than the one before.
    #[error("line {0} stands behind line {1}; the lines stand in the order of the source, each once")]
    OutOfOrder(u32, u32),
    /// What should be numbers.
    #[error(
        "`{0}` are not numbers with single spaces between; a number is digits, with points and commas between digits, or \
         a word in small letters that says a number, such as `two`"
    )]
    NoNumbers(String),
    /// A word that no entry begins with, or an entry with too few or too many words.
    #[error(
        "`{0}` is no entry; write `claim ID`, `reading ID`, `again ID`, `rest ID DOTS` with the dots counted from 1, \
         `label NUMBER`, `exception ID: REASON` or `exception ID (NUMBERS): REASON`"
    )]
    NoEntry(String),
    /// The id of another source.
    #[error("`{0}` is not of this source; its ids begin with `{1}.`")]
    OfAnotherSource(String, &'static str),
    /// An entry before the first line of the source.
    #[error("`{0}` stands in no line of the source; open one with `line NUMBER` or `line NUMBER: NUMBERS`")]
    InNoLine(String),
    /// Indented as the rest of a reason.
    #[error("`{0}` continues no reason; only an exception's goes on, and an entry is indented by two spaces")]
    NoReason(String),
}

/// The lines of the source with this slug, from its inventory file.
pub(crate) fn parse(slug: &'static str, file: InventoryFile) -> Result<Vec<Line>, Malformed> {
    let mut lines: Vec<Line> = Vec::new();
    for (at, row) in file.text.lines().enumerate() {
        let malformed = |fault| Malformed { file: file.path, line: at + 1, fault };
        add(&mut lines, slug, row).map_err(malformed)?;
    }
    Ok(lines)
}

/// Adds what a row of the file says to the lines of the source.
fn add(lines: &mut Vec<Line>, slug: &'static str, row: &'static str) -> Result<(), Fault> {
    let words = row.trim();
    if words.is_empty() || words.starts_with('#') {
        return Ok(());
    }
    if !row.starts_with(' ') {
        let line = header(row)?;
        if let Some(before) = lines.last().filter(|before| before.number >= line.number) {
            return Err(Fault::OutOfOrder(line.number, before.number));
        }
        lines.push(line);
        return Ok(());
    }
    let line = lines.last_mut().ok_or_else(|| Fault::InNoLine(words.to_owned()))?;
    if row.starts_with("    ") {
        let Some(Entry::Exception { reason, .. }) = line.entries.last_mut() else {
            return Err(Fault::NoReason(words.to_owned()));
        };
        reason.push(' ');
        reason.push_str(words);
    } else {
        line.entries.push(entry(words, slug)?);
    }
    Ok(())
}

/// The line of the source that a row opens.
fn header(row: &str) -> Result<Line, Fault> {
    let no_line = || Fault::NoLine(row.to_owned());
    let opened = row.strip_prefix("line ").ok_or_else(no_line)?;
    let (number, printed) = opened.split_once(": ").unwrap_or((opened, ""));
    let number = number.parse().ok().filter(|number| *number > 0).ok_or_else(no_line)?;
    Ok(Line { number, numbers: numbers(printed)?, entries: Vec::new() })
}

fn numbers(text: &str) -> Result<Vec<String>, Fault> {
    let numbers = number_tokens(text);
    if numbers.join(" ") == text { Ok(numbers) } else { Err(Fault::NoNumbers(text.to_owned())) }
}

fn entry(words: &'static str, slug: &'static str) -> Result<Entry, Fault> {
    let no_entry = || Fault::NoEntry(words.to_owned());
    let own = |id: &'static str| match id.strip_prefix(slug).and_then(|id| id.strip_prefix('.')) {
        Some(_) => Ok(id),
        None => Err(Fault::OfAnotherSource(id.to_owned(), slug)),
    };
    if let Some(exception) = words.strip_prefix("exception ") {
        let (named, reason) = exception.split_once(": ").ok_or_else(no_entry)?;
        let (id, printed) = named.split_once(' ').unwrap_or((named, "()"));
        let printed = printed.strip_prefix('(').and_then(|printed| printed.strip_suffix(')')).ok_or_else(no_entry)?;
        return Ok(Entry::Exception { id: own(id)?, numbers: numbers(printed)?, reason: reason.trim().to_owned() });
    }
    match words.split(' ').collect::<Vec<_>>()[..] {
        ["claim", id] => Ok(Entry::Claim(own(id)?)),
        ["reading", id] => Ok(Entry::Reading(own(id)?)),
        ["again", id] => Ok(Entry::Again(own(id)?)),
        ["label", number] => Ok(Entry::Label(number)),
        ["rest", id, dots] => {
            let dots = dots.parse().ok().filter(|dots| *dots > 0).ok_or_else(no_entry)?;
            Ok(Entry::Rest(own(id)?, dots))
        }
        _ => Err(no_entry()),
    }
}

/// The inventory file that a copy of the source asks for: every line that has numbers, and every line that the file
/// already has without. Entries are kept where the numbers have not changed, also if the line has moved, and comments everywhere.
pub(crate) fn updated(file: &str, copy: &str) -> String {
    let (head, body) = file.split_once("\n\n").unwrap_or((file.trim_end(), ""));
    let copied: Vec<Vec<String>> = copy.lines().map(number_tokens).collect();
    let mut known = moved(blocks(body), &copied);
    let last = known.keys().last().copied().unwrap_or_default();
    let mut written = format!("{head}\n\n");
    let mut copied = copied.into_iter().chain(std::iter::repeat(Vec::new()));
    for number in 1..=last.max(copy.lines().count()) {
        let numbers = copied.next().unwrap_or_default();
        let header =
            if numbers.is_empty() { format!("line {number}") } else { format!("line {number}: {}", numbers.join(" ")) };
        let (comments, block) = known.remove(&number).unwrap_or_default();
        written += &comments;
        if block.lines().next() == Some(&header) {
            written += &block;
        } else if !numbers.is_empty() {
            written = written + &header + "\n";
        }
    }
    written
}

/// Comments, and the block below them.
type CommentedBlock = (String, String);

/// The blocks by the lines where a copy has their numbers now. What has no numbers, or others now, stays behind what is before it.
fn moved(blocks: BTreeMap<usize, CommentedBlock>, copied: &[Vec<String>]) -> BTreeMap<usize, CommentedBlock> {
    let numbers_of = |block: &str| -> Vec<String> {
        let printed = block.lines().next().and_then(|header| header.split_once(": "));
        printed.map_or_else(Vec::new, |(_, printed)| printed.split(' ').map(str::to_owned).collect())
    };
    let old: Vec<(usize, Vec<String>)> = blocks
        .iter()
        .map(|(number, (_, block))| (*number, numbers_of(block)))
        .filter(|(_, of)| !of.is_empty())
        .collect();
    let new: Vec<(usize, &Vec<String>)> =
        copied.iter().enumerate().map(|(at, of)| (at + 1, of)).filter(|(_, of)| !of.is_empty()).collect();
    let places: BTreeMap<usize, usize> =
        common(&old.iter().map(|(_, of)| of).collect::<Vec<_>>(), &new.iter().map(|(_, of)| *of).collect::<Vec<_>>())
            .into_iter()
            .map(|(one, other)| (old[one].0, new[other].0))
            .collect();
    let (mut moved, mut before): (BTreeMap<usize, CommentedBlock>, _) = (BTreeMap::new(), (0, 0));
    for (number, (comments, block)) in blocks {
        let place = places.get(&number).copied();
        if let Some(place) = place {
            before = (number, place);
        }
        let place = place.unwrap_or(number - before.0 + before.1);
        let there = moved.entry(place).or_default();
        there.0 += &comments;
        if there.1.is_empty() || places.contains_key(&number) {
            there.1 = block.replacen(&format!("line {number}"), &format!("line {place}"), 1);
        }
    }
    moved
}

/// The longest list of pairs of equal items, in the order of both lists. Of very long lists only the equal items at both ends.
fn common<T: PartialEq>(old: &[T], new: &[T]) -> Vec<(usize, usize)> {
    /// Most pairs that are compared.
    const MOST: usize = 1 << 24;
    let start = old.iter().zip(new).take_while(|(one, other)| one == other).count();
    let (middle_old, middle_new) = (&old[start..], &new[start..]);
    let end = middle_old.iter().rev().zip(middle_new.iter().rev()).take_while(|(one, other)| one == other).count();
    let [rows, columns] = [middle_old.len() - end, middle_new.len() - end];
    let mut pairs: Vec<(usize, usize)> = (0..start).map(|at| (at, at)).collect();
    if rows.saturating_mul(columns) <= MOST {
        // How many pairs there are behind each two items.
        let mut behind = vec![vec![0_u32; columns + 1]; rows + 1];
        for row in (0..rows).rev() {
            for column in (0..columns).rev() {
                behind[row][column] = match middle_old[row] == middle_new[column] {
                    true => behind[row + 1][column + 1] + 1,
                    false => behind[row + 1][column].max(behind[row][column + 1]),
                };
            }
        }
        let (mut row, mut column) = (0, 0);
        while row < rows && column < columns {
            if middle_old[row] == middle_new[column] {
                pairs.push((start + row, start + column));
                (row, column) = (row + 1, column + 1);
            } else if behind[row + 1][column] >= behind[row][column + 1] {
                row += 1;
            } else {
                column += 1;
            }
        }
    }
    pairs.extend((0..end).map(|at| (start + rows + at, start + columns + at)));
    pairs
}

/// The blocks of a file by the line of the source, each with the comments above it.
fn blocks(body: &str) -> BTreeMap<usize, CommentedBlock> {
    let mut blocks = BTreeMap::new();
    let (mut number, mut comments) = (0, String::new());
    for row in body.split_inclusive('\n') {
        let opened = row.strip_prefix("line ").and_then(|opened| opened.split([':', '\n']).next()?.parse().ok());
        if let Some(opened) = opened {
            number = opened;
            blocks.insert(number, (std::mem::take(&mut comments), row.to_owned()));
        } else if row.starts_with(' ') {
            blocks.entry(number).or_default().1 += row;
        } else {
            comments += row;
        }
    }
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(text: &'static str) -> InventoryFile {
        InventoryFile { path: "sources/sum.inventory", text }
    }

    #[test]
    fn entries_are_read_in_order_and_reasons_to_their_end() {
        let text = "# Head.\n\n# Part.\nline 3: 2 1,950 0.5\n  rest sum.a 2\n  exception sum.b (2 1,950): not: one\n    \
                    but two\n\nline 4\n  reading sum.c\n";
        let exception = Entry::Exception {
            id: "sum.b",
            numbers: vec!["2".to_owned(), "1,950".to_owned()],
            reason: "not: one but two".to_owned(),
        };
        let third = Line {
            number: 3,
            numbers: number_tokens("2 1,950 0.5"),
            entries: vec![Entry::Rest("sum.a", 2), exception],
        };
        let fourth = Line { number: 4, numbers: Vec::new(), entries: vec![Entry::Reading("sum.c")] };
        assert_eq!(parse("sum", file(text)), Ok(vec![third, fourth]));
    }

    #[test]
    fn what_is_malformed_is_named_with_its_place_and_what_is_allowed() {
        for (row, said) in [
            ("lines 3", "`lines 3` opens no line of the source; write `line NUMBER` or"),
            ("line three: 3", "`line three: 3` opens no line"),
            ("line 0", "`line 0` opens no line"),
            ("line 1: 7", "line 1 stands behind line 1; the lines stand in the order of the source"),
            ("line 2: 7, 8", "`7, 8` are not numbers with single spaces between"),
            ("line 2: x", "`x` are not numbers"),
            ("  claims sum.a", "`claims sum.a` is no entry; write `claim ID`, `reading ID`"),
            ("  claim sum.a sum.b", "`claim sum.a sum.b` is no entry"),
            ("  rest sum.a 0", "`rest sum.a 0` is no entry"),
            ("  exception sum.a", "`exception sum.a` is no entry"),
            ("  exception sum.a 2: why", "`exception sum.a 2: why` is no entry"),
            ("  exception sum.a (few): why", "`few` are not numbers"),
            ("line 2: Two", "`Two` are not numbers with single spaces between; a number is digits"),
            ("  claim sums.a", "`sums.a` is not of this source; its ids begin with `sum.`"),
            ("    claim sum.b", "`claim sum.b` continues no reason; only an exception's goes on"),
        ] {
            let text = format!("# Head.\n\nline 1: 7\n  claim sum.a\n{row}\n").leak();
            let malformed = parse("sum", file(text)).expect_err(row).to_string();
            let expected = format!("sources/sum.inventory, line 5: {said}");
            assert!(malformed.starts_with(&expected), "{malformed}");
        }
        let homeless = parse("sum", file("  claim sum.a")).expect_err("no line").to_string();
        assert!(homeless.contains("`claim sum.a` stands in no line of the source; open one with"), "{homeless}");
    }

    #[test]
    fn entries_are_kept_where_the_numbers_have_not_changed() {
        let file = "# Head.\n\nline 1: 1 2\n  label 1-2\nline 3\n  claim sum.a\n\n# Part.\nline 4: 4\n  label 4\nline 5: 5\n  \
                    label 5\n";
        let copy = "1 and 2\n22\n\nfour: 40\nno number\n";
        let written =
            "# Head.\n\nline 1: 1 2\n  label 1-2\nline 2: 22\nline 3\n  claim sum.a\n\n# Part.\nline 4: four 40\n";
        assert_eq!(updated(file, copy), written);
        // A line before them, and one that has changed: the others keep what is said of them.
        let file = "# Head.\n\nline 1: 1 2\n  label 1-2\nline 3\n  claim sum.a\n\n# Part.\nline 4: 4\n  label 4\nline 5: 5\n  \
                    label 5\n";
        let copy = "a new line\n7\n1 and 2\n\nno number\n44\n5\n";
        let written = "# Head.\n\nline 2: 7\nline 3: 1 2\n  label 1-2\nline 5\n  claim sum.a\n\n# Part.\nline 6: 44\nline 7: 5\n  \
                       label 5\n";
        assert_eq!(updated(file, copy), written);
        assert_eq!(updated("# Head of a new source.\n", "none\n3.5\n"), "# Head of a new source.\n\nline 2: 3.5\n");
    }
}
