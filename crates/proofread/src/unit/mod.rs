//! Units of measurement as texts write them, by their factor to the base units of the SI.

pub(crate) mod product;

use crate::decimal::fixed;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Exponents of metre, kilogram, second, ampere, kelvin, mole and candela, each in sixtieths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnitDimension([i32; 7]);

impl UnitDimension {
    /// No dimension.
    pub const NONE: Self = Self([0; 7]);

    const fn from_exponents(exponents: [i32; 7]) -> Self {
        let mut sixtieths = [0; 7];
        let mut at = 0;
        while at < 7 {
            sixtieths[at] = exponents[at] * 60;
            at += 1;
        }
        Self(sixtieths)
    }

    /// Its name: that of a unit of the SI without a prefix, or a product of base units; empty if there is none.
    pub(crate) fn in_base_units(self) -> String {
        const NAMED: [&str; 11] = ["N", "J", "W", "Pa", "C", "V", "Ω", "F", "T", "H", "Wb"];
        const BASE: [&str; 7] = ["m", "kg", "s", "A", "K", "mol", "cd"];
        let named = NAMED.into_iter().find(|name| unit(name).is_some_and(|unit| unit.dimension == self));
        if let Some(name) = named {
            return name.to_owned();
        }
        let part = |(name, sixtieths): (&str, i32)| match f64::from(sixtieths) / 60.0 {
            0.0 => None,
            1.0 => Some(name.to_owned()),
            power => {
                let power = fixed(power, 3);
                let power = power.trim_end_matches('0').trim_end_matches('.');
                Some(format!("{name}^{power}").replace('-', "−"))
            }
        };
        BASE.into_iter().zip(self.0).filter_map(part).collect::<Vec<_>>().join("·")
    }

    /// Whether there is none.
    pub(crate) fn is_none(self) -> bool {
        self == Self::NONE
    }

    /// The dimension of a product with another quantity to a power; sizes that no text has are cut.
    #[must_use]
    pub(crate) fn with_factor(self, other: Self, power: f64) -> Self {
        if other == Self::NONE {
            return self;
        }
        let mut result = self.0;
        for (mine, its) in result.iter_mut().zip(other.0) {
            let more = (f64::from(its) * power).round().clamp(-1e6, 1e6) as i32;
            *mine = (*mine + more).clamp(-1_000_000, 1_000_000);
        }
        Self(result)
    }

    /// The dimension of a quantity to a power.
    #[must_use]
    pub(crate) fn power(self, power: f64) -> Self {
        Self::NONE.with_factor(self, power)
    }
}

/// A unit: one of it is `factor` base units of its dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasurementUnit {
    /// How many base units of the SI it is, in units of its dimension.
    pub factor: f64,
    /// Its dimension.
    pub dimension: UnitDimension,
}

const LENGTH: [i32; 7] = [1, 0, 0, 0, 0, 0, 0];
const AREA: [i32; 7] = [2, 0, 0, 0, 0, 0, 0];
const VOLUME: [i32; 7] = [3, 0, 0, 0, 0, 0, 0];
const MASS: [i32; 7] = [0, 1, 0, 0, 0, 0, 0];
const TIME: [i32; 7] = [0, 0, 1, 0, 0, 0, 0];
const RATE: [i32; 7] = [0, 0, -1, 0, 0, 0, 0];
const SPEED: [i32; 7] = [1, 0, -1, 0, 0, 0, 0];
const FORCE: [i32; 7] = [1, 1, -2, 0, 0, 0, 0];
const ENERGY: [i32; 7] = [2, 1, -2, 0, 0, 0, 0];
const POWER: [i32; 7] = [2, 1, -3, 0, 0, 0, 0];
const PRESSURE: [i32; 7] = [-1, 1, -2, 0, 0, 0, 0];
const CHARGE: [i32; 7] = [0, 0, 1, 1, 0, 0, 0];
const FIELD: [i32; 7] = [0, 1, -2, -1, 0, 0, 0];
const DOSE: [i32; 7] = [2, 0, -2, 0, 0, 0, 0];
const CONCENTRATION: [i32; 7] = [-3, 0, 0, 0, 0, 1, 0];
const KELVIN: [i32; 7] = [0, 0, 0, 0, 1, 0, 0];
const PLAIN: [i32; 7] = [0; 7];

