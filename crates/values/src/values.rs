//! The values that a program computed: files in JSON, CSV or TOML to exact numbers under keys.

use crate::printed_unit::unit_in_one_spelling;
use dashu_int::{IBig, UBig};
use geneva_exact::{Field, Rational};
use geneva_host::printable::escape_and_shorten;
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;
use std::collections::HashMap;
use std::fmt;
use toml::de::{DeTable, DeValue};

/// Greatest power of ten of a value, either way.
pub const GREATEST_EXPONENT: i32 = 1000;
/// Most digits of a value.
pub const MOST_DIGITS: usize = 1000;
/// Deepest nesting of a file of values.
const DEEPEST: usize = 64;

/// A value under a key.
#[derive(Clone, Debug)]
pub struct ComputedValue {
    /// The key; keys within keys are joined by points, and places in a list count from 0.
    pub key: String,
    /// The number as it is in the file.
    pub characters: String,
    /// The number, exactly.
    pub exact: Rational,
    /// The nearest `f64`, to find it quickly.
    pub(crate) nearest: f64,
    /// The unit in one spelling, if the file gives one.
    pub unit: Option<String>,
}

/// The values of one or more files.
#[derive(Clone, Debug, Default)]
pub struct Values {
    all: Vec<ComputedValue>,
    by_key: HashMap<String, (usize, String)>,
}

impl Values {
    /// The values in the order of their files.
    pub fn computed(&self) -> &[ComputedValue] {
        &self.all
    }

    /// The value under a key.
    pub fn get(&self, key: &str) -> Option<&ComputedValue> {
        self.by_key.get(key).map(|(at, _)| &self.all[*at])
    }

    /// Adds the values of a file, whose name tells its format: `.json`, `.csv` or `.toml`.
    ///
    /// # Errors
    ///
    /// The file is in none of the formats, a key is there twice, or something is no number that can be used. The message names
    /// the file and the key.
    ///
    /// ```
    /// use geneva_values::Values;
    ///
    /// let mut values = Values::default();
    /// values.add("values.json", r#"{"swing": {"period": 2.006, "width": "3.2 mm"}}"#)?;
    /// let width = values.get("swing.width").expect("a value");
    /// assert_eq!((&*width.characters, width.unit.as_deref()), ("3.2", Some("mm")));
    /// let twice = values.add("more.csv", "name,value\nswing.period,2\n").expect_err("it is there already");
    /// assert!(twice.contains("more.csv: key swing.period is in values.json already"));
    /// # Ok::<(), String>(())
    /// ```
    pub fn add(&mut self, file: &str, text: &str) -> Result<(), String> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut found = Vec::new();
        let extension = file.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
        let read = match extension.as_str() {
            "json" => read_json(text, &mut found),
            "csv" => read_csv(text, &mut found),
            "toml" => read_toml(text, &mut found),
            _ => Err("a file of values is named .json, .csv or .toml; rename it".to_owned()),
        };
        read.map_err(|why| format!("{file}: {why}"))?;
        for value in found {
            let shown = escape_and_shorten(&value.key);
            if let Some((_, earlier)) = self.by_key.get(&value.key) {
                return Err(match earlier == file {
                    true => format!("{file}: key {shown} is there twice; keep one of them"),
                    false => format!("{file}: key {shown} is in {earlier} already; give it another name"),
                });
            }
            self.by_key.insert(value.key.clone(), (self.all.len(), file.to_owned()));
            self.all.push(value);
        }
        Ok(())
    }
}

