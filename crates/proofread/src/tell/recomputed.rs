//! What is computed, in the form of what is printed: with as many digits, in its unit, as a fraction or as a power of ten.

use crate::decimal::{fixed, parse_decimal, scientific};
use crate::evaluate::atom::large_number;
use crate::evaluate::exponent::{plain_exponent, small_integer};
use crate::evaluate::expression::Evaluator;
use crate::evaluate::printed::{Mode, power_of_ten};
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::{AngleUnit, Obstacle, SideValue};
use crate::join::chain::{ChainSide, Relation};
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::section::ReportSection;
use crate::judge::verdict::{PairJudgement, evaluate_freely, judge};
use crate::tell::number_form::{part_thousands, power_form, rational, signed, significant, sized};
use crate::token::{Span, Token, TokenKind, show, span_of};
use crate::unit::currency;

/// What is told of the values of two sides.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct RecomputedValue {
    /// The computed value in the form of the printed one, or what both sides give if none is printed.
    pub shown: Option<String>,
    /// The printed value over the computed one, dimensionless.
    pub factor: Option<f64>,
    /// In which way they differ, in words, where that helps.
    pub difference: Option<String>,
}

/// Two sides of which one is printed and the other one computed.
pub(crate) struct PrintedPair<'p> {
    pub computed: &'p ChainSide,
    pub printed: &'p ChainSide,
    /// Whether the printed side is the right one.
    pub right_is_printed: bool,
    pub judgement: &'p PairJudgement,
}

/// Where sizes differ so much, the factor says more than the digits.
const TELLING_FACTOR: f64 = 1.5;

/// Digits that are tried one after the other until the two sides are shown as what they are.
const MORE_DIGITS: [usize; 6] = [0, 1, 2, 4, 7, 12];

