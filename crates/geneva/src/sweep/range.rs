//! Ranges of values: from, to, how many, how spaced.

use crate::typed::{self, as_typed, number, rounded};
use anyhow::ensure;
use clap::ValueEnum;
use geneva_ask::typed_number::{TypedNumber, advice};

/// How the values of a range are spaced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Spacing {
    /// Equal differences between neighbouring values
    #[default]
    Linear,
    /// Equal ratios of neighbouring values; only for values above zero
    Log,
}

/// A range as it was typed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    from: f64,
    to: f64,
    count: u64,
    spacing: Option<Spacing>,
}

/// How a range is written.
const FORM: &str = "not a range; give FROM:TO:COUNT, such as 0.1:0.3:5, or FROM:TO:COUNT:log, or a single number";

impl Range {
    /// A range of numbers above zero.
    pub(crate) fn positive(text: &str) -> Result<Self, String> {
        Self::of(text, typed::positive)
    }

    /// A range of numbers that are zero or more.
    pub(crate) fn zero_or_more(text: &str) -> Result<Self, String> {
        Self::of(text, typed::zero_or_more)
    }

    /// A range whose ends can be typed as `value` reads them; what is between them can be too.
    fn of(text: &str, value: fn(&str) -> Result<f64, String>) -> Result<Self, String> {
        let wrong = |text: &str| advice(text, TypedNumber::Plain).unwrap_or_else(|| FORM.to_owned());
        let value = |text: &str| if number(text).is_some() { value(text) } else { Err(wrong(text)) };
        let parts: Vec<_> = text.split(':').map(str::trim).collect();
        let (from, to, count, spacing) = match parts[..] {
            [only] => return value(only).map(|value| Self { from: value, to: value, count: 1, spacing: None }),
            [from, to, count] => (from, to, count, None),
            [from, to, count, spacing] => (from, to, count, Some(Spacing::from_str(spacing, false))),
            _ => return Err(FORM.to_owned()),
        };
        let spacing =
            spacing.transpose().map_err(|_| format!("'{}' is not a spacing; give linear or log", parts[3]))?;
        let count = count.parse().ok().filter(|count| *count > 0);
        let count = count.ok_or("the COUNT of a range must be an integer; give 1 or more")?;
        let range = Self { from: value(from)?, to: value(to)?, count, spacing };
        if (range.from == range.to) != (range.count == 1) {
            let count = range.count;
            return Err(format!(
                "{from}:{to}:{count} is not a range; give two different ends and a COUNT of 2 or more, or a single number"
            ));
        }
        Ok(range)
    }

    /// How many values it has.
    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    /// The values of a range; `option` names it in errors.
    pub(crate) fn values(&self, option: &str, usual: Spacing) -> anyhow::Result<Vec<f64>> {
        let spacing = self.spacing.unwrap_or(usual);
        ensure!(
            spacing == Spacing::Linear || (self.from > 0.0 && self.to > 0.0) || self.count == 1,
            "{option} {}:{}:{}: equal ratios can't start or end at zero; give ends above zero, or linear spacing",
            as_typed(self.from),
            as_typed(self.to),
            self.count
        );
        Ok((0..self.count).map(|number| self.value(number, spacing)).collect())
    }

    /// Ends as they were typed; what is between is rounded to digits that can be typed again.
    fn value(&self, number: u64, spacing: Spacing) -> f64 {
        if number == 0 {
            return self.from;
        }
        if number + 1 == self.count {
            return self.to;
        }
        let part = number as f64 / (self.count - 1) as f64;
        let value = match spacing {
            Spacing::Linear => self.from + (self.to - self.from) * part,
            Spacing::Log => self.from * libm::pow(self.to / self.from, part),
        };
        rounded(value)
    }
}

#[cfg(test)]
mod tests {
    use super::{Range, Spacing};

    fn values(text: &str, spacing: Spacing) -> Vec<f64> {
        Range::zero_or_more(text).unwrap().values("--option", spacing).unwrap()
    }

    #[test]
    fn values_are_those_that_a_reader_would_type() {
        assert_eq!(values("0.1:0.7:7", Spacing::Linear), [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]);
        assert_eq!(values("1e-3:1:4:log", Spacing::Linear), [1e-3, 1e-2, 1e-1, 1.0]);
        assert_eq!(values("8:1:4", Spacing::Log), [8.0, 4.0, 2.0, 1.0]);
        assert_eq!(values("0:1:3:linear", Spacing::Log), [0.0, 0.5, 1.0]);
        assert_eq!(values("0", Spacing::Log), [0.0]);
        assert_eq!(values("2:2:1", Spacing::Linear), [2.0]);
    }

    #[test]
    fn what_is_no_range_is_told() {
        for text in ["", ":", "1:2", "1:2:3:4:5", "1:2:x", "1:2:0", "1:2:-3", "1:2:1", "2:2:5", "1:2:3:loud", "a:2:3"] {
            assert!(Range::zero_or_more(text).unwrap_err().contains("give "), "{text}");
        }
        assert!(Range::positive("0:1:3").unwrap_err().contains("above zero"));
        assert!(Range::zero_or_more("0:1:3:log").unwrap().values("--friction", Spacing::Linear).is_err());
    }
}
