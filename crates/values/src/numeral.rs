//! One number as it is printed: its digits, its power of ten and its unit.

use crate::printed_unit::{self, skip_space};

/// What was read at one place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Numeral {
    /// Sign, digits, thousands commas and point, as [`geneva_evidence::Decimal`] reads them.
    pub digits: String,
    /// The power of ten that they are multiplied by.
    pub exponent: i32,
    /// The power of ten as it is recorded, such as `e-3` or ` million`; mostly empty.
    pub scale: String,
    /// The unit in one spelling; empty if there is none.
    pub unit: String,
    /// The byte behind the digits and the power of ten.
    pub end: usize,
    /// The byte behind the unit.
    pub whole_end: usize,
    /// What it is by its form alone.
    pub form: Form,
}

/// What the form of a number tells of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// Nothing special.
    Plain,
    /// A date or a time of day, such as `2024-05-17`.
    Date,
    /// A version, an ordinal number or a part of a name, such as `1.2.3`, `4th` or `3D`.
    Name,
    /// A part of a formula, such as the 2 in `2\pi` or `1/2`.
    Coefficient,
}

/// Most digits of a number: no text prints more, and the arithmetic stays cheap.
pub(crate) const MOST_DIGITS: usize = 60;
/// Greatest power of ten that a text prints.
const GREATEST_EXPONENT: i32 = 400;

/// Signs between groups of three digits, as texts write them.
const SEPARATORS: [&str; 9] = [",", "{,}", "\\,", "\u{2009}", "\u{202f}", "\u{a0}", "'", "’", "~"];

/// Reads the number whose first digit or sign is at `at`; none if there is no digit.
pub(crate) fn numeral_at(text: &str, at: usize) -> Option<Numeral> {
    let negative = text[at..].starts_with(['-', '−']);
    let signed = text[at..].chars().next().filter(|c| "-−+".contains(*c)).map_or(0, char::len_utf8);
    let start = at + signed;
    let first = run(text, start);
    if first == start {
        return None;
    }
    if let Some(end) = date_end(text, start, first) {
        return Some(special(text, at, end, Form::Date));
    }
    let mut digits = if negative { "-".to_owned() } else { String::new() };
    digits += &text[start..first];
    let mut end = first;
    let mut grouped = false;
    if first - start <= 3 {
        while let Some((group, behind)) = group(text, end) {
            digits.push(',');
            digits += group;
            end = behind;
            grouped = true;
        }
    }
    if text[end..].starts_with('.') && run(text, end + 1) > end + 1 {
        let behind = run(text, end + 1);
        digits += &text[end..behind];
        end = behind;
        // Another point makes it a version.
        let mut version = end;
        while text[version..].starts_with('.') && run(text, version + 1) > version + 1 {
            version = run(text, version + 1);
        }
        if version > end {
            return Some(special(text, at, version, Form::Name));
        }
    } else if !grouped && text[end..].starts_with('/') && run(text, end + 1) > end + 1 {
        return Some(special(text, at, end, Form::Coefficient));
    }
    if digits.len() > MOST_DIGITS {
        return Some(special(text, at, end, Form::Name));
    }
    let mut numeral = Numeral {
        digits,
        exponent: 0,
        scale: String::new(),
        unit: String::new(),
        end,
        whole_end: end,
        form: Form::Plain,
    };
    let is_degree = ["^\\circ", "^{\\circ}"].iter().any(|sign| text[end..].starts_with(sign));
    if text[end..].starts_with('^') && !is_degree {
        numeral.form = Form::Coefficient;
        return Some(numeral);
    }
    if let Some((exponent, behind)) = exponent(text, end) {
        numeral.exponent = exponent;
        numeral.scale = format!("e{exponent}");
        numeral.end = behind;
    } else if let Some((scale, exponent, behind)) = scale_word(text, end) {
        numeral.exponent = exponent;
        numeral.scale = scale;
        numeral.end = behind;
    }
    numeral.whole_end = numeral.end;
    if let Some((unit, behind)) = printed_unit::unit_behind(text, numeral.end) {
        numeral.unit = unit;
        numeral.whole_end = behind;
    } else if numeral.scale.is_empty() {
        numeral.form = form_by_neighbours(text, start, end);
    }
    Some(numeral)
}

fn special(text: &str, at: usize, end: usize, form: Form) -> Numeral {
    Numeral {
        digits: text[at..end].to_owned(),
        exponent: 0,
        scale: String::new(),
        unit: String::new(),
        end,
        whole_end: end,
        form,
    }
}

/// The byte behind the digits that begin at `at`.
pub(crate) fn run(text: &str, at: usize) -> usize {
    at + text.as_bytes().get(at..).unwrap_or_default().iter().take_while(|byte| byte.is_ascii_digit()).count()
}

/// The group of three digits behind a separator, and the byte behind it.
fn group(text: &str, at: usize) -> Option<(&str, usize)> {
    let separator = SEPARATORS.iter().find(|separator| text[at..].starts_with(**separator))?;
    let start = at + separator.len();
    let end = run(text, start);
    (end == start + 3).then(|| (&text[start..end], end))
}

