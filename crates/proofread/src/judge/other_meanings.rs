//! Sides that have another meaning than their signs say: two values of one result, a stroke of a fraction with space around it, angles of
//! textbooks, letters that look like units.

use crate::decimal::parse_decimal;
use crate::evaluate::expression::Evaluator;
use crate::evaluate::printed::Mode;
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::SideValue;
use crate::join::chain::ChainSide;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::doubt::PlacedPair;
use crate::judge::other_arithmetic;
use crate::judge::substitution::without_space;
use crate::judge::surroundings;
use crate::judge::verdict::PairJudgement;
use crate::token::{MathFunction, NamedOperation, Token, TokenKind, any, trim_space};
use crate::unit::{is_percent, takes_prefix, unit};

impl PlacedPair<'_> {
    /// Whether the signs of one side or of both may mean something else.
    pub(super) fn has_other_meaning(&self, judgement: &PairJudgement) -> bool {
        let [left, right] = [self.left, self.right].map(|side| side.tokens.as_slice());
        is_estimate_with_exact_value(left, right)
            || [(left, right), (right, left)].into_iter().any(|(side, other)| {
                has_outer_stroke(self.text, side, other)
                    || adds_letters(side)
                    || has_bracketed_prefix(side)
                    || is_of_complement(side, other)
                    || is_change_of_factor(side, other)
            })
            || is_of_rounded_angle(left, right)
            || (judgement.verdict == ChainVerdict::Dimensions
                && (agree_in_minutes(left, right) || has_factor_letter(left) || has_factor_letter(right)))
            || (judgement.verdict == ChainVerdict::Dimensions && self.has_letter_of_physics())
            || has_angstroms(left)
            || has_angstroms(right)
            || self.is_scale_of_drawing()
            || self.adds_points()
            || self.follows_choices()
            || self.has_residue_symbol()
    }

    /// Whether a letter that was taken for a unit names a constant or an element: `2e^2/h`, `81.10 g H`; or ounces are those of fluids.
    fn has_letter_of_physics(&self) -> bool {
        let sides = [self.left, self.right].map(|side| side.tokens.as_slice());
        sides.into_iter().any(|side| has_planck_constant(side) || has_hydrogen(side))
            || agree_in_fluid_ounces(sides[0], sides[1])
    }

    /// Whether the left side is one unit of length and the right one another length, in a section about drawings to scale: `1 cm = 0.5 m`.
    fn is_scale_of_drawing(&self) -> bool {
        const WORDS: [&str; 5] = ["scale drawing", "drawing scale", "drawn to scale", "linear scale", "to scale"];
        let [left, right] = [self.left, self.right].map(|side| without_space(&side.tokens));
        let is_length = |of: &Token| {
            of.word().and_then(unit).is_some_and(|of| unit("m").is_some_and(|m| of.dimension == m.dimension))
        };
        let fits = |of: &[&Token], one: bool| matches!(of, [number, length] if number.number().is_some_and(|of| !one || of == "1") && is_length(length));
        fits(&left, true) && fits(&right, false) && {
            let section = other_arithmetic::section_before(self.text, self.left.span).to_ascii_lowercase();
            WORDS.iter().any(|word| section.contains(word))
        }
    }

    /// Whether points of a curve are added by the law of its group, and not coordinate by coordinate.
    fn adds_points(&self) -> bool {
        const WORDS: [&str; 4] = ["elliptic", "group law", "point addition", "point doubling"];
        let has_points = |side: &ChainSide| {
            side.tokens.iter().any(|of| of.is_sign(',')) && side.tokens.iter().any(|of| of.is_sign('('))
        };
        has_points(self.left)
            && has_points(self.right)
            && surroundings::example_speaks_of(self.text, self.formula.span, &WORDS)
    }

    /// Whether the right side stands in a row below one that has several equations joined by *or*: `x = 2 or x = 3`.
    fn follows_choices(&self) -> bool {
        const WORDS: [&str; 4] = ["or", "oder", "ou", "o"];
        let between = self.text.get(self.left.span.end as usize..self.right.span.start as usize).unwrap_or_default();
        if between.len() > LONGEST || !between.contains("\\\\") {
            return false;
        }
        let before = self.text.get(self.formula.span.start as usize..self.left.span.end as usize).unwrap_or_default();
        let row = before.get(before.ceil_char_boundary(before.len().saturating_sub(LONGEST))..).unwrap_or_default();
        let row = row.rsplit("\\\\").next().unwrap_or_default();
        let mut braced = row.split('{').skip(1).filter_map(|behind| behind.split_once('}'));
        braced.any(|(inside, _)| WORDS.contains(&inside.trim()))
    }

    /// Whether a fraction of integers in brackets is the symbol of a quadratic residue, by the name of its command or by what the text speaks of.
    fn has_residue_symbol(&self) -> bool {
        const WORDS: [&str; 7] = [
            "legendre",
            "jacobi symbol",
            "kronecker symbol",
            "quadratic residue",
            "reciprocity",
            "a square modulo",
            "quadratischer rest",
        ];
        const COMMANDS: [&str; 6] = ["\\kr{", "\\kron", "\\leg", "\\jac", "\\Leg", "\\Jac"];
        let source = self.text.get(self.left.span.join(self.right.span).range()).unwrap_or_default();
        [self.left, self.right].into_iter().any(|side| has_bracketed_fraction(&side.tokens))
            && (COMMANDS.iter().any(|command| source.contains(command))
                || surroundings::example_speaks_of(self.text, self.formula.span, &WORDS))
    }
}

