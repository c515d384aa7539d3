//! Functions by name: their arguments with and without brackets, and their values on intervals.

use crate::evaluate::cursor::Cursor;
use crate::evaluate::exponent::plain_exponent;
use crate::evaluate::expression::Evaluator;
use crate::evaluate::interval::{Interval, RESIDUE};
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::{AngleUnit, Evaluated, Obstacle, SideValue};
use crate::token::{MathFunction, Token, TokenKind, any};
use crate::unit::unit;
use std::f64::consts::PI;

impl Evaluator<'_> {
    /// The value of a function, whose name is the next token.
    pub(crate) fn function(&mut self, function: MathFunction, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        cursor.at += 1;
        if function.takes_list() {
            return self.of_list(function, cursor);
        }
        let (mut function, mut power) = (function, None);
        if let Some(Token { kind: TokenKind::Power(exponent), .. }) = cursor.current() {
            let exponent = plain_exponent(exponent)?;
            cursor.at += 1;
            if exponent == -1.0 {
                function = inverse(function).ok_or(Obstacle::Unclear("an inverse that is not known"))?;
            } else {
                power = Some(exponent);
            }
        }
        // arctan2(y, x)
        let two = |at: usize| cursor.tokens.get(at).and_then(Token::number) == Some("2");
        if function == MathFunction::Arctan
            && two(cursor.at)
            && cursor.tokens.get(cursor.at + 1).is_some_and(|next| next.is_sign('('))
        {
            return Err(Obstacle::Unclear("a function of two numbers"));
        }
        let from = cursor.at;
        let argument = self.argument(function, cursor)?;
        // An angle with π in it is never in degrees.
        let is_pi = |kind: &TokenKind| matches!(kind, TokenKind::Name(name) if name == "π");
        let has_pi =
            self.has_pi_as_limit || cursor.tokens.get(from..cursor.at).is_some_and(|tokens| any(tokens, &is_pi));
        if !argument.dimension.is_none() {
            return Err(Obstacle::Unclear("a function of a quantity with a unit"));
        }
        let mut x = argument.number()?;
        let trigonometric = matches!(
            function,
            MathFunction::Sin
                | MathFunction::Cos
                | MathFunction::Tan
                | MathFunction::Cot
                | MathFunction::Sec
                | MathFunction::Csc
        );
        if trigonometric && argument.angle.is_none() && !has_pi {
            self.noticed.insert(ReadingChoices::DEGREES);
            if self.is_chosen(ReadingChoices::DEGREES) {
                x = x.scaled(PI / 180.0);
            }
        }
        if function == MathFunction::Log {
            self.noticed.insert(ReadingChoices::NATURAL);
            if self.is_chosen(ReadingChoices::NATURAL) {
                function = MathFunction::Ln;
            }
        }
        let is_outside = match function {
            MathFunction::Arcsin | MathFunction::Arccos => x.low > OUTSIDE || x.high < -OUTSIDE,
            MathFunction::Ln | MathFunction::Log | MathFunction::Lg | MathFunction::LogTo(_) => x.high < 0.0,
            _ => false,
        };
        if is_outside {
            return Err(Obstacle::NoValue("it takes a function outside its domain"));
        }
        let result = on_interval(function, x).filter(|result| result.is_finite());
        let result = result.ok_or(Obstacle::Unclear("a function outside its domain"))?;
        let mut value = SideValue {
            operations: argument.operations + 1,
            bound: argument.bound,
            ..SideValue::from_interval(result)
        };
        if matches!(function, MathFunction::Arcsin | MathFunction::Arccos | MathFunction::Arctan) {
            self.noticed.insert(ReadingChoices::DEGREES);
            self.inverse = true;
            value.angle = Some(AngleUnit::Radians);
        }
        if let Some(power) = power {
            value = value.power(Interval::exact(power))?;
        }
        let value = self.steps.round(value);
        self.with_powers(value, cursor)
    }

    fn argument(&mut self, of: MathFunction, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        if cursor.peek().is_some_and(|token| token.is_one_of("([{")) {
            let inner = cursor.take_group()?;
            let mut value = self.evaluate_all(inner)?;
            let raised = cursor.current().is_some_and(|token| matches!(token.kind, TokenKind::Power(_)));
            if raised {
                self.noticed.insert(ReadingChoices::POWER_OUTSIDE);
            }
            if !raised || !self.is_chosen(ReadingChoices::POWER_OUTSIDE) {
                value = self.with_powers(value, cursor)?;
            }
            let bare = !value.has_unit && value.angle.is_none();
            let degrees = cursor.peek().and_then(Token::word) == Some("°");
            return if bare && degrees { self.with_unit(value, cursor, false) } else { Ok(value) };
        }
        // Factors without a sign between them, up to the first angle in degrees.
        let mut argument: Option<SideValue> = None;
        while let Some(token) = cursor.peek() {
            let starts = match &token.kind {
                TokenKind::Number(_) | TokenKind::Name(_) | TokenKind::Fraction(..) | TokenKind::Root(..) => true,
                TokenKind::Word(word) => unit(word).is_some(),
                _ => false,
            };
            let next = match &argument {
                None if token.is_one_of("|√-") => {
                    let negative = cursor.take('-');
                    let value = self.evaluate_factor(cursor)?;
                    argument = Some(if negative { value.negate() } else { value });
                    if negative { continue } else { break }
                }
                Some(so_far) if token.is_sign('/') && so_far.angle.is_none() && !so_far.has_unit => {
                    if cursor.token_from(cursor.at + 1).0.and_then(Token::number).is_none() {
                        break;
                    }
                    if matches!(of, MathFunction::Ln | MathFunction::Log | MathFunction::Lg) {
                        self.noticed.insert(ReadingChoices::LOGARITHM_ABOVE);
                        if self.is_chosen(ReadingChoices::LOGARITHM_ABOVE) {
                            break;
                        }
                    }
                    cursor.at += 1;
                    let divisor = self.evaluate_factor(cursor)?;
                    so_far.quotient(&divisor)?
                }
                // An angle in brackets: cos 2(30°), sin 2(π/6).
                Some(so_far) if token.is_sign('(') && so_far.angle.is_none() && !so_far.has_unit => {
                    let mut ahead = *cursor;
                    let inner = ahead.take_group()?;
                    let factor = self.evaluate_all(inner)?;
                    let has_pi = any(inner, &|kind| *kind == TokenKind::Name("π".to_owned()));
                    let in_radians = cursor.previous().is_some_and(|before| before.number().is_some()) && has_pi;
                    if factor.angle != Some(AngleUnit::Degrees) && !in_radians {
                        break;
                    }
                    *cursor = ahead;
                    so_far.product(&factor, None, true)?
                }
                Some(so_far) if starts => {
                    if token.number().is_some() || so_far.angle == Some(AngleUnit::Degrees) {
                        break;
                    }
                    let factor = self.evaluate_factor(cursor)?;
                    so_far.product(&factor, None, true)?
                }
                None if starts => self.evaluate_factor(cursor)?,
                _ => break,
            };
            argument = Some(next);
        }
        argument.ok_or(Obstacle::Unclear("a function without an argument"))
    }
}

