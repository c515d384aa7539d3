//! The fields of an answer: values under keys, with units, names and meanings.

use crate::number_format::{angle, inches, no_greater, number, to_digits};
use geneva_fields::{DataRow, FieldValue};
use serde::ser::{Serialize, Serializer};
use std::borrow::Cow;

/// A value under its key, in its unit, with its name and its meaning where it has a line of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportField {
    /// Its name among the fields, which also says the unit.
    pub key: &'static str,
    /// What it is, with all its digits.
    pub value: FieldValue,
    /// Its unit; nothing for a pure number.
    pub unit: &'static str,
    /// How it is rounded where it is read, unless the reader's text says otherwise.
    pub rounding: Rounding,
    /// Its line of a sheet. It has none if the title or another line says it, or the sheet doesn't need it.
    pub line: Option<SheetLine>,
    /// What the question must give for it to have a value. Only the fields of a wheel say so.
    pub needs: Needs,
    /// Whether a figure that a reader moves lists it although the figure has no place of its own for it.
    pub is_visible_in_live_figure: bool,
}

/// What a value needs of those things that a question about a wheel may leave out: a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needs(u32);

impl Needs {
    /// Nothing but what every question gives.
    pub const NONE: Self = Self(0);
    /// The speed of the driver.
    pub const SPEED: Self = Self(1 << 0);
    /// A length that gives the size of the wheel; for the parts of a wheel, of an external one.
    pub const SIZE: Self = Self(1 << 1);
    /// A moment of inertia: that of the table, or the wheel's own.
    pub const INERTIA: Self = Self(1 << 2);
    /// The moment of inertia of the table and all else that turns with the wheel.
    pub const TABLE_INERTIA: Self = Self(1 << 3);
    /// The torque of the friction that brakes the wheel.
    pub const FRICTION_TORQUE: Self = Self(1 << 4);
    /// Mass and diameter of a round table.
    pub const TABLE: Self = Self(1 << 8);
    /// A driver with more than one pin.
    pub const SECOND_PIN: Self = Self(1 << 5);
    /// The coefficient of friction of a pin in its slot.
    pub const PIN_FRICTION: Self = Self(1 << 6);
    /// A crank angle before a pin enters.
    pub const BEFORE_ENTRY: Self = Self(1 << 7);
    /// The diameter of the wheel's shaft.
    pub const WHEEL_SHAFT: Self = Self(1 << 9);
    /// The diameter of the driver's shaft, in the plane of the wheel and in the plate.
    pub const DRIVER_SHAFT: Self = Self(1 << 10);
    /// The flat of the wheel's shaft.
    pub const WHEEL_FLAT: Self = Self(1 << 11);
    /// The flat of the driver's shaft.
    pub const DRIVER_FLAT: Self = Self(1 << 12);
    /// The screw of the pins.
    pub const PIN_SCREW: Self = Self(1 << 13);

    /// The coefficient of friction of the locking disc.
    pub const DISC_FRICTION: Self = Self(1 << 16);
    /// The coefficient of friction of the bearings.
    pub const BEARING_FRICTION: Self = Self(1 << 17);
    /// A constant friction torque on the driver.
    pub const DRIVER_FRICTION: Self = Self(1 << 18);
    /// A torque that turns the wheel while it should stand.
    pub const HELD_TORQUE: Self = Self(1 << 19);
    /// An overload torque on the driver's arm.
    pub const ARM_TORQUE: Self = Self(1 << 20);
    /// The moment of inertia of what turns with the driver.
    pub const DRIVER_INERTIA: Self = Self(1 << 21);
    /// The torque with which the driver is started.
    pub const DRIVE_TORQUE: Self = Self(1 << 22);
    /// The ratio of the gear between motor and driver.
    pub const GEAR_RATIO: Self = Self(1 << 23);

    /// The process by which the parts are made.
    pub const PROCESS: Self = Self(1 << 24);