/// The byte behind a date or a time of day, such as `2024-05-17`, `17/5/2024` or `12:30`.
fn date_end(text: &str, start: usize, first: usize) -> Option<usize> {
    let mark = text[first..].chars().next().filter(|c| "-/.:".contains(*c))?;
    let second = run(text, first + 1);
    let is_short = |length: usize| (1..=2).contains(&length);
    if mark == ':' {
        let both = is_short(first - start) && second - first == 3;
        let seconds = text[second..].starts_with(':') && run(text, second + 1) == second + 3;
        return both.then_some(if seconds { second + 3 } else { second });
    }
    if !is_short((second - first).saturating_sub(1)) || !text[second..].starts_with(mark) {
        return None;
    }
    let third = run(text, second + 1);
    let lengths = (first - start, third - second - 1);
    let is_date = matches!(lengths, (4, 1..=2)) || (is_short(lengths.0) && lengths.1 == 4);
    is_date.then_some(third)
}

/// A power of ten in scientific notation behind the digits, and the byte behind it.
fn exponent(text: &str, at: usize) -> Option<(i32, usize)> {
    let rest = &text[at..];
    if let Some(raised) = rest.strip_prefix(['e', 'E']) {
        let sign = usize::from(raised.starts_with(['-', '+']));
        let end = run(text, at + 1 + sign);
        return read_exponent(&text[at + 1..end]).map(|exponent| (exponent, end));
    }
    let mut behind = skip_space(text, at);
    let times = ["×", "\\times", "\\cdot", "·", "*", "x "].iter().find(|sign| text[behind..].starts_with(**sign))?;
    behind = skip_space(text, behind + times.len());
    let power = text[behind..].strip_prefix("10")?;
    behind += 2;
    let superscript = |c: char| "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c);
    if power.starts_with(superscript) {
        let end = power.find(|c| !superscript(c)).unwrap_or(power.len());
        let plain = power[..end].chars().map(|c| match "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == c)
        {
            Some(digit) => char::from(b'0' + digit as u8),
            None => '-',
        });
        return read_exponent(&plain.collect::<String>()).map(|exponent| (exponent, behind + end));
    }
    let raised = power.strip_prefix('^')?;
    let bracketed = raised.starts_with(['{', '(']);
    let inner = &raised[usize::from(bracketed)..];
    let end = inner.find(|c: char| !c.is_ascii_digit() && !matches!(c, '-' | '−' | '+')).unwrap_or(inner.len());
    let closes = usize::from(bracketed);
    if bracketed && !inner[end..].starts_with(['}', ')']) {
        return None;
    }
    read_exponent(&inner[..end]).map(|exponent| (exponent, behind + 1 + closes + end + closes))
}

fn read_exponent(text: &str) -> Option<i32> {
    let text = text.replace('−', "-");
    text.parse().ok().filter(|exponent: &i32| exponent.abs() <= GREATEST_EXPONENT)
}

/// A scale in words or as a letter behind the digits.
fn scale_word(text: &str, at: usize) -> Option<(String, i32, usize)> {
    const WORDS: [(&str, i32); 4] = [("thousand", 3), ("million", 6), ("billion", 9), ("trillion", 12)];
    let behind = skip_space(text, at);
    let is_end = |at: usize| !text[at..].starts_with(|c: char| c.is_alphanumeric());
    for (word, exponent) in WORDS {
        if text[behind..].starts_with(word) && is_end(behind + word.len()) {
            return Some((format!(" {word}"), exponent, behind + word.len()));
        }
    }
    // A letter stands directly behind the digits: 12k, 1.5M.
    let letters = [('k', 3), ('M', 6)];
    let (letter, exponent) = letters.into_iter().find(|(letter, _)| text[at..].starts_with(*letter))?;
    is_end(at + 1).then(|| (letter.to_string(), exponent, at + 1))
}

/// Whether what touches a number makes it part of a name or of a formula.
fn form_by_neighbours(text: &str, start: usize, end: usize) -> Form {
    const SPACING: [&str; 9] = ["\\,", "\\;", "\\:", "\\ ", "\\%", "\\)", "\\]", "\\\\", "\\&"];
    const FORMULA: [&str; 6] = ["frac{", "frac12", "sqrt{", "sqrt[", "}{", "binom{"];
    let behind = &text[end..];
    if behind.starts_with(|c: char| c.is_alphabetic()) {
        let letters = behind.find(|c: char| !c.is_alphanumeric()).unwrap_or(behind.len());
        let is_ordinal = ["st", "nd", "rd", "th"].contains(&&behind[..letters]);
        return if is_ordinal || letters > 1 { Form::Name } else { Form::Coefficient };
    }
    let is_short = end - start <= 3 && !text[start..end].contains('.');
    let meets =
        behind.starts_with('(') || (behind.starts_with('\\') && !SPACING.iter().any(|of| behind.starts_with(of)));
    let wide =
        ["\\times", "\\cdot", "\\pm", "\\quad", "\\qquad", "\\end", "\\text", "\\le", "\\ge", "\\approx", "\\to"];
    let is_relation = wide.iter().any(|name| behind.starts_with(name));
    let before = &text[..start];
    let inside = FORMULA.iter().any(|name| before.ends_with(name)) && behind.starts_with('}');
    let divides = is_short && before.ends_with('/');
    if (is_short && meets && !is_relation) || inside || divides { Form::Coefficient } else { Form::Plain }
}