/// Whether a side has a fraction of integers alone in brackets.
fn has_bracketed_fraction(side: &[Token]) -> bool {
    let is_decimal = |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if digits.contains('.'));
    let is_fraction =
        |of: &Token| matches!(of.kind, TokenKind::Fraction(..)) && !any(std::slice::from_ref(of), &is_decimal);
    let solid = without_space(side);
    solid.windows(3).any(|of| of[0].is_sign('(') && is_fraction(of[1]) && of[2].is_sign(')'))
}

/// How far an estimate may be from the exact value behind it, relative to the larger one.
const OF_ESTIMATE: f64 = 0.3;

/// The longest source of a formula that is searched, in bytes.
const LONGEST: usize = 4000;

/// How far two exact values may be apart, relative to them.
const NOISE: f64 = 1e-9;

/// The least exponent for which the difference of a number from one is lost: 1 − 10⁻²⁰ is one in floating point.
const LARGEST_EXPONENT: f64 = 1e12;

fn value(tokens: &[Token]) -> Option<SideValue> {
    Evaluator::new(Mode::Point, ReadingChoices::USUAL, None).evaluate_all(tokens).ok()
}

fn number(tokens: &[Token]) -> Option<f64> {
    value(tokens)?.number().ok().map(|number| number.point)
}

/// The value in which numbers before fractions are mixed ones.
fn mixed_number(tokens: &[Token]) -> Option<f64> {
    let value = Evaluator::new(Mode::Point, ReadingChoices::MIXED, None).evaluate_all(tokens).ok()?;
    value.number().ok().map(|number| number.point)
}

fn alike(one: f64, other: f64, tolerance: f64) -> bool {
    (one - other).abs() <= tolerance * one.abs().max(other.abs())
}

/// Whether a number is a whole one, a fraction, a mixed number or one with decimals, and nothing else.
fn is_amount(tokens: &[Token]) -> bool {
    let is_part = |token: &&Token| matches!(token.kind, TokenKind::Number(_) | TokenKind::Fraction(..));
    let solid = without_space(tokens);
    matches!(solid.len(), 1 | 2) && solid.iter().all(is_part)
}

/// Whether the right side is an estimate that the left one gives, with the exact value in brackets behind it: `5 ½ (5 11/24)`.
fn is_estimate_with_exact_value(left: &[Token], right: &[Token]) -> bool {
    let Some((close, rest)) = trim_space(right).split_last().filter(|(close, _)| close.is_sign(')')) else {
        return false;
    };
    let Some(open) = rest.iter().position(|token| token.is_sign('(')) else { return false };
    let (estimate, exact) = (&rest[..open], &rest[open + 1..]);
    let values = || Some([mixed_number(left)?, mixed_number(estimate)?, mixed_number(exact)?]);
    close.span.end > rest[open].span.start
        && is_amount(estimate)
        && is_amount(exact)
        && values()
            .is_some_and(|[left, estimate, exact]| alike(left, estimate, NOISE) && alike(estimate, exact, OF_ESTIMATE))
}