impl PrintedPair<'_> {
    /// What is told of a pair on a section of the report.
    pub(crate) fn recomputed(&self, section: ReportSection) -> RecomputedValue {
        let Some((left, right)) = self.judgement.values.as_ref() else { return self.without_value() };
        let (computed, printed) = if self.right_is_printed { (left, right) } else { (right, left) };
        if computed.parts.is_vector() || printed.parts.is_vector() {
            let shown = self.in_other_words(|digits| components(computed, digits));
            return RecomputedValue { shown, ..RecomputedValue::default() };
        }
        // Zero is compared with whatever it is, so its dimension may be another one, too.
        let alike = computed.dimension == printed.dimension || self.judgement.reading.contains(ReadingChoices::NUMBERS);
        if matches!(self.judgement.verdict, ChainVerdict::Units | ChainVerdict::Dimensions) || !alike {
            let shown = self.in_own_unit();
            let what = match self.judgement.verdict {
                ChainVerdict::Units => Some("the units differ"),
                ChainVerdict::Dimensions => Some("the dimensions differ"),
                _ => None,
            };
            let difference = what.map(str::to_owned);
            return RecomputedValue { shown, difference, ..RecomputedValue::default() };
        }
        let (Ok(of_computed), Ok(of_printed)) = (computed.number(), printed.number()) else {
            return RecomputedValue::default();
        };
        let (value, printed_value) = (of_computed.point, of_printed.point);
        if !value.is_finite() || !printed_value.is_finite() {
            return RecomputedValue::default();
        }
        let on_scale = self.judgement.reading.contains(ReadingChoices::POINTS);
        let factor = Some(printed_value / value)
            .filter(|_| !on_scale && self.judgement.verdict != ChainVerdict::Consistent)
            .filter(|factor| factor.is_finite() && *factor != 0.0)
            .map(rounded);
        let differs = section != ReportSection::Agreeing;
        let difference = factor.and_then(difference_in_words).filter(|_| differs);
        if let Some(number) =
            PrintedNumeral::of(&self.printed.tokens).filter(|of| printed.is_literal() || of.is_price())
        {
            let shown = self.as_numeral(&number, value, printed, differs);
            return RecomputedValue { shown, factor, difference };
        }
        if let Some((shown, decimals)) = self.as_fraction(value, printed_value) {
            let difference = [Some(decimals), difference].into_iter().flatten().collect::<Vec<_>>().join(", ");
            return RecomputedValue { shown: Some(shown), factor, difference: Some(difference) };
        }
        let unit = |side: &SideValue| side.dimension.in_base_units();
        let both = MORE_DIGITS.iter().map(|more| {
            [(value, computed), (printed_value, printed)]
                .map(|(value, side)| format!("{} {}", sized(value, 4 + more), unit(side)).trim().to_owned())
        });
        let shown =
            both.into_iter().find(|[one, other]| one != other).map(|[one, other]| format!("{one} against {other}"));
        RecomputedValue { shown, factor, difference }
    }

    /// The computed value as a number in the place of the printed one.
    fn as_numeral(
        &self,
        number: &PrintedNumeral<'_>,
        value: f64,
        printed: &SideValue,
        differs: bool,
    ) -> Option<String> {
        let mantissa = self.mantissa(number, value, printed)?;
        let own = show(&self.printed.tokens);
        let mut second = None;
        for plain in [number.outgrows_its_word(mantissa), false] {
            for more in MORE_DIGITS {
                let tokens = number.with_value(mantissa, number.digits() + more, plain);
                let shown = show(&tokens);
                if differs && is_same(&shown, &own) {
                    continue;
                }
                let sides = if self.right_is_printed {
                    [self.computed.tokens.as_slice(), &tokens]
                } else {
                    [&tokens, self.computed.tokens.as_slice()]
                };
                if !differs || judge(sides[0], sides[1], Relation::Equal, None).verdict == ChainVerdict::Consistent {
                    return Some(shown);
                }
                second = second.or(Some(shown));
                if !self.judgement.used.is_empty() || self.judgement.explanation.is_some() {
                    break;
                }
            }
        }
        second
    }

    /// Which number in the place of the printed one would give the computed value.
    fn mantissa(&self, number: &PrintedNumeral<'_>, value: f64, printed: &SideValue) -> Option<f64> {
        let at = |digits: &str, is_negative: bool| {
            let tokens = number.with_digits(digits, is_negative);
            let mut evaluator = Evaluator::new(Mode::Point, self.judgement.reading, None);
            let side = evaluator.evaluate_side(&tokens).ok()?;
            Some((side.number().ok()?.point, side.dimension))
        };
        let point = printed.number().ok()?.point;
        let is_as_printed = at(number.text, number.is_negative).is_some_and(|(own, dimension)| {
            dimension == printed.dimension && (own.abs() - point.abs()).abs() <= 1e-9 * point.abs()
        });
        let line = at("3", false).zip(at("4", false)).filter(|_| is_as_printed);
        let mantissa = match line {
            // In a unit that begins at zero, all digits of a value that is far smaller count.
            Some(((three, _), (four, _))) if (four / three - 4.0 / 3.0).abs() < 1e-9 => value / (four - three),
            Some(((three, _), (four, _))) if three != four => 3.0 + (value - three) / (four - three),
            _ if point != 0.0 => number.value * value / point,
            _ => value / if printed.factor == 0.0 { 1.0 } else { printed.factor },
        };
        mantissa.is_finite().then_some(mantissa)
    }

    /// The computed value as a fraction, if the printed one is one, and both as decimals.
    fn as_fraction(&self, value: f64, printed: f64) -> Option<(String, String)> {
        let fraction = PrintedFraction::of(&self.printed.tokens)?;
        let own = fraction.value();
        let unit = if own == 0.0 || printed == 0.0 { 1.0 } else { (printed / own).abs() };
        let unit = if unit.is_finite() && unit != 0.0 { unit } else { 1.0 };
        let (value, own) = (value / unit, printed / unit);
        let decimal = |value: f64, digits: usize| match (1e-4..1e6).contains(&value.abs()) {
            true => signed(significant(value.abs(), digits, true), value < 0.0),
            false => sized(value, digits),
        };
        let decimals = MORE_DIGITS.iter().map(|more| [value, own].map(|value| decimal(value, 3 + more)));
        let [decimal, other] = decimals.into_iter().find(|[one, other]| one != other)?;
        let rest = show(fraction.rest);
        let shown = match rational(value) {
            Some((above, below)) => fraction.with_value(above, below),
            None => decimal.clone(),
        };
        let shown =
            if rest.is_empty() || rest.starts_with(['°', '%']) { shown + &rest } else { format!("{shown} {rest}") };
        Some((shown, format!("{decimal} against {other}")))
    }

    /// The computed value in base units, with the digits of the printed one.
    fn in_own_unit(&self) -> Option<String> {
        let reading = self.judgement.reading;
        let all = reading.subsets(16).into_iter().rev().find(|of| !of.contains(ReadingChoices::NUMBERS));
        let evaluated = Evaluator::new(Mode::Point, all.unwrap_or_default(), None).evaluate_side(&self.computed.tokens);
        let side = evaluated.or_else(|_| evaluate_freely(&self.computed.tokens, None)).ok()?;
        let value = side.number().ok()?.point;
        let digits = PrintedNumeral::of(&self.printed.tokens).map_or(3, |number| number.digits());
        self.in_other_words(|more| match side.angle.filter(|_| side.dimension.is_none()) {
            Some(AngleUnit::Degrees) => format!("{}°", sized(value.to_degrees(), digits + more)),
            Some(AngleUnit::Radians) => format!("{} rad", sized(value, digits + more)),
            None => format!("{} {}", sized(value, digits + more), side.dimension.in_base_units()).trim().to_owned(),
        })
    }

    /// The first of several ways to show a value that is not what is printed.
    fn in_other_words(&self, shown: impl Fn(usize) -> String) -> Option<String> {
        let own = show(&self.printed.tokens);
        MORE_DIGITS.iter().map(|more| shown(*more)).find(|shown| !is_same(shown, &own))
    }

    /// What is told where a side has no value.
    fn without_value(&self) -> RecomputedValue {
        let name = |is_printed: bool| if is_printed == self.right_is_printed { "right" } else { "left" };
        let value =
            |side: &ChainSide| Evaluator::new(Mode::Point, ReadingChoices::USUAL, None).evaluate_side(&side.tokens);
        let (printed, computed) = (value(self.printed), value(self.computed));
        let what = |obstacle: &Obstacle| match obstacle {
            Obstacle::NoValue(_) => Some("has no value"),
            Obstacle::MixedSum => Some("has no unit"),
            _ => None,
        };
        let (lacks, has) = match (&computed, &printed) {
            (Err(why), other) => (what(why).map(|what| (false, what)), other.as_ref().ok()),
            (other, Err(why)) => (what(why).map(|what| (true, what)), other.as_ref().ok()),
            _ => (None, None),
        };
        let difference = lacks.map(|(is_printed, what)| {
            let other = has.filter(|side| is_printed || !side.is_literal()).and_then(|side| {
                let value = side.number().ok().filter(|value| value.is_finite())?.point;
                let value = format!("{} {}", sized(value, 4), side.dimension.in_base_units());
                Some(format!(", and the {} side gives {}", name(!is_printed), value.trim()))
            });
            format!("the {} side {what}{}", name(is_printed), other.unwrap_or_default())
        });
        RecomputedValue { difference, ..RecomputedValue::default() }
    }
}

