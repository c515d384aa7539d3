//! The sheets that the commands print, and pieces that their drawings share.

use crate::output::{heading, wrapped};

/// Digits of a number on a sheet.
pub const DIGITS: usize = 4;

/// `value` with [`DIGITS`] significant digits: trailing zeros kept, and no more zeros than a reader counts.
pub fn number(value: f64) -> String {
    let scientific = format!("{value:.*e}", DIGITS - 1);
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()).unwrap_or(0);
    match usize::try_from(DIGITS as i32 - 1 - exponent) {
        _ if value == 0.0 => "0".to_owned(),
        Ok(decimals) if decimals < 2 * DIGITS => format!("{value:.decimals$}"),
        Err(_) if exponent < 2 * DIGITS as i32 => format!("{value:.0}"),
        _ => scientific,
    }
}

/// What stands before the point, and the rest with it.
fn split(number: &str) -> (&str, &str) {
    number.split_at(number.find('.').unwrap_or(number.len()))
}

/// Characters of the longest.
fn longest<'a>(texts: impl Iterator<Item = &'a str>) -> usize {
    texts.map(|text| text.chars().count()).max().unwrap_or(0)
}

/// A line of a sheet: a number under its name, and what is said of it. Number, unit and direction are empty where words
/// say it all.
pub struct Line {
    /// What it is, in a word or two.
    pub name: &'static str,
    /// The number, written.
    pub number: String,
    /// Its unit.
    pub unit: &'static str,
    /// The direction of what the number is the length of.
    pub direction: String,
    /// What is said of it.
    pub meaning: String,
}

impl Line {
    /// A number and what it means.
    pub fn new(name: &'static str, number: String, unit: &'static str, meaning: &str) -> Self {
        Self { name, number, unit, direction: String::new(), meaning: meaning.to_owned() }
    }

    /// Words alone.
    pub fn said(name: &'static str, meaning: &str) -> Self {
        Self::new(name, String::new(), "", meaning)
    }
}

/// A title, what all numbers have in common, and sections of lines whose numbers stand under one another.
pub fn page(title: &str, introduction: &str, sections: &[(&str, Vec<Line>)]) -> String {
    let all = || sections.iter().flat_map(|(_, lines)| lines);
    let name = longest(all().map(|line| line.name));
    let whole = longest(all().map(|line| split(&line.number).0));
    let decimals = longest(all().map(|line| split(&line.number).1));
    let unit = longest(all().map(|line| line.unit));

    let bold = heading();
    let mut page = format!("{bold}{}{bold:#}\n", wrapped("", title).trim_end());
    page += &wrapped("", introduction);
    for (title, lines) in sections {
        let direction = longest(lines.iter().map(|line| line.direction.as_str()));
        page += &format!("\n{bold}{title}{bold:#}\n");
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
    page
}

/// The drawing with fixed colours: each custom property, which only a page can set and only a browser understands,
/// gives way to what stands behind it.
pub fn standalone(svg: &str) -> String {
    let mut parts = svg.split("var(--");
    let mut fixed = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(')').and_then(|(property, rest)| Some((property.split_once(", ")?.1, rest))) {
            Some((colour, rest)) => fixed.extend([colour, rest]),
            None => fixed.extend(["var(--", part]),
        }
    }
    fixed
}

#[cfg(test)]
mod tests {
    use super::{number, standalone};

    #[test]
    fn numbers_have_a_few_digits_and_no_long_rows_of_zeros() {
        let written = [0.0, 2.0, 1.0 / 3.0, 99.999, 12_345.6, 1e9, 1e-9].map(number);
        assert_eq!(written, ["0", "2.000", "0.3333", "100.0", "12346", "1.000e9", "1.000e-9"]);
    }

    #[test]
    fn colours_of_the_page_give_way_to_their_fallbacks() {
        let svg = "<g fill=\"var(--a, #111)\" stroke=\"var(--b)\"><path stroke=\"var(--c, #222)\"/></g>";
        assert_eq!(standalone(svg), "<g fill=\"#111\" stroke=\"var(--b)\"><path stroke=\"#222\"/></g>");
        assert_eq!(standalone("<g/>"), "<g/>");
    }
}
