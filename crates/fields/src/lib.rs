//! Values under keys: what is known of a thing as data, before it is written as JSON or CSV.

use serde::ser::{Serialize, Serializer};

/// What a field says.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldValue {
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
    List(Vec<FieldValue>),
    /// Fields of its own: columns of their own in CSV; null in JSON if every one of them is missing.
    Object(DataRow),
    /// Fields of one of a list, and the words for them in a cell.
    Worded(DataRow, String),
}

/// Keys, which are also the columns, with their values.
#[derive(Clone, Debug, PartialEq)]
pub struct DataRow(pub Vec<(&'static str, FieldValue)>);

impl FieldValue {
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
}

impl DataRow {
    /// Whether every field of it is missing.
    pub fn is_empty(&self) -> bool {
        self.0.iter().all(|(_, value)| *value == FieldValue::Missing)
    }
}

impl Serialize for DataRow {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

impl Serialize for FieldValue {
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

impl From<bool> for FieldValue {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

impl From<u32> for FieldValue {
    fn from(count: u32) -> Self {
        Self::Count(count.into())
    }
}

impl From<usize> for FieldValue {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

impl From<f64> for FieldValue {
    /// A zero has no sign.
    fn from(number: f64) -> Self {
        Self::Number(number + 0.0)
    }
}

impl From<&str> for FieldValue {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for FieldValue {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl<T: Into<FieldValue>> From<Option<T>> for FieldValue {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Missing, T::into)
    }
}

impl<T: Into<FieldValue>> From<Vec<T>> for FieldValue {
    fn from(values: Vec<T>) -> Self {
        Self::List(values.into_iter().map(T::into).collect())
    }
}

/// Things one after the other in words.
///
/// ```
/// use geneva_fields::joined_with_and;
///
/// let things = ["a".to_owned(), "b".to_owned(), "c".to_owned()];
/// assert_eq!([joined_with_and(&things[..1]), joined_with_and(&things[..2]), joined_with_and(&things)], ["a", "a and b", "a, b and c"]);
/// assert_eq!(joined_with_and(&[]), "");
/// ```
pub fn joined_with_and(things: &[String]) -> String {
    match things {
        [] => String::new(),
        [only] => only.clone(),
        [others @ .., last] => format!("{} and {last}", others.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_that_is_none_is_found_wherever_it_is() {
        for (value, finite) in [
            (FieldValue::from(f64::NAN), false),
            (vec![1.0, f64::INFINITY].into(), false),
            (FieldValue::Object(DataRow(vec![("x", f64::NEG_INFINITY.into())])), false),
            (vec![1.0].into(), true),
            (None::<f64>.into(), true),
        ] {
            assert_eq!(value.is_finite(), finite, "{value:?}");
        }
    }
}
