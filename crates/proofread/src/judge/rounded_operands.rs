//! Results that rounded numbers leave open: the digits that are printed do not give them, but digits that round to these do.
//!
//! A few shapes of chains were more often rounded than wrong at first contact; the counts are in `judged/README.md`. Whole numbers and sums of
//! money are exact, so that a difference which only their digits explain still counts.

use crate::decimal::parse_decimal;
use crate::evaluate::expression::Evaluator;
use crate::evaluate::numeral::{with_digits, with_shared_exact};
use crate::evaluate::printed::Mode;
use crate::evaluate::value::SideValue;
use crate::judge::doubt::PlacedPair;
use crate::judge::lost_digits::{is_plain_sum, significant};
use crate::judge::money::has_money;
use crate::judge::substitution::without_space;
use crate::judge::surroundings::speaks_around;
use crate::judge::verdict::PairJudgement;
use crate::token::{MathFunction, Token, TokenKind};

/// Decimals of a term from which on it was hardly given as it is: shares, probabilities, means.
const COMPUTED: usize = 3;

/// Significant digits of a result from which on its last one is no large part of it.
const THREE: usize = 3;

/// How small a difference is beside its terms if it lost digits.
const SMALL: f64 = 0.3;

/// How far a result is from the computed value at most, in units of its last digit.
const NEAR: f64 = 2.3;

/// How far a product of rounded numbers is from its result at most, in units of the last digit.
const NEAR_OF_PRODUCT: f64 = 2.0;

/// How far two sides are apart at most, relative to them, if the text puts it down to rounding.
const SLIGHT: f64 = 0.01;

/// A computed side and the number that is compared with it.
struct OpenResult<'t> {
    computed: &'t [Token],
    /// The digits of the result.
    printed: String,
    /// How far the sides are apart, in units of the last digit of the result.
    units: f64,
    /// The size of the result.
    size: f64,
}

impl PlacedPair<'_> {
    /// Whether other digits of the rounded numbers in a side give the other one, in one of the shapes in which that is likelier than an
    /// error.
    pub(crate) fn may_be_of_rounded_numbers(&self, judgement: &PairJudgement) -> bool {
        let Some((left, right)) = &judgement.values else { return false };
        // The terms of a multiple may lack the unit of the result.
        let is_multiple = is_multiple_of_sum(&self.left.tokens);
        if (left.dimension != right.dimension && !is_multiple) || !judgement.used.is_empty() {
            return false;
        }
        if left.difference(right) < SLIGHT && self.is_put_down_to_rounding() {
            return true;
        }
        if has_money(&self.left.tokens) || has_money(&self.right.tokens) {
            return false;
        }
        let Some(result) = self.open_result(judgement, left, right) else { return false };
        let decimals = decimals_in(result.computed);
        let digits = significant(&result.printed);
        let fewest = decimals.iter().map(|of| significant(of)).min().unwrap_or(0);
        if is_plain_sum(result.computed) {
            let most = decimals.iter().map(|of| places(of)).max().unwrap_or(0);
            let of_shares = most >= COMPUTED
                && !left.has_unit
                && !right.has_unit
                && places(&result.printed) == most
                && decimals.iter().filter(|of| places(of) >= COMPUTED).count() > 1
                && result.units < 1.001;
            let largest = decimals.iter().filter_map(|of| parse_decimal(of)).fold(0.0, f64::max);
            let lost = decimals.len() > 1 && places(&result.printed) > most && result.size < SMALL * largest;
            return of_shares || lost;
        }
        if is_multiple && result.units < 1.001 {
            let most = decimals.iter().map(|of| places(of)).max().unwrap_or(0);
            return most >= COMPUTED && places(&result.printed) == most;
        }
        // Two digits of a result hold nearly anything.
        if digits < THREE {
            return has_open_exponent(result.computed) && result.units < NEAR;
        }
        let is_square = squares_in(result.computed).iter().any(|of| significant(of) >= digits);
        let is_product = decimals.len() > 1 && result.units < NEAR_OF_PRODUCT;
        (has_open_exponent(result.computed) && result.units < NEAR)
            || (fewest >= digits && ((is_square && result.units < NEAR) || is_product))
    }

    /// The result of these sides, if it is open within the digits of the decimals before it.
    fn open_result(&self, judgement: &PairJudgement, left: &SideValue, right: &SideValue) -> Option<OpenResult<'_>> {
        let [one, other] = [&self.left.tokens, &self.right.tokens].map(Vec::as_slice);
        let (computed, result) = if left.is_literal() { (other, one) } else { (one, other) };
        if left.is_literal() && right.is_literal() {
            return None;
        }
        let [computed_open, result_open] = match with_shared_exact([computed, result]) {
            Some(sides) => sides,
            None => [computed.to_vec(), result.to_vec()],
        };
        let open = |tokens: &[Token], mode: Mode| {
            let exact = with_whole_numbers_exact(tokens);
            Evaluator::new(mode, judgement.reading, None).evaluate_side(exact.as_deref().unwrap_or(tokens)).ok()
        };
        let is_printed = left.is_literal() || right.is_literal();
        let computed_value = open(&computed_open, Mode::Strict)?;
        let result_value = if is_printed {
            Evaluator::new(Mode::Result, judgement.reading, None).evaluate_side(result).ok()?
        } else {
            open(&result_open, Mode::Strict)?
        };
        if !computed_value.meets(&result_value, 0.0) {
            return None;
        }
        let half = result_value.number().ok()?.half_width();
        let (left, right) = (left.number().ok()?, right.number().ok()?);
        // The numbers that only the result has.
        let before = numbers_in(computed);
        let mut own = numbers_in(result).into_iter().filter(|of| !before.contains(of));
        let printed = own.next()?;
        let size = if is_printed { parse_decimal(&printed)? } else { f64::INFINITY };
        (own.all(|of| is_printed && of == "10") && half > 0.0).then(|| OpenResult {
            computed,
            size,
            units: (left.point - right.point).abs() / (2.0 * half),
            printed,
        })
    }

    /// Whether the text near the formula says that the difference comes from rounding.
    fn is_put_down_to_rounding(&self) -> bool {
        const WORDS: [&str; 8] = [
            "rounding error",
            "rounding difference",
            "due to rounding",
            "because of rounding",
            "not rounded",
            "unrounded",
            "without rounding",
            "before rounding",
        ];
        speaks_around(self.text, self.formula.span, &WORDS)
    }
}