    /// All of both.
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether these are all given.
    pub const fn are_met_by(self, given: Self) -> bool {
        self.0 & !given.0 == 0
    }

    /// These, but for others that are not given.
    pub const fn difference(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }
}

/// The line of a field on a sheet: its name, and what its number means.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetLine {
    /// Its name; nothing where the line above has it.
    pub name: &'static str,
    /// What the number means.
    pub meaning: Cow<'static, str>,
    /// Which number it shows.
    pub shows: SheetNumber,
}

/// The number that a line of a sheet shows.
#[derive(Clone, Debug, PartialEq)]
pub enum SheetNumber {
    /// The value, in its unit.
    Value,
    /// The value, in its unit, and then in another one, with that unit.
    Both(String),
    /// The size of a value that is signed or has a direction, in the value's unit, and the direction.
    Size(f64, String),
    /// None: words say it all.
    Words,
}

/// How a number is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To so many digits that count.
    Significant(usize),
    /// To so many digits after the point.
    Decimals(usize),
    /// To so many digits after the point, in per cent.
    Percent(usize),
    /// To so many digits that count, and never up: a limit holds as it is written.
    Limit(usize),
}

impl ReportField {
    /// A value without a unit. It has no line unless it gets one.
    pub fn new(key: &'static str, value: impl Into<FieldValue>) -> Self {
        Self::in_unit(key, value, "")
    }

    /// A value with a unit, without a line: millimetres and degrees to three decimals, all else to four digits.
    pub fn in_unit(key: &'static str, value: impl Into<FieldValue>, unit: &'static str) -> Self {
        let rounding = if matches!(unit, "mm" | "°") { Rounding::Decimals(3) } else { Rounding::Significant(4) };
        Self {
            key,
            value: value.into(),
            unit,
            rounding,
            line: None,
            needs: Needs::NONE,
            is_visible_in_live_figure: false,
        }
    }

    /// The field with its line: a name, and what the number means. What is missing has none.
    pub fn line(self, name: &'static str, meaning: impl Into<Cow<'static, str>>) -> Self {
        if self.value == FieldValue::Missing { self } else { self.with(name, meaning.into(), SheetNumber::Value) }
    }

    /// The field with its line under another that says the same in another unit.
    pub fn in_other_unit(self) -> Self {
        self.line("", "")
    }

    /// The field with a line without a number: words say it all, also of what is missing.
    pub fn words(self, name: &'static str, words: impl Into<Cow<'static, str>>) -> Self {
        self.with(name, words.into(), SheetNumber::Words)
    }

    fn with(self, name: &'static str, meaning: Cow<'static, str>, shows: SheetNumber) -> Self {
        Self { line: Some(SheetLine { name, meaning, shows }), ..self }
    }

    /// The field with another number on its line: the size of what is signed or has a direction, which stands beside it.
    pub fn with_size(mut self, size: f64, direction: String) -> Self {
        if let Some(line) = &mut self.line {
            line.shows = SheetNumber::Size(size, direction);
        }
        self
    }

    /// The number of its line, to the digits of a sheet; nothing where words say it all.
    pub fn on_a_sheet(&self) -> String {
        match (self.line.as_ref().map(|line| &line.shows), &self.value) {
            (Some(SheetNumber::Size(size, _)), _) => number(*size),
            (Some(SheetNumber::Value | SheetNumber::Both(_)), FieldValue::Number(value)) => match self.rounding {
                Rounding::Limit(digits) => to_digits(no_greater(*value, digits), digits),
                _ if self.unit == "°" => angle(*value),
                _ => number(*value),
            },
            (Some(SheetNumber::Value), FieldValue::Count(count)) => count.to_string(),
            _ => String::new(),
        }
    }

