//! Errors about lengths in the units in which these were typed.
//!
//! All that is computed is in millimetres, and so is what a refusal says. A reader who typed inches is told inches: values as they were
//! typed, and limits rounded to the side on which they hold.

use crate::number_format::{MILLIMETRES_OF_AN_INCH, as_typed, rounded, rounded_down, rounded_up, to_digits};
use crate::typed_number::unit_of;

/// Lengths that were typed, by the names of their arguments, and the unit of those that weren't.
///
/// ```
/// use geneva_ask::length_units::TypedLengths;
///
/// let mut typed = TypedLengths::new(false);
/// typed.add("crank-radius", "1-1/2in");
/// typed.add("pin-diameter", "50");
/// let said = "--crank-radius 38.1, --pin-diameter 50: too thick; give --crank-radius 127 or more, or --pin-diameter from 2 to 19.05";
/// assert_eq!(
///     typed.in_their_units(said, &["crank-radius", "pin-diameter"]),
///     "--crank-radius 1-1/2in, --pin-diameter 50: too thick; give --crank-radius 5in or more, or --pin-diameter from 2 to 19.05"
/// );
/// ```
#[derive(Clone, Debug, Default)]
pub struct TypedLengths {
    /// Names, texts and units; none of what is in millimetres.
    typed: Vec<(String, String, Option<LengthUnit>)>,
    is_in_inches: bool,
}

/// A unit as it is typed, and its millimetres.
type LengthUnit = (&'static str, f64);

/// What a word of a sentence about an argument says of the number behind it.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    /// A value.
    Value,
    /// The least that holds.
    Least,
    /// The greatest that holds.
    Most,
}

/// Inches as they are typed, and their millimetres.
const INCHES: LengthUnit = ("in", MILLIMETRES_OF_AN_INCH);
/// Significant digits to which a value in another unit is told if it is then the same value.
const EXACT: usize = 8;
/// Significant digits of a length in a sentence.
const DIGITS: usize = 4;

impl TypedLengths {
    /// Of a question without lengths; whether those that aren't typed are told in inches.
    pub fn new(is_in_inches: bool) -> Self {
        Self { typed: Vec::new(), is_in_inches }
    }

    /// Adds a length as it was typed for an argument, which is named without hyphens.
    pub fn add(&mut self, name: &str, text: &str) {
        self.typed.push((name.to_owned(), text.trim().to_owned(), unit_of(text)));
    }

    /// Whether all is in millimetres, as in what is computed.
    pub fn is_metric(&self) -> bool {
        !self.is_in_inches && self.typed.iter().all(|(.., unit)| unit.is_none())
    }

    /// The unit of an argument that was typed or not, or of a length in a sentence; none for millimetres.
    fn unit(&self, name: &str) -> Option<LengthUnit> {
        match self.typed.iter().find(|(of, ..)| of == name) {
            Some((.., unit)) => *unit,
            None => self.other_unit(),
        }
    }

    /// The unit of what wasn't typed: inches if they are asked for, and otherwise that of all that was.
    fn other_unit(&self) -> Option<LengthUnit> {
        if self.is_in_inches {
            return Some(INCHES);
        }
        let (.., first) = self.typed.first()?;
        first.filter(|unit| self.typed.iter().all(|(.., other)| *other == Some(*unit)))
    }

    /// A refusal with the lengths in their units: what stands behind the names of these arguments, and what has its millimetres behind it.
    pub fn in_their_units(&self, said: &str, arguments: &[&str]) -> String {
        if self.is_metric() {
            return said.to_owned();
        }
        let words: Vec<&str> = said.split(' ').collect();
        let bare = |word: &str| word.trim_end_matches([',', ';', ':', '.', ')']).len();
        let mut told: Vec<String> = Vec::new();
        let (mut about, mut side): (Option<&str>, Side) = (None, Side::Value);
        let mut skipped = false;
        for (k, word) in words.iter().enumerate() {
            if std::mem::take(&mut skipped) {
                continue;
            }
            let (text, marks) = word.split_at(bare(word));
            let next = words.get(k + 1).copied().unwrap_or_default();
            let value = text
                .parse::<f64>()
                .ok()
                .filter(|_| text.starts_with(|sign: char| sign.is_ascii_digit() || sign == '-'));
            if let Some(name) = text.trim_start_matches('(').strip_prefix("--") {
                about = arguments.iter().copied().find(|argument| *argument == name);
                side = Side::Value;
            } else if let (Some(value), Some(name)) = (value, about) {
                let or_more = next == "or" && words.get(k + 2).is_some_and(|word| word.starts_with("more"));
                side = if or_more { Side::Least } else { side };
                told.push(self.argument(name, text, value, side) + marks);
                // The second of two limits is the greater one.
                side = Side::Value;
                about = about.filter(|_| marks.is_empty());
                continue;
            } else {
                match text {
                    "from" => side = Side::Least,
                    "to" | "up" => side = Side::Most,
                    "or" | "more" => {}
                    _ => about = None,
                }
                let is_in_mm =
                    next.strip_prefix("mm").is_some_and(|rest| rest.len() == next.len() - 2 && bare(next) == 2);
                if let (Some(value), Some((unit, size)), true) = (value, self.other_unit(), is_in_mm) {
                    told.push(format!("{} {unit}{}", to_digits(value / size, DIGITS), &next[2..]));
                    skipped = true;
                    continue;
                }
            }
            told.push((*word).to_owned());
        }
        told.join(" ")
    }

