//! What is told as data: keys with values, a row of them, JSON and CSV.
//!
//! In JSON a list of fields is an object, in CSV a row.

use serde::ser::{Serialize, Serializer};

/// What a field says.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Nothing is known, or nothing was asked for: null in JSON, an empty cell.
    Missing,
    /// Whether something is so.
    Flag(bool),
    /// How many.
    Count(u64),
    /// A number, which JSON and CSV write with all its digits.
    Number(f64),
    /// A word or a sentence.
    Text(String),
    /// Several, with semicolons between them in a cell.
    List(Vec<Value>),
    /// Fields of its own: columns of their own in CSV; null in JSON if every one of them is missing.
    Object(Row),
    /// Fields of one of a list, and the words for them in a cell.
    Worded(Row, String),
}

/// Keys, which are also the columns, with their values.
#[derive(Clone, Debug, PartialEq)]
pub struct Row(pub Vec<(&'static str, Value)>);

impl Value {
    /// Whether every number in it is one.
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Number(number) => number.is_finite(),
            Self::List(values) => values.iter().all(Self::is_finite),
            Self::Object(row) | Self::Worded(row, _) => row.0.iter().all(|(_, value)| value.is_finite()),
            Self::Missing | Self::Flag(_) | Self::Count(_) | Self::Text(_) => true,
        }
    }

    /// What it is in JSON, and its place among what one field may be: what says nothing comes last.
    pub fn kind(&self) -> (u8, &'static str) {
        match self {
            Self::Flag(_) => (0, "true or false"),
            Self::Count(_) | Self::Number(_) => (1, "number"),
            Self::Text(_) => (2, "text"),
            Self::List(_) => (3, "list"),
            Self::Object(row) if row.is_empty() => (5, "null"),
            Self::Object(_) | Self::Worded(..) => (4, "object"),
            Self::Missing => (5, "null"),
        }
    }

    /// As it stands in a cell: a number as in JSON.
    fn cell(&self) -> String {
        match self {
            Self::Missing | Self::Object(_) => String::new(),
            Self::Flag(flag) => flag.to_string(),
            Self::Count(count) => count.to_string(),
            Self::Number(number) => serde_json::to_string(number).unwrap_or_default(),
            Self::Text(text) | Self::Worded(_, text) => text.clone(),
            Self::List(values) => values.iter().map(Self::cell).collect::<Vec<_>>().join("; "),
        }
    }
}

impl Row {
    /// Whether every field of it is missing.
    fn is_empty(&self) -> bool {
        self.0.iter().all(|(_, value)| *value == Value::Missing)
    }

    /// The names of the cells: the keys, those of an object behind its own.
    fn columns(&self) -> Vec<String> {
        let names = self.0.iter().flat_map(|(key, value)| match value {
            Value::Object(inner) => inner.columns().iter().map(|column| format!("{key}_{column}")).collect(),
            _ => vec![(*key).to_owned()],
        });
        names.collect()
    }

    fn cells(&self) -> Vec<String> {
        let cells = self.0.iter().flat_map(|(_, value)| match value {
            Value::Object(inner) => inner.cells(),
            other => vec![other.cell()],
        });
        cells.collect()
    }
}

/// A header, which is that of any such row, and the rows.
pub fn csv(any: Option<&Row>, rows: impl IntoIterator<Item = Row>) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    if let Some(any) = any {
        writer.write_record(any.columns())?;
    }
    for row in rows {
        writer.write_record(row.cells())?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// Something in JSON, for reading and for programs.
pub fn json(said: &impl Serialize) -> anyhow::Result<String> {
    Ok(serde_json::to_string_pretty(said)? + "\n")
}

impl Serialize for Row {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Missing => serializer.serialize_none(),
            Self::Flag(flag) => serializer.serialize_bool(*flag),
            Self::Count(count) => serializer.serialize_u64(*count),
            Self::Number(number) => serializer.serialize_f64(*number),
            Self::Text(text) => serializer.serialize_str(text),
            Self::List(values) => serializer.collect_seq(values),
            Self::Object(row) if row.is_empty() => serializer.serialize_none(),
            Self::Object(row) | Self::Worded(row, _) => row.serialize(serializer),
        }
    }
}

impl From<bool> for Value {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

impl From<u32> for Value {
    fn from(count: u32) -> Self {
        Self::Count(count.into())
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl<T: Into<Value>> From<Option<T>> for Value {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Missing, T::into)
    }
}

impl<T: Into<Value>> From<Vec<T>> for Value {
    fn from(values: Vec<T>) -> Self {
        Self::List(values.into_iter().map(T::into).collect())
    }
}
