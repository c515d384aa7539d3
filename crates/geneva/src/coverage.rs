//! The claims and exceptions on each line of a source, the comparison with a copy, and the inventory file for a copy.

use crate::input::MOST_BYTES;
use crate::output::{Outcome, TextLayout, count, heading};
use crate::printable::shown_path;
use crate::typed;
use anyhow::{Error, bail};
use clap::Args;
use geneva_documents::LEDGER;
use geneva_evidence::Document;
use geneva_evidence::{Entry, Line, joined_or_none, line_gap, number_tokens};
use geneva_host::files;
use std::path::{Path, PathBuf};

/// Options of `geneva coverage`.
#[derive(Args, Debug)]
pub(crate) struct CoverageArguments {
    /// Show only this source
    #[arg(long, value_parser = typed::value_named(LEDGER.mirrored(), |document| document.slug, |document| document.citation))]
    pub source: Option<&'static Document>,
    /// Compare the numbers on each line, in digits and in words, with those in FILE, your own copy of the source's text
    #[arg(long, value_name = "FILE", requires = "source")]
    pub against: Option<PathBuf>,
    /// Write a new inventory file for the ledger, with the numbers in FILE, your own copy of the source's text
    #[arg(long, value_name = "FILE", requires = "source", conflicts_with = "against")]
    pub record: Option<PathBuf>,
}

/// Most characters of a line of a copy. No page has so many.
const LONGEST_LINE: usize = 100_000;

/// The coverage that is wanted, and whether a line differs.
pub(crate) fn page(wanted: &CoverageArguments, layout: TextLayout) -> anyhow::Result<(String, Outcome)> {
    if let (Some(source), Some(file)) = (wanted.source, &wanted.against) {
        return Ok(compare(source.lines()?, &copy(source, "--against", file)?, layout));
    }
    if let (Some(source), Some(file)) = (wanted.source, &wanted.record) {
        source.lines()?;
        return Ok((source.inventory_for(&copy(source, "--record", file)?), Outcome::AsRecorded));
    }
    let (mut pages, mut complete) = (Vec::new(), true);
    for work in LEDGER.mirrored().iter().filter(|work| wanted.source.is_none_or(|source| source == **work)) {
        let lines = work.lines()?;
        pages.push(inventory(work, lines, layout));
        complete &= lines.iter().all(|line| line_gap(work, line).is_none());
    }
    Ok((pages.join("\n"), Outcome::as_recorded_if(complete)))
}

fn inventory(work: &'static Document, lines: &[Line], layout: TextLayout) -> String {
    let bold = heading();
    let mut page = layout.wrapped(&format!("{work}: "), work.citation);
    page += &format!("\n{bold}  line  claims  again  exceptions  its numbers{bold:#}\n");
    for line in lines {
        let number_of = |wanted: fn(&Entry) -> bool| line.entries.iter().filter(|entry| wanted(entry)).count();
        let numbers = format!(
            "  {:>4}  {:>6}  {:>5}  {:>10}  ",
            line.number,
            number_of(|entry| matches!(entry, Entry::Claim(_))),
            number_of(|entry| matches!(entry, Entry::Again(_))),
            number_of(|entry| matches!(entry, Entry::Exception { .. })),
        );
        let gap =
            line_gap(work, line).map_or("all accounted for".to_owned(), |gap| format!("NOT accounted for: {gap}"));
        page += &layout.wrapped(&numbers, &gap);
    }
    page += &format!("\n{bold}Exceptions{bold:#}\n");
    for line in lines {
        for entry in &line.entries {
            if let Entry::Exception { id, reason, .. } = entry {
                page += &layout.wrapped(&format!("  line {:>4}  ", line.number), &format!("{id}: {reason}"));
            }
        }
    }
    page
}

/// The copy of a source that an option names.
fn copy(work: &'static Document, option: &str, file: &Path) -> anyhow::Result<String> {
    let wanted = format!("{option} a text file with your copy of {work}");
    let bytes = files::read(file, MOST_BYTES, &wanted).map_err(Error::msg)?;
    // Digits and number words are the same in every encoding that a copy is likely to have. Raised digits and fractions that
    // are one character are not: what is no UTF-8 is read as Latin-1.
    let chunks = bytes.utf8_chunks();
    let text: String = chunks
        .flat_map(|chunk| chunk.valid().chars().chain(chunk.invalid().iter().map(|byte| char::from(*byte))))
        .collect();
    if let Some((at, _)) = text.lines().enumerate().find(|(_, line)| line.len() > LONGEST_LINE) {
        bail!(
            "{}: line {} has more than {LONGEST_LINE} characters; give {option} your copy of {work} with its line breaks",
            shown_path(file),
            at + 1
        );
    }
    Ok(text)
}

