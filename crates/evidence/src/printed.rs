//! Printed digits, kept as text and compared exactly.

use crate::tolerance::{ARITHMETIC, ROUTES};
use dashu_base::{Abs, Signed};
use dashu_int::{IBig, UBig};
use geneva_exact::{Field, Rational, rational};
use std::str::FromStr;

/// A number as printed: a decimal with its digits behind the point, or a fraction of integers.
///
/// A sign `±` is read as plus: the claim is about the size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decimal {
    exact: Rational,
    /// Digits behind the point; a fraction has no last place and is exact.
    places: Option<u32>,
    /// Whether commas part the thousands.
    grouped: bool,
}

/// Text that is not a printed number.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{0}` is not a printed number: digits are expected, with an optional sign, thousands commas and one point, or a \
     fraction of two such integers"
)]
pub struct Unreadable(String);

/// How a printed digit compares with the computed value rounded to as many places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Both numbers have this digit in this place.
    Agree,
    /// All digits before this one agree and this is the last.
    Last,
    /// The first digit that differs, or one behind it.
    Wrong,
}

/// The printed characters, each with its mark.
pub type Marked = Vec<(char, Mark)>;

impl FromStr for Decimal {
    type Err = Unreadable;

    fn from_str(text: &str) -> Result<Self, Unreadable> {
        let unreadable = || Unreadable(text.to_owned());
        let unsigned = text.strip_prefix(['-', '−', '+', '±']).unwrap_or(text);
        let (size, places) = match unsigned.split_once('/') {
            Some((above, below)) => {
                let (above, below) = (digits(above).ok_or_else(unreadable)?, digits(below).ok_or_else(unreadable)?);
                let ((above, 0), (below, 0)) = (above, below) else { return Err(unreadable()) };
                let below = UBig::try_from(below).ok().filter(|below| *below != UBig::ZERO).ok_or_else(unreadable)?;
                (Rational::from_parts(above, below), None)
            }
            None => {
                let (all, places) = digits(unsigned).ok_or_else(unreadable)?;
                (Rational::from_parts(all, power_of_ten(places)), Some(places))
            }
        };
        let negative = text.starts_with(['-', '−']);
        Ok(Self { exact: if negative { -size } else { size }, places, grouped: text.contains(',') })
    }
}

/// All digits of a decimal without a sign as one integer, and how many of them are behind the point.
fn digits(text: &str) -> Option<(IBig, u32)> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let grouped = whole.replace(',', "");
    let point_without_digits = fraction.is_empty() && text.contains('.');
    let all = format!("{grouped}{fraction}");
    let well_formed =
        !all.is_empty() && !point_without_digits && groups_of_three(whole) && all.bytes().all(|b| b.is_ascii_digit());
    if !well_formed {
        return None;
    }
    Some((all.parse().ok()?, fraction.len() as u32))
}

fn groups_of_three(whole: &str) -> bool {
    let mut groups = whole.split(',');
    let first = groups.next().unwrap_or_default();
    let mut rest = groups.peekable();
    rest.peek().is_none() || (1..=3).contains(&first.len()) && rest.all(|group| group.len() == 3)
}

impl Decimal {
    /// How many places more than the printed number a computed one is shown with.
    pub const MORE_PLACES: usize = 3;

    /// Digits behind the point; none for a fraction.
    pub fn places(&self) -> u32 {
        self.places.unwrap_or(0)
    }

    /// The number, exactly.
    pub fn exact(&self) -> Rational {
        self.exact.clone()
    }

    /// The nearest `f64`.
    pub fn to_f64(&self) -> f64 {
        self.exact.approximate()
    }

    /// One unit of the last printed place; zero for a fraction, which is exact.
    pub fn unit_in_last_place(&self) -> Rational {
        self.places.map_or(Rational::ZERO, |places| Rational::from_parts(IBig::ONE, power_of_ten(places)))
    }

    /// The interval that the digits leave open: half a unit of the last place either way.
    pub fn interval(&self) -> [f64; 2] {
        let half = self.unit_in_last_place().approximate() / 2.0;
        [self.to_f64() - half, self.to_f64() + half]
    }

    /// Whether `computed` rounds to the printed digits: it is within half a unit of the last printed place.
    pub fn is_rounding_of(&self, computed: f64) -> bool {
        let Ok(exact) = Rational::try_from(computed) else { return false };
        let half = self.unit_in_last_place() / rational(2, 1);
        (exact.clone() - self.exact()).abs() <= half + slack(&exact)
    }

    /// Whether cutting `computed` off behind the last printed place gives the printed digits.
    pub fn is_truncation_of(&self, computed: f64) -> bool {
        let Ok(exact) = Rational::try_from(computed) else { return false };
        let (size, printed) = (exact.clone().abs(), self.exact().abs());
        let same_side = exact.is_negative() == self.exact.is_negative() || self.exact.is_zero();
        let beyond = size - printed;
        same_side && beyond >= -slack(&exact) && beyond < self.unit_in_last_place()
    }

