//! The value of a side under one reading: sums, products, powers and groups.

use crate::effort;
use crate::evaluate::cursor::Cursor;
use crate::evaluate::interval::Interval;
use crate::evaluate::printed::{Mode, PrintedNumber};
use crate::evaluate::progression::of_progression;
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::step_rounding::StepRounding;
use crate::evaluate::value::{AngleUnit, Evaluated, Literal, Obstacle, SideValue};
use crate::evaluate::whole::double_factorial;
use crate::token::{Token, TokenKind, has_number, trim_space};
use crate::unit::unit;
use std::collections::HashMap;

/// Names with their values.
pub(crate) type NameValues = HashMap<String, SideValue>;

/// Deepest nesting that is evaluated.
const DEEPEST: usize = 60;
/// Most factors of one side.
const LONGEST: usize = 3000;

/// Evaluates sides under one reading.
pub(crate) struct Evaluator<'b> {
    pub mode: Mode,
    pub reading: ReadingChoices,
    pub bindings: Option<&'b NameValues>,
    /// The choices that made a difference, or could have.
    pub noticed: ReadingChoices,
    /// Whether an inverse function gave an angle.
    pub inverse: bool,
    /// The names whose values were used.
    pub used: Vec<String>,
    /// The variable of an evaluation bar.
    pub local: Vec<(String, SideValue)>,
    /// Whether the limits of the bar at hand have π in them, so that its variable is in no degrees.
    pub has_pi_as_limit: bool,
    /// What is rounded on the way.
    pub steps: StepRounding,
    /// Whether a sign of plus or minus was met.
    pub spreads: bool,
    depth: usize,
    work: usize,
}

impl<'b> Evaluator<'b> {
    pub(crate) fn new(mode: Mode, reading: ReadingChoices, bindings: Option<&'b NameValues>) -> Self {
        Self {
            mode,
            reading,
            bindings,
            noticed: ReadingChoices::USUAL,
            inverse: false,
            used: Vec::new(),
            local: Vec::new(),
            has_pi_as_limit: false,
            steps: StepRounding::default(),
            spreads: false,
            depth: 0,
            work: 0,
        }
    }

    pub(crate) fn is_chosen(&self, choice: ReadingChoices) -> bool {
        self.reading.contains(choice)
    }

    /// The value of a side, behind which prose may follow.
    pub(crate) fn evaluate_side(&mut self, tokens: &[Token]) -> Evaluated<SideValue> {
        // The integer part of π is a number that is computed.
        let has_part = tokens.iter().any(|token| token.is_one_of("⌊⌈"));
        if !has_number(tokens) && !has_part && self.bindings.is_none() {
            return Err(Obstacle::NoNumber);
        }
        let words = |token: &Token| matches!(&token.kind, TokenKind::Word(word) if word != "e") || token.is_space();
        let is_letter =
            |token: &Token| words(token) || matches!(token.kind, TokenKind::Power(_)) || token.is_one_of("·/");
        if self.bindings.is_none() && tokens.iter().all(is_letter) {
            return Err(Obstacle::NoNumber);
        }
        // A name with a digit in it: F1 Score.
        if let [Token { kind: TokenKind::Word(name), span, .. }, digit, rest @ ..] = tokens
            && name.chars().all(char::is_alphabetic)
            && digit.number().is_some()
            && digit.span.start == span.end
            && rest.iter().all(|token| token.is_space() || token.word().is_some())
        {
            return Err(Obstacle::Word(name.clone()));
        }
        if let Some(value) = self.evaluate_bar(tokens) {
            return value;
        }
        let mut cursor = Cursor::new(tokens);
        let value = self.sum(&mut cursor)?;
        if !has_number(tokens) && !has_part && self.used.is_empty() {
            return Err(Obstacle::NoNumber);
        }
        let rest: Vec<&Token> = tokens[cursor.at..].iter().filter(|token| !token.is_space()).collect();
        let is_number = |token: &&Token| {
            matches!(
                token.kind,
                TokenKind::Number(_) | TokenKind::Fraction(..) | TokenKind::Root(..) | TokenKind::Unknown(_)
            )
        };
        let unknown_word = |token: &Token, longer: usize| {
            token.word().filter(|word| word.chars().count() >= longer && unit(word).is_none()).map(str::to_owned)
        };
        match rest.as_slice() {
            [] => Ok(value),
            [one] if one.is_one_of(".)]") => Ok(value),
            [first, ..] if first.word() == Some("per") => Err(Obstacle::Unclear("a quotient in words")),
            [first, ..] if unknown_word(first, 2).is_some() && !rest.iter().any(is_number) => {
                let bare = !value.has_unit && value.angle.is_none() && !value.parts.is_vector();
                match unknown_word(first, 2).filter(|_| bare) {
                    Some(word) => Err(Obstacle::Word(word)),
                    None => Ok(value),
                }
            }
            [first, second, ..] if first.is_sign('(') && unknown_word(second, 3).is_some() => Ok(value),
            [first, ..] => Err(leftover(first)),
        }
    }

