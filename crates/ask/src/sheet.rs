//! An answer as a sheet for reading, with the numbers under one another.

use crate::{MechanismReport, ReportField, SheetNumber};

/// Columns of a sheet that goes to a file; those that a text needs to the right of its lead, and how far it is set in without them.
const WIDTH: usize = 100;
const LEAST_ROOM: usize = 30;
const SET_IN: usize = 6;

/// A line as it is written.
struct Written<'a> {
    name: &'static str,
    number: String,
    unit: &'static str,
    /// The number in another unit, with that.
    other: &'a str,
    direction: &'a str,
    meaning: &'a str,
}

impl<'a> Written<'a> {
    fn of(field: &'a ReportField) -> Option<Self> {
        let line = field.line.as_ref()?;
        let (unit, other, direction) = match &line.shows {
            SheetNumber::Value => (field.unit, "", ""),
            SheetNumber::Both(other) => (field.unit, other.as_str(), ""),
            SheetNumber::Size(_, direction) => (field.unit, "", direction.as_str()),
            SheetNumber::Words => ("", "", ""),
        };
        Some(Self { name: line.name, number: field.on_a_sheet(), unit, other, direction, meaning: &line.meaning })
    }
}

impl MechanismReport {
    /// The answer as a sheet.
    ///
    /// `wrapped` breaks a text, its second argument, into lines behind the first one; `[on, off]` is written before and after each
    /// heading.
    pub fn sheet(&self, wrapped: impl Fn(&str, &str) -> String, [on, off]: [&str; 2]) -> String {
        let items = self.list.iter().flat_map(|(_, items)| items).map(|item| (item.heading, &item.fields));
        let sections = self.sections.iter().map(|(title, fields)| (*title, fields)).chain(items);
        let sections: Vec<(_, Vec<_>)> =
            sections.map(|(title, fields)| (title, fields.iter().filter_map(Written::of).collect())).collect();
        let widest =
            |part: fn(&Written) -> usize| sections.iter().flat_map(|(_, lines)| lines).map(part).max().unwrap_or(0);
        let (name, unit) = (widest(|line| length(line.name)), widest(|line| length(line.unit)));
        let whole = widest(|line| length(split(&line.number).0));
        let decimals = widest(|line| length(split(&line.number).1));

        let mut page = format!("{on}{}{off}\n", wrapped("", &self.title).trim_end());
        page += &wrapped("", self.introduction);
        for (title, lines) in &sections {
            let other = lines.iter().map(|line| length(line.other)).max().unwrap_or(0);
            let direction = lines.iter().map(|line| length(line.direction)).max().unwrap_or(0);
            if !lines.is_empty() {
                page += &format!("\n{on}{title}{off}\n");
            }
            for line in lines {
                let mut lead = format!("  {:<name$}  ", line.name);
                if !line.number.is_empty() {
                    let (before, after) = split(&line.number);
                    lead += &format!("{before:>whole$}{after:<decimals$} {:<unit$}  ", line.unit);
                }
                if other > 0 && !line.number.is_empty() {
                    lead += &format!("{:>other$}  ", line.other);
                }
                if direction > 0 {
                    lead += &format!("{:>direction$}  ", line.direction);
                }
                page += &wrapped(&lead, line.meaning);
            }
        }
        if self.note.is_empty() { page } else { page + "\n" + &wrapped("", &self.note) }
    }

    /// The answer as a sheet for a file: in lines of 100 columns, without marks for headings.
    ///
    /// ```
    /// let sheet = geneva_ask::answer("wheel --stations 6")?.plain_sheet();
    /// assert!(sheet.starts_with("External Geneva wheel: 6 stations, driver with 1 pin\n"));
    /// assert!(sheet.lines().all(|line| line.chars().count() <= 100));
    /// # Ok::<(), geneva_ask::Error>(())
    /// ```
    pub fn plain_sheet(&self) -> String {
        self.sheet(wrapped, ["", ""])
    }
}

/// A text in lines behind `lead`, then under it; with little room beside a long lead, the text begins under it.
fn wrapped(lead: &str, text: &str) -> String {
    let beside = length(lead);
    let is_beside = beside == 0 || beside + LEAST_ROOM <= WIDTH;
    let indent = if is_beside { beside } else { SET_IN };
    let mut lines = String::new();
    let mut line = if is_beside {
        lead.to_owned()
    } else {
        lines += lead.trim_end();
        lines.push('\n');
        " ".repeat(indent)
    };
    let mut is_empty = true;
    for word in text.split_whitespace() {
        let gap = if is_empty { "" } else { " " };
        if !is_empty && length(&line) + gap.len() + length(word) > WIDTH {
            lines += line.trim_end();
            lines.push('\n');
            line = " ".repeat(indent);
        } else {
            line += gap;
        }
        line += word;
        is_empty = false;
    }
    if is_beside || !is_empty {
        lines += line.trim_end();
        lines.push('\n');
    }
    lines
}

/// What stands before the point, and the rest with it.
fn split(number: &str) -> (&str, &str) {
    number.split_at(number.find('.').unwrap_or(number.len()))
}

fn length(text: &str) -> usize {
    text.chars().count()
}