/// Whether a side is a whole number times a sum of decimals: 2(0.783 + 0.026).
fn is_multiple_of_sum(side: &[Token]) -> bool {
    let solid = without_space(side);
    let (factor, open, sum, close) = match solid.as_slice() {
        [factor, sign, open, sum @ .., close] if sign.is_one_of("·×") => (factor, open, sum, close),
        [factor, open, sum @ .., close] => (factor, open, sum, close),
        _ => return false,
    };
    let is_term = |(at, token): (usize, &&Token)| match at % 2 {
        0 => token.number().is_some_and(|digits| digits.contains('.')),
        _ => token.is_one_of("+-"),
    };
    factor.number().is_some_and(|digits| !digits.contains('.'))
        && open.is_sign('(')
        && close.is_sign(')')
        && sum.len() > 2
        && sum.iter().enumerate().all(is_term)
}

/// A side with its whole numbers exact; none if it has none.
fn with_whole_numbers_exact(side: &[Token]) -> Option<Vec<Token>> {
    with_digits(side, &|number| {
        let whole = number.power.is_none() && !number.digits.contains(['.', '…']);
        (whole && number.digits.len() > 2).then(|| format!("{}.{:0<12}", number.digits, ""))
    })
}

/// All numbers that are printed in these tokens, in their order.
fn numbers_in(tokens: &[Token]) -> Vec<String> {
    let mut out = Vec::new();
    collect(tokens, &mut |token| out.extend(token.number().map(|digits| digits.replace(',', ""))));
    out
}

/// The numbers with decimals.
fn decimals_in(tokens: &[Token]) -> Vec<String> {
    numbers_in(tokens).into_iter().filter(|digits| digits.contains('.')).collect()
}

/// The decimals that are squared.
fn squares_in(tokens: &[Token]) -> Vec<String> {
    let is_two = |token: &Token| matches!(&token.kind, TokenKind::Power(power) if matches!(power.as_slice(), [two] if two.number() == Some("2")));
    let mut out = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        token.inner().for_each(|inner| out.extend(squares_in(inner)));
        let before = |back: usize| at.checked_sub(back).map(|at| &tokens[at]);
        let base = match (before(1), before(2)) {
            (Some(close), Some(number)) if close.is_sign(')') => Some(number),
            (base, _) => base,
        };
        if is_two(token)
            && let Some(digits) = base.and_then(Token::number)
            && digits.contains('.')
        {
            out.push(digits.to_owned());
        }
    }
    out
}

/// Whether a power of e has an exponent with two significant digits or more behind a point.
fn has_open_exponent(tokens: &[Token]) -> bool {
    let is_open = |inside: &[Token]| decimals_in(inside).iter().any(|of| significant(of) > 1);
    let is_e = |token: &Token| match &token.kind {
        TokenKind::Name(name) | TokenKind::Word(name) => name == "e",
        _ => false,
    };
    let is_raised = |of: &[Token]| is_e(&of[0]) && matches!(&of[1].kind, TokenKind::Power(power) if is_open(power));
    let exp = tokens.iter().position(|token| token.kind == TokenKind::Function(MathFunction::Exp));
    let here = tokens.windows(2).any(is_raised) || exp.is_some_and(|at| is_open(&tokens[at..]));
    here || tokens.iter().any(|token| token.inner().any(has_open_exponent))
}

fn collect(tokens: &[Token], each: &mut dyn FnMut(&Token)) {
    for token in tokens {
        each(token);
        token.inner().for_each(|inner| collect(inner, each));
    }
}

/// How many digits stand behind the point.
fn places(digits: &str) -> usize {
    digits.split_once('.').map_or(0, |(_, behind)| behind.chars().filter(char::is_ascii_digit).count())
}
