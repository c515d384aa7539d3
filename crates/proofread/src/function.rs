//! Functions by name: their arguments with and without brackets, and their values on intervals.

use crate::cursor::Cursor;
use crate::evaluate::Evaluator;
use crate::exponent::plain_exponent;
use crate::interval::{Interval, RESIDUE};
use crate::reading::Reading;
use crate::token::{Function, Kind, Token};
use crate::unit::unit;
use crate::value::{Angle, Evaluated, Obstacle, Value};
use std::f64::consts::PI;

impl Evaluator<'_> {
    /// The value of a function, whose name is the next token.
    pub fn function(&mut self, function: Function, cursor: &mut Cursor<'_>) -> Evaluated<Value> {
        cursor.at += 1;
        let (mut function, mut power) = (function, None);
        if let Some(Token { kind: Kind::Power(exponent), .. }) = cursor.here() {
            let exponent = plain_exponent(exponent)?;
            cursor.at += 1;
            if exponent == -1.0 {
                function = inverse(function).ok_or(Obstacle::Unclear("an inverse that is not known"))?;
            } else {
                power = Some(exponent);
            }
        }
        let argument = self.argument(function, cursor)?;
        if !argument.dimension.is_none() {
            return Err(Obstacle::Unclear("a function of a quantity with a unit"));
        }
        let mut x = argument.number()?;
        let trigonometric = matches!(
            function,
            Function::Sin | Function::Cos | Function::Tan | Function::Cot | Function::Sec | Function::Csc
        );
        if trigonometric && argument.angle.is_none() {
            self.noticed.note(Reading::DEGREES);
            if self.chosen(Reading::DEGREES) {
                x = x.scaled(PI / 180.0);
            }
        }
        if function == Function::Log {
            self.noticed.note(Reading::NATURAL);
            if self.chosen(Reading::NATURAL) {
                function = Function::Ln;
            }
        }
        let is_outside = match function {
            Function::Arcsin | Function::Arccos => x.low > OUTSIDE || x.high < -OUTSIDE,
            Function::Ln | Function::Log | Function::Lg | Function::LogTo(_) => x.high < 0.0,
            _ => false,
        };
        if is_outside {
            return Err(Obstacle::NoValue("it takes a function outside its domain"));
        }
        let result = on_interval(function, x).filter(|result| result.is_finite());
        let result = result.ok_or(Obstacle::Unclear("a function outside its domain"))?;
        let mut value = Value { operations: argument.operations + 1, bound: argument.bound, ..Value::of(result) };
        if matches!(function, Function::Arcsin | Function::Arccos | Function::Arctan) {
            self.noticed.note(Reading::DEGREES);
            self.inverse = true;
            value.angle = Some(Angle::Radians);
        }
        if let Some(power) = power {
            value = value.power(Interval::exact(power))?;
        }
        self.followed(value, cursor)
    }

    fn argument(&mut self, of: Function, cursor: &mut Cursor<'_>) -> Evaluated<Value> {
        if cursor.peek().is_some_and(|token| token.is_one_of("([{")) {
            let inner = cursor.group()?;
            let mut value = self.whole(inner)?;
            let raised = cursor.here().is_some_and(|token| matches!(token.kind, Kind::Power(_)));
            if raised {
                self.noticed.note(Reading::POWER_OUTSIDE);
            }
            if !raised || !self.chosen(Reading::POWER_OUTSIDE) {
                value = self.followed(value, cursor)?;
            }
            let bare = !value.has_unit && value.angle.is_none();
            let degrees = cursor.peek().and_then(Token::word) == Some("°");
            return if bare && degrees { self.with_unit(value, cursor, false) } else { Ok(value) };
        }
        // Factors without a sign between them, up to the first angle in degrees.
        let mut argument: Option<Value> = None;
        while let Some(token) = cursor.peek() {
            let starts = match &token.kind {
                Kind::Number(_) | Kind::Name(_) | Kind::Fraction(..) | Kind::Root(..) => true,
                Kind::Word(word) => unit(word).is_some(),
                _ => false,
            };
            let next = match &argument {
                None if token.is_one_of("|√-") => {
                    let negative = cursor.take('-');
                    let value = self.single(cursor)?;
                    argument = Some(if negative { value.negated() } else { value });
                    if negative { continue } else { break }
                }
                Some(so_far) if token.is('/') && so_far.angle.is_none() && !so_far.has_unit => {
                    if cursor.look(cursor.at + 1).0.and_then(Token::number).is_none() {
                        break;
                    }
                    if matches!(of, Function::Ln | Function::Log | Function::Lg) {
                        self.noticed.note(Reading::LOGARITHM_ABOVE);
                        if self.chosen(Reading::LOGARITHM_ABOVE) {
                            break;
                        }
                    }
                    cursor.at += 1;
                    let divisor = self.single(cursor)?;
                    so_far.over(&divisor)?
                }
                // An angle in brackets: cos 2(30°).
                Some(so_far) if token.is('(') && so_far.angle.is_none() && !so_far.has_unit => {
                    let mut ahead = *cursor;
                    let factor = self.whole(ahead.group()?)?;
                    if factor.angle != Some(Angle::Degrees) {
                        break;
                    }
                    *cursor = ahead;
                    so_far.times(&factor, None, true)?
                }
                Some(so_far) if starts => {
                    if token.number().is_some() || so_far.angle == Some(Angle::Degrees) {
                        break;
                    }
                    let factor = self.single(cursor)?;
                    so_far.times(&factor, None, true)?
                }
                None if starts => self.single(cursor)?,
                _ => break,
            };
            argument = Some(next);
        }
        argument.ok_or(Obstacle::Unclear("a function without an argument"))
    }
}

