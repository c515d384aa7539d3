//! Chains in plain characters as formulas: fractions, roots and powers set as such, units upright.

use crate::formula::{breakable, formula};
use crate::html::{GLUED, escape};
use crate::maths::JOINED;
use crate::numbers::with_minus_sign;
use std::iter::Peekable;
use std::str::Chars;

/// A chain as a formula whose line may break, and with its text for the data beside the table.
pub fn chain(text: &str) -> anyhow::Result<String> {
    marked(text, text)
}

/// A number such as `5e-8` as one with a power of ten, and as it is for the data beside the table; other text as it is.
pub fn scientific(number: &str) -> anyhow::Result<String> {
    match number.split_once('e') {
        Some(("1", exponent)) => marked(&format!("10^{}", with_minus_sign(exponent)), number),
        Some((digits, exponent)) => marked(&format!("{digits} × 10^{}", with_minus_sign(exponent)), number),
        None => Ok(escape(number)),
    }
}

/// A chain as a formula, with a text for the data.
fn marked(text: &str, data: &str) -> anyhow::Result<String> {
    // As wide as a phone where its fractions are as large as its other parts; a longer one has smaller fractions.
    const SHORT: usize = 64;
    // The space that a browser gives the sign of a product anyway.
    const USUAL: &str = " lspace=\"0.2222em\" rspace=\"0.2222em\"";
    let markup = breakable(&formula(&tex(text), false)?.replace(USUAL, ""));
    let class = if text.chars().count() < SHORT { "" } else { " class=\"long\"" };
    Ok(format!("<span data-text=\"{}\"{class}>{markup}</span>", escape(data)))
}

/// Words about a chain: a number with a power is a formula, `1e-3` is such a number, and a hyphen before a digit is a minus
/// sign.
pub fn words(text: &str) -> anyhow::Result<String> {
    let text = signed(&text.replace('`', ""));
    let mut out = String::new();
    let mut rest = text.as_str();
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        // A sign belongs to its number.
        let start = rest[..start].strip_suffix('−').map_or(start, str::len);
        let (before, number) = rest.split_at(start);
        let (number, behind) = number.split_at(power(number));
        rest = behind;
        out.push_str(&escape(before.trim_end_matches('^')));
        out.push_str(&match number {
            "2" if before.ends_with('^') => "²".to_owned(),
            "3" if before.ends_with('^') => "³".to_owned(),
            _ if before.ends_with('^') => format!("<sup>{number}</sup>"),
            _ if number.contains(['^', 'e']) => {
                // A sign behind a formula does not begin a line.
                let signs = behind.len() - behind.trim_start_matches(JOINED).len();
                let (signs, beyond) = behind.split_at(signs);
                rest = beyond;
                let formula = chain(&number.replace('e', " × 10^"))?;
                if signs.is_empty() { formula } else { format!("{GLUED}{formula}{}</span>", escape(signs)) }
            }
            _ => escape(number),
        });
    }
    Ok(out + &escape(rest))
}

/// Text with a minus sign for each hyphen that is one: before a digit, and behind no letter or digit.
fn signed(text: &str) -> String {
    let before = std::iter::once(' ').chain(text.chars());
    let behind = text.chars().skip(1).chain([' ']);
    let signs = text.chars().zip(before.zip(behind)).map(|(c, (before, behind))| match c {
        '-' if behind.is_ascii_digit() && (!before.is_alphanumeric() || before == 'e') => with_minus_sign("-"),
        c => c.to_string(),
    });
    signs.collect()
}

/// How many bytes a number has, with the power of ten or the exponent behind it.
fn power(text: &str) -> usize {
    let number = |text: &str| {
        let digits = text.trim_start_matches('−');
        let length = digits.find(|c: char| !c.is_ascii_digit() && c != '.' && c != ',').unwrap_or(digits.len());
        let length = digits[..length].trim_end_matches(['.', ',']).len();
        if length == 0 { 0 } else { text.len() - digits.len() + length }
    };
    let length = number(text);
    let exponents = [" × 10^", "^", "e"].into_iter().filter_map(|sign| text[length..].strip_prefix(sign));
    let ends = exponents.filter(|rest| number(rest) > 0).map(|rest| text.len() - rest.len() + number(rest));
    ends.max().unwrap_or(length)
}

/// A chain in TeX.
fn tex(chain: &str) -> String {
    Reader(chain.chars().peekable()).until(None)
}

struct Reader<'a>(Peekable<Chars<'a>>);