    /// The field with its length in millimetres also in inches on its line; all others are left as they are.
    fn beside_inches(mut self) -> Self {
        if let (Some(line), "mm", FieldValue::Number(length)) = (&mut self.line, self.unit, &self.value)
            && line.shows == SheetNumber::Value
        {
            line.shows = SheetNumber::Both(inches(*length, matches!(self.rounding, Rounding::Limit(_))));
        }
        self
    }

    /// The field also on pages: a figure that a reader moves lists it under its name.
    pub fn visible_in_live_figure(self) -> Self {
        Self { is_visible_in_live_figure: true, ..self }
    }

    /// The field with what the question must give for it to have a value. In the module that a page loads it has no needs: no
    /// page asks for them, and they would be a two-hundredth of the module.
    pub fn needing(self, needs: Needs) -> Self {
        if cfg!(target_family = "wasm") { self } else { Self { needs, ..self } }
    }

    /// The fields with these needs, those that have needs of their own left as they are.
    pub(crate) fn all_needing(fields: Vec<Self>, needs: Needs) -> Vec<Self> {
        let needing = |field: Self| if field.needs == Needs::NONE { field.needing(needs) } else { field };
        if cfg!(target_family = "wasm") { fields } else { fields.into_iter().map(needing).collect() }
    }

    /// The field with its own rounding.
    pub fn rounded(self, rounding: Rounding) -> Self {
        Self { rounding, ..self }
    }

    /// Its number, or the size of its vector; none if it is something else or missing.
    pub fn number(&self) -> Option<f64> {
        match &self.value {
            FieldValue::Number(number) => Some(*number),
            FieldValue::Count(count) => Some(*count as f64),
            FieldValue::Object(DataRow(vector)) => match vector.first() {
                Some(("magnitude", FieldValue::Number(size))) => Some(*size),
                _ => None,
            },
            _ => None,
        }
    }

    /// The direction of its vector in degrees; none if it is something else, or a vector that is zero.
    pub fn direction(&self) -> Option<f64> {
        match &self.value {
            FieldValue::Object(DataRow(vector)) => match vector.get(1) {
                Some(("direction_deg", FieldValue::Number(degrees))) => Some(*degrees),
                _ => None,
            },
            _ => None,
        }
    }
}

/// What a question gets: a title, what all numbers have in common, sections of fields, a list, and a closing note. A section
/// without lines has no heading.
#[derive(Clone, Debug, PartialEq)]
pub struct MechanismReport {
    /// What the answer is about.
    pub title: String,
    /// What all numbers have in common.
    pub introduction: &'static str,
    /// Headings with their fields.
    pub sections: Vec<(&'static str, Vec<ReportField>)>,
    /// A list behind the fields, such as instants, and its key.
    pub list: Option<(&'static str, Vec<Item>)>,
    /// What to add to the question for more.
    pub note: String,
}

/// One of a list: a row of data, and a section of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// The heading of the section.
    pub heading: &'static str,
    /// Its fields in the order of the sheet.
    pub fields: Vec<ReportField>,
    /// All of it as data.
    pub row: DataRow,
}

/// A value as it stands in a cell of a table: a number as in JSON.
fn cell(value: &FieldValue) -> String {
    match value {
        FieldValue::Missing | FieldValue::Object(_) => String::new(),
        FieldValue::Flag(flag) => flag.to_string(),
        FieldValue::Count(count) => count.to_string(),
        // Rust and JSON begin exponents at other small numbers.
        FieldValue::Number(number) if (1e-5..1e-4).contains(&number.abs()) => number.to_string(),
        FieldValue::Number(number) => format!("{number:?}"),
        FieldValue::Text(text) | FieldValue::Worded(_, text) => text.clone(),
        FieldValue::List(values) => values.iter().map(cell).collect::<Vec<_>>().join("; "),
    }
}

/// A cell between quotes if it needs them (RFC 4180).
fn quoted_cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

impl ReportField {
    /// The numbers of the field with their keys and units: one, or those of a vector.
    fn parts(&self) -> Vec<(String, &FieldValue, &'static str)> {
        match &self.value {
            FieldValue::Object(DataRow(parts)) => parts
                .iter()
                .map(|(part, value)| {
                    let unit = if part.ends_with("_deg") { "°" } else { self.unit };
                    (format!("{}_{part}", self.key), value, unit)
                })
                .collect(),
            value => vec![(self.key.to_owned(), value, self.unit)],
        }
    }
}

impl MechanismReport {
    /// All fields of the sections.
    pub fn fields(&self) -> impl Iterator<Item = &ReportField> {
        self.sections.iter().flat_map(|(_, fields)| fields)
    }

