//! Numbers and lengths as they are typed: units of length, and what to write instead of a text that is no number.

use crate::Error;
use crate::number_format::MILLIMETRES_OF_AN_INCH;
use std::borrow::Cow;

/// Units of length with their millimetres. Of two that end alike, the longer one is first.
const UNITS: [(&str, f64); 8] = [
    ("mm", 1.0),
    ("cm", 10.0),
    ("inches", INCH),
    ("inch", INCH),
    ("in", INCH),
    ("\"", INCH),
    ("″", INCH),
    ("m", 1000.0),
];
const INCH: f64 = MILLIMETRES_OF_AN_INCH;

/// Characters of a number and of a unit that a message repeats at most.
const MOST_REPEATED: usize = 24;

/// What a typed number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TypedNumber {
    /// A number in the unit of its option.
    Plain,
    /// A length, with or without its unit.
    Length,
}

/// A length as it is typed, without its unit, and the millimetres of that unit: `2.5in`, `2.5"`, `1/8in`, `½in`, `1-1/2 inch`, `8mm`, `0.8cm`,
/// `0.008m` or `8`. A fraction of an inch becomes a decimal number; one of another unit, or without one, is left as it is, and is no
/// number.
///
/// ```
/// use geneva_ask::typed_number::in_millimetres;
///
/// assert_eq!(in_millimetres("0.5in"), ("0.5".into(), 25.4)); // mm
/// assert_eq!(in_millimetres("1-1/2in"), ("1.5".into(), 25.4));
/// assert_eq!(in_millimetres("8cm"), ("8".into(), 10.0));
/// assert_eq!(in_millimetres("8"), ("8".into(), 1.0));
/// ```
pub fn in_millimetres(text: &str) -> (Cow<'_, str>, f64) {
    let text = text.trim();
    let found = UNITS.into_iter().find_map(|(unit, size)| Some((text.strip_suffix(unit)?.trim_end(), size)));
    let (number, size) = found.unwrap_or((text, 1.0));
    let value = if size == INCH { fraction(number) } else { None };
    (value.map_or(number.into(), |value| value.to_string().into()), size)
}

/// The unit with which a length is typed, and its millimetres; none for millimetres, and of a number alone.
///
/// ```
/// use geneva_ask::typed_number::unit_of;
///
/// assert_eq!([unit_of("1/2 inch"), unit_of("2cm"), unit_of("8mm")], [Some(("in", 25.4)), Some(("cm", 10.0)), None]);
/// ```
pub fn unit_of(text: &str) -> Option<(&'static str, f64)> {
    let (_, size) = in_millimetres(text);
    // Of several signs for one unit the shortest word is told.
    [("in", INCH), ("cm", 10.0), ("m", 1000.0)].into_iter().find(|(_, of)| *of == size)
}

/// Fractions that are one character.
const ONE_CHARACTER: [(char, &str); 10] = [
    ('½', " 1/2"),
    ('¼', " 1/4"),
    ('¾', " 3/4"),
    ('⅛', " 1/8"),
    ('⅜', " 3/8"),
    ('⅝', " 5/8"),
    ('⅞', " 7/8"),
    ('⅓', " 1/3"),
    ('⅔', " 2/3"),
    ('⁄', "/"),
];

/// A text whose fractions are written with digits and a stroke.
fn with_stroke(text: &str) -> String {
    let spelled = ONE_CHARACTER.iter().fold(text.to_owned(), |text, (one, spelled)| text.replace(*one, spelled));
    let (sign, size) = spelled.strip_prefix(['-', '−']).map_or(("", spelled.as_str()), |size| ("-", size));
    format!("{sign}{}", size.trim())
}

/// The value of `1/8`, `1-1/2`, `1 1/2` or `1½`, with a sign or without; none of anything else.
fn fraction(text: &str) -> Option<f64> {
    let spelled = with_stroke(text);
    let text = spelled.as_str();
    let (sign, size) = match text.strip_prefix(['-', '−']) {
        Some(size) => (-1.0, size),
        None => (1.0, text),
    };
    let (above, below) = size.split_once('/')?;
    let (whole, above) = above.trim().split_once(['-', ' ']).unwrap_or(("0", above));
    let [whole, above, below] = [whole, above, below].map(|digits| digits.trim().parse::<u32>().ok());
    let below = below.filter(|below| *below > 0)?;
    Some(sign * (f64::from(whole?) + f64::from(above?) / f64::from(below)))
}

/// A length in millimetres: a number, or one with its unit, `2.5in`, `1-1/2in` or `2cm`.
///
/// # Errors
///
/// What is no number, with what to write instead.
pub(crate) fn length(name: &str, text: &str) -> Result<f64, Error> {
    let (number, unit) = in_millimetres(text);
    read(&number).map(|value| value * unit).ok_or_else(|| {
        let advice = advice(text, TypedNumber::Length);
        let advice =
            advice.unwrap_or_else(|| "not a length; give millimetres, or a number in mm, cm, m or in".to_owned());
        refused!("--{name} {text}: {advice}")
    })
}

/// A number with either of the signs for minus.
fn read(text: &str) -> Option<f64> {
    text.trim().replace('−', "-").parse().ok()
}