/// Whether a side is equal to the other one if the only stroke with space around it in the source is the outer one: `-50/7 / -2/7`.
fn has_outer_stroke(text: &str, side: &[Token], other: &[Token]) -> bool {
    let is_stroke = |at: usize| side[at].is_sign('/');
    let is_apart = |at: usize| {
        let span = side[at].span.range();
        let [before, behind] = [text.get(..span.start), text.get(span.end..)].map(Option::unwrap_or_default);
        is_stroke(at) && before.ends_with([' ', '~']) && behind.starts_with([' ', '~'])
    };
    let mut outer = (0..side.len()).filter(|at| is_apart(*at));
    let (Some(at), None) = (outer.next(), outer.next()) else { return false };
    let values = || Some((number(&side[..at])? / number(&side[at + 1..])?, number(other)?));
    (0..side.len()).filter(|at| is_stroke(*at)).count() > 1
        && values().is_some_and(|(quotient, other)| alike(quotient, other, NOISE))
}

/// Whether a side has so large an exponent that the digits of its base are lost, or a sum in which large terms that cancel take all digits of
/// a small one: `(1 - 10^{-20})^{10^{20}}`, `10^{22} + 1 - 10^{22}`.
pub(crate) fn loses_all_digits(side: &[Token]) -> bool {
    let is_large = |power: &[Token]| number(power).is_some_and(|of| of.abs() >= LARGEST_EXPONENT);
    let is_high = |power: &[Token]| number(power).is_some_and(|of| of.abs() >= DIGITS as f64);
    let mut powers = side.iter().filter_map(|token| match &token.kind {
        TokenKind::Power(power) => Some(power),
        _ => None,
    });
    let has_large = powers.clone().any(|power| is_large(power));
    let has_long = || side.iter().filter_map(Token::number).any(|digits| digits.len() > DIGITS);
    has_large || ((powers.any(|power| is_high(power)) || has_long()) && cancels_large_terms(side))
}

/// Whether the sum of the terms of a side is so much smaller than the largest of them that a double has none of its digits.
fn cancels_large_terms(side: &[Token]) -> bool {
    let terms = side.split(|token| token.is_one_of("+-")).filter(|term| !trim_space(term).is_empty());
    let largest = terms.filter_map(number).fold(0.0, |largest: f64, term| largest.max(term.abs()));
    // Smaller whole numbers are exact.
    largest >= libm::exp10(DIGITS as f64)
        && number(side).is_some_and(|sum| sum.abs() < libm::exp10(1.0 - DIGITS as f64) * largest)
}

/// The decimal digits that a double has.
const DIGITS: usize = 15;

/// Whether one side is a function of an angle of whole degrees, as textbooks round it, and the other one a fraction that has this angle:
/// `3/4 = tan 37°`.
fn is_of_rounded_angle(left: &[Token], right: &[Token]) -> bool {
    let is_of = |function: &[Token], fraction: &[Token]| {
        let solid = without_space(function);
        let [function, angle, degrees] = solid.as_slice() else { return false };
        let TokenKind::Function(function) = &function.kind else { return false };
        let angle = angle.number().filter(|digits| digits.bytes().all(|c| c.is_ascii_digit()));
        let Some(angle) = angle.and_then(|digits| digits.parse::<f64>().ok()) else { return false };
        let is_fraction =
            matches!(without_space(fraction).as_slice(), [of] if matches!(of.kind, TokenKind::Fraction(..)));
        let at = |angle: f64| {
            let angle = angle.to_radians();
            Some(match function {
                MathFunction::Sin => libm::sin(angle),
                MathFunction::Cos => libm::cos(angle),
                MathFunction::Tan => libm::tan(angle),
                _ => return None,
            })
        };
        let is_degrees = degrees.word() == Some("°") || is_raised_zero(degrees);
        let bounds = at(angle - 0.5).zip(at(angle + 0.5)).zip(number(fraction));
        is_degrees && is_fraction && bounds.is_some_and(|((low, high), of)| (low - of) * (high - of) <= 0.0)
    };
    is_of(left, right) || is_of(right, left)
}

