//! What a figure answers.

use crate::json::{array, or_null, string};
use crate::turned::TurnedParts;
use geneva_ask::number_format::no_greater;
use geneva_ask::worked::WorkedStep;
use geneva_ask::{ReportField, Rounding};
use geneva_figures::{Figure, with_minus_sign};

/// What a live figure replies: a drawing and its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct LiveReply {
    /// The drawing with its words and its series.
    pub figure: Figure,
    /// What is told beside it.
    pub numbers: Vec<LiveNumber>,
    /// What is told, too, that isn't one of the figure's own quantities.
    pub further: Vec<LiveQuantity>,
    /// Where controls stand that follow the others; no number where there is nothing that they would stand for.
    pub followers: Vec<(&'static str, f64)>,
    /// What is to be said of the setting, if anything.
    pub message: Option<String>,
    /// How far a long calculation has come; asked again, it goes on.
    pub progress: Option<Progress>,
    /// The solution step by step with the numbers of the setting, if the figure solves a problem.
    pub steps: Vec<WorkedStep>,
    /// Whether the mechanism may jam at this setting: then nothing turns, and what plays stops.
    pub jams: bool,
    /// How its parts stand, if they turn without a new drawing.
    pub turned: Option<TurnedParts>,
    /// The command that answers the same question, if there is one.
    pub command: Option<String>,
}

/// A number that a live figure shows, with its text.
#[derive(Clone, Debug, PartialEq)]
pub struct LiveNumber {
    /// Its name among the figure's quantities.
    pub name: &'static str,
    /// All its digits, in the unit of the text.
    pub value: f64,
    /// As it is read, with its unit.
    pub text: String,
}

/// A quantity that a live figure shows.
#[derive(Clone, Debug, PartialEq)]
pub struct LiveQuantity {
    /// Its name in the answer.
    pub name: &'static str,
    /// What it is called.
    pub label: &'static str,
    /// The key of the field that it is; none if the figure has it from elsewhere.
    pub key: Option<&'static str>,
}

impl LiveQuantity {
    /// A number that the figure finds itself.
    pub const fn new(name: &'static str, label: &'static str) -> Self {
        Self { name, label, key: None }
    }

    /// A number that is the field with this key.
    pub const fn field(name: &'static str, label: &'static str, key: &'static str) -> Self {
        Self { name, label, key: Some(key) }
    }
}

/// So many of so many parts of a long calculation, of which the last answer of a setting has none left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// What its parts are called.
    pub parts: &'static str,
    /// Parts that are done.
    pub done: usize,
    /// All parts.
    pub all: usize,
}

impl Progress {
    /// That something is left, of which no parts are counted.
    pub const UNCOUNTED: Self = Self { parts: "", done: 0, all: 1 };
}

impl LiveReply {
    /// A drawing and its numbers.
    pub fn new(figure: Figure, numbers: impl IntoIterator<Item = LiveNumber>) -> Self {
        let (numbers, further, followers) = (numbers.into_iter().collect(), Vec::new(), Vec::new());
        Self {
            figure,
            numbers,
            further,
            followers,
            message: None,
            progress: None,
            steps: Vec::new(),
            jams: false,
            turned: None,
            command: None,
        }
    }