const EV: f64 = 1.602_176_634e-19;
const DALTON: f64 = 1.660_539_07e-27;

/// Units that take a prefix if they are written by their sign: names, factor, dimension, and the signs that take one.
type UnitRow = (&'static str, f64, [i32; 7]);

const PREFIXED: &[UnitRow] = &[
    ("m", 1.0, LENGTH),
    ("g", 1e-3, MASS),
    ("s", 1.0, TIME),
    ("A", 1.0, [0, 0, 0, 1, 0, 0, 0]),
    ("K", 1.0, KELVIN),
    ("mol", 1.0, [0, 0, 0, 0, 0, 1, 0]),
    ("N", 1.0, FORCE),
    ("J", 1.0, ENERGY),
    ("W", 1.0, POWER),
    ("Pa", 1.0, PRESSURE),
    ("Hz", 1.0, RATE),
    ("C", 1.0, CHARGE),
    ("V", 1.0, [2, 1, -3, -1, 0, 0, 0]),
    ("Ω ohm ohms", 1.0, [2, 1, -3, -2, 0, 0, 0]),
    ("F", 1.0, [-2, -1, 4, 2, 0, 0, 0]),
    ("T", 1.0, FIELD),
    ("H", 1.0, [2, 1, -2, -2, 0, 0, 0]),
    ("Wb", 1.0, [2, 1, -2, -1, 0, 0, 0]),
    ("S", 1.0, [-2, -1, 3, 2, 0, 0, 0]),
    ("eV", EV, ENERGY),
    ("L l", 1e-3, VOLUME),
    ("Bq", 1.0, RATE),
    ("Gy Sv", 1.0, DOSE),
    ("rem", 0.01, DOSE),
    ("Ci", 3.7e10, RATE),
    ("G", 1e-4, FIELD),
    ("bar", 1e5, PRESSURE),
    ("cal", 4.186, ENERGY),
    ("pc", 3.085_677_581_491_367e16, LENGTH),
];

/// Signs and names of currencies.
const CURRENCIES: [&str; 4] = ["$ USD dollar dollars", "€ EUR euro euros Euro", "£ GBP", "CHF"];

const WHOLE: &[UnitRow] = &[
    ("meter meters metre metres", 1.0, LENGTH),
    ("gram grams", 1e-3, MASS),
    ("kilogram kilograms", 1.0, MASS),
    ("kilometer kilometers kilometre kilometres", 1e3, LENGTH),
    ("sec second seconds", 1.0, TIME),
    ("amp amps ampere amperes", 1.0, [0, 0, 0, 1, 0, 0, 0]),
    ("kelvin kelvins", 1.0, KELVIN),
    ("mole moles", 1.0, [0, 0, 0, 0, 0, 1, 0]),
    ("cd lm", 1.0, [0, 0, 0, 0, 0, 0, 1]),
    ("lx", 1.0, [-2, 0, 0, 0, 0, 0, 1]),
    ("newton newtons", 1.0, FORCE),
    ("joule joules Joule Joules", 1.0, ENERGY),
    ("watt watts", 1.0, POWER),
    ("volt volts", 1.0, [2, 1, -3, -1, 0, 0, 0]),
    ("liter liters litre litres ℓ", 1e-3, VOLUME),
    ("mℓ", 1e-6, VOLUME),
    ("Å angstrom angstroms", 1e-10, LENGTH),
    ("fm", 1e-15, LENGTH),
    ("b", 1e-28, AREA),
    ("Da u amu", DALTON, MASS),
    ("t ton tonne tonnes", 1000.0, MASS),
    ("min minute minutes", 60.0, TIME),
    ("h hr hrs hour hours", 3600.0, TIME),
    ("d day days", 86_400.0, TIME),
    ("week weeks wk", 604_800.0, TIME),
    ("y yr year years", 3.155_76e7, TIME),
    ("kyr", 3.155_76e10, TIME),
    ("Myr", 3.155_76e13, TIME),
    ("Gyr", 3.155_76e16, TIME),
    (
        "rad sr turns photons photon atoms atom molecules electrons electron particles decays fissions proton protons ion nuclei people \
         loops passes lines events ions slits cycles cycle fringes reactions nucleons layers pulses times beats Np deuterons \
         flashes orbits windings bulbs cars halflives wt dB",
        1.0,
        PLAIN,
    ),
    ("rev revs revolution revolutions", 2.0 * PI, PLAIN),
    ("rpm", 2.0 * PI / 60.0, RATE),
    ("° degree degrees", PI / 180.0, PLAIN),
    ("arcsec", PI / 180.0 / 3600.0, PLAIN),
    ("% percent", 0.01, PLAIN),
    ("ppm", 1e-6, PLAIN),
    (CURRENCIES[0], 1.0, PLAIN),
    (CURRENCIES[1], 1.0, PLAIN),
    (CURRENCIES[2], 1.0, PLAIN),
    (CURRENCIES[3], 1.0, PLAIN),
    ("cents", 0.01, PLAIN),
    ("atm", 101_325.0, PRESSURE),
    ("Torr torr mmHg", 101_325.0 / 760.0, PRESSURE),
    ("cmHg", 1333.22, PRESSURE),
    ("inHg", 3386.39, PRESSURE),
    ("cmwater", 98.0665, PRESSURE),
    ("mmwater", 9.806_65, PRESSURE),
    ("psi", 6894.757, PRESSURE),
    ("ksi", 6.894_757e6, PRESSURE),
    ("lb lbs lbf", 4.448_221_6, FORCE),
    ("kip kips", 4448.2216, FORCE),
    ("kgf kp", 9.806_65, FORCE),
    ("lbm", 0.453_592_37, MASS),
    ("slug slugs", 14.5939, MASS),
    ("oz", 0.028_349_5, MASS),
    ("dyn", 1e-5, FORCE),
    ("erg", 1e-7, ENERGY),
    ("ft feet foot", 0.3048, LENGTH),
    ("in inch inches", 0.0254, LENGTH),
    ("mi mile miles", 1609.344, LENGTH),
    ("nmi", 1852.0, LENGTH),
    ("yd", 0.9144, LENGTH),
    ("ly", 9.460_730_472_580_8e15, LENGTH),
    ("Mly", 9.460_730_472_580_8e21, LENGTH),
    ("AU au", 1.495_978_707e11, LENGTH),
    ("acre", 4046.86, AREA),
    ("gal gallon gallons", 3.785_411_784e-3, VOLUME),
    ("cc", 1e-6, VOLUME),
    ("mph", 0.447_04, SPEED),
    ("knot knots", 0.514_444, SPEED),
    ("hp", 746.0, POWER),
    ("Btu BTU", 1055.06, ENERGY),
    ("Cal kcal", 4186.0, ENERGY),
    ("kWh", 3.6e6, ENERGY),
    ("MWh", 3.6e9, ENERGY),
    ("GWh", 3.6e12, ENERGY),
    ("TWh", 3.6e15, ENERGY),
    ("mAh", 3.6, CHARGE),
    ("kVA", 1e3, POWER),
    ("M", 1e3, CONCENTRATION),
    ("mM", 1.0, CONCENTRATION),
    ("μM", 1e-3, CONCENTRATION),
    ("M⊙", 1.988e30, MASS),
    ("R⊙", 6.957e8, LENGTH),
    ("L⊙", 3.828e26, POWER),
    ("Mev", 1e6 * EV, ENERGY),
    ("e", EV, CHARGE),
    ("Gs", 1e-4, FIELD),
    ("D diopter diopters", 1.0, [-1, 0, 0, 0, 0, 0, 0]),
    ("°C", 1.0, KELVIN),
    ("°F", 5.0 / 9.0, KELVIN),
];

/// Units that are written without anything between them.
const PAIRS: &[(&str, &str, &str)] = &[
    ("Nm", "N", "m"),
    ("kNm", "kN", "m"),
    ("eVs", "eV", "s"),
    ("kgm", "kg", "m"),
    ("Js", "J", "s"),
    ("Ns", "N", "s"),
    ("Vm", "V", "m"),
    ("Ah", "A", "h"),
    ("Wh", "W", "h"),
    ("Tm", "T", "m"),
    ("Wm", "W", "m"),
    ("Vs", "V", "s"),
    ("Ws", "W", "s"),
    ("VA", "V", "A"),
];

const PREFIXES: &[(char, f64)] = &[
    ('k', 1e3),
    ('M', 1e6),
    ('G', 1e9),
    ('T', 1e12),
    ('P', 1e15),
    ('E', 1e18),
    ('c', 1e-2),
    ('d', 1e-1),
    ('h', 1e2),
    ('m', 1e-3),
    ('μ', 1e-6),
    ('n', 1e-9),
    ('p', 1e-12),
    ('f', 1e-15),
    ('a', 1e-18),
];

/// Prefixes of units that are written out.
const PREFIX_WORDS: &[(&str, f64)] =
    &[("pico", 1e-12), ("nano", 1e-9), ("micro", 1e-6), ("milli", 1e-3), ("kilo", 1e3), ("mega", 1e6)];

/// Units that are written out behind such a prefix.
const PREFIXED_WORDS: &str = " meter meters metre metres gram grams second seconds amp amps ampere amperes mole moles newton newtons \
    joule joules watt watts volt volts liter liters litre litres ohm ohms ";

/// Letters that are a product of quantities, or nothing, more often than a unit with a prefix.
const NO_UNITS: &str = " as am aA aK aN aJ aV aT aH aC aF aL al ds dA dV dN dK dW dT dF dH dC dJ dS hm hs hA hV hT hH hF hN hK \
    hJ hS hC PV PA PT PF PH pH PC PS PN PK Pm Ps ES EA EV ET EF EH EC EN EK Em Es TH TC TA TF TK TL Ts TS MA MT MC MF GM Mm cH cA \
    cV cF cT cN cK cJ cS cW cC pcal fA Mbar kL nl pl fl ";

/// Units whose letters also are a product of quantities: read as a unit only directly behind a number.
const AMBIGUOUS: &str =
    " kT fL fC mg mV fA mL mA mC nl pV nT fT dN mH mT mK mN nA nV pT pA nC pC kA kV mF fF hc dL ML MV GM MR ";

/// The bytes of each of these.
const AMBIGUOUS_LENGTH: usize = 2;

fn is_listed(list: &str, word: &str) -> bool {
    list.split_ascii_whitespace().any(|of| of == word)
}

static TABLE: LazyLock<HashMap<String, MeasurementUnit>> = LazyLock::new(|| {
    let mut table = HashMap::new();
    for (names, factor, exponents) in PREFIXED {
        for name in names.split_ascii_whitespace() {
            let dimension = UnitDimension::from_exponents(*exponents);
            table.insert(name.to_owned(), MeasurementUnit { factor: *factor, dimension });
            if name.starts_with("ohm") {
                continue;
            }
            for (prefix, times) in PREFIXES {
                let word = format!("{prefix}{name}");
                if word == "kT" || !is_listed(NO_UNITS, &word) {
                    table.insert(word, MeasurementUnit { factor: factor * times, dimension });
                }
            }
        }
    }
    // What stands here by itself wins over a prefix: `min` is no milli-inch, `ft` no femtotonne.
    for (names, factor, exponents) in WHOLE {
        for name in names.split_ascii_whitespace() {
            table.insert(
                name.to_owned(),
                MeasurementUnit { factor: *factor, dimension: UnitDimension::from_exponents(*exponents) },
            );
        }
    }
    for name in PREFIXED_WORDS.split_ascii_whitespace() {
        let Some(one) = table.get(name).copied() else { continue };
        for (prefix, times) in PREFIX_WORDS {
            table.insert(format!("{prefix}{name}"), MeasurementUnit { factor: one.factor * times, ..one });
        }
    }
    for (word, one, other) in PAIRS {
        if let (Some(one), Some(other)) = (table.get(*one).copied(), table.get(*other).copied()) {
            let dimension = one.dimension.with_factor(other.dimension, 1.0);
            table.insert((*word).to_owned(), MeasurementUnit { factor: one.factor * other.factor, dimension });
        }
    }
    table
});

/// The unit of this name or sign.
pub(crate) fn unit(word: &str) -> Option<MeasurementUnit> {
    let things = MeasurementUnit { factor: 1.0, dimension: UnitDimension::NONE };
    if word.starts_with(COUNTED) { Some(things) } else { TABLE.get(word).copied() }
}

/// The sign before a word for things that are counted, which is not shown.
pub(crate) const COUNTED: char = '\u{2060}';

/// A word for things that are counted, which is a unit without a dimension.
pub(crate) fn counted(word: &str) -> String {
    format!("{COUNTED}{word}")
}

/// Whether the letters are as likely a product of quantities as a unit.
pub(crate) fn is_ambiguous(word: &str) -> bool {
    word.len() == AMBIGUOUS_LENGTH && is_listed(AMBIGUOUS, word)
}

/// The sign of the currency of a word, if it is a sum of money's.
pub(crate) fn currency(word: &str) -> Option<&'static str> {
    let names = CURRENCIES.iter().find(|names| is_listed(names, word))?;
    names.split_ascii_whitespace().next()
}

