//! What an equals sign between two quantities may mean besides that they are equal: one stands for the other, or the factor
//! between their units is rounded.

use crate::decimal::parse_decimal;
use crate::evaluate::printed::{Mode, PrintedNumber};
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::{AngleUnit, SideValue};
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::money::has_money;
use crate::judge::substitution::without_space;
use crate::token::{Token, TokenKind, any, trim_space};
use crate::unit::{UnitDimension, is_percent, unit, without_prefix};
use std::f64::consts::PI;

/// Units whose size in others texts round or define differently, and by how much relative to it.
const LOOSE: [(&[&str], f64); 9] = [
    (&["hp"], 0.015),
    (&["cal", "kcal", "Cal"], 0.0012),
    (&["Btu", "BTU"], 0.0015),
    (&["y", "yr", "year", "years"], 0.003),
    (&["ly", "Mly", "pc", "kpc", "Mpc", "AU", "au"], 0.003),
    (&["mi", "mile", "miles", "mph"], 0.006),
    (&["lb", "lbs", "lbf", "lbm"], 0.003),
    (&["knot", "knots", "nmi"], 0.002),
    (&["M⊙", "L⊙", "R⊙"], 0.01),
];

/// Units of a logarithm, which are neither added nor converted as others are.
const DECIBELS: [&str; 3] = ["dB", "dBm", "dBA"];

fn has_word(tokens: &[Token], words: &[&str]) -> bool {
    any(tokens, &|kind| matches!(kind, TokenKind::Word(word) if words.contains(&word.as_str())))
}

/// How far two sides may be apart, relative to their size, since the size of a unit of only one of them is rounded.
pub(crate) fn unit_looseness(left: &[Token], right: &[Token]) -> f64 {
    let has_words = |side: &[Token]| any(side, &|kind| matches!(kind, TokenKind::Word(_)));
    if !has_words(left) && !has_words(right) {
        return 0.0;
    }
    LOOSE.iter().filter(|(words, _)| has_word(left, words) != has_word(right, words)).map(|(_, by)| by).sum()
}

/// Whether one side counts electrons and the other one is their charge, whose sign the count leaves out.
pub(crate) fn counts_electrons(sides: [&[Token]; 2], left: &SideValue, right: &SideValue) -> bool {
    let [of_left, of_right] = sides.map(|side| has_word(side, &["e"]));
    of_left != of_right && left.has_unit && left.dimension == right.dimension && left.clone().negate().meets(right, 0.0)
}

/// Whether two sides agree if the bare numbers of one of them are degrees, too.
pub(crate) fn lacks_degrees(left: &SideValue, right: &SideValue) -> bool {
    let bare = |of: &SideValue| of.angle.is_none() && !of.has_unit;
    let in_degrees = |of: &SideValue| of.angle == Some(AngleUnit::Degrees) && of.dimension.is_none();
    let scaled = |of: &SideValue| of.scaled(180.0 / PI);
    (bare(left) && in_degrees(right) && left.meets(&scaled(right), 0.0))
        || (bare(right) && in_degrees(left) && right.meets(&scaled(left), 0.0))
}

/// Whether two sides, of which only one is in electronvolts, agree with the charge of an electron rounded to three digits.
pub(crate) fn agree_with_rounded_charge(sides: [&[Token]; 2], left: &SideValue, right: &SideValue) -> bool {
    const VOLTS: [&str; 5] = ["eV", "meV", "keV", "MeV", "GeV"];
    let Some(volt) = unit("eV").filter(|volt| volt.dimension == left.dimension) else { return false };
    let rounded = 1.60e-19 / volt.factor;
    match sides.map(|side| has_word(side, &VOLTS)) {
        [true, false] => left.scaled(rounded).meets(right, 0.0),
        [false, true] => left.meets(&right.scaled(rounded), 0.0),
        _ => false,
    }
}

/// Whether a side turns an angle into degrees by a factor 180/π that lacks its degree sign.
pub(crate) fn turns_into_degrees(side: &[Token]) -> bool {
    let is_straight = |of: &[Token]| matches!(of, [one] if one.number() == Some("180"));
    let is_pi = |of: &[Token]| matches!(of, [one] if one.kind == TokenKind::Name("π".to_owned()));
    let stacked =
        any(side, &|kind| matches!(kind, TokenKind::Fraction(above, below) if is_straight(above) && is_pi(below)));
    stacked || side.windows(3).any(|of| is_straight(&of[..1]) && of[1].is_sign('/') && is_pi(&of[2..]))
}