    /// A length in millimetres behind the name of its argument.
    fn argument(&self, name: &str, text: &str, value: f64, side: Side) -> String {
        let typed = self.typed.iter().find(|(of, ..)| of == name);
        let Some((unit, size)) = self.unit(name) else { return text.to_owned() };
        let as_it_was = typed.filter(|(_, typed, _)| {
            side == Side::Value
                && crate::typed_number::length(name, typed).is_ok_and(|length| rounded(length) == rounded(value))
        });
        if let Some((_, typed, _)) = as_it_was {
            return typed.clone();
        }
        let in_unit = rounded(value / size);
        let short: f64 = format!("{in_unit:.*e}", EXACT - 1).parse().unwrap_or(in_unit);
        if short * size == value || rounded(short * size) == value {
            return format!("{}{unit}", as_typed(short));
        }
        match side {
            Side::Least => rounded_up(in_unit) + unit,
            Side::Most => rounded_down(in_unit) + unit,
            // A screw's diameter has no short number of inches.
            Side::Value => format!("{text}mm"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::TypedLengths;

    const LENGTHS: [&str; 4] = ["crank-radius", "pin-diameter", "play", "centre-error"];

    fn told(typed: &[(&str, &str)], is_in_inches: bool, said: &str) -> String {
        let mut lengths = TypedLengths::new(is_in_inches);
        typed.iter().for_each(|(name, text)| lengths.add(name, text));
        lengths.in_their_units(said, &LENGTHS)
    }

    #[test]
    fn lengths_are_told_as_they_were_typed_and_limits_on_the_side_on_which_they_hold() {
        let in_inches = [("crank-radius", "1in"), ("pin-diameter", "1/2 in")];
        for (typed, is_in_inches, said, right) in [
            (
                &in_inches[..],
                false,
                "--pin-diameter 12.7: too thick; give --pin-diameter up to 10",
                "--pin-diameter 1/2 in: too thick; give --pin-diameter up to 0.3937in",
            ),
            (
                &in_inches,
                false,
                "give --pin-diameter from 1 to 10, or --crank-radius 30 or more",
                "give --pin-diameter from 0.03938in to 0.3937in, or --crank-radius 1.182in or more",
            ),
            (
                &in_inches,
                false,
                "by 0.254 mm; the axes are 50.8 mm, or 1 mm.",
                "by 0.01000 in; the axes are 2.000 in, or 0.03937 in.",
            ),
            (
                &in_inches[..1],
                false,
                "--pin-screw 3 and 4: give --play 0 (--crank-radius 25.4)",
                "--pin-screw 3 and 4: give --play 0in (--crank-radius 1in)",
            ),
            (
                &[("crank-radius", "25.4"), ("play", "1cm")],
                false,
                "--crank-radius 25.4, --play 10: by 3 mm",
                "--crank-radius 25.4, --play 1cm: by 3 mm",
            ),
            (
                &[("crank-radius", "25.4")],
                true,
                "--crank-radius 25.4: by 25.4 mm; give --play up to 2.54",
                "--crank-radius 25.4: by 1.000 in; give --play up to 0.1in",
            ),
            (
                &[("centre-error", "-1in")],
                false,
                "--centre-error -25.4: give --centre-error from -3 to 3",
                "--centre-error -1in: give --centre-error from -0.1181in to 0.1181in",
            ),
            (
                &in_inches,
                false,
                "give --pin-diameter 3, which is then the screw itself",
                "give --pin-diameter 3mm, which is then the screw itself",
            ),
            (&[("crank-radius", "25.4")], false, "--crank-radius 25.4: 3 mm", "--crank-radius 25.4: 3 mm"),
        ] {
            assert_eq!(told(typed, is_in_inches, said), right);
        }
    }
}