/// Whether a character is the sign of a currency.
pub(crate) fn is_currency_sign(c: char) -> bool {
    matches!(c, '$' | '€' | '£')
}

/// Whether a word is the sign of a percentage.
pub(crate) fn is_percent(word: &str) -> bool {
    matches!(word, "%" | "percent")
}

/// Whether a word joins a share to the whole of which it is one: 5 % *of* 20, in several languages.
pub(crate) fn joins_share(word: &str) -> bool {
    matches!(word, "of" | "von" | "van" | "de" | "di" | "av" | "af")
}

/// The unit without its prefix, if the word is one of those that take a prefix and has one.
pub(crate) fn without_prefix(word: &str) -> Option<&str> {
    let first = word.chars().next().filter(|first| PREFIXES.iter().any(|(prefix, _)| prefix == first))?;
    let rest = &word[first.len_utf8()..];
    // What stands in the table by itself, such as `min`, has no prefix.
    let parts = takes_prefix(rest).then(|| unit(rest).zip(unit(word))).flatten();
    let factor = PREFIXES.iter().find(|(prefix, _)| *prefix == first).map(|(_, factor)| factor)?;
    parts
        .filter(|(base, whole)| base.dimension == whole.dimension)
        .filter(|(base, whole)| (whole.factor / (base.factor * factor) - 1.0).abs() < 1e-9)
        .map(|_| rest)
}

