//! The arguments of a question.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Sizes of numbers whose quotients and products keep full precision.
const COMPUTABLE: RangeInclusive<f64> = 1e-30..=1e30;
/// Characters of a text that an error quotes.
const QUOTED: usize = 40;

/// Names and values, as in the part of an address after `?`: `stations=6&crank=-20`, each name once.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LiveArguments(BTreeMap<String, String>);

impl LiveArguments {
    /// Reads a query as a form writes it (`application/x-www-form-urlencoded`): a blank is `+`, and any byte may be `%` and
    /// two hexadecimal digits. A name without `=` has an empty value.
    ///
    /// # Errors
    ///
    /// A name that is given twice, and a `%` without two digits or with bytes that are not UTF-8, each quoted.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut arguments = BTreeMap::new();
        for pair in text.split('&').filter(|pair| !pair.is_empty()) {
            let (name, value) = pair.split_once('=').unwrap_or((pair, ""));
            let (name, value) = (decoded(name)?, decoded(value)?);
            if arguments.contains_key(&name) {
                return Err(format!("`{}` is given twice: give it once", quoted(&name)));
            }
            arguments.insert(name, value);
        }
        Ok(Self(arguments))
    }

    /// The arguments with these names and values; the last value of a name counts.
    pub fn from_pairs<'a>(pairs: impl IntoIterator<Item = (&'a str, String)>) -> Self {
        Self(pairs.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
    }

    /// The arguments whose names `is_wanted` accepts.
    pub fn only(&self, is_wanted: impl Fn(&str) -> bool) -> Self {
        let wanted = self.0.iter().filter(|(name, _)| is_wanted(name));
        Self(wanted.map(|(name, value)| (name.clone(), value.clone())).collect())
    }

    /// The names.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// The query that [`parse`](Self::parse) reads back, sorted by name.
    pub fn to_query(&self) -> String {
        let pair = |(name, value): (&String, &String)| format!("{}={}", encoded(name), encoded(value));
        self.0.iter().map(pair).collect::<Vec<_>>().join("&")
    }

    /// The value of a name.
    pub fn text(&self, name: &str) -> Option<&str> {
        self.0.get(name).map(String::as_str)
    }

    /// The value of a name without which there is no figure.
    pub fn required(&self, name: &str) -> Result<&str, String> {
        self.text(name).ok_or_else(|| format!("`{name}` is missing: the page that shows the figure gives it"))
    }

    /// The number of a name without which there is no figure.
    pub fn required_number(&self, name: &str) -> Result<f64, String> {
        number(name, self.required(name)?)
    }

    /// The word of a name without which there is no figure, which must be one of these.
    pub fn required_word<'a>(&self, name: &str, words: &[&'a str]) -> Result<&'a str, String> {
        let text = self.required(name)?;
        let word = words.iter().find(|word| **word == text).copied();
        word.ok_or_else(|| format!("{name} `{}`: give one of {}", quoted(text), words.join(", ")))
    }
}

fn decoded(text: &str) -> Result<String, String> {
    let refused = || format!("`{}` is not encoded as a query: write % as %25", quoted(text));
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'+' => b' ',
            b'%' => {
                let mut digit = || rest.next().and_then(|digit| char::from(digit).to_digit(16));
                let (high, low) = (digit().ok_or_else(refused)?, digit().ok_or_else(refused)?);
                (16 * high + low) as u8
            }
            other => other,
        });
    }
    String::from_utf8(bytes).map_err(|_| refused())
}

fn encoded(text: &str) -> String {
    let encoded = |byte: u8| match byte {
        b' ' => "+".to_owned(),
        // Commas and semicolons separate the numbers of a list; a query may hold both as they are.
        b'-' | b'.' | b'_' | b'*' | b',' | b';' => char::from(byte).to_string(),
        _ if byte.is_ascii_alphanumeric() => char::from(byte).to_string(),
        _ => format!("%{byte:02X}"),
    };
    text.bytes().map(encoded).collect()
}

