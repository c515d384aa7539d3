//! Ranges of values: from, to, how many, how spaced.

use crate::escapement::typed::{again, neat, number};
use anyhow::ensure;
use clap::ValueEnum;
use std::str::FromStr;

/// How the values of a range are spaced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Spacing {
    /// Equal differences
    #[default]
    Linear,
    /// Equal ratios; only for values above zero
    Log,
}

/// A range as it was typed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    from: f64,
    to: f64,
    count: u64,
    spacing: Option<Spacing>,
}

/// How a range is written.
const FORM: &str = "not a range; give FROM:TO:COUNT, as 0.1:0.3:5, or FROM:TO:COUNT:log, or a single number";

impl FromStr for Range {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let value = |text: &str| number(text).ok_or_else(|| FORM.to_owned());
        let parts: Vec<_> = text.split(':').map(str::trim).collect();
        let (from, to, count, spacing) = match parts[..] {
            [only] => return value(only).map(|value| Self { from: value, to: value, count: 1, spacing: None }),
            [from, to, count] => (from, to, count, None),
            [from, to, count, spacing] => (from, to, count, Some(Spacing::from_str(spacing, false))),
            _ => return Err(FORM.to_owned()),
        };
        let spacing = spacing.transpose().map_err(|_| format!("'{}' is no spacing; give linear or log", parts[3]))?;
        let count = count.parse().ok().filter(|count| *count > 0);
        let count = count.ok_or("the COUNT of a range is a whole number; give 1 or more")?;
        let range = Self { from: value(from)?, to: value(to)?, count, spacing };
        if (range.from == range.to) != (range.count == 1) {
            let count = range.count;
            return Err(format!(
                "{count} from {from} to {to}: give two different ends and a COUNT of 2 or more, or one number"
            ));
        }
        Ok(range)
    }
}

impl Range {
    /// How many values it has.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The values of an option, each of which `check` finds possible. There must not be too many of them.
    pub fn values(
        &self,
        option: &str,
        usual: Spacing,
        check: impl Fn(&str, f64) -> anyhow::Result<f64>,
    ) -> anyhow::Result<Vec<f64>> {
        check(option, self.from)?;
        check(option, self.to)?;
        let spacing = self.spacing.unwrap_or(usual);
        ensure!(
            spacing == Spacing::Linear || (self.from > 0.0 && self.to > 0.0) || self.count == 1,
            "{option} {}:{}:{}: equal ratios do not start from zero; give ends above zero, or the spacing linear",
            again(self.from),
            again(self.to),
            self.count
        );
        (0..self.count).map(|number| check(option, self.value(number, spacing))).collect()
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
        neat(value)
    }
}

#[cfg(test)]
mod tests {
    use super::{Range, Spacing};

    fn values(text: &str, spacing: Spacing) -> Vec<f64> {
        text.parse::<Range>().unwrap().values("--option", spacing, |_, value| Ok(value)).unwrap()
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
            assert!(text.parse::<Range>().unwrap_err().contains("give "), "{text}");
        }
        let from_zero = "0:1:3:log".parse::<Range>().unwrap();
        assert!(from_zero.values("--friction", Spacing::Linear, |_, value| Ok(value)).is_err());
    }
}