/// What to write instead of a text that is no number, if that can be told: it has a comma, or a unit that isn't read here.
///
/// ```
/// use geneva_ask::typed_number::{TypedNumber, advice};
///
/// let of = |text| advice(text, TypedNumber::Length).expect("an advice");
/// assert_eq!(of("87,1"), "give 87.1, with a decimal point, not a comma");
/// assert!(of("5lb").starts_with("lb is not a unit of length that is read here"));
/// assert_eq!(advice("many", TypedNumber::Length), None);
/// ```
pub fn advice(text: &str, what: TypedNumber) -> Option<String> {
    let text = text.trim();
    let number = if what == TypedNumber::Length { in_millimetres(text).0 } else { text.into() };
    let is_short = text.chars().count() <= MOST_REPEATED;
    if number.contains(',') && is_short {
        let [pointed, bare] = [".", ""].map(|mark| number.replace(',', mark));
        let [with_point, without] = [".", ""].map(|mark| text.replace(',', mark));
        // Three digits behind each comma may be thousands.
        let mut groups = number.trim_start_matches(['-', '−', '+']).split(',');
        let is_of_zero = groups.next().is_some_and(|first| first.starts_with('0'));
        let has_thousands = groups.all(|group| group.split('.').next().is_some_and(|digits| digits.len() == 3));
        return match (read(&pointed).is_some(), has_thousands && !is_of_zero && read(&bare).is_some()) {
            (true, false) => Some(format!("give {with_point}, with a decimal point, not a comma")),
            (true, true) => Some(format!("give {with_point}, with a decimal point, or {without}, without a comma")),
            (false, true) => Some(format!("give {without}, without commas")),
            (false, false) => None,
        };
    }
    let parted = |mark: char| mark.is_whitespace() || matches!(mark, '\'' | '’' | '_');
    if is_short && number.contains(parted) && read(&number.replace(parted, "")).is_some() {
        return Some(format!("give {}, without a mark between the digits", text.replace(parted, "")));
    }
    if what == TypedNumber::Length && with_stroke(&number).contains('/') {
        let in_inches = format!("{number}in");
        let is_fraction = is_short && read(&in_millimetres(&in_inches).0).is_some();
        return is_fraction.then(|| format!("only inches have fractions; give {in_inches}, or a decimal number"));
    }
    let bare = text.trim_end_matches(|sign: char| sign.is_ascii_alphabetic() || "%'′µ".contains(sign)).trim_end();
    let unit = text.strip_prefix(bare)?.trim_start();
    if unit.is_empty() || matches!(unit, "e" | "E") || !is_short || read(bare).is_none() {
        return None;
    }
    Some(match what {
        TypedNumber::Length => {
            format!(
                "{unit} is not a unit of length that is read here; give a number in mm, cm, m or in, such as {bare}mm"
            )
        }
        TypedNumber::Plain => format!("give {bare}, without {unit}: the option has its own unit, which --help names"),
    })
}

#[cfg(test)]
mod tests {
    use super::{TypedNumber, advice, in_millimetres, length};

    #[test]
    fn lengths_are_read_in_every_unit_that_a_refusal_names() {
        // Sixty-fourths are exact in binary, so the closed form is, too.
        let right = [
            ("1in", 25.4),
            ("0.5 inch", 12.7),
            ("2inches", 50.8),
            ("1/8in", 0.125 * 25.4),
            ("1-1/2in", 1.5 * 25.4),
            ("1 1/2 in", 1.5 * 25.4),
            ("½in", 0.5 * 25.4),
            ("1½ in", 1.5 * 25.4),
            ("1 ⅜\"", 1.375 * 25.4),
            ("-1⁄4in", -0.25 * 25.4),
            ("-3/64\"", -0.046_875 * 25.4),
            ("−1/4″", -0.25 * 25.4),
            ("8mm", 8.0),
            ("8 cm", 80.0),
            ("0.008m", 8.0),
            ("8", 8.0),
        ];
        for (text, millimetres) in right {
            assert_eq!(length("crank-radius", text).expect(text), millimetres, "{text}");
        }
        for text in ["1/8", "1/8mm", "1/0in", "1/in", "/8in", "1/2/4in", "1.5/8in", "1--1/2in", "in", "5lb", "5ft", "m"]
        {
            let error = length("crank-radius", text).expect_err(text).to_string();
            assert!(error.starts_with(&format!("--crank-radius {text}: ")), "{error}");
            let named = ["mm", "cm", "in"].into_iter().filter(|unit| error.contains(unit)).count();
            assert!(named == 3 || error.contains("only inches have fractions; give 1/8in"), "{error}");
        }
    }

    #[test]
    fn what_is_advised_can_be_read() {
        for (text, said) in [
            ("87,1", "give 87.1, with a decimal point, not a comma"),
            ("87,1mm", "give 87.1mm, with a decimal point, not a comma"),
            ("-0,125", "give -0.125, with a decimal point, not a comma"),
            ("0,125", "give 0.125, with a decimal point, not a comma"),
            ("1,250", "give 1.250, with a decimal point, or 1250, without a comma"),
            ("1,250.5", "give 1250.5, without commas"),
            ("1,250,000", "give 1250000, without commas"),
            ("1/8", "only inches have fractions; give 1/8in, or a decimal number"),
            ("½", "only inches have fractions; give ½in, or a decimal number"),
            ("1 000", "give 1000, without a mark between the digits"),
            ("1'000.5mm", "give 1000.5mm, without a mark between the digits"),
        ] {
            assert_eq!(advice(text, TypedNumber::Length).as_deref(), Some(said));
            let words = said.split("give ").nth(1).and_then(|rest| rest.split(", ").next()).expect("a number");
            assert!(length("crank-radius", words).is_ok(), "{words}");
        }
        assert_eq!(
            advice("5lb", TypedNumber::Plain).as_deref(),
            Some("give 5, without lb: the option has its own unit, which --help names")
        );
        for text in
            ["", "x", "-", "1e", "1,2,3", ",", "6.1,6.0", "1.2.3", &"1".repeat(40), &format!("{},5", "1".repeat(40))]
        {
            assert_eq!(advice(text, TypedNumber::Plain), None, "{text}");
        }
        assert_eq!(in_millimetres("x").0, "x");
    }
}