    /// The value of all tokens.
    pub(crate) fn evaluate_all(&mut self, tokens: &[Token]) -> Evaluated<SideValue> {
        let mut cursor = Cursor::new(tokens);
        let value = self.sum(&mut cursor)?;
        match cursor.peek() {
            None => Ok(value),
            Some(token) if token.is_sign('.') && cursor.token_from(cursor.at + 1).0.is_none() => Ok(value),
            Some(token) => Err(leftover(token)),
        }
    }

    /// What is computed inside from the digits as they are printed.
    pub(crate) fn in_points<T>(&mut self, value: impl FnOnce(&mut Self) -> Evaluated<T>) -> Evaluated<T> {
        let mode = std::mem::replace(&mut self.mode, Mode::Point);
        let value = value(self);
        self.mode = mode;
        value
    }

    /// One step further inside: whatever is in something else is evaluated by this, be it in brackets, below a root or behind a bar.
    pub(crate) fn nest(&mut self, value: impl FnOnce(&mut Self) -> Evaluated<SideValue>) -> Evaluated<SideValue> {
        if self.depth >= DEEPEST {
            return Err(Obstacle::TooLarge);
        }
        self.depth += 1;
        let value = value(self);
        self.depth -= 1;
        value
    }

    fn sum(&mut self, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        if let Some(sum) = cursor.tokens.get(cursor.at..).and_then(of_progression) {
            cursor.at = cursor.tokens.len();
            return Ok(sum);
        }
        let mut negative = false;
        if let Some(sign) = cursor.peek().filter(|token| token.is_one_of("±∓")) {
            cursor.at += 1;
            self.noticed.insert(ReadingChoices::MINUS);
            negative = self.is_chosen(ReadingChoices::MINUS) != sign.is_sign('∓');
        } else if !cursor.take('+') {
            negative = cursor.take('-');
        }
        let mut sum = self.product(cursor)?;
        if negative {
            let scale = cursor.previous().and_then(Token::word).filter(|_| self.is_chosen(ReadingChoices::POINTS));
            let literal = sum.literal == Literal::Number;
            // Below zero of the scale: the sign belongs to what is printed, not to the kelvins.
            let zero = match scale {
                Some("°C") if literal => 2.0 * 273.15,
                Some("°F") if literal => 2.0 * 273.15 - 64.0 * 5.0 / 9.0,
                _ => 0.0,
            };
            sum = sum.negate();
            if zero > 0.0 {
                sum.parts = sum.parts.map(|part| part.shifted(zero));
            }
        }
        let mut largest = 0.0f64;
        while let Some(token) = cursor.peek() {
            if token.is_one_of("±∓") {
                return self.spread(&sum, cursor);
            }
            if !token.is_one_of("+-") {
                break;
            }
            // 20 % + 5 % are 25 %.
            let behind_percent = |cursor: &Cursor<'_>| cursor.previous().and_then(Token::word) == Some("%");
            let percents = behind_percent(cursor);
            cursor.at += 1;
            // Some add a negative number without brackets: 5 · 3 + −4 · 2.
            let subtracts = token.is_sign('-') != (token.is_sign('+') && cursor.take_minus());
            let mut term = self.product(cursor)?;
            if !percents && term.literal == Literal::Number && behind_percent(cursor) {
                self.noticed.insert(ReadingChoices::PERCENT);
                if self.is_chosen(ReadingChoices::PERCENT) {
                    term = sum.product(&SideValue { has_unit: false, ..term }, None, true)?;
                }
            }
            let term = if subtracts { term.negate() } else { term };
            let both = sum.sum(&term, self.is_chosen(ReadingChoices::NUMBERS))?;
            self.steps.note_sum([&sum, &term], &both);
            let sizes = [&sum, &term].map(|of| of.number().map_or(0.0, |of| of.point.abs()));
            // What is exactly zero has no rounding that goes on.
            largest = if both.is_zero_at_point() { 0.0 } else { sizes.into_iter().fold(largest, f64::max) };
            sum = both;
        }
        sum.parts = sum.parts.map(|part| part.without_residue(largest));
        if cursor.peek().and_then(Token::word) == Some("mod") {
            cursor.at += 1;
            let negative = cursor.take('-');
            let modulus = self.product(cursor)?;
            let modulus = if negative { modulus.negate() } else { modulus };
            sum = self.remainder(&sum, &modulus)?;
        }
        Ok(sum)
    }

