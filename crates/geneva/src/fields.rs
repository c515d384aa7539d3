//! An answer as a sheet for reading. In JSON its fields are an object; what has many rows of its own, such as a cycle or a run, is
//! a series.

use crate::output::{TextLayout, heading};
use geneva_ask::{MechanismReport, ReportField, SheetNumber};

pub(crate) use geneva_press::fields::{DataRow, csv, json};

/// A line as it is written.
struct Written<'a> {
    name: &'static str,
    number: String,
    unit: &'static str,
    direction: &'a str,
    meaning: &'a str,
}

impl<'a> Written<'a> {
    fn of(field: &'a ReportField) -> Option<Self> {
        let line = field.line.as_ref()?;
        let (unit, direction) = match &line.shows {
            SheetNumber::Value => (field.unit, ""),
            SheetNumber::Size(_, direction) => (field.unit, direction.as_str()),
            SheetNumber::Words => ("", ""),
        };
        Some(Self { name: line.name, number: field.on_a_sheet(), unit, direction, meaning: &line.meaning })
    }
}

/// An answer as a sheet for reading, with the numbers under one another.
pub(crate) fn sheet(answer: &MechanismReport, layout: TextLayout) -> String {
    let items = answer.list.iter().flat_map(|(_, items)| items).map(|item| (item.heading, &item.fields));
    let sections = answer.sections.iter().map(|(title, fields)| (*title, fields)).chain(items);
    let sections: Vec<(_, Vec<_>)> =
        sections.map(|(title, fields)| (title, fields.iter().filter_map(Written::of).collect())).collect();
    let widest =
        |part: fn(&Written) -> usize| sections.iter().flat_map(|(_, lines)| lines).map(part).max().unwrap_or(0);
    let (name, unit) = (widest(|line| length(line.name)), widest(|line| length(line.unit)));
    let whole = widest(|line| length(split(&line.number).0));
    let decimals = widest(|line| length(split(&line.number).1));

    let bold = heading();
    let mut page = format!("{bold}{}{bold:#}\n", layout.wrapped("", &answer.title).trim_end());
    page += &layout.wrapped("", answer.introduction);
    for (title, lines) in &sections {
        let direction = lines.iter().map(|line| length(line.direction)).max().unwrap_or(0);
        if !lines.is_empty() {
            page += &format!("\n{bold}{title}{bold:#}\n");
        }
        for line in lines {
            let mut lead = format!("  {:<name$}  ", line.name);
            if !line.number.is_empty() {
                let (before, after) = split(&line.number);
                lead += &format!("{before:>whole$}{after:<decimals$} {:<unit$}  ", line.unit);
            }
            if direction > 0 {
                lead += &format!("{:>direction$}  ", line.direction);
            }
            page += &layout.wrapped(&lead, line.meaning);
        }
    }
    if answer.note.is_empty() { page } else { page + "\n" + &layout.wrapped("", &answer.note) }
}

/// What stands before the point, and the rest with it.
fn split(number: &str) -> (&str, &str) {
    number.split_at(number.find('.').unwrap_or(number.len()))
}

fn length(text: &str) -> usize {
    text.chars().count()
}