/// A number with either minus sign: zero, or of a size between 1e-30 and 1e30.
pub fn number(name: &str, text: &str) -> Result<f64, String> {
    computable(text).ok_or_else(|| {
        let (least, most) = (COMPUTABLE.start(), COMPUTABLE.end());
        format!("{name} `{}`: give 0, or a number of a size from {least:e} to {most:e}, such as 2.5", quoted(text))
    })
}

/// The number that a text is, with either minus sign, if it can be computed with. A zero has no sign.
pub fn computable(text: &str) -> Option<f64> {
    let value: f64 = text.trim().replace('−', "-").parse().ok()?;
    (value == 0.0 || COMPUTABLE.contains(&value.abs())).then_some(value + 0.0)
}

/// A text as an error may quote it: the first characters, without control characters.
pub fn quoted(text: &str) -> String {
    let shown: String = text.chars().take(QUOTED).flat_map(char::escape_debug).collect();
    if text.chars().nth(QUOTED).is_some() { shown + "…" } else { shown }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_query_is_read_back_as_it_was_written() {
        for value in ["3e+2", "−2.5", "a b&c=d%26", "1,2;3", "\n\n<img>", ""] {
            let arguments = LiveArguments::from_pairs([("b", value.to_owned()), ("a", "1".to_owned())]);
            assert_eq!(LiveArguments::parse(&arguments.to_query()), Ok(arguments), "{value}");
        }
        let arguments = LiveArguments::parse("b=x+y&a=3e%2B2&c&").expect("a query");
        assert_eq!(arguments.to_query(), "a=3e%2B2&b=x+y&c=");
        assert_eq!((arguments.text("b"), arguments.text("c"), arguments.text("d")), (Some("x y"), Some(""), None));
        assert_eq!(arguments.required_number("a"), Ok(300.0));
        assert!(arguments.required("d").is_err_and(|why| why.contains("`d` is missing")));
    }

    #[test]
    fn a_name_that_is_given_twice_is_refused() {
        for query in ["unit=m&crank=1&unit=mm", "a=1&%61=2", "a&a"] {
            assert!(LiveArguments::parse(query).is_err_and(|why| why.contains("is given twice")), "{query}");
        }
    }

    #[test]
    fn what_is_not_encoded_is_refused() {
        for query in ["a=%", "a=%2", "a=%zz", "a=%ff", "%C3=1"] {
            assert!(LiveArguments::parse(query).is_err_and(|why| why.contains("is not encoded")), "{query}");
        }
    }

    #[test]
    fn a_number_is_finite_and_can_be_computed_with() {
        assert_eq!([number("n", "−2.5"), number("n", " 0 "), number("n", "1e30")], [Ok(-2.5), Ok(0.0), Ok(1e30)]);
        for text in ["NaN", "inf", "x", "", "1e31", "-1e-31", "1e999"] {
            assert!(number("n", text).is_err_and(|why| why.contains(text)), "{text}");
        }
    }

    #[test]
    fn what_is_quoted_is_short_and_on_one_line() {
        let why = number("n", &("1\n\u{1b}[31m\u{202e}".to_owned() + &"x".repeat(3000))).expect_err("no number");
        assert!(why.len() < 200 && !why.contains(['\n', '\u{1b}', '\u{202e}']), "{why}");
    }

    #[test]
    fn a_word_comes_from_its_list() {
        let arguments = LiveArguments::from_pairs([("unit", "<img>".to_owned())]);
        let why = arguments.required_word("unit", &["m", "mm"]).expect_err("no unit");
        assert_eq!(why, "unit `<img>`: give one of m, mm");
        assert_eq!(
            LiveArguments::from_pairs([("unit", "mm".to_owned())]).required_word("unit", &["m", "mm"]),
            Ok("mm")
        );
    }
}