/// The exact number of characters such as `-1.5e-3`.
///
/// # Errors
///
/// They are no finite decimal number, or one with too many digits or too great a power of ten.
pub(crate) fn exact_decimal(characters: &str) -> Result<Rational, String> {
    let lower = characters.trim().to_ascii_lowercase();
    let unsigned = lower.trim_start_matches(['-', '+']);
    if unsigned.starts_with("nan") || unsigned.starts_with("inf") {
        return Err(format!("{} is not a finite number; write a number, or leave the key out", characters.trim()));
    }
    let shown = escape_and_shorten(characters);
    let wrong = || format!("`{shown}` is not a decimal number");
    let (mantissa, exponent) = lower.split_once('e').unwrap_or((&lower, "0"));
    let exponent: i32 = exponent.parse().map_err(|_| match exponent.trim_start_matches(['-', '+']).parse::<f64>() {
        Ok(_) => format!("the power of ten of {shown} is beyond {GREATEST_EXPONENT}, the greatest that is read"),
        Err(_) => wrong(),
    })?;
    if exponent.abs() > GREATEST_EXPONENT {
        return Err(format!(
            "the power of ten of {shown} is beyond the range from -{GREATEST_EXPONENT} to {GREATEST_EXPONENT}"
        ));
    }
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{}{fraction}", whole.trim_start_matches(['-', '+']));
    let one_sign = whole.len() - whole.trim_start_matches(['-', '+']).len() <= 1;
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) || !one_sign {
        return Err(wrong());
    }
    if digits.len() > MOST_DIGITS {
        return Err(format!("{shown} has more than {MOST_DIGITS} digits, the most that are read"));
    }
    let digits: IBig = digits.parse().map_err(|_| wrong())?;
    let exponent = exponent - fraction.len() as i32;
    let scale = power_of_ten(exponent.unsigned_abs());
    let size = match exponent < 0 {
        true => Rational::from_parts(digits, scale),
        false => Rational::from(digits * IBig::from(scale)),
    };
    Ok(if whole.starts_with('-') { -size } else { size })
}

/// Ten to a power.
pub(crate) fn power_of_ten(exponent: u32) -> UBig {
    UBig::from(10u8).pow(exponent as usize)
}

/// Adds a number with a unit, which may be empty.
fn push(key: &str, characters: &str, unit: &str, out: &mut Vec<ComputedValue>) -> Result<(), String> {
    let characters = characters.trim().replace('_', "");
    let shown = escape_and_shorten(key);
    let exact = exact_decimal(&characters).map_err(|why| format!("key {shown}: {why}"))?;
    let unit = unit.trim();
    let known = unit_in_one_spelling(unit);
    if known.is_none() && !unit.is_empty() && unit != "1" {
        let unit = escape_and_shorten(unit);
        return Err(format!("key {shown}: the unit `{unit}` is not known; write one such as mm, m/s^2 or %, or none"));
    }
    let nearest = exact.approximate();
    out.push(ComputedValue { key: key.to_owned(), characters, exact, nearest, unit: known });
    Ok(())
}

/// Adds a text that is a number with a unit, such as `3.2 mm`; other texts are no values.
fn push_text(key: &str, text: &str, out: &mut Vec<ComputedValue>) -> Result<(), String> {
    let text = text.trim();
    let is_special = ["nan", "inf", "infinity"].contains(&&*text.trim_start_matches(['-', '+']).to_ascii_lowercase());
    let is_of_number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E');
    let mut end = text.find(|c| !is_of_number(c)).unwrap_or(text.len());
    // The unit `eV` begins as a power of ten does.
    while end > 0 && text[..end].ends_with(|c: char| !c.is_ascii_digit()) {
        end -= 1;
    }
    let (number, unit) = text.split_at(end);
    if is_special
        || (exact_decimal(number).is_ok() && (unit.trim().is_empty() || unit_in_one_spelling(unit.trim()).is_some()))
    {
        return push(key, if is_special { text } else { number }, unit, out);
    }
    Ok(())
}

fn joined(key: &str, name: &str) -> String {
    if key.is_empty() { name.to_owned() } else { format!("{key}.{name}") }
}

/// An object of JSON with its keys as they come.
struct Object<'t>(Vec<(String, &'t RawValue)>);

impl<'de: 't, 't> serde::Deserialize<'de> for Object<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Pairs;
        impl<'de> Visitor<'de> for Pairs {
            type Value = Vec<(String, &'de RawValue)>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut pairs = Vec::new();
                while let Some(pair) = map.next_entry()? {
                    pairs.push(pair);
                }
                Ok(pairs)
            }
        }
        deserializer.deserialize_map(Pairs).map(Object)
    }
}

/// A list of JSON.
struct List<'t>(Vec<&'t RawValue>);

impl<'de: 't, 't> serde::Deserialize<'de> for List<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Items;
        impl<'de> Visitor<'de> for Items {
            type Value = Vec<&'de RawValue>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
                let mut items = Vec::new();
                while let Some(item) = list.next_element()? {
                    items.push(item);
                }
                Ok(items)
            }
        }
        deserializer.deserialize_seq(Items).map(List)
    }
}

