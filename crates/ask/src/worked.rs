//! A problem worked with its numbers filled in, step by step, as one writes it for homework; and the units in which such a
//! problem gives its lengths and its speed.
//!
//! A line of a step is text with marked symbols: `{v:P}` is v with the index P, `{a:2:n}` is a with the index 2 and the
//! superscript n, and `{r}` is r alone. A page sets them in italics with real indices; a terminal shows [`plain`] characters.

use crate::number_format::{as_typed, to_digits};
use crate::{Error, ReportField};
use geneva_figures::with_minus_sign;
use std::f64::consts::PI;

/// One step of a solution: what it finds, and the equations with their numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorkedStep {
    /// What the step finds.
    pub heading: &'static str,
    /// Its equations, in the notation of this module; a line without an equals sign is a remark.
    pub lines: Vec<String>,
}

impl WorkedStep {
    /// A step with these lines.
    pub(crate) fn new(heading: &'static str, lines: impl IntoIterator<Item = String>) -> Self {
        Self { heading, lines: lines.into_iter().collect() }
    }
}

/// A line in characters alone: `{v:P}` is `v_P`, and `{a:2:n}` is `a_2^n`.
pub fn plain(line: &str) -> String {
    let symbol = |symbol: &str, indices: &[&str]| {
        symbol.to_owned()
            + &indices.iter().zip(["_", "^"]).map(|(index, mark)| format!("{mark}{index}")).collect::<String>()
    };
    set_symbols(line, str::to_owned, symbol)
}

/// A line with its words and its symbols set by these two functions. A symbol comes with its indices: the lower one first, and then
/// the upper one, as far as it has them.
pub fn set_symbols(line: &str, words: impl Fn(&str) -> String, symbol: impl Fn(&str, &[&str]) -> String) -> String {
    let part = |(place, part): (usize, &str)| {
        if place % 2 == 0 {
            return words(part);
        }
        let parts: Vec<&str> = part.split(':').collect();
        symbol(parts[0], &parts[1..])
    };
    line.split(['{', '}']).enumerate().map(part).collect()
}

/// Steps as lines of text: each heading with its number, and below it its equations.
pub fn as_text(steps: &[WorkedStep]) -> String {
    let step = |(step, number): (&WorkedStep, usize)| {
        let lines: String = step.lines.iter().map(|line| format!("   {}\n", plain(line))).collect();
        format!("{number}. {}\n{lines}", step.heading)
    };
    steps.iter().zip(1..).map(step).collect::<Vec<_>>().join("\n")
}

/// Significant digits that a solution carries from step to step.
const CARRIED: usize = 6;

/// A number as a solution carries it: rounded to six significant digits, so that what is computed from it is computed from what
/// is written.
pub(crate) fn carried(value: f64) -> f64 {
    format!("{value:.behind$e}", behind = CARRIED - 1).parse().unwrap_or(value)
}

/// A number of a step: six significant digits and a true minus sign, or fewer digits if it has no more; without a power of ten
/// as far as a reader counts zeros.
pub(crate) fn shown(value: f64) -> String {
    let value = carried(value);
    let typed = as_typed(value);
    if value == 0.0 || !SIZES.contains(&value.abs()) || !typed.contains('e') && typed.len() < 8 {
        return with_minus_sign(&shorter(typed, to_digits(value, CARRIED)));
    }
    let magnitude = libm::floor(libm::log10(value.abs())) as i32;
    let decimals = usize::try_from(CARRIED as i32 - 1 - magnitude).unwrap_or(0);
    with_minus_sign(&format!("{value:.decimals$}"))
}

/// Sizes of numbers that are written without a power of ten.
const SIZES: std::ops::Range<f64> = 1e-7..1e9;

/// A number as a factor or behind a minus sign: as by [`shown`], in brackets if it is negative.
pub(crate) fn factor(value: f64) -> String {
    bracketed(&shown(value))
}

/// A number as it is written, in brackets if it is negative.
pub(crate) fn bracketed(written: &str) -> String {
    if written.starts_with('−') { format!("({written})") } else { written.to_owned() }
}

/// An angle of a step in degrees, as by [`shown`], with the sign for degrees.
pub(crate) fn in_degrees(degrees: f64) -> String {
    format!("{}°", shown(degrees))
}

/// The shorter of two ways to write a number.
fn shorter(typed: String, written: String) -> String {
    if typed.chars().count() < written.chars().count() { typed } else { written }
}

/// `value`, or zero if it is no more than the rounding of numbers of this size.
pub(crate) fn without_rounding(value: f64, size: f64) -> f64 {
    if value.abs() <= 64.0 * f64::EPSILON * size.abs() { 0.0 } else { value }
}

/// A unit in which a problem gives its lengths. Its speeds, areas and accelerations follow it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthUnit {
    /// Millimetres.
    Millimetre,
    /// Centimetres.
    Centimetre,
    /// Metres.
    Metre,
    /// Inches of 25.4 mm.
    Inch,
    /// Feet of 12 inches.
    Foot,
}

impl LengthUnit {
    /// All units, in the order of a list to choose from.
    pub const ALL: [Self; 5] = [Self::Millimetre, Self::Centimetre, Self::Metre, Self::Inch, Self::Foot];