    pub(crate) fn product(&mut self, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        let mut product = self.factor(cursor)?;
        while let Some(token) = cursor.peek() {
            let literal_with_unit = product.literal == Literal::Number && product.has_unit;
            if token.is_one_of("·×*") {
                cursor.at += 1;
                let factor = self.signed(cursor)?;
                let sign = if token.is_sign('×') { '×' } else { '·' };
                product = product.product(&factor, Some(sign), true)?;
            } else if token.is_sign('/') {
                cursor.at += 1;
                product = self.quotient(product, cursor)?;
            } else if token.number().is_some()
                && product.literal == Literal::Number
                && product.angle == Some(AngleUnit::Degrees)
            {
                return Err(Obstacle::Unclear("two numbers side by side"));
            } else if token.number().is_some() && literal_with_unit && !product.dimension.is_none() {
                // 2 min 30 s
                let more = self.factor(cursor)?;
                if more.dimension != product.dimension || !more.has_unit || more.literal != Literal::Number {
                    return Err(Obstacle::Unclear("two numbers side by side"));
                }
                product = product.sum(&more, false)?;
                product.operations = 0;
                product.literal = Literal::Number;
            } else if token.word() == Some("mod") && self.takes_one_factor(&product, cursor) {
                cursor.at += 1;
                let modulus = self.signed(cursor)?;
                product = self.remainder(&product, &modulus)?;
            } else if token.is_sign('(') && self.repeats(&product, cursor)? {
            } else if self.starts_factor(token) {
                if token.number().is_some() && cursor.previous().and_then(Token::word) == Some("%") {
                    return Err(Obstacle::Unclear("a remainder"));
                }
                if token.number().is_some() && cursor.previous().is_some_and(|before| before.number().is_some()) {
                    return Err(Obstacle::Unclear("two numbers side by side"));
                }
                let factor = self.factor(cursor)?;
                let is_unit = matches!(token.kind, TokenKind::Basis(_)) || factor.literal == Literal::Unit;
                product = product.product(&factor, None, !is_unit)?;
            } else {
                break;
            }
        }
        Ok(product)
    }

    fn quotient(&mut self, above: SideValue, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        let (next, _) = cursor.token_from(cursor.at);
        let mut divisor = self.signed(cursor)?;
        while let Some(token) = cursor.peek().filter(|token| self.follows_stroke(token, &divisor)) {
            self.noticed.insert(ReadingChoices::ALL_BELOW);
            if !self.is_chosen(ReadingChoices::ALL_BELOW) {
                break;
            }
            let factor = self.factor(cursor)?;
            let is_unit = factor.literal == Literal::Unit;
            divisor = divisor.product(&factor, None, !is_unit && token.number().is_none())?;
        }
        let number = next.and_then(Token::number).and_then(PrintedNumber::read);
        if let Some(number) =
            number.filter(|_| divisor.literal == Literal::Number && divisor.has_unit && !above.has_unit)
        {
            self.noticed.insert(ReadingChoices::QUOTIENT);
            if self.is_chosen(ReadingChoices::QUOTIENT) && number.value != 0.0 {
                let factor = divisor.number()?.point / number.value;
                let bare = SideValue { has_unit: false, dimension: Default::default(), ..divisor.scaled(1.0 / factor) };
                let quotient = above.quotient(&bare)?;
                return Ok(SideValue { dimension: divisor.dimension, has_unit: true, ..quotient.scaled(factor) });
            }
        }
        // A number with an inverse unit is printed as it is: 26.6/s. One of them is mostly meant exactly.
        let is_printed = above.literal == Literal::Number && !above.has_unit && divisor.literal == Literal::Unit;
        let is_one = above.number().is_ok_and(|of| of.point == 1.0);
        let mut quotient = self.steps.round(above.quotient(&divisor)?);
        if is_printed && !is_one {
            (quotient.literal, quotient.operations) = (Literal::Number, 0);
        }
        Ok(quotient)
    }

