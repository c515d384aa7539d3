//! The answer of a command is one list of fields, from which come the readable sheet, the JSON, the CSV and the check that
//! every number is finite.
//!
//! In JSON a list of fields is an object, in CSV a row. CSV is for a series: a row for each claim, time or escapement. A
//! single thing has a [`Report`].

use crate::output::{heading, wrapped};
use serde::ser::{Serialize, Serializer};

pub use geneva_press::fields::{Row, Value, csv, json};

/// A value under its key, in its unit, and its line of the sheet.
pub struct Field {
    key: &'static str,
    value: Value,
    unit: &'static str,
    line: Option<Line>,
}

/// A number under its name, and its explanation. Number, unit and direction are empty where words say it all.
struct Line {
    name: &'static str,
    number: String,
    unit: &'static str,
    direction: String,
    meaning: String,
}

impl Field {
    /// A value without a unit. It has no line unless it gets one: the title or another line may say it, or the sheet doesn't
    /// need it.
    pub fn new(key: &'static str, value: impl Into<Value>) -> Self {
        Self::in_unit(key, value, "")
    }

    /// A value with a unit, without a line.
    pub fn in_unit(key: &'static str, value: impl Into<Value>, unit: &'static str) -> Self {
        Self { key, value: value.into(), unit, line: None }
    }

    /// Its line: a name, and what the number means. What is missing has none.
    pub fn line(mut self, name: &'static str, meaning: impl Into<String>) -> Self {
        let number = match self.value {
            Value::Missing => return self,
            Value::Number(degrees) if self.unit == "°" => angle(degrees),
            Value::Number(value) => number(value),
            Value::Count(count) => count.to_string(),
            _ => String::new(),
        };
        self.line = Some(Line { name, number, unit: self.unit, direction: String::new(), meaning: meaning.into() });
        self
    }

    /// Its line under another that says the same in another unit.
    pub fn also(self) -> Self {
        self.line("", "")
    }

    /// A line without a number: words say it all, also of what is missing.
    pub fn words(mut self, name: &'static str, words: impl Into<String>) -> Self {
        let (number, direction) = (String::new(), String::new());
        self.line = Some(Line { name, number, unit: "", direction, meaning: words.into() });
        self
    }

    /// Another number on its line: the size of what is signed or has a direction. The direction stands beside it.
    pub fn of_size(mut self, size: f64, direction: String) -> Self {
        if let Some(line) = &mut self.line {
            line.number = number(size);
            line.direction = direction;
        }
        self
    }
}

/// The report on one thing: a title, what all numbers have in common, sections of fields, and a closing note. A section
/// without lines has no heading.
pub struct Report {
    pub title: String,
    pub introduction: &'static str,
    pub sections: Vec<(&'static str, Vec<Field>)>,
    pub note: String,
}

impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.fields().map(|field| (field.key, &field.value)))
    }
}

impl Report {
    fn fields(&self) -> impl Iterator<Item = &Field> {
        self.sections.iter().flat_map(|(_, fields)| fields)
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        self.fields().all(|field| field.value.is_finite())
    }

    /// The sheet for reading, with the numbers under one another.
    pub fn sheet(&self) -> String {
        let lines: Vec<_> = self.fields().filter_map(|field| field.line.as_ref()).collect();
        let widest = |part: fn(&Line) -> &str| lines.iter().map(|line| length(part(line))).max().unwrap_or(0);
        let (name, unit) = (widest(|line| line.name), widest(|line| line.unit));
        let whole = widest(|line| split(&line.number).0);
        let decimals = widest(|line| split(&line.number).1);

        let bold = heading();
        let mut page = format!("{bold}{}{bold:#}\n", wrapped("", &self.title).trim_end());
        page += &wrapped("", self.introduction);
        for (title, fields) in &self.sections {
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
        if self.note.is_empty() { page } else { page + "\n" + &wrapped("", &self.note) }
    }
}

/// What stands before the point, and the rest with it.
fn split(number: &str) -> (&str, &str) {
    number.split_at(number.find('.').unwrap_or(number.len()))
}

fn length(text: &str) -> usize {
    text.chars().count()
}

/// Significant digits of a number on a sheet.
const DIGITS: usize = 4;

/// Degrees that are zero but for rounding.
const NO_ANGLE: f64 = 1e-9;

/// `value` with [`DIGITS`] significant digits and a true minus sign: trailing zeros kept, and no more zeros than a reader
/// counts.
pub fn number(value: f64) -> String {
    let scientific = format!("{value:.*e}", DIGITS - 1);
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()).unwrap_or(0);
    let number = match usize::try_from(DIGITS as i32 - 1 - exponent) {
        _ if value == 0.0 => "0".to_owned(),
        Ok(decimals) if decimals < 2 * DIGITS => format!("{value:.decimals$}"),
        Err(_) if exponent < 2 * DIGITS as i32 => format!("{value:.0}"),
        _ => scientific,
    };
    number.replace('-', "−")
}

/// An angle in degrees with as many digits. Zero and the half turn have no sign.
pub fn angle(degrees: f64) -> String {
    let written = number(if degrees.abs() <= NO_ANGLE { 0.0 } else { degrees });
    if written == number(-180.0) { number(180.0) } else { written }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_a_few_digits_and_no_long_rows_of_zeros() {
        let written = [0.0, 2.0, -1.0 / 3.0, 99.999, 12_345.6, 1e9, 1e-9].map(number);
        assert_eq!(written, ["0", "2.000", "−0.3333", "100.0", "12346", "1.000e9", "1.000e−9"]);
        assert_eq!([-1e-15, 1e-3, -179.999_99, 180.0, -30.0].map(angle), ["0", "0.001000", "180.0", "180.0", "−30.00"]);
    }

    #[test]
    fn json_and_csv_say_the_same_of_what_is_there_and_of_what_is_missing() {
        let finding = Row(vec![("form", "printed".into()), ("holds", false.into())]);
        let row = |inner: Option<f64>| {
            Row(vec![
                ("a", 6e-5.into()),
                ("b", Value::Missing),
                ("c", vec![Value::Worded(finding.clone(), "printed fails".to_owned()), 2_u32.into()].into()),
                ("d", Value::Object(Row(vec![("x", inner.into()), ("y", inner.map(|_| "text").into())]))),
            ])
        };
        let (some, none) = (row(Some(1.0)), row(None));
        let text = serde_json::to_string(&[&some, &none]).expect("JSON");
        let list = r#"[{"form":"printed","holds":false},2]"#;
        let expected = format!(
            r#"[{{"a":0.00006,"b":null,"c":{list},"d":{{"x":1.0,"y":"text"}}}},{{"a":0.00006,"b":null,"c":{list},"d":null}}]"#
        );
        assert_eq!(text, expected);
        let text = csv(Some(&none), [some, none.clone()]).expect("CSV");
        assert_eq!(text, "a,b,c,d_x,d_y\n0.00006,,printed fails; 2,1.0,text\n0.00006,,printed fails; 2,,\n");
    }

    #[test]
    fn a_number_that_is_none_is_found_wherever_it_is() {
        for (value, finite) in [
            (Value::from(f64::NAN), false),
            (vec![1.0, f64::INFINITY].into(), false),
            (Value::Object(Row(vec![("x", f64::NEG_INFINITY.into())])), false),
            (vec![1.0].into(), true),
            (None::<f64>.into(), true),
        ] {
            assert_eq!(value.is_finite(), finite, "{value:?}");
        }
    }
}