/// Whether a unit has a prefix, be it a sign or written out.
pub(crate) fn has_prefix(word: &str) -> bool {
    without_prefix(word).is_some()
        || PREFIX_WORDS.iter().any(|(prefix, _)| word.strip_prefix(prefix).is_some_and(|rest| unit(rest).is_some()))
}

/// Whether a sign takes a prefix that stands apart from it.
pub(crate) fn takes_prefix(word: &str) -> bool {
    PREFIXED.iter().any(|(names, ..)| names.split_ascii_whitespace().any(|name| name == word))
}

/// The two units of a word that runs them together.
pub(crate) fn pair(word: &str) -> Option<(&'static str, &'static str)> {
    PAIRS.iter().find(|(name, ..)| *name == word).map(|(_, one, other)| (*one, *other))
}

#[cfg(test)]
mod second_table;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_and_whole_names_are_told_apart() {
        for (word, factor) in [("km", 1e3), ("min", 60.0), ("μs", 1e-6), ("ft", 0.3048), ("MeV", 1e6 * EV), ("kg", 1.0)]
        {
            let found = unit(word).unwrap_or_else(|| panic!("{word}"));
            assert!((found.factor / factor - 1.0).abs() < 1e-12, "{word}: {found:?}");
        }
        for word in ["as", "dV", "PV", "xyz", ""] {
            assert_eq!(unit(word), None, "{word}");
        }
    }

    #[test]
    fn ambiguous_letters_have_the_length_by_which_others_are_told() {
        assert!(AMBIGUOUS.split_ascii_whitespace().all(|word| word.len() == AMBIGUOUS_LENGTH && is_ambiguous(word)));
        assert!(!is_ambiguous("m") && !is_ambiguous("km"));
    }

    #[test]
    fn derived_units_have_the_dimensions_of_their_definition() {
        let of = |word: &str| unit(word).unwrap_or_else(|| panic!("{word}")).dimension;
        let joule = of("N").with_factor(of("m"), 1.0);
        for word in ["J", "Nm", "eV", "kWh", "cal", "Btu"] {
            assert_eq!(of(word), joule, "{word}");
        }
        assert_eq!(of("V"), joule.with_factor(of("C"), -1.0));
        assert_eq!(of("Ω"), of("V").with_factor(of("A"), -1.0));
        assert_eq!(of("F"), of("C").with_factor(of("V"), -1.0));
        assert_eq!(of("H"), of("Wb").with_factor(of("A"), -1.0));
        assert_eq!(of("Pa"), of("N").with_factor(of("m"), -2.0));
        assert_eq!(of("S"), of("Ω").power(-1.0));
    }
}
