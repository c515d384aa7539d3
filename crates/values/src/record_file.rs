//! The record: which texts and values belong together, and an entry for each printed number.
//!
//! People edit it. So an entry is kept as its lines, and only the lines that say where its number is are ever written anew.

use crate::values::exact_decimal;
use geneva_evidence::nearest_name;
use geneva_exact::Rational;
use geneva_host::printable::escape_and_shorten;
use std::fmt::Write;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The name of a record in its folder.
pub const RECORD_NAME: &str = "numbers.toml";
/// The line above an entry.
const ENTRY_HEAD: &str = "[[number]]";
/// What a number may be if it is no value; a quotation names its source.
pub const NO_VALUE: [&str; 3] = ["given", "date", "reference"];
const QUOTED: &str = "quoted from ";
const ENTRY_KEYS: [&str; 10] =
    ["text", "before", "printed", "unit", "after", "value", "factor", "none", "candidates", "open"];

/// What a printed number is tied to.
#[derive(Clone, Debug, PartialEq)]
pub enum Tie {
    /// A value under this key, multiplied by a factor before it is compared.
    Value {
        /// The key.
        key: String,
        /// The factor, if there is one; units are then not converted.
        factor: Option<Rational>,
    },
    /// No value: the number is given, a date, a reference, or quoted.
    None(String),
    /// One of several values; a person has to choose.
    Candidates(Vec<String>),
    /// Nothing so far.
    Open,
}

/// An entry of a record.
#[derive(Clone, Debug)]
pub struct NumberEntry {
    /// Its lines, with the comments behind it.
    pub(crate) lines: String,
    /// The text that prints the number.
    pub text: String,
    /// The words before the number.
    pub before: String,
    /// The words after the number and its unit.
    pub after: String,
    /// The characters of the number in one spelling.
    pub printed: String,
    /// The unit in one spelling; empty if there is none.
    pub unit: String,
    /// What the number is tied to.
    pub tie: Tie,
}

/// A record.
#[derive(Clone, Debug, Default)]
pub struct Record {
    /// The lines above the first entry.
    pub(crate) head: String,
    /// The texts, by their paths from the folder of the record.
    pub texts: Vec<String>,
    /// The files of values.
    pub values: Vec<String>,
    /// The files of the values that were computed in a second way.
    pub second: Vec<String>,
    /// The entries in the order of the file.
    pub entries: Vec<NumberEntry>,
}

impl Record {
    /// A record without entries.
    pub(crate) fn new(texts: Vec<String>, values: Vec<String>, second: Vec<String>) -> Self {
        let mut head =
            "# The numbers of these texts, each tied to the value that it prints. `geneva record` adds what is new\n\
                        # and keeps what you decide: change an `open` or `candidates` to value = \"KEY\", or to none = \"given\",\n\
                        # \"date\", \"reference\" or \"quoted from …\" for a number that no program computes.\n"
                .to_owned();
        let list = |names: &[String]| names.iter().map(|name| quoted(name)).collect::<Vec<_>>().join(", ");
        for (name, files) in [("texts", &texts), ("values", &values), ("second", &second)] {
            if name != "second" || !files.is_empty() {
                let _ = writeln!(head, "{name} = [{}]", list(files));
            }
        }
        Self { head, texts, values, second, entries: Vec::new() }
    }

    /// Reads a record.
    ///
    /// # Errors
    ///
    /// It is no TOML, or an entry isn't one. The message names the line, and what may be written there.
    pub fn parse(text: &str) -> Result<Self, String> {
        let line_of = |at: usize| text.as_bytes().iter().take(at).filter(|byte| **byte == b'\n').count() + 1;
        let table = DeTable::parse(text).map_err(|error| {
            let line = error.span().map_or(1, |span| line_of(span.start));
            format!("line {line}: {}", error.message())
        })?;
        let table = table.get_ref();
        let mut record = Self::default();
        for (name, value) in table {
            let list = || strings(value).ok_or_else(|| format!("`{}` must be a list of file names", name.get_ref()));
            match &**name.get_ref() {
                "texts" => record.texts = list()?,
                "values" => record.values = list()?,
                "second" => record.second = list()?,
                "number" => {}
                other => {
                    return Err(unknown(other, line_of(name.span().start), ["texts", "values", "second", "number"]));
                }
            }
        }
        for (name, files) in [("texts", &record.texts), ("values", &record.values)] {
            if files.is_empty() {
                return Err(format!("`{name}` names no file; write {name} = [\"…\"] at the top"));
            }
        }
        let mut blocks = blocks(text);
        record.head = blocks.remove(0);
        let Some(numbers) = table.get("number") else { return Ok(record) };
        let numbers = numbers.get_ref().as_array();
        let numbers = numbers.filter(|numbers| numbers.len() == blocks.len());
        let numbers = numbers.ok_or_else(|| format!("each entry must begin with a line {ENTRY_HEAD}"))?;
        // Lines are counted once: an entry is as far behind the one before it as that one is long.
        let mut line = record.head.matches('\n').count() + 1;
        for (number, lines) in numbers.iter().zip(blocks) {
            let length = lines.matches('\n').count();
            let entry = number.get_ref().as_table().ok_or_else(|| "an entry must be a table".to_owned());
            let entry = entry.and_then(|table| entry_of(table, lines, &record.texts));
            record.entries.push(entry.map_err(|why| format!("the entry in line {line}: {why}"))?);
            line += length;
        }
        Ok(record)
    }