/// Whether one side is a vector along an axis, and the other one its component without the direction.
pub(crate) fn lacks_direction(left: &SideValue, right: &SideValue) -> bool {
    let along = |of: &SideValue| match of.parts.0 {
        [None, Some(x), None, None] | [None, None, Some(x), None] | [None, None, None, Some(x)] => Some(x),
        _ => None,
    };
    let of = |vector: &SideValue, scalar: &SideValue| match (along(vector), scalar.parts.0) {
        (Some(x), [Some(y), None, None, None]) => x.meets(y, 0.0),
        _ => false,
    };
    of(left, right) || of(right, left)
}

/// Whether two sides agree once the unit that one of them leaves to be understood is put in: the electronvolt beside meV, the
/// centimetre beside μm, kilohms under volts beside μA, the revolution beside a division by 2π, the atomic mass unit.
pub(crate) fn agree_with_omitted_unit(sides: [&[Token]; 2], left: &SideValue, right: &SideValue) -> bool {
    let [of_left, of_right] = sides;
    leaves_unit_out(of_left, left, of_right, right) || leaves_unit_out(of_right, right, of_left, left)
}

/// Whether two sides agree once a mass on one of them counts as its weight, as in a pressure of kilograms per square centimetre.
pub(crate) fn agree_as_weight(left: &SideValue, right: &SideValue) -> bool {
    const STANDARD: [f64; 3] = [9.806_65, 9.81, 9.8];
    let Some((newton, kilogram)) = unit("N").zip(unit("kg")) else { return false };
    let weighs = |mass: &SideValue, force: &SideValue| {
        mass.has_unit
            && force.has_unit
            && mass.dimension.with_factor(newton.dimension, 1.0).with_factor(kilogram.dimension, -1.0)
                == force.dimension
            && STANDARD.iter().any(|g| mass.scaled(*g).meets(force, 0.0))
    };
    weighs(left, right) || weighs(right, left)
}

fn leaves_unit_out(bare_side: &[Token], bare: &SideValue, side: &[Token], other: &SideValue) -> bool {
    if bare.has_unit || bare.angle.is_some() || !bare.dimension.is_none() {
        return false;
    }
    // An interval with zero in it is met by any factor.
    if bare.number().is_ok_and(|of| of.low <= 0.0 && of.high >= 0.0) {
        return false;
    }
    let with = |factor: f64| bare.scaled(factor).meets(other, 0.0);
    if other.has_unit {
        if !other.is_literal() {
            return false;
        }
        let is_unit = |token: &Token| token.word().is_some_and(|word| unit(word).is_some());
        let Some(at) = side.iter().position(is_unit) else { return false };
        let word = side[at].word().unwrap_or_default();
        let base = without_prefix(word).and_then(unit);
        if side.iter().filter(|token| is_unit(token)).count() > 1 {
            // A kilowatt-hour beside a product of watts and hours.
            let raised = side.get(at + 1).is_some_and(|next| matches!(next.kind, TokenKind::Power(_)));
            let ratio = base.zip(unit(word)).map(|(base, whole)| base.factor / whole.factor);
            return !raised && ratio.is_some_and(|ratio| with(other.factor * ratio));
        }
        let base = base.filter(|base| base.dimension == other.dimension);
        // Volts over kilohms give milliamperes, and the prefixes are understood with the units. Whether numbers without such prefixes
        // agree is for those who compare them.
        let is_printed_unit = |factor: f64| (factor / other.factor - 1.0).abs() < 1e-9;
        let by_prefixes = |base: f64| {
            let mut factors = (-4..=4).map(|power| base * libm::pow(1e3, f64::from(power)));
            !bare.is_literal() && factors.any(|factor| !is_printed_unit(factor) && with(factor))
        };
        let length = unit("cm").filter(|cm| cm.dimension == other.dimension && word != "cm");
        return base.is_some_and(|base| {
            with(base.factor) || length.is_some_and(|cm| with(cm.factor)) || by_prefixes(base.factor)
        });
    }
    if other.angle == Some(AngleUnit::Radians) {
        let divides = any(bare_side, &|kind| *kind == TokenKind::Name("π".to_owned()));
        return divides && !bare.is_literal() && with(2.0 * PI);
    }
    // A mass in kilograms over one in atomic mass units.
    let is_quotient = any(bare_side, &|kind| matches!(kind, TokenKind::Fraction(..) | TokenKind::Operator('/')));
    other.angle.is_none() && is_quotient && unit("u").is_some_and(|dalton| with(1.0 / dalton.factor))
}