    /// Its symbol.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "in",
            Self::Foot => "ft",
        }
    }

    /// Its name in words.
    pub const fn in_words(self) -> &'static str {
        match self {
            Self::Millimetre => "millimetres",
            Self::Centimetre => "centimetres",
            Self::Metre => "metres",
            Self::Inch => "inches",
            Self::Foot => "feet",
        }
    }

    /// The unit of speeds.
    pub const fn speed(self) -> &'static str {
        match self {
            Self::Millimetre => "mm/s",
            Self::Centimetre => "cm/s",
            Self::Metre => "m/s",
            Self::Inch => "in/s",
            Self::Foot => "ft/s",
        }
    }

    /// The unit of accelerations.
    pub const fn acceleration(self) -> &'static str {
        match self {
            Self::Millimetre => "mm/s²",
            Self::Centimetre => "cm/s²",
            Self::Metre => "m/s²",
            Self::Inch => "in/s²",
            Self::Foot => "ft/s²",
        }
    }

    /// The unit of areas.
    pub const fn area(self) -> &'static str {
        match self {
            Self::Millimetre => "mm²",
            Self::Centimetre => "cm²",
            Self::Metre => "m²",
            Self::Inch => "in²",
            Self::Foot => "ft²",
        }
    }

    /// How many of it are a metre.
    pub const fn per_metre(self) -> f64 {
        match self {
            Self::Millimetre => 1000.0,
            Self::Centimetre => 100.0,
            Self::Metre => 1.0,
            Self::Inch => 1.0 / 0.0254,
            Self::Foot => 1.0 / 0.3048,
        }
    }

    /// The unit with this symbol.
    ///
    /// # Errors
    ///
    /// A symbol of none of them, with all that there are.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let known = Self::ALL.into_iter().find(|unit| unit.name() == text);
        known.ok_or_else(|| refused!("--unit {text}: give one of {}", Self::ALL.map(Self::name).join(", ")))
    }
}

/// The constant speed of a driver, in the unit in which a problem gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriverSpeed {
    /// In turns per minute.
    Rpm(f64),
    /// In radians per second.
    RadiansPerSecond(f64),
}

impl DriverSpeed {
    /// The speed in radians per second.
    pub fn radians_per_second(self) -> f64 {
        match self {
            Self::Rpm(rpm) => rpm * PI / 30.0,
            Self::RadiansPerSecond(speed) => speed,
        }
    }

    /// The speed in turns per minute.
    pub fn rpm(self) -> f64 {
        match self {
            Self::Rpm(rpm) => rpm,
            Self::RadiansPerSecond(speed) => speed * 30.0 / PI,
        }
    }

    /// The number as it was given.
    pub fn value(self) -> f64 {
        match self {
            Self::Rpm(given) | Self::RadiansPerSecond(given) => given,
        }
    }

    /// Its unit.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Rpm(_) => "rpm",
            Self::RadiansPerSecond(_) => "rad/s",
        }
    }

    /// The speed in radians per second with the way there, in the notation of this module.
    pub(crate) fn line(self) -> String {
        let speed = shown(self.radians_per_second());
        match self {
            Self::Rpm(rpm) => format!("{{θ̇}} = 2π · {} rpm / (60 s/min) = {speed} rad/s", factor(rpm)),
            Self::RadiansPerSecond(_) => format!("{{θ̇}} = {speed} rad/s is given"),
        }
    }

    /// The two fields of an answer: as it was given, and in radians per second.
    pub(crate) fn fields(self, key: &'static str) -> [ReportField; 2] {
        [
            ReportField::new("rpm", crate::number_format::rounded(self.rpm())),
            ReportField::in_unit(key, self.radians_per_second(), "rad/s"),
        ]
    }
}

/// The line from which a crank's angle is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AngleOrigin {
    /// From the line of centres, where the pin is nearest to the other axis: θ, negative before that line.
    LineOfCentres,
    /// From the extension of the line of centres beyond the crank's axis: 180° + θ.
    Extension,
}

impl AngleOrigin {
    /// The angle from the line of centres, in degrees from above −180 to 180.
    pub fn from_line_of_centres(self, degrees: f64) -> f64 {
        let degrees = match self {
            Self::LineOfCentres => degrees,
            Self::Extension => degrees - 180.0,
        };
        let turned = degrees - 360.0 * (degrees / 360.0).round();
        // A half turn to either side is the same place.
        if turned == -180.0 { 180.0 } else { turned + 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_are_read_without_their_marks() {
        let line = "{v:P′} = {v:P} sin {γ} = 151.5 mm/s, {a:2:n} = {R} {θ̇}²";
        assert_eq!(plain(line), "v_P′ = v_P sin γ = 151.5 mm/s, a_2^n = R θ̇²");
        assert_eq!([40.0, -0.5, 17.876_543, 40.000_000_1].map(shown), ["40", "−0.5", "17.8765", "40"]);
        assert_eq!([carried(17.876_543), carried(-1.0 / 3.0)], [17.8765, -0.333_333]);
        assert_eq!((in_degrees(-20.0), factor(-1.0 / 3.0)), ("−20°".to_owned(), "(−0.333333)".to_owned()));
        let steps = [WorkedStep::new("One", ["{r} = 1".to_owned()]), WorkedStep::new("Two", [])];
        assert_eq!(as_text(&steps), "1. One\n   r = 1\n\n2. Two\n");
    }

    #[test]
    fn a_speed_is_the_same_in_either_unit() {
        let speed = DriverSpeed::Rpm(60.0).radians_per_second();
        approx::assert_relative_eq!(speed, 2.0 * PI, max_relative = 1e-15);
        approx::assert_relative_eq!(DriverSpeed::RadiansPerSecond(speed).rpm(), 60.0, max_relative = 1e-15);
        assert!(LengthUnit::parse("mile").is_err_and(|error| error.to_string().contains("mm, cm, m, in, ft")));
        assert!(LengthUnit::ALL.iter().all(|unit| LengthUnit::parse(unit.name()) == Ok(*unit)));
    }
}