    /// The record as it is written.
    pub(crate) fn to_text(&self) -> String {
        let mut out = self.head.clone();
        for entry in &self.entries {
            if !out.is_empty() && !out.ends_with("\n\n") {
                out.push('\n');
            }
            out += &entry.lines;
        }
        out
    }
}

/// The text above the first entry, and that of each entry.
fn blocks(text: &str) -> Vec<String> {
    let mut blocks = vec![String::new()];
    for line in text.split_inclusive('\n') {
        if line.trim_end() == ENTRY_HEAD {
            blocks.push(String::new());
        }
        if let Some(block) = blocks.last_mut() {
            *block += line;
        }
    }
    blocks.iter_mut().filter(|block| !block.is_empty() && !block.ends_with('\n')).for_each(|block| block.push('\n'));
    blocks
}

fn unknown<'n>(name: &str, line: usize, known: impl IntoIterator<Item = &'n str>) -> String {
    let nearest = nearest_name(name, known).map(|near| format!("; the nearest name is `{near}`")).unwrap_or_default();
    format!("line {line}: `{}` means nothing here{nearest}", escape_and_shorten(name))
}

fn strings(value: &Spanned<DeValue<'_>>) -> Option<Vec<String>> {
    let items = value.get_ref().as_array()?;
    items.iter().map(|item| item.get_ref().as_str().map(str::to_owned)).collect()
}

fn entry_of(table: &DeTable<'_>, lines: String, texts: &[String]) -> Result<NumberEntry, String> {
    for name in table.keys() {
        if !ENTRY_KEYS.contains(&&**name.get_ref()) {
            let near = nearest_name(name.get_ref(), ENTRY_KEYS).unwrap_or_default();
            return Err(format!(
                "`{}` means nothing here; the nearest name is `{near}`",
                escape_and_shorten(name.get_ref())
            ));
        }
    }
    let text = |name: &str| table.get(name).map(|value| value.get_ref().as_str().map(str::to_owned));
    let optional = |name: &str| match text(name) {
        Some(None) => Err(format!("`{name}` must be a text in quotation marks")),
        found => Ok(found.flatten()),
    };
    let required = |name: &str| optional(name)?.ok_or_else(|| format!("`{name}` is missing"));
    let of_text = required("text")?;
    if !texts.contains(&of_text) {
        let near = nearest_name(&of_text, texts.iter().map(String::as_str)).unwrap_or_default();
        return Err(format!("`{}` is not one of `texts`; the nearest is `{near}`", escape_and_shorten(&of_text)));
    }
    let factor = optional("factor")?.map(|factor| exact_decimal(&factor).map_err(|why| format!("`factor`: {why}")));
    let factor = factor.transpose()?;
    let candidates = table.get("candidates").map(|value| strings(value).ok_or("`candidates` must be a list of keys"));
    let is_open = table.get("open").is_some_and(|value| value.get_ref().as_bool() == Some(true));
    let mut ties = Vec::new();
    ties.extend(optional("value")?.map(|key| Tie::Value { key, factor: factor.clone() }));
    ties.extend(optional("none")?.map(Tie::None));
    ties.extend(candidates.transpose()?.map(Tie::Candidates));
    ties.extend(is_open.then_some(Tie::Open));
    let choice = "an entry needs one of `value`, `none`, `candidates` and `open = true`";
    let tie = if ties.len() > 1 { None } else { ties.pop() }.ok_or(choice)?;
    if factor.is_some() && !matches!(tie, Tie::Value { .. }) {
        return Err("`factor` goes with `value` alone".to_owned());
    }
    if let Tie::None(kind) = &tie
        && !NO_VALUE.contains(&&**kind)
        && kind.strip_prefix(QUOTED).is_none_or(|source| source.trim().is_empty())
    {
        let kind = escape_and_shorten(kind);
        return Err(format!("none = \"{kind}\" must be given, date, reference, or quoted from and the source"));
    }
    Ok(NumberEntry {
        lines,
        text: of_text,
        before: required("before")?,
        after: required("after")?,
        printed: required("printed")?,
        unit: optional("unit")?.unwrap_or_default(),
        tie,
    })
}

