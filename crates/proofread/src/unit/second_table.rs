//! Every unit against a second table, typed from other places: factors from appendix B of NIST Special Publication 811 (2008) and
//! definitions from its tables 1 to 3. What that guide does not list has its definition beside it.

use super::{MeasurementUnit, PAIRS, PREFIXED, PREFIXES, WHOLE, unit};

/// Names, the factor as the guide prints it (without spaces), and the definition in base units of the SI.
type SecondUnit = (&'static str, &'static str, &'static str);

const ENTRIES: &[SecondUnit] = &[
    ("m meter meters metre metres", "1", "m"),
    ("g gram grams", "1e-3", "kg"),
    ("kilogram kilograms", "1", "kg"),
    ("kilometer kilometers kilometre kilometres", "1e3", "m"),
    ("s sec second seconds", "1", "s"),
    ("A amp amps ampere amperes", "1", "A"),
    ("K kelvin kelvins °C", "1", "K"),
    ("mol mole moles", "1", "mol"),
    // A lumen is a candela times a steradian, and a lux a lumen per square metre.
    ("cd lm", "1", "cd"),
    ("lx", "1", "m-2 cd"),
    ("Hz Bq", "1", "s-1"),
    ("N newton newtons", "1", "m kg s-2"),
    ("Pa", "1", "m-1 kg s-2"),
    ("J joule joules Joule Joules", "1", "m2 kg s-2"),
    ("W watt watts", "1", "m2 kg s-3"),
    ("C", "1", "s A"),
    ("V volt volts", "1", "m2 kg s-3 A-1"),
    ("F", "1", "m-2 kg-1 s4 A2"),
    ("Ω ohm ohms", "1", "m2 kg s-3 A-2"),
    ("S", "1", "m-2 kg-1 s3 A2"),
    ("Wb", "1", "m2 kg s-2 A-1"),
    ("T", "1", "kg s-2 A-1"),
    ("H", "1", "m2 kg s-2 A-2"),
    ("Gy Sv", "1", "m2 s-2"),
    // Exact in the SI of 2019.
    ("eV", "1.602176634e-19", "m2 kg s-2"),
    ("L l liter liters litre litres ℓ", "1e-3", "m3"),
    ("mℓ cc", "1e-6", "m3"),
    ("rem", "1e-2", "m2 s-2"),
    ("Ci", "3.7e10", "s-1"),
    ("G Gs", "1e-4", "kg s-2 A-1"),
    ("bar", "1e5", "m-1 kg s-2"),
    // The calorie at 15 °C.
    ("cal", "4.1858", "m2 kg s-2"),
    ("Cal kcal", "4.1858e3", "m2 kg s-2"),
    ("pc", "3.085678e16", "m"),
    ("Å angstrom angstroms", "1e-10", "m"),
    ("fm", "1e-15", "m"),
    ("b", "1e-28", "m2"),
    // The value of CODATA 2018, which is newer than the guide.
    ("Da u amu", "1.66053907e-27", "kg"),
    ("t ton tonne tonnes", "1e3", "kg"),
    ("min minute minutes", "6e1", "s"),
    ("h hr hrs hour hours", "3.6e3", "s"),
    ("d day days", "8.64e4", "s"),
    // Seven days, and the 365.25 days of the International Astronomical Union.
    ("week weeks wk", "6.048e5", "s"),
    ("y yr year years", "3.15576e7", "s"),
    ("kyr", "3.15576e10", "s"),
    ("Myr", "3.15576e13", "s"),
    ("Gyr", "3.15576e16", "s"),
    ("rad sr turns Np dB wt", "1", ""),
    ("$ USD dollar dollars € EUR euro euros Euro £ GBP CHF", "1", ""),
    ("rev revs revolution revolutions", "6.283185", ""),
    ("rpm", "1.047198e-1", "s-1"),
    ("° degree degrees", "1.745329e-2", ""),
    ("arcsec", "4.848137e-6", ""),
    ("% percent cents", "1e-2", ""),
    ("ppm", "1e-6", ""),
    ("atm", "1.01325e5", "m-1 kg s-2"),
    ("Torr torr mmHg", "1.333224e2", "m-1 kg s-2"),
    ("cmHg", "1.333224e3", "m-1 kg s-2"),
    ("inHg", "3.386389e3", "m-1 kg s-2"),
    ("cmwater", "9.80665e1", "m-1 kg s-2"),
    ("mmwater", "9.80665", "m-1 kg s-2"),
    ("psi", "6.894757e3", "m-1 kg s-2"),
    ("ksi", "6.894757e6", "m-1 kg s-2"),
    ("lb lbs lbf", "4.448222", "m kg s-2"),
    ("kip kips", "4.448222e3", "m kg s-2"),
    ("kgf kp", "9.80665", "m kg s-2"),
    ("lbm", "4.535924e-1", "kg"),
    ("slug slugs", "1.459390e1", "kg"),
    ("oz", "2.834952e-2", "kg"),
    ("dyn", "1e-5", "m kg s-2"),
    ("erg", "1e-7", "m2 kg s-2"),
    ("ft feet foot", "3.048e-1", "m"),
    ("in inch inches", "2.54e-2", "m"),
    ("mi mile miles", "1.609344e3", "m"),
    ("nmi", "1.852e3", "m"),
    ("yd", "9.144e-1", "m"),
    ("ly", "9.46073e15", "m"),
    ("Mly", "9.46073e21", "m"),
    ("AU au", "1.495979e11", "m"),
    // 43 560 square feet, of the international foot.
    ("acre", "4.046856e3", "m2"),
    ("gal gallon gallons", "3.785412e-3", "m3"),
    ("mph", "4.4704e-1", "m s-1"),
    ("knot knots", "5.144444e-1", "m s-1"),
    // The electric horsepower.
    ("hp", "7.46e2", "m2 kg s-3"),
    // The International Table's.
    ("Btu BTU", "1.055056e3", "m2 kg s-2"),
    ("kWh", "3.6e6", "m2 kg s-2"),
    ("MWh", "3.6e9", "m2 kg s-2"),
    ("GWh", "3.6e12", "m2 kg s-2"),
    ("TWh", "3.6e15", "m2 kg s-2"),
    ("mAh", "3.6", "s A"),
    ("kVA", "1e3", "m2 kg s-3"),
    // A mole in a litre.
    ("M", "1e3", "m-3 mol"),
    ("mM", "1", "m-3 mol"),
    ("μM", "1e-3", "m-3 mol"),
    // Resolution B3 of the International Astronomical Union (2015); the mass is its GM over the constant of gravitation.
    ("M⊙", "1.988e30", "kg"),
    ("R⊙", "6.957e8", "m"),
    ("L⊙", "3.828e26", "m2 kg s-3"),
    ("Mev", "1.602176634e-13", "m2 kg s-2"),
    ("e", "1.602176634e-19", "s A"),
    ("D diopter diopters", "1", "m-1"),
    ("°F", "5.555556e-1", "K"),
    ("Nm", "1", "m2 kg s-2"),
    ("kNm", "1e3", "m2 kg s-2"),
    ("Js", "1", "m2 kg s-1"),
    ("eVs", "1.602176634e-19", "m2 kg s-1"),
    ("kgm", "1", "m kg"),
    ("Ns", "1", "m kg s-1"),
    ("Vm", "1", "m3 kg s-3 A-1"),
    ("Ah", "3.6e3", "s A"),
    ("Wh", "3.6e3", "m2 kg s-2"),
    ("Tm", "1", "m kg s-2 A-1"),
    ("Wm", "1", "m3 kg s-3"),
    ("Vs", "1", "m2 kg s-2 A-1"),
    ("Ws", "1", "m2 kg s-2"),
    ("VA", "1", "m2 kg s-3"),
];

/// Table 5 of the guide, of the prefixes that the program reads: powers of ten.
const POWERS: &[(char, i32)] = &[
    ('E', 18),
    ('P', 15),
    ('T', 12),
    ('G', 9),
    ('M', 6),
    ('k', 3),
    ('h', 2),
    ('d', -1),
    ('c', -2),
    ('m', -3),
    ('μ', -6),
    ('n', -9),
    ('p', -12),
    ('f', -15),
    ('a', -18),
];

/// The sixtieths of exponents of a definition such as `m2 kg s-2`.
fn exponents(definition: &str) -> [i32; 7] {
    let mut exponents = [0; 7];
    for part in definition.split_whitespace() {
        let end = part.find(|of: char| of == '-' || of.is_ascii_digit()).unwrap_or(part.len());
        let base = ["m", "kg", "s", "A", "K", "mol", "cd"].iter().position(|base| *base == &part[..end]);
        let power: i32 = if end == part.len() { 1 } else { part[end..].parse().expect("a power") };
        exponents[base.expect("a base unit")] += 60 * power;
    }
    exponents
}

/// The digits of a number, without zeros at its ends, and one in the place of the last of them.
fn digits_and_place(number: &str) -> (usize, f64) {
    let (mantissa, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let decimals = mantissa.split_once('.').map_or("", |(_, decimals)| decimals).len();
    let exponent: i32 = exponent.parse().expect("an exponent");
    let digits = mantissa.replace('.', "");
    let zeros = digits.len() - digits.trim_end_matches('0').len();
    let place = exponent - decimals as i32 + zeros as i32;
    (digits.trim_matches('0').len(), format!("1e{place}").parse().expect("a number"))
}

/// What is wrong with a unit for which the guide has this factor and definition.
fn fault(name: &str, factor: &str, definition: &str, found: Option<MeasurementUnit>) -> Option<String> {
    let Some(found) = found else { return Some(format!("{name} is no unit")) };
    let own = format!("{:e}", found.factor);
    let (expected, [guide, ours]) = (factor.parse::<f64>().expect("a number"), [factor, &own].map(digits_and_place));
    // Of the two, the one with fewer digits is the other one rounded; one of a few digits where there are more says too little.
    let apart = (found.factor - expected).abs();
    if apart > 0.5 * guide.1.max(ours.1) * (1.0 + 1e-9) || ours.0 < guide.0.min(4) {
        return Some(format!("{name} is {own}, and {factor} in the guide"));
    }
    (found.dimension.0 != exponents(definition)).then(|| format!("{name} is no {definition}"))
}

/// Things that are counted, and have no unit.
fn is_counted(name: &str) -> bool {
    const COUNTED: &str = "photons photon atoms atom molecules electrons electron particles decays fissions proton protons ion nuclei \
        people loops passes lines events ions slits cycles cycle fringes reactions nucleons layers pulses times beats deuterons flashes \
        orbits windings bulbs cars halflives";
    COUNTED.split_whitespace().any(|of| of == name)
}

#[test]
fn every_unit_is_as_the_guide_has_it() {
    let listed = |name: &str| ENTRIES.iter().find(|(names, ..)| names.split_whitespace().any(|of| of == name));
    let names = PREFIXED.iter().chain(WHOLE).flat_map(|(names, ..)| names.split_whitespace());
    let mut wrong = Vec::new();
    for name in names.chain(PAIRS.iter().map(|(name, ..)| *name)) {
        match listed(name) {
            Some((_, factor, definition)) => wrong.extend(fault(name, factor, definition, unit(name))),
            None if is_counted(name) => wrong.extend(fault(name, "1", "", unit(name))),
            None => wrong.push(format!("{name} is in no second table")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    for name in ENTRIES.iter().flat_map(|(names, ..)| names.split_whitespace()) {
        assert!(unit(name).is_some(), "{name} is no unit any more");
    }
}

#[test]
fn every_prefix_is_its_power_of_ten() {
    assert_eq!(POWERS.len(), PREFIXES.len());
    let by_itself = |word: &str| {
        WHOLE.iter().any(|(names, ..)| names.split_whitespace().any(|name| name == word))
            || PAIRS.iter().any(|(name, ..)| *name == word)
    };
    let mut tried = 0;
    for (prefix, power) in POWERS {
        for name in PREFIXED.iter().flat_map(|(names, ..)| names.split_whitespace()) {
            let word = format!("{prefix}{name}");
            let (Some(base), Some(found)) = (unit(name), unit(&word).filter(|_| !by_itself(&word))) else { continue };
            let ten: f64 = format!("1e{power}").parse().expect("a number");
            assert!((found.factor / (base.factor * ten) - 1.0).abs() < 1e-14, "{word}: {found:?}");
            assert_eq!(found.dimension, base.dimension, "{word}");
            tried += 1;
        }
    }
    assert!(tried > 250, "{tried}");
}

#[test]
fn another_digit_or_another_dimension_is_noticed() {
    let changed = |name: &str, factor: f64| {
        let found = unit(name).map(|of| MeasurementUnit { factor: of.factor * factor, ..of });
        let (_, factor, definition) =
            ENTRIES.iter().find(|(names, ..)| names.split(' ').any(|of| of == name)).expect("listed");
        fault(name, factor, definition, found)
    };
    assert!(changed("yd", 0.9154 / 0.9144).is_some() && changed("oz", 0.028_349_9 / 0.028_349_5).is_some());
    assert!(changed("hp", 747.0 / 746.0).is_some() && changed("yd", 0.9 / 0.9144).is_some());
    assert!(fault("yd", "9.144e-1", "m2", unit("yd")).is_some() && fault("xyz", "1", "m", unit("xyz")).is_some());
    assert_eq!((changed("yd", 1.0), changed("lbm", 1.0)), (None, None));
}