fn read_json(text: &str, out: &mut Vec<ComputedValue>) -> Result<(), String> {
    let whole: &RawValue = serde_json::from_str(text).map_err(|error| special_in_json(text, &error))?;
    if !whole.get().starts_with('{') {
        return Err("the values must be in an object, such as {\"period\": 2.006}".to_owned());
    }
    json(whole, "", 0, out)
}

/// What is wrong in a text that is no JSON: often a value that other programs write and JSON does not have.
fn special_in_json(text: &str, error: &serde_json::Error) -> String {
    let start = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum::<usize>();
    let at = (start + error.column()).min(text.len());
    let at = (0..=at).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    let before = &text[..at];
    let word_start = before.trim_end_matches(|c: char| c.is_ascii_alphabetic() || c == '-').len();
    let word = text[word_start..].split(|c: char| !(c.is_ascii_alphabetic() || c == '-')).next().unwrap_or_default();
    if ["NaN", "Infinity", "-Infinity", "nan", "inf", "-inf"].contains(&word) {
        // The key is the last text before a colon.
        let key = before[..word_start].rsplit_once(':').map_or("", |(before, _)| before.trim_end());
        let key = key.trim_end_matches('"').rsplit('"').next().unwrap_or_default();
        let key = escape_and_shorten(key);
        return format!("key {key}: {word} is not a finite number; write a number, or leave the key out");
    }
    format!("this is not JSON: {error}")
}

fn json(value: &RawValue, key: &str, depth: usize, out: &mut Vec<ComputedValue>) -> Result<(), String> {
    let wrong = |error: serde_json::Error| format!("key {}: {error}", escape_and_shorten(key));
    let source = value.get();
    if depth > DEEPEST {
        return Err(format!("key {}: nested more than {DEEPEST} deep", escape_and_shorten(key)));
    }
    match source.as_bytes().first() {
        Some(b'{') => {
            let Object(pairs) = serde_json::from_str(source).map_err(wrong)?;
            let of = |name: &str| pairs.iter().find(|(key, _)| key == name).map(|(_, value)| value.get());
            let is_quantity = pairs.iter().all(|(key, _)| matches!(&**key, "value" | "unit"));
            if let (true, Some(number)) = (is_quantity && pairs.len() == 2, of("value")) {
                let unit = of("unit").and_then(|unit| serde_json::from_str::<String>(unit).ok()).unwrap_or_default();
                let text = serde_json::from_str::<String>(number).unwrap_or_else(|_| number.to_owned());
                return push(key, &text, &unit, out);
            }
            for (name, value) in pairs {
                json(value, &joined(key, &name), depth + 1, out)?;
            }
            Ok(())
        }
        Some(b'[') => {
            let List(items) = serde_json::from_str(source).map_err(wrong)?;
            items
                .into_iter()
                .enumerate()
                .try_for_each(|(at, item)| json(item, &joined(key, &at.to_string()), depth + 1, out))
        }
        Some(b'"') => push_text(key, &serde_json::from_str::<String>(source).map_err(wrong)?, out),
        Some(b't' | b'f' | b'n') | None => Ok(()),
        Some(_) => push(key, source, "", out),
    }
}

fn read_csv(text: &str, out: &mut Vec<ComputedValue>) -> Result<(), String> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| format!("this is not CSV: {error}"))?.clone();
    let column = |name: &str| header.iter().position(|head| head.eq_ignore_ascii_case(name));
    let (Some(name), Some(value)) = (column("name"), column("value")) else {
        return Err("the first line must name the columns name and value, and may name unit".to_owned());
    };
    let unit = column("unit");
    for row in reader.records() {
        let row = row.map_err(|error| format!("this is not CSV: {error}"))?;
        let cell = |at: usize| row.get(at).unwrap_or_default();
        push(cell(name), cell(value), unit.map_or("", cell), out)?;
    }
    Ok(())
}

fn read_toml(text: &str, out: &mut Vec<ComputedValue>) -> Result<(), String> {
    let table = DeTable::parse(text).map_err(|error| format!("this is not TOML: {}", error.message()))?;
    toml_table(table.get_ref(), "", out)
}