    /// The rows of the list.
    pub fn rows(&self) -> impl Iterator<Item = &DataRow> {
        self.list.iter().flat_map(|(_, items)| items).map(|item| &item.row)
    }

    /// The field with this key: of the sections, or of the first of the list.
    pub fn field(&self, key: &str) -> Option<&ReportField> {
        let first = self.list.iter().filter_map(|(_, items)| items.first()).flat_map(|item| &item.fields);
        self.fields().chain(first).find(|field| field.key == key)
    }

    /// All fields as CSV, a row for each number: `key`, `name`, `value`, `unit` and `meaning`.
    ///
    /// The keys are those of the JSON, also of values that are missing. A vector has a row for each of its parts. Where a sheet
    /// leaves out the name because the line above has it, the row has it too.
    pub fn table(&self) -> String {
        let (mut above, mut table) = (("", ""), "key,name,value,unit,meaning\n".to_owned());
        for field in self.fields() {
            let (name, meaning) = field.line.as_ref().map_or(("", ""), |line| {
                above = match (line.name, &*line.meaning) {
                    ("", "") => above,
                    ("", meaning) => (above.0, meaning),
                    own => own,
                };
                above
            });
            for (key, value, unit) in field.parts() {
                let cells = [&key, name, &cell(value), unit, meaning].map(quoted_cell);
                table += &(cells.join(",") + "\n");
            }
        }
        table
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        self.not_finite().is_none()
    }

    /// The answer with each length in millimetres on its sheet also in inches, to a thousandth, or to a ten-thousandth if it is short.
    ///
    /// ```
    /// let sheet = geneva_ask::answer("wheel --stations 6 --crank-radius 25.4")?.beside_inches().plain_sheet();
    /// assert!(sheet.contains(" 2.000 in  "), "{sheet}"); // the centre distance of 50.8 mm
    /// # Ok::<(), geneva_ask::Error>(())
    /// ```
    #[must_use]
    pub fn beside_inches(mut self) -> Self {
        let fields = |fields: Vec<ReportField>| fields.into_iter().map(ReportField::beside_inches).collect();
        self.sections = self.sections.into_iter().map(|(title, of)| (title, fields(of))).collect();
        self.list = self.list.map(|(key, items)| {
            let items = items.into_iter().map(|item| Item { fields: fields(item.fields), ..item });
            (key, items.collect())
        });
        let remark = "Inches are rounded, limits downwards; the millimetres count, and all files are in millimetres.";
        self.note =
            [self.note.as_str(), remark].into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ");
        self
    }

    /// The key of the first number that is not finite, if there is one.
    pub fn not_finite(&self) -> Option<&'static str> {
        let in_rows = self.rows().flat_map(|row| &row.0).map(|(key, value)| (*key, value));
        let all = self.fields().map(|field| (field.key, &field.value)).chain(in_rows);
        all.into_iter().find(|(_, value)| !value.is_finite()).map(|(key, _)| key)
    }
}

impl Serialize for MechanismReport {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let list = self.list.as_ref().map(|(key, items)| {
            (*key, FieldValue::List(items.iter().map(|item| FieldValue::Object(item.row.clone())).collect()))
        });
        let fields = self.fields().map(|field| (field.key, field.value.clone()));
        serializer.collect_map(fields.chain(list))
    }
}
