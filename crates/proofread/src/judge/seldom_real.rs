//! Kinds of differences that were real in less than two of five cases at first contact, so that they are set aside. Each is known by what stands in
//! its chain; the counts are in `judged/README.md`.

use crate::evaluate::expression::Evaluator;
use crate::evaluate::printed::Mode;
use crate::join::chain::{ChainSide, Relation};
use crate::judge::doubt::PlacedPair;
use crate::judge::lost_digits::significant;
use crate::judge::substitution::without_space;
use crate::judge::surroundings;
use crate::judge::verdict::PairJudgement;
use crate::token::{MathFunction, NamedOperation, Token, TokenKind, any};

/// How far two numbers are apart that differ in nothing but their sign, relative to them.
const EXACT: f64 = 0.01;

/// Digits of a result that nobody prints who has rounded on the way. Of the flags at first contact on such results that other digits of the
/// terms explain, none was real (0 of 9, in nine texts), while of those with fewer digits half were.
const MANY_DIGITS: usize = 5;

/// How far such a result is from the computed one at most, relative to it: what a digit more in each term may give.
const BY_DIGITS: f64 = 0.002;

/// How far the results of rounded estimates are from the computed ones at most, relative to them.
const BY_ESTIMATES: f64 = 0.02;

/// How far a fraction may be from what it approximates, relative to the larger one.
const COARSE: f64 = 0.2;