/// Whether a side is so many times a power of two by its letter, as in computing, where 64K are 65 536, and the other one is that number.
fn is_binary_multiple(side: &[Token], other: &SideValue) -> bool {
    const LETTERS: [&str; 5] = ["K", "M", "G", "T", "P"];
    let mut tokens = side.iter().filter(|token| !token.is_space());
    let (Some(number), Some(mut letter)) = (tokens.next(), tokens.next()) else { return false };
    // 2⁷ G
    let mut exponent = Some(1.0);
    if let TokenKind::Power(power) = &letter.kind {
        exponent = match power.as_slice() {
            [digits] => digits.number().and_then(parse_decimal),
            _ => None,
        };
        let Some(next) = tokens.next() else { return false };
        letter = next;
    }
    if tokens.next().is_some() {
        return false;
    }
    let letter = match &letter.kind {
        TokenKind::Word(letter) | TokenKind::Name(letter) => LETTERS.iter().position(|known| known == letter),
        _ => None,
    };
    let number = number.number().and_then(|digits| parse_decimal(&digits.replace(',', "")));
    let number = number.zip(exponent).map(|(base, exponent)| libm::pow(base, exponent));
    let (Some(letter), Some(number), Ok(value)) = (letter, number, other.number()) else { return false };
    let multiple = number * libm::exp2(10.0 * (letter as f64 + 1.0));
    !other.has_unit && (value.point - multiple).abs() < 1e-9 * multiple
}

/// Whether one side is said to stand for the other, as on a scale drawing, of a mole or by a law of physics.
pub(crate) fn may_stand_for_each_other(left: &[Token], right: &[Token], values: &(SideValue, SideValue)) -> bool {
    let (one, other) = values;
    let both_printed = one.is_literal() && other.is_literal();
    let decibels = [has_word(left, &DECIBELS), has_word(right, &DECIBELS)];
    let are_added =
        |tokens: &[Token]| has_word(tokens, &DECIBELS) && any(tokens, &|kind| *kind == TokenKind::Operator('+'));
    if decibels == [true, true] && (are_added(left) || are_added(right)) {
        return true;
    }
    if has_word(left, &["Np"]) != has_word(right, &["Np"]) && (decibels[0] || decibels[1]) {
        return true;
    }
    // A ratio and its size in decibels.
    let in_decibels = |ratio: &SideValue, level: &SideValue, side: &[Token]| match (ratio.number(), level.number()) {
        (Ok(of), Ok(level)) if of.point > 0.0 && !ratio.has_unit => {
            let log = libm::log10(of.point);
            let half = side
                .iter()
                .find_map(Token::number)
                .and_then(PrintedNumber::read)
                .map(|of| of.open(Mode::Result, false).0);
            let near = half.unwrap_or_default().max(0.02 * level.point.abs());
            [10.0, 20.0].iter().any(|factor| (factor * log - level.point).abs() <= near)
        }
        _ => false,
    };
    if (decibels == [false, true] && in_decibels(one, other, right))
        || (decibels == [true, false] && in_decibels(other, one, left))
    {
        return true;
    }
    // Temperatures without their degree sign.
    let scales = |tokens: &[Token]| has_word(tokens, &["C", "F"]);
    let kelvins = |tokens: &[Token]| has_word(tokens, &["C", "F", "K", "°C", "°F"]);
    if both_printed && ((scales(left) && kelvins(right)) || (scales(right) && kelvins(left))) && left != right {
        return true;
    }
    // Degrees of temperature in a product: 4.2 J/K × 230° = 966 J.
    let kelvin = unit("K").map(|kelvin| kelvin.dimension).unwrap_or_default();
    let differs_by_kelvin = [1.0, -1.0].into_iter().any(|by| one.dimension.with_factor(kelvin, by) == other.dimension);
    if !both_printed && differs_by_kelvin && (has_word(left, &["°"]) || has_word(right, &["°"])) {
        return true;
    }
    // A share and what it amounts to.
    let shares = |tokens: &[Token]| tokens.iter().filter_map(Token::word).any(is_percent);
    if both_printed && (shares(left) && !other.dimension.is_none() || shares(right) && !one.dimension.is_none()) {
        return true;
    }
    if is_binary_multiple(left, other) || is_binary_multiple(right, one) {
        return true;
    }
    // A price.
    if has_money(left) != has_money(right) && one.has_unit && other.has_unit && one.dimension != other.dimension {
        return true;
    }
    if !both_printed || one.parts.is_vector() || other.parts.is_vector() {
        return false;
    }
    let counted = |tokens: &[Token]| has_word(tokens, &["mol", "mole", "moles"]);
    let is_one = |value: &SideValue| !value.has_unit && value.number().is_ok_and(|of| of.point == 1.0);
    if one.has_unit && other.has_unit {
        let is_unity = |tokens: &[Token]| tokens.iter().find_map(Token::number) == Some("1");
        let unity = is_unity(left) || is_unity(right);
        return one.dimension != other.dimension
            && (unity
                || counted(left)
                || counted(right)
                || (is_convertible(one.dimension) && is_convertible(other.dimension)));
    }
    let stands_for_one = (is_one(one) && other.has_unit) || (is_one(other) && one.has_unit);
    decibels[0] != decibels[1] || counted(left) != counted(right) || stands_for_one
}

