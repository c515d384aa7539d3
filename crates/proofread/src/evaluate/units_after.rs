//! Units behind a number or a bracket: products and quotients of signs with exponents.

use crate::evaluate::cursor::Cursor;
use crate::evaluate::exponent::{is_power_of_e, plain_exponent};
use crate::evaluate::expression::Evaluator;
use crate::evaluate::interval::Interval;
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::{AngleUnit, Evaluated, Literal, Obstacle, SideValue};
use crate::token::{Token, TokenKind};
use crate::unit::{MeasurementUnit, UnitDimension, is_ambiguous, is_percent, unit};
use std::f64::consts::PI;

/// What the units at a place are together.
pub(crate) struct UnitProduct {
    /// How many base units of the SI they are, in units of their dimension.
    pub factor: f64,
    pub dimension: UnitDimension,
    pub angle: Option<AngleUnit>,
    /// The scale of a temperature, if it stands alone.
    pub scale: Option<char>,
}

fn light_speed() -> Option<MeasurementUnit> {
    unit("m").zip(unit("s")).map(|(metre, second)| MeasurementUnit {
        factor: 299_792_458.0,
        dimension: metre.dimension.with_factor(second.dimension, -1.0),
    })
}

fn unit_of(token: Option<&Token>) -> Option<MeasurementUnit> {
    token.and_then(Token::word).and_then(unit)
}

/// Whether it may be the speed of light behind a stroke, as in MeV/c².
fn is_light(token: Option<&Token>) -> bool {
    token.is_some_and(|token| matches!(&token.kind, TokenKind::Name(name) | TokenKind::Word(name) if name == "c"))
}