impl PlacedPair<'_> {
    /// Whether the sides differ in sign alone where a sign is often left out: in a difference or an elasticity that the text calls so, and in
    /// the square of a negative number without brackets, `t² = −3.1² = 9.61`, or where the text takes the absolute value.
    pub(crate) fn leaves_sign_out(&self, judgement: &PairJudgement) -> bool {
        let Some((left, right)) = &judgement.values else { return false };
        let positive = right.is_literal() && right.number().is_ok_and(|of| of.point > 0.0);
        if !positive || !left.clone().negate().meets(right, EXACT) {
            return false;
        }
        let solid = without_space(&self.left.tokens);
        let is_difference = matches!(solid.as_slice(), [one, minus, other] if one.number().is_some() && minus.is_sign('-') && other.number().is_some());
        let is_square = |tokens: &[&Token]| matches!(tokens, [.., Token { kind: TokenKind::Power(power), .. }] if matches!(power.as_slice(), [two] if two.number() == Some("2")));
        let is_squared = solid.len() == 3
            && solid[0].is_sign('-')
            && is_square(&solid)
            && self.chain.sides.iter().take_while(|side| side.span != self.left.span).any(|side| {
                let letters = without_space(&side.tokens);
                letters.len() == 2 && matches!(letters[0].kind, TokenKind::Name(_)) && is_square(&letters)
            });
        let called = |words: &[&str]| surroundings::speaks_before(self.text, self.left.span, words);
        // By how much something falls, and the size of an effect or of a statistic of two sides.
        const FALLS: [&str; 10] = [
            "elasticity",
            "differs ",
            "differ by",
            "decreases by",
            "decreased by",
            "drops by",
            "falls by",
            "effect size",
            "cohen",
            "two-sided",
        ];
        let example = || surroundings::text_before(self.text, self.left.span).to_ascii_lowercase();
        const SIZES: [&str; 4] =
            ["take the absolute value", "taking the absolute value", "in absolute value", "in magnitude"];
        let is_size = surroundings::speaks_around(self.text, self.right.span, &SIZES);
        let is_named = is_difference && called(&["difference", "distance", "apart"]);
        is_squared || is_named || is_size || called(&FALLS) || example().contains("elasticit")
    }

    /// Whether a determinant has entries in colour or struck out, so that a part of it may be meant: the minor of an entry.
    pub(crate) fn is_minor(&self) -> bool {
        const MARKS: [&str; 4] = ["\\color", "\\textcolor", "cancel{", "\\sout"];
        let is_determinant = |kind: &TokenKind| matches!(kind, TokenKind::Call(NamedOperation::Determinant, _));
        [self.left, self.right].into_iter().filter(|side| any(&side.tokens, &is_determinant)).any(|side| {
            let source = self.text.get(side.span.range()).unwrap_or_default();
            MARKS.iter().any(|mark| source.contains(mark))
        })
    }

    /// Whether a small angle takes the place of its sine or tangent: `sin 0.5 ≈ 0.5`.
    fn is_small_angle(&self) -> bool {
        let solid = |side: &ChainSide| -> Vec<TokenKind> {
            let printed = side.tokens.iter().filter(|token| !token.is_space() && !token.is_one_of("()"));
            printed.map(|token| token.kind.clone()).collect()
        };
        match solid(self.left).as_slice() {
            [TokenKind::Function(MathFunction::Sin | MathFunction::Tan), angle @ ..] => angle == solid(self.right),
            _ => false,
        }
    }

    /// Whether a factor of a hundred only changes a number to per cent: `.8 = .8 · 100 = 80%`.
    pub(crate) fn is_change_to_percent(&self) -> bool {
        let at = self.chain.sides.iter().position(|side| side.span == self.right.span);
        let next = at.and_then(|at| self.chain.sides.get(at + 1));
        let is_percent = next.is_some_and(|next| next.tokens.last().and_then(Token::word) == Some("%"));
        let (left, right) = (without_space(&self.left.tokens), without_space(&self.right.tokens));
        match right.as_slice() {
            [number, times, hundred] => {
                is_percent
                    && times.is_one_of("·×")
                    && hundred.number() == Some("100")
                    && number.number().is_some()
                    && left.iter().any(|token| token.number().is_some())
            }
            _ => false,
        }
    }

    /// Whether ≈ stands before something exact that is computed, as in a linear approximation: √5 ≈ 9/4, ln 1.08 ≈ ln 1, sin 33 ≈ 33. A
    /// fraction is near what it stands for, and has its sign.
    pub(crate) fn is_coarse_approximation(&self, judgement: &PairJudgement) -> bool {
        let is_decimal = |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if digits.contains('.'));
        let is_computed =
            |kind: &TokenKind| matches!(kind, TokenKind::Fraction(..) | TokenKind::Function(_) | TokenKind::Root(..));
        let right = &self.right.tokens;
        // The stroke of a unit divides nothing.
        let of_unit = |at: usize| {
            right[at + 1..].iter().find(|token| !token.is_space()).is_some_and(|next| next.word().is_some())
        };
        let divides = right.iter().enumerate().any(|(at, token)| token.is_sign('/') && !of_unit(at));
        let is_exact = (divides || any(right, &is_computed)) && !any(right, &is_decimal);
        let is_function = any(right, &|kind| matches!(kind, TokenKind::Function(_)));
        let is_near = || judgement.values.as_ref().is_none_or(|(left, right)| left.difference(right) <= COARSE);
        self.right.relation == Some(Relation::Approximate)
            && (is_exact && (is_function || is_near()) || self.is_small_angle())
    }

    /// Whether the left side is computed from rounded estimates: a power of e with a decimal exponent where the text speaks of them, or the
    /// quotient of decimals that a test statistic is.
    fn is_of_estimates(&self) -> bool {
        const STATISTICS: [&str; 5] = ["Z", "z", "t", "F", "Wald"];
        const ESTIMATES: [&str; 9] =
            ["odds", "coefficient", "estimate", "logit", "regression", "covariate", "fitted", "model", "effect"];
        let solid = without_space(&self.left.tokens);
        let is_e = |token: &Token| match &token.kind {
            TokenKind::Name(name) | TokenKind::Word(name) => name == "e",
            _ => false,
        };
        let is_power = matches!(solid.as_slice(), [base, Token { kind: TokenKind::Power(_), .. }] if is_e(base))
            || matches!(solid.as_slice(), [Token { kind: TokenKind::Function(MathFunction::Exp), .. }, ..]);
        let is_quotient = solid.iter().any(|token| matches!(token.kind, TokenKind::Fraction(..)) || token.is_sign('/'));
        let names = |side: &ChainSide| {
            let name = without_space(&side.tokens);
            matches!(name.as_slice(), [Token { kind: TokenKind::Name(name) | TokenKind::Word(name), .. }] if STATISTICS.contains(&name.split('_').next().unwrap_or_default()))
        };
        let is_statistic = is_quotient && self.chain.sides.first().is_some_and(names);
        is_statistic || (is_power && surroundings::speaks_around(self.text, self.left.span, &ESTIMATES))
    }

    /// Whether a printed result of many digits agrees if the rounded numbers before it had digits that are not printed: `2.012 × 3.1416 =
    /// 6.32091`.
    pub(crate) fn may_have_more_digits(&self, judgement: &PairJudgement) -> bool {
        let Some((left, right)) = &judgement.values else { return false };
        let is_near = left.difference(right) < if self.is_of_estimates() { BY_ESTIMATES } else { BY_DIGITS };
        if left.is_literal() || !right.is_literal() || !is_near || !judgement.used.is_empty() {
            return false;
        }
        let digits = self.right.tokens.iter().find_map(Token::number).unwrap_or_default();
        // Whole numbers are as they are.
        let is_decimal = |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if digits.contains('.'));
        // In a sum, the digits of the terms decide.
        let is_product = |kind: &TokenKind| match kind {
            TokenKind::Operator(c) => "·×/(".contains(*c),
            TokenKind::Fraction(..) | TokenKind::Power(_) | TokenKind::Root(..) | TokenKind::Function(_) => true,
            _ => false,
        };
        let is_long =
            |kind: &TokenKind| matches!(kind, TokenKind::Number(digits) if !digits.contains('.') && digits.len() > 2);
        let strict =
            |side: &ChainSide| Evaluator::new(Mode::Strict, judgement.reading, None).evaluate_side(&side.tokens).ok();
        digits.contains('.')
            && (significant(digits) >= MANY_DIGITS || self.is_of_estimates())
            && any(&self.left.tokens, &is_decimal)
            && any(&self.left.tokens, &is_product)
            && !any(&self.left.tokens, &is_long)
            && strict(self.left).zip(strict(self.right)).is_some_and(|(left, right)| left.meets(&right, 0.0))
    }
}
