//! What digits that were lost on the way explain: rounded steps, results that are cut off, a last digit that differs.

use crate::decimal::parse_decimal;
use crate::evaluate::step_rounding::significant_digits;
use crate::evaluate::value::SideValue;
use crate::token::{Token, TokenKind, any};

/// How many significant digits are printed.
pub(super) fn significant(digits: &str) -> usize {
    digits.trim_start_matches(['0', '.', ',']).chars().filter(char::is_ascii_digit).count()
}

/// The most significant digits of a decimal number anywhere in these tokens.
pub(super) fn most_digits(tokens: &[Token]) -> usize {
    let own = |token: &Token| {
        let digits = token.number().filter(|digits| digits.contains('.'));
        digits.map_or(0, significant)
    };
    let inner = |token: &Token| token.inner().map(most_digits).max().unwrap_or(0);
    tokens.iter().map(|token| own(token).max(inner(token))).max().unwrap_or(0)
}

/// The most digits of a number anywhere in these tokens, without the zeros at either end of a whole one.
pub(super) fn most_digits_of_any(tokens: &[Token]) -> usize {
    let own = |token: &Token| {
        let digits = token.number().unwrap_or_default();
        significant(if digits.contains('.') { digits } else { digits.trim_end_matches(['0', ',']) })
    };
    let inner = |token: &Token| token.inner().map(most_digits_of_any).max().unwrap_or(0);
    tokens.iter().map(|token| own(token).max(inner(token))).max().unwrap_or(0)
}

/// Terms of a sum whose rounding easily changes its last digit.
const MANY_TERMS: usize = 6;
/// Decimals behind which a half is rounded up on both sides of a difference from a whole number: 15 − 6.71875 = 8.28125.
const MANY_DECIMALS: usize = 4;

/// Whether the last digit of a sum may be one off by the rounding of its terms: of many decimals, or of one whose next digit was just a five,
/// which is rounded up in it and in the result.
pub(super) fn may_have_rounded_terms(side: &[Token], computed: &SideValue, printed: &SideValue) -> bool {
    let (Ok(computed), Ok(printed)) = (computed.number(), printed.number()) else { return false };
    let unit = 2.0 * printed.half_width();
    let excess = (printed.point - computed.point) / unit;
    if !is_plain_sum(side) || (excess.abs() - 1.0).abs() > 1e-6 {
        return false;
    }
    let decimals = |token: &Token| token.number()?.split_once('.').map(|(_, behind)| behind.len());
    let terms: Vec<usize> = side.iter().filter_map(decimals).collect();
    let numbers = side.iter().filter(|token| token.number().is_some()).count();
    let subtracts = side.iter().any(|token| token.is_sign('-'));
    // The five is the last digit of some part of a power of two.
    let ends_in_five = |token: &Token| {
        let value = token.number().and_then(parse_decimal).zip(decimals(token));
        value.is_some_and(|(value, places)| {
            let exact = value - 0.5 * libm::exp10(-(places as f64));
            let parts = exact * libm::exp2(places as f64 + 1.0);
            (parts - libm::round(parts)).abs() < 1e-6
        })
    };
    let is_of_half = || {
        matches!(terms.as_slice(), [one] if *one >= MANY_DECIMALS)
            && numbers == 2
            && subtracts
            && excess > 0.0
            && side.iter().any(ends_in_five)
    };
    terms.len() >= MANY_TERMS || is_of_half()
}

/// What explains a difference by digits that were lost on the way. Their errors hardly ever all point the same way.
#[derive(Clone, Copy)]
pub(super) struct StepLikelihood {
    /// How much the difference may be of what all the steps together leave open.
    pub(super) share: f64,
    /// How much it may be if it is about one unit of the last digit; none if that is nothing special.
    pub(super) of_one_digit: Option<f64>,
}

impl StepLikelihood {
    pub(super) fn explains(self, open: &[SideValue; 2], points: &[SideValue; 2], literal: [bool; 2]) -> bool {
        let (computed, printed) = match literal {
            [false, true] => (0, 1),
            [true, false] => (1, 0),
            [false, false] | [true, true] if self.of_one_digit.is_none() => (0, 1),
            _ => return true,
        };
        let differences = points[computed].parts.pairs(&points[printed].parts).map(|(a, b)| (a.point - b.point).abs());
        let halves = open[computed].parts.pairs(&open[printed].parts).map(|(a, b)| (a.half_width(), b.half_width()));
        differences.zip(halves).all(|(difference, (steps, digits))| {
            let open = steps + digits;
            let is_one_digit =
                |share: f64| difference <= 3.0001 * digits && (share.is_infinite() || difference <= share * open);
            digits == 0.0 || self.of_one_digit.is_some_and(is_one_digit) || difference <= self.share * open
        })
    }
}

/// Whether two points are within so many half units of the printed one's last digit.
pub(super) fn is_within(points: &[SideValue; 2], printed: &SideValue, halves: f64) -> bool {
    let differences = points[0].parts.pairs(&points[1].parts).map(|(a, b)| (a.point - b.point).abs());
    let printed = printed.parts.0.iter().flatten().map(|part| part.half_width());
    differences.zip(printed).all(|(difference, half)| difference <= halves * half)
}

