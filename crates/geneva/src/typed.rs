//! What several commands take, as it is typed: numbers, each with the range in which we can compute with it, and as messages repeat
//! them; names; the format of an answer, and where it goes.
//!
//! The parser of an option returns a number that the option may have. If one number is possible only with another, the
//! command says so.

use crate::output::{TextLayout, heading};
use crate::printable::escape_and_shorten;
use anyhow::bail;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use geneva_ask::worked::{DriverSpeed, WorkedStep, as_text};
use geneva_kinematics::wheel::STATIONS;
use std::num::NonZeroUsize;
use std::ops::RangeInclusive;
use std::str::FromStr;

pub(crate) use geneva_ask::number_format::{as_typed, rounded};
use geneva_ask::typed_number::{TypedNumber, advice, in_millimetres, unit_of};

/// Numbers whose quotients and products have full precision, far outside of any machine.
const COMPUTABLE: RangeInclusive<f64> = 1e-30..=1e30;

/// Degrees beyond which fractions of one are lost.
const MOST_DEGREES: f64 = 1e9;

/// Pins of a driver whose wheel has three stations; with more stations there are fewer.
const MOST_PINS: u32 = 6;

/// Holes or dowels on a circle that may be asked for.
const HOLES: RangeInclusive<u32> = 2..=12;

/// Most threads that may be asked for.
pub(crate) const MOST_THREADS: usize = 1024;

/// A number above zero.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    above_zero(text, "number")
}

/// A length in millimetres, above zero: the unit of all lengths of a wheel. It can be typed with its unit, `2.5in`, `1-1/2in` or `2cm`.
pub(crate) fn millimetres(text: &str) -> Result<f64, String> {
    length(text, |number| above_zero(number, LENGTH))
}

/// A length in millimetres that is zero or more, or with its unit.
pub(crate) fn millimetres_or_zero(text: &str) -> Result<f64, String> {
    length(text, zero_or_more)
}

/// A length in millimetres of either sign, or with its unit.
pub(crate) fn signed_millimetres(text: &str) -> Result<f64, String> {
    length(text, |typed| {
        let size = read(typed, || {
            format!(
                "not a number; give a {LENGTH} of either sign, such as 0.5 or -0.5, with a decimal point, not a comma"
            )
        })?;
        if size == 0.0 { Ok(size) } else { computable(typed, size) }
    })
}

/// A length in millimetres whose number is read by `parse`; the unit may be behind it, and is then told with what is wrong.
fn length(text: &str, parse: impl Fn(&str) -> Result<f64, String>) -> Result<f64, String> {
    let (typed, size) = in_millimetres(text);
    if let Some(wrong) = number(&typed).is_none().then(|| advice(text, TypedNumber::Length)).flatten() {
        return Err(wrong);
    }
    let in_unit = |said: String| match unit_of(text) {
        // With the unit that was typed, an example is a length, too.
        Some((unit, _)) => {
            let said = said.replacen(typed.as_ref(), &escape_and_shorten(text.trim()), 1);
            said.replace(LENGTH, "length").replace("25 or 0.5", &format!("2{unit} or 0.5{unit}"))
        }
        None => said,
    };
    parse(&typed).map(|length| length * size).map_err(in_unit)
}

/// A number, or what to write instead: where that can't be told, `otherwise` says what is wrong.
fn read(text: &str, otherwise: impl Fn() -> String) -> Result<f64, String> {
    number(text).ok_or_else(|| advice(text, TypedNumber::Plain).unwrap_or_else(&otherwise))
}

/// What a length is, in messages.
const LENGTH: &str = "length in millimetres";

/// A number that is zero or more.
pub(crate) fn zero_or_more(text: &str) -> Result<f64, String> {
    let value = read(text, || {
        "not a number; give zero, or a number above it such as 0.5, with a decimal point, not a comma".to_owned()
    })?;
    if value < 0.0 || value.is_nan() {
        return Err(format!(
            "{} is not zero or more; give zero, or a number above it such as 0.5",
            escape_and_shorten(text.trim())
        ));
    }
    if value == 0.0 { Ok(value) } else { computable(text, value) }
}

/// Turns a minute in either sense, counter-clockwise above zero.
pub(crate) fn turns_a_minute(text: &str) -> Result<f64, String> {
    turning(text, "turns per minute")
}