fn inverse(function: MathFunction) -> Option<MathFunction> {
    Some(match function {
        MathFunction::Sin => MathFunction::Arcsin,
        MathFunction::Cos => MathFunction::Arccos,
        MathFunction::Tan => MathFunction::Arctan,
        _ => return None,
    })
}

/// What is certainly no sine or cosine, dimensionless.
const OUTSIDE: f64 = 1.000_000_1;

/// The least and greatest value of a function on an interval, and its value at the point.
fn on_interval(function: MathFunction, x: Interval) -> Option<Interval> {
    let inside = |x: Interval| {
        let fits = x.point.abs() <= OUTSIDE;
        fits.then(|| x.map_monotone(|x| x.clamp(-1.0, 1.0)))
    };
    Some(match function {
        MathFunction::Sin => wave(x, |x| without_residue(libm::sin(x), x), PI / 2.0),
        MathFunction::Cos => wave(x, |x| without_residue(libm::cos(x), x), 0.0),
        MathFunction::Tan => {
            let branch = |x: f64| libm::floor((x - PI / 2.0) / PI);
            if branch(x.low) != branch(x.high) {
                return None;
            }
            x.map_monotone(|x| without_residue(libm::tan(x), x))
        }
        MathFunction::Cot => {
            let quotient = [MathFunction::Cos, MathFunction::Sin].map(|of| on_interval(of, x));
            let [Some(cosine), Some(sine)] = quotient else { return None };
            cosine * sine.inverse()?
        }
        MathFunction::Sec => wave(x, libm::cos, 0.0).inverse()?,
        MathFunction::Csc => wave(x, libm::sin, PI / 2.0).inverse()?,
        MathFunction::Arcsin => inside(x)?.map_monotone(libm::asin),
        MathFunction::Arccos => inside(x)?.map_monotone(libm::acos),
        MathFunction::Arctan => x.map_monotone(libm::atan),
        MathFunction::Ln if x.low > 0.0 => x.map_monotone(libm::log),
        MathFunction::Log | MathFunction::Lg if x.low > 0.0 => x.map_monotone(libm::log10),
        MathFunction::LogTo(base) if x.low > 0.0 => x.map_monotone(|x| libm::log(x) / libm::log(f64::from(base))),
        MathFunction::Ln | MathFunction::Log | MathFunction::Lg | MathFunction::LogTo(_) => return None,
        MathFunction::Max | MathFunction::Min | MathFunction::Gcd | MathFunction::Lcm => return None,
        MathFunction::Exp => x.map_monotone(libm::exp),
        MathFunction::Sinh => x.map_monotone(libm::sinh),
        MathFunction::Tanh => x.map_monotone(libm::tanh),
        MathFunction::Cosh => {
            let around_zero = x.low < 0.0 && x.high > 0.0;
            let ends = x.map_monotone(libm::cosh);
            if around_zero { Interval { low: 1.0, ..ends } } else { ends }
        }
    })
}

/// The value of a function at `x`, zero if no more than the rounding of `x` is left: the sine of 4π in floating point.
fn without_residue(value: f64, x: f64) -> f64 {
    if x.abs() > 1.0 && value.abs() <= RESIDUE * x.abs() { 0.0 } else { value }
}

/// A sine or cosine, whose crests are at `crest` and every 2π from there.
fn wave(x: Interval, function: impl Fn(f64) -> f64, crest: f64) -> Interval {
    let mut on = x.map_monotone(function);
    let passes = |at: f64| libm::floor((x.high - at) / (2.0 * PI)) > libm::floor((x.low - at) / (2.0 * PI));
    if passes(crest) {
        on.high = 1.0;
    }
    if passes(crest + PI) {
        on.low = -1.0;
    }
    on
}