fn inverse(function: Function) -> Option<Function> {
    Some(match function {
        Function::Sin => Function::Arcsin,
        Function::Cos => Function::Arccos,
        Function::Tan => Function::Arctan,
        _ => return None,
    })
}

/// What is certainly no sine or cosine, dimensionless.
const OUTSIDE: f64 = 1.000_000_1;

/// The least and greatest value of a function on an interval, and its value at the point.
fn on_interval(function: Function, x: Interval) -> Option<Interval> {
    let inside = |x: Interval| {
        let fits = x.point.abs() <= OUTSIDE;
        fits.then(|| x.through(|x| x.clamp(-1.0, 1.0)))
    };
    Some(match function {
        Function::Sin => wave(x, |x| without_residue(libm::sin(x), x), PI / 2.0),
        Function::Cos => wave(x, |x| without_residue(libm::cos(x), x), 0.0),
        Function::Tan => {
            let branch = |x: f64| libm::floor((x - PI / 2.0) / PI);
            if branch(x.low) != branch(x.high) {
                return None;
            }
            x.through(|x| without_residue(libm::tan(x), x))
        }
        Function::Cot => on_interval(Function::Tan, x)?.inverse()?,
        Function::Sec => wave(x, libm::cos, 0.0).inverse()?,
        Function::Csc => wave(x, libm::sin, PI / 2.0).inverse()?,
        Function::Arcsin => inside(x)?.through(libm::asin),
        Function::Arccos => inside(x)?.through(libm::acos),
        Function::Arctan => x.through(libm::atan),
        Function::Ln if x.low > 0.0 => x.through(libm::log),
        Function::Log | Function::Lg if x.low > 0.0 => x.through(libm::log10),
        Function::LogTo(base) if x.low > 0.0 => x.through(|x| libm::log(x) / libm::log(f64::from(base))),
        Function::Ln | Function::Log | Function::Lg | Function::LogTo(_) => return None,
        Function::Exp => x.through(libm::exp),
        Function::Sinh => x.through(libm::sinh),
        Function::Tanh => x.through(libm::tanh),
        Function::Cosh => {
            let around_zero = x.low < 0.0 && x.high > 0.0;
            let ends = x.through(libm::cosh);
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
    let mut on = x.through(function);
    let passes = |at: f64| libm::floor((x.high - at) / (2.0 * PI)) > libm::floor((x.low - at) / (2.0 * PI));
    if passes(crest) {
        on.high = 1.0;
    }
    if passes(crest + PI) {
        on.low = -1.0;
    }
    on
}
