//! The arguments of a question.

use std::collections::BTreeMap;

/// Names and values, as in the part of an address behind `?`: `stations=6&crank=-20`. Of a name that stands twice the
/// later counts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arguments(BTreeMap<String, String>);

impl Arguments {
    /// Reads them; what has no `=` is a name with nothing behind it.
    pub fn parse(text: &str) -> Self {
        let pairs = text.split('&').filter(|pair| !pair.is_empty());
        let pair = |pair: &str| {
            let (name, value) = pair.split_once('=').unwrap_or((pair, ""));
            (name.to_owned(), value.to_owned())
        };
        Self(pairs.map(pair).collect())
    }

    /// The names.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// All of them again, by name.
    pub fn to_text(&self) -> String {
        self.0.iter().map(|(name, value)| format!("{name}={value}&")).collect()
    }

    /// The text of a name.
    pub fn text(&self, name: &str) -> Option<&str> {
        self.0.get(name).map(String::as_str)
    }

    /// The text of a name without which there is no figure.
    pub fn given(&self, name: &str) -> Result<&str, String> {
        self.text(name).ok_or_else(|| format!("`{name}` is missing: the page that shows the figure gives it"))
    }

    /// The number of a name without which there is no figure.
    pub fn given_number(&self, name: &str) -> Result<f64, String> {
        number(name, self.given(name)?)
    }
}

/// A finite number, with either of the signs for minus.
pub fn number(name: &str, text: &str) -> Result<f64, String> {
    let value: Option<f64> = text.trim().replace('−', "-").parse().ok();
    let refused = || format!("{name} `{text}`: not a number; give one with a point before its decimals");
    value.filter(|value| value.is_finite()).ok_or_else(refused)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_later_of_two_counts_and_a_minus_is_a_minus() {
        let arguments = Arguments::parse("a=1&b=x&a=−2.5&c&");
        assert_eq!(arguments.to_text(), "a=−2.5&b=x&c=&");
        assert_eq!(arguments.given_number("a"), Ok(-2.5));
        assert_eq!((arguments.text("b"), arguments.text("c"), arguments.text("d")), (Some("x"), Some(""), None));
        assert!(arguments.given_number("b").is_err_and(|why| why.contains("`x`: not a number")));
        assert!(arguments.given("d").is_err_and(|why| why.contains("`d` is missing")));
        assert!(number("n", "NaN").is_err() && number("n", "inf").is_err());
    }
}