/// Whether two values are shown by the same characters, but for space.
fn is_same(one: &str, other: &str) -> bool {
    let squeezed = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
    squeezed(one) == squeezed(other)
}

/// A factor to six digits: what is behind them is the error of the printed digits.
fn rounded(factor: f64) -> f64 {
    parse_decimal(&scientific(factor, 5)).unwrap_or(factor)
}

/// How far apart two values are, if a factor or a sign says more than their digits.
fn difference_in_words(factor: f64) -> Option<String> {
    let size = factor.abs().max(1.0 / factor.abs());
    let by = (size >= TELLING_FACTOR * 0.999).then(|| format!("a factor of {}", factor_in_words(size)));
    match (factor < 0.0, by) {
        (true, Some(by)) => Some(format!("the sign differs, and {by}")),
        (true, None) => Some("the sign differs".to_owned()),
        (false, by) => by,
    }
}

/// A factor of 1 or more with three digits: a whole number with its thousands parted, or a power of ten.
fn factor_in_words(size: f64) -> String {
    let power = libm::round(libm::log10(size));
    let is_power = (size / power_of_ten(power) - 1.0).abs() < 1e-3;
    match is_power {
        true if power > 9.0 => "10^".to_owned() + &fixed(power, 0),
        true => part_thousands(&fixed(power_of_ten(power), 0)),
        false if size >= 1e9 => power_form(size, 3),
        false => part_thousands(&significant(size, 3, true)),
    }
}

/// The components of a vector or a tuple, in base units.
fn components(of: &SideValue, more: usize) -> String {
    let parts = of.parts.0.iter().enumerate().filter_map(|(at, part)| Some((at, part.as_ref()?.point)));
    let unit = of.dimension.in_base_units();
    let shown = if of.is_tuple {
        format!("({})", parts.map(|(_, value)| sized(value, 4 + more)).collect::<Vec<_>>().join(", "))
    } else {
        let names = ["", "î", "ĵ", "k̂"];
        let named = |(at, value): (usize, f64)| sized(value, 4 + more) + names.get(at).unwrap_or(&"");
        let sum = parts.map(named).collect::<Vec<_>>().join(" + ").replace("+ −", "− ");
        if unit.is_empty() { sum } else { format!("({sum})") }
    };
    format!("{shown} {unit}").trim().to_owned()
}