/// Whether a token is a zero that is raised, as some write the sign of degrees.
fn is_raised_zero(token: &Token) -> bool {
    matches!(&token.kind, TokenKind::Power(power) if matches!(power.as_slice(), [zero] if zero.number() == Some("0")))
}

/// Whether two terms of a side are numbers with different letters behind them, units of different kinds that nobody adds: `5J + 10N`.
fn adds_letters(side: &[Token]) -> bool {
    let letter = |term: &[Token]| match without_space(term).as_slice() {
        [number, letter] if number.number().is_some() => {
            letter.word().filter(|word| word.chars().count() == 1).and_then(unit)
        }
        _ => None,
    };
    let units: Vec<_> = side.split(|token| token.is_one_of("+-")).filter_map(letter).collect();
    units.windows(2).any(|pair| pair[0].dimension != pair[1].dimension)
}

/// Whether a prefix stands in brackets between a number and its unit: `60 (m)m`.
fn has_bracketed_prefix(side: &[Token]) -> bool {
    let solid = without_space(side);
    let letter = |token: &Token| match &token.kind {
        TokenKind::Word(text) | TokenKind::Name(text) => Some(text.clone()),
        _ => None,
    };
    solid.windows(5).any(|of| {
        let prefix = letter(of[2]).is_some_and(|prefix| ["k", "M", "G", "m", "c", "μ", "n", "p"].contains(&&*prefix));
        let named = letter(of[4]).is_some_and(|named| takes_prefix(&named) || named == "m");
        of[0].number().is_some() && of[1].is_sign('(') && prefix && of[3].is_sign(')') && named
    })
}

/// Whether a side has the square of a charge above Planck's constant: `2e^2/h`.
fn has_planck_constant(side: &[Token]) -> bool {
    let is_letter = |token: &Token, letter: &str| matches!(&token.kind, TokenKind::Word(word) | TokenKind::Name(word) if word == letter);
    let is_charge = |of: &[Token]| {
        of.windows(2).any(|of| {
            is_letter(&of[0], "e")
                && matches!(&of[1].kind, TokenKind::Power(power) if power.iter().any(|of| of.number() == Some("2")))
        })
    };
    let has_h = |of: &[Token]| of.iter().any(|token| is_letter(token, "h"));
    is_charge(side) && has_h(side)
        || side
            .iter()
            .any(|token| matches!(&token.kind, TokenKind::Fraction(above, below) if is_charge(above) && has_h(below)))
}

/// Whether a side has the sign of hydrogen behind a unit of what there is of it: `81.10 g H`, `18.7 mol H`.
fn has_hydrogen(side: &[Token]) -> bool {
    let solid = without_space(side);
    let here = solid.windows(2).any(|of| {
        of[0].word().is_some_and(|unit| ["g", "mg", "kg", "mol", "mmol"].contains(&unit)) && of[1].word() == Some("H")
    });
    here || side.iter().any(|token| token.inner().any(has_hydrogen))
}

/// Whether two sides agree if ounces are those of fluids and of no mass.
fn agree_in_fluid_ounces(left: &[Token], right: &[Token]) -> bool {
    let [one, other] = [left, right].map(|side| in_units(side, "oz", "mL", FLUID_OUNCE));
    let values = value(&one).zip(value(&other));
    let has_ounces = |side: &[Token]| any(side, &|kind| matches!(kind, TokenKind::Word(word) if word == "oz"));
    has_ounces(left)
        && values.is_some_and(|(one, other)| {
            let numbers = one.number().ok().zip(other.number().ok());
            one.dimension == other.dimension
                && numbers.is_some_and(|(one, other)| alike(one.point, other.point, ROUGHLY))
        })
}