    /// Whether a token behind a divisor may still be below the stroke.
    fn follows_stroke(&self, token: &Token, divisor: &SideValue) -> bool {
        let starts = match &token.kind {
            TokenKind::Name(_) | TokenKind::Function(_) | TokenKind::Root(..) => true,
            TokenKind::Operator(c) => "([√".contains(*c),
            _ => false,
        };
        starts && divisor.literal != Literal::Unit
    }

    /// Whether what is in the brackets ahead only repeats the value in another unit, or is the number of an equation.
    fn repeats(&mut self, value: &SideValue, cursor: &mut Cursor<'_>) -> Evaluated<bool> {
        let mut ahead = *cursor;
        let inner = ahead.take_group()?;
        let core: Vec<&Token> = inner.iter().filter(|token| !token.is_space()).collect();
        let ends = ahead.peek().is_none();
        if let [Token { kind: TokenKind::Word(word), .. }] = core.as_slice()
            && value.has_unit
            && unit(word).is_some_and(|unit| unit.dimension == value.dimension)
        {
            *cursor = ahead;
            return Ok(true);
        }
        let apart = cursor.at.checked_sub(1).and_then(|at| cursor.tokens.get(at)).is_some_and(Token::is_space);
        if let [Token { kind: TokenKind::Number(number), .. }] = core.as_slice()
            && ends
            && (apart || value.has_unit)
            && is_equation_number(number)
        {
            self.noticed.insert(ReadingChoices::TAG);
            if self.is_chosen(ReadingChoices::TAG) {
                *cursor = ahead;
                return Ok(true);
            }
            return Ok(false);
        }
        // A result in another unit.
        if ends
            && value.literal == Literal::Number
            && value.has_unit
            && core.len() > 1
            && matches!(core[0].kind, TokenKind::Number(_))
        {
            let (noticed, used) = (self.noticed, self.used.len());
            if let Ok(other) = self.evaluate_all(inner)
                && other.literal == Literal::Number
                && other.has_unit
                && other.dimension == value.dimension
                && value.meets(&other, 0.02)
            {
                *cursor = ahead;
                return Ok(true);
            }
            self.noticed = noticed;
            self.used.truncate(used);
        }
        if let [Token { kind: TokenKind::Number(_), .. }, percent] = core.as_slice()
            && percent.word() == Some("%")
            && ends
            && value.literal == Literal::Number
        {
            // A count with its share, or a factor before a percentage.
            self.noticed.insert(ReadingChoices::SHARE);
            if !self.is_chosen(ReadingChoices::SHARE) {
                *cursor = ahead;
                return Ok(true);
            }
        }
        if ends && core.iter().any(|token| token.word() == Some("%")) {
            let (noticed, used) = (self.noticed, self.used.len());
            if let Ok(other) = self.evaluate_all(inner)
                && value.meets(&other, 0.02)
            {
                *cursor = ahead;
                return Ok(true);
            }
            self.noticed = noticed;
            self.used.truncate(used);
        }
        Ok(false)
    }

    pub(crate) fn signed(&mut self, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        let negative = cursor.take('-');
        let value = self.factor(cursor)?;
        Ok(if negative { value.negate() } else { value })
    }