/// Whether the right side is the size of a square, such as 5 × 5, and not a product.
pub(crate) fn is_size(left: f64, right: &[Token]) -> bool {
    match without_space(right).as_slice() {
        [one, times, other] => {
            let number = one.number().and_then(parse_decimal);
            times.is_sign('×') && one.number() == other.number() && number == Some(left)
        }
        _ => false,
    }
}

/// Whether one side is a power of ten alone, and the other one of the same order of magnitude.
pub(crate) fn is_order_of_magnitude(sides: [&[Token]; 2], points: &[SideValue; 2]) -> bool {
    let is_power = |side: &[Token]| match trim_space(side) {
        [ten, Token { kind: TokenKind::Power(_), .. }] => ten.number() == Some("10"),
        _ => false,
    };
    let near = match [points[0].number(), points[1].number()] {
        [Ok(one), Ok(other)] if one.point * other.point > 0.0 => libm::log10(one.point / other.point).abs() < 0.7,
        _ => false,
    };
    near && sides.into_iter().any(is_power)
}

/// Whether one quantity may stand for another one on a drawing: they are of different kinds, it is a length of one of its unit, or they
/// are of sizes that no misprint of a conversion explains.
pub(crate) fn may_be_to_scale(left: &SideValue, right: &SideValue) -> bool {
    let size = |of: &SideValue| of.number().map_or(0.0, |number| number.point.abs());
    let (one, other) = (size(left), size(right));
    let is_length = unit("m").is_some_and(|metre| left.dimension == metre.dimension);
    let is_unit = is_length && left.factor > 0.0 && (one / left.factor - 1.0).abs() < 1e-9;
    left.dimension != right.dimension || is_unit || one > 10.0 * other || other > 10.0 * one
}

/// Whether a law or a constant of nature makes such a quantity one of another kind: mass, energy, energy of a mole, weight,
/// temperature, amount, number, wave number.
fn is_convertible(dimension: UnitDimension) -> bool {
    let of = |word: &str| unit(word).map(|unit| unit.dimension);
    let known = ["kg", "J", "K", "N", "mol", "rad"].map(of);
    let of_a_mole = of("J").zip(of("mol")).map(|(energy, amount)| energy.with_factor(amount, -1.0));
    known.contains(&Some(dimension))
        || of_a_mole == Some(dimension)
        || of("m").map(|length| length.power(-1.0)) == Some(dimension)
}

/// Angles of an inverse function agree up to half turns, and the degree sign may be missing.
pub(super) fn angles(
    [left, right]: &[SideValue; 2],
    points: &[SideValue; 2],
    reading: ReadingChoices,
) -> Option<ChainVerdict> {
    if reading.contains(ReadingChoices::DEGREES) {
        for (angle, bare, point) in [(left, right, &points[1]), (right, left, &points[0])] {
            let in_degrees = angle.scaled(180.0 / PI);
            if point.angle.is_none() && !point.has_unit && in_degrees.meets(bare, 0.0) {
                return Some(ChainVerdict::Units);
            }
        }
    }
    // Below or above, left or right is said in words.
    if left.clone().negate().meets(right, 0.0) {
        return Some(ChainVerdict::Doubtful);
    }
    // The other angle with the same sine or cosine.
    let turned = left.clone().negate();
    let other = |by: f64| SideValue { parts: turned.parts.map(|part| part.shifted(by)), ..turned.clone() };
    if other(PI).meets(right, 0.0) || other(2.0 * PI).meets(right, 0.0) {
        return Some(ChainVerdict::Doubtful);
    }
    let moved = |by: f64| SideValue { parts: left.parts.map(|part| part.shifted(by)), ..left.clone() };
    [PI, -PI, 2.0 * PI, -2.0 * PI].iter().any(|by| moved(*by).meets(right, 0.0)).then_some(ChainVerdict::Rounded)
}

/// Whether the left side may be the end of a vector that began in another formula: it lacks components that the right side
/// has, and those that it has agree.
pub(super) fn is_continued(left: &SideValue, right: &SideValue) -> bool {
    let (mine, its) = (&left.parts.0[1..], &right.parts.0[1..]);
    let lacks = mine.iter().zip(its).any(|(a, b)| a.is_none() && b.is_some());
    let fits = mine.iter().zip(its).all(|(a, b)| match (a, b) {
        (Some(a), Some(b)) => a.meets(*b, 0.0),
        (Some(_), None) => false,
        _ => true,
    });
    left.parts.is_vector() && lacks && fits
}