/// Compares the numbers of a text, line by line, with an inventory.
fn compare(inventory: &[Line], text: &str, layout: TextLayout) -> (String, Outcome) {
    let mut copy = text.lines().map(number_tokens).fuse();
    let lines = inventory.iter().map(|line| line.number as usize).max().unwrap_or(0).max(text.lines().count());
    let (mut page, mut compared, mut differing, mut agreeing) = (String::new(), 0, 0, 0);
    for number in 1..=lines {
        let found = copy.next().unwrap_or_default();
        let expected = inventory.iter().find(|line| line.number as usize == number);
        if expected.is_none() && found.is_empty() {
            continue;
        }
        compared += 1;
        let ours = expected.map_or(&[][..], |line| &line.numbers);
        if found == ours {
            // A line without numbers agrees with any text.
            agreeing += usize::from(!found.is_empty());
            page += &format!("line {number:>4}  same numbers\n");
            continue;
        }
        differing += 1;
        page += &format!("line {number:>4}  DIFFERENT NUMBERS\n");
        page += &layout.wrapped("    in your copy:   ", &joined_or_none(&found));
        page += &layout.wrapped("    in the ledger:  ", &joined_or_none(ours));
    }
    let compared = count(compared, "line");
    let sum = match differing {
        0 => format!("{compared} compared: all numbers, in digits and in words, match the ledger"),
        _ if agreeing == 0 => {
            format!("{compared} compared: no number matches the ledger; is this a copy of the right source?")
        }
        _ => format!("{compared} compared: {differing} with numbers that differ from the ledger"),
    };
    page += &layout.wrapped("", &sum);
    (page, Outcome::as_recorded_if(differing == 0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_evidence::another;

    fn compared(inventory: &[Line], text: &str) -> (String, Outcome) {
        compare(inventory, text, TextLayout::default())
    }

    fn line(number: u32, printed: &str) -> Line {
        Line { number, numbers: number_tokens(printed), entries: Vec::new() }
    }

    #[test]
    fn a_copy_with_the_same_numbers_agrees_whatever_its_words() {
        let (page, outcome) = compared(&[line(1, "a 1 b 2"), line(3, "")], "1 and 2\r\n\r\nnothing\n\n");
        assert_eq!(outcome, Outcome::AsRecorded, "{page}");
    }

    #[test]
    fn a_changed_number_a_lost_line_and_one_too_many_are_each_seen() {
        let inventory = [line(1, "1.5"), line(2, "2.5")];
        for (copy, differing) in [("1.5\n2.6\n", 1), ("1.5\n", 1), ("1.5\n2.5\n3.5\n", 1), ("", 2)] {
            let (page, outcome) = compared(&inventory, copy);
            assert_eq!(outcome, Outcome::Differs, "{copy}");
            assert_eq!(page.matches("DIFFERENT NUMBERS").count(), differing, "{page}");
        }
    }

    #[test]
    fn each_number_of_a_copy_is_seen_if_it_is_another_or_gone_or_printed_twice() {
        // Made up from the inventories, since the sources' sentences are not ours to keep.
        let (mut in_words, mut in_digits) = (0, 0);
        for work in LEDGER.mirrored() {
            let inventory = work.lines().expect("a test of its own reads it");
            let numbers = inventory.iter().flat_map(|line| (0..line.numbers.len()).map(move |at| (line, at)));
            for (line, at) in numbers {
                let number = &line.numbers[at];
                let is_word = number.starts_with(|c: char| c.is_alphabetic());
                let other = another(number);
                *(if is_word { &mut in_words } else { &mut in_digits }) += 1;
                for put in [&other, "", &format!("{number} {number}")] {
                    let mut changed = line.numbers.clone();
                    changed[at] = put.to_owned();
                    let sentence = format!("So it says {} of them.\n", changed.join(" of the "));
                    let copy = "\n".repeat(line.number as usize - 1) + &sentence;
                    let (page, _) = compared(std::slice::from_ref(line), &copy);
                    assert!(page.contains("DIFFERENT NUMBERS"), "{work}, line {}: {number}, {put}", line.number);
                }
            }
        }
        assert!(in_words > 140 && in_digits > 1700, "only {in_words} and {in_digits} numbers were tried");
    }

    #[test]
    fn a_number_word_that_is_changed_gone_or_too_many_is_said_as_a_number_in_digits_is() {
        let inventory = [line(1, "In one of four slots, 1.5 times."), line(2, "Nothing."), line(3, "Three-Quarters")];
        let (page, outcome) = compared(&inventory, "one FOUR 1.5\n\nof three quarters\n");
        assert_eq!(outcome, Outcome::AsRecorded, "{page}");
        assert!(page.ends_with("all numbers, in digits and in words, match the ledger\n"), "{page}");
        for (copy, found) in [
            ("one of five 1.5\n\nthree quarters\n", "one five 1.5"),
            ("one of them 1.5\n\nthree quarters\n", "one 1.5"),
            ("one of four 1.5\nboth\nthree quarters\n", "both"),
            ("one of four 1.5\n\ntwo-thirds\n", "two thirds"),
        ] {
            let (page, outcome) = compared(&inventory, copy);
            assert_eq!(outcome, Outcome::Differs, "{copy}");
            assert!(page.contains(&format!("in your copy:   {found}\n")), "{page}");
            assert!(page.ends_with("1 with numbers that differ from the ledger\n"), "{page}");
        }
    }

    #[test]
    fn a_text_without_a_number_of_the_source_may_be_none_of_it() {
        // A line of the source without numbers agrees with an empty file.
        let inventory = [line(1, "1.5"), line(2, "none"), line(3, "2.5")];
        for copy in ["", "\n\n\n", "7\n\n8\n"] {
            let (page, _) = compared(&inventory, copy);
            assert!(page.contains("no number matches the ledger; is this a copy of the right source?"), "{page}");
        }
        let (page, _) = compared(&inventory, "1.5\n\n8\n");
        assert!(page.contains("1 with numbers that differ"), "{page}");
    }
}