    fn starts_factor(&self, token: &Token) -> bool {
        match &token.kind {
            TokenKind::Number(_)
            | TokenKind::Name(_)
            | TokenKind::Function(_)
            | TokenKind::Fraction(..)
            | TokenKind::Root(..)
            | TokenKind::Group(_)
            | TokenKind::Basis(_)
            | TokenKind::Call(..)
            | TokenKind::Unknown(_) => true,
            TokenKind::Word(word) => {
                unit(word).is_some()
                    || word.chars().count() == 1
                    || self.bindings.is_some_and(|known| known.contains_key(word))
            }
            TokenKind::Operator(c) => "([{√⌊⌈".contains(*c),
            _ => false,
        }
    }

    fn exponent(&mut self, tokens: &[Token]) -> Evaluated<Interval> {
        let mode = std::mem::replace(&mut self.mode, Mode::Point);
        let exact = self.evaluate_all(tokens);
        self.mode = mode;
        let exact = exact?;
        let value = if exact.operations == 0 && !exact.has_unit { exact } else { self.evaluate_all(tokens)? };
        if !value.dimension.is_none() {
            return Err(Obstacle::Unclear("an exponent with a unit"));
        }
        value.number()
    }

    pub(crate) fn raise(&mut self, value: &SideValue, exponent: &[Token]) -> Evaluated<SideValue> {
        if let [Token { kind: TokenKind::Call(operation, count), .. }] = exponent
            && let [count] = count.as_slice()
        {
            return self.factorial_power(value, *operation, count);
        }
        let exponent = self.exponent(exponent)?;
        Ok(self.steps.round(value.power(exponent)?))
    }

    /// Exponents and factorials behind a value.
    pub(crate) fn with_powers(&mut self, mut value: SideValue, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        while let Some(token) = cursor.current() {
            if let TokenKind::Power(exponent) = &token.kind {
                cursor.at += 1;
                value = self.raise(&value, exponent)?;
            } else if token.is_sign('!') {
                cursor.at += 1;
                match cursor.current() {
                    Some(next) if next.is_sign('!') => {
                        cursor.at += 1;
                        if cursor.current().is_some_and(|next| next.is_sign('!')) {
                            return Err(Obstacle::Unclear("a factorial of several steps"));
                        }
                        value = double_factorial(&value)?;
                        continue;
                    }
                    Some(Token { kind: TokenKind::Power(of), .. })
                        if of.first().is_some_and(|open| open.is_sign('(')) =>
                    {
                        return Err(Obstacle::Unclear("a factorial of several steps"));
                    }
                    _ => {}
                }
                value = value.factorial()?;
            } else {
                break;
            }
        }
        Ok(value)
    }

    /// One factor, for the argument of a function.
    pub(crate) fn evaluate_factor(&mut self, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        self.factor(cursor)
    }

    fn factor(&mut self, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        self.work += 1;
        effort::count_steps(1);
        if self.work > LONGEST {
            return Err(Obstacle::TooLarge);
        }
        let Some(token) = cursor.peek() else { return Err(Obstacle::Unclear("something is missing")) };
        self.nest(|inside| inside.factor_of(token, cursor))
    }