/// Radians a second in either sense, counter-clockwise above zero.
pub(crate) fn radians_a_second(text: &str) -> Result<f64, String> {
    turning(text, "radians per second")
}

/// A speed of a crank in this unit, in either sense.
fn turning(text: &str, unit: &str) -> Result<f64, String> {
    let value =
        read(text, || format!("not a speed; give {unit}, such as 60 or -60, with a decimal point, not a comma"))?;
    if value == 0.0 || value.is_nan() {
        return Err(format!(
            "the crank must turn, or nothing moves; give {unit} above zero for counter-clockwise, such as 60, or below zero for clockwise"
        ));
    }
    computable(text, value)
}

/// An angle in degrees. Which are possible, the mechanism says.
pub(crate) fn degrees(text: &str) -> Result<f64, String> {
    read(text, || {
        format!(
            "not an angle; give degrees between −{MOST_DEGREES} and {MOST_DEGREES}, with a decimal point, not a comma"
        )
    })
}

/// An angle in degrees, of which every finite one is possible.
pub(crate) fn finite_degrees(text: &str) -> Result<f64, String> {
    let value = degrees(text)?;
    if value.abs() <= MOST_DEGREES {
        Ok(value)
    } else {
        Err(format!(
            "{} is not a usable angle; give degrees between −{MOST_DEGREES} and {MOST_DEGREES}",
            escape_and_shorten(text.trim())
        ))
    }
}

/// A number of a follower's slots. Which are possible, the library says.
pub(crate) fn slots(text: &str) -> Result<u32, String> {
    whole(text, "slots", "3, 4 or 6")
}

/// A number of a wheel's stations. Which are possible, the library says.
pub(crate) fn stations(text: &str) -> Result<u32, String> {
    whole(text, "stations", &format!("an integer from {} to {}", STATIONS.start(), STATIONS.end()))
}

/// A number of a driver's pins. Which are possible, the library says.
pub(crate) fn pins(text: &str) -> Result<u32, String> {
    whole(text, "pins", &format!("an integer from 1 to {MOST_PINS}"))
}

/// A number of holes or dowels on a circle.
pub(crate) fn holes(text: &str) -> Result<u32, String> {
    let possible = format!("an integer from {} to {}", HOLES.start(), HOLES.end());
    let holes: u32 = whole(text, "holes or dowels", &possible)?;
    if HOLES.contains(&holes) {
        Ok(holes)
    } else {
        Err(format!("not a possible number of holes or dowels; give {possible}"))
    }
}

/// A number of threads.
pub(crate) fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let possible = format!("an integer from 1 to {MOST_THREADS}");
    let threads: NonZeroUsize = whole(text, "threads", &possible)?;
    if threads.get() > MOST_THREADS { Err(format!("too many threads; give {possible}")) } else { Ok(threads) }
}

fn whole<T: FromStr>(text: &str, things: &str, possible: &str) -> Result<T, String> {
    text.trim().parse().map_err(|_| format!("not a number of {things}; give {possible}"))
}

/// A number, with either of the signs for minus: the sheet has the typographer's. A zero has none.
pub(crate) fn number(text: &str) -> Option<f64> {
    text.trim().replace('−', "-").parse::<f64>().ok().map(|value| value + 0.0)
}

/// One of the values in a list, by its name; help says what each means.
pub(crate) fn value_named<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    slug: fn(T) -> &'static str,
    meaning: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.iter().map(|value| PossibleValue::new(slug(*value)).help(meaning(*value))))
        .try_map(move |name| all.iter().copied().find(|value| slug(*value) == name).ok_or("not a known name"))
}

/// The number that was typed, if it is above zero and can be computed with; `what` it is.
fn above_zero(text: &str, what: &str) -> Result<f64, String> {
    let value = read(text, || {
        format!("not a number; give a {what} above zero, such as 25 or 0.5, with a decimal point, not a comma")
    })?;
    if value > 0.0 {
        computable(text, value)
    } else {
        Err(format!(
            "{} is not above zero; give a {what} above zero, such as 25 or 0.5",
            escape_and_shorten(text.trim())
        ))
    }
}