impl Evaluator<'_> {
    /// The units from here on.
    pub(crate) fn units(&mut self, cursor: &mut Cursor<'_>) -> Evaluated<UnitProduct> {
        let mut all = UnitProduct { factor: 1.0, dimension: UnitDimension::NONE, angle: None, scale: None };
        let (mut below, mut count) = (false, 0);
        loop {
            let (token, at) = cursor.token_from(cursor.at);
            let letter = token.and_then(|token| match &token.kind {
                TokenKind::Name(name) if below && matches!(name.as_str(), "m" | "s" | "g") => unit(name),
                _ => None,
            });
            let light = || (count > 0 && is_light(token)).then(light_speed).flatten();
            let Some(one) = unit_of(token).or(letter).or_else(light) else { break };
            let word = token.and_then(Token::word).unwrap_or_default();
            let one = self.resolve_unit(word, one, &mut all);
            cursor.at = at + 1;
            let mut exponent = 1.0;
            if let Some(Token { kind: TokenKind::Power(power), .. }) = cursor.current() {
                exponent = plain_exponent(power)?;
                if is_percent(word) {
                    return Err(Obstacle::Unclear("a power of a percentage"));
                }
                cursor.at += 1;
            }
            if below {
                exponent = -exponent;
            }
            all.factor *= libm::pow(one.factor, exponent);
            all.dimension = all.dimension.with_factor(one.dimension, exponent);
            count += 1;
            if self.is_chosen(ReadingChoices::ONE_BELOW) {
                below = false;
            }
            if !self.take_connection(cursor, &mut below, &mut all)? {
                break;
            }
        }
        if count != 1 {
            all.scale = None;
        }
        if count > 1 && all.angle == Some(AngleUnit::Degrees) && self.is_chosen(ReadingChoices::NUMBERS) {
            all.factor = 1.0;
        }
        if !all.factor.is_finite() || all.factor == 0.0 {
            return Err(Obstacle::Unclear("a unit beyond all bounds"));
        }
        Ok(all)
    }

    /// A unit as the reading means it.
    fn resolve_unit(&mut self, word: &str, mut one: MeasurementUnit, all: &mut UnitProduct) -> MeasurementUnit {
        let turns = matches!(word, "rev" | "revs" | "revolution" | "revolutions" | "rpm");
        if turns || matches!(word, "cycle" | "cycles") {
            self.noticed.insert(ReadingChoices::TURNS);
        }
        match word {
            "°" => all.angle = Some(AngleUnit::Degrees),
            "rad" => {
                self.noticed.insert(ReadingChoices::DOSE);
                if self.is_chosen(ReadingChoices::DOSE) {
                    let dose = unit("Gy").map(|gray| gray.dimension).unwrap_or_default();
                    one = MeasurementUnit { factor: 0.01, dimension: dose };
                }
                all.angle = all.angle.or(Some(AngleUnit::Radians));
            }
            "electron" | "electrons" | "proton" | "protons" | "ion" | "ions" => {
                self.noticed.insert(ReadingChoices::CHARGES);
                if self.is_chosen(ReadingChoices::CHARGES)
                    && let Some(charge) = unit("e")
                {
                    one = charge;
                }
            }
            "Hz" | "kHz" => {
                self.noticed.insert(ReadingChoices::CYCLES);
                if self.is_chosen(ReadingChoices::CYCLES) {
                    one.factor *= 2.0 * PI;
                }
            }
            "lb" | "lbs" => {
                self.noticed.insert(ReadingChoices::POUNDS);
                if self.is_chosen(ReadingChoices::POUNDS)
                    && let Some(mass) = unit("lbm")
                {
                    one = mass;
                }
            }
            "°C" | "°F" => {
                self.noticed.insert(ReadingChoices::POINTS);
                all.scale = word.chars().last();
            }
            _ if turns => {
                all.angle = all.angle.or(Some(AngleUnit::Radians));
                if self.is_chosen(ReadingChoices::TURNS) {
                    one.factor /= 2.0 * PI;
                }
            }
            _ => {}
        }
        if self.is_chosen(ReadingChoices::NUMBERS) && word != "°" {
            let percent = is_percent(word);
            if percent {
                self.noticed.insert(ReadingChoices::SHARE);
            }
            if !(percent && self.is_chosen(ReadingChoices::SHARE)) {
                one.factor = 1.0;
            }
        }
        one
    }

    /// Takes what connects two units; whether another one follows.
    fn take_connection(&mut self, cursor: &mut Cursor<'_>, below: &mut bool, all: &mut UnitProduct) -> Evaluated<bool> {
        let (sign, at) = cursor.token_from(cursor.at);
        let Some(sign) = sign else { return Ok(false) };
        let (next, next_at) = cursor.token_from(at + 1);
        if sign.is_one_of("·*×") {
            if unit_of(next).is_none() {
                return Ok(false);
            }
            cursor.at = at + 1;
            if *below {
                self.noticed.insert(ReadingChoices::ONE_BELOW);
            }
            return Ok(true);
        }
        if sign.is_sign('-') && at == cursor.at {
            // Units may be joined by hyphens, with a space behind one: L-bar- mol.
            let follows = unit_of(next).is_some();
            cursor.at = if follows { next_at } else { cursor.at };
            return Ok(follows);
        }
        if sign.is_sign('/') {
            if unit_of(next).is_some() || is_light(next) {
                cursor.at = at + 1;
                *below = true;
                self.noticed.insert(ReadingChoices::ONE_BELOW);
                return Ok(true);
            }
            if next.is_some_and(|next| next.is_sign('(')) && unit_of(cursor.token_from(next_at + 1).0).is_some() {
                cursor.at = next_at;
                let inner = cursor.take_group()?;
                let mut inside = Cursor::new(inner);
                let divisor = self.units(&mut inside)?;
                if inside.peek().is_some() {
                    return Err(Obstacle::Unclear("brackets among units"));
                }
                all.factor /= divisor.factor;
                all.dimension = all.dimension.with_factor(divisor.dimension, -1.0);
            }
            return Ok(false);
        }
        Ok(unit_of(Some(sign)).is_some())
    }

    /// A value with the units behind it, if there are any. `number` says that it is a printed number.
    pub(crate) fn with_unit(
        &mut self,
        value: SideValue,
        cursor: &mut Cursor<'_>,
        number: bool,
    ) -> Evaluated<SideValue> {
        if value.has_unit {
            return Ok(value);
        }
        let (token, at) = cursor.token_from(cursor.at);
        let Some(word) = token.and_then(Token::word) else { return Ok(value) };
        let before = cursor.at.checked_sub(1).and_then(|at| cursor.tokens.get(at));
        if !number && !before.is_some_and(|before| before.is_sign(')')) {
            let behind_fraction = before.is_some_and(|before| matches!(before.kind, TokenKind::Fraction(..)));
            if is_ambiguous(word) || (matches!(word, "°C" | "°F") && behind_fraction) {
                return Err(Obstacle::Letter(word.to_owned()));
            }
        }
        // An upright e with such an exponent is the base of the logarithms, not a charge.
        let raised = cursor.tokens.get(at + 1).is_some_and(|next| match &next.kind {
            TokenKind::Power(power) => plain_exponent(power).map_or(true, is_power_of_e),
            _ => false,
        });
        if unit(word).is_none() || (word == "e" && raised) {
            return Ok(value);
        }
        cursor.at = at;
        let units = self.units(cursor)?;
        // So are the ends of a spread: (20 ± 1) °C.
        let is_point = number || value.is_tuple;
        let mut with = match units.scale.filter(|_| self.is_chosen(ReadingChoices::POINTS) && is_point) {
            Some('C') => SideValue { parts: value.parts.map(|part| part.shifted(273.15)), ..value },
            Some(_) => {
                let kelvin = |part: Interval| part.shifted(-32.0).scaled(5.0 / 9.0).shifted(273.15);
                SideValue { parts: value.parts.map(kelvin), factor: 5.0 / 9.0, ..value }
            }
            None => value.scaled(units.factor),
        };
        with.dimension = units.dimension;
        with.has_unit = !units.dimension.is_none() || units.angle.is_none();
        with.angle = units.angle;
        if with.literal == Literal::Unit {
            with.literal = Literal::No;
        }
        Ok(with)
    }
}
