//! Operations with names and signs of their own: remainders, integer parts, binomial coefficients, factorials of several kinds, lists,
//! sums over an index, tuples and determinants.

use crate::decimal::parse_decimal;
use crate::evaluate::cursor::Cursor;
use crate::evaluate::exponent::small_integer;
use crate::evaluate::expression::Evaluator;
use crate::evaluate::interval::Interval;
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::{Evaluated, Literal, Obstacle, SideValue};
use crate::evaluate::whole::{LARGEST, MOST_FACTORS, NOISE, computed, integer, product_of};
use crate::token::{MathFunction, NamedOperation, Token, TokenKind, trim_space};

/// Largest integer that is told from its inverse in floating point.
const LARGEST_INVERTED: f64 = 9.0e7;

/// Most terms of a sum over an index.
const MOST_TERMS: f64 = 200.0;

/// Most terms of a sum over an index inside another one.
const MOST_TERMS_INSIDE: f64 = 12.0;

/// Largest determinant that is computed, in rows.
const MOST_ROWS: usize = 4;

/// The integer whose inverse a computed value is.
fn inverted_integer(value: &SideValue) -> Option<f64> {
    let number = value.number().ok().filter(|_| !value.has_unit && value.literal != Literal::Number)?.point;
    let whole = libm::round(1.0 / number);
    (whole.abs() < LARGEST_INVERTED && (1.0 / number - whole).abs() <= NOISE * whole.abs()).then_some(whole)
}

/// The inverse of an integer for a modulus, from 1 to the modulus.
fn inverse(of: f64, modulus: f64) -> Evaluated<f64> {
    let (mut a, mut b) = (of.rem_euclid(modulus), modulus);
    let (mut factor, mut other) = (1.0, 0.0);
    while b > 0.0 {
        let times = libm::floor(a / b);
        (a, b) = (b, a - times * b);
        (factor, other) = (other, factor - times * other);
    }
    if a != 1.0 || modulus < 2.0 {
        return Err(Obstacle::Unclear("a number without an inverse"));
    }
    Ok(factor.rem_euclid(modulus))
}

/// The pieces between commas or semicolons outside brackets.
pub(crate) fn listed(tokens: &[Token]) -> Vec<&[Token]> {
    let mut depth = 0usize;
    tokens
        .split(|token| {
            if token.is_one_of("([{⌊⌈") {
                depth += 1;
            } else if token.is_one_of(")]}⌋⌉") {
                depth = depth.saturating_sub(1);
            }
            depth == 0 && token.is_one_of(",;")
        })
        .collect()
}

fn greatest_divisor(mut a: f64, mut b: f64) -> f64 {
    while b > 0.0 {
        (a, b) = (b, a % b);
    }
    a
}

/// A coefficient of the binomial series, as of the power −3/2: its first `k` factors over the factorial of `k`.
fn generalised_binomial(n: f64, k: f64) -> Evaluated<f64> {
    if k < 0.0 {
        return Err(Obstacle::Unclear("a binomial coefficient below a negative number"));
    }
    if k > MOST_FACTORS {
        return Err(Obstacle::TooLarge);
    }
    Ok((0..k as u32).map(|at| (n - f64::from(at)) / f64::from(at + 1)).product())
}

fn binomial(n: f64, k: f64) -> Evaluated<f64> {
    if k < 0.0 {
        return Err(Obstacle::Unclear("a binomial coefficient below a negative number"));
    }
    let k = if n >= k { k.min(n - k) } else { return Ok(0.0) };
    if k > MOST_FACTORS {
        return Err(Obstacle::TooLarge);
    }
    let grow = |sum: f64, at: u32| libm::round(sum * (n - f64::from(at)) / f64::from(at + 1));
    Ok((0..k as u32)
        .try_fold(1.0, |sum: f64, at| (sum < LARGEST).then(|| grow(sum, at)))
        .unwrap_or_else(|| (0..k as u32).map(|at| (n - f64::from(at)) / f64::from(at + 1)).product()))
}