/// A printed number and what stands around it.
struct PrintedNumeral<'t> {
    before: &'t [Token],
    is_negative: bool,
    text: &'t str,
    /// With its sign, without its power of ten.
    value: f64,
    /// The exponent of the ten behind it.
    power: Option<i32>,
    /// A word such as *million* behind it.
    word: Option<&'t Token>,
    behind: &'t [Token],
}

impl<'t> PrintedNumeral<'t> {
    fn of(tokens: &'t [Token]) -> Option<Self> {
        let at = tokens.iter().position(|token| token.number().is_some())?;
        let text = tokens[at].number()?;
        let sign = at.checked_sub(1).filter(|at| tokens[*at].is_one_of("-+"));
        let is_negative = sign.is_some_and(|at| tokens[at].is_sign('-'));
        let before = &tokens[..sign.unwrap_or(at)];
        let is_plain = |token: &Token| token.is_space() || token.word().is_some() || token.is_one_of("$€£([");
        if !before.iter().all(is_plain) {
            return None;
        }
        let exponent = |at: usize| match &tokens.get(at)?.kind {
            TokenKind::Power(exponent) => plain_exponent(exponent).ok().filter(|power| power.fract() == 0.0),
            _ => None,
        };
        let value = parse_decimal(&text.trim_end_matches('…').replace(',', ""))?;
        let value = if is_negative { -value } else { value };
        let new = |value: f64, power: Option<f64>, end: usize| {
            let behind = &tokens[end.min(tokens.len())..];
            let word = behind.iter().position(|token| !token.is_space()).map(|at| &behind[at]);
            let is_large = |token: &&Token| token.word().and_then(large_number).is_some();
            let power = power.map(|power| power as i32);
            Self { before, is_negative, text, value, power, word: word.filter(is_large), behind }
        };
        if text == "10"
            && let Some(power) = exponent(at + 1)
        {
            return Some(new(if is_negative { -1.0 } else { 1.0 }, Some(power), at + 2));
        }
        let mut ahead = (at + 1..tokens.len()).filter(|at| !tokens[*at].is_space());
        let times = ahead.next().filter(|at| tokens[*at].is_one_of("×·*"));
        let ten = times.and_then(|_| ahead.next()).filter(|at| tokens[*at].number() == Some("10"));
        if let Some(ten) = ten
            && let Some(power) = exponent(ten + 1)
        {
            return Some(new(value, Some(power), ten + 2));
        }
        Some(new(value, None, at + 1))
    }

    /// Whether it is a sum of money with its sign before it, which counts as a product.
    fn is_price(&self) -> bool {
        self.before.iter().any(is_money) && self.behind.iter().all(Token::is_space)
    }

    /// Significant digits, at least two.
    fn digits(&self) -> usize {
        let digits: String = self.text.chars().filter(char::is_ascii_digit).collect();
        if self.power.is_some() && self.text == "10" { 2 } else { digits.trim_start_matches('0').len().clamp(2, 15) }
    }

    /// Whether a number is better written without the word behind it: 0.00012 million is no way to write 120.
    fn outgrows_its_word(&self, mantissa: f64) -> bool {
        self.word.is_some() && !(0.01..1e5).contains(&mantissa.abs()) && mantissa != 0.0
    }

    fn tokens_with(&self, is_negative: bool, number: Vec<Token>, behind: &[Token]) -> Vec<Token> {
        let mut tokens = self.before.to_vec();
        if is_negative {
            tokens.push(Token::new(TokenKind::Operator('-'), Span::default()));
        }
        tokens.extend(number);
        tokens.extend_from_slice(behind);
        tokens
    }

    fn power_tokens(&self, mantissa: &str, power: i32) -> Vec<Token> {
        let new = |kind| Token::new(kind, Span::default());
        let mut exponent = Vec::new();
        if power < 0 {
            exponent.push(new(TokenKind::Operator('-')));
        }
        exponent.push(new(TokenKind::Number(power.unsigned_abs().to_string())));
        vec![
            new(TokenKind::Number(mantissa.to_owned())),
            new(TokenKind::Operator('×')),
            new(TokenKind::Number("10".to_owned())),
            new(TokenKind::Power(exponent)),
        ]
    }

    /// The side with these digits, and the power of ten as it is.
    fn with_digits(&self, digits: &str, is_negative: bool) -> Vec<Token> {
        let number = match self.power {
            Some(power) => {
                let own = self.text == "10" && digits == "10";
                self.power_tokens(if own { "1" } else { digits }, power)
            }
            None => vec![Token::new(TokenKind::Number(digits.to_owned()), Span::default())],
        };
        self.tokens_with(is_negative, number, self.behind)
    }