    /// The answer as a JSON object: `numbers`, a list of `name`, `value` (null where there is none) and `text`; `followers`, a
    /// list of `name` and `value` (null where there is none); `message`, or null; `progress` with `done`, `all` and `parts`, or null; `caption`; `svg`; `steps`, a
    /// list of `heading` and `lines` in the notation of [`geneva_ask::worked`]; `jams`, true or false; `turned`, as of
    /// [`TurnedParts::to_json`], or null; `command`, or null.
    pub fn to_json(&self) -> String {
        let number = |LiveNumber { name, value, text }: &LiveNumber| {
            let value = if value.is_finite() { format!("{value:?}") } else { "null".to_owned() };
            format!("{{\"name\":{},\"value\":{value},\"text\":{}}}", string(name), string(text))
        };
        let follower = |(name, value): &(&str, f64)| {
            let value = or_null(value.is_finite().then(|| round_for_box(*value).to_string()));
            format!("{{\"name\":{},\"value\":{value}}}", string(name))
        };
        let step = |WorkedStep { heading, lines }: &WorkedStep| {
            format!("{{\"heading\":{},\"lines\":{}}}", string(heading), array(lines.iter().map(|line| string(line))))
        };
        let progress = or_null(self.progress.map(|Progress { parts, done, all }| {
            format!("{{\"done\":{done},\"all\":{all},\"parts\":{}}}", string(parts))
        }));
        format!(
            "{{\"numbers\":{},\"followers\":{},\"message\":{},\"progress\":{progress},\"caption\":{},\"svg\":{},\"steps\":{},\"jams\":{},\"turned\":{},\"command\":{}}}",
            array(self.numbers.iter().map(number)),
            array(self.followers.iter().map(follower)),
            or_null(self.message.as_deref().map(string)),
            string(&self.figure.caption),
            string(self.figure.svg.trim_end()),
            array(self.steps.iter().map(step)),
            self.jams,
            or_null(self.turned.as_ref().map(TurnedParts::to_json)),
            or_null(self.command.as_deref().map(string)),
        )
    }
}

/// The value of a control, to as many decimals as a box has room for. A zero has no sign.
pub fn round_for_box(value: f64) -> f64 {
    (value * 1e4).round() / 1e4 + 0.0
}

impl LiveNumber {
    /// A number to so many digits after the point, with its unit.
    pub fn new(name: &'static str, value: f64, digits: usize, unit: &str) -> Self {
        // What rounds to zero has no sign.
        let value = value + 0.0;
        let text = format!("{value:.digits$}");
        let is_zero = !text.contains(|c: char| ('1'..='9').contains(&c));
        let text = if is_zero { text.trim_start_matches('-').to_owned() } else { with_minus_sign(&text) };
        let gap = if unit.is_empty() || unit == "°" { "" } else { " " };
        Self { name, value, text: format!("{text}{gap}{unit}") }
    }

    /// A number to so many digits that count, with its unit.
    pub fn significant(name: &'static str, value: f64, digits: usize, unit: &str) -> Self {
        let magnitude = if value == 0.0 || !value.is_finite() { 0.0 } else { libm::floor(libm::log10(value.abs())) };
        Self::new(name, value, (digits as f64 - 1.0 - magnitude).clamp(0.0, 12.0) as usize, unit)
    }

    /// The number with words behind it, such as which way it points.
    pub fn and_words(mut self, words: &str) -> Self {
        self.text = format!("{}, {words}", self.text);
        self
    }

    /// The number of an answer's field, rounded as the field says, with its unit.
    pub fn from_field(name: &'static str, field: &ReportField) -> Option<Self> {
        let value = field.number()?;
        Some(match field.rounding {
            Rounding::Significant(digits) => Self::significant(name, value, digits, field.unit),
            Rounding::Decimals(digits) => Self::new(name, value, digits, field.unit),
            Rounding::Percent(digits) => Self::new(name, 100.0 * value, digits, "%"),
            Rounding::Limit(digits) => {
                Self { value, ..Self::significant(name, no_greater(value, digits), digits, field.unit) }
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_with_a_true_minus_and_no_negative_zero() {
        assert_eq!(LiveNumber::new("a", -1.25, 1, "rad/s").text, "−1.2 rad/s");
        assert_eq!(LiveNumber::new("a", -0.04, 1, "°").text, "0.0°");
        assert_eq!(LiveNumber::new("a", -0.0, 0, "").value.to_bits(), 0);
        assert_eq!(LiveNumber::significant("a", 0.012_345, 3, "").text, "0.0123");
        assert_eq!(LiveNumber::significant("a", 1234.5, 3, "ms").text, "1234 ms");
        let most = LiveNumber::from_field("a", &ReportField::in_unit("a", 0.0349, "mm").rounded(Rounding::Limit(2)))
            .expect("a number");
        assert_eq!((most.value, most.text.as_str()), (0.0349, "0.034 mm"));
    }
}
