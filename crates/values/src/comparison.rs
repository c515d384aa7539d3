//! A printed number against a value: exactly, to the printed digits, in the printed unit.

use crate::numbered_text::PrintedNumber;
use crate::values::{ComputedValue, exact_decimal, power_of_ten};
use dashu_base::Abs;
use dashu_int::IBig;
use geneva_exact::{Rational, rational};
use proofread::unit_named;

/// How a printed number and a value go together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Comparison {
    /// The value rounds to the printed digits.
    Right,
    /// The rounded value differs by one unit of the last printed place.
    LastDigit,
    /// The printed digits are those of the value, times a factor that has a name.
    Scaled(&'static str),
    /// The units measure different things.
    OtherQuantity,
    /// The printed number is another one.
    Other,
}

/// Factors by which numbers are off when a unit or a scale was mistaken, with their names.
const FACTORS: [(&str, &str); 26] = [
    ("10", "10"),
    ("0.1", "a tenth"),
    ("100", "100"),
    ("0.01", "a hundredth"),
    ("1e3", "1000"),
    ("1e-3", "a thousandth"),
    ("1e6", "a million"),
    ("1e-6", "a millionth"),
    ("1e9", "a billion"),
    ("1e-9", "a billionth"),
    ("60", "60, as from minutes to seconds"),
    ("0.0166666666666666666667", "a sixtieth, as from seconds to minutes"),
    ("3600", "3600, as from hours to seconds"),
    ("0.000277777777777777777778", "1/3600, as from seconds to hours"),
    ("3.6", "3.6, as from m/s to km/h"),
    ("0.277777777777777777778", "1/3.6, as from km/h to m/s"),
    ("25.4", "25.4, as from inches to millimetres"),
    ("0.0393700787401574803150", "1/25.4, as from millimetres to inches"),
    ("0.3048", "0.3048, as from feet to metres"),
    ("3.28083989501312335958", "1/0.3048, as from metres to feet"),
    ("57.2957795130823208768", "180/π, as from radians to degrees"),
    ("0.0174532925199432957692", "π/180, as from degrees to radians"),
    ("6.28318530717958647693", "2π"),
    ("0.159154943091895335769", "1/(2π)"),
    ("9.80665", "9.80665, as from kgf to N"),
    ("-1", "−1"),
];

/// What a value must be multiplied by so that it counts in the printed unit.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Conversion {
    /// Nothing: the units are the same, or one side gives none.
    None,
    /// A factor between two units.
    Factor(Rational),
    /// The units measure different things, or one of them counts from another zero.
    Impossible,
}

/// What leads from one unit to another.
pub(crate) fn conversion(from: Option<&str>, to: &str) -> Conversion {
    let Some(from) = from.filter(|from| *from != to && !to.is_empty()) else { return Conversion::None };
    let offset = |unit: &str| unit.contains("°C") || unit.contains("°F");
    let unit = |name: &str| unit_named(&name.replace('·', " ")).filter(|_| !offset(name));
    match unit(from).zip(unit(to)) {
        Some((mine, its)) if mine.dimension == its.dimension && is_part(from) == is_part(to) => {
            let (ratio, inverse) = (mine.factor / its.factor, its.factor / mine.factor);
            // The shorter decimal is the exact one: 0.001 for mm in m, and 1000 the other way.
            let short = |number: f64| format!("{number:e}");
            let decimal = |text: &str| exact_decimal(text).unwrap_or(Rational::ONE);
            let (direct, reverse) = (short(ratio), short(inverse));
            Conversion::Factor(match direct.len() <= reverse.len() {
                true => decimal(&direct),
                false => Rational::ONE / decimal(&reverse),
            })
        }
        _ => Conversion::Impossible,
    }
}

/// Whether a unit counts parts of a whole. Angles have no dimension either, and 18 % are no 10°.
fn is_part(unit: &str) -> bool {
    matches!(unit, "%" | "ppm")
}

/// The value as the printed digits count it: in the printed unit and without the printed power of ten. None if the units measure
/// different things.
pub(crate) fn as_printed(number: &PrintedNumber, value: &ComputedValue, factor: Option<&Rational>) -> Option<Rational> {
    let mut exact = value.exact.clone();
    match factor {
        Some(factor) => exact *= factor,
        None => match conversion(value.unit.as_deref(), &number.unit) {
            Conversion::None => {}
            Conversion::Factor(factor) => exact *= factor,
            Conversion::Impossible => return None,
        },
    }
    let scale = Rational::from(power_of_ten(number.exponent.unsigned_abs()));
    Some(if number.exponent < 0 { exact * scale } else { exact / scale })
}

/// Whether a number rounds to digits printed in this way. Exactly half a unit rounds either way.
pub(crate) fn rounds_to(exact: &Rational, printed: &Rational, last_place: &Rational) -> bool {
    (exact - printed).abs() * rational(2, 1) <= *last_place
}