    /// The side with another number of so many digits in its place; `plain` leaves the word behind it out.
    fn with_value(&self, mantissa: f64, digits: usize, plain: bool) -> Vec<Token> {
        let is_word = |token: &Token| self.word.is_some_and(|word| std::ptr::eq(word, token));
        let (mantissa, behind) = match self.word.and_then(Token::word).filter(|_| plain) {
            Some(word) => {
                let power = large_number(word).unwrap_or_default();
                let rest = self.behind.iter().position(is_word).map_or(&[][..], |at| &self.behind[at + 1..]);
                (mantissa * power_of_ten(power), rest)
            }
            None => (mantissa, self.behind),
        };
        let size = mantissa.abs();
        let exponent = if size == 0.0 { 0 } else { libm::floor(libm::log10(size)) as i32 };
        let is_negative = mantissa < 0.0;
        if let Some(own) = self.power {
            // The power of ten of the printed number, or the nearest one if that is far off.
            let places = if (-1..=2).contains(&exponent) { 0 } else { exponent };
            let scaled = significant(size / power_of_ten(f64::from(places)), digits, false);
            return self.tokens_with(is_negative, self.power_tokens(&scaled, own + places), behind);
        }
        if size != 0.0 && !(-6..12).contains(&exponent) {
            let scaled = significant(size / power_of_ten(f64::from(exponent)), digits, false);
            return self.tokens_with(is_negative, self.power_tokens(&scaled, exponent), behind);
        }
        let decimals = self.text.split_once('.').map(|(_, behind)| behind.len());
        let whole = (size - libm::round(size)).abs() < 1e-9 * size.max(1.0);
        let text = match decimals {
            None if whole => fixed(size, 0),
            Some(decimals) if self.before.iter().chain(self.behind).any(is_money) && digits <= self.digits() => {
                fixed(size, decimals)
            }
            _ => significant(size, digits, false),
        };
        let text = if self.text.contains(',') { part_thousands(&text) } else { text };
        self.tokens_with(is_negative, vec![Token::new(TokenKind::Number(text), Span::default())], behind)
    }
}

fn is_money(token: &Token) -> bool {
    token.is_one_of("$€£") || token.word().is_some_and(|word| currency(word).is_some())
}

/// A printed fraction of two integers, or a mixed number.
struct PrintedFraction<'t> {
    is_negative: bool,
    whole: Option<f64>,
    above: f64,
    below: f64,
    rest: &'t [Token],
}

impl<'t> PrintedFraction<'t> {
    fn of(tokens: &'t [Token]) -> Option<Self> {
        let (is_negative, tokens) = match tokens {
            [sign, rest @ ..] if sign.is_sign('-') => (true, rest),
            all => (false, all),
        };
        let integer = |token: &Token| small_integer(std::slice::from_ref(token));
        let parts = |whole, token: &Token| match &token.kind {
            TokenKind::Fraction(above, below) => Some((whole, small_integer(above)?, small_integer(below)?)),
            _ => None,
        };
        let ((whole, above, below), rest) = match tokens {
            [first, rest @ ..] if parts(None, first).is_some() => (parts(None, first)?, rest),
            [whole, fraction, rest @ ..] if parts(None, fraction).is_some() => {
                (parts(Some(integer(whole)?), fraction)?, rest)
            }
            [above, stroke, below, rest @ ..] if stroke.is_sign('/') => {
                ((None, integer(above)?, integer(below)?), rest)
            }
            _ => return None,
        };
        let is_unit = |token: &Token| {
            token.is_space()
                || token.word().is_some()
                || token.is_one_of("/·")
                || matches!(token.kind, TokenKind::Power(_))
        };
        let fits = below != 0.0 && rest.iter().all(is_unit) && span_of(tokens) != Span::default();
        fits.then_some(Self { is_negative, whole, above, below, rest })
    }

    fn value(&self) -> f64 {
        let size = self.whole.unwrap_or(0.0) + self.above / self.below;
        if self.is_negative { -size } else { size }
    }

    /// Another fraction in the same manner.
    fn with_value(&self, above: f64, below: f64) -> String {
        let size = above.abs();
        let text = if below == 1.0 {
            fixed(size, 0)
        } else if self.whole.is_some() && size > below {
            format!("{} {}/{}", fixed(libm::floor(size / below), 0), fixed(size % below, 0), fixed(below, 0))
        } else {
            format!("{}/{}", fixed(size, 0), fixed(below, 0))
        };
        signed(text, above < 0.0)
    }
}