fn computable(text: &str, value: f64) -> Result<f64, String> {
    if COMPUTABLE.contains(&value.abs()) {
        return Ok(value);
    }
    let (least, most) = (COMPUTABLE.start(), COMPUTABLE.end());
    Err(format!(
        "{} is too large or too small to compute with; give a number between {least:e} and {most:e}",
        escape_and_shorten(text.trim())
    ))
}

/// The constant speed of a driver or a crank, in one of two units.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub(crate) struct SpeedArguments {
    /// Constant speed in turns per minute; give this or --rad-s
    #[arg(long, value_name = "R", value_parser = turns_a_minute, allow_hyphen_values = true)]
    pub rpm: Option<f64>,
    /// Constant speed in radians per second; give this or --rpm
    #[arg(long, value_name = "W", value_parser = radians_a_second, allow_hyphen_values = true)]
    pub rad_s: Option<f64>,
}

impl SpeedArguments {
    /// The speed that was given; the parser sees to it that there is one.
    pub(crate) fn given(&self) -> DriverSpeed {
        match (self.rpm, self.rad_s) {
            (_, Some(speed)) => DriverSpeed::RadiansPerSecond(speed),
            (rpm, None) => DriverSpeed::Rpm(rpm.unwrap_or_default()),
        }
    }
}

/// The steps of a solution below a sheet.
pub(crate) fn steps(steps: &[WorkedStep], layout: TextLayout) -> String {
    let bold = heading();
    let lines = as_text(steps).lines().map(|line| layout.wrapped("", line)).collect::<String>();
    format!("\n{bold}Steps{bold:#}\n{lines}")
}

/// Where the output goes.
#[derive(Args, Debug)]
pub(crate) struct Output {
    /// Write to this file, or to standard output (-); an existing file is replaced once the new one is complete
    #[arg(long, value_name = "FILE", default_value = "-")]
    pub output: String,
}

/// Output formats. A word means the same to every command that knows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CommandFormat {
    /// Readable text.
    Text,
    /// Text as a line printer wrote it.
    Print,
    /// Everything known, with all digits.
    Json,
    /// A series: one row per claim, mistake or time.
    Csv,
    /// The numbers of one mechanism: one row per field, as CSV.
    Fields,
    /// A drawing as a standalone file.
    Svg,
    /// A drawing for cutting machines.
    Dxf,
    /// A model for OpenSCAD.
    Scad,
    /// A mesh for printing.
    Stl,
    /// Solids for other programs.
    Step,
    /// Parts to be cut, as a drawing.
    Parts,
    /// Markdown for a page.
    Markdown,
}

impl CommandFormat {
    /// Its name at the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Print => "print",
            Self::Json => "json",
            Self::Csv => "csv",
            Self::Fields => "fields",
            Self::Svg => "svg",
            Self::Dxf => "dxf",
            Self::Scad => "scad",
            Self::Stl => "stl",
            Self::Step => "step",
            Self::Parts => "parts",
            Self::Markdown => "markdown",
        }
    }

    /// Refuses an option that applies to this format only, if another is wanted; `what` is what it applies to.
    pub(crate) fn only_with(self, wanted: Self, option: &str, typed: Option<String>, what: &str) -> anyhow::Result<()> {
        match typed {
            Some(typed) if wanted != self => {
                let typed = format!("{option} {typed}");
                bail!(
                    "{} applies only to {what}; give --format {} with it, or leave it out",
                    typed.trim_end(),
                    self.name()
                )
            }
            _ => Ok(()),
        }
    }
}

/// The formats of a command, each with its help. A command without a series says what to use instead of CSV.
pub(crate) fn formats(known: &'static [(CommandFormat, &'static str)]) -> impl TypedValueParser<Value = CommandFormat> {
    let has_series = known.iter().any(|(format, _)| *format == CommandFormat::Csv);
    let names = known.iter().map(|(format, told)| PossibleValue::new(format.name()).help(*told));
    let refused = (!has_series).then(|| PossibleValue::new(CommandFormat::Csv.name()).hide(true));
    PossibleValuesParser::new(names.chain(refused)).try_map(move |name| {
        let format = known.iter().map(|(format, _)| *format).find(|format| format.name() == name);
        format.ok_or(
            "csv is for a series of rows, but this is a single mechanism; use fields for its numbers, one \
                   in each row, or json",
        )
    })
}