fn toml_table(table: &DeTable<'_>, key: &str, out: &mut Vec<ComputedValue>) -> Result<(), String> {
    let of = |name: &str| table.iter().find(|(key, _)| key.get_ref() == name).map(|(_, value)| value.get_ref());
    if table.len() == 2
        && let (Some(number), Some(unit)) = (of("value"), of("unit").and_then(|unit| unit.as_str()))
        && let Some(characters) = toml_number(number).or_else(|| number.as_str().map(str::to_owned))
    {
        return push(key, &characters, unit, out);
    }
    // In the order of the file, whatever the order in memory.
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(name, _)| name.span().start);
    entries.into_iter().try_for_each(|(name, value)| toml_value(value.get_ref(), &joined(key, name.get_ref()), out))
}

/// The characters of a number in TOML.
fn toml_number(value: &DeValue<'_>) -> Option<String> {
    match value {
        DeValue::Float(float) => Some(float.as_str().to_owned()),
        DeValue::Integer(integer) if integer.radix() == 10 => Some(integer.as_str().to_owned()),
        DeValue::Integer(integer) => {
            i128::from_str_radix(integer.as_str(), integer.radix()).ok().map(|of| of.to_string())
        }
        _ => None,
    }
}

fn toml_value(value: &DeValue<'_>, key: &str, out: &mut Vec<ComputedValue>) -> Result<(), String> {
    match value {
        DeValue::Table(table) => toml_table(table, key, out),
        DeValue::Array(items) => {
            let mut items = items.iter().enumerate();
            items.try_for_each(|(at, item)| toml_value(item.get_ref(), &joined(key, &at.to_string()), out))
        }
        DeValue::String(text) => push_text(key, text, out),
        other => toml_number(other).map_or(Ok(()), |characters| push(key, &characters, "", out)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(file: &str, text: &str) -> Result<Vec<(String, String, String)>, String> {
        let mut values = Values::default();
        values.add(file, text)?;
        let cells = |value: &ComputedValue| {
            (value.key.clone(), value.characters.clone(), value.unit.clone().unwrap_or_default())
        };
        Ok(values.computed().iter().map(cells).collect())
    }

    #[test]
    fn three_formats_give_one_list() {
        let json = r#"{"a": {"b": 1.50, "c": [2, "x", "3.2 mm"]}, "d": {"value": 7e-3, "unit": "m/s²"}, "e": true}"#;
        let toml = "[a]\nb = 1.50\nc = [2, \"x\", \"3.2 mm\"]\n[d]\nvalue = 7e-3\nunit = \"m/s²\"\n";
        let csv = "name,value,unit\na.b,1.50,\na.c.0,2,\na.c.2,3.2,mm\nd,7e-3,m/s²\n";
        let all = read("v.json", json).expect("values");
        assert_eq!(all.len(), 4);
        assert_eq!(all[3], ("d".to_owned(), "7e-3".to_owned(), "m/s^2".to_owned()));
        assert_eq!(read("v.toml", toml).expect("values"), all);
        assert_eq!(read("v.csv", csv).expect("values"), all);
    }

    #[test]
    fn what_is_no_value_is_refused_with_its_key() {
        for (file, text, words) in [
            ("v.json", r#"{"a": 1, "a": 2}"#, "key a is there twice"),
            ("v.json", "{\"a\": {\"drag\": NaN}}", "key drag: NaN is not a finite number"),
            ("v.json", "{\"a\": [1, -Infinity]}", "key a: "),
            ("v.json", r#"{"a": "nan"}"#, "key a: nan is not a finite number"),
            ("v.toml", "a = nan", "key a: nan is not a finite number"),
            ("v.csv", "name,value\na,inf\n", "key a: inf is not a finite number"),
            ("v.csv", "name,value\na,1\na,2\n", "key a is there twice"),
            ("v.csv", "key,value\na,1\n", "must name the columns name and value"),
            ("v.json", r#"{"a": 1e99999}"#, "key a: the power of ten"),
            ("v.json", r#"{"a": {"value": 1, "unit": "blorp"}}"#, "key a: the unit `blorp` is not known"),
            ("v.json", "[1]", "must be in an object"),
            ("v.txt", "1", "is named .json, .csv or .toml"),
        ] {
            let said = read(file, text).expect_err(text);
            assert!(said.starts_with(file) && said.contains(words), "{text}: {said}");
        }
    }

    #[test]
    fn characters_are_kept_beyond_a_float() {
        let values = read("v.json", r#"{"a": 0.1234567890123456789012345}"#).expect("values");
        assert_eq!(values[0].1, "0.1234567890123456789012345");
        assert_eq!(exact_decimal("-1.50e2"), exact_decimal("-150"));
    }
}
