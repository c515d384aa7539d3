//! An answer as a sheet for reading. In JSON its fields are an object; CSV is for a series, a row for each claim, time or
//! escapement.

use crate::output::{heading, wrapped};
use geneva_ask::{Answer, Line};

pub use geneva_press::fields::{Row, csv, json};

/// An answer as a sheet for reading, with the numbers under one another.
pub fn sheet(answer: &Answer) -> String {
    let items = answer.list.iter().flat_map(|(_, items)| items);
    let items = items.map(|item| (item.heading, &item.fields));
    let sections: Vec<_> = answer.sections.iter().map(|(title, fields)| (*title, fields)).chain(items).collect();
    let all = sections.iter().flat_map(|(_, fields)| *fields);
    let lines: Vec<_> = all.filter_map(|field| field.line.as_ref()).collect();
    let widest = |part: fn(&Line) -> &str| lines.iter().map(|line| length(part(line))).max().unwrap_or(0);
    let (name, unit) = (widest(|line| line.name), widest(|line| line.unit));
    let whole = widest(|line| split(&line.number).0);
    let decimals = widest(|line| split(&line.number).1);

    let bold = heading();
    let mut page = format!("{bold}{}{bold:#}\n", wrapped("", &answer.title).trim_end());
    page += &wrapped("", answer.introduction);
    for (title, fields) in sections {
        let lines: Vec<_> = fields.iter().filter_map(|field| field.line.as_ref()).collect();
        let direction = lines.iter().map(|line| length(&line.direction)).max().unwrap_or(0);
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
            page += &wrapped(&lead, &line.meaning);
        }
    }
    if answer.note.is_empty() { page } else { page + "\n" + &wrapped("", &answer.note) }
}

/// What stands before the point, and the rest with it.
fn split(number: &str) -> (&str, &str) {
    number.split_at(number.find('.').unwrap_or(number.len()))
}

fn length(text: &str) -> usize {
    text.chars().count()
}