impl Evaluator<'_> {
    /// The remainder of a division of integers, not negative unless the modulus is; that of a computed fraction 1/a is the inverse of a.
    pub(crate) fn remainder(&mut self, of: &SideValue, modulus: &SideValue) -> Evaluated<SideValue> {
        let operations = of.operations.saturating_add(modulus.operations);
        let modulus = integer(modulus)?;
        if let (Err(_), Some(inverted)) = (integer(of), inverted_integer(of)) {
            return Ok(computed(inverse(inverted, modulus)?, operations));
        }
        let of = integer(of)?;
        if modulus == 0.0 {
            return Err(Obstacle::Unclear("a remainder of a division by zero"));
        }
        let rest = of % modulus;
        if rest * modulus < 0.0 {
            self.noticed.insert(ReadingChoices::REMAINDER_OF_FACTOR);
            if !self.is_chosen(ReadingChoices::REMAINDER_OF_FACTOR) {
                return Ok(computed(rest + modulus, operations));
            }
        }
        Ok(computed(rest, operations))
    }

    /// Whether the remainder ahead is one of the last factor alone.
    pub(crate) fn takes_one_factor(&mut self, product: &SideValue, cursor: &Cursor<'_>) -> bool {
        let before = &cursor.tokens[..cursor.at.min(cursor.tokens.len())];
        if product.has_unit || !before.iter().any(|token| token.is_one_of("+-")) {
            return false;
        }
        self.noticed.insert(ReadingChoices::REMAINDER_OF_FACTOR);
        self.is_chosen(ReadingChoices::REMAINDER_OF_FACTOR)
    }

    /// What is in the brackets of an integer part that open here.
    pub(crate) fn rounded_part(&mut self, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        let open = if cursor.peek().is_some_and(|token| token.is_sign('⌈')) { '⌈' } else { '⌊' };
        let inner = cursor.take_group()?;
        let closes = cursor.previous().is_some_and(|close| close.is_sign(if open == '⌈' { '⌉' } else { '⌋' }));
        if !closes {
            return Err(Obstacle::Unclear("a bracket that is not closed"));
        }
        let value = self.in_points(|inside| inside.evaluate_all(inner))?;
        self.whole(value, open, cursor)
    }

    /// The integer part of a value, downwards or upwards.
    pub(crate) fn whole(&mut self, value: SideValue, open: char, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        let number = value.number()?.point;
        if value.has_unit {
            return Err(Obstacle::Unclear("an integer part of a quantity"));
        }
        let slack = NOISE * number.abs().max(1.0);
        let whole = if open == '⌈' { libm::ceil(number - slack) } else { libm::floor(number + slack) };
        self.with_powers(computed(whole, value.operations), cursor)
    }

    /// The largest or smallest of a list, or the divisor or multiple of its integers.
    pub(crate) fn of_list(&mut self, function: MathFunction, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        if !cursor.peek().is_some_and(|token| token.is_one_of("([{")) {
            return Err(Obstacle::Unclear("a function of a list without one"));
        }
        let inner = cursor.take_group()?;
        let mut values = Vec::new();
        for piece in listed(inner) {
            values.push(self.evaluate_all(piece)?);
        }
        // In a list, a comma without space parts no thousands.
        if values.len() == 1
            && let [Token { kind: TokenKind::Number(digits), .. }] = trim_space(inner)
        {
            let numbers = digits.split(',').filter_map(parse_decimal);
            values = numbers.map(|of| computed(of, 0)).collect();
        }
        let Some((first, rest)) = values.split_first().filter(|(_, rest)| !rest.is_empty()) else {
            return Err(Obstacle::Unclear("a function of a list without one"));
        };
        let operations = values.iter().map(|value| value.operations).fold(0u32, u32::saturating_add);
        let value = match function {
            MathFunction::Gcd | MathFunction::Lcm => {
                let mut sum = integer(first)?.abs();
                for other in rest {
                    let other = integer(other)?.abs();
                    let divisor = greatest_divisor(sum, other);
                    sum = match function {
                        MathFunction::Gcd => divisor,
                        _ if divisor > 0.0 => sum / divisor * other,
                        _ => 0.0,
                    };
                }
                computed(sum, operations)
            }
            _ => {
                let mut best = first.clone();
                for other in rest {
                    if other.dimension != best.dimension {
                        return Err(Obstacle::MixedSum);
                    }
                    let (one, two) = (best.number()?, other.number()?);
                    let pick = |a: f64, b: f64| if function == MathFunction::Max { a.max(b) } else { a.min(b) };
                    let picked = Interval {
                        low: pick(one.low, two.low),
                        point: pick(one.point, two.point),
                        high: pick(one.high, two.high),
                    };
                    best.parts = best.parts.map(|_| picked);
                }
                SideValue { operations: operations.saturating_add(1), literal: Literal::No, factor: 1.0, ..best }
            }
        };
        self.with_powers(value, cursor)
    }

    /// An operation with arguments of its own.
    pub(crate) fn call(
        &mut self,
        operation: NamedOperation,
        arguments: &[Vec<Token>],
        cursor: &mut Cursor<'_>,
    ) -> Evaluated<SideValue> {
        cursor.at += 1;
        let value = match (operation, arguments) {
            (NamedOperation::Sum | NamedOperation::Product, [index, first, last]) => {
                return self.over_index(operation, [index, first, last], cursor);
            }
            (NamedOperation::InBase, [digits, base]) => {
                let base = small_integer(base).unwrap_or(10.0);
                let digits = digits.first().and_then(Token::number).unwrap_or_default();
                let value =
                    digits.chars().filter_map(|c| c.to_digit(10)).fold(0.0, |sum, digit| sum * base + f64::from(digit));
                SideValue::from_interval(Interval::exact(value))
            }
            (NamedOperation::Determinant, rows) => self.determinant(rows)?,
            (NamedOperation::Matrix, rows) => return self.column(rows),
            (_, [n, k]) => self.count_choices(operation, n, k)?,
            _ => return Err(Obstacle::Unclear("an operation without its arguments")),
        };
        self.with_powers(value, cursor)
    }

    /// A falling or rising factorial, written as a power.
    pub(crate) fn factorial_power(
        &mut self,
        base: &SideValue,
        operation: NamedOperation,
        count: &[Token],
    ) -> Evaluated<SideValue> {
        let count = self.in_points(|inside| inside.evaluate_all(count))?;
        let (n, k) = (integer(base)?, integer(&count)?);
        let step = if operation == NamedOperation::Falling { -1.0 } else { 1.0 };
        let value = product_of(n, k, step)?;
        if !value.is_finite() {
            return Err(Obstacle::TooLarge);
        }
        Ok(computed(value, base.operations + count.operations))
    }

    /// Both ends of what is around a value: 5 ± 2 from 3 to 7, and 5 ∓ 2 the other way round.
    pub(crate) fn spread(&mut self, middle: &SideValue, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        let obstacle = Obstacle::Unclear("an uncertainty");
        let plus = cursor.peek().is_some_and(|token| token.is_sign('±'));
        cursor.at += 1;
        let by = self.product(cursor)?;
        let ends = cursor.peek().is_none();
        // Percentages and units that stand behind both are not told from others, and uncertainties don't add.
        let bare = !middle.has_unit && !by.has_unit && middle.angle.is_none() && by.angle.is_none();
        if !ends || !bare || middle.is_tuple || by.is_tuple || self.spreads {
            return Err(obstacle);
        }
        self.spreads = true;
        let low = middle.sum(&by.clone().negate(), false)?;
        let high = middle.sum(&by, false)?;
        let spread = SideValue::from_components(&if plus { [low, high] } else { [high, low] })?;
        Ok(SideValue { literal: Literal::No, ..spread })
    }

    fn count_choices(&mut self, operation: NamedOperation, n: &[Token], k: &[Token]) -> Evaluated<SideValue> {
        let of = self.in_points(|inside| inside.evaluate_all(n))?;
        let operations = of.operations;
        let is_count = integer(&of).is_ok_and(|n| n >= 0.0);
        if operation == NamedOperation::Binomial && !is_count && !of.has_unit {
            let k = self.in_points(|inside| inside.evaluate_all(k))?;
            return Ok(computed(generalised_binomial(of.number()?.point, integer(&k)?)?, operations));
        }
        let n = integer(&of)?;
        let mut chosen = Vec::new();
        for piece in listed(k) {
            let value = self.in_points(|inside| inside.evaluate_all(piece))?;
            chosen.push(integer(&value)?);
        }
        let value = match (operation, chosen.as_slice()) {
            (NamedOperation::Binomial, [k]) => binomial(n, *k)?,
            (NamedOperation::Binomial, all) if all.iter().sum::<f64>() == n => {
                let (mut left, mut product) = (n, 1.0);
                for k in all {
                    product *= binomial(left, *k)?;
                    left -= k;
                }
                product
            }
            (NamedOperation::Permutations, [k]) if *k > n || n < 0.0 => 0.0,
            (NamedOperation::Permutations | NamedOperation::Falling, [k]) => product_of(n, *k, -1.0)?,
            (NamedOperation::Rising, [k]) => product_of(n, *k, 1.0)?,
            _ => return Err(Obstacle::Unclear("an operation without its arguments")),
        };
        let value = computed(value, operations);
        if value.number()?.is_finite() { Ok(value) } else { Err(Obstacle::TooLarge) }
    }

    /// A sum or product over an index of what follows.
    fn over_index(
        &mut self,
        operation: NamedOperation,
        [index, first, last]: [&[Token]; 3],
        cursor: &mut Cursor<'_>,
    ) -> Evaluated<SideValue> {
        let [Token { kind: TokenKind::Name(index), .. }] = trim_space(index) else {
            return Err(Obstacle::Unclear("a sum without an index"));
        };
        let depth = self.local.len();
        if depth > 1 || self.local.iter().any(|(of, _)| of == index) {
            return Err(Obstacle::Unclear("a sum inside a sum"));
        }
        let most = if depth == 0 { MOST_TERMS } else { MOST_TERMS_INSIDE };
        let limits = [first, last].map(|limit| self.in_points(|inside| inside.evaluate_all(limit)));
        let [first, last] = limits;
        let (first, last) = (integer(&first?)?, integer(&last?)?);
        if last - first >= most || last < first {
            return Err(Obstacle::TooLarge);
        }
        let start = *cursor;
        let mut total: Option<SideValue> = None;
        for at in first as i64..=last as i64 {
            let mut body = start;
            self.local.push((index.clone(), computed(at as f64, 0)));
            let term = self.body(&mut body);
            self.local.truncate(depth);
            let term = term?;
            *cursor = body;
            total = Some(match total {
                None => term,
                Some(so_far) if operation == NamedOperation::Sum => so_far.sum(&term, false)?,
                Some(so_far) => so_far.product(&term, Some('·'), true)?,
            });
        }
        let mut total = total.ok_or(Obstacle::TooLarge)?;
        total.operations = total.operations.saturating_add(1);
        total.literal = Literal::No;
        Ok(total)
    }

    /// What is summed: one product, or all that follows.
    fn body(&mut self, cursor: &mut Cursor<'_>) -> Evaluated<SideValue> {
        let value = self.product(cursor)?;
        if !cursor.peek().is_some_and(|token| token.is_one_of("+-")) {
            return Ok(value);
        }
        self.noticed.insert(ReadingChoices::SUM_OF_ALL);
        if !self.is_chosen(ReadingChoices::SUM_OF_ALL) {
            return Ok(value);
        }
        let rest = self.evaluate_all(&cursor.tokens[cursor.at..])?;
        cursor.at = cursor.tokens.len();
        value.sum(&rest, false)
    }

    /// The components of a tuple, an interval or a vector of two or three numbers; none if there is no list in the brackets.
    pub(crate) fn tuple(&mut self, inner: &[Token], is_set: bool) -> Evaluated<Option<SideValue>> {
        let pieces = listed(inner);
        if pieces.len() == 1 {
            return Ok(None);
        }
        if is_set {
            return Err(Obstacle::Unclear("a set"));
        }
        if pieces.len() > 3 {
            return Err(Obstacle::Unclear("a list of more than three numbers"));
        }
        let mut values = Vec::new();
        for piece in pieces {
            values.push(self.evaluate_all(piece)?);
        }
        SideValue::from_components(&values).map(Some)
    }

    /// A row or column of two or three numbers.
    fn column(&mut self, rows: &[Vec<Token>]) -> Evaluated<SideValue> {
        let cells: Vec<&[Token]> =
            rows.iter().flat_map(|row| row.split(|token| token.kind == TokenKind::Cell)).collect();
        if !(2..=3).contains(&cells.len()) || (rows.len() > 1 && cells.len() > rows.len()) {
            return Err(Obstacle::Unclear("a matrix"));
        }
        let mut values = Vec::new();
        for cell in cells {
            values.push(self.evaluate_all(cell)?);
        }
        SideValue::from_components(&values)
    }

    /// The determinant of the rows, whose cells are parted.
    fn determinant(&mut self, rows: &[Vec<Token>]) -> Evaluated<SideValue> {
        let mut cells = Vec::new();
        for row in rows {
            let mut values = Vec::new();
            for cell in row.split(|token| token.kind == TokenKind::Cell) {
                values.push(self.evaluate_all(cell)?);
            }
            cells.push(values);
        }
        let size = cells.len();
        if size == 0 || size > MOST_ROWS || cells.iter().any(|row| row.len() != size) {
            return Err(Obstacle::Unclear("a determinant of what is no small square"));
        }
        let all: Vec<usize> = (0..size).collect();
        let mut value = minor(&cells, 0, &all)?;
        value.operations = value.operations.saturating_add(1);
        value.literal = Literal::No;
        Ok(value)
    }
}

/// The determinant of the rows from one on and of these columns.
fn minor(cells: &[Vec<SideValue>], from: usize, columns: &[usize]) -> Evaluated<SideValue> {
    let mut sum: Option<SideValue> = None;
    for (which, column) in columns.iter().enumerate() {
        let Some(cell) = cells.get(from).and_then(|row| row.get(*column)) else {
            return Err(Obstacle::Unclear("a determinant of what is no small square"));
        };
        let mut term = cell.clone();
        if columns.len() > 1 {
            let rest: Vec<usize> = columns.iter().filter(|of| *of != column).copied().collect();
            term = term.product(&minor(cells, from + 1, &rest)?, Some('·'), true)?;
        }
        let term = if which % 2 == 0 { term } else { term.negate() };
        sum = Some(match sum {
            None => term,
            Some(sum) => sum.sum(&term, false)?,
        });
    }
    sum.ok_or(Obstacle::NoNumber)
}