/// Millilitres of a fluid ounce, with the sign of a product.
const FLUID_OUNCE: &str = "29.5735";

/// How far quantities in fluid ounces may be apart, relative to the larger one.
const ROUGHLY: f64 = 0.005;

/// A side with one unit in another one, so many of which it is.
fn in_units(side: &[Token], old: &str, new: &str, factor: &str) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(side.len() + 2);
    for token in side {
        let mut copy = token.clone();
        for list in copy.kind.lists() {
            *list = in_units(list, old, new, factor);
        }
        if token.word() == Some(old) {
            out.push(Token::new(TokenKind::Operator('·'), token.span));
            out.push(Token::new(TokenKind::Number(factor.to_owned()), token.span));
            copy.kind = TokenKind::Word(new.to_owned());
        }
        out.push(copy);
    }
    out
}

/// Whether the dimensions of two sides agree if `mi` is minutes, and not miles.
fn agree_in_minutes(left: &[Token], right: &[Token]) -> bool {
    let has_miles = |side: &[Token]| any(side, &|kind| matches!(kind, TokenKind::Word(word) if word == "mi"));
    let dimension = |side: &[Token]| value(&in_minutes(side)).map(|value| value.dimension);
    (has_miles(left) || has_miles(right)) && dimension(left).is_some_and(|of| dimension(right) == Some(of))
}

fn in_minutes(side: &[Token]) -> Vec<Token> {
    let mut out = side.to_vec();
    for token in &mut out {
        if token.word() == Some("mi") {
            token.kind = TokenKind::Word("min".to_owned());
        }
        for list in token.kind.lists() {
            *list = in_minutes(list);
        }
    }
    out
}

/// Whether a letter that is seldom a unit behind another one stands behind the sign of a product, as a quantity: `0.5·g·t^2`.
fn has_factor_letter(side: &[Token]) -> bool {
    let solid = without_space(side);
    let is_letter = |token: &Token| token.word().is_some_and(|word| ["g", "F"].contains(&word));
    solid.windows(2).any(|pair| pair[0].is_one_of("·×") && is_letter(pair[1]))
}

/// Whether a side has the sign of degrees behind `A`, which some write for ångströms: `5.43 A°`.
fn has_angstroms(side: &[Token]) -> bool {
    side.windows(2).any(|pair| pair[0].word() == Some("A") && pair[1].word() == Some("°"))
}

/// Whether one side is a factor of one or more, and the other one is in per cent what it adds: `1.21 = 21%`.
fn is_change_of_factor(factor: &[Token], change: &[Token]) -> bool {
    let solid = without_space(change);
    let [percent, sign] = solid.as_slice() else { return false };
    let Some(digits) = percent.number().filter(|_| sign.word().is_some_and(is_percent)) else { return false };
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let half = 0.005 * libm::exp10(-(decimals as f64)) + NOISE;
    let factor = value(factor).filter(|factor| !factor.has_unit).and_then(|factor| factor.number().ok());
    parse_decimal(digits).zip(factor).is_some_and(|(percent, factor)| {
        let factor = factor.point;
        factor > 1.0 && factor < LARGEST_FACTOR && (factor - 1.0 - percent / 100.0).abs() <= half
    })
}

/// The largest factor whose change is told in per cent; of larger ones, people say how many times.
const LARGEST_FACTOR: f64 = 3.0;

/// Whether a number in base two is the negative one that has the same bits: `1000_2 = -8_{10}`.
fn is_of_complement(left: &[Token], right: &[Token]) -> bool {
    let solid = without_space(left);
    let [Token { kind: TokenKind::Call(NamedOperation::InBase, arguments), .. }] = solid.as_slice() else {
        return false;
    };
    let [digits, base] = arguments.as_slice() else { return false };
    let bits = digits.first().and_then(Token::number).filter(|bits| bits.starts_with('1') && bits.len() < 50);
    let is_two = base.first().and_then(Token::number) == Some("2");
    let places = bits.filter(|_| is_two).map(|bits| libm::exp2(bits.len() as f64));
    places.zip(number(left).zip(number(right))).is_some_and(|(places, (left, right))| left - places == right)
}
