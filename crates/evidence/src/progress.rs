//! How far a ledger is that is still being written: its verdicts, and what its claims do not account for yet.

use crate::{Document, Judged, Ledger, Line, Malformed, PlainVerdict, line_gap, numbers_left};
use std::fmt;

/// A line of a document that the claims and exceptions do not account for yet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnfinishedLine {
    /// The document.
    pub document: &'static Document,
    /// The line's number in the document's text, from 1.
    pub number: u32,
    /// The numbers that are left over, in their order, as printed; none if the line has no entry and prints no number.
    pub numbers: Vec<String>,
}

/// How far a ledger is. Its text is for whoever writes the ledger: verdicts, what differs from the record, and what is left to do.
#[derive(Clone, Debug)]
pub struct LedgerProgress {
    /// How many claims have each verdict, in the order of [`PlainVerdict`].
    pub verdicts: Vec<(PlainVerdict, usize)>,
    /// The claims that differ from their record, each with what contradicts it, and the lines whose entries say other numbers than
    /// the line.
    pub contradictions: Vec<String>,
    /// How many numbers the mirrored documents print, in digits and in words.
    pub numbers: usize,
    /// The lines that are not yet accounted for, in the order of the documents.
    pub unfinished: Vec<UnfinishedLine>,
}

impl Document {
    /// The lines that its claims and exceptions do not account for yet, in their order: those with a number left over, and those
    /// without an entry. A line whose entries contradict it is none of them.
    ///
    /// # Errors
    ///
    /// If its inventory file cannot be read.
    pub fn unfinished_lines(&'static self) -> Result<Vec<UnfinishedLine>, &'static Malformed> {
        let unfinished = |line: &Line| {
            let numbers = numbers_left(self, line).ok()?;
            let is_left = !numbers.is_empty() || line.entries.is_empty();
            is_left.then_some(UnfinishedLine { document: self, number: line.number, numbers })
        };
        Ok(self.lines()?.iter().filter_map(unfinished).collect())
    }
}

impl Ledger {
    /// The lines of all mirrored documents that are not yet accounted for; see [`Document::unfinished_lines`].
    ///
    /// # Errors
    ///
    /// If an inventory file cannot be read.
    pub fn unfinished_lines(&'static self) -> Result<Vec<UnfinishedLine>, &'static Malformed> {
        let lines = self.mirrored().iter().map(|document| document.unfinished_lines());
        Ok(lines.collect::<Result<Vec<_>, _>>()?.concat())
    }

    /// How far the ledger is, with all its verdicts.
    ///
    /// # Errors
    ///
    /// If an inventory file cannot be read.
    pub fn progress(&'static self) -> Result<LedgerProgress, &'static Malformed> {
        let judged = self.verdicts();
        let count = |verdict| (verdict, judged.iter().filter(|judged| judged.plain() == verdict).count());
        let differing = judged.iter().filter(|judged| !judged.matches_record());
        let complaint = |judged: &&Judged| {
            let computed = match (judged.computed, judged.witnessed) {
                (Some(one), Some(other)) => {
                    format!("printed {}, and the routes give {one} and {other}; ", judged.printed)
                }
                _ => String::new(),
            };
            format!("{}: {computed}{}", judged.claim.id, judged.complaints().join("; "))
        };
        let mut contradictions: Vec<String> = differing.map(complaint).collect();
        let mut numbers = 0;
        for document in self.mirrored() {
            for line in document.lines()? {
                numbers += line.numbers.len();
                if numbers_left(document, line).is_err() {
                    let gap = line_gap(document, line).unwrap_or_default();
                    contradictions.push(format!("{document}, line {}: {gap}", line.number));
                }
            }
        }
        let verdicts = PlainVerdict::ALL.iter().copied().map(count).collect();
        Ok(LedgerProgress { verdicts, contradictions, numbers, unfinished: self.unfinished_lines()? })
    }
}

impl LedgerProgress {
    /// How many numbers are left over.
    pub fn numbers_left(&self) -> usize {
        self.unfinished.iter().map(|line| line.numbers.len()).sum()
    }
}

impl fmt::Display for UnfinishedLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.numbers.is_empty() {
            return write!(f, "line {}: no entry", self.number);
        }
        write!(f, "line {}: {}", self.number, self.numbers.join(", "))
    }
}

impl fmt::Display for LedgerProgress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plural = |count: usize, one: &str| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
        let all: usize = self.verdicts.iter().map(|(_, count)| count).sum();
        let there = self.verdicts.iter().filter(|(_, count)| *count > 0);
        let verdicts: Vec<String> = there.map(|(verdict, count)| format!("{count} {}", verdict.words())).collect();
        let colon = if verdicts.is_empty() { "" } else { ": " };
        writeln!(f, "{}{colon}{}", plural(all, "claim"), verdicts.join(", "))?;
        for contradiction in &self.contradictions {
            writeln!(f, "differs: {contradiction}")?;
        }
        match self.unfinished.first() {
            None => write!(f, "all of the {} are accounted for", plural(self.numbers, "number")),
            Some(first) => write!(
                f,
                "{} of {} in {} are not accounted for yet; the first: {first}",
                self.numbers_left(),
                plural(self.numbers, "number"),
                plural(self.unfinished.len(), "line")
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{check, check_unfinished};
    use crate::{Cache, Evidence, InventoryFile, Locator};
    use std::panic::catch_unwind;

    /// A document with this inventory, and with a claim on its second line.
    macro_rules! document {
        ($name:ident, $ledger:ident, $text:literal) => {
            static $name: Document = Document {
                slug: "notes",
                title: "notes",
                citation: "Notes that are made up",
                inventory: Some(InventoryFile { path: "notes.inventory", text: $text }),
                claims: || {
                    let here = Locator::new(&$name, "line 2");
                    vec![here.value("notes.half", "2.5", "m", "length").missing("made up")]
                },
                answers: &[],
                given: Vec::new,
                conclusions: &[],
                symbols: &[],
                units: &[("length", "m"), ("time", "s")],
                test: "",
                cache: Cache::new(),
            };
            static $ledger: Ledger = Ledger::new(&[&$name], &[Evidence::CLOSED_FORM]);
        };
    }

    document!(BEGUN, BEGUN_LEDGER, "# Notes.\n\nline 2: 7 2.5 9\n  claim notes.half\nline 3: three\nline 5\n");
    document!(WRONG, WRONG_LEDGER, "# Notes.\n\nline 2: 7 2.6\n  claim notes.half\nline 3: three\n");

    fn complaint(of: fn()) -> String {
        let stopped = catch_unwind(of).expect_err("a complaint");
        stopped.downcast_ref::<String>().expect("words").clone()
    }

    #[test]
    fn what_is_left_to_do_is_said() {
        let progress = BEGUN_LEDGER.progress().expect("an inventory");
        let lines: Vec<String> = progress.unfinished.iter().map(ToString::to_string).collect();
        assert_eq!(lines, ["line 2: 7, 9", "line 3: three", "line 5: no entry"]);
        assert_eq!((progress.numbers, progress.numbers_left()), (4, 3));
        let said = "1 claim: 1 open\n3 of 4 numbers in 3 lines are not accounted for yet; the first: line 2: 7, 9";
        assert_eq!(progress.to_string(), said);
    }

    #[test]
    fn the_number_of_lines_to_do_can_only_fall() {
        check_unfinished(&BEGUN_LEDGER, 3);
        let fewer = complaint(|| check_unfinished(&BEGUN_LEDGER, 4));
        assert!(fewer.starts_with("1 fault:\n3 lines are still to be accounted for, and 4 are on record"), "{fewer}");
        let more = complaint(|| check_unfinished(&BEGUN_LEDGER, 2));
        assert!(more.contains("and only 2 are on record") && more.ends_with("notes, line 5: no entry"), "{more}");
        let finished = complaint(|| check(&BEGUN_LEDGER));
        assert_eq!(complaint(|| check_unfinished(&BEGUN_LEDGER, 0)), finished);
        for words in ["line 3: no entry", "has 2.5, the line there 7", "closed-form is used by no claim", "\"time\""] {
            assert!(finished.contains(words), "no `{words}` in {finished}");
        }
    }

    #[test]
    fn entries_that_contradict_a_line_are_no_work_left_to_do() {
        let progress = WRONG_LEDGER.progress().expect("an inventory");
        assert_eq!(progress.contradictions, ["notes, line 2: claim notes.half has 2.5, the line there 7 2.6"]);
        assert_eq!(progress.unfinished.len(), 1);
        let said = complaint(|| check_unfinished(&WRONG_LEDGER, 1));
        assert!(said.contains("line 2: 7 2.6: claim notes.half has 2.5, the line there 7 2.6"), "{said}");
    }
}