impl Reader<'_> {
    /// What stands before the bracket that closes, or before the end.
    fn until(&mut self, close: Option<char>) -> String {
        let mut out = String::new();
        while let Some(c) = self.0.next_if(|c| Some(*c) != close) {
            out += &self.part(c);
        }
        self.0.next();
        out
    }

    /// What begins with this character.
    fn part(&mut self, c: char) -> String {
        match c {
            '(' => self.group(),
            '√' if self.0.next_if_eq(&'(').is_some() => format!(r"\sqrt{{{}}}", self.until(Some(')'))),
            '^' => format!("^{{{}}}", self.exponent()),
            ' ' => match self.0.next_if(|c| c.is_alphabetic()) {
                Some(first) => self.letters(first, "~"),
                None if self.0.peek() == Some(&'°') => r"\,".to_owned(),
                None => c.to_string(),
            },
            c if c.is_ascii_digit() => self.number(c),
            '°' if self.0.next_if_eq(&'C').is_some() => r"{}^\circ\mathrm{C}".to_owned(),
            c if c.is_alphabetic() => self.letters(c, ""),
            c => sign(c),
        }
    }

    /// A group, and what it is the numerator of.
    fn group(&mut self) -> String {
        let inside = self.until(Some(')'));
        self.over(&inside).unwrap_or_else(|| format!("({inside})"))
    }

    /// A fraction, if a bracket or a number follows behind a stroke.
    fn over(&mut self, above: &str) -> Option<String> {
        let mut ahead = self.0.clone();
        let is_over = ahead.next() == Some('/') && ahead.peek().is_some_and(|c| *c == '(' || c.is_ascii_digit());
        if !is_over {
            return None;
        }
        self.0.next();
        let below = match self.0.next()? {
            '(' => self.until(Some(')')),
            first => self.digits(first),
        };
        Some(format!(r"\frac{{{above}}}{{{below}}}"))
    }

    /// A number, and what it is the numerator of.
    fn number(&mut self, first: char) -> String {
        let digits = self.digits(first);
        let tex = digits.replace(',', "{,}");
        self.over(&tex).unwrap_or(tex)
    }

    fn digits(&mut self, first: char) -> String {
        let mut digits = first.to_string();
        while let Some(c) = self.0.next_if(|c| c.is_ascii_digit() || *c == '.' || *c == ',') {
            digits.push(c);
        }
        digits
    }

    /// A sign and digits, or brackets, of which a fraction has none.
    fn exponent(&mut self) -> String {
        let sign = self.0.next_if(|c| ['−', '-'].contains(c)).map_or("", |_| "−");
        match self.0.next() {
            Some('(') => {
                let inside = self.until(Some(')'));
                sign.replace('−', "-") + &self.over(&inside).unwrap_or(inside)
            }
            // A sign and its digits are one piece.
            Some(first) if !sign.is_empty() => format!(r"\text{{{sign}{}}}", self.digits(first)),
            Some(first) => self.digits(first),
            None => String::new(),
        }
    }

    /// A function, a constant, a unit or a word, with the space before it.
    fn letters(&mut self, first: char, space: &str) -> String {
        let mut letters = first.to_string();
        let is_letter = |c: &char| c.is_ascii_alphabetic() || *c == 'Ω';
        while !['î', 'ĵ', 'π'].contains(&first) {
            let mut ahead = self.0.clone();
            let joins = ahead.next().is_some_and(|c| ['/', '·'].contains(&c)) && ahead.peek().is_some_and(is_letter);
            match self.0.next_if(|c| is_letter(c) || joins) {
                Some(c) => letters.push(c),
                None => break,
            }
        }
        let is_power = self.0.peek() == Some(&'^');
        match letters.as_str() {
            "sin" | "cos" | "tan" | "exp" => format!(r"\{letters} "),
            "π" => r"\pi ".to_owned(),
            "î" => r"\hat{i}".to_owned(),
            "ĵ" => r"\hat{j}".to_owned(),
            "e" if is_power => "e".to_owned(),
            _ => format!(r"\text{{{space}{letters}}}"),
        }
    }
}

fn sign(c: char) -> String {
    match c {
        '−' => "-".to_owned(),
        '×' => r"\times ".to_owned(),
        '·' => r"{\cdot}".to_owned(),
        '°' => r"{}^\circ ".to_owned(),
        '%' => r"\%".to_owned(),
        '√' => r"\surd ".to_owned(),
        c => c.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_is_set_as_the_formula_that_it_is() {
        assert_eq!(tex("43.4 − 29.8 = 13.8 km/s"), r"43.4 - 29.8 = 13.8\text{~km/s}");
        assert_eq!(tex("(a/2)^(1/2)"), r"(\text{a}/2)^{\frac{1}{2}}");
        assert_eq!(tex("((1 m)(2 s)^−2)/(4)"), r"\frac{(1\text{~m})(2\text{~s})^{\text{−2}}}{4}");
        assert_eq!(tex("(−705 (kg·m)/s)"), r"(-705 (\text{kg·m})/\text{s})");
        assert_eq!(tex("e^−(1.00 s)/(3.52 s)"), r"e^{-\frac{1.00\text{~s}}{3.52\text{~s}}}");
        assert_eq!(tex("√(2(3.0) m) = 84ĵ"), r"\sqrt{2(3.0)\text{~m}} = 84\hat{j}");
        assert_eq!(tex("30,000 °C cos 0°"), r"30{,}000\,{}^\circ\mathrm{C}\cos  0{}^\circ ");
    }

    #[test]
    fn a_power_of_ten_is_a_number_in_the_data() {
        let set = scientific("1e-6").expect("set");
        assert_eq!(set, "<span data-text=\"1e-6\"><math><msup><mn>10</mn><mtext>−6</mtext></msup></math></span>");
        assert!(scientific("5e-8").expect("set").contains("<mn>5</mn><mo>×</mo><msup>"));
        assert_eq!(scientific("–").expect("set"), "–");
    }

    #[test]
    fn words_have_minus_signs_and_powers() {
        assert_eq!(words("the exponent is -5, not a-b or `2`").expect("set"), "the exponent is −5, not a-b or 2");
        let set = words("exp(-51.2) is 5.81e-23").expect("set");
        assert!(set.starts_with("exp(−51.2) is <span data-text=\"5.81 × 10&#94;−23\"><math>"), "{set}");
        assert!(set.contains("<msup><mn>10</mn><mtext>−23</mtext></msup>"), "{set}");
        assert_eq!(words("km^2 for km, 9.8 m/s^2").expect("set"), "km² for km, 9.8 m/s²");
    }
}