impl NumberEntry {
    /// A new entry, with a factor as it is to be written.
    pub(crate) fn new(place: Place, tie: Tie, factor: Option<&str>) -> Self {
        let mut lines = format!("{ENTRY_HEAD}\n");
        for (name, text) in place.lines() {
            if name != "unit" || !text.is_empty() {
                let _ = writeln!(lines, "{name} = {}", quoted(text));
            }
        }
        let _ = match &tie {
            Tie::Value { key, .. } => writeln!(lines, "value = {}", quoted(key)),
            Tie::None(kind) => writeln!(lines, "none = {}", quoted(kind)),
            Tie::Candidates(keys) => {
                let keys: Vec<String> = keys.iter().map(|key| quoted(key)).collect();
                writeln!(lines, "candidates = [{}]", keys.join(", "))
            }
            Tie::Open => writeln!(lines, "open = true"),
        };
        if let Some(factor) = factor {
            let _ = writeln!(lines, "factor = {}", quoted(factor));
        }
        let Place { text, before, printed, unit, after } = place;
        Self { lines, text, before, after, printed, unit, tie }
    }

    /// Adds a comment for the person who reviews the record.
    pub(crate) fn remark(&mut self, what: &str) {
        let _ = writeln!(self.lines, "# {what}");
    }

    /// Says anew where the number is and how it is printed; all other lines stay as they are.
    pub(crate) fn move_to(&mut self, place: Place) {
        let mut out = String::with_capacity(self.lines.len());
        let mut has_unit = false;
        for line in self.lines.split_inclusive('\n') {
            let name = line.split('=').next().unwrap_or_default().trim();
            has_unit |= name == "unit";
            match place.lines().into_iter().find(|(known, _)| *known == name && line.contains('=')) {
                Some((_, text)) => {
                    let _ = writeln!(out, "{name} = {}", quoted(text));
                }
                None => out += line,
            }
            if name == "printed" && !self.lines.contains("\nunit =") && !place.unit.is_empty() && !has_unit {
                let _ = writeln!(out, "unit = {}", quoted(&place.unit));
            }
        }
        let Place { text, before, printed, unit, after } = place;
        let tie = self.tie.clone();
        *self = Self { lines: out, text, before, after, printed, unit, tie };
    }
}

/// Where a number is, and how it is printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub text: String,
    pub before: String,
    pub printed: String,
    pub unit: String,
    pub after: String,
}

impl Place {
    fn lines(&self) -> [(&'static str, &str); 5] {
        [
            ("text", &self.text),
            ("before", &self.before),
            ("printed", &self.printed),
            ("unit", &self.unit),
            ("after", &self.after),
        ]
    }
}

/// A text as TOML quotes it.
fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "texts = [\"a.md\"]\nvalues = [\"v.json\"]\n";

    #[test]
    fn an_entry_is_read_and_moved_with_its_comments() {
        let lines = "[[number]]\ntext = \"a.md\"\nbefore = \"it is\"\nprinted = \"2\"\nafter = \"\"\n# ours\nvalue = 'k' # sure\n";
        let mut record = Record::parse(&format!("{HEAD}\n{lines}")).expect("a record");
        assert_eq!(record.entries[0].tie, Tie::Value { key: "k".to_owned(), factor: None });
        assert_eq!(record.to_text(), format!("{HEAD}\n{lines}"));
        let [text, before, printed, unit, after] = ["a.md", "it \"was\"", "3", "s", "now"].map(str::to_owned);
        record.entries[0].move_to(Place { text, before, printed, unit, after });
        let moved = record.to_text();
        assert!(
            moved.contains("before = \"it \\\"was\\\"\"\nprinted = \"3\"\nunit = \"s\"\nafter = \"now\"\n# ours\n")
        );
        assert!(moved.ends_with("value = 'k' # sure\n"), "{moved}");
        let again = Record::parse(&moved).expect("a record");
        assert_eq!(again.entries[0].before, "it \"was\"");
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        let entry = |more: &str| {
            format!("{HEAD}[[number]]\ntext = \"a.md\"\nbefore = \"\"\nprinted = \"2\"\nafter = \"\"\n{more}\n")
        };
        for (text, words) in [
            (entry(""), "line 3: an entry needs one of"),
            (entry("value = \"a\"\nopen = true"), "needs one of"),
            (entry("vlaue = \"a\""), "the nearest name is `value`"),
            (entry("none = \"guess\""), "must be given, date, reference"),
            (entry("none = \"quoted from \""), "must be given, date, reference"),
            (entry("value = \"a\"\nfactor = \"x\""), "`factor`: `x` is not a decimal number"),
            (entry("none = \"date\"\nfactor = \"2\""), "goes with `value` alone"),
            (entry("open = true").replace("text = \"a.md\"", "text = \"b.md\""), "is not one of `texts`"),
            ("texts = [\"a.md\"]\n".to_owned(), "`values` names no file"),
            ("txts = 1".to_owned(), "the nearest name is `texts`"),
            ("= 1".to_owned(), "line 1: "),
        ] {
            let said = Record::parse(&text).expect_err(&text);
            assert!(said.contains(words), "{text}\n{said}");
        }
    }
}