/// Whether a printed result is as coarse as its integers would be if they were rounded; a finer one shows that they are exact.
pub(super) fn is_as_coarse([left, right]: &[SideValue; 2], literal: [bool; 2]) -> bool {
    let (computed, printed) = match literal {
        [false, true] => (left, right),
        [true, false] => (right, left),
        _ => return true,
    };
    let halves = computed.parts.pairs(&printed.parts).map(|(a, b)| (a.half_width(), b.half_width()));
    halves.into_iter().all(|(steps, digits)| digits == 0.0 || steps <= FINEST * digits)
}

/// How much of a value its digits leave open.
pub(super) fn relative_width(value: &SideValue) -> f64 {
    value.number().map_or(0.0, |of| if of.point == 0.0 { 1.0 } else { of.half_width() / of.point.abs() })
}

/// How much less a conversion may leave open than the quantity that is converted.
pub(super) const FEWER_DIGITS: f64 = 0.1;

/// How many times finer than its rounded integers a result may be printed.
pub(super) const FINEST: f64 = 10.0;

/// How much of what the steps leave open they are expected to use. In University Physics, where steps were rounded, all but
/// three of 73 results stay within it, and half of the planted digits that the whole interval hides are noticed.
pub(super) const LIKELY: f64 = 0.25;
/// How much one unit of the last digit may be of it in arithmetic without units, whose numbers are often exact.
pub(super) const LIKELY_OF_BARE: f64 = 0.6;
/// How much they are expected to use if only integers that were rounded to tens explain a difference.
pub(super) const FROM_TENS: StepLikelihood = StepLikelihood { share: 0.15, of_one_digit: None };

/// Whether cutting `computed` off gives the printed digits.
pub(super) fn is_cut(computed: &SideValue, printed: &SideValue) -> bool {
    let is_bare = !printed.has_unit;
    computed.parts.pairs(&printed.parts).all(|(computed, printed)| {
        let (size, open) = (printed.point.abs(), 2.0 * printed.half_width());
        let beyond = computed.point.abs() - size;
        // What the printed digits hold exactly has nothing to cut off.
        let units = computed.point / open;
        let is_held = is_bare && (units - libm::round(units)).abs() < 1e-9 && computed.half_width() == 0.0;
        let is_whole = is_bare && computed.half_width() == 0.0 && computed.point.fract() == 0.0;
        open > 0.0
            && !is_held
            && !(is_whole && printed.point.fract() == 0.0)
            && computed.point * printed.point >= 0.0
            && beyond >= -1e-9 * size
            && beyond < (1.0 - 1e-9) * open
    })
}

/// Whether a printed result has three digits or more.
pub(super) fn is_exact(printed: &SideValue) -> bool {
    printed.parts.0.iter().flatten().all(|part| part.half_width() > 0.0 && part.half_width() < 0.05 * part.point.abs())
}

/// Whether a printed result has three significant digits or more.
pub(super) fn has_three_digits(printed: &SideValue) -> bool {
    printed.parts.0.iter().flatten().all(|part| significant_digits(*part).is_none_or(|digits| digits >= 3))
}

/// Whether a computed value is within one more unit of the last printed digit.
pub(super) fn is_near(computed: &SideValue, printed: &SideValue) -> bool {
    computed.parts.pairs(&printed.parts).all(|(computed, printed)| {
        let more = 2.0001 * printed.half_width();
        more <= printed.point.abs() && computed.high >= printed.low - more && computed.low <= printed.high + more
    })
}

/// Whether two numbers are of about the same size, so that no prefix of a unit is between them.
pub(super) fn are_near(left: &SideValue, right: &SideValue) -> bool {
    let size = |of: &SideValue| of.number().map_or(0.0, |number| number.point.abs());
    (0.5..2.0).contains(&(size(left) / size(right)))
}

/// Whether a side only adds and subtracts printed numbers, so that nothing is rounded on the way.
pub(super) fn is_plain_sum(side: &[Token]) -> bool {
    let is_term = |token: &Token| match &token.kind {
        TokenKind::Number(_) | TokenKind::Word(_) | TokenKind::Space(_) | TokenKind::Basis(_) => true,
        TokenKind::Operator(c) => "+-±()[]|,;".contains(*c),
        _ => false,
    };
    let products =
        side.windows(2).any(|pair| pair[1].is_one_of("([") && !pair[0].is_one_of("+-([") && !pair[0].is_space());
    side.iter().all(is_term) && side.iter().any(|token| token.is_one_of("+-±")) && !products
}

/// Whether a side is a round expression, as in 0.0198 ≈ 1/50 and 2498 ≈ 50².
pub(super) fn is_round(side: &[Token]) -> bool {
    let decimal = |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if digits.contains('.'));
    side.len() > 1 && !any(side, &decimal)
}

/// Whether all units of one side are among those of another one.
pub(super) fn has_words_of(side: &[Token], other: &[Token]) -> bool {
    side.iter().filter_map(Token::word).all(|word| other.iter().any(|token| token.word() == Some(word)))
}