    fn factor_of(&mut self, token: &Token, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        match &token.kind {
            TokenKind::Number(text) => self.number(text, cursor),
            TokenKind::Word(word) | TokenKind::Name(word) => self.name(token, word, cursor),
            TokenKind::Basis(which) => {
                cursor.at += 1;
                let mut value = SideValue::from_interval(Interval::exact(1.0));
                value.parts.0 = [None; 4];
                value.parts.0[usize::from(*which).min(3)] = Some(Interval::exact(1.0));
                Ok(value)
            }
            TokenKind::Fraction(above_tokens, below) => {
                cursor.at += 1;
                let (above, below) = (self.evaluate_all(above_tokens)?, self.evaluate_all(below)?);
                let mut value = above.quotient(&below)?;
                let is_inverse = matches!(trim_space(above_tokens), [one] if one.number() == Some("1"));
                if (above.literal == Literal::Unit || is_inverse) && below.literal == Literal::Unit {
                    value.literal = Literal::Unit;
                    value.operations = 0;
                }
                let value = self.steps.round(value);
                let value = self.with_powers(value, cursor)?;
                self.with_unit(value, cursor, false)
            }
            TokenKind::Root(of, index) => {
                cursor.at += 1;
                if matches!(of.as_slice(), [minus, one] if minus.is_sign('-') && one.number() == Some("1")) {
                    return Err(Obstacle::Unclear("an imaginary number"));
                }
                let index = if index.is_empty() { 2.0 } else { self.exponent(index)?.point };
                let value = self.evaluate_all(of)?.power(Interval::exact(1.0 / index))?;
                let value = self.steps.round(value);
                let value = self.with_powers(value, cursor)?;
                self.with_unit(value, cursor, false)
            }
            TokenKind::Group(inner) => {
                cursor.at += 1;
                let value = self.evaluate_all(inner)?;
                let value = self.with_powers(value, cursor)?;
                self.with_unit(value, cursor, false)
            }
            TokenKind::Operator('√') => {
                cursor.at += 1;
                let value = self.factor(cursor)?.power(Interval::exact(0.5))?;
                self.with_unit(value, cursor, false)
            }
            TokenKind::Operator('(' | '[' | '{') => self.evaluate_bracketed(cursor),
            TokenKind::Operator('⌊' | '⌈') => self.rounded_part(cursor),
            TokenKind::Call(operation, arguments) => self.call(*operation, arguments, cursor),
            TokenKind::Operator('|') => {
                let end = cursor.tokens.iter().skip(cursor.at + 1).position(|token| token.is_sign('|'));
                let end = cursor.at + 1 + end.ok_or(Obstacle::Unclear("a bar without another one"))?;
                let mut value = self.evaluate_all(&cursor.tokens[cursor.at + 1..end])?;
                cursor.at = end + 1;
                value.number()?;
                value.parts = value.parts.map(Interval::abs);
                value.operations += 1;
                value.literal = Literal::No;
                let value = self.with_powers(value, cursor)?;
                self.with_unit(value, cursor, false)
            }
            TokenKind::Function(function) => self.function(*function, cursor),
            _ => Err(leftover(token)),
        }
    }

    fn evaluate_bracketed(&mut self, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        let inner = cursor.take_group()?;
        if trim_space(inner).is_empty() {
            return Err(Obstacle::Unclear("empty brackets"));
        }
        if let Some(limits) = cursor.current().filter(|token| matches!(token.kind, TokenKind::Limits(..))) {
            cursor.at += 1;
            let value = self.evaluate_between(inner, limits)?;
            return self.with_unit(value, cursor, false);
        }
        // The greatest integer: [[3.7]].
        if let [first, middle @ .., last] = trim_space(inner)
            && first.is_sign('[')
            && last.is_sign(']')
            && !middle.iter().any(|token| token.is_one_of("[]"))
        {
            let value = self.in_points(|inside| inside.evaluate_all(middle))?;
            return self.whole(value, '⌊', cursor);
        }
        // The order of a set says nothing.
        let is_set = cursor.previous().is_some_and(|close| close.is_sign('}'));
        if let Some(value) = self.tuple(inner, is_set)? {
            return self.with_powers(value, cursor);
        }
        let mut value = self.evaluate_all(inner)?;
        if value.literal != Literal::Unit {
            value.literal = Literal::No;
        }
        let value = self.with_powers(value, cursor)?;
        self.with_unit(value, cursor, false)
    }
}

pub(crate) fn leftover(token: &Token) -> Obstacle {
    match &token.kind {
        TokenKind::Name(name) => Obstacle::Letter(name.clone()),
        TokenKind::Word(word) => Obstacle::Word(word.clone()),
        TokenKind::Unknown(_) => Obstacle::Unclear("it has a sign or command that is not known"),
        TokenKind::Limits(..) => Obstacle::Unclear("a bar in the middle of an expression"),
        _ => Obstacle::Unclear("it has a sign in a place where none is expected"),
    }
}

/// Whether brackets around it make the number of an equation.
fn is_equation_number(text: &str) -> bool {
    let [chapter, number] = text.split_once('.').map_or(["", text], |(chapter, number)| [chapter, number]);
    chapter.len() <= 2 && (1..=3).contains(&number.len()) && !number.contains(',')
}