/// The name of a value as it is typed.
pub(crate) fn name_of(value: impl ValueEnum) -> Option<String> {
    Some(value.to_possible_value()?.get_name().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_typed_is_told_back() {
        for text in ["-60", "0.125", "1e-20", "1e30", "4e-6", "0.3", "2"] {
            assert_eq!(number(text).map(as_typed).as_deref(), Some(text));
        }
        assert_eq!(number(" −7 "), Some(-7.0));
        assert_eq!(number("0,3"), None);
    }

    type Parser<T> = fn(&str) -> Result<T, String>;

    #[test]
    fn every_number_that_is_none_is_refused_with_numbers_that_can_be_given() {
        let parsers: [Parser<f64>; 7] =
            [positive, radians_a_second, millimetres, zero_or_more, turns_a_minute, degrees, finite_degrees];
        let counts: [Parser<u32>; 4] = [slots, stations, pins, holes];
        let threads = |text: &str| threads(text).map(|threads| threads.get() as f64);
        for text in ["", "x", "１２", "1,2,3", "-", "1e", "nan", "-.5", "1e309", "-1e999", "5e-324"] {
            let numbers = parsers.iter().map(|parse| parse(text)).chain([threads(text)]);
            for refused in numbers.chain(counts.iter().map(|parse| parse(text).map(f64::from))).filter_map(Result::err)
            {
                let given = refused.split("give ").nth(1).unwrap_or_default();
                let ends = [" to ", " up to ", " and ", " or "].iter().any(|word| given.contains(word));
                assert!(ends && given.contains(|sign: char| sign.is_ascii_digit()), "{text}: {refused}");
            }
        }
    }

    #[test]
    fn a_comma_and_a_unit_are_answered_with_what_to_write() {
        let parsers: [Parser<f64>; 8] = [
            positive,
            radians_a_second,
            millimetres,
            millimetres_or_zero,
            signed_millimetres,
            zero_or_more,
            turns_a_minute,
            finite_degrees,
        ];
        for parse in parsers {
            assert_eq!(parse("87,1"), Err("give 87.1, with a decimal point, not a comma".to_owned()));
            let said = parse("5lb").expect_err("a unit");
            assert!(said.contains("without lb") || said.contains("mm, cm, m or in"), "{said}");
        }
        assert_eq!([millimetres("2inch"), millimetres("5cm"), millimetres("0.05m")], [Ok(50.8), Ok(50.0), Ok(50.0)]);
        let said = millimetres("-2in").expect_err("below zero");
        assert_eq!(said, "-2in is not above zero; give a length above zero, such as 2in or 0.5in");
        assert!(millimetres("-1/2in").is_err_and(|said| said.starts_with("-1/2in is not above zero")));
        assert!(
            millimetres("-2").is_err_and(|said| said.contains("length in millimetres above zero, such as 25 or 0.5"))
        );
    }

    #[test]
    fn what_is_out_of_range_is_refused_with_the_range() {
        for (said, words) in [
            (positive("0"), "above zero"),
            (positive("nan"), "nan is not above zero"),
            (positive("1e309"), "1e309 is too large or too small"),
            (zero_or_more("1E309"), "1E309 is too large or too small"),
            (zero_or_more("-0.30"), "-0.30 is not zero or more; give zero, or a number above it such as 0.5"),
            (positive(&"1".repeat(3000)), "1111…"),
            (positive("1e31"), "between 1e-30 and 1e30"),
            (millimetres("x"), "millimetres above zero, such as 25 or 0.5, with a decimal point"),
            (radians_a_second("0"), "radians per second above zero for counter-clockwise"),
            (zero_or_more("nan"), "nan is not zero or more"),
            (turns_a_minute("-0"), "the crank must turn"),
            (turns_a_minute("-1e-31"), "-1e-31 is too large or too small"),
        ] {
            let said = said.expect_err(words);
            assert!(said.contains(words) && said.contains("give "), "{said}");
        }
        assert_eq!(turns_a_minute("−60"), Ok(-60.0));
        assert!(finite_degrees("-0").is_ok_and(f64::is_sign_positive));
        assert!(zero_or_more("-0").is_ok_and(f64::is_sign_positive));
        assert!(threads("1025").is_err() && threads("0").is_err());
    }
}