    /// Another number, written as this one is: with as many places, or as a fraction if it is one of whole numbers.
    pub fn like(&self, number: f64) -> String {
        let Some(places) = self.places else {
            let above = |below: u32| libm::round(number * f64::from(below));
            let is_exact = |below: &u32| ROUTES.agrees(above(*below) / f64::from(*below), number);
            let below = (1..=1000).find(is_exact);
            return below.map_or_else(|| number.to_string(), |below| format!("{:.0}/{below}", above(below)));
        };
        let text = format!("{number:.*}", places as usize);
        let whole = text.trim_start_matches('-').split('.').next().map_or(0, str::len);
        if !self.grouped {
            return text;
        }
        let sign = text.len() - text.trim_start_matches('-').len();
        let comma =
            |at: usize| (at > sign && at < sign + whole && (sign + whole - at).is_multiple_of(3)).then_some(',');
        text.char_indices().flat_map(|(at, c)| comma(at).into_iter().chain([c])).collect()
    }

    /// Marks each character of `text`, as which this number was printed, against `computed`.
    pub fn marks(&self, text: &str, computed: f64) -> Marked {
        let Some(places) = self.places else {
            let mark = if self.is_rounding_of(computed) { Mark::Agree } else { Mark::Wrong };
            return text.chars().map(|c| (c, if c.is_ascii_digit() { mark } else { Mark::Agree })).collect();
        };
        let ours = format!("{computed:.*}", places as usize);
        let plain: Vec<char> = text.chars().map(|c| if c == '−' { '-' } else { c }).filter(|c| !skipped(*c)).collect();
        let ours: Vec<char> = ours.chars().collect();
        let differs = if self.is_rounding_of(computed) {
            None
        } else if plain.len() == ours.len() {
            plain.iter().zip(&ours).position(|(p, o)| p != o)
        } else {
            Some(0)
        };
        let mut place = 0;
        text.chars()
            .map(|c| {
                let here = place;
                place += usize::from(!skipped(c));
                let mark = match differs {
                    Some(first) if here == first && first + 1 == plain.len() => Mark::Last,
                    Some(first) if here >= first && c.is_ascii_digit() => Mark::Wrong,
                    _ => Mark::Agree,
                };
                (c, mark)
            })
            .collect()
    }
}

/// What comes between digits, or before them, and is no place of the number.
fn skipped(c: char) -> bool {
    matches!(c, ',' | '±' | '+')
}

fn power_of_ten(exponent: u32) -> UBig {
    UBig::from(10u8).pow(exponent as usize)
}

/// What floating-point arithmetic may have cost a computed value.
fn slack(exact: &Rational) -> Rational {
    Rational::try_from(ARITHMETIC.relative).map_or(Rational::ZERO, |relative| exact.clone().abs() * relative)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decimal(text: &str) -> Decimal {
        text.parse().expect("readable")
    }

    #[test]
    fn digits_are_kept_with_their_places() {
        assert_eq!(decimal("0.050").places(), 3);
        assert_eq!(decimal("1,234").exact(), rational(1234, 1));
        assert_eq!(decimal("−0.25").exact(), rational(-1, 4));
        assert_eq!(decimal("1/18").exact(), rational(1, 18));
        assert_eq!(decimal("±1.5").exact(), rational(3, 2));
        for text in ["1/0", "1/2.5", "/3", "1/2/3", "", ".", "1.2.3", "12,34", ",123", "1e3", "a", "--1", "1."] {
            let read = text.parse::<Decimal>();
            assert!(read.is_err(), "{text}: {read:?}");
        }
    }

    #[test]
    fn half_a_unit_of_the_last_place_decides() {
        let printed = decimal("0.3");
        for (computed, rounds) in [(0.25, true), (0.3499, true), (0.2499, false), (0.3501, false), (f64::NAN, false)] {
            assert_eq!(printed.is_rounding_of(computed), rounds, "{computed}");
        }
    }

    #[test]
    fn a_fraction_is_exact() {
        assert!(decimal("1/3").is_rounding_of(1.0 / 3.0));
        assert!(!decimal("1/3").is_rounding_of(0.3333333));
        assert!(!decimal("1/3").is_truncation_of(0.34));
    }

    #[test]
    fn cutting_off_is_told_from_rounding() {
        let printed = decimal("0.055");
        assert!(printed.is_truncation_of(1.0 / 18.0) && !printed.is_rounding_of(1.0 / 18.0));
        assert!(!printed.is_truncation_of(-1.0 / 18.0));
        assert!(decimal("-1.2").is_truncation_of(-1.29));
    }

    #[test]
    fn another_number_is_written_alike() {
        let alike =
            [("0.050", 0.1111, "0.111"), ("1/3", 2.0 / 3.0, "2/3"), ("1/18", 1.0 / 9.0, "1/9"), ("2", 7.6, "8")];
        let grouped = [("1,234", 2345.6, "2,346"), ("1,234", -123_456.7, "-123,457"), ("1,234.5", 99.04, "99.0")];
        for (text, number, written) in alike.into_iter().chain(grouped) {
            assert_eq!(decimal(text).like(number), written, "{text}");
        }
    }

    #[test]
    fn marks_show_where_the_digits_part() {
        let marks = |text: &str, computed| -> String {
            decimal(text)
                .marks(text, computed)
                .iter()
                .map(|(_, mark)| match mark {
                    Mark::Agree => '=',
                    Mark::Last => '~',
                    Mark::Wrong => '#',
                })
                .collect()
        };
        assert_eq!(marks("12.34", 12.3412), "=====");
        assert_eq!(marks("12.34", 12.351), "====~");
        assert_eq!(marks("12.34", 12.21), "===##");
        assert_eq!(marks("1,234", 1334.0), "==###");
        assert_eq!(marks("9.9", 10.4), "#=#");
        assert_eq!(marks("±1.3", 1.26), "====");
        assert_eq!(marks("1/3", 0.5), "#=#");
    }
}
