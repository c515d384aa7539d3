//! What an expression is made of: printed numbers, letters with values, and units alone.

use crate::evaluate::cursor::Cursor;
use crate::evaluate::exponent::{integer_below, is_power_of_e, plain_exponent};
use crate::evaluate::expression::Evaluator;
use crate::evaluate::interval::Interval;
use crate::evaluate::printed::{Mode, PrintedNumber, power_of_ten};
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::{AngleUnit, Evaluated, Literal, Obstacle, SideValue};
use crate::token::{Token, TokenKind, any};
use crate::unit::{currency, is_ambiguous, unit};
use std::f64::consts::PI;

/// Numbers that a mixed number may have above and below its stroke: thousandths, but no more.
const LONGEST_PART: u32 = 10_001;

impl Evaluator<'_> {
    /// A printed number with its power of ten and its unit.
    pub(crate) fn number(&mut self, text: &str, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        cursor.at += 1;
        let unreadable = Obstacle::Unclear("a number with too many digits");
        let mut printed = PrintedNumber::read(text).ok_or(unreadable)?;
        let mut scale = None;
        let (next, at) = cursor.token_from(cursor.at);
        if let Some(power) = next.and_then(Token::word).and_then(large_number) {
            cursor.at = at + 1;
            scale = Some(power);
        }
        if let Some(Token { kind: TokenKind::Power(exponent), .. }) = cursor.current()
            && matches!(exponent.as_slice(), [zero] if zero.number() == Some("0"))
            && text != "10"
        {
            self.noticed.insert(ReadingChoices::ZERO_DEGREES);
            if self.is_chosen(ReadingChoices::ZERO_DEGREES) {
                cursor.at += 1;
                let mut value = SideValue::from_interval(Interval::with_half_width(
                    printed.value,
                    printed.open(self.mode, false).0,
                ));
                value = SideValue { literal: Literal::Number, ..value.scaled(PI / 180.0) };
                value.angle = Some(AngleUnit::Degrees);
                return Ok(value);
            }
        }
        let (next, at) = cursor.token_from(cursor.at);
        if scale.is_none() && next.is_some_and(|token| token.is_one_of("×·*")) {
            let (ten, ten_at) = cursor.token_from(at + 1);
            if ten.and_then(Token::number) == Some("10")
                && let Some(Token { kind: TokenKind::Power(exponent), .. }) = cursor.tokens.get(ten_at + 1)
                && let Ok(power) = plain_exponent(exponent)
            {
                scale = Some(power);
                cursor.at = ten_at + 2;
            }
        } else if text == "10"
            && let Some(Token { kind: TokenKind::Power(exponent), .. }) = cursor.current()
            && let Some(power) = plain_exponent(exponent).ok().filter(|power| power.fract() == 0.0)
        {
            printed = PrintedNumber::read("1").ok_or(Obstacle::NoNumber)?;
            scale = Some(power);
            cursor.at += 1;
        }
        // The decimals of an exponent of ten are as open as those of any result.
        if scale.is_none()
            && text == "10"
            && let Some(Token { kind: TokenKind::Power(exponent), .. }) = cursor.current()
            && plain_exponent(exponent).is_ok_and(|power| power.fract() != 0.0)
            && any(exponent, &|kind| matches!(kind, TokenKind::Number(digits) if digits.contains('.')))
        {
            cursor.at += 1;
            let power = self.evaluate_all(exponent)?.number()?;
            let mut value = SideValue::from_interval(power.map_monotone(power_of_ten));
            value.literal = Literal::Number;
            return self.with_unit(value, cursor, true);
        }
        if scale.is_none()
            && cursor.current().is_some_and(|token| matches!(token.kind, TokenKind::Power(_)) || token.is_sign('!'))
        {
            let half = if printed.decimals.is_some() { printed.open(self.mode, false).0 } else { 0.0 };
            let value =
                self.with_powers(SideValue::from_interval(Interval::with_half_width(printed.value, half)), cursor)?;
            return self.with_unit(value, cursor, false);
        }
        let (half, _) = printed.open(self.mode, scale.is_some());
        let power_alone = text == "10" && scale.is_some() && printed.value == 1.0;
        let half = if power_alone && self.mode != Mode::Result { 0.0 } else { half };
        let factor = power_of_ten(scale.unwrap_or(0.0));
        let exact = Interval::with_half_width(printed.value, half).scaled(factor);
        if !exact.is_finite() {
            return Err(Obstacle::Unclear("a number beyond all bounds"));
        }
        let mut value = SideValue::from_interval(exact);
        value.literal = Literal::Number;
        let (next, at) = cursor.token_from(cursor.at);
        if let Some(Token { kind: TokenKind::Fraction(above, below), .. }) = next
            && at <= cursor.at + 1
            && scale.is_none()
            && let (Some(above), Some(below)) = (integer_below(LONGEST_PART, above), integer_below(LONGEST_PART, below))
            && (above < below || (above < 2.0 * below && below > 1.0))
        {
            self.noticed.insert(ReadingChoices::MIXED);
            if self.is_chosen(ReadingChoices::MIXED) {
                cursor.at = at + 1;
                let mut mixed = SideValue::from_interval(Interval::exact(printed.value + above / below));
                mixed.operations = 1;
                return self.with_unit(mixed, cursor, false);
            }
        }
        self.with_unit(value, cursor, true)
    }

    /// A letter with a value, π, a power of e, or a unit alone.
    pub(crate) fn name(&mut self, token: &Token, name: &str, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        let power = match cursor.tokens.get(cursor.at + 1) {
            Some(Token { kind: TokenKind::Power(exponent), .. }) => plain_exponent(exponent).ok(),
            _ => None,
        };
        // An upright e to such a power is the base of the logarithms, not a charge.
        let is_base = name == "e" && power.is_some_and(is_power_of_e);
        let is_word = token.word().is_some() && !is_base;
        if let Some((_, value)) = self.local.iter().find(|(of, _)| of == name) {
            cursor.at += 1;
            let value = SideValue { operations: 1, literal: Literal::No, ..value.clone() };
            return self.with_powers(value, cursor);
        }
        let bound = self.bindings.and_then(|known| known.get(name)).filter(|_| !is_word || unit(name).is_none());
        if let Some(value) = bound {
            cursor.at += 1;
            self.used.push(name.to_owned());
            if value.has_unit && self.is_chosen(ReadingChoices::NUMBERS) {
                return Err(Obstacle::Unclear("a bound quantity without its unit"));
            }
            let value = SideValue { operations: 1, bound: true, literal: Literal::No, ..value.clone() };
            return self.with_powers(value, cursor);
        }
        if is_word {
            // An upright e that is in no quantity may be the base, too.
            if is_ambiguous(name) || name == "e" {
                return Err(Obstacle::Letter(name.to_owned()));
            }
            if matches!(name, "°C" | "°F") || unit(name).is_none() {
                return Err(Obstacle::Word(name.to_owned()));
            }
            // The sign of a currency comes before its number, which is printed all the same.
            let (next, at) = cursor.token_from(cursor.at + 1);
            if currency(name).is_some()
                && let Some(digits) = next.and_then(Token::number)
            {
                cursor.at = at;
                let price = self.number(digits, cursor)?;
                return Ok(SideValue { has_unit: true, ..price });
            }
            // A letter beside a sign of a sum is no unit: 25 + 4 = A + 1.
            let is_sign = |token: Option<&Token>| token.is_some_and(|token| token.is_one_of("+-"));
            let alone = name.chars().count() == 1 && name.chars().all(char::is_alphabetic);
            if alone && (is_sign(cursor.token_from(cursor.at + 1).0) || is_sign(cursor.previous())) {
                return Err(Obstacle::Letter(name.to_owned()));
            }
            let units = self.units(cursor)?;
            let mut value = SideValue::from_interval(Interval::exact(units.factor));
            value.dimension = units.dimension;
            value.has_unit = !units.dimension.is_none() || units.angle.is_none();
            value.angle = units.angle;
            value.literal = Literal::Unit;
            return Ok(value);
        }
        match name {
            "π" => {
                cursor.at += 1;
                self.with_powers(SideValue::from_interval(Interval::exact(PI)), cursor)
            }
            "e" => {
                let Some(Token { kind: TokenKind::Power(exponent), .. }) = cursor.tokens.get(cursor.at + 1) else {
                    return Err(Obstacle::Letter(name.to_owned()));
                };
                let exponent = self.evaluate_all(exponent)?;
                if !exponent.dimension.is_none() {
                    return Err(Obstacle::Unclear("an exponent with a unit"));
                }
                let power = exponent.number()?;
                if exponent.operations == 0 && power.point == 2.0 {
                    return Err(Obstacle::Unclear("e² may be the square of a charge"));
                }
                cursor.at += 2;
                let raised = power.map_monotone(libm::exp);
                if !raised.is_finite() {
                    return Err(Obstacle::Unclear("a power that is no number"));
                }
                let value = SideValue { operations: 1, bound: exponent.bound, ..SideValue::from_interval(raised) };
                Ok(self.steps.round(value))
            }
            _ => Err(Obstacle::Letter(name.to_owned())),
        }
    }
}

/// The power of ten by which a word multiplies the number before it; none for any other word.
pub(crate) fn large_number(word: &str) -> Option<f64> {
    Some(match word {
        "thousand" => 3.0,
        "million" | "millions" | "Millionen" | "millones" | "milioni" | "milhões" => 6.0,
        "billion" | "Milliarden" | "milliards" | "miliardi" => 9.0,
        "trillion" => 12.0,
        _ => return None,
    })
}