/// How they go together.
pub(crate) fn compare(number: &PrintedNumber, value: &ComputedValue, factor: Option<&Rational>) -> Comparison {
    let (printed, last) = (number.decimal.exact(), number.decimal.unit_in_last_place());
    let Some(target) = as_printed(number, value, factor) else { return Comparison::OtherQuantity };
    if rounds_to(&target, &printed, &last) {
        return Comparison::Right;
    }
    let apart = (rounded(&target, number.decimal.places()) - &printed).abs();
    if apart == last {
        return Comparison::LastDigit;
    }
    // Of one digit, any number is a multiple.
    let significant = number.digits.bytes().filter(u8::is_ascii_digit).skip_while(|byte| *byte == b'0').count();
    let scaled = FACTORS.iter().find(|(by, _)| {
        significant > 1 && exact_decimal(by).is_ok_and(|by| rounds_to(&(by * &target), &printed, &last))
    });
    scaled.map_or(Comparison::Other, |(_, name)| Comparison::Scaled(name))
}

/// How many of the two neighbours of a printed number the value rounds to as well: the last digit one more and one less.
pub(crate) fn neighbours_passed(number: &PrintedNumber, value: &ComputedValue, factor: Option<&Rational>) -> usize {
    let (printed, last) = (number.decimal.exact(), number.decimal.unit_in_last_place());
    let Some(target) = as_printed(number, value, factor) else { return 0 };
    [&printed + &last, &printed - &last].iter().filter(|neighbour| rounds_to(&target, neighbour, &last)).count()
}

/// A number rounded to places behind the point, halves away from zero.
pub(crate) fn rounded(exact: &Rational, places: u32) -> Rational {
    let scale = power_of_ten(places);
    let shifted = exact * Rational::from(scale.clone());
    Rational::from_parts(shifted.round(), scale)
}

/// A value written as a number is printed: with as many places, its thousands commas and its power of ten.
pub(crate) fn written_like(number: &PrintedNumber, target: &Rational) -> String {
    let places = number.decimal.places() as usize;
    let scaled: IBig = (target * Rational::from(power_of_ten(places as u32))).round();
    let text = scaled.to_string();
    let (sign, digits) = text.strip_prefix('-').map_or(("", &*text), |digits| ("-", digits));
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    let whole = if number.digits.contains(',') { grouped(whole) } else { whole.to_owned() };
    let point = if places > 0 { "." } else { "" };
    let scale = number.printed.strip_prefix(&*number.digits).unwrap_or_default();
    format!("{sign}{whole}{point}{fraction}{scale}")
}

fn grouped(whole: &str) -> String {
    let comma = |at: usize| (at > 0 && (whole.len() - at).is_multiple_of(3)).then_some(',');
    whole.char_indices().flat_map(|(at, c)| comma(at).into_iter().chain([c])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{NumberedText, Values};
    use proofread::TextFormat;

    fn pair(printed: &str, value: &str) -> (PrintedNumber, ComputedValue) {
        let mut text = NumberedText::read(printed, TextFormat::Plain).expect("a text");
        let mut values = Values::default();
        values.add("v.json", &format!("{{\"a\": {value}}}")).expect("a value");
        (text.numbers.remove(0), values.get("a").expect("a value").clone())
    }

    #[test]
    fn each_kind_of_difference_is_told() {
        for (printed, value, expected) in [
            ("2.006", "2.00641", Comparison::Right),
            ("2.007", "2.00641", Comparison::LastDigit),
            ("2.06", "2.00641", Comparison::Other),
            ("2006", "2.00641", Comparison::Scaled("1000")),
            ("12.3 %", "0.1234", Comparison::Scaled("100")),
            ("3.2 mm", "\"0.0032 m\"", Comparison::Right),
            ("0.0032 m", "\"3.2 mm\"", Comparison::Right),
            ("3.2 s", "\"3.2 mm\"", Comparison::OtherQuantity),
            ("1.5e-3", "0.0015", Comparison::Right),
            ("2.5 million", "2496000", Comparison::Right),
            ("12k", "12345", Comparison::Right),
            ("1,234", "1234.4", Comparison::Right),
            ("0.13", "0.125", Comparison::Right),
            ("0.12", "0.125", Comparison::Right),
            ("0.12", "0.1250000000000000000000001", Comparison::LastDigit),
            ("72 km/h", "\"20 m/s\"", Comparison::Right),
            ("10°", "\"18.03 %\"", Comparison::OtherQuantity),
            ("90°", "\"1.5708 rad\"", Comparison::Right),
            ("120 ppm", "\"0.012 %\"", Comparison::Right),
        ] {
            let (number, value) = pair(printed, value);
            assert_eq!(compare(&number, &value, None), expected, "{printed} and {value:?}");
        }
    }

    #[test]
    fn a_value_is_written_as_the_number_is_printed() {
        for (printed, value, written) in [
            ("2.006", "2.0071", "2.007"),
            ("1,234", "1234567.8", "1,234,568"),
            ("0.050", "-0.0004", "0.000"),
            ("1.5e-3", "0.00234", "2.3e-3"),
            ("7", "0.2", "0"),
        ] {
            let (number, value) = pair(printed, value);
            let target = as_printed(&number, &value, None).expect("a number");
            assert_eq!(written_like(&number, &target), written, "{printed}");
        }
    }
}
